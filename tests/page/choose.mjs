// A chooser, of places where no targets are given: steps are calls by name, with what they take.

import { Chooser, PlaceChooser } from "../../server/pointpred_server/web/prediction/chooser.js";
import { answer, attempt, given, numbers } from "./given.mjs";

const { targets, settings, steps } = await given();
const chooser = targets ? new Chooser(targets, settings) : new PlaceChooser(settings);
const calls = {
  update: (...taken) => {
    const [row, event] = taken.splice(-2);
    return chooser.update(...taken, row && numbers(row), numbers(event));
  },
  shares: () => [...chooser.shares],
  proposed: () => [chooser.standing, chooser.entered],
  summary: () => chooser.ledger.summary,
};
const answers = [];
for (const [name, ...args] of steps) answers.push(await attempt(() => (calls[name] ?? ((...taken) => chooser[name](...taken)))(...args) ?? null));
answer(answers);
