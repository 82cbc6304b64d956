// Written by `make laws` from the registry: change that and run it again.
import { HomogeneousDifferentiator } from "../differentiators/homogeneous.js";
import { SwitchedPredictor } from "../predictors/switched.js";
import * as $homogeneous from "../differentiators/homogeneous.js";
import * as $switched from "../predictors/switched.js";
export const REGISTRY = {
  GAINS: { gain_lambda: 48, gain_xi: 1.6, alpha: 0 },
  PREDICTORS: { "switched-printed": { differentiator: "homogeneous", preset: { gain_lambda: 5, gain_xi: 2, alpha: -0.2, threshold: 0.2, bound: 0.1 }, load: async () => SwitchedPredictor } },
  DIFFERENTIATORS: { "homogeneous": { load: async () => HomogeneousDifferentiator } },
};
export const loadStages = () =>
  Promise.all([
    { step: $homogeneous.step, settings: [0, 0.0002645833333333333, 0.1, 0.3, 4, -0.2, 0.0015, 0, 0.045, 75, 1750, 15000, 40000], states: 34 },
    { step: $switched.step, settings: [0.2, 0.1, 0.1, 10000], states: 1413 },
  ]);
