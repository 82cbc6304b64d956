import type { Action } from "svelte/action";
import type { IntentBinding } from "../index.d.ts";

export type { IntentBinding };

/** `<a use:intent={callback}>`, or `use:intent={{ callback, policy: "highlight" }}`. */
export const intent: Action<Element, IntentBinding>;
