/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const int64_t scoring_measures_endpoint_BY_PATH = 10;
static const int64_t scoring_measures_endpoint_BY_TIME = 2;
static const int64_t scoring_measures_endpoint_COVERAGE = 1;
static const int64_t scoring_measures_endpoint_MEASURES = 37;
static const int64_t scoring_measures_endpoint_SINGLE_AXIS = 17;
static const int64_t scoring_measures_endpoint_SOUND = -1;
static const int64_t scoring_measures_endpoint_TIME_AVERAGED = 0;
static const double scoring_measures_endpoint_WEIGHT_S = 0.05;
static const int64_t scoring_measures_regions_CLAIMED = 0;
static const int64_t scoring_measures_regions_INSIDE = 1;
static const T3d scoring_measures_regions_LEVELS = {0.5, 0.8, 0.95};
static const int64_t scoring_measures_regions_RANKED = 4;
static const double scoring_measures_regions_SETTLED = 1e-14;
static const double scoring_measures_regions_SMALLEST = 1e-300;
static const int64_t scoring_measures_regions_TERMS = 200;
static const int64_t scoring_measures_time_left_CLAIMED = 0;
static const int64_t scoring_measures_time_left_CLOCK = 2;
static const T3d scoring_measures_time_left_DEVIATIONS = {0.6744897501960817, 1.2815515655446004, 1.959963984540054};
static const int64_t scoring_measures_time_left_ERROR = 1;
static const int64_t scoring_measures_time_left_INSIDE = 4;
static const int64_t scoring_measures_time_left_REMAINING = 6;
static const double scoring_measures_time_left_SHORTEST_S = 1e-06;
static const int64_t scoring_measures_time_left_SPREAD = 3;
static const int64_t scoring_measures_time_left_SPREADS = 9;

/* Write the measures of one trial; returns SOUND or the row of an answer that is not finite. */
int64_t scoring_measures_endpoint_measure_trial(Table rows, Table answers, Vector fractions, int64_t arrival, Vector out) {
  int64_t last, next_time, next_path, next_axis, answered;
  double end_x, end_y, way_x, way_y, distance2, start_t, span_t, weighted, weights, x, y, error_x, error_y, error, weight, done_x, done_y, progress, along;
  bool upright;
  last = rows.n - 1;
  end_x = rows.p[last * rows.m + 1];
  end_y = rows.p[last * rows.m + 2];
  way_x = end_x - rows.p[0 * rows.m + 1];
  way_y = end_y - rows.p[0 * rows.m + 2];
  distance2 = way_x * way_x + way_y * way_y;
  upright = fabs(way_y) > fabs(way_x);
  start_t = rows.p[0 * rows.m + 0];
  span_t = rows.p[arrival * rows.m + 0] - rows.p[0 * rows.m + 0];
  next_time = scoring_measures_endpoint_BY_TIME;
  next_path = scoring_measures_endpoint_BY_PATH;
  next_axis = scoring_measures_endpoint_SINGLE_AXIS;
  weighted = 0.0;
  weights = 0.0;
  answered = 0;
  for (int64_t i = 0, end_1 = last + 1; i < end_1; i++) {
    x = rows.p[i * rows.m + 1];
    y = rows.p[i * rows.m + 2];
    error_x = x - end_x;
    error_y = y - end_y;
    if (answers.p[i * answers.m + 1] == answers.p[i * answers.m + 1]) {
      answered += 1;
      error_x = answers.p[i * answers.m + 1] - end_x;
      error_y = answers.p[i * answers.m + 2] - end_y;
    }
    error = hypot(error_x, error_y);
    if (!(error < INFINITY)) {
      return i;
    }
    if (i < arrival) {
      weight = min_float(rows.p[(i + 1) * rows.m + 0] - rows.p[i * rows.m + 0], scoring_measures_endpoint_WEIGHT_S);
      weighted += weight * error;
      weights += weight;
    }
    while (next_time < scoring_measures_endpoint_BY_PATH && (i == last || rows.p[(i + 1) * rows.m + 0] > start_t + fractions.p[next_time - scoring_measures_endpoint_BY_TIME] * span_t + records_ROUNDING_S)) {
      out.p[next_time] = error;
      next_time += 1;
    }
    done_x = x - rows.p[0 * rows.m + 1];
    done_y = y - rows.p[0 * rows.m + 2];
    progress = done_x * way_x + done_y * way_y;
    while (next_path < scoring_measures_endpoint_SINGLE_AXIS && progress >= fractions.p[next_path - scoring_measures_endpoint_BY_TIME] * distance2) {
      out.p[next_path] = error;
      next_path += 1;
    }
    along = upright ? fabs(way_y) : fabs(way_x);
    progress = upright ? done_y : done_x;
    if ((upright ? way_y : way_x) < 0.0) {
      progress = -progress;
    }
    while (next_axis < scoring_measures_endpoint_MEASURES && progress >= fractions.p[next_axis - scoring_measures_endpoint_BY_TIME] * along) {
      out.p[next_axis] = fabs(upright ? error_y : error_x);
      next_axis += 1;
    }
  }
  out.p[scoring_measures_endpoint_TIME_AVERAGED] = weighted / weights;
  out.p[scoring_measures_endpoint_COVERAGE] = (double)answered / (last + 1);
  return scoring_measures_endpoint_SOUND;
}

/* A row of measures for each trial that lies in these rows; ``offsets`` need not begin at 0. */
void scoring_measures_endpoint_measure(Table rows, Table answers, Vector fractions, WholeVector offsets, WholeVector arrivals, Table out, WholeVector faults) {
  int64_t base, a, b;
  base = offsets.p[0];
  for (int64_t k = 0, end_1 = offsets.n - 1; k < end_1; k++) {
    a = offsets.p[k] - base;
    b = offsets.p[k + 1] - base;
    faults.p[k] = scoring_measures_endpoint_measure_trial((Table){rows.p + a * rows.m, b - a, rows.m}, (Table){answers.p + a * answers.m, b - a, answers.m}, fractions, arrivals.p[k] - offsets.p[k], (Vector){out.p + k * out.m, out.m});
  }
}

/* For each share of the time its row: the last at or before that time; shares ascend. */
void scoring_measures_endpoint_moments(Table rows, int64_t first, int64_t arrival, int64_t last, Vector shares, WholeVector out) {
  int64_t i;
  double start, span;
  i = first;
  start = rows.p[first * rows.m + 0];
  span = rows.p[arrival * rows.m + 0] - rows.p[first * rows.m + 0];
  for (int64_t k = 0; k < shares.n; k++) {
    while (i < last && rows.p[(i + 1) * rows.m + 0] <= start + shares.p[k] * span + records_ROUNDING_S) {
      i += 1;
    }
    out.p[k] = i;
  }
}

/* For each trial and share of the time: 1 where the prediction lies in the target, 0 where it does not. */
void scoring_measures_endpoint_hits(Table rows, Table answers, WholeVector offsets, WholeVector arrivals, Table discs, Vector shares, Table out) {
  WholeVector at;
  int64_t first, last;
  double x, y;
  fill((Vector){(Table){out.p, out.n, out.m}.p, (Table){out.p, out.n, out.m}.n * (Table){out.p, out.n, out.m}.m}, NAN);
  RELEASED int64_t *buffer_1 = reserved(shares.n);
  at = (WholeVector){buffer_1, shares.n};
  for (int64_t k = 0, end_2 = offsets.n - 1; k < end_2; k++) {
    if (discs.p[k * discs.m + 0] != discs.p[k * discs.m + 0]) {
      continue;
    }
    first = offsets.p[k] - offsets.p[0];
    last = offsets.p[k + 1] - offsets.p[0] - 1;
    scoring_measures_endpoint_moments(rows, first, arrivals.p[k] - offsets.p[0], last, shares, at);
    for (int64_t m = 0; m < shares.n; m++) {
      x = rows.p[at.p[m] * rows.m + 1];
      y = rows.p[at.p[m] * rows.m + 2];
      if (answers.p[at.p[m] * answers.m + 1] == answers.p[at.p[m] * answers.m + 1]) {
        x = answers.p[at.p[m] * answers.m + 1];
        y = answers.p[at.p[m] * answers.m + 2];
      }
      out.p[k * out.m + m] = hypot(x - discs.p[k * discs.m + 0], y - discs.p[k * discs.m + 1]) <= 0.5 * discs.p[k * discs.m + 2] ? 1.0 : 0.0;
    }
  }
}

/* The continued fraction of the incomplete beta function, by Lentz's method. */
WIDE double scoring_measures_regions_beta_fraction(double a, double b, double x) {
  double c, d, total, even, odd, term;
  c = 1.0;
  d = 1.0 - (a + b) * x / (a + 1.0);
  d = 1.0 / (fabs(d) > scoring_measures_regions_SMALLEST ? d : scoring_measures_regions_SMALLEST);
  total = d;
  for (int64_t m = 1; m < scoring_measures_regions_TERMS; m++) {
    even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
    odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
    for (int64_t k = 0; k < 2; k++) {
      term = k == 0 ? even : odd;
      d = 1.0 + term * d;
      d = 1.0 / (fabs(d) > scoring_measures_regions_SMALLEST ? d : scoring_measures_regions_SMALLEST);
      c = 1.0 + term / c;
      c = fabs(c) > scoring_measures_regions_SMALLEST ? c : scoring_measures_regions_SMALLEST;
      total *= c * d;
    }
    if (fabs(c * d - 1.0) < scoring_measures_regions_SETTLED) {
      break;
    }
  }
  return total;
}

/* Logarithm of the beta function. */
double scoring_measures_regions_log_beta(double a, double b) {
  return lgamma(a) + lgamma(b) - lgamma(a + b);
}

/* The regularised incomplete beta function I_x(a, b). */
double scoring_measures_regions_incomplete_beta(double a, double b, double x) {
  double scale;
  if (x <= 0.0) {
    return 0.0;
  }
  if (x >= 1.0) {
    return 1.0;
  }
  scale = exp(a * log(x) + b * log(1.0 - x) - scoring_measures_regions_log_beta(a, b));
  if (x < (a + 1.0) / (a + b + 2.0)) {
    return scale * scoring_measures_regions_beta_fraction(a, b, x) / a;
  }
  return 1.0 - scale * scoring_measures_regions_beta_fraction(b, a, 1.0 - x) / b;
}

/* Probability below ``z`` of a law with ``tail`` degrees of freedom, scale 1. */
double scoring_measures_regions_distribution(double z, double tail) {
  double beyond;
  beyond = 0.5 * scoring_measures_regions_incomplete_beta(0.5 * tail, 0.5, tail / (tail + z * z));
  return z > 0.0 ? 1.0 - beyond : beyond;
}

/* Continuous ranked probability score of a Student law whose centre is off by ``error``. */
double scoring_measures_regions_student_score(double error, double scale, double tail) {
  double z, both, density, spread, near;
  if (tail <= 1.0) {
    return INFINITY;
  }
  if (scale == 0.0) {
    return fabs(error);
  }
  z = error / scale;
  both = scoring_measures_regions_log_beta(0.5, 0.5 * tail);
  density = exp(-0.5 * (tail + 1.0) * log(1.0 + z * z / tail) - both) / sqrt(tail);
  spread = 2.0 * sqrt(tail) * exp(scoring_measures_regions_log_beta(0.5, tail - 0.5) - 2.0 * both);
  near = z * (2.0 * scoring_measures_regions_distribution(z, tail) - 1.0);
  return scale * (near + (2.0 * density * (tail + z * z) - spread) / (tail - 1.0));
}

/* Continuous ranked probability score of a normal law whose mean is off by ``error``. */
double scoring_measures_regions_ranked_score(double error, double deviation) {
  double z, density;
  if (deviation == 0.0) {
    return fabs(error);
  }
  z = error / deviation;
  density = exp(-0.5 * z * z) / sqrt(2.0 * 3.141592653589793);
  return deviation * (z * erf(z / sqrt(2.0)) + 2.0 * density - 1.0 / sqrt(3.141592653589793));
}

/* Squared Mahalanobis distance; -1 where the numbers are no covariance with an inside. */
double scoring_measures_regions_surprise(double dx, double dy, double sxx, double sxy, double syy) {
  double determinant;
  determinant = sxx * syy - sxy * sxy;
  if (!(sxx > 0.0 && syy > 0.0 && determinant > 0.0)) {
    return -1.0;
  }
  return (syy * dx * dx - 2.0 * sxy * dx * dy + sxx * dy * dy) / determinant;
}

/* The ranked score along one axis. */
double scoring_measures_regions_axis_score(double error, double variance, double tail) {
  double scale;
  scale = sqrt(max_float(variance, 0.0));
  return tail != tail ? scoring_measures_regions_ranked_score(error, scale) : scoring_measures_regions_student_score(error, scale, tail);
}

/* A row of ``out`` for each trial, NaN where no region was given; ``offsets`` need not begin at 0. */
void scoring_measures_regions_calibrate(Table rows, Table answers, WholeVector offsets, WholeVector arrivals, Table out) {
  int64_t first, last;
  double all_s, claimed_s, ranked, weight, sxx, sxy, syy, tail, dx, dy, far;
  Vector inside;
  double buffer_2[3];
  fill((Vector){(Table){out.p, out.n, out.m}.p, (Table){out.p, out.n, out.m}.n * (Table){out.p, out.n, out.m}.m}, NAN);
  for (int64_t k = 0, end_1 = offsets.n - 1; k < end_1; k++) {
    first = offsets.p[k] - offsets.p[0];
    last = offsets.p[k + 1] - offsets.p[0] - 1;
    all_s = 0.0;
    claimed_s = 0.0;
    ranked = 0.0;
    memset(buffer_2, 0, sizeof buffer_2);
    inside = (Vector){buffer_2, 3};
    for (int64_t i = first, end_3 = arrivals.p[k] - offsets.p[0]; i < end_3; i++) {
      weight = min_float(rows.p[(i + 1) * rows.m + 0] - rows.p[i * rows.m + 0], scoring_measures_endpoint_WEIGHT_S);
      all_s += weight;
      sxx = answers.p[i * answers.m + 3];
      sxy = answers.p[i * answers.m + 4];
      syy = answers.p[i * answers.m + 5];
      tail = answers.p[i * answers.m + 8];
      if (sxx != sxx) {
        continue;
      }
      claimed_s += weight;
      dx = rows.p[last * rows.m + 1] - answers.p[i * answers.m + 1];
      dy = rows.p[last * rows.m + 2] - answers.p[i * answers.m + 2];
      far = scoring_measures_regions_surprise(dx, dy, sxx, sxy, syy);
      for (int64_t j = 0; j < 3; j++) {
        if (0.0 <= far && far <= regions_reach(((const double *)&scoring_measures_regions_LEVELS)[j], tail)) {
          inside.p[j] += weight;
        }
      }
      ranked = ranked + weight * 0.5 * (scoring_measures_regions_axis_score(dx, sxx, tail) + scoring_measures_regions_axis_score(dy, syy, tail));
    }
    out.p[k * out.m + scoring_measures_regions_CLAIMED] = claimed_s / all_s;
    if (claimed_s > 0.0) {
      for (int64_t j = 0; j < 3; j++) {
        out.p[k * out.m + scoring_measures_regions_INSIDE + j] = inside.p[j] / claimed_s;
      }
      out.p[k * out.m + scoring_measures_regions_RANKED] = ranked / claimed_s;
    }
  }
}

/* A row a trial: for each share of the time and level 1 where the region holds the endpoint, else 0. */
void scoring_measures_regions_inside_by_time(Table rows, Table answers, WholeVector offsets, WholeVector arrivals, Vector shares, Table out) {
  WholeVector at;
  int64_t first, last, i;
  double sxx, sxy, syy, dx, dy, far;
  fill((Vector){(Table){out.p, out.n, out.m}.p, (Table){out.p, out.n, out.m}.n * (Table){out.p, out.n, out.m}.m}, NAN);
  RELEASED int64_t *buffer_1 = reserved(shares.n);
  at = (WholeVector){buffer_1, shares.n};
  for (int64_t k = 0, end_2 = offsets.n - 1; k < end_2; k++) {
    first = offsets.p[k] - offsets.p[0];
    last = offsets.p[k + 1] - offsets.p[0] - 1;
    scoring_measures_endpoint_moments(rows, first, arrivals.p[k] - offsets.p[0], last, shares, at);
    for (int64_t m = 0; m < shares.n; m++) {
      i = at.p[m];
      sxx = answers.p[i * answers.m + 3];
      sxy = answers.p[i * answers.m + 4];
      syy = answers.p[i * answers.m + 5];
      if (sxx != sxx) {
        continue;
      }
      dx = rows.p[last * rows.m + 1] - answers.p[i * answers.m + 1];
      dy = rows.p[last * rows.m + 2] - answers.p[i * answers.m + 2];
      far = scoring_measures_regions_surprise(dx, dy, sxx, sxy, syy);
      for (int64_t j = 0; j < 3; j++) {
        out.p[k * out.m + m * 3 + j] = 0.0 <= far && far <= regions_reach(((const double *)&scoring_measures_regions_LEVELS)[j], answers.p[i * answers.m + 8]) ? 1.0 : 0.0;
      }
    }
  }
}

/* Whether the time left lies in the predicted interval: a normal law of its logarithm. */
bool scoring_measures_time_left_within(double left, double predicted, double spread, double deviations) {
  double off;
  off = log(max_float(left, scoring_measures_time_left_SHORTEST_S) / max_float(predicted, scoring_measures_time_left_SHORTEST_S));
  return fabs(off) <= deviations * spread;
}

/* A row of ``out`` for each trial; time counts as in the time-averaged error of the endpoint. */
void scoring_measures_time_left_time_left(Table rows, Table answers, WholeVector offsets, WholeVector arrivals, double median_s, Table out) {
  int64_t first, arrival;
  double all_s, claimed_s, spread_s, error, clock, weight, left, by_clock, predicted, spread;
  Vector inside;
  double buffer_2[3];
  fill((Vector){(Table){out.p, out.n, out.m}.p, (Table){out.p, out.n, out.m}.n * (Table){out.p, out.n, out.m}.m}, NAN);
  for (int64_t k = 0, end_1 = offsets.n - 1; k < end_1; k++) {
    first = offsets.p[k] - offsets.p[0];
    arrival = arrivals.p[k] - offsets.p[0];
    all_s = 0.0;
    claimed_s = 0.0;
    spread_s = 0.0;
    error = 0.0;
    clock = 0.0;
    memset(buffer_2, 0, sizeof buffer_2);
    inside = (Vector){buffer_2, 3};
    for (int64_t i = first; i < arrival; i++) {
      weight = min_float(rows.p[(i + 1) * rows.m + 0] - rows.p[i * rows.m + 0], scoring_measures_endpoint_WEIGHT_S);
      left = rows.p[arrival * rows.m + 0] - rows.p[i * rows.m + 0];
      by_clock = max_float(median_s - rows.p[i * rows.m + 0] + rows.p[first * rows.m + 0], 0.0);
      predicted = answers.p[i * answers.m + scoring_measures_time_left_REMAINING];
      spread = answers.p[i * answers.m + scoring_measures_time_left_SPREADS];
      all_s += weight;
      clock += weight * fabs(left - by_clock);
      if (predicted != predicted) {
        error += weight * fabs(left - by_clock);
        continue;
      }
      claimed_s += weight;
      error += weight * fabs(left - predicted);
      if (spread == spread) {
        spread_s += weight;
        for (int64_t j = 0; j < 3; j++) {
          if (scoring_measures_time_left_within(left, predicted, spread, ((const double *)&scoring_measures_time_left_DEVIATIONS)[j])) {
            inside.p[j] += weight;
          }
        }
      }
    }
    out.p[k * out.m + scoring_measures_time_left_CLAIMED] = claimed_s / all_s;
    out.p[k * out.m + scoring_measures_time_left_SPREAD] = spread_s / all_s;
    out.p[k * out.m + scoring_measures_time_left_ERROR] = error / all_s;
    out.p[k * out.m + scoring_measures_time_left_CLOCK] = clock / all_s;
    if (spread_s > 0.0) {
      for (int64_t j = 0; j < 3; j++) {
        out.p[k * out.m + scoring_measures_time_left_INSIDE + j] = inside.p[j] / spread_s;
      }
    }
  }
}

/* A row a trial: for each share of the time and level 1 where the arrival is in the interval, else 0. */
void scoring_measures_time_left_inside_by_time(Table rows, Table answers, WholeVector offsets, WholeVector arrivals, Vector shares, Table out) {
  WholeVector at;
  int64_t first, arrival;
  double predicted, spread, left;
  fill((Vector){(Table){out.p, out.n, out.m}.p, (Table){out.p, out.n, out.m}.n * (Table){out.p, out.n, out.m}.m}, NAN);
  RELEASED int64_t *buffer_1 = reserved(shares.n);
  at = (WholeVector){buffer_1, shares.n};
  for (int64_t k = 0, end_2 = offsets.n - 1; k < end_2; k++) {
    first = offsets.p[k] - offsets.p[0];
    arrival = arrivals.p[k] - offsets.p[0];
    scoring_measures_endpoint_moments(rows, first, arrival, offsets.p[k + 1] - offsets.p[0] - 1, shares, at);
    for (int64_t m = 0; m < shares.n; m++) {
      predicted = answers.p[at.p[m] * answers.m + scoring_measures_time_left_REMAINING];
      spread = answers.p[at.p[m] * answers.m + scoring_measures_time_left_SPREADS];
      if (predicted != predicted || spread != spread) {
        continue;
      }
      left = rows.p[arrival * rows.m + 0] - rows.p[at.p[m] * rows.m + 0];
      for (int64_t j = 0; j < 3; j++) {
        out.p[k * out.m + m * 3 + j] = scoring_measures_time_left_within(left, predicted, spread, ((const double *)&scoring_measures_time_left_DEVIATIONS)[j]) ? 1.0 : 0.0;
      }
    }
  }
}
