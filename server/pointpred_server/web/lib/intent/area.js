// Links in the map of an image, which have no box of their own.

/** The image that an area belongs to; null where there is none. @param {HTMLAreaElement} area @returns {HTMLImageElement|null} */
export function imageOf(area) {
  const name = area.closest("map")?.name;
  return name ? document.querySelector(`img[usemap="#${CSS.escape(name)}"]`) : null;
}

/** The rectangle around an area, px of the viewport. @param {HTMLAreaElement} area @param {HTMLImageElement} image */
export function boxOf({ shape, coords }, image) {
  const { left, top, width, height } = image.getBoundingClientRect();
  const numbers = coords.split(/[\s,;]+/).map(Number);
  const [x, y, radius] = numbers;
  if (shape === "default") return new DOMRect(left, top, width, height);
  if (shape === "circle") return new DOMRect(left + x - radius, top + y - radius, 2 * radius, 2 * radius);
  const across = numbers.filter((_, i) => i % 2 === 0),
    down = numbers.filter((_, i) => i % 2 === 1);
  const [west, north] = [Math.min(...across), Math.min(...down)];
  return new DOMRect(left + west, top + north, Math.max(...across) - west, Math.max(...down) - north);
}
