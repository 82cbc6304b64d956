// A directive for Vue: <a v-intent="callback">, or v-intent="{ callback, policy: 'highlight' }".

import { onIntent } from "../intent/index.js";

const registered = new WeakMap(); // by element: the newest callback, its options as text, what stops it

const parts = (value) => (typeof value === "function" ? { callback: value } : value);

function mounted(element, { value }) {
  const { callback, ...options } = parts(value),
    one = { callback, key: JSON.stringify(options) };
  one.stop = onIntent(element, (firing) => one.callback(firing), options);
  registered.set(element, one);
}

function unmounted(element) {
  registered.get(element)?.stop();
  registered.delete(element);
}

/** A new callback is called from then on. Changed options register the element again. */
function updated(element, binding) {
  const { callback, ...options } = parts(binding.value),
    one = registered.get(element);
  if (JSON.stringify(options) === one.key) one.callback = callback;
  else {
    unmounted(element);
    mounted(element, binding);
  }
}

export const vIntent = { mounted, updated, unmounted };
