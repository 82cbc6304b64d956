// Written by `make laws` from the registry: change that and run it again.
export const PREDICTORS = {
  "hold": {
    "title": "no prediction: the cursor's own position",
    "reference": "the floor",
    "meanings": {}
  },
  "linear": {
    "title": "constant velocity over a fixed horizon",
    "reference": "ForesightJS",
    "meanings": {
      "horizon_s": "how far ahead the velocity is carried on",
      "window_s": "over how long the velocity is averaged"
    }
  },
  "kalman": {
    "title": "constant acceleration over a fixed horizon, filtered",
    "reference": "Chromium",
    "meanings": {
      "horizon_s": "how far ahead the filter's state is carried",
      "cursor_jerk_density": "spectral density of the cursor's jerk",
      "cursor_noise_px": "standard deviation of a cursor position",
      "gap_s": "a longer gap between events means that the device was still"
    }
  },
  "minimum-jerk": {
    "title": "minimum-jerk inversion, no training",
    "reference": "Flash, Hogan 1985",
    "meanings": {}
  },
  "delphian": {
    "title": "once past the speed peak, as far as a line through the peak speed says",
    "reference": "Asano and others 2005",
    "meanings": {
      "slope_px_s_m": "distance left at the peak for each m/s of its speed",
      "offset_px": "distance left at a peak without speed",
      "fall": "share by which the speed must fall for a peak to be known"
    }
  },
  "kep-quadratic": {
    "title": "where a quadratic of speed over distance returns to zero",
    "reference": "Ruiz, Lank 2009, without its stability check",
    "meanings": {
      "degree": "degree of the polynomial of speed over distance",
      "reach": "farthest zero ahead, as a multiple of the distance travelled",
      "change_most": "relative change between samples of an accepted prediction"
    }
  },
  "kep-quadratic-gated": {
    "title": "where a quadratic of speed over distance returns to zero, once that is stable",
    "reference": "Ruiz, Lank 2009",
    "meanings": {
      "degree": "degree of the polynomial of speed over distance",
      "reach": "farthest zero ahead, as a multiple of the distance travelled",
      "change_most": "relative change between samples of an accepted prediction"
    }
  },
  "kep-quartic": {
    "title": "where a quartic of speed over distance returns to zero",
    "reference": "Lank, Cheng, Ruiz 2007, without its coefficients c_k",
    "meanings": {
      "degree": "degree of the polynomial of speed over distance",
      "reach": "farthest zero ahead, as a multiple of the distance travelled",
      "change_most": "relative change between samples of an accepted prediction"
    }
  },
  "kep-quartic-gated": {
    "title": "where a quartic of speed over distance returns to zero, once that is stable",
    "reference": "Lank, Cheng, Ruiz 2007 with the stability check of Ruiz, Lank 2009",
    "meanings": {
      "degree": "degree of the polynomial of speed over distance",
      "reach": "farthest zero ahead, as a multiple of the distance travelled",
      "change_most": "relative change between samples of an accepted prediction"
    }
  },
  "ktm": {
    "title": "as far as the session's earlier movement whose speed profile is most alike",
    "reference": "Pasqual, Wobbrock 2014",
    "meanings": {
      "templates": "movements of the session that are remembered",
      "longest_s": "longest movement that becomes a template",
      "shortest_px": "straight distance of the shortest"
    }
  },
  "switched": {
    "title": "doubling while the hand accelerates, DREM while it corrects; tuned",
    "reference": "Khalin 2022, section 2.5.6",
    "meanings": {
      "threshold": "below it an axis is corrective; above 1: always",
      "bound": "largest step of the corrective estimate",
      "delay_s": "delay between the copies of the regression",
      "gamma": "rate of the regression at full excitation"
    }
  },
  "switched-printed": {
    "title": "switched with the gains, threshold and bound as printed",
    "reference": "Khalin 2022, sections 2.3.2 and 2.5.6",
    "meanings": {
      "threshold": "below it an axis is corrective; above 1: always",
      "bound": "largest step of the corrective estimate",
      "delay_s": "delay between the copies of the regression",
      "gamma": "rate of the regression at full excitation"
    }
  },
  "switched-direction": {
    "title": "one sub-movement after the other along its direction: doubling, then an approach that converges",
    "reference": "Khalin 2022, sections 2.4.2, 2.4.3 and 2.5.6, changed",
    "meanings": {
      "rise": "a rise out of a valley by more is a sub-movement",
      "typical_s": "time constant of a typical approach at its peak",
      "own": "share of the sub-movement's own time in its time constant",
      "turn": "power of speed over peak speed that says how much the peak counts",
      "watched": "weight of the rate seen since the peak",
      "stopping": "way left at most, in speed^2 / deceleration"
    }
  },
  "kinematic": {
    "title": "learned from people: endpoint, region, tail and time left from the movement so far",
    "reference": "docs/evidence/results.md",
    "meanings": {}
  },
  "kinematic-adaptive": {
    "title": "kinematic, corrected by what the person's earlier movements taught",
    "reference": "docs/guide/adaptation.md",
    "meanings": {
      "adapt": "1: learn from each finished movement; 0: exactly `kinematic`",
      "distances": "1: ask the last distances; 0: only bias, widths, tempo and the clock",
      "shortest_px": "straight distance of the shortest movement that teaches",
      "places": "1: remember where movements ended; 0: only how far they went",
      "sequence": "1: learn which place follows which; 0: only how often each is visited"
    }
  }
};
export const DIFFERENTIATORS = {
  "homogeneous": {
    "meanings": {
      "cpi": "resolution of the device; None: counts are not used",
      "dpi": "resolution of the screen, used where counts are not",
      "gap_s": "a longer gap between events means that the device was still",
      "pause_s": "the first event after a longer pause starts a movement",
      "order": "number of estimated quantities: position, velocity, ...",
      "gain_lambda": "slowest pole of the linear law",
      "gain_xi": "ratio of neighbouring poles",
      "alpha": "degree of homogeneity: 0 linear, -1/order sliding mode",
      "step_s": "longest Euler step; longer gaps are cut into sub-steps"
    }
  },
  "kalman": {
    "meanings": {
      "cpi": "resolution of the device; None: counts are not used",
      "dpi": "resolution of the screen, used where counts are not",
      "gap_s": "a longer gap between events means that the device was still",
      "pause_s": "the first event after a longer pause starts a movement",
      "jerk_density": "spectral density of the jerk",
      "noise_m": "standard deviation of a measured position"
    }
  },
  "difference": {
    "meanings": {
      "cpi": "resolution of the device; None: counts are not used",
      "dpi": "resolution of the screen, used where counts are not",
      "gap_s": "a longer gap between events means that the device was still",
      "pause_s": "the first event after a longer pause starts a movement",
      "shortest_s": "shortest interval differenced"
    }
  }
};
