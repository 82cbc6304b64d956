// Where predictions are made: in this page, or by the service. The page's address keeps the choice.

const PARAMETER = "by";

/** Whether this page comes from a service; a page of static files has none. */
export const hasService = document.documentElement.dataset.service !== "none";

let page = !hasService || new URLSearchParams(window.location.search).get(PARAMETER) !== "service";

/** Whether predictions are made in this page. @returns {boolean} */
export const inPage = () => page;

/**
 * Makes a select choose the place: the value "service", or any other for the page.
 * @param {HTMLSelectElement} select @param {() => void} onChoice is called whenever another was chosen
 */
export function makePlaceSelect(select, onChoice) {
  select.value = page ? "page" : "service";
  select.addEventListener("change", () => {
    choose(select.value);
    onChoice();
  });
}

function choose(place) {
  page = place !== "service";
  const address = new URL(window.location.href);
  if (page) address.searchParams.delete(PARAMETER);
  else address.searchParams.set(PARAMETER, "service");
  window.history.replaceState(null, "", address);
}
