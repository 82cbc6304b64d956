/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const int64_t regressors_gradient_BACKWARDS = 1;
static const double regressors_gradient_CONTINUOUS = 0.0;
static const int64_t regressors_gradient_COUNT = 0;
static const double regressors_gradient_DISCRETE = 1.0;
static const int64_t regressors_gradient_KIND = 2;
static const double regressors_gradient_NORMALISED = 2.0;
static const int64_t regressors_gradient_OUTPUTS = 1;
static const int64_t regressors_gradient_SAMPLE = 1;
static const int64_t regressors_gradient_START = 3;
static const int64_t regressors_gradient_TAKEN = 0;
static const int64_t regressors_gradient_TOO_STEEP = 2;
static const int64_t regressors_gradient_UNUSABLE = 3;
static const int64_t regressors_nonlinear_regression_BACKWARDS = 1;
static const int64_t regressors_nonlinear_regression_CODE = 3;
static const int64_t regressors_nonlinear_regression_COUNT = 0;
static const int64_t regressors_nonlinear_regression_GAIN = 2;
static const int64_t regressors_nonlinear_regression_OUTPUTS = 1;
static const int64_t regressors_nonlinear_regression_SAMPLE = 1;
static const int64_t regressors_nonlinear_regression_START = 5;
static const int64_t regressors_nonlinear_regression_STEEPEST = 4;
static const int64_t regressors_nonlinear_regression_STEPS_MOST = 10000;
static const double regressors_nonlinear_regression_STEP_MOST = 0.5;
static const int64_t regressors_nonlinear_regression_TAKEN = 0;
static const int64_t regressors_nonlinear_regression_TOO_FAST = 2;
static const int64_t regressors_nonlinear_regression_UNUSABLE = 3;

/* Floats of a sample: p rows of the regressor, then p outputs. */
int64_t regressors_gradient_width(int64_t n, int64_t p) {
  return p * n + p;
}

/* Offset of the state. */
int64_t regressors_gradient_state_at(int64_t n) {
  return regressors_gradient_START + n + n * n;
}

/* Floats of the state. */
int64_t regressors_gradient_states(int64_t n, int64_t p) {
  return 2 + n + 2 * regressors_gradient_width(n, p);
}

/* Whether every number of a row is finite. */
bool regressors_gradient_finite(Vector row) {
  for (int64_t i = 1; i < row.n; i++) {
    if (!(fabs(row.p[i]) < INFINITY)) {
      return false;
    }
  }
  return fabs(row.p[0]) < INFINITY;
}

/* The trace of D G D': the sum of the decay rates of the errors of the outputs, in 1/s or per sample. */
double regressors_gradient_steepness(Vector memory, Vector row, int64_t n, int64_t p) {
  int64_t gain, w;
  double total;
  gain = regressors_gradient_START + n;
  total = 0.0;
  for (int64_t output = 0; output < p; output++) {
    w = regressors_gradient_SAMPLE + output * n;
    for (int64_t i = 0; i < n; i++) {
      for (int64_t j = 0; j < n; j++) {
        total += row.p[w + i] * memory.p[gain + i * n + j] * row.p[w + j];
      }
    }
  }
  return total;
}

/* Follow (3.46) over ``h`` s: exact for one output, a symmetric splitting of second order for several. */
void regressors_gradient_flow(Vector memory, int64_t n, int64_t p, int64_t sample, double h) {
  int64_t theta, row;
  double output;
  theta = regressors_gradient_state_at(n) + 2;
  for (int64_t i = 0, end_1 = 2 * p; i < end_1; i++) {
    row = i < p ? i : 2 * p - 1 - i;
    output = memory.p[sample + p * n + row];
    for (int64_t j = 0; j < n; j++) {
      output -= memory.p[sample + row * n + j] * memory.p[regressors_gradient_START + j];
    }
    regression_gradient_descend_along(memory, (T3q){theta, sample + row * n, regressors_gradient_START + n}, n, output, 0.5 * h);
  }
}

/* One step of (3.58) with ``share`` of the gain; the outputs at ``sample`` become their errors. */
void regressors_gradient_jump(Vector memory, int64_t n, int64_t p, int64_t sample, double share) {
  int64_t theta, gain, errors;
  double way;
  theta = regressors_gradient_state_at(n) + 2;
  gain = regressors_gradient_START + n;
  errors = sample + p * n;
  for (int64_t row = 0; row < p; row++) {
    for (int64_t j = 0; j < n; j++) {
      memory.p[errors + row] -= memory.p[sample + row * n + j] * (memory.p[regressors_gradient_START + j] + memory.p[theta + j]);
    }
  }
  for (int64_t row = 0; row < p; row++) {
    for (int64_t i = 0; i < n; i++) {
      for (int64_t j = 0; j < n; j++) {
        way = memory.p[gain + i * n + j] * memory.p[sample + row * n + j];
        memory.p[theta + i] += share * way * memory.p[errors + row];
      }
    }
  }
}

/* Process a row and write the estimate to ``out``; a refused row changes nothing. */
int64_t regressors_gradient_step(Vector memory, Vector row, Vector out) {
  int64_t n, p, state, wide, last, middle;
  bool started;
  double h, steep;
  n = (int64_t)memory.p[regressors_gradient_COUNT];
  p = (int64_t)memory.p[regressors_gradient_OUTPUTS];
  state = regressors_gradient_state_at(n);
  wide = regressors_gradient_width(n, p);
  last = state + 2 + n;
  middle = last + wide;
  if (!regressors_gradient_finite(row)) {
    return regressors_gradient_UNUSABLE;
  }
  started = memory.p[state] == 1.0;
  h = row.p[0] - memory.p[state + 1];
  if (started && h < 0.0) {
    return regressors_gradient_BACKWARDS;
  }
  if (memory.p[regressors_gradient_KIND] == regressors_gradient_CONTINUOUS) {
    for (int64_t i = 0; i < wide; i++) {
      memory.p[middle + i] = 0.5 * (memory.p[last + i] + row.p[regressors_gradient_SAMPLE + i]);
    }
    if (started) {
      regressors_gradient_flow(memory, n, p, middle, h);
    }
  } else {
    steep = regressors_gradient_steepness(memory, row, n, p);
    if (memory.p[regressors_gradient_KIND] == regressors_gradient_DISCRETE && !(steep < 2.0)) {
      return regressors_gradient_TOO_STEEP;
    }
    for (int64_t i = 0; i < wide; i++) {
      memory.p[middle + i] = row.p[regressors_gradient_SAMPLE + i];
    }
    regressors_gradient_jump(memory, n, p, middle, memory.p[regressors_gradient_KIND] == regressors_gradient_NORMALISED ? 1.0 / (1.0 + steep) : 1.0);
  }
  for (int64_t i = 0; i < wide; i++) {
    memory.p[last + i] = row.p[regressors_gradient_SAMPLE + i];
  }
  memory.p[state] = 1.0;
  memory.p[state + 1] = row.p[0];
  for (int64_t i = 0; i < n; i++) {
    out.p[i] = memory.p[regressors_gradient_START + i] + memory.p[state + 2 + i];
  }
  return regressors_gradient_TAKEN;
}

/* Floats of a sample. */
int64_t regressors_nonlinear_regression_width(int64_t n, int64_t r) {
  return r * n + r + 1;
}

/* Floats of the state. */
int64_t regressors_nonlinear_regression_states(int64_t n, int64_t r) {
  return 2 + n + 2 * regressors_nonlinear_regression_width(n, r) + 3 * n;
}

/* The sum of the squares of J, which bounds the eigenvalues of J'J. */
double regressors_nonlinear_regression_pace(Vector sample, int64_t at, int64_t n, int64_t r) {
  double total;
  total = 0.0;
  for (int64_t i = 0, end_1 = r * n; i < end_1; i++) {
    total += sample.p[at + i] * sample.p[at + i];
  }
  return total;
}

/* Write g J'(y - (1 - D1) J theta - D1 f(J theta)) at ``to``; theta minus its start. */
void regressors_nonlinear_regression_slope(Vector memory, int64_t theta, int64_t sample, int64_t to) {
  int64_t n, r;
  double weight, s, error;
  n = (int64_t)memory.p[regressors_nonlinear_regression_COUNT];
  r = (int64_t)memory.p[regressors_nonlinear_regression_OUTPUTS];
  weight = memory.p[sample + r * n + r];
  for (int64_t i = 0; i < n; i++) {
    memory.p[to + i] = 0.0;
  }
  for (int64_t row = 0; row < r; row++) {
    s = 0.0;
    for (int64_t i = 0; i < n; i++) {
      s += memory.p[sample + row * n + i] * (memory.p[theta + i] + memory.p[regressors_nonlinear_regression_START + i]);
    }
    error = memory.p[sample + r * n + row] - (1.0 - weight) * s;
    error -= weight * nonlinearity_value(memory.p[regressors_nonlinear_regression_CODE], s);
    for (int64_t i = 0; i < n; i++) {
      memory.p[to + i] += memory.p[regressors_nonlinear_regression_GAIN] * memory.p[sample + row * n + i] * error;
    }
  }
}

/* A step of the classical Runge-Kutta method over the share ``h`` of the interval ``dt``. */
void regressors_nonlinear_regression_flow(Vector memory, Vector row, double begin, double h, double dt) {
  int64_t n, r, theta, last, wide, between, room;
  double at, weight, ahead;
  n = (int64_t)memory.p[regressors_nonlinear_regression_COUNT];
  r = (int64_t)memory.p[regressors_nonlinear_regression_OUTPUTS];
  theta = regressors_nonlinear_regression_START + n + 2;
  last = regressors_nonlinear_regression_START + n + 2 + n;
  wide = regressors_nonlinear_regression_width(n, r);
  between = last + wide;
  room = last + 2 * wide;
  for (int64_t i = 0; i < n; i++) {
    memory.p[room + i] = memory.p[theta + i];
    memory.p[room + 2 * n + i] = 0.0;
  }
  for (int64_t part = 0; part < 4; part++) {
    at = begin + (part == 0 ? 0.0 : part == 3 ? h : 0.5 * h);
    for (int64_t i = 0; i < wide; i++) {
      memory.p[between + i] = memory.p[last + i] + at * (row.p[regressors_nonlinear_regression_SAMPLE + i] - memory.p[last + i]);
    }
    regressors_nonlinear_regression_slope(memory, room, between, room + n);
    weight = part == 0 || part == 3 ? 1.0 : 2.0;
    ahead = part == 2 ? h * dt : 0.5 * h * dt;
    for (int64_t i = 0; i < n; i++) {
      memory.p[room + 2 * n + i] += weight * memory.p[room + n + i];
      memory.p[room + i] = memory.p[theta + i] + ahead * memory.p[room + n + i];
    }
  }
  for (int64_t i = 0; i < n; i++) {
    memory.p[theta + i] += h * dt / 6.0 * memory.p[room + 2 * n + i];
  }
}

/* Process a row and write the estimate to ``out``; a refused row changes nothing. */
int64_t regressors_nonlinear_regression_step(Vector memory, Vector row, Vector out) {
  int64_t n, r, state, theta, last, steps;
  double dt, steep, needed;
  n = (int64_t)memory.p[regressors_nonlinear_regression_COUNT];
  r = (int64_t)memory.p[regressors_nonlinear_regression_OUTPUTS];
  state = regressors_nonlinear_regression_START + n;
  theta = state + 2;
  last = state + 2 + n;
  if (!regressors_gradient_finite(row) || !(0.0 <= row.p[regressors_nonlinear_regression_SAMPLE + r * n + r] && row.p[regressors_nonlinear_regression_SAMPLE + r * n + r] <= 1.0)) {
    return regressors_nonlinear_regression_UNUSABLE;
  }
  if (memory.p[state] == 1.0) {
    dt = row.p[0] - memory.p[state + 1];
    if (dt < 0.0) {
      return regressors_nonlinear_regression_BACKWARDS;
    }
    steep = max_float(regressors_nonlinear_regression_pace(memory, last, n, r), regressors_nonlinear_regression_pace(row, regressors_nonlinear_regression_SAMPLE, n, r));
    needed = memory.p[regressors_nonlinear_regression_GAIN] * steep * memory.p[regressors_nonlinear_regression_STEEPEST] * dt / regressors_nonlinear_regression_STEP_MOST;
    if (!(needed <= regressors_nonlinear_regression_STEPS_MOST)) {
      return regressors_nonlinear_regression_TOO_FAST;
    }
    steps = max_whole(1, (int64_t)ceil(needed));
    if (dt > 0.0) {
      for (int64_t i = 0; i < steps; i++) {
        regressors_nonlinear_regression_flow(memory, row, (double)i / steps, 1.0 / steps, dt);
      }
    }
  }
  memory.p[state] = 1.0;
  memory.p[state + 1] = row.p[0];
  for (int64_t i = 0, end_1 = regressors_nonlinear_regression_width(n, r); i < end_1; i++) {
    memory.p[last + i] = row.p[regressors_nonlinear_regression_SAMPLE + i];
  }
  for (int64_t i = 0; i < n; i++) {
    out.p[i] = memory.p[theta + i] + memory.p[regressors_nonlinear_regression_START + i];
  }
  return regressors_nonlinear_regression_TAKEN;
}
