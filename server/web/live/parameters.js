// A predictor's parameters as sliders with a field for the exact number: each change goes to the service at once.

import { write } from "../page/elements.js";

const WAIT_MS = 80; // while a slider moves, not every step of it is sent
const STEPS = 200;
const WIDEST = 20; // bounds that span more, as a multiple of the value they begin with, leave no room on a slider
const SPAN = 30;

/**
 * What a slider covers: `log` where the values span decades; narrower than the bounds where those are too wide.
 * @param {{low: number, high: number, default: number}} parameter
 * @returns {{from: number, to: number, log: boolean}}
 */
export function rangeOf({ low, high, default: usual }) {
  if (usual > 0 && high / Math.max(low, usual / SPAN) > WIDEST) {
    const [from, to] = [Math.max(low, usual / SPAN), Math.min(high, usual * SPAN)];
    return { from, to, log: to / from > WIDEST };
  }
  if (usual < 0 && high - low > WIDEST * -usual) return { from: Math.max(low, 3 * usual), to: Math.min(high, -3 * usual), log: false };
  return { from: low, to: high, log: false };
}

/** Whether only whole numbers make sense: the service takes no others. */
const whole = ({ unit, low, high, default: usual }) => unit === "" && high <= 1000 && [low, high, usual].every(Number.isInteger);

/** The number at a share of the slider, with as many digits as one can set by hand. */
function valueAt({ from, to, log }, share, step) {
  const value = log ? from * (to / from) ** share : from + share * (to - from);
  return step === 1 ? Math.round(value) : Number(value.toPrecision(3));
}

const shareOf = ({ from, to, log }, value) =>
  Math.max(0, Math.min(1, log ? Math.log(Math.max(value, from) / from) / Math.log(to / from) : (value - from) / (to - from)));

/** The sliders of one predictor inside a `details` element. */
export class Parameters {
  /** Those that were changed, by name. @type {Object<string, number>} */ values = {};
  #box; #said; #list; #changed; #waiting = null; #cells = new Map();

  /** @param {HTMLDetailsElement} box @param {() => void} changed is called when `values` has changed, a little later */
  constructor(box, changed) {
    [this.#box, this.#changed] = [box, changed];
    this.#said = box.querySelector("[role=status]");
    this.#list = box.querySelector(".sliders");
    box.querySelector("button").addEventListener("click", () => this.reset());
  }

  /** Shows those of another predictor, each as it is usually. @param {{name: string, parameters: object[]}|null} predictor */
  show(predictor) {
    clearTimeout(this.#waiting);
    [this.values, this.#cells] = [{}, new Map()];
    this.#box.hidden = predictor === null;
    write(this.#box.querySelector("summary"), `Parameters of ${predictor?.name ?? ""}`);
    const settable = (predictor?.parameters ?? []).filter(({ default: usual }) => typeof usual === "number");
    const own = settable.filter(({ name, of }) => of === "predictor" && name !== "dpi");
    const other = settable.filter(({ name, of }) => of !== "predictor" && name !== "dpi");
    this.#list.replaceChildren(...group("Predictor", own, (one) => this.#slider(one)), ...group("Differentiator (speed from positions)", other, (one) => this.#slider(one)));
    this.say("");
  }

  /** Everything as it is usually. */
  reset() {
    this.values = {};
    for (const { parameter, put } of this.#cells.values()) put(parameter.default);
    this.say("");
    this.#changed();
  }

  /** The service did not take the newest change. @param {string} message @param {string} path of the field */
  refused(message, path) {
    delete this.values[path.split(".").at(-1)];
    this.say(`Not set: ${message}.`, path);
  }

  /** Writes a note below the sliders and marks the field that it is about. @param {string} words @param {string} path of the field */
  say(words, path = "") {
    write(this.#said, words);
    for (const [name, { field }] of this.#cells) field.setAttribute("aria-invalid", String(path.endsWith(`.${name}`)));
  }

  #slider(parameter) {
    const { name, unit, meaning, low, high } = parameter, range = rangeOf(parameter), step = whole(parameter) ? 1 : "any";
    const label = document.createElement("label"), slider = document.createElement("input"), field = document.createElement("input");
    Object.assign(slider, { type: "range", min: "0", max: "1", step: step === 1 ? String(1 / (range.to - range.from)) : String(1 / STEPS), title: meaning });
    Object.assign(field, { type: "number", min: String(low), max: String(high), step: String(step), name });
    slider.setAttribute("aria-label", `${name}, slider`);
    field.setAttribute("aria-label", unit ? `${name}, ${unit}` : name);
    const put = (value) => {
      slider.value = String(shareOf(range, value));
      field.value = String(value);
    };
    slider.addEventListener("input", () => {
      field.value = String(valueAt(range, Number(slider.value), step));
      this.#set(name, Number(field.value));
    });
    field.addEventListener("change", () => {
      if (!field.validity.valid || field.value === "") return this.say(`${name} must be a number from ${low} to ${high}.`, `.${name}`);
      slider.value = String(shareOf(range, Number(field.value)));
      this.#set(name, Number(field.value));
    });
    put(parameter.default);
    this.#cells.set(name, { parameter, put, field });
    const words = document.createElement("span"), small = document.createElement("small");
    words.append(unit ? `${name}, ${unit}` : name);
    small.append(meaning);
    label.append(words, slider, field, small);
    return label;
  }

  #set(name, value) {
    this.values = { ...this.values, [name]: value };
    this.say("");
    clearTimeout(this.#waiting);
    this.#waiting = setTimeout(() => this.#changed(), WAIT_MS);
  }
}

function group(title, parameters, slider) {
  if (parameters.length === 0) return [];
  const head = document.createElement("h3");
  head.append(title);
  return [head, ...parameters.map(slider)];
}
