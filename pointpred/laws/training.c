/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"


/* ``reaches`` into an array. */
void training_calibration_fill_reaches(double level, Vector tail, Vector far) {
  for (int64_t i = 0; i < tail.n; i++) {
    far.p[i] = regions_reach(level, tail.p[i]);
  }
}
