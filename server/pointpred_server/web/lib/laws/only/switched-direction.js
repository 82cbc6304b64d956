// Written by `make laws` from the registry: change that and run it again.
import { HomogeneousDifferentiator } from "../differentiators/homogeneous.js";
import { SwitchedDirectionPredictor } from "../predictors/switched_direction.js";
import * as $homogeneous from "../differentiators/homogeneous.js";
import * as $switched_direction from "../predictors/switched_direction.js";
export const REGISTRY = {
  GAINS: { gain_lambda: 48, gain_xi: 1.6, alpha: 0 },
  PREDICTORS: { "switched-direction": { differentiator: "homogeneous", preset: { gain_lambda: 100 }, load: async () => SwitchedDirectionPredictor } },
  DIFFERENTIATORS: { "homogeneous": { load: async () => HomogeneousDifferentiator } },
};
export const loadStages = () =>
  Promise.all([
    { step: $homogeneous.step, settings: [0, 0.0002645833333333333, 0.1, 0.3, 4, 0, 0.0015, 0, 0.03, 925.6000000000001, 293913.60000000003, 37912576.000000015, 1677721600.0000007], states: 34 },
    { step: $switched_direction.step, settings: [0.6, 0.045, 0.4, 0.6, 0.65, 0.5], states: 23 },
  ]);
