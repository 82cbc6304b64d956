// Predictions along a recorded movement: a session answers each of its events.

import { connect } from "../../lib/pointpred.js";
import { inPage, token } from "../service/service.js";

const PART = 512; // events per message; the next message waits for the answers, so that none is dropped
const PER_S = 10000; // that a service takes
const TIMEOUT_MS = 10000;

/** The next message of a connection that `accept` accepts; rejects after an error or ten seconds. */
function nextMessage(connection, name, accept) {
  return new Promise((resolve, reject) => {
    const settle = (act, value) => {
      clearTimeout(timer);
      removers.forEach((remove) => remove());
      act(value);
    };
    const timer = setTimeout(() => settle(reject, new Error("no answer came within ten seconds")), TIMEOUT_MS);
    const removers = [
      connection.on(name, (message) => accept(message) && settle(resolve, message)),
      connection.on("error", ({ message }) => settle(reject, new Error(message))),
    ];
  });
}

/**
 * The prediction of a predictor after each event of a movement.
 * @param {import("../../lib/index.d.ts").EventRow[]} rows @param {string} predictor
 * @param {{dpi: number, cpi: number|null}} resolution
 * @returns {Promise<import("./picture.js").Column>}
 */
export async function predictionsAlong(rows, predictor, { dpi, cpi }) {
  const page = inPage();
  /** @type {import("../../lib/index.d.ts").ConnectOptions} */
  const options = {
    page,
    predictor,
    pointer: false,
    token,
    reply: "event",
    screen: { dpi },
    ...(cpi ? { device: { cpi } } : {}),
  };
  const connection = connect(undefined, options);
  /** @type {import("./picture.js").Column} */
  const column = { x: [], y: [], regions: [] };
  connection.on("prediction", ({ x, y, region }) => {
    column.x.push(x);
    column.y.push(y);
    column.regions.push(region);
  });
  try {
    if (connection.state !== "open") await nextMessage(connection, "state", (state) => state === "open");
    for (let first = 0; first < rows.length; first += PART) {
      const part = rows.slice(first, first + PART);
      const answered = nextMessage(connection, "prediction", () => column.x.length === first + part.length);
      connection.send(part);
      await answered;
      if (!page && rows.length > PER_S) await new Promise((resolve) => setTimeout(resolve, (1000 * PART) / PER_S));
    }
  } finally {
    connection.close();
  }
  return column;
}
