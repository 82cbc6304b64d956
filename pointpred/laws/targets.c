/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const double predictors_adaptation_moments_LEAST_S = 0.08;
static const double predictors_adaptation_moments_NEAR_PX = 8.0;
static const double predictors_adaptation_moments_NEAR_SHARE = 0.03;
static const int64_t predictors_adaptation_moments_SAMPLES_LEAST = 6;
static const int64_t predictors_adaptation_region_widening_JUDGED = 9;
static const double predictors_adaptation_region_widening_MOVEMENTS_MOST = 1000000.0;
static const double predictors_adaptation_time_left_LONGEST = 4.0;
static const double targets_aim_JUDGED_LEAST = 0.02;
static const int64_t targets_aim_JUDGED_POINTS = 128;
static const double targets_aim_LIKELY = 0.01;
static const int64_t targets_aim_POINTS_LEAST = 8;
static const double targets_aim_SIZE_PX = 20.0;
static const double targets_arrival_DIFFICULTY_OF = 4.0;
static const double targets_arrival_KEEP = 0.98;
static const double targets_arrival_LONGER = 3.0;
static const double targets_arrival_prior_PRIOR[] = {0.103, 0.34, 0.22, 0.053, 0.162, -0.237, -0.169, 5.079, 7.222, 18.259, 4.412, 8.719, 6.744, 3.098, 6.017, 3.963, 3.812, 2.215, 3.098, 2.193, 1.859, 1.519, 2.487, 7.489, 2.794, 1.202, 0.476, 6.189, 0.939, 2.131, 0.914, 0.972, 0.469, 0.68, 0.577};
static const double targets_choice_law_ENTERED = 2.0;
static const double targets_choice_law_INSIDE = 1.0;
static const double targets_choice_law_KEEP = 0.4;
static const double targets_choice_law_LEAST_PX = 16.0;
static const double targets_choice_law_OUTSIDE = 0.0;
static const double targets_choice_law_RELEASED = 3.0;
static const double targets_cursor_PAUSE_S = 0.3;
static const double targets_endpoint_LEAST_PX2 = 1.0;
static const double targets_endpoint_NARROWEST = 0.25;
static const double targets_endpoint_NEGLIGIBLE = 0.001;
static const double targets_endpoint_RADII2 = 0.5;
static const int64_t targets_endpoint_STEPS = 8;
static const double targets_endpoint_TAIL = 3.0;
static const double targets_endpoint_WIDER = 2.0;
static const int64_t targets_heading_MOST = 32;
static const double targets_heading_SHORTEST_PX = 3.0;
static const int64_t targets_ledger_KEY = 3;
static const int64_t targets_past_AFTER = 3;
static const int64_t targets_past_ALIKE = 4;
static const int64_t targets_past_CAPACITY = 64;
static const double targets_past_FADING_OF = 4.0;
static const double targets_past_FIRST_OF = 1.0;
static const T5d targets_past_FIRST_RULES = {12.0, 1.0, 1.0, 1.0, 1.0};
static const int64_t targets_past_GIVEN = 0;
static const double targets_past_GIVEN_OF = 1.0;
static const int64_t targets_past_ID = 0;
static const double targets_past_KEEP = 0.97;
static const int64_t targets_past_KIND = 1;
static const int64_t targets_past_LATELY = 2;
static const double targets_past_LATE_AGE = 3.0;
static const double targets_past_NONE_MOST = 0.99;
static const double targets_past_NO_TARGET = 0.0;
static const int64_t targets_past_OFTEN = 1;
static const double targets_past_OFTEN_AGE = 40.0;
static const int64_t targets_past_RULES = 5;
static const double targets_posterior_ACROSS = 0.2;
static const double targets_posterior_ALONG = 0.5;
static const double targets_posterior_ANGLE = 0.15;
static const double targets_posterior_EFFECTIVE = 4.133;
static const int64_t targets_posterior_FEATURES = 6;
static const double targets_posterior_FITTED_NONE = 0.25;
static const double targets_posterior_FITTED_TARGETS = 16.0;
static const double targets_posterior_FLATTEST = 1e-12;
static const int64_t targets_posterior_HEADING = 2;
static const double targets_posterior_LEAST = 0.1;
static const double targets_posterior_LEAST_MASS = 0.001;
static const int64_t targets_posterior_MASS = 0;
static const int64_t targets_posterior_NEAR = 5;
static const int64_t targets_posterior_PER_SPEED = 4;
static const int64_t targets_posterior_PER_WAY = 3;
static const T2d targets_posterior_TAILS = {0.001, 1000000000.0};
static const int64_t targets_posterior_TRAIL = 1;
static const double targets_prefetch_ARMED = 0.0;
static const double targets_prefetch_ENTERED = 4.0;
static const double targets_prefetch_FIRED = 1.0;
static const double targets_prefetch_LEAST_VISITS = 0.05;
static const double targets_prefetch_LEAST_WAY_PX = 3.0;
static const double targets_prefetch_LONGEST_S = 5.0;
static const double targets_prefetch_NEGLIGIBLE = 0.001;
static const int64_t targets_prefetch_PATHS = 8;
static const double targets_prefetch_PREDICTED = 3.0;
static const double targets_prefetch_REFERENCE_S = 0.25;
static const double targets_prefetch_RESTING = 2.0;
static const double targets_prefetch_ROUNDING = 1e-06;
static const double targets_prefetch_SHORTEST_S = 0.005;
static const double targets_prefetch_SMALLEST = 1e-06;
static const int64_t targets_rectangles_CENTRE_X = 0;
static const int64_t targets_rectangles_CENTRE_Y = 1;
static const int64_t targets_rectangles_HEIGHT = 3;
static const int64_t targets_rectangles_LOG_WEIGHT = 4;
static const int64_t targets_rectangles_WIDTH = 2;

/* Whether a movement begins with this event: the first, one after a pause, or the release of a button. */
bool targets_cursor_begins(targets_cursor_State * s, double t, double pressed) {
  return s->known == 0.0 || (s->pressed == 1.0 && pressed == 0.0) || t - s->t > targets_cursor_PAUSE_S + records_ROUNDING_S;
}

/* Whether a predicted law can be used: a region of finite size, and a tail that is one, or none. */
bool targets_posterior_lawful(targets_posterior_Law predicted) {
  double sxx, sxy, syy, tail;
  sxx = predicted.sxx;
  sxy = predicted.sxy;
  syy = predicted.syy;
  tail = predicted.tail;
  if (!((0.0 < sxx && sxx <= records_LARGEST * records_LARGEST) && (0.0 < syy && syy <= records_LARGEST * records_LARGEST) && fabs(sxy) <= records_LARGEST * records_LARGEST)) {
    return false;
  }
  return sxx * syy - sxy * sxy > targets_posterior_FLATTEST * sxx * syy && (tail != tail || (targets_posterior_TAILS.f0 <= tail && tail <= targets_posterior_TAILS.f1));
}

/* The scale matrix of a law for which the predictor claims none: long along the way left, px^2. */
T3d targets_posterior_unclaimed(targets_cursor_State * s, double x, double y) {
  double gx, gy, done_x, done_y, left, done, size, reach, across, more, ux, uy;
  gx = x - s->x;
  gy = y - s->y;
  done_x = s->x - s->x0;
  done_y = s->y - s->y0;
  left = hypot(gx, gy);
  done = hypot(done_x, done_y);
  if (left == 0.0) {
    gx = done_x;
    gy = done_y;
  }
  size = hypot(gx, gy);
  reach = max_float(left + targets_posterior_LEAST * done, 1.0);
  across = square(targets_posterior_ACROSS * reach);
  if (size == 0.0) {
    return (T3d){across, 0.0, across};
  }
  more = square(targets_posterior_ALONG * reach) - across;
  ux = gx / size;
  uy = gy / size;
  return (T3d){across + more * ux * ux, more * ux * uy, across + more * uy * uy};
}

/* A vector of length 1; (0, 0) where it has none. */
T2d targets_posterior_direction(double x, double y) {
  double size;
  size = hypot(x, y);
  return size > 0.0 ? (T2d){x / size, y / size} : (T2d){0.0, 0.0};
}

/* What the features of all targets share. */
targets_posterior_Situation targets_posterior_situation(targets_cursor_State * s) {
  double x, y, way, sweep, trail_x, trail_y, ux, uy;
  x = s->x;
  y = s->y;
  way = hypot(x - s->x0, y - s->y0);
  sweep = s->speed * (s->t - s->t0);
  T2d values_1 = targets_posterior_direction(x - s->trail_x, y - s->trail_y);
  trail_x = values_1.f0;
  trail_y = values_1.f1;
  T2d values_2 = targets_posterior_direction(s->vx, s->vy);
  ux = values_2.f0;
  uy = values_2.f1;
  return (targets_posterior_Situation){x, y, trail_x, trail_y, ux, uy, log(max_float(way, 1.0)), log(max_float(sweep, 1.0))};
}

/* Logarithm of how much of a law falls to a rectangle with its centre at (dx, dy) from the law's, px. */
double targets_posterior_log_mass(targets_posterior_Law predicted, double dx, double dy, double width, double height) {
  double sxx, sxy, syy, det, area, far, flat;
  sxx = predicted.sxx + square(width / targets_posterior_EFFECTIVE);
  sxy = predicted.sxy;
  syy = predicted.syy + square(height / targets_posterior_EFFECTIVE);
  det = sxx * syy - sxy * sxy;
  area = width * height / (2.0 * 3.141592653589793);
  far = max_float((syy * dx * dx - 2.0 * sxy * dx * dy + sxx * dy * dy) / det, 0.0);
  flat = 0.5 * log(area * area / det);
  if (predicted.tail != predicted.tail) {
    return flat - 0.5 * far;
  }
  return flat - (0.5 * predicted.tail + 1.0) * log(1.0 + far / predicted.tail);
}

/* The features of one target, a row of a table. */
T6d targets_posterior_feature(Vector row, targets_posterior_Situation now, targets_posterior_Law predicted) {
  double x, y, width, height, gx, gy, size, far2, far, straight, trail, heading, off, left, log_left;
  x = row.p[targets_rectangles_CENTRE_X];
  y = row.p[targets_rectangles_CENTRE_Y];
  width = row.p[targets_rectangles_WIDTH];
  height = row.p[targets_rectangles_HEIGHT];
  gx = x - now.x;
  gy = y - now.y;
  size = 0.5 * (width + height);
  far2 = gx * gx + gy * gy;
  far = sqrt(far2);
  straight = targets_posterior_ANGLE * targets_posterior_ANGLE * far2 + 0.0625 * size * size;
  trail = 0.0;
  heading = 0.0;
  if (now.trail_x != 0.0 || now.trail_y != 0.0) {
    off = max_float(far - now.trail_x * gx - now.trail_y * gy, 0.0);
    trail = log(1.0 + 2.0 * far * off / straight);
  }
  if (now.ux != 0.0 || now.uy != 0.0) {
    off = max_float(far - now.ux * gx - now.uy * gy, 0.0);
    heading = log(1.0 + 2.0 * far * off / straight);
  }
  left = max_float(far, 1.0);
  log_left = log(left);
  return (T6d){targets_posterior_log_mass(predicted, x - predicted.x, y - predicted.y, width, height), trail, heading, log_left - now.log_way, log_left - now.log_sweep, log(1.0 + 2.0 * left / size)};
}

/* Logarithm of how much of a law falls to FITTED_TARGETS targets, from the mean by weight. */
double targets_posterior_log_total(double mean) {
  return log(max_float(targets_posterior_FITTED_TARGETS * mean, targets_posterior_LEAST_MASS));
}

/* The logarithm of each target's share, up to a constant; behind them that of none of them. */
void targets_posterior_scores(targets_cursor_State * s, Table table, T10d answer, targets_posterior_Coefficients * coefficients, double elsewhere, Vector out) {
  double x, y, sxx, sxy, syy, tail, fast, total, usual, f0, f1, f2, f3, f4, f5, score, none, around;
  bool claimed;
  targets_posterior_Weights * fit;
  targets_posterior_Law predicted;
  targets_posterior_Situation now;
  Vector weight;
  int64_t count;
  double buffer_2[6];
  x = answer.f1;
  y = answer.f2;
  sxx = answer.f3;
  sxy = answer.f4;
  syy = answer.f5;
  tail = answer.f8;
  claimed = fabs(x) <= records_LARGEST && fabs(y) <= records_LARGEST;
  if (!claimed) {
    x = s->x;
    y = s->y;
  }
  fit = &coefficients->claimed;
  predicted = (targets_posterior_Law){x, y, sxx, sxy, syy, tail};
  if (!claimed || !targets_posterior_lawful(predicted)) {
    T3d values_1 = targets_posterior_unclaimed(s, x, y);
    sxx = values_1.f0;
    sxy = values_1.f1;
    syy = values_1.f2;
    fit = &coefficients->unclaimed;
    predicted = (targets_posterior_Law){x, y, sxx, sxy, syy, NAN};
  }
  now = targets_posterior_situation(s);
  weight = (Vector){buffer_2, targets_posterior_FEATURES};
  fast = s->peak > 0.0 ? min_float(s->speed / s->peak, 1.0) : 0.0;
  for (int64_t j = 0; j < targets_posterior_FEATURES; j++) {
    weight.p[j] = (1.0 - fast) * fit->slow[j] + fast * fit->fast[j];
  }
  count = table.n;
  total = 0.0;
  usual = log(targets_posterior_FITTED_TARGETS * (1.0 - elsewhere) / (1.0 - targets_posterior_FITTED_NONE));
  for (int64_t i = 0; i < count; i++) {
    if (table.p[i * table.m + targets_rectangles_LOG_WEIGHT] == -INFINITY) {
      out.p[i] = -INFINITY;
      continue;
    }
    T6d values_3 = targets_posterior_feature((Vector){table.p + i * table.m, table.m}, now, predicted);
    f0 = values_3.f0;
    f1 = values_3.f1;
    f2 = values_3.f2;
    f3 = values_3.f3;
    f4 = values_3.f4;
    f5 = values_3.f5;
    score = weight.p[0] * f0 + weight.p[1] * f1 + weight.p[2] * f2;
    out.p[i] = table.p[i * table.m + targets_rectangles_LOG_WEIGHT] + usual + score + weight.p[3] * f3 + weight.p[4] * f4 + weight.p[5] * f5;
    total += exp(table.p[i * table.m + targets_rectangles_LOG_WEIGHT] + f0);
  }
  none = (1.0 - fast) * fit->none[0] + fast * fit->none[1];
  around = (1.0 - fast) * fit->around[0] + fast * fit->around[1];
  out.p[count] = none + around * targets_posterior_log_total(total) + log(elsewhere / targets_posterior_FITTED_NONE);
}

/* Scores become shares of one; the last score is finite. */
void targets_posterior_normalise(Vector out) {
  double most, total;
  most = -INFINITY;
  for (int64_t i = 0; i < out.n; i++) {
    most = max_float(most, out.p[i]);
  }
  total = 0.0;
  for (int64_t i = 0; i < out.n; i++) {
    out.p[i] = exp(out.p[i] - most);
    total += out.p[i];
  }
  for (int64_t i = 0; i < out.n; i++) {
    out.p[i] = out.p[i] / total;
  }
}

/* The target with the largest share, the first of equal ones; NOBODY where there is none. */
int64_t targets_decision_likeliest(Vector shares, int64_t count) {
  int64_t best;
  best = targets_rectangles_NOBODY;
  for (int64_t i = 0; i < count; i++) {
    if (best == targets_rectangles_NOBODY || shares.p[i] > shares.p[best]) {
      best = i;
    }
  }
  return best;
}

/* Nothing is known of a movement yet, nor of the targets of these rows. */
void targets_ledger_begin(targets_ledger_State * s, Table rows) {
  memset(s, 0, sizeof(targets_ledger_State));
  s->ended = targets_rectangles_NOBODY;
  s->standing = s->ended;
  for (int64_t i = 0; i < rows.n; i++) {
    rows.p[i * rows.m + targets_ledger_MADE] = 0.0;
    rows.p[i * rows.m + targets_ledger_ENTRY] = NAN;
    rows.p[i * rows.m + targets_ledger_ENTRY_SINCE] = NAN;
  }
}

/* Seconds until the cursor enters a rectangle at its present speed; 0 inside, infinite at rest. */
double targets_cursor_until(targets_cursor_State * s, double x, double y, double width, double height) {
  double dx, dy, way;
  dx = max_float(fabs(x - s->x) - 0.5 * width, 0.0);
  dy = max_float(fabs(y - s->y) - 0.5 * height, 0.0);
  way = hypot(dx, dy);
  if (way == 0.0) {
    return 0.0;
  }
  return s->speed > 0.0 ? way / s->speed : INFINITY;
}

/* Whether a proposal of this target would still come in time: the cursor is not there at once. */
bool targets_decision_early(targets_cursor_State * s, Vector row, double remaining_s, double least_s) {
  double left;
  left = targets_cursor_until(s, row.p[targets_rectangles_CENTRE_X], row.p[targets_rectangles_CENTRE_Y], row.p[targets_rectangles_WIDTH], row.p[targets_rectangles_HEIGHT]);
  if (left == 0.0) {
    return false;
  }
  if (remaining_s == remaining_s) {
    left = max_float(left, remaining_s);
  }
  return left >= least_s;
}

/* Ten numbers as a row. */
T10d targets_aim_row_of(Vector values) {
  return (T10d){values.p[0], values.p[1], values.p[2], values.p[3], values.p[4], values.p[5], values.p[6], values.p[7], values.p[8], values.p[9]};
}

/* The law of a movement that goes to none of the targets: that of the answer, or one that stands in. */
targets_posterior_Law targets_endpoint_elsewhere(targets_cursor_State * s, T10d answer) {
  double x, y, sxx, sxy, syy, tail;
  targets_posterior_Law stated;
  x = answer.f1;
  y = answer.f2;
  sxx = answer.f3;
  sxy = answer.f4;
  syy = answer.f5;
  tail = answer.f8;
  stated = (targets_posterior_Law){x, y, sxx, sxy, syy, tail};
  if (targets_posterior_lawful(stated)) {
    return stated;
  }
  T3d values_1 = targets_posterior_unclaimed(s, x, y);
  sxx = values_1.f0;
  sxy = values_1.f1;
  syy = values_1.f2;
  return (targets_posterior_Law){x, y, sxx, sxy, syy, NAN};
}

/* Write the law of the endpoint of a movement to a target: normal, between its centre and the prediction. */
void targets_endpoint_write_target(Vector row, targets_posterior_Law predicted, double share, predictors_mixture_PartRow * part) {
  double x, y, sxx, sxy, syy, tail, across, down, dx, dy, least_x, least_y, wide, a, b, c, far2, scaled;
  x = predicted.x;
  y = predicted.y;
  sxx = predicted.sxx;
  sxy = predicted.sxy;
  syy = predicted.syy;
  tail = predicted.tail;
  across = square(row.p[targets_rectangles_WIDTH] / targets_posterior_EFFECTIVE);
  down = square(row.p[targets_rectangles_HEIGHT] / targets_posterior_EFFECTIVE);
  dx = x - row.p[targets_rectangles_CENTRE_X];
  dy = y - row.p[targets_rectangles_CENTRE_Y];
  least_x = (1.0 + targets_endpoint_NARROWEST) * across;
  least_y = (1.0 + targets_endpoint_NARROWEST) * down;
  wide = targets_endpoint_WIDER;
  if (tail == tail) {
    a = wide * sxx + least_x;
    b = wide * sxy;
    c = wide * syy + least_y;
    far2 = (c * dx * dx - 2.0 * b * dx * dy + a * dy * dy) / (a * c - b * b);
    wide *= (tail + far2) / (tail + 2.0);
  }
  a = wide * sxx + least_x;
  b = wide * sxy;
  c = wide * syy + least_y;
  scaled = 1.0 / (a * c - b * b);
  part->share = share;
  part->x = row.p[targets_rectangles_CENTRE_X] + across * (c * dx - b * dy) * scaled;
  part->y = row.p[targets_rectangles_CENTRE_Y] + down * (a * dy - b * dx) * scaled;
  part->sxx = across - across * across * c * scaled;
  part->sxy = across * down * b * scaled;
  part->syy = down - down * down * a * scaled;
  part->tail = 0.0;
}

/* Write the parts of the mixture, as ``predictors.mixture`` has them: elsewhere, then the targets. */
int64_t targets_endpoint_mixture(Table table, Vector shares, targets_posterior_Law predicted, double least, Table out) {
  int64_t count;
  double rest;
  predictors_mixture_PartRow * first;
  count = 1;
  rest = 1.0;
  for (int64_t i = 0; i < table.n; i++) {
    if (shares.p[i] >= least) {
      targets_endpoint_write_target((Vector){table.p + i * table.m, table.m}, predicted, shares.p[i], (predictors_mixture_PartRow *)((Vector){out.p + count * out.m, out.m}.p));
      rest -= shares.p[i];
      count += 1;
    }
  }
  first = (predictors_mixture_PartRow *)((Vector){out.p + 0 * out.m, out.m}.p);
  first->share = max_float(rest, 0.0);
  first->x = predicted.x;
  first->y = predicted.y;
  first->sxx = predicted.sxx;
  first->sxy = predicted.sxy;
  first->syy = predicted.syy;
  first->tail = predicted.tail == predicted.tail ? predicted.tail : 0.0;
  return count;
}

/* Judge the ellipses and level sets that were stated over ``span``, in s, by where the movement ended. */
void targets_aim_learn_regions(predictors_adaptation_region_widening_Radii * s, targets_heading_Movement * movement, T2d end, T2d span, T_Table__Vector__Table__Vector_ targets, targets_posterior_Coefficients * coefficients) {
  Table rows, parts;
  double x, y, step, share, within, nearer, near, far, tail, asked;
  Vector shares;
  int64_t k, count;
  targets_heading_Moment * m;
  T10d answer;
  targets_posterior_Law predicted;
  T6d ellipse;
  rows = targets.f0;
  x = end.f0;
  y = end.f1;
  s->movements = min_float(s->movements + 1.0, predictors_adaptation_region_widening_MOVEMENTS_MOST);
  step = predictors_adaptation_levels_step_after(s->movements);
  RELEASED double *buffer_1 = reserved((rows.n + 1));
  RELEASED double *buffer_2 = reserved((rows.n + 1) * 7);
  shares = (Vector){buffer_1, rows.n + 1};
  parts = (Table){buffer_2, rows.n + 1, 7};
  k = 0;
  for (int64_t judged = 1; judged < (predictors_adaptation_region_widening_JUDGED + 1); judged++) {
    share = judged / (predictors_adaptation_region_widening_JUDGED + 1.0);
    while (k + 1 < movement->series.count && predictors_adaptation_moments_has_come(&movement->series, movement->moments[k + 1].t, span, share)) {
      k += 1;
    }
    m = &movement->moments[k];
    answer = targets_aim_row_of((Vector){m->answer, 10});
    targets_posterior_scores(&m->cursor, rows, answer, coefficients, movement->elsewhere, shares);
    targets_posterior_normalise(shares);
    predicted = targets_endpoint_elsewhere(&m->cursor, answer);
    count = targets_endpoint_mixture(rows, shares, predicted, targets_aim_JUDGED_LEAST, parts);
    within = predictors_mixture_content(parts, count, x, y, max_whole(floor_divided_whole(targets_aim_JUDGED_POINTS, count), targets_aim_POINTS_LEAST));
    ellipse = (T6d){m->x, m->y, m->sxx, m->sxy, m->syy, m->tail};
    nearer = predictors_adaptation_region_widening_probability_within(ellipse, x, y);
    near = predictors_adaptation_levels_offset(&s->mixed, share, 0);
    far = predictors_adaptation_levels_offset(&s->mixed, share, 1);
    tail = predicted.tail == predicted.tail ? predicted.tail : 2.0 / predictors_mixture_HEAVINESS_LEAST;
    for (int64_t which = 0; which < 2; which++) {
      asked = predictors_mixture_corrected_probability(((const double *)&predictors_mixture_LEVELS)[which], tail, near, far);
      predictors_adaptation_levels_learn(&s->mixed, share, which, within <= asked, step);
      predictors_adaptation_levels_learn(&s->single, share, which, nearer <= ((const double *)&predictors_mixture_LEVELS)[which], step);
    }
  }
}

/* When the cursor came near its end (x, y) for good, s. */
double targets_heading_arrived(targets_heading_Movement * movement, double x, double y, double near, double end) {
  targets_heading_Moment * m;
  for (int64_t k = (int64_t)movement->series.count - 1; k > (-1); k--) {
    m = &movement->moments[k];
    if (hypot(m->cursor.x - x, m->cursor.y - y) > near) {
      return end;
    }
    end = m->t;
  }
  return end;
}

/* When the movement that is over came to its end, s; NaN where nothing is learned from it. */
double targets_heading_ended(targets_heading_Memory * memory, Table rows) {
  targets_cursor_State * s;
  targets_heading_Movement * movement;
  double distance, end;
  bool whole;
  s = &memory->cursor;
  movement = &memory->movement;
  distance = hypot(s->x - s->x0, s->y - s->y0);
  end = targets_heading_arrived(movement, s->x, s->y, max_float(predictors_adaptation_moments_NEAR_PX, predictors_adaptation_moments_NEAR_SHARE * distance), s->t);
  whole = movement->samples >= predictors_adaptation_moments_SAMPLES_LEAST && distance >= targets_heading_SHORTEST_PX && end - s->t0 >= predictors_adaptation_moments_LEAST_S;
  return memory->settings.learn == 1.0 && whole && rows.n > 0 ? end : NAN;
}

/* The mean duration in s; 0 where none is known. */
double targets_arrival_mean(targets_arrival_Durations * s) {
  return s->count > 0.0 ? s->total / s->count : 0.0;
}

/* Take in the duration of a finished movement, s. */
void targets_arrival_remember(targets_arrival_Durations * s, double duration) {
  double most;
  most = s->count > 0.0 ? targets_arrival_LONGER * targets_arrival_mean(s) : duration;
  s->total = targets_arrival_KEEP * s->total + min_float(duration, most);
  s->count = targets_arrival_KEEP * s->count + 1.0;
}

/* The movement has ended where the cursor is: learn how good its regions and times were. */
void targets_aim_learn_prediction(targets_heading_Memory * memory, T_Table__Vector__Table__Vector_ targets, targets_posterior_Coefficients * coefficients) {
  targets_cursor_State * s;
  targets_heading_Movement * movement;
  targets_heading_Person * person;
  double end, usual;
  T2d span;
  s = &memory->cursor;
  movement = &memory->movement;
  person = &memory->person;
  end = targets_heading_ended(memory, targets.f0);
  if (end == end) {
    span = (T2d){s->t0, end};
    targets_aim_learn_regions(&person->regions, movement, (T2d){s->x, s->y}, span, targets, coefficients);
    usual = targets_arrival_mean(&person->durations);
    predictors_adaptation_time_left_learn(&person->time_left, &person->intervals, &movement->time_left, span, usual, (Vector){(double *)targets_arrival_prior_PRIOR, 35});
    targets_arrival_remember(&person->durations, end - s->t0);
  }
}

/* Add the target that was taken ``k`` movements ago to the visits of each rule, as far as it is there. */
void targets_past_add_visit(targets_past_Past * s, int64_t k, Table keys, Table out) {
  int64_t place;
  double alike, weight;
  place = -1;
  alike = 0.0;
  for (int64_t i = 0; i < keys.n; i++) {
    if (keys.p[i * keys.m + targets_past_ID] == s->ids[k]) {
      place = i;
    }
    if (keys.p[i * keys.m + targets_past_KIND] == s->kinds[k]) {
      alike += out.p[targets_past_GIVEN * out.m + i];
    }
  }
  weight = exp(-k / targets_past_OFTEN_AGE);
  if (place >= 0) {
    out.p[targets_past_OFTEN * out.m + place] += weight;
    out.p[targets_past_LATELY * out.m + place] += exp(-k / targets_past_LATE_AGE);
    if (k + 1 < (int64_t)s->count && s->ids[0] != targets_past_NO_TARGET && s->ids[k + 1] == s->ids[0]) {
      out.p[targets_past_AFTER * out.m + place] += weight;
    }
  }
  if (alike > 0.0) {
    for (int64_t i = 0; i < keys.n; i++) {
      if (keys.p[i * keys.m + targets_past_KIND] == s->kinds[k]) {
        out.p[targets_past_ALIKE * out.m + i] += weight * out.p[targets_past_GIVEN * out.m + i] / alike;
      }
    }
  }
}

/* The share of each target by each rule, a row each, whose sum is one. */
void targets_past_shares(targets_past_Past * s, Vector own, Table keys, Table out) {
  double total;
  for (int64_t i = 0; i < own.n; i++) {
    out.p[targets_past_GIVEN * out.m + i] = own.p[i] > -INFINITY ? exp(own.p[i]) : 0.0;
  }
  for (int64_t k = 0, end_1 = (int64_t)s->count; k < end_1; k++) {
    if (s->ids[k] != targets_past_NO_TARGET) {
      targets_past_add_visit(s, k, keys, out);
    }
  }
  for (int64_t rule = targets_past_OFTEN; rule < targets_past_RULES; rule++) {
    total = targets_past_GIVEN_OF;
    for (int64_t i = 0; i < own.n; i++) {
      out.p[rule * out.m + i] = out.p[targets_past_GIVEN * out.m + i] > 0.0 ? out.p[rule * out.m + i] : 0.0;
      total += out.p[rule * out.m + i];
    }
    for (int64_t i = 0; i < own.n; i++) {
      out.p[rule * out.m + i] = (out.p[rule * out.m + i] + targets_past_GIVEN_OF * out.p[targets_past_GIVEN * out.m + i]) / total;
    }
  }
}

/* The weight of a rule among all: the first belief fades as visits are shared. */
double targets_past_rule_weight(targets_past_Past * s, int64_t rule) {
  double fading, total;
  fading = targets_past_FADING_OF / (targets_past_FADING_OF + s->to);
  total = 0.0;
  for (int64_t k = 0; k < targets_past_RULES; k++) {
    total += s->rules[k] + ((const double *)&targets_past_FIRST_RULES)[k] * fading;
  }
  return (s->rules[rule] + ((const double *)&targets_past_FIRST_RULES)[rule] * fading) / total;
}

/* Learn from a movement to the target of this place, below 0: to none of them. */
void targets_past_learn(targets_past_Past * s, Vector own, Table keys, int64_t taken) {
  Table by_rule;
  double total;
  s->to *= targets_past_KEEP;
  s->none *= targets_past_KEEP;
  if (taken < 0) {
    s->none += 1.0;
  } else {
    s->to += 1.0;
    RELEASED double *buffer_1 = reserved(targets_past_RULES * own.n);
    by_rule = (Table){buffer_1, targets_past_RULES, own.n};
    targets_past_shares(s, own, keys, by_rule);
    total = 0.0;
    for (int64_t rule = 0; rule < targets_past_RULES; rule++) {
      by_rule.p[rule * by_rule.m + taken] = by_rule.p[rule * by_rule.m + taken] * targets_past_rule_weight(s, rule);
      total += by_rule.p[rule * by_rule.m + taken];
    }
    for (int64_t rule = 0; rule < targets_past_RULES; rule++) {
      s->rules[rule] = targets_past_KEEP * s->rules[rule] + (total > 0.0 ? by_rule.p[rule * by_rule.m + taken] / total : 0.0);
    }
  }
  s->count = min_float(s->count + 1.0, targets_past_CAPACITY);
  for (int64_t k = (int64_t)s->count - 1; k > 0; k--) {
    double value_2 = s->ids[k - 1];
    double value_3 = s->kinds[k - 1];
    s->ids[k] = value_2;
    s->kinds[k] = value_3;
  }
  s->ids[0] = taken >= 0 ? keys.p[taken * keys.m + targets_past_ID] : targets_past_NO_TARGET;
  s->kinds[0] = taken >= 0 ? keys.p[taken * keys.m + targets_past_KIND] : targets_past_NO_TARGET;
}

/* The smallest target that holds a point, of equal ones the nearest; NOBODY where there is none. */
int64_t targets_rectangles_holder(Table table, double x, double y) {
  int64_t best;
  double smallest, least, across, down, area, away;
  Vector row;
  best = targets_rectangles_NOBODY;
  smallest = INFINITY;
  least = INFINITY;
  for (int64_t i = 0; i < table.n; i++) {
    row = (Vector){table.p + i * table.m, table.m};
    across = fabs(row.p[targets_rectangles_CENTRE_X] - x);
    down = fabs(row.p[targets_rectangles_CENTRE_Y] - y);
    if (across <= 0.5 * row.p[targets_rectangles_WIDTH] && down <= 0.5 * row.p[targets_rectangles_HEIGHT]) {
      area = row.p[targets_rectangles_WIDTH] * row.p[targets_rectangles_HEIGHT];
      away = across + down;
      if (area < smallest || (area == smallest && away < least)) {
        best = i;
        smallest = area;
        least = away;
      }
    }
  }
  return best;
}

/* The target that a movement was for that ended here; -1: none of them. */
int64_t targets_heading_taken(Table rows, double x, double y) {
  int64_t best;
  double least, off;
  Vector row;
  best = targets_rectangles_holder(rows, x, y);
  if (best != targets_rectangles_NOBODY) {
    return best;
  }
  least = 1.0;
  for (int64_t i = 0; i < rows.n; i++) {
    row = (Vector){rows.p + i * rows.m, rows.m};
    off = max_float(fabs(row.p[targets_rectangles_CENTRE_X] - x) / row.p[targets_rectangles_WIDTH], fabs(row.p[targets_rectangles_CENTRE_Y] - y) / row.p[targets_rectangles_HEIGHT]);
    if (off < least) {
      best = i;
      least = off;
    }
  }
  return best;
}

/* The movement has ended where the cursor is: learn which target was taken, and forget it. */
void targets_heading_learn_target(targets_heading_Memory * memory, T_Table__Vector__Table__Vector_ targets) {
  targets_cursor_State * s;
  Table rows, keys;
  Vector own;
  double end;
  s = &memory->cursor;
  rows = targets.f0;
  own = targets.f1;
  keys = targets.f2;
  end = targets_heading_ended(memory, rows);
  if (end == end) {
    targets_past_learn(&memory->person.past, own, keys, targets_heading_taken(rows, s->x, s->y));
  }
  memset(&memory->movement, 0, sizeof(targets_heading_Movement));
}

/* The movement has ended where the cursor is: learn from it, and forget it. */
void targets_aim_conclude(targets_heading_Memory * memory, T_Table__Vector__Table__Vector_ targets, targets_posterior_Coefficients * coefficients) {
  targets_aim_learn_prediction(memory, targets, coefficients);
  targets_heading_learn_target(memory, targets);
}

/* The expected size of what the movement ends in, px. */
double targets_aim_size_of(Table rows, Vector shares) {
  double size, total;
  size = targets_aim_SIZE_PX * shares.p[rows.n];
  total = shares.p[rows.n];
  for (int64_t i = 0; i < rows.n; i++) {
    size += shares.p[i] * 0.5 * (rows.p[i * rows.m + targets_rectangles_WIDTH] + rows.p[i * rows.m + targets_rectangles_HEIGHT]);
    total += shares.p[i];
  }
  return max_float(size / total, 1.0);
}

/* Remember what is stated now, if the last moment is far enough back. */
void targets_aim_record(targets_heading_Movement * movement, targets_cursor_State * s, targets_endpoint_Ellipse region, T10d answer) {
  targets_heading_Moment * last, *m;
  int64_t number;
  bool full;
  last = &movement->moments[max_whole((int64_t)movement->series.count - 1, 0)];
  Tqb values_1 = predictors_adaptation_moments_next_moment(&movement->series, last->t, (T3d){s->t, s->x, s->y}, targets_heading_MOST);
  number = values_1.f0;
  full = values_1.f1;
  if (number < 0) {
    return;
  }
  if (full) {
    for (int64_t k = 1; k < number; k++) {
      stage_copy_values((Vector){(double *)&movement->moments[2 * k], 32}, (Vector){(double *)&movement->moments[k], 32});
    }
  }
  m = &movement->moments[number];
  m->t = s->t;
  m->x = region.x;
  m->y = region.y;
  m->sxx = region.sxx;
  m->sxy = region.sxy;
  m->syy = region.syy;
  m->tail = region.tail;
  for (int64_t i = 0; i < 10; i++) {
    m->answer[i] = ((const double *)&answer)[i];
  }
  stage_copy_values((Vector){(double *)s, 15}, (Vector){(double *)&m->cursor, 15});
}

/* The share of the time that has passed; without a time left, of ``usual``, the usual duration, s. */
double targets_aim_share_passed(double since, double left, double usual) {
  double total;
  total = left == left ? since + left : max_float(usual, since);
  return total > 0.0 ? since / total : 0.0;
}

/* The share of movements to none of the targets; ``first``: what it is at least, and at first. */
double targets_past_elsewhere(targets_past_Past * s, double first) {
  double learned;
  learned = (first * targets_past_FIRST_OF + s->none) / (targets_past_FIRST_OF + s->to + s->none);
  return max_float(min_float(learned, targets_past_NONE_MOST), first);
}

/* Write the weights of the targets before a movement, as logarithms, into their table. */
void targets_past_weigh(targets_past_Past * s, Vector own, Table keys, Table table) {
  Table by_rule;
  double total;
  if (s->to == 0.0) {
    for (int64_t i = 0; i < own.n; i++) {
      table.p[i * table.m + targets_rectangles_LOG_WEIGHT] = own.p[i];
    }
    return;
  }
  RELEASED double *buffer_1 = reserved(targets_past_RULES * own.n);
  by_rule = (Table){buffer_1, targets_past_RULES, own.n};
  targets_past_shares(s, own, keys, by_rule);
  for (int64_t i = 0; i < own.n; i++) {
    total = 0.0;
    for (int64_t rule = 0; rule < targets_past_RULES; rule++) {
      total = total + targets_past_rule_weight(s, rule) * by_rule.p[rule * by_rule.m + i];
    }
    table.p[i * table.m + targets_rectangles_LOG_WEIGHT] = total > 0.0 ? log(total) : -INFINITY;
  }
}

/* A movement begins: lay out how likely each target is before it. */
void targets_heading_begin(targets_heading_Memory * memory, T_Table__Vector__Table__Vector_ targets) {
  Table rows, keys;
  Vector own, shares;
  double none, total;
  rows = targets.f0;
  own = targets.f1;
  keys = targets.f2;
  shares = targets.f3;
  none = targets_past_elsewhere(&memory->person.past, memory->settings.elsewhere);
  targets_past_weigh(&memory->person.past, own, keys, rows);
  memory->movement.elsewhere = none;
  total = none;
  shares.p[rows.n] = none;
  for (int64_t i = 0; i < rows.n; i++) {
    shares.p[i] = rows.p[i * rows.m + targets_rectangles_LOG_WEIGHT] > -INFINITY ? (1.0 - none) * exp(rows.p[i * rows.m + targets_rectangles_LOG_WEIGHT]) : 0.0;
    total += shares.p[i];
  }
  for (int64_t i = 0; i < shares.n; i++) {
    shares.p[i] = shares.p[i] / total;
  }
}

/* Take in an event. Where a movement begins with it, learn which target the last one took. */
void targets_heading_follow(targets_heading_Memory * memory, T6d event, T_Table__Vector__Table__Vector_ targets) {
  double t, x, y, buttons, pressed;
  targets_cursor_State * s;
  targets_heading_Movement * movement;
  t = event.f0;
  x = event.f1;
  y = event.f2;
  buttons = event.f5;
  s = &memory->cursor;
  movement = &memory->movement;
  pressed = (double)((int64_t)buttons & 1);
  if (targets_cursor_begins(s, t, pressed)) {
    targets_heading_learn_target(memory, targets);
    targets_heading_begin(memory, targets);
  }
  movement->samples += t > s->t || movement->samples == 0.0 ? 1.0 : 0.0;
  movement->released = targets_cursor_follow(s, t, x, y, pressed) ? 1.0 : 0.0;
}

/* Write how likely each target is after the last event, by the prediction made at it. */
void targets_heading_weigh(targets_heading_Memory * memory, T10d answer, T_Table__Vector__Table__Vector_ targets, targets_posterior_Coefficients * coefficients) {
  Table rows;
  Vector shares;
  targets_heading_Movement * movement;
  rows = targets.f0;
  shares = targets.f3;
  movement = &memory->movement;
  targets_posterior_scores(&memory->cursor, rows, answer, coefficients, movement->elsewhere, shares);
  targets_posterior_normalise(shares);
  movement->remaining_s = answer.f6;
  movement->claimed = 0.0;
}

/* The point of the least expected distance (Weiszfeld), px, softened by the size of each part. */
WIDE T2d targets_endpoint_geometric_median(Table parts, int64_t count) {
  double x, y, sum_x, sum_y, total, dx, dy, weight;
  predictors_mixture_PartRow * part;
  x = 0.0;
  y = 0.0;
  for (int64_t k = 0; k < count; k++) {
    part = (predictors_mixture_PartRow *)((Vector){parts.p + k * parts.m, parts.m}.p);
    x += part->share * part->x;
    y += part->share * part->y;
  }
  for (int64_t i_1 = 0; i_1 < targets_endpoint_STEPS; i_1++) {
    sum_x = 0.0;
    sum_y = 0.0;
    total = 0.0;
    for (int64_t k = 0; k < count; k++) {
      part = (predictors_mixture_PartRow *)((Vector){parts.p + k * parts.m, parts.m}.p);
      dx = part->x - x;
      dy = part->y - y;
      weight = part->share / sqrt(dx * dx + dy * dy + max_float(0.5 * (part->sxx + part->syy), targets_endpoint_LEAST_PX2));
      sum_x += weight * part->x;
      sum_y += weight * part->y;
      total += weight;
    }
    x = sum_x / total;
    y = sum_y / total;
  }
  return (T2d){x, y};
}

/* The mixture as one law about its median, its axes along and across the way of the movement. */
targets_endpoint_Ellipse targets_endpoint_ellipse(Table parts, int64_t count, T2d centre, T2d way) {
  double x, y, size, ux, uy, wide, broad, dx, dy, along, across, cross, wide2, broad2, sxx, syy;
  predictors_mixture_PartRow * part;
  x = centre.f0;
  y = centre.f1;
  size = hypot(way.f0, way.f1);
  T2d values_1 = size > 0.0 ? (T2d){way.f0 / size, way.f1 / size} : (T2d){1.0, 0.0};
  ux = values_1.f0;
  uy = values_1.f1;
  wide = 0.0;
  broad = 0.0;
  for (int64_t k = 0; k < count; k++) {
    part = (predictors_mixture_PartRow *)((Vector){parts.p + k * parts.m, parts.m}.p);
    dx = part->x - x;
    dy = part->y - y;
    along = dx * ux + dy * uy;
    across = dy * ux - dx * uy;
    cross = 2.0 * part->sxy * ux * uy;
    wide += part->share * sqrt(along * along + part->sxx * ux * ux + cross + part->syy * uy * uy);
    broad += part->share * sqrt(across * across + part->sxx * uy * uy - cross + part->syy * ux * ux);
  }
  wide2 = targets_endpoint_RADII2 * wide * wide;
  broad2 = targets_endpoint_RADII2 * broad * broad;
  sxx = wide2 * ux * ux + broad2 * uy * uy;
  syy = wide2 * uy * uy + broad2 * ux * ux;
  return (targets_endpoint_Ellipse){x, y, sxx, (wide2 - broad2) * ux * uy, syy, targets_endpoint_TAIL};
}

/* What the time left is a sum of, in mean durations, of which each is ``usual`` s. */
T7d targets_arrival_terms(double predicted, double since, double usual, double left_px, double size_px) {
  double own, passed, difficulty, near, both, with_clock;
  own = min_float(predicted / usual, predictors_adaptation_time_left_LONGEST);
  passed = min_float(since / usual, predictors_adaptation_time_left_LONGEST);
  difficulty = min_float(log(1.0 + left_px / size_px) / (targets_arrival_DIFFICULTY_OF * log(2.0)), predictors_adaptation_time_left_LONGEST);
  near = size_px * size_px / (size_px * size_px + left_px * left_px);
  both = min_float(own * difficulty, predictors_adaptation_time_left_LONGEST);
  with_clock = min_float(passed * difficulty, predictors_adaptation_time_left_LONGEST);
  return (T7d){own, 1.0, max_float(1.0 - passed, 0.0), difficulty, both, near, with_clock};
}

/* Take in an event and the prediction made at it: the prediction given the targets. */
T10d targets_aim_step(targets_heading_Memory * memory, T6d event, T10d answer, T_Table__Vector__Table__Vector_ targets, targets_posterior_Coefficients * coefficients) {
  double t, x, y, buttons, least, since, left, spread, usual, way, share, factor, tail, phase;
  Table rows, parts;
  Vector shares;
  targets_cursor_State * s;
  targets_heading_Movement * movement;
  targets_heading_Person * person;
  targets_posterior_Law predicted;
  int64_t count;
  T2d end;
  targets_endpoint_Ellipse region;
  T7d known;
  t = event.f0;
  x = event.f1;
  y = event.f2;
  buttons = event.f5;
  rows = targets.f0;
  shares = targets.f3;
  s = &memory->cursor;
  movement = &memory->movement;
  person = &memory->person;
  if (targets_cursor_begins(s, t, (double)((int64_t)buttons & 1))) {
    targets_aim_learn_prediction(memory, targets, coefficients);
  }
  targets_heading_follow(memory, event, targets);
  targets_heading_weigh(memory, answer, targets, coefficients);
  if (answer.f1 != answer.f1 || rows.n == 0) {
    return answer;
  }
  predicted = targets_endpoint_elsewhere(s, answer);
  movement->claimed = 1.0;
  for (int64_t i = 0; i < 6; i++) {
    movement->elsewhere_law[i] = ((const double *)&predicted)[i];
  }
  RELEASED double *buffer_1 = reserved((rows.n + 1) * 7);
  parts = (Table){buffer_1, rows.n + 1, 7};
  least = min_float(targets_endpoint_NEGLIGIBLE, 0.5 / max_whole(rows.n, 1));
  count = targets_endpoint_mixture(rows, shares, predicted, least, parts);
  end = targets_endpoint_geometric_median(parts, count);
  region = targets_endpoint_ellipse(parts, count, end, (T2d){x - s->x0, y - s->y0});
  since = t - s->t0;
  left = answer.f6;
  spread = answer.f9;
  usual = targets_arrival_mean(&person->durations);
  if (usual > 0.0 && left == left) {
    way = hypot(end.f0 - x, end.f1 - y);
    known = targets_arrival_terms(left, since, usual, way, targets_aim_size_of(rows, shares));
    T2d values_2 = predictors_adaptation_time_left_weighed(&person->time_left, &person->intervals, &movement->time_left, (T3d){t, x, y}, since, usual, left, known, (Vector){(double *)targets_arrival_prior_PRIOR, 35});
    left = values_2.f0;
    spread = values_2.f1;
  }
  share = targets_aim_share_passed(since, left, usual);
  T2d values_3 = predictors_adaptation_region_widening_widen(&person->regions, share, region.tail);
  factor = values_3.f0;
  tail = values_3.f1;
  region = (targets_endpoint_Ellipse){region.x, region.y, factor * region.sxx, factor * region.sxy, factor * region.syy, tail};
  if (memory->settings.learn == 1.0) {
    targets_aim_record(movement, s, region, answer);
  }
  movement->remaining_s = left;
  phase = answer.f7;
  return (T10d){t, region.x, region.y, region.sxx, region.sxy, region.syy, left, phase, tail, spread};
}

/* Write the parts of the law of the endpoint as it was stated last, elsewhere first, a row each. */
Tq2d targets_aim_lay_parts(targets_heading_Memory * memory, T_Table__Vector__Table__Vector_ targets, Table out) {
  targets_cursor_State * s;
  targets_heading_Movement * movement;
  Vector law_of;
  targets_posterior_Law predicted;
  int64_t count;
  targets_heading_Person * person;
  double share;
  predictors_adaptation_levels_Offsets * mixed;
  s = &memory->cursor;
  movement = &memory->movement;
  if (movement->claimed == 0.0) {
    return (Tq2d){0, 0.0, 0.0};
  }
  law_of = (Vector){movement->elsewhere_law, 6};
  predicted = (targets_posterior_Law){law_of.p[0], law_of.p[1], law_of.p[2], law_of.p[3], law_of.p[4], law_of.p[5]};
  count = targets_endpoint_mixture(targets.f0, targets.f3, predicted, targets_aim_LIKELY, out);
  person = &memory->person;
  share = targets_aim_share_passed(s->t - s->t0, movement->remaining_s, targets_arrival_mean(&person->durations));
  mixed = &person->regions.mixed;
  return (Tq2d){count, predictors_adaptation_levels_offset(mixed, share, 0), predictors_adaptation_levels_offset(mixed, share, 1)};
}

/* ``step`` over tables; the predictions take the place of ``answers``. */
void targets_aim_walk(targets_heading_Memory * memory, FlagVector begins, Table events, Table answers, T_Table__Vector__Table__Vector_ targets, targets_posterior_Coefficients * coefficients) {
  T10d answer;
  for (int64_t i = 0; i < events.n; i++) {
    if (begins.p[i]) {
      targets_aim_conclude(memory, targets, coefficients);
      memset(&memory->cursor, 0, sizeof(targets_cursor_State));
    }
    answer = targets_aim_step(memory, records_event_at(events, i), records_row_at(answers, i), targets, coefficients);
    for (int64_t j = 0; j < 10; j++) {
      answers.p[i * answers.m + j] = ((const double *)&answer)[j];
    }
  }
}

/* What is wrong with what is known of a person, as ``time_left.fault`` says it; FINE for nothing. */
Tqd targets_aim_fault(targets_heading_Person * learned) {
  return predictors_adaptation_time_left_fault(&learned->time_left, (Vector){(double *)targets_arrival_prior_PRIOR, 35});
}

/* The smallest target that the cursor is in, of equal ones the last; NOBODY where there is none. */
int64_t targets_choice_law_innermost(Table table, Vector inside) {
  int64_t best;
  double area;
  best = targets_rectangles_NOBODY;
  for (int64_t i = 0; i < table.n; i++) {
    if (inside.p[i] == targets_choice_law_OUTSIDE || inside.p[i] == targets_choice_law_RELEASED || table.p[i * table.m + targets_rectangles_LOG_WEIGHT] == -INFINITY) {
      continue;
    }
    area = table.p[i * table.m + targets_rectangles_WIDTH] * table.p[i * table.m + targets_rectangles_HEIGHT];
    if (best == targets_rectangles_NOBODY || area <= table.p[best * table.m + targets_rectangles_WIDTH] * table.p[best * table.m + targets_rectangles_HEIGHT]) {
      best = i;
    }
  }
  return best;
}

/* Write where the cursor is for each target; returns how many it has just gone into. */
int64_t targets_choice_law_enter(Table table, Vector inside, double x, double y, bool released) {
  int64_t count;
  Vector row;
  count = 0;
  for (int64_t i = 0; i < table.n; i++) {
    row = (Vector){table.p + i * table.m, table.m};
    if (fabs(row.p[targets_rectangles_CENTRE_X] - x) <= 0.5 * row.p[targets_rectangles_WIDTH] && fabs(row.p[targets_rectangles_CENTRE_Y] - y) <= 0.5 * row.p[targets_rectangles_HEIGHT]) {
      if (inside.p[i] == targets_choice_law_OUTSIDE) {
        inside.p[i] = targets_choice_law_ENTERED;
        count += 1;
      } else {
        inside.p[i] = released || inside.p[i] == targets_choice_law_RELEASED ? targets_choice_law_RELEASED : targets_choice_law_INSIDE;
      }
    } else {
      inside.p[i] = targets_choice_law_OUTSIDE;
    }
  }
  return count;
}

/* What follows from the shares at an event that the cursor has taken in. */
T3q targets_choice_law_decide(targets_cursor_State * s, bool released, double remaining_s, T_Table_2_Vector_ targets, targets_decision_Settings settings, int64_t standing) {
  Table table;
  Vector inside, shares;
  int64_t count, chosen, over;
  double ask, least_s;
  T4d bounds;
  table = targets.f0;
  inside = targets.f1;
  shares = targets.f2;
  if (released) {
    standing = targets_rectangles_NOBODY;
  }
  count = targets_choice_law_enter(table, inside, s->x, s->y, released);
  ask = settings.precision;
  least_s = settings.least_lead_s;
  bounds = (T4d){ask, targets_choice_law_KEEP * ask, least_s, settings.least_way_px};
  chosen = targets_decision_decide(s, table, shares, standing, remaining_s, bounds);
  over = targets_choice_law_innermost(table, inside);
  return (T3q){chosen, over == chosen ? targets_rectangles_NOBODY : over, count};
}

/* What ends and what begins: a prediction and an entry that end, a prediction and an entry that begin. */
T4q targets_choice_law_changes(T2q before, T2q now) {
  int64_t predicted, entered, chosen, over, ends, leaves, begins, enters;
  predicted = before.f0;
  entered = before.f1;
  chosen = now.f0;
  over = now.f1;
  ends = predicted;
  leaves = entered;
  begins = chosen;
  enters = over;
  if (predicted == chosen) {
    begins = targets_rectangles_NOBODY;
    ends = begins;
  }
  if (entered == over) {
    enters = targets_rectangles_NOBODY;
    leaves = enters;
  }
  if (predicted == over) {
    enters = targets_rectangles_NOBODY;
    ends = enters;
  }
  if (entered == chosen) {
    begins = targets_rectangles_NOBODY;
    leaves = begins;
  }
  return (T4q){ends, leaves, begins, enters};
}

/* The row of a target; NOBODY where it has none, unless ``new`` and there is room for another. */
int64_t targets_ledger_row_of(targets_ledger_Account * s, Table rows, double key, bool new) {
  int64_t count;
  count = (int64_t)s->rows;
  for (int64_t i = 0; i < count; i++) {
    if (rows.p[i * rows.m + targets_ledger_KEY] == key) {
      return i;
    }
  }
  if (!new || count == rows.n) {
    return targets_rectangles_NOBODY;
  }
  s->rows += 1.0;
  rows.p[count * rows.m + targets_ledger_MADE] = 0.0;
  rows.p[count * rows.m + targets_ledger_ENTRY] = NAN;
  rows.p[count * rows.m + targets_ledger_ENTRY_SINCE] = NAN;
  rows.p[count * rows.m + targets_ledger_KEY] = key;
  return count;
}

/* The cursor goes into this target. */
void targets_ledger_note_entry(targets_ledger_Account * s, Table rows, double t, double key) {
  targets_ledger_State * value_1 = &s->movement;
  Table value_2 = rows;
  int64_t value_4 = targets_ledger_row_of(s, rows, key, true);
  targets_ledger_enter(value_1, value_2, t, value_4);
}

/* The proposal of this target that stands ends, as ``withdraw`` says. */
void targets_ledger_note_end(targets_ledger_Account * s, Table rows, double t, double key, bool released) {
  targets_ledger_State * value_1 = &s->movement;
  int64_t value_3 = targets_ledger_row_of(s, rows, key, false);
  targets_ledger_withdraw(value_1, t, value_3, released);
}

/* A proposal of the target of this number is made. */
void targets_ledger_note_proposal(targets_ledger_Account * s, Table rows, double t, double key) {
  targets_ledger_State * value_1 = &s->movement;
  Table value_2 = rows;
  int64_t value_4 = targets_ledger_row_of(s, rows, key, true);
  targets_ledger_propose(value_1, value_2, t, value_4);
}

/* Decide after the event that ``memory`` took in last; returns whether something changes. */
bool targets_choice_law_update(targets_choice_law_State * s, targets_heading_Memory * memory, T_Table_2_Vector_ targets, Table keys, targets_decision_Settings settings, targets_ledger_Account * account, Table rows, Vector out) {
  Vector inside;
  targets_cursor_State * now;
  bool released;
  T2q before;
  double left_s;
  int64_t chosen, over, count;
  inside = targets.f1;
  now = &memory->cursor;
  released = memory->movement.released == 1.0;
  before = (T2q){(int64_t)s->predicted, (int64_t)s->entered};
  left_s = memory->movement.remaining_s;
  T3q values_1 = targets_choice_law_decide(now, released, left_s, targets, settings, before.f0);
  chosen = values_1.f0;
  over = values_1.f1;
  count = values_1.f2;
  if (before.f0 == chosen && before.f1 == over && count == 0) {
    return false;
  }
  for (int64_t i = 0; i < inside.n; i++) {
    if (inside.p[i] == targets_choice_law_ENTERED) {
      targets_ledger_note_entry(account, rows, now->t, keys.p[i * keys.m + targets_past_ID]);
    }
  }
  if (before.f0 != chosen && before.f0 != targets_rectangles_NOBODY) {
    targets_ledger_note_end(account, rows, now->t, keys.p[before.f0 * keys.m + targets_past_ID], released);
  }
  if (before.f0 != chosen && chosen != targets_rectangles_NOBODY) {
    targets_ledger_note_proposal(account, rows, now->t, keys.p[chosen * keys.m + targets_past_ID]);
  }
  if (before.f1 != over && over != targets_rectangles_NOBODY) {
    account->movement.entered += 1.0;
  }
  s->predicted = chosen;
  s->entered = over;
  T4q values_2 = targets_choice_law_changes(before, (T2q){chosen, over});
  out.p[0] = values_2.f0;
  out.p[1] = values_2.f1;
  out.p[2] = values_2.f2;
  out.p[3] = values_2.f3;
  return true;
}

/* Where the target of a number is, looked for from ``first`` on and around; NOBODY where it is not. */
int64_t targets_choice_law_place_of(Table keys, double key, int64_t first) {
  int64_t i;
  for (int64_t k = 0; k < keys.n; k++) {
    i = remainder_whole(first + k, keys.n);
    if (keys.p[i * keys.m + targets_past_ID] == key) {
      return i;
    }
  }
  return targets_rectangles_NOBODY;
}

/* Go on with other targets: the numbers of those before and where the cursor was, and those from now on. */
T2b targets_choice_law_replace(targets_choice_law_State * s, double t, T_Table__Vector_ before, T_Table__Vector_ now, targets_ledger_Account * account, Table rows) {
  Table keys, new_keys;
  Vector inside, new_inside;
  int64_t near, place, predicted, entered;
  keys = before.f0;
  inside = before.f1;
  new_keys = now.f0;
  new_inside = now.f1;
  near = 0;
  for (int64_t i = 0; i < new_keys.n; i++) {
    place = targets_choice_law_place_of(keys, new_keys.p[i * new_keys.m + targets_past_ID], near);
    new_inside.p[i] = targets_choice_law_OUTSIDE;
    if (place != targets_rectangles_NOBODY) {
      new_inside.p[i] = inside.p[place] == targets_choice_law_ENTERED ? targets_choice_law_INSIDE : inside.p[place];
      near = place + 1;
    }
  }
  predicted = (int64_t)s->predicted;
  entered = (int64_t)s->entered;
  if (predicted != targets_rectangles_NOBODY) {
    s->predicted = targets_choice_law_place_of(new_keys, keys.p[predicted * keys.m + targets_past_ID], predicted);
    if (s->predicted == targets_rectangles_NOBODY) {
      targets_ledger_note_end(account, rows, t, keys.p[predicted * keys.m + targets_past_ID], false);
    }
  }
  if (entered != targets_rectangles_NOBODY) {
    s->entered = targets_choice_law_place_of(new_keys, keys.p[entered * keys.m + targets_past_ID], entered);
  }
  return (T2b){predicted != targets_rectangles_NOBODY && s->predicted == targets_rectangles_NOBODY, entered != targets_rectangles_NOBODY && s->entered == targets_rectangles_NOBODY};
}

/* Nothing is proposed; a target that the cursor is in has to be left before it is entered again. */
void targets_choice_law_reset(targets_choice_law_State * s, Vector inside) {
  s->entered = targets_rectangles_NOBODY;
  s->predicted = s->entered;
  for (int64_t i = 0; i < inside.n; i++) {
    if (inside.p[i] != targets_choice_law_OUTSIDE) {
      inside.p[i] = targets_choice_law_RELEASED;
    }
  }
}

/* Places as targets. ``places``: x, y, p, number, spread, a row each; ``shares``: also of none of them. */
void targets_choice_law_lay_places(Table places, Table table, Table keys, Vector shares) {
  double known;
  known = 0.0;
  for (int64_t i = 0; i < places.n; i++) {
    table.p[i * table.m + targets_rectangles_CENTRE_X] = places.p[i * places.m + 0];
    table.p[i * table.m + targets_rectangles_CENTRE_Y] = places.p[i * places.m + 1];
    table.p[i * table.m + targets_rectangles_LOG_WEIGHT] = 0.0;
    shares.p[i] = places.p[i * places.m + 2];
    keys.p[i * keys.m + targets_past_ID] = places.p[i * places.m + 3];
    table.p[i * table.m + targets_rectangles_HEIGHT] = max_float(targets_posterior_EFFECTIVE * places.p[i * places.m + 4], targets_choice_law_LEAST_PX);
    table.p[i * table.m + targets_rectangles_WIDTH] = table.p[i * table.m + targets_rectangles_HEIGHT];
    known += places.p[i * places.m + 2];
  }
  shares.p[places.n] = max_float(1.0 - known, 0.0);
}

/* Whether an event's numbers are finite and within the bounds of events. */
bool targets_cursor_usable(double t, double x, double y) {
  return fabs(t) < records_LATEST_S && fabs(x) <= records_LARGEST && fabs(y) <= records_LARGEST;
}

/* The places of the largest shares into ``order``, best first, the first of equal ones before the others. */
WIDE void targets_decision_rank(Vector shares, int64_t count, Vector order) {
  int64_t place;
  for (int64_t k = 0; k < order.n; k++) {
    order.p[k] = targets_rectangles_NOBODY;
  }
  for (int64_t i = 0; i < count; i++) {
    place = order.n;
    while (place > 0 && (order.p[place - 1] == targets_rectangles_NOBODY || shares.p[i] > shares.p[(int64_t)order.p[place - 1]])) {
      place -= 1;
    }
    if (place < order.n) {
      for (int64_t later = order.n - 1; later > place; later--) {
        order.p[later] = order.p[later - 1];
      }
      order.p[place] = i;
    }
  }
}

/* Add a movement: how many it proposed, whether it was hit, wasted, retracted, and entered. */
void targets_ledger_add(targets_ledger_Totals * s, T5d movement) {
  double proposed, hit, wasted, retracted, entered;
  proposed = movement.f0;
  hit = movement.f1;
  wasted = movement.f2;
  retracted = movement.f3;
  entered = movement.f4;
  s->movements += 1.0;
  s->proposed += proposed;
  s->right += proposed - wasted;
  s->hits += hit;
  s->wasted += wasted;
  s->retracted += retracted;
  s->entered += entered;
}

/* Forget the movement. */
void targets_ledger_drop(targets_ledger_Account * s) {
  memset(&s->movement, 0, sizeof(targets_ledger_State));
  s->movement.ended = targets_rectangles_NOBODY;
  s->movement.standing = s->movement.ended;
  s->rows = 0.0;
}

/* Close the movement, for the target of this number or NOBODY, and add it to the totals. */
T6d targets_ledger_finish(targets_ledger_Account * s, Table rows, double t, double key) {
  double right, entry_s, click_s, proposed, retracted, entered, hit;
  targets_ledger_State * value_1 = &s->movement;
  Table value_2 = rows;
  int64_t value_4 = targets_ledger_row_of(s, rows, key, false);
  T3d values_5 = targets_ledger_close(value_1, value_2, t, value_4);
  right = values_5.f0;
  entry_s = values_5.f1;
  click_s = values_5.f2;
  proposed = s->movement.proposed;
  retracted = s->movement.retracted;
  entered = s->movement.entered;
  hit = entry_s == entry_s ? 1.0 : 0.0;
  targets_ledger_add(&s->totals, (T5d){proposed, hit, proposed - right, retracted, entered});
  targets_ledger_drop(s);
  return (T6d){proposed, proposed - right, retracted, entered, entry_s, click_s};
}

/* A row of features for each target and a predicted law. */
void targets_posterior_features(targets_cursor_State * s, Table table, targets_posterior_Law predicted, Table out) {
  targets_posterior_Situation now;
  Vector f;
  now = targets_posterior_situation(s);
  for (int64_t i = 0; i < table.n; i++) {
    f = (Vector){out.p + i * out.m, out.m};
    T6d values_1 = targets_posterior_feature((Vector){table.p + i * table.m, table.m}, now, predicted);
    f.p[targets_posterior_MASS] = values_1.f0;
    f.p[targets_posterior_TRAIL] = values_1.f1;
    f.p[targets_posterior_HEADING] = values_1.f2;
    f.p[targets_posterior_PER_WAY] = values_1.f3;
    f.p[targets_posterior_PER_SPEED] = values_1.f4;
    f.p[targets_posterior_NEAR] = values_1.f5;
  }
}

/* How many steps (dx, dy) from (x, y) until the rectangle is met, 0 inside; infinite if it never is. */
double targets_prefetch_contact(double x, double y, double dx, double dy, Vector row) {
  double enters, leaves, step, off, half, near, far;
  enters = 0.0;
  leaves = INFINITY;
  for (int64_t axis = 0; axis < 2; axis++) {
    step = axis == 0 ? dx : dy;
    off = axis == 0 ? row.p[targets_rectangles_CENTRE_X] - x : row.p[targets_rectangles_CENTRE_Y] - y;
    half = 0.5 * (axis == 0 ? row.p[targets_rectangles_WIDTH] : row.p[targets_rectangles_HEIGHT]);
    if (step == 0.0) {
      if (fabs(off) > half) {
        return INFINITY;
      }
    } else {
      near = (off - half) / step;
      far = (off + half) / step;
      enters = max_float(enters, min_float(near, far));
      leaves = min_float(leaves, max_float(near, far));
    }
  }
  return enters <= leaves ? enters : INFINITY;
}

/* Whether a point lies in a rectangle, its border included. */
bool targets_prefetch_inside(double x, double y, Vector row) {
  return fabs(row.p[targets_rectangles_CENTRE_X] - x) <= 0.5 * row.p[targets_rectangles_WIDTH] && fabs(row.p[targets_rectangles_CENTRE_Y] - y) <= 0.5 * row.p[targets_rectangles_HEIGHT];
}

/* How likely the cursor goes through each target: its share, and the shares of what lies behind it. */
void targets_prefetch_visit(double x, double y, Table table, Vector shares, Vector out) {
  Vector ends;
  int64_t end;
  double to_x, to_y, middle_x, middle_y, across, down, far_x, far_y;
  double buffer_1[8];
  ends = (Vector){buffer_1, targets_prefetch_PATHS};
  targets_decision_rank(shares, table.n, ends);
  for (int64_t i = 0; i < table.n; i++) {
    out.p[i] = shares.p[i];
  }
  for (int64_t place = 0; place < targets_prefetch_PATHS; place++) {
    end = (int64_t)ends.p[place];
    if (end == targets_rectangles_NOBODY || shares.p[end] < targets_prefetch_NEGLIGIBLE) {
      continue;
    }
    to_x = table.p[end * table.m + targets_rectangles_CENTRE_X] - x;
    to_y = table.p[end * table.m + targets_rectangles_CENTRE_Y] - y;
    middle_x = x + 0.5 * to_x;
    middle_y = y + 0.5 * to_y;
    across = 0.5 * fabs(to_x) + targets_prefetch_ROUNDING;
    down = 0.5 * fabs(to_y) + targets_prefetch_ROUNDING;
    for (int64_t i = 0; i < table.n; i++) {
      far_x = fabs(table.p[i * table.m + targets_rectangles_CENTRE_X] - middle_x);
      far_y = fabs(table.p[i * table.m + targets_rectangles_CENTRE_Y] - middle_y);
      if (far_x > across + 0.5 * table.p[i * table.m + targets_rectangles_WIDTH] || far_y > down + 0.5 * table.p[i * table.m + targets_rectangles_HEIGHT]) {
        continue;
      }
      if (i != end && targets_prefetch_contact(x, y, to_x, to_y, (Vector){table.p + i * table.m, table.m}) <= 1.0) {
        out.p[i] += shares.p[end];
      }
    }
  }
}

/* Arm every target anew where a movement has begun; those that it starts in first have to be left. */
void targets_prefetch_begin(targets_prefetch_State * s, Table table, Vector fired) {
  for (int64_t i = 0; i < table.n; i++) {
    if (fired.p[i] == targets_prefetch_PREDICTED || fired.p[i] == targets_prefetch_ENTERED) {
      fired.p[i] = targets_prefetch_FIRED;
    }
  }
  if (s->began == s->cursor.t0) {
    return;
  }
  s->began = s->cursor.t0;
  for (int64_t i = 0; i < table.n; i++) {
    if (fired.p[i] != targets_prefetch_ARMED) {
      fired.p[i] = targets_prefetch_inside(s->cursor.x0, s->cursor.y0, (Vector){table.p + i * table.m, table.m}) ? targets_prefetch_RESTING : targets_prefetch_ARMED;
    }
  }
}

/* Logarithm of p over 1 - p, finite also at 0 and 1. */
double targets_prefetch_log_odds(double p) {
  p = min_float(max_float(p, targets_prefetch_SMALLEST), 1.0 - targets_prefetch_SMALLEST);
  return log(p / (1.0 - p));
}

/* What the settings weigh of one target, in their order. */
T6d targets_prefetch_terms(targets_cursor_State * s, Vector row, double share, double visited, targets_prefetch_Expected expected) {
  double left_s, near, end;
  left_s = targets_cursor_until(s, row.p[targets_rectangles_CENTRE_X], row.p[targets_rectangles_CENTRE_Y], row.p[targets_rectangles_WIDTH], row.p[targets_rectangles_HEIGHT]);
  near = -log(min_float(max_float(left_s, targets_prefetch_SHORTEST_S), targets_prefetch_LONGEST_S) / targets_prefetch_REFERENCE_S);
  end = log(max_float(share, targets_prefetch_SMALLEST) / max_float(visited, targets_prefetch_SMALLEST));
  return (T6d){1.0, end, near, -near * near, log(max_float(expected.passed, targets_prefetch_LEAST_VISITS)), -expected.sure};
}

/* What ``step`` compares with the logarithm of the odds of a target's threshold. */
double targets_prefetch_score(targets_cursor_State * s, Vector row, double share, double visited, targets_prefetch_Expected expected, targets_prefetch_Settings * settings) {
  double t0, t1, t2, t3, t4, t5, total;
  T6d values_1 = targets_prefetch_terms(s, row, share, visited, expected);
  t0 = values_1.f0;
  t1 = values_1.f1;
  t2 = values_1.f2;
  t3 = values_1.f3;
  t4 = values_1.f4;
  t5 = values_1.f5;
  total = targets_prefetch_log_odds(visited) + settings->base * t0 + settings->end * t1 + settings->near * t2;
  total += settings->far * t3 + settings->passed * t4 + settings->sure * t5;
  return total;
}

/* How likely a visit must be at least for ``score`` to reach the lowest threshold, wherever it is. */
double targets_prefetch_least_visit(double lowest, targets_prefetch_Expected expected, targets_prefetch_Settings * settings) {
  double soon, late, most;
  soon = log(targets_prefetch_REFERENCE_S / targets_prefetch_SHORTEST_S);
  late = log(targets_prefetch_LONGEST_S / targets_prefetch_REFERENCE_S);
  most = max_float(settings->near * soon, -settings->near * late) + max_float(-settings->far, 0.0) * soon * soon;
  most += max_float(settings->end * log(targets_prefetch_SMALLEST), 0.0) + settings->base + targets_prefetch_ROUNDING;
  most += settings->passed * log(max_float(expected.passed, targets_prefetch_LEAST_VISITS)) - settings->sure * expected.sure;
  return 1.0 / (1.0 + exp(most - targets_prefetch_log_odds(lowest)));
}

/* What lies ahead of the cursor, without the targets that it is in. */
targets_prefetch_Expected targets_prefetch_expect(double x, double y, Table table, Vector visits, Vector shares) {
  double passed, sure;
  passed = 0.0;
  sure = 0.0;
  for (int64_t i = 0; i < table.n; i++) {
    if (!targets_prefetch_inside(x, y, (Vector){table.p + i * table.m, table.m})) {
      passed = passed + visits.p[i];
      sure = max_float(sure, shares.p[i]);
    }
  }
  return (targets_prefetch_Expected){passed, sure};
}

/* Decide which targets fire now; returns how many. */
int64_t targets_prefetch_step(targets_prefetch_State * s, T_Table_3_Vector_ targets, Vector shares, targets_prefetch_Settings * settings) {
  Table table;
  Vector thresholds, visits, fired;
  double x, y, lowest, least, reached;
  targets_prefetch_Expected expected;
  bool moves;
  int64_t count;
  table = targets.f0;
  thresholds = targets.f1;
  visits = targets.f2;
  fired = targets.f3;
  targets_prefetch_begin(s, table, fired);
  x = s->cursor.x;
  y = s->cursor.y;
  targets_prefetch_visit(x, y, table, shares, visits);
  expected = targets_prefetch_expect(x, y, table, visits, shares);
  moves = hypot(x - s->cursor.x0, y - s->cursor.y0) >= targets_prefetch_LEAST_WAY_PX;
  lowest = 1.0;
  for (int64_t i = 0; i < table.n; i++) {
    lowest = min_float(lowest, thresholds.p[i]);
  }
  least = targets_prefetch_least_visit(lowest, expected, settings);
  count = 0;
  for (int64_t i = 0; i < table.n; i++) {
    if (table.p[i * table.m + targets_rectangles_LOG_WEIGHT] == -INFINITY) {
      continue;
    }
    if (targets_prefetch_inside(x, y, (Vector){table.p + i * table.m, table.m})) {
      if (fired.p[i] == targets_prefetch_ARMED) {
        fired.p[i] = targets_prefetch_ENTERED;
        count = count + 1;
      }
      continue;
    }
    if (fired.p[i] == targets_prefetch_RESTING) {
      fired.p[i] = targets_prefetch_ARMED;
    }
    if (fired.p[i] != targets_prefetch_ARMED || !moves) {
      continue;
    }
    if (least > targets_prefetch_SMALLEST && visits.p[i] < least) {
      continue;
    }
    reached = targets_prefetch_score(&s->cursor, (Vector){table.p + i * table.m, table.m}, shares.p[i], visits.p[i], expected, settings);
    if (reached >= targets_prefetch_log_odds(thresholds.p[i])) {
      fired.p[i] = targets_prefetch_PREDICTED;
      count = count + 1;
    }
  }
  return count;
}

/* Rows of an upper left corner, a size and a weight become the table: centres, logarithms of weights. */
void targets_rectangles_complete(Table rows) {
  double most, weight, total;
  most = -INFINITY;
  for (int64_t i = 0; i < rows.n; i++) {
    rows.p[i * rows.m + targets_rectangles_CENTRE_X] += 0.5 * rows.p[i * rows.m + targets_rectangles_WIDTH];
    rows.p[i * rows.m + targets_rectangles_CENTRE_Y] += 0.5 * rows.p[i * rows.m + targets_rectangles_HEIGHT];
    weight = rows.p[i * rows.m + targets_rectangles_LOG_WEIGHT];
    rows.p[i * rows.m + targets_rectangles_LOG_WEIGHT] = weight > 0.0 ? log(weight) : -INFINITY;
    most = max_float(most, rows.p[i * rows.m + targets_rectangles_LOG_WEIGHT]);
  }
  if (most == -INFINITY) {
    return;
  }
  total = 0.0;
  for (int64_t i = 0; i < rows.n; i++) {
    total += exp(rows.p[i * rows.m + targets_rectangles_LOG_WEIGHT] - most);
  }
  for (int64_t i = 0; i < rows.n; i++) {
    rows.p[i * rows.m + targets_rectangles_LOG_WEIGHT] -= most + log(total);
  }
}
