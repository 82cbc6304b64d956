// The parameters of a predictor as sliders, each with a field for the exact number; changes are sent at once.

import { sentence, write } from "../shell/elements.js";

const WAIT_MS = 80; // while a slider moves, only its newest value is sent
const STEPS = 200;
const WIDE = 20; // bounds beyond this ratio to the default are too wide for a linear slider
const SPAN = 30;

/** @typedef {import("../service/listing.js").Described} Parameter */

/**
 * The range of a slider: `log` if it spans decades; narrower than the bounds if those are too wide.
 * @param {{low: number, high: number, default: number}} parameter
 * @returns {{from: number, to: number, log: boolean}}
 */
export function rangeOf({ low, high, default: initial }) {
  if (initial > 0 && high / Math.max(low, initial / SPAN) > WIDE) {
    const [from, to] = [Math.max(low, initial / SPAN), Math.min(high, initial * SPAN)];
    return { from, to, log: to / from > WIDE };
  }
  if (initial < 0 && high - low > WIDE * -initial)
    return { from: Math.max(low, 3 * initial), to: Math.min(high, -3 * initial), log: false };
  return { from: low, to: high, log: false };
}

/** Whether the service takes only whole numbers. */
const isInteger = ({ unit, low, high, default: initial }) =>
  unit === "" && high <= 1000 && [low, high, initial].every(Number.isInteger);

/** The value at a position of the slider, 0 to 1, with three significant digits. */
function valueAt({ from, to, log }, position, step) {
  const value = log ? from * (to / from) ** position : from + position * (to - from);
  return step === 1 ? Math.round(value) : Number(value.toPrecision(3));
}

const positionOf = ({ from, to, log }, value) =>
  Math.max(
    0,
    Math.min(1, log ? Math.log(Math.max(value, from) / from) / Math.log(to / from) : (value - from) / (to - from)),
  );

/** The sliders of one predictor inside a `details` element. */
export class Parameters {
  /** The changed ones, by name. @type {Object<string, number>} */ values = {};
  #box;
  #message;
  #list;
  #onChange;
  /** @type {number|undefined} */ #timer;
  #controls = new Map();

  /** @param {HTMLDetailsElement} box @param {() => void} onChange is called shortly after `values` has changed */
  constructor(box, onChange) {
    [this.#box, this.#onChange] = [box, onChange];
    this.#message = box.querySelector("[role=status]");
    this.#list = box.querySelector(".sliders");
    box.querySelector("button")?.addEventListener("click", () => this.reset());
  }

  /** Shows the parameters of another predictor with their defaults. @param {{name: string, parameters?: Parameter[]}|null} predictor */
  show(predictor) {
    clearTimeout(this.#timer);
    [this.values, this.#controls] = [{}, new Map()];
    this.#box.hidden = predictor === null;
    write(this.#box.querySelector("summary"), `Parameters of ${predictor?.name ?? ""}`);
    const settable = (predictor?.parameters ?? []).filter(({ default: initial }) => typeof initial === "number");
    const predictorOwn = settable.filter(({ name, of }) => of === "predictor" && name !== "dpi");
    const differentiator = settable.filter(({ name, of }) => of !== "predictor" && name !== "dpi");
    this.#list.replaceChildren(
      ...group("Predictor", predictorOwn, (one) => this.#slider(one)),
      ...group("Differentiator (speed from positions)", differentiator, (one) => this.#slider(one)),
    );
    this.#write("");
  }

  /** Sets every parameter to its default. */
  reset() {
    this.values = {};
    for (const { parameter, setValue } of this.#controls.values()) setValue(parameter.default);
    this.#write("");
    this.#onChange();
  }

  /** The service has refused the newest change. @param {string} message @param {string} path of the field */
  reject(message, path) {
    delete this.values[path.slice(path.lastIndexOf(".") + 1)];
    this.#write(`Not set. ${sentence(message)}`, path);
  }

  /** Writes a message below the sliders and marks the field that it is about. @param {string} message @param {string} path of the field */
  #write(message, path = "") {
    write(this.#message, message);
    for (const [name, { field }] of this.#controls)
      field.setAttribute("aria-invalid", String(path.endsWith(`.${name}`)));
  }

  #slider(parameter) {
    const { name, unit, meaning, low, high } = parameter,
      range = rangeOf(parameter),
      step = isInteger(parameter) ? 1 : "any";
    const label = document.createElement("label"),
      slider = document.createElement("input"),
      field = document.createElement("input");
    Object.assign(slider, {
      type: "range",
      min: "0",
      max: "1",
      step: step === 1 ? String(1 / (range.to - range.from)) : String(1 / STEPS),
      title: meaning,
    });
    Object.assign(field, { type: "number", min: String(low), max: String(high), step: String(step), name });
    slider.setAttribute("aria-label", `${name}, slider`);
    field.setAttribute("aria-label", unit ? `${name}, ${unit}` : name);
    const setValue = (value) => {
      slider.value = String(positionOf(range, value));
      field.value = String(value);
    };
    slider.addEventListener("input", () => {
      field.value = String(valueAt(range, Number(slider.value), step));
      this.#set(name, Number(field.value));
    });
    field.addEventListener("change", () => {
      if (!field.validity.valid || field.value === "")
        return this.#write(`${name} must be a number from ${low} to ${high}.`, `.${name}`);
      slider.value = String(positionOf(range, Number(field.value)));
      this.#set(name, Number(field.value));
    });
    setValue(parameter.default);
    this.#controls.set(name, { parameter, setValue, field });
    const title = document.createElement("span"),
      small = document.createElement("small");
    title.append(unit ? `${name}, ${unit}` : name);
    small.append(meaning);
    label.append(title, slider, field, small);
    return label;
  }

  #set(name, value) {
    this.values = { ...this.values, [name]: value };
    this.#write("");
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#onChange(), WAIT_MS);
  }
}

function group(title, parameters, slider) {
  if (parameters.length === 0) return [];
  const head = document.createElement("h3");
  head.append(title);
  return [head, ...parameters.map(slider)];
}
