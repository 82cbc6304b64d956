/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const T12d predictors_kinematic_features_LAGS_S = {0.01, 0.02, 0.03, 0.045, 0.065, 0.09, 0.12, 0.16, 0.21, 0.28, 0.37, 0.5};
static const int64_t predictors_kinematic_features_ODD = 50;
static const double predictors_kinematic_features_REACH_S = 0.06;
static const double predictors_kinematic_features_SOON_S = 0.1;
static const double predictors_kinematic_history_STILL_GAP_S = 0.1;
static const int64_t predictors_kinematic_history_TICKS = 66;
static const double predictors_kinematic_history_TICK_S = 0.008;
static const int64_t predictors_kinematic_network_BASES = 5;
static const T5q predictors_kinematic_network_BASIS_ACROSS = {50, 55, 57, 60, 52};
static const T5q predictors_kinematic_network_BASIS_ALONG = {9, 40, 42, 45, 28};
static const double predictors_kinematic_network_EXTREME = 6.0;
static const double predictors_kinematic_network_GATE_SLOPE = 0.16666666666666666;
static const double predictors_kinematic_network_HEAD_START_S = 0.05;
static const int64_t predictors_kinematic_network_KNOTS = 10;
static const T2d predictors_kinematic_network_LEFT_LOGS = {-6.0, 4.0};
static const T2q predictors_kinematic_network_SIDES = {57, 60};
static const double predictors_kinematic_network_SIDE_SOFT = 0.01;
static const int64_t predictors_kinematic_network_SPREAD_FACTOR = 2;
static const T2d predictors_kinematic_network_SPREAD_LOGS = {-3.0, 1.5};
static const int64_t predictors_kinematic_network_TAIL_FACTOR = 1;
static const T2d predictors_kinematic_network_TAIL_LOGS = {0.3, 4.0};
static const int64_t predictors_kinematic_network_WIDTH_FACTOR = 0;
static const T2d predictors_kinematic_network_WIDTH_LOGS = {-9.0, 4.0};
static const double predictors_kinematic_submovements_FALLEN = 0.7;
static const double predictors_kinematic_submovements_REST_M_S = 1e-06;
static const double predictors_kinematic_submovements_RISEN = 1.4;
static const double predictors_kinematic_submovements_RISE_M_S = 0.005;
static const double predictors_kinematic_submovements_RISE_SHARE = 0.02;
static const double predictors_kinematic_track_SLOW = 0.2;
static const double predictors_kinematic_track_SLOWER = 0.05;
static const double predictors_kinematic_track_SPAN_S = 0.05;

/* Remember the start: tick 0 is the origin. */
void predictors_kinematic_history_begin(predictors_kinematic_history_State * s) {
  s->head.count = 1.0;
  memset(&s->head.last, 0, sizeof(predictors_kinematic_history_Tick));
  memset(&s->ticks[0], 0, sizeof(predictors_kinematic_history_Tick));
}

/* Copy the track before a new time; go back to the copy where a sample of the same time comes again. */
void predictors_kinematic_features_rewind(predictors_kinematic_features_State * s, bool again) {
  predictors_kinematic_track_State * now, *before;
  predictors_kinematic_history_Head * head, *head_before;
  now = &s->track;
  before = &s->before.track;
  for (int64_t i = 0; i < 29; i++) {
    if (again) {
      (Vector){(double *)now, 29}.p[i] = (Vector){(double *)before, 29}.p[i];
    } else {
      (Vector){(double *)before, 29}.p[i] = (Vector){(double *)now, 29}.p[i];
    }
  }
  head = &s->history.head;
  head_before = &s->before.head;
  for (int64_t i = 0; i < 4; i++) {
    if (again) {
      (Vector){(double *)head, 4}.p[i] = (Vector){(double *)head_before, 4}.p[i];
    } else {
      (Vector){(double *)head_before, 4}.p[i] = (Vector){(double *)head, 4}.p[i];
    }
  }
}

/* Fill the ticks after the last one up to now, on the line from the last event (t, x, y) to this one. */
predictors_kinematic_history_Point predictors_kinematic_history_extend(predictors_kinematic_history_State * s, T3d last, T3d now) {
  double last_t, last_x, last_y, t, x, y, share;
  int64_t count, newest;
  predictors_kinematic_history_Tick * old, *tick;
  last_t = last.f0;
  last_x = last.f1;
  last_y = last.f2;
  t = now.f0;
  x = now.f1;
  y = now.f2;
  count = (int64_t)s->head.count;
  newest = (int64_t)floor(t / predictors_kinematic_history_TICK_S);
  old = &s->head.last;
  for (int64_t number = max_whole(count, newest + 1 - predictors_kinematic_history_TICKS), end_1 = newest + 1; number < end_1; number++) {
    share = 0.0;
    if (t - last_t <= predictors_kinematic_history_STILL_GAP_S) {
      share = min_float(max_float((number * predictors_kinematic_history_TICK_S - last_t) / (t - last_t), 0.0), 1.0);
    }
    tick = &s->ticks[remainder_whole(number, predictors_kinematic_history_TICKS)];
    tick->x = last_x + share * (x - last_x);
    tick->y = last_y + share * (y - last_y);
    old->path += hypot(tick->x - old->x, tick->y - old->y);
    tick->path = old->path;
    old->x = tick->x;
    old->y = tick->y;
  }
  s->head.count = max_whole(count, newest + 1);
  return (predictors_kinematic_history_Point){t, x, y, old->path + hypot(x - old->x, y - old->y)};
}

/* Place and path ``ago`` seconds before now: between two ticks on a line, the start before it. */
T3d predictors_kinematic_history_past(predictors_kinematic_history_State * s, predictors_kinematic_history_Point now, double ago) {
  double then, span, share, after_x, after_y, after_path;
  int64_t count, number;
  predictors_kinematic_history_Tick * before, *after;
  then = now.t - ago;
  if (then <= 0.0) {
    return (T3d){0.0, 0.0, 0.0};
  }
  count = (int64_t)s->head.count;
  number = (int64_t)floor(then / predictors_kinematic_history_TICK_S);
  if (number > count - 1) {
    return (T3d){now.x, now.y, now.path};
  }
  before = &s->ticks[remainder_whole(number, predictors_kinematic_history_TICKS)];
  if (number == count - 1) {
    span = now.t - number * predictors_kinematic_history_TICK_S;
    share = span > 0.0 ? (then - number * predictors_kinematic_history_TICK_S) / span : 1.0;
    after_x = now.x;
    after_y = now.y;
    after_path = now.path;
  } else {
    share = (then - number * predictors_kinematic_history_TICK_S) / predictors_kinematic_history_TICK_S;
    after = &s->ticks[remainder_whole(number + 1, predictors_kinematic_history_TICKS)];
    after_x = after->x;
    after_y = after->y;
    after_path = after->path;
  }
  return (T3d){before->x + share * (after_x - before->x), before->y + share * (after_y - before->y), before->path + share * (after_path - before->path)};
}

/* Divide the movement at the valleys of its speed. */
void predictors_kinematic_submovements_divide(predictors_kinematic_submovements_State * s, predictors_kinematic_history_Point point, double speed, double movement_peak) {
  if (s->falling == 0.0) {
    if (speed > s->peak) {
      s->peak = speed;
      s->peak_t = point.t;
    } else if (speed < predictors_kinematic_submovements_FALLEN * s->peak) {
      s->falling = 1.0;
      s->low = 2.0 * speed;
    }
  }
  if (s->falling == 0.0) {
    return;
  }
  if (speed < s->low - predictors_kinematic_submovements_REST_M_S) {
    s->low = speed;
    s->low_t = point.t;
    s->low_x = point.x;
    s->low_y = point.y;
    s->low_path = point.path;
  } else if (speed > predictors_kinematic_submovements_RISEN * s->low + predictors_kinematic_submovements_RISE_SHARE * movement_peak + predictors_kinematic_submovements_RISE_M_S) {
    s->falling = 0.0;
    s->count += 1.0;
    double value_1 = s->low_t;
    double value_2 = s->low_path;
    s->t = value_1;
    s->path = value_2;
    double value_3 = s->low_x;
    double value_4 = s->low_y;
    s->x = value_3;
    s->y = value_4;
    s->peak = speed;
    s->peak_t = point.t;
  }
}

/* Take one sample in: where the cursor is, the hand's motion, the cursor's speed in px/s. */
void predictors_kinematic_track_advance(predictors_kinematic_track_State * s, predictors_kinematic_history_Point point, records_MotionRow hand, double cursor_speed) {
  double t, x, y, path, speed, d, push;
  t = point.t;
  x = point.x;
  y = point.y;
  path = point.path;
  speed = hypot(hand.vx, hand.vy);
  d = hypot(x, y);
  if (x != s->x || y != s->y) {
    s->moved_t = t;
  }
  s->way += speed * (t - s->t);
  s->t = t;
  s->x = x;
  s->y = y;
  s->far = max_float(s->far, d);
  s->cursor_peak = max_float(s->cursor_peak, cursor_speed);
  if (speed > s->peak) {
    s->peak = speed;
    s->peak_t = t;
    s->peak_d = d;
    s->peak_path = path;
  }
  push = d > 0.0 ? (hand.ax * x + hand.ay * y) / d : 0.0;
  if (push > s->push) {
    s->push = push;
    s->push_t = t;
  }
  s->brake = min_float(s->brake, push);
  if (speed >= predictors_kinematic_track_SLOW * s->peak) {
    s->fast_t = t;
  }
  if (speed >= predictors_kinematic_track_SLOWER * s->peak) {
    s->moving_t = t;
  }
  predictors_kinematic_submovements_divide(&s->submovement, point, speed, s->peak);
}

/* Take one motion in: its fault, and where the cursor is. */
Tq_predictors_kinematic_history_Point_ predictors_kinematic_features_follow(predictors_kinematic_features_State * s, records_MotionRow m) {
  double started, last_t, path_before;
  int64_t fault;
  bool new;
  T3d last, now;
  predictors_kinematic_history_Point point;
  started = s->movement.known;
  last_t = s->movement.t;
  Tqbd values_1 = predictors_movement_follow(&s->movement, m);
  fault = values_1.f0;
  new = values_1.f1;
  if (fault != records_FINE) {
    return (Tq_predictors_kinematic_history_Point_){fault, (predictors_kinematic_history_Point){0.0, 0.0, 0.0, 0.0}};
  }
  if (new || m.t == s->movement.t0) {
    memset(&s->track, 0, sizeof(predictors_kinematic_track_State));
    memset(&s->before, 0, sizeof(predictors_kinematic_features_Before));
    predictors_kinematic_history_begin(&s->history);
  } else {
    predictors_kinematic_features_rewind(s, started == 1.0 && m.t == last_t);
  }
  last = (T3d){s->track.t, s->track.x, s->track.y};
  now = (T3d){m.t - s->movement.t0, m.x - s->movement.x0, m.y - s->movement.y0};
  point = predictors_kinematic_history_extend(&s->history, last, now);
  T3d values_2 = predictors_kinematic_history_past(&s->history, point, predictors_kinematic_track_SPAN_S);
  path_before = values_2.f2;
  predictors_kinematic_track_advance(&s->track, point, m, (point.path - path_before) / predictors_kinematic_track_SPAN_S);
  return (Tq_predictors_kinematic_history_Point_){records_FINE, point};
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

/* The frame of the movement so far. */
predictors_kinematic_features_Frame predictors_kinematic_features_frame_of(predictors_kinematic_track_State * s, predictors_kinematic_history_Point point, records_MotionRow m) {
  double ux, uy, reach;
  T2d values_1 = predictors_kinematic_features_direction(point.x, point.y, m.vx, m.vy);
  ux = values_1.f0;
  uy = values_1.f1;
  if (!(point.path > 0.0)) {
    return (predictors_kinematic_features_Frame){0.0, 0.0, ux, uy};
  }
  reach = point.path + predictors_kinematic_features_REACH_S * s->cursor_peak;
  return (predictors_kinematic_features_Frame){reach, s->way + predictors_kinematic_features_REACH_S * s->peak + 0.0001, ux, uy};
}

/* Features of the way so far: its length, its peak, its sub-movements. */
void predictors_kinematic_features_fill_shape(predictors_kinematic_track_State * s, predictors_kinematic_history_Point point, predictors_kinematic_features_Frame frame, predictors_kinematic_features_Values * out) {
  double t, x, y, path, reach, hand, d, peak;
  predictors_kinematic_submovements_State * sub;
  t = point.t;
  x = point.x;
  y = point.y;
  path = point.path;
  reach = frame.reach;
  hand = frame.hand;
  sub = &s->submovement;
  d = hypot(x, y);
  peak = s->peak + 1e-09;
  out->log_reach = log(hand);
  out->log_time = log(t + 0.02);
  out->time = t;
  out->distance = d / reach;
  out->straightness = d / path;
  out->of_farthest = d / max_float(s->far, 1e-09);
  out->cursor_peak = s->cursor_peak * predictors_kinematic_features_SOON_S / reach;
  out->log_peak = log(s->peak + 0.0003);
  out->since_peak = t - s->peak_t;
  out->peak_share = s->peak_t / (t + 0.001);
  out->peak_time = s->peak_t;
  out->peak_distance = s->peak_d / reach;
  out->peak_path = s->peak_path / path;
  out->mean_of_peak = s->way / (t + 0.001) / peak;
  out->push = s->push * predictors_kinematic_features_SOON_S * 0.1 / hand;
  out->brake = s->brake * predictors_kinematic_features_SOON_S * 0.1 / hand;
  out->since_push = t - s->push_t;
  out->subs = min_float(sub->count, 6.0);
  out->since_sub = t - sub->t;
  out->sub_peak = sub->peak / peak;
  out->since_sub_peak = t - sub->peak_t;
  out->falling = sub->falling;
  out->sub_path = (path - sub->path) / reach;
  out->slow_for = t - s->fast_t;
  out->slower_for = t - s->moving_t;
  out->still_for = t - s->moved_t;
  out->log_mean = log(s->way / (t + 0.01) + 0.0003);
}

/* What a minimum-jerk movement has ahead as a share of its way done, from speed over peak. */
double predictors_kinematic_features_ahead(double ratio) {
  double done;
  T2d values_1 = predictors_minimum_jerk_progress(ratio);
  done = values_1.f1;
  return (1.0 - done) / done;
}

/* Features of the present motion: against its peaks, across the direction, and what it says is left. */
void predictors_kinematic_features_fill_pace(predictors_kinematic_track_State * s, predictors_kinematic_history_Point point, records_MotionRow m, predictors_kinematic_features_Frame frame, predictors_kinematic_features_Values * out) {
  double reach, hand, ux, uy, sub_x, sub_y, peak, sub_peak, v, v_along, a_along, of_peak, of_sub, braking;
  predictors_kinematic_submovements_State * sub;
  reach = frame.reach;
  hand = frame.hand;
  ux = frame.ux;
  uy = frame.uy;
  sub = &s->submovement;
  sub_x = point.x - sub->x;
  sub_y = point.y - sub->y;
  peak = s->peak + 1e-09;
  sub_peak = sub->peak + 1e-09;
  v = hypot(m.vx, m.vy);
  v_along = m.vx * ux + m.vy * uy;
  a_along = m.ax * ux + m.ay * uy;
  out->log_speed = log(v + 0.003);
  out->v_along = v_along * predictors_kinematic_features_SOON_S / hand;
  out->a_along = a_along * predictors_kinematic_features_SOON_S * 0.1 / hand;
  out->speed_of_peak = v / peak;
  out->v_aligned = v_along / (v + 1e-06);
  out->speed_of_sub = v / sub_peak;
  of_peak = point.t > s->peak_t ? v / peak : 1.0;
  of_sub = point.t > sub->peak_t ? v / sub_peak : 1.0;
  out->jerk_ahead = predictors_kinematic_features_ahead(of_peak) * hypot(point.x, point.y) / reach;
  out->sub_jerk_ahead = predictors_kinematic_features_ahead(of_sub) * hypot(sub_x, sub_y) / reach;
  braking = max_float(-a_along, 0.001);
  out->stop_time = min_float(1.0, max_float(-1.0, v_along / braking));
  out->stop_way = min_float(4.0, v_along * v_along / (2.0 * braking) / hand);
  out->sub_along = (sub_x * ux + sub_y * uy) / reach;
  out->across.sub = (sub_y * ux - sub_x * uy) / reach;
  out->across.v = (m.vy * ux - m.vx * uy) * predictors_kinematic_features_SOON_S / hand;
  out->across.a = (m.ay * ux - m.ax * uy) * predictors_kinematic_features_SOON_S * 0.1 / hand;
}

/* Features of the way of the last moments. */
void predictors_kinematic_features_fill_lags(predictors_kinematic_history_State * s, predictors_kinematic_history_Point point, predictors_kinematic_features_Frame frame, predictors_kinematic_features_Values * out) {
  double reach, ux, uy, past_x, past_y, lag_x, lag_y;
  reach = frame.reach;
  ux = frame.ux;
  uy = frame.uy;
  for (int64_t i = 0; i < 12; i++) {
    T3d values_1 = predictors_kinematic_history_past(s, point, ((const double *)&predictors_kinematic_features_LAGS_S)[i]);
    past_x = values_1.f0;
    past_y = values_1.f1;
    lag_x = point.x - past_x;
    lag_y = point.y - past_y;
    out->lag_along[i] = (lag_x * ux + lag_y * uy) / reach;
    out->across.lag[i] = (lag_y * ux - lag_x * uy) / reach;
  }
}

/* Take one motion in and compute the features: its fault, and their frame. */
Tq_predictors_kinematic_features_Frame_ predictors_kinematic_features_observe(predictors_kinematic_features_State * s, records_MotionRow m, predictors_kinematic_features_Values * out) {
  int64_t fault;
  predictors_kinematic_history_Point point;
  predictors_kinematic_features_Frame frame;
  Tq_predictors_kinematic_history_Point_ values_1 = predictors_kinematic_features_follow(s, m);
  fault = values_1.f0;
  point = values_1.f1;
  if (fault != records_FINE) {
    return (Tq_predictors_kinematic_features_Frame_){fault, (predictors_kinematic_features_Frame){0.0, 0.0, 0.0, 0.0}};
  }
  frame = predictors_kinematic_features_frame_of(&s->track, point, m);
  if (frame.reach > 0.0) {
    predictors_kinematic_features_fill_shape(&s->track, point, frame, out);
    predictors_kinematic_features_fill_pace(&s->track, point, m, frame, out);
    predictors_kinematic_features_fill_lags(&s->history, point, frame, out);
  }
  return (Tq_predictors_kinematic_features_Frame_){records_FINE, frame};
}

/* To which side the movement bends: between -1 and 1, near 0 while it is straight. */
double predictors_kinematic_network_side(Vector values) {
  double bent;
  bent = values.p[predictors_kinematic_network_SIDES.f0] + values.p[predictors_kinematic_network_SIDES.f1];
  return bent / sqrt(bent * bent + predictors_kinematic_network_SIDE_SOFT * predictors_kinematic_network_SIDE_SOFT);
}

/* Weighted sums of the inputs; returns where the next layer's weights stand in the rest. */
WIDE int64_t predictors_kinematic_network_layer(predictors_kinematic_network_Coefficients * coefficients, int64_t at, Vector inputs, Vector sums) {
  int64_t width, count, offset, p, w;
  double a, b, c, d, e, f, g, h, four, value;
  Vector wa, wb, wc, wd, we, wf, wg, wh, weights;
  width = sums.n;
  count = inputs.n;
  offset = at + count * width;
  for (int64_t j = 0; j < width; j++) {
    sums.p[j] = coefficients->rest[offset + j];
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
    wa = (Vector){(Vector){coefficients->rest, -1}.p + w, offset - w};
    wb = (Vector){(Vector){coefficients->rest, -1}.p + (w + width), offset - (w + width)};
    wc = (Vector){(Vector){coefficients->rest, -1}.p + (w + 2 * width), offset - (w + 2 * width)};
    wd = (Vector){(Vector){coefficients->rest, -1}.p + (w + 3 * width), offset - (w + 3 * width)};
    we = (Vector){(Vector){coefficients->rest, -1}.p + (w + 4 * width), offset - (w + 4 * width)};
    wf = (Vector){(Vector){coefficients->rest, -1}.p + (w + 5 * width), offset - (w + 5 * width)};
    wg = (Vector){(Vector){coefficients->rest, -1}.p + (w + 6 * width), offset - (w + 6 * width)};
    wh = (Vector){(Vector){coefficients->rest, -1}.p + (w + 7 * width), offset - (w + 7 * width)};
    for (int64_t j = 0; j < width; j++) {
      four = sums.p[j] + a * wa.p[j] + b * wb.p[j] + c * wc.p[j] + d * wd.p[j];
      sums.p[j] = four + e * we.p[j] + f * wf.p[j] + g * wg.p[j] + h * wh.p[j];
    }
  }
  for (int64_t i = count - remainder_whole(count, 8); i < count; i++) {
    value = inputs.p[i];
    weights = (Vector){(Vector){coefficients->rest, -1}.p + (at + i * width), offset - (at + i * width)};
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

/* Fill ``out`` from the values of the features; returns where the calibration stands in the rest. */
int64_t predictors_kinematic_network_evaluate(predictors_kinematic_network_Coefficients * coefficients, Vector values, Vector out) {
  double mirror, value;
  int64_t count, at;
  Vector inputs, first, second;
  mirror = predictors_kinematic_network_side(values);
  count = values.n;
  RELEASED double *buffer_1 = reserved(count);
  inputs = (Vector){buffer_1, count};
  for (int64_t i = 0; i < count; i++) {
    value = i >= predictors_kinematic_features_ODD ? values.p[i] * mirror : values.p[i];
    value = (value - coefficients->mean[i]) * coefficients->scale[i];
    inputs.p[i] = min_float(max_float(value, -predictors_kinematic_network_EXTREME), predictors_kinematic_network_EXTREME);
  }
  RELEASED double *buffer_2 = reserved((int64_t)coefficients->first);
  first = (Vector){buffer_2, (int64_t)coefficients->first};
  RELEASED double *buffer_3 = reserved((int64_t)coefficients->second);
  second = (Vector){buffer_3, (int64_t)coefficients->second};
  at = predictors_kinematic_network_layer(coefficients, 0, inputs, first);
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
double predictors_kinematic_network_factor(predictors_kinematic_network_Calibration * calibration, double share, int64_t which) {
  double place, low, high;
  int64_t knot;
  place = min_float(max_float(share * predictors_kinematic_network_KNOTS - 0.5, 0.0), predictors_kinematic_network_KNOTS - 1.0);
  knot = min_whole((int64_t)floor(place), predictors_kinematic_network_KNOTS - 2);
  low = calibration->table[knot][which];
  high = calibration->table[knot + 1][which];
  return exp(low + (place - knot) * (high - low));
}

/* Features, network, calibration, and back to the screen. */
T10d predictors_kinematic_predictor_step(predictors_kinematic_features_State * s, T10d motion, predictors_kinematic_network_Coefficients * coefficients) {
  records_MotionRow m;
  Vector values, sums;
  int64_t fault, at;
  predictors_kinematic_features_Frame frame;
  double phase, reach, ux, uy, along, across, since, left, share, scale, wide, broad, tail, spread;
  predictors_kinematic_network_Calibration * calibration;
  predictors_kinematic_network_Outputs * out;
  double buffer_1[65];
  double buffer_3[12];
  m = records_MotionRow_of_T10d(motion);
  values = (Vector){buffer_1, 65};
  Tq_predictors_kinematic_features_Frame_ values_2 = predictors_kinematic_features_observe(s, m, (predictors_kinematic_features_Values *)(values.p));
  fault = values_2.f0;
  frame = values_2.f1;
  if (fault != records_FINE) {
    return predictors_movement_refuse(&s->movement, m, fault);
  }
  phase = predictors_movement_phase(&s->movement, m);
  reach = frame.reach;
  ux = frame.ux;
  uy = frame.uy;
  if (reach == 0.0) {
    return records_endpoint(m.t, m.x, m.y, phase);
  }
  sums = (Vector){buffer_3, 12};
  at = predictors_kinematic_network_evaluate(coefficients, values, sums);
  calibration = (predictors_kinematic_network_Calibration *)((Vector){coefficients->rest, -1}.p + at);
  out = (predictors_kinematic_network_Outputs *)(sums.p);
  along = out->along;
  across = out->across * predictors_kinematic_network_side(values);
  for (int64_t i = 0; i < predictors_kinematic_network_BASES; i++) {
    along += out->basis[i] * values.p[((const int64_t *)&predictors_kinematic_network_BASIS_ALONG)[i]];
    across += out->basis[i] * values.p[((const int64_t *)&predictors_kinematic_network_BASIS_ACROSS)[i]];
  }
  since = m.t - s->movement.t0;
  left = (since + predictors_kinematic_network_HEAD_START_S) * predictors_kinematic_predictor_bounded_exp(out->left, predictors_kinematic_network_LEFT_LOGS);
  share = since / (since + left);
  scale = reach * predictors_kinematic_network_factor(calibration, share, predictors_kinematic_network_WIDTH_FACTOR);
  wide = square(scale * predictors_kinematic_predictor_bounded_exp(out->wide, predictors_kinematic_network_WIDTH_LOGS));
  broad = square(scale * predictors_kinematic_predictor_bounded_exp(out->broad, predictors_kinematic_network_WIDTH_LOGS));
  tail = predictors_kinematic_predictor_bounded_exp(out->tail, predictors_kinematic_network_TAIL_LOGS);
  spread = predictors_kinematic_predictor_bounded_exp(out->spread, predictors_kinematic_network_SPREAD_LOGS);
  return (T10d){m.t, m.x + reach * (along * ux - across * uy), m.y + reach * (along * uy + across * ux), wide * ux * ux + broad * uy * uy, (wide - broad) * ux * uy, wide * uy * uy + broad * ux * ux, left, phase, tail * predictors_kinematic_network_factor(calibration, share, predictors_kinematic_network_TAIL_FACTOR), spread * predictors_kinematic_network_factor(calibration, share, predictors_kinematic_network_SPREAD_FACTOR)};
}

/* The features of a whole table of motions, as training needs them; frames: reach and direction. */
void predictors_kinematic_features_observe_all(predictors_kinematic_features_State * s, FlagVector begin, Table rows, Table out, Table frames) {
  predictors_kinematic_features_Frame frame;
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      memset(s, 0, sizeof(predictors_kinematic_features_State));
    }
    Tq_predictors_kinematic_features_Frame_ values_1 = predictors_kinematic_features_observe(s, records_MotionRow_of_T10d(records_row_at(rows, i)), (predictors_kinematic_features_Values *)((Vector){out.p + i * out.m, out.m}.p));
    frame = values_1.f1;
    frames.p[i * frames.m + 0] = frame.reach;
    frames.p[i * frames.m + 1] = frame.ux;
    frames.p[i * frames.m + 2] = frame.uy;
  }
}

/* Take one motion in without an answer: the network remembers nothing. */
bool predictors_kinematic_predictor_follow(predictors_kinematic_features_State * s, T10d motion, predictors_kinematic_network_Coefficients * coefficients) {
  int64_t fault;
  Tq_predictors_kinematic_history_Point_ values_1 = predictors_kinematic_features_follow(s, records_MotionRow_of_T10d(motion));
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
    answer = predictors_kinematic_predictor_step((predictors_kinematic_features_State *)memory.p, records_row_at(rows, i), (predictors_kinematic_network_Coefficients *)shared_0.p);
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
    answer = predictors_kinematic_predictor_step((predictors_kinematic_features_State *)other.p, answer, (predictors_kinematic_network_Coefficients *)shared_0.p);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
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
    if (between.f0 != between.f0 || !predictors_kinematic_predictor_follow((predictors_kinematic_features_State *)other.p, between, (predictors_kinematic_network_Coefficients *)shared_0.p)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_difference_step((differentiators_difference_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_kinematic_predictor_step((predictors_kinematic_features_State *)other.p, between, (predictors_kinematic_network_Coefficients *)shared_0.p);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
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
    answer = predictors_kinematic_predictor_step((predictors_kinematic_features_State *)other.p, answer, (predictors_kinematic_network_Coefficients *)shared_0.p);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
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
    if (between.f0 != between.f0 || !predictors_kinematic_predictor_follow((predictors_kinematic_features_State *)other.p, between, (predictors_kinematic_network_Coefficients *)shared_0.p)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_kinematic_predictor_step((predictors_kinematic_features_State *)other.p, between, (predictors_kinematic_network_Coefficients *)shared_0.p);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
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
    answer = predictors_kinematic_predictor_step((predictors_kinematic_features_State *)other.p, answer, (predictors_kinematic_network_Coefficients *)shared_0.p);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
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
    if (between.f0 != between.f0 || !predictors_kinematic_predictor_follow((predictors_kinematic_features_State *)other.p, between, (predictors_kinematic_network_Coefficients *)shared_0.p)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_kinematic_predictor_step((predictors_kinematic_features_State *)other.p, between, (predictors_kinematic_network_Coefficients *)shared_0.p);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}
