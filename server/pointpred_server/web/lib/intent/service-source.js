// Predictions made by a service, over its WebSocket.

import { connect } from "../pointpred.js";

/**
 * A predictor behind a service: its predictions come later than the events.
 * @param {string} predictor a name of the registry @param {string} service its address @param {(row: number[]) => void} onAnswer
 * @returns {import("./source.js").Opened}
 */
export function open(predictor, service, onAnswer) {
  const connection = connect(service, { predictor, pointer: false });
  const rows = [];
  connection.on("prediction", ({ t, x, y, region, remaining_s }) => {
    const { sxx = NaN, sxy = NaN, syy = NaN, tail } = region ?? {};
    onAnswer([t, x ?? NaN, y ?? NaN, sxx, sxy, syy, remaining_s ?? NaN, NaN, tail ?? NaN, NaN]);
  });
  /** @type {Promise<void>} */
  const ready = new Promise((resolve) => {
    connection.on("state", (state) => state === "open" && resolve());
  });
  return {
    ready,
    add(row) {
      rows.push(row);
      return null;
    },
    flush() {
      connection.send(rows.splice(0));
      return connection.state === "open";
    },
    close: () => connection.close(),
  };
}
