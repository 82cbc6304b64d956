/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const int64_t triangular_interlaced_observer_BACKWARDS = 1;
static const double triangular_interlaced_observer_NEGLIGIBLE = 1e-18;
static const int64_t triangular_interlaced_observer_ORDER = 14;
static const int64_t triangular_interlaced_observer_STEPS_MOST = 4096;
static const int64_t triangular_interlaced_observer_TAKEN = 0;
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
  return 10 + q + 2 * q * q + q * p;
}

/* Floats of the state, with two scratch vectors, before the program's registers. */
int64_t triangular_interlaced_observer_states(int64_t q, int64_t p) {
  return 3 + p + 3 * q;
}

/* The parts in their places. */
triangular_interlaced_observer_Parts triangular_interlaced_observer_parts_of(Vector memory) {
  triangular_interlaced_observer_Head * head;
  int64_t q, p, rows, a_at, closed_at, l_at, y_at, w_at, program_at, answers_at;
  head = (triangular_interlaced_observer_Head *)(memory.p);
  q = (int64_t)head->states;
  p = (int64_t)head->outputs;
  rows = (int64_t)head->rows;
  a_at = 10 + q;
  closed_at = a_at + q * q;
  l_at = closed_at + q * q;
  y_at = (int64_t)head->state + 3;
  w_at = y_at + p;
  program_at = (int64_t)head->program;
  answers_at = (int64_t)head->answers;
  return (triangular_interlaced_observer_Parts){(Vector){memory.p + 10, a_at - 10}, (Table){(Vector){memory.p + a_at, closed_at - a_at}.p, q, q}, (Table){(Vector){memory.p + closed_at, l_at - closed_at}.p, q, q}, (Table){(Vector){memory.p + l_at, l_at + q * p - l_at}.p, q, p}, (Vector){memory.p + y_at, w_at - y_at}, (Vector){memory.p + w_at, w_at + q - w_at}, (Vector){memory.p + (w_at + q), w_at + 2 * q - (w_at + q)}, (Vector){memory.p + (w_at + 2 * q), w_at + 3 * q - (w_at + 2 * q)}, (Table){(Vector){memory.p + program_at, program_at + triangular_program_ROW * rows - program_at}.p, rows, triangular_program_ROW}, (Vector){memory.p + answers_at, answers_at + (int64_t)head->answered - answers_at}};
}

/* The part of L y in row i of the first two derivatives, y linear between the two samples. */
double triangular_interlaced_observer_drive(triangular_interlaced_observer_Parts parts, int64_t i, int64_t k, double passed, double share, Vector row) {
  double total, rise;
  total = 0.0;
  for (int64_t j = 0, end_1 = parts.y.n; j < end_1; j++) {
    rise = row.p[1 + j] - parts.y.p[j];
    total += parts.L.p[i * parts.L.m + j] * (k == 1 ? parts.y.p[j] + passed * rise : share * rise);
  }
  return total;
}

/* Follow w' = (A - L C) w + L y over ``h`` s by the exponential series, w' = A w unless ``driven``. */
void triangular_interlaced_observer_follow(triangular_interlaced_observer_Parts parts, double h, int64_t steps, Vector row, bool driven) {
  int64_t q;
  Table matrix;
  Vector source;
  double total, moved, most;
  q = parts.w.n;
  matrix = driven ? parts.closed : parts.A;
  for (int64_t n = 0; n < steps; n++) {
    for (int64_t k = 1; k < (triangular_interlaced_observer_ORDER + 1); k++) {
      source = k == 1 ? parts.w : parts.term;
      for (int64_t i = 0; i < q; i++) {
        total = driven && k <= 2 ? triangular_interlaced_observer_drive(parts, i, k, (double)n / steps, 1.0 / steps, row) : 0.0;
        for (int64_t j = 0; j < q; j++) {
          total += matrix.p[i * matrix.m + j] * source.p[j];
        }
        parts.after.p[i] = total * h / (steps * k);
      }
      moved = 0.0;
      most = 0.0;
      for (int64_t i = 0; i < q; i++) {
        parts.term.p[i] = parts.after.p[i];
        parts.w.p[i] += parts.after.p[i];
        moved = max_float(moved, fabs(parts.after.p[i]));
        most = max_float(most, fabs(parts.w.p[i]));
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

/* Execute the rows of a program, whose registers are places in the memory. */
void triangular_program_execute(Vector memory, Table rows) {
  int64_t target, left, right;
  for (int64_t i = 0; i < rows.n; i++) {
    target = (int64_t)rows.p[i * rows.m + 1];
    left = (int64_t)rows.p[i * rows.m + 2];
    right = (int64_t)rows.p[i * rows.m + 3];
    memory.p[target] = triangular_program_apply((int64_t)rows.p[i * rows.m + 0], memory.p[left], memory.p[right]);
  }
}

/* Process t and the outputs (NaN: not measured) into ``out``; an earlier t changes nothing. */
int64_t triangular_interlaced_observer_step(Vector memory, Vector row, Vector out) {
  triangular_interlaced_observer_Head * head;
  triangular_interlaced_observer_Parts parts;
  triangular_interlaced_observer_State * s;
  double h, steps;
  bool started, measured, driven;
  int64_t q;
  head = (triangular_interlaced_observer_Head *)(memory.p);
  parts = triangular_interlaced_observer_parts_of(memory);
  s = (triangular_interlaced_observer_State *)(memory.p + (int64_t)head->state);
  h = row.p[0] - s->t;
  started = s->started == 1.0;
  if (started && h < 0.0) {
    return triangular_interlaced_observer_BACKWARDS;
  }
  measured = true;
  for (int64_t j = 0, end_1 = parts.y.n; j < end_1; j++) {
    if (row.p[1 + j] != row.p[1 + j]) {
      measured = false;
    }
  }
  driven = measured && s->measured == 1.0 && h <= head->gap_s;
  steps = max_float(1.0, (int64_t)ceil(2.0 * h * (driven ? head->fast : head->slow)));
  if (started && steps <= triangular_interlaced_observer_STEPS_MOST) {
    triangular_interlaced_observer_follow(parts, h, (int64_t)steps, row, driven);
  } else {
    for (int64_t i = 0, end_2 = parts.w.n; i < end_2; i++) {
      parts.w.p[i] = parts.start.p[i];
    }
  }
  s->started = 1.0;
  s->t = row.p[0];
  s->measured = measured ? 1.0 : 0.0;
  for (int64_t j = 0, end_3 = parts.y.n; j < end_3; j++) {
    parts.y.p[j] = measured ? row.p[1 + j] : 0.0;
  }
  triangular_program_execute(memory, parts.program);
  q = parts.w.n;
  for (int64_t i = 0; i < q; i++) {
    out.p[i] = parts.w.p[i];
  }
  for (int64_t i = 0, end_4 = parts.answers.n; i < end_4; i++) {
    out.p[q + i] = parts.answers.p[i];
  }
  return triangular_interlaced_observer_TAKEN;
}
