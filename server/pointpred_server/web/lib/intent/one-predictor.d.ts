// Types that the entries of one predictor share, such as `pointpred/minimum-jerk`.

import type * as all from "../index.js";

/** Options without the choice of a predictor. */
type Own<Options> = Omit<Options, "predictor" | "service">;

export type IntentOptions = Own<all.IntentOptions>;
export type PrefetchLinkOptions = Own<all.PrefetchLinkOptions>;

/** Calls `callback` when the user is heading for an element, or for one of several, such as a NodeList. Returns what stops it. */
export function onIntent(
  elements: Element | Iterable<Element>,
  callback: all.IntentCallback,
  options?: IntentOptions,
): () => void;

/** Registers an element without a callback, so that its neighbours are predicted by mistake less often. */
export function register(element: Element, options?: IntentOptions): all.Handle;

/** Loads the pages of links that the user is heading for. Returns what stops it. */
export function prefetchLink(
  links: Parameters<typeof all.prefetchLink>[0],
  options?: PrefetchLinkOptions,
): ReturnType<typeof all.prefetchLink>;

export type { Firing, Handle, IntentCallback, LedgerEntry, LedgerSummary } from "../index.js";
export { ledger, onLedger } from "../index.js";
export { showOverlay } from "./overlay/overlay.js";
