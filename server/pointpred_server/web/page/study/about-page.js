// What is noted of a participant's browser, screen and device.

import { median } from "../shell/numbers.js";

const FRAMES = 30;

/** The median time between frames, ms. */
async function frameMs() {
  const times = [];
  for (let i = 0; i < FRAMES && document.visibilityState === "visible"; i++)
    times.push(await new Promise((resolve) => requestAnimationFrame(resolve)));
  return times.length > 2 ? median(times.slice(1).map((time, i) => time - times[i])) : 0;
}

/** The least step of the page's clock, ms. */
function clockStepMs() {
  let least = Infinity;
  for (let i = 0, before = performance.now(); i < 1000; i++) {
    const now = performance.now();
    if (now > before) least = Math.min(least, now - before);
    before = now;
  }
  return Number.isFinite(least) ? least : 1;
}

/** As the service stores it. */
export async function aboutPage() {
  return {
    browser: navigator.userAgent.slice(0, 512),
    language: navigator.language,
    pointer: window.matchMedia("(pointer: coarse)").matches ? "coarse" : "fine",
    screen: [window.screen.width, window.screen.height],
    window: [window.innerWidth, window.innerHeight],
    pixel_ratio: window.devicePixelRatio,
    frame_ms: await frameMs(),
    clock_step_ms: clockStepMs(),
  };
}
