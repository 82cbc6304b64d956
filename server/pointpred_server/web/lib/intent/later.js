// What a page needs only when its user scrolls, presses Tab, or it has a map of links: loaded when the page is idle.

export { boxOf, imageOf } from "./area.js";
export { reached } from "./keyboard.js";
export { NearView, ScrollAhead } from "./scroll.js";
