/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const T2d predictors_adaptation_arrival_intervals_DEVIATIONS = {0.6744897501960817, 1.2815515655446004};
static const double predictors_adaptation_arrival_intervals_FURTHEST = 3.0;
static const T2d predictors_adaptation_arrival_intervals_LEVELS = {0.5, 0.8};
static const double predictors_adaptation_arrival_intervals_MOVEMENTS_MOST = 1000000.0;
static const T2d predictors_adaptation_arrival_intervals_SHARES = {0.6666666666666666, 1.3333333333333333};
static const double predictors_adaptation_arrival_intervals_SPREAD = 0.6;
static const int64_t predictors_adaptation_arrival_intervals_STAGES = 3;
static const double predictors_adaptation_arrival_intervals_STEP = 12.0;
static const double predictors_adaptation_arrival_intervals_STEP_LEAST = 0.15;
static const double predictors_adaptation_arrival_intervals_STEP_OF = 5.0;
static const double predictors_adaptation_correction_APART_S = 0.005;
static const double predictors_adaptation_correction_BIAS_FADE = 0.2;
static const double predictors_adaptation_correction_EARLY = 0.1;
static const double predictors_adaptation_correction_FADE = 0.5;
static const double predictors_adaptation_correction_PLACES_FADE = 0.7;
static const int64_t predictors_adaptation_correction_TRACE_PLACES = 96;
static const int64_t predictors_adaptation_correction_UNEQUAL = 21;
static const double predictors_adaptation_destination_LEAST_SHARE = 0.0001;
static const double predictors_adaptation_destination_NEAREST = 2.5;
static const double predictors_adaptation_destination_NEARNESS = 1.25;
static const double predictors_adaptation_destination_NEGLIGIBLE = 0.001;
static const int64_t predictors_adaptation_destination_STEPS = 10;
static const T2d predictors_adaptation_distances_AGES = {1.5, 12.0};
static const double predictors_adaptation_distances_ARC = 0.5;
static const int64_t predictors_adaptation_distances_CAPACITY = 12;
static const int64_t predictors_adaptation_distances_FINE = 0;
static const double predictors_adaptation_distances_FORGET = 0.05;
static const int64_t predictors_adaptation_distances_HALVINGS = 10;
static const int64_t predictors_adaptation_distances_LAWS = 6;
static const int64_t predictors_adaptation_distances_LEAST = 2;
static const double predictors_adaptation_distances_LEAST_LIKELY = 1e-12;
static const double predictors_adaptation_distances_LEAST_UNKNOWN = 0.049;
static const double predictors_adaptation_distances_LOGISTIC = 1.7;
static const double predictors_adaptation_distances_NEGLIGIBLE = 0.0001;
static const int64_t predictors_adaptation_distances_NO_SHARES = 3;
static const double predictors_adaptation_distances_OFF_ONE = 1e-06;
static const int64_t predictors_adaptation_distances_TOO_SHORT = 1;
static const int64_t predictors_adaptation_distances_TOO_SURE = 2;
static const double predictors_adaptation_distances_UNKNOWN_LOGS = 3.0;
static const double predictors_adaptation_distances_UNKNOWN_SHARE = 0.98;
static const T3d predictors_adaptation_distances_WIDTHS = {0.02, 0.08, 0.35};
static const int64_t predictors_adaptation_durations_CAPACITY = 12;
static const int64_t predictors_adaptation_durations_FINE = 0;
static const T5d predictors_adaptation_durations_FIRST = {1.0, 0.92, 0.88, 0.9, 0.97};
static const double predictors_adaptation_durations_FIRST_OF = 5.0;
static const double predictors_adaptation_durations_KEEP = 0.97;
static const double predictors_adaptation_durations_LEAST = 0.05;
static const int64_t predictors_adaptation_durations_NO_DURATION = 11;
static const int64_t predictors_adaptation_durations_OTHER_MEDIAN = 12;
static const T5d predictors_adaptation_durations_SHARES = {0.0, 0.25, 0.5, 0.75, 1.0};
static const int64_t predictors_adaptation_habits_AFTER_SO_MANY = 2;
static const double predictors_adaptation_habits_AGE = 60.0;
static const T4d predictors_adaptation_habits_FIRST_RULES = {1.0, 0.15, 0.15, 0.15};
static const double predictors_adaptation_habits_FIRST_RULES_OF = 8.0;
static const int64_t predictors_adaptation_habits_FROM_HERE = 3;
static const double predictors_adaptation_habits_KEEP = 0.95;
static const int64_t predictors_adaptation_habits_LAGS = 16;
static const double predictors_adaptation_habits_LAG_KEEP = 0.95;
static const int64_t predictors_adaptation_habits_LATELY = 1;
static const double predictors_adaptation_habits_LATE_AGE = 3.0;
static const double predictors_adaptation_habits_LATE_ELSE = 0.1;
static const double predictors_adaptation_habits_LEAST_LOG = -200.0;
static const int64_t predictors_adaptation_habits_OFTEN = 0;
static const double predictors_adaptation_habits_OFTEN_OF = 0.7;
static const double predictors_adaptation_habits_RETURNS = 0.05;
static const double predictors_adaptation_habits_RETURNS_OF = 1.0;
static const int64_t predictors_adaptation_habits_RULES = 4;
static const T3d predictors_adaptation_habits_WIDTHS = {0.02, 0.05, 0.1};
static const double predictors_adaptation_habits_WIDTHS_OF = 3.0;
static const double predictors_adaptation_mixed_region_LEAST = 0.02;
static const double predictors_adaptation_mixed_region_LEAST_SPREAD = 0.5;
static const int64_t predictors_adaptation_mixed_region_MOST_PLACES = 4;
static const int64_t predictors_adaptation_mixed_region_POINTS = 32;
static const double predictors_adaptation_moments_LEAST_S = 0.08;
static const double predictors_adaptation_moments_NEAR_PX = 8.0;
static const double predictors_adaptation_moments_NEAR_SHARE = 0.03;
static const int64_t predictors_adaptation_moments_SAMPLES_LEAST = 6;
static const double predictors_adaptation_moments_SHORTEST_PX = 1e-06;
static const int64_t predictors_adaptation_places_CAPACITY = 64;
static const int64_t predictors_adaptation_places_FINE = 0;
static const double predictors_adaptation_places_KEEP = 0.97;
static const double predictors_adaptation_places_LIGHTEST = 1e-09;
static const int64_t predictors_adaptation_places_MOST_ENDED = INT64_C(131072);
static const int64_t predictors_adaptation_places_MOVEMENTS = 128;
static const double predictors_adaptation_places_NEAR_SHARE = 0.03;
static const double predictors_adaptation_places_NOWHERE = -1.0;
static const int64_t predictors_adaptation_places_NO_SUCH_PLACE = 42;
static const double predictors_adaptation_places_STEADIEST = 0.1;
static const int64_t predictors_adaptation_places_TOO_LIGHT = 41;
static const int64_t predictors_adaptation_predictor_ADAPT_OF = 0;
static const int64_t predictors_adaptation_predictor_BEFORE = 3;
static const int64_t predictors_adaptation_predictor_NUMBER = 5;
static const int64_t predictors_adaptation_predictor_P = 2;
static const int64_t predictors_adaptation_predictor_SPREAD = 6;
static const int64_t predictors_adaptation_predictor_VISITS = 4;
static const int64_t predictors_adaptation_predictor_X = 0;
static const int64_t predictors_adaptation_predictor_Y = 1;
static const int64_t predictors_adaptation_region_widening_HALVINGS = 12;
static const double predictors_adaptation_region_widening_HEAVIEST = 4.0;
static const int64_t predictors_adaptation_region_widening_JUDGED = 9;
static const double predictors_adaptation_region_widening_LIGHTEST = 0.02;
static const int64_t predictors_adaptation_region_widening_MOST = 48;
static const double predictors_adaptation_region_widening_MOVEMENTS_MOST = 1000000.0;
static const double predictors_adaptation_stages_DOUBT = 5.0;
static const double predictors_adaptation_stages_FURTHEST = 4.0;
static const double predictors_adaptation_stages_KEEP = 0.97;
static const double predictors_adaptation_stages_MOST_SHARE = 1000.0;
static const double predictors_adaptation_stages_RIDGE = 20.0;
static const int64_t predictors_adaptation_stages_STAGES = 5;
static const double predictors_adaptation_stages_TEMPO_MOST = 0.4;
static const double predictors_adaptation_stages_TEMPO_OF = 10.0;
static const double predictors_adaptation_stages_TEMPO_OFF = 0.3;
static const double predictors_adaptation_stages_WIDTHS_OF = 2.0;
static const double predictors_adaptation_time_left_FURTHEST = 20.0;
static const int64_t predictors_adaptation_time_left_JUDGED = 12;
static const double predictors_adaptation_time_left_KEEP = 0.98;
static const double predictors_adaptation_time_left_LEAST = 0.05;
static const double predictors_adaptation_time_left_LONGEST = 4.0;
static const int64_t predictors_adaptation_time_left_MOST = 32;
static const double predictors_adaptation_time_left_NEAR = 0.04;
static const double predictors_adaptation_time_left_SHORTEST_S = 1e-06;
static const double predictors_adaptation_time_left_SMALL = 0.05;
static const double predictors_adaptation_time_left_START = 0.1;
static const int64_t predictors_adaptation_time_left_TERMS = 7;
static const double predictors_adaptation_time_left_prior_PRIOR[] = {0.463, 0.05, 0.135, 0.352, -0.144, -0.102, 0.026, 5.386, 4.699, 7.62, 7.876, 8.315, 18.215, 3.974, 3.859, 5.877, 4.439, 3.135, 4.623, 4.769, 3.006, 4.42, 0.488, 0.501, 1.748, 0.157, 0.026, 0.716, 0.764, 0.903, 3.059, 0.155, 0.112, 0.72, 1.826};

/* Of so many stages the one before a share of the time, and how far the share is from it to the next. */
Tqd predictors_adaptation_stages_interpolation_among(double share, int64_t count) {
  double spot;
  int64_t stage;
  spot = min_float(max_float(share * count - 0.5, 0.0), count - 1.0);
  stage = min_whole((int64_t)floor(spot), count - 2);
  return (Tqd){stage, spot - stage};
}

/* Standard deviation of the logarithm of the time left at a share of the time: lines between stages. */
double predictors_adaptation_arrival_intervals_spread(predictors_adaptation_arrival_intervals_Intervals * s, double share) {
  int64_t stage;
  double part, low;
  Tqd values_1 = predictors_adaptation_stages_interpolation_among(share, predictors_adaptation_arrival_intervals_STAGES);
  stage = values_1.f0;
  part = values_1.f1;
  low = s->offsets[stage];
  return predictors_adaptation_arrival_intervals_SPREAD * exp(low + part * (s->offsets[stage + 1] - low));
}

/* Count a finished movement; returns its step. */
double predictors_adaptation_arrival_intervals_next_step(predictors_adaptation_arrival_intervals_Intervals * s) {
  s->movements = min_float(s->movements + 1.0, predictors_adaptation_arrival_intervals_MOVEMENTS_MOST);
  return max_float(predictors_adaptation_arrival_intervals_STEP / (s->movements + predictors_adaptation_arrival_intervals_STEP_OF), predictors_adaptation_arrival_intervals_STEP_LEAST);
}

/* The value, no further from zero than ``most``. */
double predictors_adaptation_stages_bounded(double value, double most) {
  return min_float(max_float(value, -most), most);
}

/* Change the spread by one moment: ``claim``, the time left in s and its spread; ``left`` what was left. */
void predictors_adaptation_arrival_intervals_judge(predictors_adaptation_arrival_intervals_Intervals * s, double share, double step, T2d claim, double left) {
  double off, missed, part, change;
  bool inside;
  int64_t stage;
  off = fabs(log(left / claim.f0));
  missed = 0.0;
  for (int64_t k = 0; k < 2; k++) {
    inside = off <= ((const double *)&predictors_adaptation_arrival_intervals_DEVIATIONS)[k] * claim.f1;
    missed += ((const double *)&predictors_adaptation_arrival_intervals_SHARES)[k] * (inside ? ((const double *)&predictors_adaptation_arrival_intervals_LEVELS)[k] - 1.0 : ((const double *)&predictors_adaptation_arrival_intervals_LEVELS)[k]);
  }
  Tqd values_1 = predictors_adaptation_stages_interpolation_among(share, predictors_adaptation_arrival_intervals_STAGES);
  stage = values_1.f0;
  part = values_1.f1;
  for (int64_t side = 0; side < 2; side++) {
    change = step * missed * (side == 1 ? part : 1.0 - part);
    s->offsets[stage + side] = predictors_adaptation_stages_bounded(s->offsets[stage + side] + change, predictors_adaptation_arrival_intervals_FURTHEST);
  }
}

/* What is wrong with numbers that are each within their bounds, and the number that is wrong. */
Tqd predictors_adaptation_distances_fault(predictors_adaptation_distances_Distances * learned) {
  int64_t count;
  double total;
  count = (int64_t)learned->count;
  if (count == 0) {
    return (Tqd){predictors_adaptation_distances_FINE, 0.0};
  }
  for (int64_t i = 0; i < count; i++) {
    if (!(learned->last[i] >= predictors_adaptation_moments_SHORTEST_PX)) {
      return (Tqd){predictors_adaptation_distances_TOO_SHORT, learned->last[i]};
    }
  }
  if (!(learned->belief[predictors_adaptation_distances_LAWS] >= predictors_adaptation_distances_LEAST_UNKNOWN)) {
    return (Tqd){predictors_adaptation_distances_TOO_SURE, learned->belief[predictors_adaptation_distances_LAWS]};
  }
  total = 0.0;
  for (int64_t i = 0; i < 7; i++) {
    total += learned->belief[i];
  }
  if (!(fabs(total - 1.0) <= predictors_adaptation_distances_OFF_ONE)) {
    return (Tqd){predictors_adaptation_distances_NO_SHARES, total};
  }
  return (Tqd){predictors_adaptation_distances_FINE, 0.0};
}

/* The duration that would stand at a place if they were sorted. */
WIDE double predictors_adaptation_durations_value_of_rank(predictors_adaptation_durations_Durations * s, int64_t rank) {
  int64_t count, before;
  count = (int64_t)s->count;
  for (int64_t i = 0; i < count; i++) {
    before = 0;
    for (int64_t j = 0; j < count; j++) {
      if (s->last[j] < s->last[i] || (s->last[j] == s->last[i] && j < i)) {
        before += 1;
      }
    }
    if (before == rank) {
      return s->last[i];
    }
  }
  return NAN;
}

/* The median of the durations, bit for bit that of ``np.median``. */
double predictors_adaptation_durations_median(predictors_adaptation_durations_Durations * s) {
  int64_t count;
  double upper;
  count = (int64_t)s->count;
  upper = predictors_adaptation_durations_value_of_rank(s, floor_divided_whole(count, 2));
  return remainder_whole(count, 2) ? upper : (predictors_adaptation_durations_value_of_rank(s, floor_divided_whole(count, 2) - 1) + upper) / 2.0;
}

/* What is wrong with numbers that are each within their bounds, and the number that is wrong. */
Tqd predictors_adaptation_durations_fault(predictors_adaptation_durations_Durations * learned) {
  for (int64_t i = 0, end_1 = (int64_t)learned->count; i < end_1; i++) {
    if (!(learned->last[i] > 0.0)) {
      return (Tqd){predictors_adaptation_durations_NO_DURATION, learned->last[i]};
    }
  }
  if (learned->count > 0.0 && learned->median != predictors_adaptation_durations_median(learned)) {
    return (Tqd){predictors_adaptation_durations_OTHER_MEDIAN, learned->median};
  }
  return (Tqd){predictors_adaptation_durations_FINE, 0.0};
}

/* Factor the sums and the prior's into L D L' in place of their lower triangle; returns the least of D. */
WIDE double predictors_adaptation_time_left_factor(predictors_adaptation_time_left_Sums * s, Vector prior, Vector out) {
  double least, scaled;
  int64_t row, column;
  least = INFINITY;
  for (int64_t i = 0; i < predictors_adaptation_time_left_SUMS; i++) {
    out.p[i] = s->products[i] + prior.p[predictors_adaptation_time_left_TERMS + i];
  }
  for (int64_t i = 0; i < predictors_adaptation_time_left_TERMS; i++) {
    row = floor_divided_whole(i * (i + 1), 2);
    for (int64_t j = 0; j < i; j++) {
      column = floor_divided_whole(j * (j + 1), 2);
      for (int64_t k = 0; k < j; k++) {
        out.p[row + j] -= out.p[row + k] * out.p[column + k];
      }
    }
    for (int64_t j = 0; j < i; j++) {
      scaled = out.p[row + j] / out.p[floor_divided_whole(j * (j + 3), 2)];
      out.p[row + i] -= scaled * out.p[row + j];
      out.p[row + j] = scaled;
    }
    least = min_float(least, out.p[row + i]);
  }
  return least;
}

/* What is wrong with numbers that are each within their bounds, and the number that is wrong. */
Tqd predictors_adaptation_places_fault(predictors_adaptation_places_Places * learned) {
  int64_t count;
  count = (int64_t)learned->count;
  for (int64_t i = 0; i < count; i++) {
    if (!(learned->places[i].visits >= predictors_adaptation_places_LIGHTEST)) {
      return (Tqd){predictors_adaptation_places_TOO_LIGHT, learned->places[i].visits};
    }
  }
  for (int64_t age = 0, end_1 = (int64_t)min_float(learned->ended, predictors_adaptation_places_MOVEMENTS); age < end_1; age++) {
    if (learned->history[age] >= count) {
      return (Tqd){predictors_adaptation_places_NO_SUCH_PLACE, learned->history[age]};
    }
  }
  return (Tqd){predictors_adaptation_places_FINE, 0.0};
}

/* What is wrong with numbers that are each within their bounds, and the number that is wrong. */
Tqd predictors_adaptation_correction_fault(predictors_adaptation_correction_Person * learned) {
  int64_t wrong;
  double value;
  if (learned->distances.count != learned->durations.count) {
    return (Tqd){predictors_adaptation_correction_UNEQUAL, learned->distances.count};
  }
  Tqd values_1 = predictors_adaptation_distances_fault(&learned->distances);
  wrong = values_1.f0;
  value = values_1.f1;
  if (wrong != predictors_adaptation_distances_FINE) {
    return (Tqd){wrong, value};
  }
  Tqd values_2 = predictors_adaptation_durations_fault(&learned->durations);
  wrong = values_2.f0;
  value = values_2.f1;
  if (wrong != predictors_adaptation_durations_FINE) {
    return (Tqd){wrong, value};
  }
  Tqd values_3 = predictors_adaptation_time_left_fault(&learned->time_left, (Vector){(double *)predictors_adaptation_time_left_prior_PRIOR, 35});
  wrong = values_3.f0;
  value = values_3.f1;
  if (wrong != predictors_adaptation_time_left_FINE) {
    return (Tqd){wrong, value};
  }
  return predictors_adaptation_places_fault(&learned->places);
}

/* When the cursor came near its end for good; the oldest time remembered where that is longer ago. */
double predictors_adaptation_correction_arrival(predictors_adaptation_correction_Movement * movement, double near) {
  int64_t traced;
  double when;
  predictors_adaptation_correction_Sample * place;
  traced = (int64_t)movement->traced;
  when = movement->t;
  for (int64_t back = 0, end_1 = min_whole(traced, predictors_adaptation_correction_TRACE_PLACES); back < end_1; back++) {
    place = &movement->trace[remainder_whole(traced - 1 - back, predictors_adaptation_correction_TRACE_PLACES)];
    if (hypot(place->x - movement->x, place->y - movement->y) > near) {
      return when;
    }
    when = place->t;
  }
  return when;
}

/* How likely the last distances had made a distance, over what it is where nothing is known. */
WIDE double predictors_adaptation_distances_likelihood(predictors_adaptation_distances_Distances * s, double distance) {
  int64_t count;
  double likely, off, near;
  count = (int64_t)s->count;
  if (count < predictors_adaptation_distances_LEAST) {
    return 1.0;
  }
  likely = s->belief[predictors_adaptation_distances_LAWS];
  for (int64_t j = 0; j < count; j++) {
    for (int64_t w = 0; w < 3; w++) {
      off = log(distance / s->last[j]) / ((const double *)&predictors_adaptation_distances_WIDTHS)[w];
      near = exp(-0.5 * min_float(off * off, 1000.0)) / (((const double *)&predictors_adaptation_distances_WIDTHS)[w] * sqrt(2.0 * 3.141592653589793));
      likely += s->weights[j][w] * predictors_adaptation_distances_UNKNOWN_LOGS * near;
    }
  }
  return likely;
}

/* The share of each place of a key by its visits; returns the sum of the visits. */
double predictors_adaptation_habits_count_often(predictors_adaptation_places_Places * held, double key, Table out) {
  int64_t count;
  double total;
  count = (int64_t)held->count;
  total = 0.0;
  for (int64_t i = 0; i < count; i++) {
    if (held->places[i].key == key) {
      out.p[predictors_adaptation_habits_OFTEN * out.m + i] = held->places[i].visits;
      total += out.p[predictors_adaptation_habits_OFTEN * out.m + i];
    }
  }
  for (int64_t i = 0; i < count; i++) {
    out.p[predictors_adaptation_habits_OFTEN * out.m + i] = total > 0.0 ? out.p[predictors_adaptation_habits_OFTEN * out.m + i] / total : 0.0;
  }
  return total;
}

/* Where a movement ended, ``age`` movements before the last one: the place, -1 where it is unknown. */
int64_t predictors_adaptation_places_visited(predictors_adaptation_places_Places * s, int64_t age) {
  int64_t ended;
  ended = (int64_t)s->ended;
  if (age >= min_whole(ended, predictors_adaptation_places_MOVEMENTS)) {
    return -1;
  }
  return (int64_t)s->history[remainder_whole(ended - 1 - age, predictors_adaptation_places_MOVEMENTS)];
}

/* Recent visits, and returns after as many movements as each place was visited ago. */
void predictors_adaptation_habits_count_last(predictors_adaptation_habits_Habits * s, predictors_adaptation_places_Places * held, Table out) {
  int64_t number;
  for (int64_t age = 0; age < predictors_adaptation_places_MOVEMENTS; age++) {
    number = predictors_adaptation_places_visited(held, age);
    if (number >= 0 && out.p[predictors_adaptation_habits_OFTEN * out.m + number] > 0.0) {
      out.p[predictors_adaptation_habits_LATELY * out.m + number] += exp(-age / predictors_adaptation_habits_LATE_AGE);
    }
  }
  for (int64_t age = predictors_adaptation_habits_LAGS - 1; age > (-1); age--) {
    number = predictors_adaptation_places_visited(held, age);
    if (number >= 0 && out.p[predictors_adaptation_habits_OFTEN * out.m + number] > 0.0) {
      out.p[predictors_adaptation_habits_AFTER_SO_MANY * out.m + number] = s->lags[age];
    }
  }
}

/* Shares of a rule from its counts, with those of another rule for so many visits. */
void predictors_adaptation_habits_blend(Table out, int64_t rule, int64_t base, int64_t count, double weight) {
  double total;
  total = weight;
  for (int64_t i = 0; i < count; i++) {
    total += out.p[rule * out.m + i];
  }
  for (int64_t i = 0; i < count; i++) {
    out.p[rule * out.m + i] = (out.p[rule * out.m + i] + weight * out.p[base * out.m + i]) / total;
  }
}

/* The place of this key nearest to a point, at most ``near`` px from it; -1 where there is none. */
int64_t predictors_adaptation_places_nearest(predictors_adaptation_places_Places * s, double key, T2d point, double near) {
  double x, y, closest, away;
  int64_t best;
  predictors_adaptation_places_Place * place;
  x = point.f0;
  y = point.f1;
  best = -1;
  closest = near;
  for (int64_t i = 0, end_1 = (int64_t)s->count; i < end_1; i++) {
    place = &s->places[i];
    away = hypot(place->x - x, place->y - y);
    if (place->key == key && away <= closest) {
      best = i;
      closest = away;
    }
  }
  return best;
}

/* Where the person went from this place. */
void predictors_adaptation_habits_count_following(predictors_adaptation_places_Places * held, int64_t here, Table out) {
  int64_t after, before;
  for (int64_t age = 0; age < (predictors_adaptation_places_MOVEMENTS - 1); age++) {
    after = predictors_adaptation_places_visited(held, age);
    before = predictors_adaptation_places_visited(held, age + 1);
    if (before == here && after >= 0 && out.p[predictors_adaptation_habits_OFTEN * out.m + after] > 0.0) {
      out.p[predictors_adaptation_habits_FROM_HERE * out.m + after] += exp(-age / predictors_adaptation_habits_AGE);
    }
  }
}

/* The share of each place by each rule, a row each; whether there is any. */
bool predictors_adaptation_habits_shares(predictors_adaptation_habits_Habits * s, predictors_adaptation_places_Places * held, double key, T3d start, Table out) {
  int64_t count, here;
  double x, y, near;
  if (predictors_adaptation_habits_count_often(held, key, out) == 0.0) {
    return false;
  }
  count = (int64_t)held->count;
  predictors_adaptation_habits_count_last(s, held, out);
  predictors_adaptation_habits_blend(out, predictors_adaptation_habits_LATELY, predictors_adaptation_habits_OFTEN, count, predictors_adaptation_habits_LATE_ELSE);
  predictors_adaptation_habits_blend(out, predictors_adaptation_habits_AFTER_SO_MANY, predictors_adaptation_habits_OFTEN, count, predictors_adaptation_habits_OFTEN_OF);
  x = start.f0;
  y = start.f1;
  near = start.f2;
  here = predictors_adaptation_places_nearest(held, key, (T2d){x, y}, near);
  if (here >= 0) {
    predictors_adaptation_habits_count_following(held, here, out);
  }
  predictors_adaptation_habits_blend(out, predictors_adaptation_habits_FROM_HERE, predictors_adaptation_habits_OFTEN, count, predictors_adaptation_habits_OFTEN_OF);
  return true;
}

/* How likely a place makes an end, over what it is where nothing is known. */
double predictors_adaptation_habits_density_ratio(double far2, double distance2, double width) {
  double width2;
  if (distance2 == 0.0) {
    return 0.0;
  }
  width2 = width * width;
  return exp(max_float(-0.5 * far2 / distance2 / width2, predictors_adaptation_habits_LEAST_LOG)) * predictors_adaptation_distances_UNKNOWN_LOGS / width2;
}

/* The share of movements that go to a known place. */
double predictors_adaptation_habits_returns(predictors_adaptation_habits_Habits * s) {
  return (s->known + predictors_adaptation_habits_RETURNS * predictors_adaptation_habits_RETURNS_OF) / (s->known + s->new + predictors_adaptation_habits_RETURNS_OF);
}

/* The weight of a rule among all; without the sequence only of OFTEN and LATELY. */
double predictors_adaptation_habits_rule_weight(predictors_adaptation_habits_Habits * s, int64_t rule, double with_sequence) {
  int64_t most;
  double total, first;
  most = with_sequence == 1.0 ? predictors_adaptation_habits_RULES : predictors_adaptation_habits_AFTER_SO_MANY;
  if (rule >= most) {
    return 0.0;
  }
  total = 0.0;
  first = predictors_adaptation_habits_FIRST_RULES_OF / (predictors_adaptation_habits_FIRST_RULES.f0 + predictors_adaptation_habits_FIRST_RULES.f1 + predictors_adaptation_habits_FIRST_RULES.f2 + predictors_adaptation_habits_FIRST_RULES.f3);
  for (int64_t k = 0; k < most; k++) {
    total += s->rules[k] + first * ((const double *)&predictors_adaptation_habits_FIRST_RULES)[k];
  }
  return (s->rules[rule] + first * ((const double *)&predictors_adaptation_habits_FIRST_RULES)[rule]) / total;
}

/* The weight of a width among all. */
double predictors_adaptation_habits_width_weight(predictors_adaptation_habits_Habits * s, int64_t width) {
  double total;
  total = predictors_adaptation_habits_WIDTHS_OF;
  for (int64_t k = 0; k < 3; k++) {
    total += s->widths[k];
  }
  return (s->widths[width] + predictors_adaptation_habits_WIDTHS_OF / 3) / total;
}

/* Share one visit among rules, widths and "a new place" by how likely each had made the end. */
void predictors_adaptation_habits_share_visit(predictors_adaptation_habits_Habits * s, Table likely, double with_sequence, double elsewhere) {
  double known, new, total, prior;
  known = predictors_adaptation_habits_returns(s);
  new = (1.0 - known) * elsewhere;
  total = new;
  for (int64_t rule = 0; rule < predictors_adaptation_habits_RULES; rule++) {
    for (int64_t width = 0; width < 3; width++) {
      prior = known * predictors_adaptation_habits_rule_weight(s, rule, with_sequence) * predictors_adaptation_habits_width_weight(s, width);
      likely.p[rule * likely.m + width] *= prior;
      total += likely.p[rule * likely.m + width];
    }
  }
  s->new = predictors_adaptation_habits_KEEP * s->new + new / total;
  s->known = predictors_adaptation_habits_KEEP * s->known + (1.0 - new / total);
  for (int64_t rule = 0; rule < predictors_adaptation_habits_RULES; rule++) {
    s->rules[rule] *= predictors_adaptation_habits_KEEP;
  }
  for (int64_t width = 0; width < 3; width++) {
    s->widths[width] *= predictors_adaptation_habits_KEEP;
  }
  for (int64_t rule = 0; rule < predictors_adaptation_habits_RULES; rule++) {
    for (int64_t width = 0; width < 3; width++) {
      s->rules[rule] += likely.p[rule * likely.m + width] / total;
      s->widths[width] += likely.p[rule * likely.m + width] / total;
    }
  }
}

/* Learn from a movement, before its end is taken in as a visit. */
void predictors_adaptation_habits_learn(predictors_adaptation_habits_Habits * s, predictors_adaptation_places_Places * held, T3d scene, T4d movement, double elsewhere) {
  double key, with_sequence, near, x0, y0, x, y, px, py, distance2, far2, ratio;
  Table out, likely;
  int64_t number;
  double buffer_1[256];
  double buffer_2[12];
  key = scene.f0;
  with_sequence = scene.f1;
  near = scene.f2;
  x0 = movement.f0;
  y0 = movement.f1;
  x = movement.f2;
  y = movement.f3;
  memset(buffer_1, 0, sizeof buffer_1);
  out = (Table){buffer_1, predictors_adaptation_habits_RULES, predictors_adaptation_places_CAPACITY};
  if (!predictors_adaptation_habits_shares(s, held, key, (T3d){x0, y0, near}, out)) {
    return;
  }
  memset(buffer_2, 0, sizeof buffer_2);
  likely = (Table){buffer_2, predictors_adaptation_habits_RULES, 3};
  for (int64_t i = 0, end_3 = (int64_t)held->count; i < end_3; i++) {
    px = held->places[i].x;
    py = held->places[i].y;
    distance2 = square(px - x0) + square(py - y0);
    far2 = square(px - x) + square(py - y);
    for (int64_t width = 0; width < 3; width++) {
      ratio = predictors_adaptation_habits_density_ratio(far2, distance2, ((const double *)&predictors_adaptation_habits_WIDTHS)[width]);
      for (int64_t rule = 0; rule < predictors_adaptation_habits_RULES; rule++) {
        likely.p[rule * likely.m + width] += out.p[rule * out.m + i] * ratio;
      }
    }
  }
  predictors_adaptation_habits_share_visit(s, likely, with_sequence, elsewhere);
  number = predictors_adaptation_places_nearest(held, key, (T2d){x, y}, predictors_adaptation_places_NEAR_SHARE * hypot(x - x0, y - y0));
  for (int64_t age = 0; age < predictors_adaptation_habits_LAGS; age++) {
    if (number >= 0 && predictors_adaptation_places_visited(held, age) == number) {
      for (int64_t k = 0; k < predictors_adaptation_habits_LAGS; k++) {
        s->lags[k] *= predictors_adaptation_habits_LAG_KEEP;
      }
      s->lags[age] += 1.0;
      return;
    }
  }
}

/* A free place; where there is none the one with the fewest visits is forgotten, in the history too. */
int64_t predictors_adaptation_places_new_place(predictors_adaptation_places_Places * s) {
  int64_t count, free_;
  count = (int64_t)s->count;
  if (count < predictors_adaptation_places_CAPACITY) {
    s->count = count + 1.0;
    return count;
  }
  free_ = 0;
  for (int64_t i = 0; i < predictors_adaptation_places_CAPACITY; i++) {
    if (s->places[i].visits < s->places[free_].visits) {
      free_ = i;
    }
  }
  for (int64_t age = 0; age < predictors_adaptation_places_MOVEMENTS; age++) {
    if (s->history[age] == free_) {
      s->history[age] = predictors_adaptation_places_NOWHERE;
    }
  }
  return free_;
}

/* Take in the end of a movement: a visit of the nearest place within ``near`` px, or a new place. */
void predictors_adaptation_places_visit(predictors_adaptation_places_Places * s, double key, T2d end, double near) {
  double x, y, share;
  int64_t number;
  predictors_adaptation_places_Place * new, *place;
  x = end.f0;
  y = end.f1;
  for (int64_t i = 0, end_1 = (int64_t)s->count; i < end_1; i++) {
    s->places[i].visits = max_float(predictors_adaptation_places_KEEP * s->places[i].visits, predictors_adaptation_places_LIGHTEST);
  }
  number = predictors_adaptation_places_nearest(s, key, end, near);
  if (number < 0) {
    number = predictors_adaptation_places_new_place(s);
    new = &s->places[number];
    new->key = key;
    new->visits = 0.0;
    new->x = x;
    new->y = y;
  }
  place = &s->places[number];
  place->visits += 1.0;
  share = max_float(1.0 / place->visits, predictors_adaptation_places_STEADIEST);
  place->x += share * (x - place->x);
  place->y += share * (y - place->y);
  s->history[remainder_whole((int64_t)s->ended, predictors_adaptation_places_MOVEMENTS)] = number;
  s->ended += 1.0;
  if (s->ended == predictors_adaptation_places_MOST_ENDED) {
    s->ended -= predictors_adaptation_places_MOVEMENTS;
  }
}

/* Learn which place the movement went to; before its distance is taken in. */
void predictors_adaptation_correction_learn_place(predictors_adaptation_correction_Settings * settings, predictors_adaptation_correction_Person * person, predictors_adaptation_correction_Movement * movement) {
  predictors_adaptation_correction_Window * scene;
  double x0, y0, x, y, distance, usual, near;
  T3d where;
  scene = &settings->scene;
  x0 = movement->x0 - scene->x;
  y0 = movement->y0 - scene->y;
  x = movement->x - scene->x;
  y = movement->y - scene->y;
  distance = hypot(x - x0, y - y0);
  usual = 1.0;
  if (settings->distances == 1.0) {
    usual = predictors_adaptation_distances_likelihood(&person->distances, distance);
  }
  near = predictors_adaptation_places_NEAR_SHARE * distance;
  where = (T3d){scene->key, settings->sequence, near};
  predictors_adaptation_habits_learn(&person->habits, &person->places, where, (T4d){x0, y0, x, y}, usual);
  predictors_adaptation_places_visit(&person->places, scene->key, (T2d){x, y}, near);
}

/* Discount the errors of earlier movements. */
void predictors_adaptation_durations_forget(predictors_adaptation_durations_Durations * s) {
  for (int64_t k = 0; k < 5; k++) {
    s->errors[k] *= predictors_adaptation_durations_KEEP;
  }
  s->movements = predictors_adaptation_durations_KEEP * s->movements + 1.0;
}

/* Logarithm of what a stage multiplies the time left by. */
double predictors_adaptation_stages_tempo(predictors_adaptation_stages_Stage * s) {
  return s->tempo / (s->timed + predictors_adaptation_stages_TEMPO_OF);
}

/* Share of a correction that has paid so far: 0 to 1. */
double predictors_adaptation_stages_belief(double paid, double size) {
  return min_float(max_float(paid / (size + predictors_adaptation_stages_DOUBT), 0.0), 1.0);
}

/* What a stage multiplies the time left by. */
double predictors_adaptation_stages_tempo_factor(predictors_adaptation_stages_Stage * s) {
  return exp(predictors_adaptation_stages_tempo(s) * predictors_adaptation_stages_belief(s->tempo_paid, s->tempo_size));
}

/* The time left in s, of which the clock says a share; ``left``: what the predictor says. */
double predictors_adaptation_durations_mixture(predictors_adaptation_durations_Durations * s, double share, double since, double left) {
  double by_clock;
  by_clock = max_float(s->median - since, 0.0);
  return max_float((1.0 - share) * left + share * by_clock, predictors_adaptation_durations_LEAST * left);
}

/* Add the errors of the mixtures at one moment of a finished movement. */
void predictors_adaptation_durations_judge(predictors_adaptation_durations_Durations * s, double since, double predicted, double left, double duration) {
  double off;
  for (int64_t k = 0; k < 5; k++) {
    off = predictors_adaptation_durations_mixture(s, ((const double *)&predictors_adaptation_durations_SHARES)[k], since, predicted) - left;
    s->errors[k] += fabs(off) / duration;
  }
}

/* Discount what earlier movements taught; the bias is computed again. */
void predictors_adaptation_stages_forget(predictors_adaptation_stages_Stage * s) {
  double total, ahead;
  Vector sums;
  total = s->total;
  ahead = s->ahead;
  sums = (Vector){(double *)s, 16};
  for (int64_t i = 0; i < 16; i++) {
    sums.p[i] *= predictors_adaptation_stages_KEEP;
  }
  s->total = total;
  s->ahead = ahead;
}

/* What a stage adds to the way ahead, px. */
double predictors_adaptation_stages_bias(predictors_adaptation_stages_Stage * s, double total, double along) {
  return s->total * total + s->ahead * along;
}

/* The coefficients of the bias from the normal equations. */
void predictors_adaptation_stages_solve(predictors_adaptation_stages_Stage * s) {
  double g00, g01, g11, determinant, by_total, by_ahead;
  g00 = s->g00 + predictors_adaptation_stages_RIDGE;
  g01 = s->g01;
  g11 = s->g11 + predictors_adaptation_stages_RIDGE;
  determinant = max_float(g00 * g11 - g01 * g01, predictors_adaptation_stages_RIDGE * predictors_adaptation_stages_RIDGE);
  by_total = (g11 * s->r0 - g01 * s->r1) / determinant;
  by_ahead = (g00 * s->r1 - g01 * s->r0) / determinant;
  s->total = predictors_adaptation_stages_bounded(by_total, predictors_adaptation_stages_MOST_SHARE);
  s->ahead = predictors_adaptation_stages_bounded(by_ahead, predictors_adaptation_stages_MOST_SHARE);
}

/* What the sum for a width grows by, as a Student law has it: what is far off counts little. */
double predictors_adaptation_stages_scale(predictors_adaptation_stages_Stage * s, double squares, double off, double tail) {
  double before;
  before = (squares + predictors_adaptation_stages_WIDTHS_OF) / (s->count + predictors_adaptation_stages_WIDTHS_OF);
  return (tail + 1.0) / (tail + off * off / before) * off * off;
}

/* Learn from one stage of a finished movement: where it ended, and when the cursor came to rest. */
void predictors_adaptation_stages_learn(predictors_adaptation_stages_Stage * s, predictors_adaptation_stages_Moment * m, double x, double y, double t) {
  double dx, dy, off, aside, total, shift, rest, paid, weight, f0, f1, left, late, slow;
  predictors_adaptation_stages_forget(s);
  dx = x - m->x;
  dy = y - m->y;
  off = (dx * m->ux + dy * m->uy - m->along) / m->wide;
  aside = (dy * m->ux - dx * m->uy - m->across) / m->broad;
  total = sqrt(square(m->reached + m->along) + square(m->across));
  shift = predictors_adaptation_stages_bias(s, total, m->along) / m->wide;
  rest = off - shift;
  paid = predictors_adaptation_stages_bounded(shift, predictors_adaptation_stages_FURTHEST);
  s->bias_paid = s->bias_paid + paid * predictors_adaptation_stages_bounded(off, predictors_adaptation_stages_FURTHEST);
  s->bias_size += paid * paid;
  weight = (m->tail + 1.0) / (m->tail + rest * rest);
  f0 = total / m->wide;
  f1 = m->along / m->wide;
  s->g00 += weight * f0 * f0;
  s->g01 += weight * f0 * f1;
  s->g11 += weight * f1 * f1;
  s->r0 += weight * f0 * off;
  s->r1 += weight * f1 * off;
  predictors_adaptation_stages_solve(s);
  s->wide = s->wide + predictors_adaptation_stages_scale(s, s->wide, rest, m->tail);
  s->broad = s->broad + predictors_adaptation_stages_scale(s, s->broad, aside, m->tail);
  left = t - m->t;
  if (left > 0.0) {
    late = predictors_adaptation_stages_bounded(log(left / m->left), predictors_adaptation_stages_TEMPO_MOST);
    slow = predictors_adaptation_stages_tempo(s);
    s->tempo_paid += slow * late / square(predictors_adaptation_stages_TEMPO_OFF);
    s->tempo_size += slow * slow / square(predictors_adaptation_stages_TEMPO_OFF);
    s->tempo += late;
    s->timed += 1.0;
  }
  s->count += 1.0;
}

/* The number of the moment at a share of the time between the start and the end in s, from ``k`` on. */
int64_t predictors_adaptation_time_left_moment_at(predictors_adaptation_time_left_Movement * movement, int64_t k, T2d span, double share) {
  while (k + 1 < movement->series.count && predictors_adaptation_moments_has_come(&movement->series, movement->moments[k + 1].t, span, share)) {
    k += 1;
  }
  return k;
}

/* Learn from a movement over ``span``, its start and its arrival in s. */
void predictors_adaptation_time_left_learn(predictors_adaptation_time_left_Sums * s, predictors_adaptation_arrival_intervals_Intervals * intervals, predictors_adaptation_time_left_Movement * movement, T2d span, double median, Vector prior) {
  double step, share, seconds, left, off, off_prior, weight, term;
  int64_t k;
  predictors_adaptation_time_left_Moment * m;
  if (movement->ready == 0.0) {
    return;
  }
  step = predictors_adaptation_arrival_intervals_next_step(intervals) / predictors_adaptation_time_left_JUDGED;
  for (int64_t i = 0; i < predictors_adaptation_time_left_SUMS; i++) {
    s->products[i] *= predictors_adaptation_time_left_KEEP;
  }
  for (int64_t i = 0; i < predictors_adaptation_time_left_TERMS; i++) {
    s->residuals[i] *= predictors_adaptation_time_left_KEEP;
  }
  k = 0;
  for (int64_t judged = 0; judged < predictors_adaptation_time_left_JUDGED; judged++) {
    share = (judged + 0.5) / predictors_adaptation_time_left_JUDGED;
    k = predictors_adaptation_time_left_moment_at(movement, k, span, share);
    m = &movement->moments[k];
    seconds = max_float(span.f1 - m->t, predictors_adaptation_time_left_SHORTEST_S);
    predictors_adaptation_arrival_intervals_judge(intervals, share, step, (T2d){m->left, m->spread}, seconds);
    left = min_float(seconds / median, predictors_adaptation_time_left_FURTHEST);
    off = left;
    off_prior = left;
    for (int64_t i = 0; i < predictors_adaptation_time_left_TERMS; i++) {
      off -= movement->weights[i] * m->terms[i];
      off_prior -= prior.p[i] * m->terms[i];
    }
    weight = 1.0 / (max_float(fabs(off), predictors_adaptation_time_left_SMALL) * predictors_adaptation_time_left_JUDGED);
    for (int64_t i = 0; i < predictors_adaptation_time_left_TERMS; i++) {
      term = weight * m->terms[i];
      s->residuals[i] += term * off_prior;
      for (int64_t j = 0, end_1 = i + 1; j < end_1; j++) {
        s->products[floor_divided_whole(i * (i + 1), 2) + j] += term * m->terms[j];
      }
    }
  }
}

/* Weight of a distance ``age`` movements old, of ``count``. */
double predictors_adaptation_distances_age_weight(int64_t age, int64_t count, double time) {
  double total;
  total = 0.0;
  for (int64_t j = 0; j < count; j++) {
    total += exp(-j / time);
  }
  return exp(-age / time) / total;
}

/* Share the belief among the laws by how likely each had made a distance. */
void predictors_adaptation_distances_judge(predictors_adaptation_distances_Distances * s, double distance) {
  int64_t count;
  double total, width, time, likely, off, first;
  count = (int64_t)s->count;
  total = 0.0;
  for (int64_t k = 0; k < predictors_adaptation_distances_LAWS; k++) {
    width = ((const double *)&predictors_adaptation_distances_WIDTHS)[remainder_whole(k, 3)];
    time = ((const double *)&predictors_adaptation_distances_AGES)[floor_divided_whole(k, 3)];
    likely = 0.0;
    for (int64_t j = 0; j < count; j++) {
      off = log(distance / s->last[j]) / width;
      likely = likely + predictors_adaptation_distances_age_weight(j, count, time) * exp(-0.5 * min_float(off * off, 1000.0)) / (width * sqrt(2.0 * 3.141592653589793));
    }
    s->belief[k] *= max_float(predictors_adaptation_distances_UNKNOWN_LOGS * likely, predictors_adaptation_distances_LEAST_LIKELY);
    total += s->belief[k];
  }
  total += s->belief[predictors_adaptation_distances_LAWS];
  for (int64_t k = 0; k < predictors_adaptation_distances_LAWS; k++) {
    first = (1.0 - predictors_adaptation_distances_UNKNOWN_SHARE) / predictors_adaptation_distances_LAWS;
    s->belief[k] = (1.0 - predictors_adaptation_distances_FORGET) * s->belief[k] / total + predictors_adaptation_distances_FORGET * first;
  }
  s->belief[predictors_adaptation_distances_LAWS] = (1.0 - predictors_adaptation_distances_FORGET) * s->belief[predictors_adaptation_distances_LAWS] / total + predictors_adaptation_distances_FORGET * predictors_adaptation_distances_UNKNOWN_SHARE;
}

/* Take in the distance of a finished movement. */
void predictors_adaptation_distances_remember(predictors_adaptation_distances_Distances * s, double distance) {
  int64_t count;
  double weight;
  if (s->count == 0.0) {
    fill((Vector){(Vector){s->belief, 7}.p, predictors_adaptation_distances_LAWS}, (1.0 - predictors_adaptation_distances_UNKNOWN_SHARE) / predictors_adaptation_distances_LAWS);
    s->belief[predictors_adaptation_distances_LAWS] = predictors_adaptation_distances_UNKNOWN_SHARE;
  }
  if (s->count >= predictors_adaptation_distances_LEAST) {
    predictors_adaptation_distances_judge(s, distance);
  }
  for (int64_t j = predictors_adaptation_distances_CAPACITY - 1; j > 0; j--) {
    s->last[j] = s->last[j - 1];
  }
  s->last[0] = distance;
  s->count = min_float(s->count + 1.0, predictors_adaptation_distances_CAPACITY);
  count = (int64_t)s->count;
  for (int64_t j = 0; j < count; j++) {
    for (int64_t w = 0; w < 3; w++) {
      weight = 0.0;
      for (int64_t a = 0; a < 2; a++) {
        weight = weight + s->belief[a * 3 + w] * predictors_adaptation_distances_age_weight(j, count, ((const double *)&predictors_adaptation_distances_AGES)[a]);
      }
      s->weights[j][w] = weight;
    }
  }
}

/* Take in the duration of a finished movement, and choose the mixture again. */
void predictors_adaptation_durations_remember(predictors_adaptation_durations_Durations * s, double duration) {
  int64_t count;
  double usual, least, error;
  count = (int64_t)min_float(s->count + 1.0, predictors_adaptation_durations_CAPACITY);
  for (int64_t j = count - 1; j > 0; j--) {
    s->last[j] = s->last[j - 1];
  }
  s->count = count;
  s->last[0] = duration;
  s->median = predictors_adaptation_durations_median(s);
  usual = s->errors[0] / max_float(s->movements, 1.0);
  least = INFINITY;
  for (int64_t k = 0; k < 5; k++) {
    error = s->errors[k] + predictors_adaptation_durations_FIRST_OF * ((const double *)&predictors_adaptation_durations_FIRST)[k] * usual;
    if (error < least) {
      least = error;
      s->best = ((const double *)&predictors_adaptation_durations_SHARES)[k];
    }
  }
}

/* The stage before a share of the time, and how far the share is from it to the next. */
Tqd predictors_adaptation_stages_interpolation(double share) {
  return predictors_adaptation_stages_interpolation_among(share, predictors_adaptation_stages_STAGES);
}

/* Learn whether the end lay inside the regions that were stated at a share of the time. */
void predictors_adaptation_mixed_region_judge(predictors_adaptation_levels_Offsets * offsets, predictors_adaptation_mixed_region_Mixture * stated, T2d end, double share, double step) {
  int64_t count;
  Table parts;
  double within, tail, near, far;
  bool inside;
  double buffer_1[35];
  count = (int64_t)stated->count;
  parts = (Table){buffer_1, predictors_adaptation_mixed_region_MOST_PLACES + 1, 7};
  for (int64_t k = 0; k < count; k++) {
    for (int64_t i = 0; i < 7; i++) {
      parts.p[k * parts.m + i] = (Vector){(double *)&stated->rows[k], 7}.p[i];
    }
  }
  within = predictors_mixture_content(parts, count, end.f0, end.f1, predictors_adaptation_mixed_region_POINTS);
  tail = stated->rows[0].tail;
  near = stated->offsets[0];
  far = stated->offsets[1];
  for (int64_t which = 0; which < 2; which++) {
    inside = within <= predictors_mixture_corrected_probability(((const double *)&predictors_mixture_LEVELS)[which], tail, near, far);
    predictors_adaptation_levels_learn(offsets, share, which, inside, step);
  }
}

/* Judge a movement over ``span``, its start and end in s, which ended at a place in px. */
void predictors_adaptation_region_widening_learn(predictors_adaptation_region_widening_Radii * s, predictors_adaptation_region_widening_Movement * stated, T2d place_of_end, T2d span) {
  double x, y, step, share, within;
  int64_t k;
  predictors_adaptation_region_widening_Moment * m;
  if (stated->series.count == 0.0) {
    return;
  }
  x = place_of_end.f0;
  y = place_of_end.f1;
  s->movements = min_float(s->movements + 1.0, predictors_adaptation_region_widening_MOVEMENTS_MOST);
  step = predictors_adaptation_levels_step_after(s->movements);
  k = 0;
  for (int64_t judged = 1; judged < (predictors_adaptation_region_widening_JUDGED + 1); judged++) {
    share = judged / (predictors_adaptation_region_widening_JUDGED + 1.0);
    while (k + 1 < stated->series.count && predictors_adaptation_moments_has_come(&stated->series, stated->moments[k + 1].t, span, share)) {
      k += 1;
    }
    m = &stated->moments[k];
    within = predictors_adaptation_region_widening_probability_within((T6d){m->x, m->y, m->sxx, m->sxy, m->syy, m->tail}, x, y);
    for (int64_t which = 0; which < 2; which++) {
      predictors_adaptation_levels_learn(&s->single, share, which, within <= ((const double *)&predictors_mixture_LEVELS)[which], step);
    }
    predictors_adaptation_mixed_region_judge(&s->mixed, &m->mixture, place_of_end, share, step);
  }
}

/* Learn from a movement over ``distance`` px that arrived at ``end`` s where the cursor is. */
void predictors_adaptation_correction_learn(predictors_adaptation_correction_Person * person, predictors_adaptation_correction_Movement * movement, double distance, double end) {
  double x, y, start, duration, left;
  predictors_adaptation_durations_Durations * clock;
  bool not_first;
  predictors_adaptation_stages_Moment * m;
  predictors_adaptation_stages_Stage * stage;
  T2d span;
  x = movement->x;
  y = movement->y;
  start = movement->t0;
  duration = end - start;
  clock = &person->durations;
  not_first = clock->count > 0.0;
  if (not_first) {
    predictors_adaptation_durations_forget(clock);
  }
  for (int64_t number = 0; number < predictors_adaptation_stages_STAGES; number++) {
    m = &movement->stages[number];
    stage = &person->stages.stages[number];
    if (m->present == 1.0) {
      if (not_first && m->t < end) {
        left = m->left * predictors_adaptation_stages_tempo_factor(stage);
        predictors_adaptation_durations_judge(clock, m->t - start, left, end - m->t, duration);
      }
      predictors_adaptation_stages_learn(stage, m, x, y, end);
    }
  }
  if (not_first) {
    span = (T2d){start, end};
    predictors_adaptation_time_left_learn(&person->time_left, &person->intervals, &movement->time_left, span, clock->median, (Vector){(double *)predictors_adaptation_time_left_prior_PRIOR, 35});
  }
  predictors_adaptation_distances_remember(&person->distances, distance);
  predictors_adaptation_durations_remember(clock, duration);
  predictors_adaptation_region_widening_learn(&person->regions, &movement->regions, (T2d){x, y}, (T2d){start, end});
}

/* The movement has ended where the cursor is: learn from it, and forget it. */
void predictors_adaptation_correction_conclude(predictors_adaptation_correction_Settings * settings, predictors_adaptation_correction_Person * person, predictors_adaptation_correction_Movement * movement) {
  double distance, end, shortest;
  bool whole;
  distance = hypot(movement->x - movement->x0, movement->y - movement->y0);
  end = predictors_adaptation_correction_arrival(movement, max_float(predictors_adaptation_moments_NEAR_PX, predictors_adaptation_moments_NEAR_SHARE * distance));
  whole = movement->started == 1.0 && movement->samples >= predictors_adaptation_moments_SAMPLES_LEAST;
  shortest = max_float(settings->shortest_px, predictors_adaptation_moments_SHORTEST_PX);
  if (whole && end - movement->t0 >= predictors_adaptation_moments_LEAST_S && distance >= shortest) {
    if (settings->places == 1.0) {
      predictors_adaptation_correction_learn_place(settings, person, movement);
    }
    predictors_adaptation_correction_learn(person, movement, distance, end);
  }
  memset(movement, 0, sizeof(predictors_adaptation_correction_Movement));
}

/* Take in one sample (t, x, y) of the movement that started at ``start``. */
void predictors_adaptation_correction_follow(predictors_adaptation_correction_Movement * movement, T3d now, T3d start) {
  double t, x, y;
  int64_t traced;
  predictors_adaptation_correction_Sample * last, *place;
  bool moved;
  t = now.f0;
  x = now.f1;
  y = now.f2;
  traced = (int64_t)movement->traced;
  last = &movement->trace[remainder_whole(traced - 1, predictors_adaptation_correction_TRACE_PLACES)];
  if (movement->started == 0.0 || t > movement->t) {
    movement->samples += 1.0;
  }
  moved = x != last->x || y != last->y;
  if (traced > 0 && t == last->t) {
    last->x = x;
    last->y = y;
  } else if (traced == 0 || (moved && t - last->t >= predictors_adaptation_correction_APART_S)) {
    place = &movement->trace[remainder_whole(traced, predictors_adaptation_correction_TRACE_PLACES)];
    place->t = t;
    place->x = x;
    place->y = y;
    movement->traced = traced + 1.0;
  }
  movement->started = 1.0;
  movement->t0 = start.f0;
  movement->x0 = start.f1;
  movement->y0 = start.f2;
  movement->t = t;
  movement->x = x;
  movement->y = y;
}

/* The stage whose moment is at a share of the time, the first or of the same time again; -1 for none. */
int64_t predictors_adaptation_correction_stage_begun(predictors_adaptation_correction_Movement * movement, double share) {
  int64_t stage;
  bool again;
  stage = (int64_t)floor(share * predictors_adaptation_stages_STAGES - 0.5 + predictors_adaptation_correction_EARLY);
  if (stage < 0 || stage >= predictors_adaptation_stages_STAGES) {
    return -1;
  }
  again = movement->stages[stage].present == 1.0 && movement->stages[stage].t == movement->t;
  for (int64_t later = stage; later < predictors_adaptation_stages_STAGES; later++) {
    if (movement->stages[later].present == 1.0 && !again) {
      return -1;
    }
  }
  return stage;
}

/* 1 up to a share of the time, then falling to 0 at the end. */
double predictors_adaptation_correction_fading(double share, double since) {
  return min_float((1.0 - share) / (1.0 - since), 1.0);
}

/* The law of an answer along and across the direction from the start to the cursor. */
predictors_adaptation_destination_Heading predictors_adaptation_correction_heading_of(predictors_adaptation_correction_Movement * movement, T10d answer) {
  double px, py, sxx, sxy, syy, left, tail, away_x, away_y, reached, ux, uy, wide2, broad2;
  px = answer.f1;
  py = answer.f2;
  sxx = answer.f3;
  sxy = answer.f4;
  syy = answer.f5;
  left = answer.f6;
  tail = answer.f8;
  away_x = movement->x - movement->x0;
  away_y = movement->y - movement->y0;
  reached = hypot(away_x, away_y);
  if (!(reached > 0.0 && left > 0.0 && tail > 0.0 && sxx + syy > 0.0)) {
    return (predictors_adaptation_destination_Heading){px, py, 0.0, 0.0, 0.0, 0.0, tail};
  }
  ux = away_x / reached;
  uy = away_y / reached;
  wide2 = sxx * ux * ux + 2.0 * sxy * ux * uy + syy * uy * uy;
  broad2 = sxx * uy * uy - 2.0 * sxy * ux * uy + syy * ux * ux;
  if (!(wide2 > 0.0 && broad2 > 0.0)) {
    return (predictors_adaptation_destination_Heading){px, py, 0.0, 0.0, 0.0, 0.0, tail};
  }
  return (predictors_adaptation_destination_Heading){px, py, ux, uy, sqrt(wide2), sqrt(broad2), tail};
}

/* The way from the cursor to the centre of a law, along and across its direction, px. */
T2d predictors_adaptation_correction_ahead_of(predictors_adaptation_correction_Movement * movement, predictors_adaptation_destination_Heading heading) {
  double dx, dy;
  dx = heading.x - movement->x;
  dy = heading.y - movement->y;
  return (T2d){dx * heading.ux + dy * heading.uy, dy * heading.ux - dx * heading.uy};
}

/* A law whose centre lies ``along`` px ahead of the cursor, of the width ``wide`` px along. */
predictors_adaptation_destination_Heading predictors_adaptation_correction_with_centre_ahead(predictors_adaptation_correction_Movement * movement, predictors_adaptation_destination_Heading heading, double along, double wide) {
  double across, x, y, ux, uy, broad, tail;
  T2d values_1 = predictors_adaptation_correction_ahead_of(movement, heading);
  across = values_1.f1;
  x = heading.x;
  y = heading.y;
  ux = heading.ux;
  uy = heading.uy;
  broad = heading.broad;
  tail = heading.tail;
  x = movement->x + along * ux - across * uy;
  y = movement->y + along * uy + across * ux;
  return (predictors_adaptation_destination_Heading){x, y, ux, uy, wide, broad, tail};
}

/* The way ahead and its width along, by the predicted law and the last distances: (px, px). */
WIDE T3d predictors_adaptation_distances_combine(predictors_adaptation_distances_Distances * s, double reached, predictors_adaptation_distances_Ahead predicted) {
  double ahead, wide, broad, tail, total, low, high, distance, gap, kernel2, both2, fits, part, middle, below, off, around;
  int64_t count, most, parts;
  Vector weight, shift, width;
  ahead = predicted.ahead;
  wide = predicted.wide;
  broad = predicted.broad;
  tail = predicted.tail;
  count = (int64_t)s->count;
  if (count < predictors_adaptation_distances_LEAST) {
    return (T3d){ahead, wide, 1.0};
  }
  most = count * 3 + 1;
  RELEASED double *buffer_1 = reserved(most);
  RELEASED double *buffer_2 = reserved(most);
  RELEASED double *buffer_3 = reserved(most);
  weight = (Vector){buffer_1, most};
  shift = (Vector){buffer_2, most};
  width = (Vector){buffer_3, most};
  total = s->belief[predictors_adaptation_distances_LAWS];
  low = 0.0;
  high = 0.0;
  parts = 1;
  weight.p[0] = total;
  shift.p[0] = 0.0;
  width.p[0] = wide;
  for (int64_t j = 0; j < count; j++) {
    distance = s->last[j];
    gap = distance / sqrt(1.0 + predictors_adaptation_distances_ARC * square(broad / distance)) - reached - ahead;
    for (int64_t w = 0; w < 3; w++) {
      kernel2 = square(((const double *)&predictors_adaptation_distances_WIDTHS)[w] * distance);
      both2 = wide * wide + kernel2;
      fits = pow(1.0 + gap * gap / both2 / tail, -0.5 * (tail + 1.0)) / sqrt(2.0 * 3.141592653589793 * both2);
      part = s->weights[j][w] * predictors_adaptation_distances_UNKNOWN_LOGS * distance * fits;
      if (part > predictors_adaptation_distances_NEGLIGIBLE * total) {
        weight.p[parts] = part;
        shift.p[parts] = gap * wide * wide / both2;
        width.p[parts] = wide * sqrt(kernel2 / both2);
        low = min_float(low, shift.p[parts]);
        high = max_float(high, shift.p[parts]);
        total += part;
        parts += 1;
      }
    }
  }
  for (int64_t i_4 = 0; i_4 < predictors_adaptation_distances_HALVINGS; i_4++) {
    middle = 0.5 * (low + high);
    below = 0.0;
    for (int64_t k = 0; k < parts; k++) {
      off = predictors_adaptation_distances_LOGISTIC * (shift.p[k] - middle) / width.p[k];
      below += weight.p[k] / (1.0 + exp(min_float(max_float(off, -50.0), 50.0)));
    }
    if (below < 0.5 * total) {
      low = middle;
    } else {
      high = middle;
    }
  }
  middle = 0.5 * (low + high);
  around = 0.0;
  for (int64_t k = 0; k < parts; k++) {
    around += weight.p[k] * (square(width.p[k]) + square(shift.p[k] - middle));
  }
  return (T3d){ahead + middle, min_float(sqrt(around / total), wide), total};
}

/* The law of the endpoint by the last distances, and how likely ``own`` makes these. */
T_predictors_adaptation_destination_Heading_d predictors_adaptation_correction_by_distances(predictors_adaptation_correction_Person * person, predictors_adaptation_correction_Movement * movement, predictors_adaptation_destination_Heading own, double share) {
  double reached, along, usual_along, usual_wide, usual, weight;
  predictors_adaptation_distances_Ahead ahead;
  reached = hypot(movement->x - movement->x0, movement->y - movement->y0);
  T2d values_1 = predictors_adaptation_correction_ahead_of(movement, own);
  along = values_1.f0;
  ahead = (predictors_adaptation_distances_Ahead){along, own.wide, own.broad, own.tail};
  T3d values_2 = predictors_adaptation_distances_combine(&person->distances, reached, ahead);
  usual_along = values_2.f0;
  usual_wide = values_2.f1;
  usual = values_2.f2;
  weight = predictors_adaptation_correction_fading(share, predictors_adaptation_correction_FADE);
  along += weight * (usual_along - along);
  return (T_predictors_adaptation_destination_Heading_d){predictors_adaptation_correction_with_centre_ahead(movement, own, along, own.wide * pow(usual_wide / own.wide, weight)), usual};
}

/* How far from a place its visits end, as a share of the distance to it: the geometric mean. */
double predictors_adaptation_habits_usual_width(predictors_adaptation_habits_Habits * s) {
  double log_width;
  log_width = 0.0;
  for (int64_t k = 0; k < 3; k++) {
    log_width = log_width + predictors_adaptation_habits_width_weight(s, k) * log(((const double *)&predictors_adaptation_habits_WIDTHS)[k]);
  }
  return exp(log_width);
}

/* Shift the shares before the movement towards the places near its start; their sum stays. */
void predictors_adaptation_destination_favour_near(predictors_adaptation_destination_Movement * s, predictors_adaptation_places_Places * held, T2d start, double near) {
  double before, after, distance, nearest;
  before = 0.0;
  after = 0.0;
  for (int64_t i = 0, end_1 = (int64_t)held->count; i < end_1; i++) {
    distance = hypot(held->places[i].x - start.f0, held->places[i].y - start.f1);
    before += s->before[i];
    nearest = predictors_adaptation_destination_NEAREST * near;
    s->before[i] *= distance > near ? pow(max_float(distance, nearest), -predictors_adaptation_destination_NEARNESS) : 0.0;
    after += s->before[i];
  }
  for (int64_t i = 0, end_2 = (int64_t)held->count; i < end_2; i++) {
    s->before[i] *= after > 0.0 ? before / after : 0.0;
  }
}

/* Lay out the share of each place before a movement from ``start``, px from the origin. */
void predictors_adaptation_destination_prepare(predictors_adaptation_destination_Movement * s, predictors_adaptation_places_Places * held, predictors_adaptation_habits_Habits * known, T3d scene, T2d start) {
  double key, with_sequence, near, weight;
  Table out;
  double buffer_1[256];
  key = scene.f0;
  with_sequence = scene.f1;
  near = scene.f2;
  memset(buffer_1, 0, sizeof buffer_1);
  out = (Table){buffer_1, predictors_adaptation_habits_RULES, predictors_adaptation_places_CAPACITY};
  memset(s, 0, sizeof(predictors_adaptation_destination_Movement));
  s->ready = 1.0;
  s->elsewhere = 1.0;
  if (!predictors_adaptation_habits_shares(known, held, key, (T3d){start.f0, start.f1, near}, out)) {
    return;
  }
  s->returns = predictors_adaptation_habits_returns(known);
  s->width = predictors_adaptation_habits_usual_width(known);
  for (int64_t rule = 0; rule < predictors_adaptation_habits_RULES; rule++) {
    weight = predictors_adaptation_habits_rule_weight(known, rule, with_sequence);
    for (int64_t i = 0; i < predictors_adaptation_places_CAPACITY; i++) {
      s->before[i] += weight * out.p[rule * out.m + i];
    }
  }
  predictors_adaptation_destination_favour_near(s, held, start, near);
}

/* Lay out how likely each place is for a movement from ``start``, px from the window's origin. */
void predictors_adaptation_correction_prepare(predictors_adaptation_correction_Settings * settings, predictors_adaptation_correction_Person * person, predictors_adaptation_destination_Movement * going, T2d start) {
  double near;
  T3d where;
  near = predictors_adaptation_places_NEAR_SHARE * person->distances.last[0];
  where = (T3d){settings->scene.key, settings->sequence, near};
  predictors_adaptation_destination_prepare(going, &person->places, &person->habits, where, start);
}

/* How likely a law makes a place, over what it is where nothing is known. */
double predictors_adaptation_destination_likelihood(predictors_adaptation_destination_Heading law_of_end, double x, double y, double distance, double spread) {
  double ux, uy, wide, broad, tail, dx, dy, along, across, wide2, broad2, far2, density;
  ux = law_of_end.ux;
  uy = law_of_end.uy;
  wide = law_of_end.wide;
  broad = law_of_end.broad;
  tail = law_of_end.tail;
  dx = x - law_of_end.x;
  dy = y - law_of_end.y;
  along = dx * ux + dy * uy;
  across = dy * ux - dx * uy;
  wide2 = wide * wide + spread * spread;
  broad2 = broad * broad + spread * spread;
  far2 = along * along / wide2 + across * across / broad2;
  density = pow(1.0 + far2 / tail, -0.5 * (tail + 2.0)) / (2.0 * 3.141592653589793 * sqrt(wide2 * broad2));
  return density * 2.0 * 3.141592653589793 * distance * distance * predictors_adaptation_distances_UNKNOWN_LOGS;
}

/* The share of each place now, and of elsewhere; positions in px from the origin. */
void predictors_adaptation_destination_weigh(predictors_adaptation_destination_Movement * s, predictors_adaptation_places_Places * held, T2d start, predictors_adaptation_destination_Heading law_of_end, T2d elsewhere) {
  double x0, y0, usual, counts, total, before, share, x, y, distance, spread, rest;
  int64_t count;
  x0 = start.f0;
  y0 = start.f1;
  usual = elsewhere.f0;
  counts = elsewhere.f1;
  s->counts = counts;
  count = (int64_t)held->count;
  total = (1.0 - s->returns) * usual;
  for (int64_t i = 0; i < count; i++) {
    before = s->before[i];
    share = 0.0;
    if (before > predictors_adaptation_destination_LEAST_SHARE) {
      x = held->places[i].x;
      y = held->places[i].y;
      distance = hypot(x - x0, y - y0);
      spread = s->width * distance;
      share = s->returns * before * predictors_adaptation_destination_likelihood(law_of_end, x, y, distance, spread);
    }
    s->now[i] = share;
    total += share;
  }
  rest = 1.0;
  for (int64_t i = 0; i < count; i++) {
    s->now[i] = s->now[i] / total;
    rest -= s->now[i];
  }
  s->elsewhere = max_float(rest, 0.0);
}

/* A law whose centre is shifted. */
predictors_adaptation_destination_Heading predictors_adaptation_destination_shift_law(predictors_adaptation_destination_Heading heading, double dx, double dy) {
  double x, y, ux, uy, wide, broad, tail;
  x = heading.x;
  y = heading.y;
  ux = heading.ux;
  uy = heading.uy;
  wide = heading.wide;
  broad = heading.broad;
  tail = heading.tail;
  return (predictors_adaptation_destination_Heading){x + dx, y + dy, ux, uy, wide, broad, tail};
}

/* How far visits of a place end from it, px. */
double predictors_adaptation_destination_spread_of(predictors_adaptation_destination_Movement * s, T2d start, double x, double y) {
  return s->width * hypot(x - start.f0, y - start.f1);
}

/* Fill rows of share, position and squared width, px^2: elsewhere, then the places; returns how many. */
int64_t predictors_adaptation_destination_candidates(predictors_adaptation_destination_Movement * s, predictors_adaptation_places_Places * held, T2d start, predictors_adaptation_destination_Heading elsewhere, Table out) {
  double size2, rest, share, x, y, spread;
  int64_t count;
  size2 = 0.5 * (elsewhere.wide * elsewhere.wide + elsewhere.broad * elsewhere.broad);
  rest = 1.0 - s->counts * (1.0 - s->elsewhere);
  out.p[0 * out.m + 0] = rest;
  out.p[0 * out.m + 1] = elsewhere.x;
  out.p[0 * out.m + 2] = elsewhere.y;
  out.p[0 * out.m + 3] = size2;
  count = 1;
  for (int64_t i = 0, end_1 = (int64_t)held->count; i < end_1; i++) {
    share = s->counts * s->now[i];
    if (share > predictors_adaptation_destination_NEGLIGIBLE) {
      x = held->places[i].x;
      y = held->places[i].y;
      spread = predictors_adaptation_destination_spread_of(s, start, x, y);
      out.p[count * out.m + 0] = share;
      out.p[count * out.m + 1] = x;
      out.p[count * out.m + 2] = y;
      out.p[count * out.m + 3] = spread * spread;
      count += 1;
    }
  }
  return count;
}

/* The point with the least mean distance from where the movement may end (Weiszfeld), px. */
WIDE T2d predictors_adaptation_destination_geometric_median(Table rows, int64_t count) {
  double x, y, total, sum_x, sum_y, sum_w, dx, dy, w;
  x = 0.0;
  y = 0.0;
  total = 0.0;
  for (int64_t k = 0; k < count; k++) {
    x += rows.p[k * rows.m + 0] * rows.p[k * rows.m + 1];
    y += rows.p[k * rows.m + 0] * rows.p[k * rows.m + 2];
    total += rows.p[k * rows.m + 0];
  }
  x = x / total;
  y = y / total;
  for (int64_t i_1 = 0; i_1 < predictors_adaptation_destination_STEPS; i_1++) {
    sum_x = 0.0;
    sum_y = 0.0;
    sum_w = 0.0;
    for (int64_t k = 0; k < count; k++) {
      dx = rows.p[k * rows.m + 1] - x;
      dy = rows.p[k * rows.m + 2] - y;
      w = rows.p[k * rows.m + 0] / sqrt(dx * dx + dy * dy + rows.p[k * rows.m + 3]);
      sum_x += w * rows.p[k * rows.m + 1];
      sum_y += w * rows.p[k * rows.m + 2];
      sum_w += w;
    }
    x = sum_x / sum_w;
    y = sum_y / sum_w;
  }
  return (T2d){x, y};
}

/* The law of the endpoint by the places and elsewhere: ``elsewhere`` moved and of another size. */
predictors_adaptation_destination_Heading predictors_adaptation_destination_combine(predictors_adaptation_destination_Movement * s, predictors_adaptation_places_Places * held, T2d start, predictors_adaptation_destination_Heading elsewhere) {
  Table rows;
  int64_t count;
  double x, y, ux, uy, wide, broad, tail, new_wide, new_broad, total, dx, dy, share, along, across, wide2, broad2;
  double buffer_1[260];
  rows = (Table){buffer_1, predictors_adaptation_places_CAPACITY + 1, 4};
  count = predictors_adaptation_destination_candidates(s, held, start, elsewhere, rows);
  if (count == 1) {
    return elsewhere;
  }
  T2d values_2 = predictors_adaptation_destination_geometric_median(rows, count);
  x = values_2.f0;
  y = values_2.f1;
  ux = elsewhere.ux;
  uy = elsewhere.uy;
  wide = elsewhere.wide;
  broad = elsewhere.broad;
  tail = elsewhere.tail;
  new_wide = 0.0;
  new_broad = 0.0;
  total = 0.0;
  for (int64_t k = 0; k < count; k++) {
    dx = rows.p[k * rows.m + 1] - x;
    dy = rows.p[k * rows.m + 2] - y;
    share = rows.p[k * rows.m + 0];
    along = dx * ux + dy * uy;
    across = dy * ux - dx * uy;
    T2d values_3 = k == 0 ? (T2d){wide * wide, broad * broad} : (T2d){rows.p[k * rows.m + 3], rows.p[k * rows.m + 3]};
    wide2 = values_3.f0;
    broad2 = values_3.f1;
    new_wide += share * sqrt(along * along + wide2);
    new_broad += share * sqrt(across * across + broad2);
    total += share;
  }
  return (predictors_adaptation_destination_Heading){x, y, ux, uy, new_wide / total, new_broad / total, tail};
}

/* The law of the endpoint by the places where the person was before. */
predictors_adaptation_destination_Heading predictors_adaptation_correction_by_places(predictors_adaptation_correction_Settings * settings, predictors_adaptation_correction_Person * person, predictors_adaptation_correction_Movement * movement, T2_predictors_adaptation_destination_Heading_ laws, T2d weights) {
  predictors_adaptation_destination_Heading own, elsewhere, combined;
  predictors_adaptation_correction_Window * scene;
  predictors_adaptation_destination_Movement * going;
  predictors_adaptation_places_Places * held;
  T2d start;
  own = laws.f0;
  elsewhere = laws.f1;
  scene = &settings->scene;
  going = &movement->destination;
  held = &person->places;
  start = (T2d){movement->x0 - scene->x, movement->y0 - scene->y};
  if (going->ready == 0.0) {
    predictors_adaptation_correction_prepare(settings, person, going, start);
  }
  if (going->returns == 0.0) {
    return elsewhere;
  }
  predictors_adaptation_destination_weigh(going, held, start, predictors_adaptation_destination_shift_law(own, -scene->x, -scene->y), weights);
  combined = predictors_adaptation_destination_combine(going, held, start, predictors_adaptation_destination_shift_law(elsewhere, -scene->x, -scene->y));
  return predictors_adaptation_destination_shift_law(combined, scene->x, scene->y);
}

/* The law of the endpoint by all parts that answer, and that of elsewhere, without the places. */
T2_predictors_adaptation_destination_Heading_ predictors_adaptation_correction_adapted_end(predictors_adaptation_correction_Settings * settings, predictors_adaptation_correction_Person * person, predictors_adaptation_correction_Movement * movement, predictors_adaptation_destination_Heading own, double share) {
  predictors_adaptation_destination_Heading elsewhere;
  double usual;
  T2d weights;
  elsewhere = own;
  usual = 1.0;
  if (settings->distances == 1.0) {
    T_predictors_adaptation_destination_Heading_d values_1 = predictors_adaptation_correction_by_distances(person, movement, own, share);
    elsewhere = values_1.f0;
    usual = values_1.f1;
  }
  if (settings->places == 0.0) {
    return (T2_predictors_adaptation_destination_Heading_){elsewhere, elsewhere};
  }
  weights = (T2d){usual, predictors_adaptation_correction_fading(share, predictors_adaptation_correction_PLACES_FADE)};
  return (T2_predictors_adaptation_destination_Heading_){predictors_adaptation_correction_by_places(settings, person, movement, (T2_predictors_adaptation_destination_Heading_){own, elsewhere}, weights), elsewhere};
}

/* The likeliest place that is less likely than ``below``; -1 where there is none above ``LEAST``. */
int64_t predictors_adaptation_mixed_region_likeliest(predictors_adaptation_places_Places * held, predictors_adaptation_destination_Movement * going, double below) {
  int64_t best;
  double most, share;
  best = -1;
  most = predictors_adaptation_mixed_region_LEAST;
  for (int64_t i = 0, end_1 = (int64_t)held->count; i < end_1; i++) {
    share = going->now[i];
    if (most < share && share < below) {
      best = i;
      most = share;
    }
  }
  return best;
}

/* Write a place: a normal law of a standard deviation in px. */
void predictors_adaptation_mixed_region_write_part(predictors_mixture_PartRow * part, double share, T2d centre, double spread) {
  part->share = share;
  part->x = centre.f0;
  part->y = centre.f1;
  part->sxx = spread * spread;
  part->sxy = 0.0;
  part->syy = spread * spread;
  part->tail = 0.0;
}

/* Write the mixture as it is now, and what its regions must hold of it. */
void predictors_adaptation_mixed_region_write(predictors_adaptation_levels_Offsets * offsets, predictors_adaptation_places_Places * held, predictors_adaptation_destination_Movement * going, predictors_adaptation_mixed_region_Movement * now, predictors_adaptation_mixed_region_Mixture * to, T2d origin, T2d start) {
  int64_t count, number;
  double rest, below, spread;
  predictors_adaptation_places_Place * place;
  predictors_mixture_PartRow * elsewhere;
  count = 1;
  rest = 1.0;
  below = 2.0;
  number = predictors_adaptation_mixed_region_likeliest(held, going, below);
  while (number >= 0 && count <= predictors_adaptation_mixed_region_MOST_PLACES) {
    below = going->now[number];
    place = &held->places[number];
    spread = max_float(predictors_adaptation_destination_spread_of(going, start, place->x, place->y), predictors_adaptation_mixed_region_LEAST_SPREAD);
    predictors_adaptation_mixed_region_write_part(&to->rows[count], below, (T2d){place->x + origin.f0, place->y + origin.f1}, spread);
    rest -= below;
    count += 1;
    number = predictors_adaptation_mixed_region_likeliest(held, going, below);
  }
  elsewhere = &to->rows[0];
  to->count = count;
  elsewhere->share = max_float(rest, 0.0);
  for (int64_t i = 0; i < 6; i++) {
    (Vector){(double *)elsewhere, 7}.p[1 + i] = now->elsewhere[i];
  }
  for (int64_t which = 0; which < 2; which++) {
    to->offsets[which] = predictors_adaptation_levels_offset(offsets, now->time, which);
  }
}

/* Write the mixture of places and elsewhere as it is claimed now. */
void predictors_adaptation_correction_write_mixture(predictors_adaptation_correction_Settings * settings, predictors_adaptation_correction_Person * person, predictors_adaptation_correction_Movement * movement, predictors_adaptation_mixed_region_Mixture * to) {
  predictors_adaptation_correction_Window * scene;
  T2d start;
  scene = &settings->scene;
  start = (T2d){movement->x0 - scene->x, movement->y0 - scene->y};
  predictors_adaptation_mixed_region_write(&person->regions.mixed, &person->places, &movement->destination, &movement->now, to, (T2d){scene->x, scene->y}, start);
}

/* Remember elsewhere's law at a share of the time: its centre, scale matrix and tail. */
void predictors_adaptation_mixed_region_claim(predictors_adaptation_mixed_region_Movement * s, double share, T6d elsewhere) {
  s->claimed = 1.0;
  s->time = share;
  for (int64_t i = 0; i < 6; i++) {
    s->elsewhere[i] = ((const double *)&elsewhere)[i];
  }
}

/* Remember the law stated at a moment, when the cursor is at (t, x, y): endpoint, scale matrix, tail. */
int64_t predictors_adaptation_region_widening_record(predictors_adaptation_region_widening_Movement * stated, T3d cursor, T6d region) {
  predictors_adaptation_region_widening_Moment * last, *m;
  int64_t number;
  bool full;
  last = &stated->moments[max_whole((int64_t)stated->series.count - 1, 0)];
  Tqb values_1 = predictors_adaptation_moments_next_moment(&stated->series, last->t, cursor, predictors_adaptation_region_widening_MOST);
  number = values_1.f0;
  full = values_1.f1;
  if (number < 0) {
    return -1;
  }
  if (full) {
    for (int64_t k = 1; k < number; k++) {
      stage_copy_values((Vector){(double *)&stated->moments[2 * k], 45}, (Vector){(double *)&stated->moments[k], 45});
    }
  }
  m = &stated->moments[number];
  m->t = cursor.f0;
  m->x = region.f0;
  m->y = region.f1;
  m->sxx = region.f2;
  m->sxy = region.f3;
  m->syy = region.f4;
  m->tail = region.f5;
  return number;
}

/* Remember what is stated at a share of the time: the single law, and that of elsewhere. */
void predictors_adaptation_correction_state(predictors_adaptation_correction_Settings * settings, predictors_adaptation_correction_Person * person, predictors_adaptation_correction_Movement * movement, double share, T2_T6d_ laws) {
  T6d region, elsewhere;
  T3d cursor;
  int64_t number;
  region = laws.f0;
  elsewhere = laws.f1;
  predictors_adaptation_mixed_region_claim(&movement->now, share, elsewhere);
  cursor = (T3d){movement->t, movement->x, movement->y};
  number = predictors_adaptation_region_widening_record(&movement->regions, cursor, region);
  if (number >= 0) {
    predictors_adaptation_correction_write_mixture(settings, person, movement, &movement->regions.moments[number].mixture);
  }
}

/* Logarithm of what a stage multiplies a width by, from the sum for it. */
double predictors_adaptation_stages_width_log(predictors_adaptation_stages_Stage * s, double squares) {
  return 0.5 * log((squares + predictors_adaptation_stages_WIDTHS_OF) / (s->count + predictors_adaptation_stages_WIDTHS_OF));
}

/* (bias px, factors of the width along, the width across, the time left). */
T4d predictors_adaptation_stages_correct(predictors_adaptation_stages_Stages * known, double share, double total, double along) {
  int64_t stage;
  double part, shift, wide, broad, slow, weight;
  predictors_adaptation_stages_Stage * s;
  Tqd values_1 = predictors_adaptation_stages_interpolation(share);
  stage = values_1.f0;
  part = values_1.f1;
  shift = 0.0;
  wide = 0.0;
  broad = 0.0;
  slow = 0.0;
  for (int64_t side = 0; side < 2; side++) {
    s = &known->stages[stage + side];
    weight = side == 1 ? part : 1.0 - part;
    shift = shift + weight * predictors_adaptation_stages_bias(s, total, along) * predictors_adaptation_stages_belief(s->bias_paid, s->bias_size);
    wide = wide + weight * predictors_adaptation_stages_width_log(s, s->wide);
    broad = broad + weight * predictors_adaptation_stages_width_log(s, s->broad);
    slow = slow + weight * predictors_adaptation_stages_tempo(s) * predictors_adaptation_stages_belief(s->tempo_paid, s->tempo_size);
  }
  return (T4d){shift, exp(wide), exp(broad), exp(slow)};
}

/* The time left by the best mixture; what the predictor says before any movement is known. */
double predictors_adaptation_durations_mix(predictors_adaptation_durations_Durations * s, double since, double left) {
  if (s->count == 0.0) {
    return left;
  }
  return predictors_adaptation_durations_mixture(s, s->best, since, left);
}

/* (factor of the scale matrix, tail) of the law whose regions of both levels have the learned radii. */
T2d predictors_adaptation_region_widening_widen(predictors_adaptation_region_widening_Radii * s, double share, double tail) {
  double heavy_now, first, second, near, far, ratio, low, high, heavy, half, most, both;
  if (s->movements == 0.0) {
    return (T2d){1.0, tail};
  }
  heavy_now = predictors_mixture_heaviness(tail);
  first = predictors_adaptation_levels_offset(&s->single, share, 0);
  second = predictors_adaptation_levels_offset(&s->single, share, 1);
  near = log(predictors_mixture_corrected_radius(predictors_mixture_LEVELS.f0, heavy_now, first) * 2.0 / heavy_now);
  far = log(predictors_mixture_corrected_radius(predictors_mixture_LEVELS.f1, heavy_now, second) * 2.0 / heavy_now);
  ratio = exp(far - near);
  low = predictors_adaptation_region_widening_LIGHTEST;
  high = predictors_adaptation_region_widening_HEAVIEST;
  for (int64_t i_1 = 0; i_1 < predictors_adaptation_region_widening_HALVINGS; i_1++) {
    heavy = 0.5 * (low + high);
    if (predictors_mixture_squared_radius_over_tail(predictors_mixture_LEVELS.f1, heavy) < ratio * predictors_mixture_squared_radius_over_tail(predictors_mixture_LEVELS.f0, heavy)) {
      low = heavy;
    } else {
      high = heavy;
    }
  }
  heavy = 0.5 * (low + high);
  half = predictors_mixture_squared_radius_over_tail(predictors_mixture_LEVELS.f0, heavy);
  most = predictors_mixture_squared_radius_over_tail(predictors_mixture_LEVELS.f1, heavy);
  both = half * most * square(2.0 / heavy);
  return (T2d){exp(0.5 * (near + far - log(both))), 2.0 / heavy};
}

/* The endpoint, the scale matrix times a factor, and a tail. */
T6d predictors_adaptation_destination_scaled(predictors_adaptation_destination_Heading end, double shape, double factor, double tail) {
  double wide2, broad2, cross, ux, uy, sxx, sxy, syy;
  wide2 = factor * end.wide * end.wide;
  broad2 = factor * end.broad * end.broad;
  cross = factor * shape * end.wide * end.broad;
  ux = end.ux;
  uy = end.uy;
  sxx = wide2 * ux * ux - 2.0 * cross * ux * uy + broad2 * uy * uy;
  sxy = (wide2 - broad2) * ux * uy + cross * (ux * ux - uy * uy);
  syy = wide2 * uy * uy + 2.0 * cross * ux * uy + broad2 * ux * ux;
  return (T6d){end.x, end.y, sxx, sxy, syy, tail};
}

/* What the time left is a sum of, in medians of the last durations; ``since`` s have passed. */
T7d predictors_adaptation_time_left_terms(predictors_adaptation_time_left_Estimates estimates, predictors_adaptation_time_left_Way way, predictors_adaptation_time_left_Pace pace, double since, double median) {
  double mixed, predicted, share, slow, near;
  mixed = min_float(estimates.mixed / median, predictors_adaptation_time_left_LONGEST);
  predicted = min_float(estimates.predicted / median, predictors_adaptation_time_left_LONGEST);
  share = way.left / (way.left + way.done);
  slow = min_float(pace.slow_s / median, 1.0) / (since / median + predictors_adaptation_time_left_START);
  near = predictors_adaptation_time_left_NEAR * predictors_adaptation_time_left_NEAR / (predictors_adaptation_time_left_NEAR * predictors_adaptation_time_left_NEAR + share * share);
  return (T7d){mixed, predicted, 1.0, share, pace.of_peak * predicted, slow, near};
}

/* The weights of the terms for this person. */
void predictors_adaptation_time_left_solve(predictors_adaptation_time_left_Sums * s, Vector prior, Vector weights) {
  Vector factors;
  double buffer_1[28];
  factors = (Vector){buffer_1, predictors_adaptation_time_left_SUMS};
  predictors_adaptation_time_left_factor(s, prior, factors);
  for (int64_t i = 0; i < predictors_adaptation_time_left_TERMS; i++) {
    weights.p[i] = s->residuals[i];
    for (int64_t j = 0; j < i; j++) {
      weights.p[i] -= factors.p[floor_divided_whole(i * (i + 1), 2) + j] * weights.p[j];
    }
  }
  for (int64_t i = 0; i < predictors_adaptation_time_left_TERMS; i++) {
    weights.p[i] = weights.p[i] / factors.p[floor_divided_whole(i * (i + 3), 2)];
  }
  for (int64_t i = predictors_adaptation_time_left_TERMS - 1; i > (-1); i--) {
    for (int64_t j = i + 1; j < predictors_adaptation_time_left_TERMS; j++) {
      weights.p[i] -= factors.p[floor_divided_whole(j * (j + 1), 2) + i] * weights.p[j];
    }
  }
  for (int64_t i = 0; i < predictors_adaptation_time_left_TERMS; i++) {
    weights.p[i] += prior.p[i];
  }
}

/* The time left in s and the spread of its logarithm, ``since`` s after the start; remembers both. */
T2d predictors_adaptation_time_left_weighed(predictors_adaptation_time_left_Sums * s, predictors_adaptation_arrival_intervals_Intervals * intervals, predictors_adaptation_time_left_Movement * movement, T3d cursor, double since, double median, double predicted, T7d known, Vector prior) {
  double total, left, spread;
  predictors_adaptation_time_left_Moment * last, *m;
  int64_t number;
  bool full;
  if (movement->ready == 0.0) {
    predictors_adaptation_time_left_solve(s, prior, (Vector){movement->weights, 7});
    movement->ready = 1.0;
  }
  total = 0.0;
  for (int64_t i = 0; i < predictors_adaptation_time_left_TERMS; i++) {
    total += movement->weights[i] * ((const double *)&known)[i];
  }
  left = max_float(min_float(total, predictors_adaptation_time_left_FURTHEST) * median, predictors_adaptation_time_left_LEAST * min_float(predicted, median));
  spread = predictors_adaptation_arrival_intervals_spread(intervals, since / (since + left));
  last = &movement->moments[max_whole((int64_t)movement->series.count - 1, 0)];
  Tqb values_1 = predictors_adaptation_moments_next_moment(&movement->series, last->t, cursor, predictors_adaptation_time_left_MOST);
  number = values_1.f0;
  full = values_1.f1;
  if (full) {
    for (int64_t k = 1; k < number; k++) {
      stage_copy_values((Vector){(double *)&movement->moments[2 * k], 10}, (Vector){(double *)&movement->moments[k], 10});
    }
  }
  if (number >= 0) {
    m = &movement->moments[number];
    m->t = cursor.f0;
    m->left = left;
    m->spread = spread;
    for (int64_t i = 0; i < predictors_adaptation_time_left_TERMS; i++) {
      m->terms[i] = ((const double *)&known)[i];
    }
  }
  return (T2d){left, spread};
}

/* ``weighed`` by everybody's weights, from what the terms are made of. */
T2d predictors_adaptation_time_left_stated(predictors_adaptation_time_left_Sums * s, predictors_adaptation_arrival_intervals_Intervals * intervals, predictors_adaptation_time_left_Movement * movement, T3d cursor, double since, double median, predictors_adaptation_time_left_Estimates estimates, predictors_adaptation_time_left_Way way, predictors_adaptation_time_left_Pace pace) {
  T7d known;
  known = predictors_adaptation_time_left_terms(estimates, way, pace, since, median);
  return predictors_adaptation_time_left_weighed(s, intervals, movement, cursor, since, median, estimates.predicted, known, (Vector){(double *)predictors_adaptation_time_left_prior_PRIOR, 35});
}

/* The prediction as it is for this person; as it was where it claims too little or has no direction. */
T10d predictors_adaptation_correction_adapt(predictors_adaptation_correction_Settings * settings, predictors_adaptation_correction_Person * person, predictors_adaptation_correction_Movement * movement, T10d answer, predictors_adaptation_time_left_Pace pace) {
  double t, px, py, sxx, sxy, syy, predicted, phase, tail, ux, uy, wide, broad, now, x, y, reached, since, along, across, share, total, shift, widen, broaden, slow, left, shape, factor, spread;
  predictors_adaptation_destination_Heading heading, own, end, elsewhere;
  int64_t stage;
  predictors_adaptation_stages_Moment * m;
  T6d first, region;
  t = answer.f0;
  px = answer.f1;
  py = answer.f2;
  sxx = answer.f3;
  sxy = answer.f4;
  syy = answer.f5;
  predicted = answer.f6;
  phase = answer.f7;
  tail = answer.f8;
  heading = predictors_adaptation_correction_heading_of(movement, answer);
  ux = heading.ux;
  uy = heading.uy;
  wide = heading.wide;
  broad = heading.broad;
  movement->now.claimed = 0.0;
  if (wide == 0.0) {
    return answer;
  }
  now = movement->t;
  x = movement->x;
  y = movement->y;
  reached = hypot(x - movement->x0, y - movement->y0);
  since = now - movement->t0;
  T2d values_1 = predictors_adaptation_correction_ahead_of(movement, heading);
  along = values_1.f0;
  across = values_1.f1;
  share = since / (since + predicted);
  stage = predictors_adaptation_correction_stage_begun(movement, share);
  if (stage >= 0) {
    m = &movement->stages[stage];
    m->present = 1.0;
    m->t = now;
    m->x = x;
    m->y = y;
    m->reached = reached;
    m->ux = ux;
    m->uy = uy;
    m->along = along;
    m->across = across;
    m->wide = wide;
    m->broad = broad;
    m->tail = tail;
    m->left = predicted;
  }
  if (person->distances.count == 0.0) {
    first = (T6d){px, py, sxx, sxy, syy, tail};
    predictors_adaptation_correction_state(settings, person, movement, share, (T2_T6d_){first, first});
    return answer;
  }
  total = hypot(reached + along, across);
  T4d values_2 = predictors_adaptation_stages_correct(&person->stages, share, total, along);
  shift = values_2.f0;
  widen = values_2.f1;
  broaden = values_2.f2;
  slow = values_2.f3;
  left = predictors_adaptation_durations_mix(&person->durations, since, predicted * slow);
  share = since / (since + left);
  shape = (sxy * (ux * ux - uy * uy) + (syy - sxx) * ux * uy) / (wide * broad);
  own = predictors_adaptation_correction_with_centre_ahead(movement, heading, along + shift * predictors_adaptation_correction_fading(share, predictors_adaptation_correction_BIAS_FADE), wide * widen);
  own = (predictors_adaptation_destination_Heading){own.x, own.y, ux, uy, own.wide, broad * broaden, tail};
  T2_predictors_adaptation_destination_Heading_ values_3 = predictors_adaptation_correction_adapted_end(settings, person, movement, own, share);
  end = values_3.f0;
  elsewhere = values_3.f1;
  T2d values_4 = predictors_adaptation_region_widening_widen(&person->regions, share, tail);
  factor = values_4.f0;
  tail = values_4.f1;
  region = predictors_adaptation_destination_scaled(end, shape, factor, tail);
  predictors_adaptation_correction_state(settings, person, movement, share, (T2_T6d_){region, predictors_adaptation_destination_scaled(elsewhere, shape, factor, tail)});
  px = region.f0;
  py = region.f1;
  sxx = region.f2;
  sxy = region.f3;
  syy = region.f4;
  T2d values_5 = predictors_adaptation_time_left_stated(&person->time_left, &person->intervals, &movement->time_left, (T3d){now, x, y}, since, person->durations.median, (predictors_adaptation_time_left_Estimates){left, predicted}, (predictors_adaptation_time_left_Way){reached, hypot(px - x, py - y)}, pace);
  left = values_5.f0;
  spread = values_5.f1;
  return (T10d){t, px, py, sxx, sxy, syy, left, phase, tail, spread};
}

/* How many settings, learned floats and states there are: without adaptation nothing is learned. */
T3q predictors_adaptation_predictor_sizes(Vector values) {
  int64_t learned;
  learned = values.p[predictors_adaptation_predictor_ADAPT_OF] == 1.0 ? 628 : 0;
  return (T3q){11, learned, 3949 - 11 - learned};
}

/* The movement has ended: learn from it. The next one is in the window that was entered last. */
void predictors_adaptation_predictor_conclude(predictors_adaptation_predictor_Memory * memory) {
  predictors_adaptation_predictor_Settings * settings;
  predictors_adaptation_correction_Window * scene, *after;
  settings = &memory->settings;
  if (settings->adapt == 1.0) {
    predictors_adaptation_correction_conclude(&settings->adaptation, &memory->person, &memory->movement);
    scene = &settings->adaptation.scene;
    after = &settings->next;
    scene->key = after->key;
    scene->x = after->x;
    scene->y = after->y;
  }
}

/* The hand's speed over its peak and how long it has been slow; ``own``: memory of `kinematic`. */
predictors_adaptation_time_left_Pace predictors_adaptation_predictor_pace_of(predictors_kinematic_features_State * own, records_MotionRow m) {
  double of_peak;
  of_peak = own->track.peak > 0.0 ? hypot(m.vx, m.vy) / own->track.peak : 0.0;
  return (predictors_adaptation_time_left_Pace){of_peak, m.t - own->movement.t0 - own->track.fast_t};
}

/* The learned predictor's step, then what is known of the person. */
T10d predictors_adaptation_predictor_step(predictors_adaptation_predictor_Memory * memory, T10d motion, predictors_kinematic_network_Coefficients * coefficients) {
  records_MotionRow m;
  predictors_kinematic_features_State * own;
  T10d answer;
  T3d start;
  predictors_adaptation_correction_Settings * settings;
  predictors_adaptation_time_left_Pace pace;
  m = records_MotionRow_of_T10d(motion);
  own = &memory->observation;
  answer = predictors_kinematic_predictor_step(own, motion, coefficients);
  if (memory->settings.adapt == 0.0 || answer.f0 != answer.f0) {
    return answer;
  }
  if (m.start == 1.0) {
    predictors_adaptation_predictor_conclude(memory);
  }
  start = (T3d){own->movement.t0, own->movement.x0, own->movement.y0};
  predictors_adaptation_correction_follow(&memory->movement, (T3d){m.t, m.x, m.y}, start);
  settings = &memory->settings.adaptation;
  pace = predictors_adaptation_predictor_pace_of(own, m);
  return predictors_adaptation_correction_adapt(settings, &memory->person, &memory->movement, answer, pace);
}

/* The next movement is in this window or page; at once where none goes on. */
void predictors_adaptation_predictor_enter_scene(predictors_adaptation_predictor_Memory * memory, scene_Scene scene) {
  predictors_adaptation_correction_Window * now, *after;
  now = &memory->settings.adaptation.scene;
  after = &memory->settings.next;
  after->key = scene.key;
  after->x = scene.x;
  after->y = scene.y;
  if (memory->settings.adapt == 0.0 || memory->movement.started == 0.0) {
    now->key = scene.key;
    now->x = scene.x;
    now->y = scene.y;
  }
}

/* Where the last movement to a place of this key ended, px from the origin; the origin if none did. */
T2d predictors_adaptation_predictor_last_end(predictors_adaptation_places_Places * held, double key) {
  int64_t number;
  predictors_adaptation_places_Place * place;
  for (int64_t age = 0; age < predictors_adaptation_places_MOVEMENTS; age++) {
    number = predictors_adaptation_places_visited(held, age);
    place = &held->places[max_whole(number, 0)];
    if (number >= 0 && place->key == key) {
      return (T2d){place->x, place->y};
    }
  }
  return (T2d){0.0, 0.0};
}

/* Fill a row for each place of the window that the cursor is in, by their numbers; returns how many. */
int64_t predictors_adaptation_predictor_list_places(predictors_adaptation_predictor_Memory * memory, Table out) {
  predictors_adaptation_correction_Settings * settings;
  predictors_adaptation_correction_Person * person;
  predictors_adaptation_destination_Movement * going;
  predictors_adaptation_correction_Window * scene;
  predictors_adaptation_places_Places * held;
  bool waits;
  T2d start;
  int64_t count;
  predictors_adaptation_places_Place * place;
  double before;
  settings = &memory->settings.adaptation;
  person = &memory->person;
  going = &memory->movement.destination;
  if (memory->settings.adapt == 0.0 || settings->places == 0.0) {
    return 0;
  }
  scene = &settings->scene;
  held = &person->places;
  waits = going->ready == 0.0;
  start = (T2d){memory->movement.x0 - scene->x, memory->movement.y0 - scene->y};
  if (waits) {
    if (memory->movement.started == 0.0) {
      start = predictors_adaptation_predictor_last_end(held, scene->key);
    }
    predictors_adaptation_correction_prepare(settings, person, going, start);
  }
  count = 0;
  for (int64_t i = 0, end_1 = (int64_t)held->count; i < end_1; i++) {
    place = &held->places[i];
    if (place->key == scene->key) {
      before = going->returns * going->before[i];
      out.p[count * out.m + predictors_adaptation_predictor_X] = place->x + scene->x;
      out.p[count * out.m + predictors_adaptation_predictor_Y] = place->y + scene->y;
      out.p[count * out.m + predictors_adaptation_predictor_P] = waits ? before : going->now[i];
      out.p[count * out.m + predictors_adaptation_predictor_BEFORE] = before;
      out.p[count * out.m + predictors_adaptation_predictor_VISITS] = place->visits;
      out.p[count * out.m + predictors_adaptation_predictor_NUMBER] = i;
      out.p[count * out.m + predictors_adaptation_predictor_SPREAD] = predictors_adaptation_destination_spread_of(going, start, place->x, place->y);
      count += 1;
    }
  }
  if (waits) {
    memset(going, 0, sizeof(predictors_adaptation_destination_Movement));
  }
  return count;
}

/* Write the mixture of places and elsewhere into the memory; whether one is claimed now. */
bool predictors_adaptation_predictor_write_mixture(predictors_adaptation_predictor_Memory * memory) {
  predictors_adaptation_predictor_Settings * settings;
  predictors_adaptation_mixed_region_Movement * now;
  settings = &memory->settings;
  now = &memory->movement.now;
  if (settings->adapt == 0.0 || settings->adaptation.places == 0.0 || now->claimed == 0.0) {
    return false;
  }
  predictors_adaptation_correction_write_mixture(&settings->adaptation, &memory->person, &memory->movement, &now->asked);
  return true;
}

/* Write the parts of the mixture into ``out``; returns how many, 0 for no mixture, and its offsets. */
Tq2d predictors_adaptation_predictor_list_parts(predictors_adaptation_predictor_Memory * memory, Table out) {
  predictors_adaptation_mixed_region_Mixture * asked;
  if (!predictors_adaptation_predictor_write_mixture(memory)) {
    return (Tq2d){0, 0.0, 0.0};
  }
  asked = &memory->movement.now.asked;
  for (int64_t k = 0, end_1 = (int64_t)asked->count; k < end_1; k++) {
    for (int64_t i = 0; i < 7; i++) {
      out.p[k * out.m + i] = (Vector){(double *)&asked->rows[k], 7}.p[i];
    }
  }
  return (Tq2d){(int64_t)asked->count, asked->offsets[0], asked->offsets[1]};
}

void loop__predictors_adaptation_predictor_conclude__records_row_at__predictors_adaptation_predictor_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out, Vector shared_0) {
  T10d answer;
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      predictors_adaptation_predictor_conclude((predictors_adaptation_predictor_Memory *)memory.p);
      fill((Vector){memory.p + first, memory.n - first}, 0.0);
    }
    answer = predictors_adaptation_predictor_step((predictors_adaptation_predictor_Memory *)memory.p, records_row_at(rows, i), (predictors_kinematic_network_Coefficients *)shared_0.p);
    for (int64_t j = 0; j < 10; j++) {
      out.p[i * out.m + j] = ((const double *)&answer)[j];
    }
  }
}

T10d joint__differentiators_difference_step__predictors_adaptation_predictor_step(Vector memory, Vector other, records_EventRow row, Vector shared_0) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_difference_step((differentiators_difference_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_adaptation_predictor_step((predictors_adaptation_predictor_Memory *)other.p, answer, (predictors_kinematic_network_Coefficients *)shared_0.p);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

bool follow__predictors_adaptation_predictor_step(Vector memory, T10d row, Vector shared_0) {
  double t;
  t = predictors_adaptation_predictor_step((predictors_adaptation_predictor_Memory *)memory.p, row, (predictors_kinematic_network_Coefficients *)shared_0.p).f0;
  return t == t;
}

T10d last__differentiators_difference_step__follow__predictors_adaptation_predictor_step__predictors_adaptation_predictor_step(Vector memory, Vector other, Table rows, Vector shared_0) {
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
    if (between.f0 != between.f0 || !follow__predictors_adaptation_predictor_step(other, between, shared_0)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_difference_step((differentiators_difference_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_adaptation_predictor_step((predictors_adaptation_predictor_Memory *)other.p, between, (predictors_kinematic_network_Coefficients *)shared_0.p);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_homogeneous_step__predictors_adaptation_predictor_step(Vector memory, Vector other, records_EventRow row, Vector shared_0) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_adaptation_predictor_step((predictors_adaptation_predictor_Memory *)other.p, answer, (predictors_kinematic_network_Coefficients *)shared_0.p);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

T10d last__differentiators_homogeneous_step__follow__predictors_adaptation_predictor_step__predictors_adaptation_predictor_step(Vector memory, Vector other, Table rows, Vector shared_0) {
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
    if (between.f0 != between.f0 || !follow__predictors_adaptation_predictor_step(other, between, shared_0)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_homogeneous_step((differentiators_homogeneous_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_adaptation_predictor_step((predictors_adaptation_predictor_Memory *)other.p, between, (predictors_kinematic_network_Coefficients *)shared_0.p);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}

T10d joint__differentiators_kalman_step__predictors_adaptation_predictor_step(Vector memory, Vector other, records_EventRow row, Vector shared_0) {
  Vector kept;
  T10d answer;
  RELEASED double *buffer_1 = copied(memory.p, sizeof(double) * memory.n);
  kept = (Vector){buffer_1, memory.n};
  answer = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, row);
  if (answer.f0 == answer.f0) {
    answer = predictors_adaptation_predictor_step((predictors_adaptation_predictor_Memory *)other.p, answer, (predictors_kinematic_network_Coefficients *)shared_0.p);
    if (answer.f0 != answer.f0) {
      copy_into((Vector){memory.p, memory.n}, kept);
    }
  }
  return answer;
}

T10d last__differentiators_kalman_step__follow__predictors_adaptation_predictor_step__predictors_adaptation_predictor_step(Vector memory, Vector other, Table rows, Vector shared_0) {
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
    if (between.f0 != between.f0 || !follow__predictors_adaptation_predictor_step(other, between, shared_0)) {
      break;
    }
    count += 1;
  }
  if (count == rows.n - 1) {
    between = differentiators_kalman_step((differentiators_kalman_Memory *)memory.p, records_EventRow_of_T6d(records_event_at(rows, count)));
    if (between.f0 == between.f0) {
      answer = predictors_adaptation_predictor_step((predictors_adaptation_predictor_Memory *)other.p, between, (predictors_kinematic_network_Coefficients *)shared_0.p);
    }
  }
  if (answer.f0 != answer.f0) {
    copy_into((Vector){memory.p, memory.n}, kept);
    copy_into((Vector){other.p, other.n}, other_kept);
  }
  return answer;
}
