// Written by `make laws` from the registry: change that and run it again.
import { HomogeneousDifferentiator } from "../differentiators/homogeneous.js";
import * as $homogeneous from "../differentiators/homogeneous.js";
export const REGISTRY = {
  GAINS: { gain_lambda: 48, gain_xi: 1.6, alpha: 0 },
  PREDICTORS: { "kinematic-adaptive": { differentiator: "homogeneous", load: () => import("../predictors/adaptation/predictor.js").then((one) => one.AdaptiveKinematicPredictor), coefficients: () => import("../kinematic.js").then((one) => one.COEFFICIENTS) } },
  DIFFERENTIATORS: { "homogeneous": { load: async () => HomogeneousDifferentiator } },
};
export const loadStages = () =>
  Promise.all([
    { step: $homogeneous.step, fill: $homogeneous.fill, settle: $homogeneous.settle, settings: 17, learned: 0, states: 30, values: [0, 96, 0.1, 0.3, 4, 48, 1.6, 0, 0.0015] },
    Promise.all([import("../predictors/adaptation/predictor.js"), import("../kinematic.js")]).then(([{ AdaptiveKinematicPredictor }, { COEFFICIENTS }]) => ({ ...AdaptiveKinematicPredictor, coefficients: COEFFICIENTS, values: [1, 1, 10, 1, 1] })),
  ]);
