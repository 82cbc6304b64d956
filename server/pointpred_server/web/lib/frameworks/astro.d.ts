import type { AstroIntegration } from "astro";
import type { IntentOptions } from "../index.d.ts";

/**
 * Prefetches links with `data-astro-prefetch`, or with `data-astro-prefetch="intent"`, when the user is heading for them; with
 * `prefetchAll` among Astro's own options every link that names no other strategy.
 */
export default function pointpred(options?: IntentOptions): AstroIntegration;
