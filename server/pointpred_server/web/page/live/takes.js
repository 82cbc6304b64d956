// Simulated movements of the embedded sample, turned so that they end on a tile, with the prediction after each event.

import { connect } from "../../lib/pointpred.js";
import { inPage, sample, samples, token } from "../service/service.js";
import { speed } from "./movement.js";
import { proposedAfter } from "./tiles.js";

const PLANS = [
  { tile: 3, start: [0.16, 0.24] },
  { tile: 1, start: [0.84, 0.3] },
  { tile: 4, start: [0.4, 0.18] },
];
const STEP_S = 0.008; // as a mouse at 125 Hz
const REST_PX = 3;
const APART_S = 1000; // between the times of two movements

/**
 * @typedef {{rows: number[][], answers: import("../service/predictor-connection.js").Prediction[], proposals: (string|null)[], delays: number[], speeds: number[], tile: string}} Take
 *   rows [t s from 0, x, y]; after each row: the prediction, the predicted tile, the delay of the answer, ms, and the speed, px/s; the tile where it ends
 */

/** A movement without the rest before and after it, thinned to the rate of a mouse. @returns {number[][]} [t s, x, y] */
function trim({ t, x, y }) {
  const last = t.length - 1;
  const distance = (i, k) => Math.hypot(x[i] - x[k], y[i] - y[k]);
  let first = 0,
    end = last;
  while (first < last && distance(first + 1, 0) < REST_PX) first += 1;
  while (end > first && distance(end - 1, last) < REST_PX) end -= 1;
  const rows = [];
  for (let i = first; i <= end; i += 1) {
    if (i === end || rows.length === 0 || t[i] - t[first] >= rows[rows.length - 1][0] + STEP_S)
      rows.push([t[i] - t[first], x[i], y[i]]);
  }
  return rows;
}

/** Turns, scales and moves a path so that it leads from one point to another; times stay. */
function transform(rows, [startX, startY], [endX, endY]) {
  const [, x, y] = rows[0],
    [, lastX, lastY] = rows[rows.length - 1];
  const [dx, dy, toX, toY] = [lastX - x, lastY - y, endX - startX, endY - startY];
  const square = dx * dx + dy * dy;
  const [re, im] = [(toX * dx + toY * dy) / square, (toY * dx - toX * dy) / square];
  return rows.map(([t, px, py]) => [t, startX + re * (px - x) - im * (py - y), startY + im * (px - x) + re * (py - y)]);
}

/**
 * Requests the movements and their predictions one after another, over a connection of its own.
 * @param {{predictor: string, parameters: Object<string, number>, tiles: import("../../lib/index.d.ts").NamedTarget[], width: number, height: number}} scene
 * @param {(take: Take) => void} onTake @param {AbortSignal} signal
 */
export async function requestTakes({ predictor, parameters, tiles, width, height }, onTake, signal) {
  const listed = await samples();
  const connection = connect(undefined, {
    predictor,
    parameters,
    pointer: false,
    token,
    page: inPage(),
    encoding: "json",
    targets: tiles,
  });
  signal.addEventListener("abort", () => connection.close());
  try {
    for (const [i, { tile, start }] of PLANS.entries()) {
      const movement = await sample(listed[i % listed.length].name);
      const target = tiles[tile];
      const rows = transform(
        trim(movement),
        [start[0] * width, start[1] * height],
        [target.x + target.width / 2, target.y + target.height / 2],
      );
      if (signal.aborted) return;
      const speeds = rows.map(([t], k) => speed(rows.slice(Math.max(0, k - 10), k + 1), t));
      onTake({ rows, tile: target.id, speeds, ...(await answersTo(connection, rows, APART_S * (i + 1))) });
      connection.reset();
    }
  } finally {
    connection.close();
  }
}

/** The prediction after each event; rejects if the connection is lost. */
function answersTo(connection, rows, offset) {
  const answers = [],
    delays = [],
    choices = [];
  const send = ([t, x, y]) => connection.send([[offset + t, x, y, null, null, 0]]);
  return new Promise((resolve, reject) => {
    const removers = [
      connection.on("choice", (choice) => choices.push(choice)),
      connection.on("prediction", (prediction) => {
        answers.push({ ...prediction, mixture: connection.mixture });
        delays.push(connection.delayMs);
        if (answers.length < rows.length) return send(rows[answers.length]);
        removers.forEach((remove) => remove());
        resolve({
          answers,
          delays,
          proposals: proposedAt(
            rows.map(([t]) => offset + t),
            choices,
          ),
        });
      }),
      connection.on("error", ({ message }) => reject(new Error(message))),
      connection.on(
        "state",
        (state) => (state === "waiting" || state === "closed") && reject(new Error("the connection was lost")),
      ),
    ];
    send(rows[0]);
  });
}

/** The tile that is predicted after each event. @param {number[]} times s @param {import("../../lib/index.d.ts").Choice[]} choices */
export function proposedAt(times, choices) {
  let next = 0,
    /** @type {string|null} */ proposed = null;
  return times.map((time) => {
    for (; next < choices.length && /** @type {number} */ (choices[next].t) <= time; next += 1)
      proposed = proposedAfter(proposed, choices[next]);
    return proposed;
  });
}
