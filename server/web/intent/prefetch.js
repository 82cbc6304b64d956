// Which targets are worth loading ahead.

import { X, X0, Y, Y0 } from "../laws/targets/cursor.js";
import { early } from "../laws/targets/decision.js";

const LEAST_WAY_PX = 3; // nearer to the movement's start nothing is predicted

/** Whether a target of this share is fired now. @param {Float64Array} memory of the cursor @param {Float64Array} row of the table @param {number} share @param {number} threshold */
export function fires(memory, row, share, threshold) {
  return share >= threshold && Math.hypot(memory[X] - memory[X0], memory[Y] - memory[Y0]) >= LEAST_WAY_PX && early(memory, row, NaN, 0);
}
