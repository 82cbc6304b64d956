/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

