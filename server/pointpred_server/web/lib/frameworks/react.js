// Hooks and a component for React.

import {
  createElement,
  forwardRef,
  useCallback,
  useEffect,
  useImperativeHandle,
  useReducer,
  useRef,
  useState,
} from "react";
import { isAbort } from "../intent/firing-ledger.js";
import { Registered } from "./registered.js";

const BEFORE = { predicted: false, fired: false, p: 0, error: null };

/**
 * Calls `callback` when the user is heading for the element that gets the returned ref. Callback and options may change in
 * each render.
 * @param {import("../index.d.ts").IntentCallback} callback
 * @param {import("../index.d.ts").IntentOptions} [options]
 * @returns {(element: Element|null) => void} a ref
 */
export function useIntent(callback, options) {
  const given = useRef(/** @type {[typeof callback, typeof options]} */ ([callback, options]));
  const registered = useRef(/** @type {Registered|null} */ (null));
  useEffect(() => {
    given.current = [callback, options];
    registered.current?.update(callback, options);
  });
  return useCallback((element) => {
    registered.current?.stop();
    registered.current = element && new Registered(element, ...given.current);
  }, []);
}

/** As `useIntent`, with what has become of it, which renders again whenever it changes: `{ ref, predicted, fired, p, error }`. */
export function useIntentState(callback, options) {
  const [state, setState] = useState(BEFORE);
  const change = (part) => setState((now) => ({ ...now, ...part }));
  const ref = useIntent((firing) => {
    const fail = (error) => isAbort(error) || change({ error });
    setState({ predicted: true, fired: true, p: firing.p, error: null });
    firing.signal.addEventListener("abort", () => change({ predicted: false }));
    try {
      const answer = callback?.(firing);
      answer?.catch?.(fail);
      return answer;
    } catch (error) {
      fail(error);
      throw error;
    }
  }, options);
  return { ref, ...state };
}

/** @typedef {Pick<import("./react.d.ts").IntentProperties<"a">, "as"|"onIntent"|"options">} Properties */

/** An element, `as` which (`"a"` by default), that calls `onIntent`; `options` as in `useIntent`, every other property goes to the element. */
export const Intent = forwardRef(function Intent(
  /** @type {Properties} */ { as = "a", onIntent, options, ...properties },
  outer,
) {
  const element = useRef(undefined);
  const [swaps, countSwap] = useReducer((count) => count + 1, 0);
  const register = useIntent(onIntent, options);
  const ref = useCallback((found) => {
    if (found && element.current !== undefined) countSwap(); // a component may change its node without this being rendered
    element.current = found;
    register(found);
  }, []);
  useImperativeHandle(outer, () => element.current, [as, swaps]);
  return createElement(as, { ...properties, ref });
});
