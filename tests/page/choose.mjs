// A pipeline and its chooser, of places or of targets: steps are calls by name, with what they take.

import { build } from "../../server/pointpred_server/web/lib/prediction/build.js";
import { Chooser, PlaceChooser } from "../../server/pointpred_server/web/lib/prediction/chooser.js";
import { Mixture } from "../../server/pointpred_server/web/lib/prediction/mixture.js";
import { answer, attempt, given, numbers } from "./given.mjs";

/** Where the account begins. */
const TOTALS = ["movements", "proposed", "right", "hit", "wasted", "retracted", "entered"];

const { name, targets, settings, steps } = await given();
const pipeline = await build(name, { targets: targets ?? [] });
const chooser = new (targets ? Chooser : PlaceChooser)(pipeline, settings);
const calls = {
  update: (event) => {
    const [t] = pipeline.advance(numbers(event));
    return t === t ? chooser.update() : null;
  },
  register: (listed) => {
    pipeline.register(listed);
    return chooser.followTargets();
  },
  finish: (...id) => chooser.finish(...id),
  configure: (more) => chooser.configure(more),
  reset: () => {
    pipeline.reset();
    chooser.reset();
  },
  shares: () => Array.from(pipeline.shares),
  likeliest: (most) => pipeline.aim.likeliest(most),
  mixture: () => pipeline.mixture && { parts: pipeline.mixture.parts, offsets: pipeline.mixture.offsets },
  outlines: (parts, level) =>
    new Mixture(
      parts.map((part) => Float64Array.from(part)),
      [0, 0],
    ).outlines(level),
  proposed: () => [chooser.standing, chooser.entered],
  person: () => pipeline.person,
  summary: () => Object.fromEntries(TOTALS.map((name, i) => [name, chooser.ledger.account[i]])),
};
const answers = [];
for (const [call, ...args] of steps) answers.push(await attempt(() => calls[call](...args) ?? null));
answer(answers);
