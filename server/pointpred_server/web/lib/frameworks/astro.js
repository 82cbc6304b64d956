// An integration for Astro: links with data-astro-prefetch are prefetched when the user is heading for them.

const OWN = ":is([data-astro-prefetch=''], [data-astro-prefetch='intent'])";
const ALL = ":is(:not([data-astro-prefetch]), [data-astro-prefetch=''], [data-astro-prefetch='intent'])";

/** What runs in each page. Astro's own `prefetch` loads, so that its router finds what was loaded. */
const script = (links, options) => `
import { prefetch } from "astro:prefetch";
import { onIntent } from "pointpred/intent";

let stops = [];
function begin() {
  for (const stop of stops) stop();
  stops = [...document.querySelectorAll(${JSON.stringify(links)})].map((link) =>
    onIntent(link, () => prefetch(link.href), ${JSON.stringify(options)}),
  );
}
begin();
document.addEventListener("astro:page-load", begin);
`;

/**
 * Prefetches links with `data-astro-prefetch`, or with `data-astro-prefetch="intent"`; with `prefetchAll` in Astro's own
 * options every link without another strategy.
 * @param {import("../index.d.ts").IntentOptions} [options] of `onIntent`
 * @returns {{name: string, hooks: Object<string, (setup: any) => void>}} an `AstroIntegration`
 */
export default function pointpred(options = {}) {
  return {
    name: "pointpred",
    hooks: {
      "astro:config:setup": ({ config, updateConfig, injectScript }) => {
        const links = `a[href]${config.prefetch?.prefetchAll ? ALL : OWN}`;
        updateConfig({ prefetch: { prefetchAll: false, defaultStrategy: "tap" } });
        injectScript("page", script(links, options));
      },
    },
  };
}
