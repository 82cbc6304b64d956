/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const int64_t triangular_interlaced_observer_ANSWERED = 5;
static const int64_t triangular_interlaced_observer_ANSWERS = 4;
static const int64_t triangular_interlaced_observer_BACKWARDS = 1;
static const int64_t triangular_interlaced_observer_FAST = 8;
static const int64_t triangular_interlaced_observer_GAP_S = 7;
static const int64_t triangular_interlaced_observer_MEASURED = 2;
static const double triangular_interlaced_observer_NEGLIGIBLE = 1e-18;
static const int64_t triangular_interlaced_observer_ORDER = 14;
static const int64_t triangular_interlaced_observer_P = 1;
static const int64_t triangular_interlaced_observer_PROGRAM = 3;
static const int64_t triangular_interlaced_observer_Q = 0;
static const int64_t triangular_interlaced_observer_ROWS = 2;
static const int64_t triangular_interlaced_observer_SLOW = 9;
static const int64_t triangular_interlaced_observer_START = 10;
static const int64_t triangular_interlaced_observer_STARTED = 0;
static const int64_t triangular_interlaced_observer_STATE = 6;
static const int64_t triangular_interlaced_observer_STEPS_MOST = 4096;
static const int64_t triangular_interlaced_observer_T = 1;
static const int64_t triangular_interlaced_observer_TAKEN = 0;
static const int64_t triangular_interlaced_observer_Y = 3;
static const int64_t triangular_program_ACOS = 12;
static const int64_t triangular_program_ADD = 1;
static const int64_t triangular_program_ASIN = 11;
static const int64_t triangular_program_ATAN = 13;
static const int64_t triangular_program_COPY = 0;
static const int64_t triangular_program_COS = 9;
static const int64_t triangular_program_DIVIDE = 3;
static const int64_t triangular_program_EXP = 6;
static const double triangular_program_LARGEST_EXPONENT = 700.0;
static const int64_t triangular_program_LOG = 7;
static const int64_t triangular_program_MULTIPLY = 2;
static const int64_t triangular_program_POWER = 4;
static const int64_t triangular_program_ROW = 4;
static const int64_t triangular_program_SIN = 8;
static const int64_t triangular_program_SINH = 15;
static const int64_t triangular_program_SQRT = 5;
static const int64_t triangular_program_TAN = 10;
static const int64_t triangular_program_TANH = 14;

/* Floats before the program. */
int64_t triangular_interlaced_observer_settings(int64_t q, int64_t p) {
  return triangular_interlaced_observer_START + q + 2 * q * q + q * p;
}

/* Floats of the state, with two scratch vectors, before the program's registers. */
int64_t triangular_interlaced_observer_states(int64_t q, int64_t p) {
  return triangular_interlaced_observer_Y + p + 3 * q;
}

/* The part of L y in row i of the first two derivatives, y linear between the two samples. */
double triangular_interlaced_observer_drive(Vector memory, int64_t i, int64_t k, double passed, double share, Vector row) {
  int64_t q, p, gain, last;
  double total, rise;
  q = (int64_t)memory.p[triangular_interlaced_observer_Q];
  p = (int64_t)memory.p[triangular_interlaced_observer_P];
  gain = triangular_interlaced_observer_START + q + 2 * q * q + i * p;
  last = (int64_t)memory.p[triangular_interlaced_observer_STATE] + triangular_interlaced_observer_Y;
  total = 0.0;
  for (int64_t j = 0; j < p; j++) {
    rise = row.p[1 + j] - memory.p[last + j];
    total += memory.p[gain + j] * (k == 1 ? memory.p[last + j] + passed * rise : share * rise);
  }
  return total;
}

/* Follow w' = M w + L y over ``h`` s by the exponential series; without L y unless ``driven``. */
void triangular_interlaced_observer_follow(Vector memory, int64_t matrix, double h, int64_t steps, Vector row, bool driven) {
  int64_t q, w, term, after, source;
  double total, moved, most;
  q = (int64_t)memory.p[triangular_interlaced_observer_Q];
  w = (int64_t)memory.p[triangular_interlaced_observer_STATE] + triangular_interlaced_observer_Y + (int64_t)memory.p[triangular_interlaced_observer_P];
  term = w + q;
  after = w + 2 * q;
  for (int64_t n = 0; n < steps; n++) {
    for (int64_t k = 1; k < (triangular_interlaced_observer_ORDER + 1); k++) {
      source = k == 1 ? w : term;
      for (int64_t i = 0; i < q; i++) {
        total = driven && k <= 2 ? triangular_interlaced_observer_drive(memory, i, k, (double)n / steps, 1.0 / steps, row) : 0.0;
        for (int64_t j = 0; j < q; j++) {
          total += memory.p[matrix + i * q + j] * memory.p[source + j];
        }
        memory.p[after + i] = total * h / (steps * k);
      }
      moved = 0.0;
      most = 0.0;
      for (int64_t i = 0; i < q; i++) {
        memory.p[term + i] = memory.p[after + i];
        memory.p[w + i] += memory.p[after + i];
        moved = max_float(moved, fabs(memory.p[after + i]));
        most = max_float(most, fabs(memory.p[w + i]));
      }
      if (k > 2 && moved <= triangular_interlaced_observer_NEGLIGIBLE * most) {
        break;
      }
    }
  }
}

/* One operation; NaN without a finite real value. */
double triangular_program_apply(int64_t code, double a, double b) {
  bool grows;
  if (code == triangular_program_COPY) {
    return a;
  }
  if (code == triangular_program_ADD) {
    return a + b;
  }
  if (code == triangular_program_MULTIPLY) {
    return a * b;
  }
  if (code == triangular_program_DIVIDE) {
    return b != 0.0 ? a / b : NAN;
  }
  if (code == triangular_program_POWER) {
    return a > 0.0 && b * log(a) < triangular_program_LARGEST_EXPONENT ? pow(a, b) : NAN;
  }
  if (code == triangular_program_SQRT) {
    return a >= 0.0 ? sqrt(a) : NAN;
  }
  if (code == triangular_program_LOG) {
    return a > 0.0 ? log(a) : NAN;
  }
  if (code == triangular_program_ATAN) {
    return atan(a);
  }
  if (code == triangular_program_TANH) {
    return tanh(a);
  }
  if (code == triangular_program_ASIN) {
    return fabs(a) <= 1.0 ? asin(a) : NAN;
  }
  if (code == triangular_program_ACOS) {
    return fabs(a) <= 1.0 ? acos(a) : NAN;
  }
  grows = code >= triangular_program_SINH || (code == triangular_program_EXP && a > 0.0);
  if (!isfinite(a) || (grows && fabs(a) > triangular_program_LARGEST_EXPONENT)) {
    return NAN;
  }
  if (code == triangular_program_EXP) {
    return exp(a);
  }
  if (code == triangular_program_SIN) {
    return sin(a);
  }
  if (code == triangular_program_COS) {
    return cos(a);
  }
  if (code == triangular_program_TAN) {
    return tan(a);
  }
  return code == triangular_program_SINH ? sinh(a) : cosh(a);
}

/* Execute ``count`` rows from ``first`` on. */
void triangular_program_execute(Vector memory, int64_t first, int64_t count) {
  int64_t at, target;
  for (int64_t i = 0; i < count; i++) {
    at = first + triangular_program_ROW * i;
    target = (int64_t)memory.p[at + 1];
    memory.p[target] = triangular_program_apply((int64_t)memory.p[at], memory.p[(int64_t)memory.p[at + 2]], memory.p[(int64_t)memory.p[at + 3]]);
  }
}

/* Process t and the outputs (NaN: not measured) into ``out``; an earlier t changes nothing. */
int64_t triangular_interlaced_observer_step(Vector memory, Vector row, Vector out) {
  int64_t q, p, state, w, a;
  double h, steps;
  bool started, measured, driven;
  q = (int64_t)memory.p[triangular_interlaced_observer_Q];
  p = (int64_t)memory.p[triangular_interlaced_observer_P];
  state = (int64_t)memory.p[triangular_interlaced_observer_STATE];
  w = state + triangular_interlaced_observer_Y + p;
  a = triangular_interlaced_observer_START + q;
  h = row.p[0] - memory.p[state + triangular_interlaced_observer_T];
  started = memory.p[state + triangular_interlaced_observer_STARTED] == 1.0;
  if (started && h < 0.0) {
    return triangular_interlaced_observer_BACKWARDS;
  }
  measured = true;
  for (int64_t j = 0; j < p; j++) {
    if (row.p[1 + j] != row.p[1 + j]) {
      measured = false;
    }
  }
  driven = measured && memory.p[state + triangular_interlaced_observer_MEASURED] == 1.0 && h <= memory.p[triangular_interlaced_observer_GAP_S];
  steps = max_float(1.0, (int64_t)ceil(2.0 * h * memory.p[driven ? triangular_interlaced_observer_FAST : triangular_interlaced_observer_SLOW]));
  if (started && steps <= triangular_interlaced_observer_STEPS_MOST) {
    triangular_interlaced_observer_follow(memory, driven ? a + q * q : a, h, (int64_t)steps, row, driven);
  } else {
    for (int64_t i = 0; i < q; i++) {
      memory.p[w + i] = memory.p[triangular_interlaced_observer_START + i];
    }
  }
  memory.p[state + triangular_interlaced_observer_STARTED] = 1.0;
  memory.p[state + triangular_interlaced_observer_T] = row.p[0];
  memory.p[state + triangular_interlaced_observer_MEASURED] = measured ? 1.0 : 0.0;
  for (int64_t j = 0; j < p; j++) {
    memory.p[state + triangular_interlaced_observer_Y + j] = measured ? row.p[1 + j] : 0.0;
  }
  triangular_program_execute(memory, (int64_t)memory.p[triangular_interlaced_observer_PROGRAM], (int64_t)memory.p[triangular_interlaced_observer_ROWS]);
  for (int64_t i = 0; i < q; i++) {
    out.p[i] = memory.p[w + i];
  }
  for (int64_t i = 0, end_1 = (int64_t)memory.p[triangular_interlaced_observer_ANSWERED]; i < end_1; i++) {
    out.p[q + i] = memory.p[(int64_t)memory.p[triangular_interlaced_observer_ANSWERS] + i];
  }
  return triangular_interlaced_observer_TAKEN;
}
