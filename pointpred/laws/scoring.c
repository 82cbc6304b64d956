/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const int64_t scoring_target_choice_HIT = 3;
static const int64_t scoring_target_choice_LEAD_CLICK = 5;
static const int64_t scoring_target_choice_LEAD_ENTRY = 4;
static const int64_t scoring_target_choice_LOSS = 1;
static const int64_t scoring_target_choice_NEAREST_RIGHT = 3;
static const int64_t scoring_target_choice_PROPOSED = 0;
static const int64_t scoring_target_choice_PROPOSED_RIGHT = 1;
static const int64_t scoring_target_choice_RETRACTED = 2;
static const int64_t scoring_target_choice_RIGHT = 0;
static const double scoring_target_choice_SMALLEST = 1e-12;
static const int64_t scoring_target_choice_SURENESS = 2;
static const int64_t scoring_trials_ARRIVAL = 4;
static const double scoring_trials_ARRIVAL_PX = 8.0;
static const double scoring_trials_ARRIVAL_SHARE = 0.03;
static const int64_t scoring_trials_ARRIVED = 6;
static const double scoring_trials_ARRIVING = 0.95;
static const int64_t scoring_trials_BACKWARD = 4;
static const double scoring_trials_DIP = 2.0;
static const double scoring_trials_DISTANCE_PX = 80.0;
static const int64_t scoring_trials_EMPTY = 1;
static const int64_t scoring_trials_GOOD = 0;
static const int64_t scoring_trials_INSTANT = 7;
static const double scoring_trials_LEAVING = 0.05;
static const int64_t scoring_trials_NEVER_LEFT = 5;
static const int64_t scoring_trials_ONE_SAMPLE = 2;
static const int64_t scoring_trials_ONSET = 2;
static const double scoring_trials_ONSET_PX = 3.0;
static const double scoring_trials_PATH_RATIO = 1.5;
static const double scoring_trials_PEAK_RATIO = 5.0;
static const int64_t scoring_trials_ROW = 1;
static const double scoring_trials_STANDSTILL_S = 0.1;
static const int64_t scoring_trials_STOP = 3;
static const int64_t scoring_trials_UNUSABLE = 3;
static const int64_t scoring_trials_VERDICT = 0;
static const double targets_choice_law_KEEP = 0.4;
static const int64_t targets_ledger_FIELDS = 4;

/* The shares of all targets after each event, in a row of ``shares``. */
void scoring_target_choice_weigh(Table events, Table answers, Table table, targets_posterior_Coefficients * coefficients, double elsewhere, Table shares) {
  targets_cursor_State * memory;
  double buffer_1[15];
  memset(buffer_1, 0, sizeof buffer_1);
  memory = (targets_cursor_State *)((Vector){buffer_1, 15}.p);
  for (int64_t i = 0; i < events.n; i++) {
    targets_cursor_follow(memory, events.p[i * events.m + 0], events.p[i * events.m + 1], events.p[i * events.m + 2], 0.0);
    targets_posterior_scores(memory, table, records_row_at(answers, i), coefficients, elsewhere, (Vector){shares.p + i * shares.m, shares.m});
    targets_posterior_normalise((Vector){shares.p + i * shares.m, shares.m});
  }
}

/* The target whose centre is nearest. */
int64_t scoring_target_choice_nearest(Table table, double x, double y) {
  int64_t best;
  double least, far;
  best = 0;
  least = INFINITY;
  for (int64_t i = 0; i < table.n; i++) {
    far = square(table.p[i * table.m + 0] - x) + square(table.p[i * table.m + 1] - y);
    if (far < least) {
      best = i;
      least = far;
    }
  }
  return best;
}

/* Read the shares at fractions of the time from the first event to the arrival. */
void scoring_target_choice_read(Table events, Table table, Table shares, int64_t arrival, int64_t right, Vector fractions, Table out) {
  int64_t i, best;
  double until;
  i = 0;
  for (int64_t k = 0; k < fractions.n; k++) {
    until = events.p[0 * events.m + 0] + fractions.p[k] * (events.p[arrival * events.m + 0] - events.p[0 * events.m + 0]);
    while (i + 1 < events.n && events.p[(i + 1) * events.m + 0] <= until) {
      i += 1;
    }
    best = targets_decision_likeliest((Vector){shares.p + i * shares.m, shares.m}, table.n);
    out.p[k * out.m + scoring_target_choice_RIGHT] = best == right ? 1.0 : 0.0;
    out.p[k * out.m + scoring_target_choice_LOSS] = -log(max_float(shares.p[i * shares.m + right], scoring_target_choice_SMALLEST));
    out.p[k * out.m + scoring_target_choice_SURENESS] = shares.p[i * shares.m + best];
    out.p[k * out.m + scoring_target_choice_NEAREST_RIGHT] = scoring_target_choice_nearest(table, events.p[i * events.m + 1], events.p[i * events.m + 2]) == right ? 1.0 : 0.0;
  }
}

/* Decide after each event at one precision, and the account of the movement by the laws of the ledger. */
void scoring_target_choice_account(Table events, Table answers, Table table, Table shares, int64_t right, double ask, double least_s, double least_px, Vector out) {
  targets_cursor_State * memory;
  targets_ledger_State * movement;
  Table rows;
  int64_t standing, chosen;
  double t, x, y, made, lead_entry_s, lead_click_s;
  bool inside;
  T4d bounds;
  double buffer_1[15];
  double buffer_2[8];
  double buffer_3[8];
  memset(buffer_1, 0, sizeof buffer_1);
  memory = (targets_cursor_State *)((Vector){buffer_1, 15}.p);
  memset(buffer_2, 0, sizeof buffer_2);
  movement = (targets_ledger_State *)((Vector){buffer_2, 8}.p);
  memset(buffer_3, 0, sizeof buffer_3);
  rows = (Table){buffer_3, 2, targets_ledger_FIELDS};
  targets_ledger_begin(movement, rows);
  standing = targets_rectangles_NOBODY;
  for (int64_t i = 0; i < events.n; i++) {
    t = events.p[i * events.m + 0];
    x = events.p[i * events.m + 1];
    y = events.p[i * events.m + 2];
    targets_cursor_follow(memory, t, x, y, 0.0);
    inside = fabs(x - table.p[right * table.m + 0]) <= 0.5 * table.p[right * table.m + 2];
    if (inside && fabs(y - table.p[right * table.m + 1]) <= 0.5 * table.p[right * table.m + 3]) {
      targets_ledger_enter(movement, rows, t, 0);
    }
    bounds = (T4d){ask, targets_choice_law_KEEP * ask, least_s, least_px};
    chosen = targets_decision_decide(memory, table, (Vector){shares.p + i * shares.m, shares.m}, standing, answers.p[i * answers.m + 6], bounds);
    if (chosen != standing) {
      if (standing != targets_rectangles_NOBODY) {
        targets_ledger_withdraw(movement, t, standing == right ? 0 : 1, false);
      }
      if (chosen != targets_rectangles_NOBODY) {
        targets_ledger_propose(movement, rows, t, chosen == right ? 0 : 1);
      }
      standing = chosen;
    }
  }
  T3d values_4 = targets_ledger_close(movement, rows, events.p[(events.n - 1) * events.m + 0], 0);
  made = values_4.f0;
  lead_entry_s = values_4.f1;
  lead_click_s = values_4.f2;
  out.p[scoring_target_choice_PROPOSED] = movement->proposed;
  out.p[scoring_target_choice_PROPOSED_RIGHT] = made;
  out.p[scoring_target_choice_RETRACTED] = movement->retracted;
  out.p[scoring_target_choice_HIT] = lead_click_s == lead_click_s ? 1.0 : 0.0;
  out.p[scoring_target_choice_LEAD_ENTRY] = lead_entry_s;
  out.p[scoring_target_choice_LEAD_CLICK] = lead_click_s;
}

/* The first reason not to score a trial as it was recorded, and its row. */
T2q scoring_trials_fault(Table rows, int64_t first, int64_t stop) {
  if (stop == first) {
    return (T2q){scoring_trials_EMPTY, first};
  }
  for (int64_t i = first; i < stop; i++) {
    if (records_fault_of_event(records_EventRow_of_T6d(records_event_at(rows, i))) != records_FINE) {
      return (T2q){scoring_trials_UNUSABLE, i};
    }
    if (i > first && rows.p[i * rows.m + 0] < rows.p[(i - 1) * rows.m + 0]) {
      return (T2q){scoring_trials_BACKWARD, i};
    }
  }
  if (stop - first == 1) {
    return (T2q){scoring_trials_ONE_SAMPLE, first};
  }
  return (T2q){scoring_trials_GOOD, first};
}

/* The row after the selecting click: the last press of the primary button away from the start. */
int64_t scoring_trials_selection(Table rows, int64_t first, int64_t stop) {
  bool pressed;
  for (int64_t i = stop - 1; i > first; i--) {
    pressed = ((int64_t)rows.p[i * rows.m + 5] & 1) == 1 && ((int64_t)rows.p[(i - 1) * rows.m + 5] & 1) == 0;
    if (pressed && hypot(rows.p[i * rows.m + 1] - rows.p[first * rows.m + 1], rows.p[i * rows.m + 2] - rows.p[first * rows.m + 2]) > scoring_trials_ONSET_PX) {
      return i + 1;
    }
  }
  return stop;
}

/* The last row within 3 px of the trial's first position. */
int64_t scoring_trials_departure(Table rows, int64_t first, int64_t stop) {
  for (int64_t i = stop - 1; i > first; i--) {
    if (hypot(rows.p[i * rows.m + 1] - rows.p[first * rows.m + 1], rows.p[i * rows.m + 2] - rows.p[first * rows.m + 2]) <= scoring_trials_ONSET_PX) {
      return i;
    }
  }
  return first;
}

/* The first row from which on the cursor stays near the endpoint. */
int64_t scoring_trials_settling(Table rows, int64_t onset, int64_t stop) {
  double x, y, near;
  x = rows.p[(stop - 1) * rows.m + 1];
  y = rows.p[(stop - 1) * rows.m + 2];
  near = max_float(scoring_trials_ARRIVAL_PX, scoring_trials_ARRIVAL_SHARE * hypot(x - rows.p[onset * rows.m + 1], y - rows.p[onset * rows.m + 2]));
  for (int64_t i = stop - 1, end_1 = onset - 1; i > end_1; i--) {
    if (hypot(rows.p[i * rows.m + 1] - x, rows.p[i * rows.m + 2] - y) > near) {
      return i + 1;
    }
  }
  return onset;
}

/* One row of ``out`` for each trial. */
void scoring_trials_cut(Table rows, WholeVector offsets, WholeTable out) {
  int64_t first, stop, verdict, row, onset, arrival;
  for (int64_t k = 0, end_1 = offsets.n - 1; k < end_1; k++) {
    first = offsets.p[k];
    stop = offsets.p[k + 1];
    T2q values_2 = scoring_trials_fault(rows, first, stop);
    verdict = values_2.f0;
    row = values_2.f1;
    onset = first;
    arrival = first;
    if (verdict == scoring_trials_GOOD) {
      stop = scoring_trials_selection(rows, first, stop);
      onset = scoring_trials_departure(rows, first, stop);
      arrival = scoring_trials_settling(rows, onset, stop);
      row = onset;
      if (onset == stop - 1) {
        verdict = scoring_trials_NEVER_LEFT;
      } else if (arrival == onset) {
        verdict = scoring_trials_ARRIVED;
      } else if (rows.p[arrival * rows.m + 0] == rows.p[onset * rows.m + 0]) {
        verdict = scoring_trials_INSTANT;
      }
    }
    out.p[k * out.m + scoring_trials_VERDICT] = verdict;
    out.p[k * out.m + scoring_trials_ROW] = row;
    out.p[k * out.m + scoring_trials_ONSET] = onset;
    out.p[k * out.m + scoring_trials_STOP] = stop;
    out.p[k * out.m + scoring_trials_ARRIVAL] = arrival;
  }
}

/* Whether the trial in rows ``first`` up to ``stop`` goes far enough, straight enough, without a stop. */
bool scoring_trials_straight_through(Table table, int64_t first, int64_t stop) {
  double x, y, along_x, along_y, square_, path, step, progress;
  int64_t moved;
  x = table.p[first * table.m + 1];
  y = table.p[first * table.m + 2];
  along_x = table.p[(stop - 1) * table.m + 1] - x;
  along_y = table.p[(stop - 1) * table.m + 2] - y;
  square_ = along_x * along_x + along_y * along_y;
  path = 0.0;
  moved = first;
  for (int64_t i = first + 1; i < stop; i++) {
    step = hypot(table.p[i * table.m + 1] - table.p[(i - 1) * table.m + 1], table.p[i * table.m + 2] - table.p[(i - 1) * table.m + 2]);
    if (step > 0.0) {
      progress = ((table.p[moved * table.m + 1] - x) * along_x + (table.p[moved * table.m + 2] - y) * along_y) / square_;
      if ((scoring_trials_LEAVING < progress && progress < scoring_trials_ARRIVING) && table.p[i * table.m + 0] - table.p[moved * table.m + 0] > scoring_trials_STANDSTILL_S) {
        return false;
      }
      moved = i;
    }
    path += step;
  }
  return square_ >= square(scoring_trials_DISTANCE_PX) && path <= scoring_trials_PATH_RATIO * sqrt(square_);
}

/* The same for each trial. */
void scoring_trials_judge(Table table, WholeVector offsets, FlagVector out) {
  for (int64_t k = 0; k < out.n; k++) {
    out.p[k] = scoring_trials_straight_through(table, offsets.p[k], offsets.p[k + 1]);
  }
}

/* Whether the second highest speed peak of these rows exceeds a fifth of the highest. */
bool scoring_trials_divided(Table motions, int64_t first, int64_t stop) {
  double highest, second, extreme, speed;
  bool rising;
  highest = 0.0;
  second = 0.0;
  rising = true;
  extreme = 0.0;
  for (int64_t i = first; i < stop; i++) {
    speed = hypot(motions.p[i * motions.m + 3], motions.p[i * motions.m + 4]);
    if ((rising && speed >= extreme) || (!rising && speed <= extreme)) {
      extreme = speed;
    } else if (!rising && speed > scoring_trials_DIP * extreme) {
      rising = true;
      extreme = speed;
    } else if (rising && scoring_trials_DIP * speed < extreme) {
      double value_1 = max_float(highest, extreme);
      double value_2 = max_float(second, min_float(highest, extreme));
      highest = value_1;
      second = value_2;
      rising = false;
      extreme = speed;
    }
  }
  if (rising) {
    double value_3 = max_float(highest, extreme);
    double value_4 = max_float(second, min_float(highest, extreme));
    highest = value_3;
    second = value_4;
  }
  return scoring_trials_PEAK_RATIO * second > highest;
}

/* The same for each trial. */
void scoring_trials_divide(Table motions, WholeVector offsets, FlagVector out) {
  for (int64_t k = 0, end_1 = offsets.n - 1; k < end_1; k++) {
    out.p[k] = scoring_trials_divided(motions, offsets.p[k], offsets.p[k + 1]);
  }
}
