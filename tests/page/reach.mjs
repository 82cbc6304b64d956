// Moves the page package's simulated hands, and writes what their mice report.
import { readFileSync } from "node:fs";
import { Hand } from "../../server/pointpred_server/web/lib/human/hand.js";

const { hands, boxes } = JSON.parse(readFileSync(0, "utf8"));
const answers = hands.map(({ seed, skill, at }) => {
  const hand = new Hand(seed, skill, at);
  return boxes.map(({ box, clicks }) => hand.reach(box, clicks).map(({ t, x, y, pressed }) => [t, x, y, pressed]));
});
console.log(JSON.stringify(answers));
