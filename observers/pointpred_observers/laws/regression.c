/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"


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
