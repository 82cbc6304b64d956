// A picture over the page for developers: what is predicted, what fired and why, and the ledger.

import { needDocument } from "../../client/document.js";
import { regionOf } from "../../client/regions.js";
import { regionIn } from "../../prediction/row.js";
import { trackers } from "../register.js";
import { ledger, onLedger } from "../reports.js";

const MOST_ENTRIES = 6; // of the list in the corner
const LEVELS = [0.5, 0.9]; // of the regions
const SHOWN = 0.01; // shares from here on are written
const ROLES = ["idle", "fired", "lit", "ahead", "paper"]; // of colours
const NOTED_MS = 1500; // how long a reason stays beside its element

/** @type {(() => void)|null} */
let hide = null; // what hides the one that is shown

/**
 * Shows the rectangles of the registered elements with their slop and their shares, the predicted endpoint and its region, what
 * fired and why, and the ledger. It takes no pointer events and does not change the page. Shown twice, it stays one.
 * @returns {() => void} hides it
 */
export function showOverlay() {
  needDocument("showOverlay");
  hide ??= begin();
  return hide;
}

function begin() {
  const host = document.createElement("div"),
    root = host.attachShadow({ mode: "open" }),
    sheet = new CSSStyleSheet();
  sheet.replaceSync(STYLE);
  root.adoptedStyleSheets = [sheet];
  const picture = new Picture(),
    panel = new Panel();
  root.append(picture.canvas, ...picture.samples, panel.element);
  host.setAttribute("aria-hidden", "true");
  document.documentElement.append(host);
  const stop = onLedger((entry) => {
    picture.note(entry);
    panel.note(entry);
  });
  let frame = requestAnimationFrame(function draw() {
    picture.draw([...trackers.values()].map(({ shares }) => shares));
    panel.update(ledger());
    frame = requestAnimationFrame(draw);
  });
  return () => {
    cancelAnimationFrame(frame);
    stop();
    host.remove();
    hide = null;
  };
}

/** A canvas over the viewport. */
class Picture {
  canvas = document.createElement("canvas");
  /** Carry the colours. */ samples = ROLES.map((className) =>
    Object.assign(document.createElement("i"), { className }),
  );
  #context = /** @type {CanvasRenderingContext2D} */ (this.canvas.getContext("2d"));
  #notes = new Map();

  /** Writes a reason beside an element for a while. @param {import("../../index.d.ts").LedgerEntry} entry */
  note({ kind, element, reason, score, threshold }) {
    if (kind !== "fired" && kind !== "withheld") return;
    const compared = score === null ? "" : ` ${score.toFixed(2)} ≥ ${threshold}`;
    this.#notes.set(element, {
      text: kind === "fired" ? reason + compared : kind,
      until: performance.now() + NOTED_MS,
    });
  }

  /** @param {import("../shares.js").Shares[]} followed what each knows of its elements */
  draw(followed) {
    const { canvas } = this,
      context = this.#context,
      ratio = devicePixelRatio;
    const [width, height] = [Math.round(innerWidth * ratio), Math.round(innerHeight * ratio)];
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, innerWidth, innerHeight);
    context.font = "600 11px system-ui, sans-serif";
    const colours = Object.fromEntries(this.samples.map((one) => [one.className, getComputedStyle(one).color]));
    for (const shares of followed) {
      shares.entries.forEach((one, i) => one.isHidden || this.#drawElement(one, shares.share(i), colours));
      this.#drawPrediction(shares.cursor, shares.answer, colours.ahead);
    }
    for (const [element, { until }] of this.#notes) if (until < performance.now()) this.#notes.delete(element);
  }

  /** @param {import("../entry.js").Entry} entry @param {number} share @param {Object<string, string>} colours */
  #drawElement({ element, row: [x, y, width, height], registrations }, share, colours) {
    const context = this.#context,
      firings = [...registrations].map(({ firing }) => firing);
    const state = firings.some((one) => one?.policy === "highlight") ? "lit" : firings.some(Boolean) ? "fired" : "idle";
    const [left, top] = [x - 0.5 * width, y - 0.5 * height];
    context.fillStyle = context.strokeStyle = colours[state];
    context.globalAlpha = 0.3 * share;
    context.fillRect(left, top, width, height);
    context.globalAlpha = 1;
    context.lineWidth = state === "idle" ? 1 : 2;
    context.setLineDash(state === "idle" ? [4, 3] : []);
    context.strokeRect(left, top, width, height);
    context.setLineDash([]);
    const note = this.#notes.get(element)?.text,
      written = share >= SHOWN ? `${Math.round(100 * share)} %` : "";
    if (note || written)
      this.#label([note, written].filter(Boolean).join("  "), left, top, colours[state], colours.paper);
  }

  #label(text, left, top, colour, paper) {
    const context = this.#context,
      wide = context.measureText(text).width + 8,
      above = Math.max(0, top - 16);
    context.fillStyle = paper;
    context.fillRect(left, above, wide, 16);
    context.fillStyle = colour;
    context.fillText(text, left + 4, above + 12);
  }

  #drawPrediction(cursor, answer, colour) {
    const [, x, y] = answer;
    if (!(x === x && cursor.t > 0)) return;
    const context = this.#context,
      region = regionIn(answer);
    context.strokeStyle = context.fillStyle = colour;
    context.lineWidth = 1.5;
    context.beginPath();
    context.moveTo(cursor.x, cursor.y);
    context.lineTo(x, y);
    context.stroke();
    for (const level of LEVELS) {
      const ellipse = regionOf({ x, y, region }, level);
      if (!ellipse) continue;
      context.beginPath();
      context.ellipse(x, y, ellipse.major, ellipse.minor, ellipse.angle, 0, 2 * Math.PI);
      context.globalAlpha = 0.08;
      context.fill();
      context.globalAlpha = 0.6;
      context.stroke();
      context.globalAlpha = 1;
    }
    context.beginPath();
    context.arc(x, y, 4, 0, 2 * Math.PI);
    context.fill();
  }
}

/** A table of counts above a list. */
class Panel {
  element = document.createElement("section");
  #numbers = new Map();
  #list = document.createElement("ol");

  constructor() {
    const title = document.createElement("h1"),
      counts = document.createElement("dl");
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
  note({ kind, name, element, reason, p, score, lead_s }) {
    const item = document.createElement("li"),
      shown = [
        kind === "fired" ? reason : kind,
        name || (element?.localName ?? ""),
        lead_s === null ? `${Math.round(100 * (score ?? p))} %` : `${lead_s.toFixed(2)} s`,
      ];
    item.dataset.kind = kind;
    item.append(...shown.map((text) => Object.assign(document.createElement("span"), { textContent: text })));
    this.#list.prepend(item);
    while (this.#list.children.length > MOST_ENTRIES) this.#list.lastChild?.remove();
  }
}

// How the overlay looks, in light and dark; the picture reads its colours from elements of these classes.
const STYLE = `
:host { all: initial; color-scheme: light dark; position: fixed; inset: 0; z-index: 2147483647; pointer-events: none;
  font: 12px/1.45 system-ui, sans-serif;
  --paper: light-dark(#fffffff0, #16181df0); --ink: light-dark(#1b1f27, #e8eaef); --faint: light-dark(#626b7a, #98a1b2);
  --edge: light-dark(#d5dae2, #343944); --idle: light-dark(#2563c9, #7fb0ff); --fired: light-dark(#14803c, #5fd48a);
  --lit: light-dark(#b45309, #fbbf5d); --ahead: light-dark(#a21caf, #f0a3fb) }
canvas { position: absolute; inset: 0; width: 100%; height: 100% }
i { display: none }
.idle { color: var(--idle) } .fired { color: var(--fired) } .lit { color: var(--lit) } .ahead { color: var(--ahead) } .paper { color: var(--paper) }
section { position: absolute; right: 12px; bottom: 12px; width: 296px; box-sizing: border-box; padding: 10px 12px; border-radius: 8px;
  background: var(--paper); color: var(--ink); border: 1px solid var(--edge); box-shadow: 0 4px 18px #0003 }
h1 { margin: 0 0 6px; font: 600 12px/1.45 system-ui, sans-serif }
dl { display: grid; grid-template-columns: repeat(5, auto); margin: 0 0 8px; gap: 0 4px }
dt { grid-row: 2; color: var(--faint); font-size: 11px }
dd { grid-row: 1; margin: 0; font-size: 15px; white-space: nowrap; font-variant-numeric: tabular-nums }
ol { margin: 0; padding: 6px 0 0; list-style: none; border-top: 1px solid var(--edge); min-height: 108px }
li { display: grid; grid-template-columns: 64px 1fr auto; gap: 6px; font-variant-numeric: tabular-nums }
li span { overflow: hidden; text-overflow: ellipsis; white-space: nowrap }
li :first-child, li :last-child { color: var(--faint) }
[data-kind=fired] :nth-child(2) { color: var(--fired) }
[data-kind=hit] :nth-child(2) { color: var(--fired); font-weight: 600 }
[data-kind=withheld] :nth-child(2), [data-kind=withdrawn] :nth-child(2) { color: var(--faint) }
`;
