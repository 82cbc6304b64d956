/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const double records_METRES_PER_INCH = 0.0254;
static const double simulation_hand_CPI = 2000.0;
static const double simulation_hand_DPI = 96.0;
static const double simulation_hand_GAIN = 4.0;
static const double simulation_hand_M1 = 4294967087.0;
static const double simulation_hand_M2 = 4294944443.0;
static const double simulation_hand_PERIOD_S = 0.008;
static const int64_t simulation_hand_SUBSTEPS = 16;
static const int64_t simulation_hand_WARM_UP = 20;
static const double simulation_loop_BALLISTIC = 1.0;
static const int64_t simulation_loop_BISECTIONS = 40;
static const double simulation_loop_CORRECTIVE = 2.0;
static const double simulation_loop_DONE = 5.0;
static const double simulation_loop_LONGEST_M = 2.0;
static const double simulation_loop_NEAR_SHARE = 0.85;
static const int64_t simulation_loop_PIECES_MOST = 4;
static const double simulation_loop_PRESSING = 4.0;
static const int64_t simulation_loop_QUADRATURE = 16;
static const int64_t simulation_loop_RING_ROWS = 256;
static const double simulation_loop_SLOW_M_S = 0.008;
static const double simulation_loop_VERIFYING = 3.0;
static const double simulation_loop_WAITING = 0.0;
static const double simulation_loop_WANDER_S = 0.03;
static const double simulation_loop_WORTHWHILE_PX = 10.0;
static const int64_t simulation_person_NORMALS = 18;
static const double simulation_plan_FURTHER_PIECE = 0.55;
static const double simulation_plan_LATER_PIECE = 0.65;
static const double simulation_plan_MOST_AIM_OFF = 0.33;
static const double simulation_plan_PATIENCE_S = 5.0;
static const double simulation_plan_SMALLEST_PIECE_S = 0.16;
static const double transfer_functions_CONSTANT = 1.0;

/* The next number in (0, 1): MRG32k3a of L'Ecuyer (1999), whose products are exact in floats. */
double simulation_hand_uniform(simulation_hand_Stream * s) {
  double first, second, between;
  first = remainder_float(1403580.0 * s->one[1] - 810728.0 * s->one[0], simulation_hand_M1);
  second = remainder_float(527612.0 * s->two[2] - 1370589.0 * s->two[0], simulation_hand_M2);
  double value_1 = s->one[1];
  double value_2 = s->one[2];
  double value_3 = first;
  s->one[0] = value_1;
  s->one[1] = value_2;
  s->one[2] = value_3;
  double value_4 = s->two[1];
  double value_5 = s->two[2];
  double value_6 = second;
  s->two[0] = value_4;
  s->two[1] = value_5;
  s->two[2] = value_6;
  between = first > second ? first - second : first - second + simulation_hand_M1;
  return between / (simulation_hand_M1 + 1.0);
}

/* A standard normal number, by Box and Muller. */
double simulation_hand_normal(simulation_hand_Stream * s) {
  double length;
  length = sqrt(-2.0 * log(simulation_hand_uniform(s)));
  return length * cos(2.0 * 3.141592653589793 * simulation_hand_uniform(s));
}

/* Begin the generator with a whole number in [0, 2^31 - 3]. */
void simulation_hand_sow(simulation_hand_Stream * s, double seed) {
  double number;
  number = seed + 1.0;
  for (int64_t i = 0; i < 3; i++) {
    number = remainder_float(16807.0 * number, 2147483647.0);
    s->one[i] = number;
    number = remainder_float(16807.0 * number, 2147483647.0);
    s->two[i] = number;
  }
  for (int64_t i_1 = 0; i_1 < simulation_hand_WARM_UP; i_1++) {
    simulation_hand_uniform(s);
  }
}

/* A trait between a novice's and an expert's, scattered by a factor e^scatter. */
double simulation_person_between(double skill, double novice, double expert, double scatter) {
  return (novice + skill * (expert - novice)) * exp(scatter);
}

/* The traits of a person of a skill in [0, 1], from ``NORMALS`` standard normal numbers. */
void simulation_person_grow(simulation_person_Traits * traits, double skill, Vector normals) {
  Vector n;
  double buffer_1[18];
  n = (Vector){buffer_1, simulation_person_NORMALS};
  for (int64_t i = 0; i < simulation_person_NORMALS; i++) {
    n.p[i] = min_float(max_float(normals.p[i], -2.0), 2.0);
  }
  traits->skill = skill;
  traits->rate = simulation_person_between(skill, 7.5, 10.5, 0.08 * n.p[0]);
  traits->base_s = simulation_person_between(skill, 0.34, 0.24, 0.1 * n.p[1]);
  traits->per_bit_s = simulation_person_between(skill, 0.085, 0.06, 0.08 * n.p[2]);
  traits->one_piece = min_float(max_float(0.08 + 0.84 * skill, 0.0), 1.0);
  traits->reach = simulation_person_between(skill, 0.96, 0.98, 0.03 * n.p[3]);
  traits->reach_sd = simulation_person_between(skill, 0.12, 0.05, 0.1 * n.p[4]);
  traits->turn_sd = simulation_person_between(skill, 0.12, 0.05, 0.15 * n.p[5]);
  traits->curvature = (0.08 + 0.08 * (1.0 - skill)) * normals.p[6];
  traits->skew = min_float(max_float(0.1 + 0.08 * normals.p[7], -0.1), 0.4);
  traits->reaction_s = simulation_person_between(skill, 0.26, 0.2, 0.12 * n.p[8]);
  traits->pause_s = simulation_person_between(skill, 0.07, 0.03, 0.2 * n.p[9]);
  traits->verify_s = simulation_person_between(skill, 0.17, 0.1, 0.15 * n.p[10]);
  traits->press_s = simulation_person_between(skill, 0.095, 0.08, 0.15 * n.p[11]);
  traits->friction = 2.0 * simulation_person_between(skill, 1.05, 1.05, 0.06 * n.p[12]) * traits->rate;
  traits->delay_s = simulation_person_between(skill, 0.12, 0.095, 0.08 * n.p[13]);
  traits->muscle_s = simulation_person_between(skill, 0.024, 0.018, 0.1 * n.p[14]);
  traits->noise = simulation_person_between(skill, 0.035, 0.025, 0.15 * n.p[15]);
  traits->tremor_m_s = simulation_person_between(skill, 0.0007, 0.0004, 0.2 * n.p[16]);
  traits->aim_sd = simulation_person_between(skill, 0.16, 0.12, 0.1 * n.p[17]);
}

/* A person of a skill in [0, 1], drawn from the seed, with the mouse. */
void simulation_hand_begin(simulation_hand_Hand * hand, double seed, double skill) {
  Vector normals;
  simulation_loop_Settings * settings;
  double buffer_1[18];
  memset(hand, 0, sizeof(simulation_hand_Hand));
  simulation_hand_sow(&hand->stream, seed);
  normals = (Vector){buffer_1, simulation_person_NORMALS};
  for (int64_t i = 0; i < simulation_person_NORMALS; i++) {
    normals.p[i] = simulation_hand_normal(&hand->stream);
  }
  simulation_person_grow(&hand->traits, skill, normals);
  settings = &hand->trial.settings;
  settings->period_s = simulation_hand_PERIOD_S;
  settings->substeps = (double)simulation_hand_SUBSTEPS;
  settings->px_per_metre = simulation_hand_DPI / records_METRES_PER_INCH;
  settings->metres_per_count = records_METRES_PER_INCH / simulation_hand_CPI;
  settings->function.kind = transfer_functions_CONSTANT;
  settings->function.numbers[0] = simulation_hand_GAIN;
}

/* The chance in the next plan. */
void simulation_hand_draw(simulation_hand_Stream * s, simulation_person_Traits * traits, simulation_plan_Draws * draws) {
  int64_t count;
  simulation_plan_PieceDraws * piece;
  bool last;
  draws->friction = simulation_hand_normal(s);
  draws->rate = simulation_hand_normal(s);
  draws->aim_x = simulation_hand_normal(s);
  draws->aim_y = simulation_hand_normal(s);
  draws->reaction = simulation_hand_normal(s);
  draws->verify = simulation_hand_normal(s);
  draws->press = simulation_hand_normal(s);
  draws->count = 1.0;
  double value_1 = simulation_hand_uniform(s);
  double value_2 = traits->one_piece;
  if (value_1 >= value_2) {
    draws->count = 2.0;
    for (int64_t i_3 = 0; i_3 < (simulation_loop_PIECES_MOST - 2); i_3++) {
      double value_4 = simulation_hand_uniform(s);
      double value_5 = simulation_plan_FURTHER_PIECE * (1.0 - traits->skill);
      if (value_4 < value_5) {
        draws->count += 1.0;
      }
    }
  }
  count = (int64_t)draws->count;
  for (int64_t number = 0; number < count; number++) {
    piece = &draws->pieces[number];
    last = number == count - 1;
    piece->share = last ? simulation_hand_normal(s) : simulation_hand_uniform(s);
    piece->duration = simulation_hand_normal(s);
    piece->skew = simulation_hand_normal(s);
    piece->turn = simulation_hand_normal(s);
    piece->curve = simulation_hand_normal(s);
    piece->until = simulation_hand_uniform(s);
    piece->pause = last ? 0.0 : -log(simulation_hand_uniform(s));
  }
}

/* A factor near 1, bounded. */
double simulation_plan_varied(double spread, double normal) {
  return exp(spread * min_float(max_float(normal, -2.5), 2.5));
}

/* Share, duration, skew, turn, curvature, and when the next phase begins, of one piece. */
void simulation_plan_plan_piece(simulation_loop_Settings * settings, simulation_person_Traits * traits, simulation_plan_Draws * draws, int64_t number, double first_s) {
  simulation_loop_Piece * piece;
  simulation_plan_PieceDraws * d;
  bool last;
  double share, duration, until;
  piece = &settings->pieces[number];
  d = &draws->pieces[number];
  last = number == (int64_t)draws->count - 1;
  share = last ? traits->reach + traits->reach_sd * d->share : 0.6 + (0.88 - 0.6) * d->share;
  duration = first_s * (number == 0 ? 1.0 : simulation_plan_LATER_PIECE) * simulation_plan_varied(0.1, d->duration);
  duration = max_float(duration, simulation_plan_SMALLEST_PIECE_S);
  until = 0.78 + (0.94 - 0.78) * d->until;
  if (!last) {
    until = 0.9 + (1.0 - 0.9) * d->until + traits->pause_s * d->pause / duration;
  }
  piece->share = max_float(share, 0.3);
  piece->duration_s = duration;
  piece->skew = min_float(max_float(traits->skew + 0.08 * d->skew, -0.2), 0.6);
  piece->turn = traits->turn_sd * d->turn;
  piece->curve = traits->curvature + 0.4 * traits->turn_sd * d->curve;
  piece->until = min_float(until, 1.6);
}

/* Plan a movement to a target of ``width`` px, whose centre lies ``x y`` px from the start. */
void simulation_plan_plan(simulation_loop_Settings * settings, simulation_person_Traits * traits, simulation_plan_Draws * draws, double x, double y, double width) {
  double off_x, off_y, shrink, first_s;
  settings->b1 = traits->friction * simulation_plan_varied(0.05, draws->friction);
  settings->rate = traits->rate * simulation_plan_varied(0.08, draws->rate);
  settings->muscle_s = traits->muscle_s;
  settings->delay_s = traits->delay_s;
  settings->noise = traits->noise;
  settings->tremor = traits->tremor_m_s;
  settings->target_x = x;
  settings->target_y = y;
  settings->radius = 0.5 * width;
  off_x = draws->aim_x * traits->aim_sd * width;
  off_y = draws->aim_y * traits->aim_sd * width;
  shrink = min_float(1.0, simulation_plan_MOST_AIM_OFF * width / max_float(hypot(off_x, off_y), 1e-09));
  settings->aim_x = x + shrink * off_x;
  settings->aim_y = y + shrink * off_y;
  settings->reaction_s = traits->reaction_s * simulation_plan_varied(0.18, draws->reaction);
  settings->verify_s = traits->verify_s * simulation_plan_varied(0.25, draws->verify);
  settings->press_s = traits->press_s * simulation_plan_varied(0.15, draws->press);
  settings->patience_s = simulation_plan_PATIENCE_S;
  settings->count = draws->count;
  first_s = traits->base_s + traits->per_bit_s * log2(hypot(x, y) / width + 1.0);
  for (int64_t number = 0, end_1 = (int64_t)draws->count; number < end_1; number++) {
    simulation_plan_plan_piece(settings, traits, draws, number, first_s);
  }
}

/* Begin a movement to a target of ``width`` px, whose centre lies ``x y`` px from the cursor. */
void simulation_hand_aim(simulation_hand_Hand * hand, double x, double y, double width) {
  memset(&hand->trial.state, 0, sizeof(simulation_loop_State));
  simulation_hand_draw(&hand->stream, &hand->traits, &hand->draws);
  simulation_plan_plan(&hand->trial.settings, &hand->traits, &hand->draws, x, y, width);
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

/* Move for one period; the floats of a ``Report``. */
T5d simulation_hand_report(simulation_hand_Hand * hand) {
  double chance_x, chance_y;
  T14d poll;
  chance_x = simulation_hand_normal(&hand->stream);
  chance_y = simulation_hand_normal(&hand->stream);
  poll = simulation_loop_step(&hand->trial, (T5d){chance_x, chance_y, 0.0, NAN, NAN});
  return (T5d){poll.f0, poll.f1, poll.f2, poll.f5, poll.f12};
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
