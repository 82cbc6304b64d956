/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const double regions_LARGEST_LOG = 700.0;
static const double regions_NEARLY_NORMAL = 1e+16;

/* Squared Mahalanobis distance up to which the region of a level in (0, 1) goes. */
double regions_reach(double level, double tail) {
  double normal;
  normal = -2.0 * log1p(-level);
  if (!(tail < regions_NEARLY_NORMAL)) {
    return normal;
  }
  if (tail <= 0.0) {
    return NAN;
  }
  if (normal / tail > regions_LARGEST_LOG) {
    return INFINITY;
  }
  return tail * expm1(normal / tail);
}
