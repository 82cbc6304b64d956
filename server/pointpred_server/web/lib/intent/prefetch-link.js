// Loads the page behind a link when the user is heading for it.

import { needDocument } from "../client/document.js";

const loaded = new Set(); // addresses, so that each is loaded once
let speculates; // whether the browser has rules, and takes them; known from the first page that is loaded

/** A page whose Content Security Policy refuses inline scripts refuses the rules: links take over. */
function begin() {
  speculates = HTMLScriptElement.supports?.("speculationrules") ?? false;
  document.addEventListener("securitypolicyviolation", ({ effectiveDirective, blockedURI }) => {
    if (!speculates || blockedURI !== "inline" || !effectiveDirective.startsWith("script-src")) return;
    speculates = false;
    for (const address of loaded) addLink(address);
  });
}

/**
 * `prefetchLink` with this `onIntent`. It prefetches or prerenders the pages of links that the user is heading for: by Speculation Rules where the browser has them,
 * else by `<link rel=prefetch>`. Left out are links to other origins (unless `crossOrigin`), to this page itself, with
 * `download` or another `target`, and pages loaded before. A link that is added later, or whose address changes to one that may be loaded, needs another call.
 * @param {ReturnType<import("./register.js").onIntentWith>} onIntent
 * @returns {(links: Element|string, options?: import("../index.d.ts").PrefetchLinkOptions) => () => void} takes a link, or a selector of
 *   several; options of `onIntent`, and `action`, `crossOrigin`. What it returns stops it
 */
export const prefetchLinkWith = (onIntent) => (links, options) => prefetch(onIntent, links, options);

function prefetch(onIntent, links, { action = "prefetch", crossOrigin = false, ...options } = {}) {
  needDocument("prefetchLink");
  if (action !== "prefetch" && action !== "prerender")
    throw new TypeError(`action must be prefetch or prerender, received ${action}`);
  const found = typeof links === "string" ? [...document.querySelectorAll(links)] : [links];
  const stops = found.map((link) => {
    if (!(link instanceof HTMLAnchorElement)) throw new TypeError(`a link (<a href>) is needed, received ${link}`);
    return isLoadable(link, crossOrigin)
      ? onIntent(link, () => isLoadable(link, crossOrigin) && load(link.href, action), options)
      : () => {};
  });
  return () => stops.forEach((stop) => stop());
}

/** Whether a link leads to a page that may be loaded ahead. */
function isLoadable(link, crossOrigin) {
  const { href, origin, protocol, target } = link;
  const [page, here] = [href, location.href].map((url) => url.replace(/#.*/, ""));
  return (
    href !== "" &&
    /^https?:$/.test(protocol) &&
    (crossOrigin || origin === location.origin) &&
    page !== here &&
    (target === "" || target === "_self") &&
    !link.hasAttribute("download")
  );
}

/** Asks the browser to load a page, once. */
function load(url, action) {
  const address = url.replace(/#.*/, "");
  if (loaded.has(address)) return;
  loaded.add(address);
  if (speculates === undefined) begin();
  if (!speculates) return addLink(address);
  const rules = document.createElement("script");
  rules.type = "speculationrules";
  rules.textContent = JSON.stringify({ [action]: [{ source: "list", urls: [address], eagerness: "immediate" }] });
  document.head.append(rules);
}

function addLink(address) {
  document.head.append(Object.assign(document.createElement("link"), { rel: "prefetch", href: address }));
}
