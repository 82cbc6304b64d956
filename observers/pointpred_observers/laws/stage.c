/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"


/* What most stages do when a movement ends. */
void stage_learn_nothing(Vector memory) {
}
