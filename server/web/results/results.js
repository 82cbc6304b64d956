// Scores of all predictors on one recording: two plots, a legend that switches their lines, and a sorted table.

import { part, write } from "../page/elements.js";
import { FLOOR, Highlights } from "./highlights.js";
import { clearPlot, lookOf, plotErrors, swatch } from "./plots.js";
import { expectScores, linesOf, ranked, scoreTable, sentence, setOf } from "./scores.js";
import { score } from "../service/http.js";

const PLOTS = ["by-path", "by-time"];

/** The parts of the page whose ids begin with a view's name: its plots, legend, table and the line above them. */
export class Results {
  #view; #highlights = new Highlights(); #set = null; #marks = new Map(); #asked = 0;

  /** @param {string} view */
  constructor(view) {
    this.#view = view;
    this.#part("scores").addEventListener("click", ({ target }) => this.#switch(target.closest("tr")?.dataset.predictor));
  }

  /**
   * Lets the service score a recording, and shows the scores unless others have been asked for meanwhile.
   * @param {string|Blob} csv the samples file @param {string[]} names of the predictors that will be scored
   * @param {string} otherwise what to add where it fails @param {object} told what is said of the file's columns
   * @returns {Promise<"done"|"failed"|"late">}
   */
  async score(csv, names, otherwise = "", told = {}) {
    const mine = ++this.#asked;
    this.#expect(names);
    write(this.#part("scored"), "The service scores every predictor on these movements…");
    try {
      const set = setOf(await score(csv, told));
      if (mine !== this.#asked) return "late";
      this.#show(set);
      write(this.#part("scored"), sentence(set));
      return "done";
    } catch (error) {
      if (mine !== this.#asked) return "late";
      expectScores(this.#part("scores"), names, "–");
      for (const id of PLOTS) clearPlot(this.#part(id));
      write(this.#part("scored"), `Not scored: ${error.message}.${otherwise}`);
      return "failed";
    }
  }

  #part(id) {
    return part(`${this.#view}-${id}`);
  }

  #expect(names) {
    this.#set = null;
    expectScores(this.#part("scores"), names);
    this.#legend(names);
    this.#paint();
  }

  #show(set) {
    this.#set = set;
    const names = ranked(set.predictors).map(({ name }) => name);
    this.#highlights.offer(names);
    scoreTable(this.#part("scores"), set);
    this.#legend(names);
    this.#paint();
  }

  /** A button for each line that can be switched, the best first; no prediction is always in front. */
  #legend(names) {
    this.#marks = new Map();
    this.#part("legend").replaceChildren(...names.map((name) => {
      const item = document.createElement("li");
      const mark = document.createElement(name === FLOOR ? "span" : "button");
      if (name !== FLOOR) Object.assign(mark, { type: "button", disabled: this.#set === null, onclick: () => this.#switch(name) });
      mark.append(swatch(this.#look(name)), name === FLOOR ? "hold: no prediction" : name);
      this.#marks.set(name, mark);
      item.append(mark);
      return item;
    }));
  }

  #look(name) {
    return lookOf(name, this.#set === null ? null : this.#highlights.place(name));
  }

  #switch(name) {
    if (this.#set === null || name === undefined || name === FLOOR) return;
    this.#highlights.toggle(name);
    this.#paint();
  }

  /** The looks of all lines, in the legend, in the table and in the plots. */
  #paint() {
    for (const [name, mark] of this.#marks) {
      mark.firstChild.replaceWith(swatch(this.#look(name)));
      if (name !== FLOOR) mark.setAttribute("aria-pressed", String(this.#highlights.place(name) !== null && this.#set !== null));
    }
    if (this.#set === null) return;
    for (const row of this.#part("scores").tBodies[0].rows) {
      const { predictor: name } = row.dataset;
      row.classList.toggle("front", name === FLOOR || this.#highlights.place(name) !== null);
      row.cells[0].replaceChildren(swatch(this.#look(name)), name);
    }
    for (const id of PLOTS) {
      const { shares, lines } = linesOf(this.#set, id.replace("-", "_"));
      plotErrors(this.#part(id), shares, lines.map((line) => ({ ...line, look: this.#look(line.name) })));
    }
  }
}
