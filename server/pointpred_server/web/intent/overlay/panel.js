// The ledger in a corner: the counts, and the newest entries.

const MOST_ENTRIES = 6;

/** A table of counts above a list. */
export class Panel {
  element = document.createElement("section");
  #numbers = new Map(); #list = document.createElement("ol");

  constructor() {
    const title = document.createElement("h1"), counts = document.createElement("dl");
    title.textContent = "pointpred";
    for (const name of ["fired", "hit", "wasted", "withheld", "lead"]) {
      const [label, number] = [document.createElement("dt"), document.createElement("dd")];
      label.textContent = name;
      this.#numbers.set(name, number);
      counts.append(label, number);
    }
    this.element.append(title, counts, this.#list);
  }

  /** @param {import("../../index.d.ts").LedgerSummary} summary */
  update({ lead_s: { median }, ...counts }) {
    for (const [name, number] of this.#numbers) {
      const text = name === "lead" ? (median === null ? "–" : `${median.toFixed(2)} s`) : String(counts[name]);
      if (number.textContent !== text) number.textContent = text;
    }
  }

  /** Adds an entry above the others. @param {import("../../index.d.ts").LedgerEntry} entry */
  note({ kind, name, element, reason, p, lead_s }) {
    const item = document.createElement("li"), shown = [kind === "fired" ? reason : kind, name || element.localName,
      lead_s === null ? `${Math.round(100 * p)} %` : `${lead_s.toFixed(2)} s`];
    item.dataset.kind = kind;
    item.append(...shown.map((text) => Object.assign(document.createElement("span"), { textContent: text })));
    this.#list.prepend(item);
    while (this.#list.children.length > MOST_ENTRIES) this.#list.lastChild.remove();
  }
}
