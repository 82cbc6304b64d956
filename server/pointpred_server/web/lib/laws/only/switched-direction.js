// Written by `make laws` from the registry: change that and run it again.
import { HomogeneousDifferentiator } from "../differentiators/homogeneous.js";
import { SwitchedDirectionPredictor } from "../predictors/switched_direction.js";
export const REGISTRY = {
  GAINS: { gain_lambda: 48, gain_xi: 1.6, alpha: 0 },
  PREDICTORS: { "switched-direction": { differentiator: "homogeneous", preset: { gain_lambda: 100 }, load: async () => SwitchedDirectionPredictor } },
  DIFFERENTIATORS: { "homogeneous": { load: async () => HomogeneousDifferentiator } },
};
