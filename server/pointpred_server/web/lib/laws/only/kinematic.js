// Written by `make laws` from the registry: change that and run it again.
import { HomogeneousDifferentiator } from "../differentiators/homogeneous.js";
export const REGISTRY = {
  GAINS: { gain_lambda: 48, gain_xi: 1.6, alpha: 0 },
  PREDICTORS: { "kinematic": { differentiator: "homogeneous", load: () => import("../predictors/kinematic/predictor.js").then((one) => one.KinematicPredictor), coefficients: () => import("../kinematic.js").then((one) => one.COEFFICIENTS) } },
  DIFFERENTIATORS: { "homogeneous": { load: async () => HomogeneousDifferentiator } },
};
