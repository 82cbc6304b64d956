// Written by `make laws` from the registry: change that and run it again.

/** Of every predictor: parameters of the differentiators, and of what weighs targets. */
export interface SharedParameters {
  /** resolution of the device; None: counts are not used; 1 to 1e+06 counts per inch */
  cpi?: number | null;
  /** resolution of the screen, used where counts are not; 1 to 100000 px per inch */
  dpi?: number;
  /** a longer gap between events means that the device was still; 0.001 to 1000 s */
  gap_s?: number;
  /** the first event after a longer pause starts a movement; 0.001 to 1000 s */
  pause_s?: number;
  /** number of estimated quantities: position, velocity, ...; 2 to 8 */
  order?: number;
  /** slowest pole of the linear law; 0.001 to 10000 1/s */
  gain_lambda?: number;
  /** ratio of neighbouring poles; 0.001 to 100 */
  gain_xi?: number;
  /** degree of homogeneity: 0 linear, -1/order sliding mode; -0.5 to 0 */
  alpha?: number;
  /** longest Euler step; longer gaps are cut into sub-steps; 1e-05 to 0.1 s */
  step_s?: number;
  /** spectral density of the jerk; 0.001 to 1e+09 m^2/s^5 */
  jerk_density?: number;
  /** standard deviation of a measured position; 1e-08 to 0.1 m */
  noise_m?: number;
  /** shortest interval differenced; 1e-06 to 0.1 s */
  shortest_s?: number;
  /** share of movements that go to none of the targets: at least, and at first; 1e-06 to 0.999999 */
  elsewhere?: number;
  /** 1: learn from finished movements what the person takes; 0: not; 0 to 1 */
  learn?: number;
  differentiator?: "homogeneous" | "kalman" | "difference";
}

/** The parameters of each predictor by its name. */
export interface OwnParameters {
  /** no prediction: the cursor's own position (the floor) */
  "hold": {};
  /** constant velocity over a fixed horizon (ForesightJS) */
  "linear": {
    /** how far ahead the velocity is carried on; 0 to 1 s */
    horizon_s?: number;
    /** over how long the velocity is averaged; 0.001 to 1 s */
    window_s?: number;
  };
  /** constant acceleration over a fixed horizon, filtered (Chromium) */
  "kalman": {
    /** how far ahead the filter's state is carried; 0 to 1 s */
    horizon_s?: number;
    /** spectral density of the cursor's jerk; 1 to 1e+18 px^2/s^5 */
    cursor_jerk_density?: number;
    /** standard deviation of a cursor position; 0.001 to 1000 px */
    cursor_noise_px?: number;
    /** a longer gap between events means that the device was still; 0.001 to 1000 s */
    gap_s?: number;
  };
  /** minimum-jerk inversion, no training (Flash, Hogan 1985) */
  "minimum-jerk": {};
  /** once past the speed peak, as far as a line through the peak speed says (Asano and others 2005) */
  "delphian": {
    /** distance left at the peak for each m/s of its speed; 0 to 100000 px s/m */
    slope_px_s_m?: number;
    /** distance left at a peak without speed; -10000 to 10000 px */
    offset_px?: number;
    /** share by which the speed must fall for a peak to be known; 0 to 0.9 */
    fall?: number;
  };
  /** where a quadratic of speed over distance returns to zero (Ruiz, Lank 2009, without its stability check) */
  "kep-quadratic": {
    /** degree of the polynomial of speed over distance; 2 to 4 */
    degree?: number;
    /** farthest zero ahead, as a multiple of the distance travelled; 0.001 to 1e+06 */
    reach?: number;
    /** relative change between samples of an accepted prediction; 1e-06 to 1 */
    change_most?: number | null;
  };
  /** where a quadratic of speed over distance returns to zero, once that is stable (Ruiz, Lank 2009) */
  "kep-quadratic-gated": {
    /** degree of the polynomial of speed over distance; 2 to 4 */
    degree?: number;
    /** farthest zero ahead, as a multiple of the distance travelled; 0.001 to 1e+06 */
    reach?: number;
    /** relative change between samples of an accepted prediction; 1e-06 to 1 */
    change_most?: number | null;
  };
  /** where a quartic of speed over distance returns to zero (Lank, Cheng, Ruiz 2007, without its coefficients c_k) */
  "kep-quartic": {
    /** degree of the polynomial of speed over distance; 2 to 4 */
    degree?: number;
    /** farthest zero ahead, as a multiple of the distance travelled; 0.001 to 1e+06 */
    reach?: number;
    /** relative change between samples of an accepted prediction; 1e-06 to 1 */
    change_most?: number | null;
  };
  /** where a quartic of speed over distance returns to zero, once that is stable (Lank, Cheng, Ruiz 2007 with the stability check of Ruiz, Lank 2009) */
  "kep-quartic-gated": {
    /** degree of the polynomial of speed over distance; 2 to 4 */
    degree?: number;
    /** farthest zero ahead, as a multiple of the distance travelled; 0.001 to 1e+06 */
    reach?: number;
    /** relative change between samples of an accepted prediction; 1e-06 to 1 */
    change_most?: number | null;
  };
  /** as far as the session's earlier movement whose speed profile is most alike (Pasqual, Wobbrock 2014) */
  "ktm": {
    /** movements of the session that are remembered; 0 to 1000 */
    templates?: number;
    /** longest movement that becomes a template; 0.2 to 30 s */
    longest_s?: number;
    /** straight distance of the shortest; 0 to 1e+06 px */
    shortest_px?: number;
  };
  /** doubling while the hand accelerates, DREM while it corrects; tuned (Khalin 2022, section 2.5.6) */
  "switched": {
    /** below it an axis is corrective; above 1: always; 0 to 10 share of peak speed */
    threshold?: number;
    /** largest step of the corrective estimate; 0 to 10 share of displacement */
    bound?: number;
    /** delay between the copies of the regression; 0.001 to 1 s */
    delay_s?: number;
    /** rate of the regression at full excitation; 0 to 1e+09 1/s */
    gamma?: number;
  };
  /** switched with the gains, threshold and bound as printed (Khalin 2022, sections 2.3.2 and 2.5.6) */
  "switched-printed": {
    /** below it an axis is corrective; above 1: always; 0 to 10 share of peak speed */
    threshold?: number;
    /** largest step of the corrective estimate; 0 to 10 share of displacement */
    bound?: number;
    /** delay between the copies of the regression; 0.001 to 1 s */
    delay_s?: number;
    /** rate of the regression at full excitation; 0 to 1e+09 1/s */
    gamma?: number;
  };
  /** one sub-movement after the other along its direction: doubling, then an approach that converges (Khalin 2022, sections 2.4.2, 2.4.3 and 2.5.6, changed) */
  "switched-direction": {
    /** a rise out of a valley by more is a sub-movement; 0 to 10 share of peak speed */
    rise?: number;
    /** time constant of a typical approach at its peak; 0.0001 to 10 s */
    typical_s?: number;
    /** share of the sub-movement's own time in its time constant; 0 to 1 */
    own?: number;
    /** power of speed over peak speed that says how much the peak counts; 0 to 1 */
    turn?: number;
    /** weight of the rate seen since the peak; 0 to 10 */
    watched?: number;
    /** way left at most, in speed^2 / deceleration; 0 to 1e+06 */
    stopping?: number;
  };
  /** learned from people: endpoint, region, tail and time left from the movement so far (docs/evidence/results.md) */
  "kinematic": {};
  /** kinematic, corrected by what the person's earlier movements taught (docs/guide/adaptation.md) */
  "kinematic-adaptive": {
    /** 1: learn from each finished movement; 0: exactly `kinematic`; 0 to 1 */
    adapt?: number;
    /** 1: ask the last distances; 0: only bias, widths, tempo and the clock; 0 to 1 */
    distances?: number;
    /** straight distance of the shortest movement that teaches; 0 to 1e+06 px */
    shortest_px?: number;
    /** 1: remember where movements ended; 0: only how far they went; 0 to 1 */
    places?: number;
    /** 1: learn which place follows which; 0: only how often each is visited; 0 to 1 */
    sequence?: number;
  };
}

export type PredictorName = keyof OwnParameters;
