/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const int64_t interconnected_persidskii_law_ACCEPTED = 0;
static const int64_t interconnected_persidskii_law_BACKWARDS = 2;
static const int64_t interconnected_persidskii_law_REPEATED = 1;
static const int64_t interconnected_persidskii_law_SKIPPED = 4;
static const int64_t interconnected_persidskii_law_STEPS_MOST = INT64_C(100000);
static const int64_t interconnected_persidskii_law_TOO_LONG = 3;

/* The matrices and the state in their places. */
T_interconnected_persidskii_law_Matrices__interconnected_persidskii_law_State_ interconnected_persidskii_law_parts_of(interconnected_persidskii_law_Memory * memory) {
  int64_t q, k, m, p, wide, change_at, shown_at, missing_at, start_at, valued_at, first_at, clock_at, both_at, total_at, stage_at, moved_at, step_at, f_at, absent_at;
  interconnected_persidskii_law_Matrices matrices;
  interconnected_persidskii_law_State state;
  q = (int64_t)memory->states;
  k = (int64_t)memory->components;
  m = (int64_t)memory->inputs;
  p = (int64_t)memory->outputs;
  wide = q + k + m;
  change_at = k + k * (q + m);
  shown_at = change_at + q * wide;
  missing_at = shown_at + p * wide;
  start_at = missing_at + m * wide;
  valued_at = start_at + q;
  first_at = valued_at + m;
  clock_at = first_at + m;
  both_at = clock_at + 2;
  total_at = both_at + q + m;
  stage_at = total_at + q + m;
  moved_at = stage_at + q + m;
  step_at = moved_at + q + m;
  f_at = step_at + q + m;
  absent_at = f_at + k;
  matrices = (interconnected_persidskii_law_Matrices){(Vector){(Vector){memory->rest, -1}.p, k}, (Table){(Vector){(Vector){memory->rest, -1}.p + k, change_at - k}.p, k, q + m}, (Table){(Vector){(Vector){memory->rest, -1}.p + change_at, shown_at - change_at}.p, q, wide}, (Table){(Vector){(Vector){memory->rest, -1}.p + shown_at, missing_at - shown_at}.p, p, wide}, (Table){(Vector){(Vector){memory->rest, -1}.p + missing_at, start_at - missing_at}.p, m, wide}, (Vector){(Vector){memory->rest, -1}.p + start_at, valued_at - start_at}, (Vector){(Vector){memory->rest, -1}.p + valued_at, first_at - valued_at}, (Vector){(Vector){memory->rest, -1}.p + first_at, clock_at - first_at}};
  state = (interconnected_persidskii_law_State){(Vector){(Vector){memory->rest, -1}.p + clock_at, both_at - clock_at}, (Vector){(Vector){memory->rest, -1}.p + both_at, total_at - both_at}, (Vector){(Vector){memory->rest, -1}.p + total_at, stage_at - total_at}, (Vector){(Vector){memory->rest, -1}.p + stage_at, moved_at - stage_at}, (Vector){(Vector){memory->rest, -1}.p + moved_at, step_at - moved_at}, (Vector){(Vector){memory->rest, -1}.p + step_at, f_at - step_at}, (Vector){(Vector){memory->rest, -1}.p + f_at, absent_at - f_at}, (Vector){(Vector){memory->rest, -1}.p + absent_at, absent_at + m - absent_at}};
  return (T_interconnected_persidskii_law_Matrices__interconnected_persidskii_law_State_){matrices, state};
}

/* A total and a row of a matrix times a vector. */
double interconnected_persidskii_law_along(double total, Vector row, Vector vector) {
  for (int64_t i = 0; i < vector.n; i++) {
    total += row.p[i] * vector.p[i];
  }
  return total;
}

/* A row of a matrix times (w, f, inputs). */
double interconnected_persidskii_law_along_all(Vector row, Vector w, Vector nonlinear, Vector inputs) {
  int64_t q, k;
  q = w.n;
  k = nonlinear.n;
  return interconnected_persidskii_law_along(interconnected_persidskii_law_along(interconnected_persidskii_law_along(0.0, (Vector){row.p, q}, w), (Vector){row.p + q, q + k - q}, nonlinear), (Vector){row.p + (q + k), row.n - (q + k)}, inputs);
}

/* f(Jw + R i). */
void interconnected_persidskii_law_bend(interconnected_persidskii_law_Matrices m, Vector w, Vector inputs, Vector to) {
  int64_t q;
  Vector row;
  q = w.n;
  for (int64_t j = 0, end_1 = m.codes.n; j < end_1; j++) {
    row = (Vector){m.inner.p + j * m.inner.m, m.inner.m};
    to.p[j] = plants_nonlinearity_value(m.codes.p[j], interconnected_persidskii_law_along(interconnected_persidskii_law_along(0.0, (Vector){row.p, q}, w), (Vector){row.p + q, row.n - q}, inputs));
  }
}

/* N w + L f(Jw + R i) + K i, with f in ``nonlinear``. */
void interconnected_persidskii_law_slope(interconnected_persidskii_law_Matrices m, Vector w, Vector inputs, Vector nonlinear, Vector to) {
  interconnected_persidskii_law_bend(m, w, inputs, nonlinear);
  for (int64_t i = 0, end_1 = m.start.n; i < end_1; i++) {
    to.p[i] = interconnected_persidskii_law_along_all((Vector){m.change.p + i * m.change.m, m.change.m}, w, nonlinear, inputs);
  }
}

/* Write the missing inputs that are values, V0 w + V1 f(Jw + R i), of which R reads V0 w only. */
void interconnected_persidskii_law_replace(interconnected_persidskii_law_Matrices m, Vector w, Vector inputs, Vector nonlinear, Vector absent) {
  int64_t q, k;
  Vector row;
  q = w.n;
  k = nonlinear.n;
  for (int64_t j = 0; j < inputs.n; j++) {
    if (absent.p[j] == 1.0 && m.valued.p[j] == 1.0) {
      row = (Vector){m.missing.p + j * m.missing.m, m.missing.m};
      inputs.p[j] = interconnected_persidskii_law_along(0.0, (Vector){row.p, q}, w);
    }
  }
  interconnected_persidskii_law_bend(m, w, inputs, nonlinear);
  for (int64_t j = 0; j < inputs.n; j++) {
    if (absent.p[j] == 1.0 && m.valued.p[j] == 1.0) {
      row = (Vector){m.missing.p + j * m.missing.m, m.missing.m};
      inputs.p[j] = interconnected_persidskii_law_along(inputs.p[j], (Vector){row.p + q, q + k - q}, nonlinear);
    }
  }
}

/* One step of the classical Runge-Kutta method, of ``h`` s, where ``length`` s are left until ``row``. */
void interconnected_persidskii_law_flow(interconnected_persidskii_law_Matrices m, interconnected_persidskii_law_State s, Vector row, double length, double h, bool missing) {
  int64_t q, size;
  Vector w, given;
  double weight, ahead;
  q = m.start.n;
  size = s.both.n;
  w = (Vector){s.stage.p, q};
  given = (Vector){s.stage.p + q, s.stage.n - q};
  for (int64_t i = 0; i < size; i++) {
    s.first.p[i] = s.both.p[i];
    s.stage.p[i] = s.both.p[i];
    s.total.p[i] = 0.0;
  }
  for (int64_t part = 0; part < 4; part++) {
    if (missing) {
      interconnected_persidskii_law_replace(m, w, given, s.nonlinear, s.absent);
    }
    interconnected_persidskii_law_slope(m, w, given, s.nonlinear, s.change);
    for (int64_t j = 0, end_1 = m.first.n; j < end_1; j++) {
      if (s.absent.p[j] == 0.0) {
        s.change.p[q + j] = (row.p[1 + j] - s.first.p[q + j]) / length;
      } else if (m.valued.p[j] == 1.0) {
        s.change.p[q + j] = 0.0;
      } else {
        s.change.p[q + j] = interconnected_persidskii_law_along_all((Vector){m.missing.p + j * m.missing.m, m.missing.m}, w, s.nonlinear, given);
      }
    }
    weight = part == 0 || part == 3 ? 1.0 : 2.0;
    ahead = part == 2 ? h : 0.5 * h;
    for (int64_t i = 0; i < size; i++) {
      s.total.p[i] += weight * s.change.p[i];
      s.stage.p[i] = s.first.p[i] + ahead * s.change.p[i];
    }
  }
  for (int64_t i = 0; i < size; i++) {
    s.both.p[i] = s.first.p[i] + h / 6.0 * s.total.p[i];
  }
}

/* Carry w, and missing inputs, from the last sample to ``row``. */
void interconnected_persidskii_law_move(interconnected_persidskii_law_Memory * memory, interconnected_persidskii_law_Matrices m, interconnected_persidskii_law_State s, Vector row, bool missing) {
  double h;
  int64_t q, count;
  Vector w, last;
  h = row.p[0] - s.clock.p[1];
  if (memory->discrete == 1.0) {
    q = m.start.n;
    w = (Vector){s.both.p, q};
    last = (Vector){s.both.p + q, s.both.n - q};
    interconnected_persidskii_law_slope(m, w, last, s.nonlinear, s.total);
    for (int64_t j = 0, end_1 = m.first.n; j < end_1; j++) {
      s.total.p[q + j] = missing ? interconnected_persidskii_law_along_all((Vector){m.missing.p + j * m.missing.m, m.missing.m}, w, s.nonlinear, last) : 0.0;
    }
    for (int64_t i = 0, end_2 = s.both.n; i < end_2; i++) {
      s.both.p[i] = s.total.p[i];
    }
    return;
  }
  count = max_whole(1, (int64_t)ceil(min_float(h / memory->step_s, interconnected_persidskii_law_STEPS_MOST)));
  for (int64_t i = 0; i < count; i++) {
    interconnected_persidskii_law_flow(m, s, row, h * (count - i) / count, h / count, missing);
  }
}

/* Take over the inputs that a sample has. */
void interconnected_persidskii_law_measure(interconnected_persidskii_law_State s, Vector last, Vector row) {
  for (int64_t j = 0; j < last.n; j++) {
    if (row.p[1 + j] == row.p[1 + j]) {
      last.p[j] = row.p[1 + j];
      s.absent.p[j] = 0.0;
    }
  }
}

/* Process the sample (t, inputs), NaN for a missing one; a repeated t replaces the inputs it has. */
int64_t interconnected_persidskii_law_advance(interconnected_persidskii_law_Memory * memory, interconnected_persidskii_law_Matrices m, interconnected_persidskii_law_State s, Vector row) {
  int64_t q, inputs;
  Vector w, last;
  bool started, discrete, missing, begin;
  double h;
  q = m.start.n;
  inputs = m.first.n;
  w = (Vector){s.both.p, q};
  last = (Vector){s.both.p + q, s.both.n - q};
  started = s.clock.p[0] == 1.0;
  discrete = memory->discrete == 1.0;
  h = row.p[0] - s.clock.p[1];
  if (started && h < 0.0) {
    return interconnected_persidskii_law_BACKWARDS;
  }
  if (started && h == 0.0) {
    interconnected_persidskii_law_measure(s, last, row);
    return interconnected_persidskii_law_REPEATED;
  }
  if (started && discrete && h != 1.0) {
    return interconnected_persidskii_law_SKIPPED;
  }
  missing = false;
  begin = !started || (!discrete && h > memory->gap_s);
  if (!begin && !discrete && h > memory->bridged_s) {
    return interconnected_persidskii_law_TOO_LONG;
  }
  for (int64_t j = 0; j < inputs; j++) {
    if (row.p[1 + j] != row.p[1 + j]) {
      s.absent.p[j] = 1.0;
    }
    if (s.absent.p[j] == 1.0) {
      missing = true;
    }
  }
  if (begin) {
    for (int64_t i = 0; i < q; i++) {
      w.p[i] = m.start.p[i];
    }
    for (int64_t j = 0; j < inputs; j++) {
      last.p[j] = m.first.p[j];
    }
  } else {
    for (int64_t i = 0; i < q; i++) {
      w.p[i] += m.start.p[i];
    }
    interconnected_persidskii_law_move(memory, m, s, row, missing);
  }
  interconnected_persidskii_law_measure(s, last, row);
  if (missing) {
    interconnected_persidskii_law_replace(m, w, last, s.nonlinear, s.absent);
  }
  for (int64_t i = 0; i < q; i++) {
    w.p[i] -= m.start.p[i];
  }
  s.clock.p[0] = 1.0;
  s.clock.p[1] = row.p[0];
  return interconnected_persidskii_law_ACCEPTED;
}

/* A total and a row of a matrix times the sum of two vectors. */
double interconnected_persidskii_law_along_both(double total, Vector row, Vector one, Vector other) {
  for (int64_t i = 0; i < one.n; i++) {
    total += row.p[i] * (one.p[i] + other.p[i]);
  }
  return total;
}

/* Integrate to the sample (t, inputs) and write R0 w + R1 f(Jw + R i) + R2 i to ``out``. */
int64_t interconnected_persidskii_law_step(interconnected_persidskii_law_Memory * memory, Vector row, Vector out) {
  interconnected_persidskii_law_Matrices m;
  interconnected_persidskii_law_State s;
  int64_t verdict, q, k;
  Vector w, last, inner, shown;
  double argument, linear;
  T_interconnected_persidskii_law_Matrices__interconnected_persidskii_law_State_ values_1 = interconnected_persidskii_law_parts_of(memory);
  m = values_1.f0;
  s = values_1.f1;
  verdict = interconnected_persidskii_law_advance(memory, m, s, row);
  if (verdict >= interconnected_persidskii_law_BACKWARDS) {
    return verdict;
  }
  q = m.start.n;
  k = m.codes.n;
  w = (Vector){s.both.p, q};
  last = (Vector){s.both.p + q, s.both.n - q};
  for (int64_t j = 0; j < k; j++) {
    inner = (Vector){m.inner.p + j * m.inner.m, m.inner.m};
    argument = interconnected_persidskii_law_along_both(interconnected_persidskii_law_along(0.0, (Vector){inner.p + q, inner.n - q}, last), (Vector){inner.p, q}, w, m.start);
    s.nonlinear.p[j] = plants_nonlinearity_value(m.codes.p[j], argument);
  }
  for (int64_t i = 0, end_2 = m.shown.n; i < end_2; i++) {
    shown = (Vector){m.shown.p + i * m.shown.m, m.shown.m};
    linear = interconnected_persidskii_law_along_both(0.0, (Vector){shown.p, q}, w, m.start);
    out.p[i] = interconnected_persidskii_law_along(interconnected_persidskii_law_along(linear, (Vector){shown.p + q, q + k - q}, s.nonlinear), (Vector){shown.p + (q + k), shown.n - (q + k)}, last);
  }
  return verdict;
}
