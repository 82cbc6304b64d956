// The movements of the embedded sample: asked of the service, or files beside a page without one.

import { read } from "./http.js";
import { hasService } from "./place.js";

const LISTING = hasService ? "/v1/samples" : "samples/index.json";

/** The name, the person and the number of events of each movement. @returns {Promise<{name: string, user: string, events: number}[]>} */
export const samples = async () => (await read(LISTING)).samples;

/**
 * A movement as columns.
 * @param {string} name
 * @returns {Promise<{user: string, target: import("../../lib/index.d.ts").Goal|null, dpi: number, cpi: number|null, t: number[], x: number[], y: number[],
 *   dx: (number|null)[], dy: (number|null)[], buttons: number[]}>} t in s from 0
 */
export const sample = (name) => read(hasService ? `/v1/samples/${encodeURIComponent(name)}` : `samples/${name}.json`);
