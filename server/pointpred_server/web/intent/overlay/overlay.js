// A picture over the page for developers: what is predicted, what fired and why, and the ledger.

import { ledger } from "../ledger.js";
import { trackers } from "../register.js";
import { Panel } from "./panel.js";
import { Picture } from "./picture.js";
import { STYLE } from "./style.js";

let hide = null; // what hides the one that is shown

/**
 * Shows the rectangles of the registered elements with their slop and their shares, the predicted endpoint and its region, what
 * fired and why, and the ledger. It takes no pointer events and does not change the page. Shown twice, it stays one.
 * @returns {() => void} hides it
 */
export function showOverlay() {
  hide ??= begin();
  return hide;
}

function begin() {
  const host = document.createElement("div"), root = host.attachShadow({ mode: "open" }), sheet = new CSSStyleSheet();
  sheet.replaceSync(STYLE);
  root.adoptedStyleSheets = [sheet];
  const picture = new Picture(), panel = new Panel();
  root.append(picture.canvas, ...picture.samples, panel.element);
  host.setAttribute("aria-hidden", "true");
  document.documentElement.append(host);
  const stop = ledger.subscribe((entry) => {
    picture.note(entry);
    panel.note(entry);
  });
  let frame = requestAnimationFrame(function draw() {
    picture.draw([...trackers.values()].map(({ view }) => view));
    panel.update(ledger.summary());
    frame = requestAnimationFrame(draw);
  });
  return () => {
    cancelAnimationFrame(frame);
    stop();
    host.remove();
    hide = null;
  };
}
