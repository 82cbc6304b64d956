// A predictor in the live view: its choice, its connection, its parameters and its predictions.

import { SmoothRegions } from "../drawing/regions.js";
import { withParameters } from "../service/listing.js";
import { ConnectionStatus, PredictorConnection, stateText } from "../service/predictor-connection.js";
import { fillSelect } from "../shell/elements.js";
import { Parameters } from "./parameters.js";
import { markOf, opacityAfter, PredictionFields } from "./prediction.js";

/** The card of one predictor. */
export class LiveCard {
  /** Null while no predictor is chosen or the view is closed. @type {PredictorConnection|null} */ connection = null;
  /** @type {import("../service/listing.js").Listed[]} */ #predictors = [];
  #card;
  #status;
  #handlers;
  #options;
  #regions = new SmoothRegions();

  /**
   * @param {HTMLElement} card @param {HTMLDetailsElement} parameters
   * @param {(prediction: import("../../lib/index.d.ts").Prediction, name: string) => void} onPrediction is called with each, and with its predictor
   * @param {import("../service/predictor-connection.js").Handlers} handlers @param {import("../../lib/index.d.ts").ConnectOptions} options of the connection
   */
  constructor(card, parameters, onPrediction, handlers = {}, options = {}) {
    this.#options = options;
    this.#card = card;
    this.select = /** @type {HTMLSelectElement} */ (card.querySelector("select"));
    this.fields = new PredictionFields(card);
    this.#status = new ConnectionStatus(/** @type {HTMLElement} */ (card.querySelector(".connection")));
    this.#handlers = {
      prediction: (one) => onPrediction(one, /** @type {PredictorConnection} */ (this.connection).activePredictor),
      state: () => this.#showStatus(),
      error: (one) => this.#showError(one),
      ...handlers,
    };
    this.parameters = new Parameters(parameters, () =>
      this.connection?.configure(this.select.value, this.parameters.values),
    );
    this.select.addEventListener("change", () => this.#choose());
  }

  get isFilled() {
    return this.#predictors.length > 0;
  }

  /** Fills the select. @param {import("../service/listing.js").Listed[]} predictors @param {string} selected @param {string|null} none label of an empty choice */
  fill(predictors, selected, none = null) {
    fillSelect(this.select, predictors, selected, none);
    this.#predictors = predictors;
    this.#describe();
  }

  /** Connects with the chosen predictor, if there is one. */
  open() {
    const parameters = this.parameters.values;
    if (this.connection === null && this.select.value)
      this.connection = new PredictorConnection(this.select.value, this.#handlers, { ...this.#options, parameters });
    this.#showStatus();
  }

  close() {
    this.connection?.close();
    this.connection = null;
  }

  /** The newest prediction as it is drawn; null once it is too old or the movement is over. */
  mark(now) {
    const { latest, at } = this.connection?.state === "open" ? this.connection : { latest: null, at: -Infinity };
    return markOf(latest, this.#regions, now, opacityAfter(performance.now() - at));
  }

  #choose() {
    this.#describe();
    if (!this.select.value) this.close();
    else if (this.connection === null) this.open();
    else this.connection.choose(this.select.value);
    this.#showStatus();
  }

  /** Shows the predictor's parameters. */
  #describe() {
    const chosen = this.#predictors.find(({ name }) => name === this.select.value) ?? null;
    this.parameters.show(chosen === null ? null : { name: chosen.name, parameters: [] });
    if (chosen !== null) this.#showParameters(chosen);
  }

  async #showParameters(chosen) {
    const described = await withParameters(chosen).catch(() => null); // the connection says what is wrong
    if (described !== null && chosen.name === this.select.value) this.parameters.show(described);
  }

  #showError({ message, path }) {
    if ((path ?? "").startsWith("$.parameters")) this.parameters.reject(message, path);
    this.#showStatus();
  }

  #showStatus() {
    const predictor = this.select.value;
    this.#card.dataset.chosen = predictor;
    const disconnected = predictor || !this.isFilled ? stateText("connecting") : "No predictor chosen.";
    this.#status.show(this.connection?.state, { error: this.connection?.error, disconnected });
  }
}
