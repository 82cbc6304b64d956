import type { ElementType, ReactElement, RefCallback } from "react";
import type { IntentCallback, IntentOptions } from "../index.d.ts";

/** Calls `callback` when the user is heading for the element that gets the returned ref. */
export function useIntent(callback: IntentCallback, options?: IntentOptions): RefCallback<Element>;

/** An element that calls `onIntent`. */
export function Intent(properties: {
  as?: ElementType;
  onIntent: IntentCallback;
  options?: IntentOptions;
  [property: string]: unknown;
}): ReactElement;
