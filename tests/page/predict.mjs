// A pipeline by its name: steps are rows of events, "reset", "fresh", "forget", "person", "places" and {enter: [key, x, y]}.

import { build } from "../../server/pointpred_server/web/lib/prediction/build.js";
import { answer, attempt, given, numbers } from "./given.mjs";

const { name, options, steps } = await given();
answer(
  await attempt(async () => {
    let pipeline = await build(name, options);
    return steps.map((step) => {
      if (step === "person") return pipeline.person;
      if (step === "reset") return pipeline.reset() ?? null;
      if (step === "fresh") return (pipeline = pipeline.fresh()) && null;
      if (step === "forget") return pipeline.forget() ?? null;
      if (step === "places") return pipeline.places;
      if (step.enter) return pipeline.enter(...step.enter) ?? null;
      return [...pipeline.advance(numbers(step))];
    });
  }),
);
