// Tabs after the ARIA pattern: arrow keys, Home and End, one tab stop; the address names the open tab.

import { part } from "./elements.js";

/**
 * Makes the buttons of a tab list work.
 * @param {HTMLElement} list the element with role "tablist"; each tab's aria-controls names its panel
 * @param {(name: string, before: string | null) => void} onOpen is called after a tab was opened, also the first one
 */
export function makeTabs(list, onOpen) {
  const all = [.../** @type {NodeListOf<HTMLElement>} */ (list.querySelectorAll("[role=tab]"))];
  const name = (tab) => tab.dataset.view;
  /** @type {string|null} */
  let open = null;

  function show(tab) {
    if (name(tab) === open) return;
    const before = open;
    open = name(tab);
    for (const each of all) {
      const selected = each === tab;
      each.setAttribute("aria-selected", String(selected));
      each.tabIndex = selected ? 0 : -1;
      part(String(each.getAttribute("aria-controls"))).hidden = !selected;
    }
    onOpen(name(tab), before);
  }

  function select(tab) {
    if (window.location.hash !== `#${name(tab)}`) window.history.pushState(null, "", `#${name(tab)}`);
    show(tab);
  }

  const addressed = () => all.find((tab) => `#${name(tab)}` === window.location.hash) ?? all[0];

  for (const tab of all) tab.addEventListener("click", () => select(tab));
  list.addEventListener("keydown", (event) => {
    const at = all.indexOf(/** @type {HTMLElement} */ (document.activeElement));
    const to = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: all.length - 1 }[event.key];
    if (at < 0 || to === undefined) return;
    event.preventDefault();
    const tab = all[(to + all.length) % all.length];
    tab.focus();
    select(tab);
  });
  for (const kind of ["hashchange", "popstate"]) window.addEventListener(kind, () => show(addressed()));
  show(addressed());
}
