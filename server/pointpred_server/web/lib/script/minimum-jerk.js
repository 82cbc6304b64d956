// What `minimum-jerk.min.js` holds, for a script tag: `npm pack` makes it. It is small: without the overlay.

export { ledger, onIntent, onLedger, prefetchLink, register } from "../entries/minimum-jerk.js";
