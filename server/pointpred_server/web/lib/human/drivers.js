// What moves the mouse of a browser: a page of Playwright or Puppeteer, or a session of WebDriver.

const ELEMENT = "element-6066-11e4-a52e-4f735466cecf"; // the key of a reference to an element, in the W3C's protocol
const MEASURE = `const [target] = arguments;
const element = typeof target === "string" ? document.querySelector(target) : target;
if (!element) return null;
const { x, y, width, height } = element.getBoundingClientRect();
return { x, y, width, height };`;

/** A page of Playwright or Puppeteer. */
export class PageMouse {
  #page;

  constructor(page) {
    this.#page = page;
  }

  /** The rectangle of an element in the viewport, px; null where there is none. */
  async measure(target) {
    const element = typeof target === "string" ? await this.#page.$(target) : target;
    return element && (await element.boundingBox());
  }

  viewport() {
    return this.#page.evaluate("({ width: innerWidth, height: innerHeight })");
  }

  /** Moves without waiting for the page, which answers once a frame; waits for it before the button changes. */
  async play(reports) {
    const { mouse } = this.#page;
    const began = performance.now();
    /** @type {Promise<unknown>} */
    let moves = Promise.resolve();
    let held = false;
    for (const { t, x, y, pressed } of reports) {
      await new Promise((done) => setTimeout(done, began + 1000 * t - performance.now()));
      moves = Promise.all([moves, mouse.move(x, y)]);
      moves.catch(() => {}); // is thrown below
      if (pressed !== held) {
        await moves;
        await (pressed ? mouse.down() : mouse.up());
        held = pressed;
      }
    }
    await moves;
  }
}

/** A session of WebDriver by its address. */
export class Session {
  #address;

  constructor(address) {
    this.#address = String(address).replace(/\/$/, "");
  }

  measure(target) {
    return this.#run(MEASURE, typeof target === "string" ? target : { [ELEMENT]: target[ELEMENT] });
  }

  viewport() {
    return this.#run("return { width: innerWidth, height: innerHeight };");
  }

  /** The whole movement is one command. */
  async play(reports) {
    const actions = [];
    let [before, held] = [0, false];
    for (const { t, x, y, pressed } of reports) {
      actions.push({ type: "pointerMove", duration: Math.round(1000 * (t - before)), x, y, origin: "viewport" });
      if (pressed !== held) actions.push({ type: pressed ? "pointerDown" : "pointerUp", button: 0 });
      [before, held] = [t, pressed];
    }
    const mouse = { type: "pointer", id: "mouse", parameters: { pointerType: "mouse" }, actions };
    await this.#send("actions", { actions: [mouse] });
  }

  #run(script, ...args) {
    return this.#send("execute/sync", { script, args });
  }

  async #send(command, body) {
    const answer = await fetch(`${this.#address}/${command}`, { method: "POST", body: JSON.stringify(body) });
    const { value } = await answer.json();
    if (!answer.ok) throw new Error(`the WebDriver refused ${command}: ${value.message}`);
    return value;
  }
}
