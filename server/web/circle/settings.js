// The settings of a circle run: read from the form, held against what the picture has room for.

import { radiusFor } from "./geometry.js";

const NAMES = { targets: "Targets", distance: "Distance", width: "Width", blocks: "Blocks" };
const MARGIN_PX = 6;
const LEAST = { targets: 13, distance: 200, width: 30, blocks: 1 };

/** The longest distance between targets for which circle and targets lie inside the picture. */
function room(canvas, targets, width) {
  const side = Math.min(canvas.clientWidth, canvas.clientHeight);
  return Math.floor(((side - width) / 2 - MARGIN_PX) / radiusFor(1, targets));
}

function problemWith(field, name) {
  const value = field.valueAsNumber;
  const { min, max, step } = field;
  const odd = Number(step) === 2 && value % 2 === 0 ? " and odd" : "";
  if (Number.isInteger(value) && value >= Number(min) && value <= Number(max) && !odd) return null;
  return `${NAMES[name]} must be a whole number from ${min} to ${max}${Number(step) === 2 ? ", and odd" : ""}.`;
}

/** Sets the distance that suits the picture: the usual one, or the longest that fits. */
export function suit(form, canvas) {
  const { targets, width, distance } = form.elements;
  if (problemWith(targets, "targets") || problemWith(width, "width")) return;
  const most = room(canvas, targets.valueAsNumber, width.valueAsNumber);
  distance.value = String(Math.min(Number(distance.defaultValue), Math.max(50, 10 * Math.floor(most / 10))));
}

/** How far the centres of neighbours on the circle are apart, for targets taken in turn a distance of 1 apart. */
const besides = (targets) => 2 * Math.sin(Math.PI / (2 * targets));

/** What to say where targets overlap, with the settings at which they would not; empty where they do not. */
export function overlap({ targets, distance, width, most }) {
  const apart = distance * besides(targets);
  if (width <= apart) return "";
  const enough = Math.ceil(width / besides(targets));
  const farther = enough <= most ? `, a distance from ${enough} px` : ""; // there is no room for more
  return `Targets overlap: they are ${width} px wide and ${Math.floor(apart)} px apart. Use a width up to ${Math.floor(apart)} px${farther}, or fewer targets.`;
}

/** Marks a field that cannot be run with, and ties the reason to it. */
function mark(field, wrong) {
  field.setAttribute("aria-invalid", String(wrong));
  if (wrong) field.setAttribute("aria-describedby", "circle-said");
  else field.removeAttribute("aria-describedby");
}

/** Whether every target of a run lies inside the picture. */
export function fits({ places, settings: { width } }, canvas) {
  return places.every(([x, y]) => Math.min(x, y, canvas.clientWidth - x, canvas.clientHeight - y) >= width / 2);
}

/**
 * @returns {{settings: {targets: number, distance: number, width: number, blocks: number, centre: [number, number], most: number},
 *   problem: string | null, field: HTMLInputElement | null}} settings that can be drawn in any case; `problem` says why they cannot be run, and
 *   `field` is the first that is wrong; `most` is the longest distance that there is room for
 */
export function readSettings(form, canvas) {
  let problem = null, first = null;
  const settings = { centre: [Math.round(canvas.clientWidth / 2), Math.round(canvas.clientHeight / 2)] };
  for (const name of Object.keys(NAMES)) {
    const field = form.elements[name];
    const wrong = problemWith(field, name);
    settings[name] = wrong ? LEAST[name] : field.valueAsNumber;
    mark(field, wrong !== null);
    if (wrong) first ??= field;
    problem ??= wrong;
  }
  const most = settings.most = room(canvas, settings.targets, settings.width);
  if (problem === null && settings.distance > most) {
    problem = `There is room for a distance of at most ${most} px here.`;
    first = form.elements.distance;
    mark(first, true);
    settings.distance = Math.max(0, most); // the picture shows what there is room for
  }
  return { settings, problem, field: first };
}
