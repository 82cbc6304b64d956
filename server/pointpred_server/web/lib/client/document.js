// What can be called in a page only; importing works anywhere.

/** Throws an Error where there is no document, such as in Node. @param {string} call what was called */
export function needDocument(call) {
  if (typeof document === "undefined") throw new Error(`${call} needs a document: call it in the browser`);
}
