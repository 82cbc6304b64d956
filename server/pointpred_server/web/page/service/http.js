// Requests to the service over HTTP; a page without one reads files beside it.

import { hasService } from "./place.js";

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
