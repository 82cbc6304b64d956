/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const int64_t nonlinearity_ATAN = 3;
static const int64_t nonlinearity_CUBE = 5;
static const int64_t nonlinearity_SATURATION = 4;
static const int64_t nonlinearity_SIN = 1;
static const int64_t nonlinearity_TANH = 2;

/* The nonlinearity with the given code at s. */
double nonlinearity_value(double code, double s) {
  if (code == nonlinearity_SIN) {
    return sin(s);
  }
  if (code == nonlinearity_TANH) {
    return tanh(s);
  }
  if (code == nonlinearity_ATAN) {
    return atan(s);
  }
  if (code == nonlinearity_SATURATION) {
    return min_float(max_float(s, -1.0), 1.0);
  }
  if (code == nonlinearity_CUBE) {
    return s * s * s;
  }
  return s;
}
