import type { Action } from "svelte/action";
import type { IntentCallback, IntentOptions } from "../index.d.ts";

/** A callback, or a callback with options; with nothing to call the element is not registered. */
export type IntentBinding = IntentCallback | (IntentOptions & { callback: IntentCallback }) | null | undefined;

/** `<a use:intent={callback}>`, or `use:intent={{ callback, policy: "highlight" }}`. */
export const intent: Action<Element, IntentBinding>;
