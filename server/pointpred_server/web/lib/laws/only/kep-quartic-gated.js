// Written by `make laws` from the registry: change that and run it again.
import { HomogeneousDifferentiator } from "../differentiators/homogeneous.js";
import { KinematicEndpointPredictor } from "../predictors/kep.js";
import * as $homogeneous from "../differentiators/homogeneous.js";
import * as $kep from "../predictors/kep.js";
import * as $stage from "../stage.js";
export const REGISTRY = {
  GAINS: { gain_lambda: 48, gain_xi: 1.6, alpha: 0 },
  PREDICTORS: { "kep-quartic-gated": { differentiator: "homogeneous", preset: { degree: 4, change_most: 0.02 }, load: async () => KinematicEndpointPredictor } },
  DIFFERENTIATORS: { "homogeneous": { load: async () => HomogeneousDifferentiator } },
};
export const loadStages = () =>
  Promise.all([
    { step: $homogeneous.step, fill: $homogeneous.fill, settle: $homogeneous.settle, settings: 17, learned: 0, states: 30, values: [0, 96, 0.1, 0.3, 4, 48, 1.6, 0, 0.0015] },
    { step: $kep.step, fill: $stage.copy_values, settings: 3, learned: 0, states: 56, values: [4, 10, 0.02] },
  ]);
