/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const int64_t simulation_loop_BISECTIONS = 40;
static const double simulation_loop_LONGEST_M = 2.0;
static const double simulation_loop_NEAR_SHARE = 0.85;
static const int64_t simulation_loop_QUADRATURE = 16;
static const double simulation_loop_SLOW_M_S = 0.008;
static const double simulation_loop_WANDER_S = 0.03;
static const double simulation_loop_WORTHWHILE_PX = 10.0;
static const int64_t simulation_slots_AIM_X = 24;
static const int64_t simulation_slots_AIM_Y = 25;
static const int64_t simulation_slots_AMPLITUDE = 59;
static const int64_t simulation_slots_ANGLE = 60;
static const int64_t simulation_slots_AX = 66;
static const int64_t simulation_slots_AY = 67;
static const int64_t simulation_slots_B1 = 14;
static const int64_t simulation_slots_B2 = 15;
static const double simulation_slots_BALLISTIC = 1.0;
static const int64_t simulation_slots_CARRY = 74;
static const double simulation_slots_CORRECTIVE = 2.0;
static const int64_t simulation_slots_COUNTED_X = 72;
static const int64_t simulation_slots_COUNTED_Y = 73;
static const int64_t simulation_slots_CURVE = 4;
static const int64_t simulation_slots_DELAY_S = 18;
static const double simulation_slots_DONE = 5.0;
static const int64_t simulation_slots_DURATION_S = 1;
static const int64_t simulation_slots_FEEDBACK = 61;
static const int64_t simulation_slots_FUNCTION = 6;
static const int64_t simulation_slots_METRES_PER_COUNT = 3;
static const int64_t simulation_slots_MUSCLE_S = 17;
static const int64_t simulation_slots_NOISE = 19;
static const int64_t simulation_slots_NUMBER = 58;
static const int64_t simulation_slots_PATIENCE_S = 29;
static const int64_t simulation_slots_PERIOD_S = 0;
static const int64_t simulation_slots_PHASE = 56;
static const int64_t simulation_slots_PIECE = 31;
static const int64_t simulation_slots_PIECES = 30;
static const int64_t simulation_slots_PIECE_SLOTS = 6;
static const double simulation_slots_PRESSING = 4.0;
static const int64_t simulation_slots_PRESS_S = 28;
static const int64_t simulation_slots_PULLED = 76;
static const int64_t simulation_slots_PX_PER_METRE = 2;
static const int64_t simulation_slots_RADIUS = 23;
static const int64_t simulation_slots_RATE = 16;
static const int64_t simulation_slots_REACTION_S = 26;
static const int64_t simulation_slots_RHO = 4;
static const int64_t simulation_slots_RING = 78;
static const int64_t simulation_slots_RING_ROWS = 256;
static const int64_t simulation_slots_RING_SLOTS = 4;
static const int64_t simulation_slots_SHARE = 0;
static const int64_t simulation_slots_SINCE = 57;
static const int64_t simulation_slots_SKEW = 2;
static const int64_t simulation_slots_STRENGTH = 5;
static const int64_t simulation_slots_SUBSTEPS = 1;
static const int64_t simulation_slots_TARGET_X = 21;
static const int64_t simulation_slots_TARGET_Y = 22;
static const int64_t simulation_slots_TICK = 55;
static const int64_t simulation_slots_TREMOR = 20;
static const int64_t simulation_slots_TURN = 3;
static const int64_t simulation_slots_U = 62;
static const int64_t simulation_slots_UNTIL = 5;
static const int64_t simulation_slots_V = 63;
static const double simulation_slots_VERIFYING = 3.0;
static const int64_t simulation_slots_VERIFY_S = 27;
static const int64_t simulation_slots_VX = 64;
static const int64_t simulation_slots_VY = 65;
static const double simulation_slots_WAITING = 0.0;
static const int64_t simulation_slots_WANDER_X = 68;
static const int64_t simulation_slots_WANDER_Y = 69;
static const int64_t simulation_slots_X = 70;
static const int64_t simulation_slots_Y = 71;

/* Share of the way at share u of the time, and its first two derivatives. */
T3d simulation_loop_profile(double u, double skew) {
  double s, rate, speed;
  if (u < 0.0) {
    return (T3d){0.0, 0.0, 0.0};
  }
  if (u > 1.0) {
    return (T3d){1.0, 0.0, 0.0};
  }
  s = 3.141592653589793 * (u + skew * u * (1.0 - u));
  rate = 3.141592653589793 * (1.0 + skew * (1.0 - 2.0 * u));
  speed = 0.5 * sin(s) * rate;
  return (T3d){0.5 * (1.0 - cos(s)), speed, 0.5 * (cos(s) * rate * rate - 2.0 * 3.141592653589793 * skew * sin(s))};
}

/* The cursor's distance (px) while the hand moves ``amplitude`` metres by the law without skew. */
double simulation_loop_cursor_distance(Vector memory, double amplitude, double duration) {
  double peak, total, weight;
  peak = 0.5 * 3.141592653589793 * amplitude / duration;
  total = 0.0;
  for (int64_t i = 1; i < simulation_loop_QUADRATURE; i++) {
    weight = remainder_whole(i, 2) == 1 ? 4.0 : 2.0;
    total += weight * transfer_functions_cursor_speed(memory, simulation_slots_FUNCTION, peak * sin(3.141592653589793 * i / simulation_loop_QUADRATURE));
  }
  return memory.p[simulation_slots_PX_PER_METRE] * duration * total / (3.0 * simulation_loop_QUADRATURE);
}

/* The amplitude (m) that moves the cursor by ``distance_px``: ``cursor_distance`` inverted. */
double simulation_loop_hand_distance(Vector memory, double distance_px, double duration) {
  double low, high, middle;
  low = 0.0;
  high = simulation_loop_LONGEST_M;
  for (int64_t i_1 = 0; i_1 < simulation_loop_BISECTIONS; i_1++) {
    middle = 0.5 * (low + high);
    if (simulation_loop_cursor_distance(memory, middle, duration) < distance_px) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return 0.5 * (low + high);
}

/* The open-loop force of the current piece: planned acceleration with friction compensated. */
T2d simulation_loop_ballistic_force(Vector memory, double t) {
  int64_t piece;
  double duration, curve, share, rate, bend, speed, along, across, angle;
  piece = simulation_slots_PIECE + simulation_slots_PIECE_SLOTS * (int64_t)memory.p[simulation_slots_NUMBER];
  duration = memory.p[piece + simulation_slots_DURATION_S];
  curve = memory.p[piece + simulation_slots_CURVE];
  T3d values_1 = simulation_loop_profile((t - memory.p[simulation_slots_SINCE]) / duration, memory.p[piece + simulation_slots_SKEW]);
  share = values_1.f0;
  rate = values_1.f1;
  bend = values_1.f2;
  speed = memory.p[simulation_slots_AMPLITUDE] * rate / duration;
  along = memory.p[simulation_slots_AMPLITUDE] * bend / square(duration) + memory.p[simulation_slots_B1] * speed;
  across = -2.0 * curve * (rate / duration) * speed;
  angle = memory.p[simulation_slots_ANGLE] + curve * (1.0 - 2.0 * share);
  return (T2d){along * cos(angle) - across * sin(angle), along * sin(angle) + across * cos(angle)};
}

/* The person's estimate of the cursor: its delayed sight, plus the hand's motion since. */
T2d simulation_loop_cursor_in_mind(Vector memory, double u, double v, double speed) {
  int64_t late, row;
  double gain;
  late = (int64_t)(memory.p[simulation_slots_DELAY_S] / memory.p[simulation_slots_PERIOD_S] + 0.5);
  row = simulation_slots_RING + simulation_slots_RING_SLOTS * remainder_whole((int64_t)memory.p[simulation_slots_TICK] - late, simulation_slots_RING_ROWS);
  gain = transfer_functions_gain(memory, simulation_slots_FUNCTION, speed) * memory.p[simulation_slots_PX_PER_METRE];
  return (T2d){memory.p[row] + gain * (u - memory.p[row + 2]), memory.p[row + 1] + gain * (v - memory.p[row + 3])};
}

/* V' of (2.1): friction -b1 V, and the force of the phase. */
T2d simulation_loop_acceleration(Vector memory, double t, simulation_loop_Place place) {
  double x, y, u, v, vx, vy, b1, along_x, along_y, b2;
  x = place.x;
  y = place.y;
  u = place.u;
  v = place.v;
  vx = place.vx;
  vy = place.vy;
  b1 = memory.p[simulation_slots_B1];
  if (memory.p[simulation_slots_PHASE] == simulation_slots_BALLISTIC) {
    T2d values_1 = simulation_loop_ballistic_force(memory, t);
    along_x = values_1.f0;
    along_y = values_1.f1;
    return (T2d){along_x - b1 * vx, along_y - b1 * vy};
  }
  if (memory.p[simulation_slots_PHASE] != simulation_slots_CORRECTIVE) {
    return (T2d){-b1 * vx, -b1 * vy};
  }
  if (memory.p[simulation_slots_METRES_PER_COUNT] > 0.0) {
    T2d values_2 = simulation_loop_cursor_in_mind(memory, u, v, hypot(vx, vy));
    x = values_2.f0;
    y = values_2.f1;
  }
  b2 = memory.p[simulation_slots_FEEDBACK];
  return (T2d){-b1 * vx - b2 * (x - memory.p[simulation_slots_AIM_X]), -b1 * vy - b2 * (y - memory.p[simulation_slots_AIM_Y])};
}

/* The cursor's velocity of (2.1) without a sensor: (Vx, Vy) / |V| PTF(|V|), px/s. */
T2d simulation_loop_cursor_rate(Vector memory, double vx, double vy) {
  double scale;
  scale = memory.p[simulation_slots_PX_PER_METRE] * transfer_functions_gain(memory, simulation_slots_FUNCTION, hypot(vx, vy));
  return (T2d){scale * vx, scale * vy};
}

/* One step of h s by the midpoint rule; ``extra`` is the velocity of noise and tremor. */
void simulation_loop_advance(Vector memory, double t, double h, double extra_x, double extra_y) {
  double keep, u, v, vx, vy, x, y, ax, ay, middle_x, middle_y, dx, dy, middle_u, middle_v, bx, by;
  bool continuous;
  keep = memory.p[simulation_slots_MUSCLE_S] > 0.0 ? exp(-0.5 * h / memory.p[simulation_slots_MUSCLE_S]) : 0.0;
  u = memory.p[simulation_slots_U];
  v = memory.p[simulation_slots_V];
  vx = memory.p[simulation_slots_VX];
  vy = memory.p[simulation_slots_VY];
  x = memory.p[simulation_slots_X];
  y = memory.p[simulation_slots_Y];
  continuous = memory.p[simulation_slots_METRES_PER_COUNT] == 0.0;
  T2d values_1 = simulation_loop_acceleration(memory, t, (simulation_loop_Place){x, y, u, v, vx, vy});
  ax = values_1.f0;
  ay = values_1.f1;
  ax = ax + keep * (memory.p[simulation_slots_AX] - ax);
  ay = ay + keep * (memory.p[simulation_slots_AY] - ay);
  middle_x = vx + 0.5 * h * ax;
  middle_y = vy + 0.5 * h * ay;
  if (continuous) {
    T2d values_2 = simulation_loop_cursor_rate(memory, vx + extra_x, vy + extra_y);
    dx = values_2.f0;
    dy = values_2.f1;
    x = x + 0.5 * h * dx;
    y = y + 0.5 * h * dy;
  }
  middle_u = u + 0.5 * h * vx;
  middle_v = v + 0.5 * h * vy;
  T2d values_3 = simulation_loop_acceleration(memory, t + 0.5 * h, (simulation_loop_Place){x, y, middle_u, middle_v, middle_x, middle_y});
  bx = values_3.f0;
  by = values_3.f1;
  bx = bx + keep * (ax - bx);
  by = by + keep * (ay - by);
  memory.p[simulation_slots_AX] = bx;
  memory.p[simulation_slots_AY] = by;
  memory.p[simulation_slots_VX] = vx + h * bx;
  memory.p[simulation_slots_VY] = vy + h * by;
  memory.p[simulation_slots_U] = u + h * (middle_x + extra_x);
  memory.p[simulation_slots_V] = v + h * (middle_y + extra_y);
  if (continuous) {
    T2d values_4 = simulation_loop_cursor_rate(memory, middle_x + extra_x, middle_y + extra_y);
    dx = values_4.f0;
    dy = values_4.f1;
    memory.p[simulation_slots_X] += h * dx;
    memory.p[simulation_slots_Y] += h * dy;
  }
}

/* Whole counts an axis has moved since the last report; the remainder carries over. */
double simulation_loop_count(double position_m, double metres_per_count, double counted) {
  return (double)(int64_t)trunc(position_m / metres_per_count - counted);
}

/* The pull of the assisted transfer function over one report period, px; 0 without an estimate. */
T2d simulation_loop_assist(Vector memory, double own_px, double hat_x, double hat_y) {
  double off_x, off_y, rho, strength, share;
  off_x = hat_x - memory.p[simulation_slots_X];
  off_y = hat_y - memory.p[simulation_slots_Y];
  rho = memory.p[simulation_slots_RHO];
  strength = memory.p[simulation_slots_STRENGTH];
  share = transfer_assistance_pull(rho, strength, memory.p[simulation_slots_PERIOD_S], own_px, off_x, off_y);
  return share > 0.0 ? (T2d){share * off_x, share * off_y} : (T2d){0.0, 0.0};
}

/* Poll the sensor: the counts of both axes; the cursor moves by whole pixels. */
T2d simulation_loop_report(Vector memory, double hat_x, double hat_y) {
  double unit, dx, dy, gain, scale, pull_x, pull_y;
  unit = memory.p[simulation_slots_METRES_PER_COUNT];
  dx = simulation_loop_count(memory.p[simulation_slots_U], unit, memory.p[simulation_slots_COUNTED_X]);
  dy = simulation_loop_count(memory.p[simulation_slots_V], unit, memory.p[simulation_slots_COUNTED_Y]);
  memory.p[simulation_slots_COUNTED_X] += dx;
  memory.p[simulation_slots_COUNTED_Y] += dy;
  gain = transfer_functions_gain(memory, simulation_slots_FUNCTION, hypot(dx, dy) * unit / memory.p[simulation_slots_PERIOD_S]);
  scale = gain * memory.p[simulation_slots_PX_PER_METRE] * unit;
  T2d values_1 = simulation_loop_assist(memory, scale * hypot(dx, dy), hat_x, hat_y);
  pull_x = values_1.f0;
  pull_y = values_1.f1;
  memory.p[simulation_slots_X] += transfer_pixels_carry(memory, simulation_slots_CARRY, scale * dx);
  memory.p[simulation_slots_Y] += transfer_pixels_carry(memory, simulation_slots_CARRY + 1, scale * dy);
  memory.p[simulation_slots_X] += transfer_pixels_carry(memory, simulation_slots_PULLED, pull_x);
  memory.p[simulation_slots_Y] += transfer_pixels_carry(memory, simulation_slots_PULLED + 1, pull_y);
  return (T2d){dx, dy};
}

/* Begin a phase. */
void simulation_loop_enter(Vector memory, double phase, double t) {
  memory.p[simulation_slots_PHASE] = phase;
  memory.p[simulation_slots_SINCE] = t;
}

/* Begin the corrective phase; by default b2 follows from the gain at half the present speed. */
void simulation_loop_correct(Vector memory, double t) {
  double gain;
  simulation_loop_enter(memory, simulation_slots_CORRECTIVE, t);
  memory.p[simulation_slots_FEEDBACK] = memory.p[simulation_slots_B2];
  if (memory.p[simulation_slots_B2] == 0.0) {
    gain = transfer_functions_gain(memory, simulation_slots_FUNCTION, 0.5 * hypot(memory.p[simulation_slots_VX], memory.p[simulation_slots_VY]));
    memory.p[simulation_slots_FEEDBACK] = square(memory.p[simulation_slots_RATE]) / (gain * memory.p[simulation_slots_PX_PER_METRE]);
  }
}

/* Begin a piece towards its share of the remaining way; if that is too short, correct instead. */
void simulation_loop_launch(Vector memory, int64_t number, double t) {
  int64_t piece;
  double way_x, way_y, way, wanted;
  piece = simulation_slots_PIECE + simulation_slots_PIECE_SLOTS * number;
  way_x = memory.p[simulation_slots_AIM_X] - memory.p[simulation_slots_X];
  way_y = memory.p[simulation_slots_AIM_Y] - memory.p[simulation_slots_Y];
  way = hypot(way_x, way_y);
  if (number >= memory.p[simulation_slots_PIECES] || way < max_float(simulation_loop_WORTHWHILE_PX, 2.0 * memory.p[simulation_slots_RADIUS])) {
    simulation_loop_correct(memory, t);
    return;
  }
  simulation_loop_enter(memory, simulation_slots_BALLISTIC, t);
  memory.p[simulation_slots_NUMBER] = (double)number;
  wanted = way * memory.p[piece + simulation_slots_SHARE];
  memory.p[simulation_slots_AMPLITUDE] = simulation_loop_hand_distance(memory, wanted, memory.p[piece + simulation_slots_DURATION_S]);
  memory.p[simulation_slots_ANGLE] = atan2(way_y, way_x) + memory.p[piece + simulation_slots_TURN];
}

/* The person's next phase: wait, move, move again, correct, verify, press, release. */
void simulation_loop_decide(Vector memory, double t) {
  double phase, since, off;
  int64_t number, piece;
  bool slow, arrived;
  phase = memory.p[simulation_slots_PHASE];
  since = memory.p[simulation_slots_SINCE];
  if (phase == simulation_slots_WAITING && t >= memory.p[simulation_slots_REACTION_S]) {
    simulation_loop_launch(memory, 0, t);
  } else if (phase == simulation_slots_BALLISTIC) {
    number = (int64_t)memory.p[simulation_slots_NUMBER];
    piece = simulation_slots_PIECE + simulation_slots_PIECE_SLOTS * number;
    if (t - since >= memory.p[piece + simulation_slots_UNTIL] * memory.p[piece + simulation_slots_DURATION_S]) {
      simulation_loop_launch(memory, number + 1, t);
    }
  } else if (phase == simulation_slots_CORRECTIVE) {
    off = hypot(memory.p[simulation_slots_X] - memory.p[simulation_slots_TARGET_X], memory.p[simulation_slots_Y] - memory.p[simulation_slots_TARGET_Y]);
    slow = hypot(memory.p[simulation_slots_VX], memory.p[simulation_slots_VY]) < simulation_loop_SLOW_M_S;
    arrived = slow && off < simulation_loop_NEAR_SHARE * memory.p[simulation_slots_RADIUS];
    if (arrived || t > memory.p[simulation_slots_PATIENCE_S]) {
      simulation_loop_enter(memory, simulation_slots_VERIFYING, t);
    }
  } else if (phase == simulation_slots_VERIFYING && t - since >= memory.p[simulation_slots_VERIFY_S]) {
    simulation_loop_enter(memory, simulation_slots_PRESSING, t);
  } else if (phase == simulation_slots_PRESSING && t - since >= memory.p[simulation_slots_PRESS_S]) {
    simulation_loop_enter(memory, simulation_slots_DONE, t);
  }
}

/* One report period: decide, move the hand, poll the sensor, update the delayed sight. */
T14d simulation_loop_step(Vector memory, T5d chance) {
  double noise_x, noise_y, late_s, hat_x, hat_y, period, now, keep, fresh, speed, size, extra_x, extra_y, before_x, before_y, h, dy, dx, own_px, pull_x, pull_y;
  int64_t substeps, row;
  simulation_loop_Chance values_1 = simulation_loop_Chance_of_T5d(chance);
  noise_x = values_1.noise_x;
  noise_y = values_1.noise_y;
  late_s = values_1.late_s;
  hat_x = values_1.hat_x;
  hat_y = values_1.hat_y;
  period = memory.p[simulation_slots_PERIOD_S];
  now = memory.p[simulation_slots_TICK] * period;
  simulation_loop_decide(memory, now);
  keep = exp(-period / simulation_loop_WANDER_S);
  fresh = sqrt(1.0 - keep * keep);
  memory.p[simulation_slots_WANDER_X] = keep * memory.p[simulation_slots_WANDER_X] + fresh * noise_x;
  memory.p[simulation_slots_WANDER_Y] = keep * memory.p[simulation_slots_WANDER_Y] + fresh * noise_y;
  speed = hypot(memory.p[simulation_slots_VX], memory.p[simulation_slots_VY]);
  size = memory.p[simulation_slots_TREMOR] + memory.p[simulation_slots_NOISE] * speed;
  extra_x = size * memory.p[simulation_slots_WANDER_X];
  extra_y = size * memory.p[simulation_slots_WANDER_Y];
  before_x = memory.p[simulation_slots_X];
  before_y = memory.p[simulation_slots_Y];
  substeps = (int64_t)memory.p[simulation_slots_SUBSTEPS];
  h = period / substeps;
  for (int64_t i = 0; i < substeps; i++) {
    simulation_loop_advance(memory, now + i * h, h, extra_x, extra_y);
  }
  dy = 0.0;
  dx = dy;
  if (memory.p[simulation_slots_METRES_PER_COUNT] > 0.0) {
    T2d values_2 = simulation_loop_report(memory, hat_x, hat_y);
    dx = values_2.f0;
    dy = values_2.f1;
  } else {
    own_px = hypot(memory.p[simulation_slots_X] - before_x, memory.p[simulation_slots_Y] - before_y);
    T2d values_3 = simulation_loop_assist(memory, own_px, hat_x, hat_y);
    pull_x = values_3.f0;
    pull_y = values_3.f1;
    memory.p[simulation_slots_X] += pull_x;
    memory.p[simulation_slots_Y] += pull_y;
  }
  memory.p[simulation_slots_TICK] += 1.0;
  row = simulation_slots_RING + simulation_slots_RING_SLOTS * remainder_whole((int64_t)memory.p[simulation_slots_TICK], simulation_slots_RING_ROWS);
  double value_4 = memory.p[simulation_slots_X];
  double value_5 = memory.p[simulation_slots_Y];
  memory.p[row] = value_4;
  memory.p[row + 1] = value_5;
  double value_6 = memory.p[simulation_slots_U];
  double value_7 = memory.p[simulation_slots_V];
  memory.p[row + 2] = value_6;
  memory.p[row + 3] = value_7;
  return (T14d){memory.p[simulation_slots_TICK] * period + late_s, memory.p[simulation_slots_X], memory.p[simulation_slots_Y], dx, dy, memory.p[simulation_slots_PHASE] == simulation_slots_PRESSING ? 1.0 : 0.0, memory.p[simulation_slots_U], memory.p[simulation_slots_V], memory.p[simulation_slots_VX] + extra_x, memory.p[simulation_slots_VY] + extra_y, memory.p[simulation_slots_AX], memory.p[simulation_slots_AY], memory.p[simulation_slots_PHASE], memory.p[simulation_slots_NUMBER]};
}

/* Report after report, a ``Chance`` a row, until the button is released; returns how many there were. */
int64_t simulation_loop_play(Vector memory, Table rows, Table out) {
  Vector r;
  T14d answer;
  for (int64_t i = 0; i < rows.n; i++) {
    r = (Vector){rows.p + i * rows.m, rows.m};
    answer = simulation_loop_step(memory, (T5d){r.p[0], r.p[1], r.p[2], r.p[3], r.p[4]});
    for (int64_t j = 0; j < 14; j++) {
      out.p[i * out.m + j] = ((const double *)&answer)[j];
    }
    if (memory.p[simulation_slots_PHASE] == simulation_slots_DONE) {
      return i + 1;
    }
  }
  return rows.n;
}
