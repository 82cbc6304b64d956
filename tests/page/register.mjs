// What a pipeline says to targets that cannot be used, by what is wrong; and which it has afterwards.

import { build } from "../../server/pointpred_server/web/lib/prediction/build.js";
import { answer, attempt } from "./given.mjs";

const one = { id: "a", x: 0, y: 0, width: 10, height: 10 };
const wrong = {
  "no list": 7,
  "null for a list": null,
  "a text for a list": "abc",
  "a set": new Set([one]),
  "no object": [3],
  "null for an object": [null],
  "nothing but holes": Array(3),
  "a hole": Object.assign([], { 0: one, 2: { ...one, id: "b" } }),
  "no id": [{ ...one, id: undefined }],
  "the id null": [{ ...one, id: null }],
  "the id NaN": [{ ...one, id: NaN }],
  "an id twice": [one, { ...one, x: 50 }],
  "too many": Array.from({ length: 1001 }, (_, id) => ({ ...one, id })),
};
for (const field of ["x", "y", "width", "height", "weight"])
  for (const value of ["1", null, true, [1], NaN, Infinity, -2e9])
    wrong[`${field} ${JSON.stringify([value])} ${value}`] = [{ ...one, [field]: value }];
for (const field of ["width", "height"]) wrong[`${field} 0`] = [{ ...one, [field]: 0 }];
const pipeline = await build("hold", { targets: [{ ...one, id: "before" }] });
const told = {};
for (const [name, targets] of Object.entries(wrong))
  told[name] = [
    await attempt(() => pipeline.register(targets) ?? null),
    await attempt(() => build("hold", { targets }).then(() => null)),
  ];
try {
  pipeline.register([{ ...one, id: Object.create(null) }]);
} catch {} // no text names it
answer({ told, left: [...pipeline.shares.keys()] });
