/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const double plants_boxes_BORDER = 1e-09;

/* The weight of each vertex of a box at a point; false for a point outside. */
WIDE bool plants_boxes_weigh(Table axes, Vector p, Vector weights) {
  int64_t count;
  double low, high, slack, up;
  count = 1;
  weights.p[0] = 1.0;
  for (int64_t axis = 0; axis < axes.n; axis++) {
    low = axes.p[axis * axes.m + 0];
    high = axes.p[axis * axes.m + 1];
    slack = plants_boxes_BORDER * (high - low);
    if (!(low - slack <= p.p[axis] && p.p[axis] <= high + slack)) {
      return false;
    }
    if (low < high) {
      up = min_float(max_float((p.p[axis] - low) / (high - low), 0.0), 1.0);
      for (int64_t i = count - 1; i > (-1); i--) {
        weights.p[2 * i + 1] = weights.p[i] * up;
        weights.p[2 * i] = weights.p[i] * (1.0 - up);
      }
      count *= 2;
    }
  }
  return true;
}
