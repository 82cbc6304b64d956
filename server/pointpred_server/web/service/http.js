// Requests to the service over HTTP; a page without one reads files beside it.

import { hasService } from "./place.js";

/** The token in the page's own address, if the service asks for one. */
export const token = new URLSearchParams(window.location.search).get("token") ?? undefined;

const AUTHORIZATION = token === undefined ? {} : { Authorization: `Bearer ${token}` };

/** A request that the service has refused; `code`, `path` and `field` are those of the service. */
export class ServiceError extends Error {
  /** @param {object} body the error as the service describes it @param {number} status */
  constructor(body, status) {
    super(body.message ?? `the server answered with status ${status}`);
    this.code = body.code ?? "internal";
    this.path = body.path ?? null;
    this.field = body.field ?? null;
    this.body = body;
  }
}

/** Requests JSON. Throws a ServiceError if the service refuses, and an Error if it cannot be reached. */
export async function read(address, options = {}) {
  const headers = { ...AUTHORIZATION, ...options.headers };
  const response = await fetch(address, { ...options, headers }).catch(() => {
    throw new Error(hasService ? "the service cannot be reached" : `${address} cannot be read`); // the browsers' own messages differ and say less
  });
  const body = await response.json().catch(() => ({}));
  if (!response.ok) throw new ServiceError(body, response.status);
  return body;
}

/** Uploads a table of samples. @param {string|Blob} body @param {object} columns how to read it: the query of the request */
async function upload(address, body, columns) {
  const query = Object.keys(columns).length ? `?${new URLSearchParams(columns)}` : "";
  const leaving = new AbortController(); // browsers go on with the requests of a page that they keep for "back"
  const abort = () => leaving.abort();
  window.addEventListener("pagehide", abort);
  const options = { method: "POST", headers: { "Content-Type": "text/csv" }, body, signal: leaving.signal };
  return read(`${address}${query}`, options).finally(() => window.removeEventListener("pagehide", abort));
}

/** The scores of a recording, as `pointpred score --json` prints them. @param {string|Blob} body @param {object} columns */
export const score = (body, columns = {}) => upload("/v1/score", body, columns);

/** The movements of a recording in any format. @param {Blob} body @param {object} columns */
export const recording = (body, columns = {}) => upload("/v1/recording", body, columns);
