// Asks the browser for pages ahead: by Speculation Rules where they are allowed, else by <link rel=prefetch>.

const FRESH_MS = 300000; // the browser forgets a page so long after it was loaded
const MOST_PAGES = 1000; // beyond, those that the browser was not asked for lately are forgotten
const MOST = { prefetch: 40, prerender: 8, link: 40 }; // at a time: Chromium takes rules for no more than 50 and 10 pages
const AT_ONCE = 2; // links being loaded; rules are queued by the browser itself
const LOST_MS = 30000; // after so long a link that tells nothing counts as loaded: the page may have removed it
const POLICY = "pointpred"; // of Trusted Types
const RULES = { createScript: (text) => text };

/** @typedef {{address: string, askedAt: number}} Page */

/** @type {Map<string, Page>} */
const pages = new Map();
const added = { prefetch: [], prerender: [], link: [] }; // to the head: what asks for which page
/** @type {Page[]} */
const waiting = [];
let loading = 0;
let isRefused = false; // the page's policy does not allow link elements to load
let policed; // whether the page has a Content Security Policy; undefined while nobody has asked
let scripts; // what makes the texts of scripts under Trusted Types; null where the page's policy refuses its name

/** The page at an address, the same object as long as the browser has it. @param {string} address @returns {Page} */
export function pageOf(address) {
  if (pages.size >= MOST_PAGES && !pages.has(address))
    for (const [other, page] of pages) if (!isAsked(page)) pages.delete(other);
  if (!pages.has(address)) pages.set(address, { address, askedAt: -Infinity });
  return /** @type {Page} */ (pages.get(address));
}

/** Whether the browser was asked for a page lately, so that it still has it. @param {Page} page */
export const isAsked = ({ askedAt }) => performance.now() - askedAt < FRESH_MS;

/**
 * Asks the browser to load a page.
 * @param {Page} page @param {"prefetch"|"prerender"} action @param {string|undefined} nonce of the page's policy
 */
export function ask(page, action, nonce) {
  if (takesRules(nonce)) addRule(page, action, nonce);
  else {
    waiting.push(page);
    loadNext();
  }
  page.askedAt = performance.now();
}

/** Whether the browser can be asked at all. @param {string|undefined} nonce */
export const canAsk = (nonce) =>
  (!isRefused && document.createElement("link").relList.supports("prefetch")) || takesRules(nonce);

/** Whether rules may be added; to try would be reported as a violation where they are refused. */
function takesRules(nonce) {
  if (!globalThis.HTMLScriptElement?.supports?.("speculationrules")) return false;
  if (nonce === undefined) return !hasPolicy();
  if (scripts === undefined)
    try {
      scripts = globalThis.trustedTypes?.createPolicy(POLICY, RULES) ?? RULES;
    } catch {
      scripts = null; // to try again would be reported again
    }
  return scripts !== null;
}

/** A browser hides a nonce from the page's own code where a policy came with the page's headers. */
function hasPolicy() {
  if (policed !== undefined) return policed;
  const probe = document.createElement("link");
  probe.setAttribute("nonce", POLICY);
  document.head.append(probe);
  const isHidden = probe.getAttribute("nonce") !== POLICY;
  probe.remove();
  policed = isHidden || document.querySelector('meta[http-equiv="Content-Security-Policy" i]') !== null;
  return policed;
}

/** Adds an element to the head. One that is spent makes room: pages of rules that stay count towards the browser's limit. */
function add(kind, page, element) {
  const old = added[kind];
  while (old.length >= MOST[kind] || (old.length && !isAsked(old[0].page))) old.shift().element.remove();
  document.head.append(element);
  old.push({ page, element });
}

function addRule(page, action, nonce) {
  const script = document.createElement("script"),
    list = [{ source: "list", urls: [page.address], eagerness: "immediate" }],
    text = JSON.stringify({ [action]: list });
  script.type = "speculationrules";
  if (nonce) script.nonce = nonce;
  script.text = scripts ? scripts.createScript(text) : text;
  add(action, page, script);
}

function loadNext() {
  if (loading >= AT_ONCE || waiting.length === 0) return;
  const page = /** @type {Page} */ (waiting.shift()),
    link = document.createElement("link");
  let timer = 0;
  const refuse = ({ blockedURI, disposition }) => {
    isRefused ||= blockedURI === page.address && disposition === "enforce"; // each further one would be reported, too
  };
  const end = () => {
    document.removeEventListener("securitypolicyviolation", refuse);
    clearTimeout(timer);
    link.onload = link.onerror = null;
    loading -= 1;
    loadNext();
  };
  document.addEventListener("securitypolicyviolation", refuse);
  loading += 1;
  link.rel = "prefetch";
  link.href = page.address;
  link.onload = end;
  link.onerror = () => {
    pages.set(page.address, { ...page }); // another page to the ledger: its use is no hit
    end();
  };
  timer = setTimeout(end, LOST_MS);
  add("link", page, link);
}
