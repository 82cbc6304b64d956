// What `pointpred.min.js` holds, for a script tag: `npm pack` makes it.

export { ledger, onIntent, onLedger, prefetchLink, register, showOverlay } from "../entries/kinematic-adaptive.js";
