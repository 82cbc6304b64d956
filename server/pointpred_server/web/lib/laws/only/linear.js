// Written by `make laws` from the registry: change that and run it again.
import { HomogeneousDifferentiator } from "../differentiators/homogeneous.js";
import { LinearPredictor } from "../predictors/linear.js";
import * as $homogeneous from "../differentiators/homogeneous.js";
import * as $linear from "../predictors/linear.js";
import * as $stage from "../stage.js";
export const REGISTRY = {
  GAINS: { gain_lambda: 48, gain_xi: 1.6, alpha: 0 },
  PREDICTORS: { "linear": { differentiator: "homogeneous", load: async () => LinearPredictor } },
  DIFFERENTIATORS: { "homogeneous": { load: async () => HomogeneousDifferentiator } },
};
export const loadStages = () =>
  Promise.all([
    { step: $homogeneous.step, fill: $homogeneous.fill, settle: $homogeneous.settle, settings: 17, learned: 0, states: 30, values: [0, 96, 0.1, 0.3, 4, 48, 1.6, 0, 0.0015] },
    { step: $linear.step, fill: $stage.copy_values, settings: 2, learned: 0, states: 34, values: [0.12, 0.12] },
  ]);
