import type { Directive } from "vue";
import type { IntentCallback, IntentOptions } from "../index.d.ts";

/** A callback, or a callback with options; with nothing to call the element is not registered. */
export type IntentBinding = IntentCallback | (IntentOptions & { callback: IntentCallback }) | null | undefined;

/** `<a v-intent="callback">`, or `v-intent="{ callback, policy: 'highlight' }"`. */
export const vIntent: Directive<Element, IntentBinding>;

declare module "vue" {
  interface GlobalDirectives {
    vIntent: typeof vIntent;
  }
}
