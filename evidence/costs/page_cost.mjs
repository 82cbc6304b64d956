// The cost of a pipeline in V8, one event at a time: `node evidence/costs/page_cost.mjs`. The last column has 100 targets.

import { PREDICTORS } from "../../server/pointpred_server/web/lib/laws/registry.js";
import { build } from "../../server/pointpred_server/web/lib/prediction/build.js";
import { Chooser } from "../../server/pointpred_server/web/lib/prediction/chooser.js";

const RATE_HZ = 1000,
  REPEATS = 7,
  EVENTS = 5000;

/** Reaches of 0.6 s to and fro, on whole px, with a rest of 0.2 s after each. */
const rows = Array.from({ length: EVENTS }, (_, i) => {
  const t = i / RATE_HZ,
    number = Math.floor(t / 0.8),
    s = Math.min((t % 0.8) / 0.6, 1),
    way = 10 * s ** 3 - 15 * s ** 4 + 6 * s ** 5;
  const along = number % 2 ? 1 - way : way;
  return [t, Math.round(700 * along), Math.round(300 * along), NaN, NaN, 0];
});
const targets = Array.from({ length: 100 }, (_, i) => ({
  id: i,
  x: 80 * (i % 10),
  y: 50 * Math.floor(i / 10),
  width: 40,
  height: 30,
}));

/** The median of some repetitions, us an event. @param {() => (row: number[]) => void} make */
function cost(make) {
  const costs = [];
  for (let k = 0; k < REPEATS; k++) {
    const use = make(),
      began = performance.now();
    for (const row of rows) use(row);
    costs.push((1000 * (performance.now() - began)) / rows.length);
  }
  return costs.sort((one, other) => one - other)[REPEATS >> 1];
}

for (const name of Object.keys(PREDICTORS)) {
  const pattern = await build(name);
  const alone = cost(() => {
    const pipeline = pattern.fresh();
    return (row) => pipeline.advance(row);
  });
  const among = cost(() => {
    const pipeline = pattern.fresh();
    pipeline.register(targets);
    const chooser = new Chooser(pipeline);
    return (row) => {
      pipeline.advance(row);
      chooser.update();
    };
  });
  console.log(`${name.padEnd(22)}${alone.toFixed(2).padStart(8)}${among.toFixed(2).padStart(8)}`);
}
