/** Everything that pages use: predictions in the page and from a service, and what a user is heading for. Types: `index.d.ts`. */

export * from "./intent/index.js";
export { Connection, connect, regionOf } from "./pointpred.js";
export { build } from "./prediction/build.js";
