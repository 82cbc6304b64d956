// Written by `make laws` from the registry: change that and run it again.
import { HomogeneousDifferentiator } from "../differentiators/homogeneous.js";
import { SwitchedDirectionPredictor } from "../predictors/switched_direction.js";
import * as $homogeneous from "../differentiators/homogeneous.js";
import * as $switched_direction from "../predictors/switched_direction.js";
import * as $stage from "../stage.js";
export const REGISTRY = {
  GAINS: { gain_lambda: 48, gain_xi: 1.6, alpha: 0 },
  PREDICTORS: { "switched-direction": { differentiator: "homogeneous", preset: { gain_lambda: 100 }, load: async () => SwitchedDirectionPredictor } },
  DIFFERENTIATORS: { "homogeneous": { load: async () => HomogeneousDifferentiator } },
};
export const loadStages = () =>
  Promise.all([
    { step: $homogeneous.step, fill: $homogeneous.fill, settle: $homogeneous.settle, settings: 17, learned: 0, states: 30, values: [0, 96, 0.1, 0.3, 4, 100, 1.6, 0, 0.0015] },
    { step: $switched_direction.step, fill: $stage.copy_values, settings: 6, learned: 0, states: 23, values: [0.6, 0.045, 0.4, 0.6, 0.65, 0.5] },
  ]);
