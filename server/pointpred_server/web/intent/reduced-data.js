// Whether the user wants to save data, or has a connection too slow to load anything ahead.

const SLOW = ["slow-2g", "2g"];

/** Whether nothing shall be loaded ahead: `Save-Data`, a 2G connection, or the media feature `prefers-reduced-data`. */
export function isReduced() {
  const { saveData = false, effectiveType = "" } = navigator.connection ?? {};
  return saveData || SLOW.includes(effectiveType) || matchMedia("(prefers-reduced-data: reduce)").matches;
}
