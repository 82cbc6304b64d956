// A WebSocket to the service that can be opened again; each attempt waits longer than the one before.

const SUBPROTOCOL = "pointpred.v1";
const FIRST_WAIT_MS = 250;
const LONGEST_WAIT_MS = 8000;
const STEADY_MS = 2000; // a session that lasts this long resets the waits

/** One WebSocket at a time; events of earlier ones are ignored. */
export class RetryingSocket {
  /** Whether the newest socket was ever open: if not, the service refused it or cannot be reached. */ opened = false;
  #address; #handlers; #socket = null; #attempts = 0; #timer; #sessionAt = Infinity;

  /**
   * @param {() => string} address
   * @param {{onOpen: () => void, onMessage: (data: string|ArrayBuffer) => void, onClose: () => void}} handlers
   */
  constructor(address, handlers) {
    [this.#address, this.#handlers] = [address, handlers];
  }

  /** Whether what is sent now goes out. */
  get isOpen() {
    return this.#socket?.readyState === WebSocket.OPEN;
  }

  /** Whether the service has begun a session on this socket. */
  get hasSession() {
    return this.isOpen && this.#sessionAt < Infinity;
  }

  /** Bytes that the browser still holds back. */
  get bufferedAmount() {
    return this.#socket.bufferedAmount;
  }

  open() {
    clearTimeout(this.#timer);
    [this.opened, this.#sessionAt] = [false, Infinity];
    const socket = new WebSocket(this.#address(), SUBPROTOCOL);
    socket.binaryType = "arraybuffer";
    const current = (handle) => (event) => socket === this.#socket && handle(event);
    socket.onopen = current(() => {
      this.opened = true;
      this.#handlers.onOpen();
    });
    socket.onmessage = current(({ data }) => this.#handlers.onMessage(data));
    socket.onclose = current(() => {
      if (performance.now() - this.#sessionAt > STEADY_MS) this.#attempts = 0;
      this.#socket = null;
      this.#handlers.onClose();
    });
    this.#socket = socket;
  }

  /** The service has begun a session: if it lasts, the next wait is the shortest again. */
  beginSession() {
    this.#sessionAt = performance.now();
  }

  /** @param {string|ArrayBuffer} frame */
  send(frame) {
    this.#socket.send(frame);
  }

  /** Calls `open` after a wait. @param {() => void} open */
  retry(open) {
    const wait = Math.min(LONGEST_WAIT_MS, FIRST_WAIT_MS * 2 ** this.#attempts++) * (0.75 + 0.5 * Math.random());
    this.#timer = setTimeout(open, wait);
  }

  /** Gives up waiting for the next attempt. */
  cancelRetry() {
    clearTimeout(this.#timer);
  }

  /** Closes the socket without calling `onClose`. @param {string} [farewell] the last message of a session */
  close(farewell) {
    this.cancelRetry();
    const socket = this.#socket;
    if (farewell && this.hasSession) socket.send(farewell);
    this.#socket = null;
    if (socket?.readyState === WebSocket.CONNECTING) socket.onopen = () => socket.close(1000); // closing it now would log an error
    else socket?.close(1000);
  }
}
