/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const double targets_choice_law_ENTERED = 2.0;
static const double targets_choice_law_INSIDE = 1.0;
static const double targets_choice_law_KEEP = 0.4;
static const double targets_choice_law_OUTSIDE = 0.0;
static const double targets_choice_law_RELEASED = 3.0;
static const int64_t targets_expectation_BEFORE = 3;
static const int64_t targets_expectation_NONE = -1;
static const int64_t targets_expectation_SPREAD = 4;
static const int64_t targets_expectation_X = 0;
static const int64_t targets_expectation_Y = 1;
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
static const double targets_prefetch_SHORTEST_S = 0.005;
static const double targets_prefetch_SMALLEST = 1e-06;
static const int64_t targets_rectangles_CENTRE_X = 0;
static const int64_t targets_rectangles_CENTRE_Y = 1;
static const int64_t targets_rectangles_HEIGHT = 3;
static const int64_t targets_rectangles_LOG_WEIGHT = 4;
static const int64_t targets_rectangles_WIDTH = 2;

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
  best = targets_decision_NOBODY;
  for (int64_t i = 0; i < count; i++) {
    if (best == targets_decision_NOBODY || shares.p[i] > shares.p[best]) {
      best = i;
    }
  }
  return best;
}

/* Nothing is known of a movement yet, nor of the targets of these rows. */
void targets_ledger_begin(targets_ledger_State * s, Table rows) {
  memset(s, 0, sizeof(targets_ledger_State));
  s->ended = targets_decision_NOBODY;
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

/* The smallest target that the cursor is in, of equal ones the last; NOBODY where there is none. */
int64_t targets_choice_law_innermost(Table table, Vector inside) {
  int64_t best;
  double area;
  best = targets_decision_NOBODY;
  for (int64_t i = 0; i < table.n; i++) {
    if (inside.p[i] == targets_choice_law_OUTSIDE || inside.p[i] == targets_choice_law_RELEASED || table.p[i * table.m + targets_rectangles_LOG_WEIGHT] == -INFINITY) {
      continue;
    }
    area = table.p[i * table.m + targets_rectangles_WIDTH] * table.p[i * table.m + targets_rectangles_HEIGHT];
    if (best == targets_decision_NOBODY || area <= table.p[best * table.m + targets_rectangles_WIDTH] * table.p[best * table.m + targets_rectangles_HEIGHT]) {
      best = i;
    }
  }
  return best;
}

/* The smallest target that holds a point, of equal ones the nearest; NOBODY where there is none. */
int64_t targets_choice_law_holder(Table table, double x, double y) {
  int64_t best;
  double smallest, least, across, down, area, away;
  Vector row;
  best = targets_decision_NOBODY;
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

/* What follows from the shares at an event that ``cursor.follow`` has taken in, as ``step``. */
T3q targets_choice_law_propose(targets_cursor_State * s, T4d event, bool released, double remaining_s, T_Table_2_Vector_ targets, targets_posterior_Settings settings, int64_t standing) {
  double x, y, ask, least_s;
  Table table;
  Vector inside, shares;
  int64_t count, chosen, over;
  T4d bounds;
  x = event.f1;
  y = event.f2;
  table = targets.f0;
  inside = targets.f1;
  shares = targets.f2;
  if (released) {
    standing = targets_decision_NOBODY;
  }
  count = targets_choice_law_enter(table, inside, x, y, released);
  ask = settings.precision;
  least_s = settings.least_lead_s;
  bounds = (T4d){ask, targets_choice_law_KEEP * ask, least_s, settings.least_way_px};
  chosen = targets_decision_decide(s, table, shares, standing, remaining_s, bounds);
  over = targets_choice_law_innermost(table, inside);
  return (T3q){chosen, over == chosen ? targets_decision_NOBODY : over, count};
}

/* ``step`` where the shares have been written by somebody who knows them. */
T3q targets_choice_law_step_with_shares(targets_cursor_State * s, T4d event, double remaining_s, T_Table_2_Vector_ targets, targets_posterior_Settings settings, int64_t standing) {
  double t, x, y, pressed;
  bool released;
  t = event.f0;
  x = event.f1;
  y = event.f2;
  pressed = event.f3;
  released = targets_cursor_follow(s, t, x, y, pressed);
  return targets_choice_law_propose(s, event, released, remaining_s, targets, settings, standing);
}

/* Take in one usable event (t, x, y, pressed), with the prediction made at it. */
T3q targets_choice_law_step(targets_cursor_State * s, T4d event, T10d answer, T_Table_2_Vector_ targets, targets_posterior_Coefficients * coefficients, targets_posterior_Settings settings, int64_t standing) {
  double t, x, y, pressed;
  Table table;
  Vector shares;
  records_PredictionRow p;
  bool released;
  t = event.f0;
  x = event.f1;
  y = event.f2;
  pressed = event.f3;
  table = targets.f0;
  shares = targets.f2;
  p = records_PredictionRow_of_T10d(answer);
  released = targets_cursor_follow(s, t, x, y, pressed);
  targets_posterior_scores(s, table, answer, coefficients, settings.elsewhere, shares);
  targets_posterior_normalise(shares);
  return targets_choice_law_propose(s, event, released, p.remaining_s, targets, settings, standing);
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
    begins = targets_decision_NOBODY;
    ends = begins;
  }
  if (entered == over) {
    enters = targets_decision_NOBODY;
    leaves = enters;
  }
  if (predicted == over) {
    enters = targets_decision_NOBODY;
    ends = enters;
  }
  if (entered == chosen) {
    begins = targets_decision_NOBODY;
    leaves = begins;
  }
  return (T4q){ends, leaves, begins, enters};
}

/* Whether an event's numbers are finite and within the bounds of events. */
bool targets_cursor_usable(double t, double x, double y) {
  return fabs(t) < records_LATEST_S && fabs(x) <= records_LARGEST && fabs(y) <= records_LARGEST;
}

/* The first row that ``step`` must not be given, -1 where all are usable. */
int64_t targets_choice_law_unusable(targets_cursor_State * s, Table events) {
  double before, t;
  before = s->known == 1.0 ? s->t : -INFINITY;
  for (int64_t i = 0; i < events.n; i++) {
    t = events.p[i * events.m + 0];
    if (!targets_cursor_usable(t, events.p[i * events.m + 1], events.p[i * events.m + 2]) || t < before) {
      return i;
    }
    before = t;
  }
  return -1;
}

/* The places of the largest shares into ``order``, best first, the first of equal ones before the others. */
WIDE void targets_decision_rank(Vector shares, int64_t count, Vector order) {
  int64_t place;
  for (int64_t k = 0; k < order.n; k++) {
    order.p[k] = targets_decision_NOBODY;
  }
  for (int64_t i = 0; i < count; i++) {
    place = order.n;
    while (place > 0 && (order.p[place - 1] == targets_decision_NOBODY || shares.p[i] > shares.p[(int64_t)order.p[place - 1]])) {
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

/* Take in rows, from ``first`` up to and with the one at which there is something to note. */
T4q targets_choice_law_walk(targets_cursor_State * s, T3_Table_ tables, int64_t first, T_Table_2_Vector_ targets, targets_posterior_Coefficients * coefficients, targets_posterior_Settings settings, T2q proposed) {
  Table events, answers, likeliest;
  Vector shares;
  int64_t standing, over, most, chosen, now_over, entered, place;
  T4d event;
  events = tables.f0;
  answers = tables.f1;
  likeliest = tables.f2;
  shares = targets.f2;
  standing = proposed.f0;
  over = proposed.f1;
  most = floor_divided_whole(likeliest.m, 2);
  for (int64_t i = first; i < events.n; i++) {
    event = (T4d){events.p[i * events.m + 0], events.p[i * events.m + 1], events.p[i * events.m + 2], (double)((int64_t)events.p[i * events.m + 5] & 1)};
    T3q values_1 = targets_choice_law_step(s, event, records_row_at(answers, i), targets, coefficients, settings, standing);
    chosen = values_1.f0;
    now_over = values_1.f1;
    entered = values_1.f2;
    place = i - (events.n - likeliest.n);
    if (place >= 0) {
      targets_decision_rank(shares, shares.n, (Vector){likeliest.p + place * likeliest.m + 0, most - 0});
      for (int64_t k = 0; k < most; k++) {
        likeliest.p[place * likeliest.m + most + k] = shares.p[(int64_t)likeliest.p[place * likeliest.m + k]];
      }
    }
    if (chosen != standing || now_over != over || entered > 0) {
      return (T4q){i + 1, chosen, now_over, entered};
    }
  }
  return (T4q){events.n, standing, over, 0};
}

/* The target that a place belongs to; NONE for none. */
int64_t targets_expectation_target_of(Table table, Vector place) {
  int64_t best;
  double least, smallest, across, away, area;
  Vector target;
  bool nearer;
  best = targets_expectation_NONE;
  least = INFINITY;
  smallest = INFINITY;
  for (int64_t i = 0; i < table.n; i++) {
    target = (Vector){table.p + i * table.m, table.m};
    across = fabs(place.p[targets_expectation_X] - target.p[targets_rectangles_CENTRE_X]) - 0.5 * target.p[targets_rectangles_WIDTH];
    away = max_float(max_float(across, fabs(place.p[targets_expectation_Y] - target.p[targets_rectangles_CENTRE_Y]) - 0.5 * target.p[targets_rectangles_HEIGHT]), 0.0);
    area = target.p[targets_rectangles_WIDTH] * target.p[targets_rectangles_HEIGHT];
    nearer = away < least || (away == least && area < smallest);
    if (target.p[targets_rectangles_LOG_WEIGHT] > -INFINITY && away <= place.p[targets_expectation_SPREAD] && nearer) {
      best = i;
      least = away;
      smallest = area;
    }
  }
  return best;
}

/* Write the weights of targets with what is known of the person. */
void targets_expectation_expect(Table table, Vector own, Table known) {
  int64_t count, owner;
  Vector shares;
  double total;
  count = table.n;
  RELEASED double *buffer_1 = reserved(count);
  shares = (Vector){buffer_1, count};
  for (int64_t i = 0; i < count; i++) {
    table.p[i * table.m + targets_rectangles_LOG_WEIGHT] = own.p[i];
  }
  for (int64_t k = 0; k < known.n; k++) {
    owner = targets_expectation_target_of(table, (Vector){known.p + k * known.m, known.m});
    if (owner != targets_expectation_NONE) {
      shares.p[owner] += known.p[k * known.m + targets_expectation_BEFORE];
    }
  }
  total = 0.0;
  for (int64_t i = 0; i < count; i++) {
    table.p[i * table.m + targets_rectangles_LOG_WEIGHT] += log(1.0 + count * shares.p[i]);
    total += exp(table.p[i * table.m + targets_rectangles_LOG_WEIGHT]);
  }
  if (total == 0.0) {
    return;
  }
  for (int64_t i = 0; i < count; i++) {
    table.p[i * table.m + targets_rectangles_LOG_WEIGHT] -= log(total);
  }
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
  double total, to_x, to_y;
  int64_t end;
  double buffer_1[8];
  ends = (Vector){buffer_1, targets_prefetch_PATHS};
  targets_decision_rank(shares, table.n, ends);
  for (int64_t i = 0; i < table.n; i++) {
    total = shares.p[i];
    for (int64_t place = 0; place < targets_prefetch_PATHS; place++) {
      end = (int64_t)ends.p[place];
      if (end == targets_decision_NOBODY || end == i || shares.p[end] < targets_prefetch_NEGLIGIBLE) {
        continue;
      }
      to_x = table.p[end * table.m + targets_rectangles_CENTRE_X] - x;
      to_y = table.p[end * table.m + targets_rectangles_CENTRE_Y] - y;
      if (targets_prefetch_contact(x, y, to_x, to_y, (Vector){table.p + i * table.m, table.m}) <= 1.0) {
        total += shares.p[end];
      }
    }
    out.p[i] = total;
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
  double x, y, t0, t1, t2, t3, t4, t5, score;
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
    T6d values_1 = targets_prefetch_terms(&s->cursor, (Vector){table.p + i * table.m, table.m}, shares.p[i], visits.p[i], expected);
    t0 = values_1.f0;
    t1 = values_1.f1;
    t2 = values_1.f2;
    t3 = values_1.f3;
    t4 = values_1.f4;
    t5 = values_1.f5;
    score = targets_prefetch_log_odds(visits.p[i]) + settings->base * t0 + settings->end * t1 + settings->near * t2;
    score += settings->far * t3 + settings->passed * t4 + settings->sure * t5;
    if (score >= targets_prefetch_log_odds(thresholds.p[i])) {
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
