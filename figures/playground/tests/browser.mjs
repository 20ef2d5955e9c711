// A browser driven by the DevTools protocol through its pipe: no package, no port.
//
//   chromium ── fd 3, fd 4 ──▶ Browser ── page ──▶ Page: evaluate, mouse, touch, keys, pictures
//
// Whatever a page says on its console, every error and every request is kept.

import { spawn, spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const NAMES = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];

/** The path of a browser, or nothing. */
export function browser() {
  if (process.env.CHROMIUM !== undefined) return process.env.CHROMIUM;
  return NAMES.find((name) => spawnSync(name, ["--version"]).status === 0) ?? "";
}

export const sleep = (ms) => new Promise((done) => setTimeout(done, ms));

export class Browser {
  static async start(program) {
    const profile = mkdtempSync(join(tmpdir(), "dcel-browser-"));
    const options = ["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking"];
    const child = spawn(program, [...options, `--user-data-dir=${profile}`, "--remote-debugging-pipe", "about:blank"], {
      stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"],
    });
    return new Browser(child, profile);
  }

  constructor(child, profile) {
    Object.assign(this, { child, profile, number: 0, waits: new Map(), pages: new Map() });
    let buffer = "";
    child.stdio[4].on("data", (data) => {
      buffer += data;
      for (let end = buffer.indexOf("\0"); end >= 0; end = buffer.indexOf("\0")) {
        this.hear(JSON.parse(buffer.slice(0, end)));
        buffer = buffer.slice(end + 1);
      }
    });
  }

  hear(message) {
    if (message.id) {
      this.waits.get(message.id)?.(message);
      this.waits.delete(message.id);
    } else {
      this.pages.get(message.sessionId)?.hear(message);
    }
  }

  send(method, params = {}, sessionId = undefined) {
    return new Promise((done, fail) => {
      this.number += 1;
      this.waits.set(this.number, ({ result, error }) => (error ? fail(new Error(`${method}: ${error.message}`)) : done(result)));
      this.child.stdio[3].write(JSON.stringify({ id: this.number, method, params, sessionId }) + "\0");
    });
  }

  /** A page of its own storage. */
  async page(options) {
    const { browserContextId } = await this.send("Target.createBrowserContext");
    const { targetId } = await this.send("Target.createTarget", { url: "about:blank", browserContextId });
    const { sessionId } = await this.send("Target.attachToTarget", { targetId, flatten: true });
    const page = new Page(this, sessionId, targetId);
    this.pages.set(sessionId, page);
    await page.prepare(options);
    return page;
  }

  async stop() {
    const ended = new Promise((done) => this.child.once("exit", done));
    this.child.kill();
    await ended;
    // Its helpers end a little later, and may still write.
    for (let i = 0; i < 50; i += 1) {
      try {
        return rmSync(this.profile, { recursive: true, force: true });
      } catch {
        await sleep(100);
      }
    }
  }
}

class Page {
  constructor(owner, session, target) {
    Object.assign(this, { owner, session, target, problems: [], requests: [] });
  }

  hear({ method, params }) {
    if (method === "Runtime.exceptionThrown") {
      this.problems.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    } else if (method === "Runtime.consoleAPICalled") {
      this.problems.push(params.args.map((argument) => argument.value ?? argument.description).join(" "));
    } else if (method === "Log.entryAdded") {
      this.problems.push(params.entry.text);
    } else if (method === "Network.requestWillBeSent") {
      this.requests.push(params.request.url);
    }
  }

  send(method, params) {
    return this.owner.send(method, params, this.session);
  }

  async prepare({ width, height, dark = false, touch = false, still = false }) {
    this.touch = touch;
    for (const domain of ["Page", "Runtime", "Log", "Network"]) await this.send(`${domain}.enable`);
    await this.send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile: touch });
    await this.send("Emulation.setTouchEmulationEnabled", { enabled: touch });
    // Another page that opens would take the focus, and with it what is typed here.
    await this.send("Emulation.setFocusEmulationEnabled", { enabled: true });
    const features = [
      { name: "prefers-color-scheme", value: dark ? "dark" : "light" },
      { name: "prefers-reduced-motion", value: still ? "reduce" : "no-preference" },
    ];
    await this.send("Emulation.setEmulatedMedia", { features });
  }

  async open(url) {
    await this.send("Page.navigate", { url: "about:blank" });
    await this.send("Page.navigate", { url });
    await this.until("document.documentElement.dataset.ready === 'yes'", "the page is ready");
  }

  async evaluate(expression) {
    const answer = await this.send("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true });
    if (answer.exceptionDetails) throw new Error(answer.exceptionDetails.exception?.description ?? answer.exceptionDetails.text);
    return answer.result.value;
  }

  /** The same in the first frame of the page. */
  async within(expression) {
    const { frameTree } = await this.send("Page.getFrameTree");
    const frameId = frameTree.childFrames?.[0].frame.id;
    if (!frameId) throw new Error("the page has no frame yet");
    const { executionContextId } = await this.send("Page.createIsolatedWorld", { frameId });
    const answer = await this.send("Runtime.evaluate", { expression, returnByValue: true, contextId: executionContextId });
    if (answer.exceptionDetails) throw new Error(answer.exceptionDetails.exception?.description ?? answer.exceptionDetails.text);
    return answer.result.value;
  }

  /** Waits until an expression holds. */
  async until(expression, what = expression) {
    for (let i = 0; i < 400; i += 1) {
      if (await this.evaluate(expression).catch(() => false)) return;
      await sleep(25);
    }
    throw new Error(`never: ${what}; the page says: ${await this.evaluate("document.getElementById('message')?.textContent")}; ${this.problems.join("; ")}`);
  }

  /** The middle of the first element of a selector, scrolled into sight. */
  middle(selector) {
    return this.evaluate(`(() => {
      const element = document.querySelector(${JSON.stringify(selector)});
      if (!element) throw new Error("nothing is " + ${JSON.stringify(selector)});
      element.scrollIntoView({ block: "nearest" });
      const box = element.getBoundingClientRect();
      return [box.x + box.width / 2, box.y + box.height / 2];
    })()`);
  }

  /** A click, or a tap where there is a finger. */
  async click(selector, [dx, dy] = [0, 0]) {
    const [x, y] = await this.middle(selector);
    await this.press([[x + dx, y + dy]]);
  }

  /** From the first place to the last, with the mouse or a finger down. */
  async press(places) {
    const [first, ...rest] = places;
    const last = places.at(-1);
    if (this.touch) {
      const points = ([x, y]) => ({ touchPoints: [{ x, y }] });
      await this.send("Input.dispatchTouchEvent", { type: "touchStart", ...points(first) });
      for (const place of rest) {
        await this.send("Input.dispatchTouchEvent", { type: "touchMove", ...points(place) });
        await sleep(20);
      }
      await this.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
    } else {
      const at = (type, [x, y], buttons) =>
        this.send("Input.dispatchMouseEvent", { type, x, y, button: "left", buttons, clickCount: 1 });
      await at("mouseMoved", first, 0);
      await at("mousePressed", first, 1);
      for (const place of rest) {
        await at("mouseMoved", place, 1);
        await sleep(20);
      }
      await at("mouseReleased", last, 0);
    }
    await sleep(60);
  }

  /** A key; `modifiers` as the protocol has them: 2 Ctrl, 8 Shift. */
  async key(key, modifiers = 0) {
    const codes = { Tab: 9, Enter: 13, Escape: 27, ArrowLeft: 37, ArrowUp: 38, ArrowRight: 39, ArrowDown: 40 };
    const text = key.length === 1 && modifiers !== 2 ? { text: key } : key === "Enter" ? { text: "\r" } : {};
    const common = { key, modifiers, windowsVirtualKeyCode: codes[key] ?? key.toUpperCase().charCodeAt(0), ...text };
    await this.send("Input.dispatchKeyEvent", { type: "keyDown", ...common });
    await this.send("Input.dispatchKeyEvent", { type: "keyUp", ...common });
    await sleep(40);
  }

  type(text) {
    return this.send("Input.insertText", { text });
  }

  async picture(file) {
    const { data } = await this.send("Page.captureScreenshot");
    writeFileSync(file, Buffer.from(data, "base64"));
  }

  async close() {
    await this.owner.send("Target.closeTarget", { targetId: this.target });
  }
}
