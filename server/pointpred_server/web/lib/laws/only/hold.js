// Written by `make laws` from the registry: change that and run it again.
import { HomogeneousDifferentiator } from "../differentiators/homogeneous.js";
import { HoldPredictor } from "../predictors/hold.js";
import * as $homogeneous from "../differentiators/homogeneous.js";
import * as $hold from "../predictors/hold.js";
export const REGISTRY = {
  GAINS: { gain_lambda: 48, gain_xi: 1.6, alpha: 0 },
  PREDICTORS: { "hold": { differentiator: "homogeneous", load: async () => HoldPredictor } },
  DIFFERENTIATORS: { "homogeneous": { load: async () => HomogeneousDifferentiator } },
};
export const loadStages = () =>
  Promise.all([
    { step: $homogeneous.step, settings: [0, 0.0002645833333333333, 0.1, 0.3, 4, 0, 0.0015, 0, 0.04, 444.2880000000001, 67717.69344000003, 4192827.6049920022, 89060441.84985606], states: 34 },
    { step: $hold.step, settings: [], states: 9 },
  ]);
