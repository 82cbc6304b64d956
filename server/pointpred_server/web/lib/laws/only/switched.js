// Written by `make laws` from the registry: change that and run it again.
import { HomogeneousDifferentiator } from "../differentiators/homogeneous.js";
import { SwitchedPredictor } from "../predictors/switched.js";
import * as $homogeneous from "../differentiators/homogeneous.js";
import * as $switched from "../predictors/switched.js";
import * as $stage from "../stage.js";
export const REGISTRY = {
  GAINS: { gain_lambda: 48, gain_xi: 1.6, alpha: 0 },
  PREDICTORS: { "switched": { differentiator: "homogeneous", preset: { threshold: 0.08, bound: 1, delay_s: 0.011, gamma: 65000000 }, load: async () => SwitchedPredictor } },
  DIFFERENTIATORS: { "homogeneous": { load: async () => HomogeneousDifferentiator } },
};
export const loadStages = () =>
  Promise.all([
    { step: $homogeneous.step, fill: $homogeneous.fill, settle: $homogeneous.settle, settings: 17, learned: 0, states: 30, values: [0, 96, 0.1, 0.3, 4, 48, 1.6, 0, 0.0015] },
    { step: $switched.step, fill: $stage.copy_values, settings: 4, learned: 0, states: 1413, values: [0.08, 1, 0.011, 65000000] },
  ]);
