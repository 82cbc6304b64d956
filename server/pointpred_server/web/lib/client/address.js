// The address of the service, and why it refused a connection before it was open.

/**
 * The address of a WebSocket: `http` becomes `ws`, and an address without a path gets the path of the stream.
 * @param {string|URL|undefined} url the service that this module came from unless given @param {string} [token]
 */
export function socketAddress(url, token) {
  const address = new URL(url ?? "/v1/stream", url === undefined ? import.meta.url : document.baseURI);
  address.protocol = address.protocol.replace("http", "ws");
  if (address.pathname === "/") address.pathname = "/v1/stream";
  if (token) address.searchParams.set("token", token);
  return address.href;
}

/**
 * The console's warning about a connection that never opened; the token is left out.
 * @param {string} stream its address @param {string|null} refusal why the service refuses the page, if it does
 */
export function warningFor(stream, refusal) {
  const { origin, pathname } = new URL(stream);
  const plain = `pointpred is not connected (${origin}${pathname}): targets are proposed only when the pointer enters them.`;
  return refusal === null ? plain : `${plain} ${refusal}`;
}

/** Whether this page came from the service at an address. @param {string} stream */
export const isOwn = (stream) => new URL(stream).host === location.host;

/**
 * Asks the service whether pages of this origin may connect: a browser does not tell a page why a WebSocket was refused.
 * @param {string} stream its address
 * @returns {Promise<string|null>} the service's advice if they may not; null if they may, or if nothing answers
 */
export async function findRefusal(stream) {
  const url = new URL("/v1/origin", stream.replace(/^ws/, "http"));
  try {
    const response = await fetch(url, { cache: "no-store", credentials: "omit", signal: AbortSignal.timeout(5000) });
    const { allowed, message } = await response.json();
    return allowed === false ? String(message) : null;
  } catch {
    return null;
  }
}
