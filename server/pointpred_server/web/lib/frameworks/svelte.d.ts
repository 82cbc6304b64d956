import type { Action } from "svelte/action";
import type { IntentCallback, IntentOptions } from "../index.d.ts";

/** A callback, or a callback with options. */
export type IntentBinding = IntentCallback | (IntentOptions & { callback: IntentCallback });

/** `<a use:intent={callback}>`, or `use:intent={{ callback, policy: "highlight" }}`. */
export const intent: Action<Element, IntentBinding>;
