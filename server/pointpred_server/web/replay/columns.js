// The form that asks which column of a table is which, if the service cannot tell.

import { part, sentence, write } from "../page/elements.js";

const FIELDS = ["t", "x", "y", "user", "trial", "buttons"];
const REQUIRED = FIELDS.slice(0, 3);

const form = part("replay-columns");
const selectOf = (field) => part(`replay-column-${field}`);

/** Hides the form. */
export function closeColumns() {
  form.hidden = true;
}

/**
 * Asks for the columns of a table, with the service's guess filled in.
 * @param {string} name of the file @param {{reason: string, columns: string[], guess: object, time_unit: string|null}} refusal
 * @param {(columns: object) => void} onChosen is called with the parameters of the request
 */
export function askColumns(name, { reason, columns, guess, time_unit: unit }, onChosen) {
  write(part("replay-columns-title"), `Which columns of ${name} are which?`);
  write(part("replay-columns-reason"), `The service could not recognise them: ${sentence(reason)}`);
  for (const field of FIELDS) {
    const none = new Option(REQUIRED.includes(field) ? "choose" : "none", "");
    selectOf(field).replaceChildren(none, ...columns.map((column) => new Option(column, column)));
    selectOf(field).value = guess[field] ?? "";
  }
  selectOf("unit").value = unit ?? "";
  form.onsubmit = (event) => {
    event.preventDefault();
    onChosen(readForm());
  };
  form.hidden = false;
  (REQUIRED.map(selectOf).find(({ value }) => value === "") ?? selectOf("unit")).focus();
}

/** The parameters of the request. */
function readForm() {
  const pairs = FIELDS.filter((field) => selectOf(field).value !== "").map((field) => `${field}=${selectOf(field).value}`);
  const columns = { columns: pairs.join(",") };
  if (selectOf("unit").value !== "") columns.time_unit = selectOf("unit").value;
  if (selectOf("up").checked) columns.y_up = "true";
  return columns;
}

part("replay-columns-cancel").addEventListener("click", closeColumns);
