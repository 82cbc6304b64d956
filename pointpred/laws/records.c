/* Written by `make laws` from the laws: change those and run it again. */
#include "laws.h"

static const int64_t records_EVENT_FIELD = 2;
static const int64_t records_FINE = 0;
static const double records_LARGEST = 1000000000.0;
static const double records_LATEST_S = 100000000000.0;

/* Whether the values make an event: all within their bounds, buttons whole, counts both or none (NaN). */
int64_t records_fault_of_event(records_EventRow event) {
  double t, x, y, dx, dy, buttons;
  t = event.t;
  x = event.x;
  y = event.y;
  dx = event.dx;
  dy = event.dy;
  buttons = event.buttons;
  if (!(fabs(t) <= records_LATEST_S)) {
    return records_EVENT_FIELD;
  }
  if (!(fabs(x) <= records_LARGEST)) {
    return records_EVENT_FIELD + 1;
  }
  if (!(fabs(y) <= records_LARGEST)) {
    return records_EVENT_FIELD + 2;
  }
  if (!(dx != dx && dy != dy)) {
    if (!(fabs(dx) <= records_LARGEST)) {
      return records_EVENT_FIELD + 3;
    }
    if (!(fabs(dy) <= records_LARGEST)) {
      return records_EVENT_FIELD + 4;
    }
  }
  if (!((0.0 <= buttons && buttons <= records_LARGEST) && buttons == (int64_t)floor(buttons))) {
    return records_EVENT_FIELD + 5;
  }
  return records_FINE;
}

/* The answer of a law to a row that it refuses: NaN for a time, why, and what it was compared with. */
T10d records_refused(int64_t code, double value) {
  return (T10d){NAN, (double)code, value, NAN, NAN, NAN, NAN, NAN, NAN, NAN};
}

/* The row of a prediction that claims an endpoint and nothing else; ``x`` is NaN where it claims none. */
T10d records_endpoint(double t, double x, double y, double phase) {
  return (T10d){t, x, y, NAN, NAN, NAN, NAN, phase, NAN, NAN};
}

/* A row of a table of motions or of predictions as a tuple. */
T10d records_row_at(Table table, int64_t i) {
  Vector r;
  r = (Vector){table.p + i * table.m, table.m};
  return (T10d){r.p[0], r.p[1], r.p[2], r.p[3], r.p[4], r.p[5], r.p[6], r.p[7], r.p[8], r.p[9]};
}

/* A row of a table of events as a tuple. */
T6d records_event_at(Table table, int64_t i) {
  Vector r;
  r = (Vector){table.p + i * table.m, table.m};
  return (T6d){r.p[0], r.p[1], r.p[2], r.p[3], r.p[4], r.p[5]};
}
