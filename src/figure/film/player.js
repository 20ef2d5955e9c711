"use strict";
(() => {
  const prefix = document.body.dataset.film;
  const frames = document.querySelectorAll(`#${CSS.escape(prefix)} .fr`);
  const [back, next, play, at, count] = ["back", "next", "play", "at", "count"].map((id) => document.getElementById(id));
  const last = frames.length - 1;
  const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
  let timer = 0;

  const current = () => {
    const found = [...frames].findIndex((frame) => `#${frame.id}` === decodeURIComponent(location.hash));
    return Math.max(found, 0);
  };
  const tell = () => {
    const i = current();
    at.value = i;
    at.setAttribute("aria-valuetext", frames[i].querySelector("title").textContent);
    count.textContent = `${i + 1} of ${last + 1}`;
    back.disabled = i === 0;
    next.disabled = i === last;
  };
  const go = (i) => {
    const to = Math.min(Math.max(i, 0), last);
    if (to !== current() || location.hash === "") {
      // The frame is the target of the address, which is how it is shown. The page must not scroll for it.
      const [x, y] = [scrollX, scrollY];
      location.replace(`#${frames[to].id}`);
      scrollTo(x, y);
    }
    tell();
  };
  const stop = () => {
    clearInterval(timer);
    timer = 0;
    play.textContent = "play";
    play.setAttribute("aria-pressed", "false");
  };
  const start = () => {
    if (current() === last) go(0);
    play.textContent = "pause";
    play.setAttribute("aria-pressed", "true");
    timer = setInterval(() => {
      go(current() + 1);
      if (current() === last) stop();
    }, still ? 3000 : 1500);
  };
  const toggle = () => (timer ? stop() : start());

  back.addEventListener("click", () => { stop(); go(current() - 1); });
  next.addEventListener("click", () => { stop(); go(current() + 1); });
  play.addEventListener("click", toggle);
  at.addEventListener("input", () => { stop(); go(Number(at.value)); });
  addEventListener("hashchange", tell);
  addEventListener("keydown", (event) => {
    if (event.altKey || event.ctrlKey || event.metaKey || event.target === at) return;
    const steps = { ArrowLeft: () => current() - 1, ArrowRight: () => current() + 1, Home: () => 0, End: () => last };
    if (steps[event.key]) {
      stop();
      go(steps[event.key]());
    } else if (event.key === " " && !["BUTTON", "SUMMARY", "A"].includes(event.target.tagName)) {
      toggle();
    } else {
      return;
    }
    event.preventDefault();
  });

  document.body.classList.add("scripted");
  for (const hidden of document.querySelectorAll(".controls, .keys")) hidden.hidden = false;
  tell();
  next.focus();
})();
