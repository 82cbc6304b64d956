/** Everything that pages use: predictions in the page and from a service, and what a user is heading for. Types: `index.d.ts`. */

export { connect, Connection, regionOf } from "./pointpred.js";
export { build } from "./prediction/build.js";
export * from "./intent/index.js";
