/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"


/* What most stages do with the numbers of their parameters: these are their settings. */
void stage_copy_values(Vector values, Vector memory) {
  for (int64_t i = 0; i < values.n; i++) {
    memory.p[i] = values.p[i];
  }
}

/* The first row whose answer is a refusal, with NaN for a time; -1 where there is none. */
int64_t stage_first_refused(Table answers) {
  for (int64_t i = 0; i < answers.n; i++) {
    if (answers.p[i * answers.m + 0] != answers.p[i * answers.m + 0]) {
      return i;
    }
  }
  return -1;
}
