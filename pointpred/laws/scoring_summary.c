/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"


/* Add the columns of each trial to the sums of its person in each group that it is in. */
WIDE void scoring_summary_sums_add_trials(Table columns, WholeVector person, FlagTable inside, Table sums) {
  int64_t people;
  people = floor_divided_whole(sums.n, inside.n);
  for (int64_t k = 0; k < person.n; k++) {
    for (int64_t g = 0; g < inside.n; g++) {
      if (inside.p[g * inside.m + k]) {
        for (int64_t c = 0, end_1 = columns.m; c < end_1; c++) {
          sums.p[(g * people + person.p[k]) * sums.m + c] += columns.p[k * columns.m + c];
        }
      }
    }
  }
}
