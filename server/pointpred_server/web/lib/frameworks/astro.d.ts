import type { AstroIntegration } from "astro";
import type { IntentOptions } from "../index.d.ts";

/** Options of `onIntent` but functions: they are written into each page. */
export type AstroOptions = Omit<IntentOptions, "enabled" | "onError"> & { enabled?: boolean };

/**
 * Prefetches links with `data-astro-prefetch`, or with `data-astro-prefetch="intent"`, when the user is heading for them; with
 * `prefetchAll` among Astro's own options every link that names no other strategy. Left out is what `prefetchLink` leaves out:
 * other origins, addresses that look as if they logged out or changed something, what is in an element with `data-no-prefetch`.
 */
export default function pointpred(options?: AstroOptions): AstroIntegration;
