/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const double predictors_kalman_PRIOR_ACCELERATION = 1000.0;
static const double predictors_kalman_PRIOR_SPEED = 100.0;
static const double predictors_kep_EXCITATION_LEAST = 1e-05;
static const int64_t predictors_kep_STEPS_MOST = 80;
static const T22d predictors_ktm_KERNEL = {1.0, 0.9898478033787338, 0.9600054412854777, 0.9122540768285452, 0.8493658165683124, 0.7748374288832494, 0.6925693242051978, 0.6065306597126334, 0.5204501210207021, 0.43756473770026916, 0.360447788597821, 0.2909238070461482, 0.23006629899380912, 0.17826397958504792, 0.1353352832366127, 0.10066889977289781, 0.0733696513683829, 0.0523931410698256, 0.036658041953378, 0.025130488985274403, 0.01687988414878991, 0.011108996538242306};
static const int64_t predictors_ktm_LONGEST_OF = 1;
static const int64_t predictors_ktm_POINTS_LEAST = 4;
static const double predictors_ktm_RATE_HZ = 20.0;
static const int64_t predictors_ktm_SHORTEST_OF = 2;
static const double predictors_ktm_STAMP_S = 1e-06;
static const double predictors_ktm_STEP_S = 0.05;
static const int64_t predictors_ktm_TAPS = 22;
static const int64_t predictors_ktm_TEMPLATES_OF = 0;
static const int64_t predictors_linear_CAPACITY = 8;
static const double predictors_mixture_AT_CENTRE = 0.4;
static const int64_t predictors_mixture_CLOSER = 3;
static const double predictors_mixture_DENSITY_LEAST = 1e-280;
static const int64_t predictors_mixture_HALVINGS = 60;
static const int64_t predictors_mixture_LINES = 24;
static const int64_t predictors_mixture_LINES_LEAST = 3;
static const int64_t predictors_mixture_LINES_OF = 120;
static const double predictors_mixture_OUTSIDE = 1.0001;
static const int64_t predictors_mixture_POINTS = 2000;
static const int64_t predictors_mixture_POINTS_LEAST = 30;
static const int64_t predictors_mixture_POINTS_OF = 10000;
static const double predictors_mixture_TURN_COS = -0.7373688780783197;
static const double predictors_mixture_TURN_SIN = 0.6754902942615238;
static const int64_t predictors_movement_NUMBERS = 7;
static const int64_t predictors_switched_T = 2;
static const int64_t predictors_switched_UNKNOWNS = 3;
static const double records_MOTION_MOST = 1e+300;

/* The density of a part at a place, times its share, in 1 / px^2. */
double predictors_mixture_part_density(predictors_mixture_PartRow * part, double x, double y) {
  double sxx, sxy, syy, tail, determinant, dx, dy, far, log_density;
  sxx = part->sxx;
  sxy = part->sxy;
  syy = part->syy;
  tail = part->tail;
  determinant = sxx * syy - sxy * sxy;
  dx = x - part->x;
  dy = y - part->y;
  far = (syy * dx * dx - 2.0 * sxy * dx * dy + sxx * dy * dy) / determinant;
  log_density = tail == 0.0 ? -0.5 * far : -0.5 * (tail + 2.0) * log1p(far / tail);
  return part->share * exp(log_density) / (2.0 * 3.141592653589793 * sqrt(determinant));
}

/* Squared Mahalanobis distance within which a share of a part's law lies. */
double predictors_mixture_squared_radius(double share, double tail) {
  double normal;
  normal = -2.0 * log1p(-share);
  return tail == 0.0 ? normal : tail * expm1(normal / tail);
}

/* The density of the mixture at a place, in 1 / px^2. */
double predictors_mixture_density(Table parts, int64_t count, double x, double y) {
  double total;
  total = 0.0;
  for (int64_t k = 0; k < count; k++) {
    total = total + predictors_mixture_part_density((predictors_mixture_PartRow *)((Vector){parts.p + k * parts.m, parts.m}.p), x, y);
  }
  return total;
}

/* The density at so many points of each part, a row of ``out`` each. */
void predictors_mixture_densities(Table parts, int64_t count, int64_t points, Table out) {
  predictors_mixture_PartRow * part;
  double wide, slant, broad, cos_, sin_, radius, x, y;
  for (int64_t k = 0; k < count; k++) {
    part = (predictors_mixture_PartRow *)((Vector){parts.p + k * parts.m, parts.m}.p);
    wide = sqrt(part->sxx);
    slant = part->sxy / wide;
    broad = sqrt(part->syy - slant * slant);
    cos_ = 1.0;
    sin_ = 0.0;
    for (int64_t i = 0; i < points; i++) {
      radius = sqrt(predictors_mixture_squared_radius((i + 0.5) / points, part->tail));
      x = part->x + radius * wide * cos_;
      y = part->y + radius * (slant * cos_ + broad * sin_);
      out.p[k * out.m + i] = predictors_mixture_density(parts, count, x, y);
      double value_1 = cos_ * predictors_mixture_TURN_COS - sin_ * predictors_mixture_TURN_SIN;
      double value_2 = cos_ * predictors_mixture_TURN_SIN + sin_ * predictors_mixture_TURN_COS;
      cos_ = value_1;
      sin_ = value_2;
    }
  }
}

/* The probability of the places that are denser than a threshold; ``known``: by ``densities``. */
WIDE double predictors_mixture_share_above(Table parts, int64_t count, int64_t points, Table known, double threshold) {
  double total;
  int64_t above;
  total = 0.0;
  for (int64_t k = 0; k < count; k++) {
    above = 0;
    for (int64_t i = 0; i < points; i++) {
      above += known.p[k * known.m + i] > threshold ? 1 : 0;
    }
    total += ((predictors_mixture_PartRow *)((Vector){parts.p + k * parts.m, parts.m}.p))->share * above / points;
  }
  return total;
}

/* FINE; ORDER before the last time; MOTION_FIELD plus the place of the first value out of its bounds. */
int64_t predictors_movement_fault_of(predictors_movement_State * s, records_MotionRow m) {
  for (int64_t i = 0; i < predictors_movement_NUMBERS; i++) {
    if (!(fabs(((const double *)&m)[i]) <= records_MOTION_MOST)) {
      return records_MOTION_FIELD + i;
    }
  }
  return s->known == 1.0 && m.t < s->t ? records_ORDER : records_FINE;
}

/* Remember the peak; once the speed has fallen from it, the line says how far it is from there. */
T10d predictors_delphian_step(predictors_delphian_Memory * memory, T10d motion) {
  records_MotionRow m;
  predictors_delphian_Settings * settings;
  predictors_movement_State * s;
  predictors_delphian_Peak * peak;
  double before, phase, speed, away_x, away_y, away, ahead;
  int64_t fault;
  bool new;
  m = records_MotionRow_of_T10d(motion);
  settings = &memory->settings;
  s = &memory->state.movement;
  peak = &memory->state.peak;
  before = s->peak;
  Tqbd values_1 = predictors_movement_follow(s, m);
  fault = values_1.f0;
  new = values_1.f1;
  if (fault != records_FINE) {
    return predictors_movement_refuse(s, m, fault);
  }
  phase = predictors_movement_phase(s, m);
  if (new) {
    memset(peak, 0, sizeof(predictors_delphian_Peak));
  }
  speed = hypot(m.vx, m.vy);
  if (new || s->peak > before) {
    away_x = m.x - s->x0;
    away_y = m.y - s->y0;
    away = hypot(away_x, away_y);
    peak->x = m.x;
    peak->y = m.y;
    peak->fallen = 0.0;
    peak->unit_x = away > 0.0 ? away_x / away : 0.0;
    peak->unit_y = away > 0.0 ? away_y / away : 0.0;
  } else if (speed < (1.0 - settings->fall) * s->peak && s->peak >= predictors_movement_STILL_M_S) {
    peak->fallen = 1.0;
  }
  if (peak->fallen == 0.0 || (peak->unit_x == 0.0 && peak->unit_y == 0.0)) {
    return records_endpoint(m.t, NAN, NAN, phase);
  }
  ahead = max_float(settings->slope * s->peak + settings->offset, 0.0);
  return records_endpoint(m.t, peak->x + ahead * peak->unit_x, peak->y + ahead * peak->unit_y, phase);
}

/* The cursor's position is the answer. */
T10d predictors_hold_step(predictors_movement_State * s, T10d motion) {
  records_MotionRow m;
  int64_t fault;
  m = records_MotionRow_of_T10d(motion);
  Tqbd values_1 = predictors_movement_follow(s, m);
  fault = values_1.f0;
  if (fault != records_FINE) {
    return predictors_movement_refuse(s, m, fault);
  }
  return records_endpoint(m.t, m.x, m.y, predictors_movement_phase(s, m));
}

/* Expect a cursor that rests at (x, y). */
void predictors_kalman_expect_rest(differentiators_kalman_Plane * plane, double noise, double x, double y) {
  memset(plane, 0, sizeof(differentiators_kalman_Plane));
  plane->x[0] = x;
  plane->y[0] = y;
  plane->covariance.p00 = noise;
  plane->covariance.p11 = square(predictors_kalman_PRIOR_SPEED);
  plane->covariance.p22 = square(predictors_kalman_PRIOR_ACCELERATION);
}

/* Position, velocity and acceleration of one axis after its position was measured. */
T3d predictors_kalman_corrected(Vector axis, differentiators_kalman_Covariance * p, double noise, double measured) {
  double share;
  share = (measured - axis.p[0]) / (p->p00 + noise);
  return (T3d){axis.p[0] + p->p00 * share, axis.p[1] + p->p01 * share, axis.p[2] + p->p02 * share};
}

/* Take the last position (x, y) in and expect the state ``dt`` later. */
void predictors_kalman_expect(differentiators_kalman_Plane * plane, double noise, double jerk_density, double dt, double x, double y) {
  differentiators_kalman_correct((Vector){plane->x, 3}, &plane->covariance, noise, x);
  differentiators_kalman_predict((Vector){plane->x, 3}, dt);
  differentiators_kalman_correct((Vector){plane->y, 3}, &plane->covariance, noise, y);
  differentiators_kalman_predict((Vector){plane->y, 3}, dt);
  differentiators_kalman_narrow(&plane->covariance, noise);
  differentiators_kalman_spread(&plane->covariance, jerk_density, dt);
}

/* One position through the filter of both axes, and its state carried over the horizon. */
T10d predictors_kalman_step(predictors_kalman_Memory * memory, T10d motion) {
  records_MotionRow m;
  predictors_kalman_Settings * settings;
  predictors_movement_State * s;
  differentiators_kalman_Plane * plane;
  double last_x, last_y, dt, noise, px, vx_px, ax_px, py, vy_px, ay_px, h;
  int64_t fault;
  bool new;
  m = records_MotionRow_of_T10d(motion);
  settings = &memory->settings;
  s = &memory->state.movement;
  plane = &memory->state.expected;
  last_x = s->x;
  last_y = s->y;
  Tqbd values_1 = predictors_movement_follow(s, m);
  fault = values_1.f0;
  new = values_1.f1;
  dt = values_1.f2;
  if (fault != records_FINE) {
    return predictors_movement_refuse(s, m, fault);
  }
  noise = square(settings->noise_px);
  if (new || dt > settings->gap_s + records_ROUNDING_S) {
    predictors_kalman_expect_rest(plane, noise, m.x - s->x0, m.y - s->y0);
  } else if (dt > 0.0) {
    predictors_kalman_expect(plane, noise, settings->jerk_density, dt, last_x - s->x0, last_y - s->y0);
  }
  T3d values_2 = predictors_kalman_corrected((Vector){plane->x, 3}, &plane->covariance, noise, m.x - s->x0);
  px = values_2.f0;
  vx_px = values_2.f1;
  ax_px = values_2.f2;
  T3d values_3 = predictors_kalman_corrected((Vector){plane->y, 3}, &plane->covariance, noise, m.y - s->y0);
  py = values_3.f0;
  vy_px = values_3.f1;
  ay_px = values_3.f2;
  h = settings->horizon_s;
  return records_endpoint(m.t, s->x0 + px + h * (vx_px + 0.5 * h * ax_px), s->y0 + py + h * (vy_px + 0.5 * h * ay_px), predictors_movement_phase(s, m));
}

/* The polynomial at w. */
double predictors_kep_value(predictors_kep_Quartic p, double w) {
  return p.c0 + w * (p.c1 + w * (p.c2 + w * (p.c3 + w * p.c4)));
}

/* The polynomial's derivative. */
predictors_kep_Quartic predictors_kep_derivative(predictors_kep_Quartic p) {
  return (predictors_kep_Quartic){p.c1, 2.0 * p.c2, 3.0 * p.c3, 4.0 * p.c4, 0.0};
}

/* The points in (0, far) where the second derivative 2 c2 + 6 c3 w + 12 c4 w^2 is zero, else ``far``. */
T2d predictors_kep_bends(predictors_kep_Quartic p, double far) {
  double a, b, c, discriminant, half, one, other;
  a = 6.0 * p.c4;
  b = 3.0 * p.c3;
  c = p.c2;
  discriminant = b * b - 4.0 * a * c;
  if (discriminant < 0.0) {
    return (T2d){far, far};
  }
  half = -0.5 * (b + (b >= 0.0 ? sqrt(discriminant) : -sqrt(discriminant)));
  one = a != 0.0 ? half / a : far;
  other = half != 0.0 ? c / half : far;
  one = 0.0 < one && one < far ? one : far;
  other = 0.0 < other && other < far ? other : far;
  return (T2d){min_float(one, other), max_float(one, other)};
}

/* The zero between low and high where the polynomial is monotone; ``high`` if there is none. */
double predictors_kep_zero_between(predictors_kep_Quartic p, double low, double high) {
  double at_low, w, here, slope, new;
  at_low = predictors_kep_value(p, low);
  if (!(at_low * predictors_kep_value(p, high) < 0.0)) {
    return high;
  }
  w = 0.5 * (low + high);
  for (int64_t i_1 = 0; i_1 < predictors_kep_STEPS_MOST; i_1++) {
    here = predictors_kep_value(p, w);
    if (here == 0.0) {
      return w;
    }
    if ((here > 0.0) == (at_low > 0.0)) {
      low = w;
    } else {
      high = w;
    }
    slope = p.c1 + w * (2.0 * p.c2 + w * (3.0 * p.c3 + w * 4.0 * p.c4));
    new = slope != 0.0 ? w - here / slope : low;
    if (!(low < new && new < high)) {
      new = 0.5 * (low + high);
    }
    if (fabs(new - w) <= 1e-13 * fabs(w)) {
      return new;
    }
    w = new;
  }
  return w;
}

/* Smallest w in (0, far] where the polynomial comes down to zero from c0 > 0, else NaN. */
double predictors_kep_first_zero(predictors_kep_Quartic p, double far) {
  double bend_1, bend_2, left, turn;
  T3d bounds;
  predictors_kep_Quartic slope;
  if (!(p.c0 > 0.0)) {
    return NAN;
  }
  T2d values_1 = predictors_kep_bends(p, far);
  bend_1 = values_1.f0;
  bend_2 = values_1.f1;
  bounds = (T3d){bend_1, bend_2, far};
  slope = predictors_kep_derivative(p);
  left = 0.0;
  for (int64_t i = 0; i < 3; i++) {
    turn = predictors_kep_zero_between(slope, left, ((const double *)&bounds)[i]);
    if (predictors_kep_value(p, turn) <= 0.0) {
      return predictors_kep_zero_between(p, left, turn);
    }
    if (predictors_kep_value(p, ((const double *)&bounds)[i]) <= 0.0) {
      return predictors_kep_zero_between(p, turn, ((const double *)&bounds)[i]);
    }
    left = ((const double *)&bounds)[i];
  }
  return NAN;
}

/* Take the row (1, d, d^2, ... | speed) into the fit. */
void predictors_kep_add(predictors_kep_Fit * fit, int64_t degree, double distance, double speed) {
  regression_least_squares_Regression regression;
  double power;
  regression = regression_least_squares_parts((Vector){fit->numbers, 35}, degree + 1);
  power = 1.0;
  for (int64_t j = 0, end_1 = degree + 1; j < end_1; j++) {
    regression.w.p[j] = power;
    power *= distance;
  }
  regression_least_squares_advance(&fit->sums, regression, 1.0, speed);
}

/* Distance in px from where the cursor is to where the fitted speed returns to zero, else NaN. */
double predictors_kep_remaining(predictors_kep_Fit * fit, int64_t degree, double reach, double travelled) {
  Vector c;
  regression_least_squares_Regression regression;
  double c0, c1, c2, c3, c4;
  predictors_kep_Quartic here;
  c = (Vector){fit->coefficients, 5};
  regression = regression_least_squares_parts((Vector){fit->numbers, 35}, degree + 1);
  if (!(travelled > 0.0 && regression_least_squares_solve(regression, predictors_kep_EXCITATION_LEAST, c))) {
    return NAN;
  }
  c0 = c.p[0];
  c1 = c.p[1] * travelled;
  c2 = c.p[2] * square(travelled);
  c3 = degree > 2 ? c.p[3] * whole_power(travelled, 3) : 0.0;
  c4 = degree > 3 ? c.p[4] * whole_power(travelled, 4) : 0.0;
  here = (predictors_kep_Quartic){predictors_kep_value((predictors_kep_Quartic){c0, c1, c2, c3, c4}, 1.0), c1 + 2.0 * c2 + 3.0 * c3 + 4.0 * c4, c2 + 3.0 * c3 + 6.0 * c4, c3 + 4.0 * c4, c4};
  return predictors_kep_first_zero(here, reach) * travelled;
}

/* Accept an endpoint when the predicted length changed little since the sample before. */
void predictors_kep_judge(predictors_kep_Check * check, double change_most, double length, double x, double y) {
  double before;
  before = check->predicted;
  if (before > 0.0 && fabs(length - before) < change_most * before) {
    check->accepted = 1.0;
    check->x = x;
    check->y = y;
  }
  check->predicted = length > 0.0 ? length : 0.0;
}

/* Add the motion to the fit and look for its zero ahead. */
T10d predictors_kep_step(predictors_kep_Memory * memory, T10d motion) {
  records_MotionRow m;
  predictors_kep_Settings * settings;
  predictors_movement_State * s;
  predictors_kep_Fit * fit;
  predictors_kep_Check * check;
  int64_t fault, degree;
  bool new, accepted;
  double dt, travelled, away_x, away_y, away, end_x, end_y, ahead;
  m = records_MotionRow_of_T10d(motion);
  settings = &memory->settings;
  s = &memory->state.movement;
  fit = &memory->state.fit;
  check = &memory->state.check;
  Tqbd values_1 = predictors_movement_follow(s, m);
  fault = values_1.f0;
  new = values_1.f1;
  dt = values_1.f2;
  if (fault != records_FINE) {
    return predictors_movement_refuse(s, m, fault);
  }
  if (new) {
    memset(fit, 0, sizeof(predictors_kep_Fit));
    memset(check, 0, sizeof(predictors_kep_Check));
  }
  degree = (int64_t)settings->degree;
  travelled = s->path;
  if (new || dt > 0.0) {
    predictors_kep_add(fit, degree, travelled, hypot(m.vx, m.vy));
  }
  away_x = m.x - s->x0;
  away_y = m.y - s->y0;
  away = hypot(away_x, away_y);
  end_x = NAN;
  end_y = NAN;
  if (away > 0.0) {
    ahead = predictors_kep_remaining(fit, degree, settings->reach, travelled);
    end_x = m.x + ahead * (away_x / away);
    end_y = m.y + ahead * (away_y / away);
    if (dt > 0.0) {
      predictors_kep_judge(check, settings->change_most, travelled + ahead, end_x, end_y);
    }
  }
  if (settings->change_most > 0.0) {
    accepted = check->accepted == 1.0;
    end_x = accepted ? check->x : NAN;
    end_y = accepted ? check->y : NAN;
  }
  return records_endpoint(m.t, end_x, end_y, predictors_movement_phase(s, m));
}

/* Samples in the profile of the longest movement: one for each 50 ms, and the zero before them. */
int64_t predictors_ktm_samples_of(double longest_s) {
  return (int64_t)((longest_s + predictors_ktm_STAMP_S) / predictors_ktm_STEP_S) + 1;
}

/* The settings and the kernel, without a library. */
void predictors_ktm_fill(Vector values, predictors_ktm_Settings * settings) {
  settings->learned_most = values.p[predictors_ktm_TEMPLATES_OF];
  settings->templates_given = 0.0;
  settings->longest = predictors_ktm_samples_of(values.p[predictors_ktm_LONGEST_OF]);
  settings->shortest_px = values.p[predictors_ktm_SHORTEST_OF];
  for (int64_t k = 0; k < predictors_ktm_TAPS; k++) {
    settings->half[k] = ((const double *)&predictors_ktm_KERNEL)[k];
  }
}

/* How many settings, learned floats and states of a movement there are without a library. */
T3q predictors_ktm_sizes(Vector values) {
  int64_t templates, longest, states;
  templates = (int64_t)values.p[predictors_ktm_TEMPLATES_OF];
  longest = predictors_ktm_samples_of(values.p[predictors_ktm_LONGEST_OF]);
  states = 35 + longest + templates * 25;
  if (templates == 0) {
    return (T3q){26, 0, states + 2};
  }
  return (T3q){26, templates * (2 + longest) + 2, states};
}

/* Place of the k-th template. */
int64_t predictors_ktm_place_of_template(predictors_ktm_Settings * settings, int64_t k) {
  return k * (2 + (int64_t)settings->longest);
}

/* Place of what is learned: after the last template. */
int64_t predictors_ktm_place_of_learned(predictors_ktm_Settings * settings) {
  return predictors_ktm_place_of_template(settings, (int64_t)settings->templates_given + (int64_t)settings->learned_most);
}

/* How many templates there are to compare with. */
int64_t predictors_ktm_template_count(predictors_ktm_Memory * memory) {
  predictors_ktm_Learned * learned;
  learned = (predictors_ktm_Learned *)((Vector){memory->rest, -1}.p + predictors_ktm_place_of_learned(&memory->settings));
  return (int64_t)memory->settings.templates_given + (int64_t)learned->count;
}

/* One template's mean absolute smoothed difference over samples 0 to n. */
void predictors_ktm_score(predictors_ktm_Settings * settings, int64_t n, double speed, double own, predictors_ktm_Template * template, predictors_ktm_Match * match) {
  int64_t length, oldest;
  double difference, total, newest;
  length = (int64_t)template->samples;
  difference = n < length ? speed - template->speeds[n] : speed;
  match->final += fabs(match->smooth[0]);
  total = match->final;
  oldest = max_whole(0, predictors_ktm_TAPS - 1 - n);
  for (int64_t k = oldest; k < (predictors_ktm_TAPS - 1); k++) {
    match->smooth[k] = match->smooth[k + 1] + settings->half[predictors_ktm_TAPS - 1 - k] * difference;
    total += fabs(match->smooth[k]);
  }
  newest = own;
  if (n < length) {
    for (int64_t k = oldest; k < predictors_ktm_TAPS; k++) {
      newest -= settings->half[predictors_ktm_TAPS - 1 - k] * template->speeds[n - (predictors_ktm_TAPS - 1) + k];
    }
  }
  match->smooth[predictors_ktm_TAPS - 1] = newest;
  match->score = (total + fabs(newest)) / (n + 1);
}

/* Take in the next sample of the movement's speed, and score every template. */
void predictors_ktm_sample(predictors_ktm_Memory * memory, predictors_ktm_State * s, double speed) {
  predictors_ktm_Settings * settings;
  predictors_ktm_Samples * samples;
  int64_t n, longest;
  double own;
  predictors_ktm_Template * template;
  settings = &memory->settings;
  samples = &s->samples;
  n = (int64_t)samples->count;
  longest = (int64_t)settings->longest;
  for (int64_t k = 0; k < (predictors_ktm_TAPS - 1); k++) {
    samples->recent[k] = samples->recent[k + 1];
  }
  samples->recent[predictors_ktm_TAPS - 1] = speed;
  if (n < longest) {
    s->rest[n] = speed;
  }
  own = 0.0;
  for (int64_t k = 0; k < predictors_ktm_TAPS; k++) {
    own += settings->half[predictors_ktm_TAPS - 1 - k] * samples->recent[k];
  }
  for (int64_t j = 0, end_1 = predictors_ktm_template_count(memory); j < end_1; j++) {
    template = (predictors_ktm_Template *)((Vector){memory->rest, -1}.p + predictors_ktm_place_of_template(settings, j));
    predictors_ktm_score(settings, n, speed, own, template, (predictors_ktm_Match *)((Vector){s->rest, -1}.p + longest + j * 25));
  }
  samples->count = n + 1.0;
}

/* Add each score that many times to its running sum; the first with the lowest sum, -1 without any. */
int64_t predictors_ktm_winner(predictors_ktm_Memory * memory, predictors_ktm_State * s, double times) {
  int64_t best;
  double lowest;
  predictors_ktm_Match * match;
  best = -1;
  lowest = 0.0;
  for (int64_t j = 0, end_1 = predictors_ktm_template_count(memory); j < end_1; j++) {
    match = (predictors_ktm_Match *)((Vector){s->rest, -1}.p + (int64_t)memory->settings.longest + j * 25);
    match->sum += times * match->score;
    if (best < 0 || match->sum < lowest) {
      best = j;
      lowest = match->sum;
    }
  }
  return best;
}

/* Store the movement as a template, replacing the oldest learned one, if its length is within bounds. */
void predictors_ktm_keep(predictors_ktm_Memory * memory, predictors_ktm_State * s, double distance) {
  predictors_ktm_Settings * settings;
  int64_t most, samples;
  predictors_ktm_Learned * learned;
  predictors_ktm_Template * template;
  settings = &memory->settings;
  most = (int64_t)settings->learned_most;
  samples = (int64_t)s->samples.count;
  if (most == 0 || s->samples.points < predictors_ktm_POINTS_LEAST || !(2 <= samples && samples <= settings->longest)) {
    return;
  }
  if (!(distance >= settings->shortest_px)) {
    return;
  }
  learned = (predictors_ktm_Learned *)((Vector){memory->rest, -1}.p + predictors_ktm_place_of_learned(settings));
  template = (predictors_ktm_Template *)((Vector){memory->rest, -1}.p + predictors_ktm_place_of_template(settings, (int64_t)settings->templates_given + (int64_t)learned->next));
  template->samples = samples;
  template->distance = distance;
  for (int64_t k = 0, end_1 = (int64_t)settings->longest; k < end_1; k++) {
    template->speeds[k] = s->rest[k];
  }
  learned->next = remainder_float(learned->next + 1.0, most);
  learned->count = min_float(learned->count + 1.0, most);
}

/* Nothing is known of the movement but what all predictors know. */
void predictors_ktm_forget(predictors_ktm_Settings * settings, predictors_ktm_State * s) {
  int64_t matches;
  memset(&s->samples, 0, sizeof(predictors_ktm_Samples));
  matches = (int64_t)settings->templates_given + (int64_t)settings->learned_most;
  fill((Vector){(Vector){s->rest, -1}.p, (int64_t)settings->longest + matches * 25}, 0.0);
}

/* How far the cursor is from the movement's start, px. */
double predictors_ktm_distance(predictors_movement_State * s) {
  return hypot(s->x - s->x0, s->y - s->y0);
}

/* The movement has ended: keep it as a template. */
void predictors_ktm_conclude(predictors_ktm_Memory * memory) {
  predictors_ktm_State * s;
  s = (predictors_ktm_State *)((Vector){memory->rest, -1}.p + predictors_ktm_place_of_learned(&memory->settings) + 2);
  predictors_ktm_keep(memory, s, predictors_ktm_distance(&s->movement));
}

/* Take in the samples that have fallen due since the motion before the last one. */
void predictors_ktm_resample(predictors_ktm_Memory * memory, predictors_ktm_State * s, double since, double x_before, double y_before) {
  predictors_ktm_Samples * samples;
  double most, now, x, y, due, back, grid_x, grid_y, way;
  samples = &s->samples;
  most = memory->settings.longest + predictors_ktm_TAPS;
  now = s->movement.t - s->movement.t0;
  x = s->movement.x;
  y = s->movement.y;
  due = samples->count * predictors_ktm_STEP_S;
  while (due <= now + predictors_ktm_STAMP_S && samples->count < most) {
    back = min_float(max_float((now - due) / since, 0.0), 1.0);
    grid_x = x + back * (x_before - x);
    grid_y = y + back * (y_before - y);
    way = hypot(grid_x - samples->x, grid_y - samples->y);
    samples->x = grid_x;
    samples->y = grid_y;
    predictors_ktm_sample(memory, s, way * predictors_ktm_RATE_HZ);
    due = samples->count * predictors_ktm_STEP_S;
  }
}

/* Follow the speed profile and go as far as the template that is most like it. */
T10d predictors_ktm_step(predictors_ktm_Memory * memory, T10d motion) {
  records_MotionRow m;
  predictors_ktm_State * s;
  double last_distance, x_before, y_before, dt, phase, away, ahead, x0, y0;
  int64_t fault, best;
  bool new;
  predictors_ktm_Template * template;
  m = records_MotionRow_of_T10d(motion);
  s = (predictors_ktm_State *)((Vector){memory->rest, -1}.p + predictors_ktm_place_of_learned(&memory->settings) + 2);
  last_distance = predictors_ktm_distance(&s->movement);
  x_before = s->movement.x;
  y_before = s->movement.y;
  Tqbd values_1 = predictors_movement_follow(&s->movement, m);
  fault = values_1.f0;
  new = values_1.f1;
  dt = values_1.f2;
  if (fault != records_FINE) {
    return predictors_movement_refuse(&s->movement, m, fault);
  }
  phase = predictors_movement_phase(&s->movement, m);
  if (new) {
    predictors_ktm_keep(memory, s, last_distance);
    predictors_ktm_forget(&memory->settings, s);
    s->samples.points = 1.0;
    predictors_ktm_sample(memory, s, 0.0);
  }
  if (new || m.t == s->movement.t0) {
    s->samples.x = m.x;
    s->samples.y = m.y;
  }
  if (dt > 0.0) {
    s->samples.points += 1.0;
    predictors_ktm_resample(memory, s, dt, x_before, y_before);
  }
  away = predictors_ktm_distance(&s->movement);
  best = -1;
  if (s->samples.points >= predictors_ktm_POINTS_LEAST) {
    best = predictors_ktm_winner(memory, s, dt > 0.0 ? 1.0 : 0.0);
  }
  if (best < 0 || !(away > 0.0)) {
    return records_endpoint(m.t, NAN, NAN, phase);
  }
  template = (predictors_ktm_Template *)((Vector){memory->rest, -1}.p + predictors_ktm_place_of_template(&memory->settings, best));
  ahead = template->distance / away - 1.0;
  x0 = s->movement.x0;
  y0 = s->movement.y0;
  return records_endpoint(m.t, m.x + ahead * (m.x - x0), m.y + ahead * (m.y - y0), phase);
}

/* Remember a sample if the newest is an eighth of the window old; one of the same time is replaced. */
WIDE void predictors_linear_remember(predictors_linear_Past * past, double window_s, double t, double x, double y) {
  int64_t count;
  bool same;
  count = (int64_t)past->count;
  same = count > 0 && past->samples[0][0] == t;
  if (count > 0 && !same && t - past->samples[0][0] < window_s / predictors_linear_CAPACITY - records_ROUNDING_S) {
    return;
  }
  if (!same) {
    for (int64_t i = predictors_linear_CAPACITY - 1; i > 0; i--) {
      for (int64_t j = 0; j < 3; j++) {
        past->samples[i][j] = past->samples[i - 1][j];
      }
    }
    past->count = min_whole(count + 1, predictors_linear_CAPACITY);
  }
  past->samples[0][0] = t;
  past->samples[0][1] = x;
  past->samples[0][2] = y;
}

/* Whether there is a sample before ``t``; the oldest within the window, else the newest: (t, x, y). */
Tb3d predictors_linear_before(predictors_linear_Past * past, double window_s, double t) {
  int64_t found;
  double age;
  found = -1;
  for (int64_t i = 0, end_1 = (int64_t)past->count; i < end_1; i++) {
    age = t - past->samples[i][0];
    if (age > 0.0 && (found < 0 || age <= window_s + records_ROUNDING_S)) {
      found = i;
    }
  }
  if (found < 0) {
    return (Tb3d){false, t, 0.0, 0.0};
  }
  return (Tb3d){true, past->samples[found][0], past->samples[found][1], past->samples[found][2]};
}

/* Carry the mean velocity of the window on over the horizon. */
T10d predictors_linear_step(predictors_linear_Memory * memory, T10d motion) {
  records_MotionRow m;
  predictors_linear_Settings * settings;
  predictors_movement_State * s;
  predictors_linear_Past * past;
  int64_t fault;
  bool new, any_before;
  double phase, before_t, before_x, before_y, ahead;
  m = records_MotionRow_of_T10d(motion);
  settings = &memory->settings;
  s = &memory->state.movement;
  past = &memory->state.past;
  Tqbd values_1 = predictors_movement_follow(s, m);
  fault = values_1.f0;
  new = values_1.f1;
  if (fault != records_FINE) {
    return predictors_movement_refuse(s, m, fault);
  }
  if (new) {
    past->count = 0.0;
  }
  phase = predictors_movement_phase(s, m);
  Tb3d values_2 = predictors_linear_before(past, settings->window_s, m.t);
  any_before = values_2.f0;
  before_t = values_2.f1;
  before_x = values_2.f2;
  before_y = values_2.f3;
  predictors_linear_remember(past, settings->window_s, m.t, m.x, m.y);
  if (!any_before) {
    return records_endpoint(m.t, NAN, NAN, phase);
  }
  ahead = settings->horizon_s / max_float(m.t - before_t, settings->window_s / predictors_linear_CAPACITY);
  return records_endpoint(m.t, m.x + ahead * (m.x - before_x), m.y + ahead * (m.y - before_y), phase);
}

/* Divide the way done by the share that the speed says is done. */
T10d predictors_minimum_jerk_step(predictors_movement_State * s, T10d motion) {
  records_MotionRow m;
  int64_t fault;
  double phase, tau, done, ahead;
  m = records_MotionRow_of_T10d(motion);
  Tqbd values_1 = predictors_movement_follow(s, m);
  fault = values_1.f0;
  if (fault != records_FINE) {
    return predictors_movement_refuse(s, m, fault);
  }
  phase = predictors_movement_phase(s, m);
  if (s->peak < predictors_movement_STILL_M_S) {
    return records_endpoint(m.t, NAN, NAN, phase);
  }
  T2d values_2 = predictors_minimum_jerk_progress(hypot(m.vx, m.vy) / s->peak);
  tau = values_2.f0;
  done = values_2.f1;
  ahead = (1.0 - done) / done;
  return (T10d){m.t, m.x + ahead * (m.x - s->x0), m.y + ahead * (m.y - s->y0), NAN, NAN, NAN, (m.t - s->t0) * (1.0 - tau) / tau, phase, NAN, NAN};
}

/* The density above which places of the probability ``level`` lie: exact for a single part. */
double predictors_mixture_threshold_of(Table parts, int64_t count, double level, int64_t points) {
  predictors_mixture_PartRow * first, *part;
  double far, log_density, most, low, high, middle;
  Table known;
  if (count == 1) {
    first = (predictors_mixture_PartRow *)((Vector){parts.p + 0 * parts.m, parts.m}.p);
    far = predictors_mixture_squared_radius(level, first->tail);
    log_density = first->tail == 0.0 ? -0.5 * far : -0.5 * (first->tail + 2.0) * log1p(far / first->tail);
    return predictors_mixture_part_density(first, first->x, first->y) * exp(log_density);
  }
  RELEASED double *buffer_1 = reserved(count * points);
  known = (Table){buffer_1, count, points};
  predictors_mixture_densities(parts, count, points, known);
  most = predictors_mixture_DENSITY_LEAST;
  for (int64_t k = 0; k < count; k++) {
    part = (predictors_mixture_PartRow *)((Vector){parts.p + k * parts.m, parts.m}.p);
    most = most + predictors_mixture_part_density(part, part->x, part->y);
  }
  low = log(predictors_mixture_DENSITY_LEAST);
  high = log(most);
  for (int64_t i_2 = 0; i_2 < predictors_mixture_HALVINGS; i_2++) {
    middle = 0.5 * (low + high);
    if (predictors_mixture_share_above(parts, count, points, known, exp(middle)) > level) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return exp(0.5 * (low + high));
}

/* Squared Mahalanobis distance beyond which one of the parts is less than its portion of a threshold. */
double predictors_mixture_reach(predictors_mixture_PartRow * part, int64_t count, double threshold) {
  double over, tail;
  over = predictors_mixture_part_density(part, part->x, part->y) * count / threshold;
  if (!(over > 1.0)) {
    return -1.0;
  }
  tail = part->tail;
  return tail == 0.0 ? 2.0 * log(over) : tail * expm1(2.0 * log(over) / (tail + 2.0));
}

/* Lay out the lines of the grid in one direction, ascending; returns how many. ``across``: 0 x, 1 y. */
int64_t predictors_mixture_lines_of(Table parts, int64_t count, double threshold, int64_t across, Vector out) {
  int64_t total, lines, place;
  predictors_mixture_PartRow * part;
  double centre, scale, far, at, value;
  total = 0;
  lines = max_whole(min_whole(predictors_mixture_LINES, floor_divided_whole(predictors_mixture_LINES_OF, count)), predictors_mixture_LINES_LEAST);
  for (int64_t k = 0; k < count; k++) {
    part = (predictors_mixture_PartRow *)((Vector){parts.p + k * parts.m, parts.m}.p);
    centre = part->x;
    scale = part->sxx;
    if (across == 1) {
      centre = part->y;
      scale = part->syy;
    }
    far = predictors_mixture_reach(part, count, threshold);
    for (int64_t i = 0; i < lines; i++) {
      if (far > 0.0) {
        at = 2.0 * i / (lines - 1.0) - 1.0;
        at *= predictors_mixture_AT_CENTRE + (1.0 - predictors_mixture_AT_CENTRE) * at * at;
        value = centre + predictors_mixture_OUTSIDE * at * sqrt(far * scale);
        place = total;
        while (place > 0 && out.p[place - 1] > value) {
          out.p[place] = out.p[place - 1];
          place -= 1;
        }
        out.p[place] = value;
        total += 1;
      }
    }
  }
  return total;
}

/* The logarithm of the density over the threshold. */
double predictors_mixture_height(Table parts, int64_t count, double threshold, double x, double y) {
  return log(max_float(predictors_mixture_density(parts, count, x, y), predictors_mixture_DENSITY_LEAST)) - log(threshold);
}

/* Where the density is the threshold between two places, each x, y and its height of another sign. */
T2d predictors_mixture_crossing(Table parts, int64_t count, double threshold, T3d one, T3d other) {
  double x0, y0, h0, x1, y1, h1, x, y, part, h;
  x0 = one.f0;
  y0 = one.f1;
  h0 = one.f2;
  x1 = other.f0;
  y1 = other.f1;
  h1 = other.f2;
  x = x0;
  y = y0;
  for (int64_t i_1 = 0; i_1 < predictors_mixture_CLOSER; i_1++) {
    part = h0 / (h0 - h1);
    x = x0 + part * (x1 - x0);
    y = y0 + part * (y1 - y0);
    h = predictors_mixture_height(parts, count, threshold, x, y);
    if ((h > 0.0) == (h0 > 0.0)) {
      x0 = x;
      y0 = y;
      h0 = h;
    } else {
      x1 = x;
      y1 = y;
      h1 = h;
    }
  }
  return (T2d){x, y};
}

/* The number of an edge of the cell at column ``i``, row ``j``: 0 below, 1 right, 2 above, 3 left. */
int64_t predictors_mixture_edge_of(int64_t side, int64_t i, int64_t j, int64_t columns, int64_t rows) {
  if (side == 0) {
    return j * columns + i;
  }
  if (side == 2) {
    return (j + 1) * columns + i;
  }
  return rows * columns + j * columns + (side == 1 ? i + 1 : i);
}

/* The side where a contour that enters a cell at ``side`` leaves it. */
int64_t predictors_mixture_partner(Vector sides, int64_t side, double middle) {
  int64_t way, other;
  way = middle > 0.0 ? 1 : 3;
  for (int64_t k = 1; k < 4; k++) {
    other = remainder_whole(side + way * k, 4);
    if (sides.p[other] == 1.0) {
      return other;
    }
  }
  return side;
}

/* For each edge that a contour crosses the edge that it crosses next, the region on its left; else -1. */
void predictors_mixture_follow_cells(Table heights, Table middles, int64_t columns, int64_t rows, Vector following) {
  Vector corners, sides;
  bool here, there;
  int64_t end, start;
  double buffer_1[4];
  double buffer_2[4];
  corners = (Vector){buffer_1, 4};
  sides = (Vector){buffer_2, 4};
  for (int64_t n = 0, end_3 = 2 * columns * rows; n < end_3; n++) {
    following.p[n] = -1.0;
  }
  for (int64_t j = 0, end_4 = rows - 1; j < end_4; j++) {
    for (int64_t i = 0, end_5 = columns - 1; i < end_5; i++) {
      corners.p[0] = heights.p[j * heights.m + i];
      corners.p[1] = heights.p[j * heights.m + i + 1];
      corners.p[2] = heights.p[(j + 1) * heights.m + i + 1];
      corners.p[3] = heights.p[(j + 1) * heights.m + i];
      for (int64_t side = 0; side < 4; side++) {
        here = corners.p[side] > 0.0;
        there = corners.p[remainder_whole(side + 1, 4)] > 0.0;
        sides.p[side] = here == there ? 0.0 : here ? -1.0 : 1.0;
      }
      for (int64_t side = 0; side < 4; side++) {
        if (sides.p[side] == -1.0) {
          end = predictors_mixture_partner(sides, side, middles.p[j * middles.m + i]);
          start = predictors_mixture_edge_of(side, i, j, columns, rows);
          following.p[start] = predictors_mixture_edge_of(end, i, j, columns, rows);
        }
      }
    }
  }
}

/* Write the contours; returns how many there are. */
int64_t predictors_mixture_outlines(Table parts, int64_t count, double threshold, Table points, Vector ends) {
  Vector xs, ys, following;
  int64_t columns, rows, total, polygons, edge, before, place, row, column, below, beside, after;
  Table heights, middles;
  bool upright;
  T3d one, other;
  RELEASED double *buffer_1 = reserved((count * predictors_mixture_LINES));
  RELEASED double *buffer_2 = reserved((count * predictors_mixture_LINES));
  xs = (Vector){buffer_1, count * predictors_mixture_LINES};
  ys = (Vector){buffer_2, count * predictors_mixture_LINES};
  columns = predictors_mixture_lines_of(parts, count, threshold, 0, xs);
  rows = predictors_mixture_lines_of(parts, count, threshold, 1, ys);
  if (columns == 0 || rows == 0) {
    return 0;
  }
  RELEASED double *buffer_3 = reserved(rows * columns);
  RELEASED double *buffer_4 = reserved(rows * columns);
  heights = (Table){buffer_3, rows, columns};
  middles = (Table){buffer_4, rows, columns};
  for (int64_t j = 0; j < rows; j++) {
    for (int64_t i = 0; i < columns; i++) {
      heights.p[j * heights.m + i] = predictors_mixture_height(parts, count, threshold, xs.p[i], ys.p[j]);
    }
  }
  for (int64_t j = 0, end_5 = rows - 1; j < end_5; j++) {
    for (int64_t i = 0, end_6 = columns - 1; i < end_6; i++) {
      middles.p[j * middles.m + i] = 0.25 * (heights.p[j * heights.m + i] + heights.p[j * heights.m + i + 1] + heights.p[(j + 1) * heights.m + i] + heights.p[(j + 1) * heights.m + i + 1]);
    }
  }
  RELEASED double *buffer_7 = reserved((2 * columns * rows));
  following = (Vector){buffer_7, 2 * columns * rows};
  predictors_mixture_follow_cells(heights, middles, columns, rows, following);
  total = 0;
  polygons = 0;
  for (int64_t first = 0, end_8 = 2 * columns * rows; first < end_8; first++) {
    edge = first;
    before = total;
    while (following.p[edge] >= 0.0 && total < points.n && polygons < ends.n) {
      upright = edge >= columns * rows;
      place = upright ? edge - columns * rows : edge;
      row = floor_divided_whole(place, columns);
      column = remainder_whole(place, columns);
      T2q values_9 = upright ? (T2q){row + 1, column} : (T2q){row, column + 1};
      below = values_9.f0;
      beside = values_9.f1;
      one = (T3d){xs.p[column], ys.p[row], heights.p[row * heights.m + column]};
      other = (T3d){xs.p[beside], ys.p[below], heights.p[below * heights.m + beside]};
      T2d values_10 = predictors_mixture_crossing(parts, count, threshold, one, other);
      points.p[total * points.m + 0] = values_10.f0;
      points.p[total * points.m + 1] = values_10.f1;
      total += 1;
      after = (int64_t)following.p[edge];
      following.p[edge] = -1.0;
      edge = after;
    }
    if (total > before) {
      ends.p[polygons] = total;
      polygons += 1;
    }
  }
  return polygons;
}

/* How many points of each of so many parts are enough. */
int64_t predictors_mixture_points_of(int64_t count) {
  return max_whole(min_whole(predictors_mixture_POINTS, floor_divided_whole(predictors_mixture_POINTS_OF, count)), predictors_mixture_POINTS_LEAST);
}

/* One sample of one axis (figure 2.4); returns the endpoint in px from the movement's start. */
double predictors_switched_advance(predictors_switched_Settings * settings, predictors_switched_Axis * axis, double t, double x, double v, double a) {
  double dx, before;
  regression_drem_Regression regression;
  Vector w, theta;
  bool solved;
  dx = x - axis->x;
  before = axis->endpoint;
  axis->x = x;
  axis->peak = max_float(axis->peak, fabs(v));
  regression = regression_drem_parts((Vector){axis->numbers, 695}, predictors_switched_UNKNOWNS);
  w = regression.w;
  theta = regression.theta;
  w.p[0] = -a;
  w.p[1] = -v;
  w.p[2] = 1.0;
  if (fabs(v) < settings->threshold * axis->peak) {
    theta.p[predictors_switched_T] = before;
    solved = regression_drem_advance(&axis->regression, regression, settings->delay_s, settings->gamma, t, x);
    if (solved && fabs(theta.p[predictors_switched_T] - before) < settings->bound * fabs(x)) {
      axis->endpoint = theta.p[predictors_switched_T];
    }
  } else {
    regression_drem_remember(&axis->regression, regression, settings->delay_s, t, x);
    if (a * v >= 0.0) {
      axis->endpoint = before + 2.0 * dx;
    }
  }
  return axis->endpoint;
}

/* Both axes, each in its own phase (Remark 2.5.1). */
T10d predictors_switched_step(predictors_switched_Memory * memory, T10d motion) {
  records_MotionRow m;
  predictors_switched_Settings * settings;
  predictors_movement_State * s;
  predictors_switched_Axis * x, *y;
  int64_t fault;
  bool new;
  double since, end_x, end_y;
  m = records_MotionRow_of_T10d(motion);
  settings = &memory->settings;
  s = &memory->state.movement;
  x = &memory->state.x;
  y = &memory->state.y;
  Tqbd values_1 = predictors_movement_follow(s, m);
  fault = values_1.f0;
  new = values_1.f1;
  if (fault != records_FINE) {
    return predictors_movement_refuse(s, m, fault);
  }
  if (new) {
    memset(x, 0, sizeof(predictors_switched_Axis));
    memset(y, 0, sizeof(predictors_switched_Axis));
  }
  since = m.t - s->t0;
  double value_2 = s->x0;
  double value_3 = predictors_switched_advance(settings, x, since, m.x - s->x0, m.vx, m.ax);
  end_x = value_2 + value_3;
  double value_4 = s->y0;
  double value_5 = predictors_switched_advance(settings, y, since, m.y - s->y0, m.vy, m.ay);
  end_y = value_4 + value_5;
  return records_endpoint(m.t, end_x, end_y, predictors_movement_phase(s, m));
}

/* A movement starts at rest at (x, y). */
void predictors_switched_direction_begin_submovement(predictors_switched_direction_Submovement * s, double x, double y) {
  s->peak = 0.0;
  s->valley = 0.0;
  s->peak_x = x;
  s->peak_y = y;
  s->valley_x = x;
  s->valley_y = y;
  s->start_x = x;
  s->start_y = y;
}

/* Take one sample in; a rise of the speed by ``rise`` of the peak out of a valley is a new sub-movement. */
void predictors_switched_direction_follow_submovement(predictors_switched_direction_Submovement * s, double rise, double x, double y, double speed) {
  if (speed < s->peak && speed <= s->valley + rise * s->peak) {
    if (speed <= s->valley) {
      s->valley = speed;
      s->valley_x = x;
      s->valley_y = y;
    }
    return;
  }
  if (speed < s->peak) {
    double value_1 = s->valley_x;
    double value_2 = s->valley_y;
    s->start_x = value_1;
    s->start_y = value_2;
  }
  s->peak = speed;
  s->peak_x = x;
  s->peak_y = y;
  s->valley = speed;
  s->valley_x = x;
  s->valley_y = y;
}

/* Averaged gain g in px/m by least squares, displacement = g times the hand's; 0 where unknown. */
double predictors_switched_direction_gain(predictors_switched_direction_Hand * hand, double dt, double away_x, double away_y, double vx, double vy) {
  hand->x += 0.5 * dt * (vx + hand->vx);
  hand->y += 0.5 * dt * (vy + hand->vy);
  hand->vx = vx;
  hand->vy = vy;
  hand->cross += dt * (away_x * hand->x + away_y * hand->y);
  hand->square_ += dt * (hand->x * hand->x + hand->y * hand->y);
  if (!(hand->cross > 0.0 && hand->square_ > 0.0)) {
    return 0.0;
  }
  return hand->cross / hand->square_;
}

/* Time constant at the peak in s, from the sub-movement's own, way done / peak speed, and a typical. */
double predictors_switched_direction_time_constant(double own, double typical_s, double done, double peak) {
  if (own == 0.0) {
    return typical_s;
  }
  return pow(done / peak, own) * pow(typical_s, 1.0 - own);
}

/* Rate k in 1/s of the approach V = k (T - x): from the switch and the slope since; 0 where unknown. */
double predictors_switched_direction_approach(predictors_switched_direction_Settings * settings, predictors_switched_direction_Submovement * s, double px_m, double x, double y, double speed) {
  double done, at_switch, since, slope, share;
  done = hypot(s->peak_x - s->start_x, s->peak_y - s->start_y);
  if (done == 0.0) {
    return 0.0;
  }
  at_switch = 1.0 / predictors_switched_direction_time_constant(settings->own, settings->typical_s, done, s->peak * px_m);
  since = hypot(x - s->peak_x, y - s->peak_y);
  slope = since > 0.0 ? (s->peak - speed) * px_m / since : 0.0;
  share = pow(speed / s->peak, settings->turn);
  return share * at_switch + (1.0 - share) * settings->watched * slope;
}

/* Follow the sub-movement and add what is left of it in the direction of the hand. */
T10d predictors_switched_direction_step(predictors_switched_direction_Memory * memory, T10d motion) {
  records_MotionRow m;
  predictors_switched_direction_Settings * settings;
  predictors_movement_State * s;
  predictors_switched_direction_Submovement * submovement;
  predictors_switched_direction_Hand * hand;
  int64_t fault;
  bool new, known;
  double dt, speed, px_m, rate, ahead_s, braking, end_x, end_y;
  m = records_MotionRow_of_T10d(motion);
  settings = &memory->settings;
  s = &memory->state.movement;
  submovement = &memory->state.submovement;
  hand = &memory->state.hand;
  Tqbd values_1 = predictors_movement_follow(s, m);
  fault = values_1.f0;
  new = values_1.f1;
  dt = values_1.f2;
  if (fault != records_FINE) {
    return predictors_movement_refuse(s, m, fault);
  }
  if (new) {
    memset(hand, 0, sizeof(predictors_switched_direction_Hand));
  }
  if (new || m.t == s->t0) {
    predictors_switched_direction_begin_submovement(submovement, m.x, m.y);
  }
  speed = hypot(m.vx, m.vy);
  predictors_switched_direction_follow_submovement(submovement, settings->rise, m.x, m.y, speed);
  px_m = predictors_switched_direction_gain(hand, dt, m.x - s->x0, m.y - s->y0, m.vx, m.vy);
  known = px_m > 0.0 && speed > predictors_movement_STILL_M_S;
  rate = known ? predictors_switched_direction_approach(settings, submovement, px_m, m.x, m.y, speed) : 0.0;
  ahead_s = rate > 0.0 ? 1.0 / rate : 0.0;
  braking = -(m.ax * m.vx + m.ay * m.vy);
  if (braking > 0.0 && ahead_s * braking > settings->stopping * speed * speed) {
    ahead_s = settings->stopping * speed * speed / braking;
  }
  end_x = m.x + ahead_s * px_m * m.vx;
  end_y = m.y + ahead_s * px_m * m.vy;
  return records_endpoint(m.t, end_x, end_y, predictors_movement_phase(s, m));
}

void loop__stage_learn_nothing__records_row_at__predictors_minimum_jerk_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out) {
  T10d answer;
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      stage_learn_nothing(memory);
      fill((Vector){memory.p + first, memory.n - first}, 0.0);
    }
    answer = predictors_minimum_jerk_step((predictors_movement_State *)memory.p, records_row_at(rows, i));
    for (int64_t j = 0; j < 10; j++) {
      out.p[i * out.m + j] = ((const double *)&answer)[j];
    }
  }
}

void loop__stage_learn_nothing__records_row_at__predictors_delphian_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out) {
  T10d answer;
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      stage_learn_nothing(memory);
      fill((Vector){memory.p + first, memory.n - first}, 0.0);
    }
    answer = predictors_delphian_step((predictors_delphian_Memory *)memory.p, records_row_at(rows, i));
    for (int64_t j = 0; j < 10; j++) {
      out.p[i * out.m + j] = ((const double *)&answer)[j];
    }
  }
}

void loop__stage_learn_nothing__records_row_at__predictors_hold_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out) {
  T10d answer;
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      stage_learn_nothing(memory);
      fill((Vector){memory.p + first, memory.n - first}, 0.0);
    }
    answer = predictors_hold_step((predictors_movement_State *)memory.p, records_row_at(rows, i));
    for (int64_t j = 0; j < 10; j++) {
      out.p[i * out.m + j] = ((const double *)&answer)[j];
    }
  }
}

void loop__stage_learn_nothing__records_row_at__predictors_kalman_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out) {
  T10d answer;
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      stage_learn_nothing(memory);
      fill((Vector){memory.p + first, memory.n - first}, 0.0);
    }
    answer = predictors_kalman_step((predictors_kalman_Memory *)memory.p, records_row_at(rows, i));
    for (int64_t j = 0; j < 10; j++) {
      out.p[i * out.m + j] = ((const double *)&answer)[j];
    }
  }
}

void loop__stage_learn_nothing__records_row_at__predictors_kep_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out) {
  T10d answer;
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      stage_learn_nothing(memory);
      fill((Vector){memory.p + first, memory.n - first}, 0.0);
    }
    answer = predictors_kep_step((predictors_kep_Memory *)memory.p, records_row_at(rows, i));
    for (int64_t j = 0; j < 10; j++) {
      out.p[i * out.m + j] = ((const double *)&answer)[j];
    }
  }
}

void loop__predictors_ktm_conclude__records_row_at__predictors_ktm_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out) {
  T10d answer;
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      predictors_ktm_conclude((predictors_ktm_Memory *)memory.p);
      fill((Vector){memory.p + first, memory.n - first}, 0.0);
    }
    answer = predictors_ktm_step((predictors_ktm_Memory *)memory.p, records_row_at(rows, i));
    for (int64_t j = 0; j < 10; j++) {
      out.p[i * out.m + j] = ((const double *)&answer)[j];
    }
  }
}

void loop__stage_learn_nothing__records_row_at__predictors_linear_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out) {
  T10d answer;
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      stage_learn_nothing(memory);
      fill((Vector){memory.p + first, memory.n - first}, 0.0);
    }
    answer = predictors_linear_step((predictors_linear_Memory *)memory.p, records_row_at(rows, i));
    for (int64_t j = 0; j < 10; j++) {
      out.p[i * out.m + j] = ((const double *)&answer)[j];
    }
  }
}

void loop__stage_learn_nothing__records_row_at__predictors_switched_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out) {
  T10d answer;
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      stage_learn_nothing(memory);
      fill((Vector){memory.p + first, memory.n - first}, 0.0);
    }
    answer = predictors_switched_step((predictors_switched_Memory *)memory.p, records_row_at(rows, i));
    for (int64_t j = 0; j < 10; j++) {
      out.p[i * out.m + j] = ((const double *)&answer)[j];
    }
  }
}

void loop__stage_learn_nothing__records_row_at__predictors_switched_direction_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out) {
  T10d answer;
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      stage_learn_nothing(memory);
      fill((Vector){memory.p + first, memory.n - first}, 0.0);
    }
    answer = predictors_switched_direction_step((predictors_switched_direction_Memory *)memory.p, records_row_at(rows, i));
    for (int64_t j = 0; j < 10; j++) {
      out.p[i * out.m + j] = ((const double *)&answer)[j];
    }
  }
}

T10d joint__differentiators_difference_step__predictors_minimum_jerk_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_difference_step((differentiators_difference_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_minimum_jerk_step((predictors_movement_State *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

bool follow__predictors_minimum_jerk_step(Vector memory, T10d row) {
  double t;
  t = predictors_minimum_jerk_step((predictors_movement_State *)memory.p, row).f0;
  return t == t;
}

T10d last__differentiators_difference_step__follow__predictors_minimum_jerk_step__predictors_minimum_jerk_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_difference_step((differentiators_difference_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_minimum_jerk_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_difference_step((differentiators_difference_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_minimum_jerk_step((predictors_movement_State *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_homogeneous_step__predictors_minimum_jerk_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_minimum_jerk_step((predictors_movement_State *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

T10d last__differentiators_homogeneous_step__follow__predictors_minimum_jerk_step__predictors_minimum_jerk_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_minimum_jerk_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_minimum_jerk_step((predictors_movement_State *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_kalman_step__predictors_minimum_jerk_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_minimum_jerk_step((predictors_movement_State *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

T10d last__differentiators_kalman_step__follow__predictors_minimum_jerk_step__predictors_minimum_jerk_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_minimum_jerk_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_minimum_jerk_step((predictors_movement_State *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_difference_step__predictors_delphian_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_difference_step((differentiators_difference_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_delphian_step((predictors_delphian_Memory *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

bool follow__predictors_delphian_step(Vector memory, T10d row) {
  double t;
  t = predictors_delphian_step((predictors_delphian_Memory *)memory.p, row).f0;
  return t == t;
}

T10d last__differentiators_difference_step__follow__predictors_delphian_step__predictors_delphian_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_difference_step((differentiators_difference_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_delphian_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_difference_step((differentiators_difference_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_delphian_step((predictors_delphian_Memory *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_homogeneous_step__predictors_delphian_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_delphian_step((predictors_delphian_Memory *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

T10d last__differentiators_homogeneous_step__follow__predictors_delphian_step__predictors_delphian_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_delphian_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_delphian_step((predictors_delphian_Memory *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_kalman_step__predictors_delphian_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_delphian_step((predictors_delphian_Memory *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

T10d last__differentiators_kalman_step__follow__predictors_delphian_step__predictors_delphian_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_delphian_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_delphian_step((predictors_delphian_Memory *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_difference_step__predictors_hold_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_difference_step((differentiators_difference_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_hold_step((predictors_movement_State *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

bool follow__predictors_hold_step(Vector memory, T10d row) {
  double t;
  t = predictors_hold_step((predictors_movement_State *)memory.p, row).f0;
  return t == t;
}

T10d last__differentiators_difference_step__follow__predictors_hold_step__predictors_hold_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_difference_step((differentiators_difference_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_hold_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_difference_step((differentiators_difference_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_hold_step((predictors_movement_State *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_homogeneous_step__predictors_hold_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_hold_step((predictors_movement_State *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

T10d last__differentiators_homogeneous_step__follow__predictors_hold_step__predictors_hold_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_hold_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_hold_step((predictors_movement_State *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_kalman_step__predictors_hold_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_hold_step((predictors_movement_State *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

T10d last__differentiators_kalman_step__follow__predictors_hold_step__predictors_hold_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_hold_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_hold_step((predictors_movement_State *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_difference_step__predictors_kalman_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_difference_step((differentiators_difference_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_kalman_step((predictors_kalman_Memory *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

bool follow__predictors_kalman_step(Vector memory, T10d row) {
  double t;
  t = predictors_kalman_step((predictors_kalman_Memory *)memory.p, row).f0;
  return t == t;
}

T10d last__differentiators_difference_step__follow__predictors_kalman_step__predictors_kalman_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_difference_step((differentiators_difference_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_kalman_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_difference_step((differentiators_difference_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_kalman_step((predictors_kalman_Memory *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_homogeneous_step__predictors_kalman_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_kalman_step((predictors_kalman_Memory *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

T10d last__differentiators_homogeneous_step__follow__predictors_kalman_step__predictors_kalman_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_kalman_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_kalman_step((predictors_kalman_Memory *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_kalman_step__predictors_kalman_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_kalman_step((predictors_kalman_Memory *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

T10d last__differentiators_kalman_step__follow__predictors_kalman_step__predictors_kalman_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_kalman_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_kalman_step((predictors_kalman_Memory *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_difference_step__predictors_kep_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_difference_step((differentiators_difference_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_kep_step((predictors_kep_Memory *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

bool follow__predictors_kep_step(Vector memory, T10d row) {
  double t;
  t = predictors_kep_step((predictors_kep_Memory *)memory.p, row).f0;
  return t == t;
}

T10d last__differentiators_difference_step__follow__predictors_kep_step__predictors_kep_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_difference_step((differentiators_difference_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_kep_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_difference_step((differentiators_difference_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_kep_step((predictors_kep_Memory *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_homogeneous_step__predictors_kep_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_kep_step((predictors_kep_Memory *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

T10d last__differentiators_homogeneous_step__follow__predictors_kep_step__predictors_kep_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_kep_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_kep_step((predictors_kep_Memory *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_kalman_step__predictors_kep_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_kep_step((predictors_kep_Memory *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

T10d last__differentiators_kalman_step__follow__predictors_kep_step__predictors_kep_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_kep_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_kep_step((predictors_kep_Memory *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_difference_step__predictors_ktm_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_difference_step((differentiators_difference_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_ktm_step((predictors_ktm_Memory *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

bool follow__predictors_ktm_step(Vector memory, T10d row) {
  double t;
  t = predictors_ktm_step((predictors_ktm_Memory *)memory.p, row).f0;
  return t == t;
}

T10d last__differentiators_difference_step__follow__predictors_ktm_step__predictors_ktm_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_difference_step((differentiators_difference_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_ktm_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_difference_step((differentiators_difference_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_ktm_step((predictors_ktm_Memory *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_homogeneous_step__predictors_ktm_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_ktm_step((predictors_ktm_Memory *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

T10d last__differentiators_homogeneous_step__follow__predictors_ktm_step__predictors_ktm_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_ktm_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_ktm_step((predictors_ktm_Memory *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_kalman_step__predictors_ktm_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_ktm_step((predictors_ktm_Memory *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

T10d last__differentiators_kalman_step__follow__predictors_ktm_step__predictors_ktm_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_ktm_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_ktm_step((predictors_ktm_Memory *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_difference_step__predictors_linear_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_difference_step((differentiators_difference_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_linear_step((predictors_linear_Memory *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

bool follow__predictors_linear_step(Vector memory, T10d row) {
  double t;
  t = predictors_linear_step((predictors_linear_Memory *)memory.p, row).f0;
  return t == t;
}

T10d last__differentiators_difference_step__follow__predictors_linear_step__predictors_linear_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_difference_step((differentiators_difference_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_linear_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_difference_step((differentiators_difference_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_linear_step((predictors_linear_Memory *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_homogeneous_step__predictors_linear_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_linear_step((predictors_linear_Memory *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

T10d last__differentiators_homogeneous_step__follow__predictors_linear_step__predictors_linear_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_linear_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_linear_step((predictors_linear_Memory *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_kalman_step__predictors_linear_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_linear_step((predictors_linear_Memory *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

T10d last__differentiators_kalman_step__follow__predictors_linear_step__predictors_linear_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_linear_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_linear_step((predictors_linear_Memory *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_difference_step__predictors_switched_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_difference_step((differentiators_difference_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_switched_step((predictors_switched_Memory *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

bool follow__predictors_switched_step(Vector memory, T10d row) {
  double t;
  t = predictors_switched_step((predictors_switched_Memory *)memory.p, row).f0;
  return t == t;
}

T10d last__differentiators_difference_step__follow__predictors_switched_step__predictors_switched_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_difference_step((differentiators_difference_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_switched_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_difference_step((differentiators_difference_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_switched_step((predictors_switched_Memory *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_homogeneous_step__predictors_switched_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_switched_step((predictors_switched_Memory *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

T10d last__differentiators_homogeneous_step__follow__predictors_switched_step__predictors_switched_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_switched_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_switched_step((predictors_switched_Memory *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_kalman_step__predictors_switched_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_switched_step((predictors_switched_Memory *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

T10d last__differentiators_kalman_step__follow__predictors_switched_step__predictors_switched_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_switched_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_switched_step((predictors_switched_Memory *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_difference_step__predictors_switched_direction_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_difference_step((differentiators_difference_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_switched_direction_step((predictors_switched_direction_Memory *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

bool follow__predictors_switched_direction_step(Vector memory, T10d row) {
  double t;
  t = predictors_switched_direction_step((predictors_switched_direction_Memory *)memory.p, row).f0;
  return t == t;
}

T10d last__differentiators_difference_step__follow__predictors_switched_direction_step__predictors_switched_direction_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_difference_step((differentiators_difference_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_switched_direction_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_difference_step((differentiators_difference_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_switched_direction_step((predictors_switched_direction_Memory *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_homogeneous_step__predictors_switched_direction_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_switched_direction_step((predictors_switched_direction_Memory *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

T10d last__differentiators_homogeneous_step__follow__predictors_switched_direction_step__predictors_switched_direction_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_switched_direction_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_switched_direction_step((predictors_switched_direction_Memory *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_kalman_step__predictors_switched_direction_step(Vector memory, Vector other, records_EventRow row) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_switched_direction_step((predictors_switched_direction_Memory *)other.p, answer);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

T10d last__differentiators_kalman_step__follow__predictors_switched_direction_step__predictors_switched_direction_step(Vector memory, Vector other, Table rows) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !follow__predictors_switched_direction_step(other, between)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_switched_direction_step((predictors_switched_direction_Memory *)other.p, between);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}
