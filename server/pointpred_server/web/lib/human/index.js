// A hand for tests: moves a real browser's mouse as people do, and makes no secret of being a driver.

import { PageMouse, Session } from "./drivers.js";
import { Hand } from "./hand.js";

const LAST_SEED = 2 ** 31 - 3;

/**
 * A simulated hand for the mouse of a browser. Throws a TypeError or a RangeError for what cannot be used.
 * @param {object|string|URL} browser a page of Playwright or Puppeteer, or the address of a WebDriver session
 * @param {{seed?: number, skill?: number, at?: {x: number, y: number}}} [options]
 * @returns {import("./index.d.ts").Human}
 */
export function human(browser, { seed = 1, skill = 0.5, at = { x: 0, y: 0 }, ...unknown } = {}) {
  for (const name in unknown) throw new TypeError(`unknown option ${name}; known: seed, skill, at`);
  if (!(Number.isInteger(seed) && seed >= 0 && seed <= LAST_SEED))
    throw new RangeError(`seed must be a whole number in [0, ${LAST_SEED}], received ${seed}`);
  if (!(skill >= 0 && skill <= 1)) throw new RangeError(`skill must be a number in [0, 1], received ${skill}`);
  if (!(Number.isFinite(at?.x) && Number.isFinite(at.y)))
    throw new TypeError(`at must be a point {x, y}, received ${JSON.stringify(at)}`);
  const driver = driverOf(browser);
  const hand = new Hand(seed, skill, { x: Math.round(at.x), y: Math.round(at.y) });

  async function reach(target, clicks) {
    const box = isPlace(target) ? { width: 0, height: 0, ...target } : await driver.measure(target);
    const name = typeof target === "string" ? target : "the target";
    if (!box) throw new Error(`${name} is not on the page, or not shown`);
    const { width, height } = await driver.viewport();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    if (!(x >= 0 && y >= 0 && x < width && y < height))
      throw new Error(`the middle of ${name} lies outside of the viewport, at ${x}, ${y}: scroll there first`);
    const within = (value, most) => Math.min(Math.max(value, 0), most - 1);
    const reports = hand
      .reach(box, clicks)
      .map((one) => ({ ...one, x: within(one.x, width), y: within(one.y, height) }));
    const last = reports[reports.length - 1];
    hand.at = { x: last.x, y: last.y }; // the mouse stops at the edge of the viewport
    await driver.play(reports);
  }

  return {
    moveTo: (target) => reach(target, false),
    click: (target) => reach(target, true),
    get at() {
      return hand.at;
    },
  };
}

const isPlace = (target) => typeof target?.x === "number" && typeof target.y === "number";

function driverOf(browser) {
  if (browser?.mouse && browser.$) return new PageMouse(browser);
  if (browser instanceof URL || /^https?:/.test(browser)) return new Session(browser);
  throw new TypeError(
    `a page of Playwright or Puppeteer is needed, or the address of a WebDriver session, received ${browser}`,
  );
}
