// Written by `make laws` from the registry: change that and run it again.
export const RECOMMENDED = "kinematic-adaptive";
export const GAINS = { gain_lambda: 48, gain_xi: 1.6, alpha: 0 };
export const PREDICTORS = {
  "hold": { differentiator: "homogeneous", load: () => import("./predictors/hold.js").then((one) => one.HoldPredictor) },
  "linear": { differentiator: "homogeneous", load: () => import("./predictors/linear.js").then((one) => one.LinearPredictor) },
  "kalman": { differentiator: "homogeneous", load: () => import("./predictors/kalman.js").then((one) => one.KalmanPredictor) },
  "minimum-jerk": { differentiator: "homogeneous", load: () => import("./predictors/minimum_jerk.js").then((one) => one.MinimumJerkPredictor) },
  "delphian": { differentiator: "homogeneous", load: () => import("./predictors/delphian.js").then((one) => one.DelphianPredictor) },
  "kep-quadratic": { differentiator: "homogeneous", preset: { degree: 2 }, load: () => import("./predictors/kep.js").then((one) => one.KinematicEndpointPredictor) },
  "kep-quadratic-gated": { differentiator: "homogeneous", preset: { degree: 2, change_most: 0.02 }, load: () => import("./predictors/kep.js").then((one) => one.KinematicEndpointPredictor) },
  "kep-quartic": { differentiator: "homogeneous", preset: { degree: 4 }, load: () => import("./predictors/kep.js").then((one) => one.KinematicEndpointPredictor) },
  "kep-quartic-gated": { differentiator: "homogeneous", preset: { degree: 4, change_most: 0.02 }, load: () => import("./predictors/kep.js").then((one) => one.KinematicEndpointPredictor) },
  "ktm": { differentiator: "homogeneous", load: () => import("./predictors/ktm.js").then((one) => one.TemplatePredictor) },
  "switched": { differentiator: "homogeneous", preset: { threshold: 0.08, bound: 1, delay_s: 0.011, gamma: 65000000 }, load: () => import("./predictors/switched.js").then((one) => one.SwitchedPredictor) },
  "switched-printed": { differentiator: "homogeneous", preset: { gain_lambda: 5, gain_xi: 2, alpha: -0.2, threshold: 0.2, bound: 0.1 }, load: () => import("./predictors/switched.js").then((one) => one.SwitchedPredictor) },
  "switched-direction": { differentiator: "homogeneous", preset: { gain_lambda: 100 }, load: () => import("./predictors/switched_direction.js").then((one) => one.SwitchedDirectionPredictor) },
  "kinematic": { differentiator: "homogeneous", load: () => import("./predictors/kinematic/predictor.js").then((one) => one.KinematicPredictor), coefficients: () => import("./kinematic.js").then((one) => one.COEFFICIENTS) },
  "kinematic-adaptive": { differentiator: "homogeneous", load: () => import("./predictors/adaptation/predictor.js").then((one) => one.AdaptiveKinematicPredictor), coefficients: () => import("./kinematic.js").then((one) => one.COEFFICIENTS) },
};
export const DIFFERENTIATORS = {
  "homogeneous": { load: () => import("./differentiators/homogeneous.js").then((one) => one.HomogeneousDifferentiator) },
  "kalman": { load: () => import("./differentiators/kalman.js").then((one) => one.KalmanDifferentiator) },
  "difference": { load: () => import("./differentiators/difference.js").then((one) => one.BackwardDifferentiator) },
};
export const REGISTRY = { GAINS, PREDICTORS, DIFFERENTIATORS };
