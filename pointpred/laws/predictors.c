/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const int64_t predictors_delphian_AT = 3;
static const int64_t predictors_delphian_FALL = 2;
static const int64_t predictors_delphian_FALLEN = 16;
static const int64_t predictors_delphian_OFFSET = 1;
static const int64_t predictors_delphian_PEAK_X = 12;
static const int64_t predictors_delphian_PEAK_Y = 13;
static const int64_t predictors_delphian_SLOPE = 0;
static const int64_t predictors_delphian_UNIT_X = 14;
static const int64_t predictors_delphian_UNIT_Y = 15;
static const int64_t predictors_hold_AT = 0;
static const int64_t predictors_kalman_AT = 4;
static const int64_t predictors_kalman_END = 25;
static const int64_t predictors_kalman_GAP_S = 3;
static const int64_t predictors_kalman_HORIZON_S = 0;
static const int64_t predictors_kalman_JERK_DENSITY = 1;
static const int64_t predictors_kalman_MEAN_X = 13;
static const int64_t predictors_kalman_MEAN_Y = 16;
static const int64_t predictors_kalman_NOISE_PX = 2;
static const double predictors_kalman_PRIOR_ACCELERATION = 1000.0;
static const double predictors_kalman_PRIOR_SPEED = 100.0;
static const int64_t predictors_kalman_SPREAD = 19;
static const int64_t predictors_kep_ACCEPTED = 56;
static const int64_t predictors_kep_ACCEPTED_X = 57;
static const int64_t predictors_kep_ACCEPTED_Y = 58;
static const int64_t predictors_kep_AT = 3;
static const int64_t predictors_kep_CHANGE_MOST = 2;
static const int64_t predictors_kep_COEFFICIENTS = 50;
static const int64_t predictors_kep_DEGREE = 0;
static const double predictors_kep_EXCITATION_LEAST = 1e-05;
static const int64_t predictors_kep_FIT = 12;
static const int64_t predictors_kep_LENGTH = 55;
static const int64_t predictors_kep_REACH = 1;
static const int64_t predictors_kep_STEPS_MOST = 80;
static const int64_t predictors_ktm_COUNT = 0;
static const int64_t predictors_ktm_DISTANCE = 1;
static const int64_t predictors_ktm_FINAL = 1;
static const int64_t predictors_ktm_GRID_X = 11;
static const int64_t predictors_ktm_GRID_Y = 12;
static const int64_t predictors_ktm_HALF = 4;
static const T22d predictors_ktm_KERNEL = {1.0, 0.9898478033787338, 0.9600054412854777, 0.9122540768285452, 0.8493658165683124, 0.7748374288832494, 0.6925693242051978, 0.6065306597126334, 0.5204501210207021, 0.43756473770026916, 0.360447788597821, 0.2909238070461482, 0.23006629899380912, 0.17826397958504792, 0.1353352832366127, 0.10066889977289781, 0.0733696513683829, 0.0523931410698256, 0.036658041953378, 0.025130488985274403, 0.01687988414878991, 0.011108996538242306};
static const int64_t predictors_ktm_LEARNED = 2;
static const int64_t predictors_ktm_LEARNED_MOST = 0;
static const int64_t predictors_ktm_LENGTH = 0;
static const int64_t predictors_ktm_LIBRARY = 1;
static const int64_t predictors_ktm_LONGEST = 2;
static const int64_t predictors_ktm_LONGEST_OF = 1;
static const int64_t predictors_ktm_MATCH = 25;
static const int64_t predictors_ktm_NEXT = 1;
static const int64_t predictors_ktm_POINTS = 9;
static const int64_t predictors_ktm_POINTS_LEAST = 4;
static const int64_t predictors_ktm_PROFILE = 35;
static const double predictors_ktm_RATE_HZ = 20.0;
static const int64_t predictors_ktm_RECENT = 13;
static const int64_t predictors_ktm_SAMPLES = 10;
static const int64_t predictors_ktm_SCORE = 2;
static const int64_t predictors_ktm_SHORTEST_OF = 2;
static const int64_t predictors_ktm_SHORTEST_PX = 3;
static const int64_t predictors_ktm_SMOOTH = 3;
static const int64_t predictors_ktm_SPEEDS = 2;
static const double predictors_ktm_STAMP_S = 1e-06;
static const double predictors_ktm_STEP_S = 0.05;
static const int64_t predictors_ktm_STORE = 26;
static const int64_t predictors_ktm_SUM = 0;
static const int64_t predictors_ktm_TAPS = 22;
static const int64_t predictors_ktm_TEMPLATES_OF = 0;
static const int64_t predictors_linear_AT = 2;
static const int64_t predictors_linear_CAPACITY = 8;
static const int64_t predictors_linear_COUNT = 11;
static const int64_t predictors_linear_HORIZON_S = 0;
static const int64_t predictors_linear_PAST = 12;
static const int64_t predictors_linear_WINDOW_S = 1;
static const int64_t predictors_minimum_jerk_AT = 0;
static const double predictors_mixture_AT_CENTRE = 0.4;
static const int64_t predictors_mixture_CLOSER = 3;
static const double predictors_mixture_DENSITY_LEAST = 1e-280;
static const int64_t predictors_mixture_HALVINGS = 60;
static const double predictors_mixture_HEAVINESS_LEAST = 1e-06;
static const double predictors_mixture_HEAVINESS_MOST = 40.0;
static const T2d predictors_mixture_LEVELS = {0.5, 0.8};
static const int64_t predictors_mixture_LINES = 24;
static const double predictors_mixture_OUTSIDE = 1.0001;
static const double predictors_mixture_PROBABILITY_MOST = 0.999999999;
static const int64_t predictors_mixture_SHARE = 0;
static const int64_t predictors_mixture_SXX = 3;
static const int64_t predictors_mixture_SXY = 4;
static const int64_t predictors_mixture_SYY = 5;
static const int64_t predictors_mixture_TAIL = 6;
static const double predictors_mixture_TURN_COS = -0.7373688780783197;
static const double predictors_mixture_TURN_SIN = 0.6754902942615238;
static const int64_t predictors_mixture_X = 1;
static const int64_t predictors_mixture_Y = 2;
static const double predictors_movement_BALLISTIC = 1.0;
static const double predictors_movement_CORRECTIVE = 2.0;
static const double predictors_movement_CORRECTIVE_FRACTION = 0.2;
static const int64_t predictors_movement_NUMBERS = 7;
static const double predictors_movement_STILL = 0.0;
static const double predictors_movement_STILL_M_S = 0.002;
static const int64_t predictors_switched_AT = 4;
static const int64_t predictors_switched_BOUND = 1;
static const int64_t predictors_switched_DELAY_S = 2;
static const int64_t predictors_switched_DREM = 3;
static const int64_t predictors_switched_ENDPOINT = 2;
static const int64_t predictors_switched_GAMMA = 3;
static const int64_t predictors_switched_PEAK = 0;
static const int64_t predictors_switched_PLACE = 1;
static const int64_t predictors_switched_THRESHOLD = 0;
static const int64_t predictors_switched_UNKNOWNS = 3;
static const int64_t predictors_switched_X_AXIS = 13;
static const int64_t predictors_switched_Y_AXIS = 715;
static const int64_t predictors_switched_direction_AT = 6;
static const int64_t predictors_switched_direction_CROSS = 27;
static const int64_t predictors_switched_direction_END = 29;
static const int64_t predictors_switched_direction_HAND_X = 25;
static const int64_t predictors_switched_direction_HAND_Y = 26;
static const int64_t predictors_switched_direction_OWN = 2;
static const int64_t predictors_switched_direction_PEAK = 0;
static const int64_t predictors_switched_direction_PEAK_X = 1;
static const int64_t predictors_switched_direction_PEAK_Y = 2;
static const int64_t predictors_switched_direction_RISE = 0;
static const int64_t predictors_switched_direction_SQUARE = 28;
static const int64_t predictors_switched_direction_START_X = 6;
static const int64_t predictors_switched_direction_START_Y = 7;
static const int64_t predictors_switched_direction_STOPPING = 5;
static const int64_t predictors_switched_direction_TURN = 3;
static const int64_t predictors_switched_direction_TYPICAL_S = 1;
static const int64_t predictors_switched_direction_UNIT = 15;
static const int64_t predictors_switched_direction_VALLEY = 3;
static const int64_t predictors_switched_direction_VALLEY_X = 4;
static const int64_t predictors_switched_direction_VALLEY_Y = 5;
static const int64_t predictors_switched_direction_VX = 23;
static const int64_t predictors_switched_direction_VY = 24;
static const int64_t predictors_switched_direction_WATCHED = 4;
static const int64_t records_EVENT_FIELD = 2;
static const int64_t records_FINE = 0;
static const int64_t records_MOTION_FIELD = 8;
static const double records_MOTION_MOST = 1e+300;
static const int64_t records_ORDER = 1;
static const double records_ROUNDING_S = 1e-06;
static const int64_t regression_drem_REGRESSOR = 4;
static const int64_t regression_least_squares_REGRESSOR = 3;

/* The density of a part at a place, times its share, in 1 / px^2. */
double predictors_mixture_part_density(Table parts, int64_t k, double x, double y) {
  double sxx, sxy, syy, tail, determinant, dx, dy, far, log_density;
  sxx = parts.p[k * parts.m + predictors_mixture_SXX];
  sxy = parts.p[k * parts.m + predictors_mixture_SXY];
  syy = parts.p[k * parts.m + predictors_mixture_SYY];
  tail = parts.p[k * parts.m + predictors_mixture_TAIL];
  determinant = sxx * syy - sxy * sxy;
  dx = x - parts.p[k * parts.m + predictors_mixture_X];
  dy = y - parts.p[k * parts.m + predictors_mixture_Y];
  far = (syy * dx * dx - 2.0 * sxy * dx * dy + sxx * dy * dy) / determinant;
  log_density = tail == 0.0 ? -0.5 * far : -0.5 * (tail + 2.0) * log1p(far / tail);
  return parts.p[k * parts.m + predictors_mixture_SHARE] * exp(log_density) / (2.0 * 3.141592653589793 * sqrt(determinant));
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
    total += predictors_mixture_part_density(parts, k, x, y);
  }
  return total;
}

/* The density at so many points of each part, a row of ``out`` each. */
void predictors_mixture_densities(Table parts, int64_t count, int64_t points, Table out) {
  double wide, slant, broad, cos_, sin_, radius, x, y;
  for (int64_t k = 0; k < count; k++) {
    wide = sqrt(parts.p[k * parts.m + predictors_mixture_SXX]);
    slant = parts.p[k * parts.m + predictors_mixture_SXY] / wide;
    broad = sqrt(parts.p[k * parts.m + predictors_mixture_SYY] - slant * slant);
    cos_ = 1.0;
    sin_ = 0.0;
    for (int64_t i = 0; i < points; i++) {
      radius = sqrt(predictors_mixture_squared_radius((i + 0.5) / points, parts.p[k * parts.m + predictors_mixture_TAIL]));
      x = parts.p[k * parts.m + predictors_mixture_X] + radius * wide * cos_;
      y = parts.p[k * parts.m + predictors_mixture_Y] + radius * (slant * cos_ + broad * sin_);
      out.p[k * out.m + i] = predictors_mixture_density(parts, count, x, y);
      double value_1 = cos_ * predictors_mixture_TURN_COS - sin_ * predictors_mixture_TURN_SIN;
      double value_2 = cos_ * predictors_mixture_TURN_SIN + sin_ * predictors_mixture_TURN_COS;
      cos_ = value_1;
      sin_ = value_2;
    }
  }
}

/* The probability of the places that are denser than a threshold; ``known``: by ``densities``. */
double predictors_mixture_share_above(Table parts, int64_t count, int64_t points, Table known, double threshold) {
  double total;
  int64_t above;
  total = 0.0;
  for (int64_t k = 0; k < count; k++) {
    above = 0;
    for (int64_t i = 0; i < points; i++) {
      above += known.p[k * known.m + i] > threshold ? 1 : 0;
    }
    total += parts.p[k * parts.m + predictors_mixture_SHARE] * above / points;
  }
  return total;
}

/* The probability of the places that are denser than a place: exact for a single part. */
double predictors_mixture_content(Table parts, int64_t count, double x, double y, int64_t points) {
  double own, best, tail, power;
  Table known;
  if (count == 1) {
    own = predictors_mixture_part_density(parts, 0, x, y);
    best = predictors_mixture_part_density(parts, 0, parts.p[0 * parts.m + predictors_mixture_X], parts.p[0 * parts.m + predictors_mixture_Y]);
    tail = parts.p[0 * parts.m + predictors_mixture_TAIL];
    power = tail == 0.0 ? 1.0 : tail / (tail + 2.0);
    return 1.0 - pow(own / best, power);
  }
  RELEASED double *buffer_1 = reserved(count * points);
  known = (Table){buffer_1, count, points};
  predictors_mixture_densities(parts, count, points, known);
  return predictors_mixture_share_above(parts, count, points, known, predictors_mixture_density(parts, count, x, y));
}

/* 2 / tail within bounds. */
double predictors_mixture_heaviness(double tail) {
  return min_float(max_float(2.0 / tail, predictors_mixture_HEAVINESS_LEAST), predictors_mixture_HEAVINESS_MOST);
}

/* ``squared_radius_over_tail`` of a level with its offset. */
double predictors_mixture_corrected_radius(double level, double heavy, double offset) {
  double lower;
  lower = exp(min_float(offset, 0.0));
  return exp(max_float(offset, 0.0)) * (exp(-heavy * log(1.0 - level) * lower) - 1.0);
}

/* The probability that the region of a level must have so that it holds that share of the ends. */
double predictors_mixture_corrected_probability(double level, double tail, double near, double far) {
  double radius, half, most, part, heavy, own;
  radius = log(-log(1.0 - level));
  half = log(-log(1.0 - predictors_mixture_LEVELS.f0));
  most = log(-log(1.0 - predictors_mixture_LEVELS.f1));
  part = min_float(max_float((radius - half) / (most - half), 0.0), 1.0);
  heavy = predictors_mixture_heaviness(tail);
  own = predictors_mixture_corrected_radius(level, heavy, near + part * (far - near));
  if (level > predictors_mixture_LEVELS.f0) {
    own = max_float(own, predictors_mixture_corrected_radius(predictors_mixture_LEVELS.f0, heavy, near));
  }
  return min_float(1.0 - exp(-log(1.0 + own) / heavy), predictors_mixture_PROBABILITY_MOST);
}

/* Squared radius of a level's region over the tail; ``heavy``: 2 / tail. */
double predictors_mixture_squared_radius_over_tail(double level, double heavy) {
  return exp(-heavy * log(1.0 - level)) - 1.0;
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

/* Take one motion in: (its fault, a movement starts here, dt in s since the motion before). */
Tqbd predictors_movement_follow(predictors_movement_State * s, records_MotionRow m) {
  double t, x, y, dt;
  int64_t fault;
  bool new;
  t = m.t;
  x = m.x;
  y = m.y;
  fault = predictors_movement_fault_of(s, m);
  if (fault != records_FINE) {
    return (Tqbd){fault, false, 0.0};
  }
  new = m.start == 1.0 || s->known == 0.0;
  dt = new ? 0.0 : t - s->t;
  if (new || t == s->t0) {
    s->t0 = t;
    s->x0 = x;
    s->y0 = y;
    s->path = 0.0;
  } else {
    s->path += hypot(x - s->x, y - s->y);
  }
  if (new) {
    s->peak = 0.0;
  }
  s->known = 1.0;
  s->t = t;
  s->x = x;
  s->y = y;
  s->peak = max_float(s->peak, hypot(m.vx, m.vy));
  return (Tqbd){records_FINE, new, dt};
}

/* Share of the time and of the way done, from the speed as a share of its peak, after the peak. */
T2d predictors_minimum_jerk_progress(double ratio) {
  double tau;
  tau = 0.5 * (1.0 + sqrt(1.0 - sqrt(min_float(max_float(ratio, 0.0), 1.0))));
  return (T2d){tau, tau * tau * tau * (10.0 - tau * (15.0 - 6.0 * tau))};
}

/* The answer to a motion with a fault. */
T10d predictors_movement_refuse(predictors_movement_State * s, records_MotionRow m, int64_t fault) {
  return records_refused(fault, fault == records_ORDER ? s->t : ((const double *)&m)[fault - records_MOTION_FIELD]);
}

/* The phase by speed alone: still, ballistic above a fifth of the peak, corrective below. */
double predictors_movement_phase(predictors_movement_State * s, records_MotionRow m) {
  double speed;
  speed = hypot(m.vx, m.vy);
  if (speed < predictors_movement_STILL_M_S) {
    return predictors_movement_STILL;
  }
  return speed >= predictors_movement_CORRECTIVE_FRACTION * s->peak ? predictors_movement_BALLISTIC : predictors_movement_CORRECTIVE;
}

/* Remember the peak; once the speed has fallen from it, the line says how far it is from there. */
T10d predictors_delphian_step(Vector memory, T10d motion) {
  records_MotionRow m;
  double before, phase, peak, speed, away_x, away_y, away, ahead, end_x, end_y;
  int64_t fault;
  bool new;
  m = records_MotionRow_of_T10d(motion);
  before = ((predictors_movement_State *)(memory.p + predictors_delphian_AT))->peak;
  Tqbd values_1 = predictors_movement_follow((predictors_movement_State *)(memory.p + predictors_delphian_AT), m);
  fault = values_1.f0;
  new = values_1.f1;
  if (fault != records_FINE) {
    return predictors_movement_refuse((predictors_movement_State *)(memory.p + predictors_delphian_AT), m, fault);
  }
  phase = predictors_movement_phase((predictors_movement_State *)(memory.p + predictors_delphian_AT), m);
  if (new) {
    fill((Vector){memory.p + predictors_delphian_PEAK_X, memory.n - predictors_delphian_PEAK_X}, 0.0);
  }
  peak = ((predictors_movement_State *)(memory.p + predictors_delphian_AT))->peak;
  speed = hypot(m.vx, m.vy);
  if (new || peak > before) {
    away_x = m.x - ((predictors_movement_State *)(memory.p + predictors_delphian_AT))->x0;
    away_y = m.y - ((predictors_movement_State *)(memory.p + predictors_delphian_AT))->y0;
    away = hypot(away_x, away_y);
    memory.p[predictors_delphian_PEAK_X] = m.x;
    memory.p[predictors_delphian_PEAK_Y] = m.y;
    memory.p[predictors_delphian_FALLEN] = 0.0;
    memory.p[predictors_delphian_UNIT_X] = away > 0.0 ? away_x / away : 0.0;
    memory.p[predictors_delphian_UNIT_Y] = away > 0.0 ? away_y / away : 0.0;
  } else if (speed < (1.0 - memory.p[predictors_delphian_FALL]) * peak && peak >= predictors_movement_STILL_M_S) {
    memory.p[predictors_delphian_FALLEN] = 1.0;
  }
  if (memory.p[predictors_delphian_FALLEN] == 0.0 || (memory.p[predictors_delphian_UNIT_X] == 0.0 && memory.p[predictors_delphian_UNIT_Y] == 0.0)) {
    return records_endpoint(m.t, NAN, NAN, phase);
  }
  ahead = max_float(memory.p[predictors_delphian_SLOPE] * peak + memory.p[predictors_delphian_OFFSET], 0.0);
  end_x = memory.p[predictors_delphian_PEAK_X] + ahead * memory.p[predictors_delphian_UNIT_X];
  end_y = memory.p[predictors_delphian_PEAK_Y] + ahead * memory.p[predictors_delphian_UNIT_Y];
  return records_endpoint(m.t, end_x, end_y, phase);
}

/* The cursor's position is the answer. */
T10d predictors_hold_step(Vector memory, T10d motion) {
  records_MotionRow m;
  int64_t fault;
  m = records_MotionRow_of_T10d(motion);
  Tqbd values_1 = predictors_movement_follow((predictors_movement_State *)(memory.p + predictors_hold_AT), m);
  fault = values_1.f0;
  if (fault != records_FINE) {
    return predictors_movement_refuse((predictors_movement_State *)(memory.p + predictors_hold_AT), m, fault);
  }
  return records_endpoint(m.t, m.x, m.y, predictors_movement_phase((predictors_movement_State *)(memory.p + predictors_hold_AT), m));
}

/* Expect a cursor that rests at (x, y). */
void predictors_kalman_expect_rest(Vector memory, double x, double y) {
  fill((Vector){memory.p + predictors_kalman_MEAN_X, predictors_kalman_END - predictors_kalman_MEAN_X}, 0.0);
  memory.p[predictors_kalman_MEAN_X] = x;
  memory.p[predictors_kalman_MEAN_Y] = y;
  memory.p[predictors_kalman_SPREAD] = square(memory.p[predictors_kalman_NOISE_PX]);
  memory.p[predictors_kalman_SPREAD + 3] = square(predictors_kalman_PRIOR_SPEED);
  memory.p[predictors_kalman_SPREAD + 5] = square(predictors_kalman_PRIOR_ACCELERATION);
}

/* Position, velocity and acceleration of one axis after its position was measured. */
T3d predictors_kalman_correct(Vector memory, int64_t mean, double measured) {
  double total, share;
  total = memory.p[predictors_kalman_SPREAD] + square(memory.p[predictors_kalman_NOISE_PX]);
  share = (measured - memory.p[mean]) / total;
  return (T3d){memory.p[mean] + memory.p[predictors_kalman_SPREAD] * share, memory.p[mean + 1] + memory.p[predictors_kalman_SPREAD + 1] * share, memory.p[mean + 2] + memory.p[predictors_kalman_SPREAD + 2] * share};
}

/* Take the last position (x, y) in and expect the state ``dt`` later. */
void predictors_kalman_expect(Vector memory, double dt, double x, double y) {
  double noise;
  differentiators_kalman_Plane * plane;
  noise = square(memory.p[predictors_kalman_NOISE_PX]);
  plane = (differentiators_kalman_Plane *)(memory.p + predictors_kalman_MEAN_X);
  differentiators_kalman_correct((Vector){plane->x, 3}, &plane->covariance, noise, x);
  differentiators_kalman_predict((Vector){plane->x, 3}, dt);
  differentiators_kalman_correct((Vector){plane->y, 3}, &plane->covariance, noise, y);
  differentiators_kalman_predict((Vector){plane->y, 3}, dt);
  differentiators_kalman_narrow(&plane->covariance, noise);
  differentiators_kalman_spread(&plane->covariance, memory.p[predictors_kalman_JERK_DENSITY], dt);
}

/* One position through the filter of both axes, and its state carried over the horizon. */
T10d predictors_kalman_step(Vector memory, T10d motion) {
  records_MotionRow m;
  double last_x, last_y, dt, x0, y0, h, px, vx_px, ax_px, py, vy_px, ay_px;
  int64_t fault;
  bool new;
  m = records_MotionRow_of_T10d(motion);
  last_x = ((predictors_movement_State *)(memory.p + predictors_kalman_AT))->x;
  last_y = ((predictors_movement_State *)(memory.p + predictors_kalman_AT))->y;
  Tqbd values_1 = predictors_movement_follow((predictors_movement_State *)(memory.p + predictors_kalman_AT), m);
  fault = values_1.f0;
  new = values_1.f1;
  dt = values_1.f2;
  if (fault != records_FINE) {
    return predictors_movement_refuse((predictors_movement_State *)(memory.p + predictors_kalman_AT), m, fault);
  }
  x0 = ((predictors_movement_State *)(memory.p + predictors_kalman_AT))->x0;
  y0 = ((predictors_movement_State *)(memory.p + predictors_kalman_AT))->y0;
  if (new || dt > memory.p[predictors_kalman_GAP_S] + records_ROUNDING_S) {
    predictors_kalman_expect_rest(memory, m.x - x0, m.y - y0);
  } else if (dt > 0.0) {
    predictors_kalman_expect(memory, dt, last_x - x0, last_y - y0);
  }
  h = memory.p[predictors_kalman_HORIZON_S];
  T3d values_2 = predictors_kalman_correct(memory, predictors_kalman_MEAN_X, m.x - x0);
  px = values_2.f0;
  vx_px = values_2.f1;
  ax_px = values_2.f2;
  T3d values_3 = predictors_kalman_correct(memory, predictors_kalman_MEAN_Y, m.y - y0);
  py = values_3.f0;
  vy_px = values_3.f1;
  ay_px = values_3.f2;
  return records_endpoint(m.t, x0 + px + h * (vx_px + 0.5 * h * ax_px), y0 + py + h * (vy_px + 0.5 * h * ay_px), predictors_movement_phase((predictors_movement_State *)(memory.p + predictors_kalman_AT), m));
}

/* The polynomial at w. */
double predictors_kep_value(kep_Quartic p, double w) {
  return p.c0 + w * (p.c1 + w * (p.c2 + w * (p.c3 + w * p.c4)));
}

/* The polynomial's derivative. */
kep_Quartic predictors_kep_derivative(kep_Quartic p) {
  return (kep_Quartic){p.c1, 2.0 * p.c2, 3.0 * p.c3, 4.0 * p.c4, 0.0};
}

/* The points in (0, far) where the second derivative 2 c2 + 6 c3 w + 12 c4 w^2 is zero, else ``far``. */
T2d predictors_kep_bends(kep_Quartic p, double far) {
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

/* The zero zero_between low and high where the polynomial is monotone; ``high`` if there is none. */
double predictors_kep_zero_between(kep_Quartic p, double low, double high) {
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
double predictors_kep_first_zero(kep_Quartic p, double far) {
  double bend_1, bend_2, left, turn;
  T3d bounds;
  kep_Quartic slope;
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
void predictors_kep_add(Vector memory, double distance, double speed) {
  int64_t terms;
  double power;
  terms = (int64_t)memory.p[predictors_kep_DEGREE] + 1;
  power = 1.0;
  for (int64_t j = 0; j < terms; j++) {
    memory.p[predictors_kep_FIT + regression_least_squares_REGRESSOR + j] = power;
    power *= distance;
  }
  regression_least_squares_advance(memory, predictors_kep_FIT, terms, 1.0, speed);
}

/* Distance in px from where the cursor is to where the fitted speed returns to zero, else NaN. */
double predictors_kep_remaining(Vector memory, double travelled) {
  int64_t degree;
  double c0, c1, c2, c3, c4;
  kep_Quartic here;
  degree = (int64_t)memory.p[predictors_kep_DEGREE];
  if (!(travelled > 0.0 && regression_least_squares_solve(memory, predictors_kep_FIT, degree + 1, predictors_kep_EXCITATION_LEAST, predictors_kep_COEFFICIENTS))) {
    return NAN;
  }
  c0 = memory.p[predictors_kep_COEFFICIENTS];
  c1 = memory.p[predictors_kep_COEFFICIENTS + 1] * travelled;
  c2 = memory.p[predictors_kep_COEFFICIENTS + 2] * square(travelled);
  c3 = degree > 2 ? memory.p[predictors_kep_COEFFICIENTS + 3] * whole_power(travelled, 3) : 0.0;
  c4 = degree > 3 ? memory.p[predictors_kep_COEFFICIENTS + 4] * whole_power(travelled, 4) : 0.0;
  here = (kep_Quartic){predictors_kep_value((kep_Quartic){c0, c1, c2, c3, c4}, 1.0), c1 + 2.0 * c2 + 3.0 * c3 + 4.0 * c4, c2 + 3.0 * c3 + 6.0 * c4, c3 + 4.0 * c4, c4};
  return predictors_kep_first_zero(here, memory.p[predictors_kep_REACH]) * travelled;
}

/* Accept an endpoint when the predicted length changed little since the sample before. */
void predictors_kep_judge(Vector memory, double length, double x, double y) {
  double before;
  before = memory.p[predictors_kep_LENGTH];
  if (before > 0.0 && fabs(length - before) < memory.p[predictors_kep_CHANGE_MOST] * before) {
    memory.p[predictors_kep_ACCEPTED] = 1.0;
    memory.p[predictors_kep_ACCEPTED_X] = x;
    memory.p[predictors_kep_ACCEPTED_Y] = y;
  }
  memory.p[predictors_kep_LENGTH] = length > 0.0 ? length : 0.0;
}

/* Add the motion to the fit and look for its zero ahead. */
T10d predictors_kep_step(Vector memory, T10d motion) {
  records_MotionRow m;
  int64_t fault;
  bool new, accepted;
  double dt, travelled, away_x, away_y, away, end_x, end_y, ahead;
  m = records_MotionRow_of_T10d(motion);
  Tqbd values_1 = predictors_movement_follow((predictors_movement_State *)(memory.p + predictors_kep_AT), m);
  fault = values_1.f0;
  new = values_1.f1;
  dt = values_1.f2;
  if (fault != records_FINE) {
    return predictors_movement_refuse((predictors_movement_State *)(memory.p + predictors_kep_AT), m, fault);
  }
  travelled = ((predictors_movement_State *)(memory.p + predictors_kep_AT))->path;
  if (new) {
    fill((Vector){memory.p + predictors_kep_FIT, memory.n - predictors_kep_FIT}, 0.0);
  }
  if (new || dt > 0.0) {
    predictors_kep_add(memory, travelled, hypot(m.vx, m.vy));
  }
  away_x = m.x - ((predictors_movement_State *)(memory.p + predictors_kep_AT))->x0;
  away_y = m.y - ((predictors_movement_State *)(memory.p + predictors_kep_AT))->y0;
  away = hypot(away_x, away_y);
  end_x = NAN;
  end_y = NAN;
  if (away > 0.0) {
    ahead = predictors_kep_remaining(memory, travelled);
    end_x = m.x + ahead * (away_x / away);
    end_y = m.y + ahead * (away_y / away);
    if (dt > 0.0) {
      predictors_kep_judge(memory, travelled + ahead, end_x, end_y);
    }
  }
  if (memory.p[predictors_kep_CHANGE_MOST] > 0.0) {
    accepted = memory.p[predictors_kep_ACCEPTED] == 1.0;
    end_x = accepted ? memory.p[predictors_kep_ACCEPTED_X] : NAN;
    end_y = accepted ? memory.p[predictors_kep_ACCEPTED_Y] : NAN;
  }
  return records_endpoint(m.t, end_x, end_y, predictors_movement_phase((predictors_movement_State *)(memory.p + predictors_kep_AT), m));
}

/* Samples in the profile of the longest movement: one for each 50 ms, and the zero before them. */
int64_t predictors_ktm_samples_of(double longest_s) {
  return (int64_t)((longest_s + predictors_ktm_STAMP_S) / predictors_ktm_STEP_S) + 1;
}

/* The settings and the kernel, without a library. */
void predictors_ktm_fill(Vector values, Vector memory) {
  memory.p[predictors_ktm_LEARNED_MOST] = values.p[predictors_ktm_TEMPLATES_OF];
  memory.p[predictors_ktm_LIBRARY] = 0.0;
  memory.p[predictors_ktm_LONGEST] = predictors_ktm_samples_of(values.p[predictors_ktm_LONGEST_OF]);
  memory.p[predictors_ktm_SHORTEST_PX] = values.p[predictors_ktm_SHORTEST_OF];
  for (int64_t k = 0; k < predictors_ktm_TAPS; k++) {
    memory.p[predictors_ktm_HALF + k] = ((const double *)&predictors_ktm_KERNEL)[k];
  }
}

/* How many settings, learned floats and states of a movement there are without a library. */
T3q predictors_ktm_sizes(Vector values) {
  int64_t templates, longest, states;
  templates = (int64_t)values.p[predictors_ktm_TEMPLATES_OF];
  longest = predictors_ktm_samples_of(values.p[predictors_ktm_LONGEST_OF]);
  states = predictors_ktm_PROFILE + longest + templates * predictors_ktm_MATCH;
  if (templates == 0) {
    return (T3q){predictors_ktm_STORE, 0, states + predictors_ktm_LEARNED};
  }
  return (T3q){predictors_ktm_STORE, templates * (predictors_ktm_SPEEDS + longest) + predictors_ktm_LEARNED, states};
}

/* Place of the k-th template. */
int64_t predictors_ktm_template(Vector memory, int64_t k) {
  return predictors_ktm_STORE + k * (predictors_ktm_SPEEDS + (int64_t)memory.p[predictors_ktm_LONGEST]);
}

/* Place of the counts of learned templates: after the last of them. */
int64_t predictors_ktm_counts(Vector memory) {
  return predictors_ktm_template(memory, (int64_t)memory.p[predictors_ktm_LIBRARY] + (int64_t)memory.p[predictors_ktm_LEARNED_MOST]);
}

/* How many templates there are to compare with. */
int64_t predictors_ktm_template_count(Vector memory) {
  return (int64_t)memory.p[predictors_ktm_LIBRARY] + (int64_t)memory.p[predictors_ktm_counts(memory) + predictors_ktm_COUNT];
}

/* One template's mean absolute smoothed difference over samples 0 to n. */
void predictors_ktm_score(Vector memory, int64_t n, double speed, double own, int64_t place, int64_t match) {
  int64_t length, smooth, oldest;
  double difference, total, newest;
  length = (int64_t)memory.p[place + predictors_ktm_LENGTH];
  smooth = match + predictors_ktm_SMOOTH;
  difference = n < length ? speed - memory.p[place + predictors_ktm_SPEEDS + n] : speed;
  memory.p[match + predictors_ktm_FINAL] += fabs(memory.p[smooth]);
  total = memory.p[match + predictors_ktm_FINAL];
  oldest = max_whole(0, predictors_ktm_TAPS - 1 - n);
  for (int64_t k = oldest; k < (predictors_ktm_TAPS - 1); k++) {
    memory.p[smooth + k] = memory.p[smooth + k + 1] + memory.p[predictors_ktm_HALF + predictors_ktm_TAPS - 1 - k] * difference;
    total += fabs(memory.p[smooth + k]);
  }
  newest = own;
  if (n < length) {
    for (int64_t k = oldest; k < predictors_ktm_TAPS; k++) {
      newest -= memory.p[predictors_ktm_HALF + predictors_ktm_TAPS - 1 - k] * memory.p[place + predictors_ktm_SPEEDS + n - (predictors_ktm_TAPS - 1) + k];
    }
  }
  memory.p[smooth + predictors_ktm_TAPS - 1] = newest;
  memory.p[match + predictors_ktm_SCORE] = (total + fabs(newest)) / (n + 1);
}

/* Take in the next sample of the movement's speed, and score every template. */
void predictors_ktm_sample(Vector memory, int64_t at, double speed) {
  int64_t n, longest, recent, place, match;
  double own;
  n = (int64_t)memory.p[at + predictors_ktm_SAMPLES];
  longest = (int64_t)memory.p[predictors_ktm_LONGEST];
  recent = at + predictors_ktm_RECENT;
  for (int64_t k = 0; k < (predictors_ktm_TAPS - 1); k++) {
    memory.p[recent + k] = memory.p[recent + k + 1];
  }
  memory.p[recent + predictors_ktm_TAPS - 1] = speed;
  if (n < longest) {
    memory.p[at + predictors_ktm_PROFILE + n] = speed;
  }
  own = 0.0;
  for (int64_t k = 0; k < predictors_ktm_TAPS; k++) {
    own += memory.p[predictors_ktm_HALF + predictors_ktm_TAPS - 1 - k] * memory.p[recent + k];
  }
  for (int64_t j = 0, end_1 = predictors_ktm_template_count(memory); j < end_1; j++) {
    place = predictors_ktm_template(memory, j);
    match = at + predictors_ktm_PROFILE + longest + j * predictors_ktm_MATCH;
    predictors_ktm_score(memory, n, speed, own, place, match);
  }
  memory.p[at + predictors_ktm_SAMPLES] = n + 1.0;
}

/* Add each score that many times to its running sum; the first with the lowest sum, -1 without any. */
int64_t predictors_ktm_winner(Vector memory, int64_t at, double times) {
  int64_t first, best, match;
  first = at + predictors_ktm_PROFILE + (int64_t)memory.p[predictors_ktm_LONGEST];
  best = -1;
  for (int64_t j = 0, end_1 = predictors_ktm_template_count(memory); j < end_1; j++) {
    match = first + j * predictors_ktm_MATCH;
    memory.p[match + predictors_ktm_SUM] += times * memory.p[match + predictors_ktm_SCORE];
    if (best < 0 || memory.p[match + predictors_ktm_SUM] < memory.p[first + best * predictors_ktm_MATCH + predictors_ktm_SUM]) {
      best = j;
    }
  }
  return best;
}

/* Store the movement as a template, replacing the oldest learned one, if its length is within bounds. */
void predictors_ktm_keep(Vector memory, int64_t at, double distance) {
  int64_t most, samples, place_of_counts, place;
  most = (int64_t)memory.p[predictors_ktm_LEARNED_MOST];
  samples = (int64_t)memory.p[at + predictors_ktm_SAMPLES];
  if (most == 0 || memory.p[at + predictors_ktm_POINTS] < predictors_ktm_POINTS_LEAST || !(2 <= samples && samples <= memory.p[predictors_ktm_LONGEST])) {
    return;
  }
  if (!(distance >= memory.p[predictors_ktm_SHORTEST_PX])) {
    return;
  }
  place_of_counts = predictors_ktm_counts(memory);
  place = predictors_ktm_template(memory, (int64_t)memory.p[predictors_ktm_LIBRARY] + (int64_t)memory.p[place_of_counts + predictors_ktm_NEXT]);
  memory.p[place + predictors_ktm_LENGTH] = samples;
  memory.p[place + predictors_ktm_DISTANCE] = distance;
  for (int64_t k = 0, end_1 = (int64_t)memory.p[predictors_ktm_LONGEST]; k < end_1; k++) {
    memory.p[place + predictors_ktm_SPEEDS + k] = memory.p[at + predictors_ktm_PROFILE + k];
  }
  memory.p[place_of_counts + predictors_ktm_NEXT] = remainder_float(memory.p[place_of_counts + predictors_ktm_NEXT] + 1.0, most);
  memory.p[place_of_counts + predictors_ktm_COUNT] = min_float(memory.p[place_of_counts + predictors_ktm_COUNT] + 1.0, most);
}

/* How far the cursor is from the movement's start, px. */
double predictors_ktm_distance(Vector memory, int64_t at) {
  double away_x;
  away_x = ((predictors_movement_State *)(memory.p + at))->x - ((predictors_movement_State *)(memory.p + at))->x0;
  return hypot(away_x, ((predictors_movement_State *)(memory.p + at))->y - ((predictors_movement_State *)(memory.p + at))->y0);
}

/* The movement has ended: keep it as a template. */
void predictors_ktm_conclude(Vector memory) {
  int64_t at;
  at = predictors_ktm_counts(memory) + predictors_ktm_LEARNED;
  predictors_ktm_keep(memory, at, predictors_ktm_distance(memory, at));
}

/* Take in the samples that have fallen due since the motion before the last one. */
void predictors_ktm_resample(Vector memory, int64_t at, double since, double x_before, double y_before) {
  double most, now, x, y, due, back, grid_x, grid_y, way;
  most = memory.p[predictors_ktm_LONGEST] + predictors_ktm_TAPS;
  now = ((predictors_movement_State *)(memory.p + at))->t - ((predictors_movement_State *)(memory.p + at))->t0;
  x = ((predictors_movement_State *)(memory.p + at))->x;
  y = ((predictors_movement_State *)(memory.p + at))->y;
  due = memory.p[at + predictors_ktm_SAMPLES] * predictors_ktm_STEP_S;
  while (due <= now + predictors_ktm_STAMP_S && memory.p[at + predictors_ktm_SAMPLES] < most) {
    back = min_float(max_float((now - due) / since, 0.0), 1.0);
    grid_x = x + back * (x_before - x);
    grid_y = y + back * (y_before - y);
    way = hypot(grid_x - memory.p[at + predictors_ktm_GRID_X], grid_y - memory.p[at + predictors_ktm_GRID_Y]);
    memory.p[at + predictors_ktm_GRID_X] = grid_x;
    memory.p[at + predictors_ktm_GRID_Y] = grid_y;
    predictors_ktm_sample(memory, at, way * predictors_ktm_RATE_HZ);
    due = memory.p[at + predictors_ktm_SAMPLES] * predictors_ktm_STEP_S;
  }
}

/* Follow the speed profile and go as far as the template that is most like it. */
T10d predictors_ktm_step(Vector memory, T10d motion) {
  records_MotionRow m;
  int64_t at, fault, best;
  double last_distance, x_before, y_before, dt, phase, away, ahead, x0, y0;
  bool new;
  m = records_MotionRow_of_T10d(motion);
  at = predictors_ktm_counts(memory) + predictors_ktm_LEARNED;
  last_distance = predictors_ktm_distance(memory, at);
  x_before = ((predictors_movement_State *)(memory.p + at))->x;
  y_before = ((predictors_movement_State *)(memory.p + at))->y;
  Tqbd values_1 = predictors_movement_follow((predictors_movement_State *)(memory.p + at), m);
  fault = values_1.f0;
  new = values_1.f1;
  dt = values_1.f2;
  if (fault != records_FINE) {
    return predictors_movement_refuse((predictors_movement_State *)(memory.p + at), m, fault);
  }
  phase = predictors_movement_phase((predictors_movement_State *)(memory.p + at), m);
  if (new) {
    predictors_ktm_keep(memory, at, last_distance);
    fill((Vector){memory.p + (at + 9), memory.n - (at + 9)}, 0.0);
    memory.p[at + predictors_ktm_POINTS] = 1.0;
    predictors_ktm_sample(memory, at, 0.0);
  }
  if (new || m.t == ((predictors_movement_State *)(memory.p + at))->t0) {
    memory.p[at + predictors_ktm_GRID_X] = m.x;
    memory.p[at + predictors_ktm_GRID_Y] = m.y;
  }
  if (dt > 0.0) {
    memory.p[at + predictors_ktm_POINTS] += 1.0;
    predictors_ktm_resample(memory, at, dt, x_before, y_before);
  }
  away = predictors_ktm_distance(memory, at);
  best = -1;
  if (memory.p[at + predictors_ktm_POINTS] >= predictors_ktm_POINTS_LEAST) {
    best = predictors_ktm_winner(memory, at, dt > 0.0 ? 1.0 : 0.0);
  }
  if (best < 0 || !(away > 0.0)) {
    return records_endpoint(m.t, NAN, NAN, phase);
  }
  ahead = memory.p[predictors_ktm_template(memory, best) + predictors_ktm_DISTANCE] / away - 1.0;
  x0 = ((predictors_movement_State *)(memory.p + at))->x0;
  y0 = ((predictors_movement_State *)(memory.p + at))->y0;
  return records_endpoint(m.t, m.x + ahead * (m.x - x0), m.y + ahead * (m.y - y0), phase);
}

/* Remember a sample if the newest is an eighth of the window old; one of the same time is replaced. */
void predictors_linear_remember(Vector memory, double t, double x, double y) {
  int64_t count;
  bool same;
  count = (int64_t)memory.p[predictors_linear_COUNT];
  same = count > 0 && memory.p[predictors_linear_PAST] == t;
  if (count > 0 && !same && t - memory.p[predictors_linear_PAST] < memory.p[predictors_linear_WINDOW_S] / predictors_linear_CAPACITY - records_ROUNDING_S) {
    return;
  }
  if (!same) {
    for (int64_t i = 3 * predictors_linear_CAPACITY - 1; i > 2; i--) {
      memory.p[predictors_linear_PAST + i] = memory.p[predictors_linear_PAST + i - 3];
    }
    memory.p[predictors_linear_COUNT] = min_whole(count + 1, predictors_linear_CAPACITY);
  }
  memory.p[predictors_linear_PAST] = t;
  memory.p[predictors_linear_PAST + 1] = x;
  memory.p[predictors_linear_PAST + 2] = y;
}

/* Whether there is a sample before ``t``; the oldest within the window, else the newest: (t, x, y). */
Tb3d predictors_linear_before(Vector memory, double t) {
  int64_t place;
  double age;
  place = -1;
  for (int64_t i = 0, end_1 = (int64_t)memory.p[predictors_linear_COUNT]; i < end_1; i++) {
    age = t - memory.p[predictors_linear_PAST + 3 * i];
    if (age > 0.0 && (place < 0 || age <= memory.p[predictors_linear_WINDOW_S] + records_ROUNDING_S)) {
      place = predictors_linear_PAST + 3 * i;
    }
  }
  if (place < 0) {
    return (Tb3d){false, t, 0.0, 0.0};
  }
  return (Tb3d){true, memory.p[place], memory.p[place + 1], memory.p[place + 2]};
}

/* Carry the mean velocity of the window on over the horizon. */
T10d predictors_linear_step(Vector memory, T10d motion) {
  records_MotionRow m;
  int64_t fault;
  bool new, any_before;
  double phase, before_t, before_x, before_y, ahead;
  m = records_MotionRow_of_T10d(motion);
  Tqbd values_1 = predictors_movement_follow((predictors_movement_State *)(memory.p + predictors_linear_AT), m);
  fault = values_1.f0;
  new = values_1.f1;
  if (fault != records_FINE) {
    return predictors_movement_refuse((predictors_movement_State *)(memory.p + predictors_linear_AT), m, fault);
  }
  if (new) {
    memory.p[predictors_linear_COUNT] = 0.0;
  }
  phase = predictors_movement_phase((predictors_movement_State *)(memory.p + predictors_linear_AT), m);
  Tb3d values_2 = predictors_linear_before(memory, m.t);
  any_before = values_2.f0;
  before_t = values_2.f1;
  before_x = values_2.f2;
  before_y = values_2.f3;
  predictors_linear_remember(memory, m.t, m.x, m.y);
  if (!any_before) {
    return records_endpoint(m.t, NAN, NAN, phase);
  }
  ahead = memory.p[predictors_linear_HORIZON_S] / max_float(m.t - before_t, memory.p[predictors_linear_WINDOW_S] / predictors_linear_CAPACITY);
  return records_endpoint(m.t, m.x + ahead * (m.x - before_x), m.y + ahead * (m.y - before_y), phase);
}

/* Divide the way done by the share that the speed says is done. */
T10d predictors_minimum_jerk_step(Vector memory, T10d motion) {
  records_MotionRow m;
  int64_t fault;
  double phase, peak, tau, done, ahead;
  m = records_MotionRow_of_T10d(motion);
  Tqbd values_1 = predictors_movement_follow((predictors_movement_State *)(memory.p + predictors_minimum_jerk_AT), m);
  fault = values_1.f0;
  if (fault != records_FINE) {
    return predictors_movement_refuse((predictors_movement_State *)(memory.p + predictors_minimum_jerk_AT), m, fault);
  }
  phase = predictors_movement_phase((predictors_movement_State *)(memory.p + predictors_minimum_jerk_AT), m);
  peak = ((predictors_movement_State *)(memory.p + predictors_minimum_jerk_AT))->peak;
  if (peak < predictors_movement_STILL_M_S) {
    return records_endpoint(m.t, NAN, NAN, phase);
  }
  T2d values_2 = predictors_minimum_jerk_progress(hypot(m.vx, m.vy) / peak);
  tau = values_2.f0;
  done = values_2.f1;
  ahead = (1.0 - done) / done;
  return (T10d){m.t, m.x + ahead * (m.x - ((predictors_movement_State *)(memory.p + predictors_minimum_jerk_AT))->x0), m.y + ahead * (m.y - ((predictors_movement_State *)(memory.p + predictors_minimum_jerk_AT))->y0), NAN, NAN, NAN, (m.t - ((predictors_movement_State *)(memory.p + predictors_minimum_jerk_AT))->t0) * (1.0 - tau) / tau, phase, NAN, NAN};
}

/* The density above which places of the probability ``level`` lie: exact for a single part. */
double predictors_mixture_threshold_of(Table parts, int64_t count, double level, int64_t points) {
  double tail, far, log_density, most, low, high, middle;
  Table known;
  if (count == 1) {
    tail = parts.p[0 * parts.m + predictors_mixture_TAIL];
    far = predictors_mixture_squared_radius(level, tail);
    log_density = tail == 0.0 ? -0.5 * far : -0.5 * (tail + 2.0) * log1p(far / tail);
    return predictors_mixture_part_density(parts, 0, parts.p[0 * parts.m + predictors_mixture_X], parts.p[0 * parts.m + predictors_mixture_Y]) * exp(log_density);
  }
  RELEASED double *buffer_1 = reserved(count * points);
  known = (Table){buffer_1, count, points};
  predictors_mixture_densities(parts, count, points, known);
  most = predictors_mixture_DENSITY_LEAST;
  for (int64_t k = 0; k < count; k++) {
    most += predictors_mixture_part_density(parts, k, parts.p[k * parts.m + predictors_mixture_X], parts.p[k * parts.m + predictors_mixture_Y]);
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

/* Squared Mahalanobis distance beyond which a part is less than its portion of a threshold. */
double predictors_mixture_reach(Table parts, int64_t count, int64_t k, double threshold) {
  double over, tail;
  over = predictors_mixture_part_density(parts, k, parts.p[k * parts.m + predictors_mixture_X], parts.p[k * parts.m + predictors_mixture_Y]) * count / threshold;
  if (!(over > 1.0)) {
    return -1.0;
  }
  tail = parts.p[k * parts.m + predictors_mixture_TAIL];
  return tail == 0.0 ? 2.0 * log(over) : tail * expm1(2.0 * log(over) / (tail + 2.0));
}

/* Lay out the lines of the grid in one direction, ascending; returns how many. ``across``: 0 x, 1 y. */
int64_t predictors_mixture_lines_of(Table parts, int64_t count, double threshold, int64_t across, Vector out) {
  int64_t centre, scale, total, place;
  double far, at, value;
  centre = predictors_mixture_X;
  scale = predictors_mixture_SXX;
  total = 0;
  if (across == 1) {
    centre = predictors_mixture_Y;
    scale = predictors_mixture_SYY;
  }
  for (int64_t k = 0; k < count; k++) {
    far = predictors_mixture_reach(parts, count, k, threshold);
    for (int64_t i = 0; i < predictors_mixture_LINES; i++) {
      if (far > 0.0) {
        at = 2.0 * i / (predictors_mixture_LINES - 1.0) - 1.0;
        at *= predictors_mixture_AT_CENTRE + (1.0 - predictors_mixture_AT_CENTRE) * at * at;
        value = parts.p[k * parts.m + centre] + predictors_mixture_OUTSIDE * at * sqrt(far * parts.p[k * parts.m + scale]);
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

/* One sample of one axis (figure 2.4); returns the endpoint in px from the movement's start. */
double predictors_switched_advance(Vector memory, int64_t axis, double t, double place, double v, double a) {
  double moved, before;
  int64_t regression, third;
  bool solved;
  moved = place - memory.p[axis + predictors_switched_PLACE];
  memory.p[axis + predictors_switched_PLACE] = place;
  memory.p[axis + predictors_switched_PEAK] = max_float(memory.p[axis + predictors_switched_PEAK], fabs(v));
  before = memory.p[axis + predictors_switched_ENDPOINT];
  regression = axis + predictors_switched_DREM;
  memory.p[regression + regression_drem_REGRESSOR] = -a;
  memory.p[regression + regression_drem_REGRESSOR + 1] = -v;
  memory.p[regression + regression_drem_REGRESSOR + 2] = 1.0;
  if (fabs(v) < memory.p[predictors_switched_THRESHOLD] * memory.p[axis + predictors_switched_PEAK]) {
    third = regression_drem_estimates(regression, predictors_switched_UNKNOWNS) + 2;
    memory.p[third] = before;
    solved = regression_drem_advance(memory, regression, predictors_switched_UNKNOWNS, memory.p[predictors_switched_DELAY_S], memory.p[predictors_switched_GAMMA], (T2d){t, place});
    if (solved && fabs(memory.p[third] - before) < memory.p[predictors_switched_BOUND] * fabs(place)) {
      memory.p[axis + predictors_switched_ENDPOINT] = memory.p[third];
    }
  } else {
    regression_drem_remember(memory, regression, predictors_switched_UNKNOWNS, memory.p[predictors_switched_DELAY_S], t, place);
    if (a * v >= 0.0) {
      memory.p[axis + predictors_switched_ENDPOINT] = before + 2.0 * moved;
    }
  }
  return memory.p[axis + predictors_switched_ENDPOINT];
}

/* Both axes, each in its own phase (Remark 2.5.1). */
T10d predictors_switched_step(Vector memory, T10d motion) {
  records_MotionRow m;
  int64_t fault;
  bool new;
  double x0, y0, since, end_x, end_y;
  m = records_MotionRow_of_T10d(motion);
  Tqbd values_1 = predictors_movement_follow((predictors_movement_State *)(memory.p + predictors_switched_AT), m);
  fault = values_1.f0;
  new = values_1.f1;
  if (fault != records_FINE) {
    return predictors_movement_refuse((predictors_movement_State *)(memory.p + predictors_switched_AT), m, fault);
  }
  if (new) {
    fill((Vector){memory.p + predictors_switched_X_AXIS, memory.n - predictors_switched_X_AXIS}, 0.0);
  }
  x0 = ((predictors_movement_State *)(memory.p + predictors_switched_AT))->x0;
  y0 = ((predictors_movement_State *)(memory.p + predictors_switched_AT))->y0;
  since = m.t - ((predictors_movement_State *)(memory.p + predictors_switched_AT))->t0;
  end_x = x0 + predictors_switched_advance(memory, predictors_switched_X_AXIS, since, m.x - x0, m.vx, m.ax);
  end_y = y0 + predictors_switched_advance(memory, predictors_switched_Y_AXIS, since, m.y - y0, m.vy, m.ay);
  return records_endpoint(m.t, end_x, end_y, predictors_movement_phase((predictors_movement_State *)(memory.p + predictors_switched_AT), m));
}

/* A movement starts at rest at (x, y). */
void predictors_switched_direction_begin_submovement(Vector memory, int64_t at, double x, double y) {
  memory.p[at + predictors_switched_direction_PEAK] = 0.0;
  memory.p[at + predictors_switched_direction_VALLEY] = 0.0;
  memory.p[at + predictors_switched_direction_PEAK_X] = x;
  memory.p[at + predictors_switched_direction_PEAK_Y] = y;
  memory.p[at + predictors_switched_direction_VALLEY_X] = x;
  memory.p[at + predictors_switched_direction_VALLEY_Y] = y;
  memory.p[at + predictors_switched_direction_START_X] = x;
  memory.p[at + predictors_switched_direction_START_Y] = y;
}

/* Take one sample in; a rise of the speed by ``rise`` of the peak out of a valley is a new sub-movement. */
void predictors_switched_direction_follow_submovement(Vector memory, int64_t at, double rise, double x, double y, double speed) {
  double peak, valley;
  peak = memory.p[at + predictors_switched_direction_PEAK];
  valley = memory.p[at + predictors_switched_direction_VALLEY];
  if (speed < peak && speed <= valley + rise * peak) {
    if (speed <= valley) {
      memory.p[at + predictors_switched_direction_VALLEY] = speed;
      memory.p[at + predictors_switched_direction_VALLEY_X] = x;
      memory.p[at + predictors_switched_direction_VALLEY_Y] = y;
    }
    return;
  }
  if (speed < peak) {
    double value_1 = memory.p[at + predictors_switched_direction_VALLEY_X];
    double value_2 = memory.p[at + predictors_switched_direction_VALLEY_Y];
    memory.p[at + predictors_switched_direction_START_X] = value_1;
    memory.p[at + predictors_switched_direction_START_Y] = value_2;
  }
  memory.p[at + predictors_switched_direction_PEAK] = speed;
  memory.p[at + predictors_switched_direction_VALLEY] = speed;
  memory.p[at + predictors_switched_direction_PEAK_X] = x;
  memory.p[at + predictors_switched_direction_PEAK_Y] = y;
  memory.p[at + predictors_switched_direction_VALLEY_X] = x;
  memory.p[at + predictors_switched_direction_VALLEY_Y] = y;
}

/* Averaged gain g in px/m by least squares, displacement = g times the hand's; 0 where unknown. */
double predictors_switched_direction_gain(Vector memory, double dt, double away_x, double away_y, double vx, double vy) {
  double hand_x, hand_y;
  memory.p[predictors_switched_direction_HAND_X] += 0.5 * dt * (vx + memory.p[predictors_switched_direction_VX]);
  memory.p[predictors_switched_direction_HAND_Y] += 0.5 * dt * (vy + memory.p[predictors_switched_direction_VY]);
  memory.p[predictors_switched_direction_VX] = vx;
  memory.p[predictors_switched_direction_VY] = vy;
  hand_x = memory.p[predictors_switched_direction_HAND_X];
  hand_y = memory.p[predictors_switched_direction_HAND_Y];
  memory.p[predictors_switched_direction_CROSS] += dt * (away_x * hand_x + away_y * hand_y);
  memory.p[predictors_switched_direction_SQUARE] += dt * (hand_x * hand_x + hand_y * hand_y);
  if (!(memory.p[predictors_switched_direction_CROSS] > 0.0 && memory.p[predictors_switched_direction_SQUARE] > 0.0)) {
    return 0.0;
  }
  return memory.p[predictors_switched_direction_CROSS] / memory.p[predictors_switched_direction_SQUARE];
}

/* Time constant at the peak in s, from the sub-movement's own, way done / peak speed, and a typical. */
double predictors_switched_direction_time_constant(double own, double typical_s, double done, double peak) {
  if (own == 0.0) {
    return typical_s;
  }
  return pow(done / peak, own) * pow(typical_s, 1.0 - own);
}

/* Rate k in 1/s of the approach V = k (T - x): from the switch and the slope since; 0 where unknown. */
double predictors_switched_direction_approach(Vector memory, double px_m, double x, double y, double speed) {
  double peak, peak_x, peak_y, done, at_switch, since, slope, share;
  peak = memory.p[predictors_switched_direction_UNIT + predictors_switched_direction_PEAK];
  peak_x = memory.p[predictors_switched_direction_UNIT + predictors_switched_direction_PEAK_X];
  peak_y = memory.p[predictors_switched_direction_UNIT + predictors_switched_direction_PEAK_Y];
  done = hypot(peak_x - memory.p[predictors_switched_direction_UNIT + predictors_switched_direction_START_X], peak_y - memory.p[predictors_switched_direction_UNIT + predictors_switched_direction_START_Y]);
  if (done == 0.0) {
    return 0.0;
  }
  at_switch = 1.0 / predictors_switched_direction_time_constant(memory.p[predictors_switched_direction_OWN], memory.p[predictors_switched_direction_TYPICAL_S], done, peak * px_m);
  since = hypot(x - peak_x, y - peak_y);
  slope = since > 0.0 ? (peak - speed) * px_m / since : 0.0;
  share = pow(speed / peak, memory.p[predictors_switched_direction_TURN]);
  return share * at_switch + (1.0 - share) * memory.p[predictors_switched_direction_WATCHED] * slope;
}

/* Follow the sub-movement and add what is left of it in the direction of the hand. */
T10d predictors_switched_direction_step(Vector memory, T10d motion) {
  records_MotionRow m;
  int64_t fault;
  bool new;
  double dt, speed, phase, px_m, rate, ahead_s, braking;
  m = records_MotionRow_of_T10d(motion);
  Tqbd values_1 = predictors_movement_follow((predictors_movement_State *)(memory.p + predictors_switched_direction_AT), m);
  fault = values_1.f0;
  new = values_1.f1;
  dt = values_1.f2;
  if (fault != records_FINE) {
    return predictors_movement_refuse((predictors_movement_State *)(memory.p + predictors_switched_direction_AT), m, fault);
  }
  if (new) {
    fill((Vector){memory.p + predictors_switched_direction_VX, predictors_switched_direction_END - predictors_switched_direction_VX}, 0.0);
  }
  if (new || m.t == ((predictors_movement_State *)(memory.p + predictors_switched_direction_AT))->t0) {
    predictors_switched_direction_begin_submovement(memory, predictors_switched_direction_UNIT, m.x, m.y);
  }
  speed = hypot(m.vx, m.vy);
  predictors_switched_direction_follow_submovement(memory, predictors_switched_direction_UNIT, memory.p[predictors_switched_direction_RISE], m.x, m.y, speed);
  phase = predictors_movement_phase((predictors_movement_State *)(memory.p + predictors_switched_direction_AT), m);
  px_m = predictors_switched_direction_gain(memory, dt, m.x - ((predictors_movement_State *)(memory.p + predictors_switched_direction_AT))->x0, m.y - ((predictors_movement_State *)(memory.p + predictors_switched_direction_AT))->y0, m.vx, m.vy);
  rate = px_m > 0.0 && speed > predictors_movement_STILL_M_S ? predictors_switched_direction_approach(memory, px_m, m.x, m.y, speed) : 0.0;
  ahead_s = rate > 0.0 ? 1.0 / rate : 0.0;
  braking = -(m.ax * m.vx + m.ay * m.vy);
  if (braking > 0.0 && ahead_s * braking > memory.p[predictors_switched_direction_STOPPING] * speed * speed) {
    ahead_s = memory.p[predictors_switched_direction_STOPPING] * speed * speed / braking;
  }
  return records_endpoint(m.t, m.x + ahead_s * px_m * m.vx, m.y + ahead_s * px_m * m.vy, phase);
}

void loop__stage_learn_nothing__records_row_at__predictors_minimum_jerk_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out) {
  T10d answer;
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      stage_learn_nothing(memory);
      fill((Vector){memory.p + first, memory.n - first}, 0.0);
    }
    answer = predictors_minimum_jerk_step(memory, records_row_at(rows, i));
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
    answer = predictors_delphian_step(memory, records_row_at(rows, i));
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
    answer = predictors_hold_step(memory, records_row_at(rows, i));
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
    answer = predictors_kalman_step(memory, records_row_at(rows, i));
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
    answer = predictors_kep_step(memory, records_row_at(rows, i));
    for (int64_t j = 0; j < 10; j++) {
      out.p[i * out.m + j] = ((const double *)&answer)[j];
    }
  }
}

void loop__predictors_ktm_conclude__records_row_at__predictors_ktm_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out) {
  T10d answer;
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      predictors_ktm_conclude(memory);
      fill((Vector){memory.p + first, memory.n - first}, 0.0);
    }
    answer = predictors_ktm_step(memory, records_row_at(rows, i));
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
    answer = predictors_linear_step(memory, records_row_at(rows, i));
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
    answer = predictors_switched_step(memory, records_row_at(rows, i));
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
    answer = predictors_switched_direction_step(memory, records_row_at(rows, i));
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
    answer = predictors_minimum_jerk_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    }
  }
  return answer;
}

bool follow__predictors_minimum_jerk_step(Vector memory, T10d row) {
  double t;
  t = predictors_minimum_jerk_step(memory, row).f0;
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
      answer = predictors_minimum_jerk_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_minimum_jerk_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
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
      answer = predictors_minimum_jerk_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_minimum_jerk_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
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
      answer = predictors_minimum_jerk_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_delphian_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    }
  }
  return answer;
}

bool follow__predictors_delphian_step(Vector memory, T10d row) {
  double t;
  t = predictors_delphian_step(memory, row).f0;
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
      answer = predictors_delphian_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_delphian_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
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
      answer = predictors_delphian_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_delphian_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
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
      answer = predictors_delphian_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_hold_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    }
  }
  return answer;
}

bool follow__predictors_hold_step(Vector memory, T10d row) {
  double t;
  t = predictors_hold_step(memory, row).f0;
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
      answer = predictors_hold_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_hold_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
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
      answer = predictors_hold_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_hold_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
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
      answer = predictors_hold_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_kalman_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    }
  }
  return answer;
}

bool follow__predictors_kalman_step(Vector memory, T10d row) {
  double t;
  t = predictors_kalman_step(memory, row).f0;
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
      answer = predictors_kalman_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_kalman_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
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
      answer = predictors_kalman_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_kalman_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
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
      answer = predictors_kalman_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_kep_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    }
  }
  return answer;
}

bool follow__predictors_kep_step(Vector memory, T10d row) {
  double t;
  t = predictors_kep_step(memory, row).f0;
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
      answer = predictors_kep_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_kep_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
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
      answer = predictors_kep_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_kep_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
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
      answer = predictors_kep_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_ktm_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    }
  }
  return answer;
}

bool follow__predictors_ktm_step(Vector memory, T10d row) {
  double t;
  t = predictors_ktm_step(memory, row).f0;
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
      answer = predictors_ktm_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_ktm_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
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
      answer = predictors_ktm_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_ktm_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
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
      answer = predictors_ktm_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_linear_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    }
  }
  return answer;
}

bool follow__predictors_linear_step(Vector memory, T10d row) {
  double t;
  t = predictors_linear_step(memory, row).f0;
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
      answer = predictors_linear_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_linear_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
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
      answer = predictors_linear_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_linear_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
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
      answer = predictors_linear_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_switched_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    }
  }
  return answer;
}

bool follow__predictors_switched_step(Vector memory, T10d row) {
  double t;
  t = predictors_switched_step(memory, row).f0;
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
      answer = predictors_switched_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_switched_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
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
      answer = predictors_switched_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_switched_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
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
      answer = predictors_switched_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_switched_direction_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    }
  }
  return answer;
}

bool follow__predictors_switched_direction_step(Vector memory, T10d row) {
  double t;
  t = predictors_switched_direction_step(memory, row).f0;
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
      answer = predictors_switched_direction_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_switched_direction_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
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
      answer = predictors_switched_direction_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_switched_direction_step(other, answer);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
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
      answer = predictors_switched_direction_step(other, between);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
  }
  return answer;
}
