// Calls of the page's own functions.

/** What the page's own function returns; its error is logged, and keeps nothing else from being called. */
export function attempt(call) {
  try {
    return call();
  } catch (error) {
    reportError(error);
    return undefined;
  }
}
