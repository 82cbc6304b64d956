// Types of `pointpred/intent`.

export type {
  Counts,
  Firing,
  Firings,
  Handle,
  IntentCallback,
  IntentOptions,
  LedgerEntry,
  LedgerSummary,
  LinkFilter,
  PlaceFiring,
  PlaceHandle,
  PlaceOptions,
  PredictorName,
  PrefetchLinkOptions,
  Reason,
  Sides,
} from "../index.js";
export { ledger, onIntent, onLedger, onPlace, prefetchLink, register, showOverlay } from "../index.js";
