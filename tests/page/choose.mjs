// A chooser: steps are calls by name, with what they take.

import { Chooser } from "../../server/pointpred_server/web/prediction/chooser.js";
import { answer, attempt, given, numbers } from "./given.mjs";

const { targets, settings, steps } = await given();
const chooser = new Chooser(targets, settings);
const calls = {
  update: (row, event) => chooser.update(row && numbers(row), numbers(event)),
  expect: (places) => chooser.expect(places) ?? null,
  replace: (list) => chooser.replace(list),
  configure: (more) => chooser.configure(more) ?? null,
  finish: (id) => chooser.finish(id),
  reset: () => chooser.reset() ?? null,
  shares: () => [...chooser.shares],
  likeliest: (most) => chooser.likeliest(most),
  headingTo: (target, elsewhere) => chooser.headingTo(target, elsewhere),
  proposed: () => [chooser.standing, chooser.entered],
  summary: () => chooser.ledger.summary,
};
const answers = [];
for (const [name, ...args] of steps) answers.push(await attempt(() => calls[name](...args)));
answer(answers);
