// Types of `pointpred/intent`.

export type {
  Counts,
  Firing,
  Handle,
  IntentCallback,
  IntentOptions,
  LedgerEntry,
  LedgerSummary,
  PlaceFiring,
  PlaceHandle,
  PlaceOptions,
  PredictorName,
  PrefetchLinkOptions,
  Reason,
  Sides,
} from "../index.js";
export { ledger, onIntent, onLedger, onPlace, prefetchLink, register, showOverlay } from "../index.js";
