// The numbers of the learned predictor: fetched once, shared by every pipeline of the page.

import { unpack } from "../laws/coefficients.js";

const FILES = { "kinematic.f32": () => new URL("../laws/kinematic.f32", import.meta.url) }; // a bundler finds the file by this expression
const NODE_FILES = "node:fs/promises"; // a name, so that a bundler for the browser does not look for it

/** @type {Map<string, Promise<Float64Array>>} */ const read = new Map();

/** The coefficients in a file. Rejects where it cannot be fetched; the next call tries again. @param {string} name @returns {Promise<Float64Array>} */
export function coefficientsOf(name) {
  if (!read.has(name)) {
    const reading = bytesOf(FILES[name]()).then(unpack);
    reading.catch(() => read.delete(name));
    read.set(name, reading);
  }
  return read.get(name);
}

/** @param {URL} url @returns {Promise<ArrayBuffer>} */
async function bytesOf(url) {
  if (url.protocol === "file:") return Uint8Array.from(await (await import(NODE_FILES)).readFile(url)).buffer; // in Node
  const response = await fetch(url);
  if (!response.ok) throw new Error(`the coefficients at ${url.href} cannot be fetched: status ${response.status}`);
  return response.arrayBuffer();
}
