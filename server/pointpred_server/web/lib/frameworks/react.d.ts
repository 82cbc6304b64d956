import type { ComponentPropsWithRef, ElementType, ReactElement, RefCallback } from "react";
import type { IntentCallback, IntentOptions } from "../index.d.ts";

/** Calls `callback` when the user is heading for the element that gets the returned ref. Both may change in each render. */
export function useIntent(callback: IntentCallback, options?: IntentOptions): RefCallback<Element>;

export interface IntentState {
  /** For the element. */
  ref: RefCallback<Element>;
  /** Whether a firing holds: with `highlight` until the movement turns to something else, with `prefetch` for good. */
  predicted: boolean;
  /** Whether it has fired. */
  fired: boolean;
  /** The probability at the newest firing; 0 before. */
  p: number;
  /** What the callback threw, or its promise was rejected with, at the newest firing; else null. */
  error: unknown;
}

/** As `useIntent`, with what has become of it; a change renders again. Without a callback it only says so. */
export function useIntentState(callback?: IntentCallback | null, options?: IntentOptions): IntentState;

/** The properties of `Intent`: its own, and those of the element or component that it is made `as`. */
export type IntentProperties<Type extends ElementType> = {
  /** `"a"` by default. A component must forward its ref. */
  as?: Type;
  onIntent: IntentCallback;
  options?: IntentOptions;
} & Omit<ComponentPropsWithRef<Type>, "as" | "onIntent" | "options">;

/** An element that calls `onIntent`. */
export function Intent<Type extends ElementType = "a">(properties: IntentProperties<Type>): ReactElement | null;
