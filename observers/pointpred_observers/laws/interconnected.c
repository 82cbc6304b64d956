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
  int64_t q, k, m, p, n_at, l_at, j_at, k_at, r0_at, r1_at, r_at, r2_at, start_at, valued_at, v0_at, v1_at, v2_at, first_at, clock_at, both_at, total_at, stage_at, change_at, step_at, f_at, absent_at;
  interconnected_persidskii_law_Matrices matrices;
  interconnected_persidskii_law_State state;
  q = (int64_t)memory->states;
  k = (int64_t)memory->components;
  m = (int64_t)memory->inputs;
  p = (int64_t)memory->outputs;
  n_at = k;
  l_at = n_at + q * q;
  j_at = l_at + q * k;
  k_at = j_at + k * q;
  r0_at = k_at + q * m;
  r1_at = r0_at + p * q;
  r_at = r1_at + p * k;
  r2_at = r_at + k * m;
  start_at = r2_at + p * m;
  valued_at = start_at + q;
  v0_at = valued_at + m;
  v1_at = v0_at + m * q;
  v2_at = v1_at + m * k;
  first_at = v2_at + m * m;
  clock_at = first_at + m;
  both_at = clock_at + 2;
  total_at = both_at + q + m;
  stage_at = total_at + q + m;
  change_at = stage_at + q + m;
  step_at = change_at + q + m;
  f_at = step_at + q + m;
  absent_at = f_at + k;
  matrices = (interconnected_persidskii_law_Matrices){(Vector){(Vector){memory->rest, -1}.p, n_at}, (Table){(Vector){(Vector){memory->rest, -1}.p + n_at, l_at - n_at}.p, q, q}, (Table){(Vector){(Vector){memory->rest, -1}.p + l_at, j_at - l_at}.p, q, k}, (Table){(Vector){(Vector){memory->rest, -1}.p + j_at, k_at - j_at}.p, k, q}, (Table){(Vector){(Vector){memory->rest, -1}.p + k_at, r0_at - k_at}.p, q, m}, (Table){(Vector){(Vector){memory->rest, -1}.p + r0_at, r1_at - r0_at}.p, p, q}, (Table){(Vector){(Vector){memory->rest, -1}.p + r1_at, r_at - r1_at}.p, p, k}, (Table){(Vector){(Vector){memory->rest, -1}.p + r_at, r2_at - r_at}.p, k, m}, (Table){(Vector){(Vector){memory->rest, -1}.p + r2_at, start_at - r2_at}.p, p, m}, (Vector){(Vector){memory->rest, -1}.p + start_at, valued_at - start_at}, (Vector){(Vector){memory->rest, -1}.p + valued_at, v0_at - valued_at}, (Table){(Vector){(Vector){memory->rest, -1}.p + v0_at, v1_at - v0_at}.p, m, q}, (Table){(Vector){(Vector){memory->rest, -1}.p + v1_at, v2_at - v1_at}.p, m, k}, (Table){(Vector){(Vector){memory->rest, -1}.p + v2_at, first_at - v2_at}.p, m, m}, (Vector){(Vector){memory->rest, -1}.p + first_at, clock_at - first_at}};
  state = (interconnected_persidskii_law_State){(Vector){(Vector){memory->rest, -1}.p + clock_at, both_at - clock_at}, (Vector){(Vector){memory->rest, -1}.p + both_at, total_at - both_at}, (Vector){(Vector){memory->rest, -1}.p + total_at, stage_at - total_at}, (Vector){(Vector){memory->rest, -1}.p + stage_at, change_at - stage_at}, (Vector){(Vector){memory->rest, -1}.p + change_at, step_at - change_at}, (Vector){(Vector){memory->rest, -1}.p + step_at, f_at - step_at}, (Vector){(Vector){memory->rest, -1}.p + f_at, absent_at - f_at}, (Vector){(Vector){memory->rest, -1}.p + absent_at, absent_at + m - absent_at}};
  return (T_interconnected_persidskii_law_Matrices__interconnected_persidskii_law_State_){matrices, state};
}

/* A total and a row of a matrix times a vector. */
double interconnected_persidskii_law_along(double total, Vector row, Vector vector) {
  for (int64_t i = 0; i < vector.n; i++) {
    total += row.p[i] * vector.p[i];
  }
  return total;
}

/* f(Jw + R i). */
void interconnected_persidskii_law_bend(interconnected_persidskii_law_Matrices m, Vector w, Vector inputs, Vector to) {
  for (int64_t j = 0, end_1 = m.codes.n; j < end_1; j++) {
    to.p[j] = plants_nonlinearity_value(m.codes.p[j], interconnected_persidskii_law_along(interconnected_persidskii_law_along(0.0, (Vector){m.J.p + j * m.J.m, m.J.m}, w), (Vector){m.R.p + j * m.R.m, m.R.m}, inputs));
  }
}

/* N w + L f(Jw + R i) + K i, with f in ``nonlinear``. */
void interconnected_persidskii_law_slope(interconnected_persidskii_law_Matrices m, Vector w, Vector inputs, Vector nonlinear, Vector to) {
  interconnected_persidskii_law_bend(m, w, inputs, nonlinear);
  for (int64_t i = 0, end_1 = m.start.n; i < end_1; i++) {
    to.p[i] = interconnected_persidskii_law_along(interconnected_persidskii_law_along(interconnected_persidskii_law_along(0.0, (Vector){m.N.p + i * m.N.m, m.N.m}, w), (Vector){m.L.p + i * m.L.m, m.L.m}, nonlinear), (Vector){m.K.p + i * m.K.m, m.K.m}, inputs);
  }
}

/* Write the missing inputs that are values, V0 w + V1 f(Jw + R i), of which R reads V0 w only. */
void interconnected_persidskii_law_replace(interconnected_persidskii_law_Matrices m, Vector w, Vector inputs, Vector nonlinear, Vector absent) {
  for (int64_t j = 0; j < inputs.n; j++) {
    if (absent.p[j] == 1.0 && m.valued.p[j] == 1.0) {
      inputs.p[j] = interconnected_persidskii_law_along(0.0, (Vector){m.V0.p + j * m.V0.m, m.V0.m}, w);
    }
  }
  interconnected_persidskii_law_bend(m, w, inputs, nonlinear);
  for (int64_t j = 0; j < inputs.n; j++) {
    if (absent.p[j] == 1.0 && m.valued.p[j] == 1.0) {
      inputs.p[j] = interconnected_persidskii_law_along(inputs.p[j], (Vector){m.V1.p + j * m.V1.m, m.V1.m}, nonlinear);
    }
  }
}

/* V0 w + V1 f + V2 i: the rate of a missing input, in discrete time its next value. */
double interconnected_persidskii_law_onward(interconnected_persidskii_law_Matrices m, int64_t j, Vector w, Vector inputs, Vector nonlinear) {
  return interconnected_persidskii_law_along(interconnected_persidskii_law_along(interconnected_persidskii_law_along(0.0, (Vector){m.V0.p + j * m.V0.m, m.V0.m}, w), (Vector){m.V1.p + j * m.V1.m, m.V1.m}, nonlinear), (Vector){m.V2.p + j * m.V2.m, m.V2.m}, inputs);
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
        s.change.p[q + j] = interconnected_persidskii_law_onward(m, j, w, given, s.nonlinear);
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
      s.total.p[q + j] = missing ? interconnected_persidskii_law_onward(m, j, w, last, s.nonlinear) : 0.0;
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
  int64_t verdict, q;
  Vector w, last;
  double argument;
  T_interconnected_persidskii_law_Matrices__interconnected_persidskii_law_State_ values_1 = interconnected_persidskii_law_parts_of(memory);
  m = values_1.f0;
  s = values_1.f1;
  verdict = interconnected_persidskii_law_advance(memory, m, s, row);
  if (verdict >= interconnected_persidskii_law_BACKWARDS) {
    return verdict;
  }
  q = m.start.n;
  w = (Vector){s.both.p, q};
  last = (Vector){s.both.p + q, s.both.n - q};
  for (int64_t j = 0, end_2 = m.codes.n; j < end_2; j++) {
    argument = interconnected_persidskii_law_along_both(interconnected_persidskii_law_along(0.0, (Vector){m.R.p + j * m.R.m, m.R.m}, last), (Vector){m.J.p + j * m.J.m, m.J.m}, w, m.start);
    s.nonlinear.p[j] = plants_nonlinearity_value(m.codes.p[j], argument);
  }
  for (int64_t i = 0, end_3 = m.R0.n; i < end_3; i++) {
    out.p[i] = interconnected_persidskii_law_along(interconnected_persidskii_law_along(interconnected_persidskii_law_along_both(0.0, (Vector){m.R0.p + i * m.R0.m, m.R0.m}, w, m.start), (Vector){m.R1.p + i * m.R1.m, m.R1.m}, s.nonlinear), (Vector){m.R2.p + i * m.R2.m, m.R2.m}, last);
  }
  return verdict;
}
