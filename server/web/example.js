// Prefetches the page whose link the movement is heading for, while the mouse is still on its way.
import { connect } from "/pointpred.js";

const links = [...document.querySelectorAll("nav a")];
const connection = connect();
for (const link of links) connection.observe(link, link.pathname);

connection.on("prediction", ({ x, y, phase }) => {
  if (x === null || phase === "still") return; // nothing is known, or nothing moves
  const ahead = links.find((link) => {
    const { left, right, top, bottom } = link.getBoundingClientRect();
    return left <= x && x <= right && top <= y && y <= bottom;
  });
  if (ahead === undefined || ahead.dataset.fetched) return;
  ahead.dataset.fetched = "yes";
  fetch(ahead.href, { priority: "low" }).catch(() => delete ahead.dataset.fetched); // a link with rel=prefetch needs a policy that allows it
  document.getElementById("said").textContent = `Prefetched: ${ahead.textContent}.`;
});
