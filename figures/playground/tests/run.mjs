// The playground in a browser, used as people use it: by mouse, keys and fingers, wide and narrow, light and dark.
//
//   node figures/playground/tests/run.mjs [--axe FILE] [--pictures DIR] [NAME …]
//
// FILE is axe.min.js of the npm package axe-core. Every error, every message on the console and every request to anywhere
// is a failure.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { Browser, browser, sleep } from "./browser.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const FILE = resolve(here, "../../playground.html");
const PAGE = pathToFileURL(FILE).href;
const arguments_ = process.argv.slice(2);
const option = (name) => {
  const at = arguments_.indexOf(name);
  return at < 0 ? "" : arguments_.splice(at, 2)[1];
};
const [axe, pictures] = [option("--axe"), option("--pictures")];

const program = browser();
if (!program) {
  console.log("ignored (needs chromium)");
  process.exit(0);
}

const text = (page, id) => page.evaluate(`document.getElementById("${id}").textContent`);
const says = async (page, what) => {
  await page.until(`document.getElementById("message").textContent.includes(${JSON.stringify(what)})`, `message “${what}”`);
};
const vertex = (name) => `#picture [id$="-${name}"] circle`;
const half = (name) => `#picture [id$="-${name}"] .sh`;
const action = (page, id) => page.evaluate(`document.getElementById("${id}").click()`);
const menu = async (page, selector) => page.evaluate(`document.querySelector(${JSON.stringify(selector)}).click()`);

/** What is saved under which name, taken before it reaches the disk. */
const downloads = (page) =>
  page.evaluate(`window.saved = []; HTMLAnchorElement.prototype.click = function () {
    const name = this.download;
    window.saved.push(name); window.blobs ??= {}; window.blobs[name] ??= window.lastBlob; };
    const make = URL.createObjectURL; URL.createObjectURL = (blob) => { window.lastBlob = blob; return make.call(URL, blob); };`);
const savedText = (page, name) => page.evaluate(`window.blobs[${JSON.stringify(name)}].text()`);

const run = async (page, line) => {
  await page.evaluate(`document.getElementById("line").focus()`);
  await page.type(line);
  await page.until(`document.getElementById("line").value.includes(${JSON.stringify(line)})`, `“${line}” is typed`);
  await page.key("Enter");
  await sleep(60);
};

const tests = {
  async "two corners are joined, and refused at the elements"(page) {
    await page.click(vertex("v1"));
    assert.match(await text(page, "selected"), /^vertex v1/);
    await page.click(vertex("v4"));
    await says(page, "split_face h2 h8 returned h12, f2");
    assert.equal(await text(page, "counts"), "6 vertices, 7 edges, 3 faces");
    await page.key("Escape");
    await page.click(vertex("v0"));
    await page.click(vertex("v3"));
    await says(page, "h0 bounds f2, but h6 bounds f1");
    assert.ok(await page.evaluate(`document.querySelector('[data-name="h6"]').classList.contains("bad")`));
  },

  async "an edge is split, flipped, removed; undo and redo"(page) {
    await page.click(vertex("v1"));
    await page.click(vertex("v4"));
    await page.click(half("h12"));
    await page.click('[data-edit="split_in_half"]');
    await says(page, "split_in_half h12 returned v6");
    await action(page, "undo");
    await says(page, "taken back: split_in_half h12");
    await page.click(half("h12"));
    await page.click('[data-edit="flip_edge"]');
    await says(page, "f2 beside h12 is no triangle");
    await run(page, "triangles 0 0 4 0 4 3 0 3 / 0 1 2 0 2 3");
    await page.key("Escape");
    const inner = await page.evaluate(`[...document.querySelectorAll(".he")].find((h) => h.dataset.face !== "f0" && document.querySelector('[data-name="' + h.dataset.twin + '"]').dataset.face !== "f0").dataset.name`);
    await page.click(half(inner));
    await page.click('[data-edit="flip_edge"]');
    await says(page, `flip_edge ${inner}`);
    const flipped = await text(page, "lines");
    await page.click(half(inner));
    await page.click('[data-edit="remove_edge"]');
    await says(page, "remove_edge e");
    assert.equal(await text(page, "counts"), "4 vertices, 4 edges, 2 faces");
    await action(page, "undo");
    assert.equal(await text(page, "lines"), flipped);
    await action(page, "redo");
    await says(page, "done again: remove_edge e");
  },

  async "a corner is dragged while that is legal"(page) {
    const [x, y] = await page.middle(vertex("v0"));
    await page.press([[x, y], [x + 10, y - 8], [x + 25, y - 20], [x + 40, y - 30]]);
    await says(page, "set_point v0");
    const [a, b] = await page.middle(vertex("v0"));
    assert.ok(Math.hypot(a - x - 40, b - y + 30) < 3, `it stands at ${a}, ${b}`);
    const [far, top] = await page.middle(vertex("v3"));
    const before = await text(page, "lines");
    await page.press([[a, b], [a + 60, b], [far + 10, top], [far + 14, top + 4]]);
    assert.equal(await page.evaluate(`document.getElementById("message").className`), "refused");
    assert.equal(await text(page, "lines"), before);
  },

  async "a finger or the mouse shows in red where an edge would cross"(page) {
    const [x, y] = await page.middle(vertex("v1"));
    const [, top] = await page.middle(vertex("v4"));
    const hold = page.touch
      ? (type, x, y) => page.send("Input.dispatchTouchEvent", { type: { down: "touchStart", move: "touchMove", up: "touchEnd" }[type], touchPoints: type === "up" ? [] : [{ x, y }] })
      : (type, x, y) => page.send("Input.dispatchMouseEvent", { type: { down: "mousePressed", move: "mouseMoved", up: "mouseReleased" }[type], x, y, button: "left", buttons: type === "up" ? 0 : 1, clickCount: 1 });
    await hold("down", x, y);
    await hold("move", x, y - 20);
    await hold("move", x, top - 20);
    await page.until(`document.querySelector("#over .bad")`, "the crossing is red");
    const colour = await page.evaluate(`getComputedStyle(document.querySelector("#over .drag.bad")).stroke`);
    const bad = await page.evaluate(`(() => { const p = document.createElement("p"); p.style.color = "var(--bad)"; document.body.append(p); const c = getComputedStyle(p).color; p.remove(); return c; })()`);
    assert.equal(colour, bad);
    await hold("up", x, top - 20);
    await sleep(60);
    assert.equal(await text(page, "counts"), "6 vertices, 6 edges, 2 faces");
  },

  async "keys: walking, splitting, moving, arrows, Enter"(page) {
    await page.evaluate(`document.querySelector('#picture [tabindex="0"]').focus()`);
    await page.key("Enter");
    assert.match(await text(page, "selected"), /^half-edge h0/);
    for (const [key, found] of [["n", "h2"], ["t", "h3"], ["p", "h5"], ["o", "v3"], ["e", "h6"], ["f", "f1"], ["e", "h0"]]) {
      await page.key(key);
      await page.until(`document.getElementById("selected").textContent.split(/[ ,]/).includes("${found}")`, `${key} leads to ${found}`);
    }
    await page.key("n");
    await page.key("s");
    await says(page, "choose the second element");
    for (const key of ["n", "n", "n", "Enter"]) await page.key(key);
    await says(page, "split_face h2 h8 returned h12, f2");
    await page.key("m");
    await says(page, "split_in_half h12");
    await page.key("z", 2);
    await says(page, "taken back: split_in_half h12");
    await page.key("y", 2);
    await says(page, "done again: split_in_half h12");
    await page.key("Escape");
    await page.evaluate(`document.querySelector('[data-name="v3"]').focus()`);
    await page.key("ArrowRight");
    assert.equal(await page.evaluate("document.activeElement.dataset.name"), "v4");
    await page.key("Enter");
    await page.key("ArrowUp", 8);
    await says(page, "set_point v4 0 ");
    await page.key("/");
    assert.equal(await page.evaluate("document.activeElement.id"), "path");
  },

  async "a path is walked, a wrong one explained"(page) {
    await page.evaluate(`document.getElementById("path").focus()`);
    await page.type("h2.next.twin.prev");
    await page.key("Enter");
    await page.until(`document.getElementById("trail").textContent === "h2 → h4 → h5 → h7"`, "the walk");
    assert.equal(await page.evaluate(`document.querySelectorAll("#picture .trail").length`), 4);
    await page.evaluate(`document.getElementById("path").value = "h2.nxt"; document.getElementById("walk").requestSubmit()`);
    await says(page, "`nxt` is not a link of a half-edge; known: next");
  },

  async "script lines are typed, refused, named, pasted and copied"(page) {
    await run(page, "let door = split_face h2 h8");
    await says(page, "split_face h2 h8 returned h12, f2");
    await run(page, "split_in_half door");
    await run(page, "split_face h2 h99");
    await says(page, "h99");
    assert.equal(await page.evaluate(`document.getElementById("line").value`), "split_face h2 h99", "what was typed stays");
    assert.match(await text(page, "lines"), /let door = split_face h2 h8 {3}# h12, f2/);
    const before = await text(page, "lines");
    await page.evaluate(`document.getElementById("line").value = "rectangle\\nsplit_face h2 h8\\n\\n\\n\\n\\nsplit_fase h2 h8"; document.getElementById("script").requestSubmit()`);
    await says(page, "script:7:1");
    assert.equal(await text(page, "lines"), before);
    await page.evaluate(`navigator.clipboard.writeText = (text) => { window.copied = text; return Promise.resolve(); }`);
    await action(page, "copy-script");
    await page.until("window.copied", "the script is copied");
    assert.match(await page.evaluate("window.copied"), /^rectangle\nlet door = split_face h2 h8 {3}# h12, f2\nlet a2 = split_in_half door/);
  },

  async "tables and picture are linked both ways"(page) {
    await page.evaluate(`document.querySelector('tr[data-id="h4"] th').click()`);
    assert.match(await text(page, "selected"), /^half-edge h4/);
    assert.ok(await page.evaluate(`document.querySelector('[data-name="h4"]').classList.contains("on")`));
    await page.evaluate(`document.querySelector('tr[data-id="h4"] [data-pointer="twin"]').click()`);
    assert.match(await text(page, "selected"), /^half-edge h5/);
    await page.key("Escape");
    await page.click(half("h10"));
    assert.ok(await page.evaluate(`document.querySelector('tr[data-id="h10"]').classList.contains("on")`));
    const pointers = await page.evaluate(`[...document.querySelectorAll("#pointers div")].map((pair) => pair.textContent).join(" ")`);
    assert.equal(pointers, "originv5 twinh11 nexth0 prevh8 facef1");
    assert.equal(await page.evaluate(`getComputedStyle(document.querySelector('[data-name="h10"] .ptr')).display`), "inline");
    // By keys alone.
    await page.evaluate(`document.querySelector(".rows").focus()`);
    for (const key of ["ArrowDown", "ArrowDown", "ArrowRight", "ArrowRight", "Enter"]) await page.key(key);
    assert.match(await text(page, "selected"), /^half-edge h0/, "h1.twin");
  },

  async "a pointer is broken by hand, the invariants are listed, and mended"(page) {
    await action(page, "break");
    const lead = async (id, pointer, to) => {
      await page.evaluate(`document.querySelector('tr[data-id="${id}"] [data-pointer="${pointer}"]').click()`);
      await page.evaluate(`document.querySelector("td input").value = "${to}"`);
      await page.key("Enter");
      await sleep(60);
    };
    await lead("h2", "next", "h8");
    await says(page, "h2.next = h8 (it was h4)");
    assert.match(await text(page, "violations"), /N2: h2\.next = h8, but h8\.prev = h6 \(expected h2\)/);
    assert.ok(await page.evaluate(`document.querySelector('[data-name="h2"]').classList.contains("bad")`));
    await lead("h2", "next", "v1");
    await says(page, "h2.next leads to a half-edge such as h0, and `v1` is none");
    await action(page, "mend");
    assert.equal(await text(page, "violations"), "Every invariant holds.");
    await action(page, "break");
  },

  async "the last edit is played step by step"(page) {
    await run(page, "split_face h2 h8");
    await action(page, "replay");
    await page.until(`document.getElementById("film").open`, "the film opens");
    for (let i = 0; i < 100 && !(await page.within(`document.querySelector("svg .fr") !== null`).catch(() => false)); i += 1) await sleep(50);
    assert.match(await page.within("document.body.textContent"), /split_face h2 h8/);
    const count = () => page.within(`document.getElementById("count").textContent`);
    const first = await count();
    await page.within(`document.getElementById("next").click()`);
    assert.match(first, /^1 of \d+$/);
    assert.match(await count(), /^2 of \d+$/, "the player runs");
    assert.ok(await page.within(`[...document.querySelectorAll(".fr")].filter((frame) => frame.getBoundingClientRect().width > 0).length === 1`), "one frame is seen");
    await page.evaluate(`document.getElementById("film").close()`);
  },

  async "everything can be saved: SVG, PNG, structure, script, film, link"(page) {
    await run(page, "split_face h2 h8");
    await downloads(page);
    for (const what of ["svg", "dcel", "script", "film"]) {
      await menu(page, `[data-export="${what}"]`);
    }
    await action(page, "png");
    await page.until("window.saved.length === 5", "five files");
    assert.deepEqual((await page.evaluate("window.saved")).sort(), ["drawing.dcel", "drawing.dcels", "drawing.png", "drawing.svg", "film.html"]);
    assert.match(await savedText(page, "drawing.svg"), /^<svg[^]*<\/svg>\s*$/);
    assert.match(await savedText(page, "drawing.dcel"), /^dcel 1\nv0 -250 -150 out h0/);
    assert.match(await savedText(page, "film.html"), /^<!DOCTYPE html>/);
    assert.ok((await page.evaluate(`window.blobs["drawing.png"].size`)) > 5000);
    await page.evaluate(`navigator.clipboard.writeText = (text) => { window.copied = text; return Promise.resolve(); }`);
    await action(page, "copy-link");
    await page.until("window.copied", "the link is copied");
    assert.match(await page.evaluate("window.copied"), /playground\.html#1\.\d+\./);
  },

  async "a reload keeps the scene; cut links and later ones are told, and change nothing"(page) {
    await run(page, "let a = split_face h2 h8");
    await run(page, "split_in_half a");
    await page.until(`location.hash.length > 20`, "the link is in the address");
    await sleep(300);
    const [lines, address] = [await text(page, "lines"), await page.evaluate("location.href")];
    await page.open(address);
    assert.equal(await text(page, "lines"), lines);
    for (const [hash, told] of [[address.split("#")[1].slice(0, -4), "this link is cut short"], ["2.10.abcdefghij", "made by a later playground"], ["1.4.abcd", "altered"], ["walk", "no link of the playground"]]) {
      await page.evaluate(`location.hash = ${JSON.stringify(hash)}`);
      await says(page, told);
      assert.equal(await text(page, "lines"), lines);
    }
    // Without an address, what the browser has kept.
    await page.open(PAGE);
    assert.equal(await text(page, "lines"), lines);
  },

  async "files are dropped, good ones and bad ones"(page) {
    const drop = (name, body) =>
      page.evaluate(`(() => { const data = new DataTransfer(); data.items.add(new File([${body}], ${JSON.stringify(name)})); document.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true })); })()`);
    await drop("square.obj", JSON.stringify("v 0 0\nv 4 0\nv 4 4\nv 0 4\nf 1 2 3\nf 1 3 4\n"));
    await page.until(`document.getElementById("counts").textContent === "4 vertices, 5 edges, 3 faces"`, "the square is drawn");
    const lines = await text(page, "lines");
    for (const [name, body, told] of [
      ["photo.png", "new Uint8Array([137, 80, 78, 71, 0, 1, 2])", "photo.png"],
      ["bad.obj", JSON.stringify("v 0 0\nv 1 x\n"), "bad.obj:2:5: `x` is not a number"],
      ["huge.obj", "new Uint8Array(50 << 20)", "huge.obj has 50.0 MB"],
    ]) {
      await drop(name, body);
      await says(page, told);
      assert.equal(await text(page, "lines"), lines);
    }
    await drop("sites.xy", JSON.stringify("0 0\n4 1\n2 5\n3 2\n"));
    await page.until(`!document.getElementById("layers").hidden`, "points are a scene of their own");
  },

  async "a polygon is drawn by clicks"(page) {
    await action(page, "polygon");
    const box = await page.evaluate(`(() => { const b = document.querySelector("#picture svg").getBoundingClientRect(); return [b.x, b.y, b.width, b.height]; })()`);
    for (const [x, y] of [[0.2, 0.2], [0.2, 0.8], [0.8, 0.8], [0.7, 0.3]]) {
      await page.press([[box[0] + x * box[2], box[1] + y * box[3]]]);
    }
    assert.equal(await page.evaluate(`document.querySelectorAll("#over circle").length`), 4);
    await page.click("#finish");
    await page.until(`document.getElementById("counts").textContent === "4 vertices, 4 edges, 2 faces"`, "the polygon is there");
    assert.match(await text(page, "lines"), /^polygon /);
    await run(page, "split_face h0 h4");
    await says(page, "returned h8, f2");
  },

  async "points carry their triangulation along, then become a structure"(page) {
    await menu(page, '[data-start="points"]');
    await page.click('[data-over="voronoi"]');
    await page.until(`document.querySelectorAll("#over .voronoi").length > 5`, "Voronoi edges");
    const [x, y] = await page.middle(vertex("v5"));
    const before = await page.evaluate(`document.getElementById("over").innerHTML`);
    await page.press([[x, y], [x + 10, y + 5], [x + 20, y + 10]]);
    assert.notEqual(await page.evaluate(`document.getElementById("over").innerHTML`), before);
    await action(page, "undo");
    assert.equal(await page.evaluate(`document.getElementById("over").innerHTML`), before);
    await page.click('[data-over="circles"]');
    await page.until(`document.querySelectorAll("#over .circle").length > 5`, "circles");
    await page.click("#keep");
    await run(page, "split_in_half h0");
    await says(page, "split_in_half h0 returned");
  },

  async "a solid laid flat, and the torus with glued sides"(page) {
    await menu(page, '[data-start="dodecahedron"]');
    await page.until(`document.getElementById("counts").textContent === "20 vertices, 30 edges, 12 faces"`, "the dodecahedron");
    await menu(page, '[data-start="torus"]');
    await page.until(`document.getElementById("euler").textContent.endsWith("genus 1")`, "the torus");
    await page.click(half("h0"));
    assert.match(await text(page, "selected"), /^half-edge h0/);
    await page.click('[data-edit="split_edge"]');
    await says(page, "split_edge h0 returned v1");
    assert.ok(await page.evaluate(`document.querySelector('#picture [id*="-v1"]') !== null`));
  },

  async "where am I: wrong and right answers, the code at the end"(page) {
    await begin(page, "where_am_i", 1, 7);
    assert.match(await text(page, "quiz-text"), /^You stand on h\d+\. Follow /);
    assert.equal(await page.evaluate(`document.querySelectorAll("#tables tr").length`), 0, "the tables would tell");
    const asked = await text(page, "quiz-text");
    await action(page, "quiz-quit");
    await begin(page, "where_am_i", 1, 7);
    assert.equal(await text(page, "quiz-text"), asked, "the same seed asks the same");
    for (let i = 0; i < 5; i += 1) {
      // The pointers of the drawing itself tell where the path leads.
      const goal = await page.evaluate(`(() => {
        const words = document.getElementById("quiz-text").textContent.match(/h\\d+|next|twin|prev/g);
        let at = words[0];
        for (const word of words.slice(1)) at = document.querySelector('[data-name="' + at + '"]').dataset[word];
        return at;
      })()`);
      await page.click(half(i === 0 ? (goal === "h0" ? "h1" : "h0") : goal));
      await page.until(`!document.getElementById("quiz-next").disabled || document.getElementById("quiz-code").textContent`, "the answer is judged");
      assert.equal(await page.evaluate(`document.getElementById("message").className`), i === 0 ? "refused" : "right");
      if (i < 4) await page.click("#quiz-next");
    }
    const code = (await text(page, "quiz-code")).replace("Your result: ", "");
    assert.match(code, /^where_am_i-1-7-4of5-[0-9a-f]{4}$/);
    await action(page, "quiz-quit");
    assert.match(await text(page, "lines"), /^rectangle/, "the scene before it is back");
    await page.evaluate(`document.getElementById("code").value = "${code}"; document.querySelector('#practise [value="code"]').click()`);
    await says(page, "Where am I? Level 1, seed 7: 4 of 5 right.");
  },

  async "make this drawing: the two splits alone, the fewest moves"(page) {
    await begin(page, "make_drawing", 1, 1);
    assert.ok(await page.evaluate(`document.querySelector("#quiz-target svg") !== null`));
    await run(page, "remove_edge e0");
    await says(page, "only split_face and split_in_half draw this");
    await page.click("#quiz-check");
    await says(page, "not yet");
    await page.click(vertex("v1"));
    await page.click(vertex("v4"));
    await says(page, "right, in 1 move, the fewest");
    await page.click("#quiz-next");
    assert.match(await text(page, "quiz-text"), /a tent/);
    await action(page, "quiz-quit");
  },

  async "lab 04's ship is made by clicks"(page) {
    await begin(page, "make_drawing", 3, 1);
    assert.match(await text(page, "quiz-text"), /the ship of lab 04/);
    const ship = readFileSync(join(here, "../../scripts/lab-04-drawing.dcels"), "utf8");
    const lines = ship.split("\n").map((line) => line.split("#")[0].trim()).filter((line) => line && line !== "rectangle");
    const names = {};
    /** What a path of links leads to, walked in the page. */
    const found = async (path) => {
      const [first, ...links] = path.split(".");
      const start = names[first] ?? first;
      if (!links.length) return start;
      await page.evaluate(`document.getElementById("path").value = "${[start, ...links].join(".")}"; document.getElementById("walk").requestSubmit()`);
      return page.until(`document.getElementById("trail").textContent`).then(async () => (await text(page, "selected")).match(/[vhef][0-9]+/)[0]);
    };
    const choose = (id) => page.evaluate(`document.querySelector('tr[data-id="${id}"] th').click()`);
    let moves = 0;
    for (const line of lines) {
      const [, name, call] = line.match(/^(?:let (\w+) = )?(.*)$/);
      const [word, ...paths] = call.split(/\s+/);
      if (word !== "split_face" && word !== "split_in_half") {
        names[name] = await found(word);
        continue;
      }
      const ids = [];
      for (const path of paths) ids.push(await found(path));
      await page.evaluate(`document.activeElement.blur()`);
      await page.key("Escape");
      await choose(ids[0]);
      await page.evaluate(`document.querySelector('[data-edit="${word}"]').click()`);
      if (ids.length > 1) await choose(ids[1]);
      moves += 1;
      const message = await text(page, "message");
      assert.ok(moves === 27 || message.startsWith(`${word} ${ids.join(" ")} returned`), `${line}: ${message}`);
      if (name) names[name] = message.match(/returned (\w+)/)[1];
    }
    assert.equal(moves, 27);
    await says(page, "right, in 27 moves, the fewest");
    await page.until(`document.getElementById("counts").textContent.includes("33 edges")`, "the ship is drawn");
    await action(page, "quiz-quit");
  },

  async "find the fault: a cell of the tables is the answer"(page) {
    await begin(page, "find_fault", 1, 3);
    assert.ok(await page.evaluate(`document.querySelectorAll("#violations li").length > 0`));
    await page.evaluate(`document.querySelector('#tables [data-pointer]').click()`);
    await page.until(`!document.getElementById("quiz-next").disabled`, "the answer is judged");
    assert.match(await text(page, "message"), /should be/);
    await page.click("#quiz-next");
    // By keys: the answer as a word.
    await page.evaluate(`document.getElementById("path").value = "h0.colour"; document.getElementById("walk").requestSubmit()`);
    await says(page, "h0 has no pointer `colour`");
    await action(page, "quiz-quit");
  },

  async "predict the verdict: the call, then the reason"(page) {
    await begin(page, "predict", 2, 5);
    assert.equal(await page.evaluate(`document.querySelectorAll("#quiz-choices button").length`), 4);
    await page.click("#quiz-choices button");
    await sleep(80);
    const after = await page.evaluate(`[document.querySelectorAll("#quiz-choices button").length, document.getElementById("quiz-next").disabled]`);
    assert.ok((after[0] === 3 && after[1]) || (after[0] === 0 && !after[1]), `asked for the reason, or told: ${after}`);
    await action(page, "quiz-quit");
  },

  async "the hint is shown once"(page) {
    assert.equal(await page.evaluate(`document.getElementById("hint").hidden`), false);
    await page.click("#understood");
    await page.open(PAGE);
    assert.equal(await page.evaluate(`document.getElementById("hint").hidden`), true);
  },

  async "nothing is wider than the window, and everything has a name"(page) {
    assert.ok(await page.evaluate("document.documentElement.scrollWidth <= window.innerWidth"), "no scrolling sideways");
    if (!axe) return;
    await page.evaluate(readFileSync(axe, "utf8"));
    for (const scene of ["rectangle", "points", "torus"]) {
      await menu(page, `[data-start="${scene}"]`);
      await page.evaluate(`document.querySelector(".menu").open = true`);
      const found = await page.evaluate(`axe.run(document, { resultTypes: ["violations"] }).then(({ violations }) =>
        violations.filter(({ impact }) => impact === "serious" || impact === "critical")
          .map(({ id, help, nodes }) => id + ": " + help + ": " + nodes.slice(0, 3).map((node) => node.html.slice(0, 160)).join(" | ")))`);
      assert.deepEqual(found, [], scene);
    }
  },

  async "a half-edge that is pointed at shows its five pointers"(page) {
    const shown = `[...document.querySelectorAll("#picture .he .ptr")].filter((g) => getComputedStyle(g).display !== "none")
      .map((g) => g.closest(".he").dataset.name + ": " + g.children.length)`;
    assert.deepEqual(await page.evaluate(shown), []);
    await page.evaluate(`document.querySelector('[data-name="h2"].he').focus()`);
    await page.until(`JSON.stringify(${shown}).startsWith('["h2: ')`, "the pointers of h2 are shown");
    assert.equal((await page.evaluate(shown)).length, 1, "and no others");
    const links = await page.evaluate(`[...document.querySelectorAll('[data-name="h2"].he .ptr > *')].map((link) => link.getAttribute("class"))`);
    assert.deepEqual(links, ["next", "twin", "origin", "face-of"]);
    assert.equal(await page.evaluate(`document.querySelectorAll('[data-name="h2"].he .ptr .next .pl').length`), 2, "next, and prev by it");
  },

  async "a private window, where nothing can be kept, works all the same"(page) {
    const { identifier } = await page.send("Page.addScriptToEvaluateOnNewDocument", { source: `
      Object.defineProperty(window, "localStorage", { get() { throw new DOMException("denied", "SecurityError"); } });` });
    await page.open(PAGE);
    await run(page, "split_face h2 h8");
    await says(page, "split_face h2 h8 returned h12, f2");
    await action(page, "understood");
    await page.until(`location.hash.length > 20`, "the link is in the address");
    await sleep(300);
    const [lines, address] = [await text(page, "lines"), await page.evaluate("location.href")];
    await page.open(address);
    assert.equal(await text(page, "lines"), lines, "a reload keeps the scene by its address");
    await page.open(PAGE);
    assert.equal(await text(page, "counts"), "6 vertices, 6 edges, 2 faces", "without it the page begins anew");
    await page.send("Page.removeScriptToEvaluateOnNewDocument", { identifier });
  },

  async "a window that is turned, or gives room to a keyboard, takes nothing back"(page) {
    const kind = { deviceScaleFactor: 1, mobile: page.touch };
    let [width, height] = await page.evaluate(`[innerWidth, innerHeight]`);
    const drawn = () => page.evaluate(`(() => { const box = document.querySelector("#picture svg").viewBox.baseVal; return box.width + " x " + box.height; })()`);
    const turn = async (redrawn = true) => {
      const before = await drawn();
      [width, height] = [width - 12, height - 20];
      await page.send("Emulation.setDeviceMetricsOverride", { width, height, ...kind });
      if (redrawn) await page.until(`(() => { const box = document.querySelector("#picture svg").viewBox.baseVal; return box.width + " x " + box.height !== ${JSON.stringify(before)}; })()`, "the picture has its new room");
      else await sleep(300);
    };
    const has = (kind, name) => page.evaluate(`document.querySelector('#picture [data-name="${name}"]').classList.contains("${kind}")`);
    await run(page, "split_face h2 h8");
    await says(page, "split_face h2 h8 returned h12, f2");
    await turn();
    await says(page, "split_face h2 h8 returned h12, f2");
    await page.evaluate(`document.getElementById("path").value = "h2.next.twin"; document.getElementById("walk").requestSubmit()`);
    await page.until(`document.getElementById("trail").textContent === "h2 → h4 → h5"`, "the walk");
    await turn();
    assert.equal(await text(page, "trail"), "h2 → h4 → h5");
    assert.ok(await has("trail", "h4"), "the walk is marked");
    await page.click(vertex("v1"));
    await page.evaluate(`document.getElementById("line").value = "split_face h2 h8"; document.getElementById("script").requestSubmit()`);
    await says(page, "choose two half-edges of the same face");
    await turn();
    await says(page, "choose two half-edges of the same face");
    assert.ok(await has("bad", "h8") && await has("on", "v1"), "what is refused and what is selected are marked");
    assert.equal(await page.evaluate(`document.getElementById("line").value`), "split_face h2 h8");
    // A pointer that is being written.
    await action(page, "break");
    await page.evaluate(`document.querySelector('tr[data-id="h4"] [data-pointer="next"]').click()`);
    await page.evaluate(`document.querySelector("td input").value = "h1"`);
    await turn();
    assert.equal(await page.evaluate(`document.querySelector("td input")?.value`), "h1");
    assert.equal(await page.evaluate(`document.activeElement.tagName`), "INPUT");
    await page.key("Escape");
    await action(page, "break");
    // The corners of a polygon stay where they were clicked.
    await action(page, "polygon");
    await page.evaluate(`document.getElementById("picture").scrollIntoView()`);
    const [x, y, wide, high] = await page.evaluate(`(() => { const b = document.querySelector("#picture svg").getBoundingClientRect(); return [b.x, b.y, b.width, b.height]; })()`);
    for (const [right, down] of [[0.3, 0.3], [0.3, 0.7], [0.7, 0.7]]) await page.press([[x + right * wide, y + down * high]]);
    await turn(false);
    assert.equal(await page.evaluate(`document.querySelectorAll("#over circle").length`), 3);
    await action(page, "finish");
    await page.until(`document.getElementById("counts").textContent === "3 vertices, 3 edges, 2 faces"`, "the polygon is there");
    const room = await page.evaluate(`document.getElementById("picture").clientWidth - 4`);
    assert.ok((await drawn()).startsWith(`${room} x`), "the polygon has the new room");
  },

  async "nothing jumps while the page starts and the scene changes"(page) {
    const { identifier } = await page.send("Page.addScriptToEvaluateOnNewDocument", { source: `
      window.jumps = [];
      new PerformanceObserver((list) => list.getEntries().forEach((entry) => window.jumps.push([entry.value,
        entry.sources.map(({ node }) => node?.id || node?.nodeName || "gone").join(" ")]))).observe({ type: "layout-shift", buffered: true });` });
    await page.open(PAGE);
    await sleep(300);
    for (const line of ["split_face h2 h8", "split_in_half h12", "split_face h0 h99"]) {
      await page.evaluate(`document.getElementById("line").value = "${line}"; document.getElementById("script").requestSubmit()`);
      await sleep(200);
    }
    const jumps = await page.evaluate("window.jumps");
    const sum = jumps.reduce((all, [value]) => all + value, 0);
    assert.ok(sum < 0.02, JSON.stringify(jumps));
    await page.send("Page.removeScriptToEvaluateOnNewDocument", { identifier });
  },

  async "what is done before the kit is unpacked is no error"(page) {
    const { identifier } = await page.send("Page.addScriptToEvaluateOnNewDocument", { source: `
      const buffer = Response.prototype.arrayBuffer;
      Response.prototype.arrayBuffer = async function () {
        window.dispatchEvent(new Event("resize"));
        document.getElementById("line").value = "split_in_half h0";
        document.getElementById("script").requestSubmit();
        document.getElementById("undo").click();
        document.body.dispatchEvent(new KeyboardEvent("keydown", { key: "n", bubbles: true }));
        await new Promise((done) => setTimeout(done, 400));
        window.early = true;
        return buffer.call(this);
      };` });
    await page.open(PAGE);
    await page.send("Page.removeScriptToEvaluateOnNewDocument", { identifier });
    assert.equal(await page.evaluate("window.early"), true);
    assert.equal(await text(page, "counts"), "6 vertices, 6 edges, 2 faces");
    assert.equal(await page.evaluate(`document.getElementById("line").value`), "split_in_half h0", "what was typed stays");
  },

  async "2,000 edges are dragged at the pace of the screen, 20,000 can be used"(page) {
    const grid = (n) => {
      const corners = [];
      const faces = [];
      for (let y = 0; y <= n; y += 1) for (let x = 0; x <= n; x += 1) corners.push(`v ${x} ${y}`);
      const at = (x, y) => y * (n + 1) + x + 1;
      for (let y = 0; y < n; y += 1) for (let x = 0; x < n; x += 1) faces.push(`f ${at(x, y)} ${at(x + 1, y)} ${at(x + 1, y + 1)} ${at(x, y + 1)}`);
      return [...corners, ...faces].join("\n") + "\n";
    };
    const drop = (name, body) =>
      page.evaluate(`(() => { const data = new DataTransfer(); data.items.add(new File([${JSON.stringify(body)}], "${name}")); document.dispatchEvent(new DragEvent("drop", { dataTransfer: data })); })()`);
    await drop("grid.obj", grid(31));
    await page.until(`document.getElementById("counts").textContent.includes("1984 edges")`, "the grid is drawn");
    // The work of each frame of a drag, with the layout after it; where single vertices are drawn.
    const spent = await page.evaluate(`(async () => {
      const target = document.getElementById("picture"), times = [];
      const dot = document.querySelector('[data-name="v500"] circle')?.getBoundingClientRect();
      if (!dot) return null;
      const later = window.requestAnimationFrame;
      window.requestAnimationFrame = (work) => later((time) => {
        const start = performance.now();
        work(time);
        document.body.getBoundingClientRect();
        times.push(performance.now() - start);
      });
      target.setPointerCapture = () => {};
      const fire = (type, x, y) => target.dispatchEvent(new PointerEvent(type, { clientX: x, clientY: y, button: 0, buttons: 1, pointerId: 1, pointerType: "mouse", bubbles: true }));
      const x = dot.x + dot.width / 2, y = dot.y + dot.height / 2;
      fire("pointerdown", x, y);
      for (let i = 0; i < 40; i += 1) {
        fire("pointermove", x + 6 + (i % 5) / 4, y + 2);
        await new Promise((done) => later(() => later(done)));
      }
      fire("pointerup", x + 1, y + 1);
      window.requestAnimationFrame = later;
      return [times.length, times.sort((a, b) => a - b)[times.length >> 1], times.at(-1)];
    })()`);
    if (spent) {
      assert.ok(spent[0] > 20, "frames were drawn");
      measured.push(`a frame of a drag, 1,984 edges: median ${spent[1].toFixed(1)} ms, slowest ${spent[2].toFixed(1)} ms of ${spent[0]}`);
    }
    await drop("large.obj", grid(98));
    await page.until(`document.getElementById("counts").textContent.includes("19404 edges")`, "the large grid is drawn");
    await run(page, "split_in_half h0");
    await page.until(`document.getElementById("counts").textContent.includes("19405 edges")`, "it is edited");
    await drop("larger.obj", grid(110));
    await says(page, "the playground takes up to 20000");
  },
};

async function begin(page, what, level, seed) {
  await page.evaluate(`document.getElementById("level").value = "${level}"; document.getElementById("seed").value = "${seed}"; document.querySelector('#practise [value="${what}"]').click()`);
  await page.until(`!document.getElementById("quiz").hidden`, "the quiz begins");
}

const measured = [];
const kinds = [
  { name: "1200 px, light, mouse", width: 1200, height: 800 },
  { name: "400 px, dark, touch, reduced motion", width: 400, height: 800, dark: true, touch: true, still: true },
];
const machine = await Browser.start(program);
let [passed, failed] = [0, 0];
const began = Date.now();
await Promise.all(kinds.map(tryAll));

async function tryAll(kind) {
  for (const [name, test] of Object.entries(tests)) {
    if (arguments_.length && !arguments_.some((part) => name.includes(part))) continue;
    const page = await machine.page(kind);
    try {
      await page.open(PAGE);
      await test(page);
      assert.deepEqual(page.problems, [], "messages on the console");
      assert.deepEqual(page.requests.filter((url) => !/^(file|blob|data|about):/.test(url)), [], "requests");
      passed += 1;
      console.log(`ok      ${kind.name}: ${name}`);
    } catch (error) {
      failed += 1;
      console.log(`FAILED  ${kind.name}: ${name}\n        ${String(error.stack ?? error).split("\n").slice(0, 12).join("\n        ")}`);
    }
    if (pictures) await page.picture(join(pictures, `${kind.width}-${name.replace(/[^a-z0-9]+/gi, "-").slice(0, 40)}.png`));
    await page.close();
  }
}

// From nothing to the first picture.
const page = await machine.page(kinds[0]);
await page.open(PAGE);
const start = await page.evaluate(`Math.round(performance.now())`);
measured.push(`start: at most ${start} ms from the request of the page until it was ready and asked`);
measured.forEach((line) => console.log(line));
await machine.stop();
console.log(`${passed} passed, ${failed} failed, in ${Math.round((Date.now() - began) / 1000)} s${axe ? "" : "; axe-core was not given: names were not checked by it"}`);
process.exit(failed ? 1 : 0);
