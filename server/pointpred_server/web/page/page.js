// The page's four views, of one part or two; each is connected and drawn only while its tab is open.
// All modules are loaded with the page: a browser does not request a module again after it has failed to load once.

import * as assist from "./assist/view.js";
import * as circle from "./circle/view.js";
import * as device from "./device/view.js";
import * as recordings from "./live/recordings.js";
import * as live from "./live/view.js";
import { part } from "./shell/elements.js";
import "./shell/glossary.js";
import "./shell/snippet.js";
import { refuseFiles } from "./replay/drop.js";
import * as replay from "./replay/view.js";
import { hasService, makePlaceSelect } from "./service/service.js";
import { makeTabs } from "./shell/tabs.js";

const PARTS = { live, device, circle, replay, assist };
const VIEWS = {
  live: hasService ? ["live", "device"] : ["live"],
  circle: ["circle"],
  replay: ["replay"],
  assist: ["assist"],
};
const STATUS = {
  live: "live-verdict",
  device: "device-status",
  circle: "circle-status",
  replay: "replay-source",
  assist: "assist-status",
};
const RETRY_MS = 2000;

/** @type {string} */ let current;

const errors = new Map(); // by part: the message shown, and the text that it has replaced
const attempts = new Map(); // by part: the newest attempt to open it

function showError(name, error) {
  const place = part(STATUS[name]);
  const replaced = errors.get(name)?.replaced ?? place.textContent;
  place.textContent = `Not working: ${error.message}.${hasService ? " Is the service still running?" : ""} Trying again.`;
  place.dataset.failed = "true";
  errors.set(name, { replaced, message: place.textContent });
}

/** Puts the replaced text back, unless the part has written another since. */
function clearError(name) {
  const place = part(STATUS[name]),
    shown = errors.get(name);
  if (place.textContent === shown?.message) place.textContent = shown.replaced;
  delete place.dataset.failed;
  errors.delete(name);
}

const isOpen = (name) => VIEWS[current].includes(name);

/** Opens a part of a view, and tries again until it works or another view is chosen. */
async function open(name) {
  const attempt = (attempts.get(name) ?? 0) + 1;
  attempts.set(name, attempt);
  const isNewest = () => attempts.get(name) === attempt;
  try {
    await PARTS[name].open();
    if (isOpen(name)) clearError(name);
    else PARTS[name].close();
  } catch (error) {
    if (!isOpen(name) || !isNewest()) return;
    showError(name, error);
    setTimeout(() => isOpen(name) && isNewest() && open(name), RETRY_MS);
  }
}

const closeView = (view) => VIEWS[view].forEach((name) => PARTS[name].close());

makeTabs(part("tabs"), (view, before) => {
  current = view;
  document.title = `pointpred: ${view}`;
  if (before !== null) closeView(before);
  VIEWS[view].forEach(open);
});

live.useRecordings(recordings);

makePlaceSelect(/** @type {HTMLSelectElement} */ (part("place")), () => {
  // the attached device is shown wherever predictions are made
  PARTS[current].close("place");
  open(current);
});

// A browser may keep a page in its history with open sockets.
window.addEventListener("pagehide", () => closeView(current));
window.addEventListener("pageshow", ({ persisted }) => persisted && VIEWS[current].forEach(open));

refuseFiles();
