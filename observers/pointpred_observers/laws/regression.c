/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"


/* Follow theta' = G w (output - w'theta) over ``h`` s with w and output constant; theta, w, G lie ``at``. */
void regression_gradient_descend_along(Vector memory, T3q at, int64_t n, double output, double h) {
  int64_t theta, w, gain;
  double error, square_, exponent, share;
  theta = at.f0;
  w = at.f1;
  gain = at.f2;
  error = output;
  square_ = 0.0;
  for (int64_t i = 0; i < n; i++) {
    error -= memory.p[w + i] * memory.p[theta + i];
    for (int64_t j = 0; j < n; j++) {
      square_ += memory.p[w + i] * memory.p[gain + i * n + j] * memory.p[w + j];
    }
  }
  exponent = square_ * h;
  if (exponent <= 0.0) {
    return;
  }
  share = -expm1(-exponent) / square_ * error;
  for (int64_t i = 0; i < n; i++) {
    for (int64_t j = 0; j < n; j++) {
      memory.p[theta + i] += share * memory.p[gain + i * n + j] * memory.p[w + j];
    }
  }
}
