// The settings of a circle run, read from the form and checked against the size of the picture.

import { circle, radiusFor } from "../study/task.js";

/**
 * @typedef {{targets: number, distance: number, width: number, blocks: number, participant: string, centre: [number, number], most: number}} Settings
 *   `most`: the longest distance that fits
 * @typedef {HTMLFormElement & {elements: Record<"targets"|"distance"|"width"|"blocks"|"participant"|"shown", HTMLInputElement> &
 *   {predictor: HTMLSelectElement}}} CircleForm
 */

const NAMES = { targets: "Targets", distance: "Distance", width: "Width", blocks: "Blocks" };
const MARGIN_PX = 6;
const FALLBACK = { targets: 13, distance: 200, width: 30, blocks: 1 };

/** The longest distance between targets for which circle and targets lie inside the picture. */
function longestDistance(canvas, targets, width) {
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

/** Sets the distance to the default, or to the longest that fits if that is shorter. @param {CircleForm} form @param {HTMLCanvasElement} canvas */
export function fitDistance(form, canvas) {
  const { targets, width, distance } = form.elements;
  if (problemWith(targets, "targets") || problemWith(width, "width")) return;
  const most = longestDistance(canvas, targets.valueAsNumber, width.valueAsNumber);
  distance.value = String(Math.min(Number(distance.defaultValue), Math.max(50, 10 * Math.floor(most / 10))));
}

/** The distance of neighbours on the circle, if targets taken in turn are a distance of 1 apart. */
const neighbourDistance = (targets) => 2 * Math.sin(Math.PI / (2 * targets));

/** A warning that targets overlap, with settings at which they would not; empty if they do not overlap. */
export function overlapWarning({ targets, distance, width, most }) {
  const apart = distance * neighbourDistance(targets);
  if (width <= apart) return "";
  const enough = Math.ceil(width / neighbourDistance(targets));
  const distanceAdvice = enough <= most ? `, a distance from ${enough} px` : ""; // no longer distance fits
  return `Targets overlap: they are ${width} px wide and ${Math.floor(apart)} px apart. Use a width up to ${Math.floor(apart)} px${distanceAdvice}, or fewer targets.`;
}

/** Marks a field as wrong or right, and links the reason to it. */
function mark(field, wrong) {
  field.setAttribute("aria-invalid", String(wrong));
  if (wrong) field.setAttribute("aria-describedby", "circle-status");
  else field.removeAttribute("aria-describedby");
}

/** A study of one condition: a sequence each block. @param {Settings} settings @returns {import("../study/task.js").Sequence[]} */
export const sequencesOf = ({ targets, distance, width, blocks }) =>
  Array.from({ length: blocks }, (_, i) => ({
    phase: "test",
    block: i + 1,
    task: "circle",
    distance,
    width,
    height: null,
    movements: targets,
    places: circle(distance, [0, 0], targets),
  }));

/** Whether every target of a run lies inside the picture. @param {import("../study/task.js").PointingTask} task @param {HTMLCanvasElement} canvas */
export function fitsPicture({ places, sequence: { width } }, canvas) {
  return places.every(([x, y]) => Math.min(x, y, canvas.clientWidth - x, canvas.clientHeight - y) >= width / 2);
}

/**
 * @param {CircleForm} form @param {HTMLCanvasElement} canvas
 * @returns {{settings: Settings, problem: string | null, field: HTMLInputElement | null}} settings that can be drawn in any case;
 *   `problem` says why they cannot be used, and `field` is the first wrong one
 */
export function readSettings(form, canvas) {
  let /** @type {string|null} */ problem = null,
    /** @type {HTMLInputElement|null} */ first = null;
  const settings = /** @type {Settings} */ ({
    centre: [Math.round(canvas.clientWidth / 2), Math.round(canvas.clientHeight / 2)],
  });
  for (const name of Object.keys(NAMES)) {
    const field = form.elements[name];
    const wrong = problemWith(field, name);
    settings[name] = wrong ? FALLBACK[name] : field.valueAsNumber;
    mark(field, wrong !== null);
    if (wrong) first ??= field;
    problem ??= wrong;
  }
  const { participant } = form.elements;
  settings.participant = participant.value;
  mark(participant, !participant.checkValidity());
  if (!participant.checkValidity()) {
    problem ??= "Participant must be a code of up to 40 letters, digits, - and _.";
    first ??= participant;
  }
  const most = (settings.most = longestDistance(canvas, settings.targets, settings.width));
  if (problem === null && settings.distance > most) {
    problem = `Distance can be at most ${most} px in this window.`;
    first = form.elements.distance;
    mark(first, true);
    settings.distance = Math.max(0, most); // the picture shows what fits
  }
  return { settings, problem, field: first };
}
