// Predictions along a recorded movement: its events go over the socket, one answer comes back for each.

import { token } from "../service/http.js";
import { connect } from "/pointpred.js";

const PART = 512; // events a message; the next one waits for the answer, so that no answer gives way to a newer
const PER_S = 10000;
const PATIENCE_MS = 10000;

/** Resolves when `ready` says so, rejects after ten seconds without it or with the service's own words. */
function waiting(connection, name, ready) {
  return new Promise((resolve, reject) => {
    const end = (settle, value) => {
      clearTimeout(timer);
      stopListening.forEach((stop) => stop());
      settle(value);
    };
    const timer = setTimeout(() => end(reject, new Error("the service does not answer")), PATIENCE_MS);
    const stopListening = [
      connection.on(name, (message) => ready(message) && end(resolve, message)),
      connection.on("error", ({ message }) => end(reject, new Error(message))),
    ];
  });
}

/**
 * What a predictor says after each event of a movement.
 * @param {number[][]} rows events [t, x, y, dx, dy, buttons] @param {string} predictor
 * @param {{dpi: number, cpi: number|null}} resolution
 * @returns {Promise<import("./picture.js").Column>}
 */
export async function predictionsAlong(rows, predictor, { dpi, cpi }) {
  const options = { predictor, pointer: false, token, reply: "event", screen: { dpi }, ...(cpi ? { device: { cpi } } : {}) };
  const connection = connect(undefined, options);
  const column = { x: [], y: [], regions: [] };
  connection.on("prediction", ({ x, y, region }) => {
    column.x.push(x);
    column.y.push(y);
    column.regions.push(region);
  });
  try {
    if (connection.state !== "open") await waiting(connection, "state", (state) => state === "open");
    for (let first = 0; first < rows.length; first += PART) {
      const part = rows.slice(first, first + PART);
      const answered = waiting(connection, "prediction", () => column.x.length === first + part.length);
      connection.send(part);
      await answered;
      if (rows.length > PER_S) await new Promise((resolve) => setTimeout(resolve, (1000 * PART) / PER_S));
    }
  } finally {
    connection.close();
  }
  return column;
}
