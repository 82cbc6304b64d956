// Written by `make laws` from the registry: change that and run it again.
import { HomogeneousDifferentiator } from "../differentiators/homogeneous.js";
import { SwitchedPredictor } from "../predictors/switched.js";
export const REGISTRY = {
  GAINS: { gain_lambda: 48, gain_xi: 1.6, alpha: 0 },
  PREDICTORS: { "switched": { differentiator: "homogeneous", preset: { threshold: 0.08, bound: 1, delay_s: 0.011, gamma: 65000000 }, load: async () => SwitchedPredictor } },
  DIFFERENTIATORS: { "homogeneous": { load: async () => HomogeneousDifferentiator } },
};
