// Written by `make laws` from the registry: change that and run it again.
import { HomogeneousDifferentiator } from "../differentiators/homogeneous.js";
import { SwitchedPredictor } from "../predictors/switched.js";
export const REGISTRY = {
  GAINS: { gain_lambda: 48, gain_xi: 1.6, alpha: 0 },
  PREDICTORS: { "switched-printed": { differentiator: "homogeneous", preset: { gain_lambda: 5, gain_xi: 2, alpha: -0.2, threshold: 0.2, bound: 0.1 }, load: async () => SwitchedPredictor } },
  DIFFERENTIATORS: { "homogeneous": { load: async () => HomogeneousDifferentiator } },
};
