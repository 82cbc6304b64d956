// Cards light up while the pointer is still on its way to them, and their pages are fetched once.
import { connect } from "../lib/pointpred.js";

const status = /** @type {HTMLElement} */ (document.getElementById("status"));
const connection = connect();
/** @type {NodeListOf<HTMLAnchorElement>} */
const cards = document.querySelectorAll("nav a");
for (const card of cards) connection.observe(card, card.pathname);

connection.on("choice", ({ element, action, reason }) => {
  const card = /** @type {HTMLAnchorElement} */ (element); // one of these
  card.classList.toggle("ahead", action === "propose");
  card.dataset.reason = reason ?? "";
  if (action === "retract" || card.dataset.fetched) return;
  card.dataset.fetched = "yes";
  fetch(card.href, { priority: "low" }).catch(() => delete card.dataset.fetched); // a prefetch link would need a policy that allows it
  status.textContent = `Prefetched: ${card.firstElementChild?.textContent}.`;
});
connection.on("error", ({ message }) => {
  status.textContent = message;
});
