// The scores of all predictors on one recording: two plots, a legend that switches their lines, and a sorted table.

import { part, write } from "../page/elements.js";
import { score } from "../service/http.js";
import { BASELINE, Highlights } from "./highlights.js";
import { clearPlot, lineStyle, lineSymbol, plotErrors } from "./plots.js";
import { fillPlaceholders, fillScores, linesOf, ranked, setOf, summary } from "./scores.js";

const PLOTS = ["by-path", "by-time"];

/** The results in a view: elements whose ids begin with the view's name. */
export class Results {
  #view; #highlights = new Highlights(); #set = null; #labels = new Map(); #requests = 0;

  /** @param {string} view */
  constructor(view) {
    this.#view = view;
    this.#part("scores").addEventListener("click", ({ target }) => this.#toggle(target.closest("tr")?.dataset.predictor));
  }

  /**
   * Requests the scores of a recording and shows them, unless newer ones have been requested meanwhile.
   * @param {string|Blob} csv the samples file @param {string[]} names of the predictors that will be scored
   * @param {string} advice to add if it fails @param {object} columns parameters of the request
   * @returns {Promise<"done"|"failed"|"outdated">}
   */
  async score(csv, names, advice = "", columns = {}) {
    const request = ++this.#requests;
    this.#showPlaceholders(names);
    this.#showStatus("The service scores every predictor on these movements…", "scoring");
    try {
      const set = setOf(await score(csv, columns));
      if (request !== this.#requests) return "outdated";
      this.#show(set);
      this.#showStatus(summary(set), "done");
      return "done";
    } catch (error) {
      if (request !== this.#requests) return "outdated";
      fillPlaceholders(this.#part("scores"), names, "–");
      for (const id of PLOTS) clearPlot(this.#part(id));
      this.#showStatus(`Not scored: ${error.message}.${advice}`, "failed");
      return "failed";
    }
  }

  #part(id) {
    return part(`${this.#view}-${id}`);
  }

  /** @param {string} text @param {"scoring"|"done"|"failed"} state */
  #showStatus(text, state) {
    const line = this.#part("score-status");
    write(line, text);
    line.dataset.state = state;
  }

  #showPlaceholders(names) {
    this.#set = null;
    fillPlaceholders(this.#part("scores"), names);
    this.#fillLegend(names);
    this.#applyStyles();
  }

  #show(set) {
    this.#set = set;
    const names = ranked(set.predictors).map(({ name }) => name);
    this.#highlights.setNames(names);
    fillScores(this.#part("scores"), set);
    this.#fillLegend(names);
    this.#applyStyles();
  }

  /** A button for each line that can be switched, best first; hold is always highlighted. */
  #fillLegend(names) {
    this.#labels = new Map();
    this.#part("legend").replaceChildren(...names.map((name) => {
      const item = document.createElement("li");
      const label = document.createElement(name === BASELINE ? "span" : "button");
      if (name !== BASELINE) Object.assign(label, { type: "button", disabled: this.#set === null, onclick: () => this.#toggle(name) });
      label.append(lineSymbol(this.#styleOf(name)), name === BASELINE ? "hold: no prediction" : name);
      this.#labels.set(name, label);
      item.append(label);
      return item;
    }));
  }

  #styleOf(name) {
    return lineStyle(name, this.#set === null ? null : this.#highlights.colourIndex(name));
  }

  #toggle(name) {
    if (this.#set === null || name === undefined || name === BASELINE) return;
    this.#highlights.toggle(name);
    this.#applyStyles();
  }

  /** Applies the styles of all lines to the legend, the table and the plots. */
  #applyStyles() {
    for (const [name, label] of this.#labels) {
      label.firstChild.replaceWith(lineSymbol(this.#styleOf(name)));
      if (name !== BASELINE) label.setAttribute("aria-pressed", String(this.#highlights.colourIndex(name) !== null && this.#set !== null));
    }
    if (this.#set === null) return;
    for (const row of this.#part("scores").tBodies[0].rows) {
      const { predictor: name } = row.dataset;
      row.classList.toggle("front", name === BASELINE || this.#highlights.colourIndex(name) !== null);
      row.cells[0].replaceChildren(lineSymbol(this.#styleOf(name)), name);
    }
    for (const id of PLOTS) {
      const { shares, lines } = linesOf(this.#set, id.replace("-", "_"));
      plotErrors(this.#part(id), shares, lines.map((line) => ({ ...line, style: this.#styleOf(line.name) })));
    }
  }
}
