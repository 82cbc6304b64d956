// Written by `make laws` from the registry: change that and run it again.
import { HomogeneousDifferentiator } from "../differentiators/homogeneous.js";
import { TemplatePredictor } from "../predictors/ktm.js";
import * as $homogeneous from "../differentiators/homogeneous.js";
import * as $ktm from "../predictors/ktm.js";
export const REGISTRY = {
  GAINS: { gain_lambda: 48, gain_xi: 1.6, alpha: 0 },
  PREDICTORS: { "ktm": { differentiator: "homogeneous", load: async () => TemplatePredictor } },
  DIFFERENTIATORS: { "homogeneous": { load: async () => HomogeneousDifferentiator } },
};
export const loadStages = () =>
  Promise.all([
    { step: $homogeneous.step, fill: $homogeneous.fill, settle: $homogeneous.settle, settings: 17, learned: 0, states: 30, values: [0, 96, 0.1, 0.3, 4, 48, 1.6, 0, 0.0015] },
    { step: $ktm.step, conclude: $ktm.conclude, fill: $ktm.fill, sizes: $ktm.sizes, settings: 26, learned: 4034, states: 1696, values: [64, 3, 10] },
  ]);
