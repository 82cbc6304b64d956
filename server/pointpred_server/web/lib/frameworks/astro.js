// An integration for Astro: links with data-astro-prefetch are prefetched when the user is heading for them.

import { loadable } from "../intent/prefetch-link.js";

const OWN = ":is([data-astro-prefetch=''], [data-astro-prefetch='intent'])";
const ALL = ":is(:not([data-astro-prefetch]), [data-astro-prefetch=''], [data-astro-prefetch='intent'])";

/** The links of a page that a selector takes and `prefetchLink` would load, too. @param {string} selector @returns {HTMLAnchorElement[]} */
export const linksOf = (selector) =>
  [.../** @type {NodeListOf<HTMLAnchorElement>} */ (document.querySelectorAll(selector))].filter(
    (link) => loadable(link, { href: undefined, ignores: [], origins: [] }) !== null,
  );

/** An option as JSON has it: the only one that may be infinite is so by default. */
const written = (_, value) => (value === Infinity ? undefined : value);

/** What runs in each page. Astro's own `prefetch` loads, so that its router finds what was loaded. */
const script = (selector, options) => `
import { prefetch } from "astro:prefetch";
import { linksOf } from "pointpred/astro";
import { onIntent } from "pointpred/intent";

let stops = [];
function begin() {
  for (const stop of stops) stop();
  stops = linksOf(${JSON.stringify(selector)}).map((link) =>
    onIntent(link, () => prefetch(link.href), ${JSON.stringify(options, written)}),
  );
}
begin();
document.addEventListener("astro:page-load", begin);
`;

/**
 * Prefetches links with `data-astro-prefetch`, or with `data-astro-prefetch="intent"`; with `prefetchAll` in Astro's own
 * options every link without another strategy. Left out is what `prefetchLink` leaves out.
 * @param {Omit<import("../index.d.ts").IntentOptions, "enabled"|"onError"> & {enabled?: boolean}} [options] of `onIntent`
 * @returns {{name: string, hooks: Object<string, (setup: any) => void>}} an `AstroIntegration`
 */
export default function pointpred(options = {}) {
  return {
    name: "pointpred",
    hooks: {
      "astro:config:setup": ({ config, updateConfig, injectScript }) => {
        const selector = `a[href]${config.prefetch?.prefetchAll ? ALL : OWN}`;
        updateConfig({ prefetch: { prefetchAll: false, defaultStrategy: "tap" } });
        injectScript("page", script(selector, options));
      },
    },
  };
}
