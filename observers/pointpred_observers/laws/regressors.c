/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const int64_t regressors_gradient_BACKWARDS = 1;
static const double regressors_gradient_CONTINUOUS = 0.0;
static const double regressors_gradient_NONLINEAR = 2.0;
static const int64_t regressors_gradient_STEPS_MOST = 10000;
static const double regressors_gradient_STEP_MOST = 0.5;
static const int64_t regressors_gradient_TAKEN = 0;
static const int64_t regressors_gradient_TOO_STEEP = 2;
static const int64_t regressors_gradient_UNUSABLE = 3;

/* The parts in their places. */
regressors_gradient_Parts regressors_gradient_parts_of(regressors_gradient_Memory * memory) {
  int64_t n, width, clock_at, theta_at, last_at, between_at, stage_at;
  n = (int64_t)memory->count;
  width = (int64_t)memory->width;
  clock_at = n + n * n;
  theta_at = clock_at + 2;
  last_at = theta_at + n;
  between_at = last_at + width;
  stage_at = between_at + width;
  return (regressors_gradient_Parts){(Vector){(Vector){memory->rest, -1}.p, n}, (Table){(Vector){(Vector){memory->rest, -1}.p + n, clock_at - n}.p, n, n}, (Vector){(Vector){memory->rest, -1}.p + clock_at, theta_at - clock_at}, (Vector){(Vector){memory->rest, -1}.p + theta_at, last_at - theta_at}, (Vector){(Vector){memory->rest, -1}.p + last_at, between_at - last_at}, (Vector){(Vector){memory->rest, -1}.p + between_at, stage_at - between_at}, (Vector){(Vector){memory->rest, -1}.p + stage_at, stage_at + n - stage_at}, (Vector){(Vector){memory->rest, -1}.p + (stage_at + n), stage_at + 2 * n - (stage_at + n)}, (Vector){(Vector){memory->rest, -1}.p + (stage_at + 2 * n), stage_at + 3 * n - (stage_at + 2 * n)}};
}

/* The parts of a sample. */
regressors_gradient_Sample regressors_gradient_sample_of(Vector numbers, int64_t n) {
  int64_t p;
  p = floor_divided_whole(numbers.n, n + 1);
  return (regressors_gradient_Sample){(Table){(Vector){numbers.p, p * n}.p, p, n}, (Vector){numbers.p + p * n, p * n + p - p * n}};
}

/* The trace of D G D': the sum of the decay rates of the errors of the outputs, in 1/s or per sample. */
WIDE double regressors_gradient_steepness(Table d, Table gain) {
  double total;
  total = 0.0;
  for (int64_t row = 0; row < d.n; row++) {
    for (int64_t i = 0; i < gain.n; i++) {
      for (int64_t j = 0; j < gain.n; j++) {
        total += d.p[row * d.m + i] * gain.p[i * gain.m + j] * d.p[row * d.m + j];
      }
    }
  }
  return total;
}

/* Follow (3.46) over ``h`` s: exact for one output, a symmetric splitting of second order for several. */
void regressors_gradient_flow(regressors_gradient_Parts s, double h) {
  regressors_gradient_Sample sample;
  int64_t p, row;
  double output;
  sample = regressors_gradient_sample_of(s.between, s.start.n);
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

/* One step of (3.58); the outputs of the sample become their errors. */
void regressors_gradient_jump(regressors_gradient_Parts s) {
  int64_t n;
  regressors_gradient_Sample sample;
  double way;
  n = s.start.n;
  sample = regressors_gradient_sample_of(s.between, n);
  for (int64_t row = 0, end_1 = sample.y.n; row < end_1; row++) {
    for (int64_t j = 0; j < n; j++) {
      sample.y.p[row] -= sample.D.p[row * sample.D.m + j] * (s.start.p[j] + s.theta.p[j]);
    }
  }
  for (int64_t row = 0, end_2 = sample.y.n; row < end_2; row++) {
    for (int64_t i = 0; i < n; i++) {
      for (int64_t j = 0; j < n; j++) {
        way = s.gain.p[i * s.gain.m + j] * sample.D.p[row * sample.D.m + j];
        s.theta.p[i] += way * sample.y.p[row];
      }
    }
  }
}

/* Write G J'(y - (1 - D1) J theta - D1 f(J theta)) of the stage at the interpolated sample. */
void regressors_gradient_slope(double code, regressors_gradient_Parts s) {
  int64_t n;
  double weight, argument, error;
  regressors_gradient_Sample sample;
  n = s.start.n;
  weight = s.between.p[s.between.n - 1];
  sample = regressors_gradient_sample_of(s.between, n);
  for (int64_t i = 0; i < n; i++) {
    s.change.p[i] = 0.0;
  }
  for (int64_t row = 0, end_1 = sample.y.n; row < end_1; row++) {
    argument = 0.0;
    for (int64_t i = 0; i < n; i++) {
      argument += sample.D.p[row * sample.D.m + i] * (s.stage.p[i] + s.start.p[i]);
    }
    error = sample.y.p[row] - (1.0 - weight) * argument - weight * plants_nonlinearity_value(code, argument);
    for (int64_t i = 0; i < n; i++) {
      for (int64_t j = 0; j < n; j++) {
        s.change.p[i] += s.gain.p[i * s.gain.m + j] * sample.D.p[row * sample.D.m + j] * error;
      }
    }
  }
}

/* A step of the classical Runge-Kutta method over the share ``h`` of the interval ``dt``. */
void regressors_gradient_bend(double code, regressors_gradient_Parts s, Vector new, double begin, double h, double dt) {
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
    regressors_gradient_slope(code, s);
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
int64_t regressors_gradient_step(regressors_gradient_Memory * memory, Vector row, Vector out) {
  regressors_gradient_Parts s;
  int64_t n, steps;
  Vector new;
  double weight, h, steep, fastest, needed;
  bool started;
  s = regressors_gradient_parts_of(memory);
  n = s.start.n;
  new = (Vector){row.p + 1, row.n - 1};
  for (int64_t i = 0; i < row.n; i++) {
    if (!(fabs(row.p[i]) < INFINITY)) {
      return regressors_gradient_UNUSABLE;
    }
  }
  weight = row.p[row.n - 1];
  if (memory->kind == regressors_gradient_NONLINEAR && !(weight >= 0.0 && weight <= 1.0)) {
    return regressors_gradient_UNUSABLE;
  }
  started = s.clock.p[0] == 1.0;
  h = row.p[0] - s.clock.p[1];
  if (started && h < 0.0) {
    return regressors_gradient_BACKWARDS;
  }
  steep = regressors_gradient_steepness(regressors_gradient_sample_of(new, n).D, s.gain);
  if (memory->kind == regressors_gradient_CONTINUOUS) {
    for (int64_t i = 0, end_1 = s.last.n; i < end_1; i++) {
      s.between.p[i] = 0.5 * (s.last.p[i] + new.p[i]);
    }
    if (started) {
      regressors_gradient_flow(s, h);
    }
  } else if (memory->kind == regressors_gradient_NONLINEAR) {
    fastest = max_float(regressors_gradient_steepness(regressors_gradient_sample_of(s.last, n).D, s.gain), steep) * memory->steepest;
    needed = started ? fastest * h / regressors_gradient_STEP_MOST : 0.0;
    if (!(needed <= regressors_gradient_STEPS_MOST)) {
      return regressors_gradient_TOO_STEEP;
    }
    steps = started && h > 0.0 ? max_whole(1, (int64_t)ceil(needed)) : 0;
    for (int64_t i = 0; i < steps; i++) {
      regressors_gradient_bend(memory->code, s, new, (double)i / steps, 1.0 / steps, h);
    }
  } else {
    if (!(steep < 2.0)) {
      return regressors_gradient_TOO_STEEP;
    }
    for (int64_t i = 0, end_2 = s.last.n; i < end_2; i++) {
      s.between.p[i] = new.p[i];
    }
    regressors_gradient_jump(s);
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
