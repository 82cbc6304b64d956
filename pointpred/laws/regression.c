/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const int64_t regression_delay_PER_DELAY = 64;

/* A = d A + w w', psi = d psi + w y for the regressor w and y = ``output``. */
WIDE void regression_least_squares_advance(regression_least_squares_Sums * s, regression_least_squares_Regression regression, double forgetting, double output) {
  Vector w, z;
  Table r;
  int64_t n;
  double keep, rest, top, low, length, cosine, sine, upper, lower;
  w = regression.w;
  z = regression.z;
  r = regression.R;
  n = w.n;
  if (forgetting < 1.0) {
    keep = sqrt(forgetting);
    for (int64_t i = 0; i < n; i++) {
      z.p[i] *= keep;
      for (int64_t j = 0; j < n; j++) {
        r.p[i * r.m + j] *= keep;
      }
    }
  }
  rest = output;
  for (int64_t i = 0; i < n; i++) {
    top = r.p[i * r.m + i];
    low = w.p[i];
    length = hypot(top, low);
    if (low == 0.0 || length == 0.0) {
      continue;
    }
    cosine = top / length;
    sine = low / length;
    for (int64_t j = i; j < n; j++) {
      upper = r.p[i * r.m + j];
      lower = w.p[j];
      r.p[i * r.m + j] = cosine * upper + sine * lower;
      w.p[j] = cosine * lower - sine * upper;
    }
    double value_1 = cosine * z.p[i] + sine * rest;
    double value_2 = cosine * rest - sine * z.p[i];
    z.p[i] = value_1;
    rest = value_2;
  }
  s->samples += 1.0;
  s->effective = forgetting * s->effective + 1.0;
  s->residual = forgetting * s->residual + rest * rest;
}

/* The sine of the angle between column j of the data and those before it: 0 if it depends on them. */
double regression_least_squares_excitation(Table r, int64_t j) {
  double square_;
  square_ = 0.0;
  for (int64_t i = 0, end_1 = j + 1; i < end_1; i++) {
    square_ += r.p[i * r.m + j] * r.p[i * r.m + j];
  }
  return square_ > 0.0 ? fabs(r.p[j * r.m + j]) / sqrt(square_) : 0.0;
}

/* Write the estimate to ``out``; False, without writing, if an excitation is below ``least``. */
bool regression_least_squares_solve(regression_least_squares_Regression regression, double least, Vector out) {
  Vector z;
  Table r;
  int64_t n, i;
  double value;
  z = regression.z;
  r = regression.R;
  n = z.n;
  for (int64_t j = 0; j < n; j++) {
    if (regression_least_squares_excitation(r, j) < least) {
      return false;
    }
  }
  for (int64_t back = 0; back < n; back++) {
    i = n - 1 - back;
    value = z.p[i];
    for (int64_t j = i + 1; j < n; j++) {
      value -= r.p[i * r.m + j] * out.p[j];
    }
    out.p[i] = value / r.p[i * r.m + i];
  }
  return true;
}

/* Store the sample (t, w, y), never before the last. */
void regression_delay_push(regression_delay_Ring * ring, int64_t samples, double spacing, double t, Vector w, double y) {
  int64_t n, size, count, newest, before, at;
  bool keep;
  double last_t;
  n = w.n;
  size = n + 2;
  count = (int64_t)ring->count;
  newest = (int64_t)ring->newest;
  keep = count > 0;
  if (keep) {
    last_t = ring->samples[newest * size];
    keep = t > last_t;
    if (keep && count > 1) {
      before = newest > 0 ? newest - 1 : samples - 1;
      keep = last_t - ring->samples[before * size] >= spacing;
    }
  }
  if (keep) {
    newest = newest + 1 < samples ? newest + 1 : 0;
  }
  if (keep || count == 0) {
    ring->count = min_whole(count + 1, samples);
    ring->newest = newest;
  }
  at = newest * size;
  ring->samples[at] = t;
  for (int64_t j = 0; j < n; j++) {
    ring->samples[at + 1 + j] = w.p[j];
  }
  ring->samples[at + 1 + n] = y;
}

/* Samples needed to span a number of delays: the two newest and one on each side. */
int64_t regression_delay_capacity(int64_t delays) {
  return delays * regression_delay_PER_DELAY + 4;
}

/* Store y = w'theta at ``t`` without learning; returns the step in s. */
double regression_drem_remember(regression_drem_State * s, regression_drem_Regression r, double delay_s, double t, double y) {
  double h;
  int64_t n;
  h = s->started == 1.0 ? t - s->t : 0.0;
  s->started = 1.0;
  s->t = t;
  n = r.w.n;
  regression_delay_push((regression_delay_Ring *)(r.past.p), regression_delay_capacity(n - 1), delay_s / regression_delay_PER_DELAY, t, r.w, y);
  for (int64_t j = 0; j < n; j++) {
    r.largest.p[j] = max_float(r.largest.p[j], fabs(r.w.p[j]));
  }
  return h;
}

/* Write w(t) and return y(t), on a line between the samples around ``t``: (history long enough?, y). */
Tbd regression_delay_delayed(regression_delay_Ring * ring, int64_t samples, double t, Vector w) {
  int64_t n, size, count, newest, oldest, before, after, low, high, middle, row;
  double share, first;
  n = w.n;
  size = n + 2;
  count = (int64_t)ring->count;
  newest = (int64_t)ring->newest;
  oldest = newest - count + 1;
  if (oldest < 0) {
    oldest += samples;
  }
  before = newest * size;
  after = newest * size;
  share = 0.0;
  if (count == 0 || t < ring->samples[oldest * size]) {
    return (Tbd){false, 0.0};
  }
  if (t < ring->samples[after]) {
    before = oldest * size;
    low = 0;
    high = count - 1;
    while (high - low > 1) {
      middle = floor_divided_whole(low + high, 2);
      row = oldest + middle;
      if (row >= samples) {
        row -= samples;
      }
      if (ring->samples[row * size] <= t) {
        low = middle;
        before = row * size;
      } else {
        high = middle;
        after = row * size;
      }
    }
    share = (t - ring->samples[before]) / (ring->samples[after] - ring->samples[before]);
  }
  for (int64_t j = 0; j < n; j++) {
    first = ring->samples[before + 1 + j];
    w.p[j] = first + share * (ring->samples[after + 1 + j] - first);
  }
  first = ring->samples[before + 1 + n];
  return (Tbd){true, first + share * (ring->samples[after + 1 + n] - first)};
}

/* Phi and Y: row i is w and y at t - i delay_s; False if the history is too short or a row is zero. */
bool regression_drem_extend(regression_drem_Regression r, double delay_s, double t) {
  int64_t n, samples;
  regression_delay_Ring * past;
  Vector row;
  bool known;
  double y, square_, norm;
  n = r.w.n;
  past = (regression_delay_Ring *)(r.past.p);
  samples = regression_delay_capacity(n - 1);
  for (int64_t i = 0; i < n; i++) {
    row = (Vector){r.Phi.p + i * r.Phi.m, r.Phi.m};
    Tbd values_1 = regression_delay_delayed(past, samples, t - i * delay_s, row);
    known = values_1.f0;
    y = values_1.f1;
    if (!known) {
      return false;
    }
    square_ = 0.0;
    for (int64_t j = 0; j < n; j++) {
      row.p[j] = r.largest.p[j] > 0.0 ? row.p[j] / r.largest.p[j] : 0.0;
      square_ += row.p[j] * row.p[j];
    }
    if (square_ == 0.0) {
      return false;
    }
    norm = sqrt(square_);
    for (int64_t j = 0; j < n; j++) {
      row.p[j] = row.p[j] / norm;
    }
    r.Y.p[i] = y / norm;
  }
  return true;
}

/* ``mix`` for n = 3 in closed form. */
double regression_drem_mix3(Table a, Vector y, Vector out) {
  double a11, a12, a13, a21, a22, a23, a31, a32, a33, c11, c12, c13, c21, c22, c23, c31, c32, c33;
  a11 = a.p[0 * a.m + 0];
  a12 = a.p[0 * a.m + 1];
  a13 = a.p[0 * a.m + 2];
  a21 = a.p[1 * a.m + 0];
  a22 = a.p[1 * a.m + 1];
  a23 = a.p[1 * a.m + 2];
  a31 = a.p[2 * a.m + 0];
  a32 = a.p[2 * a.m + 1];
  a33 = a.p[2 * a.m + 2];
  c11 = a22 * a33 - a23 * a32;
  c12 = a23 * a31 - a21 * a33;
  c13 = a21 * a32 - a22 * a31;
  c21 = a13 * a32 - a12 * a33;
  c22 = a11 * a33 - a13 * a31;
  c23 = a12 * a31 - a11 * a32;
  c31 = a12 * a23 - a13 * a22;
  c32 = a13 * a21 - a11 * a23;
  c33 = a11 * a22 - a12 * a21;
  out.p[0] = c11 * y.p[0] + c21 * y.p[1] + c31 * y.p[2];
  out.p[1] = c12 * y.p[0] + c22 * y.p[1] + c32 * y.p[2];
  out.p[2] = c13 * y.p[0] + c23 * y.p[1] + c33 * y.p[2];
  return a11 * c11 + a12 * c12 + a13 * c13;
}

/* The determinant of a square matrix, which is destroyed, by elimination with row pivoting. */
WIDE double regression_drem_determinant(Table a) {
  int64_t n, pivot;
  double result, value, factor;
  n = a.n;
  result = 1.0;
  for (int64_t k = 0; k < n; k++) {
    pivot = k;
    for (int64_t i = k + 1; i < n; i++) {
      if (fabs(a.p[i * a.m + k]) > fabs(a.p[pivot * a.m + k])) {
        pivot = i;
      }
    }
    value = a.p[pivot * a.m + k];
    if (value == 0.0) {
      return 0.0;
    }
    if (pivot != k) {
      result = -result;
      for (int64_t j = k; j < n; j++) {
        double value_1 = a.p[pivot * a.m + j];
        double value_2 = a.p[k * a.m + j];
        a.p[k * a.m + j] = value_1;
        a.p[pivot * a.m + j] = value_2;
      }
    }
    result *= value;
    for (int64_t i = k + 1; i < n; i++) {
      factor = a.p[i * a.m + k] / value;
      for (int64_t j = k + 1; j < n; j++) {
        a.p[i * a.m + j] -= factor * a.p[k * a.m + j];
      }
    }
  }
  return result;
}

/* Write adj(A) y to ``out`` and return det A; ``scratch`` has room for A. */
double regression_drem_mix(Table a, Vector y, Vector out, Vector scratch) {
  int64_t n;
  Table replaced;
  double value, phi;
  n = y.n;
  if (n == 3) {
    return regression_drem_mix3(a, y, out);
  }
  replaced = (Table){scratch.p, n, n};
  for (int64_t column = -1; column < n; column++) {
    for (int64_t i = 0; i < n; i++) {
      for (int64_t j = 0; j < n; j++) {
        replaced.p[i * replaced.m + j] = j == column ? y.p[i] : a.p[i * a.m + j];
      }
    }
    value = regression_drem_determinant(replaced);
    if (column < 0) {
      phi = value;
    } else {
      out.p[column] = value;
    }
  }
  return phi;
}

/* Follow theta' = gamma phi (mixed - phi theta) over ``h`` s with constant mixed and phi. */
double regression_gradient_descend(double theta, double mixed, double phi, double gamma, double h) {
  double exponent;
  exponent = gamma * phi * phi * h;
  if (exponent <= 0.0) {
    return theta;
  }
  return theta - expm1(-exponent) / phi * (mixed - phi * theta);
}

/* Learn from y = w'theta at ``t``; False while the history is shorter than (n - 1) delays. */
bool regression_drem_advance(regression_drem_State * s, regression_drem_Regression r, double delay_s, double gamma, double t, double y) {
  double h, phi;
  h = regression_drem_remember(s, r, delay_s, t, y);
  s->phi = 0.0;
  if (!regression_drem_extend(r, delay_s, t)) {
    return false;
  }
  phi = regression_drem_mix(r.Phi, r.Y, r.mixed, r.scratch);
  s->phi = phi;
  s->excitation += gamma * phi * phi * h;
  for (int64_t i = 0, end_1 = r.theta.n; i < end_1; i++) {
    if (r.largest.p[i] > 0.0) {
      r.theta.p[i] = regression_gradient_descend(r.theta.p[i], r.mixed.p[i] / r.largest.p[i], phi, gamma, h);
    }
  }
  return true;
}

/* Floats of a ring for that many samples of n + 1 values. */
int64_t regression_delay_states(int64_t n, int64_t samples) {
  return 2 + samples * (n + 2);
}

/* Floats that n unknowns need besides the state. */
int64_t regression_drem_numbers(int64_t n) {
  return 5 * n + 2 * n * n + regression_delay_states(n, regression_delay_capacity(n - 1));
}

/* Follow theta' = G w (output - w'theta) over ``h`` s with w and output constant. */
WIDE void regression_gradient_descend_along(Vector theta, Vector w, Table gain, double output, double h) {
  int64_t n;
  double error, square_, exponent, share;
  n = theta.n;
  error = output;
  square_ = 0.0;
  for (int64_t i = 0; i < n; i++) {
    error -= w.p[i] * theta.p[i];
    for (int64_t j = 0; j < n; j++) {
      square_ += w.p[i] * gain.p[i * gain.m + j] * w.p[j];
    }
  }
  exponent = square_ * h;
  if (exponent <= 0.0) {
    return;
  }
  share = -expm1(-exponent) / square_ * error;
  for (int64_t i = 0; i < n; i++) {
    for (int64_t j = 0; j < n; j++) {
      theta.p[i] += share * gain.p[i * gain.m + j] * w.p[j];
    }
  }
}

/* Floats that n unknowns need besides the sums. */
int64_t regression_least_squares_numbers(int64_t n) {
  return 2 * n + n * n;
}
