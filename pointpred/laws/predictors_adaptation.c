/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const T2d predictors_adaptation_arrival_intervals_DEVIATIONS = {0.6744897501960817, 1.2815515655446004};
static const double predictors_adaptation_arrival_intervals_FURTHEST = 3.0;
static const T2d predictors_adaptation_arrival_intervals_LEVELS = {0.5, 0.8};
static const int64_t predictors_adaptation_arrival_intervals_MOVEMENTS = 0;
static const double predictors_adaptation_arrival_intervals_MOVEMENTS_MOST = 1000000.0;
static const int64_t predictors_adaptation_arrival_intervals_OFFSETS = 1;
static const T2d predictors_adaptation_arrival_intervals_SHARES = {0.6666666666666666, 1.3333333333333333};
static const double predictors_adaptation_arrival_intervals_SPREAD = 0.6;
static const int64_t predictors_adaptation_arrival_intervals_STAGES = 3;
static const double predictors_adaptation_arrival_intervals_STEP = 12.0;
static const double predictors_adaptation_arrival_intervals_STEP_LEAST = 0.15;
static const double predictors_adaptation_arrival_intervals_STEP_OF = 5.0;
static const double predictors_adaptation_correction_APART_S = 0.005;
static const double predictors_adaptation_correction_BIAS_FADE = 0.2;
static const int64_t predictors_adaptation_correction_DESTINATION = 2858;
static const int64_t predictors_adaptation_correction_DISTANCES = 80;
static const int64_t predictors_adaptation_correction_DURATIONS = 136;
static const double predictors_adaptation_correction_EARLY = 0.1;
static const double predictors_adaptation_correction_FADE = 0.5;
static const int64_t predictors_adaptation_correction_HABITS = 603;
static const int64_t predictors_adaptation_correction_INTERVALS = 213;
static const int64_t predictors_adaptation_correction_KNOWN = 217;
static const int64_t predictors_adaptation_correction_LEARNED = 628;
static const double predictors_adaptation_correction_LEAST_S = 0.08;
static const int64_t predictors_adaptation_correction_MOMENTS = 297;
static const double predictors_adaptation_correction_NEAR_PX = 8.0;
static const double predictors_adaptation_correction_NEAR_SHARE = 0.03;
static const int64_t predictors_adaptation_correction_NOW = 2991;
static const int64_t predictors_adaptation_correction_PLACES = 7;
static const double predictors_adaptation_correction_PLACES_FADE = 0.7;
static const int64_t predictors_adaptation_correction_REGIONS = 157;
static const int64_t predictors_adaptation_correction_SAMPLES = 8;
static const int64_t predictors_adaptation_correction_SAMPLES_LEAST = 6;
static const int64_t predictors_adaptation_correction_STARTED = 0;
static const int64_t predictors_adaptation_correction_STATED = 362;
static const int64_t predictors_adaptation_correction_STATES = 3037;
static const int64_t predictors_adaptation_correction_T = 4;
static const int64_t predictors_adaptation_correction_T0 = 1;
static const int64_t predictors_adaptation_correction_TIMED = 2526;
static const int64_t predictors_adaptation_correction_TIME_LEFT = 178;
static const int64_t predictors_adaptation_correction_TRACE = 9;
static const int64_t predictors_adaptation_correction_TRACE_PLACES = 96;
static const int64_t predictors_adaptation_correction_UNEQUAL = 21;
static const int64_t predictors_adaptation_correction_X = 5;
static const int64_t predictors_adaptation_correction_X0 = 2;
static const int64_t predictors_adaptation_correction_Y = 6;
static const int64_t predictors_adaptation_correction_Y0 = 3;
static const int64_t predictors_adaptation_destination_BEFORE = 4;
static const int64_t predictors_adaptation_destination_COUNTS = 3;
static const int64_t predictors_adaptation_destination_ELSEWHERE = 132;
static const double predictors_adaptation_destination_LEAST_SHARE = 0.0001;
static const double predictors_adaptation_destination_NEAREST = 2.5;
static const double predictors_adaptation_destination_NEARNESS = 1.25;
static const double predictors_adaptation_destination_NEGLIGIBLE = 0.001;
static const int64_t predictors_adaptation_destination_NOW = 68;
static const int64_t predictors_adaptation_destination_READY = 0;
static const int64_t predictors_adaptation_destination_RETURNS = 1;
static const int64_t predictors_adaptation_destination_STATES = 133;
static const int64_t predictors_adaptation_destination_STEPS = 10;
static const int64_t predictors_adaptation_destination_WIDTH = 2;
static const T2d predictors_adaptation_distances_AGES = {1.5, 12.0};
static const double predictors_adaptation_distances_ARC = 0.5;
static const int64_t predictors_adaptation_distances_BELIEF = 13;
static const int64_t predictors_adaptation_distances_CAPACITY = 12;
static const int64_t predictors_adaptation_distances_COUNT = 0;
static const int64_t predictors_adaptation_distances_DISTANCES = 1;
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
static const double predictors_adaptation_distances_SHORTEST_PX = 1e-06;
static const int64_t predictors_adaptation_distances_TOO_SHORT = 1;
static const int64_t predictors_adaptation_distances_TOO_SURE = 2;
static const double predictors_adaptation_distances_UNKNOWN_LOGS = 3.0;
static const double predictors_adaptation_distances_UNKNOWN_SHARE = 0.98;
static const int64_t predictors_adaptation_distances_WEIGHTS = 20;
static const T3d predictors_adaptation_distances_WIDTHS = {0.02, 0.08, 0.35};
static const int64_t predictors_adaptation_durations_BEST = 20;
static const int64_t predictors_adaptation_durations_CAPACITY = 12;
static const int64_t predictors_adaptation_durations_COUNT = 0;
static const int64_t predictors_adaptation_durations_DURATIONS = 1;
static const int64_t predictors_adaptation_durations_ERRORS = 14;
static const int64_t predictors_adaptation_durations_FINE = 0;
static const T5d predictors_adaptation_durations_FIRST = {1.0, 0.92, 0.88, 0.9, 0.97};
static const double predictors_adaptation_durations_FIRST_OF = 5.0;
static const double predictors_adaptation_durations_KEEP = 0.97;
static const double predictors_adaptation_durations_LEAST = 0.05;
static const int64_t predictors_adaptation_durations_MEDIAN = 13;
static const int64_t predictors_adaptation_durations_MOVEMENTS = 19;
static const int64_t predictors_adaptation_durations_NO_DURATION = 11;
static const int64_t predictors_adaptation_durations_OTHER_MEDIAN = 12;
static const T5d predictors_adaptation_durations_SHARES = {0.0, 0.25, 0.5, 0.75, 1.0};
static const int64_t predictors_adaptation_habits_AFTER_SO_MANY = 2;
static const double predictors_adaptation_habits_AGE = 60.0;
static const T4d predictors_adaptation_habits_FIRST_RULES = {1.0, 0.15, 0.15, 0.15};
static const double predictors_adaptation_habits_FIRST_RULES_OF = 8.0;
static const int64_t predictors_adaptation_habits_FROM_HERE = 3;
static const double predictors_adaptation_habits_KEEP = 0.95;
static const int64_t predictors_adaptation_habits_KNOWN = 0;
static const int64_t predictors_adaptation_habits_LAG = 9;
static const int64_t predictors_adaptation_habits_LAGS = 16;
static const double predictors_adaptation_habits_LAG_KEEP = 0.95;
static const int64_t predictors_adaptation_habits_LATELY = 1;
static const double predictors_adaptation_habits_LATE_AGE = 3.0;
static const double predictors_adaptation_habits_LATE_ELSE = 0.1;
static const int64_t predictors_adaptation_habits_LEARNED = 25;
static const double predictors_adaptation_habits_LEAST_LOG = -200.0;
static const int64_t predictors_adaptation_habits_NARROW = 6;
static const int64_t predictors_adaptation_habits_NEW = 1;
static const int64_t predictors_adaptation_habits_OFTEN = 0;
static const double predictors_adaptation_habits_OFTEN_OF = 0.7;
static const double predictors_adaptation_habits_RETURNS = 0.05;
static const double predictors_adaptation_habits_RETURNS_OF = 1.0;
static const int64_t predictors_adaptation_habits_RULE = 2;
static const int64_t predictors_adaptation_habits_RULES = 4;
static const T3d predictors_adaptation_habits_WIDTHS = {0.02, 0.05, 0.1};
static const double predictors_adaptation_habits_WIDTHS_OF = 3.0;
static const double predictors_adaptation_levels_FURTHEST = 6.0;
static const double predictors_adaptation_levels_STEP = 6.0;
static const double predictors_adaptation_levels_STEP_LEAST = 0.2;
static const double predictors_adaptation_levels_STEP_OF = 5.0;
static const int64_t predictors_adaptation_mixed_region_ASKED = 8;
static const int64_t predictors_adaptation_mixed_region_CLAIMED = 0;
static const int64_t predictors_adaptation_mixed_region_COUNT = 0;
static const int64_t predictors_adaptation_mixed_region_ELSEWHERE = 2;
static const double predictors_adaptation_mixed_region_LEAST = 0.02;
static const double predictors_adaptation_mixed_region_LEAST_SPREAD = 0.5;
static const int64_t predictors_adaptation_mixed_region_MOST_PLACES = 4;
static const int64_t predictors_adaptation_mixed_region_OFFSETS = 36;
static const int64_t predictors_adaptation_mixed_region_PARTS = 1;
static const int64_t predictors_adaptation_mixed_region_POINTS = 32;
static const int64_t predictors_adaptation_mixed_region_TIME = 1;
static const int64_t predictors_adaptation_moments_APART = 1;
static const double predictors_adaptation_moments_APART_S = 0.0071;
static const int64_t predictors_adaptation_moments_COUNT = 0;
static const int64_t predictors_adaptation_moments_CURSOR_X = 2;
static const int64_t predictors_adaptation_moments_CURSOR_Y = 3;
static const int64_t predictors_adaptation_moments_FIRST = 4;
static const int64_t predictors_adaptation_moments_T = 0;
static const int64_t predictors_adaptation_places_CAPACITY = 64;
static const int64_t predictors_adaptation_places_COUNT = 0;
static const int64_t predictors_adaptation_places_ENDED = 1;
static const int64_t predictors_adaptation_places_FINE = 0;
static const int64_t predictors_adaptation_places_HISTORY = 258;
static const double predictors_adaptation_places_KEEP = 0.97;
static const int64_t predictors_adaptation_places_KEY = 0;
static const double predictors_adaptation_places_LIGHTEST = 1e-09;
static const int64_t predictors_adaptation_places_MOST_ENDED = 131072;
static const int64_t predictors_adaptation_places_MOVEMENTS = 128;
static const double predictors_adaptation_places_NEAR_SHARE = 0.03;
static const double predictors_adaptation_places_NOWHERE = -1.0;
static const int64_t predictors_adaptation_places_NO_SUCH_PLACE = 42;
static const int64_t predictors_adaptation_places_PLACES = 2;
static const double predictors_adaptation_places_STEADIEST = 0.1;
static const int64_t predictors_adaptation_places_TOO_LIGHT = 41;
static const int64_t predictors_adaptation_places_WEIGHT = 3;
static const int64_t predictors_adaptation_places_WIDTH = 4;
static const int64_t predictors_adaptation_places_X = 1;
static const int64_t predictors_adaptation_places_Y = 2;
static const int64_t predictors_adaptation_predictor_ADAPT = 0;
static const int64_t predictors_adaptation_predictor_BEFORE = 3;
static const int64_t predictors_adaptation_predictor_DISTANCES = 1;
static const int64_t predictors_adaptation_predictor_KEY = 5;
static const int64_t predictors_adaptation_predictor_LENGTH = 3949;
static const int64_t predictors_adaptation_predictor_MOVEMENT = 912;
static const int64_t predictors_adaptation_predictor_NEXT = 8;
static const int64_t predictors_adaptation_predictor_NUMBER = 5;
static const int64_t predictors_adaptation_predictor_OBSERVATION = 639;
static const int64_t predictors_adaptation_predictor_ORIGIN_X = 6;
static const int64_t predictors_adaptation_predictor_ORIGIN_Y = 7;
static const int64_t predictors_adaptation_predictor_P = 2;
static const int64_t predictors_adaptation_predictor_PERSON = 11;
static const int64_t predictors_adaptation_predictor_PLACES = 3;
static const int64_t predictors_adaptation_predictor_SEQUENCE = 4;
static const int64_t predictors_adaptation_predictor_SHORTEST_PX = 2;
static const int64_t predictors_adaptation_predictor_SPREAD = 6;
static const int64_t predictors_adaptation_predictor_VISITS = 4;
static const int64_t predictors_adaptation_predictor_X = 0;
static const int64_t predictors_adaptation_predictor_Y = 1;
static const int64_t predictors_adaptation_region_widening_HALVINGS = 12;
static const double predictors_adaptation_region_widening_HEAVIEST = 4.0;
static const int64_t predictors_adaptation_region_widening_JUDGED = 9;
static const double predictors_adaptation_region_widening_LIGHTEST = 0.02;
static const int64_t predictors_adaptation_region_widening_MIXED = 11;
static const int64_t predictors_adaptation_region_widening_MIXTURE = 7;
static const int64_t predictors_adaptation_region_widening_MOMENT = 45;
static const int64_t predictors_adaptation_region_widening_MOST = 48;
static const int64_t predictors_adaptation_region_widening_MOVEMENTS = 0;
static const double predictors_adaptation_region_widening_MOVEMENTS_MOST = 1000000.0;
static const int64_t predictors_adaptation_region_widening_OFFSETS = 1;
static const int64_t predictors_adaptation_region_widening_SXX = 3;
static const int64_t predictors_adaptation_region_widening_SXY = 4;
static const int64_t predictors_adaptation_region_widening_SYY = 5;
static const int64_t predictors_adaptation_region_widening_TAIL = 6;
static const int64_t predictors_adaptation_region_widening_X = 1;
static const int64_t predictors_adaptation_region_widening_Y = 2;
static const int64_t predictors_adaptation_stages_AHEAD = 6;
static const int64_t predictors_adaptation_stages_BIAS_PAID = 7;
static const int64_t predictors_adaptation_stages_BIAS_SIZE = 8;
static const int64_t predictors_adaptation_stages_BROAD = 11;
static const int64_t predictors_adaptation_stages_COUNT = 9;
static const double predictors_adaptation_stages_DOUBT = 5.0;
static const double predictors_adaptation_stages_FURTHEST = 4.0;
static const int64_t predictors_adaptation_stages_G00 = 0;
static const int64_t predictors_adaptation_stages_G01 = 1;
static const int64_t predictors_adaptation_stages_G11 = 2;
static const double predictors_adaptation_stages_KEEP = 0.97;
static const int64_t predictors_adaptation_stages_MOMENT = 13;
static const double predictors_adaptation_stages_MOST_SHARE = 1000.0;
static const int64_t predictors_adaptation_stages_PARTS = 1;
static const int64_t predictors_adaptation_stages_PRESENT = 0;
static const int64_t predictors_adaptation_stages_R0 = 3;
static const int64_t predictors_adaptation_stages_R1 = 4;
static const double predictors_adaptation_stages_RIDGE = 20.0;
static const int64_t predictors_adaptation_stages_STAGES = 5;
static const int64_t predictors_adaptation_stages_T = 1;
static const int64_t predictors_adaptation_stages_TEMPO = 12;
static const double predictors_adaptation_stages_TEMPO_MOST = 0.4;
static const double predictors_adaptation_stages_TEMPO_OF = 10.0;
static const double predictors_adaptation_stages_TEMPO_OFF = 0.3;
static const int64_t predictors_adaptation_stages_TEMPO_PAID = 14;
static const int64_t predictors_adaptation_stages_TEMPO_SIZE = 15;
static const int64_t predictors_adaptation_stages_TIMED = 13;
static const int64_t predictors_adaptation_stages_TOTAL = 5;
static const int64_t predictors_adaptation_stages_WIDE = 10;
static const int64_t predictors_adaptation_stages_WIDTH = 16;
static const double predictors_adaptation_stages_WIDTHS_OF = 2.0;
static const int64_t predictors_adaptation_time_left_FINE = 0;
static const int64_t predictors_adaptation_time_left_FIRST_TERM = 3;
static const double predictors_adaptation_time_left_FURTHEST = 20.0;
static const int64_t predictors_adaptation_time_left_JUDGED = 12;
static const double predictors_adaptation_time_left_KEEP = 0.98;
static const int64_t predictors_adaptation_time_left_LEARNED = 35;
static const double predictors_adaptation_time_left_LEAST = 0.05;
static const double predictors_adaptation_time_left_LEAST_PIVOT = 0.01;
static const int64_t predictors_adaptation_time_left_LEFT = 1;
static const double predictors_adaptation_time_left_LONGEST = 4.0;
static const int64_t predictors_adaptation_time_left_MOMENT = 10;
static const int64_t predictors_adaptation_time_left_MOMENTS = 8;
static const int64_t predictors_adaptation_time_left_MOST = 32;
static const double predictors_adaptation_time_left_NEAR = 0.04;
static const int64_t predictors_adaptation_time_left_NOT_POSITIVE = 31;
static const int64_t predictors_adaptation_time_left_PRODUCTS = 0;
static const int64_t predictors_adaptation_time_left_READY = 0;
static const int64_t predictors_adaptation_time_left_RESIDUALS = 28;
static const double predictors_adaptation_time_left_SHORTEST_S = 1e-06;
static const double predictors_adaptation_time_left_SMALL = 0.05;
static const int64_t predictors_adaptation_time_left_SPREAD = 2;
static const double predictors_adaptation_time_left_START = 0.1;
static const int64_t predictors_adaptation_time_left_SUMS = 28;
static const int64_t predictors_adaptation_time_left_TERMS = 7;
static const int64_t predictors_adaptation_time_left_WEIGHTS = 1;
static const double predictors_adaptation_time_left_prior_PRIOR[] = {0.463, 0.05, 0.135, 0.352, -0.144, -0.102, 0.026, 5.386, 4.699, 7.62, 7.876, 8.315, 18.215, 3.974, 3.859, 5.877, 4.439, 3.135, 4.623, 4.769, 3.006, 4.42, 0.488, 0.501, 1.748, 0.157, 0.026, 0.716, 0.764, 0.903, 3.059, 0.155, 0.112, 0.72, 1.826};
static const int64_t predictors_kinematic_features_TRACK = 9;
static const int64_t predictors_kinematic_track_FAST_T = 26;
static const int64_t predictors_kinematic_track_PEAK = 6;
static const T2d predictors_mixture_LEVELS = {0.5, 0.8};
static const int64_t predictors_mixture_SHARE = 0;
static const int64_t predictors_mixture_SXX = 3;
static const int64_t predictors_mixture_SXY = 4;
static const int64_t predictors_mixture_SYY = 5;
static const int64_t predictors_mixture_TAIL = 6;
static const int64_t predictors_mixture_WIDTH = 7;
static const int64_t predictors_mixture_X = 1;
static const int64_t predictors_mixture_Y = 2;
static const int64_t records_EVENT_FIELD = 2;
static const double records_ROUNDING_S = 1e-06;

/* Of so many stages the one before a share of the time, and how far the share is from it to the next. */
Tqd predictors_adaptation_stages_interpolation_among(double share, int64_t count) {
  double spot;
  int64_t stage;
  spot = min_float(max_float(share * count - 0.5, 0.0), count - 1.0);
  stage = min_whole((int64_t)floor(spot), count - 2);
  return (Tqd){stage, spot - stage};
}

/* Standard deviation of the logarithm of the time left at a share of the time: lines between stages. */
double predictors_adaptation_arrival_intervals_spread(Vector memory, int64_t at, double share) {
  int64_t stage;
  double part, low;
  Tqd values_1 = predictors_adaptation_stages_interpolation_among(share, predictors_adaptation_arrival_intervals_STAGES);
  stage = values_1.f0;
  part = values_1.f1;
  low = memory.p[at + predictors_adaptation_arrival_intervals_OFFSETS + stage];
  return predictors_adaptation_arrival_intervals_SPREAD * exp(low + part * (memory.p[at + predictors_adaptation_arrival_intervals_OFFSETS + stage + 1] - low));
}

/* Count a finished movement; returns its step. */
double predictors_adaptation_arrival_intervals_next_step(Vector memory, int64_t at) {
  memory.p[at + predictors_adaptation_arrival_intervals_MOVEMENTS] = min_float(memory.p[at + predictors_adaptation_arrival_intervals_MOVEMENTS] + 1.0, predictors_adaptation_arrival_intervals_MOVEMENTS_MOST);
  return max_float(predictors_adaptation_arrival_intervals_STEP / (memory.p[at + predictors_adaptation_arrival_intervals_MOVEMENTS] + predictors_adaptation_arrival_intervals_STEP_OF), predictors_adaptation_arrival_intervals_STEP_LEAST);
}

/* Change the spread by one moment: ``claim``, the time left in s and its spread; ``left`` what was left. */
void predictors_adaptation_arrival_intervals_judge(Vector memory, int64_t at, double share, double step, T2d claim, double left) {
  double off, missed, part, change;
  bool inside;
  int64_t stage, slot;
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
    slot = at + predictors_adaptation_arrival_intervals_OFFSETS + stage + side;
    change = step * missed * (side == 1 ? part : 1.0 - part);
    memory.p[slot] = min_float(max_float(memory.p[slot] + change, -predictors_adaptation_arrival_intervals_FURTHEST), predictors_adaptation_arrival_intervals_FURTHEST);
  }
}

/* What is wrong with numbers that are within the bounds of their slots, and the number that is wrong. */
Tqd predictors_adaptation_distances_fault(Vector learned) {
  int64_t count;
  double total;
  count = (int64_t)learned.p[predictors_adaptation_distances_COUNT];
  if (count == 0) {
    return (Tqd){predictors_adaptation_distances_FINE, 0.0};
  }
  for (int64_t i = 0; i < count; i++) {
    if (!(learned.p[predictors_adaptation_distances_DISTANCES + i] >= predictors_adaptation_distances_SHORTEST_PX)) {
      return (Tqd){predictors_adaptation_distances_TOO_SHORT, learned.p[predictors_adaptation_distances_DISTANCES + i]};
    }
  }
  if (!(learned.p[predictors_adaptation_distances_BELIEF + predictors_adaptation_distances_LAWS] >= predictors_adaptation_distances_LEAST_UNKNOWN)) {
    return (Tqd){predictors_adaptation_distances_TOO_SURE, learned.p[predictors_adaptation_distances_BELIEF + predictors_adaptation_distances_LAWS]};
  }
  total = 0.0;
  for (int64_t i = predictors_adaptation_distances_BELIEF; i < predictors_adaptation_distances_WEIGHTS; i++) {
    total += learned.p[i];
  }
  if (!(fabs(total - 1.0) <= predictors_adaptation_distances_OFF_ONE)) {
    return (Tqd){predictors_adaptation_distances_NO_SHARES, total};
  }
  return (Tqd){predictors_adaptation_distances_FINE, 0.0};
}

/* The value that would stand at a place if the values were sorted. */
double predictors_adaptation_durations_value_of_rank(Vector values, int64_t at, int64_t count, int64_t rank) {
  int64_t before;
  for (int64_t i = at, end_1 = at + count; i < end_1; i++) {
    before = 0;
    for (int64_t j = at, end_2 = at + count; j < end_2; j++) {
      if (values.p[j] < values.p[i] || (values.p[j] == values.p[i] && j < i)) {
        before += 1;
      }
    }
    if (before == rank) {
      return values.p[i];
    }
  }
  return NAN;
}

/* The median of some values, bit for bit that of ``np.median``, which takes a second to compile. */
double predictors_adaptation_durations_median(Vector values, int64_t at, int64_t count) {
  double upper;
  upper = predictors_adaptation_durations_value_of_rank(values, at, count, floor_divided_whole(count, 2));
  return remainder_whole(count, 2) ? upper : (predictors_adaptation_durations_value_of_rank(values, at, count, floor_divided_whole(count, 2) - 1) + upper) / 2.0;
}

/* What is wrong with numbers that are within the bounds of their slots, and the number that is wrong. */
Tqd predictors_adaptation_durations_fault(Vector learned) {
  int64_t count;
  count = (int64_t)learned.p[predictors_adaptation_durations_COUNT];
  for (int64_t i = 0; i < count; i++) {
    if (!(learned.p[predictors_adaptation_durations_DURATIONS + i] > 0.0)) {
      return (Tqd){predictors_adaptation_durations_NO_DURATION, learned.p[predictors_adaptation_durations_DURATIONS + i]};
    }
  }
  if (count > 0 && learned.p[predictors_adaptation_durations_MEDIAN] != predictors_adaptation_durations_median(learned, predictors_adaptation_durations_DURATIONS, count)) {
    return (Tqd){predictors_adaptation_durations_OTHER_MEDIAN, learned.p[predictors_adaptation_durations_MEDIAN]};
  }
  return (Tqd){predictors_adaptation_durations_FINE, 0.0};
}

/* Factor the sums and the prior's into L D L' in place of their lower triangle; returns the least of D. */
double predictors_adaptation_time_left_factor(Vector memory, int64_t person, Vector prior, Vector out) {
  double least, scaled;
  int64_t row, column;
  least = INFINITY;
  for (int64_t i = 0; i < predictors_adaptation_time_left_SUMS; i++) {
    out.p[i] = memory.p[person + predictors_adaptation_time_left_PRODUCTS + i] + prior.p[predictors_adaptation_time_left_TERMS + i];
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

/* What is wrong with numbers that are within the bounds of their slots, and the number that is wrong. */
Tqd predictors_adaptation_time_left_fault(Vector learned) {
  double least;
  double buffer_1[28];
  least = predictors_adaptation_time_left_factor(learned, 0, (Vector){(double *)predictors_adaptation_time_left_prior_PRIOR, 35}, (Vector){buffer_1, predictors_adaptation_time_left_SUMS});
  return least >= predictors_adaptation_time_left_LEAST_PIVOT ? (Tqd){predictors_adaptation_time_left_FINE, 0.0} : (Tqd){predictors_adaptation_time_left_NOT_POSITIVE, least};
}

/* What is wrong with numbers that are within the bounds of their slots, and the number that is wrong. */
Tqd predictors_adaptation_places_fault(Vector learned) {
  int64_t count;
  count = (int64_t)learned.p[predictors_adaptation_places_COUNT];
  for (int64_t i = 0; i < count; i++) {
    if (!(learned.p[predictors_adaptation_places_PLACES + predictors_adaptation_places_WIDTH * i + predictors_adaptation_places_WEIGHT] >= predictors_adaptation_places_LIGHTEST)) {
      return (Tqd){predictors_adaptation_places_TOO_LIGHT, learned.p[predictors_adaptation_places_PLACES + predictors_adaptation_places_WIDTH * i + predictors_adaptation_places_WEIGHT]};
    }
  }
  for (int64_t age = 0, end_1 = (int64_t)min_float(learned.p[predictors_adaptation_places_ENDED], predictors_adaptation_places_MOVEMENTS); age < end_1; age++) {
    if (learned.p[predictors_adaptation_places_HISTORY + age] >= count) {
      return (Tqd){predictors_adaptation_places_NO_SUCH_PLACE, learned.p[predictors_adaptation_places_HISTORY + age]};
    }
  }
  return (Tqd){predictors_adaptation_places_FINE, 0.0};
}

/* What is wrong with numbers that are within the bounds of ``SLOTS``, and the number that is wrong. */
Tqd predictors_adaptation_correction_fault(Vector learned) {
  double held, value;
  int64_t wrong;
  held = learned.p[predictors_adaptation_correction_DISTANCES + predictors_adaptation_distances_COUNT];
  if (held != learned.p[predictors_adaptation_correction_DURATIONS + predictors_adaptation_durations_COUNT]) {
    return (Tqd){predictors_adaptation_correction_UNEQUAL, held};
  }
  Tqd values_1 = predictors_adaptation_distances_fault((Vector){learned.p + predictors_adaptation_correction_DISTANCES, predictors_adaptation_correction_DURATIONS - predictors_adaptation_correction_DISTANCES});
  wrong = values_1.f0;
  value = values_1.f1;
  if (wrong != predictors_adaptation_distances_FINE) {
    return (Tqd){wrong, value};
  }
  Tqd values_2 = predictors_adaptation_durations_fault((Vector){learned.p + predictors_adaptation_correction_DURATIONS, predictors_adaptation_correction_REGIONS - predictors_adaptation_correction_DURATIONS});
  wrong = values_2.f0;
  value = values_2.f1;
  if (wrong != predictors_adaptation_durations_FINE) {
    return (Tqd){wrong, value};
  }
  Tqd values_3 = predictors_adaptation_time_left_fault((Vector){learned.p + predictors_adaptation_correction_TIME_LEFT, predictors_adaptation_correction_INTERVALS - predictors_adaptation_correction_TIME_LEFT});
  wrong = values_3.f0;
  value = values_3.f1;
  if (wrong != predictors_adaptation_time_left_FINE) {
    return (Tqd){wrong, value};
  }
  return predictors_adaptation_places_fault((Vector){learned.p + predictors_adaptation_correction_KNOWN, predictors_adaptation_correction_HABITS - predictors_adaptation_correction_KNOWN});
}

/* When the cursor came near its end for good; the oldest time remembered where that is longer ago. */
double predictors_adaptation_correction_arrival(Vector memory, int64_t at, double near) {
  int64_t places, place;
  double when;
  places = (int64_t)memory.p[at + predictors_adaptation_correction_PLACES];
  when = memory.p[at + predictors_adaptation_correction_T];
  for (int64_t back = 0, end_1 = min_whole(places, predictors_adaptation_correction_TRACE_PLACES); back < end_1; back++) {
    place = at + predictors_adaptation_correction_TRACE + 3 * remainder_whole(places - 1 - back, predictors_adaptation_correction_TRACE_PLACES);
    if (hypot(memory.p[place + 1] - memory.p[at + predictors_adaptation_correction_X], memory.p[place + 2] - memory.p[at + predictors_adaptation_correction_Y]) > near) {
      return when;
    }
    when = memory.p[place];
  }
  return when;
}

/* How likely the last distances had made a distance, over what it is where nothing is known. */
double predictors_adaptation_distances_likelihood(Vector memory, int64_t at, double distance) {
  int64_t count;
  double likely, off, near;
  count = (int64_t)memory.p[at + predictors_adaptation_distances_COUNT];
  if (count < predictors_adaptation_distances_LEAST) {
    return 1.0;
  }
  likely = memory.p[at + predictors_adaptation_distances_BELIEF + predictors_adaptation_distances_LAWS];
  for (int64_t j = 0; j < count; j++) {
    for (int64_t w = 0; w < 3; w++) {
      off = log(distance / memory.p[at + predictors_adaptation_distances_DISTANCES + j]) / ((const double *)&predictors_adaptation_distances_WIDTHS)[w];
      near = exp(-0.5 * min_float(off * off, 1000.0)) / (((const double *)&predictors_adaptation_distances_WIDTHS)[w] * sqrt(2.0 * 3.141592653589793));
      likely += memory.p[at + predictors_adaptation_distances_WEIGHTS + j * 3 + w] * predictors_adaptation_distances_UNKNOWN_LOGS * near;
    }
  }
  return likely;
}

/* The share of each place of a key by its visits; returns the sum of the visits. */
double predictors_adaptation_habits_count_often(Vector memory, int64_t at, double key, Table out) {
  int64_t count, place;
  double total;
  count = (int64_t)memory.p[at + predictors_adaptation_places_COUNT];
  total = 0.0;
  for (int64_t i = 0; i < count; i++) {
    place = at + predictors_adaptation_places_PLACES + predictors_adaptation_places_WIDTH * i;
    if (memory.p[place + predictors_adaptation_places_KEY] == key) {
      out.p[predictors_adaptation_habits_OFTEN * out.m + i] = memory.p[place + predictors_adaptation_places_WEIGHT];
      total += out.p[predictors_adaptation_habits_OFTEN * out.m + i];
    }
  }
  for (int64_t i = 0; i < count; i++) {
    out.p[predictors_adaptation_habits_OFTEN * out.m + i] = total > 0.0 ? out.p[predictors_adaptation_habits_OFTEN * out.m + i] / total : 0.0;
  }
  return total;
}

/* Where a movement ended, ``age`` movements before the last one: the place, -1 where it is unknown. */
int64_t predictors_adaptation_places_visited(Vector memory, int64_t at, int64_t age) {
  int64_t ended;
  ended = (int64_t)memory.p[at + predictors_adaptation_places_ENDED];
  if (age >= min_whole(ended, predictors_adaptation_places_MOVEMENTS)) {
    return -1;
  }
  return (int64_t)memory.p[at + predictors_adaptation_places_HISTORY + remainder_whole(ended - 1 - age, predictors_adaptation_places_MOVEMENTS)];
}

/* Recent visits, and returns after as many movements as each place was visited ago. */
void predictors_adaptation_habits_count_last(Vector memory, int64_t at, int64_t habits, Table out) {
  int64_t number;
  for (int64_t age = 0; age < predictors_adaptation_places_MOVEMENTS; age++) {
    number = predictors_adaptation_places_visited(memory, at, age);
    if (number >= 0 && out.p[predictors_adaptation_habits_OFTEN * out.m + number] > 0.0) {
      out.p[predictors_adaptation_habits_LATELY * out.m + number] += exp(-age / predictors_adaptation_habits_LATE_AGE);
    }
  }
  for (int64_t age = predictors_adaptation_habits_LAGS - 1; age > (-1); age--) {
    number = predictors_adaptation_places_visited(memory, at, age);
    if (number >= 0 && out.p[predictors_adaptation_habits_OFTEN * out.m + number] > 0.0) {
      out.p[predictors_adaptation_habits_AFTER_SO_MANY * out.m + number] = memory.p[habits + predictors_adaptation_habits_LAG + age];
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
int64_t predictors_adaptation_places_nearest(Vector memory, int64_t at, double key, T2d point, double near) {
  double x, y, closest, away;
  int64_t best, place;
  x = point.f0;
  y = point.f1;
  best = -1;
  closest = near;
  for (int64_t i = 0, end_1 = (int64_t)memory.p[at + predictors_adaptation_places_COUNT]; i < end_1; i++) {
    place = at + predictors_adaptation_places_PLACES + predictors_adaptation_places_WIDTH * i;
    away = hypot(memory.p[place + predictors_adaptation_places_X] - x, memory.p[place + predictors_adaptation_places_Y] - y);
    if (memory.p[place + predictors_adaptation_places_KEY] == key && away <= closest) {
      best = i;
      closest = away;
    }
  }
  return best;
}

/* Where the person went from this place. */
void predictors_adaptation_habits_count_following(Vector memory, int64_t at, int64_t here, Table out) {
  int64_t after, before;
  for (int64_t age = 0; age < (predictors_adaptation_places_MOVEMENTS - 1); age++) {
    after = predictors_adaptation_places_visited(memory, at, age);
    before = predictors_adaptation_places_visited(memory, at, age + 1);
    if (before == here && after >= 0 && out.p[predictors_adaptation_habits_OFTEN * out.m + after] > 0.0) {
      out.p[predictors_adaptation_habits_FROM_HERE * out.m + after] += exp(-age / predictors_adaptation_habits_AGE);
    }
  }
}

/* The share of each place by each rule, a row each; whether there is any. */
bool predictors_adaptation_habits_shares(Vector memory, int64_t at, int64_t habits, double key, T3d start, Table out) {
  int64_t count, here;
  double x, y, near;
  if (predictors_adaptation_habits_count_often(memory, at, key, out) == 0.0) {
    return false;
  }
  count = (int64_t)memory.p[at + predictors_adaptation_places_COUNT];
  predictors_adaptation_habits_count_last(memory, at, habits, out);
  predictors_adaptation_habits_blend(out, predictors_adaptation_habits_LATELY, predictors_adaptation_habits_OFTEN, count, predictors_adaptation_habits_LATE_ELSE);
  predictors_adaptation_habits_blend(out, predictors_adaptation_habits_AFTER_SO_MANY, predictors_adaptation_habits_OFTEN, count, predictors_adaptation_habits_OFTEN_OF);
  x = start.f0;
  y = start.f1;
  near = start.f2;
  here = predictors_adaptation_places_nearest(memory, at, key, (T2d){x, y}, near);
  if (here >= 0) {
    predictors_adaptation_habits_count_following(memory, at, here, out);
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
double predictors_adaptation_habits_returns(Vector memory, int64_t habits) {
  double known, new;
  known = memory.p[habits + predictors_adaptation_habits_KNOWN];
  new = memory.p[habits + predictors_adaptation_habits_NEW];
  return (known + predictors_adaptation_habits_RETURNS * predictors_adaptation_habits_RETURNS_OF) / (known + new + predictors_adaptation_habits_RETURNS_OF);
}

/* The weight of a rule among all; without the sequence only of OFTEN and LATELY. */
double predictors_adaptation_habits_rule_weight(Vector memory, int64_t habits, int64_t rule, double with_sequence) {
  int64_t most;
  double total, first;
  most = with_sequence == 1.0 ? predictors_adaptation_habits_RULES : predictors_adaptation_habits_AFTER_SO_MANY;
  if (rule >= most) {
    return 0.0;
  }
  total = 0.0;
  first = predictors_adaptation_habits_FIRST_RULES_OF / (predictors_adaptation_habits_FIRST_RULES.f0 + predictors_adaptation_habits_FIRST_RULES.f1 + predictors_adaptation_habits_FIRST_RULES.f2 + predictors_adaptation_habits_FIRST_RULES.f3);
  for (int64_t k = 0; k < most; k++) {
    total += memory.p[habits + predictors_adaptation_habits_RULE + k] + first * ((const double *)&predictors_adaptation_habits_FIRST_RULES)[k];
  }
  return (memory.p[habits + predictors_adaptation_habits_RULE + rule] + first * ((const double *)&predictors_adaptation_habits_FIRST_RULES)[rule]) / total;
}

/* The weight of a width among all. */
double predictors_adaptation_habits_width_weight(Vector memory, int64_t habits, int64_t width) {
  double total;
  total = predictors_adaptation_habits_WIDTHS_OF;
  for (int64_t k = 0; k < 3; k++) {
    total += memory.p[habits + predictors_adaptation_habits_NARROW + k];
  }
  return (memory.p[habits + predictors_adaptation_habits_NARROW + width] + predictors_adaptation_habits_WIDTHS_OF / 3) / total;
}

/* Share one visit among rules, widths and "a new place" by how likely each had made the end. */
void predictors_adaptation_habits_share_visit(Vector memory, int64_t habits, Table likely, double with_sequence, double elsewhere) {
  double known, new, total, prior;
  known = predictors_adaptation_habits_returns(memory, habits);
  new = (1.0 - known) * elsewhere;
  total = new;
  for (int64_t rule = 0; rule < predictors_adaptation_habits_RULES; rule++) {
    for (int64_t width = 0; width < 3; width++) {
      prior = known * predictors_adaptation_habits_rule_weight(memory, habits, rule, with_sequence) * predictors_adaptation_habits_width_weight(memory, habits, width);
      likely.p[rule * likely.m + width] *= prior;
      total += likely.p[rule * likely.m + width];
    }
  }
  for (int64_t i = 0; i < (predictors_adaptation_habits_LEARNED - predictors_adaptation_habits_LAGS); i++) {
    memory.p[habits + i] *= predictors_adaptation_habits_KEEP;
  }
  memory.p[habits + predictors_adaptation_habits_NEW] += new / total;
  memory.p[habits + predictors_adaptation_habits_KNOWN] += 1.0 - new / total;
  for (int64_t rule = 0; rule < predictors_adaptation_habits_RULES; rule++) {
    for (int64_t width = 0; width < 3; width++) {
      memory.p[habits + predictors_adaptation_habits_RULE + rule] += likely.p[rule * likely.m + width] / total;
      memory.p[habits + predictors_adaptation_habits_NARROW + width] += likely.p[rule * likely.m + width] / total;
    }
  }
}

/* Learn from a movement, before its end is taken in as a visit. */
void predictors_adaptation_habits_learn(Vector memory, int64_t at, int64_t habits, T3d scene, T4d movement, double elsewhere) {
  double key, with_sequence, near, x0, y0, x, y, px, py, distance2, far2, ratio;
  Table out, likely;
  int64_t place, number;
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
  if (!predictors_adaptation_habits_shares(memory, at, habits, key, (T3d){x0, y0, near}, out)) {
    return;
  }
  memset(buffer_2, 0, sizeof buffer_2);
  likely = (Table){buffer_2, predictors_adaptation_habits_RULES, 3};
  for (int64_t i = 0, end_3 = (int64_t)memory.p[at + predictors_adaptation_places_COUNT]; i < end_3; i++) {
    place = at + predictors_adaptation_places_PLACES + predictors_adaptation_places_WIDTH * i;
    px = memory.p[place + predictors_adaptation_places_X];
    py = memory.p[place + predictors_adaptation_places_Y];
    distance2 = square(px - x0) + square(py - y0);
    far2 = square(px - x) + square(py - y);
    for (int64_t width = 0; width < 3; width++) {
      ratio = predictors_adaptation_habits_density_ratio(far2, distance2, ((const double *)&predictors_adaptation_habits_WIDTHS)[width]);
      for (int64_t rule = 0; rule < predictors_adaptation_habits_RULES; rule++) {
        likely.p[rule * likely.m + width] += out.p[rule * out.m + i] * ratio;
      }
    }
  }
  predictors_adaptation_habits_share_visit(memory, habits, likely, with_sequence, elsewhere);
  number = predictors_adaptation_places_nearest(memory, at, key, (T2d){x, y}, predictors_adaptation_places_NEAR_SHARE * hypot(x - x0, y - y0));
  for (int64_t age = 0; age < predictors_adaptation_habits_LAGS; age++) {
    if (number >= 0 && predictors_adaptation_places_visited(memory, at, age) == number) {
      for (int64_t k = 0; k < predictors_adaptation_habits_LAGS; k++) {
        memory.p[habits + predictors_adaptation_habits_LAG + k] *= predictors_adaptation_habits_LAG_KEEP;
      }
      memory.p[habits + predictors_adaptation_habits_LAG + age] += 1.0;
      return;
    }
  }
}

/* A free place; where there is none the one with the fewest visits is forgotten, in the history too. */
int64_t predictors_adaptation_places_new_place(Vector memory, int64_t at) {
  int64_t count, free_;
  count = (int64_t)memory.p[at + predictors_adaptation_places_COUNT];
  if (count < predictors_adaptation_places_CAPACITY) {
    memory.p[at + predictors_adaptation_places_COUNT] = count + 1.0;
    return count;
  }
  free_ = 0;
  for (int64_t i = 0; i < predictors_adaptation_places_CAPACITY; i++) {
    if (memory.p[at + predictors_adaptation_places_PLACES + predictors_adaptation_places_WIDTH * i + predictors_adaptation_places_WEIGHT] < memory.p[at + predictors_adaptation_places_PLACES + predictors_adaptation_places_WIDTH * free_ + predictors_adaptation_places_WEIGHT]) {
      free_ = i;
    }
  }
  for (int64_t age = 0; age < predictors_adaptation_places_MOVEMENTS; age++) {
    if (memory.p[at + predictors_adaptation_places_HISTORY + age] == free_) {
      memory.p[at + predictors_adaptation_places_HISTORY + age] = predictors_adaptation_places_NOWHERE;
    }
  }
  return free_;
}

/* Take in the end of a movement: a visit of the nearest place within ``near`` px, or a new place. */
void predictors_adaptation_places_visit(Vector memory, int64_t at, double key, T2d end, double near) {
  double x, y, share;
  int64_t place, number;
  x = end.f0;
  y = end.f1;
  for (int64_t i = 0, end_1 = (int64_t)memory.p[at + predictors_adaptation_places_COUNT]; i < end_1; i++) {
    place = at + predictors_adaptation_places_PLACES + predictors_adaptation_places_WIDTH * i;
    memory.p[place + predictors_adaptation_places_WEIGHT] = max_float(predictors_adaptation_places_KEEP * memory.p[place + predictors_adaptation_places_WEIGHT], predictors_adaptation_places_LIGHTEST);
  }
  number = predictors_adaptation_places_nearest(memory, at, key, end, near);
  if (number < 0) {
    number = predictors_adaptation_places_new_place(memory, at);
    place = at + predictors_adaptation_places_PLACES + predictors_adaptation_places_WIDTH * number;
    memory.p[place + predictors_adaptation_places_KEY] = key;
    memory.p[place + predictors_adaptation_places_WEIGHT] = 0.0;
    memory.p[place + predictors_adaptation_places_X] = x;
    memory.p[place + predictors_adaptation_places_Y] = y;
  }
  place = at + predictors_adaptation_places_PLACES + predictors_adaptation_places_WIDTH * number;
  memory.p[place + predictors_adaptation_places_WEIGHT] += 1.0;
  share = max_float(1.0 / memory.p[place + predictors_adaptation_places_WEIGHT], predictors_adaptation_places_STEADIEST);
  memory.p[place + predictors_adaptation_places_X] += share * (x - memory.p[place + predictors_adaptation_places_X]);
  memory.p[place + predictors_adaptation_places_Y] += share * (y - memory.p[place + predictors_adaptation_places_Y]);
  memory.p[at + predictors_adaptation_places_HISTORY + remainder_whole((int64_t)memory.p[at + predictors_adaptation_places_ENDED], predictors_adaptation_places_MOVEMENTS)] = number;
  memory.p[at + predictors_adaptation_places_ENDED] += 1.0;
  if (memory.p[at + predictors_adaptation_places_ENDED] == predictors_adaptation_places_MOST_ENDED) {
    memory.p[at + predictors_adaptation_places_ENDED] -= predictors_adaptation_places_MOVEMENTS;
  }
}

/* Learn which place the movement went to; before its distance is taken in. */
void predictors_adaptation_correction_learn_place(Vector memory, int64_t person, int64_t at, correction_Parts parts, scene_Scene scene) {
  double x0, y0, x, y, distance, usual, near;
  int64_t where, habit;
  x0 = memory.p[at + predictors_adaptation_correction_X0] - scene.x;
  y0 = memory.p[at + predictors_adaptation_correction_Y0] - scene.y;
  x = memory.p[at + predictors_adaptation_correction_X] - scene.x;
  y = memory.p[at + predictors_adaptation_correction_Y] - scene.y;
  distance = hypot(x - x0, y - y0);
  usual = 1.0;
  if (parts.distances == 1.0) {
    usual = predictors_adaptation_distances_likelihood(memory, person + predictors_adaptation_correction_DISTANCES, distance);
  }
  where = person + predictors_adaptation_correction_KNOWN;
  habit = person + predictors_adaptation_correction_HABITS;
  near = predictors_adaptation_places_NEAR_SHARE * distance;
  predictors_adaptation_habits_learn(memory, where, habit, (T3d){scene.key, parts.sequence, near}, (T4d){x0, y0, x, y}, usual);
  predictors_adaptation_places_visit(memory, where, scene.key, (T2d){x, y}, near);
}

/* Discount the errors of earlier movements. */
void predictors_adaptation_durations_forget(Vector memory, int64_t at) {
  for (int64_t k = 0; k < 5; k++) {
    memory.p[at + predictors_adaptation_durations_ERRORS + k] *= predictors_adaptation_durations_KEEP;
  }
  memory.p[at + predictors_adaptation_durations_MOVEMENTS] = predictors_adaptation_durations_KEEP * memory.p[at + predictors_adaptation_durations_MOVEMENTS] + 1.0;
}

/* The moment of a stage. */
stages_Moment predictors_adaptation_stages_moment_at(Vector memory, int64_t place) {
  Vector p;
  p = (Vector){memory.p + (place + predictors_adaptation_stages_PARTS), place + predictors_adaptation_stages_MOMENT - (place + predictors_adaptation_stages_PARTS)};
  return (stages_Moment){p.p[0], p.p[1], p.p[2], p.p[3], p.p[4], p.p[5], p.p[6], p.p[7], p.p[8], p.p[9], p.p[10], p.p[11]};
}

/* Logarithm of what a stage multiplies the time left by. */
double predictors_adaptation_stages_tempo(Vector memory, int64_t at) {
  return memory.p[at + predictors_adaptation_stages_TEMPO] / (memory.p[at + predictors_adaptation_stages_TIMED] + predictors_adaptation_stages_TEMPO_OF);
}

/* Share of a correction that has paid so far: 0 to 1. */
double predictors_adaptation_stages_belief(Vector memory, int64_t at, int64_t paid) {
  return min_float(max_float(memory.p[at + paid] / (memory.p[at + paid + 1] + predictors_adaptation_stages_DOUBT), 0.0), 1.0);
}

/* What a stage multiplies the time left by. */
double predictors_adaptation_stages_tempo_factor(Vector memory, int64_t at) {
  return exp(predictors_adaptation_stages_tempo(memory, at) * predictors_adaptation_stages_belief(memory, at, predictors_adaptation_stages_TEMPO_PAID));
}

/* The time left in s, of which the clock says a share; ``left``: what the predictor says. */
double predictors_adaptation_durations_mixture(Vector memory, int64_t at, double share, double since, double left) {
  double by_clock;
  by_clock = max_float(memory.p[at + predictors_adaptation_durations_MEDIAN] - since, 0.0);
  return max_float((1.0 - share) * left + share * by_clock, predictors_adaptation_durations_LEAST * left);
}

/* Add the errors of the mixtures at one moment of a finished movement. */
void predictors_adaptation_durations_judge(Vector memory, int64_t at, double since, double predicted, double left, double duration) {
  double off;
  for (int64_t k = 0; k < 5; k++) {
    off = predictors_adaptation_durations_mixture(memory, at, ((const double *)&predictors_adaptation_durations_SHARES)[k], since, predicted) - left;
    memory.p[at + predictors_adaptation_durations_ERRORS + k] += fabs(off) / duration;
  }
}

/* What a stage adds to the way ahead, px. */
double predictors_adaptation_stages_bias(Vector memory, int64_t at, double total, double along) {
  return memory.p[at + predictors_adaptation_stages_TOTAL] * total + memory.p[at + predictors_adaptation_stages_AHEAD] * along;
}

/* The value, no further from zero than ``most``. */
double predictors_adaptation_stages_bounded(double value, double most) {
  return min_float(max_float(value, -most), most);
}

/* The coefficients of the bias from the normal equations. */
void predictors_adaptation_stages_solve(Vector memory, int64_t at) {
  double g00, g01, g11, determinant, by_total, by_ahead;
  g00 = memory.p[at + predictors_adaptation_stages_G00] + predictors_adaptation_stages_RIDGE;
  g01 = memory.p[at + predictors_adaptation_stages_G01];
  g11 = memory.p[at + predictors_adaptation_stages_G11] + predictors_adaptation_stages_RIDGE;
  determinant = max_float(g00 * g11 - g01 * g01, predictors_adaptation_stages_RIDGE * predictors_adaptation_stages_RIDGE);
  by_total = (g11 * memory.p[at + predictors_adaptation_stages_R0] - g01 * memory.p[at + predictors_adaptation_stages_R1]) / determinant;
  by_ahead = (g00 * memory.p[at + predictors_adaptation_stages_R1] - g01 * memory.p[at + predictors_adaptation_stages_R0]) / determinant;
  memory.p[at + predictors_adaptation_stages_TOTAL] = predictors_adaptation_stages_bounded(by_total, predictors_adaptation_stages_MOST_SHARE);
  memory.p[at + predictors_adaptation_stages_AHEAD] = predictors_adaptation_stages_bounded(by_ahead, predictors_adaptation_stages_MOST_SHARE);
}

/* One step towards the scale of a Student law: what is far off counts little. */
void predictors_adaptation_stages_scale(Vector memory, int64_t at, int64_t which, double off, double tail) {
  double before;
  before = (memory.p[at + which] + predictors_adaptation_stages_WIDTHS_OF) / (memory.p[at + predictors_adaptation_stages_COUNT] + predictors_adaptation_stages_WIDTHS_OF);
  memory.p[at + which] += (tail + 1.0) / (tail + off * off / before) * off * off;
}

/* Learn from one stage of a finished movement: where it ended, and when the cursor came to rest. */
void predictors_adaptation_stages_learn(Vector memory, int64_t at, stages_Moment m, double x, double y, double t) {
  double dx, dy, off, aside, total, shift, rest, paid, weight, f0, f1, left, late, slow;
  for (int64_t i = 0; i < predictors_adaptation_stages_WIDTH; i++) {
    if (i != predictors_adaptation_stages_TOTAL && i != predictors_adaptation_stages_AHEAD) {
      memory.p[at + i] *= predictors_adaptation_stages_KEEP;
    }
  }
  dx = x - m.x;
  dy = y - m.y;
  off = (dx * m.ux + dy * m.uy - m.along) / m.wide;
  aside = (dy * m.ux - dx * m.uy - m.across) / m.broad;
  total = sqrt(square(m.reached + m.along) + square(m.across));
  shift = predictors_adaptation_stages_bias(memory, at, total, m.along) / m.wide;
  rest = off - shift;
  paid = predictors_adaptation_stages_bounded(shift, predictors_adaptation_stages_FURTHEST);
  memory.p[at + predictors_adaptation_stages_BIAS_PAID] += paid * predictors_adaptation_stages_bounded(off, predictors_adaptation_stages_FURTHEST);
  memory.p[at + predictors_adaptation_stages_BIAS_SIZE] += paid * paid;
  weight = (m.tail + 1.0) / (m.tail + rest * rest);
  f0 = total / m.wide;
  f1 = m.along / m.wide;
  memory.p[at + predictors_adaptation_stages_G00] += weight * f0 * f0;
  memory.p[at + predictors_adaptation_stages_G01] += weight * f0 * f1;
  memory.p[at + predictors_adaptation_stages_G11] += weight * f1 * f1;
  memory.p[at + predictors_adaptation_stages_R0] += weight * f0 * off;
  memory.p[at + predictors_adaptation_stages_R1] += weight * f1 * off;
  predictors_adaptation_stages_solve(memory, at);
  predictors_adaptation_stages_scale(memory, at, predictors_adaptation_stages_WIDE, rest, m.tail);
  predictors_adaptation_stages_scale(memory, at, predictors_adaptation_stages_BROAD, aside, m.tail);
  left = t - m.t;
  if (left > 0.0) {
    late = predictors_adaptation_stages_bounded(log(left / m.left), predictors_adaptation_stages_TEMPO_MOST);
    slow = predictors_adaptation_stages_tempo(memory, at);
    memory.p[at + predictors_adaptation_stages_TEMPO_PAID] += slow * late / square(predictors_adaptation_stages_TEMPO_OFF);
    memory.p[at + predictors_adaptation_stages_TEMPO_SIZE] += slow * slow / square(predictors_adaptation_stages_TEMPO_OFF);
    memory.p[at + predictors_adaptation_stages_TEMPO] += late;
    memory.p[at + predictors_adaptation_stages_TIMED] += 1.0;
  }
  memory.p[at + predictors_adaptation_stages_COUNT] += 1.0;
}

/* The number of the moment at a share of the time between the start and the end in s, from ``k`` on. */
int64_t predictors_adaptation_moments_moment_at(Vector memory, int64_t at, int64_t k, T2d span, double share, int64_t width) {
  double start, end, due;
  start = span.f0;
  end = span.f1;
  due = share * (end - start) + records_ROUNDING_S + 0.5 * memory.p[at + predictors_adaptation_moments_APART];
  while (k + 1 < memory.p[at + predictors_adaptation_moments_COUNT] && memory.p[at + predictors_adaptation_moments_FIRST + width * (k + 1) + predictors_adaptation_moments_T] - start <= due) {
    k += 1;
  }
  return k;
}

/* Learn from a movement over ``span``, its start and its arrival in s; ``place`` as for ``stated``. */
void predictors_adaptation_time_left_learn(Vector memory, T3q place, T2d span, double median, Vector prior) {
  int64_t person, intervals, at, k, moment;
  double step, share, seconds, left, off, off_prior, weight, term;
  person = place.f0;
  intervals = place.f1;
  at = place.f2;
  if (memory.p[at + predictors_adaptation_time_left_READY] == 0.0) {
    return;
  }
  step = predictors_adaptation_arrival_intervals_next_step(memory, intervals) / predictors_adaptation_time_left_JUDGED;
  for (int64_t i = 0; i < predictors_adaptation_time_left_LEARNED; i++) {
    memory.p[person + i] *= predictors_adaptation_time_left_KEEP;
  }
  k = 0;
  for (int64_t judged = 0; judged < predictors_adaptation_time_left_JUDGED; judged++) {
    share = (judged + 0.5) / predictors_adaptation_time_left_JUDGED;
    k = predictors_adaptation_moments_moment_at(memory, at + predictors_adaptation_time_left_MOMENTS, k, span, share, predictors_adaptation_time_left_MOMENT);
    moment = at + predictors_adaptation_time_left_MOMENTS + predictors_adaptation_moments_FIRST + predictors_adaptation_time_left_MOMENT * k;
    seconds = max_float(span.f1 - memory.p[moment + predictors_adaptation_moments_T], predictors_adaptation_time_left_SHORTEST_S);
    predictors_adaptation_arrival_intervals_judge(memory, intervals, share, step, (T2d){memory.p[moment + predictors_adaptation_time_left_LEFT], memory.p[moment + predictors_adaptation_time_left_SPREAD]}, seconds);
    left = min_float(seconds / median, predictors_adaptation_time_left_FURTHEST);
    off = left;
    off_prior = left;
    for (int64_t i = 0; i < predictors_adaptation_time_left_TERMS; i++) {
      off -= memory.p[at + predictors_adaptation_time_left_WEIGHTS + i] * memory.p[moment + predictors_adaptation_time_left_FIRST_TERM + i];
      off_prior -= prior.p[i] * memory.p[moment + predictors_adaptation_time_left_FIRST_TERM + i];
    }
    weight = 1.0 / (max_float(fabs(off), predictors_adaptation_time_left_SMALL) * predictors_adaptation_time_left_JUDGED);
    for (int64_t i = 0; i < predictors_adaptation_time_left_TERMS; i++) {
      term = weight * memory.p[moment + predictors_adaptation_time_left_FIRST_TERM + i];
      memory.p[person + predictors_adaptation_time_left_RESIDUALS + i] += term * off_prior;
      for (int64_t j = 0, end_1 = i + 1; j < end_1; j++) {
        memory.p[person + predictors_adaptation_time_left_PRODUCTS + floor_divided_whole(i * (i + 1), 2) + j] += term * memory.p[moment + predictors_adaptation_time_left_FIRST_TERM + j];
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
void predictors_adaptation_distances_judge(Vector memory, int64_t at, double distance) {
  int64_t count, belief;
  double total, width, time, likely, off, first;
  count = (int64_t)memory.p[at + predictors_adaptation_distances_COUNT];
  belief = at + predictors_adaptation_distances_BELIEF;
  total = 0.0;
  for (int64_t k = 0; k < predictors_adaptation_distances_LAWS; k++) {
    width = ((const double *)&predictors_adaptation_distances_WIDTHS)[remainder_whole(k, 3)];
    time = ((const double *)&predictors_adaptation_distances_AGES)[floor_divided_whole(k, 3)];
    likely = 0.0;
    for (int64_t j = 0; j < count; j++) {
      off = log(distance / memory.p[at + predictors_adaptation_distances_DISTANCES + j]) / width;
      likely += predictors_adaptation_distances_age_weight(j, count, time) * exp(-0.5 * min_float(off * off, 1000.0)) / (width * sqrt(2.0 * 3.141592653589793));
    }
    memory.p[belief + k] *= max_float(predictors_adaptation_distances_UNKNOWN_LOGS * likely, predictors_adaptation_distances_LEAST_LIKELY);
    total += memory.p[belief + k];
  }
  total += memory.p[belief + predictors_adaptation_distances_LAWS];
  for (int64_t k = 0; k < predictors_adaptation_distances_LAWS; k++) {
    first = (1.0 - predictors_adaptation_distances_UNKNOWN_SHARE) / predictors_adaptation_distances_LAWS;
    memory.p[belief + k] = (1.0 - predictors_adaptation_distances_FORGET) * memory.p[belief + k] / total + predictors_adaptation_distances_FORGET * first;
  }
  memory.p[belief + predictors_adaptation_distances_LAWS] = (1.0 - predictors_adaptation_distances_FORGET) * memory.p[belief + predictors_adaptation_distances_LAWS] / total + predictors_adaptation_distances_FORGET * predictors_adaptation_distances_UNKNOWN_SHARE;
}

/* Take in the distance of a finished movement. */
void predictors_adaptation_distances_remember(Vector memory, int64_t at, double distance) {
  int64_t count;
  double weight;
  if (memory.p[at + predictors_adaptation_distances_COUNT] == 0.0) {
    fill((Vector){memory.p + (at + predictors_adaptation_distances_BELIEF), at + predictors_adaptation_distances_BELIEF + predictors_adaptation_distances_LAWS - (at + predictors_adaptation_distances_BELIEF)}, (1.0 - predictors_adaptation_distances_UNKNOWN_SHARE) / predictors_adaptation_distances_LAWS);
    memory.p[at + predictors_adaptation_distances_BELIEF + predictors_adaptation_distances_LAWS] = predictors_adaptation_distances_UNKNOWN_SHARE;
  }
  if (memory.p[at + predictors_adaptation_distances_COUNT] >= predictors_adaptation_distances_LEAST) {
    predictors_adaptation_distances_judge(memory, at, distance);
  }
  for (int64_t j = predictors_adaptation_distances_CAPACITY - 1; j > 0; j--) {
    memory.p[at + predictors_adaptation_distances_DISTANCES + j] = memory.p[at + predictors_adaptation_distances_DISTANCES + j - 1];
  }
  memory.p[at + predictors_adaptation_distances_DISTANCES] = distance;
  memory.p[at + predictors_adaptation_distances_COUNT] = min_float(memory.p[at + predictors_adaptation_distances_COUNT] + 1.0, predictors_adaptation_distances_CAPACITY);
  count = (int64_t)memory.p[at + predictors_adaptation_distances_COUNT];
  for (int64_t j = 0; j < count; j++) {
    for (int64_t w = 0; w < 3; w++) {
      weight = 0.0;
      for (int64_t a = 0; a < 2; a++) {
        weight += memory.p[at + predictors_adaptation_distances_BELIEF + a * 3 + w] * predictors_adaptation_distances_age_weight(j, count, ((const double *)&predictors_adaptation_distances_AGES)[a]);
      }
      memory.p[at + predictors_adaptation_distances_WEIGHTS + j * 3 + w] = weight;
    }
  }
}

/* Take in the duration of a finished movement, and choose the mixture again. */
void predictors_adaptation_durations_remember(Vector memory, int64_t at, double duration) {
  int64_t count;
  double usual, least, error;
  count = (int64_t)min_float(memory.p[at + predictors_adaptation_durations_COUNT] + 1.0, predictors_adaptation_durations_CAPACITY);
  for (int64_t j = count - 1; j > 0; j--) {
    memory.p[at + predictors_adaptation_durations_DURATIONS + j] = memory.p[at + predictors_adaptation_durations_DURATIONS + j - 1];
  }
  memory.p[at + predictors_adaptation_durations_COUNT] = count;
  memory.p[at + predictors_adaptation_durations_DURATIONS] = duration;
  memory.p[at + predictors_adaptation_durations_MEDIAN] = predictors_adaptation_durations_median(memory, at + predictors_adaptation_durations_DURATIONS, count);
  usual = memory.p[at + predictors_adaptation_durations_ERRORS] / max_float(memory.p[at + predictors_adaptation_durations_MOVEMENTS], 1.0);
  least = INFINITY;
  for (int64_t k = 0; k < 5; k++) {
    error = memory.p[at + predictors_adaptation_durations_ERRORS + k] + predictors_adaptation_durations_FIRST_OF * ((const double *)&predictors_adaptation_durations_FIRST)[k] * usual;
    if (error < least) {
      least = error;
      memory.p[at + predictors_adaptation_durations_BEST] = ((const double *)&predictors_adaptation_durations_SHARES)[k];
    }
  }
}

/* How much is learned from the n-th movement. */
double predictors_adaptation_levels_step_after(double movements) {
  return max_float(predictors_adaptation_levels_STEP / (movements + predictors_adaptation_levels_STEP_OF), predictors_adaptation_levels_STEP_LEAST);
}

/* Share of the probability that a moment's law gives to places nearer than the end (x, y). */
double predictors_adaptation_region_widening_probability_within(Vector memory, int64_t moment, double x, double y) {
  double dx, dy, sxx, sxy, syy, determinant, tail, far;
  dx = x - memory.p[moment + predictors_adaptation_region_widening_X];
  dy = y - memory.p[moment + predictors_adaptation_region_widening_Y];
  sxx = memory.p[moment + predictors_adaptation_region_widening_SXX];
  sxy = memory.p[moment + predictors_adaptation_region_widening_SXY];
  syy = memory.p[moment + predictors_adaptation_region_widening_SYY];
  determinant = sxx * syy - sxy * sxy;
  tail = memory.p[moment + predictors_adaptation_region_widening_TAIL];
  if (!(determinant > 0.0)) {
    return 1.0;
  }
  far = (syy * dx * dx - 2.0 * sxy * dx * dy + sxx * dy * dy) / determinant;
  return 1.0 - exp(-0.5 * tail * log(1.0 + max_float(far, 0.0) / tail));
}

/* The stage before a share of the time, and how far the share is from it to the next. */
Tqd predictors_adaptation_stages_interpolation(double share) {
  return predictors_adaptation_stages_interpolation_among(share, predictors_adaptation_stages_STAGES);
}

/* Change an offset, within its bounds. */
void predictors_adaptation_levels_add(Vector memory, int64_t slot, double change) {
  memory.p[slot] = min_float(max_float(memory.p[slot] + change, -predictors_adaptation_levels_FURTHEST), predictors_adaptation_levels_FURTHEST);
}

/* Learn from an end inside or outside the region of a level that was stated at a share of the time. */
void predictors_adaptation_levels_learn(Vector memory, int64_t at, double share, int64_t which, bool inside, double step) {
  int64_t stage, low;
  double part, missed;
  Tqd values_1 = predictors_adaptation_stages_interpolation(share);
  stage = values_1.f0;
  part = values_1.f1;
  missed = inside ? ((const double *)&predictors_mixture_LEVELS)[which] - 1.0 : ((const double *)&predictors_mixture_LEVELS)[which];
  low = at + 2 * stage + which;
  predictors_adaptation_levels_add(memory, low, step * (1.0 - part) * missed);
  predictors_adaptation_levels_add(memory, low + 2, step * part * missed);
}

/* Learn whether the end lay inside the regions that were stated at a share of the time. */
void predictors_adaptation_mixed_region_judge(Vector memory, int64_t person, int64_t at, T2d end, double share, double step) {
  int64_t count;
  Table parts;
  double within, tail, near, far;
  bool inside;
  double buffer_1[35];
  count = (int64_t)memory.p[at + predictors_adaptation_mixed_region_COUNT];
  parts = (Table){buffer_1, predictors_adaptation_mixed_region_MOST_PLACES + 1, predictors_mixture_WIDTH};
  for (int64_t k = 0; k < count; k++) {
    for (int64_t i = 0; i < predictors_mixture_WIDTH; i++) {
      parts.p[k * parts.m + i] = memory.p[at + predictors_adaptation_mixed_region_PARTS + predictors_mixture_WIDTH * k + i];
    }
  }
  within = predictors_mixture_content(parts, count, end.f0, end.f1, predictors_adaptation_mixed_region_POINTS);
  tail = parts.p[0 * parts.m + predictors_mixture_TAIL];
  near = memory.p[at + predictors_adaptation_mixed_region_OFFSETS];
  far = memory.p[at + predictors_adaptation_mixed_region_OFFSETS + 1];
  for (int64_t which = 0; which < 2; which++) {
    inside = within <= predictors_mixture_corrected_probability(((const double *)&predictors_mixture_LEVELS)[which], tail, near, far);
    predictors_adaptation_levels_learn(memory, person, share, which, inside, step);
  }
}

/* Judge a movement over ``span``, its start and end in s, which ended at a place in px. */
void predictors_adaptation_region_widening_learn(Vector memory, int64_t person, int64_t at, T2d place_of_end, T2d span) {
  double x, y, step, share, within;
  int64_t k, moment;
  if (memory.p[at + predictors_adaptation_moments_COUNT] == 0.0) {
    return;
  }
  x = place_of_end.f0;
  y = place_of_end.f1;
  memory.p[person + predictors_adaptation_region_widening_MOVEMENTS] = min_float(memory.p[person + predictors_adaptation_region_widening_MOVEMENTS] + 1.0, predictors_adaptation_region_widening_MOVEMENTS_MOST);
  step = predictors_adaptation_levels_step_after(memory.p[person + predictors_adaptation_region_widening_MOVEMENTS]);
  k = 0;
  for (int64_t judged = 1; judged < (predictors_adaptation_region_widening_JUDGED + 1); judged++) {
    share = judged / (predictors_adaptation_region_widening_JUDGED + 1.0);
    k = predictors_adaptation_moments_moment_at(memory, at, k, span, share, predictors_adaptation_region_widening_MOMENT);
    moment = at + predictors_adaptation_moments_FIRST + predictors_adaptation_region_widening_MOMENT * k;
    within = predictors_adaptation_region_widening_probability_within(memory, moment, x, y);
    for (int64_t which = 0; which < 2; which++) {
      predictors_adaptation_levels_learn(memory, person + predictors_adaptation_region_widening_OFFSETS, share, which, within <= ((const double *)&predictors_mixture_LEVELS)[which], step);
    }
    predictors_adaptation_mixed_region_judge(memory, person + predictors_adaptation_region_widening_MIXED, moment + predictors_adaptation_region_widening_MIXTURE, place_of_end, share, step);
  }
}

/* Learn from a movement over ``distance`` px that arrived at ``end`` s where the cursor is. */
void predictors_adaptation_correction_learn(Vector memory, int64_t person, int64_t at, double distance, double end) {
  double x, y, start, duration, left, median;
  int64_t clock, place, stage;
  bool not_first;
  stages_Moment m;
  T3q timed;
  x = memory.p[at + predictors_adaptation_correction_X];
  y = memory.p[at + predictors_adaptation_correction_Y];
  start = memory.p[at + predictors_adaptation_correction_T0];
  duration = end - start;
  clock = person + predictors_adaptation_correction_DURATIONS;
  not_first = memory.p[clock + predictors_adaptation_durations_COUNT] > 0.0;
  if (not_first) {
    predictors_adaptation_durations_forget(memory, clock);
  }
  for (int64_t number = 0; number < predictors_adaptation_stages_STAGES; number++) {
    place = at + predictors_adaptation_correction_MOMENTS + number * predictors_adaptation_stages_MOMENT;
    stage = person + number * predictors_adaptation_stages_WIDTH;
    if (memory.p[place + predictors_adaptation_stages_PRESENT] == 1.0) {
      m = predictors_adaptation_stages_moment_at(memory, place);
      if (not_first && m.t < end) {
        left = m.left * predictors_adaptation_stages_tempo_factor(memory, stage);
        predictors_adaptation_durations_judge(memory, clock, m.t - start, left, end - m.t, duration);
      }
      predictors_adaptation_stages_learn(memory, stage, m, x, y, end);
    }
  }
  if (not_first) {
    timed = (T3q){person + predictors_adaptation_correction_TIME_LEFT, person + predictors_adaptation_correction_INTERVALS, at + predictors_adaptation_correction_TIMED};
    median = memory.p[clock + predictors_adaptation_durations_MEDIAN];
    predictors_adaptation_time_left_learn(memory, timed, (T2d){start, end}, median, (Vector){(double *)predictors_adaptation_time_left_prior_PRIOR, 35});
  }
  predictors_adaptation_distances_remember(memory, person + predictors_adaptation_correction_DISTANCES, distance);
  predictors_adaptation_durations_remember(memory, clock, duration);
  predictors_adaptation_region_widening_learn(memory, person + predictors_adaptation_correction_REGIONS, at + predictors_adaptation_correction_STATED, (T2d){x, y}, (T2d){start, end});
}

/* The movement has ended where the cursor is: learn from it, and forget it. */
void predictors_adaptation_correction_conclude(Vector memory, int64_t person, int64_t at, double shortest, correction_Parts parts, scene_Scene scene) {
  double distance, end;
  bool whole;
  distance = hypot(memory.p[at + predictors_adaptation_correction_X] - memory.p[at + predictors_adaptation_correction_X0], memory.p[at + predictors_adaptation_correction_Y] - memory.p[at + predictors_adaptation_correction_Y0]);
  end = predictors_adaptation_correction_arrival(memory, at, max_float(predictors_adaptation_correction_NEAR_PX, predictors_adaptation_correction_NEAR_SHARE * distance));
  whole = memory.p[at + predictors_adaptation_correction_STARTED] == 1.0 && memory.p[at + predictors_adaptation_correction_SAMPLES] >= predictors_adaptation_correction_SAMPLES_LEAST;
  if (whole && end - memory.p[at + predictors_adaptation_correction_T0] >= predictors_adaptation_correction_LEAST_S && distance >= max_float(shortest, predictors_adaptation_distances_SHORTEST_PX)) {
    if (parts.places == 1.0) {
      predictors_adaptation_correction_learn_place(memory, person, at, parts, scene);
    }
    predictors_adaptation_correction_learn(memory, person, at, distance, end);
  }
  fill((Vector){memory.p + at, at + predictors_adaptation_correction_STATES - at}, 0.0);
}

/* Take in one sample (t, x, y) of the movement that started at ``start``. */
void predictors_adaptation_correction_follow(Vector memory, int64_t at, T3d now, T3d start) {
  double t, x, y;
  int64_t places, last, place;
  bool moved;
  t = now.f0;
  x = now.f1;
  y = now.f2;
  places = (int64_t)memory.p[at + predictors_adaptation_correction_PLACES];
  last = at + predictors_adaptation_correction_TRACE + 3 * remainder_whole(places - 1, predictors_adaptation_correction_TRACE_PLACES);
  if (memory.p[at + predictors_adaptation_correction_STARTED] == 0.0 || t > memory.p[at + predictors_adaptation_correction_T]) {
    memory.p[at + predictors_adaptation_correction_SAMPLES] += 1.0;
  }
  moved = x != memory.p[last + 1] || y != memory.p[last + 2];
  if (places > 0 && t == memory.p[last]) {
    memory.p[last + 1] = x;
    memory.p[last + 2] = y;
  } else if (places == 0 || (moved && t - memory.p[last] >= predictors_adaptation_correction_APART_S)) {
    place = at + predictors_adaptation_correction_TRACE + 3 * remainder_whole(places, predictors_adaptation_correction_TRACE_PLACES);
    memory.p[place] = t;
    memory.p[place + 1] = x;
    memory.p[place + 2] = y;
    memory.p[at + predictors_adaptation_correction_PLACES] = places + 1.0;
  }
  memory.p[at + predictors_adaptation_correction_STARTED] = 1.0;
  memory.p[at + predictors_adaptation_correction_T0] = start.f0;
  memory.p[at + predictors_adaptation_correction_X0] = start.f1;
  memory.p[at + predictors_adaptation_correction_Y0] = start.f2;
  memory.p[at + predictors_adaptation_correction_T] = t;
  memory.p[at + predictors_adaptation_correction_X] = x;
  memory.p[at + predictors_adaptation_correction_Y] = y;
}

/* Write the moment of a stage. */
void predictors_adaptation_stages_record(Vector memory, int64_t place, stages_Moment moment) {
  memory.p[place + predictors_adaptation_stages_PRESENT] = 1.0;
  for (int64_t i = 0; i < 12; i++) {
    memory.p[place + predictors_adaptation_stages_PARTS + i] = ((const double *)&moment)[i];
  }
}

/* Remember the first moment of a stage, as its last sample has it. */
void predictors_adaptation_correction_record(Vector memory, int64_t at, double share, stages_Moment moment) {
  int64_t stage, place;
  bool again;
  stage = (int64_t)floor(share * predictors_adaptation_stages_STAGES - 0.5 + predictors_adaptation_correction_EARLY);
  if (stage < 0 || stage >= predictors_adaptation_stages_STAGES) {
    return;
  }
  place = at + predictors_adaptation_correction_MOMENTS + stage * predictors_adaptation_stages_MOMENT;
  again = memory.p[place + predictors_adaptation_stages_PRESENT] == 1.0 && memory.p[place + predictors_adaptation_stages_T] == moment.t;
  for (int64_t later = stage; later < predictors_adaptation_stages_STAGES; later++) {
    if (memory.p[at + predictors_adaptation_correction_MOMENTS + later * predictors_adaptation_stages_MOMENT + predictors_adaptation_stages_PRESENT] == 1.0 && !again) {
      return;
    }
  }
  predictors_adaptation_stages_record(memory, place, moment);
}

/* 1 up to a share of the time, then falling to 0 at the end. */
double predictors_adaptation_correction_fading(double share, double since) {
  return min_float((1.0 - share) / (1.0 - since), 1.0);
}

/* The law of an answer along and across the direction from the start to the cursor. */
destination_Heading predictors_adaptation_correction_heading_of(Vector memory, int64_t at, T10d answer) {
  double px, py, sxx, sxy, syy, left, tail, away_x, away_y, reached, ux, uy, wide2, broad2;
  px = answer.f1;
  py = answer.f2;
  sxx = answer.f3;
  sxy = answer.f4;
  syy = answer.f5;
  left = answer.f6;
  tail = answer.f8;
  away_x = memory.p[at + predictors_adaptation_correction_X] - memory.p[at + predictors_adaptation_correction_X0];
  away_y = memory.p[at + predictors_adaptation_correction_Y] - memory.p[at + predictors_adaptation_correction_Y0];
  reached = hypot(away_x, away_y);
  if (!(reached > 0.0 && left > 0.0 && tail > 0.0 && sxx + syy > 0.0)) {
    return (destination_Heading){px, py, 0.0, 0.0, 0.0, 0.0, tail};
  }
  ux = away_x / reached;
  uy = away_y / reached;
  wide2 = sxx * ux * ux + 2.0 * sxy * ux * uy + syy * uy * uy;
  broad2 = sxx * uy * uy - 2.0 * sxy * ux * uy + syy * ux * ux;
  if (!(wide2 > 0.0 && broad2 > 0.0)) {
    return (destination_Heading){px, py, 0.0, 0.0, 0.0, 0.0, tail};
  }
  return (destination_Heading){px, py, ux, uy, sqrt(wide2), sqrt(broad2), tail};
}

/* The way from the cursor to the centre of a law, along and across its direction, px. */
T2d predictors_adaptation_correction_ahead_of(Vector memory, int64_t at, destination_Heading heading) {
  double dx, dy;
  dx = heading.x - memory.p[at + predictors_adaptation_correction_X];
  dy = heading.y - memory.p[at + predictors_adaptation_correction_Y];
  return (T2d){dx * heading.ux + dy * heading.uy, dy * heading.ux - dx * heading.uy};
}

/* A law whose centre lies ``along`` px ahead of the cursor, of the width ``wide`` px along. */
destination_Heading predictors_adaptation_correction_with_centre_ahead(Vector memory, int64_t at, destination_Heading heading, double along, double wide) {
  double across, x, y, ux, uy, broad, tail;
  T2d values_1 = predictors_adaptation_correction_ahead_of(memory, at, heading);
  across = values_1.f1;
  x = heading.x;
  y = heading.y;
  ux = heading.ux;
  uy = heading.uy;
  broad = heading.broad;
  tail = heading.tail;
  x = memory.p[at + predictors_adaptation_correction_X] + along * ux - across * uy;
  y = memory.p[at + predictors_adaptation_correction_Y] + along * uy + across * ux;
  return (destination_Heading){x, y, ux, uy, wide, broad, tail};
}

/* The way ahead and its width along, by the predicted law and the last distances: (px, px). */
T3d predictors_adaptation_distances_combine(Vector memory, int64_t at, double reached, distances_Ahead predicted) {
  double ahead, wide, broad, tail, total, low, high, distance, gap, kernel2, both2, fits, part, middle, below, off, around;
  int64_t count, most, parts;
  Vector weight, shift, width;
  ahead = predicted.ahead;
  wide = predicted.wide;
  broad = predicted.broad;
  tail = predicted.tail;
  count = (int64_t)memory.p[at + predictors_adaptation_distances_COUNT];
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
  total = memory.p[at + predictors_adaptation_distances_BELIEF + predictors_adaptation_distances_LAWS];
  low = 0.0;
  high = 0.0;
  parts = 1;
  weight.p[0] = total;
  shift.p[0] = 0.0;
  width.p[0] = wide;
  for (int64_t j = 0; j < count; j++) {
    distance = memory.p[at + predictors_adaptation_distances_DISTANCES + j];
    gap = distance / sqrt(1.0 + predictors_adaptation_distances_ARC * square(broad / distance)) - reached - ahead;
    for (int64_t w = 0; w < 3; w++) {
      kernel2 = square(((const double *)&predictors_adaptation_distances_WIDTHS)[w] * distance);
      both2 = wide * wide + kernel2;
      fits = pow(1.0 + gap * gap / both2 / tail, -0.5 * (tail + 1.0)) / sqrt(2.0 * 3.141592653589793 * both2);
      part = memory.p[at + predictors_adaptation_distances_WEIGHTS + j * 3 + w] * predictors_adaptation_distances_UNKNOWN_LOGS * distance * fits;
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
T_destination_Heading_d predictors_adaptation_correction_by_distances(Vector memory, int64_t person, int64_t at, destination_Heading own, double share) {
  double reached, along, usual_along, usual_wide, usual, weight;
  distances_Ahead ahead;
  reached = hypot(memory.p[at + predictors_adaptation_correction_X] - memory.p[at + predictors_adaptation_correction_X0], memory.p[at + predictors_adaptation_correction_Y] - memory.p[at + predictors_adaptation_correction_Y0]);
  T2d values_1 = predictors_adaptation_correction_ahead_of(memory, at, own);
  along = values_1.f0;
  ahead = (distances_Ahead){along, own.wide, own.broad, own.tail};
  T3d values_2 = predictors_adaptation_distances_combine(memory, person + predictors_adaptation_correction_DISTANCES, reached, ahead);
  usual_along = values_2.f0;
  usual_wide = values_2.f1;
  usual = values_2.f2;
  weight = predictors_adaptation_correction_fading(share, predictors_adaptation_correction_FADE);
  along += weight * (usual_along - along);
  return (T_destination_Heading_d){predictors_adaptation_correction_with_centre_ahead(memory, at, own, along, own.wide * pow(usual_wide / own.wide, weight)), usual};
}

/* How far from a place its visits end, as a share of the distance to it: the geometric mean. */
double predictors_adaptation_habits_usual_width(Vector memory, int64_t habits) {
  double log_width;
  log_width = 0.0;
  for (int64_t k = 0; k < 3; k++) {
    log_width += predictors_adaptation_habits_width_weight(memory, habits, k) * log(((const double *)&predictors_adaptation_habits_WIDTHS)[k]);
  }
  return exp(log_width);
}

/* Shift the shares before the movement towards the places near its start; their sum stays. */
void predictors_adaptation_destination_favour_near(Vector memory, int64_t place_memory, int64_t at, T2d start, double near) {
  double before, after, distance, nearest;
  int64_t place;
  before = 0.0;
  after = 0.0;
  for (int64_t i = 0, end_1 = (int64_t)memory.p[place_memory + predictors_adaptation_places_COUNT]; i < end_1; i++) {
    place = place_memory + predictors_adaptation_places_PLACES + predictors_adaptation_places_WIDTH * i;
    distance = hypot(memory.p[place + predictors_adaptation_places_X] - start.f0, memory.p[place + predictors_adaptation_places_Y] - start.f1);
    before += memory.p[at + predictors_adaptation_destination_BEFORE + i];
    nearest = predictors_adaptation_destination_NEAREST * near;
    memory.p[at + predictors_adaptation_destination_BEFORE + i] *= distance > near ? pow(max_float(distance, nearest), -predictors_adaptation_destination_NEARNESS) : 0.0;
    after += memory.p[at + predictors_adaptation_destination_BEFORE + i];
  }
  for (int64_t i = 0, end_2 = (int64_t)memory.p[place_memory + predictors_adaptation_places_COUNT]; i < end_2; i++) {
    memory.p[at + predictors_adaptation_destination_BEFORE + i] *= after > 0.0 ? before / after : 0.0;
  }
}

/* Lay out the share of each place before a movement from ``start``, px from the origin. */
void predictors_adaptation_destination_prepare(Vector memory, T2q known, int64_t at, T3d scene, T2d start) {
  int64_t place_memory, habit_memory;
  double key, with_sequence, near, weight;
  Table out;
  double buffer_1[256];
  place_memory = known.f0;
  habit_memory = known.f1;
  key = scene.f0;
  with_sequence = scene.f1;
  near = scene.f2;
  memset(buffer_1, 0, sizeof buffer_1);
  out = (Table){buffer_1, predictors_adaptation_habits_RULES, predictors_adaptation_places_CAPACITY};
  fill((Vector){memory.p + at, at + predictors_adaptation_destination_STATES - at}, 0.0);
  memory.p[at + predictors_adaptation_destination_READY] = 1.0;
  memory.p[at + predictors_adaptation_destination_ELSEWHERE] = 1.0;
  if (!predictors_adaptation_habits_shares(memory, place_memory, habit_memory, key, (T3d){start.f0, start.f1, near}, out)) {
    return;
  }
  memory.p[at + predictors_adaptation_destination_RETURNS] = predictors_adaptation_habits_returns(memory, habit_memory);
  memory.p[at + predictors_adaptation_destination_WIDTH] = predictors_adaptation_habits_usual_width(memory, habit_memory);
  for (int64_t rule = 0; rule < predictors_adaptation_habits_RULES; rule++) {
    weight = predictors_adaptation_habits_rule_weight(memory, habit_memory, rule, with_sequence);
    for (int64_t i = 0; i < predictors_adaptation_places_CAPACITY; i++) {
      memory.p[at + predictors_adaptation_destination_BEFORE + i] += weight * out.p[rule * out.m + i];
    }
  }
  predictors_adaptation_destination_favour_near(memory, place_memory, at, start, near);
}

/* Lay out how likely each place is for a movement from ``start``, px from the scene's origin. */
void predictors_adaptation_correction_prepare(Vector memory, int64_t person, int64_t going, correction_Parts parts, scene_Scene scene, T2d start) {
  double near;
  T2q known;
  near = predictors_adaptation_places_NEAR_SHARE * memory.p[person + predictors_adaptation_correction_DISTANCES + predictors_adaptation_distances_DISTANCES];
  known = (T2q){person + predictors_adaptation_correction_KNOWN, person + predictors_adaptation_correction_HABITS};
  predictors_adaptation_destination_prepare(memory, known, going, (T3d){scene.key, parts.sequence, near}, start);
}

/* How likely a law makes a place, over what it is where nothing is known. */
double predictors_adaptation_destination_likelihood(destination_Heading law_of_end, double x, double y, double distance, double spread) {
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
void predictors_adaptation_destination_weigh(Vector memory, int64_t place_memory, int64_t at, T2d start, destination_Heading law_of_end, T2d elsewhere) {
  double x0, y0, usual, counts, returns, total, before, share, x, y, distance, spread, rest;
  int64_t count, place;
  x0 = start.f0;
  y0 = start.f1;
  usual = elsewhere.f0;
  counts = elsewhere.f1;
  memory.p[at + predictors_adaptation_destination_COUNTS] = counts;
  returns = memory.p[at + predictors_adaptation_destination_RETURNS];
  count = (int64_t)memory.p[place_memory + predictors_adaptation_places_COUNT];
  total = (1.0 - returns) * usual;
  for (int64_t i = 0; i < count; i++) {
    before = memory.p[at + predictors_adaptation_destination_BEFORE + i];
    share = 0.0;
    if (before > predictors_adaptation_destination_LEAST_SHARE) {
      place = place_memory + predictors_adaptation_places_PLACES + predictors_adaptation_places_WIDTH * i;
      x = memory.p[place + predictors_adaptation_places_X];
      y = memory.p[place + predictors_adaptation_places_Y];
      distance = hypot(x - x0, y - y0);
      spread = memory.p[at + predictors_adaptation_destination_WIDTH] * distance;
      share = returns * before * predictors_adaptation_destination_likelihood(law_of_end, x, y, distance, spread);
    }
    memory.p[at + predictors_adaptation_destination_NOW + i] = share;
    total += share;
  }
  rest = 1.0;
  for (int64_t i = 0; i < count; i++) {
    memory.p[at + predictors_adaptation_destination_NOW + i] = memory.p[at + predictors_adaptation_destination_NOW + i] / total;
    rest -= memory.p[at + predictors_adaptation_destination_NOW + i];
  }
  memory.p[at + predictors_adaptation_destination_ELSEWHERE] = max_float(rest, 0.0);
}

/* A law whose centre is shifted. */
destination_Heading predictors_adaptation_destination_shift_law(destination_Heading heading, double dx, double dy) {
  double x, y, ux, uy, wide, broad, tail;
  x = heading.x;
  y = heading.y;
  ux = heading.ux;
  uy = heading.uy;
  wide = heading.wide;
  broad = heading.broad;
  tail = heading.tail;
  return (destination_Heading){x + dx, y + dy, ux, uy, wide, broad, tail};
}

/* How far visits of a place end from it, px. */
double predictors_adaptation_destination_spread_of(Vector memory, int64_t at, T2d start, double x, double y) {
  return memory.p[at + predictors_adaptation_destination_WIDTH] * hypot(x - start.f0, y - start.f1);
}

/* Fill rows of share, position and squared width, px^2: elsewhere, then the places; returns how many. */
int64_t predictors_adaptation_destination_candidates(Vector memory, int64_t place_memory, int64_t at, T2d start, destination_Heading elsewhere, Table out) {
  double size2, counts, rest, share, x, y, spread;
  int64_t count, place;
  size2 = 0.5 * (elsewhere.wide * elsewhere.wide + elsewhere.broad * elsewhere.broad);
  counts = memory.p[at + predictors_adaptation_destination_COUNTS];
  rest = 1.0 - counts * (1.0 - memory.p[at + predictors_adaptation_destination_ELSEWHERE]);
  out.p[0 * out.m + 0] = rest;
  out.p[0 * out.m + 1] = elsewhere.x;
  out.p[0 * out.m + 2] = elsewhere.y;
  out.p[0 * out.m + 3] = size2;
  count = 1;
  for (int64_t i = 0, end_1 = (int64_t)memory.p[place_memory + predictors_adaptation_places_COUNT]; i < end_1; i++) {
    share = counts * memory.p[at + predictors_adaptation_destination_NOW + i];
    if (share > predictors_adaptation_destination_NEGLIGIBLE) {
      place = place_memory + predictors_adaptation_places_PLACES + predictors_adaptation_places_WIDTH * i;
      x = memory.p[place + predictors_adaptation_places_X];
      y = memory.p[place + predictors_adaptation_places_Y];
      spread = predictors_adaptation_destination_spread_of(memory, at, start, x, y);
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
T2d predictors_adaptation_destination_geometric_median(Table rows, int64_t count) {
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
destination_Heading predictors_adaptation_destination_combine(Vector memory, int64_t place_memory, int64_t at, T2d start, destination_Heading elsewhere) {
  Table rows;
  int64_t count;
  double x, y, ux, uy, wide, broad, tail, new_wide, new_broad, total, dx, dy, share, along, across, wide2, broad2;
  double buffer_1[260];
  rows = (Table){buffer_1, predictors_adaptation_places_CAPACITY + 1, 4};
  count = predictors_adaptation_destination_candidates(memory, place_memory, at, start, elsewhere, rows);
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
  return (destination_Heading){x, y, ux, uy, new_wide / total, new_broad / total, tail};
}

/* The law of the endpoint by the places where the person was before. */
destination_Heading predictors_adaptation_correction_by_places(Vector memory, int64_t person, int64_t at, correction_Parts parts, scene_Scene scene, T2_destination_Heading_ laws, T2d weights) {
  destination_Heading own, elsewhere, combined;
  T2d start;
  int64_t where, going;
  own = laws.f0;
  elsewhere = laws.f1;
  start = (T2d){memory.p[at + predictors_adaptation_correction_X0] - scene.x, memory.p[at + predictors_adaptation_correction_Y0] - scene.y};
  where = person + predictors_adaptation_correction_KNOWN;
  going = at + predictors_adaptation_correction_DESTINATION;
  if (memory.p[going + predictors_adaptation_destination_READY] == 0.0) {
    predictors_adaptation_correction_prepare(memory, person, going, parts, scene, start);
  }
  if (memory.p[going + predictors_adaptation_destination_RETURNS] == 0.0) {
    return elsewhere;
  }
  predictors_adaptation_destination_weigh(memory, where, going, start, predictors_adaptation_destination_shift_law(own, -scene.x, -scene.y), weights);
  combined = predictors_adaptation_destination_combine(memory, where, going, start, predictors_adaptation_destination_shift_law(elsewhere, -scene.x, -scene.y));
  return predictors_adaptation_destination_shift_law(combined, scene.x, scene.y);
}

/* The law of the endpoint by all parts that answer, and that of elsewhere, without the places. */
T2_destination_Heading_ predictors_adaptation_correction_adapted_end(Vector memory, int64_t person, int64_t at, correction_Parts parts, scene_Scene scene, destination_Heading own, double share) {
  destination_Heading elsewhere;
  double usual;
  T2d weights;
  elsewhere = own;
  usual = 1.0;
  if (parts.distances == 1.0) {
    T_destination_Heading_d values_1 = predictors_adaptation_correction_by_distances(memory, person, at, own, share);
    elsewhere = values_1.f0;
    usual = values_1.f1;
  }
  if (parts.places == 0.0) {
    return (T2_destination_Heading_){elsewhere, elsewhere};
  }
  weights = (T2d){usual, predictors_adaptation_correction_fading(share, predictors_adaptation_correction_PLACES_FADE)};
  return (T2_destination_Heading_){predictors_adaptation_correction_by_places(memory, person, at, parts, scene, (T2_destination_Heading_){own, elsewhere}, weights), elsewhere};
}

/* The likeliest place that is less likely than ``below``; -1 where there is none above ``LEAST``. */
int64_t predictors_adaptation_mixed_region_likeliest(Vector memory, int64_t place_memory, int64_t going, double below) {
  int64_t best;
  double most, share;
  best = -1;
  most = predictors_adaptation_mixed_region_LEAST;
  for (int64_t i = 0, end_1 = (int64_t)memory.p[place_memory + predictors_adaptation_places_COUNT]; i < end_1; i++) {
    share = memory.p[going + predictors_adaptation_destination_NOW + i];
    if (most < share && share < below) {
      best = i;
      most = share;
    }
  }
  return best;
}

/* Write a place: a normal law of a standard deviation in px. */
void predictors_adaptation_mixed_region_write_part(Vector memory, int64_t part, double share, T2d centre, double spread) {
  memory.p[part + predictors_mixture_SHARE] = share;
  memory.p[part + predictors_mixture_X] = centre.f0;
  memory.p[part + predictors_mixture_Y] = centre.f1;
  memory.p[part + predictors_mixture_SXX] = spread * spread;
  memory.p[part + predictors_mixture_SXY] = 0.0;
  memory.p[part + predictors_mixture_SYY] = spread * spread;
  memory.p[part + predictors_mixture_TAIL] = 0.0;
}

/* The offset of a level at a share of the time: on lines between the stages. */
double predictors_adaptation_levels_offset(Vector memory, int64_t at, double share, int64_t which) {
  int64_t stage, low;
  double part;
  Tqd values_1 = predictors_adaptation_stages_interpolation(share);
  stage = values_1.f0;
  part = values_1.f1;
  low = at + 2 * stage + which;
  return memory.p[low] + part * (memory.p[low + 2] - memory.p[low]);
}

/* Write the mixture as it is now, and what its regions must hold of it. */
void predictors_adaptation_mixed_region_write(Vector memory, T3q known, int64_t now, int64_t at, T2d origin, T2d start) {
  int64_t person, place_memory, going, count, number, place;
  double rest, below, x, y, spread;
  T2d centre;
  person = known.f0;
  place_memory = known.f1;
  going = known.f2;
  count = 1;
  rest = 1.0;
  below = 2.0;
  number = predictors_adaptation_mixed_region_likeliest(memory, place_memory, going, below);
  while (number >= 0 && count <= predictors_adaptation_mixed_region_MOST_PLACES) {
    below = memory.p[going + predictors_adaptation_destination_NOW + number];
    place = place_memory + predictors_adaptation_places_PLACES + predictors_adaptation_places_WIDTH * number;
    x = memory.p[place + predictors_adaptation_places_X];
    y = memory.p[place + predictors_adaptation_places_Y];
    spread = max_float(predictors_adaptation_destination_spread_of(memory, going, start, x, y), predictors_adaptation_mixed_region_LEAST_SPREAD);
    centre = (T2d){x + origin.f0, y + origin.f1};
    predictors_adaptation_mixed_region_write_part(memory, at + predictors_adaptation_mixed_region_PARTS + predictors_mixture_WIDTH * count, below, centre, spread);
    rest -= below;
    count += 1;
    number = predictors_adaptation_mixed_region_likeliest(memory, place_memory, going, below);
  }
  memory.p[at + predictors_adaptation_mixed_region_COUNT] = count;
  memory.p[at + predictors_adaptation_mixed_region_PARTS + predictors_mixture_SHARE] = max_float(rest, 0.0);
  for (int64_t i = 0; i < (predictors_adaptation_mixed_region_ASKED - predictors_adaptation_mixed_region_ELSEWHERE); i++) {
    memory.p[at + predictors_adaptation_mixed_region_PARTS + predictors_mixture_X + i] = memory.p[now + predictors_adaptation_mixed_region_ELSEWHERE + i];
  }
  for (int64_t which = 0; which < 2; which++) {
    memory.p[at + predictors_adaptation_mixed_region_OFFSETS + which] = predictors_adaptation_levels_offset(memory, person, memory.p[now + predictors_adaptation_mixed_region_TIME], which);
  }
}

/* Write the mixture of places and elsewhere as it is claimed now. */
void predictors_adaptation_correction_write_mixture(Vector memory, int64_t person, int64_t at, scene_Scene scene, int64_t to) {
  T3q known;
  T2d start;
  known = (T3q){person + predictors_adaptation_correction_REGIONS + predictors_adaptation_region_widening_MIXED, person + predictors_adaptation_correction_KNOWN, at + predictors_adaptation_correction_DESTINATION};
  start = (T2d){memory.p[at + predictors_adaptation_correction_X0] - scene.x, memory.p[at + predictors_adaptation_correction_Y0] - scene.y};
  predictors_adaptation_mixed_region_write(memory, known, at + predictors_adaptation_correction_NOW, to, (T2d){scene.x, scene.y}, start);
}

/* Remember elsewhere's law at a share of the time: its centre, scale matrix and tail. */
void predictors_adaptation_mixed_region_claim(Vector memory, int64_t now, double share, T6d elsewhere) {
  memory.p[now + predictors_adaptation_mixed_region_CLAIMED] = 1.0;
  memory.p[now + predictors_adaptation_mixed_region_TIME] = share;
  for (int64_t i = 0; i < 6; i++) {
    memory.p[now + predictors_adaptation_mixed_region_ELSEWHERE + i] = ((const double *)&elsewhere)[i];
  }
}

/* Where to write the moment of a cursor (t, x, y), its time already written; -1 for nowhere. */
int64_t predictors_adaptation_moments_new_moment(Vector memory, int64_t at, T3d cursor, int64_t width, int64_t most) {
  double t, x, y;
  int64_t count, last;
  t = cursor.f0;
  x = cursor.f1;
  y = cursor.f2;
  count = (int64_t)memory.p[at + predictors_adaptation_moments_COUNT];
  last = at + predictors_adaptation_moments_FIRST + width * (count - 1);
  if (count == 0 || t != memory.p[last + predictors_adaptation_moments_T]) {
    if (count == 0) {
      memory.p[at + predictors_adaptation_moments_APART] = predictors_adaptation_moments_APART_S;
    } else if (t - memory.p[last + predictors_adaptation_moments_T] < memory.p[at + predictors_adaptation_moments_APART]) {
      return -1;
    }
    if (count == most) {
      if (x == memory.p[at + predictors_adaptation_moments_CURSOR_X] && y == memory.p[at + predictors_adaptation_moments_CURSOR_Y]) {
        return -1;
      }
      count = floor_divided_whole(most, 2);
      for (int64_t k = 1; k < count; k++) {
        for (int64_t i = 0; i < width; i++) {
          memory.p[at + predictors_adaptation_moments_FIRST + width * k + i] = memory.p[at + predictors_adaptation_moments_FIRST + 2 * width * k + i];
        }
      }
      memory.p[at + predictors_adaptation_moments_APART] *= 2.0;
    }
    memory.p[at + predictors_adaptation_moments_COUNT] = count + 1.0;
    last = at + predictors_adaptation_moments_FIRST + width * count;
  }
  memory.p[at + predictors_adaptation_moments_CURSOR_X] = x;
  memory.p[at + predictors_adaptation_moments_CURSOR_Y] = y;
  memory.p[last + predictors_adaptation_moments_T] = t;
  return last;
}

/* Remember the law stated at a moment: endpoint, scale matrix, tail. */
int64_t predictors_adaptation_region_widening_record(Vector memory, int64_t at, double t, double cursor_x, double cursor_y, T6d stated) {
  int64_t last;
  last = predictors_adaptation_moments_new_moment(memory, at, (T3d){t, cursor_x, cursor_y}, predictors_adaptation_region_widening_MOMENT, predictors_adaptation_region_widening_MOST);
  if (last < 0) {
    return -1;
  }
  for (int64_t i = 0; i < 6; i++) {
    memory.p[last + predictors_adaptation_region_widening_X + i] = ((const double *)&stated)[i];
  }
  return last + predictors_adaptation_region_widening_MIXTURE;
}

/* Remember what is stated at a share of the time: the single law, and that of elsewhere. */
void predictors_adaptation_correction_state(Vector memory, int64_t person, int64_t at, scene_Scene scene, double share, T2_T6d_ laws) {
  T6d region, elsewhere;
  double now, x, y;
  int64_t to;
  region = laws.f0;
  elsewhere = laws.f1;
  predictors_adaptation_mixed_region_claim(memory, at + predictors_adaptation_correction_NOW, share, elsewhere);
  now = memory.p[at + predictors_adaptation_correction_T];
  x = memory.p[at + predictors_adaptation_correction_X];
  y = memory.p[at + predictors_adaptation_correction_Y];
  to = predictors_adaptation_region_widening_record(memory, at + predictors_adaptation_correction_STATED, now, x, y, region);
  if (to >= 0) {
    predictors_adaptation_correction_write_mixture(memory, person, at, scene, to);
  }
}

/* Logarithm of what a stage multiplies a width by. */
double predictors_adaptation_stages_width_log(Vector memory, int64_t at, int64_t which) {
  return 0.5 * log((memory.p[at + which] + predictors_adaptation_stages_WIDTHS_OF) / (memory.p[at + predictors_adaptation_stages_COUNT] + predictors_adaptation_stages_WIDTHS_OF));
}

/* (bias px, factors of the width along, the width across, the time left). */
T4d predictors_adaptation_stages_correct(Vector memory, int64_t at, double share, double total, double along) {
  int64_t stage, a;
  double part, shift, wide, broad, slow, weight;
  Tqd values_1 = predictors_adaptation_stages_interpolation(share);
  stage = values_1.f0;
  part = values_1.f1;
  shift = 0.0;
  wide = 0.0;
  broad = 0.0;
  slow = 0.0;
  for (int64_t side = 0; side < 2; side++) {
    a = at + (stage + side) * predictors_adaptation_stages_WIDTH;
    weight = side == 1 ? part : 1.0 - part;
    shift += weight * predictors_adaptation_stages_bias(memory, a, total, along) * predictors_adaptation_stages_belief(memory, a, predictors_adaptation_stages_BIAS_PAID);
    wide += weight * predictors_adaptation_stages_width_log(memory, a, predictors_adaptation_stages_WIDE);
    broad += weight * predictors_adaptation_stages_width_log(memory, a, predictors_adaptation_stages_BROAD);
    slow += weight * predictors_adaptation_stages_tempo(memory, a) * predictors_adaptation_stages_belief(memory, a, predictors_adaptation_stages_TEMPO_PAID);
  }
  return (T4d){shift, exp(wide), exp(broad), exp(slow)};
}

/* The time left by the best mixture; what the predictor says before any movement is known. */
double predictors_adaptation_durations_mix(Vector memory, int64_t at, double since, double left) {
  if (memory.p[at + predictors_adaptation_durations_COUNT] == 0.0) {
    return left;
  }
  return predictors_adaptation_durations_mixture(memory, at, memory.p[at + predictors_adaptation_durations_BEST], since, left);
}

/* (factor of the scale matrix, tail) of the law whose regions of both levels have the learned radii. */
T2d predictors_adaptation_region_widening_widen(Vector memory, int64_t at, double share, double tail) {
  double heavy_now, first, second, near, far, ratio, low, high, heavy, half, most, both;
  int64_t own;
  if (memory.p[at + predictors_adaptation_region_widening_MOVEMENTS] == 0.0) {
    return (T2d){1.0, tail};
  }
  heavy_now = predictors_mixture_heaviness(tail);
  own = at + predictors_adaptation_region_widening_OFFSETS;
  first = predictors_adaptation_levels_offset(memory, own, share, 0);
  second = predictors_adaptation_levels_offset(memory, own, share, 1);
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
T6d predictors_adaptation_destination_scaled(destination_Heading end, double shape, double factor, double tail) {
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

/* The weights of the terms for this person. */
void predictors_adaptation_time_left_solve(Vector memory, int64_t person, Vector prior, Vector weights) {
  Vector factors;
  double buffer_1[28];
  factors = (Vector){buffer_1, predictors_adaptation_time_left_SUMS};
  predictors_adaptation_time_left_factor(memory, person, prior, factors);
  for (int64_t i = 0; i < predictors_adaptation_time_left_TERMS; i++) {
    weights.p[i] = memory.p[person + predictors_adaptation_time_left_RESIDUALS + i];
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

/* What the time left is a sum of, in medians of the last durations; ``since`` s have passed. */
T7d predictors_adaptation_time_left_terms(time_left_Estimates estimates, time_left_Way way, time_left_Pace pace, double since, double median) {
  double mixed, predicted, share, slow, near;
  mixed = min_float(estimates.mixed / median, predictors_adaptation_time_left_LONGEST);
  predicted = min_float(estimates.predicted / median, predictors_adaptation_time_left_LONGEST);
  share = way.left / (way.left + way.done);
  slow = min_float(pace.slow_s / median, 1.0) / (since / median + predictors_adaptation_time_left_START);
  near = predictors_adaptation_time_left_NEAR * predictors_adaptation_time_left_NEAR / (predictors_adaptation_time_left_NEAR * predictors_adaptation_time_left_NEAR + share * share);
  return (T7d){mixed, predicted, 1.0, share, pace.of_peak * predicted, slow, near};
}

/* The time left in s and the spread of its logarithm, ``since`` s after the start; remembers both. */
T2d predictors_adaptation_time_left_stated(Vector memory, T3q place, T3d cursor, double since, double median, time_left_Estimates estimates, time_left_Way way, time_left_Pace pace) {
  int64_t person, intervals, at, moment;
  T7d known;
  double total, left, spread;
  person = place.f0;
  intervals = place.f1;
  at = place.f2;
  if (memory.p[at + predictors_adaptation_time_left_READY] == 0.0) {
    predictors_adaptation_time_left_solve(memory, person, (Vector){(double *)predictors_adaptation_time_left_prior_PRIOR, 35}, (Vector){memory.p + (at + predictors_adaptation_time_left_WEIGHTS), at + predictors_adaptation_time_left_MOMENTS - (at + predictors_adaptation_time_left_WEIGHTS)});
    memory.p[at + predictors_adaptation_time_left_READY] = 1.0;
  }
  known = predictors_adaptation_time_left_terms(estimates, way, pace, since, median);
  total = 0.0;
  for (int64_t i = 0; i < predictors_adaptation_time_left_TERMS; i++) {
    total += memory.p[at + predictors_adaptation_time_left_WEIGHTS + i] * ((const double *)&known)[i];
  }
  left = max_float(min_float(total, predictors_adaptation_time_left_FURTHEST) * median, predictors_adaptation_time_left_LEAST * min_float(estimates.predicted, median));
  spread = predictors_adaptation_arrival_intervals_spread(memory, intervals, since / (since + left));
  moment = predictors_adaptation_moments_new_moment(memory, at + predictors_adaptation_time_left_MOMENTS, cursor, predictors_adaptation_time_left_MOMENT, predictors_adaptation_time_left_MOST);
  if (moment >= 0) {
    memory.p[moment + predictors_adaptation_time_left_LEFT] = left;
    memory.p[moment + predictors_adaptation_time_left_SPREAD] = spread;
    for (int64_t i = 0; i < predictors_adaptation_time_left_TERMS; i++) {
      memory.p[moment + predictors_adaptation_time_left_FIRST_TERM + i] = ((const double *)&known)[i];
    }
  }
  return (T2d){left, spread};
}

/* The prediction as it is for this person; as it was where it claims too little or has no direction. */
T10d predictors_adaptation_correction_adapt(Vector memory, int64_t person, int64_t at, correction_Parts parts, scene_Scene scene, T10d answer, time_left_Pace pace) {
  double t, px, py, sxx, sxy, syy, predicted, phase, tail, ux, uy, wide, broad, now, x, y, reached, since, along, across, share, shift, widen, broaden, slow, left, shape, factor, spread;
  destination_Heading heading, own, end, elsewhere;
  stages_Moment m;
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
  heading = predictors_adaptation_correction_heading_of(memory, at, answer);
  ux = heading.ux;
  uy = heading.uy;
  wide = heading.wide;
  broad = heading.broad;
  memory.p[at + predictors_adaptation_correction_NOW + predictors_adaptation_mixed_region_CLAIMED] = 0.0;
  if (wide == 0.0) {
    return answer;
  }
  now = memory.p[at + predictors_adaptation_correction_T];
  x = memory.p[at + predictors_adaptation_correction_X];
  y = memory.p[at + predictors_adaptation_correction_Y];
  reached = hypot(x - memory.p[at + predictors_adaptation_correction_X0], y - memory.p[at + predictors_adaptation_correction_Y0]);
  since = now - memory.p[at + predictors_adaptation_correction_T0];
  T2d values_1 = predictors_adaptation_correction_ahead_of(memory, at, heading);
  along = values_1.f0;
  across = values_1.f1;
  share = since / (since + predicted);
  m = (stages_Moment){now, x, y, ux, uy, along, across, wide, broad, tail, predicted, reached};
  predictors_adaptation_correction_record(memory, at, share, m);
  if (memory.p[person + predictors_adaptation_correction_DISTANCES + predictors_adaptation_distances_COUNT] == 0.0) {
    first = (T6d){px, py, sxx, sxy, syy, tail};
    predictors_adaptation_correction_state(memory, person, at, scene, share, (T2_T6d_){first, first});
    return answer;
  }
  T4d values_2 = predictors_adaptation_stages_correct(memory, person, share, hypot(reached + along, across), along);
  shift = values_2.f0;
  widen = values_2.f1;
  broaden = values_2.f2;
  slow = values_2.f3;
  left = predictors_adaptation_durations_mix(memory, person + predictors_adaptation_correction_DURATIONS, since, predicted * slow);
  share = since / (since + left);
  shape = (sxy * (ux * ux - uy * uy) + (syy - sxx) * ux * uy) / (wide * broad);
  own = predictors_adaptation_correction_with_centre_ahead(memory, at, heading, along + shift * predictors_adaptation_correction_fading(share, predictors_adaptation_correction_BIAS_FADE), wide * widen);
  own = (destination_Heading){own.x, own.y, ux, uy, own.wide, broad * broaden, tail};
  T2_destination_Heading_ values_3 = predictors_adaptation_correction_adapted_end(memory, person, at, parts, scene, own, share);
  end = values_3.f0;
  elsewhere = values_3.f1;
  T2d values_4 = predictors_adaptation_region_widening_widen(memory, person + predictors_adaptation_correction_REGIONS, share, tail);
  factor = values_4.f0;
  tail = values_4.f1;
  region = predictors_adaptation_destination_scaled(end, shape, factor, tail);
  predictors_adaptation_correction_state(memory, person, at, scene, share, (T2_T6d_){region, predictors_adaptation_destination_scaled(elsewhere, shape, factor, tail)});
  px = region.f0;
  py = region.f1;
  sxx = region.f2;
  sxy = region.f3;
  syy = region.f4;
  T2d values_5 = predictors_adaptation_time_left_stated(memory, (T3q){person + predictors_adaptation_correction_TIME_LEFT, person + predictors_adaptation_correction_INTERVALS, at + predictors_adaptation_correction_TIMED}, (T3d){now, x, y}, since, memory.p[person + predictors_adaptation_correction_DURATIONS + predictors_adaptation_durations_MEDIAN], (time_left_Estimates){left, predicted}, (time_left_Way){reached, hypot(px - x, py - y)}, pace);
  left = values_5.f0;
  spread = values_5.f1;
  return (T10d){t, px, py, sxx, sxy, syy, left, phase, tail, spread};
}

/* How many settings, learned floats and states there are: without adaptation nothing is learned. */
T3q predictors_adaptation_predictor_sizes(Vector values) {
  int64_t learned;
  learned = values.p[predictors_adaptation_predictor_ADAPT] == 1.0 ? predictors_adaptation_correction_LEARNED : 0;
  return (T3q){predictors_adaptation_predictor_PERSON, learned, predictors_adaptation_predictor_LENGTH - predictors_adaptation_predictor_PERSON - learned};
}

/* Which parts of the adaptation answer. */
correction_Parts predictors_adaptation_predictor_parts_of(Vector memory) {
  return (correction_Parts){memory.p[predictors_adaptation_predictor_DISTANCES], memory.p[predictors_adaptation_predictor_PLACES], memory.p[predictors_adaptation_predictor_SEQUENCE]};
}

/* What the cursor moves in. */
scene_Scene predictors_adaptation_predictor_scene_of(Vector memory) {
  return (scene_Scene){memory.p[predictors_adaptation_predictor_KEY], memory.p[predictors_adaptation_predictor_ORIGIN_X], memory.p[predictors_adaptation_predictor_ORIGIN_Y]};
}

/* The movement has ended: learn from it. The next one is in the window that was entered last. */
void predictors_adaptation_predictor_conclude(Vector memory) {
  correction_Parts parts;
  scene_Scene scene;
  if (memory.p[predictors_adaptation_predictor_ADAPT] == 1.0) {
    parts = predictors_adaptation_predictor_parts_of(memory);
    scene = predictors_adaptation_predictor_scene_of(memory);
    predictors_adaptation_correction_conclude(memory, predictors_adaptation_predictor_PERSON, predictors_adaptation_predictor_MOVEMENT, memory.p[predictors_adaptation_predictor_SHORTEST_PX], parts, scene);
    double value_1 = memory.p[predictors_adaptation_predictor_NEXT];
    double value_2 = memory.p[predictors_adaptation_predictor_NEXT + 1];
    double value_3 = memory.p[predictors_adaptation_predictor_NEXT + 2];
    memory.p[predictors_adaptation_predictor_KEY] = value_1;
    memory.p[predictors_adaptation_predictor_ORIGIN_X] = value_2;
    memory.p[predictors_adaptation_predictor_ORIGIN_Y] = value_3;
  }
}

/* The learned predictor's answer, corrected for the person. */
T10d predictors_adaptation_predictor_adapt(Vector memory, T10d answer, time_left_Pace pace) {
  return predictors_adaptation_correction_adapt(memory, predictors_adaptation_predictor_PERSON, predictors_adaptation_predictor_MOVEMENT, predictors_adaptation_predictor_parts_of(memory), predictors_adaptation_predictor_scene_of(memory), answer, pace);
}

/* The hand's speed over its peak and how long it has been slow; ``own``: memory of `kinematic`. */
time_left_Pace predictors_adaptation_predictor_pace_of(Vector own, records_MotionRow m) {
  double peak, of_peak;
  peak = own.p[predictors_kinematic_features_TRACK + predictors_kinematic_track_PEAK];
  of_peak = peak > 0.0 ? hypot(m.vx, m.vy) / peak : 0.0;
  return (time_left_Pace){of_peak, m.t - ((predictors_movement_State *)(own.p))->t0 - own.p[predictors_kinematic_features_TRACK + predictors_kinematic_track_FAST_T]};
}

/* The learned predictor's step, then what is known of the person. */
T10d predictors_adaptation_predictor_step(Vector memory, T10d motion, Vector coefficients) {
  records_MotionRow m;
  Vector own;
  T10d answer;
  T3d start;
  m = records_MotionRow_of_T10d(motion);
  own = (Vector){memory.p + predictors_adaptation_predictor_OBSERVATION, predictors_adaptation_predictor_MOVEMENT - predictors_adaptation_predictor_OBSERVATION};
  answer = predictors_kinematic_predictor_step(own, motion, coefficients);
  if (memory.p[predictors_adaptation_predictor_ADAPT] == 0.0 || answer.f0 != answer.f0) {
    return answer;
  }
  if (m.start == 1.0) {
    predictors_adaptation_predictor_conclude(memory);
  }
  start = (T3d){((predictors_movement_State *)(own.p))->t0, ((predictors_movement_State *)(own.p))->x0, ((predictors_movement_State *)(own.p))->y0};
  predictors_adaptation_correction_follow(memory, predictors_adaptation_predictor_MOVEMENT, (T3d){m.t, m.x, m.y}, start);
  return predictors_adaptation_predictor_adapt(memory, answer, predictors_adaptation_predictor_pace_of(own, m));
}

/* The next movement is in this window or page; at once where none goes on. */
void predictors_adaptation_predictor_enter_scene(Vector memory, scene_Scene scene) {
  memory.p[predictors_adaptation_predictor_NEXT] = scene.key;
  memory.p[predictors_adaptation_predictor_NEXT + 1] = scene.x;
  memory.p[predictors_adaptation_predictor_NEXT + 2] = scene.y;
  if (memory.p[predictors_adaptation_predictor_ADAPT] == 0.0 || memory.p[predictors_adaptation_predictor_MOVEMENT + predictors_adaptation_correction_STARTED] == 0.0) {
    memory.p[predictors_adaptation_predictor_KEY] = scene.key;
    memory.p[predictors_adaptation_predictor_ORIGIN_X] = scene.x;
    memory.p[predictors_adaptation_predictor_ORIGIN_Y] = scene.y;
  }
}

/* Where the last movement to a place of this key ended, px from the origin; the origin if none did. */
T2d predictors_adaptation_predictor_last_end(Vector memory, int64_t known, double key) {
  int64_t number, place;
  for (int64_t age = 0; age < predictors_adaptation_places_MOVEMENTS; age++) {
    number = predictors_adaptation_places_visited(memory, known, age);
    place = known + predictors_adaptation_places_PLACES + predictors_adaptation_places_WIDTH * max_whole(number, 0);
    if (number >= 0 && memory.p[place + predictors_adaptation_places_KEY] == key) {
      return (T2d){memory.p[place + predictors_adaptation_places_X], memory.p[place + predictors_adaptation_places_Y]};
    }
  }
  return (T2d){0.0, 0.0};
}

/* Fill a row for each place of the window that the cursor is in, by their numbers; returns how many. */
int64_t predictors_adaptation_predictor_list_places(Vector memory, Table out) {
  correction_Parts parts;
  scene_Scene scene;
  int64_t known, going, count, place;
  bool waits;
  T2d start;
  double returns, x, y, before;
  if (memory.p[predictors_adaptation_predictor_ADAPT] == 0.0 || memory.p[predictors_adaptation_predictor_PLACES] == 0.0) {
    return 0;
  }
  parts = predictors_adaptation_predictor_parts_of(memory);
  scene = predictors_adaptation_predictor_scene_of(memory);
  known = predictors_adaptation_predictor_PERSON + predictors_adaptation_correction_KNOWN;
  going = predictors_adaptation_predictor_MOVEMENT + predictors_adaptation_correction_DESTINATION;
  waits = memory.p[going + predictors_adaptation_destination_READY] == 0.0;
  start = (T2d){memory.p[predictors_adaptation_predictor_MOVEMENT + predictors_adaptation_correction_X0] - scene.x, memory.p[predictors_adaptation_predictor_MOVEMENT + predictors_adaptation_correction_Y0] - scene.y};
  if (waits) {
    if (memory.p[predictors_adaptation_predictor_MOVEMENT + predictors_adaptation_correction_STARTED] == 0.0) {
      start = predictors_adaptation_predictor_last_end(memory, known, scene.key);
    }
    predictors_adaptation_correction_prepare(memory, predictors_adaptation_predictor_PERSON, going, parts, scene, start);
  }
  count = 0;
  returns = memory.p[going + predictors_adaptation_destination_RETURNS];
  for (int64_t i = 0, end_1 = (int64_t)memory.p[known + predictors_adaptation_places_COUNT]; i < end_1; i++) {
    place = known + predictors_adaptation_places_PLACES + predictors_adaptation_places_WIDTH * i;
    if (memory.p[place + predictors_adaptation_places_KEY] == scene.key) {
      x = memory.p[place + predictors_adaptation_places_X];
      y = memory.p[place + predictors_adaptation_places_Y];
      before = returns * memory.p[going + predictors_adaptation_destination_BEFORE + i];
      out.p[count * out.m + predictors_adaptation_predictor_X] = x + scene.x;
      out.p[count * out.m + predictors_adaptation_predictor_Y] = y + scene.y;
      out.p[count * out.m + predictors_adaptation_predictor_P] = waits ? before : memory.p[going + predictors_adaptation_destination_NOW + i];
      out.p[count * out.m + predictors_adaptation_predictor_BEFORE] = before;
      out.p[count * out.m + predictors_adaptation_predictor_VISITS] = memory.p[place + predictors_adaptation_places_WEIGHT];
      out.p[count * out.m + predictors_adaptation_predictor_NUMBER] = i;
      out.p[count * out.m + predictors_adaptation_predictor_SPREAD] = predictors_adaptation_destination_spread_of(memory, going, start, x, y);
      count += 1;
    }
  }
  if (waits) {
    fill((Vector){memory.p + going, going + predictors_adaptation_destination_STATES - going}, 0.0);
  }
  return count;
}

/* Write the mixture of places and elsewhere into the memory; returns where it stands, -1 for nowhere. */
int64_t predictors_adaptation_predictor_write_mixture(Vector memory) {
  int64_t now;
  now = predictors_adaptation_predictor_MOVEMENT + predictors_adaptation_correction_NOW;
  if (memory.p[predictors_adaptation_predictor_ADAPT] == 0.0 || memory.p[predictors_adaptation_predictor_PLACES] == 0.0 || memory.p[now + predictors_adaptation_mixed_region_CLAIMED] == 0.0) {
    return -1;
  }
  predictors_adaptation_correction_write_mixture(memory, predictors_adaptation_predictor_PERSON, predictors_adaptation_predictor_MOVEMENT, predictors_adaptation_predictor_scene_of(memory), now + predictors_adaptation_mixed_region_ASKED);
  return now + predictors_adaptation_mixed_region_ASKED;
}

void loop__predictors_adaptation_predictor_conclude__records_row_at__predictors_adaptation_predictor_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out, Vector shared_0) {
  T10d answer;
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      predictors_adaptation_predictor_conclude(memory);
      fill((Vector){memory.p + first, memory.n - first}, 0.0);
    }
    answer = predictors_adaptation_predictor_step(memory, records_row_at(rows, i), shared_0);
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
    answer = predictors_adaptation_predictor_step(other, answer, shared_0);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    }
  }
  return answer;
}

bool follow__predictors_adaptation_predictor_step(Vector memory, T10d row, Vector shared_0) {
  double t;
  t = predictors_adaptation_predictor_step(memory, row, shared_0).f0;
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
      answer = predictors_adaptation_predictor_step(other, between, shared_0);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_adaptation_predictor_step(other, answer, shared_0);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
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
      answer = predictors_adaptation_predictor_step(other, between, shared_0);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
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
    answer = predictors_adaptation_predictor_step(other, answer, shared_0);
    if (answer.f0 != answer.f0) {
      memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
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
      answer = predictors_adaptation_predictor_step(other, between, shared_0);
    }
  }
  if (answer.f0 != answer.f0) {
    memmove((Vector){memory.p, memory.n}.p, kept.p, sizeof(double) * (Vector){memory.p, memory.n}.n);
    memmove((Vector){other.p, other.n}.p, other_kept.p, sizeof(double) * (Vector){other.p, other.n}.n);
  }
  return answer;
}
