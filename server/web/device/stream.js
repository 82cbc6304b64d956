// The device attached to the machine that the service runs on: whether there is one, and what it does.

import { read, token } from "../service/http.js";

const FIRST_WAIT_MS = 500;
const LONGEST_WAIT_MS = 8000;

/** What the service says of an attached device. @returns {Promise<{attached: object|null, message: string}>} */
export const attached = () => read("/v1/live");

/** Listens to `/v1/live`, again whenever the connection is lost; says nothing itself. */
export class DeviceStream {
  /** @type {"connecting"|"open"|"waiting"|"closed"} */ state = "connecting";
  #told; #socket = null; #tries = 0; #retry = null;

  /** @param {Object<string, (message: object) => void>} told by the type of a message; `state` hears of the connection */
  constructor(told) {
    this.#told = told;
    this.#open();
  }

  close() {
    this.state = "closed";
    clearTimeout(this.#retry);
    const socket = this.#socket;
    if (socket?.readyState === WebSocket.CONNECTING) socket.addEventListener("open", () => socket.close()); // sooner, a browser complains
    else socket?.close();
  }

  #open() {
    const address = new URL("/v1/live", window.location.href);
    address.protocol = address.protocol.replace("http", "ws");
    if (token !== undefined) address.searchParams.set("token", token);
    const socket = new WebSocket(address, "pointpred.v1");
    this.#socket = socket;
    socket.addEventListener("open", () => {
      if (this.state === "closed") return;
      this.#tries = 0;
      this.#become("open");
    });
    socket.addEventListener("message", ({ data }) => {
      const message = JSON.parse(data);
      if (this.state !== "closed") this.#told[message.type]?.(message);
    });
    socket.addEventListener("close", () => {
      if (this.state === "closed") return;
      this.#become("waiting");
      this.#retry = setTimeout(() => this.#open(), Math.min(LONGEST_WAIT_MS, FIRST_WAIT_MS * 2 ** this.#tries));
      this.#tries += 1;
    });
  }

  #become(state) {
    this.state = state;
    this.#told.state?.(state);
  }
}
