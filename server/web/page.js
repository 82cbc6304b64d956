// The page's four views; each is connected and drawn only while its tab is open.
// All are loaded with the page: a browser never asks again for a module whose loading has failed once.

import * as assist from "./assist/view.js";
import * as circle from "./circle/view.js";
import { part } from "./page/elements.js";
import { explainWords } from "./page/glossary.js";
import * as live from "./live/view.js";
import * as replay from "./replay/view.js";
import { refuseFiles } from "./replay/drop.js";
import { tabs } from "./page/tabs.js";

const VIEWS = { live, circle, replay, assist };
const SAID_IN = { live: "live-verdict", circle: "circle-said", replay: "replay-source", assist: "assist-said" };
const RETRY_MS = 2000;
const NOT_WORKING = "Not working:";

let shown = null;

const replaced = new Map(); // what stood where a view complains now

function complain(view, error) {
  const place = part(SAID_IN[view]);
  if (!replaced.has(view)) replaced.set(view, place.textContent);
  place.textContent = `${NOT_WORKING} ${error.message}. Is the service still running? Trying again.`;
}

/** A view works again: its complaint gives way to what stood there. */
function works(view) {
  const place = part(SAID_IN[view]);
  if (replaced.has(view) && place.textContent.startsWith(NOT_WORKING)) place.textContent = replaced.get(view);
  replaced.delete(view);
}

/** Opens a view, again and again until the service answers or another one is chosen. */
async function open(view) {
  try {
    await VIEWS[view].open();
    if (shown === view) works(view);
    else VIEWS[view].close();
  } catch (error) {
    if (shown !== view) return;
    complain(view, error);
    setTimeout(() => shown === view && open(view), RETRY_MS);
  }
}

explainWords();

tabs(part("tabs"), (view, before) => {
  shown = view;
  document.title = `pointpred: ${view}`;
  if (before !== null) VIEWS[before].close();
  open(view);
});

// A browser may keep a page that was left, with its sockets: nobody looks at it any more.
window.addEventListener("pagehide", () => VIEWS[shown].close());
window.addEventListener("pageshow", ({ persisted }) => persisted && open(shown));

refuseFiles();
