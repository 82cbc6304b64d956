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
    { step: $homogeneous.step, settings: [0, 0.0002645833333333333, 0.1, 0.3, 4, 0, 0.0015, 0, 0.04, 444.2880000000001, 67717.69344000003, 4192827.6049920022, 89060441.84985606], states: 34 },
    { step: $ktm.step, settings: [64, 0, 61, 10, 1, 0.9898478033787338, 0.9600054412854777, 0.9122540768285452, 0.8493658165683124, 0.7748374288832494, 0.6925693242051978, 0.6065306597126334, 0.5204501210207021, 0.43756473770026916, 0.360447788597821, 0.2909238070461482, 0.23006629899380912, 0.17826397958504792, 0.1353352832366127, 0.10066889977289781, 0.0733696513683829, 0.0523931410698256, 0.036658041953378, 0.025130488985274403, 0.01687988414878991, 0.011108996538242306], states: 5730 },
  ]);
