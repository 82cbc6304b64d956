// Elements of the page: found by id, filled with text, options and rows.

/** The element with an id; throws if there is none. @param {string} id */
export function part(id) {
  const element = document.getElementById(id);
  if (element === null) throw new Error(`the page has no part ${id}`);
  return element;
}

/** The cells of a part that say in `data-of` what they hold, by that. @param {Element} container @returns {Object<string, HTMLElement>} */
export const cellsOf = (container) =>
  Object.fromEntries(
    [.../** @type {NodeListOf<HTMLElement>} */ (container.querySelectorAll("[data-of]"))].map((cell) => [
      cell.dataset.of,
      cell,
    ]),
  );

/** Writes text only if it changes, so that nothing is announced or laid out again without need. @param {Element} element @param {string} text */
export function write(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

/** A message of the service as a sentence: it begins with a capital letter and ends with a full stop. */
export const sentence = (words) => `${words.charAt(0).toUpperCase()}${words.slice(1)}.`;

/**
 * Fills a select with predictors; `none` is the label of an option that chooses none of them.
 * @param {HTMLSelectElement} select @param {{name: string, title: string}[]} predictors @param {string} selected @param {string|null} [none]
 */
export function fillSelect(select, predictors, selected, none = null) {
  const options = predictors.map(({ name, title }) => {
    const option = new Option(name, name, false, name === selected);
    option.title = title ?? "";
    return option;
  });
  if (none !== null) options.unshift(new Option(none, "", false, selected === ""));
  select.replaceChildren(...options);
  select.disabled = false;
}

/** Fills a table with rows of cells; the first row is the heading. @param {HTMLTableElement} table @param {string[][]} texts */
export function fillTable(table, [heads, ...rows]) {
  const cells = (kind, texts) =>
    texts.map((text) => {
      const cell = document.createElement(kind);
      cell.textContent = text;
      if (kind === "th") cell.scope = "col";
      return cell;
    });
  const head = table.createTHead();
  head.replaceChildren(document.createElement("tr"));
  head.rows[0].append(...cells("th", heads));
  const body = table.tBodies[0] ?? table.createTBody();
  body.replaceChildren(
    ...rows.map((texts) => {
      const row = document.createElement("tr");
      row.append(...cells("td", texts));
      return row;
    }),
  );
}
