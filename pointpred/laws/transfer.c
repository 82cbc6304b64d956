/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const double records_METRES_PER_INCH = 0.0254;
static const int64_t transfer_bands_BANDS = 20;
static const double transfer_functions_ARCTAN = 3.0;
static const double transfer_functions_BOUNDED = 5.0;
static const int64_t transfer_functions_BOUNDED_COEFFICIENTS = 5;
static const int64_t transfer_functions_COEFFICIENTS_MOST = 7;
static const double transfer_functions_CONSTANT = 1.0;
static const double transfer_functions_POLYNOMIAL = 4.0;
static const double transfer_functions_SIGMOID = 2.0;
static const double transfer_identification_LEFT_OUT = 1.0;
static const double transfer_identification_REFUSED = -1.0;
static const double transfer_identification_TAKEN = 0.0;

/* PTF(V) / V, the control-display gain; at V = 0 its limit (infinite for a polynomial with c_0). */
double transfer_functions_gain(transfer_functions_Function * f, double speed) {
  double gain_min, gain_max, speed_low, speed_high, share, value, low, high, within;
  if (f->kind == transfer_functions_CONSTANT) {
    return f->numbers[0];
  }
  if (f->kind == transfer_functions_SIGMOID) {
    gain_min = f->numbers[0];
    gain_max = f->numbers[1];
    speed_low = f->numbers[2];
    speed_high = f->numbers[3];
    share = (speed - speed_low) / (speed_high - speed_low);
    share = min_float(max_float(share, 0.0), 1.0);
    return gain_min + share * (gain_max - gain_min);
  }
  if (f->kind == transfer_functions_ARCTAN) {
    return speed > 0.0 ? atan(speed) / speed : 1.0;
  }
  value = 0.0;
  if (f->kind == transfer_functions_BOUNDED) {
    low = f->numbers[transfer_functions_BOUNDED_COEFFICIENTS];
    high = f->numbers[transfer_functions_BOUNDED_COEFFICIENTS + 1];
    within = min_float(max_float(speed, low), high);
    for (int64_t i = transfer_functions_BOUNDED_COEFFICIENTS - 1; i > (-1); i--) {
      value = value * within + f->numbers[i];
    }
    return value;
  }
  for (int64_t i = transfer_functions_COEFFICIENTS_MOST - 1; i > 0; i--) {
    value = value * speed + f->numbers[i];
  }
  if (f->numbers[0] == 0.0) {
    return value;
  }
  return speed > 0.0 ? value + f->numbers[0] / speed : copysign(INFINITY, f->numbers[0]);
}

/* PTF(V): the speed of the cursor in m/s on the screen for a hand's speed >= 0 in m/s. */
double transfer_functions_cursor_speed(transfer_functions_Function * f, double speed) {
  double value;
  if (f->kind == transfer_functions_POLYNOMIAL) {
    value = 0.0;
    for (int64_t i = transfer_functions_COEFFICIENTS_MOST - 1; i > (-1); i--) {
      value = value * speed + f->numbers[i];
    }
    return value;
  }
  if (f->kind == transfer_functions_ARCTAN) {
    return atan(speed);
  }
  return transfer_functions_gain(f, speed) * speed;
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
Tbd transfer_pixels_accept(transfer_pixels_Memory * memory, double t, double dx, double dy) {
  transfer_pixels_Settings * settings;
  transfer_pixels_State * s;
  bool fine;
  settings = &memory->settings;
  s = &memory->state;
  fine = fabs(t) <= records_LATEST_S && fabs(dx) <= records_LARGEST && fabs(dy) <= records_LARGEST;
  if (s->started == 0.0) {
    return (Tbd){fine, settings->period_s};
  }
  return (Tbd){fine && t >= s->t, min_float(t - s->t, settings->gap_s)};
}

/* Process an accepted report and return the pixels per count; without elapsed time, by the last gain. */
double transfer_pixels_turn(transfer_pixels_Memory * memory, double t, double dt, double dx, double dy) {
  transfer_pixels_Settings * settings;
  transfer_pixels_State * s;
  double speed;
  settings = &memory->settings;
  s = &memory->state;
  if (dt > 0.0) {
    speed = hypot(dx, dy) * settings->metres_per_count / dt;
    s->gain = transfer_functions_gain(&settings->function, speed);
  }
  s->started = 1.0;
  s->t = t;
  return s->gain * settings->px_per_count;
}

/* One ``OffsetReport``: (t, dx in px, dy in px); NaN for a report that is refused. */
T3d transfer_assistance_assisted_step(transfer_assistance_Assisted * memory, T5d report) {
  double t, dx, dy, off_x, off_y, dt, scale, x, y, share;
  bool usable;
  transfer_pixels_Carried * carried;
  transfer_assistance_OffsetReport values_1 = transfer_assistance_OffsetReport_of_T5d(report);
  t = values_1.t;
  dx = values_1.dx;
  dy = values_1.dy;
  off_x = values_1.off_x;
  off_y = values_1.off_y;
  Tbd values_2 = transfer_pixels_accept(&memory->transfer, t, dx, dy);
  usable = values_2.f0;
  dt = values_2.f1;
  if (!usable || fabs(off_x) > records_LARGEST || fabs(off_y) > records_LARGEST) {
    return (T3d){NAN, NAN, NAN};
  }
  scale = transfer_pixels_turn(&memory->transfer, t, dt, dx, dy);
  x = scale * dx;
  y = scale * dy;
  share = transfer_assistance_pull(memory->rho, memory->strength, dt, hypot(x, y), off_x, off_y);
  if (share > 0.0) {
    x += share * off_x;
    y += share * off_y;
  }
  carried = &memory->transfer.state.carried;
  double value_4 = transfer_pixels_carry(carried, 0, x);
  double value_5 = transfer_pixels_carry(carried, 1, y);
  return (T3d){t, value_4, value_5};
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

/* The px added to the hand's ``own`` (x, y) in ``dt`` s. */
T2d transfer_assistance_guide(transfer_assistance_Guard * guard, double dt, T2d own, T5d way) {
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
  trust = 1.0 - transfer_assistance_spread(distance, sxx, sxy, syy, guard->unclaimed) / guard->uncertain;
  to_x = own_x / moved;
  to_y = own_y / moved;
  ahead = off_x * to_x + off_y * to_y;
  beside = off_y * to_x - off_x * to_y;
  if (!(trust > 0.0 && ahead > 0.0)) {
    return (T2d){0.0, 0.0};
  }
  share = -expm1(-guard->rho * dt);
  longest = guard->strength * moved;
  widest = guard->sideways * longest;
  along = trust * min_float(min_float(share * ahead, longest), max_float(ahead - moved, 0.0));
  across = trust * min_float(max_float(share * beside * (ahead / distance), -widest), widest);
  return (T2d){along * to_x - across * to_y, along * to_y + across * to_x};
}

/* ``guide`` in whole pixels, with the fractions carried. */
T2d transfer_assistance_add(transfer_assistance_Guard * guard, transfer_pixels_Carried * owed, double dt, T2d own, T5d way) {
  double x, y, whole_x, whole_y;
  T2d values_1 = transfer_assistance_guide(guard, dt, own, way);
  x = values_1.f0;
  y = values_1.f1;
  whole_x = transfer_pixels_carry(owed, 0, x);
  whole_y = transfer_pixels_carry(owed, 1, y);
  if (whole_x * own.f0 + whole_y * own.f1 < 0.0) {
    memset(owed, 0, sizeof(transfer_pixels_Carried));
    return (T2d){0.0, 0.0};
  }
  return (T2d){whole_x, whole_y};
}

/* One ``GuidedReport``: (t, dx px, dy px, and the added part of these); NaN if refused. */
T5d transfer_assistance_guarded_step(transfer_assistance_Guarded * memory, T8d report) {
  double t, dx, dy, off_x, off_y, sxx, sxy, syy, dt, scale, own_x, own_y, x, y, add_x, add_y;
  bool usable;
  transfer_pixels_Carried * carried;
  transfer_assistance_GuidedReport values_1 = transfer_assistance_GuidedReport_of_T8d(report);
  t = values_1.t;
  dx = values_1.dx;
  dy = values_1.dy;
  off_x = values_1.off_x;
  off_y = values_1.off_y;
  sxx = values_1.sxx;
  sxy = values_1.sxy;
  syy = values_1.syy;
  Tbd values_2 = transfer_pixels_accept(&memory->transfer, t, dx, dy);
  usable = values_2.f0;
  dt = values_2.f1;
  if (!usable || fabs(off_x) > records_LARGEST || fabs(off_y) > records_LARGEST) {
    return (T5d){NAN, NAN, NAN, NAN, NAN};
  }
  scale = transfer_pixels_turn(&memory->transfer, t, dt, dx, dy);
  own_x = scale * dx;
  own_y = scale * dy;
  carried = &memory->transfer.state.carried;
  x = transfer_pixels_carry(carried, 0, own_x);
  y = transfer_pixels_carry(carried, 1, own_y);
  T2d values_3 = transfer_assistance_add(&memory->guard, &memory->owed, dt, (T2d){own_x, own_y}, (T5d){off_x, off_y, sxx, sxy, syy});
  add_x = values_3.f0;
  add_y = values_3.f1;
  return (T5d){t, x + add_x, y + add_y, add_x, add_y};
}

/* Floats of all bands: for each the sum of w_1 y and those of w_1 w_i, w_1 the regressor of c_1. */
int64_t transfer_bands_states(int64_t n) {
  return transfer_bands_BANDS * (1 + n);
}

/* Add output = row . c to a band, a real number; outside the bands nothing happens. */
void transfer_bands_learn(Vector memory, transfer_bands_Model model, double band, Vector row, double output) {
  int64_t n, linear, place;
  double forgetting, reference;
  if (!(0.0 <= band && band < transfer_bands_BANDS)) {
    return;
  }
  n = model.n;
  linear = model.linear;
  forgetting = model.forgetting;
  place = (int64_t)band * (1 + n);
  reference = row.p[linear];
  memory.p[place] = forgetting * memory.p[place] + reference * output;
  for (int64_t j = 0; j < n; j++) {
    memory.p[place + 1 + j] = forgetting * memory.p[place + 1 + j] + reference * row.p[j];
  }
}

/* Evaluate one of the two laws at many speeds. */
void transfer_functions_evaluate(transfer_functions_Function * f, Vector speeds, bool wanted_gain, Vector out) {
  for (int64_t i = 0; i < speeds.n; i++) {
    out.p[i] = wanted_gain ? transfer_functions_gain(f, speeds.p[i]) : transfer_functions_cursor_speed(f, speeds.p[i]);
  }
}

/* Add output = row . c at a speed of the hand to the recursion and to its band. */
void transfer_identification_learn(transfer_identification_Memory * memory, Vector row, double output, double speed) {
  transfer_identification_Settings * settings;
  transfer_identification_Learned * learned;
  int64_t n;
  regression_least_squares_Regression regression;
  double band;
  transfer_bands_Model model;
  settings = &memory->settings;
  learned = &memory->learned;
  n = (int64_t)settings->count;
  regression = regression_least_squares_parts((Vector){learned->numbers, 63}, n);
  for (int64_t j = 0; j < n; j++) {
    regression.w.p[j] = row.p[j];
  }
  regression_least_squares_advance(&learned->sums, regression, settings->forgetting, output);
  band = (speed - settings->speed_low) / settings->band_width;
  model = (transfer_bands_Model){n, 1 - (int64_t)settings->power, settings->forgetting};
  transfer_bands_learn((Vector){learned->bands, 160}, model, band, row, output);
}

/* Add one pair of speeds in m/s, as in section 2.5.1: the regressor consists of powers of V. */
void transfer_identification_learn_speeds(transfer_identification_Memory * memory, double speed, double cursor_speed) {
  Vector row;
  double value;
  row = (Vector){memory->learned.row, 7};
  value = memory->settings.power == 0.0 ? 1.0 : speed;
  for (int64_t j = 0, end_1 = (int64_t)memory->settings.count; j < end_1; j++) {
    row.p[j] = value;
    value *= speed;
  }
  transfer_identification_learn(memory, row, cursor_speed, speed);
}

/* Start a window at the last report. */
void transfer_identification_open_window(transfer_identification_State * s) {
  memset(&s->window, 0, sizeof(transfer_identification_Window));
  double value_1 = s->x;
  double value_2 = s->y;
  s->window.x = value_1;
  s->window.y = value_2;
}

/* Add one report's path to the rows of both axes. */
void transfer_identification_gather(transfer_identification_Settings * settings, transfer_identification_Window * window, double dt, double dx, double dy) {
  double u, v, path, speed, factor;
  u = dx * settings->metres_per_count;
  v = dy * settings->metres_per_count;
  path = hypot(u, v);
  window->path += path;
  window->duration += dt;
  if (path == 0.0) {
    return;
  }
  speed = path / dt;
  factor = settings->power == 0.0 ? 1.0 / speed : 1.0;
  for (int64_t j = 0, end_1 = (int64_t)settings->count; j < end_1; j++) {
    window->row_x[j] += u * factor;
    window->row_y[j] += v * factor;
    factor *= speed;
  }
}

/* One report of the device with the cursor's position after it: refused, taken or left out. */
Td transfer_identification_step(transfer_identification_Memory * memory, T6d event) {
  transfer_identification_Settings * settings;
  transfer_identification_State * s;
  transfer_identification_Window * window;
  double t, x, y, dx, dy, dt, speed;
  bool started;
  settings = &memory->settings;
  s = &memory->state;
  window = &memory->state.window;
  records_EventRow values_1 = records_EventRow_of_T6d(event);
  t = values_1.t;
  x = values_1.x;
  y = values_1.y;
  dx = values_1.dx;
  dy = values_1.dy;
  if (!(fabs(t) <= records_LATEST_S && fabs(x) + fabs(y) + fabs(dx) + fabs(dy) <= records_LARGEST)) {
    return (Td){transfer_identification_REFUSED};
  }
  started = s->started == 1.0;
  dt = t - s->t;
  if (started && dt < 0.0) {
    return (Td){transfer_identification_REFUSED};
  }
  s->started = 1.0;
  s->t = t;
  s->x = x;
  s->y = y;
  if (!started || dt > settings->gap_s + records_ROUNDING_S) {
    memory->learned.skipped += 1.0;
    s->waiting_x = 0.0;
    s->waiting_y = 0.0;
    transfer_identification_open_window(s);
    return (Td){transfer_identification_LEFT_OUT};
  }
  s->waiting_x += dx;
  s->waiting_y += dy;
  if (dt == 0.0) {
    return (Td){transfer_identification_TAKEN};
  }
  transfer_identification_gather(settings, window, dt, s->waiting_x, s->waiting_y);
  s->waiting_x = 0.0;
  s->waiting_y = 0.0;
  if (window->duration >= settings->window_s) {
    if (window->path > 0.0) {
      speed = window->path / window->duration;
      transfer_identification_learn(memory, (Vector){window->row_x, 7}, (x - window->x) * settings->metres_per_px, speed);
      transfer_identification_learn(memory, (Vector){window->row_y, 7}, (y - window->y) * settings->metres_per_px, speed);
    }
    transfer_identification_open_window(s);
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
T3d transfer_pixels_step(transfer_pixels_Memory * memory, T3d report) {
  double t, dx, dy, dt, scale;
  bool usable;
  transfer_pixels_Carried * carried;
  transfer_pixels_CountsRow values_1 = transfer_pixels_CountsRow_of_T3d(report);
  t = values_1.t;
  dx = values_1.dx;
  dy = values_1.dy;
  Tbd values_2 = transfer_pixels_accept(memory, t, dx, dy);
  usable = values_2.f0;
  dt = values_2.f1;
  if (!usable) {
    return (T3d){NAN, NAN, NAN};
  }
  scale = transfer_pixels_turn(memory, t, dt, dx, dy);
  carried = &memory->state.carried;
  double value_4 = transfer_pixels_carry(carried, 0, scale * dx);
  double value_5 = transfer_pixels_carry(carried, 1, scale * dy);
  return (T3d){t, value_4, value_5};
}

/* Write the beginning of a memory: a stage's ``own`` parameters, then its ``Settings``. */
void transfer_pixels_lay_out(Vector memory, Vector own, T4d device, transfer_functions_Function * function) {
  double cpi, dpi, period_s, gap_s;
  transfer_pixels_Settings * settings;
  cpi = device.f0;
  dpi = device.f1;
  period_s = device.f2;
  gap_s = device.f3;
  for (int64_t i = 0; i < own.n; i++) {
    memory.p[i] = own.p[i];
  }
  settings = (transfer_pixels_Settings *)(memory.p + own.n);
  settings->px_per_count = dpi / cpi;
  settings->metres_per_count = records_METRES_PER_INCH / cpi;
  settings->period_s = period_s;
  settings->gap_s = gap_s;
  settings->function.kind = function->kind;
  for (int64_t i = 0; i < 7; i++) {
    settings->function.numbers[i] = function->numbers[i];
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
    answer = transfer_assistance_guarded_step((transfer_assistance_Guarded *)memory.p, transfer_assistance_guided_report_at(rows, i));
    for (int64_t j = 0; j < 5; j++) {
      out.p[i * out.m + j] = ((const double *)&answer)[j];
    }
  }
}
