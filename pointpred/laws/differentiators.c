/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const int64_t differentiators_homogeneous_ALPHA_OF = 7;
static const int64_t differentiators_homogeneous_LAMBDA_OF = 5;
static const int64_t differentiators_homogeneous_ORDER_OF = 4;
static const double differentiators_homogeneous_SETTLING_SPEED_M_S = 0.3;
static const int64_t differentiators_homogeneous_STEP_OF = 8;
static const int64_t differentiators_homogeneous_XI_OF = 6;
static const double differentiators_kalman_SETTLED_RADIANS = 4.0;
static const double differentiators_kalman_START_ACCELERATION_M_S2 = 5.0;
static const double differentiators_kalman_START_SPEED_M_S = 0.3;
static const int64_t differentiators_sampling_MERGED = 0;
static const double records_METRES_PER_INCH = 0.0254;

/* Velocity over the last interval, acceleration between the middles of the last two. */
void differentiators_difference_advance(differentiators_difference_Differences * last, int64_t axis, double u, double dt) {
  double velocity;
  velocity = (u - last->u[axis]) / dt;
  if (last->span_s > 0.0) {
    last->a[axis] = (velocity - last->v[axis]) / (0.5 * (dt + last->span_s));
  }
  last->v[axis] = velocity;
  last->u[axis] = u;
}

/* Take one event in: (verdict, dt in s, motor position that the law used last in m, movement started). */
Tq3db differentiators_sampling_accept(differentiators_sampling_Settings * settings, differentiators_sampling_State * s, records_EventRow event) {
  double t, x, y, dx, dy, buttons, dt, before_u, before_v;
  bool started, released, start, counted, merged, restarted;
  int64_t fault;
  t = event.t;
  x = event.x;
  y = event.y;
  dx = event.dx;
  dy = event.dy;
  buttons = event.buttons;
  started = s->started == 1.0;
  fault = records_fault_of_event(event);
  if (fault == records_FINE && started && t < s->t) {
    fault = records_ORDER;
  }
  if (fault != records_FINE) {
    return (Tq3db){-fault, 0.0, 0.0, 0.0, false};
  }
  dt = t - s->t;
  released = ((int64_t)s->buttons & ~(int64_t)buttons) != 0;
  start = !started || released || dt > settings->pause_s + records_ROUNDING_S;
  counted = dx == dx && settings->metres_per_count > 0.0;
  merged = started && dt == 0.0;
  restarted = !started || dt > settings->gap_s + records_ROUNDING_S || (merged && s->samples == 1.0);
  if (restarted) {
    s->u = 0.0;
    s->v = 0.0;
    s->last_u = 0.0;
    s->last_v = 0.0;
    s->since = t;
  } else if (counted) {
    s->u += dx * settings->metres_per_count;
    s->v += dy * settings->metres_per_count;
  } else {
    s->u += (x - s->x) * settings->metres_per_px;
    s->v += (y - s->y) * settings->metres_per_px;
  }
  s->started = 1.0;
  s->t = t;
  s->x = x;
  s->y = y;
  s->buttons = buttons;
  s->counts = counted ? 1.0 : 0.0;
  if (restarted) {
    s->samples = 1.0;
    return (Tq3db){differentiators_sampling_RESTARTED, dt, 0.0, 0.0, start};
  }
  if (merged) {
    return (Tq3db){differentiators_sampling_MERGED, 0.0, 0.0, 0.0, start};
  }
  before_u = s->last_u;
  before_v = s->last_v;
  double value_1 = s->u;
  double value_2 = s->v;
  s->last_u = value_1;
  s->last_v = value_2;
  s->samples += 1.0;
  return (Tq3db){differentiators_sampling_MOVED, dt, before_u, before_v, start};
}

/* 1 once there are ``samples`` samples over ``settle_s`` s since the restart, else 0. */
double differentiators_sampling_settled(differentiators_sampling_State * s, double samples, double settle_s) {
  bool long_enough;
  long_enough = s->t - s->since >= settle_s;
  return long_enough && s->samples >= samples ? 1.0 : 0.0;
}

/* The row of the motion after an accepted event; ``hand``: its velocity m/s and acceleration m/s^2. */
T10d differentiators_sampling_motion(differentiators_sampling_State * s, records_EventRow event, T2_T2d_ hand, double settled, bool start) {
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
  return (T10d){t, x, y, vx, vy, ax, ay, settled, start ? 1.0 : 0.0, s->counts};
}

/* Integrate (2.2) by explicit Euler over ``steps`` sub-steps of ``h`` s; returns the last z_n'. */
WIDE double differentiators_homogeneous_advance(differentiators_homogeneous_Settings * settings, differentiators_homogeneous_Axis * axis, double before, double now, double h, int64_t steps) {
  int64_t order;
  double slope, y, error, size, scale, push, carried;
  order = (int64_t)settings->order;
  slope = 0.0;
  for (int64_t i = 0; i < steps; i++) {
    y = settings->hold == 1.0 ? now : before + (now - before) * ((double)i / steps);
    error = axis->z[0] - y;
    size = fabs(error);
    scale = size > 0.0 ? pow(size, settings->alpha) : 0.0;
    push = error;
    for (int64_t j = 0; j < order; j++) {
      push *= scale;
      carried = j + 1 < order ? axis->z[j + 1] : 0.0;
      slope = carried - settings->gain[j] * push;
      axis->z[j] += h * slope;
    }
  }
  return slope;
}

/* Seconds until the velocity stays within 5 % of a ramp's ``speed`` m/s, from rest; spoils ``memory``. */
double differentiators_homogeneous_settling(differentiators_homogeneous_Memory * memory, double speed, double h, int64_t steps) {
  differentiators_homogeneous_Axis * axis;
  double settled_s;
  axis = &memory->state.estimates.x;
  settled_s = 0.0;
  for (int64_t i = 0; i < steps; i++) {
    differentiators_homogeneous_advance(&memory->settings, axis, speed * i * h, speed * (i + 1) * h, h, 1);
    if (fabs(axis->z[1] - speed) > 0.05 * speed) {
      settled_s = (i + 1) * h;
    }
  }
  return settled_s;
}

/* Largest speed in m/s long after the position stepped to ``place`` m and rests; spoils ``memory``. */
double differentiators_homogeneous_chatter(differentiators_homogeneous_Memory * memory, double place, double h, int64_t steps) {
  differentiators_homogeneous_Axis * axis;
  double fastest, speed;
  axis = &memory->state.estimates.x;
  differentiators_homogeneous_advance(&memory->settings, axis, place, place, h, steps);
  fastest = 0.0;
  for (int64_t i_1 = 0, end_2 = floor_divided_whole(steps, 4); i_1 < end_2; i_1++) {
    differentiators_homogeneous_advance(&memory->settings, axis, place, place, h, 1);
    speed = fabs(axis->z[1]);
    if (!(speed <= fastest)) {
      fastest = speed;
    }
  }
  return fastest;
}

/* The gains k_1 ... k_n: coefficients of (s + lambda)(s + lambda xi) ... (s + lambda xi^(n-1)). */
WIDE void differentiators_homogeneous_place_poles(differentiators_homogeneous_Settings * settings, double gain_lambda, double gain_xi) {
  double rate;
  for (int64_t i = 0, end_1 = (int64_t)settings->order; i < end_1; i++) {
    rate = gain_lambda * whole_power(gain_xi, i);
    for (int64_t j = i; j > 0; j--) {
      settings->gain[j] += rate * settings->gain[j - 1];
    }
    settings->gain[0] += rate;
  }
}

/* The settings of counts per inch (0: counts are not used), px per inch, gap and pause in s. */
void differentiators_sampling_fill(Vector values, Vector memory) {
  memory.p[0] = values.p[0] > 0.0 ? records_METRES_PER_INCH / values.p[0] : 0.0;
  memory.p[1] = records_METRES_PER_INCH / values.p[1];
  for (int64_t i = 2; i < values.n; i++) {
    memory.p[i] = values.p[i];
  }
}

/* The settings but for the settling time; between two samples the position runs on a line. */
void differentiators_homogeneous_fill(Vector values, differentiators_homogeneous_Settings * settings) {
  differentiators_sampling_fill(values, (Vector){(double *)settings, 17});
  settings->order = values.p[differentiators_homogeneous_ORDER_OF];
  settings->alpha = values.p[differentiators_homogeneous_ALPHA_OF];
  settings->step_s = values.p[differentiators_homogeneous_STEP_OF];
  settings->settle_s = 0.0;
  settings->hold = settings->settle_s;
  differentiators_homogeneous_place_poles(settings, values.p[differentiators_homogeneous_LAMBDA_OF], values.p[differentiators_homogeneous_XI_OF]);
}

/* Measure how long the law takes to settle, in a memory without states. */
void differentiators_homogeneous_settle(differentiators_homogeneous_Memory * memory) {
  double h;
  h = min_float(memory->settings.step_s, 0.001);
  memory->settings.settle_s = differentiators_homogeneous_settling(memory, differentiators_homogeneous_SETTLING_SPEED_M_S, h, (int64_t)floor(2.0 / h + 0.5));
  memset(&memory->state, 0, sizeof(differentiators_homogeneous_State));
}

/* The settings; of the noise in m its variance. */
void differentiators_kalman_fill(Vector values, differentiators_kalman_Settings * settings) {
  differentiators_sampling_fill(values, (Vector){(double *)settings, 6});
  settings->noise = settings->noise * settings->noise;
}

/* Both axes at the origin of the path, at a speed that nobody knows. */
void differentiators_kalman_restart(differentiators_kalman_Plane * plane, double noise) {
  memset(plane, 0, sizeof(differentiators_kalman_Plane));
  plane->covariance.p00 = noise;
  plane->covariance.p11 = square(differentiators_kalman_START_SPEED_M_S);
  plane->covariance.p22 = square(differentiators_kalman_START_ACCELERATION_M_S2);
}

/* Both axes and their covariance after ``dt`` s, and after their positions were measured. */
void differentiators_kalman_follow(differentiators_kalman_Plane * plane, double jerk_density, double noise, double dt, T2d place) {
  double u, v;
  u = place.f0;
  v = place.f1;
  differentiators_kalman_predict((Vector){plane->x, 3}, dt);
  differentiators_kalman_predict((Vector){plane->y, 3}, dt);
  differentiators_kalman_spread(&plane->covariance, jerk_density, dt);
  differentiators_kalman_correct((Vector){plane->x, 3}, &plane->covariance, noise, u);
  differentiators_kalman_correct((Vector){plane->y, 3}, &plane->covariance, noise, v);
  differentiators_kalman_narrow(&plane->covariance, noise);
}

/* Time that the stationary filter takes at the mean rate so far: 4 / (q / (r T))^(1/6). */
double differentiators_kalman_settle_s(differentiators_kalman_Settings * settings, differentiators_sampling_State * samples) {
  double intervals, period;
  intervals = max_float(samples->samples - 1.0, 1.0);
  period = (samples->t - samples->since) / intervals;
  return differentiators_kalman_SETTLED_RADIANS * pow(settings->noise * period / settings->jerk_density, 1.0 / 6.0);
}

void loop__stage_learn_nothing__records_event_at__differentiators_difference_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out) {
  T10d answer;
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      stage_learn_nothing(memory);
      fill((Vector){memory.p + first, memory.n - first}, 0.0);
    }
    answer = differentiators_difference_step((differentiators_difference_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
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
    answer = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
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
    answer = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    for (int64_t j = 0; j < 10; j++) {
      out.p[i * out.m + j] = ((const double *)&answer)[j];
    }
  }
}
