// An action for Svelte: <a use:intent={callback}>, or use:intent={{ callback, policy: "highlight" }}.

import { partsOf, Registered } from "./registered.js";

/** @param {Element} element @param {import("../index.d.ts").IntentBinding} value */
export function intent(element, value) {
  const registered = new Registered(element, ...partsOf(value));
  return {
    update: (changed) => registered.update(...partsOf(changed)),
    destroy: () => registered.stop(),
  };
}
