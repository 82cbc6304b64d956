// Where predictions are made: in this page, or by the service. The page's address keeps the choice.

const PARAMETER = "by";

/** Whether this page comes from a service; a page of static files has none. */
export const hasService = document.documentElement.dataset.service !== "none";

let page = !hasService || new URLSearchParams(window.location.search).get(PARAMETER) !== "service";
const listeners = new Set();

/** Whether predictions are made in this page. @returns {boolean} */
export const inPage = () => page;

/** Calls `listener` whenever another place was chosen. @param {() => void} listener */
export function onPlace(listener) {
  listeners.add(listener);
}

/** Makes a select choose the place: the value "service", or any other for the page. @param {HTMLSelectElement} select */
export function makePlaceSelect(select) {
  select.value = page ? "page" : "service";
  select.addEventListener("change", () => choose(select.value));
}

function choose(place) {
  page = place !== "service";
  const address = new URL(window.location.href);
  if (page) address.searchParams.delete(PARAMETER);
  else address.searchParams.set(PARAMETER, "service");
  window.history.replaceState(null, "", address);
  for (const listener of listeners) listener();
}
