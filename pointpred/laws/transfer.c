/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const double records_LARGEST = 1000000000.0;
static const double records_LATEST_S = 100000000000.0;
static const double records_METRES_PER_INCH = 0.0254;
static const double records_ROUNDING_S = 1e-06;
static const int64_t transfer_assistance_ASSISTED = 2;
static const int64_t transfer_assistance_GUARDED = 5;
static const int64_t transfer_assistance_OWED = 22;
static const int64_t transfer_assistance_RHO = 0;
static const int64_t transfer_assistance_SIDEWAYS = 2;
static const int64_t transfer_assistance_STRENGTH = 1;
static const int64_t transfer_assistance_UNCERTAIN = 3;
static const int64_t transfer_assistance_UNCLAIMED = 4;
static const int64_t transfer_bands_BANDS = 20;
static const double transfer_functions_ARCTAN = 3.0;
static const double transfer_functions_BOUNDED = 5.0;
static const int64_t transfer_functions_BOUNDED_COEFFICIENTS = 5;
static const int64_t transfer_functions_COEFFICIENTS_MOST = 7;
static const double transfer_functions_CONSTANT = 1.0;
static const int64_t transfer_functions_GAIN_MAX = 2;
static const int64_t transfer_functions_GAIN_MIN = 1;
static const int64_t transfer_functions_HIGH = 7;
static const int64_t transfer_functions_LOW = 6;
static const double transfer_functions_POLYNOMIAL = 4.0;
static const double transfer_functions_SIGMOID = 2.0;
static const int64_t transfer_functions_SLOTS = 8;
static const int64_t transfer_functions_SPEED_HIGH = 4;
static const int64_t transfer_functions_SPEED_LOW = 3;
static const int64_t transfer_identification_BANDS = 76;
static const int64_t transfer_identification_BAND_WIDTH = 8;
static const int64_t transfer_identification_DURATION = 252;
static const int64_t transfer_identification_END = 267;
static const int64_t transfer_identification_FORGETTING = 6;
static const int64_t transfer_identification_GAP_S = 5;
static const double transfer_identification_LEFT_OUT = 1.0;
static const int64_t transfer_identification_METRES_PER_COUNT = 2;
static const int64_t transfer_identification_METRES_PER_PX = 3;
static const int64_t transfer_identification_N = 0;
static const int64_t transfer_identification_NUMBERS = 13;
static const int64_t transfer_identification_PATH = 251;
static const int64_t transfer_identification_POWER = 1;
static const double transfer_identification_REFUSED = -1.0;
static const int64_t transfer_identification_ROW = 236;
static const int64_t transfer_identification_ROW_X = 253;
static const int64_t transfer_identification_ROW_Y = 260;
static const int64_t transfer_identification_SKIPPED = 9;
static const int64_t transfer_identification_SPEED_LOW = 7;
static const int64_t transfer_identification_STARTED = 243;
static const int64_t transfer_identification_START_X = 249;
static const int64_t transfer_identification_START_Y = 250;
static const int64_t transfer_identification_SUMS = 10;
static const int64_t transfer_identification_T = 244;
static const double transfer_identification_TAKEN = 0.0;
static const int64_t transfer_identification_WAITING_X = 247;
static const int64_t transfer_identification_WAITING_Y = 248;
static const int64_t transfer_identification_WINDOW_S = 4;
static const int64_t transfer_identification_X = 245;
static const int64_t transfer_identification_Y = 246;
static const int64_t transfer_pixels_AT = 0;
static const int64_t transfer_pixels_CARRY = 15;
static const int64_t transfer_pixels_FUNCTION = 4;
static const int64_t transfer_pixels_GAIN = 14;
static const int64_t transfer_pixels_GAP_S = 3;
static const int64_t transfer_pixels_METRES_PER_COUNT = 1;
static const int64_t transfer_pixels_PERIOD_S = 2;
static const int64_t transfer_pixels_PX_PER_COUNT = 0;
static const int64_t transfer_pixels_STARTED = 12;
static const int64_t transfer_pixels_T = 13;

/* PTF(V) / V, the control-display gain; at V = 0 its limit (infinite for a polynomial with c_0). */
double transfer_functions_gain(Vector memory, int64_t at, double speed) {
  double share, value, within;
  if (memory.p[at] == transfer_functions_CONSTANT) {
    return memory.p[at + 1];
  }
  if (memory.p[at] == transfer_functions_SIGMOID) {
    share = (speed - memory.p[at + transfer_functions_SPEED_LOW]) / (memory.p[at + transfer_functions_SPEED_HIGH] - memory.p[at + transfer_functions_SPEED_LOW]);
    share = min_float(max_float(share, 0.0), 1.0);
    return memory.p[at + transfer_functions_GAIN_MIN] + share * (memory.p[at + transfer_functions_GAIN_MAX] - memory.p[at + transfer_functions_GAIN_MIN]);
  }
  if (memory.p[at] == transfer_functions_ARCTAN) {
    return speed > 0.0 ? atan(speed) / speed : 1.0;
  }
  value = 0.0;
  if (memory.p[at] == transfer_functions_BOUNDED) {
    within = min_float(max_float(speed, memory.p[at + transfer_functions_LOW]), memory.p[at + transfer_functions_HIGH]);
    for (int64_t i = 0; i < transfer_functions_BOUNDED_COEFFICIENTS; i++) {
      value = value * within + memory.p[at + transfer_functions_BOUNDED_COEFFICIENTS - i];
    }
    return value;
  }
  for (int64_t i = 0; i < (transfer_functions_COEFFICIENTS_MOST - 1); i++) {
    value = value * speed + memory.p[at + transfer_functions_COEFFICIENTS_MOST - i];
  }
  if (memory.p[at + 1] == 0.0) {
    return value;
  }
  return speed > 0.0 ? value + memory.p[at + 1] / speed : copysign(INFINITY, memory.p[at + 1]);
}

/* PTF(V): the speed of the cursor in m/s on the screen for a hand's speed >= 0 in m/s. */
double transfer_functions_cursor_speed(Vector memory, int64_t at, double speed) {
  double value;
  if (memory.p[at] == transfer_functions_POLYNOMIAL) {
    value = 0.0;
    for (int64_t i = 0; i < transfer_functions_COEFFICIENTS_MOST; i++) {
      value = value * speed + memory.p[at + transfer_functions_COEFFICIENTS_MOST - i];
    }
    return value;
  }
  if (memory.p[at] == transfer_functions_ARCTAN) {
    return atan(speed);
  }
  return transfer_functions_gain(memory, at, speed) * speed;
}

/* The fraction of the offset (T_hat - x, T_hat_y - y) by which the cursor is pulled in ``dt`` s. */
double transfer_assistance_pull(double rho, double strength, double dt, double own_px, double off_x, double off_y) {
  double length, share;
  length = hypot(off_x, off_y);
  if (!(0.0 < length && length < INFINITY)) {
    return 0.0;
  }
  share = -expm1(-rho * dt);
  return strength < INFINITY ? min_float(share, strength * own_px / length) : share;
}

/* Whole pixels of one axis; the remainder stays in ``memory[at]`` until the direction reverses. */
double transfer_pixels_carry(Vector memory, int64_t at, double moved_px) {
  double rest, whole;
  rest = memory.p[at] * moved_px >= 0.0 ? memory.p[at] : 0.0;
  whole = (double)(int64_t)trunc(rest + moved_px);
  memory.p[at] = rest + moved_px - whole;
  return whole;
}

/* A row of a table of reports with the way to an endpoint. */
T5d transfer_assistance_offset_report_at(Table rows, int64_t i) {
  Vector r;
  r = (Vector){rows.p + i * rows.m, rows.m};
  return (T5d){r.p[0], r.p[1], r.p[2], r.p[3], r.p[4]};
}

/* A row of a table of reports with the way to an endpoint and its covariance. */
T8d transfer_assistance_guided_report_at(Table rows, int64_t i) {
  Vector r;
  r = (Vector){rows.p + i * rows.m, rows.m};
  return (T8d){r.p[0], r.p[1], r.p[2], r.p[3], r.p[4], r.p[5], r.p[6], r.p[7]};
}

/* Whether a report is valid, and the time in s of its counts. */
Tbd transfer_pixels_accept(Vector memory, int64_t at, double t, double dx, double dy) {
  bool fine;
  fine = fabs(t) <= records_LATEST_S && fabs(dx) <= records_LARGEST && fabs(dy) <= records_LARGEST;
  if (memory.p[at + transfer_pixels_STARTED] == 0.0) {
    return (Tbd){fine, memory.p[at + transfer_pixels_PERIOD_S]};
  }
  return (Tbd){fine && t >= memory.p[at + transfer_pixels_T], min_float(t - memory.p[at + transfer_pixels_T], memory.p[at + transfer_pixels_GAP_S])};
}

/* Process an accepted report and return the pixels per count; without elapsed time, by the last gain. */
double transfer_pixels_turn(Vector memory, int64_t at, double t, double dt, double dx, double dy) {
  double speed;
  if (dt > 0.0) {
    speed = hypot(dx, dy) * memory.p[at + transfer_pixels_METRES_PER_COUNT] / dt;
    memory.p[at + transfer_pixels_GAIN] = transfer_functions_gain(memory, at + transfer_pixels_FUNCTION, speed);
  }
  memory.p[at + transfer_pixels_STARTED] = 1.0;
  memory.p[at + transfer_pixels_T] = t;
  return memory.p[at + transfer_pixels_GAIN] * memory.p[at + transfer_pixels_PX_PER_COUNT];
}

/* One ``OffsetReport``: (t, dx in px, dy in px); NaN for a report that is refused. */
T3d transfer_assistance_assisted_step(Vector memory, T5d report) {
  double t, dx, dy, off_x, off_y, dt, scale, x, y, share;
  bool usable;
  int64_t carried;
  assistance_OffsetReport values_1 = assistance_OffsetReport_of_T5d(report);
  t = values_1.t;
  dx = values_1.dx;
  dy = values_1.dy;
  off_x = values_1.off_x;
  off_y = values_1.off_y;
  Tbd values_2 = transfer_pixels_accept(memory, transfer_assistance_ASSISTED, t, dx, dy);
  usable = values_2.f0;
  dt = values_2.f1;
  if (!usable || fabs(off_x) > records_LARGEST || fabs(off_y) > records_LARGEST) {
    return (T3d){NAN, NAN, NAN};
  }
  scale = transfer_pixels_turn(memory, transfer_assistance_ASSISTED, t, dt, dx, dy);
  x = scale * dx;
  y = scale * dy;
  share = transfer_assistance_pull(memory.p[transfer_assistance_RHO], memory.p[transfer_assistance_STRENGTH], dt, hypot(x, y), off_x, off_y);
  if (share > 0.0) {
    x += share * off_x;
    y += share * off_y;
  }
  carried = transfer_assistance_ASSISTED + transfer_pixels_CARRY;
  return (T3d){t, transfer_pixels_carry(memory, carried, x), transfer_pixels_carry(memory, carried + 1, y)};
}

/* The endpoint's standard deviation along the longest axis of its region, as a share of the way to it. */
double transfer_assistance_spread(double way_px, double sxx, double sxy, double syy, double unclaimed) {
  if (sxx != sxx) {
    return unclaimed;
  }
  if (!(fabs(sxx) < INFINITY && fabs(sxy) < INFINITY && fabs(syy) < INFINITY)) {
    return INFINITY;
  }
  return sqrt(max_float(0.5 * (sxx + syy) + hypot(0.5 * (sxx - syy), sxy), 0.0)) / way_px;
}

/* The px added to the hand's ``own`` (x, y) in ``dt`` s; the guard's parameters lie at ``at``. */
T2d transfer_assistance_guide(Vector memory, int64_t at, double dt, T2d own, T5d way) {
  double own_x, own_y, off_x, off_y, sxx, sxy, syy, moved, distance, trust, to_x, to_y, ahead, beside, share, longest, widest, along, across;
  own_x = own.f0;
  own_y = own.f1;
  off_x = way.f0;
  off_y = way.f1;
  sxx = way.f2;
  sxy = way.f3;
  syy = way.f4;
  moved = hypot(own_x, own_y);
  distance = hypot(off_x, off_y);
  if (!((0.0 < moved && moved < INFINITY) && (0.0 < distance && distance < INFINITY))) {
    return (T2d){0.0, 0.0};
  }
  trust = 1.0 - transfer_assistance_spread(distance, sxx, sxy, syy, memory.p[at + transfer_assistance_UNCLAIMED]) / memory.p[at + transfer_assistance_UNCERTAIN];
  to_x = own_x / moved;
  to_y = own_y / moved;
  ahead = off_x * to_x + off_y * to_y;
  beside = off_y * to_x - off_x * to_y;
  if (!(trust > 0.0 && ahead > 0.0)) {
    return (T2d){0.0, 0.0};
  }
  share = -expm1(-memory.p[at + transfer_assistance_RHO] * dt);
  longest = memory.p[at + transfer_assistance_STRENGTH] * moved;
  widest = memory.p[at + transfer_assistance_SIDEWAYS] * longest;
  along = trust * min_float(min_float(share * ahead, longest), max_float(ahead - moved, 0.0));
  across = trust * min_float(max_float(share * beside * (ahead / distance), -widest), widest);
  return (T2d){along * to_x - across * to_y, along * to_y + across * to_x};
}

/* ``guide`` in whole pixels, with the fractions carried in ``memory[owed]`` and the next place. */
T2d transfer_assistance_add(Vector memory, int64_t at, int64_t owed, double dt, T2d own, T5d way) {
  double x, y, whole_x, whole_y;
  T2d values_1 = transfer_assistance_guide(memory, at, dt, own, way);
  x = values_1.f0;
  y = values_1.f1;
  whole_x = transfer_pixels_carry(memory, owed, x);
  whole_y = transfer_pixels_carry(memory, owed + 1, y);
  if (whole_x * own.f0 + whole_y * own.f1 < 0.0) {
    memory.p[owed + 1] = 0.0;
    memory.p[owed] = memory.p[owed + 1];
    return (T2d){0.0, 0.0};
  }
  return (T2d){whole_x, whole_y};
}

/* One ``GuidedReport``: (t, dx px, dy px, and the added part of these); NaN if refused. */
T5d transfer_assistance_guarded_step(Vector memory, T8d report) {
  double t, dx, dy, off_x, off_y, sxx, sxy, syy, dt, scale, own_x, own_y, x, y, add_x, add_y;
  bool usable;
  int64_t carried;
  assistance_GuidedReport values_1 = assistance_GuidedReport_of_T8d(report);
  t = values_1.t;
  dx = values_1.dx;
  dy = values_1.dy;
  off_x = values_1.off_x;
  off_y = values_1.off_y;
  sxx = values_1.sxx;
  sxy = values_1.sxy;
  syy = values_1.syy;
  Tbd values_2 = transfer_pixels_accept(memory, transfer_assistance_GUARDED, t, dx, dy);
  usable = values_2.f0;
  dt = values_2.f1;
  if (!usable || fabs(off_x) > records_LARGEST || fabs(off_y) > records_LARGEST) {
    return (T5d){NAN, NAN, NAN, NAN, NAN};
  }
  scale = transfer_pixels_turn(memory, transfer_assistance_GUARDED, t, dt, dx, dy);
  own_x = scale * dx;
  own_y = scale * dy;
  carried = transfer_assistance_GUARDED + transfer_pixels_CARRY;
  x = transfer_pixels_carry(memory, carried, own_x);
  y = transfer_pixels_carry(memory, carried + 1, own_y);
  T2d values_3 = transfer_assistance_add(memory, 0, transfer_assistance_OWED, dt, (T2d){own_x, own_y}, (T5d){off_x, off_y, sxx, sxy, syy});
  add_x = values_3.f0;
  add_y = values_3.f1;
  return (T5d){t, x + add_x, y + add_y, add_x, add_y};
}

/* Floats of all bands: for each the sum of w_1 y and those of w_1 w_i, w_1 the regressor of c_1. */
int64_t transfer_bands_states(int64_t n) {
  return transfer_bands_BANDS * (1 + n);
}

/* Add output = row . c to a band, a real number; outside the bands nothing happens. */
void transfer_bands_learn(Vector memory, int64_t at, bands_Model model, double band, int64_t row, double output) {
  int64_t n, linear, place;
  double forgetting, reference;
  if (!(0.0 <= band && band < transfer_bands_BANDS)) {
    return;
  }
  n = model.n;
  linear = model.linear;
  forgetting = model.forgetting;
  place = at + (int64_t)band * (1 + n);
  reference = memory.p[row + linear];
  memory.p[place] = forgetting * memory.p[place] + reference * output;
  for (int64_t j = 0; j < n; j++) {
    memory.p[place + 1 + j] = forgetting * memory.p[place + 1 + j] + reference * memory.p[row + j];
  }
}

/* Evaluate one of the two laws at many speeds. */
void transfer_functions_evaluate(Vector memory, Vector speeds, bool wanted_gain, Vector out) {
  for (int64_t i = 0; i < speeds.n; i++) {
    out.p[i] = wanted_gain ? transfer_functions_gain(memory, 0, speeds.p[i]) : transfer_functions_cursor_speed(memory, 0, speeds.p[i]);
  }
}

/* Add output = row . c at a speed of the hand to the recursion and to its band. */
void transfer_identification_learn(Vector memory, int64_t row, double output, double speed) {
  int64_t n;
  least_squares_Regression regression;
  double band;
  bands_Model model;
  n = (int64_t)memory.p[transfer_identification_N];
  regression = regression_least_squares_parts((Vector){memory.p + transfer_identification_NUMBERS, transfer_identification_BANDS - transfer_identification_NUMBERS}, n);
  for (int64_t j = 0; j < n; j++) {
    regression.w.p[j] = memory.p[row + j];
  }
  regression_least_squares_advance((regression_least_squares_Sums *)(memory.p + transfer_identification_SUMS), regression, memory.p[transfer_identification_FORGETTING], output);
  band = (speed - memory.p[transfer_identification_SPEED_LOW]) / memory.p[transfer_identification_BAND_WIDTH];
  model = (bands_Model){n, 1 - (int64_t)memory.p[transfer_identification_POWER], memory.p[transfer_identification_FORGETTING]};
  transfer_bands_learn(memory, transfer_identification_BANDS, model, band, row, output);
}

/* Add one pair of speeds in m/s, as in section 2.5.1: the regressor consists of powers of V. */
void transfer_identification_learn_speeds(Vector memory, double speed, double cursor_speed) {
  double value;
  value = memory.p[transfer_identification_POWER] == 0.0 ? 1.0 : speed;
  for (int64_t j = 0, end_1 = (int64_t)memory.p[transfer_identification_N]; j < end_1; j++) {
    memory.p[transfer_identification_ROW + j] = value;
    value *= speed;
  }
  transfer_identification_learn(memory, transfer_identification_ROW, cursor_speed, speed);
}

/* Start a window at the last report. */
void transfer_identification_open_window(Vector memory) {
  double value_1 = memory.p[transfer_identification_X];
  double value_2 = memory.p[transfer_identification_Y];
  memory.p[transfer_identification_START_X] = value_1;
  memory.p[transfer_identification_START_Y] = value_2;
  memory.p[transfer_identification_PATH] = 0.0;
  memory.p[transfer_identification_DURATION] = 0.0;
  fill((Vector){memory.p + transfer_identification_ROW_X, transfer_identification_END - transfer_identification_ROW_X}, 0.0);
}

/* Add one report's path to the rows of both axes. */
void transfer_identification_gather(Vector memory, double dt, double dx, double dy) {
  double u, v, path, speed, factor;
  u = dx * memory.p[transfer_identification_METRES_PER_COUNT];
  v = dy * memory.p[transfer_identification_METRES_PER_COUNT];
  path = hypot(u, v);
  memory.p[transfer_identification_PATH] += path;
  memory.p[transfer_identification_DURATION] += dt;
  if (path == 0.0) {
    return;
  }
  speed = path / dt;
  factor = memory.p[transfer_identification_POWER] == 0.0 ? 1.0 / speed : 1.0;
  for (int64_t j = 0, end_1 = (int64_t)memory.p[transfer_identification_N]; j < end_1; j++) {
    memory.p[transfer_identification_ROW_X + j] += u * factor;
    memory.p[transfer_identification_ROW_Y + j] += v * factor;
    factor *= speed;
  }
}

/* One report of the device with the cursor's position after it: refused, taken or left out. */
Td transfer_identification_step(Vector memory, T6d event) {
  double t, x, y, dx, dy, dt, speed;
  bool started;
  records_EventRow values_1 = records_EventRow_of_T6d(event);
  t = values_1.t;
  x = values_1.x;
  y = values_1.y;
  dx = values_1.dx;
  dy = values_1.dy;
  if (!(fabs(t) <= records_LATEST_S && fabs(x) + fabs(y) + fabs(dx) + fabs(dy) <= records_LARGEST)) {
    return (Td){transfer_identification_REFUSED};
  }
  started = memory.p[transfer_identification_STARTED] == 1.0;
  dt = t - memory.p[transfer_identification_T];
  if (started && dt < 0.0) {
    return (Td){transfer_identification_REFUSED};
  }
  memory.p[transfer_identification_STARTED] = 1.0;
  memory.p[transfer_identification_T] = t;
  memory.p[transfer_identification_X] = x;
  memory.p[transfer_identification_Y] = y;
  if (!started || dt > memory.p[transfer_identification_GAP_S] + records_ROUNDING_S) {
    memory.p[transfer_identification_SKIPPED] += 1.0;
    memory.p[transfer_identification_WAITING_X] = 0.0;
    memory.p[transfer_identification_WAITING_Y] = 0.0;
    transfer_identification_open_window(memory);
    return (Td){transfer_identification_LEFT_OUT};
  }
  memory.p[transfer_identification_WAITING_X] += dx;
  memory.p[transfer_identification_WAITING_Y] += dy;
  if (dt == 0.0) {
    return (Td){transfer_identification_TAKEN};
  }
  transfer_identification_gather(memory, dt, memory.p[transfer_identification_WAITING_X], memory.p[transfer_identification_WAITING_Y]);
  memory.p[transfer_identification_WAITING_X] = 0.0;
  memory.p[transfer_identification_WAITING_Y] = 0.0;
  if (memory.p[transfer_identification_DURATION] >= memory.p[transfer_identification_WINDOW_S]) {
    if (memory.p[transfer_identification_PATH] > 0.0) {
      speed = memory.p[transfer_identification_PATH] / memory.p[transfer_identification_DURATION];
      transfer_identification_learn(memory, transfer_identification_ROW_X, (x - memory.p[transfer_identification_START_X]) * memory.p[transfer_identification_METRES_PER_PX], speed);
      transfer_identification_learn(memory, transfer_identification_ROW_Y, (y - memory.p[transfer_identification_START_Y]) * memory.p[transfer_identification_METRES_PER_PX], speed);
    }
    transfer_identification_open_window(memory);
  }
  return (Td){transfer_identification_TAKEN};
}

/* A row of a table of events as a tuple. */
T6d transfer_identification_event_at(Table rows, int64_t i) {
  Vector r;
  r = (Vector){rows.p + i * rows.m, rows.m};
  return (T6d){r.p[0], r.p[1], r.p[2], r.p[3], r.p[4], r.p[5]};
}

/* One ``CountsRow``: (t, dx in px, dy in px); NaN for a report that is refused. */
T3d transfer_pixels_step(Vector memory, T3d report) {
  double t, dx, dy, dt, scale;
  bool usable;
  pixels_CountsRow values_1 = pixels_CountsRow_of_T3d(report);
  t = values_1.t;
  dx = values_1.dx;
  dy = values_1.dy;
  Tbd values_2 = transfer_pixels_accept(memory, transfer_pixels_AT, t, dx, dy);
  usable = values_2.f0;
  dt = values_2.f1;
  if (!usable) {
    return (T3d){NAN, NAN, NAN};
  }
  scale = transfer_pixels_turn(memory, transfer_pixels_AT, t, dt, dx, dy);
  return (T3d){t, transfer_pixels_carry(memory, transfer_pixels_AT + transfer_pixels_CARRY, scale * dx), transfer_pixels_carry(memory, transfer_pixels_AT + transfer_pixels_CARRY + 1, scale * dy)};
}

/* Write the beginning of a memory: a stage's ``own`` parameters, the device, the transfer function. */
void transfer_pixels_lay_out(Vector memory, Vector own, T4d device, Vector function) {
  double cpi, dpi, period_s, gap_s;
  int64_t at;
  cpi = device.f0;
  dpi = device.f1;
  period_s = device.f2;
  gap_s = device.f3;
  at = own.n;
  for (int64_t i = 0; i < at; i++) {
    memory.p[i] = own.p[i];
  }
  memory.p[at + transfer_pixels_PX_PER_COUNT] = dpi / cpi;
  memory.p[at + transfer_pixels_METRES_PER_COUNT] = records_METRES_PER_INCH / cpi;
  memory.p[at + transfer_pixels_PERIOD_S] = period_s;
  memory.p[at + transfer_pixels_GAP_S] = gap_s;
  for (int64_t i = 0; i < transfer_functions_SLOTS; i++) {
    memory.p[at + transfer_pixels_FUNCTION + i] = function.p[i];
  }
}

/* A row of a table of reports. */
T3d transfer_pixels_report_at(Table rows, int64_t i) {
  return (T3d){rows.p[i * rows.m + 0], rows.p[i * rows.m + 1], rows.p[i * rows.m + 2]};
}

void loop__stage_learn_nothing__transfer_assistance_guided_report_at__transfer_assistance_guarded_step(Vector memory, int64_t first, FlagVector begin, Table rows, Table out) {
  T5d answer;
  for (int64_t i = 0; i < rows.n; i++) {
    if (begin.p[i]) {
      stage_learn_nothing(memory);
      fill((Vector){memory.p + first, memory.n - first}, 0.0);
    }
    answer = transfer_assistance_guarded_step(memory, transfer_assistance_guided_report_at(rows, i));
    for (int64_t j = 0; j < 5; j++) {
      out.p[i * out.m + j] = ((const double *)&answer)[j];
    }
  }
}
