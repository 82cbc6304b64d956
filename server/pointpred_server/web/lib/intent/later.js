// What a page needs only once its user scrolls or presses Tab, or if it has a map of links: loaded then.

export { boxOf, imageOf } from "./area.js";
export { reached } from "./keyboard.js";
export { NearView, ScrollAhead } from "./scroll.js";
