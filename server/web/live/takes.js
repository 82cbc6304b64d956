// Simulated movements of the embedded sample, made to end on a tile, with what the service answers to each event of them.

import { Ledger } from "../page/ledger.js";
import { speed } from "./movement.js";
import { read, token } from "../service/http.js";
import { connect } from "/pointpred.js";

const PLANS = [{ tile: 3, start: [0.16, 0.24] }, { tile: 1, start: [0.84, 0.3] }, { tile: 4, start: [0.4, 0.18] }];
const STEP_S = 0.008; // as a mouse at 125 Hz
const REST_PX = 3;
const APART_S = 1000; // from one movement to the next

/**
 * @typedef {{rows: number[][], answers: object[], proposals: (string|null)[], delays: number[], speeds: number[], tile: string}} Take
 *   rows [t s from 0, x, y]; after each: the prediction, the predicted tile, ms until the answer came, px/s; where it ends
 */

/** Without the rest before and after, at the pace of a mouse. @returns {number[][]} [t s, x, y] */
export function trimmed({ t, x, y }) {
  const last = t.length - 1;
  const from = (i, k) => Math.hypot(x[i] - x[k], y[i] - y[k]);
  let first = 0, end = last;
  while (first < last && from(first + 1, 0) < REST_PX) first += 1;
  while (end > first && from(end - 1, last) < REST_PX) end -= 1;
  const rows = [];
  for (let i = first; i <= end; i += 1) {
    if (i === end || rows.length === 0 || t[i] - t[first] >= rows[rows.length - 1][0] + STEP_S) rows.push([t[i] - t[first], x[i], y[i]]);
  }
  return rows;
}

/** Turns, scales and moves a path so that it leads from one point to another; times stay. */
export function led(rows, [startX, startY], [endX, endY]) {
  const [, x, y] = rows[0], [, lastX, lastY] = rows[rows.length - 1];
  const [dx, dy, toX, toY] = [lastX - x, lastY - y, endX - startX, endY - startY];
  const square = dx * dx + dy * dy;
  const [re, im] = [(toX * dx + toY * dy) / square, (toY * dx - toX * dy) / square];
  return rows.map(([t, px, py]) => [t, startX + re * (px - x) - im * (py - y), startY + im * (px - x) + re * (py - y)]);
}

/**
 * Asks the service for each movement, one after another, over a connection of its own.
 * @param {{predictor: string, parameters: object, tiles: import("/pointpred.js").Target[], width: number, height: number}} about
 * @param {(take: Take) => void} done @param {AbortSignal} signal
 */
export async function askForTakes({ predictor, parameters, tiles, width, height }, done, signal) {
  const { samples } = await read("/v1/samples");
  const connection = connect(undefined, { predictor, parameters, pointer: false, token, encoding: "json", targets: tiles });
  signal.addEventListener("abort", () => connection.close());
  try {
    for (const [i, { tile, start }] of PLANS.entries()) {
      const movement = await read(`/v1/samples/${encodeURIComponent(samples[i % samples.length].name)}?predictors=`);
      const { id, x, y, width: wide, height: high } = tiles[tile];
      const rows = led(trimmed(movement), [start[0] * width, start[1] * height], [x + wide / 2, y + high / 2]);
      if (signal.aborted) return;
      done({ rows, tile: id, speeds: rows.map(([t], k) => speed(rows.slice(Math.max(0, k - 10), k + 1), t)), ...(await answersTo(connection, rows, APART_S * (i + 1))) });
      connection.reset();
    }
  } finally {
    connection.close();
  }
}

/** What the service answers to each event; fails where the connection is lost. */
function answersTo(connection, rows, offset) {
  const answers = [], delays = [], choices = [];
  const send = ([t, x, y]) => connection.send([[offset + t, x, y, null, null, 0]]);
  return new Promise((resolve, reject) => {
    const stop = [
      connection.on("choice", (choice) => choices.push(choice)),
      connection.on("prediction", (prediction) => {
        answers.push(prediction);
        delays.push(connection.delayMs);
        if (answers.length < rows.length) return send(rows[answers.length]);
        stop.forEach((each) => each());
        resolve({ answers, delays, proposals: proposedAt(rows.map(([t]) => offset + t), choices) });
      }),
      connection.on("error", ({ message }) => reject(new Error(message))),
      connection.on("state", (state) => (state === "waiting" || state === "closed") && reject(new Error("the connection was lost"))),
    ];
    send(rows[0]);
  });
}

/** Which tile is predicted after each event. @param {number[]} times s @param {import("/pointpred.js").Choice[]} choices */
export function proposedAt(times, choices) {
  const ledger = new Ledger();
  let next = 0;
  return times.map((time) => {
    for (; next < choices.length && choices[next].t <= time; next += 1) ledger.take(choices[next]);
    return ledger.standing;
  });
}
