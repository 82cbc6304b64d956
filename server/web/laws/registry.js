// Written by `make page` from the registry: change that and run it again.
export const VERSION = "0.1.0";
export const RECOMMENDED = "kinematic-adaptive";
export const GAINS = { gain_lambda: 48, gain_xi: 1.6, alpha: 0 };
export const PREDICTORS = {
  "hold": { title: "no prediction: the cursor's own position", reference: "the floor", differentiator: "homogeneous", preset: {}, coefficients: null, load: async () => (await import("./predictors/hold.js")).HoldPredictor },
  "linear": { title: "constant velocity over a fixed horizon", reference: "ForesightJS", differentiator: "homogeneous", preset: {}, coefficients: null, load: async () => (await import("./predictors/linear.js")).LinearPredictor },
  "kalman": { title: "constant acceleration over a fixed horizon, filtered", reference: "Chromium", differentiator: "homogeneous", preset: {}, coefficients: null, load: async () => (await import("./predictors/kalman.js")).KalmanPredictor },
  "minimum-jerk": { title: "minimum-jerk inversion, no training", reference: "Flash, Hogan 1985", differentiator: "homogeneous", preset: {}, coefficients: null, load: async () => (await import("./predictors/minimum_jerk.js")).MinimumJerkPredictor },
  "delphian": { title: "once past the speed peak, as far as a line through the peak speed says", reference: "Asano and others 2005", differentiator: "homogeneous", preset: {}, coefficients: null, load: async () => (await import("./predictors/delphian.js")).DelphianPredictor },
  "kep-quadratic": { title: "where a quadratic of speed over distance returns to zero", reference: "Ruiz, Lank 2009, without its stability check", differentiator: "homogeneous", preset: { degree: 2 }, coefficients: null, load: async () => (await import("./predictors/kep/predictor.js")).KinematicEndpointPredictor },
  "kep-quadratic-gated": { title: "where a quadratic of speed over distance returns to zero, once that is stable", reference: "Ruiz, Lank 2009", differentiator: "homogeneous", preset: { degree: 2, change_most: 0.02 }, coefficients: null, load: async () => (await import("./predictors/kep/predictor.js")).KinematicEndpointPredictor },
  "kep-quartic": { title: "where a quartic of speed over distance returns to zero", reference: "Lank, Cheng, Ruiz 2007, without its coefficients c_k", differentiator: "homogeneous", preset: { degree: 4 }, coefficients: null, load: async () => (await import("./predictors/kep/predictor.js")).KinematicEndpointPredictor },
  "kep-quartic-gated": { title: "where a quartic of speed over distance returns to zero, once that is stable", reference: "Lank, Cheng, Ruiz 2007 with the stability check of Ruiz, Lank 2009", differentiator: "homogeneous", preset: { degree: 4, change_most: 0.02 }, coefficients: null, load: async () => (await import("./predictors/kep/predictor.js")).KinematicEndpointPredictor },
  "ktm": { title: "as far as the session's earlier movement whose speed profile is most alike", reference: "Pasqual, Wobbrock 2014", differentiator: "homogeneous", preset: {}, coefficients: null, load: async () => (await import("./predictors/ktm/predictor.js")).TemplatePredictor },
  "switched": { title: "doubling while the hand accelerates, DREM while it corrects; tuned", reference: "Khalin 2022, section 2.5.6", differentiator: "homogeneous", preset: { threshold: 0.08, bound: 1, delay_s: 0.011, gamma: 65000000 }, coefficients: null, load: async () => (await import("./predictors/switched.js")).SwitchedPredictor },
  "switched-printed": { title: "switched with the gains, threshold and bound as printed", reference: "Khalin 2022, sections 2.3.2 and 2.5.6", differentiator: "homogeneous", preset: { gain_lambda: 5, gain_xi: 2, alpha: -0.2, threshold: 0.2, bound: 0.1 }, coefficients: null, load: async () => (await import("./predictors/switched.js")).SwitchedPredictor },
  "switched-direction": { title: "one sub-movement after the other along its direction: doubling, then an approach that converges", reference: "Khalin 2022, sections 2.4.2, 2.4.3 and 2.5.6, changed", differentiator: "homogeneous", preset: { gain_lambda: 100 }, coefficients: null, load: async () => (await import("./predictors/switched_direction.js")).SwitchedDirectionPredictor },
  "kinematic": { title: "learned from people: endpoint, region, tail and time left from the movement so far", reference: "docs/evidence/kinematic.md", differentiator: "homogeneous", preset: {}, coefficients: "kinematic.f32", load: async () => (await import("./predictors/kinematic/predictor.js")).KinematicPredictor },
  "kinematic-adaptive": { title: "kinematic, corrected by what the person's earlier movements taught", reference: "docs/guide/adaptation.md", differentiator: "homogeneous", preset: {}, coefficients: "kinematic.f32", load: async () => (await import("./predictors/adaptation/predictor.js")).AdaptiveKinematicPredictor },
};
export const DIFFERENTIATORS = {
  "homogeneous": { load: async () => (await import("./differentiators/homogeneous.js")).HomogeneousDifferentiator },
  "kalman": { load: async () => (await import("./differentiators/kalman.js")).KalmanDifferentiator },
  "fading-memory": { load: async () => (await import("./differentiators/fading.js")).FadingMemoryDifferentiator },
  "reduced-order": { load: async () => (await import("./differentiators/reduced_order.js")).ReducedOrderDifferentiator },
  "difference": { load: async () => (await import("./differentiators/difference.js")).BackwardDifferentiator },
};
