import type { Directive } from "vue";
import type { IntentBinding } from "../index.d.ts";

export type { IntentBinding };

/** `<a v-intent="callback">`, or `v-intent="{ callback, policy: 'highlight' }"`. */
export const vIntent: Directive<Element, IntentBinding>;

declare module "vue" {
  interface GlobalDirectives {
    vIntent: typeof vIntent;
  }
}
