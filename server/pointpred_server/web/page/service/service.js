// The service, and what stands for it: where predictions are made, which the page's address keeps, and what is read over HTTP.

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

/** The token in the page's own address, if the service asks for one. */
export const token = new URLSearchParams(window.location.search).get("token") ?? undefined;

/** @type {Record<string, string>} */
const AUTHORIZATION = token === undefined ? {} : { Authorization: `Bearer ${token}` };

/** Requests JSON. Throws an Error with the service's reason if it refuses, or if it cannot be reached. */
export async function read(address) {
  const response = await fetch(address, { headers: AUTHORIZATION }).catch(() => {
    throw new Error(hasService ? "the service cannot be reached" : `${address} cannot be read`); // the browsers' own messages differ and say less
  });
  const body = await response.json().catch(() => ({}));
  if (!response.ok) throw new Error(body.message ?? `the server answered with status ${response.status}`);
  return body;
}

const SAMPLES = hasService ? "/v1/samples" : "samples/index.json";

/** The name, the person and the number of events of each movement of the embedded sample. @returns {Promise<{name: string, user: string, events: number}[]>} */
export const samples = async () => (await read(SAMPLES)).samples;

/**
 * A movement as columns.
 * @param {string} name
 * @returns {Promise<{user: string, target: import("../../lib/index.d.ts").Goal|null, dpi: number, cpi: number|null, t: number[], x: number[], y: number[],
 *   dx: (number|null)[], dy: (number|null)[], buttons: number[]}>} t in s from 0
 */
export const sample = (name) => read(hasService ? `/v1/samples/${encodeURIComponent(name)}` : `samples/${name}.json`);
