// Written by `make laws` from the registry: change that and run it again.
import { HomogeneousDifferentiator } from "../differentiators/homogeneous.js";
import { KinematicEndpointPredictor } from "../predictors/kep.js";
export const REGISTRY = {
  GAINS: { gain_lambda: 48, gain_xi: 1.6, alpha: 0 },
  PREDICTORS: { "kep-quadratic-gated": { differentiator: "homogeneous", preset: { degree: 2, change_most: 0.02 }, load: async () => KinematicEndpointPredictor } },
  DIFFERENTIATORS: { "homogeneous": { load: async () => HomogeneousDifferentiator } },
};
