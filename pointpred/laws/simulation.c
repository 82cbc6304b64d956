/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const double simulation_loop_BALLISTIC = 1.0;
static const int64_t simulation_loop_BISECTIONS = 40;
static const double simulation_loop_CORRECTIVE = 2.0;
static const double simulation_loop_DONE = 5.0;
static const double simulation_loop_LONGEST_M = 2.0;
static const double simulation_loop_NEAR_SHARE = 0.85;
static const double simulation_loop_PRESSING = 4.0;
static const int64_t simulation_loop_QUADRATURE = 16;
static const int64_t simulation_loop_RING_ROWS = 256;
static const double simulation_loop_SLOW_M_S = 0.008;
static const double simulation_loop_VERIFYING = 3.0;
static const double simulation_loop_WAITING = 0.0;
static const double simulation_loop_WANDER_S = 0.03;
static const double simulation_loop_WORTHWHILE_PX = 10.0;

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
double simulation_loop_cursor_distance(simulation_loop_Settings * settings, double amplitude, double duration) {
  double peak, total, weight;
  peak = 0.5 * 3.141592653589793 * amplitude / duration;
  total = 0.0;
  for (int64_t i = 1; i < simulation_loop_QUADRATURE; i++) {
    weight = remainder_whole(i, 2) == 1 ? 4.0 : 2.0;
    total = total + weight * transfer_functions_cursor_speed(&settings->function, peak * sin(3.141592653589793 * i / simulation_loop_QUADRATURE));
  }
  return settings->px_per_metre * duration * total / (3.0 * simulation_loop_QUADRATURE);
}

/* The amplitude (m) that moves the cursor by ``distance_px``: ``cursor_distance`` inverted. */
double simulation_loop_hand_distance(simulation_loop_Settings * settings, double distance_px, double duration) {
  double low, high, middle;
  low = 0.0;
  high = simulation_loop_LONGEST_M;
  for (int64_t i_1 = 0; i_1 < simulation_loop_BISECTIONS; i_1++) {
    middle = 0.5 * (low + high);
    if (simulation_loop_cursor_distance(settings, middle, duration) < distance_px) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return 0.5 * (low + high);
}

/* The open-loop force of the current piece: planned acceleration with friction compensated. */
T2d simulation_loop_ballistic_force(simulation_loop_Memory * memory, double t) {
  simulation_loop_Settings * settings;
  simulation_loop_State * s;
  simulation_loop_Piece * piece;
  double duration, curve, share, rate, bend, speed, along, across, angle;
  settings = &memory->settings;
  s = &memory->state;
  piece = &settings->pieces[(int64_t)s->number];
  duration = piece->duration_s;
  curve = piece->curve;
  T3d values_1 = simulation_loop_profile((t - s->since) / duration, piece->skew);
  share = values_1.f0;
  rate = values_1.f1;
  bend = values_1.f2;
  speed = s->amplitude * rate / duration;
  along = s->amplitude * bend / square(duration) + settings->b1 * speed;
  across = -2.0 * curve * (rate / duration) * speed;
  angle = s->angle + curve * (1.0 - 2.0 * share);
  return (T2d){along * cos(angle) - across * sin(angle), along * sin(angle) + across * cos(angle)};
}

/* The person's estimate of the cursor: its delayed sight, plus the hand's motion since. */
T2d simulation_loop_cursor_in_mind(simulation_loop_Memory * memory, double u, double v, double speed) {
  simulation_loop_Settings * settings;
  simulation_loop_State * s;
  int64_t late;
  simulation_loop_Sight * seen;
  double gain;
  settings = &memory->settings;
  s = &memory->state;
  late = (int64_t)(settings->delay_s / settings->period_s + 0.5);
  seen = &s->ring[remainder_whole((int64_t)s->tick - late, simulation_loop_RING_ROWS)];
  gain = transfer_functions_gain(&settings->function, speed) * settings->px_per_metre;
  return (T2d){seen->x + gain * (u - seen->u), seen->y + gain * (v - seen->v)};
}

/* V' of (2.1): friction -b1 V, and the force of the phase. */
T2d simulation_loop_acceleration(simulation_loop_Memory * memory, double t, simulation_loop_Place place) {
  simulation_loop_Settings * settings;
  simulation_loop_State * s;
  double x, y, u, v, vx, vy, b1, along_x, along_y, b2;
  settings = &memory->settings;
  s = &memory->state;
  x = place.x;
  y = place.y;
  u = place.u;
  v = place.v;
  vx = place.vx;
  vy = place.vy;
  b1 = settings->b1;
  if (s->phase == simulation_loop_BALLISTIC) {
    T2d values_1 = simulation_loop_ballistic_force(memory, t);
    along_x = values_1.f0;
    along_y = values_1.f1;
    return (T2d){along_x - b1 * vx, along_y - b1 * vy};
  }
  if (s->phase != simulation_loop_CORRECTIVE) {
    return (T2d){-b1 * vx, -b1 * vy};
  }
  if (settings->metres_per_count > 0.0) {
    T2d values_2 = simulation_loop_cursor_in_mind(memory, u, v, hypot(vx, vy));
    x = values_2.f0;
    y = values_2.f1;
  }
  b2 = s->feedback;
  return (T2d){-b1 * vx - b2 * (x - settings->aim_x), -b1 * vy - b2 * (y - settings->aim_y)};
}

/* The cursor's velocity of (2.1) without a sensor: (Vx, Vy) / |V| PTF(|V|), px/s. */
T2d simulation_loop_cursor_rate(simulation_loop_Settings * settings, double vx, double vy) {
  double scale;
  scale = settings->px_per_metre * transfer_functions_gain(&settings->function, hypot(vx, vy));
  return (T2d){scale * vx, scale * vy};
}

/* One step of h s by the midpoint rule; ``extra`` is the velocity of noise and tremor. */
void simulation_loop_advance(simulation_loop_Memory * memory, double t, double h, double extra_x, double extra_y) {
  simulation_loop_Settings * settings;
  simulation_loop_State * s;
  double keep, u, v, vx, vy, x, y, ax, ay, middle_x, middle_y, dx, dy, middle_u, middle_v, bx, by;
  bool continuous;
  settings = &memory->settings;
  s = &memory->state;
  keep = settings->muscle_s > 0.0 ? exp(-0.5 * h / settings->muscle_s) : 0.0;
  u = s->u;
  v = s->v;
  vx = s->vx;
  vy = s->vy;
  x = s->x;
  y = s->y;
  continuous = settings->metres_per_count == 0.0;
  T2d values_1 = simulation_loop_acceleration(memory, t, (simulation_loop_Place){x, y, u, v, vx, vy});
  ax = values_1.f0;
  ay = values_1.f1;
  ax = ax + keep * (s->ax - ax);
  ay = ay + keep * (s->ay - ay);
  middle_x = vx + 0.5 * h * ax;
  middle_y = vy + 0.5 * h * ay;
  if (continuous) {
    T2d values_2 = simulation_loop_cursor_rate(settings, vx + extra_x, vy + extra_y);
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
  s->ax = bx;
  s->ay = by;
  s->vx = vx + h * bx;
  s->vy = vy + h * by;
  s->u = u + h * (middle_x + extra_x);
  s->v = v + h * (middle_y + extra_y);
  if (continuous) {
    T2d values_4 = simulation_loop_cursor_rate(settings, middle_x + extra_x, middle_y + extra_y);
    dx = values_4.f0;
    dy = values_4.f1;
    s->x += h * dx;
    s->y += h * dy;
  }
}

/* Whole counts an axis has moved since the last report; the remainder carries over. */
double simulation_loop_count(double position_m, double metres_per_count, double counted) {
  return (double)(int64_t)trunc(position_m / metres_per_count - counted);
}

/* The pull of the assisted transfer function over one report period, px; 0 without an estimate. */
T2d simulation_loop_assist(simulation_loop_Memory * memory, double own_px, double hat_x, double hat_y) {
  simulation_loop_Settings * settings;
  simulation_loop_State * s;
  double off_x, off_y, rho, strength, share;
  settings = &memory->settings;
  s = &memory->state;
  off_x = hat_x - s->x;
  off_y = hat_y - s->y;
  rho = settings->rho;
  strength = settings->strength;
  share = transfer_assistance_pull(rho, strength, settings->period_s, own_px, off_x, off_y);
  return share > 0.0 ? (T2d){share * off_x, share * off_y} : (T2d){0.0, 0.0};
}

/* Poll the sensor: the counts of both axes; the cursor moves by whole pixels. */
T2d simulation_loop_report(simulation_loop_Memory * memory, double hat_x, double hat_y) {
  simulation_loop_Settings * settings;
  simulation_loop_State * s;
  double unit, dx, dy, gain, scale, pull_x, pull_y;
  settings = &memory->settings;
  s = &memory->state;
  unit = settings->metres_per_count;
  dx = simulation_loop_count(s->u, unit, s->counted_x);
  dy = simulation_loop_count(s->v, unit, s->counted_y);
  s->counted_x += dx;
  s->counted_y += dy;
  gain = transfer_functions_gain(&settings->function, hypot(dx, dy) * unit / settings->period_s);
  scale = gain * settings->px_per_metre * unit;
  T2d values_1 = simulation_loop_assist(memory, scale * hypot(dx, dy), hat_x, hat_y);
  pull_x = values_1.f0;
  pull_y = values_1.f1;
  double value_2 = s->x;
  double value_3 = transfer_pixels_carry(&s->carried, 0, scale * dx);
  s->x = value_2 + value_3;
  double value_4 = s->y;
  double value_5 = transfer_pixels_carry(&s->carried, 1, scale * dy);
  s->y = value_4 + value_5;
  double value_6 = s->x;
  double value_7 = transfer_pixels_carry(&s->pulled, 0, pull_x);
  s->x = value_6 + value_7;
  double value_8 = s->y;
  double value_9 = transfer_pixels_carry(&s->pulled, 1, pull_y);
  s->y = value_8 + value_9;
  return (T2d){dx, dy};
}

/* Begin a phase. */
void simulation_loop_enter(simulation_loop_State * s, double phase, double t) {
  s->phase = phase;
  s->since = t;
}

/* Begin the corrective phase; by default b2 follows from the gain at half the present speed. */
void simulation_loop_correct(simulation_loop_Memory * memory, double t) {
  simulation_loop_Settings * settings;
  simulation_loop_State * s;
  double gain;
  settings = &memory->settings;
  s = &memory->state;
  simulation_loop_enter(s, simulation_loop_CORRECTIVE, t);
  s->feedback = settings->b2;
  if (settings->b2 == 0.0) {
    gain = transfer_functions_gain(&settings->function, 0.5 * hypot(s->vx, s->vy));
    s->feedback = square(settings->rate) / (gain * settings->px_per_metre);
  }
}

/* Begin a piece towards its share of the remaining way; if that is too short, correct instead. */
void simulation_loop_launch(simulation_loop_Memory * memory, int64_t number, double t) {
  simulation_loop_Settings * settings;
  simulation_loop_State * s;
  double way_x, way_y, way, wanted;
  simulation_loop_Piece * piece;
  settings = &memory->settings;
  s = &memory->state;
  way_x = settings->aim_x - s->x;
  way_y = settings->aim_y - s->y;
  way = hypot(way_x, way_y);
  if (number >= settings->count || way < max_float(simulation_loop_WORTHWHILE_PX, 2.0 * settings->radius)) {
    simulation_loop_correct(memory, t);
    return;
  }
  simulation_loop_enter(s, simulation_loop_BALLISTIC, t);
  piece = &settings->pieces[number];
  s->number = (double)number;
  wanted = way * piece->share;
  s->amplitude = simulation_loop_hand_distance(settings, wanted, piece->duration_s);
  s->angle = atan2(way_y, way_x) + piece->turn;
}

/* The person's next phase: wait, move, move again, correct, verify, press, release. */
void simulation_loop_decide(simulation_loop_Memory * memory, double t) {
  simulation_loop_Settings * settings;
  simulation_loop_State * s;
  double phase, since, off;
  int64_t number;
  simulation_loop_Piece * piece;
  bool slow, arrived;
  settings = &memory->settings;
  s = &memory->state;
  phase = s->phase;
  since = s->since;
  if (phase == simulation_loop_WAITING && t >= settings->reaction_s) {
    simulation_loop_launch(memory, 0, t);
  } else if (phase == simulation_loop_BALLISTIC) {
    number = (int64_t)s->number;
    piece = &settings->pieces[number];
    if (t - since >= piece->until * piece->duration_s) {
      simulation_loop_launch(memory, number + 1, t);
    }
  } else if (phase == simulation_loop_CORRECTIVE) {
    off = hypot(s->x - settings->target_x, s->y - settings->target_y);
    slow = hypot(s->vx, s->vy) < simulation_loop_SLOW_M_S;
    arrived = slow && off < simulation_loop_NEAR_SHARE * settings->radius;
    if (arrived || t > settings->patience_s) {
      simulation_loop_enter(s, simulation_loop_VERIFYING, t);
    }
  } else if (phase == simulation_loop_VERIFYING && t - since >= settings->verify_s) {
    simulation_loop_enter(s, simulation_loop_PRESSING, t);
  } else if (phase == simulation_loop_PRESSING && t - since >= settings->press_s) {
    simulation_loop_enter(s, simulation_loop_DONE, t);
  }
}

/* One report period: decide, move the hand, poll the sensor, update the delayed sight. */
T14d simulation_loop_step(simulation_loop_Memory * memory, T5d chance) {
  simulation_loop_Settings * settings;
  simulation_loop_State * s;
  double noise_x, noise_y, late_s, hat_x, hat_y, period, now, keep, fresh, speed, size, extra_x, extra_y, before_x, before_y, h, dy, dx, own_px, pull_x, pull_y;
  int64_t substeps;
  simulation_loop_Sight * seen;
  settings = &memory->settings;
  s = &memory->state;
  simulation_loop_Chance values_1 = simulation_loop_Chance_of_T5d(chance);
  noise_x = values_1.noise_x;
  noise_y = values_1.noise_y;
  late_s = values_1.late_s;
  hat_x = values_1.hat_x;
  hat_y = values_1.hat_y;
  period = settings->period_s;
  now = s->tick * period;
  simulation_loop_decide(memory, now);
  keep = exp(-period / simulation_loop_WANDER_S);
  fresh = sqrt(1.0 - keep * keep);
  s->wander_x = keep * s->wander_x + fresh * noise_x;
  s->wander_y = keep * s->wander_y + fresh * noise_y;
  speed = hypot(s->vx, s->vy);
  size = settings->tremor + settings->noise * speed;
  extra_x = size * s->wander_x;
  extra_y = size * s->wander_y;
  before_x = s->x;
  before_y = s->y;
  substeps = (int64_t)settings->substeps;
  h = period / substeps;
  for (int64_t i = 0; i < substeps; i++) {
    simulation_loop_advance(memory, now + i * h, h, extra_x, extra_y);
  }
  dy = 0.0;
  dx = dy;
  if (settings->metres_per_count > 0.0) {
    T2d values_2 = simulation_loop_report(memory, hat_x, hat_y);
    dx = values_2.f0;
    dy = values_2.f1;
  } else {
    own_px = hypot(s->x - before_x, s->y - before_y);
    T2d values_3 = simulation_loop_assist(memory, own_px, hat_x, hat_y);
    pull_x = values_3.f0;
    pull_y = values_3.f1;
    s->x += pull_x;
    s->y += pull_y;
  }
  s->tick += 1.0;
  seen = &s->ring[remainder_whole((int64_t)s->tick, simulation_loop_RING_ROWS)];
  seen->x = s->x;
  seen->y = s->y;
  seen->u = s->u;
  seen->v = s->v;
  return (T14d){s->tick * period + late_s, s->x, s->y, dx, dy, s->phase == simulation_loop_PRESSING ? 1.0 : 0.0, s->u, s->v, s->vx + extra_x, s->vy + extra_y, s->ax, s->ay, s->phase, s->number};
}

/* Report after report, a ``Chance`` a row, until the button is released; returns how many there were. */
int64_t simulation_loop_play(simulation_loop_Memory * memory, Table rows, Table out) {
  Vector r;
  T14d answer;
  for (int64_t i = 0; i < rows.n; i++) {
    r = (Vector){rows.p + i * rows.m, rows.m};
    answer = simulation_loop_step(memory, (T5d){r.p[0], r.p[1], r.p[2], r.p[3], r.p[4]});
    for (int64_t j = 0; j < 14; j++) {
      out.p[i * out.m + j] = ((const double *)&answer)[j];
    }
    if (memory->state.phase == simulation_loop_DONE) {
      return i + 1;
    }
  }
  return rows.n;
}
