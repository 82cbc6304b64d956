// The device attached to the machine of the service: whether there is one, and its messages.

import { socketAddress } from "../../lib/client/address.js";
import { RetryingSocket } from "../../lib/client/socket.js";
import { read, token } from "../service/service.js";

/** The attached device, or a message why there is none. @returns {Promise<{attached: object|null, message: string}>} */
export const attachedDevice = () => read("/v1/live");

/** Listens to `/v1/live`, and connects again whenever the connection is lost. */
export class DeviceStream {
  /** @type {"connecting"|"open"|"waiting"|"closed"} */ state = "connecting";
  #handlers;
  #socket;

  /** @param {Object<string, (message: any) => void>} handlers by the type of a message; `state` for that of the connection */
  constructor(handlers) {
    this.#handlers = handlers;
    this.#socket = new RetryingSocket(() => socketAddress("/v1/live", token), {
      onOpen: () => {
        this.#socket.beginSession();
        this.#setState("open");
      },
      onMessage: (data) => {
        const message = JSON.parse(/** @type {string} */ (data));
        this.#handlers[message.type]?.(message);
      },
      onClose: () => {
        this.#socket.retry(() => this.#socket.open());
        this.#setState("waiting");
      },
    });
    this.#socket.open();
  }

  close() {
    this.state = "closed";
    this.#socket.close();
  }

  #setState(state) {
    this.state = state;
    this.#handlers.state?.(state);
  }
}
