/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const int64_t differentiators_difference_AT = 5;
static const int64_t differentiators_difference_AX = 22;
static const int64_t differentiators_difference_SHORTEST_S = 4;
static const int64_t differentiators_difference_SPAN_S = 24;
static const int64_t differentiators_difference_TIME = 17;
static const int64_t differentiators_difference_UX = 18;
static const int64_t differentiators_difference_VX = 20;
static const int64_t differentiators_homogeneous_ALPHA = 5;
static const int64_t differentiators_homogeneous_ALPHA_OF = 7;
static const int64_t differentiators_homogeneous_AT = 17;
static const int64_t differentiators_homogeneous_GAIN = 9;
static const int64_t differentiators_homogeneous_HOLD = 7;
static const int64_t differentiators_homogeneous_LAMBDA_OF = 5;
static const int64_t differentiators_homogeneous_ORDER = 4;
static const int64_t differentiators_homogeneous_ORDER_OF = 4;
static const int64_t differentiators_homogeneous_SETTLE_S = 8;
static const double differentiators_homogeneous_SETTLING_SPEED_M_S = 0.3;
static const int64_t differentiators_homogeneous_SLOPE = 45;
static const int64_t differentiators_homogeneous_STEP_OF = 8;
static const int64_t differentiators_homogeneous_STEP_S = 6;
static const int64_t differentiators_homogeneous_XI_OF = 6;
static const int64_t differentiators_homogeneous_ZX = 29;
static const int64_t differentiators_homogeneous_ZY = 37;
static const int64_t differentiators_kalman_AT = 6;
static const int64_t differentiators_kalman_AXIS = 3;
static const int64_t differentiators_kalman_JERK_DENSITY = 4;
static const int64_t differentiators_kalman_NOISE = 5;
static const int64_t differentiators_kalman_PLANE = 12;
static const double differentiators_kalman_SETTLED_RADIANS = 4.0;
static const double differentiators_kalman_START_ACCELERATION_M_S2 = 5.0;
static const double differentiators_kalman_START_SPEED_M_S = 0.3;
static const int64_t differentiators_kalman_X = 18;
static const int64_t differentiators_sampling_BUTTONS = 4;
static const int64_t differentiators_sampling_COUNTS = 8;
static const int64_t differentiators_sampling_GAP_S = 2;
static const int64_t differentiators_sampling_LAST_U = 10;
static const int64_t differentiators_sampling_LAST_V = 11;
static const int64_t differentiators_sampling_MERGED = 0;
static const int64_t differentiators_sampling_METRES_PER_COUNT = 0;
static const int64_t differentiators_sampling_METRES_PER_PX = 1;
static const int64_t differentiators_sampling_MOVED = 2;
static const int64_t differentiators_sampling_PAUSE_S = 3;
static const int64_t differentiators_sampling_RESTARTED = 1;
static const int64_t differentiators_sampling_SAMPLES = 7;
static const int64_t differentiators_sampling_SINCE = 9;
static const int64_t differentiators_sampling_STARTED = 0;
static const int64_t differentiators_sampling_T = 1;
static const int64_t differentiators_sampling_U = 5;
static const int64_t differentiators_sampling_V = 6;
static const int64_t differentiators_sampling_X = 2;
static const int64_t differentiators_sampling_Y = 3;
static const int64_t records_FINE = 0;
static const double records_METRES_PER_INCH = 0.0254;
static const int64_t records_ORDER = 1;
static const double records_ROUNDING_S = 1e-06;

/* Velocity over the last interval, acceleration between the middles of the last two. */
void differentiators_difference_advance(Vector memory, int64_t axis, double u, double dt) {
  double velocity;
  velocity = (u - memory.p[differentiators_difference_UX + axis]) / dt;
  if (memory.p[differentiators_difference_SPAN_S] > 0.0) {
    memory.p[differentiators_difference_AX + axis] = (velocity - memory.p[differentiators_difference_VX + axis]) / (0.5 * (dt + memory.p[differentiators_difference_SPAN_S]));
  }
  memory.p[differentiators_difference_VX + axis] = velocity;
  memory.p[differentiators_difference_UX + axis] = u;
}

/* Take one event in: (verdict, dt in s, motor position that the law used last in m, movement started). */
Tq3db differentiators_sampling_accept(Vector memory, int64_t at, records_EventRow event) {
  double t, x, y, dx, dy, buttons, dt, before_u, before_v;
  bool started, released, start, counted, merged, restarted;
  int64_t fault;
  t = event.t;
  x = event.x;
  y = event.y;
  dx = event.dx;
  dy = event.dy;
  buttons = event.buttons;
  started = memory.p[at + differentiators_sampling_STARTED] == 1.0;
  fault = records_fault_of_event(event);
  if (fault == records_FINE && started && t < memory.p[at + differentiators_sampling_T]) {
    fault = records_ORDER;
  }
  if (fault != records_FINE) {
    return (Tq3db){-fault, 0.0, 0.0, 0.0, false};
  }
  dt = t - memory.p[at + differentiators_sampling_T];
  released = ((int64_t)memory.p[at + differentiators_sampling_BUTTONS] & ~(int64_t)buttons) != 0;
  start = !started || released || dt > memory.p[differentiators_sampling_PAUSE_S] + records_ROUNDING_S;
  counted = dx == dx && memory.p[differentiators_sampling_METRES_PER_COUNT] > 0.0;
  merged = started && dt == 0.0;
  restarted = !started || dt > memory.p[differentiators_sampling_GAP_S] + records_ROUNDING_S || (merged && memory.p[at + differentiators_sampling_SAMPLES] == 1.0);
  if (restarted) {
    memory.p[at + differentiators_sampling_U] = 0.0;
    memory.p[at + differentiators_sampling_V] = 0.0;
    memory.p[at + differentiators_sampling_LAST_U] = 0.0;
    memory.p[at + differentiators_sampling_LAST_V] = 0.0;
    memory.p[at + differentiators_sampling_SINCE] = t;
  } else if (counted) {
    memory.p[at + differentiators_sampling_U] += dx * memory.p[differentiators_sampling_METRES_PER_COUNT];
    memory.p[at + differentiators_sampling_V] += dy * memory.p[differentiators_sampling_METRES_PER_COUNT];
  } else {
    memory.p[at + differentiators_sampling_U] += (x - memory.p[at + differentiators_sampling_X]) * memory.p[differentiators_sampling_METRES_PER_PX];
    memory.p[at + differentiators_sampling_V] += (y - memory.p[at + differentiators_sampling_Y]) * memory.p[differentiators_sampling_METRES_PER_PX];
  }
  memory.p[at + differentiators_sampling_STARTED] = 1.0;
  memory.p[at + differentiators_sampling_T] = t;
  memory.p[at + differentiators_sampling_X] = x;
  memory.p[at + differentiators_sampling_Y] = y;
  memory.p[at + differentiators_sampling_BUTTONS] = buttons;
  memory.p[at + differentiators_sampling_COUNTS] = counted ? 1.0 : 0.0;
  if (restarted) {
    memory.p[at + differentiators_sampling_SAMPLES] = 1.0;
    return (Tq3db){differentiators_sampling_RESTARTED, dt, 0.0, 0.0, start};
  }
  if (merged) {
    return (Tq3db){differentiators_sampling_MERGED, 0.0, 0.0, 0.0, start};
  }
  before_u = memory.p[at + differentiators_sampling_LAST_U];
  before_v = memory.p[at + differentiators_sampling_LAST_V];
  double value_1 = memory.p[at + differentiators_sampling_U];
  double value_2 = memory.p[at + differentiators_sampling_V];
  memory.p[at + differentiators_sampling_LAST_U] = value_1;
  memory.p[at + differentiators_sampling_LAST_V] = value_2;
  memory.p[at + differentiators_sampling_SAMPLES] += 1.0;
  return (Tq3db){differentiators_sampling_MOVED, dt, before_u, before_v, start};
}

/* 1 once there are ``samples`` samples over ``settle_s`` s since the restart, else 0. */
double differentiators_sampling_settled(Vector memory, int64_t at, double samples, double settle_s) {
  bool long_enough;
  long_enough = memory.p[at + differentiators_sampling_T] - memory.p[at + differentiators_sampling_SINCE] >= settle_s;
  return long_enough && memory.p[at + differentiators_sampling_SAMPLES] >= samples ? 1.0 : 0.0;
}

/* The row of the motion after an accepted event; ``hand``: its velocity m/s and acceleration m/s^2. */
T10d differentiators_sampling_motion(Vector memory, int64_t at, records_EventRow event, T2_T2d_ hand, double settled, bool start) {
  double t, x, y, vx, vy, ax, ay;
  T2d velocity, acceleration;
  t = event.t;
  x = event.x;
  y = event.y;
  velocity = hand.f0;
  acceleration = hand.f1;
  vx = velocity.f0;
  vy = velocity.f1;
  ax = acceleration.f0;
  ay = acceleration.f1;
  return (T10d){t, x, y, vx, vy, ax, ay, settled, start ? 1.0 : 0.0, memory.p[at + differentiators_sampling_COUNTS]};
}

/* One event through the differences of both axes. */
T10d differentiators_difference_step(Vector memory, records_EventRow event) {
  int64_t verdict;
  bool start;
  double dt, settled;
  T2d velocity, acceleration;
  Tq3db values_1 = differentiators_sampling_accept(memory, differentiators_difference_AT, event);
  verdict = values_1.f0;
  start = values_1.f4;
  if (verdict < 0) {
    return records_refused(-verdict, memory.p[differentiators_difference_AT + differentiators_sampling_T]);
  }
  if (verdict == differentiators_sampling_RESTARTED) {
    fill((Vector){memory.p + differentiators_difference_TIME, differentiators_difference_SPAN_S + 1 - differentiators_difference_TIME}, 0.0);
    memory.p[differentiators_difference_TIME] = memory.p[differentiators_difference_AT + differentiators_sampling_T];
  }
  dt = memory.p[differentiators_difference_AT + differentiators_sampling_T] - memory.p[differentiators_difference_TIME];
  if (verdict == differentiators_sampling_MOVED && dt >= memory.p[differentiators_difference_SHORTEST_S]) {
    differentiators_difference_advance(memory, 0, memory.p[differentiators_difference_AT + differentiators_sampling_U], dt);
    differentiators_difference_advance(memory, 1, memory.p[differentiators_difference_AT + differentiators_sampling_V], dt);
    memory.p[differentiators_difference_TIME] = memory.p[differentiators_difference_AT + differentiators_sampling_T];
    memory.p[differentiators_difference_SPAN_S] = dt;
  }
  velocity = (T2d){memory.p[differentiators_difference_VX], memory.p[differentiators_difference_VX + 1]};
  acceleration = (T2d){memory.p[differentiators_difference_AX], memory.p[differentiators_difference_AX + 1]};
  settled = differentiators_sampling_settled(memory, differentiators_difference_AT, 3.0, 2.0 * memory.p[differentiators_difference_SHORTEST_S]);
  return differentiators_sampling_motion(memory, differentiators_difference_AT, event, (T2_T2d_){velocity, acceleration}, settled, start);
}

/* Integrate (2.2) by explicit Euler over ``steps`` sub-steps of ``h`` s; returns the last slope of z_n. */
double differentiators_homogeneous_advance(Vector memory, int64_t z, double before, double now, double h, int64_t steps) {
  int64_t order;
  double slope, y, error, size, scale, push, carried;
  order = (int64_t)memory.p[differentiators_homogeneous_ORDER];
  slope = 0.0;
  for (int64_t i = 0; i < steps; i++) {
    y = memory.p[differentiators_homogeneous_HOLD] == 1.0 ? now : before + (now - before) * ((double)i / steps);
    error = memory.p[z] - y;
    size = fabs(error);
    scale = size > 0.0 ? pow(size, memory.p[differentiators_homogeneous_ALPHA]) : 0.0;
    push = error;
    for (int64_t j = 0; j < order; j++) {
      push *= scale;
      carried = j + 1 < order ? memory.p[z + j + 1] : 0.0;
      slope = carried - memory.p[differentiators_homogeneous_GAIN + j] * push;
      memory.p[z + j] += h * slope;
    }
  }
  return slope;
}

/* One event through the differentiator of both axes. */
T10d differentiators_homogeneous_step(Vector memory, records_EventRow event) {
  int64_t verdict, steps;
  double dt, before_u, before_v, h, settled;
  bool start, second;
  T2d velocity, acceleration;
  Tq3db values_1 = differentiators_sampling_accept(memory, differentiators_homogeneous_AT, event);
  verdict = values_1.f0;
  dt = values_1.f1;
  before_u = values_1.f2;
  before_v = values_1.f3;
  start = values_1.f4;
  if (verdict < 0) {
    return records_refused(-verdict, memory.p[differentiators_homogeneous_AT + differentiators_sampling_T]);
  }
  if (verdict == differentiators_sampling_RESTARTED) {
    fill((Vector){memory.p + differentiators_homogeneous_ZX, differentiators_homogeneous_SLOPE + 2 - differentiators_homogeneous_ZX}, 0.0);
  } else if (verdict == differentiators_sampling_MOVED) {
    steps = (int64_t)ceil(dt / memory.p[differentiators_homogeneous_STEP_S]);
    h = dt / steps;
    memory.p[differentiators_homogeneous_SLOPE] = differentiators_homogeneous_advance(memory, differentiators_homogeneous_ZX, before_u, memory.p[differentiators_homogeneous_AT + differentiators_sampling_U], h, steps);
    memory.p[differentiators_homogeneous_SLOPE + 1] = differentiators_homogeneous_advance(memory, differentiators_homogeneous_ZY, before_v, memory.p[differentiators_homogeneous_AT + differentiators_sampling_V], h, steps);
  }
  second = memory.p[differentiators_homogeneous_ORDER] == 2.0;
  velocity = (T2d){memory.p[differentiators_homogeneous_ZX + 1], memory.p[differentiators_homogeneous_ZY + 1]};
  acceleration = (T2d){second ? memory.p[differentiators_homogeneous_SLOPE] : memory.p[differentiators_homogeneous_ZX + 2], second ? memory.p[differentiators_homogeneous_SLOPE + 1] : memory.p[differentiators_homogeneous_ZY + 2]};
  settled = differentiators_sampling_settled(memory, differentiators_homogeneous_AT, memory.p[differentiators_homogeneous_ORDER] + 1.0, memory.p[differentiators_homogeneous_SETTLE_S]);
  return differentiators_sampling_motion(memory, differentiators_homogeneous_AT, event, (T2_T2d_){velocity, acceleration}, settled, start);
}

/* Seconds until the velocity stays within 5 % of a ramp's ``speed`` m/s, from rest; spoils ``memory``. */
double differentiators_homogeneous_settling(Vector memory, double speed, double h, int64_t steps) {
  double settled_s;
  settled_s = 0.0;
  for (int64_t i = 0; i < steps; i++) {
    differentiators_homogeneous_advance(memory, differentiators_homogeneous_ZX, speed * i * h, speed * (i + 1) * h, h, 1);
    if (fabs(memory.p[differentiators_homogeneous_ZX + 1] - speed) > 0.05 * speed) {
      settled_s = (i + 1) * h;
    }
  }
  return settled_s;
}

/* Largest speed in m/s long after the position stepped to ``place`` m and rests; spoils ``memory``. */
double differentiators_homogeneous_chatter(Vector memory, double place, double h, int64_t steps) {
  double fastest, speed;
  differentiators_homogeneous_advance(memory, differentiators_homogeneous_ZX, place, place, h, steps);
  fastest = 0.0;
  for (int64_t i_1 = 0, end_2 = floor_divided_whole(steps, 4); i_1 < end_2; i_1++) {
    differentiators_homogeneous_advance(memory, differentiators_homogeneous_ZX, place, place, h, 1);
    speed = fabs(memory.p[differentiators_homogeneous_ZX + 1]);
    if (!(speed <= fastest)) {
      fastest = speed;
    }
  }
  return fastest;
}

/* The gains k_1 ... k_n: coefficients of (s + lambda)(s + lambda xi) ... (s + lambda xi^(n-1)). */
void differentiators_homogeneous_place_poles(Vector memory, double gain_lambda, double gain_xi) {
  double rate;
  for (int64_t i = 0, end_1 = (int64_t)memory.p[differentiators_homogeneous_ORDER]; i < end_1; i++) {
    rate = gain_lambda * whole_power(gain_xi, i);
    for (int64_t j = i; j > 0; j--) {
      memory.p[differentiators_homogeneous_GAIN + j] += rate * memory.p[differentiators_homogeneous_GAIN + j - 1];
    }
    memory.p[differentiators_homogeneous_GAIN] += rate;
  }
}

/* The settings of counts per inch (0: counts are not used), px per inch, gap and pause in s. */
void differentiators_sampling_fill(Vector values, Vector memory) {
  memory.p[differentiators_sampling_METRES_PER_COUNT] = values.p[0] > 0.0 ? records_METRES_PER_INCH / values.p[0] : 0.0;
  memory.p[differentiators_sampling_METRES_PER_PX] = records_METRES_PER_INCH / values.p[1];
  for (int64_t i = differentiators_sampling_GAP_S; i < values.n; i++) {
    memory.p[i] = values.p[i];
  }
}

/* The settings but for the settling time; between two samples the position runs on a line. */
void differentiators_homogeneous_fill(Vector values, Vector memory) {
  differentiators_sampling_fill(values, memory);
  memory.p[differentiators_homogeneous_ORDER] = values.p[differentiators_homogeneous_ORDER_OF];
  memory.p[differentiators_homogeneous_ALPHA] = values.p[differentiators_homogeneous_ALPHA_OF];
  memory.p[differentiators_homogeneous_STEP_S] = values.p[differentiators_homogeneous_STEP_OF];
  memory.p[differentiators_homogeneous_SETTLE_S] = 0.0;
  memory.p[differentiators_homogeneous_HOLD] = memory.p[differentiators_homogeneous_SETTLE_S];
  differentiators_homogeneous_place_poles(memory, values.p[differentiators_homogeneous_LAMBDA_OF], values.p[differentiators_homogeneous_XI_OF]);
}

/* Measure how long the law takes to settle, in a memory without states. */
void differentiators_homogeneous_settle(Vector memory) {
  double h;
  h = min_float(memory.p[differentiators_homogeneous_STEP_S], 0.001);
  memory.p[differentiators_homogeneous_SETTLE_S] = differentiators_homogeneous_settling(memory, differentiators_homogeneous_SETTLING_SPEED_M_S, h, (int64_t)floor(2.0 / h + 0.5));
  fill((Vector){memory.p + differentiators_homogeneous_AT, memory.n - differentiators_homogeneous_AT}, 0.0);
}

/* The settings; of the noise in m its variance. */
void differentiators_kalman_fill(Vector values, Vector memory) {
  differentiators_sampling_fill(values, memory);
  memory.p[differentiators_kalman_NOISE] = values.p[differentiators_kalman_NOISE] * values.p[differentiators_kalman_NOISE];
}

/* One axis after ``dt`` s of constant acceleration. */
void differentiators_kalman_predict(Vector memory, int64_t x, double dt) {
  memory.p[x] += dt * (memory.p[x + 1] + 0.5 * dt * memory.p[x + 2]);
  memory.p[x + 1] += dt * memory.p[x + 2];
}

/* Covariance after ``dt`` s: P <- F P F' + Q, Q that of white jerk integrated exactly. */
void differentiators_kalman_spread(Vector memory, int64_t p, double jerk_density, double dt) {
  double p00, p01, p02, p11, p12, p22, half, q, f00, f01, f02, g11, g12;
  p00 = memory.p[p];
  p01 = memory.p[p + 1];
  p02 = memory.p[p + 2];
  p11 = memory.p[p + 3];
  p12 = memory.p[p + 4];
  p22 = memory.p[p + 5];
  half = 0.5 * dt * dt;
  q = jerk_density * dt;
  f00 = p00 + dt * p01 + half * p02;
  f01 = p01 + dt * p11 + half * p12;
  f02 = p02 + dt * p12 + half * p22;
  g11 = p11 + dt * p12;
  g12 = p12 + dt * p22;
  memory.p[p] = f00 + dt * f01 + half * f02 + q * whole_power(dt, 4) / 20.0;
  memory.p[p + 1] = f01 + dt * f02 + q * whole_power(dt, 3) / 8.0;
  memory.p[p + 2] = f02 + q * dt * dt / 6.0;
  memory.p[p + 3] = g11 + dt * g12 + q * dt * dt / 3.0;
  memory.p[p + 4] = g12 + q * dt / 2.0;
  memory.p[p + 5] = p22 + q;
}

/* One axis after its position was measured with variance ``noise``; the covariance stays. */
void differentiators_kalman_correct(Vector memory, int64_t x, int64_t p, double noise, double measured) {
  double share;
  share = (measured - memory.p[x]) / (memory.p[p] + noise);
  memory.p[x] += memory.p[p] * share;
  memory.p[x + 1] += memory.p[p + 1] * share;
  memory.p[x + 2] += memory.p[p + 2] * share;
}

/* Covariance after a position was measured with variance ``noise``. */
void differentiators_kalman_narrow(Vector memory, int64_t p, double noise) {
  double p00, p01, p02, total;
  p00 = memory.p[p];
  p01 = memory.p[p + 1];
  p02 = memory.p[p + 2];
  total = p00 + noise;
  memory.p[p + 3] = max_float(memory.p[p + 3] - p01 * p01 / total, 0.0);
  memory.p[p + 4] -= p01 * p02 / total;
  memory.p[p + 5] = max_float(memory.p[p + 5] - p02 * p02 / total, 0.0);
  memory.p[p] = p00 * noise / total;
  memory.p[p + 1] = p01 * noise / total;
  memory.p[p + 2] = p02 * noise / total;
}

/* Both axes at the origin of the path, at a speed that nobody knows. */
void differentiators_kalman_restart(Vector memory, int64_t x, double noise) {
  int64_t p;
  fill((Vector){memory.p + x, x + differentiators_kalman_PLANE - x}, 0.0);
  p = x + 2 * differentiators_kalman_AXIS;
  memory.p[p] = noise;
  memory.p[p + 3] = square(differentiators_kalman_START_SPEED_M_S);
  memory.p[p + 5] = square(differentiators_kalman_START_ACCELERATION_M_S2);
}

/* Both axes and their covariance after ``dt`` s, and after their positions were measured. */
void differentiators_kalman_follow(Vector memory, int64_t x, double jerk_density, double noise, double dt, T2d place) {
  double u, v;
  int64_t p;
  u = place.f0;
  v = place.f1;
  p = x + 2 * differentiators_kalman_AXIS;
  differentiators_kalman_predict(memory, x, dt);
  differentiators_kalman_predict(memory, x + differentiators_kalman_AXIS, dt);
  differentiators_kalman_spread(memory, p, jerk_density, dt);
  differentiators_kalman_correct(memory, x, p, noise, u);
  differentiators_kalman_correct(memory, x + differentiators_kalman_AXIS, p, noise, v);
  differentiators_kalman_narrow(memory, p, noise);
}

/* Time that the stationary filter takes at the mean rate so far: 4 / (q / (r T))^(1/6). */
double differentiators_kalman_settle_s(Vector memory) {
  double intervals, period;
  intervals = max_float(memory.p[differentiators_kalman_AT + differentiators_sampling_SAMPLES] - 1.0, 1.0);
  period = (memory.p[differentiators_kalman_AT + differentiators_sampling_T] - memory.p[differentiators_kalman_AT + differentiators_sampling_SINCE]) / intervals;
  return differentiators_kalman_SETTLED_RADIANS * pow(memory.p[differentiators_kalman_NOISE] * period / memory.p[differentiators_kalman_JERK_DENSITY], 1.0 / 6.0);
}

/* One event through the filter of both axes. */
T10d differentiators_kalman_step(Vector memory, records_EventRow event) {
  int64_t verdict;
  double dt, settled;
  bool start;
  T2d place, velocity, acceleration;
  Tq3db values_1 = differentiators_sampling_accept(memory, differentiators_kalman_AT, event);
  verdict = values_1.f0;
  dt = values_1.f1;
  start = values_1.f4;
  if (verdict < 0) {
    return records_refused(-verdict, memory.p[differentiators_kalman_AT + differentiators_sampling_T]);
  }
  if (verdict == differentiators_sampling_RESTARTED) {
    differentiators_kalman_restart(memory, differentiators_kalman_X, memory.p[differentiators_kalman_NOISE]);
  } else if (verdict == differentiators_sampling_MOVED) {
    place = (T2d){memory.p[differentiators_kalman_AT + differentiators_sampling_U], memory.p[differentiators_kalman_AT + differentiators_sampling_V]};
    differentiators_kalman_follow(memory, differentiators_kalman_X, memory.p[differentiators_kalman_JERK_DENSITY], memory.p[differentiators_kalman_NOISE], dt, place);
  }
  velocity = (T2d){memory.p[differentiators_kalman_X + 1], memory.p[differentiators_kalman_X + 4]};
  acceleration = (T2d){memory.p[differentiators_kalman_X + 2], memory.p[differentiators_kalman_X + 5]};
  settled = differentiators_sampling_settled(memory, differentiators_kalman_AT, 4.0, differentiators_kalman_settle_s(memory));
  return differentiators_sampling_motion(memory, differentiators_kalman_AT, event, (T2_T2d_){velocity, acceleration}, settled, start);
}

void loop__stage_learn_nothing__records_event_at__differentiators_difference_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out) {
  T10d answer;
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      stage_learn_nothing(memory);
      fill((Vector){memory.p + first, memory.n - first}, 0.0);
    }
    answer = differentiators_difference_step(memory, records_EventRow_of_T6d(records_event_at(rows, i)));
    for (int64_t j = 0; j < 10; j++) {
      out.p[i * out.m + j] = ((const double *)&answer)[j];
    }
  }
}

void loop__stage_learn_nothing__records_event_at__differentiators_homogeneous_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out) {
  T10d answer;
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      stage_learn_nothing(memory);
      fill((Vector){memory.p + first, memory.n - first}, 0.0);
    }
    answer = differentiators_homogeneous_step(memory, records_EventRow_of_T6d(records_event_at(rows, i)));
    for (int64_t j = 0; j < 10; j++) {
      out.p[i * out.m + j] = ((const double *)&answer)[j];
    }
  }
}

void loop__stage_learn_nothing__records_event_at__differentiators_kalman_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out) {
  T10d answer;
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      stage_learn_nothing(memory);
      fill((Vector){memory.p + first, memory.n - first}, 0.0);
    }
    answer = differentiators_kalman_step(memory, records_EventRow_of_T6d(records_event_at(rows, i)));
    for (int64_t j = 0; j < 10; j++) {
      out.p[i * out.m + j] = ((const double *)&answer)[j];
    }
  }
}
