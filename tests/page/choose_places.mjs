// A chooser of places: steps are calls by name, with what they take.

import { PlaceChooser } from "../../server/web/prediction/chooser.js";
import { answer, attempt, given, numbers } from "./given.mjs";

const { settings, steps } = await given();
const chooser = new PlaceChooser(settings);
const calls = {
  update: (places, row, event) => chooser.update(places, row && numbers(row), numbers(event)),
  configure: (more) => chooser.configure(more) ?? null,
  finish: () => chooser.finish(),
  reset: () => chooser.reset() ?? null,
  proposed: () => [chooser.standing, chooser.entered],
  summary: () => chooser.ledger.summary,
};
const answers = [];
for (const [name, ...args] of steps) answers.push(await attempt(() => calls[name](...args)));
answer(answers);
