// Parts of the page, and how numbers are written in them.

/** The element with an id; a mistyped one is an error at once. */
export function part(id) {
  const found = document.getElementById(id);
  if (found === null) throw new Error(`the page has no part ${id}`);
  return found;
}

/** Writes text only where it changes, so that nothing is announced or laid out in vain. */
export function write(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

const DASH = "–";

/** A number with so many decimals and its unit; a dash where there is none. */
export function number(value, decimals = 0, unit = "") {
  if (value === null || value === undefined || !Number.isFinite(value)) return DASH;
  return value.toFixed(decimals) + (unit && ` ${unit}`);
}

/** A number of things, by the name of one of them. */
export const count = (value, noun) => `${value} ${noun}${value === 1 ? "" : "s"}`;

/** A share in per cent. */
export const percent = (share, decimals = 0) => number(share === null ? null : 100 * share, decimals, "%");

/** Fills a select with predictors; `none` is the word for choosing none of them. */
export function offer(select, predictors, chosen, none = null) {
  const options = predictors.map(({ name, title }) => {
    const option = new Option(name, name, false, name === chosen);
    option.title = title ?? "";
    option.dataset.predictor = name;
    return option;
  });
  if (none !== null) options.unshift(new Option(none, "", false, chosen === ""));
  select.replaceChildren(...options);
  select.disabled = false;
}

/** A table's rows: each a list of cells, the first row the heads. */
export function fill(table, [heads, ...rows]) {
  const cells = (kind, words) =>
    words.map((word) => {
      const cell = document.createElement(kind);
      cell.textContent = word;
      if (kind === "th") cell.scope = "col";
      return cell;
    });
  const head = table.createTHead();
  head.replaceChildren(document.createElement("tr"));
  head.rows[0].append(...cells("th", heads));
  const body = table.tBodies[0] ?? table.createTBody();
  body.replaceChildren(
    ...rows.map((words) => {
      const row = document.createElement("tr");
      row.append(...cells("td", words));
      return row;
    }),
  );
}
