// The page's four views; each is connected and drawn only while its tab is open.
// All modules are loaded with the page: a browser does not request a module again after it has failed to load once.

import * as assist from "./assist/view.js";
import * as circle from "./circle/view.js";
import * as device from "./device/view.js";
import * as live from "./live/view.js";
import { part } from "./page/elements.js";
import { explainTerms } from "./page/glossary.js";
import { makeTabs } from "./page/tabs.js";
import { refuseFiles } from "./replay/drop.js";
import * as replay from "./replay/view.js";

const liveWithDevice = {
  open: () => Promise.all([live.open(), device.open()]),
  close() {
    live.close();
    device.close();
  },
};
const VIEWS = { live: liveWithDevice, circle, replay, assist };
const STATUS = { live: "live-verdict", circle: "circle-status", replay: "replay-source", assist: "assist-status" };
const RETRY_MS = 2000;

let current = null;

const errors = new Map(); // by view: the message shown, and the text that it has replaced

function showError(view, error) {
  const place = part(STATUS[view]);
  const replaced = errors.get(view)?.replaced ?? place.textContent;
  place.textContent = `Not working: ${error.message}. Is the service still running? Trying again.`;
  place.dataset.failed = "true";
  errors.set(view, { replaced, message: place.textContent });
}

/** Puts the replaced text back, unless the view has written another since. */
function clearError(view) {
  const place = part(STATUS[view]), shown = errors.get(view);
  if (place.textContent === shown?.message) place.textContent = shown.replaced;
  delete place.dataset.failed;
  errors.delete(view);
}

/** Opens a view, and tries again until the service answers or another view is chosen. */
async function open(view) {
  try {
    await VIEWS[view].open();
    if (current === view) clearError(view);
    else VIEWS[view].close();
  } catch (error) {
    if (current !== view) return;
    showError(view, error);
    setTimeout(() => current === view && open(view), RETRY_MS);
  }
}

explainTerms();

makeTabs(part("tabs"), (view, before) => {
  current = view;
  document.title = `pointpred: ${view}`;
  if (before !== null) VIEWS[before].close();
  open(view);
});

// A browser may keep a page in its history with open sockets.
window.addEventListener("pagehide", () => VIEWS[current].close());
window.addEventListener("pageshow", ({ persisted }) => persisted && open(current));

refuseFiles();
