/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const int64_t regressors_gradient_BACKWARDS = 1;
static const double regressors_gradient_CONTINUOUS = 0.0;
static const double regressors_gradient_DISCRETE = 1.0;
static const double regressors_gradient_NORMALISED = 2.0;
static const int64_t regressors_gradient_TAKEN = 0;
static const int64_t regressors_gradient_TOO_STEEP = 2;
static const int64_t regressors_gradient_UNUSABLE = 3;
static const int64_t regressors_nonlinear_regression_BACKWARDS = 1;
static const int64_t regressors_nonlinear_regression_STEPS_MOST = 10000;
static const double regressors_nonlinear_regression_STEP_MOST = 0.5;
static const int64_t regressors_nonlinear_regression_TAKEN = 0;
static const int64_t regressors_nonlinear_regression_TOO_FAST = 2;
static const int64_t regressors_nonlinear_regression_UNUSABLE = 3;

/* Floats of a sample. */
int64_t regressors_gradient_width(int64_t n, int64_t p) {
  return p * n + p;
}

/* Floats of the state. */
int64_t regressors_gradient_states(int64_t n, int64_t p) {
  return 2 + n + 2 * regressors_gradient_width(n, p);
}

/* The parts in their places. */
regressors_gradient_Parts regressors_gradient_parts_of(regressors_gradient_Memory * memory) {
  int64_t n, gain_at, clock_at, theta_at, last_at, middle_at;
  n = (int64_t)memory->count;
  gain_at = n;
  clock_at = n + n * n;
  theta_at = clock_at + 2;
  last_at = clock_at + 2 + n;
  middle_at = last_at + regressors_gradient_width(n, (int64_t)memory->outputs);
  return (regressors_gradient_Parts){(Vector){(Vector){memory->rest, -1}.p, gain_at}, (Table){(Vector){(Vector){memory->rest, -1}.p + gain_at, clock_at - gain_at}.p, n, n}, (Vector){(Vector){memory->rest, -1}.p + clock_at, theta_at - clock_at}, (Vector){(Vector){memory->rest, -1}.p + theta_at, last_at - theta_at}, (Vector){(Vector){memory->rest, -1}.p + last_at, middle_at - last_at}, (Vector){(Vector){memory->rest, -1}.p + middle_at, middle_at + middle_at - last_at - middle_at}};
}

/* The parts of a sample. */
regressors_gradient_Sample regressors_gradient_sample_of(Vector numbers, int64_t n) {
  int64_t p;
  p = floor_divided_whole(numbers.n, n + 1);
  return (regressors_gradient_Sample){(Table){(Vector){numbers.p, p * n}.p, p, n}, (Vector){numbers.p + p * n, p * n + p - p * n}};
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
WIDE double regressors_gradient_steepness(Table d, Table gain) {
  int64_t n;
  double total;
  n = gain.n;
  total = 0.0;
  for (int64_t row = 0; row < d.n; row++) {
    for (int64_t i = 0; i < n; i++) {
      for (int64_t j = 0; j < n; j++) {
        total += d.p[row * d.m + i] * gain.p[i * gain.m + j] * d.p[row * d.m + j];
      }
    }
  }
  return total;
}

/* Follow (3.46) over ``h`` s: exact for one output, a symmetric splitting of second order for several. */
void regressors_gradient_flow(regressors_gradient_Parts s, regressors_gradient_Sample sample, double h) {
  int64_t p, row;
  double output;
  p = sample.y.n;
  for (int64_t i = 0, end_1 = 2 * p; i < end_1; i++) {
    row = i < p ? i : 2 * p - 1 - i;
    output = sample.y.p[row];
    for (int64_t j = 0, end_2 = s.start.n; j < end_2; j++) {
      output -= sample.D.p[row * sample.D.m + j] * s.start.p[j];
    }
    regression_gradient_descend_along(s.theta, (Vector){sample.D.p + row * sample.D.m, sample.D.m}, s.gain, output, 0.5 * h);
  }
}

/* One step of (3.58) with ``share`` of the gain; the outputs of the sample become their errors. */
WIDE void regressors_gradient_jump(regressors_gradient_Parts s, regressors_gradient_Sample sample, double share) {
  int64_t n;
  double way;
  n = s.start.n;
  for (int64_t row = 0, end_1 = sample.y.n; row < end_1; row++) {
    for (int64_t j = 0; j < n; j++) {
      sample.y.p[row] -= sample.D.p[row * sample.D.m + j] * (s.start.p[j] + s.theta.p[j]);
    }
  }
  for (int64_t row = 0, end_2 = sample.y.n; row < end_2; row++) {
    for (int64_t i = 0; i < n; i++) {
      for (int64_t j = 0; j < n; j++) {
        way = s.gain.p[i * s.gain.m + j] * sample.D.p[row * sample.D.m + j];
        s.theta.p[i] += share * way * sample.y.p[row];
      }
    }
  }
}

/* Process t and a sample and write the estimate to ``out``; a refused row changes nothing. */
int64_t regressors_gradient_step(regressors_gradient_Memory * memory, Vector row, Vector out) {
  regressors_gradient_Parts s;
  int64_t n;
  Vector new;
  bool started;
  double h, steep;
  regressors_gradient_Sample middle, now;
  s = regressors_gradient_parts_of(memory);
  n = s.start.n;
  new = (Vector){row.p + 1, row.n - 1};
  if (!regressors_gradient_finite(row)) {
    return regressors_gradient_UNUSABLE;
  }
  started = s.clock.p[0] == 1.0;
  h = row.p[0] - s.clock.p[1];
  if (started && h < 0.0) {
    return regressors_gradient_BACKWARDS;
  }
  middle = regressors_gradient_sample_of(s.middle, n);
  if (memory->kind == regressors_gradient_CONTINUOUS) {
    for (int64_t i = 0, end_1 = s.last.n; i < end_1; i++) {
      s.middle.p[i] = 0.5 * (s.last.p[i] + new.p[i]);
    }
    if (started) {
      regressors_gradient_flow(s, middle, h);
    }
  } else {
    now = regressors_gradient_sample_of(new, n);
    steep = regressors_gradient_steepness(now.D, s.gain);
    if (memory->kind == regressors_gradient_DISCRETE && !(steep < 2.0)) {
      return regressors_gradient_TOO_STEEP;
    }
    for (int64_t i = 0, end_2 = s.last.n; i < end_2; i++) {
      s.middle.p[i] = new.p[i];
    }
    regressors_gradient_jump(s, middle, memory->kind == regressors_gradient_NORMALISED ? 1.0 / (1.0 + steep) : 1.0);
  }
  for (int64_t i = 0, end_3 = s.last.n; i < end_3; i++) {
    s.last.p[i] = new.p[i];
  }
  s.clock.p[0] = 1.0;
  s.clock.p[1] = row.p[0];
  for (int64_t i = 0; i < n; i++) {
    out.p[i] = s.start.p[i] + s.theta.p[i];
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

/* The parts in their places. */
regressors_nonlinear_regression_Parts regressors_nonlinear_regression_parts_of(regressors_nonlinear_regression_Memory * memory) {
  int64_t n, wide, theta_at, last_at, between_at, stage_at;
  n = (int64_t)memory->count;
  wide = regressors_nonlinear_regression_width(n, (int64_t)memory->outputs);
  theta_at = n + 2;
  last_at = n + 2 + n;
  between_at = last_at + wide;
  stage_at = last_at + 2 * wide;
  return (regressors_nonlinear_regression_Parts){(Vector){(Vector){memory->rest, -1}.p, n}, (Vector){(Vector){memory->rest, -1}.p + n, theta_at - n}, (Vector){(Vector){memory->rest, -1}.p + theta_at, last_at - theta_at}, (Vector){(Vector){memory->rest, -1}.p + last_at, between_at - last_at}, (Vector){(Vector){memory->rest, -1}.p + between_at, stage_at - between_at}, (Vector){(Vector){memory->rest, -1}.p + stage_at, stage_at + n - stage_at}, (Vector){(Vector){memory->rest, -1}.p + (stage_at + n), stage_at + 2 * n - (stage_at + n)}, (Vector){(Vector){memory->rest, -1}.p + (stage_at + 2 * n), stage_at + 3 * n - (stage_at + 2 * n)}};
}

/* The parts of a sample. */
regressors_nonlinear_regression_Sample regressors_nonlinear_regression_sample_of(Vector numbers, int64_t n) {
  int64_t r;
  r = floor_divided_whole(numbers.n - 1, n + 1);
  return (regressors_nonlinear_regression_Sample){(Table){(Vector){numbers.p, r * n}.p, r, n}, (Vector){numbers.p + r * n, r * n + r - r * n}, numbers.p[r * n + r]};
}

/* The sum of the squares of J, which bounds the eigenvalues of J'J. */
WIDE double regressors_nonlinear_regression_pace(Table regressor) {
  double total;
  total = 0.0;
  for (int64_t row = 0; row < regressor.n; row++) {
    for (int64_t i = 0, end_1 = regressor.m; i < end_1; i++) {
      total += regressor.p[row * regressor.m + i] * regressor.p[row * regressor.m + i];
    }
  }
  return total;
}

/* Write g J'(y - (1 - D1) J theta - D1 f(J theta)) of the stage at the interpolated sample. */
void regressors_nonlinear_regression_slope(regressors_nonlinear_regression_Memory * memory, regressors_nonlinear_regression_Parts s) {
  int64_t n;
  regressors_nonlinear_regression_Sample sample;
  double argument, error;
  n = s.start.n;
  sample = regressors_nonlinear_regression_sample_of(s.between, n);
  for (int64_t i = 0; i < n; i++) {
    s.change.p[i] = 0.0;
  }
  for (int64_t row = 0, end_1 = sample.y.n; row < end_1; row++) {
    argument = 0.0;
    for (int64_t i = 0; i < n; i++) {
      argument += sample.J.p[row * sample.J.m + i] * (s.stage.p[i] + s.start.p[i]);
    }
    error = sample.y.p[row] - (1.0 - sample.weight) * argument;
    error = error - sample.weight * nonlinearity_value(memory->code, argument);
    for (int64_t i = 0; i < n; i++) {
      s.change.p[i] += memory->gain * sample.J.p[row * sample.J.m + i] * error;
    }
  }
}

/* A step of the classical Runge-Kutta method over the share ``h`` of the interval ``dt``. */
void regressors_nonlinear_regression_flow(regressors_nonlinear_regression_Memory * memory, regressors_nonlinear_regression_Parts s, Vector new, double begin, double h, double dt) {
  int64_t n;
  double at, weight, ahead;
  n = s.start.n;
  for (int64_t i = 0; i < n; i++) {
    s.stage.p[i] = s.theta.p[i];
    s.total.p[i] = 0.0;
  }
  for (int64_t part = 0; part < 4; part++) {
    at = begin + (part == 0 ? 0.0 : part == 3 ? h : 0.5 * h);
    for (int64_t i = 0, end_1 = s.last.n; i < end_1; i++) {
      s.between.p[i] = s.last.p[i] + at * (new.p[i] - s.last.p[i]);
    }
    regressors_nonlinear_regression_slope(memory, s);
    weight = part == 0 || part == 3 ? 1.0 : 2.0;
    ahead = part == 2 ? h * dt : 0.5 * h * dt;
    for (int64_t i = 0; i < n; i++) {
      s.total.p[i] += weight * s.change.p[i];
      s.stage.p[i] = s.theta.p[i] + ahead * s.change.p[i];
    }
  }
  for (int64_t i = 0; i < n; i++) {
    s.theta.p[i] += h * dt / 6.0 * s.total.p[i];
  }
}

/* Process t and a sample and write the estimate to ``out``; a refused row changes nothing. */
int64_t regressors_nonlinear_regression_step(regressors_nonlinear_regression_Memory * memory, Vector row, Vector out) {
  regressors_nonlinear_regression_Parts s;
  int64_t n, steps;
  Vector new;
  regressors_nonlinear_regression_Sample sample, last;
  double dt, steep, needed;
  s = regressors_nonlinear_regression_parts_of(memory);
  n = s.start.n;
  new = (Vector){row.p + 1, row.n - 1};
  sample = regressors_nonlinear_regression_sample_of(new, n);
  if (!regressors_gradient_finite(row) || !(0.0 <= sample.weight && sample.weight <= 1.0)) {
    return regressors_nonlinear_regression_UNUSABLE;
  }
  if (s.clock.p[0] == 1.0) {
    dt = row.p[0] - s.clock.p[1];
    if (dt < 0.0) {
      return regressors_nonlinear_regression_BACKWARDS;
    }
    last = regressors_nonlinear_regression_sample_of(s.last, n);
    steep = max_float(regressors_nonlinear_regression_pace(last.J), regressors_nonlinear_regression_pace(sample.J));
    needed = memory->gain * steep * memory->steepest * dt / regressors_nonlinear_regression_STEP_MOST;
    if (!(needed <= regressors_nonlinear_regression_STEPS_MOST)) {
      return regressors_nonlinear_regression_TOO_FAST;
    }
    steps = max_whole(1, (int64_t)ceil(needed));
    if (dt > 0.0) {
      for (int64_t i = 0; i < steps; i++) {
        regressors_nonlinear_regression_flow(memory, s, new, (double)i / steps, 1.0 / steps, dt);
      }
    }
  }
  s.clock.p[0] = 1.0;
  s.clock.p[1] = row.p[0];
  for (int64_t i = 0; i < new.n; i++) {
    s.last.p[i] = new.p[i];
  }
  for (int64_t i = 0; i < n; i++) {
    out.p[i] = s.theta.p[i] + s.start.p[i];
  }
  return regressors_nonlinear_regression_TAKEN;
}
