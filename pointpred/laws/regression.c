/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const int64_t regression_delay_COUNT = 0;
static const int64_t regression_delay_NEWEST = 1;
static const int64_t regression_delay_PER_DELAY = 64;
static const int64_t regression_delay_SAMPLES = 2;
static const int64_t regression_drem_EXCITATION = 3;
static const int64_t regression_drem_PHI = 2;
static const int64_t regression_drem_REGRESSOR = 4;
static const int64_t regression_drem_STARTED = 0;
static const int64_t regression_drem_T = 1;
static const int64_t regression_least_squares_EFFECTIVE = 1;
static const int64_t regression_least_squares_REGRESSOR = 3;
static const int64_t regression_least_squares_RESIDUAL = 2;
static const int64_t regression_least_squares_SAMPLES = 0;

/* Offset of R; z lies n floats before it. */
int64_t regression_least_squares_root(int64_t at, int64_t n) {
  return at + regression_least_squares_REGRESSOR + 2 * n;
}

/* A = d A + w w', psi = d psi + w y for the regressor w at ``at + REGRESSOR`` and y = ``output``. */
void regression_least_squares_advance(Vector memory, int64_t at, int64_t n, double forgetting, double output) {
  int64_t w, z, r;
  double keep, rest, top, low, length, cosine, sine, upper, lower;
  w = at + regression_least_squares_REGRESSOR;
  z = at + regression_least_squares_REGRESSOR + n;
  r = regression_least_squares_root(at, n);
  if (forgetting < 1.0) {
    keep = sqrt(forgetting);
    for (int64_t i = 0, end_1 = n + n * n; i < end_1; i++) {
      memory.p[z + i] *= keep;
    }
  }
  rest = output;
  for (int64_t i = 0; i < n; i++) {
    top = memory.p[r + i * n + i];
    low = memory.p[w + i];
    length = hypot(top, low);
    if (low == 0.0 || length == 0.0) {
      continue;
    }
    cosine = top / length;
    sine = low / length;
    for (int64_t j = i; j < n; j++) {
      upper = memory.p[r + i * n + j];
      lower = memory.p[w + j];
      memory.p[r + i * n + j] = cosine * upper + sine * lower;
      memory.p[w + j] = cosine * lower - sine * upper;
    }
    double value_2 = cosine * memory.p[z + i] + sine * rest;
    double value_3 = cosine * rest - sine * memory.p[z + i];
    memory.p[z + i] = value_2;
    rest = value_3;
  }
  memory.p[at + regression_least_squares_SAMPLES] += 1.0;
  memory.p[at + regression_least_squares_EFFECTIVE] = forgetting * memory.p[at + regression_least_squares_EFFECTIVE] + 1.0;
  memory.p[at + regression_least_squares_RESIDUAL] = forgetting * memory.p[at + regression_least_squares_RESIDUAL] + rest * rest;
}

/* The sine of the angle between column j of the data and those before it: 0 if it depends on them. */
double regression_least_squares_excitation(Vector memory, int64_t at, int64_t n, int64_t j) {
  int64_t r;
  double square_;
  r = regression_least_squares_root(at, n);
  square_ = 0.0;
  for (int64_t i = 0, end_1 = j + 1; i < end_1; i++) {
    square_ += memory.p[r + i * n + j] * memory.p[r + i * n + j];
  }
  return square_ > 0.0 ? fabs(memory.p[r + j * n + j]) / sqrt(square_) : 0.0;
}

/* Write the estimate at ``out``; False, without writing, if an excitation is below ``least``. */
bool regression_least_squares_solve(Vector memory, int64_t at, int64_t n, double least, int64_t out) {
  int64_t r, z, i;
  double value;
  for (int64_t j = 0; j < n; j++) {
    if (regression_least_squares_excitation(memory, at, n, j) < least) {
      return false;
    }
  }
  r = regression_least_squares_root(at, n);
  z = at + regression_least_squares_REGRESSOR + n;
  for (int64_t back = 0; back < n; back++) {
    i = n - 1 - back;
    value = memory.p[z + i];
    for (int64_t j = i + 1; j < n; j++) {
      value -= memory.p[r + i * n + j] * memory.p[out + j];
    }
    memory.p[out + i] = value / memory.p[r + i * n + i];
  }
  return true;
}

/* Offset of the n estimates. */
int64_t regression_drem_estimates(int64_t at, int64_t n) {
  return at + regression_drem_REGRESSOR + 2 * n;
}

/* Make room for the sample at ``t`` (never before the last) and return where its first value goes. */
int64_t regression_delay_push(Vector memory, int64_t at, int64_t width, int64_t samples, double spacing, double t) {
  int64_t size, count, newest, before;
  bool keep;
  double last_t;
  size = 1 + width;
  count = (int64_t)memory.p[at + regression_delay_COUNT];
  newest = (int64_t)memory.p[at + regression_delay_NEWEST];
  keep = count > 0;
  if (keep) {
    last_t = memory.p[at + regression_delay_SAMPLES + newest * size];
    keep = t > last_t;
    if (keep && count > 1) {
      before = newest > 0 ? newest - 1 : samples - 1;
      keep = last_t - memory.p[at + regression_delay_SAMPLES + before * size] >= spacing;
    }
  }
  if (keep) {
    newest = newest + 1 < samples ? newest + 1 : 0;
  }
  if (keep || count == 0) {
    memory.p[at + regression_delay_COUNT] = min_whole(count + 1, samples);
    memory.p[at + regression_delay_NEWEST] = newest;
  }
  memory.p[at + regression_delay_SAMPLES + newest * size] = t;
  return at + regression_delay_SAMPLES + newest * size + 1;
}

/* Floats of scratch space that ``mix`` needs. */
int64_t regression_drem_work(int64_t n) {
  return n * n;
}

/* Offset of the ring of past samples. */
int64_t regression_drem_ring(int64_t at, int64_t n) {
  return at + regression_drem_REGRESSOR + 5 * n + n * n + regression_drem_work(n);
}

/* Samples needed to span a number of delays: the two newest and one on each side. */
int64_t regression_delay_capacity(int64_t delays) {
  return delays * regression_delay_PER_DELAY + 4;
}

/* Store output = regressor . theta at ``t`` without learning; returns the step in s. */
double regression_drem_remember(Vector memory, int64_t at, int64_t n, double delay_s, double t, double output) {
  int64_t scale, slot;
  double h, value;
  scale = at + regression_drem_REGRESSOR + n;
  h = memory.p[at + regression_drem_STARTED] == 1.0 ? t - memory.p[at + regression_drem_T] : 0.0;
  memory.p[at + regression_drem_STARTED] = 1.0;
  memory.p[at + regression_drem_T] = t;
  slot = regression_delay_push(memory, regression_drem_ring(at, n), n + 1, regression_delay_capacity(n - 1), delay_s / regression_delay_PER_DELAY, t);
  for (int64_t j = 0; j < n; j++) {
    value = memory.p[at + regression_drem_REGRESSOR + j];
    memory.p[slot + j] = value;
    memory.p[scale + j] = max_float(memory.p[scale + j], fabs(value));
  }
  memory.p[slot + n] = output;
  return h;
}

/* The samples around ``t``: (history long enough?, place before, place after, weight of after). */
Tb2qd regression_delay_find(Vector memory, int64_t at, int64_t width, int64_t samples, double t) {
  int64_t size, count, newest, last, oldest, low, high, before, after, middle, row, place;
  size = 1 + width;
  count = (int64_t)memory.p[at + regression_delay_COUNT];
  newest = (int64_t)memory.p[at + regression_delay_NEWEST];
  last = at + regression_delay_SAMPLES + newest * size;
  if (count > 0 && t >= memory.p[last]) {
    return (Tb2qd){true, last + 1, last + 1, 0.0};
  }
  oldest = newest - count + 1;
  if (oldest < 0) {
    oldest += samples;
  }
  if (count == 0 || t < memory.p[at + regression_delay_SAMPLES + oldest * size]) {
    return (Tb2qd){false, at, at, 0.0};
  }
  low = 0;
  high = count - 1;
  before = at + regression_delay_SAMPLES + oldest * size;
  after = last;
  while (high - low > 1) {
    middle = floor_divided_whole(low + high, 2);
    row = oldest + middle;
    if (row >= samples) {
      row -= samples;
    }
    place = at + regression_delay_SAMPLES + row * size;
    if (memory.p[place] <= t) {
      low = middle;
      before = place;
    } else {
      high = middle;
      after = place;
    }
  }
  return (Tb2qd){true, before + 1, after + 1, (t - memory.p[before]) / (memory.p[after] - memory.p[before])};
}

/* Fill the rows w(t - i delay), y(t - i delay); False if the history is too short or a row is zero. */
bool regression_drem_extend(Vector memory, int64_t at, int64_t n, double delay_s, double t) {
  int64_t scale, output, rows, past, samples, before, after;
  bool long_enough;
  double share, square_, value, norm, y;
  scale = at + regression_drem_REGRESSOR + n;
  output = at + regression_drem_REGRESSOR + 3 * n;
  rows = output + 2 * n;
  past = regression_drem_ring(at, n);
  samples = regression_delay_capacity(n - 1);
  for (int64_t i = 0; i < n; i++) {
    Tb2qd values_1 = regression_delay_find(memory, past, n + 1, samples, t - i * delay_s);
    long_enough = values_1.f0;
    before = values_1.f1;
    after = values_1.f2;
    share = values_1.f3;
    if (!long_enough) {
      return false;
    }
    square_ = 0.0;
    for (int64_t j = 0; j < n; j++) {
      value = memory.p[before + j] + share * (memory.p[after + j] - memory.p[before + j]);
      value = memory.p[scale + j] > 0.0 ? value / memory.p[scale + j] : 0.0;
      memory.p[rows + i * n + j] = value;
      square_ += value * value;
    }
    if (square_ == 0.0) {
      return false;
    }
    norm = sqrt(square_);
    for (int64_t j = 0; j < n; j++) {
      memory.p[rows + i * n + j] = memory.p[rows + i * n + j] / norm;
    }
    y = memory.p[before + n] + share * (memory.p[after + n] - memory.p[before + n]);
    memory.p[output + i] = y / norm;
  }
  return true;
}

/* ``mix`` for n = 3 in closed form. */
double regression_drem_mix3(Vector memory, int64_t a, int64_t y, int64_t out) {
  double a11, a12, a13, a21, a22, a23, a31, a32, a33, y1, y2, y3, c11, c12, c13, c21, c22, c23, c31, c32, c33;
  a11 = memory.p[a];
  a12 = memory.p[a + 1];
  a13 = memory.p[a + 2];
  a21 = memory.p[a + 3];
  a22 = memory.p[a + 4];
  a23 = memory.p[a + 5];
  a31 = memory.p[a + 6];
  a32 = memory.p[a + 7];
  a33 = memory.p[a + 8];
  y1 = memory.p[y];
  y2 = memory.p[y + 1];
  y3 = memory.p[y + 2];
  c11 = a22 * a33 - a23 * a32;
  c12 = a23 * a31 - a21 * a33;
  c13 = a21 * a32 - a22 * a31;
  c21 = a13 * a32 - a12 * a33;
  c22 = a11 * a33 - a13 * a31;
  c23 = a12 * a31 - a11 * a32;
  c31 = a12 * a23 - a13 * a22;
  c32 = a13 * a21 - a11 * a23;
  c33 = a11 * a22 - a12 * a21;
  memory.p[out] = c11 * y1 + c21 * y2 + c31 * y3;
  memory.p[out + 1] = c12 * y1 + c22 * y2 + c32 * y3;
  memory.p[out + 2] = c13 * y1 + c23 * y2 + c33 * y3;
  return a11 * c11 + a12 * c12 + a13 * c13;
}

/* The determinant of the row-major n x n matrix at ``at``, which is destroyed. */
double regression_drem_determinant(Vector memory, int64_t at, int64_t n) {
  double result, value, factor;
  int64_t pivot, top, low;
  result = 1.0;
  for (int64_t k = 0; k < n; k++) {
    pivot = k;
    for (int64_t i = k + 1; i < n; i++) {
      if (fabs(memory.p[at + i * n + k]) > fabs(memory.p[at + pivot * n + k])) {
        pivot = i;
      }
    }
    value = memory.p[at + pivot * n + k];
    if (value == 0.0) {
      return 0.0;
    }
    if (pivot != k) {
      result = -result;
      for (int64_t j = k; j < n; j++) {
        top = at + k * n + j;
        low = at + pivot * n + j;
        double value_1 = memory.p[low];
        double value_2 = memory.p[top];
        memory.p[top] = value_1;
        memory.p[low] = value_2;
      }
    }
    result *= value;
    for (int64_t i = k + 1; i < n; i++) {
      factor = memory.p[at + i * n + k] / value;
      for (int64_t j = k + 1; j < n; j++) {
        memory.p[at + i * n + j] -= factor * memory.p[at + k * n + j];
      }
    }
  }
  return result;
}

/* Write adj(A) y at ``out`` and return det A; A is the row-major n x n matrix at ``a``. */
double regression_drem_mix(Vector memory, int64_t a, int64_t y, int64_t n, int64_t out, int64_t scratch) {
  double value, phi;
  if (n == 3) {
    return regression_drem_mix3(memory, a, y, out);
  }
  for (int64_t column = -1; column < n; column++) {
    for (int64_t i = 0; i < n; i++) {
      for (int64_t j = 0; j < n; j++) {
        memory.p[scratch + i * n + j] = j == column ? memory.p[y + i] : memory.p[a + i * n + j];
      }
    }
    value = regression_drem_determinant(memory, scratch, n);
    if (column < 0) {
      phi = value;
    } else {
      memory.p[out + column] = value;
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

/* Process a sample (t, regressor . theta); False while the history is shorter than (n - 1) delays. */
bool regression_drem_advance(Vector memory, int64_t at, int64_t n, double delay_s, double gamma, T2d sample) {
  int64_t scale, theta, extended, mixed, rows;
  double t, output, h, phi, target;
  scale = at + regression_drem_REGRESSOR + n;
  theta = regression_drem_estimates(at, n);
  extended = at + regression_drem_REGRESSOR + 3 * n;
  mixed = extended + n;
  rows = extended + 2 * n;
  t = sample.f0;
  output = sample.f1;
  h = regression_drem_remember(memory, at, n, delay_s, t, output);
  memory.p[at + regression_drem_PHI] = 0.0;
  if (!regression_drem_extend(memory, at, n, delay_s, t)) {
    return false;
  }
  phi = regression_drem_mix(memory, rows, extended, n, mixed, rows + n * n);
  memory.p[at + regression_drem_PHI] = phi;
  memory.p[at + regression_drem_EXCITATION] += gamma * phi * phi * h;
  for (int64_t i = 0; i < n; i++) {
    if (memory.p[scale + i] > 0.0) {
      target = memory.p[mixed + i] / memory.p[scale + i];
      memory.p[theta + i] = regression_gradient_descend(memory.p[theta + i], target, phi, gamma, h);
    }
  }
  return true;
}

/* Floats of a ring for that many samples of ``width`` values. */
int64_t regression_delay_states(int64_t width, int64_t samples) {
  return regression_delay_SAMPLES + samples * (1 + width);
}

/* Floats that n parameters need. */
int64_t regression_drem_states(int64_t n) {
  return regression_drem_ring(0, n) + regression_delay_states(n + 1, regression_delay_capacity(n - 1));
}

/* Follow theta' = G w (output - w'theta) over ``h`` s with w and output constant. */
void regression_gradient_descend_along(Vector theta, Vector w, Table gain, double output, double h) {
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

/* Floats that n parameters need. */
int64_t regression_least_squares_states(int64_t n) {
  return regression_least_squares_REGRESSOR + 2 * n + n * n;
}
