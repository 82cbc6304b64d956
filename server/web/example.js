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
  if (ahead === undefined || document.head.querySelector(`link[rel="prefetch"][href="${ahead.pathname}"]`)) return;
  document.head.append(Object.assign(document.createElement("link"), { rel: "prefetch", href: ahead.pathname }));
  document.getElementById("said").textContent = `Prefetched: ${ahead.textContent}.`;
});
