// Types of `pointpred/intent`.

export type {
  Counts, Firing, Handle, IntentCallback, IntentOptions, LedgerEntry, LedgerSummary, PrefetchLinkOptions, Reason, Sides,
} from "../index.js";
export { ledger, onIntent, onLedger, prefetchLink, register, showOverlay } from "../index.js";
