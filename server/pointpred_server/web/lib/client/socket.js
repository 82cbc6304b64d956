// A WebSocket to the service that can be opened again; each attempt waits longer than the one before.

import { frames } from "./frames.js";
import { Reconnecting } from "./reconnecting.js";

const SUBPROTOCOL = "pointpred.v1";

/** One WebSocket at a time; events of earlier ones are ignored. */
export class RetryingSocket extends Reconnecting {
  #address;
  #handlers;
  /** @type {WebSocket|null} */ #socket = null;

  /**
   * @param {() => string} address
   * @param {{onOpen: () => void, onMessage: (data: string|ArrayBuffer) => void, onClose: () => void}} handlers
   */
  constructor(address, handlers) {
    super();
    [this.#address, this.#handlers] = [address, handlers];
  }

  get isOpen() {
    return this.#socket?.readyState === WebSocket.OPEN;
  }

  /** Bytes that the browser still holds back. */
  get bufferedAmount() {
    return /** @type {WebSocket} */ (this.#socket).bufferedAmount;
  }

  open() {
    this.begin();
    const socket = new WebSocket(this.#address(), SUBPROTOCOL);
    socket.binaryType = "arraybuffer";
    const current = (handle) => (event) => socket === this.#socket && handle(event);
    socket.onopen = current(() => {
      this.opened = true;
      this.#handlers.onOpen();
    });
    socket.onmessage = current(({ data }) => this.#handlers.onMessage(data));
    socket.onclose = current(() => {
      this.end();
      this.#socket = null;
      this.#handlers.onClose();
    });
    this.#socket = socket;
  }

  /** Events as frames to send: within the limits of the service. @see frames */
  frames(rows, encoding, limits) {
    return frames(rows, encoding, limits);
  }

  /** @param {string|ArrayBuffer} frame */
  send(frame) {
    /** @type {WebSocket} */ (this.#socket).send(frame);
  }

  /** Closes the socket without calling `onClose`. @param {string} [farewell] the last message of a session */
  close(farewell) {
    this.cancelRetry();
    const socket = this.#socket;
    if (farewell && this.hasSession) socket?.send(farewell);
    this.#socket = null;
    if (socket?.readyState === WebSocket.CONNECTING)
      socket.onopen = () => socket.close(1000); // closing it now would log an error
    else socket?.close(1000);
  }
}
