// The page's three views; each is loaded, connected and drawn only while its tab is open.

import { part } from "./elements.js";
import { refuseFiles } from "./replay-drop.js";
import { tabs } from "./tabs.js";

const VIEWS = {
  live: () => import("./live.js"),
  circle: () => import("./circle.js"),
  replay: () => import("./replay.js"),
};
const SAID_IN = { live: "live-verdict", circle: "circle-said", replay: "replay-source" };
const RETRY_MS = 2000;

let shown = null;

function complain(view, error) {
  part(SAID_IN[view]).textContent = `Not working: ${error.message}. Is the service still running? Trying again.`;
}

/** Opens a view, again and again until the service answers or another one is chosen. */
async function open(view) {
  try {
    const module = await VIEWS[view]();
    if (shown === view) await module.open();
    if (shown !== view) module.close();
  } catch (error) {
    if (shown !== view) return;
    complain(view, error);
    setTimeout(() => shown === view && open(view), RETRY_MS);
  }
}

tabs(part("tabs"), (view, before) => {
  shown = view;
  document.title = `pointpred: ${view}`;
  if (before !== null) VIEWS[before]().then((module) => shown !== before && module.close(), () => {});
  open(view);
});

refuseFiles();
