import type { Directive } from "vue";
import type { IntentCallback, IntentOptions } from "../index.d.ts";

/** `<a v-intent="callback">`, or `v-intent="{ callback, policy: 'highlight' }"`. */
export const vIntent: Directive<Element, IntentCallback | (IntentOptions & { callback: IntentCallback })>;
