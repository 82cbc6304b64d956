/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const int64_t unknown_input_stage_BASE = 0;
static const int64_t unknown_input_stage_ESTIMATE = 4;
static const int64_t unknown_input_stage_RATE = 3;
static const int64_t unknown_input_stage_STAGE = 2;
static const int64_t unknown_input_stage_TOTAL = 1;

/* The matrices at a point of a box from those at its vertices, a row each; false for one outside. */
bool unknown_input_stage_mix(Table corners, Table axes, Vector p, Vector weights, Vector block) {
  if (!plants_boxes_weigh(axes, p, weights)) {
    return false;
  }
  for (int64_t j = 0; j < block.n; j++) {
    block.p[j] = 0.0;
  }
  for (int64_t i = 0; i < weights.n; i++) {
    if (weights.p[i] != 0.0) {
      for (int64_t j = 0; j < block.n; j++) {
        block.p[j] += weights.p[i] * corners.p[i * corners.m + j];
      }
    }
  }
  return true;
}

/* x_hat = z - E y, with y at a share ``s`` of the interval between two samples. */
WIDE void unknown_input_stage_estimated(Vector block, Table ends, double s, Table space) {
  int64_t n, outputs, at;
  double total, y;
  n = space.m;
  outputs = ends.m - n;
  at = n * n + n * outputs;
  for (int64_t i = 0; i < n; i++) {
    total = space.p[unknown_input_stage_STAGE * space.m + i];
    for (int64_t j = 0; j < outputs; j++) {
      y = (1.0 - s) * ends.p[0 * ends.m + j] + s * ends.p[1 * ends.m + j];
      total -= block.p[at + i * outputs + j] * y;
    }
    space.p[unknown_input_stage_ESTIMATE * space.m + i] = total;
  }
}

/* One of the four rates of a step of ``h`` s by Runge-Kutta, at x_hat and a share ``s`` of the interval. */
WIDE void unknown_input_stage_push(Vector block, Table c, Table ends, double s, int64_t part, double h, Table space) {
  int64_t n, outputs, k_at, t_at;
  double total, b, error, rate;
  n = space.m;
  outputs = ends.m - n;
  k_at = n * n;
  t_at = n * n + 2 * n * outputs;
  for (int64_t i = 0; i < n; i++) {
    total = 0.0;
    for (int64_t j = 0; j < n; j++) {
      b = (1.0 - s) * ends.p[0 * ends.m + outputs + j] + s * ends.p[1 * ends.m + outputs + j];
      total += block.p[i * n + j] * space.p[unknown_input_stage_ESTIMATE * space.m + j] + block.p[t_at + i * n + j] * b;
    }
    space.p[unknown_input_stage_RATE * space.m + i] = total;
  }
  for (int64_t k = 0; k < outputs; k++) {
    error = (1.0 - s) * ends.p[0 * ends.m + k] + s * ends.p[1 * ends.m + k];
    for (int64_t j = 0; j < n; j++) {
      error -= c.p[k * c.m + j] * space.p[unknown_input_stage_ESTIMATE * space.m + j];
    }
    for (int64_t i = 0; i < n; i++) {
      space.p[unknown_input_stage_RATE * space.m + i] += block.p[k_at + i * outputs + k] * error;
    }
  }
  for (int64_t i = 0; i < n; i++) {
    if (part == 0) {
      space.p[unknown_input_stage_BASE * space.m + i] = space.p[unknown_input_stage_STAGE * space.m + i];
      space.p[unknown_input_stage_TOTAL * space.m + i] = 0.0;
    }
    rate = space.p[unknown_input_stage_RATE * space.m + i];
    space.p[unknown_input_stage_TOTAL * space.m + i] += part == 0 || part == 3 ? rate : 2.0 * rate;
    if (part == 3) {
      space.p[unknown_input_stage_STAGE * space.m + i] = space.p[unknown_input_stage_BASE * space.m + i] + h / 6.0 * space.p[unknown_input_stage_TOTAL * space.m + i];
    } else {
      space.p[unknown_input_stage_STAGE * space.m + i] = space.p[unknown_input_stage_BASE * space.m + i] + (part == 2 ? h : 0.5 * h) * rate;
    }
  }
}
