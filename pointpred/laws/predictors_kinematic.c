/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const int64_t predictors_kinematic_features_A_ACROSS = 51;
static const int64_t predictors_kinematic_features_A_ALONG = 10;
static const int64_t predictors_kinematic_features_BRAKE = 20;
static const int64_t predictors_kinematic_features_CURSOR_PEAK = 6;
static const int64_t predictors_kinematic_features_DISTANCE = 3;
static const int64_t predictors_kinematic_features_FALLING = 27;
static const int64_t predictors_kinematic_features_FEATURES = 65;
static const int64_t predictors_kinematic_features_HEAD_BEFORE = 67;
static const int64_t predictors_kinematic_features_HISTORY = 71;
static const int64_t predictors_kinematic_features_JERK_AHEAD = 30;
static const T12d predictors_kinematic_features_LAGS_S = {0.01, 0.02, 0.03, 0.045, 0.065, 0.09, 0.12, 0.16, 0.21, 0.28, 0.37, 0.5};
static const int64_t predictors_kinematic_features_LAG_ACROSS = 53;
static const int64_t predictors_kinematic_features_LAG_ALONG = 38;
static const int64_t predictors_kinematic_features_LOG_MEAN = 35;
static const int64_t predictors_kinematic_features_LOG_PEAK = 7;
static const int64_t predictors_kinematic_features_LOG_REACH = 0;
static const int64_t predictors_kinematic_features_LOG_SPEED = 8;
static const int64_t predictors_kinematic_features_LOG_TIME = 1;
static const int64_t predictors_kinematic_features_MEAN_OF_PEAK = 18;
static const int64_t predictors_kinematic_features_ODD = 50;
static const int64_t predictors_kinematic_features_PEAK_DISTANCE = 16;
static const int64_t predictors_kinematic_features_PEAK_PATH = 17;
static const int64_t predictors_kinematic_features_PEAK_SHARE = 14;
static const int64_t predictors_kinematic_features_PEAK_TIME = 15;
static const int64_t predictors_kinematic_features_PUSH = 19;
static const double predictors_kinematic_features_REACH_S = 0.06;
static const int64_t predictors_kinematic_features_RETURN = 5;
static const int64_t predictors_kinematic_features_SINCE_PEAK = 13;
static const int64_t predictors_kinematic_features_SINCE_PUSH = 21;
static const int64_t predictors_kinematic_features_SINCE_SUB = 23;
static const int64_t predictors_kinematic_features_SINCE_SUB_PEAK = 26;
static const int64_t predictors_kinematic_features_SLOWER_FOR = 33;
static const int64_t predictors_kinematic_features_SLOW_FOR = 32;
static const double predictors_kinematic_features_SOON_S = 0.1;
static const int64_t predictors_kinematic_features_SPEED_OF_PEAK = 11;
static const int64_t predictors_kinematic_features_SPEED_OF_SUB = 25;
static const int64_t predictors_kinematic_features_STILL_FOR = 34;
static const int64_t predictors_kinematic_features_STOP_TIME = 36;
static const int64_t predictors_kinematic_features_STOP_WAY = 37;
static const int64_t predictors_kinematic_features_STRAIGHTNESS = 4;
static const int64_t predictors_kinematic_features_SUBS = 22;
static const int64_t predictors_kinematic_features_SUB_ACROSS = 52;
static const int64_t predictors_kinematic_features_SUB_ALONG = 28;
static const int64_t predictors_kinematic_features_SUB_JERK_AHEAD = 31;
static const int64_t predictors_kinematic_features_SUB_PATH = 29;
static const int64_t predictors_kinematic_features_SUB_PEAK = 24;
static const int64_t predictors_kinematic_features_TIME = 2;
static const int64_t predictors_kinematic_features_TRACK = 9;
static const int64_t predictors_kinematic_features_TRACK_BEFORE = 38;
static const int64_t predictors_kinematic_features_V_ACROSS = 50;
static const int64_t predictors_kinematic_features_V_ALIGNED = 12;
static const int64_t predictors_kinematic_features_V_ALONG = 9;
static const int64_t predictors_kinematic_history_COUNT = 0;
static const int64_t predictors_kinematic_history_HEAD = 4;
static const int64_t predictors_kinematic_history_LAST_PATH = 3;
static const int64_t predictors_kinematic_history_LAST_X = 1;
static const int64_t predictors_kinematic_history_LAST_Y = 2;
static const int64_t predictors_kinematic_history_RING = 4;
static const double predictors_kinematic_history_STILL_GAP_S = 0.1;
static const int64_t predictors_kinematic_history_TICKS = 66;
static const double predictors_kinematic_history_TICK_S = 0.008;
static const int64_t predictors_kinematic_network_ACROSS = 1;
static const int64_t predictors_kinematic_network_ALONG = 0;
static const int64_t predictors_kinematic_network_BASES = 5;
static const int64_t predictors_kinematic_network_BASIS = 2;
static const T5q predictors_kinematic_network_BASIS_ACROSS = {50, 55, 57, 60, 52};
static const T5q predictors_kinematic_network_BASIS_ALONG = {9, 40, 42, 45, 28};
static const int64_t predictors_kinematic_network_BROAD = 8;
static const double predictors_kinematic_network_EXTREME = 6.0;
static const int64_t predictors_kinematic_network_FACTORS = 3;
static const int64_t predictors_kinematic_network_FIRST = 0;
static const double predictors_kinematic_network_GATE_SLOPE = 0.16666666666666666;
static const int64_t predictors_kinematic_network_HEAD = 2;
static const double predictors_kinematic_network_HEAD_START_S = 0.05;
static const int64_t predictors_kinematic_network_KNOTS = 10;
static const int64_t predictors_kinematic_network_LEFT = 10;
static const T2d predictors_kinematic_network_LEFT_LOGS = {-6.0, 4.0};
static const int64_t predictors_kinematic_network_OUTPUTS = 12;
static const int64_t predictors_kinematic_network_SECOND = 1;
static const T2q predictors_kinematic_network_SIDES = {57, 60};
static const double predictors_kinematic_network_SIDE_SOFT = 0.01;
static const int64_t predictors_kinematic_network_SPREAD = 11;
static const int64_t predictors_kinematic_network_SPREAD_FACTOR = 2;
static const T2d predictors_kinematic_network_SPREAD_LOGS = {-3.0, 1.5};
static const int64_t predictors_kinematic_network_TAIL = 9;
static const int64_t predictors_kinematic_network_TAIL_FACTOR = 1;
static const T2d predictors_kinematic_network_TAIL_LOGS = {0.3, 4.0};
static const int64_t predictors_kinematic_network_WIDE = 7;
static const int64_t predictors_kinematic_network_WIDTH_FACTOR = 0;
static const T2d predictors_kinematic_network_WIDTH_LOGS = {-9.0, 4.0};
static const int64_t predictors_kinematic_predictor_AT = 0;
static const int64_t predictors_kinematic_submovements_COUNT = 0;
static const double predictors_kinematic_submovements_FALLEN = 0.7;
static const int64_t predictors_kinematic_submovements_FALLING = 7;
static const int64_t predictors_kinematic_submovements_LOW = 8;
static const int64_t predictors_kinematic_submovements_LOW_PATH = 12;
static const int64_t predictors_kinematic_submovements_LOW_T = 9;
static const int64_t predictors_kinematic_submovements_LOW_X = 10;
static const int64_t predictors_kinematic_submovements_LOW_Y = 11;
static const int64_t predictors_kinematic_submovements_PATH = 4;
static const int64_t predictors_kinematic_submovements_PEAK = 5;
static const int64_t predictors_kinematic_submovements_PEAK_T = 6;
static const double predictors_kinematic_submovements_REST_M_S = 1e-06;
static const double predictors_kinematic_submovements_RISEN = 1.4;
static const double predictors_kinematic_submovements_RISE_M_S = 0.005;
static const double predictors_kinematic_submovements_RISE_SHARE = 0.02;
static const int64_t predictors_kinematic_submovements_T = 1;
static const int64_t predictors_kinematic_submovements_X = 2;
static const int64_t predictors_kinematic_submovements_Y = 3;
static const int64_t predictors_kinematic_track_BRAKE = 12;
static const int64_t predictors_kinematic_track_CURSOR_PEAK = 5;
static const int64_t predictors_kinematic_track_FAR = 4;
static const int64_t predictors_kinematic_track_FAST_T = 26;
static const int64_t predictors_kinematic_track_MOVED_T = 28;
static const int64_t predictors_kinematic_track_MOVING_T = 27;
static const int64_t predictors_kinematic_track_PEAK = 6;
static const int64_t predictors_kinematic_track_PEAK_D = 8;
static const int64_t predictors_kinematic_track_PEAK_PATH = 9;
static const int64_t predictors_kinematic_track_PEAK_T = 7;
static const int64_t predictors_kinematic_track_PUSH = 10;
static const int64_t predictors_kinematic_track_PUSH_T = 11;
static const double predictors_kinematic_track_SLOW = 0.2;
static const double predictors_kinematic_track_SLOWER = 0.05;
static const double predictors_kinematic_track_SPAN_S = 0.05;
static const int64_t predictors_kinematic_track_STATES = 29;
static const int64_t predictors_kinematic_track_SUBMOVEMENT = 13;
static const int64_t predictors_kinematic_track_T = 0;
static const int64_t predictors_kinematic_track_WAY = 3;
static const int64_t predictors_kinematic_track_X = 1;
static const int64_t predictors_kinematic_track_Y = 2;
static const int64_t records_EVENT_FIELD = 2;
static const int64_t records_FINE = 0;

/* Remember the start: tick 0 is the origin. */
void predictors_kinematic_history_begin(Vector memory, int64_t at) {
  memory.p[at + predictors_kinematic_history_COUNT] = 1.0;
  fill((Vector){memory.p + (at + predictors_kinematic_history_LAST_X), at + predictors_kinematic_history_RING + 3 - (at + predictors_kinematic_history_LAST_X)}, 0.0);
}

/* Copy the track before a new time; go back to the copy where a sample of the same time comes again. */
void predictors_kinematic_features_rewind(Vector memory, int64_t at, bool again) {
  int64_t source, head, target, head_target;
  T2q values_1 = again ? (T2q){predictors_kinematic_features_TRACK_BEFORE, predictors_kinematic_features_HEAD_BEFORE} : (T2q){predictors_kinematic_features_TRACK, predictors_kinematic_features_HISTORY};
  source = values_1.f0;
  head = values_1.f1;
  T2q values_2 = again ? (T2q){predictors_kinematic_features_TRACK, predictors_kinematic_features_HISTORY} : (T2q){predictors_kinematic_features_TRACK_BEFORE, predictors_kinematic_features_HEAD_BEFORE};
  target = values_2.f0;
  head_target = values_2.f1;
  for (int64_t i = 0; i < predictors_kinematic_track_STATES; i++) {
    memory.p[at + target + i] = memory.p[at + source + i];
  }
  for (int64_t i = 0; i < predictors_kinematic_history_HEAD; i++) {
    memory.p[at + head_target + i] = memory.p[at + head + i];
  }
}

/* Fill the ticks after the last one up to now, on the line from the last event (t, x, y) to this one. */
history_Point predictors_kinematic_history_extend(Vector memory, int64_t at, T3d last, T3d now) {
  double last_t, last_x, last_y, t, x, y, old_x, old_y, path, share, new_x, new_y;
  int64_t count, newest, slot;
  last_t = last.f0;
  last_x = last.f1;
  last_y = last.f2;
  t = now.f0;
  x = now.f1;
  y = now.f2;
  count = (int64_t)memory.p[at + predictors_kinematic_history_COUNT];
  newest = (int64_t)floor(t / predictors_kinematic_history_TICK_S);
  old_x = memory.p[at + predictors_kinematic_history_LAST_X];
  old_y = memory.p[at + predictors_kinematic_history_LAST_Y];
  path = memory.p[at + predictors_kinematic_history_LAST_PATH];
  for (int64_t tick = max_whole(count, newest + 1 - predictors_kinematic_history_TICKS), end_1 = newest + 1; tick < end_1; tick++) {
    share = 0.0;
    if (t - last_t <= predictors_kinematic_history_STILL_GAP_S) {
      share = min_float(max_float((tick * predictors_kinematic_history_TICK_S - last_t) / (t - last_t), 0.0), 1.0);
    }
    new_x = last_x + share * (x - last_x);
    new_y = last_y + share * (y - last_y);
    path += hypot(new_x - old_x, new_y - old_y);
    slot = at + predictors_kinematic_history_RING + 3 * remainder_whole(tick, predictors_kinematic_history_TICKS);
    memory.p[slot] = new_x;
    memory.p[slot + 1] = new_y;
    memory.p[slot + 2] = path;
    old_x = new_x;
    old_y = new_y;
  }
  memory.p[at + predictors_kinematic_history_COUNT] = max_whole(count, newest + 1);
  memory.p[at + predictors_kinematic_history_LAST_X] = old_x;
  memory.p[at + predictors_kinematic_history_LAST_Y] = old_y;
  memory.p[at + predictors_kinematic_history_LAST_PATH] = path;
  return (history_Point){t, x, y, path + hypot(x - old_x, y - old_y)};
}

/* Place and path ``ago`` seconds before now: between two ticks on a line, the start before it. */
T3d predictors_kinematic_history_past(Vector memory, int64_t at, history_Point now, double ago) {
  double then, span, share, after_x, after_y, after_path;
  int64_t count, tick, slot, after;
  then = now.t - ago;
  if (then <= 0.0) {
    return (T3d){0.0, 0.0, 0.0};
  }
  count = (int64_t)memory.p[at + predictors_kinematic_history_COUNT];
  tick = (int64_t)floor(then / predictors_kinematic_history_TICK_S);
  if (tick > count - 1) {
    return (T3d){now.x, now.y, now.path};
  }
  slot = at + predictors_kinematic_history_RING + 3 * remainder_whole(tick, predictors_kinematic_history_TICKS);
  if (tick == count - 1) {
    span = now.t - tick * predictors_kinematic_history_TICK_S;
    share = span > 0.0 ? (then - tick * predictors_kinematic_history_TICK_S) / span : 1.0;
    after_x = now.x;
    after_y = now.y;
    after_path = now.path;
  } else {
    share = (then - tick * predictors_kinematic_history_TICK_S) / predictors_kinematic_history_TICK_S;
    after = at + predictors_kinematic_history_RING + 3 * remainder_whole(tick + 1, predictors_kinematic_history_TICKS);
    after_x = memory.p[after];
    after_y = memory.p[after + 1];
    after_path = memory.p[after + 2];
  }
  return (T3d){memory.p[slot] + share * (after_x - memory.p[slot]), memory.p[slot + 1] + share * (after_y - memory.p[slot + 1]), memory.p[slot + 2] + share * (after_path - memory.p[slot + 2])};
}

/* Divide the movement at the valleys of its speed. */
void predictors_kinematic_submovements_divide(Vector memory, int64_t at, history_Point point, double speed, double movement_peak) {
  if (memory.p[at + predictors_kinematic_submovements_FALLING] == 0.0) {
    if (speed > memory.p[at + predictors_kinematic_submovements_PEAK]) {
      memory.p[at + predictors_kinematic_submovements_PEAK] = speed;
      memory.p[at + predictors_kinematic_submovements_PEAK_T] = point.t;
    } else if (speed < predictors_kinematic_submovements_FALLEN * memory.p[at + predictors_kinematic_submovements_PEAK]) {
      memory.p[at + predictors_kinematic_submovements_FALLING] = 1.0;
      memory.p[at + predictors_kinematic_submovements_LOW] = 2.0 * speed;
    }
  }
  if (memory.p[at + predictors_kinematic_submovements_FALLING] == 0.0) {
    return;
  }
  if (speed < memory.p[at + predictors_kinematic_submovements_LOW] - predictors_kinematic_submovements_REST_M_S) {
    memory.p[at + predictors_kinematic_submovements_LOW] = speed;
    memory.p[at + predictors_kinematic_submovements_LOW_T] = point.t;
    memory.p[at + predictors_kinematic_submovements_LOW_X] = point.x;
    memory.p[at + predictors_kinematic_submovements_LOW_Y] = point.y;
    memory.p[at + predictors_kinematic_submovements_LOW_PATH] = point.path;
  } else if (speed > predictors_kinematic_submovements_RISEN * memory.p[at + predictors_kinematic_submovements_LOW] + predictors_kinematic_submovements_RISE_SHARE * movement_peak + predictors_kinematic_submovements_RISE_M_S) {
    memory.p[at + predictors_kinematic_submovements_FALLING] = 0.0;
    memory.p[at + predictors_kinematic_submovements_COUNT] += 1.0;
    double value_1 = memory.p[at + predictors_kinematic_submovements_LOW_T];
    double value_2 = memory.p[at + predictors_kinematic_submovements_LOW_PATH];
    memory.p[at + predictors_kinematic_submovements_T] = value_1;
    memory.p[at + predictors_kinematic_submovements_PATH] = value_2;
    double value_3 = memory.p[at + predictors_kinematic_submovements_LOW_X];
    double value_4 = memory.p[at + predictors_kinematic_submovements_LOW_Y];
    memory.p[at + predictors_kinematic_submovements_X] = value_3;
    memory.p[at + predictors_kinematic_submovements_Y] = value_4;
    memory.p[at + predictors_kinematic_submovements_PEAK] = speed;
    memory.p[at + predictors_kinematic_submovements_PEAK_T] = point.t;
  }
}

/* Take one sample in: where the cursor is, the hand's motion, the cursor's speed in px/s. */
void predictors_kinematic_track_advance(Vector memory, int64_t at, history_Point point, records_MotionRow hand, double cursor_speed) {
  double t, x, y, path, speed, d, push;
  t = point.t;
  x = point.x;
  y = point.y;
  path = point.path;
  speed = hypot(hand.vx, hand.vy);
  d = hypot(x, y);
  if (x != memory.p[at + predictors_kinematic_track_X] || y != memory.p[at + predictors_kinematic_track_Y]) {
    memory.p[at + predictors_kinematic_track_MOVED_T] = t;
  }
  memory.p[at + predictors_kinematic_track_WAY] += speed * (t - memory.p[at + predictors_kinematic_track_T]);
  memory.p[at + predictors_kinematic_track_T] = t;
  memory.p[at + predictors_kinematic_track_X] = x;
  memory.p[at + predictors_kinematic_track_Y] = y;
  memory.p[at + predictors_kinematic_track_FAR] = max_float(memory.p[at + predictors_kinematic_track_FAR], d);
  memory.p[at + predictors_kinematic_track_CURSOR_PEAK] = max_float(memory.p[at + predictors_kinematic_track_CURSOR_PEAK], cursor_speed);
  if (speed > memory.p[at + predictors_kinematic_track_PEAK]) {
    memory.p[at + predictors_kinematic_track_PEAK] = speed;
    memory.p[at + predictors_kinematic_track_PEAK_T] = t;
    memory.p[at + predictors_kinematic_track_PEAK_D] = d;
    memory.p[at + predictors_kinematic_track_PEAK_PATH] = path;
  }
  push = d > 0.0 ? (hand.ax * x + hand.ay * y) / d : 0.0;
  if (push > memory.p[at + predictors_kinematic_track_PUSH]) {
    memory.p[at + predictors_kinematic_track_PUSH] = push;
    memory.p[at + predictors_kinematic_track_PUSH_T] = t;
  }
  memory.p[at + predictors_kinematic_track_BRAKE] = min_float(memory.p[at + predictors_kinematic_track_BRAKE], push);
  if (speed >= predictors_kinematic_track_SLOW * memory.p[at + predictors_kinematic_track_PEAK]) {
    memory.p[at + predictors_kinematic_track_FAST_T] = t;
  }
  if (speed >= predictors_kinematic_track_SLOWER * memory.p[at + predictors_kinematic_track_PEAK]) {
    memory.p[at + predictors_kinematic_track_MOVING_T] = t;
  }
  predictors_kinematic_submovements_divide(memory, at + predictors_kinematic_track_SUBMOVEMENT, point, speed, memory.p[at + predictors_kinematic_track_PEAK]);
}

/* Take one motion in: its fault, and where the cursor is. */
Tq_history_Point_ predictors_kinematic_features_follow(Vector memory, int64_t at, records_MotionRow m) {
  double started, last_t, t0, x0, y0, path_before;
  int64_t fault, here;
  bool new;
  T3d last;
  history_Point point;
  started = ((predictors_movement_State *)(memory.p + at))->known;
  last_t = ((predictors_movement_State *)(memory.p + at))->t;
  Tqbd values_1 = predictors_movement_follow((predictors_movement_State *)(memory.p + at), m);
  fault = values_1.f0;
  new = values_1.f1;
  if (fault != records_FINE) {
    return (Tq_history_Point_){fault, (history_Point){0.0, 0.0, 0.0, 0.0}};
  }
  if (new || m.t == ((predictors_movement_State *)(memory.p + at))->t0) {
    fill((Vector){memory.p + (at + predictors_kinematic_features_TRACK), at + predictors_kinematic_features_HISTORY - (at + predictors_kinematic_features_TRACK)}, 0.0);
    predictors_kinematic_history_begin(memory, at + predictors_kinematic_features_HISTORY);
  } else {
    predictors_kinematic_features_rewind(memory, at, started == 1.0 && m.t == last_t);
  }
  here = at + predictors_kinematic_features_TRACK;
  last = (T3d){memory.p[here + predictors_kinematic_track_T], memory.p[here + predictors_kinematic_track_X], memory.p[here + predictors_kinematic_track_Y]};
  t0 = ((predictors_movement_State *)(memory.p + at))->t0;
  x0 = ((predictors_movement_State *)(memory.p + at))->x0;
  y0 = ((predictors_movement_State *)(memory.p + at))->y0;
  point = predictors_kinematic_history_extend(memory, at + predictors_kinematic_features_HISTORY, last, (T3d){m.t - t0, m.x - x0, m.y - y0});
  T3d values_2 = predictors_kinematic_history_past(memory, at + predictors_kinematic_features_HISTORY, point, predictors_kinematic_track_SPAN_S);
  path_before = values_2.f2;
  predictors_kinematic_track_advance(memory, here, point, m, (point.path - path_before) / predictors_kinematic_track_SPAN_S);
  return (Tq_history_Point_){records_FINE, point};
}

/* From the start to the cursor; at the start the hand's, without one along x. */
T2d predictors_kinematic_features_direction(double x, double y, double vx, double vy) {
  double d, speed;
  d = hypot(x, y);
  if (d > 0.0) {
    return (T2d){x / d, y / d};
  }
  speed = hypot(vx, vy);
  if (speed > 0.0) {
    return (T2d){vx / speed, vy / speed};
  }
  return (T2d){1.0, 0.0};
}

/* The frame of the movement so far; ``at``: its track. */
features_Frame predictors_kinematic_features_frame_of(Vector memory, int64_t at, history_Point point, records_MotionRow m) {
  double ux, uy, reach;
  T2d values_1 = predictors_kinematic_features_direction(point.x, point.y, m.vx, m.vy);
  ux = values_1.f0;
  uy = values_1.f1;
  if (!(point.path > 0.0)) {
    return (features_Frame){0.0, 0.0, ux, uy};
  }
  reach = point.path + predictors_kinematic_features_REACH_S * memory.p[at + predictors_kinematic_track_CURSOR_PEAK];
  return (features_Frame){reach, memory.p[at + predictors_kinematic_track_WAY] + predictors_kinematic_features_REACH_S * memory.p[at + predictors_kinematic_track_PEAK] + 0.0001, ux, uy};
}

/* Features of the way so far: its length, its peak, its sub-movements. */
void predictors_kinematic_features_fill_shape(Vector memory, int64_t at, history_Point point, features_Frame frame, Vector out) {
  double t, x, y, path, reach, hand, d, peak;
  int64_t sub;
  t = point.t;
  x = point.x;
  y = point.y;
  path = point.path;
  reach = frame.reach;
  hand = frame.hand;
  sub = at + predictors_kinematic_track_SUBMOVEMENT;
  d = hypot(x, y);
  peak = memory.p[at + predictors_kinematic_track_PEAK] + 1e-09;
  out.p[predictors_kinematic_features_LOG_REACH] = log(hand);
  out.p[predictors_kinematic_features_LOG_TIME] = log(t + 0.02);
  out.p[predictors_kinematic_features_TIME] = t;
  out.p[predictors_kinematic_features_DISTANCE] = d / reach;
  out.p[predictors_kinematic_features_STRAIGHTNESS] = d / path;
  out.p[predictors_kinematic_features_RETURN] = d / max_float(memory.p[at + predictors_kinematic_track_FAR], 1e-09);
  out.p[predictors_kinematic_features_CURSOR_PEAK] = memory.p[at + predictors_kinematic_track_CURSOR_PEAK] * predictors_kinematic_features_SOON_S / reach;
  out.p[predictors_kinematic_features_LOG_PEAK] = log(memory.p[at + predictors_kinematic_track_PEAK] + 0.0003);
  out.p[predictors_kinematic_features_SINCE_PEAK] = t - memory.p[at + predictors_kinematic_track_PEAK_T];
  out.p[predictors_kinematic_features_PEAK_SHARE] = memory.p[at + predictors_kinematic_track_PEAK_T] / (t + 0.001);
  out.p[predictors_kinematic_features_PEAK_TIME] = memory.p[at + predictors_kinematic_track_PEAK_T];
  out.p[predictors_kinematic_features_PEAK_DISTANCE] = memory.p[at + predictors_kinematic_track_PEAK_D] / reach;
  out.p[predictors_kinematic_features_PEAK_PATH] = memory.p[at + predictors_kinematic_track_PEAK_PATH] / path;
  out.p[predictors_kinematic_features_MEAN_OF_PEAK] = memory.p[at + predictors_kinematic_track_WAY] / (t + 0.001) / peak;
  out.p[predictors_kinematic_features_PUSH] = memory.p[at + predictors_kinematic_track_PUSH] * predictors_kinematic_features_SOON_S * 0.1 / hand;
  out.p[predictors_kinematic_features_BRAKE] = memory.p[at + predictors_kinematic_track_BRAKE] * predictors_kinematic_features_SOON_S * 0.1 / hand;
  out.p[predictors_kinematic_features_SINCE_PUSH] = t - memory.p[at + predictors_kinematic_track_PUSH_T];
  out.p[predictors_kinematic_features_SUBS] = min_float(memory.p[sub + predictors_kinematic_submovements_COUNT], 6.0);
  out.p[predictors_kinematic_features_SINCE_SUB] = t - memory.p[sub + predictors_kinematic_submovements_T];
  out.p[predictors_kinematic_features_SUB_PEAK] = memory.p[sub + predictors_kinematic_submovements_PEAK] / peak;
  out.p[predictors_kinematic_features_SINCE_SUB_PEAK] = t - memory.p[sub + predictors_kinematic_submovements_PEAK_T];
  out.p[predictors_kinematic_features_FALLING] = memory.p[sub + predictors_kinematic_submovements_FALLING];
  out.p[predictors_kinematic_features_SUB_PATH] = (path - memory.p[sub + predictors_kinematic_submovements_PATH]) / reach;
  out.p[predictors_kinematic_features_SLOW_FOR] = t - memory.p[at + predictors_kinematic_track_FAST_T];
  out.p[predictors_kinematic_features_SLOWER_FOR] = t - memory.p[at + predictors_kinematic_track_MOVING_T];
  out.p[predictors_kinematic_features_STILL_FOR] = t - memory.p[at + predictors_kinematic_track_MOVED_T];
  out.p[predictors_kinematic_features_LOG_MEAN] = log(memory.p[at + predictors_kinematic_track_WAY] / (t + 0.01) + 0.0003);
}

/* What a minimum-jerk movement has ahead as a share of its way done, from speed over peak. */
double predictors_kinematic_features_ahead(double ratio) {
  double done;
  T2d values_1 = predictors_minimum_jerk_progress(ratio);
  done = values_1.f1;
  return (1.0 - done) / done;
}

/* Features of the present motion: against its peaks, across the direction, and what it says is left. */
void predictors_kinematic_features_fill_pace(Vector memory, int64_t at, history_Point point, records_MotionRow m, features_Frame frame, Vector out) {
  double reach, hand, ux, uy, sub_x, sub_y, peak, sub_peak, v, v_along, a_along, of_peak, of_sub, braking;
  int64_t sub;
  reach = frame.reach;
  hand = frame.hand;
  ux = frame.ux;
  uy = frame.uy;
  sub = at + predictors_kinematic_track_SUBMOVEMENT;
  sub_x = point.x - memory.p[sub + predictors_kinematic_submovements_X];
  sub_y = point.y - memory.p[sub + predictors_kinematic_submovements_Y];
  peak = memory.p[at + predictors_kinematic_track_PEAK] + 1e-09;
  sub_peak = memory.p[sub + predictors_kinematic_submovements_PEAK] + 1e-09;
  v = hypot(m.vx, m.vy);
  v_along = m.vx * ux + m.vy * uy;
  a_along = m.ax * ux + m.ay * uy;
  out.p[predictors_kinematic_features_LOG_SPEED] = log(v + 0.003);
  out.p[predictors_kinematic_features_V_ALONG] = v_along * predictors_kinematic_features_SOON_S / hand;
  out.p[predictors_kinematic_features_A_ALONG] = a_along * predictors_kinematic_features_SOON_S * 0.1 / hand;
  out.p[predictors_kinematic_features_SPEED_OF_PEAK] = v / peak;
  out.p[predictors_kinematic_features_V_ALIGNED] = v_along / (v + 1e-06);
  out.p[predictors_kinematic_features_SPEED_OF_SUB] = v / sub_peak;
  of_peak = point.t > memory.p[at + predictors_kinematic_track_PEAK_T] ? v / peak : 1.0;
  of_sub = point.t > memory.p[sub + predictors_kinematic_submovements_PEAK_T] ? v / sub_peak : 1.0;
  out.p[predictors_kinematic_features_JERK_AHEAD] = predictors_kinematic_features_ahead(of_peak) * hypot(point.x, point.y) / reach;
  out.p[predictors_kinematic_features_SUB_JERK_AHEAD] = predictors_kinematic_features_ahead(of_sub) * hypot(sub_x, sub_y) / reach;
  braking = max_float(-a_along, 0.001);
  out.p[predictors_kinematic_features_STOP_TIME] = min_float(1.0, max_float(-1.0, v_along / braking));
  out.p[predictors_kinematic_features_STOP_WAY] = min_float(4.0, v_along * v_along / (2.0 * braking) / hand);
  out.p[predictors_kinematic_features_SUB_ALONG] = (sub_x * ux + sub_y * uy) / reach;
  out.p[predictors_kinematic_features_SUB_ACROSS] = (sub_y * ux - sub_x * uy) / reach;
  out.p[predictors_kinematic_features_V_ACROSS] = (m.vy * ux - m.vx * uy) * predictors_kinematic_features_SOON_S / hand;
  out.p[predictors_kinematic_features_A_ACROSS] = (m.ay * ux - m.ax * uy) * predictors_kinematic_features_SOON_S * 0.1 / hand;
}

/* Features of the way of the last moments, from the history at ``at``. */
void predictors_kinematic_features_fill_lags(Vector memory, int64_t at, history_Point point, features_Frame frame, Vector out) {
  double reach, ux, uy, past_x, past_y, lag_x, lag_y;
  reach = frame.reach;
  ux = frame.ux;
  uy = frame.uy;
  for (int64_t i = 0; i < 12; i++) {
    T3d values_1 = predictors_kinematic_history_past(memory, at, point, ((const double *)&predictors_kinematic_features_LAGS_S)[i]);
    past_x = values_1.f0;
    past_y = values_1.f1;
    lag_x = point.x - past_x;
    lag_y = point.y - past_y;
    out.p[predictors_kinematic_features_LAG_ALONG + i] = (lag_x * ux + lag_y * uy) / reach;
    out.p[predictors_kinematic_features_LAG_ACROSS + i] = (lag_y * ux - lag_x * uy) / reach;
  }
}

/* Take one motion in and compute the features: its fault, and their frame. */
Tq_features_Frame_ predictors_kinematic_features_observe(Vector memory, int64_t at, records_MotionRow m, Vector out) {
  int64_t fault, here;
  history_Point point;
  features_Frame frame;
  Tq_history_Point_ values_1 = predictors_kinematic_features_follow(memory, at, m);
  fault = values_1.f0;
  point = values_1.f1;
  if (fault != records_FINE) {
    return (Tq_features_Frame_){fault, (features_Frame){0.0, 0.0, 0.0, 0.0}};
  }
  here = at + predictors_kinematic_features_TRACK;
  frame = predictors_kinematic_features_frame_of(memory, here, point, m);
  if (frame.reach > 0.0) {
    predictors_kinematic_features_fill_shape(memory, here, point, frame, out);
    predictors_kinematic_features_fill_pace(memory, here, point, m, frame, out);
    predictors_kinematic_features_fill_lags(memory, at + predictors_kinematic_features_HISTORY, point, frame, out);
  }
  return (Tq_features_Frame_){records_FINE, frame};
}

/* To which side the movement bends: between -1 and 1, near 0 while it is straight. */
double predictors_kinematic_network_side(Vector values) {
  double bent;
  bent = values.p[predictors_kinematic_network_SIDES.f0] + values.p[predictors_kinematic_network_SIDES.f1];
  return bent / sqrt(bent * bent + predictors_kinematic_network_SIDE_SOFT * predictors_kinematic_network_SIDE_SOFT);
}

/* Weighted sums of the inputs; returns where the next layer's weights stand. */
int64_t predictors_kinematic_network_layer(Vector coefficients, int64_t at, Vector inputs, Vector sums) {
  int64_t width, count, offset, p, w;
  double a, b, c, d, e, f, g, h, four, value;
  Vector wa, wb, wc, wd, we, wf, wg, wh, weights;
  width = sums.n;
  count = inputs.n;
  offset = at + count * width;
  for (int64_t j = 0; j < width; j++) {
    sums.p[j] = coefficients.p[offset + j];
  }
  for (int64_t k = 0, end_1 = floor_divided_whole(count, 8); k < end_1; k++) {
    p = 8 * k;
    w = at + 8 * k * width;
    a = inputs.p[p];
    b = inputs.p[p + 1];
    c = inputs.p[p + 2];
    d = inputs.p[p + 3];
    e = inputs.p[p + 4];
    f = inputs.p[p + 5];
    g = inputs.p[p + 6];
    h = inputs.p[p + 7];
    wa = (Vector){coefficients.p + w, offset - w};
    wb = (Vector){coefficients.p + (w + width), offset - (w + width)};
    wc = (Vector){coefficients.p + (w + 2 * width), offset - (w + 2 * width)};
    wd = (Vector){coefficients.p + (w + 3 * width), offset - (w + 3 * width)};
    we = (Vector){coefficients.p + (w + 4 * width), offset - (w + 4 * width)};
    wf = (Vector){coefficients.p + (w + 5 * width), offset - (w + 5 * width)};
    wg = (Vector){coefficients.p + (w + 6 * width), offset - (w + 6 * width)};
    wh = (Vector){coefficients.p + (w + 7 * width), offset - (w + 7 * width)};
    for (int64_t j = 0; j < width; j++) {
      four = sums.p[j] + a * wa.p[j] + b * wb.p[j] + c * wc.p[j] + d * wd.p[j];
      sums.p[j] = four + e * we.p[j] + f * wf.p[j] + g * wg.p[j] + h * wh.p[j];
    }
  }
  for (int64_t i = count - remainder_whole(count, 8); i < count; i++) {
    value = inputs.p[i];
    weights = (Vector){coefficients.p + (at + i * width), offset - (at + i * width)};
    for (int64_t j = 0; j < width; j++) {
      sums.p[j] += value * weights.p[j];
    }
  }
  return offset + width;
}

/* Replace z by z times min(max(z / 6 + 1 / 2, 0), 1) in place. */
void predictors_kinematic_network_activate(Vector sums) {
  for (int64_t j = 0; j < sums.n; j++) {
    sums.p[j] *= min_float(max_float(sums.p[j] * predictors_kinematic_network_GATE_SLOPE + 0.5, 0.0), 1.0);
  }
}

/* Fill ``out`` from the values of the features; returns where the calibration stands. */
int64_t predictors_kinematic_network_evaluate(Vector coefficients, Vector values, Vector out) {
  double mirror, value;
  int64_t count, at;
  Vector inputs, first, second;
  mirror = predictors_kinematic_network_side(values);
  count = values.n;
  RELEASED double *buffer_1 = reserved(count);
  inputs = (Vector){buffer_1, count};
  for (int64_t i = 0; i < count; i++) {
    value = i >= predictors_kinematic_features_ODD ? values.p[i] * mirror : values.p[i];
    value = (value - coefficients.p[predictors_kinematic_network_HEAD + i]) * coefficients.p[predictors_kinematic_network_HEAD + count + i];
    inputs.p[i] = min_float(max_float(value, -predictors_kinematic_network_EXTREME), predictors_kinematic_network_EXTREME);
  }
  RELEASED double *buffer_2 = reserved((int64_t)coefficients.p[predictors_kinematic_network_FIRST]);
  first = (Vector){buffer_2, (int64_t)coefficients.p[predictors_kinematic_network_FIRST]};
  RELEASED double *buffer_3 = reserved((int64_t)coefficients.p[predictors_kinematic_network_SECOND]);
  second = (Vector){buffer_3, (int64_t)coefficients.p[predictors_kinematic_network_SECOND]};
  at = predictors_kinematic_network_layer(coefficients, predictors_kinematic_network_HEAD + 2 * count, inputs, first);
  predictors_kinematic_network_activate(first);
  at = predictors_kinematic_network_layer(coefficients, at, first, second);
  predictors_kinematic_network_activate(second);
  return predictors_kinematic_network_layer(coefficients, at, second, out);
}

/* The exponential of a logarithm that is bounded first. */
double predictors_kinematic_predictor_bounded_exp(double logarithm, T2d bounds) {
  return exp(min_float(max_float(logarithm, bounds.f0), bounds.f1));
}

/* A factor at a share of the time, on lines between the knots. */
double predictors_kinematic_network_factor(Vector coefficients, int64_t at, double share, int64_t which) {
  double place, low, high;
  int64_t knot;
  place = min_float(max_float(share * predictors_kinematic_network_KNOTS - 0.5, 0.0), predictors_kinematic_network_KNOTS - 1.0);
  knot = min_whole((int64_t)floor(place), predictors_kinematic_network_KNOTS - 2);
  low = coefficients.p[at + predictors_kinematic_network_FACTORS * knot + which];
  high = coefficients.p[at + predictors_kinematic_network_FACTORS * (knot + 1) + which];
  return exp(low + (place - knot) * (high - low));
}

/* Features, network, calibration, and back to the screen. */
T10d predictors_kinematic_predictor_step(Vector memory, T10d motion, Vector coefficients) {
  records_MotionRow m;
  Vector values, out;
  int64_t fault, calibration_at;
  features_Frame frame;
  double phase, reach, ux, uy, along, across, since, left, share, scale, wide, broad, tail, spread;
  double buffer_1[65];
  double buffer_3[12];
  m = records_MotionRow_of_T10d(motion);
  values = (Vector){buffer_1, predictors_kinematic_features_FEATURES};
  Tq_features_Frame_ values_2 = predictors_kinematic_features_observe(memory, predictors_kinematic_predictor_AT, m, values);
  fault = values_2.f0;
  frame = values_2.f1;
  if (fault != records_FINE) {
    return predictors_movement_refuse((predictors_movement_State *)(memory.p + predictors_kinematic_predictor_AT), m, fault);
  }
  phase = predictors_movement_phase((predictors_movement_State *)(memory.p + predictors_kinematic_predictor_AT), m);
  reach = frame.reach;
  ux = frame.ux;
  uy = frame.uy;
  if (reach == 0.0) {
    return records_endpoint(m.t, m.x, m.y, phase);
  }
  out = (Vector){buffer_3, predictors_kinematic_network_OUTPUTS};
  calibration_at = predictors_kinematic_network_evaluate(coefficients, values, out);
  along = out.p[predictors_kinematic_network_ALONG];
  across = out.p[predictors_kinematic_network_ACROSS] * predictors_kinematic_network_side(values);
  for (int64_t i = 0; i < predictors_kinematic_network_BASES; i++) {
    along += out.p[predictors_kinematic_network_BASIS + i] * values.p[((const int64_t *)&predictors_kinematic_network_BASIS_ALONG)[i]];
    across += out.p[predictors_kinematic_network_BASIS + i] * values.p[((const int64_t *)&predictors_kinematic_network_BASIS_ACROSS)[i]];
  }
  since = m.t - ((predictors_movement_State *)(memory.p + predictors_kinematic_predictor_AT))->t0;
  left = (since + predictors_kinematic_network_HEAD_START_S) * predictors_kinematic_predictor_bounded_exp(out.p[predictors_kinematic_network_LEFT], predictors_kinematic_network_LEFT_LOGS);
  share = since / (since + left);
  scale = reach * predictors_kinematic_network_factor(coefficients, calibration_at, share, predictors_kinematic_network_WIDTH_FACTOR);
  wide = square(scale * predictors_kinematic_predictor_bounded_exp(out.p[predictors_kinematic_network_WIDE], predictors_kinematic_network_WIDTH_LOGS));
  broad = square(scale * predictors_kinematic_predictor_bounded_exp(out.p[predictors_kinematic_network_BROAD], predictors_kinematic_network_WIDTH_LOGS));
  tail = predictors_kinematic_predictor_bounded_exp(out.p[predictors_kinematic_network_TAIL], predictors_kinematic_network_TAIL_LOGS);
  spread = predictors_kinematic_predictor_bounded_exp(out.p[predictors_kinematic_network_SPREAD], predictors_kinematic_network_SPREAD_LOGS);
  return (T10d){m.t, m.x + reach * (along * ux - across * uy), m.y + reach * (along * uy + across * ux), wide * ux * ux + broad * uy * uy, (wide - broad) * ux * uy, wide * uy * uy + broad * ux * ux, left, phase, tail * predictors_kinematic_network_factor(coefficients, calibration_at, share, predictors_kinematic_network_TAIL_FACTOR), spread * predictors_kinematic_network_factor(coefficients, calibration_at, share, predictors_kinematic_network_SPREAD_FACTOR)};
}

/* The features of a whole table of motions, as training needs them; frames: reach and direction. */
void predictors_kinematic_features_observe_all(Vector memory, FlagVector begin, Table rows, Table out, Table frames) {
  features_Frame frame;
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      fill((Vector){memory.p, memory.n}, 0.0);
    }
    Tq_features_Frame_ values_1 = predictors_kinematic_features_observe(memory, 0, records_MotionRow_of_T10d(records_row_at(rows, i)), (Vector){out.p + i * out.m, out.m});
    frame = values_1.f1;
    frames.p[i * frames.m + 0] = frame.reach;
    frames.p[i * frames.m + 1] = frame.ux;
    frames.p[i * frames.m + 2] = frame.uy;
  }
}

/* Take one motion in without an answer: the network remembers nothing. */
bool predictors_kinematic_predictor_follow(Vector memory, T10d motion, Vector coefficients) {
  int64_t fault;
  Tq_history_Point_ values_1 = predictors_kinematic_features_follow(memory, predictors_kinematic_predictor_AT, records_MotionRow_of_T10d(motion));
  fault = values_1.f0;
  return fault == records_FINE;
}

void loop__stage_learn_nothing__records_row_at__predictors_kinematic_predictor_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out, Vector shared_0) {
  T10d answer;
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      stage_learn_nothing(memory);
      fill((Vector){memory.p + first, memory.n - first}, 0.0);
    }
    answer = predictors_kinematic_predictor_step(memory, records_row_at(rows, i), shared_0);
    for (int64_t j = 0; j < 10; j++) {
      out.p[i * out.m + j] = ((const double *)&answer)[j];
    }
  }
}

T10d joint__differentiators_difference_step__predictors_kinematic_predictor_step(Vector memory, Vector other, records_EventRow row, Vector shared_0) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_difference_step((differentiators_difference_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_kinematic_predictor_step(other, answer, shared_0);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    }
  }
  return answer;
}

T10d last__differentiators_difference_step__predictors_kinematic_predictor_follow__predictors_kinematic_predictor_step(Vector memory, Vector other, Table rows, Vector shared_0) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_difference_step((differentiators_difference_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !predictors_kinematic_predictor_follow(other, between, shared_0)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_difference_step((differentiators_difference_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_kinematic_predictor_step(other, between, shared_0);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
  }
  return answer;
}

T10d joint__differentiators_homogeneous_step__predictors_kinematic_predictor_step(Vector memory, Vector other, records_EventRow row, Vector shared_0) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_kinematic_predictor_step(other, answer, shared_0);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    }
  }
  return answer;
}

T10d last__differentiators_homogeneous_step__predictors_kinematic_predictor_follow__predictors_kinematic_predictor_step(Vector memory, Vector other, Table rows, Vector shared_0) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !predictors_kinematic_predictor_follow(other, between, shared_0)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_kinematic_predictor_step(other, between, shared_0);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
  }
  return answer;
}

T10d joint__differentiators_kalman_step__predictors_kinematic_predictor_step(Vector memory, Vector other, records_EventRow row, Vector shared_0) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_kinematic_predictor_step(other, answer, shared_0);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    }
  }
  return answer;
}

T10d last__differentiators_kalman_step__predictors_kinematic_predictor_follow__predictors_kinematic_predictor_step(Vector memory, Vector other, Table rows, Vector shared_0) {
  Vector kept, other_kept;
  T10d answer, between;
  int64_t count;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  RELEASED double *buffer_2 = copied(other.p, sizeof(double) * other.n);
  kept = (Vector){buffer_1, memory.n};
  other_kept = (Vector){buffer_2, other.n};
  answer = records_refused(records_EVENT_FIELD, NAN);
  count = 0;
  for (int64_t i = 0, end_3 = rows.n - 1; i < end_3; i++) {
    between = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, i)));
    if (between.f0 != between.f0 || !predictors_kinematic_predictor_follow(other, between, shared_0)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_kinematic_predictor_step(other, between, shared_0);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
  }
  return answer;
}
