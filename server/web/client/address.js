// Where the service is, and why it refused a connection before it was open.

/**
 * The stream's address: `http` becomes `ws`, a bare address gets the usual path.
 * @param {string|URL|undefined} url where this module came from unless given @param {string} [token]
 */
export function address(url, token) {
  const found = new URL(url ?? "/v1/stream", url === undefined ? import.meta.url : document.baseURI);
  found.protocol = found.protocol.replace("http", "ws");
  if (found.pathname === "/") found.pathname = "/v1/stream";
  if (token) found.searchParams.set("token", token);
  return found.href;
}

/**
 * What to say in the console of a connection that never was; the token is left out.
 * @param {string} stream @param {string|null} refused why the service refuses the page, where it does
 */
export function unconnected(stream, refused) {
  const { origin, pathname } = new URL(stream);
  const plain = `pointpred is not connected (${origin}${pathname}): targets are proposed only when the pointer enters them.`;
  return refused === null ? plain : `${plain} ${refused}`;
}

/** Whether a page came from the service at this address. @param {string} stream */
export const own = (stream) => new URL(stream).host === location.host;

/**
 * Asks the service whether pages of this origin may connect: a browser hides from a page why a connection was refused.
 * @param {string} stream
 * @returns {Promise<string|null>} what to do about it where they may not; null: they may, or nobody answers
 */
export async function refusal(stream) {
  const url = new URL("/v1/origin", stream.replace(/^ws/, "http"));
  try {
    const answer = await fetch(url, { cache: "no-store", credentials: "omit", signal: AbortSignal.timeout(5000) });
    const { allowed, message } = await answer.json();
    return allowed === false ? String(message) : null;
  } catch {
    return null;
  }
}
