// The form that asks which column of a table is which, where the service cannot tell.

import { part, write } from "../page/elements.js";

const FIELDS = ["t", "x", "y", "user", "trial", "buttons"];
const NEEDED = 3; // t, x and y

const form = part("replay-columns");
const select = (field) => part(`replay-column-${field}`);

/** Hides the form. */
export function closeColumns() {
  form.hidden = true;
}

/**
 * Asks for the columns of a table: the best guess is filled in.
 * @param {string} name of the file @param {{reason: string, columns: string[], guess: object, time_unit: string|null}} refusal
 * @param {(told: object) => void} given what was chosen, as the service takes it
 */
export function askColumns(name, { reason, columns, guess, time_unit: unit }, given) {
  write(part("replay-columns-title"), `Which columns of ${name} are which?`);
  write(part("replay-columns-reason"), `The service cannot tell: ${reason}.`);
  for (const [i, field] of FIELDS.entries()) {
    const none = new Option(i < NEEDED ? "choose" : "none", "");
    select(field).replaceChildren(none, ...columns.map((column) => new Option(column, column)));
    select(field).value = guess[field] ?? "";
  }
  select("unit").value = unit ?? "";
  form.onsubmit = (submitted) => {
    submitted.preventDefault();
    given(chosen());
  };
  form.hidden = false;
  (FIELDS.slice(0, NEEDED).map(select).find(({ value }) => value === "") ?? select("unit")).focus();
}

/** What is chosen, as the service takes it. */
function chosen() {
  const pairs = FIELDS.filter((field) => select(field).value !== "").map((field) => `${field}=${select(field).value}`);
  const told = { columns: pairs.join(",") };
  if (select("unit").value !== "") told.time_unit = select("unit").value;
  if (select("up").checked) told.y_up = "true";
  return told;
}

part("replay-columns-cancel").addEventListener("click", closeColumns);
