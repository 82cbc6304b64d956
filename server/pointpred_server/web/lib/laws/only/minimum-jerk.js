// Written by `make laws` from the registry: change that and run it again.
import { HomogeneousDifferentiator } from "../differentiators/homogeneous.js";
import { MinimumJerkPredictor } from "../predictors/minimum_jerk.js";
import * as $homogeneous from "../differentiators/homogeneous.js";
import * as $minimum_jerk from "../predictors/minimum_jerk.js";
import * as $stage from "../stage.js";
export const REGISTRY = {
  GAINS: { gain_lambda: 48, gain_xi: 1.6, alpha: 0 },
  PREDICTORS: { "minimum-jerk": { differentiator: "homogeneous", load: async () => MinimumJerkPredictor } },
  DIFFERENTIATORS: { "homogeneous": { load: async () => HomogeneousDifferentiator } },
};
export const loadStages = () =>
  Promise.all([
    { step: $homogeneous.step, fill: $homogeneous.fill, settle: $homogeneous.settle, settings: 17, learned: 0, states: 30, values: [0, 96, 0.1, 0.3, 4, 48, 1.6, 0, 0.0015] },
    { step: $minimum_jerk.step, fill: $stage.copy_values, settings: 0, learned: 0, states: 9, values: [] },
  ]);
