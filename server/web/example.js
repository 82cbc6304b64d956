// Prefetches the page whose link the movement is heading for, while the mouse is still on its way; it lights up meanwhile.
import { connect } from "/pointpred.js";

const said = document.getElementById("said");
const connection = connect();
connection.configure({ precision: 0.6 }); // a page fetched in vain costs little
for (const link of document.querySelectorAll("nav a")) connection.observe(link, link.pathname);

connection.on("choice", ({ element: link, action }) => {
  link?.classList.toggle("ahead", action === "propose");
  if (link === undefined || action === "retract" || link.dataset.fetched) return;
  link.dataset.fetched = "yes";
  fetch(link.href, { priority: "low" }).catch(() => delete link.dataset.fetched); // a link with rel=prefetch needs a policy that allows it
  said.textContent = `Prefetched: ${link.textContent}.`;
});
