// A hook and a component for React.

import { createElement, useEffect, useRef, useState } from "react";
import { onIntent } from "../intent/index.js";

/**
 * Calls `callback` when the user is heading for the element that gets the returned ref.
 * @param {import("../index.d.ts").IntentCallback} callback may change in each render
 * @param {import("../index.d.ts").IntentOptions} [options] changed options register the element again
 * @returns {(element: Element|null) => void} a ref
 */
export function useIntent(callback, options = {}) {
  const [element, ref] = useState(null),
    newest = useRef();
  useEffect(() => {
    newest.current = { callback, options };
  });
  useEffect(
    () =>
      element ? onIntent(element, (firing) => newest.current.callback(firing), newest.current.options) : undefined,
    [element, JSON.stringify(options)],
  );
  return ref;
}

/** An element, `as` which (`"a"` by default), that calls `onIntent`; `options` as in `useIntent`, every other property goes to the element. */
export function Intent({ as = "a", onIntent: callback, options, ...properties }) {
  return createElement(as, { ...properties, ref: useIntent(callback, options) });
}
