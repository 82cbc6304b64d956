// A directive for Vue: <a v-intent="callback">, or v-intent="{ callback, policy: 'highlight' }".

import { partsOf, Registered } from "./registered.js";

const registered = new WeakMap(); // by element

export const vIntent = {
  mounted(element, { value }) {
    registered.set(element, new Registered(element, ...partsOf(value)));
  },
  updated(element, { value }) {
    registered.get(element).update(...partsOf(value));
  },
  unmounted(element) {
    registered.get(element).stop();
  },
};
