// The tables hold the structure; the picture and the panel follow the selected row. Without this script the page
// is the picture and the tables, and the links in the tables show their target.
(() => {
  "use strict";
  const prefix = document.body.dataset.figure;
  const $ = (name) => document.getElementById(`${prefix}-page-${name}`);
  const rows = new Map();
  for (const row of document.querySelectorAll("tr[data-id]")) rows.set(row.dataset.id, row);
  const drawn = (id) => document.getElementById(`${prefix}-${id}`);
  const still = matchMedia("(prefers-reduced-motion: reduce)");
  const STEP = 600;
  let selected = null;
  let timer = 0;

  const kind = (id) => ({ h: "half-edge", v: "vertex", f: "face" })[id[0]];
  const cell = (id, pointer) => rows.get(id)?.querySelector(`[data-pointer="${pointer}"]`) ?? null;
  const pointer = (id, name) => cell(id, name)?.dataset.to ?? null;

  function link(id) {
    if (!rows.has(id)) return document.createTextNode(id);
    const a = document.createElement("a");
    a.href = `#${prefix}-${id}`;
    a.textContent = id;
    return a;
  }

  function mark(id, name, on) {
    drawn(id)?.classList.toggle(name, on);
    rows.get(id)?.classList.toggle(name, on);
  }

  function forget() {
    clearTimeout(timer);
    timer = 0;
    for (const element of document.querySelectorAll(".seen")) element.classList.remove("seen");
    $("trail").replaceChildren();
    $("stop").disabled = true;
  }

  // The page does not scroll: only the box of the table does.
  function reveal(row) {
    const box = row.closest(".rows");
    const head = box.querySelector("thead").offsetHeight;
    const [top, bottom] = [row.offsetTop - head, row.offsetTop + row.offsetHeight - box.clientHeight];
    box.scrollTop = Math.max(Math.min(box.scrollTop, top), bottom);
  }

  function describe(id) {
    const state = $("state");
    const name = document.createElement("strong");
    name.textContent = id;
    state.replaceChildren(name, ` ${kind(id)}`);
    for (const td of rows.get(id).querySelectorAll("[data-pointer]")) {
      state.append(`, ${td.dataset.pointer} `);
      const targets = (td.dataset.to ?? "").split(" ").filter(Boolean);
      targets.forEach((to, i) => state.append(i > 0 ? " " : "", link(to)));
      if (targets.length === 0) state.append(td.textContent);
    }
  }

  function select(id) {
    if (selected !== null) mark(selected, "on", false);
    selected = id;
    mark(id, "on", true);
    if (document.activeElement?.closest(".he")) {
      document.activeElement.blur();
      drawn(id)?.focus({ preventScroll: true });
    }
    describe(id);
    if (drawn(id)?.hasAttribute("tabindex")) rove(drawn(id));
    reveal(rows.get(id));
    for (const name of ["next", "prev", "twin"]) $(name).disabled = !rows.has(pointer(id, name));
    $("face").disabled = faceStart() === null;
    $("star").disabled = starStart() === null;
  }

  // Selects without walking. The address follows, unless the browser finds that this is too often.
  function choose(id) {
    forget();
    select(id);
    try {
      history.replaceState(null, "", `#${prefix}-${id}`);
    } catch {
      say("");
    }
  }

  function say(text) {
    $("message").textContent = text;
  }

  function follow(name) {
    const to = selected === null ? null : pointer(selected, name);
    if (rows.has(to)) choose(to);
    else say(selected === null ? "Select a half-edge first." : `${selected} has no ${name} to go to.`);
  }

  const known = (id) => (rows.has(id) ? id : null);
  const faceStart = () => known(selected[0] === "f" ? pointer(selected, "boundary") : selected[0] === "h" ? selected : null);
  const starStart = () => known(selected[0] === "v" ? pointer(selected, "outgoing") : selected[0] === "h" ? selected : null);

  // Walks from start by step, one half-edge at a time; ends at start, or where the chain breaks.
  function walk(what, start, step) {
    forget();
    $("stop").disabled = false;
    const trail = $("trail");
    trail.append(`${what}: `);
    let count = 0;
    const visit = (h) => {
      if (count > 0) trail.append(" \u2192 ");
      trail.append(link(h));
      select(h);
      mark(h, "seen", true);
      count += 1;
      const to = step(h);
      if (to === start || count > rows.size || !rows.has(to)) {
        trail.append(to === start ? ` \u2192 ${start} again: ${count} half-edge${count === 1 ? "" : "s"}` : `, and no way on to ${to ?? "the next"}`);
        $("stop").disabled = true;
        timer = 0;
        return;
      }
      if (still.matches) visit(to);
      else timer = setTimeout(visit, STEP, to);
    };
    visit(start);
  }

  function walkFace() {
    const start = selected === null ? null : faceStart();
    if (start !== null) walk(`face ${pointer(start, "face") ?? "?"}, by next`, start, (h) => pointer(h, "next"));
    else say("Select a half-edge or a face first.");
  }

  function walkStar() {
    const start = selected === null ? null : starStart();
    const turn = (h) => pointer(pointer(h, "prev"), "twin");
    if (start !== null) walk(`star of ${pointer(start, "origin") ?? "?"}, by prev.twin`, start, turn);
    else say("Select a half-edge or a vertex first.");
  }

  function search(text) {
    const wanted = text.trim().toLowerCase();
    const byName = () => [...rows].find(([, row]) => row.dataset.name?.toLowerCase() === wanted)?.[0];
    const id = rows.has(wanted) ? wanted : byName();
    if (id) {
      say("");
      choose(id);
    } else {
      say(`There is no ${text.trim() || "empty name"} in the tables: write h0, v0, f0 or the name of a face.`);
    }
  }

  const stop = () => {
    clearTimeout(timer);
    timer = 0;
    $("stop").disabled = true;
  };
  const actions = {
    next: () => follow("next"),
    prev: () => follow("prev"),
    twin: () => follow("twin"),
    face: walkFace,
    star: walkStar,
    stop,
  };
  for (const [name, act] of Object.entries(actions)) {
    $(name).addEventListener("click", () => {
      say("");
      act();
    });
  }
  $("search").addEventListener("submit", (event) => {
    event.preventDefault();
    search($("query").value);
  });

  const keys = { n: "next", p: "prev", t: "twin", f: "face", s: "star", Escape: "stop" };
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target.closest("input")) return;
    const element = event.target.closest("#" + prefix + " [id]");
    if (event.key === "/") {
      event.preventDefault();
      $("query").focus();
    } else if (keys[event.key]) {
      say("");
      actions[keys[event.key]]();
    } else if ((event.key === "Enter" || event.key === " ") && element) {
      event.preventDefault();
      pick(element);
    }
  });

  // One stop of the tab key in the picture and one in each table: within, the arrow keys lead on.
  const groups = [...document.querySelectorAll(`#${prefix}, .rows`)];
  const stops = (group) => group.querySelectorAll(group.id === prefix ? "[tabindex]" : "a");
  const groupOf = (node) => groups.find((group) => group !== node && group.contains(node));
  function rove(node) {
    const group = groupOf(node);
    for (const stop of group?.querySelectorAll('[tabindex="0"], a:not([tabindex])') ?? []) stop.setAttribute("tabindex", "-1");
    if (group) node.setAttribute("tabindex", "0");
  }

  // Along the face by right and left, across the edge by up and down.
  const ways = { ArrowRight: "next", ArrowLeft: "prev", ArrowUp: "twin", ArrowDown: "twin" };
  function throughPicture(element, key) {
    const all = [...stops(document.getElementById(prefix))];
    const ends = { Home: all[0], End: all.at(-1) };
    const to = ends[key] ?? drawn(pointer(element.id.slice(prefix.length + 1), ways[key]) ?? "");
    if (to) choose(to.id.slice(prefix.length + 1));
    return to;
  }

  // From link to link: in a row by left and right, in a column by up and down.
  function throughTable(a, key) {
    const all = [...stops(a.closest(".rows"))];
    const at = all.indexOf(a);
    const row = a.closest("tr");
    const column = a.closest("th, td").cellIndex;
    const beside = (to) => to && (to.cells[column].querySelector("a") ?? to.querySelector("a"));
    return {
      ArrowRight: all[at + 1],
      ArrowLeft: all[at - 1],
      ArrowUp: beside(row.previousElementSibling),
      ArrowDown: beside(row.nextElementSibling),
      Home: all[0],
      End: all.at(-1),
    }[key];
  }

  function arrow(event) {
    if (event.shiftKey || !/^(Arrow(Right|Left|Up|Down)|Home|End)$/.test(event.key)) return;
    const inPicture = event.target.closest(`#${prefix} .he`);
    const inTable = event.target.closest(".rows a");
    const to = inPicture ? throughPicture(inPicture, event.key) : inTable ? throughTable(inTable, event.key) : null;
    if (!to) return;
    event.preventDefault();
    to.focus({ preventScroll: inPicture !== null });
    if (inTable) reveal(to.closest("tr"));
  }
  document.addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey || event.altKey)) arrow(event);
  });
  document.addEventListener("focusin", (event) => rove(event.target));

  // The id of the element that a link, a row or a part of the picture stands for.
  function meant(node) {
    const href = node.closest("a")?.getAttribute("href");
    if (href) return href.startsWith(`#${prefix}-`) ? href.slice(prefix.length + 2).replace(/^row-/, "") : null;
    const row = node.closest("tr[data-id]");
    if (row) return row.dataset.id;
    const group = node.closest(".he, .v, .f");
    return group?.closest("#" + prefix) ? group.id.slice(prefix.length + 1) : null;
  }

  function pick(node) {
    const id = meant(node);
    if (!rows.has(id)) return false;
    say("");
    choose(id);
    return true;
  }

  document.addEventListener("click", (event) => {
    if (pick(event.target) && event.target.closest("a")) event.preventDefault();
  });
  const fromAddress = () => {
    const id = location.hash.slice(prefix.length + 2).replace(/^row-/, "");
    if (location.hash.startsWith(`#${prefix}-`) && rows.has(id)) choose(id);
  };
  window.addEventListener("hashchange", fromAddress);

  document.documentElement.classList.add("js");
  for (const group of groups) {
    const all = stops(group);
    all.forEach((stop, i) => stop.setAttribute("tabindex", i === 0 ? "0" : "-1"));
    if (all.length > 0 && group.id !== prefix) group.removeAttribute("tabindex");
  }
  $("stop").disabled = true;
  for (const name of ["next", "prev", "twin", "face", "star"]) $(name).disabled = true;
  fromAddress();
})();
