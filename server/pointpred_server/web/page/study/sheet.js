// A sheet of the study: a heading, text, questions and buttons.

import { part, write } from "../shell/elements.js";

/**
 * @typedef {{name: string, text: string, kind: "text"|"number", choices: string[], low: number|null, high: number|null, required: boolean}} Question
 */

const form = /** @type {HTMLFormElement} */ (part("sheet-form"));

function make(name, properties = {}, ...children) {
  const element = Object.assign(document.createElement(name), properties);
  element.append(...children);
  return element;
}

/** The field of a question, with a place for what is wrong with its answer. @param {Question} question */
function field({ name, text, kind, choices, low, high, required }) {
  const words = required ? text : `${text} (may be left out)`;
  const wrong = make("p", { className: "wrong", id: `wrong-${name}` });
  if (choices.length) {
    const options = choices.map((choice) =>
      make("label", {}, make("input", { type: "radio", name, value: choice, required }), choice),
    );
    return make("fieldset", {}, make("legend", { textContent: words }), ...options, wrong);
  }
  const bounds = { ...(low !== null && { min: String(low) }), ...(high !== null && { max: String(high) }) };
  const input =
    kind === "number"
      ? make("input", { type: "number", step: "any", name, required, ...bounds })
      : make("textarea", { name, required, maxLength: 10_000 });
  input.setAttribute("aria-describedby", wrong.id);
  return make("div", {}, make("label", {}, make("span", { textContent: words }), input), wrong);
}

/** Marks the answers that cannot be taken, and goes to the first. @param {Question[]} questions @returns {boolean} whether all can */
function check(questions) {
  const wrong = questions.filter(({ name, kind, low, high }) => {
    const { validity } = /** @type {HTMLInputElement} */ (form.querySelector(`[name="${name}"]`));
    const range = `a number${low === null ? "" : ` from ${low}`}${high === null ? "" : ` to ${high}`}`;
    const words = validity.valueMissing && !validity.badInput ? "Please answer this." : `Please enter ${range}.`;
    part(`wrong-${name}`).textContent = validity.valid ? "" : kind === "number" ? words : "Please answer this.";
    return !validity.valid;
  });
  if (wrong.length) /** @type {HTMLElement} */ (form.querySelector(`[name="${wrong[0].name}"]`)).focus();
  return wrong.length === 0;
}

/** Says something below the sheet. @param {string} words */
export const note = (words) => write(part("sheet-note"), words);

/**
 * Shows a sheet, and waits for one of its buttons; without buttons it stays.
 * @param {string} title @param {string} text
 * @param {{buttons?: [string, string?], questions?: Question[], waitS?: number}} [options] `buttons`: the one that goes on, and perhaps
 *   another; the first waits for `waitS` seconds
 * @returns {Promise<{chosen: "first"|"second", answers: Record<string, string>}>}
 */
export function ask(title, text, { buttons, questions = [], waitS = 0 } = {}) {
  part("task").hidden = true;
  part("sheet").hidden = false;
  part("sheet-title").textContent = document.title = title;
  const paragraphs = text.trim().split(/\n\s*\n/);
  part("sheet-text").replaceChildren(...paragraphs.map((words) => make("p", { textContent: words.trim() })));
  const [first, second] = (buttons ?? []).map((textContent, i) =>
    make("button", { type: i ? "button" : "submit", textContent }),
  );
  form.replaceChildren(...questions.map(field));
  if (first) form.append(make("div", { className: "buttons" }, first, ...(second ? [second] : [])));
  part("sheet-title").focus();
  window.scrollTo(0, 0);
  note("");
  return new Promise((done) => {
    const resolve = (found) => {
      for (const button of form.querySelectorAll("button")) button.disabled = true; // until the next sheet: this answer is being saved
      done(found);
    };
    if (first && waitS > 0) countDown(/** @type {HTMLButtonElement} */ (first), waitS);
    form.onsubmit = (event) => {
      event.preventDefault();
      if (!first || first.disabled || !check(questions)) return;
      const answers = Object.fromEntries([...new FormData(form)].map(([name, value]) => [name, String(value)]));
      resolve({ chosen: "first", answers });
    };
    second?.addEventListener("click", () => resolve({ chosen: "second", answers: {} }));
  });
}

/** @param {HTMLButtonElement} button @param {number} seconds */
function countDown(button, seconds) {
  const words = button.textContent,
    end = performance.now() + 1000 * seconds;
  button.disabled = true;
  (function show() {
    const left = Math.ceil((end - performance.now()) / 1000);
    button.disabled = left > 0;
    button.textContent = left > 0 ? `${words} in ${left} s` : words;
    if (left > 0) setTimeout(show, 200);
  })();
}
