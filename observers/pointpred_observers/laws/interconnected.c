/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const int64_t interconnected_persidskii_law_ACCEPTED = 0;
static const int64_t interconnected_persidskii_law_BACKWARDS = 2;
static const int64_t interconnected_persidskii_law_BRIDGED = 7;
static const int64_t interconnected_persidskii_law_CODES = 8;
static const int64_t interconnected_persidskii_law_COMPONENTS = 1;
static const int64_t interconnected_persidskii_law_DISCRETE = 4;
static const int64_t interconnected_persidskii_law_GAP = 6;
static const int64_t interconnected_persidskii_law_INPUTS = 2;
static const int64_t interconnected_persidskii_law_OUTPUTS = 3;
static const int64_t interconnected_persidskii_law_REPEATED = 1;
static const int64_t interconnected_persidskii_law_SKIPPED = 4;
static const int64_t interconnected_persidskii_law_STATES = 0;
static const int64_t interconnected_persidskii_law_STEP = 5;
static const int64_t interconnected_persidskii_law_STEPS_MOST = 100000;
static const int64_t interconnected_persidskii_law_TOO_LONG = 3;

/* Offset of R, through which inputs enter the nonlinearity; R2 follows it. */
int64_t interconnected_persidskii_law_injected_at(int64_t q, int64_t k, int64_t inputs, int64_t outputs) {
  return interconnected_persidskii_law_CODES + k + q * q + 2 * q * k + q * inputs + outputs * (q + k);
}

/* Offset of the start. */
int64_t interconnected_persidskii_law_start_at(int64_t q, int64_t k, int64_t inputs, int64_t outputs) {
  return interconnected_persidskii_law_injected_at(q, k, inputs, outputs) + (k + outputs) * inputs;
}

/* Offset of what replaces missing inputs. */
int64_t interconnected_persidskii_law_replaced_at(int64_t q, int64_t k, int64_t inputs, int64_t outputs) {
  return interconnected_persidskii_law_start_at(q, k, inputs, outputs) + q;
}

/* Offset of the state. */
int64_t interconnected_persidskii_law_state_at(int64_t q, int64_t k, int64_t inputs, int64_t outputs) {
  return interconnected_persidskii_law_replaced_at(q, k, inputs, outputs) + inputs * (2 + q + k + inputs);
}

/* Number of floats of scratch space. */
int64_t interconnected_persidskii_law_room(int64_t q, int64_t k, int64_t inputs) {
  return 4 * (q + inputs) + k;
}

/* Number of floats of the state. */
int64_t interconnected_persidskii_law_floats(int64_t q, int64_t k, int64_t inputs) {
  return 2 + q + inputs + interconnected_persidskii_law_room(q, k, inputs) + inputs;
}

/* N w + L f(Jw + R i) + K i, read at three offsets of the memory and written at a fourth. */
void interconnected_persidskii_law_slope(Vector memory, int64_t w, int64_t inputs, int64_t nonlinear, int64_t to) {
  int64_t q, k, m, n_at, l_at, j_at, k_at, r_at;
  double s, change;
  q = (int64_t)memory.p[interconnected_persidskii_law_STATES];
  k = (int64_t)memory.p[interconnected_persidskii_law_COMPONENTS];
  m = (int64_t)memory.p[interconnected_persidskii_law_INPUTS];
  n_at = interconnected_persidskii_law_CODES + k;
  l_at = n_at + q * q;
  j_at = l_at + q * k;
  k_at = j_at + q * k;
  r_at = interconnected_persidskii_law_injected_at(q, k, m, (int64_t)memory.p[interconnected_persidskii_law_OUTPUTS]);
  for (int64_t j = 0; j < k; j++) {
    s = 0.0;
    for (int64_t i = 0; i < q; i++) {
      s += memory.p[j_at + j * q + i] * memory.p[w + i];
    }
    for (int64_t i = 0; i < m; i++) {
      s += memory.p[r_at + j * m + i] * memory.p[inputs + i];
    }
    memory.p[nonlinear + j] = nonlinearity_value(memory.p[interconnected_persidskii_law_CODES + j], s);
  }
  for (int64_t i = 0; i < q; i++) {
    change = 0.0;
    for (int64_t j = 0; j < q; j++) {
      change += memory.p[n_at + i * q + j] * memory.p[w + j];
    }
    for (int64_t j = 0; j < k; j++) {
      change += memory.p[l_at + i * k + j] * memory.p[nonlinear + j];
    }
    for (int64_t j = 0; j < m; j++) {
      change += memory.p[k_at + i * m + j] * memory.p[inputs + j];
    }
    memory.p[to + i] = change;
  }
}

/* One step of the classical Runge-Kutta method at w, with inputs linear between the last ones and row. */
void interconnected_persidskii_law_flow(Vector memory, int64_t w, Vector row, double begin, double h) {
  int64_t q, k, m, last, room, total, stage, change, first, nonlinear, inputs;
  double length, value, at, weight, ahead;
  q = (int64_t)memory.p[interconnected_persidskii_law_STATES];
  k = (int64_t)memory.p[interconnected_persidskii_law_COMPONENTS];
  m = (int64_t)memory.p[interconnected_persidskii_law_INPUTS];
  last = w + q;
  room = w + q + m;
  total = room;
  stage = room + q;
  change = room + 2 * q;
  first = room + 3 * q;
  nonlinear = room + 4 * q;
  inputs = room + 4 * q + k;
  length = h * (row.p[0] - memory.p[w - 1]);
  for (int64_t i = 0; i < q; i++) {
    value = memory.p[w + i];
    memory.p[first + i] = value;
    memory.p[stage + i] = value;
    memory.p[total + i] = 0.0;
  }
  for (int64_t part = 0; part < 4; part++) {
    at = begin + (part == 0 ? 0.0 : part == 3 ? h : 0.5 * h);
    for (int64_t j = 0; j < m; j++) {
      memory.p[inputs + j] = memory.p[last + j] + at * (row.p[1 + j] - memory.p[last + j]);
    }
    interconnected_persidskii_law_slope(memory, stage, inputs, nonlinear, change);
    weight = part == 0 || part == 3 ? 1.0 : 2.0;
    ahead = part == 2 ? length : 0.5 * length;
    for (int64_t i = 0; i < q; i++) {
      memory.p[total + i] += weight * memory.p[change + i];
      memory.p[stage + i] = memory.p[first + i] + ahead * memory.p[change + i];
    }
  }
  for (int64_t i = 0; i < q; i++) {
    memory.p[w + i] = memory.p[first + i] + length / 6.0 * memory.p[total + i];
  }
}

/* Write the missing inputs that are values, V0 w + V1 f(Jw + R i), of which R reads V0 w only. */
void interconnected_persidskii_law_replace(Vector memory, int64_t w, int64_t inputs, int64_t nonlinear, int64_t absent) {
  int64_t q, k, m, valued, j_at, r_at, v0, v1;
  double value, s;
  q = (int64_t)memory.p[interconnected_persidskii_law_STATES];
  k = (int64_t)memory.p[interconnected_persidskii_law_COMPONENTS];
  m = (int64_t)memory.p[interconnected_persidskii_law_INPUTS];
  valued = interconnected_persidskii_law_replaced_at(q, k, m, (int64_t)memory.p[interconnected_persidskii_law_OUTPUTS]);
  j_at = interconnected_persidskii_law_CODES + k + q * q + q * k;
  r_at = interconnected_persidskii_law_injected_at(q, k, m, (int64_t)memory.p[interconnected_persidskii_law_OUTPUTS]);
  v0 = valued + m;
  v1 = valued + m + m * q;
  for (int64_t j = 0; j < m; j++) {
    if (memory.p[absent + j] == 1.0 && memory.p[valued + j] == 1.0) {
      value = 0.0;
      for (int64_t i = 0; i < q; i++) {
        value += memory.p[v0 + j * q + i] * memory.p[w + i];
      }
      memory.p[inputs + j] = value;
    }
  }
  for (int64_t j = 0; j < k; j++) {
    s = 0.0;
    for (int64_t i = 0; i < q; i++) {
      s += memory.p[j_at + j * q + i] * memory.p[w + i];
    }
    for (int64_t i = 0; i < m; i++) {
      s += memory.p[r_at + j * m + i] * memory.p[inputs + i];
    }
    memory.p[nonlinear + j] = nonlinearity_value(memory.p[interconnected_persidskii_law_CODES + j], s);
  }
  for (int64_t j = 0; j < m; j++) {
    if (memory.p[absent + j] == 1.0 && memory.p[valued + j] == 1.0) {
      for (int64_t i = 0; i < k; i++) {
        memory.p[inputs + j] += memory.p[v1 + j * k + i] * memory.p[nonlinear + i];
      }
    }
  }
}

/* V0 w + V1 f + V2 i: the rate of a missing input, in discrete time its next value. */
double interconnected_persidskii_law_onward(Vector memory, int64_t j, int64_t w, int64_t inputs, int64_t nonlinear) {
  int64_t q, k, m, v0, v1, v2;
  double total;
  q = (int64_t)memory.p[interconnected_persidskii_law_STATES];
  k = (int64_t)memory.p[interconnected_persidskii_law_COMPONENTS];
  m = (int64_t)memory.p[interconnected_persidskii_law_INPUTS];
  v0 = interconnected_persidskii_law_replaced_at(q, k, m, (int64_t)memory.p[interconnected_persidskii_law_OUTPUTS]) + m;
  v1 = v0 + m * q;
  v2 = v0 + m * (q + k);
  total = 0.0;
  for (int64_t i = 0; i < q; i++) {
    total += memory.p[v0 + j * q + i] * memory.p[w + i];
  }
  for (int64_t i = 0; i < k; i++) {
    total += memory.p[v1 + j * k + i] * memory.p[nonlinear + i];
  }
  for (int64_t i = 0; i < m; i++) {
    total += memory.p[v2 + j * m + i] * memory.p[inputs + i];
  }
  return total;
}

/* A step of ``flow`` for inputs of which some are missing: these follow what replaces them. */
void interconnected_persidskii_law_bridge(Vector memory, int64_t w, Vector row, double length, double h, int64_t absent) {
  int64_t q, k, m, valued, size, total, stage, change, first, nonlinear;
  double weight, ahead;
  q = (int64_t)memory.p[interconnected_persidskii_law_STATES];
  k = (int64_t)memory.p[interconnected_persidskii_law_COMPONENTS];
  m = (int64_t)memory.p[interconnected_persidskii_law_INPUTS];
  valued = interconnected_persidskii_law_replaced_at(q, k, m, (int64_t)memory.p[interconnected_persidskii_law_OUTPUTS]);
  size = q + m;
  total = w + size;
  stage = total + size;
  change = total + 2 * size;
  first = total + 3 * size;
  nonlinear = total + 4 * size;
  for (int64_t i = 0; i < size; i++) {
    memory.p[first + i] = memory.p[w + i];
    memory.p[stage + i] = memory.p[w + i];
    memory.p[total + i] = 0.0;
  }
  for (int64_t part = 0; part < 4; part++) {
    interconnected_persidskii_law_replace(memory, stage, stage + q, nonlinear, absent);
    interconnected_persidskii_law_slope(memory, stage, stage + q, nonlinear, change);
    for (int64_t j = 0; j < m; j++) {
      if (memory.p[absent + j] == 0.0) {
        memory.p[change + q + j] = (row.p[1 + j] - memory.p[first + q + j]) / length;
      } else if (memory.p[valued + j] == 1.0) {
        memory.p[change + q + j] = 0.0;
      } else {
        memory.p[change + q + j] = interconnected_persidskii_law_onward(memory, j, stage, stage + q, nonlinear);
      }
    }
    weight = part == 0 || part == 3 ? 1.0 : 2.0;
    ahead = part == 2 ? h : 0.5 * h;
    for (int64_t i = 0; i < size; i++) {
      memory.p[total + i] += weight * memory.p[change + i];
      memory.p[stage + i] = memory.p[first + i] + ahead * memory.p[change + i];
    }
  }
  for (int64_t i = 0; i < size; i++) {
    memory.p[w + i] = memory.p[first + i] + h / 6.0 * memory.p[total + i];
  }
}

/* Carry w, and missing inputs, from the last sample to ``row``. */
void interconnected_persidskii_law_move(Vector memory, Vector row, int64_t w, int64_t absent, bool missing) {
  int64_t q, k, m, last, space, nonlinear, following, count;
  double h;
  q = (int64_t)memory.p[interconnected_persidskii_law_STATES];
  k = (int64_t)memory.p[interconnected_persidskii_law_COMPONENTS];
  m = (int64_t)memory.p[interconnected_persidskii_law_INPUTS];
  last = w + q;
  space = w + q + m;
  h = row.p[0] - memory.p[w - 1];
  if (memory.p[interconnected_persidskii_law_DISCRETE] == 1.0) {
    nonlinear = space + 4 * q;
    following = space + 4 * q + k;
    interconnected_persidskii_law_slope(memory, w, last, nonlinear, space);
    for (int64_t j = 0; j < m; j++) {
      memory.p[following + j] = missing ? interconnected_persidskii_law_onward(memory, j, w, last, nonlinear) : 0.0;
    }
    for (int64_t i = 0; i < q; i++) {
      memory.p[w + i] = memory.p[space + i];
    }
    for (int64_t j = 0; j < m; j++) {
      memory.p[last + j] = memory.p[following + j];
    }
    return;
  }
  count = max_whole(1, (int64_t)ceil(min_float(h / memory.p[interconnected_persidskii_law_STEP], interconnected_persidskii_law_STEPS_MOST)));
  for (int64_t i = 0; i < count; i++) {
    if (missing) {
      interconnected_persidskii_law_bridge(memory, w, row, h * (count - i) / count, h / count, absent);
    } else {
      interconnected_persidskii_law_flow(memory, w, row, (double)i / count, 1.0 / count);
    }
  }
}

/* Process the sample (t, inputs), NaN for a missing one; a repeated t replaces the inputs it has. */
int64_t interconnected_persidskii_law_advance(Vector memory, Vector row) {
  int64_t q, k, m, outputs, start, started, t, w, last, space, absent, first;
  double h;
  bool missing, begin;
  q = (int64_t)memory.p[interconnected_persidskii_law_STATES];
  k = (int64_t)memory.p[interconnected_persidskii_law_COMPONENTS];
  m = (int64_t)memory.p[interconnected_persidskii_law_INPUTS];
  outputs = (int64_t)memory.p[interconnected_persidskii_law_OUTPUTS];
  start = interconnected_persidskii_law_start_at(q, k, m, outputs);
  started = interconnected_persidskii_law_state_at(q, k, m, outputs);
  t = started + 1;
  w = started + 2;
  last = w + q;
  space = w + q + m;
  absent = space + interconnected_persidskii_law_room(q, k, m);
  h = row.p[0] - memory.p[t];
  if (memory.p[started] == 1.0 && h < 0.0) {
    return interconnected_persidskii_law_BACKWARDS;
  }
  if (memory.p[started] == 1.0 && h == 0.0) {
    for (int64_t j = 0; j < m; j++) {
      if (row.p[1 + j] == row.p[1 + j]) {
        memory.p[last + j] = row.p[1 + j];
        memory.p[absent + j] = 0.0;
      }
    }
    return interconnected_persidskii_law_REPEATED;
  }
  if (memory.p[started] == 1.0 && memory.p[interconnected_persidskii_law_DISCRETE] == 1.0 && h != 1.0) {
    return interconnected_persidskii_law_SKIPPED;
  }
  missing = false;
  begin = memory.p[started] == 0.0 || (memory.p[interconnected_persidskii_law_DISCRETE] == 0.0 && h > memory.p[interconnected_persidskii_law_GAP]);
  if (!begin && memory.p[interconnected_persidskii_law_DISCRETE] == 0.0 && h > memory.p[interconnected_persidskii_law_BRIDGED]) {
    return interconnected_persidskii_law_TOO_LONG;
  }
  for (int64_t j = 0; j < m; j++) {
    if (row.p[1 + j] != row.p[1 + j]) {
      memory.p[absent + j] = 1.0;
    }
    if (memory.p[absent + j] == 1.0) {
      missing = true;
    }
  }
  if (begin) {
    for (int64_t i = 0; i < q; i++) {
      memory.p[w + i] = memory.p[start + i];
    }
    first = interconnected_persidskii_law_replaced_at(q, k, m, outputs) + m * (1 + q + k + m);
    for (int64_t j = 0; j < m; j++) {
      memory.p[last + j] = memory.p[first + j];
    }
  } else {
    for (int64_t i = 0; i < q; i++) {
      memory.p[w + i] += memory.p[start + i];
    }
    interconnected_persidskii_law_move(memory, row, w, absent, missing);
  }
  if (missing) {
    for (int64_t j = 0; j < m; j++) {
      if (row.p[1 + j] == row.p[1 + j]) {
        memory.p[last + j] = row.p[1 + j];
        memory.p[absent + j] = 0.0;
      }
    }
    interconnected_persidskii_law_replace(memory, w, last, space + 4 * q, absent);
  } else {
    for (int64_t j = 0; j < m; j++) {
      memory.p[last + j] = row.p[1 + j];
    }
  }
  for (int64_t i = 0; i < q; i++) {
    memory.p[w + i] -= memory.p[start + i];
  }
  memory.p[started] = 1.0;
  memory.p[t] = row.p[0];
  return interconnected_persidskii_law_ACCEPTED;
}

/* R0 w + R1 f(Jw + R i) + R2 i. */
void interconnected_persidskii_law_read(Vector memory, Vector out) {
  int64_t q, k, m, p, start, j_at, r0_at, r1_at, r_at, r2_at, w, last, nonlinear;
  double s, value;
  q = (int64_t)memory.p[interconnected_persidskii_law_STATES];
  k = (int64_t)memory.p[interconnected_persidskii_law_COMPONENTS];
  m = (int64_t)memory.p[interconnected_persidskii_law_INPUTS];
  p = (int64_t)memory.p[interconnected_persidskii_law_OUTPUTS];
  start = interconnected_persidskii_law_start_at(q, k, m, p);
  j_at = interconnected_persidskii_law_CODES + k + q * q + q * k;
  r0_at = j_at + q * k + q * m;
  r1_at = r0_at + p * q;
  r_at = interconnected_persidskii_law_injected_at(q, k, m, p);
  r2_at = r_at + k * m;
  w = interconnected_persidskii_law_state_at(q, k, m, p) + 2;
  last = w + q;
  nonlinear = w + q + m + 4 * q;
  for (int64_t j = 0; j < k; j++) {
    s = 0.0;
    for (int64_t i = 0; i < m; i++) {
      s += memory.p[r_at + j * m + i] * memory.p[last + i];
    }
    for (int64_t i = 0; i < q; i++) {
      s += memory.p[j_at + j * q + i] * (memory.p[w + i] + memory.p[start + i]);
    }
    memory.p[nonlinear + j] = nonlinearity_value(memory.p[interconnected_persidskii_law_CODES + j], s);
  }
  for (int64_t row = 0; row < p; row++) {
    value = 0.0;
    for (int64_t i = 0; i < q; i++) {
      value += memory.p[r0_at + row * q + i] * (memory.p[w + i] + memory.p[start + i]);
    }
    for (int64_t j = 0; j < k; j++) {
      value += memory.p[r1_at + row * k + j] * memory.p[nonlinear + j];
    }
    for (int64_t j = 0; j < m; j++) {
      value += memory.p[r2_at + row * m + j] * memory.p[last + j];
    }
    out.p[row] = value;
  }
}

/* Integrate to the sample (t, inputs) and return the outputs; a t that is refused changes nothing. */
int64_t interconnected_persidskii_law_step(Vector memory, Vector row, Vector out) {
  int64_t verdict;
  verdict = interconnected_persidskii_law_advance(memory, row);
  if (verdict < interconnected_persidskii_law_BACKWARDS) {
    interconnected_persidskii_law_read(memory, out);
  }
  return verdict;
}
