// What the service answers over HTTP.

/** The predictor shown first, unless the service recommends another. */
export const PREFERRED = "kinematic-adaptive";

/** The token in the page's own address, where the service asks for one: the address that it printed has it. */
export const token = new URLSearchParams(window.location.search).get("token") ?? undefined;

const SHOWN = token === undefined ? {} : { Authorization: `Bearer ${token}` };

/** Reads JSON; a refusal is an error with the service's own words, and `refusal` is all that the service said. */
export async function read(address, options = {}) {
  const headers = { ...SHOWN, ...options.headers };
  const answer = await fetch(address, { ...options, headers }).catch(() => {
    throw new Error("the service cannot be reached"); // the browser's own words differ and say less
  });
  const body = await answer.json().catch(() => ({}));
  if (!answer.ok) throw Object.assign(new Error(body.message ?? `the service answered ${answer.status}`), { refusal: body });
  return body;
}

let listed = null;

/** The predictors the service has, and which it recommends; asked once, again after a failure. */
export function predictors() {
  listed ??= read("/v1/predictors").then((listing) => ({ recommended: PREFERRED, ...listing })).catch((error) => {
    listed = null;
    throw error;
  });
  return listed;
}

const query = (told) => (Object.keys(told).length ? `?${new URLSearchParams(told)}` : "");

/**
 * The scores of a recording, as `pointpred score --json` prints them.
 * @param {string|Blob} body the samples file @param {object} told what is said of its columns
 */
export function score(body, told = {}) {
  return read(`/v1/score${query(told)}`, { method: "POST", headers: { "Content-Type": "text/csv" }, body });
}

/** The movements of a recording in any format. @param {Blob} body @param {object} told what is said of its columns */
export function recording(body, told = {}) {
  return read(`/v1/recording${query(told)}`, { method: "POST", headers: { "Content-Type": "text/csv" }, body });
}
