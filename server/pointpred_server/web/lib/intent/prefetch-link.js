// Loads the pages behind links when the user is heading for them.

import { needDocument } from "../client/document.js";
import { attempt } from "./firing-ledger.js";
import { ask, canAsk, isAsked, pageOf } from "./pages.js";
import { canFollow, listOf, named } from "./register.js";

const DWELL_S = 0.065; // what the pointer only crosses is not loaded
const WATCH_MS = 100; // so long after a change of the page its links are looked for again

/** A part of an address that ends a session or changes something, although a GET should do neither: alone, or with one more word. */
const UNSAFE =
  /(?<![\w-])(?:[a-z\d]+[-_])?(?:(?:log|sign)[-_/]?(?:out|off)|end[-_]?session|exit|delete|remove|rollback|trash|unsubscribe)(?:[-_][a-z\d]+)?(?![\w-])/i;
/** What changes a cart. */
const CART = /cart|basket|wishlist/i;
const CHANGES =
  /(?<![a-z])(?:add|change|clear|delete|empty|remove|trash|update)(?:to|from)?(?:[^a-z]|$|(?=cart|basket|wishlist))/i;
const IS_ADDRESS = /^\/|:\/\//; // such as next=/logout
const NO_GET = ["data-method", "data-turbo-method"]; // what some frameworks ask with instead

/** @typedef {ReturnType<typeof import("./register.js").onIntentWith>} OnIntent */

/**
 * `prefetchLink` with this `onIntent`. It prefetches or prerenders the pages of links that the user is heading for: by Speculation
 * Rules where the browser has them and may use them, else by `<link rel=prefetch>`. Left out are links to other origins, to this
 * page itself, with `download` or another `target`, in an element with `data-no-prefetch`, with an address that looks as if it
 * logged out or changed something, and to pages loaded in the last five minutes. Throws a TypeError or a RangeError for links and
 * options that cannot be used; then none is registered.
 * @param {OnIntent} onIntent
 * @returns {(links: Element|Iterable<Element>|string, options?: import("../index.d.ts").PrefetchLinkOptions) => () => void} takes links or a
 *   selector, and options of `onIntent` besides its own. What it returns stops it
 */
export const prefetchLinkWith = (onIntent) => (links, options) => prefetch(onIntent, links, options);

/** @param {OnIntent} onIntent @param {Element|Iterable<Element>|string} links @param {import("../index.d.ts").PrefetchLinkOptions} [given] */
function prefetch(onIntent, links, given = {}) {
  needDocument("prefetchLink");
  if (Object(given) !== given) throw new TypeError(`options must be an object, received ${given}`);
  const { action = "prefetch", limit = Infinity, nonce, watch = false, ...more } = given;
  const { href, ignore = [], origins = [], dwell_s = DWELL_S, ...others } = more,
    options = { ...others, dwell_s };
  const rules = { href, ignores: [ignore].flat(), origins: [origins].flat().map(originOf) };
  check(links, { action, limit, watch, ...others, ...rules });
  const { enabled = true, onError } = options;
  const fail = onError && ((error) => onError(error, null));
  const registered = new Map(); // what stops it, by link
  const pageFor = (link) => {
    const address = attempt(() => loadable(link, rules), fail) ?? null;
    return address === null ? null : pageOf(address);
  };
  let left = limit;
  const load = ({ element }) => {
    const page = pageFor(element);
    if (page === null) return; // it was there a moment ago
    left -= 1;
    ask(page, action, nonce);
  };
  const isOn = (link) => {
    const page = pageFor(link);
    return (
      left > 0 &&
      page !== null &&
      !isAsked(page) &&
      canAsk(nonce) &&
      (typeof enabled === "function" ? enabled(link) : enabled)
    );
  };
  const add = (found) => {
    for (const one of found)
      if (!(href ? one instanceof Element : isLink(one)))
        throw new TypeError(`a link (<a href> or <area href>) is needed, received ${named(one)}`);
    onIntent([], load, options); // checks them
    if (!(canFollow() && canAsk(nonce))) return;
    for (const one of found) {
      const page = registered.has(one) ? null : pageFor(one);
      if (page === null) continue;
      const name = options.name || one.id || new URL(page.address).pathname;
      registered.set(
        one,
        onIntent(one, load, { ...options, name, enabled: isOn }, (link) => pageFor(link) ?? link),
      );
    }
  };
  add(typeof links === "string" ? [...document.querySelectorAll(links)] : listOf(links));
  const unwatch = watch && canFollow() ? watchLinks(links, registered, add) : () => {};
  return () => {
    unwatch();
    for (const stop of registered.values()) stop();
  };
}

/** Throws a TypeError or a RangeError for an option that cannot be used. @param {unknown} links @param {any} options */
function check(links, { action, limit, watch, policy, href, ignores }) {
  if (policy !== undefined) throw new TypeError(`prefetchLink takes no policy, received ${policy}`);
  if (action !== "prefetch" && action !== "prerender")
    throw new TypeError(`action must be prefetch or prerender, received ${action}`);
  if (!(typeof limit === "number" && limit >= 1))
    throw new RangeError(`limit must be a number from 1 on, received ${limit}`);
  if (watch && typeof links !== "string") throw new TypeError(`watch needs a selector, received ${links}`);
  if (href !== undefined && typeof href !== "function")
    throw new TypeError(`href must be a function, received ${href}`);
  for (const one of ignores)
    if (typeof one !== "function" && !(one instanceof RegExp))
      throw new TypeError(`ignore must be a RegExp, a function or a list of these, received ${one}`);
}

/** The origin of an address; `"*"` stays. Throws a TypeError for what has none. @param {string} given */
function originOf(given) {
  const origin = given === "*" ? given : parsed(given)?.origin;
  if (origin === undefined || origin === "null")
    throw new TypeError(`origins must be "*" or such as "https://shop.example", received ${given}`);
  return origin;
}

/** Registers links of a selector that are added later, and stops those that have gone. @returns {() => void} stops it */
function watchLinks(selector, registered, add) {
  let timer = 0;
  const update = () => {
    timer = 0;
    const found = new Set(document.querySelectorAll(selector));
    for (const [link, stop] of registered)
      if (!found.has(link)) {
        stop();
        registered.delete(link);
      }
    attempt(() => add([...found]));
  };
  const observer = new MutationObserver(() => {
    timer ||= setTimeout(update, WATCH_MS);
  });
  observer.observe(document, { subtree: true, childList: true, attributeFilter: ["href", "class"] });
  return () => {
    observer.disconnect();
    clearTimeout(timer);
  };
}

/** Where a link opens its page: what it says itself, else what the page says of all links. @param {Element} link */
function targetOf(link) {
  const bases = isLink(link) ? [...document.getElementsByTagName("base")] : [];
  return [link, ...bases].map((one) => one.getAttribute("target")).find((target) => target !== null) ?? "";
}

/** Whether a GET may end a session or change something, by the words of its path and of the keys and values of its query. @param {URL} url */
function isUnsafe({ pathname, searchParams }) {
  const words = [pathname, ...[...searchParams].flat().filter((one) => !IS_ADDRESS.test(one))].join("/");
  return UNSAFE.test(words) || (CART.test(words) && CHANGES.test(words));
}

/** An address, null if it is none. @param {string|URL} address @param {string} [base] */
function parsed(address, base) {
  try {
    return new URL(address, base);
  } catch {
    return null;
  }
}

const isLink = (one) => one instanceof Element && (one.localName === "a" || one.localName === "area");

/** The address of the page behind a link without its fragment; null if it shall not be loaded ahead. */
export function loadable(link, { href, ignores, origins }) {
  const given = href ? href(link) : (link.href?.baseVal ?? link.href);
  if (!given) return null;
  const url = parsed(given, document.baseURI);
  if (url === null) return null;
  url.hash = "";
  const isLoaded =
    /^https?:$/.test(url.protocol) &&
    (url.origin === location.origin || origins.includes("*") || origins.includes(url.origin)) &&
    url.href !== location.href.replace(/#.*/, "") &&
    ["", "_self"].includes(targetOf(link)) &&
    !link.hasAttribute("download") &&
    !link.closest("[data-no-prefetch]") &&
    !(url.username || url.password) &&
    NO_GET.every((name) => /^(get)?$/i.test(link.getAttribute(name) ?? "")) &&
    !isUnsafe(url) &&
    !ignores.some((one) => (one instanceof RegExp ? url.href.search(one) >= 0 : one(link, url)));
  return isLoaded ? url.href : null;
}
