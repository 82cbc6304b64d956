// What the next presses of Tab reach.

const FOCUSABLE =
  "a[href], area[href], button, input, select, textarea, summary, iframe, audio[controls], video[controls], " +
  "[contenteditable]:not([contenteditable=false]), [tabindex]";
const SEEN = { visibilityProperty: true, contentVisibilityAuto: false };

/**
 * The elements that presses of Tab reach from one, in their order: first those with a positive tabindex, then the others as
 * they stand in the document. Shadow trees are not searched. Every radio button counts, although Tab reaches one of a group.
 * @param {Element|null} from the focused one @param {boolean} backwards with Shift @param {number} most presses
 * @returns {Element[]}
 */
export function reached(from, backwards, most) {
  const order = [.../** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll(FOCUSABLE))].filter(
    ({ tabIndex }) => tabIndex >= 0,
  );
  const rank = ({ tabIndex }) => tabIndex || Infinity;
  if (order.some(({ tabIndex }) => tabIndex > 0))
    order.sort((one, other) => (rank(one) === rank(other) ? 0 : rank(one) - rank(other)));
  if (backwards) order.reverse();
  const found = [];
  for (let i = order.indexOf(/** @type {HTMLElement} */ (from)) + 1; i < order.length && found.length < most; i += 1)
    if (isReachable(order[i])) found.push(order[i]);
  return found;
}

const isReachable = (element) =>
  !element.matches(":disabled") && !element.closest("[inert]") && (element.checkVisibility?.(SEEN) ?? true);
