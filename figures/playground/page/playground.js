// The page of the playground. It sends places, words and files to the kit, and shows what comes back: pictures, tables
// and sentences. Nothing here knows geometry or follows a link of the structure.
(async () => {
  "use strict";
  const $ = (id) => document.getElementById(id);
  const picture = $("picture");
  const still = matchMedia("(prefers-reduced-motion: reduce)");
  const STEP = 550;
  const FILE = 5 << 20;
  let kit;
  let scene = "plane";
  let link = "";
  let selected = { ids: [], pointers: [], edits: [], waiting: "" };
  let tables = "";
  let named = new Map();
  const marked = { on: [], trail: [], bad: [] };
  let said = { tone: "note", text: "", elements: [] };
  let corners = null;
  let breaking = false;
  let quiz = { what: "" };
  let timer = 0;

  // The kit.

  function ask(action) {
    return call(() => kit.act(JSON.stringify(action)));
  }

  function call(work) {
    // A page that is turned or clicked before the kit is unpacked: the beginning asks for all there is to show.
    if (!kit) return { message: { tone: "refused" } };
    let reply;
    try {
      reply = JSON.parse(work());
    } catch (error) {
      // The machine inside has stopped. The scene is in the link, so that nothing is lost.
      console.error(error);
      kit = new wasm_bindgen.Playground();
      kit.act(JSON.stringify({ do: "link", text: link }));
      reply = JSON.parse(kit.act(JSON.stringify({ do: "show" })));
      reply.message = { tone: "refused", text: "The playground has failed at this; the scene is as it was. Please report what you did.", elements: [] };
    }
    show(reply);
    return reply;
  }

  async function unpack() {
    const bytes = Uint8Array.from(atob($("wasm").textContent), (letter) => letter.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    await wasm_bindgen({ module_or_path: await new Response(stream).arrayBuffer() });
    kit = new wasm_bindgen.Playground();
  }

  // What comes back.

  function show(reply) {
    if (reply.quiz) fillQuiz(reply.quiz);
    if (reply.svg !== undefined) draw(reply.svg);
    if (reply.over !== undefined) overlay(reply.over);
    if (reply.tables !== undefined) fillTables(reply.tables);
    if (reply.status) fillStatus(reply.status);
    if (reply.script) fillScript(reply.script);
    if (reply.link !== undefined) keep(reply.link);
    if (reply.selected) fillSelected(reply.selected);
    if (reply.message) say(reply.message);
    else if (reply.selected || reply.svg !== undefined) say({ tone: "note", text: "", elements: [] });
    if (reply.trail) trail(reply.trail);
    if (reply.file) save(reply.file);
  }

  function draw(svg) {
    const inside = picture.contains(document.activeElement);
    const focus = inside ? document.activeElement.id : "";
    picture.innerHTML = svg;
    // Where the pointers are the question, the picture does not tell them.
    const blind = quiz.what === "where_am_i" && !quiz.answered;
    picture.classList.toggle("blind", blind);
    named = new Map();
    for (const element of picture.querySelectorAll(".he, .v, .f")) {
      const name = /(?:^|-)([vhf]\d+)(?:-\d+)?$/.exec(element.id)?.[1];
      if (!name) continue;
      element.dataset.name = name;
      element.setAttribute("tabindex", "-1");
      if (!element.hasAttribute("role")) element.setAttribute("role", "img");
      const title = element.querySelector("title");
      if (!title) element.setAttribute("aria-label", name);
      else if (blind) title.textContent = name;
      if (!named.has(name)) named.set(name, []);
      named.get(name).push(element);
    }
    for (const kind of ["on", "trail", "bad"]) mark(kind, marked[kind]);
    rove(focus ? $(focus) : null);
    if (inside) ($(focus) ?? picture.querySelector('[tabindex="0"]'))?.focus({ preventScroll: true });
  }

  // One element of the drawing can be reached by Tab; arrow keys go on from it.
  function rove(to) {
    const next = to ?? elements(selected.ids.at(-1) ?? "")[0] ?? named.get("h0")?.[0] ?? [...named.values()][0]?.[0];
    for (const old of picture.querySelectorAll('[tabindex="0"]')) old.setAttribute("tabindex", "-1");
    next?.setAttribute("tabindex", "0");
    return next;
  }

  // The parts of the drawing that show an element; an edge is shown by its two halves.
  function elements(name) {
    const halves = /^e(\d+)$/.exec(name);
    if (halves) return [...elements(`h${2 * halves[1]}`), ...elements(`h${2 * halves[1] + 1}`)];
    return named.get(name) ?? [];
  }

  function mark(kind, names) {
    marked[kind] = names;
    for (const element of document.querySelectorAll(`#picture [data-name].${kind}, tr.${kind}`)) {
      if (kind !== "bad" || element.tagName !== "TR") element.classList.remove(kind);
    }
    for (const name of names) {
      for (const element of elements(name)) element.classList.add(kind);
      if (kind !== "bad") row(name)?.classList.add(kind);
    }
  }

  const row = (name) => $("tables").querySelector(`tr[data-id="${CSS.escape(name)}"]`);

  function overlay(markup) {
    const svg = picture.querySelector("svg");
    if (!svg) return;
    let group = $("over");
    if (!group) {
      group = document.createElementNS("http://www.w3.org/2000/svg", "g");
      group.id = "over";
      svg.append(group);
    }
    group.innerHTML = markup;
  }

  function fillTables(html) {
    tables = html;
    const box = $("tables");
    if (!$("tables-box").open) {
      box.replaceChildren();
      return;
    }
    const tops = [...box.querySelectorAll(".rows")].map((rows) => rows.scrollTop);
    box.innerHTML = html || "<p>The tables are shown when the question is answered.</p>";
    box.querySelectorAll(".rows").forEach((rows, i) => (rows.scrollTop = tops[i] ?? 0));
  }

  function fillStatus(status) {
    scene = picture.dataset.scene = status.scene;
    $("counts").textContent = status.counts;
    $("euler").textContent = status.euler;
    const list = $("violations");
    const hides = scene === "quiz" && status.violations.length === 0;
    const sound = hides ? [] : [{ text: "Every invariant holds.", elements: [] }];
    list.className = status.violations.length ? "" : "good";
    list.replaceChildren(...(status.violations.length ? status.violations : sound).map((violation) => {
      const item = document.createElement("li");
      item.textContent = violation.text;
      return item;
    }));
    mark("bad", status.violations.flatMap((violation) => violation.elements));
    $("mend").hidden = scene !== "broken";
    $("layers").hidden = scene !== "points";
    for (const button of document.querySelectorAll("[data-over]")) {
      button.setAttribute("aria-pressed", String(button.dataset.over === status.over));
    }
    [$("undo").disabled, $("redo").disabled] = status.history.map((can) => !can);
    $("break").hidden = scene === "kernel" || scene === "points" || scene === "quiz";
    $("break-help").hidden = scene === "quiz";
    $("script-box").hidden = scene === "quiz";
  }

  function fillScript(lines) {
    const list = $("lines");
    list.replaceChildren(...lines.map(([text, note]) => {
      const item = document.createElement("li");
      item.textContent = text;
      if (note && note !== "nothing") {
        const comment = document.createElement("span");
        comment.textContent = `   # ${note}`;
        item.append(comment);
      }
      return item;
    }));
    list.scrollTop = list.scrollHeight;
    $("replay").disabled = lines.length < 2;
    $("copy-script").disabled = lines.length === 0;
  }

  function fillSelected(now) {
    selected = now;
    mark("on", now.ids);
    mark("trail", []);
    clearTimeout(timer);
    $("trail").textContent = "";
    const first = now.ids.length > 1 ? `${now.ids[0]}, then ` : "";
    const waits = now.waiting ? `${now.waiting}: ` : "";
    $("selected").textContent = now.title ? waits + first + now.title : quiz.what ? "Nothing is selected" : "Click a corner, an edge or a face";
    $("pointers").replaceChildren(...now.pointers.map(([name, to]) => {
      const pair = document.createElement("div");
      const term = document.createElement("dt");
      const value = document.createElement("dd");
      const button = document.createElement("button");
      term.textContent = name;
      button.type = "button";
      button.textContent = to;
      button.dataset.pick = to;
      value.append(button);
      pair.append(term, value);
      return pair;
    }));
    $("edits").replaceChildren(...now.edits.map(([word, text, help]) => {
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = text;
      button.title = `${word}: ${help}`;
      button.dataset.edit = word;
      button.setAttribute("aria-pressed", String(now.waiting === word));
      return button;
    }));
    const last = now.ids.at(-1);
    if (!last) return;
    const inside = picture.contains(document.activeElement);
    const next = rove(null);
    if (inside) next?.focus({ preventScroll: true });
    reveal(row(last));
  }

  // The page does not scroll: only the box of the table does.
  function reveal(line) {
    const box = line?.closest(".rows");
    if (!box) return;
    const head = box.querySelector("thead").offsetHeight;
    const [top, bottom] = [line.offsetTop - head, line.offsetTop + line.offsetHeight - box.clientHeight];
    box.scrollTop = Math.max(Math.min(box.scrollTop, top), bottom);
  }

  function say(message) {
    const { tone, text, elements: names } = said = message;
    const box = $("message");
    if (box.textContent !== text) box.textContent = text;
    box.className = text ? tone : "";
    if (tone === "refused") mark("bad", names);
    else if (scene !== "broken" && scene !== "quiz") mark("bad", []);
  }

  // A walk, element by element.
  function trail(names) {
    clearTimeout(timer);
    mark("trail", []);
    const box = $("trail");
    let count = still.matches ? names.length : 0;
    const step = () => {
      count += 1;
      const shown = names.slice(0, count);
      box.textContent = shown.join(" → ");
      mark("trail", shown);
      if (count < names.length) timer = setTimeout(step, STEP);
    };
    step();
  }

  function fillQuiz(now) {
    quiz = now;
    $("quiz").hidden = !now.what;
    if (!now.what) return;
    $("quiz-title").textContent = now.title;
    $("quiz-text").textContent = now.text;
    $("quiz-score").textContent = now.score;
    $("quiz-code").textContent = now.code ? `Your result: ${now.code}` : "";
    const target = $("quiz-target");
    if (target.dataset.drawn !== now.target) {
      target.innerHTML = now.target;
      target.dataset.drawn = now.target;
    }
    $("quiz-choices").replaceChildren(...now.choices.map((text, i) => {
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = text;
      button.dataset.answer = i;
      return button;
    }));
    $("quiz-next").disabled = !now.answered || Boolean(now.code);
    $("quiz-check").hidden = now.what !== "make_drawing" || now.answered;
  }

  // The scene is in the address, and with the browser, if it allows that.
  let waiting = 0;
  function keep(now) {
    link = now;
    clearTimeout(waiting);
    waiting = setTimeout(() => {
      try {
        history.replaceState(null, "", now ? `#${now}` : "#");
      } catch { /* too often, or not allowed: the link can still be copied */ }
      try {
        if (now) localStorage.setItem("dcel-playground", now);
      } catch { /* a private window */ }
    }, 250);
  }

  // Files.

  function download(name, blob) {
    const a = document.createElement("a");
    a.href = URL.createObjectURL(blob);
    a.download = name;
    a.click();
    setTimeout(() => URL.revokeObjectURL(a.href), 10000);
  }

  let use = "save";
  function save(file) {
    if (use === "play") {
      // Its links stay in it: without a base they would lead to this page.
      $("film").querySelector("iframe").srcdoc = file.text.replace("<head>", '<head><base href="about:srcdoc">');
      $("film").showModal();
    } else if (use === "png") {
      const image = new Image();
      const url = URL.createObjectURL(new Blob([file.text], { type: file.mime }));
      image.onload = () => {
        const canvas = document.createElement("canvas");
        [canvas.width, canvas.height] = [2 * image.width, 2 * image.height];
        canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
        canvas.toBlob((blob) => download("drawing.png", blob), "image/png");
        URL.revokeObjectURL(url);
      };
      image.src = url;
    } else if (use === "copy") {
      copy(file.text, "the script is copied");
    } else {
      download(file.name, new Blob([file.text], { type: file.mime }));
      if (!$("message").textContent) say({ tone: "done", text: `${file.name} is saved`, elements: [] });
    }
  }

  function exportAs(what, how) {
    use = how;
    ask({ do: "export", what });
    use = "save";
  }

  async function copy(text, done) {
    try {
      await navigator.clipboard.writeText(text);
    } catch {
      const area = document.createElement("textarea");
      area.value = text;
      document.body.append(area);
      area.select();
      document.execCommand("copy");
      area.remove();
    }
    say({ tone: "done", text: done, elements: [] });
  }

  async function open(file) {
    if (!file) return;
    if (file.size > FILE) {
      const size = (file.size / (1 << 20)).toFixed(1);
      say({ tone: "refused", text: `${file.name} has ${size} MB: the playground takes files up to ${FILE >> 20} MB; \`dcel figure\` draws any size`, elements: [] });
      return;
    }
    const bytes = new Uint8Array(await file.arrayBuffer());
    call(() => kit.open(file.name, bytes));
  }

  // Mouse, pen and finger.

  function place(event) {
    const svg = picture.querySelector("svg");
    const matrix = svg?.getScreenCTM();
    if (!matrix) return null;
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
    return { x: at.x, y: at.y, reach: (event.pointerType === "mouse" ? 11 : 22) / matrix.a };
  }

  let held = null;
  let frame = 0;

  picture.addEventListener("pointerdown", (event) => {
    const at = place(event);
    if (!at || event.button !== 0) return;
    closeMenus();
    const can = (scene === "plane" || scene === "points") && !corners;
    const under = can ? JSON.parse(kit.act(JSON.stringify({ do: "hover", ...at }))).hover ?? "" : "";
    held = { id: under.startsWith("v") ? under : "", from: [event.clientX, event.clientY], moved: false, target: event.target, at };
    picture.setPointerCapture(event.pointerId);
  });

  picture.addEventListener("pointermove", (event) => {
    if (!held) return;
    const [x, y] = held.from;
    held.moved ||= Math.abs(event.clientX - x) + Math.abs(event.clientY - y) > 5;
    if (!held.moved || !held.id) return;
    held.at = place(event);
    frame ||= requestAnimationFrame(() => {
      frame = 0;
      if (held?.at) ask({ do: "drag", id: held.id, x: held.at.x, y: held.at.y });
    });
  });

  picture.addEventListener("pointerup", (event) => {
    const now = held;
    held = null;
    cancelAnimationFrame(frame);
    frame = 0;
    const at = place(event);
    if (!now || !at) return;
    if (now.moved && now.id) {
      overlay("");
      const reply = ask({ do: "drop", id: now.id, x: at.x, y: at.y });
      if (reply.message?.tone === "refused" && scene === "points") ask({ do: "show" });
    } else if (corners) {
      corners.push([at.x, at.y]);
      ask({ do: "outline", places: corners });
    } else if (scene === "kernel") {
      const name = now.target.closest?.("[data-name]")?.dataset.name;
      if (name) ask({ do: "pick", id: name });
    } else {
      ask({ do: "click", ...at });
    }
  });

  picture.addEventListener("pointercancel", () => {
    if (held?.moved) {
      overlay("");
      ask({ do: "show" });
    }
    held = null;
  });

  const hot = (name) => mark("hot", name ? [name] : []);
  picture.addEventListener("pointerover", (event) => {
    if (!held) hot(event.target.closest("[data-name]")?.dataset.name);
  });
  $("tables").addEventListener("pointerover", (event) => {
    const cell = event.target.closest("[data-to]");
    hot(cell?.dataset.to ?? event.target.closest("[data-id]")?.dataset.id);
  });
  for (const box of [picture, $("tables")]) box.addEventListener("pointerleave", () => hot(""));

  // Buttons.

  function closeMenus() {
    for (const menu of document.querySelectorAll(".menu[open]")) menu.open = false;
  }
  document.addEventListener("click", (event) => {
    const inside = event.target.closest(".menu");
    for (const menu of document.querySelectorAll(".menu[open]")) {
      if (menu !== inside || event.target.closest("button")) menu.open = false;
    }
    const button = event.target.closest("button");
    if (!button) return;
    const data = button.dataset;
    if (data.start) ask({ do: "start", what: data.start });
    else if (data.export) exportAs(data.export, "save");
    else if (data.edit) ask({ do: "edit", word: data.edit });
    else if (data.pick) ask({ do: "pick", id: data.pick });
    else if (data.over) ask({ do: "over", what: data.over });
    else if (data.answer) ask({ do: "answer", answer: data.answer });
  });
  const buttons = {
    undo: () => ask({ do: "undo" }),
    redo: () => ask({ do: "redo" }),
    mend: () => ask({ do: "mend" }),
    keep: () => ask({ do: "keep" }),
    "quiz-next": () => ask({ do: "next" }),
    "quiz-quit": () => ask({ do: "quit" }),
    "quiz-check": () => ask({ do: "answer", answer: "" }),
    png: () => exportAs("svg", "png"),
    replay: () => exportAs("play", "play"),
    "copy-script": () => exportAs("script", "copy"),
    "copy-link": () => copy(link ? location.href.split("#")[0] + "#" + link : "", link ? "the link is copied: it holds the whole scene" : "the scene is too large for a link: save it as .dcel"),
    open: () => $("file").click(),
    help: () => $("keys").showModal(),
    polygon: () => {
      corners = [];
      outlining(true);
    },
    finish: () => {
      const reply = ask({ do: "polygon", places: corners });
      if (reply.svg !== undefined) outlining(false);
    },
    cancel: () => outlining(false),
    understood: () => {
      $("hint").hidden = true;
      try {
        localStorage.setItem("dcel-playground-hint", "seen");
      } catch { /* a private window: it is shown again */ }
    },
    break: () => {
      breaking = !breaking;
      $("break").setAttribute("aria-pressed", String(breaking));
      $("tables").classList.toggle("breaking", breaking);
      $("break-help").textContent = breaking
        ? "Click a pointer, write where it should lead, press Enter: see which invariants break."
        : "A click on a pointer shows where it leads.";
    },
  };
  for (const [id, act] of Object.entries(buttons)) $(id).addEventListener("click", act);

  function outlining(on) {
    $("corners").hidden = !on;
    picture.classList.toggle("dim", on);
    if (on) return say({ tone: "note", text: "", elements: [] });
    corners = null;
    overlay("");
    resize();
  }

  $("practise").addEventListener("submit", (event) => {
    event.preventDefault();
    const what = event.submitter?.value ?? "where_am_i";
    closeMenus();
    if (what === "code") ask({ do: "code", code: $("code").value });
    else ask({ do: "quiz", what, level: Number($("level").value), seed: Number.parseInt($("seed").value, 10) || 0 });
  });
  $("walk").addEventListener("submit", (event) => {
    event.preventDefault();
    const path = $("path").value.trim();
    if (quiz.what === "where_am_i" && !quiz.answered) ask({ do: "answer", answer: path });
    else if (quiz.what === "find_fault" && !quiz.answered) ask({ do: "answer", answer: path });
    else if (path) ask({ do: "walk", path });
  });
  $("script").addEventListener("submit", (event) => {
    event.preventDefault();
    const text = $("line").value;
    if (!text.trim()) return;
    const reply = ask({ do: "script", text });
    if (reply.message?.tone !== "refused") $("line").value = "";
  });
  $("line").addEventListener("keydown", (event) => {
    if (event.key === "Enter" && !event.shiftKey) {
      event.preventDefault();
      $("script").requestSubmit();
    }
  });
  $("file").addEventListener("change", async (event) => {
    await open(event.target.files[0]);
    event.target.value = "";
  });
  $("tables-box").addEventListener("toggle", () => {
    fillTables(tables);
    mark("on", selected.ids);
  });

  // Tables.

  function cellChosen(cell) {
    const id = cell.closest("tr").dataset.id;
    const { pointer, to } = cell.dataset;
    if (!pointer) {
      if (cell.tagName === "TH") ask({ do: "pick", id });
    } else if (quiz.what === "find_fault" && !quiz.answered) {
      ask({ do: "break", id, pointer, to: "" });
    } else if (breaking && !quiz.what) {
      const input = document.createElement("input");
      input.value = to ?? "none";
      input.setAttribute("aria-label", `${id}.${pointer} leads to`);
      cell.replaceChildren(input);
      input.select();
      const back = () => input.isConnected && (cell.textContent = to ?? "none");
      input.addEventListener("blur", back);
      input.addEventListener("keydown", (event) => {
        event.stopPropagation();
        if (event.key === "Escape") back();
        if (event.key !== "Enter") return;
        input.removeEventListener("blur", back);
        const reply = ask({ do: "break", id, pointer, to: input.value });
        if (reply.tables === undefined) input.addEventListener("blur", back);
      });
      input.focus();
    } else if (to) {
      ask({ do: "pick", id: to });
    }
  }
  $("tables").addEventListener("click", (event) => {
    const cell = event.target.closest("tbody td, tbody th");
    if (cell && event.target.tagName !== "INPUT") cellChosen(cell);
  });
  $("tables").addEventListener("keydown", (event) => {
    const box = event.target.closest(".rows");
    if (!box || event.target.tagName === "INPUT") return;
    const cells = [...box.querySelectorAll("tbody tr")].map((line) => [...line.children]);
    const y = cells.findIndex((line) => line.includes(event.target));
    const x = y < 0 ? 0 : cells[y].indexOf(event.target);
    const go = { ArrowDown: [0, 1], ArrowUp: [0, -1], ArrowRight: [1, 0], ArrowLeft: [-1, 0] }[event.key];
    if (go) {
      const cell = y < 0 ? cells[0]?.[0] : cells[y + go[1]]?.[x + go[0]];
      cell?.setAttribute("tabindex", "-1");
      cell?.focus();
    } else if (event.key === "Enter" && y >= 0) {
      cellChosen(event.target);
    } else {
      return;
    }
    event.preventDefault();
    event.stopPropagation();
  });

  // Keys.

  const keys = {
    n: { do: "follow", link: "next" },
    p: { do: "follow", link: "prev" },
    t: { do: "follow", link: "twin" },
    o: { do: "follow", link: "origin" },
    d: { do: "follow", link: "destination" },
    f: { do: "follow", link: "face" },
    s: { do: "edit", word: "split_face" },
    m: { do: "edit", word: "split_in_half" },
    i: { do: "edit", word: "flip_edge" },
    x: { do: "edit", word: "remove_edge" },
    Escape: { do: "leave" },
  };
  const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

  document.addEventListener("keydown", (event) => {
    const typing = event.target.closest("input, textarea, select, dialog");
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if ((event.ctrlKey || event.metaKey) && !typing && (key === "z" || key === "y")) {
      event.preventDefault();
      ask({ do: key === "y" || event.shiftKey ? "redo" : "undo" });
      return;
    }
    if (typing || event.ctrlKey || event.metaKey || event.altKey) return;
    const chosen = selected.ids.at(-1) ?? "";
    const inPicture = picture.contains(event.target);
    if (key === "/") {
      event.preventDefault();
      $("path").focus();
    } else if (corners && (key === "Enter" || key === "Escape")) {
      $(key === "Enter" ? "finish" : "cancel").click();
    } else if (arrows[key] && event.shiftKey && chosen.startsWith("v")) {
      event.preventDefault();
      const [x, y] = arrows[key];
      ask({ do: "nudge", id: chosen, x, y });
    } else if (arrows[key] && inPicture) {
      event.preventDefault();
      step(event.target, arrows[key]);
    } else if ((key === "Enter" || key === " ") && inPicture) {
      event.preventDefault();
      const name = event.target.dataset.name;
      const second = selected.waiting && selected.ids.length > 1 ? selected.ids.at(-1) : name;
      if (second) ask({ do: "pick", id: second });
    } else if (key === "e" && chosen) {
      ask({ do: "follow", link: chosen.startsWith("f") ? "half_edge" : "outgoing" });
    } else if (key === "x" && chosen.startsWith("v")) {
      ask({ do: "edit", word: "remove_vertex" });
    } else if (keys[key]) {
      ask(keys[key]);
    }
  });

  // Left and right through the elements of a kind, up and down to the next kind.
  function step(from, [across, up]) {
    const kinds = ["v", "h", "f"];
    const name = from.dataset.name ?? "h0";
    const all = (kind) => [...named.keys()].filter((known) => known.startsWith(kind));
    let list = all(name[0]);
    let at = list.indexOf(name) + across;
    if (up) {
      list = all(kinds[(kinds.indexOf(name[0]) + up + 3) % 3]);
      at = 0;
    }
    const next = elements(list[(at + list.length) % list.length])[0];
    rove(next)?.focus({ preventScroll: true });
    hot(next?.dataset.name);
  }

  // Files that are dropped.

  for (const kind of ["dragenter", "dragover"]) {
    document.addEventListener(kind, (event) => {
      event.preventDefault();
      picture.classList.add("over");
    });
  }
  for (const kind of ["dragleave", "drop"]) document.addEventListener(kind, () => picture.classList.remove("over"));
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    open(event.dataTransfer?.files[0]);
  });

  // The room for the picture.

  const room = () => ({ do: "resize", width: picture.clientWidth - 4, height: picture.clientHeight - 4 });

  // A window that is turned, or shares the screen with a keyboard, takes back nothing of what was said. The corners of
  // a polygon are places of the picture: it gets its room when they are done.
  let sized = 0;
  function resize() {
    if (corners) return;
    const before = said;
    ask(room());
    if (before.text) say(before);
  }
  window.addEventListener("resize", () => {
    clearTimeout(sized);
    sized = setTimeout(resize, 120);
  });

  window.addEventListener("hashchange", () => {
    const text = location.hash.slice(1);
    if (text && text !== link) ask({ do: "link", text });
  });

  // The beginning: the scene of the address, else of the file in this page, else of the last time.

  function begin() {
    kit.act(JSON.stringify(room()));
    ask({ do: "show" });
    const text = location.hash.slice(1);
    const inside = $("scene");
    if (text) {
      ask({ do: "link", text });
    } else if (inside.dataset.name) {
      const bytes = Uint8Array.from(atob(inside.textContent), (letter) => letter.charCodeAt(0));
      call(() => kit.open(inside.dataset.name, bytes));
    } else {
      let last = null;
      try {
        last = localStorage.getItem("dcel-playground");
      } catch { /* a private window */ }
      if (last) ask({ do: "link", text: last });
    }
    $("seed").value = String(Math.floor(Math.random() * 1000));
  }

  try {
    await unpack();
  } catch (error) {
    picture.textContent = `This browser cannot run the playground: ${error.message}. A current Firefox, Chrome, Edge or Safari can.`;
    return;
  }
  begin();
  document.documentElement.dataset.ready = "yes";
})();
