/* Written by `make laws` from the laws: change those and run it again. */
#define MOST_ARRAYS 9
/* How Python's values become those of a law, and back. */
#include "abi3.h"
#include <stdbool.h>
#include <string.h>

/* MOST_ARRAYS: of the law that takes the most, as module.c says above. */
typedef struct { Py_buffer views[MOST_ARRAYS]; int count; } Held;

static void *let_go(Held *held) {
  while (held->count > 0) PyBuffer_Release(&held->views[--held->count]);
  return NULL;
}

static bool counted(const char *law, Py_ssize_t given, Py_ssize_t wanted) {
  if (given == wanted) return true;
  PyErr_Format(PyExc_TypeError, "%s takes %zd arguments, received %zd", law, wanted, given);
  return false;
}

static bool is_format(const Py_buffer *view, char letter) {
  const char *format = view->format == NULL ? "B" : view->format;
  if (*format == '@' || *format == '=' || *format == '<') format++;
  if (format[0] == '\0' || format[1] != '\0') return false;
  if (letter == 'q') return view->itemsize == 8 && strchr("lqn", *format) != NULL;
  return *format == (letter == 'b' ? '?' : letter);
}

/* The memory of an array of so many dimensions; false, with a TypeError, for anything else. */
static bool take_array(Held *held, PyObject *given, const char *law, const char *argument, char letter, int dimensions,
                       bool written, const Py_buffer **taken) {
  Py_buffer *view = &held->views[held->count];
  int flags = PyBUF_FORMAT | PyBUF_C_CONTIGUOUS | (written ? PyBUF_WRITABLE : 0);
  if (PyObject_GetBuffer(given, view, flags) == 0) {
    held->count++;
    *taken = view;
    if (view->ndim == dimensions && is_format(view, letter)) return true;
  }
  PyErr_Clear();
  const char *kind = letter == 'd' ? "float64" : letter == 'q' ? "int64" : "bool";
  PyErr_Format(PyExc_TypeError, "%s: %s must be a %scontiguous array of %s with %d dimension%s, received %R", law, argument,
               written ? "writable, " : "", kind, dimensions, dimensions == 1 ? "" : "s", (PyObject *)given->ob_type);
  return false;
}

static bool has_columns(const char *law, const char *argument, int64_t given, int64_t least) {
  if (given >= least) return true;
  PyErr_Format(PyExc_TypeError, "%s: %s must have at least %lld columns, received %lld", law, argument, (long long)least,
               (long long)given);
  return false;
}

/* The numbers of a memory: an array, or a view with names of one. */
static bool take_memory(Held *held, PyObject *given, const char *law, const char *argument, bool written, Py_ssize_t least,
                        const Py_buffer **taken) {
  bool good;
  if (PyObject_CheckBuffer(given)) {
    good = take_array(held, given, law, argument, 'd', 1, written, taken);
  } else {
    PyObject *memory = PyObject_GetAttrString(given, "memory");
    if (memory == NULL) {
      PyErr_Clear();
      return take_array(held, given, law, argument, 'd', 1, written, taken);
    }
    good = take_array(held, memory, law, argument, 'd', 1, written, taken);
    Py_DecRef(memory);
  }
  if (!good || (*taken)->shape[0] >= least) return good;
  PyErr_Format(PyExc_TypeError, "%s: %s must hold at least %zd numbers, received %zd", law, argument, least,
               (*taken)->shape[0]);
  return false;
}

static bool take_tuple(PyObject *given, const char *law, const char *argument, Py_ssize_t count) {
  if (PyTuple_Check(given) && PyTuple_Size(given) == count) return true;
  PyErr_Format(PyExc_TypeError, "%s: %s must be a tuple of %zd, received %R", law, argument, count, given);
  return false;
}

static bool take_double(PyObject *given, double *value) {
  *value = PyFloat_AsDouble(given);
  return *value != -1.0 || PyErr_Occurred() == NULL;
}

static bool take_int64_t(PyObject *given, int64_t *value) {
  *value = PyLong_AsLongLong(given);
  return *value != -1 || PyErr_Occurred() == NULL;
}

static bool take_bool(PyObject *given, bool *value) {
  int truth = PyObject_IsTrue(given);
  *value = truth == 1;
  return truth >= 0;
}
#include "laws.h"

static PyObject *give_T10d(T10d value) {
  PyObject *tuple = PyTuple_New(10);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyFloat_FromDouble(value.f0));
  PyTuple_SetItem(tuple, 1, PyFloat_FromDouble(value.f1));
  PyTuple_SetItem(tuple, 2, PyFloat_FromDouble(value.f2));
  PyTuple_SetItem(tuple, 3, PyFloat_FromDouble(value.f3));
  PyTuple_SetItem(tuple, 4, PyFloat_FromDouble(value.f4));
  PyTuple_SetItem(tuple, 5, PyFloat_FromDouble(value.f5));
  PyTuple_SetItem(tuple, 6, PyFloat_FromDouble(value.f6));
  PyTuple_SetItem(tuple, 7, PyFloat_FromDouble(value.f7));
  PyTuple_SetItem(tuple, 8, PyFloat_FromDouble(value.f8));
  PyTuple_SetItem(tuple, 9, PyFloat_FromDouble(value.f9));
  return tuple;
}
static PyObject *give_Tq3db(Tq3db value) {
  PyObject *tuple = PyTuple_New(5);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyLong_FromLongLong(value.f0));
  PyTuple_SetItem(tuple, 1, PyFloat_FromDouble(value.f1));
  PyTuple_SetItem(tuple, 2, PyFloat_FromDouble(value.f2));
  PyTuple_SetItem(tuple, 3, PyFloat_FromDouble(value.f3));
  PyTuple_SetItem(tuple, 4, PyBool_FromLong(value.f4));
  return tuple;
}
static PyObject *give_predictors_adaptation_destination_Heading(predictors_adaptation_destination_Heading value) {
  PyObject *tuple = PyTuple_New(7);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyFloat_FromDouble(value.x));
  PyTuple_SetItem(tuple, 1, PyFloat_FromDouble(value.y));
  PyTuple_SetItem(tuple, 2, PyFloat_FromDouble(value.ux));
  PyTuple_SetItem(tuple, 3, PyFloat_FromDouble(value.uy));
  PyTuple_SetItem(tuple, 4, PyFloat_FromDouble(value.wide));
  PyTuple_SetItem(tuple, 5, PyFloat_FromDouble(value.broad));
  PyTuple_SetItem(tuple, 6, PyFloat_FromDouble(value.tail));
  return tuple;
}
static PyObject *give_T2_predictors_adaptation_destination_Heading_(T2_predictors_adaptation_destination_Heading_ value) {
  PyObject *tuple = PyTuple_New(2);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, give_predictors_adaptation_destination_Heading(value.f0));
  PyTuple_SetItem(tuple, 1, give_predictors_adaptation_destination_Heading(value.f1));
  return tuple;
}
static PyObject *give_T2d(T2d value) {
  PyObject *tuple = PyTuple_New(2);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyFloat_FromDouble(value.f0));
  PyTuple_SetItem(tuple, 1, PyFloat_FromDouble(value.f1));
  return tuple;
}
static PyObject *give_T_predictors_adaptation_destination_Heading_d(T_predictors_adaptation_destination_Heading_d value) {
  PyObject *tuple = PyTuple_New(2);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, give_predictors_adaptation_destination_Heading(value.f0));
  PyTuple_SetItem(tuple, 1, PyFloat_FromDouble(value.f1));
  return tuple;
}
static PyObject *give_Tqd(Tqd value) {
  PyObject *tuple = PyTuple_New(2);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyLong_FromLongLong(value.f0));
  PyTuple_SetItem(tuple, 1, PyFloat_FromDouble(value.f1));
  return tuple;
}
static PyObject *give_T6d(T6d value) {
  PyObject *tuple = PyTuple_New(6);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyFloat_FromDouble(value.f0));
  PyTuple_SetItem(tuple, 1, PyFloat_FromDouble(value.f1));
  PyTuple_SetItem(tuple, 2, PyFloat_FromDouble(value.f2));
  PyTuple_SetItem(tuple, 3, PyFloat_FromDouble(value.f3));
  PyTuple_SetItem(tuple, 4, PyFloat_FromDouble(value.f4));
  PyTuple_SetItem(tuple, 5, PyFloat_FromDouble(value.f5));
  return tuple;
}
static PyObject *give_T3d(T3d value) {
  PyObject *tuple = PyTuple_New(3);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyFloat_FromDouble(value.f0));
  PyTuple_SetItem(tuple, 1, PyFloat_FromDouble(value.f1));
  PyTuple_SetItem(tuple, 2, PyFloat_FromDouble(value.f2));
  return tuple;
}
static PyObject *give_Tqb(Tqb value) {
  PyObject *tuple = PyTuple_New(2);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyLong_FromLongLong(value.f0));
  PyTuple_SetItem(tuple, 1, PyBool_FromLong(value.f1));
  return tuple;
}
static PyObject *give_Tq2d(Tq2d value) {
  PyObject *tuple = PyTuple_New(3);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyLong_FromLongLong(value.f0));
  PyTuple_SetItem(tuple, 1, PyFloat_FromDouble(value.f1));
  PyTuple_SetItem(tuple, 2, PyFloat_FromDouble(value.f2));
  return tuple;
}
static PyObject *give_predictors_adaptation_time_left_Pace(predictors_adaptation_time_left_Pace value) {
  PyObject *tuple = PyTuple_New(2);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyFloat_FromDouble(value.of_peak));
  PyTuple_SetItem(tuple, 1, PyFloat_FromDouble(value.slow_s));
  return tuple;
}
static PyObject *give_T3q(T3q value) {
  PyObject *tuple = PyTuple_New(3);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyLong_FromLongLong(value.f0));
  PyTuple_SetItem(tuple, 1, PyLong_FromLongLong(value.f1));
  PyTuple_SetItem(tuple, 2, PyLong_FromLongLong(value.f2));
  return tuple;
}
static PyObject *give_T4d(T4d value) {
  PyObject *tuple = PyTuple_New(4);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyFloat_FromDouble(value.f0));
  PyTuple_SetItem(tuple, 1, PyFloat_FromDouble(value.f1));
  PyTuple_SetItem(tuple, 2, PyFloat_FromDouble(value.f2));
  PyTuple_SetItem(tuple, 3, PyFloat_FromDouble(value.f3));
  return tuple;
}
static PyObject *give_T7d(T7d value) {
  PyObject *tuple = PyTuple_New(7);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyFloat_FromDouble(value.f0));
  PyTuple_SetItem(tuple, 1, PyFloat_FromDouble(value.f1));
  PyTuple_SetItem(tuple, 2, PyFloat_FromDouble(value.f2));
  PyTuple_SetItem(tuple, 3, PyFloat_FromDouble(value.f3));
  PyTuple_SetItem(tuple, 4, PyFloat_FromDouble(value.f4));
  PyTuple_SetItem(tuple, 5, PyFloat_FromDouble(value.f5));
  PyTuple_SetItem(tuple, 6, PyFloat_FromDouble(value.f6));
  return tuple;
}
static PyObject *give_predictors_kep_Quartic(predictors_kep_Quartic value) {
  PyObject *tuple = PyTuple_New(5);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyFloat_FromDouble(value.c0));
  PyTuple_SetItem(tuple, 1, PyFloat_FromDouble(value.c1));
  PyTuple_SetItem(tuple, 2, PyFloat_FromDouble(value.c2));
  PyTuple_SetItem(tuple, 3, PyFloat_FromDouble(value.c3));
  PyTuple_SetItem(tuple, 4, PyFloat_FromDouble(value.c4));
  return tuple;
}
static PyObject *give_predictors_kinematic_history_Point(predictors_kinematic_history_Point value) {
  PyObject *tuple = PyTuple_New(4);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyFloat_FromDouble(value.t));
  PyTuple_SetItem(tuple, 1, PyFloat_FromDouble(value.x));
  PyTuple_SetItem(tuple, 2, PyFloat_FromDouble(value.y));
  PyTuple_SetItem(tuple, 3, PyFloat_FromDouble(value.path));
  return tuple;
}
static PyObject *give_Tq_predictors_kinematic_history_Point_(Tq_predictors_kinematic_history_Point_ value) {
  PyObject *tuple = PyTuple_New(2);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyLong_FromLongLong(value.f0));
  PyTuple_SetItem(tuple, 1, give_predictors_kinematic_history_Point(value.f1));
  return tuple;
}
static PyObject *give_predictors_kinematic_features_Frame(predictors_kinematic_features_Frame value) {
  PyObject *tuple = PyTuple_New(4);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyFloat_FromDouble(value.reach));
  PyTuple_SetItem(tuple, 1, PyFloat_FromDouble(value.hand));
  PyTuple_SetItem(tuple, 2, PyFloat_FromDouble(value.ux));
  PyTuple_SetItem(tuple, 3, PyFloat_FromDouble(value.uy));
  return tuple;
}
static PyObject *give_Tq_predictors_kinematic_features_Frame_(Tq_predictors_kinematic_features_Frame_ value) {
  PyObject *tuple = PyTuple_New(2);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyLong_FromLongLong(value.f0));
  PyTuple_SetItem(tuple, 1, give_predictors_kinematic_features_Frame(value.f1));
  return tuple;
}
static PyObject *give_Tb3d(Tb3d value) {
  PyObject *tuple = PyTuple_New(4);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyBool_FromLong(value.f0));
  PyTuple_SetItem(tuple, 1, PyFloat_FromDouble(value.f1));
  PyTuple_SetItem(tuple, 2, PyFloat_FromDouble(value.f2));
  PyTuple_SetItem(tuple, 3, PyFloat_FromDouble(value.f3));
  return tuple;
}
static PyObject *give_Tqbd(Tqbd value) {
  PyObject *tuple = PyTuple_New(3);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyLong_FromLongLong(value.f0));
  PyTuple_SetItem(tuple, 1, PyBool_FromLong(value.f1));
  PyTuple_SetItem(tuple, 2, PyFloat_FromDouble(value.f2));
  return tuple;
}
static PyObject *give_Tbd(Tbd value) {
  PyObject *tuple = PyTuple_New(2);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyBool_FromLong(value.f0));
  PyTuple_SetItem(tuple, 1, PyFloat_FromDouble(value.f1));
  return tuple;
}
static PyObject *give_T2q(T2q value) {
  PyObject *tuple = PyTuple_New(2);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyLong_FromLongLong(value.f0));
  PyTuple_SetItem(tuple, 1, PyLong_FromLongLong(value.f1));
  return tuple;
}
static PyObject *give_T5d(T5d value) {
  PyObject *tuple = PyTuple_New(5);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyFloat_FromDouble(value.f0));
  PyTuple_SetItem(tuple, 1, PyFloat_FromDouble(value.f1));
  PyTuple_SetItem(tuple, 2, PyFloat_FromDouble(value.f2));
  PyTuple_SetItem(tuple, 3, PyFloat_FromDouble(value.f3));
  PyTuple_SetItem(tuple, 4, PyFloat_FromDouble(value.f4));
  return tuple;
}
static PyObject *give_T14d(T14d value) {
  PyObject *tuple = PyTuple_New(14);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyFloat_FromDouble(value.f0));
  PyTuple_SetItem(tuple, 1, PyFloat_FromDouble(value.f1));
  PyTuple_SetItem(tuple, 2, PyFloat_FromDouble(value.f2));
  PyTuple_SetItem(tuple, 3, PyFloat_FromDouble(value.f3));
  PyTuple_SetItem(tuple, 4, PyFloat_FromDouble(value.f4));
  PyTuple_SetItem(tuple, 5, PyFloat_FromDouble(value.f5));
  PyTuple_SetItem(tuple, 6, PyFloat_FromDouble(value.f6));
  PyTuple_SetItem(tuple, 7, PyFloat_FromDouble(value.f7));
  PyTuple_SetItem(tuple, 8, PyFloat_FromDouble(value.f8));
  PyTuple_SetItem(tuple, 9, PyFloat_FromDouble(value.f9));
  PyTuple_SetItem(tuple, 10, PyFloat_FromDouble(value.f10));
  PyTuple_SetItem(tuple, 11, PyFloat_FromDouble(value.f11));
  PyTuple_SetItem(tuple, 12, PyFloat_FromDouble(value.f12));
  PyTuple_SetItem(tuple, 13, PyFloat_FromDouble(value.f13));
  return tuple;
}
static PyObject *give_T4q(T4q value) {
  PyObject *tuple = PyTuple_New(4);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyLong_FromLongLong(value.f0));
  PyTuple_SetItem(tuple, 1, PyLong_FromLongLong(value.f1));
  PyTuple_SetItem(tuple, 2, PyLong_FromLongLong(value.f2));
  PyTuple_SetItem(tuple, 3, PyLong_FromLongLong(value.f3));
  return tuple;
}
static PyObject *give_T2b(T2b value) {
  PyObject *tuple = PyTuple_New(2);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyBool_FromLong(value.f0));
  PyTuple_SetItem(tuple, 1, PyBool_FromLong(value.f1));
  return tuple;
}
static PyObject *give_targets_endpoint_Ellipse(targets_endpoint_Ellipse value) {
  PyObject *tuple = PyTuple_New(6);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyFloat_FromDouble(value.x));
  PyTuple_SetItem(tuple, 1, PyFloat_FromDouble(value.y));
  PyTuple_SetItem(tuple, 2, PyFloat_FromDouble(value.sxx));
  PyTuple_SetItem(tuple, 3, PyFloat_FromDouble(value.sxy));
  PyTuple_SetItem(tuple, 4, PyFloat_FromDouble(value.syy));
  PyTuple_SetItem(tuple, 5, PyFloat_FromDouble(value.tail));
  return tuple;
}
static PyObject *give_targets_posterior_Law(targets_posterior_Law value) {
  PyObject *tuple = PyTuple_New(6);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyFloat_FromDouble(value.x));
  PyTuple_SetItem(tuple, 1, PyFloat_FromDouble(value.y));
  PyTuple_SetItem(tuple, 2, PyFloat_FromDouble(value.sxx));
  PyTuple_SetItem(tuple, 3, PyFloat_FromDouble(value.sxy));
  PyTuple_SetItem(tuple, 4, PyFloat_FromDouble(value.syy));
  PyTuple_SetItem(tuple, 5, PyFloat_FromDouble(value.tail));
  return tuple;
}
static PyObject *give_targets_posterior_Situation(targets_posterior_Situation value) {
  PyObject *tuple = PyTuple_New(8);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyFloat_FromDouble(value.x));
  PyTuple_SetItem(tuple, 1, PyFloat_FromDouble(value.y));
  PyTuple_SetItem(tuple, 2, PyFloat_FromDouble(value.trail_x));
  PyTuple_SetItem(tuple, 3, PyFloat_FromDouble(value.trail_y));
  PyTuple_SetItem(tuple, 4, PyFloat_FromDouble(value.ux));
  PyTuple_SetItem(tuple, 5, PyFloat_FromDouble(value.uy));
  PyTuple_SetItem(tuple, 6, PyFloat_FromDouble(value.log_way));
  PyTuple_SetItem(tuple, 7, PyFloat_FromDouble(value.log_sweep));
  return tuple;
}
static PyObject *give_targets_prefetch_Expected(targets_prefetch_Expected value) {
  PyObject *tuple = PyTuple_New(2);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyFloat_FromDouble(value.passed));
  PyTuple_SetItem(tuple, 1, PyFloat_FromDouble(value.sure));
  return tuple;
}
static PyObject *give_T8d(T8d value) {
  PyObject *tuple = PyTuple_New(8);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyFloat_FromDouble(value.f0));
  PyTuple_SetItem(tuple, 1, PyFloat_FromDouble(value.f1));
  PyTuple_SetItem(tuple, 2, PyFloat_FromDouble(value.f2));
  PyTuple_SetItem(tuple, 3, PyFloat_FromDouble(value.f3));
  PyTuple_SetItem(tuple, 4, PyFloat_FromDouble(value.f4));
  PyTuple_SetItem(tuple, 5, PyFloat_FromDouble(value.f5));
  PyTuple_SetItem(tuple, 6, PyFloat_FromDouble(value.f6));
  PyTuple_SetItem(tuple, 7, PyFloat_FromDouble(value.f7));
  return tuple;
}
static PyObject *give_Td(Td value) {
  PyObject *tuple = PyTuple_New(1);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyFloat_FromDouble(value.f0));
  return tuple;
}
static PyObject *py_differentiators_difference_advance(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.differentiators.difference:advance";
  Held held;
  const Py_buffer *view;
  differentiators_difference_Differences * a0;
  int64_t a1;
  double a2;
  double a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "last", true, 8, &view)
        && (a0 = view->buf, true)
        && take_int64_t(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  differentiators_difference_advance(a0, a1, a2, a3);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_differentiators_difference_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.differentiators.difference:step";
  Held held;
  const Py_buffer *view;
  differentiators_difference_Memory * a0;
  records_EventRow a1;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "memory", true, 25, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "event", 6)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.t)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.x)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.y)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.dx)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.dy)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.buttons)))
    return let_go(&held);
  result = differentiators_difference_step(a0, a1);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_differentiators_homogeneous_advance(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.differentiators.homogeneous:advance";
  Held held;
  const Py_buffer *view;
  differentiators_homogeneous_Settings * a0;
  differentiators_homogeneous_Axis * a1;
  double a2;
  double a3;
  double a4;
  int64_t a5;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_memory(&held, args[0], law, "settings", false, 17, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "axis", true, 8, &view)
        && (a1 = view->buf, true)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)
        && take_int64_t(args[5], &a5)))
    return let_go(&held);
  result = differentiators_homogeneous_advance(a0, a1, a2, a3, a4, a5);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_differentiators_homogeneous_chatter(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.differentiators.homogeneous:chatter";
  Held held;
  const Py_buffer *view;
  differentiators_homogeneous_Memory * a0;
  double a1;
  double a2;
  int64_t a3;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "memory", true, 47, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_int64_t(args[3], &a3)))
    return let_go(&held);
  result = differentiators_homogeneous_chatter(a0, a1, a2, a3);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_differentiators_homogeneous_fill(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.differentiators.homogeneous:fill";
  Held held;
  const Py_buffer *view;
  Vector a0;
  differentiators_homogeneous_Settings * a1;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "values", 'd', 1, false, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_memory(&held, args[1], law, "settings", true, 17, &view)
        && (a1 = view->buf, true)))
    return let_go(&held);
  differentiators_homogeneous_fill(a0, a1);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_differentiators_homogeneous_place_poles(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.differentiators.homogeneous:place_poles";
  Held held;
  const Py_buffer *view;
  differentiators_homogeneous_Settings * a0;
  double a1;
  double a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "settings", true, 17, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  differentiators_homogeneous_place_poles(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_differentiators_homogeneous_settle(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.differentiators.homogeneous:settle";
  Held held;
  const Py_buffer *view;
  differentiators_homogeneous_Memory * a0;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "memory", true, 47, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  differentiators_homogeneous_settle(a0);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_differentiators_homogeneous_settling(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.differentiators.homogeneous:settling";
  Held held;
  const Py_buffer *view;
  differentiators_homogeneous_Memory * a0;
  double a1;
  double a2;
  int64_t a3;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "memory", true, 47, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_int64_t(args[3], &a3)))
    return let_go(&held);
  result = differentiators_homogeneous_settling(a0, a1, a2, a3);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_differentiators_homogeneous_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.differentiators.homogeneous:step";
  Held held;
  const Py_buffer *view;
  differentiators_homogeneous_Memory * a0;
  records_EventRow a1;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "memory", true, 47, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "event", 6)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.t)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.x)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.y)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.dx)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.dy)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.buttons)))
    return let_go(&held);
  result = differentiators_homogeneous_step(a0, a1);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_differentiators_kalman_correct(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.differentiators.kalman:correct";
  Held held;
  const Py_buffer *view;
  Vector a0;
  differentiators_kalman_Covariance * a1;
  double a2;
  double a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_array(&held, args[0], law, "axis", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_memory(&held, args[1], law, "p", false, 6, &view)
        && (a1 = view->buf, true)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  differentiators_kalman_correct(a0, a1, a2, a3);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_differentiators_kalman_fill(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.differentiators.kalman:fill";
  Held held;
  const Py_buffer *view;
  Vector a0;
  differentiators_kalman_Settings * a1;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "values", 'd', 1, false, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_memory(&held, args[1], law, "settings", true, 6, &view)
        && (a1 = view->buf, true)))
    return let_go(&held);
  differentiators_kalman_fill(a0, a1);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_differentiators_kalman_follow(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.differentiators.kalman:follow";
  Held held;
  const Py_buffer *view;
  differentiators_kalman_Plane * a0;
  double a1;
  double a2;
  double a3;
  T2d a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "plane", true, 12, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_tuple(args[4], law, "place", 2)
        && take_double(PyTuple_GetItem(args[4], 0), &a4.f0)
        && take_double(PyTuple_GetItem(args[4], 1), &a4.f1)))
    return let_go(&held);
  differentiators_kalman_follow(a0, a1, a2, a3, a4);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_differentiators_kalman_narrow(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.differentiators.kalman:narrow";
  Held held;
  const Py_buffer *view;
  differentiators_kalman_Covariance * a0;
  double a1;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "p", true, 6, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)))
    return let_go(&held);
  differentiators_kalman_narrow(a0, a1);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_differentiators_kalman_predict(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.differentiators.kalman:predict";
  Held held;
  const Py_buffer *view;
  Vector a0;
  double a1;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "axis", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_double(args[1], &a1)))
    return let_go(&held);
  differentiators_kalman_predict(a0, a1);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_differentiators_kalman_restart(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.differentiators.kalman:restart";
  Held held;
  const Py_buffer *view;
  differentiators_kalman_Plane * a0;
  double a1;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "plane", true, 12, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)))
    return let_go(&held);
  differentiators_kalman_restart(a0, a1);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_differentiators_kalman_settle_s(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.differentiators.kalman:settle_s";
  Held held;
  const Py_buffer *view;
  differentiators_kalman_Settings * a0;
  differentiators_sampling_State * a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "settings", false, 6, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "samples", false, 12, &view)
        && (a1 = view->buf, true)))
    return let_go(&held);
  result = differentiators_kalman_settle_s(a0, a1);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_differentiators_kalman_spread(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.differentiators.kalman:spread";
  Held held;
  const Py_buffer *view;
  differentiators_kalman_Covariance * a0;
  double a1;
  double a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "p", true, 6, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  differentiators_kalman_spread(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_differentiators_kalman_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.differentiators.kalman:step";
  Held held;
  const Py_buffer *view;
  differentiators_kalman_Memory * a0;
  records_EventRow a1;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "memory", true, 30, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "event", 6)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.t)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.x)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.y)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.dx)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.dy)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.buttons)))
    return let_go(&held);
  result = differentiators_kalman_step(a0, a1);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_differentiators_sampling_accept(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.differentiators.sampling:accept";
  Held held;
  const Py_buffer *view;
  differentiators_sampling_Settings * a0;
  differentiators_sampling_State * a1;
  records_EventRow a2;
  Tq3db result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "settings", false, 4, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "s", true, 12, &view)
        && (a1 = view->buf, true)
        && take_tuple(args[2], law, "event", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = differentiators_sampling_accept(a0, a1, a2);
  let_go(&held);
  return give_Tq3db(result);
}
static PyObject *py_differentiators_sampling_fill(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.differentiators.sampling:fill";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "values", 'd', 1, false, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "memory", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  differentiators_sampling_fill(a0, a1);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_differentiators_sampling_motion(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.differentiators.sampling:motion";
  Held held;
  const Py_buffer *view;
  differentiators_sampling_State * a0;
  records_EventRow a1;
  T2_T2d_ a2;
  double a3;
  bool a4;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "s", false, 12, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "event", 6)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.t)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.x)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.y)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.dx)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.dy)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.buttons)
        && take_tuple(args[2], law, "hand", 2)
        && take_tuple(PyTuple_GetItem(args[2], 0), law, "hand", 2)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[2], 0), 0), &a2.f0.f0)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[2], 0), 1), &a2.f0.f1)
        && take_tuple(PyTuple_GetItem(args[2], 1), law, "hand", 2)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[2], 1), 0), &a2.f1.f0)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[2], 1), 1), &a2.f1.f1)
        && take_double(args[3], &a3)
        && take_bool(args[4], &a4)))
    return let_go(&held);
  result = differentiators_sampling_motion(a0, a1, a2, a3, a4);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_differentiators_sampling_settled(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.differentiators.sampling:settled";
  Held held;
  const Py_buffer *view;
  differentiators_sampling_State * a0;
  double a1;
  double a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "s", false, 12, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = differentiators_sampling_settled(a0, a1, a2);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_follow__predictors_adaptation_predictor_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:_following (pointpred.predictors.adaptation.predictor:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  T10d a1;
  Vector a2;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[1], law, "row", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.f6)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.f7)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.f8)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.f9)
        && take_array(&held, args[2], law, "shared_0", 'd', 1, false, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  result = follow__predictors_adaptation_predictor_step(a0, a1, a2);
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_follow__predictors_delphian_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:_following (pointpred.predictors.delphian:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  T10d a1;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[1], law, "row", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.f6)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.f7)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.f8)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.f9)))
    return let_go(&held);
  result = follow__predictors_delphian_step(a0, a1);
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_follow__predictors_hold_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:_following (pointpred.predictors.hold:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  T10d a1;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[1], law, "row", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.f6)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.f7)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.f8)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.f9)))
    return let_go(&held);
  result = follow__predictors_hold_step(a0, a1);
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_follow__predictors_kalman_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:_following (pointpred.predictors.kalman:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  T10d a1;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[1], law, "row", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.f6)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.f7)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.f8)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.f9)))
    return let_go(&held);
  result = follow__predictors_kalman_step(a0, a1);
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_follow__predictors_kep_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:_following (pointpred.predictors.kep:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  T10d a1;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[1], law, "row", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.f6)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.f7)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.f8)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.f9)))
    return let_go(&held);
  result = follow__predictors_kep_step(a0, a1);
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_follow__predictors_ktm_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:_following (pointpred.predictors.ktm:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  T10d a1;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[1], law, "row", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.f6)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.f7)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.f8)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.f9)))
    return let_go(&held);
  result = follow__predictors_ktm_step(a0, a1);
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_follow__predictors_linear_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:_following (pointpred.predictors.linear:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  T10d a1;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[1], law, "row", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.f6)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.f7)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.f8)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.f9)))
    return let_go(&held);
  result = follow__predictors_linear_step(a0, a1);
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_follow__predictors_minimum_jerk_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:_following (pointpred.predictors.minimum_jerk:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  T10d a1;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[1], law, "row", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.f6)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.f7)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.f8)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.f9)))
    return let_go(&held);
  result = follow__predictors_minimum_jerk_step(a0, a1);
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_follow__predictors_switched_direction_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:_following (pointpred.predictors.switched_direction:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  T10d a1;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[1], law, "row", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.f6)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.f7)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.f8)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.f9)))
    return let_go(&held);
  result = follow__predictors_switched_direction_step(a0, a1);
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_follow__predictors_switched_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:_following (pointpred.predictors.switched:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  T10d a1;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[1], law, "row", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.f6)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.f7)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.f8)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.f9)))
    return let_go(&held);
  result = follow__predictors_switched_step(a0, a1);
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_joint__differentiators_difference_step__predictors_adaptation_predictor_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.difference:step) (pointpred.predictors.adaptation.predictor:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  Vector a3;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)
        && take_array(&held, args[3], law, "shared_0", 'd', 1, false, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  result = joint__differentiators_difference_step__predictors_adaptation_predictor_step(a0, a1, a2, a3);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_difference_step__predictors_delphian_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.difference:step) (pointpred.predictors.delphian:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_difference_step__predictors_delphian_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_difference_step__predictors_hold_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.difference:step) (pointpred.predictors.hold:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_difference_step__predictors_hold_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_difference_step__predictors_kalman_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.difference:step) (pointpred.predictors.kalman:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_difference_step__predictors_kalman_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_difference_step__predictors_kep_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.difference:step) (pointpred.predictors.kep:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_difference_step__predictors_kep_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_difference_step__predictors_kinematic_predictor_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.difference:step) (pointpred.predictors.kinematic.predictor:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  Vector a3;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)
        && take_array(&held, args[3], law, "shared_0", 'd', 1, false, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  result = joint__differentiators_difference_step__predictors_kinematic_predictor_step(a0, a1, a2, a3);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_difference_step__predictors_ktm_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.difference:step) (pointpred.predictors.ktm:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_difference_step__predictors_ktm_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_difference_step__predictors_linear_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.difference:step) (pointpred.predictors.linear:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_difference_step__predictors_linear_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_difference_step__predictors_minimum_jerk_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.difference:step) (pointpred.predictors.minimum_jerk:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_difference_step__predictors_minimum_jerk_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_difference_step__predictors_switched_direction_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.difference:step) (pointpred.predictors.switched_direction:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_difference_step__predictors_switched_direction_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_difference_step__predictors_switched_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.difference:step) (pointpred.predictors.switched:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_difference_step__predictors_switched_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_homogeneous_step__predictors_adaptation_predictor_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.homogeneous:step) (pointpred.predictors.adaptation.predictor:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  Vector a3;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)
        && take_array(&held, args[3], law, "shared_0", 'd', 1, false, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  result = joint__differentiators_homogeneous_step__predictors_adaptation_predictor_step(a0, a1, a2, a3);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_homogeneous_step__predictors_delphian_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.homogeneous:step) (pointpred.predictors.delphian:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_homogeneous_step__predictors_delphian_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_homogeneous_step__predictors_hold_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.homogeneous:step) (pointpred.predictors.hold:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_homogeneous_step__predictors_hold_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_homogeneous_step__predictors_kalman_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.homogeneous:step) (pointpred.predictors.kalman:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_homogeneous_step__predictors_kalman_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_homogeneous_step__predictors_kep_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.homogeneous:step) (pointpred.predictors.kep:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_homogeneous_step__predictors_kep_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_homogeneous_step__predictors_kinematic_predictor_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.homogeneous:step) (pointpred.predictors.kinematic.predictor:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  Vector a3;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)
        && take_array(&held, args[3], law, "shared_0", 'd', 1, false, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  result = joint__differentiators_homogeneous_step__predictors_kinematic_predictor_step(a0, a1, a2, a3);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_homogeneous_step__predictors_ktm_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.homogeneous:step) (pointpred.predictors.ktm:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_homogeneous_step__predictors_ktm_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_homogeneous_step__predictors_linear_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.homogeneous:step) (pointpred.predictors.linear:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_homogeneous_step__predictors_linear_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_homogeneous_step__predictors_minimum_jerk_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.homogeneous:step) (pointpred.predictors.minimum_jerk:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_homogeneous_step__predictors_minimum_jerk_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_homogeneous_step__predictors_switched_direction_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.homogeneous:step) (pointpred.predictors.switched_direction:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_homogeneous_step__predictors_switched_direction_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_homogeneous_step__predictors_switched_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.homogeneous:step) (pointpred.predictors.switched:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_homogeneous_step__predictors_switched_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_kalman_step__predictors_adaptation_predictor_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.kalman:step) (pointpred.predictors.adaptation.predictor:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  Vector a3;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)
        && take_array(&held, args[3], law, "shared_0", 'd', 1, false, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  result = joint__differentiators_kalman_step__predictors_adaptation_predictor_step(a0, a1, a2, a3);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_kalman_step__predictors_delphian_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.kalman:step) (pointpred.predictors.delphian:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_kalman_step__predictors_delphian_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_kalman_step__predictors_hold_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.kalman:step) (pointpred.predictors.hold:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_kalman_step__predictors_hold_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_kalman_step__predictors_kalman_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.kalman:step) (pointpred.predictors.kalman:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_kalman_step__predictors_kalman_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_kalman_step__predictors_kep_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.kalman:step) (pointpred.predictors.kep:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_kalman_step__predictors_kep_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_kalman_step__predictors_kinematic_predictor_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.kalman:step) (pointpred.predictors.kinematic.predictor:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  Vector a3;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)
        && take_array(&held, args[3], law, "shared_0", 'd', 1, false, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  result = joint__differentiators_kalman_step__predictors_kinematic_predictor_step(a0, a1, a2, a3);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_kalman_step__predictors_ktm_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.kalman:step) (pointpred.predictors.ktm:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_kalman_step__predictors_ktm_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_kalman_step__predictors_linear_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.kalman:step) (pointpred.predictors.linear:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_kalman_step__predictors_linear_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_kalman_step__predictors_minimum_jerk_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.kalman:step) (pointpred.predictors.minimum_jerk:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_kalman_step__predictors_minimum_jerk_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_kalman_step__predictors_switched_direction_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.kalman:step) (pointpred.predictors.switched_direction:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_kalman_step__predictors_switched_direction_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_joint__differentiators_kalman_step__predictors_switched_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:joint_of (pointpred.differentiators.kalman:step) (pointpred.predictors.switched:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  records_EventRow a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "row", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.dx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.dy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.buttons)))
    return let_go(&held);
  result = joint__differentiators_kalman_step__predictors_switched_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_difference_step__follow__predictors_adaptation_predictor_step__predictors_adaptation_predictor_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.difference:step) (pointpred.pipeline:_following (pointpred.predictors.adaptation.predictor:step)) (pointpred.predictors.adaptation.predictor:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  Vector a3;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)
        && take_array(&held, args[3], law, "shared_0", 'd', 1, false, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_difference_step__follow__predictors_adaptation_predictor_step__predictors_adaptation_predictor_step(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_difference_step__follow__predictors_delphian_step__predictors_delphian_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.difference:step) (pointpred.pipeline:_following (pointpred.predictors.delphian:step)) (pointpred.predictors.delphian:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_difference_step__follow__predictors_delphian_step__predictors_delphian_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_difference_step__follow__predictors_hold_step__predictors_hold_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.difference:step) (pointpred.pipeline:_following (pointpred.predictors.hold:step)) (pointpred.predictors.hold:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_difference_step__follow__predictors_hold_step__predictors_hold_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_difference_step__follow__predictors_kalman_step__predictors_kalman_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.difference:step) (pointpred.pipeline:_following (pointpred.predictors.kalman:step)) (pointpred.predictors.kalman:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_difference_step__follow__predictors_kalman_step__predictors_kalman_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_difference_step__follow__predictors_kep_step__predictors_kep_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.difference:step) (pointpred.pipeline:_following (pointpred.predictors.kep:step)) (pointpred.predictors.kep:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_difference_step__follow__predictors_kep_step__predictors_kep_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_difference_step__follow__predictors_ktm_step__predictors_ktm_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.difference:step) (pointpred.pipeline:_following (pointpred.predictors.ktm:step)) (pointpred.predictors.ktm:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_difference_step__follow__predictors_ktm_step__predictors_ktm_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_difference_step__follow__predictors_linear_step__predictors_linear_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.difference:step) (pointpred.pipeline:_following (pointpred.predictors.linear:step)) (pointpred.predictors.linear:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_difference_step__follow__predictors_linear_step__predictors_linear_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_difference_step__follow__predictors_minimum_jerk_step__predictors_minimum_jerk_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.difference:step) (pointpred.pipeline:_following (pointpred.predictors.minimum_jerk:step)) (pointpred.predictors.minimum_jerk:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_difference_step__follow__predictors_minimum_jerk_step__predictors_minimum_jerk_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_difference_step__follow__predictors_switched_direction_step__predictors_switched_direction_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.difference:step) (pointpred.pipeline:_following (pointpred.predictors.switched_direction:step)) (pointpred.predictors.switched_direction:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_difference_step__follow__predictors_switched_direction_step__predictors_switched_direction_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_difference_step__follow__predictors_switched_step__predictors_switched_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.difference:step) (pointpred.pipeline:_following (pointpred.predictors.switched:step)) (pointpred.predictors.switched:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_difference_step__follow__predictors_switched_step__predictors_switched_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_difference_step__predictors_kinematic_predictor_follow__predictors_kinematic_predictor_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.difference:step) (pointpred.predictors.kinematic.predictor:follow) (pointpred.predictors.kinematic.predictor:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  Vector a3;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)
        && take_array(&held, args[3], law, "shared_0", 'd', 1, false, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_difference_step__predictors_kinematic_predictor_follow__predictors_kinematic_predictor_step(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_homogeneous_step__follow__predictors_adaptation_predictor_step__predictors_adaptation_predictor_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.homogeneous:step) (pointpred.pipeline:_following (pointpred.predictors.adaptation.predictor:step)) (pointpred.predictors.adaptation.predictor:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  Vector a3;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)
        && take_array(&held, args[3], law, "shared_0", 'd', 1, false, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_homogeneous_step__follow__predictors_adaptation_predictor_step__predictors_adaptation_predictor_step(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_homogeneous_step__follow__predictors_delphian_step__predictors_delphian_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.homogeneous:step) (pointpred.pipeline:_following (pointpred.predictors.delphian:step)) (pointpred.predictors.delphian:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_homogeneous_step__follow__predictors_delphian_step__predictors_delphian_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_homogeneous_step__follow__predictors_hold_step__predictors_hold_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.homogeneous:step) (pointpred.pipeline:_following (pointpred.predictors.hold:step)) (pointpred.predictors.hold:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_homogeneous_step__follow__predictors_hold_step__predictors_hold_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_homogeneous_step__follow__predictors_kalman_step__predictors_kalman_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.homogeneous:step) (pointpred.pipeline:_following (pointpred.predictors.kalman:step)) (pointpred.predictors.kalman:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_homogeneous_step__follow__predictors_kalman_step__predictors_kalman_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_homogeneous_step__follow__predictors_kep_step__predictors_kep_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.homogeneous:step) (pointpred.pipeline:_following (pointpred.predictors.kep:step)) (pointpred.predictors.kep:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_homogeneous_step__follow__predictors_kep_step__predictors_kep_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_homogeneous_step__follow__predictors_ktm_step__predictors_ktm_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.homogeneous:step) (pointpred.pipeline:_following (pointpred.predictors.ktm:step)) (pointpred.predictors.ktm:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_homogeneous_step__follow__predictors_ktm_step__predictors_ktm_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_homogeneous_step__follow__predictors_linear_step__predictors_linear_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.homogeneous:step) (pointpred.pipeline:_following (pointpred.predictors.linear:step)) (pointpred.predictors.linear:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_homogeneous_step__follow__predictors_linear_step__predictors_linear_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_homogeneous_step__follow__predictors_minimum_jerk_step__predictors_minimum_jerk_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.homogeneous:step) (pointpred.pipeline:_following (pointpred.predictors.minimum_jerk:step)) (pointpred.predictors.minimum_jerk:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_homogeneous_step__follow__predictors_minimum_jerk_step__predictors_minimum_jerk_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_homogeneous_step__follow__predictors_switched_direction_step__predictors_switched_direction_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.homogeneous:step) (pointpred.pipeline:_following (pointpred.predictors.switched_direction:step)) (pointpred.predictors.switched_direction:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_homogeneous_step__follow__predictors_switched_direction_step__predictors_switched_direction_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_homogeneous_step__follow__predictors_switched_step__predictors_switched_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.homogeneous:step) (pointpred.pipeline:_following (pointpred.predictors.switched:step)) (pointpred.predictors.switched:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_homogeneous_step__follow__predictors_switched_step__predictors_switched_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_homogeneous_step__predictors_kinematic_predictor_follow__predictors_kinematic_predictor_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.homogeneous:step) (pointpred.predictors.kinematic.predictor:follow) (pointpred.predictors.kinematic.predictor:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  Vector a3;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)
        && take_array(&held, args[3], law, "shared_0", 'd', 1, false, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_homogeneous_step__predictors_kinematic_predictor_follow__predictors_kinematic_predictor_step(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_kalman_step__follow__predictors_adaptation_predictor_step__predictors_adaptation_predictor_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.kalman:step) (pointpred.pipeline:_following (pointpred.predictors.adaptation.predictor:step)) (pointpred.predictors.adaptation.predictor:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  Vector a3;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)
        && take_array(&held, args[3], law, "shared_0", 'd', 1, false, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_kalman_step__follow__predictors_adaptation_predictor_step__predictors_adaptation_predictor_step(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_kalman_step__follow__predictors_delphian_step__predictors_delphian_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.kalman:step) (pointpred.pipeline:_following (pointpred.predictors.delphian:step)) (pointpred.predictors.delphian:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_kalman_step__follow__predictors_delphian_step__predictors_delphian_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_kalman_step__follow__predictors_hold_step__predictors_hold_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.kalman:step) (pointpred.pipeline:_following (pointpred.predictors.hold:step)) (pointpred.predictors.hold:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_kalman_step__follow__predictors_hold_step__predictors_hold_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_kalman_step__follow__predictors_kalman_step__predictors_kalman_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.kalman:step) (pointpred.pipeline:_following (pointpred.predictors.kalman:step)) (pointpred.predictors.kalman:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_kalman_step__follow__predictors_kalman_step__predictors_kalman_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_kalman_step__follow__predictors_kep_step__predictors_kep_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.kalman:step) (pointpred.pipeline:_following (pointpred.predictors.kep:step)) (pointpred.predictors.kep:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_kalman_step__follow__predictors_kep_step__predictors_kep_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_kalman_step__follow__predictors_ktm_step__predictors_ktm_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.kalman:step) (pointpred.pipeline:_following (pointpred.predictors.ktm:step)) (pointpred.predictors.ktm:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_kalman_step__follow__predictors_ktm_step__predictors_ktm_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_kalman_step__follow__predictors_linear_step__predictors_linear_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.kalman:step) (pointpred.pipeline:_following (pointpred.predictors.linear:step)) (pointpred.predictors.linear:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_kalman_step__follow__predictors_linear_step__predictors_linear_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_kalman_step__follow__predictors_minimum_jerk_step__predictors_minimum_jerk_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.kalman:step) (pointpred.pipeline:_following (pointpred.predictors.minimum_jerk:step)) (pointpred.predictors.minimum_jerk:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_kalman_step__follow__predictors_minimum_jerk_step__predictors_minimum_jerk_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_kalman_step__follow__predictors_switched_direction_step__predictors_switched_direction_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.kalman:step) (pointpred.pipeline:_following (pointpred.predictors.switched_direction:step)) (pointpred.predictors.switched_direction:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_kalman_step__follow__predictors_switched_direction_step__predictors_switched_direction_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_kalman_step__follow__predictors_switched_step__predictors_switched_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.kalman:step) (pointpred.pipeline:_following (pointpred.predictors.switched:step)) (pointpred.predictors.switched:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_kalman_step__follow__predictors_switched_step__predictors_switched_step(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_last__differentiators_kalman_step__predictors_kinematic_predictor_follow__predictors_kinematic_predictor_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.pipeline:last_of (pointpred.differentiators.kalman:step) (pointpred.predictors.kinematic.predictor:follow) (pointpred.predictors.kinematic.predictor:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  Vector a3;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "other", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 6)
        && take_array(&held, args[3], law, "shared_0", 'd', 1, false, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = last__differentiators_kalman_step__predictors_kinematic_predictor_follow__predictors_kinematic_predictor_step(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_loop__predictors_adaptation_predictor_conclude__records_row_at__predictors_adaptation_predictor_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.stage:loop_of (pointpred.predictors.adaptation.predictor:conclude) (pointpred.records:row_at) (pointpred.predictors.adaptation.predictor:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  int64_t a1;
  FlagVector a2;
  Table a3;
  Table a4;
  Vector a5;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_int64_t(args[1], &a1)
        && take_array(&held, args[2], law, "begin", 'b', 1, false, &view)
        && (a2 = (FlagVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "rows", 'd', 2, false, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a3.m, 10)
        && take_array(&held, args[4], law, "out", 'd', 2, true, &view)
        && (a4 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[5], law, "shared_0", 'd', 1, false, &view)
        && (a5 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS loop__predictors_adaptation_predictor_conclude__records_row_at__predictors_adaptation_predictor_step(a0, a1, a2, a3, a4, a5); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_loop__predictors_ktm_conclude__records_row_at__predictors_ktm_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.stage:loop_of (pointpred.predictors.ktm:conclude) (pointpred.records:row_at) (pointpred.predictors.ktm:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  int64_t a1;
  FlagVector a2;
  Table a3;
  Table a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_int64_t(args[1], &a1)
        && take_array(&held, args[2], law, "begin", 'b', 1, false, &view)
        && (a2 = (FlagVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "rows", 'd', 2, false, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a3.m, 10)
        && take_array(&held, args[4], law, "out", 'd', 2, true, &view)
        && (a4 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS loop__predictors_ktm_conclude__records_row_at__predictors_ktm_step(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_loop__stage_learn_nothing__records_event_at__differentiators_difference_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.stage:loop_of (pointpred.stage:learn_nothing) (pointpred.records:event_at) (pointpred.differentiators.difference:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  int64_t a1;
  FlagVector a2;
  Table a3;
  Table a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_int64_t(args[1], &a1)
        && take_array(&held, args[2], law, "begin", 'b', 1, false, &view)
        && (a2 = (FlagVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "rows", 'd', 2, false, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a3.m, 6)
        && take_array(&held, args[4], law, "out", 'd', 2, true, &view)
        && (a4 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS loop__stage_learn_nothing__records_event_at__differentiators_difference_step(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_loop__stage_learn_nothing__records_event_at__differentiators_homogeneous_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.stage:loop_of (pointpred.stage:learn_nothing) (pointpred.records:event_at) (pointpred.differentiators.homogeneous:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  int64_t a1;
  FlagVector a2;
  Table a3;
  Table a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_int64_t(args[1], &a1)
        && take_array(&held, args[2], law, "begin", 'b', 1, false, &view)
        && (a2 = (FlagVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "rows", 'd', 2, false, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a3.m, 6)
        && take_array(&held, args[4], law, "out", 'd', 2, true, &view)
        && (a4 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS loop__stage_learn_nothing__records_event_at__differentiators_homogeneous_step(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_loop__stage_learn_nothing__records_event_at__differentiators_kalman_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.stage:loop_of (pointpred.stage:learn_nothing) (pointpred.records:event_at) (pointpred.differentiators.kalman:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  int64_t a1;
  FlagVector a2;
  Table a3;
  Table a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_int64_t(args[1], &a1)
        && take_array(&held, args[2], law, "begin", 'b', 1, false, &view)
        && (a2 = (FlagVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "rows", 'd', 2, false, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a3.m, 6)
        && take_array(&held, args[4], law, "out", 'd', 2, true, &view)
        && (a4 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS loop__stage_learn_nothing__records_event_at__differentiators_kalman_step(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_loop__stage_learn_nothing__records_row_at__predictors_delphian_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.stage:loop_of (pointpred.stage:learn_nothing) (pointpred.records:row_at) (pointpred.predictors.delphian:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  int64_t a1;
  FlagVector a2;
  Table a3;
  Table a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_int64_t(args[1], &a1)
        && take_array(&held, args[2], law, "begin", 'b', 1, false, &view)
        && (a2 = (FlagVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "rows", 'd', 2, false, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a3.m, 10)
        && take_array(&held, args[4], law, "out", 'd', 2, true, &view)
        && (a4 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS loop__stage_learn_nothing__records_row_at__predictors_delphian_step(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_loop__stage_learn_nothing__records_row_at__predictors_hold_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.stage:loop_of (pointpred.stage:learn_nothing) (pointpred.records:row_at) (pointpred.predictors.hold:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  int64_t a1;
  FlagVector a2;
  Table a3;
  Table a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_int64_t(args[1], &a1)
        && take_array(&held, args[2], law, "begin", 'b', 1, false, &view)
        && (a2 = (FlagVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "rows", 'd', 2, false, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a3.m, 10)
        && take_array(&held, args[4], law, "out", 'd', 2, true, &view)
        && (a4 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS loop__stage_learn_nothing__records_row_at__predictors_hold_step(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_loop__stage_learn_nothing__records_row_at__predictors_kalman_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.stage:loop_of (pointpred.stage:learn_nothing) (pointpred.records:row_at) (pointpred.predictors.kalman:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  int64_t a1;
  FlagVector a2;
  Table a3;
  Table a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_int64_t(args[1], &a1)
        && take_array(&held, args[2], law, "begin", 'b', 1, false, &view)
        && (a2 = (FlagVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "rows", 'd', 2, false, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a3.m, 10)
        && take_array(&held, args[4], law, "out", 'd', 2, true, &view)
        && (a4 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS loop__stage_learn_nothing__records_row_at__predictors_kalman_step(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_loop__stage_learn_nothing__records_row_at__predictors_kep_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.stage:loop_of (pointpred.stage:learn_nothing) (pointpred.records:row_at) (pointpred.predictors.kep:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  int64_t a1;
  FlagVector a2;
  Table a3;
  Table a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_int64_t(args[1], &a1)
        && take_array(&held, args[2], law, "begin", 'b', 1, false, &view)
        && (a2 = (FlagVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "rows", 'd', 2, false, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a3.m, 10)
        && take_array(&held, args[4], law, "out", 'd', 2, true, &view)
        && (a4 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS loop__stage_learn_nothing__records_row_at__predictors_kep_step(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_loop__stage_learn_nothing__records_row_at__predictors_kinematic_predictor_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.stage:loop_of (pointpred.stage:learn_nothing) (pointpred.records:row_at) (pointpred.predictors.kinematic.predictor:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  int64_t a1;
  FlagVector a2;
  Table a3;
  Table a4;
  Vector a5;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_int64_t(args[1], &a1)
        && take_array(&held, args[2], law, "begin", 'b', 1, false, &view)
        && (a2 = (FlagVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "rows", 'd', 2, false, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a3.m, 10)
        && take_array(&held, args[4], law, "out", 'd', 2, true, &view)
        && (a4 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[5], law, "shared_0", 'd', 1, false, &view)
        && (a5 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS loop__stage_learn_nothing__records_row_at__predictors_kinematic_predictor_step(a0, a1, a2, a3, a4, a5); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_loop__stage_learn_nothing__records_row_at__predictors_linear_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.stage:loop_of (pointpred.stage:learn_nothing) (pointpred.records:row_at) (pointpred.predictors.linear:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  int64_t a1;
  FlagVector a2;
  Table a3;
  Table a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_int64_t(args[1], &a1)
        && take_array(&held, args[2], law, "begin", 'b', 1, false, &view)
        && (a2 = (FlagVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "rows", 'd', 2, false, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a3.m, 10)
        && take_array(&held, args[4], law, "out", 'd', 2, true, &view)
        && (a4 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS loop__stage_learn_nothing__records_row_at__predictors_linear_step(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_loop__stage_learn_nothing__records_row_at__predictors_minimum_jerk_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.stage:loop_of (pointpred.stage:learn_nothing) (pointpred.records:row_at) (pointpred.predictors.minimum_jerk:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  int64_t a1;
  FlagVector a2;
  Table a3;
  Table a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_int64_t(args[1], &a1)
        && take_array(&held, args[2], law, "begin", 'b', 1, false, &view)
        && (a2 = (FlagVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "rows", 'd', 2, false, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a3.m, 10)
        && take_array(&held, args[4], law, "out", 'd', 2, true, &view)
        && (a4 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS loop__stage_learn_nothing__records_row_at__predictors_minimum_jerk_step(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_loop__stage_learn_nothing__records_row_at__predictors_switched_direction_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.stage:loop_of (pointpred.stage:learn_nothing) (pointpred.records:row_at) (pointpred.predictors.switched_direction:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  int64_t a1;
  FlagVector a2;
  Table a3;
  Table a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_int64_t(args[1], &a1)
        && take_array(&held, args[2], law, "begin", 'b', 1, false, &view)
        && (a2 = (FlagVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "rows", 'd', 2, false, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a3.m, 10)
        && take_array(&held, args[4], law, "out", 'd', 2, true, &view)
        && (a4 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS loop__stage_learn_nothing__records_row_at__predictors_switched_direction_step(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_loop__stage_learn_nothing__records_row_at__predictors_switched_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.stage:loop_of (pointpred.stage:learn_nothing) (pointpred.records:row_at) (pointpred.predictors.switched:step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  int64_t a1;
  FlagVector a2;
  Table a3;
  Table a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_int64_t(args[1], &a1)
        && take_array(&held, args[2], law, "begin", 'b', 1, false, &view)
        && (a2 = (FlagVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "rows", 'd', 2, false, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a3.m, 10)
        && take_array(&held, args[4], law, "out", 'd', 2, true, &view)
        && (a4 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS loop__stage_learn_nothing__records_row_at__predictors_switched_step(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_loop__stage_learn_nothing__transfer_assistance_guided_report_at__transfer_assistance_guarded_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.stage:loop_of (pointpred.stage:learn_nothing) (pointpred.transfer.assistance:guided_report_at) (pointpred.transfer.assistance:guarded_step)";
  Held held;
  const Py_buffer *view;
  Vector a0;
  int64_t a1;
  FlagVector a2;
  Table a3;
  Table a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_int64_t(args[1], &a1)
        && take_array(&held, args[2], law, "begin", 'b', 1, false, &view)
        && (a2 = (FlagVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "rows", 'd', 2, false, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a3.m, 8)
        && take_array(&held, args[4], law, "out", 'd', 2, true, &view)
        && (a4 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS loop__stage_learn_nothing__transfer_assistance_guided_report_at__transfer_assistance_guarded_step(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_arrival_intervals_judge(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.arrival_intervals:judge";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_arrival_intervals_Intervals * a0;
  double a1;
  double a2;
  T2d a3;
  double a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "s", true, 4, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_tuple(args[3], law, "claim", 2)
        && take_double(PyTuple_GetItem(args[3], 0), &a3.f0)
        && take_double(PyTuple_GetItem(args[3], 1), &a3.f1)
        && take_double(args[4], &a4)))
    return let_go(&held);
  predictors_adaptation_arrival_intervals_judge(a0, a1, a2, a3, a4);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_arrival_intervals_next_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.arrival_intervals:next_step";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_arrival_intervals_Intervals * a0;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "s", true, 4, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  result = predictors_adaptation_arrival_intervals_next_step(a0);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_arrival_intervals_spread(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.arrival_intervals:spread";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_arrival_intervals_Intervals * a0;
  double a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "s", false, 4, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)))
    return let_go(&held);
  result = predictors_adaptation_arrival_intervals_spread(a0, a1);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_correction_adapt(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.correction:adapt";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_correction_Settings * a0;
  predictors_adaptation_correction_Person * a1;
  predictors_adaptation_correction_Movement * a2;
  T10d a3;
  predictors_adaptation_time_left_Pace a4;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "settings", false, 7, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "person", false, 628, &view)
        && (a1 = view->buf, true)
        && take_memory(&held, args[2], law, "movement", true, 3037, &view)
        && (a2 = view->buf, true)
        && take_tuple(args[3], law, "answer", 10)
        && take_double(PyTuple_GetItem(args[3], 0), &a3.f0)
        && take_double(PyTuple_GetItem(args[3], 1), &a3.f1)
        && take_double(PyTuple_GetItem(args[3], 2), &a3.f2)
        && take_double(PyTuple_GetItem(args[3], 3), &a3.f3)
        && take_double(PyTuple_GetItem(args[3], 4), &a3.f4)
        && take_double(PyTuple_GetItem(args[3], 5), &a3.f5)
        && take_double(PyTuple_GetItem(args[3], 6), &a3.f6)
        && take_double(PyTuple_GetItem(args[3], 7), &a3.f7)
        && take_double(PyTuple_GetItem(args[3], 8), &a3.f8)
        && take_double(PyTuple_GetItem(args[3], 9), &a3.f9)
        && take_tuple(args[4], law, "pace", 2)
        && take_double(PyTuple_GetItem(args[4], 0), &a4.of_peak)
        && take_double(PyTuple_GetItem(args[4], 1), &a4.slow_s)))
    return let_go(&held);
  result = predictors_adaptation_correction_adapt(a0, a1, a2, a3, a4);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_predictors_adaptation_correction_adapted_end(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.correction:adapted_end";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_correction_Settings * a0;
  predictors_adaptation_correction_Person * a1;
  predictors_adaptation_correction_Movement * a2;
  predictors_adaptation_destination_Heading a3;
  double a4;
  T2_predictors_adaptation_destination_Heading_ result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "settings", false, 7, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "person", false, 628, &view)
        && (a1 = view->buf, true)
        && take_memory(&held, args[2], law, "movement", true, 3037, &view)
        && (a2 = view->buf, true)
        && take_tuple(args[3], law, "own", 7)
        && take_double(PyTuple_GetItem(args[3], 0), &a3.x)
        && take_double(PyTuple_GetItem(args[3], 1), &a3.y)
        && take_double(PyTuple_GetItem(args[3], 2), &a3.ux)
        && take_double(PyTuple_GetItem(args[3], 3), &a3.uy)
        && take_double(PyTuple_GetItem(args[3], 4), &a3.wide)
        && take_double(PyTuple_GetItem(args[3], 5), &a3.broad)
        && take_double(PyTuple_GetItem(args[3], 6), &a3.tail)
        && take_double(args[4], &a4)))
    return let_go(&held);
  result = predictors_adaptation_correction_adapted_end(a0, a1, a2, a3, a4);
  let_go(&held);
  return give_T2_predictors_adaptation_destination_Heading_(result);
}
static PyObject *py_predictors_adaptation_correction_ahead_of(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.correction:ahead_of";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_correction_Movement * a0;
  predictors_adaptation_destination_Heading a1;
  T2d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "movement", false, 3037, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "heading", 7)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.x)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.y)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.ux)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.uy)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.wide)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.broad)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.tail)))
    return let_go(&held);
  result = predictors_adaptation_correction_ahead_of(a0, a1);
  let_go(&held);
  return give_T2d(result);
}
static PyObject *py_predictors_adaptation_correction_arrival(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.correction:arrival";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_correction_Movement * a0;
  double a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "movement", false, 3037, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)))
    return let_go(&held);
  result = predictors_adaptation_correction_arrival(a0, a1);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_correction_by_distances(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.correction:by_distances";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_correction_Person * a0;
  predictors_adaptation_correction_Movement * a1;
  predictors_adaptation_destination_Heading a2;
  double a3;
  T_predictors_adaptation_destination_Heading_d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "person", false, 628, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "movement", false, 3037, &view)
        && (a1 = view->buf, true)
        && take_tuple(args[2], law, "own", 7)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.ux)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.uy)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.wide)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.broad)
        && take_double(PyTuple_GetItem(args[2], 6), &a2.tail)
        && take_double(args[3], &a3)))
    return let_go(&held);
  result = predictors_adaptation_correction_by_distances(a0, a1, a2, a3);
  let_go(&held);
  return give_T_predictors_adaptation_destination_Heading_d(result);
}
static PyObject *py_predictors_adaptation_correction_by_places(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.correction:by_places";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_correction_Settings * a0;
  predictors_adaptation_correction_Person * a1;
  predictors_adaptation_correction_Movement * a2;
  T2_predictors_adaptation_destination_Heading_ a3;
  T2d a4;
  predictors_adaptation_destination_Heading result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "settings", false, 7, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "person", false, 628, &view)
        && (a1 = view->buf, true)
        && take_memory(&held, args[2], law, "movement", true, 3037, &view)
        && (a2 = view->buf, true)
        && take_tuple(args[3], law, "laws", 2)
        && take_tuple(PyTuple_GetItem(args[3], 0), law, "laws", 7)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[3], 0), 0), &a3.f0.x)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[3], 0), 1), &a3.f0.y)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[3], 0), 2), &a3.f0.ux)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[3], 0), 3), &a3.f0.uy)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[3], 0), 4), &a3.f0.wide)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[3], 0), 5), &a3.f0.broad)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[3], 0), 6), &a3.f0.tail)
        && take_tuple(PyTuple_GetItem(args[3], 1), law, "laws", 7)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[3], 1), 0), &a3.f1.x)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[3], 1), 1), &a3.f1.y)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[3], 1), 2), &a3.f1.ux)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[3], 1), 3), &a3.f1.uy)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[3], 1), 4), &a3.f1.wide)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[3], 1), 5), &a3.f1.broad)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[3], 1), 6), &a3.f1.tail)
        && take_tuple(args[4], law, "weights", 2)
        && take_double(PyTuple_GetItem(args[4], 0), &a4.f0)
        && take_double(PyTuple_GetItem(args[4], 1), &a4.f1)))
    return let_go(&held);
  result = predictors_adaptation_correction_by_places(a0, a1, a2, a3, a4);
  let_go(&held);
  return give_predictors_adaptation_destination_Heading(result);
}
static PyObject *py_predictors_adaptation_correction_conclude(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.correction:conclude";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_correction_Settings * a0;
  predictors_adaptation_correction_Person * a1;
  predictors_adaptation_correction_Movement * a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "settings", false, 7, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "person", true, 628, &view)
        && (a1 = view->buf, true)
        && take_memory(&held, args[2], law, "movement", true, 3037, &view)
        && (a2 = view->buf, true)))
    return let_go(&held);
  predictors_adaptation_correction_conclude(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_correction_fading(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.correction:fading";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)))
    return let_go(&held);
  result = predictors_adaptation_correction_fading(a0, a1);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_correction_fault(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.correction:fault";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_correction_Person * a0;
  Tqd result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "learned", false, 628, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  result = predictors_adaptation_correction_fault(a0);
  let_go(&held);
  return give_Tqd(result);
}
static PyObject *py_predictors_adaptation_correction_follow(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.correction:follow";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_correction_Movement * a0;
  T3d a1;
  T3d a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "movement", true, 3037, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "now", 3)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_tuple(args[2], law, "start", 3)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.f2)))
    return let_go(&held);
  predictors_adaptation_correction_follow(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_correction_heading_of(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.correction:heading_of";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_correction_Movement * a0;
  T10d a1;
  predictors_adaptation_destination_Heading result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "movement", false, 3037, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "answer", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.f6)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.f7)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.f8)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.f9)))
    return let_go(&held);
  result = predictors_adaptation_correction_heading_of(a0, a1);
  let_go(&held);
  return give_predictors_adaptation_destination_Heading(result);
}
static PyObject *py_predictors_adaptation_correction_learn(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.correction:learn";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_correction_Person * a0;
  predictors_adaptation_correction_Movement * a1;
  double a2;
  double a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "person", true, 628, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "movement", false, 3037, &view)
        && (a1 = view->buf, true)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  predictors_adaptation_correction_learn(a0, a1, a2, a3);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_correction_learn_place(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.correction:learn_place";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_correction_Settings * a0;
  predictors_adaptation_correction_Person * a1;
  predictors_adaptation_correction_Movement * a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "settings", false, 7, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "person", true, 628, &view)
        && (a1 = view->buf, true)
        && take_memory(&held, args[2], law, "movement", false, 3037, &view)
        && (a2 = view->buf, true)))
    return let_go(&held);
  predictors_adaptation_correction_learn_place(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_correction_prepare(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.correction:prepare";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_correction_Settings * a0;
  predictors_adaptation_correction_Person * a1;
  predictors_adaptation_destination_Movement * a2;
  T2d a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "settings", false, 7, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "person", false, 628, &view)
        && (a1 = view->buf, true)
        && take_memory(&held, args[2], law, "going", true, 133, &view)
        && (a2 = view->buf, true)
        && take_tuple(args[3], law, "start", 2)
        && take_double(PyTuple_GetItem(args[3], 0), &a3.f0)
        && take_double(PyTuple_GetItem(args[3], 1), &a3.f1)))
    return let_go(&held);
  predictors_adaptation_correction_prepare(a0, a1, a2, a3);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_correction_stage_begun(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.correction:stage_begun";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_correction_Movement * a0;
  double a1;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "movement", false, 3037, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)))
    return let_go(&held);
  result = predictors_adaptation_correction_stage_begun(a0, a1);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_predictors_adaptation_correction_state(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.correction:state";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_correction_Settings * a0;
  predictors_adaptation_correction_Person * a1;
  predictors_adaptation_correction_Movement * a2;
  double a3;
  T2_T6d_ a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "settings", false, 7, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "person", false, 628, &view)
        && (a1 = view->buf, true)
        && take_memory(&held, args[2], law, "movement", true, 3037, &view)
        && (a2 = view->buf, true)
        && take_double(args[3], &a3)
        && take_tuple(args[4], law, "laws", 2)
        && take_tuple(PyTuple_GetItem(args[4], 0), law, "laws", 6)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[4], 0), 0), &a4.f0.f0)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[4], 0), 1), &a4.f0.f1)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[4], 0), 2), &a4.f0.f2)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[4], 0), 3), &a4.f0.f3)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[4], 0), 4), &a4.f0.f4)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[4], 0), 5), &a4.f0.f5)
        && take_tuple(PyTuple_GetItem(args[4], 1), law, "laws", 6)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[4], 1), 0), &a4.f1.f0)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[4], 1), 1), &a4.f1.f1)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[4], 1), 2), &a4.f1.f2)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[4], 1), 3), &a4.f1.f3)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[4], 1), 4), &a4.f1.f4)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[4], 1), 5), &a4.f1.f5)))
    return let_go(&held);
  predictors_adaptation_correction_state(a0, a1, a2, a3, a4);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_correction_with_centre_ahead(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.correction:with_centre_ahead";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_correction_Movement * a0;
  predictors_adaptation_destination_Heading a1;
  double a2;
  double a3;
  predictors_adaptation_destination_Heading result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "movement", false, 3037, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "heading", 7)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.x)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.y)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.ux)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.uy)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.wide)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.broad)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.tail)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  result = predictors_adaptation_correction_with_centre_ahead(a0, a1, a2, a3);
  let_go(&held);
  return give_predictors_adaptation_destination_Heading(result);
}
static PyObject *py_predictors_adaptation_correction_write_mixture(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.correction:write_mixture";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_correction_Settings * a0;
  predictors_adaptation_correction_Person * a1;
  predictors_adaptation_correction_Movement * a2;
  predictors_adaptation_mixed_region_Mixture * a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "settings", false, 7, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "person", false, 628, &view)
        && (a1 = view->buf, true)
        && take_memory(&held, args[2], law, "movement", false, 3037, &view)
        && (a2 = view->buf, true)
        && take_memory(&held, args[3], law, "to", true, 38, &view)
        && (a3 = view->buf, true)))
    return let_go(&held);
  predictors_adaptation_correction_write_mixture(a0, a1, a2, a3);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_destination_candidates(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.destination:candidates";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_destination_Movement * a0;
  predictors_adaptation_places_Places * a1;
  T2d a2;
  predictors_adaptation_destination_Heading a3;
  Table a4;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "s", false, 133, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "held", false, 386, &view)
        && (a1 = view->buf, true)
        && take_tuple(args[2], law, "start", 2)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_tuple(args[3], law, "elsewhere", 7)
        && take_double(PyTuple_GetItem(args[3], 0), &a3.x)
        && take_double(PyTuple_GetItem(args[3], 1), &a3.y)
        && take_double(PyTuple_GetItem(args[3], 2), &a3.ux)
        && take_double(PyTuple_GetItem(args[3], 3), &a3.uy)
        && take_double(PyTuple_GetItem(args[3], 4), &a3.wide)
        && take_double(PyTuple_GetItem(args[3], 5), &a3.broad)
        && take_double(PyTuple_GetItem(args[3], 6), &a3.tail)
        && take_array(&held, args[4], law, "out", 'd', 2, true, &view)
        && (a4 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "out", a4.m, 4)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = predictors_adaptation_destination_candidates(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_predictors_adaptation_destination_combine(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.destination:combine";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_destination_Movement * a0;
  predictors_adaptation_places_Places * a1;
  T2d a2;
  predictors_adaptation_destination_Heading a3;
  predictors_adaptation_destination_Heading result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", false, 133, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "held", false, 386, &view)
        && (a1 = view->buf, true)
        && take_tuple(args[2], law, "start", 2)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_tuple(args[3], law, "elsewhere", 7)
        && take_double(PyTuple_GetItem(args[3], 0), &a3.x)
        && take_double(PyTuple_GetItem(args[3], 1), &a3.y)
        && take_double(PyTuple_GetItem(args[3], 2), &a3.ux)
        && take_double(PyTuple_GetItem(args[3], 3), &a3.uy)
        && take_double(PyTuple_GetItem(args[3], 4), &a3.wide)
        && take_double(PyTuple_GetItem(args[3], 5), &a3.broad)
        && take_double(PyTuple_GetItem(args[3], 6), &a3.tail)))
    return let_go(&held);
  result = predictors_adaptation_destination_combine(a0, a1, a2, a3);
  let_go(&held);
  return give_predictors_adaptation_destination_Heading(result);
}
static PyObject *py_predictors_adaptation_destination_favour_near(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.destination:favour_near";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_destination_Movement * a0;
  predictors_adaptation_places_Places * a1;
  T2d a2;
  double a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", true, 133, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "held", false, 386, &view)
        && (a1 = view->buf, true)
        && take_tuple(args[2], law, "start", 2)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_double(args[3], &a3)))
    return let_go(&held);
  predictors_adaptation_destination_favour_near(a0, a1, a2, a3);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_destination_geometric_median(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.destination:geometric_median";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  T2d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "rows", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a0.m, 4)
        && take_int64_t(args[1], &a1)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = predictors_adaptation_destination_geometric_median(a0, a1); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T2d(result);
}
static PyObject *py_predictors_adaptation_destination_likelihood(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.destination:likelihood";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_destination_Heading a0;
  double a1;
  double a2;
  double a3;
  double a4;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_tuple(args[0], law, "law_of_end", 7)
        && take_double(PyTuple_GetItem(args[0], 0), &a0.x)
        && take_double(PyTuple_GetItem(args[0], 1), &a0.y)
        && take_double(PyTuple_GetItem(args[0], 2), &a0.ux)
        && take_double(PyTuple_GetItem(args[0], 3), &a0.uy)
        && take_double(PyTuple_GetItem(args[0], 4), &a0.wide)
        && take_double(PyTuple_GetItem(args[0], 5), &a0.broad)
        && take_double(PyTuple_GetItem(args[0], 6), &a0.tail)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  result = predictors_adaptation_destination_likelihood(a0, a1, a2, a3, a4);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_destination_prepare(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.destination:prepare";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_destination_Movement * a0;
  predictors_adaptation_places_Places * a1;
  predictors_adaptation_habits_Habits * a2;
  T3d a3;
  T2d a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "s", true, 133, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "held", false, 386, &view)
        && (a1 = view->buf, true)
        && take_memory(&held, args[2], law, "known", false, 25, &view)
        && (a2 = view->buf, true)
        && take_tuple(args[3], law, "scene", 3)
        && take_double(PyTuple_GetItem(args[3], 0), &a3.f0)
        && take_double(PyTuple_GetItem(args[3], 1), &a3.f1)
        && take_double(PyTuple_GetItem(args[3], 2), &a3.f2)
        && take_tuple(args[4], law, "start", 2)
        && take_double(PyTuple_GetItem(args[4], 0), &a4.f0)
        && take_double(PyTuple_GetItem(args[4], 1), &a4.f1)))
    return let_go(&held);
  predictors_adaptation_destination_prepare(a0, a1, a2, a3, a4);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_destination_scaled(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.destination:scaled";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_destination_Heading a0;
  double a1;
  double a2;
  double a3;
  T6d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_tuple(args[0], law, "end", 7)
        && take_double(PyTuple_GetItem(args[0], 0), &a0.x)
        && take_double(PyTuple_GetItem(args[0], 1), &a0.y)
        && take_double(PyTuple_GetItem(args[0], 2), &a0.ux)
        && take_double(PyTuple_GetItem(args[0], 3), &a0.uy)
        && take_double(PyTuple_GetItem(args[0], 4), &a0.wide)
        && take_double(PyTuple_GetItem(args[0], 5), &a0.broad)
        && take_double(PyTuple_GetItem(args[0], 6), &a0.tail)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  result = predictors_adaptation_destination_scaled(a0, a1, a2, a3);
  let_go(&held);
  return give_T6d(result);
}
static PyObject *py_predictors_adaptation_destination_shift_law(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.destination:shift_law";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_destination_Heading a0;
  double a1;
  double a2;
  predictors_adaptation_destination_Heading result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_tuple(args[0], law, "heading", 7)
        && take_double(PyTuple_GetItem(args[0], 0), &a0.x)
        && take_double(PyTuple_GetItem(args[0], 1), &a0.y)
        && take_double(PyTuple_GetItem(args[0], 2), &a0.ux)
        && take_double(PyTuple_GetItem(args[0], 3), &a0.uy)
        && take_double(PyTuple_GetItem(args[0], 4), &a0.wide)
        && take_double(PyTuple_GetItem(args[0], 5), &a0.broad)
        && take_double(PyTuple_GetItem(args[0], 6), &a0.tail)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = predictors_adaptation_destination_shift_law(a0, a1, a2);
  let_go(&held);
  return give_predictors_adaptation_destination_Heading(result);
}
static PyObject *py_predictors_adaptation_destination_spread_of(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.destination:spread_of";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_destination_Movement * a0;
  T2d a1;
  double a2;
  double a3;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", false, 133, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "start", 2)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  result = predictors_adaptation_destination_spread_of(a0, a1, a2, a3);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_destination_weigh(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.destination:weigh";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_destination_Movement * a0;
  predictors_adaptation_places_Places * a1;
  T2d a2;
  predictors_adaptation_destination_Heading a3;
  T2d a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "s", true, 133, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "held", false, 386, &view)
        && (a1 = view->buf, true)
        && take_tuple(args[2], law, "start", 2)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_tuple(args[3], law, "law_of_end", 7)
        && take_double(PyTuple_GetItem(args[3], 0), &a3.x)
        && take_double(PyTuple_GetItem(args[3], 1), &a3.y)
        && take_double(PyTuple_GetItem(args[3], 2), &a3.ux)
        && take_double(PyTuple_GetItem(args[3], 3), &a3.uy)
        && take_double(PyTuple_GetItem(args[3], 4), &a3.wide)
        && take_double(PyTuple_GetItem(args[3], 5), &a3.broad)
        && take_double(PyTuple_GetItem(args[3], 6), &a3.tail)
        && take_tuple(args[4], law, "elsewhere", 2)
        && take_double(PyTuple_GetItem(args[4], 0), &a4.f0)
        && take_double(PyTuple_GetItem(args[4], 1), &a4.f1)))
    return let_go(&held);
  predictors_adaptation_destination_weigh(a0, a1, a2, a3, a4);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_distances_age_weight(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.distances:age_weight";
  Held held;
  const Py_buffer *view;
  int64_t a0;
  int64_t a1;
  double a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_int64_t(args[0], &a0)
        && take_int64_t(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = predictors_adaptation_distances_age_weight(a0, a1, a2);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_distances_combine(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.distances:combine";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_distances_Distances * a0;
  double a1;
  predictors_adaptation_distances_Ahead a2;
  T3d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "s", false, 56, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_tuple(args[2], law, "predicted", 4)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.ahead)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.wide)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.broad)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.tail)))
    return let_go(&held);
  result = predictors_adaptation_distances_combine(a0, a1, a2);
  let_go(&held);
  return give_T3d(result);
}
static PyObject *py_predictors_adaptation_distances_fault(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.distances:fault";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_distances_Distances * a0;
  Tqd result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "learned", false, 56, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  result = predictors_adaptation_distances_fault(a0);
  let_go(&held);
  return give_Tqd(result);
}
static PyObject *py_predictors_adaptation_distances_judge(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.distances:judge";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_distances_Distances * a0;
  double a1;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "s", true, 56, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)))
    return let_go(&held);
  predictors_adaptation_distances_judge(a0, a1);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_distances_likelihood(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.distances:likelihood";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_distances_Distances * a0;
  double a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "s", false, 56, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)))
    return let_go(&held);
  result = predictors_adaptation_distances_likelihood(a0, a1);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_distances_remember(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.distances:remember";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_distances_Distances * a0;
  double a1;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "s", true, 56, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)))
    return let_go(&held);
  predictors_adaptation_distances_remember(a0, a1);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_durations_fault(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.durations:fault";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_durations_Durations * a0;
  Tqd result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "learned", false, 21, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  result = predictors_adaptation_durations_fault(a0);
  let_go(&held);
  return give_Tqd(result);
}
static PyObject *py_predictors_adaptation_durations_forget(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.durations:forget";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_durations_Durations * a0;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "s", true, 21, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  predictors_adaptation_durations_forget(a0);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_durations_judge(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.durations:judge";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_durations_Durations * a0;
  double a1;
  double a2;
  double a3;
  double a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "s", true, 21, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  predictors_adaptation_durations_judge(a0, a1, a2, a3, a4);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_durations_median(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.durations:median";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_durations_Durations * a0;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "s", false, 21, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  result = predictors_adaptation_durations_median(a0);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_durations_mix(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.durations:mix";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_durations_Durations * a0;
  double a1;
  double a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "s", false, 21, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = predictors_adaptation_durations_mix(a0, a1, a2);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_durations_mixture(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.durations:mixture";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_durations_Durations * a0;
  double a1;
  double a2;
  double a3;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", false, 21, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  result = predictors_adaptation_durations_mixture(a0, a1, a2, a3);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_durations_remember(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.durations:remember";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_durations_Durations * a0;
  double a1;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "s", true, 21, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)))
    return let_go(&held);
  predictors_adaptation_durations_remember(a0, a1);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_durations_value_of_rank(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.durations:value_of_rank";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_durations_Durations * a0;
  int64_t a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "s", false, 21, &view)
        && (a0 = view->buf, true)
        && take_int64_t(args[1], &a1)))
    return let_go(&held);
  result = predictors_adaptation_durations_value_of_rank(a0, a1);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_habits_blend(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.habits:blend";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  int64_t a2;
  int64_t a3;
  double a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "out", 'd', 2, true, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_int64_t(args[1], &a1)
        && take_int64_t(args[2], &a2)
        && take_int64_t(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS predictors_adaptation_habits_blend(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_habits_count_following(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.habits:count_following";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_places_Places * a0;
  int64_t a1;
  Table a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "held", false, 386, &view)
        && (a0 = view->buf, true)
        && take_int64_t(args[1], &a1)
        && take_array(&held, args[2], law, "out", 'd', 2, true, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS predictors_adaptation_habits_count_following(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_habits_count_last(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.habits:count_last";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_habits_Habits * a0;
  predictors_adaptation_places_Places * a1;
  Table a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "s", false, 25, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "held", false, 386, &view)
        && (a1 = view->buf, true)
        && take_array(&held, args[2], law, "out", 'd', 2, true, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS predictors_adaptation_habits_count_last(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_habits_count_often(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.habits:count_often";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_places_Places * a0;
  double a1;
  Table a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "held", false, 386, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_array(&held, args[2], law, "out", 'd', 2, true, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = predictors_adaptation_habits_count_often(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_habits_density_ratio(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.habits:density_ratio";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = predictors_adaptation_habits_density_ratio(a0, a1, a2);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_habits_learn(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.habits:learn";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_habits_Habits * a0;
  predictors_adaptation_places_Places * a1;
  T3d a2;
  T4d a3;
  double a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "s", true, 25, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "held", false, 386, &view)
        && (a1 = view->buf, true)
        && take_tuple(args[2], law, "scene", 3)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.f2)
        && take_tuple(args[3], law, "movement", 4)
        && take_double(PyTuple_GetItem(args[3], 0), &a3.f0)
        && take_double(PyTuple_GetItem(args[3], 1), &a3.f1)
        && take_double(PyTuple_GetItem(args[3], 2), &a3.f2)
        && take_double(PyTuple_GetItem(args[3], 3), &a3.f3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  predictors_adaptation_habits_learn(a0, a1, a2, a3, a4);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_habits_returns(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.habits:returns";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_habits_Habits * a0;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "s", false, 25, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  result = predictors_adaptation_habits_returns(a0);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_habits_rule_weight(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.habits:rule_weight";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_habits_Habits * a0;
  int64_t a1;
  double a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "s", false, 25, &view)
        && (a0 = view->buf, true)
        && take_int64_t(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = predictors_adaptation_habits_rule_weight(a0, a1, a2);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_habits_share_visit(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.habits:share_visit";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_habits_Habits * a0;
  Table a1;
  double a2;
  double a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", true, 25, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "likely", 'd', 2, true, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS predictors_adaptation_habits_share_visit(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_habits_shares(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.habits:shares";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_habits_Habits * a0;
  predictors_adaptation_places_Places * a1;
  double a2;
  T3d a3;
  Table a4;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "s", false, 25, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "held", false, 386, &view)
        && (a1 = view->buf, true)
        && take_double(args[2], &a2)
        && take_tuple(args[3], law, "start", 3)
        && take_double(PyTuple_GetItem(args[3], 0), &a3.f0)
        && take_double(PyTuple_GetItem(args[3], 1), &a3.f1)
        && take_double(PyTuple_GetItem(args[3], 2), &a3.f2)
        && take_array(&held, args[4], law, "out", 'd', 2, true, &view)
        && (a4 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = predictors_adaptation_habits_shares(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_predictors_adaptation_habits_usual_width(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.habits:usual_width";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_habits_Habits * a0;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "s", false, 25, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  result = predictors_adaptation_habits_usual_width(a0);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_habits_width_weight(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.habits:width_weight";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_habits_Habits * a0;
  int64_t a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "s", false, 25, &view)
        && (a0 = view->buf, true)
        && take_int64_t(args[1], &a1)))
    return let_go(&held);
  result = predictors_adaptation_habits_width_weight(a0, a1);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_levels_learn(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.levels:learn";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_levels_Offsets * a0;
  double a1;
  int64_t a2;
  bool a3;
  double a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "s", true, 10, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_int64_t(args[2], &a2)
        && take_bool(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  predictors_adaptation_levels_learn(a0, a1, a2, a3, a4);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_levels_offset(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.levels:offset";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_levels_Offsets * a0;
  double a1;
  int64_t a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "s", false, 10, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_int64_t(args[2], &a2)))
    return let_go(&held);
  result = predictors_adaptation_levels_offset(a0, a1, a2);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_levels_step_after(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.levels:step_after";
  Held held;
  const Py_buffer *view;
  double a0;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_double(args[0], &a0)))
    return let_go(&held);
  result = predictors_adaptation_levels_step_after(a0);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_mixed_region_claim(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.mixed_region:claim";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_mixed_region_Movement * a0;
  double a1;
  T6d a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "s", true, 46, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_tuple(args[2], law, "elsewhere", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.f2)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.f3)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.f4)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.f5)))
    return let_go(&held);
  predictors_adaptation_mixed_region_claim(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_mixed_region_judge(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.mixed_region:judge";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_levels_Offsets * a0;
  predictors_adaptation_mixed_region_Mixture * a1;
  T2d a2;
  double a3;
  double a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "offsets", true, 10, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "stated", false, 38, &view)
        && (a1 = view->buf, true)
        && take_tuple(args[2], law, "end", 2)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  predictors_adaptation_mixed_region_judge(a0, a1, a2, a3, a4);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_mixed_region_likeliest(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.mixed_region:likeliest";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_places_Places * a0;
  predictors_adaptation_destination_Movement * a1;
  double a2;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "held", false, 386, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "going", false, 133, &view)
        && (a1 = view->buf, true)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = predictors_adaptation_mixed_region_likeliest(a0, a1, a2);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_predictors_adaptation_mixed_region_write(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.mixed_region:write";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_levels_Offsets * a0;
  predictors_adaptation_places_Places * a1;
  predictors_adaptation_destination_Movement * a2;
  predictors_adaptation_mixed_region_Movement * a3;
  predictors_adaptation_mixed_region_Mixture * a4;
  T2d a5;
  T2d a6;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 7)
        && take_memory(&held, args[0], law, "offsets", false, 10, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "held", false, 386, &view)
        && (a1 = view->buf, true)
        && take_memory(&held, args[2], law, "going", false, 133, &view)
        && (a2 = view->buf, true)
        && take_memory(&held, args[3], law, "now", false, 46, &view)
        && (a3 = view->buf, true)
        && take_memory(&held, args[4], law, "to", true, 38, &view)
        && (a4 = view->buf, true)
        && take_tuple(args[5], law, "origin", 2)
        && take_double(PyTuple_GetItem(args[5], 0), &a5.f0)
        && take_double(PyTuple_GetItem(args[5], 1), &a5.f1)
        && take_tuple(args[6], law, "start", 2)
        && take_double(PyTuple_GetItem(args[6], 0), &a6.f0)
        && take_double(PyTuple_GetItem(args[6], 1), &a6.f1)))
    return let_go(&held);
  predictors_adaptation_mixed_region_write(a0, a1, a2, a3, a4, a5, a6);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_mixed_region_write_part(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.mixed_region:write_part";
  Held held;
  const Py_buffer *view;
  predictors_mixture_PartRow * a0;
  double a1;
  T2d a2;
  double a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "part", true, 7, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_tuple(args[2], law, "centre", 2)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_double(args[3], &a3)))
    return let_go(&held);
  predictors_adaptation_mixed_region_write_part(a0, a1, a2, a3);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_moments_has_come(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.moments:has_come";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_moments_Series * a0;
  double a1;
  T2d a2;
  double a3;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", false, 4, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_tuple(args[2], law, "span", 2)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_double(args[3], &a3)))
    return let_go(&held);
  result = predictors_adaptation_moments_has_come(a0, a1, a2, a3);
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_predictors_adaptation_moments_next_moment(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.moments:next_moment";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_moments_Series * a0;
  double a1;
  T3d a2;
  int64_t a3;
  Tqb result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", true, 4, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_tuple(args[2], law, "cursor", 3)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.f2)
        && take_int64_t(args[3], &a3)))
    return let_go(&held);
  result = predictors_adaptation_moments_next_moment(a0, a1, a2, a3);
  let_go(&held);
  return give_Tqb(result);
}
static PyObject *py_predictors_adaptation_places_fault(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.places:fault";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_places_Places * a0;
  Tqd result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "learned", false, 386, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  result = predictors_adaptation_places_fault(a0);
  let_go(&held);
  return give_Tqd(result);
}
static PyObject *py_predictors_adaptation_places_nearest(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.places:nearest";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_places_Places * a0;
  double a1;
  T2d a2;
  double a3;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", false, 386, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_tuple(args[2], law, "point", 2)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_double(args[3], &a3)))
    return let_go(&held);
  result = predictors_adaptation_places_nearest(a0, a1, a2, a3);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_predictors_adaptation_places_new_place(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.places:new_place";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_places_Places * a0;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "s", true, 386, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  result = predictors_adaptation_places_new_place(a0);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_predictors_adaptation_places_visit(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.places:visit";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_places_Places * a0;
  double a1;
  T2d a2;
  double a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", true, 386, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_tuple(args[2], law, "end", 2)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_double(args[3], &a3)))
    return let_go(&held);
  predictors_adaptation_places_visit(a0, a1, a2, a3);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_places_visited(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.places:visited";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_places_Places * a0;
  int64_t a1;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "s", false, 386, &view)
        && (a0 = view->buf, true)
        && take_int64_t(args[1], &a1)))
    return let_go(&held);
  result = predictors_adaptation_places_visited(a0, a1);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_predictors_adaptation_predictor_conclude(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.predictor:conclude";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_predictor_Memory * a0;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "memory", true, 3949, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  predictors_adaptation_predictor_conclude(a0);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_predictor_enter_scene(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.predictor:enter_scene";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_predictor_Memory * a0;
  scene_Scene a1;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "memory", true, 3949, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "scene", 3)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.key)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.x)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.y)))
    return let_go(&held);
  predictors_adaptation_predictor_enter_scene(a0, a1);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_predictor_last_end(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.predictor:last_end";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_places_Places * a0;
  double a1;
  T2d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "held", false, 386, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)))
    return let_go(&held);
  result = predictors_adaptation_predictor_last_end(a0, a1);
  let_go(&held);
  return give_T2d(result);
}
static PyObject *py_predictors_adaptation_predictor_list_parts(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.predictor:list_parts";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_predictor_Memory * a0;
  Table a1;
  Tq2d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "memory", true, 3949, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "out", 'd', 2, true, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = predictors_adaptation_predictor_list_parts(a0, a1); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_Tq2d(result);
}
static PyObject *py_predictors_adaptation_predictor_list_places(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.predictor:list_places";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_predictor_Memory * a0;
  Table a1;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "memory", true, 3949, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "out", 'd', 2, true, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = predictors_adaptation_predictor_list_places(a0, a1); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_predictors_adaptation_predictor_pace_of(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.predictor:pace_of";
  Held held;
  const Py_buffer *view;
  predictors_kinematic_features_State * a0;
  records_MotionRow a1;
  predictors_adaptation_time_left_Pace result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "own", false, 273, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "m", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.t)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.x)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.y)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.vx)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.vy)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.ax)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.ay)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.settled)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.start)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.counts)))
    return let_go(&held);
  result = predictors_adaptation_predictor_pace_of(a0, a1);
  let_go(&held);
  return give_predictors_adaptation_time_left_Pace(result);
}
static PyObject *py_predictors_adaptation_predictor_sizes(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.predictor:sizes";
  Held held;
  const Py_buffer *view;
  Vector a0;
  T3q result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_array(&held, args[0], law, "values", 'd', 1, false, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  result = predictors_adaptation_predictor_sizes(a0);
  let_go(&held);
  return give_T3q(result);
}
static PyObject *py_predictors_adaptation_predictor_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.predictor:step";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_predictor_Memory * a0;
  T10d a1;
  predictors_kinematic_network_Coefficients * a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "memory", true, 3949, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "motion", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.f6)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.f7)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.f8)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.f9)
        && take_memory(&held, args[2], law, "coefficients", false, 132, &view)
        && (a2 = view->buf, true)))
    return let_go(&held);
  result = predictors_adaptation_predictor_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_predictors_adaptation_predictor_write_mixture(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.predictor:write_mixture";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_predictor_Memory * a0;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "memory", true, 3949, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  result = predictors_adaptation_predictor_write_mixture(a0);
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_predictors_adaptation_region_widening_learn(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.region_widening:learn";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_region_widening_Radii * a0;
  predictors_adaptation_region_widening_Movement * a1;
  T2d a2;
  T2d a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", true, 21, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "stated", false, 2164, &view)
        && (a1 = view->buf, true)
        && take_tuple(args[2], law, "place_of_end", 2)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_tuple(args[3], law, "span", 2)
        && take_double(PyTuple_GetItem(args[3], 0), &a3.f0)
        && take_double(PyTuple_GetItem(args[3], 1), &a3.f1)))
    return let_go(&held);
  predictors_adaptation_region_widening_learn(a0, a1, a2, a3);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_region_widening_probability_within(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.region_widening:probability_within";
  Held held;
  const Py_buffer *view;
  T6d a0;
  double a1;
  double a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_tuple(args[0], law, "region", 6)
        && take_double(PyTuple_GetItem(args[0], 0), &a0.f0)
        && take_double(PyTuple_GetItem(args[0], 1), &a0.f1)
        && take_double(PyTuple_GetItem(args[0], 2), &a0.f2)
        && take_double(PyTuple_GetItem(args[0], 3), &a0.f3)
        && take_double(PyTuple_GetItem(args[0], 4), &a0.f4)
        && take_double(PyTuple_GetItem(args[0], 5), &a0.f5)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = predictors_adaptation_region_widening_probability_within(a0, a1, a2);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_region_widening_record(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.region_widening:record";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_region_widening_Movement * a0;
  T3d a1;
  T6d a2;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "stated", true, 2164, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "cursor", 3)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_tuple(args[2], law, "region", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.f2)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.f3)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.f4)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.f5)))
    return let_go(&held);
  result = predictors_adaptation_region_widening_record(a0, a1, a2);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_predictors_adaptation_region_widening_widen(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.region_widening:widen";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_region_widening_Radii * a0;
  double a1;
  double a2;
  T2d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "s", false, 21, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = predictors_adaptation_region_widening_widen(a0, a1, a2);
  let_go(&held);
  return give_T2d(result);
}
static PyObject *py_predictors_adaptation_stages_belief(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.stages:belief";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)))
    return let_go(&held);
  result = predictors_adaptation_stages_belief(a0, a1);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_stages_bias(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.stages:bias";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_stages_Stage * a0;
  double a1;
  double a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "s", false, 16, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = predictors_adaptation_stages_bias(a0, a1, a2);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_stages_bounded(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.stages:bounded";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)))
    return let_go(&held);
  result = predictors_adaptation_stages_bounded(a0, a1);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_stages_correct(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.stages:correct";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_stages_Stages * a0;
  double a1;
  double a2;
  double a3;
  T4d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "known", false, 80, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  result = predictors_adaptation_stages_correct(a0, a1, a2, a3);
  let_go(&held);
  return give_T4d(result);
}
static PyObject *py_predictors_adaptation_stages_forget(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.stages:forget";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_stages_Stage * a0;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "s", true, 16, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  predictors_adaptation_stages_forget(a0);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_stages_interpolation(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.stages:interpolation";
  Held held;
  const Py_buffer *view;
  double a0;
  Tqd result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_double(args[0], &a0)))
    return let_go(&held);
  result = predictors_adaptation_stages_interpolation(a0);
  let_go(&held);
  return give_Tqd(result);
}
static PyObject *py_predictors_adaptation_stages_interpolation_among(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.stages:interpolation_among";
  Held held;
  const Py_buffer *view;
  double a0;
  int64_t a1;
  Tqd result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_double(args[0], &a0)
        && take_int64_t(args[1], &a1)))
    return let_go(&held);
  result = predictors_adaptation_stages_interpolation_among(a0, a1);
  let_go(&held);
  return give_Tqd(result);
}
static PyObject *py_predictors_adaptation_stages_learn(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.stages:learn";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_stages_Stage * a0;
  predictors_adaptation_stages_Moment * a1;
  double a2;
  double a3;
  double a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "s", true, 16, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "m", false, 13, &view)
        && (a1 = view->buf, true)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  predictors_adaptation_stages_learn(a0, a1, a2, a3, a4);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_stages_scale(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.stages:scale";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_stages_Stage * a0;
  double a1;
  double a2;
  double a3;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", false, 16, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  result = predictors_adaptation_stages_scale(a0, a1, a2, a3);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_stages_solve(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.stages:solve";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_stages_Stage * a0;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "s", true, 16, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  predictors_adaptation_stages_solve(a0);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_stages_tempo(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.stages:tempo";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_stages_Stage * a0;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "s", false, 16, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  result = predictors_adaptation_stages_tempo(a0);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_stages_tempo_factor(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.stages:tempo_factor";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_stages_Stage * a0;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "s", false, 16, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  result = predictors_adaptation_stages_tempo_factor(a0);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_stages_width_log(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.stages:width_log";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_stages_Stage * a0;
  double a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "s", false, 16, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)))
    return let_go(&held);
  result = predictors_adaptation_stages_width_log(a0, a1);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_time_left_factor(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.time_left:factor";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_time_left_Sums * a0;
  Vector a1;
  Vector a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "s", false, 35, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "prior", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "out", 'd', 1, true, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  result = predictors_adaptation_time_left_factor(a0, a1, a2);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_adaptation_time_left_fault(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.time_left:fault";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_time_left_Sums * a0;
  Vector a1;
  Tqd result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "learned", false, 35, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "prior", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  result = predictors_adaptation_time_left_fault(a0, a1);
  let_go(&held);
  return give_Tqd(result);
}
static PyObject *py_predictors_adaptation_time_left_learn(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.time_left:learn";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_time_left_Sums * a0;
  predictors_adaptation_arrival_intervals_Intervals * a1;
  predictors_adaptation_time_left_Movement * a2;
  T2d a3;
  double a4;
  Vector a5;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_memory(&held, args[0], law, "s", true, 35, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "intervals", true, 4, &view)
        && (a1 = view->buf, true)
        && take_memory(&held, args[2], law, "movement", false, 332, &view)
        && (a2 = view->buf, true)
        && take_tuple(args[3], law, "span", 2)
        && take_double(PyTuple_GetItem(args[3], 0), &a3.f0)
        && take_double(PyTuple_GetItem(args[3], 1), &a3.f1)
        && take_double(args[4], &a4)
        && take_array(&held, args[5], law, "prior", 'd', 1, false, &view)
        && (a5 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  predictors_adaptation_time_left_learn(a0, a1, a2, a3, a4, a5);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_time_left_moment_at(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.time_left:moment_at";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_time_left_Movement * a0;
  int64_t a1;
  T2d a2;
  double a3;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "movement", false, 332, &view)
        && (a0 = view->buf, true)
        && take_int64_t(args[1], &a1)
        && take_tuple(args[2], law, "span", 2)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_double(args[3], &a3)))
    return let_go(&held);
  result = predictors_adaptation_time_left_moment_at(a0, a1, a2, a3);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_predictors_adaptation_time_left_solve(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.time_left:solve";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_time_left_Sums * a0;
  Vector a1;
  Vector a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "s", false, 35, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "prior", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "weights", 'd', 1, true, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  predictors_adaptation_time_left_solve(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_adaptation_time_left_stated(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.time_left:stated";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_time_left_Sums * a0;
  predictors_adaptation_arrival_intervals_Intervals * a1;
  predictors_adaptation_time_left_Movement * a2;
  T3d a3;
  double a4;
  double a5;
  predictors_adaptation_time_left_Estimates a6;
  predictors_adaptation_time_left_Way a7;
  predictors_adaptation_time_left_Pace a8;
  T2d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 9)
        && take_memory(&held, args[0], law, "s", false, 35, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "intervals", false, 4, &view)
        && (a1 = view->buf, true)
        && take_memory(&held, args[2], law, "movement", true, 332, &view)
        && (a2 = view->buf, true)
        && take_tuple(args[3], law, "cursor", 3)
        && take_double(PyTuple_GetItem(args[3], 0), &a3.f0)
        && take_double(PyTuple_GetItem(args[3], 1), &a3.f1)
        && take_double(PyTuple_GetItem(args[3], 2), &a3.f2)
        && take_double(args[4], &a4)
        && take_double(args[5], &a5)
        && take_tuple(args[6], law, "estimates", 2)
        && take_double(PyTuple_GetItem(args[6], 0), &a6.mixed)
        && take_double(PyTuple_GetItem(args[6], 1), &a6.predicted)
        && take_tuple(args[7], law, "way", 2)
        && take_double(PyTuple_GetItem(args[7], 0), &a7.done)
        && take_double(PyTuple_GetItem(args[7], 1), &a7.left)
        && take_tuple(args[8], law, "pace", 2)
        && take_double(PyTuple_GetItem(args[8], 0), &a8.of_peak)
        && take_double(PyTuple_GetItem(args[8], 1), &a8.slow_s)))
    return let_go(&held);
  result = predictors_adaptation_time_left_stated(a0, a1, a2, a3, a4, a5, a6, a7, a8);
  let_go(&held);
  return give_T2d(result);
}
static PyObject *py_predictors_adaptation_time_left_terms(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.time_left:terms";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_time_left_Estimates a0;
  predictors_adaptation_time_left_Way a1;
  predictors_adaptation_time_left_Pace a2;
  double a3;
  double a4;
  T7d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_tuple(args[0], law, "estimates", 2)
        && take_double(PyTuple_GetItem(args[0], 0), &a0.mixed)
        && take_double(PyTuple_GetItem(args[0], 1), &a0.predicted)
        && take_tuple(args[1], law, "way", 2)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.done)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.left)
        && take_tuple(args[2], law, "pace", 2)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.of_peak)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.slow_s)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  result = predictors_adaptation_time_left_terms(a0, a1, a2, a3, a4);
  let_go(&held);
  return give_T7d(result);
}
static PyObject *py_predictors_adaptation_time_left_weighed(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.adaptation.time_left:weighed";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_time_left_Sums * a0;
  predictors_adaptation_arrival_intervals_Intervals * a1;
  predictors_adaptation_time_left_Movement * a2;
  T3d a3;
  double a4;
  double a5;
  double a6;
  T7d a7;
  Vector a8;
  T2d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 9)
        && take_memory(&held, args[0], law, "s", false, 35, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "intervals", false, 4, &view)
        && (a1 = view->buf, true)
        && take_memory(&held, args[2], law, "movement", true, 332, &view)
        && (a2 = view->buf, true)
        && take_tuple(args[3], law, "cursor", 3)
        && take_double(PyTuple_GetItem(args[3], 0), &a3.f0)
        && take_double(PyTuple_GetItem(args[3], 1), &a3.f1)
        && take_double(PyTuple_GetItem(args[3], 2), &a3.f2)
        && take_double(args[4], &a4)
        && take_double(args[5], &a5)
        && take_double(args[6], &a6)
        && take_tuple(args[7], law, "known", 7)
        && take_double(PyTuple_GetItem(args[7], 0), &a7.f0)
        && take_double(PyTuple_GetItem(args[7], 1), &a7.f1)
        && take_double(PyTuple_GetItem(args[7], 2), &a7.f2)
        && take_double(PyTuple_GetItem(args[7], 3), &a7.f3)
        && take_double(PyTuple_GetItem(args[7], 4), &a7.f4)
        && take_double(PyTuple_GetItem(args[7], 5), &a7.f5)
        && take_double(PyTuple_GetItem(args[7], 6), &a7.f6)
        && take_array(&held, args[8], law, "prior", 'd', 1, false, &view)
        && (a8 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  result = predictors_adaptation_time_left_weighed(a0, a1, a2, a3, a4, a5, a6, a7, a8);
  let_go(&held);
  return give_T2d(result);
}
static PyObject *py_predictors_delphian_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.delphian:step";
  Held held;
  const Py_buffer *view;
  predictors_delphian_Memory * a0;
  T10d a1;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "memory", true, 17, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "motion", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.f6)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.f7)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.f8)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.f9)))
    return let_go(&held);
  result = predictors_delphian_step(a0, a1);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_predictors_hold_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.hold:step";
  Held held;
  const Py_buffer *view;
  predictors_movement_State * a0;
  T10d a1;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "s", true, 9, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "motion", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.f6)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.f7)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.f8)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.f9)))
    return let_go(&held);
  result = predictors_hold_step(a0, a1);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_predictors_kalman_corrected(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kalman:corrected";
  Held held;
  const Py_buffer *view;
  Vector a0;
  differentiators_kalman_Covariance * a1;
  double a2;
  double a3;
  T3d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_array(&held, args[0], law, "axis", 'd', 1, false, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_memory(&held, args[1], law, "p", false, 6, &view)
        && (a1 = view->buf, true)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  result = predictors_kalman_corrected(a0, a1, a2, a3);
  let_go(&held);
  return give_T3d(result);
}
static PyObject *py_predictors_kalman_expect(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kalman:expect";
  Held held;
  const Py_buffer *view;
  differentiators_kalman_Plane * a0;
  double a1;
  double a2;
  double a3;
  double a4;
  double a5;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_memory(&held, args[0], law, "plane", true, 12, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)
        && take_double(args[5], &a5)))
    return let_go(&held);
  predictors_kalman_expect(a0, a1, a2, a3, a4, a5);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_kalman_expect_rest(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kalman:expect_rest";
  Held held;
  const Py_buffer *view;
  differentiators_kalman_Plane * a0;
  double a1;
  double a2;
  double a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "plane", true, 12, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  predictors_kalman_expect_rest(a0, a1, a2, a3);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_kalman_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kalman:step";
  Held held;
  const Py_buffer *view;
  predictors_kalman_Memory * a0;
  T10d a1;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "memory", true, 25, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "motion", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.f6)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.f7)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.f8)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.f9)))
    return let_go(&held);
  result = predictors_kalman_step(a0, a1);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_predictors_kep_add(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kep:add";
  Held held;
  const Py_buffer *view;
  predictors_kep_Fit * a0;
  int64_t a1;
  double a2;
  double a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "fit", true, 43, &view)
        && (a0 = view->buf, true)
        && take_int64_t(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  predictors_kep_add(a0, a1, a2, a3);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_kep_bends(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kep:bends";
  Held held;
  const Py_buffer *view;
  predictors_kep_Quartic a0;
  double a1;
  T2d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_tuple(args[0], law, "p", 5)
        && take_double(PyTuple_GetItem(args[0], 0), &a0.c0)
        && take_double(PyTuple_GetItem(args[0], 1), &a0.c1)
        && take_double(PyTuple_GetItem(args[0], 2), &a0.c2)
        && take_double(PyTuple_GetItem(args[0], 3), &a0.c3)
        && take_double(PyTuple_GetItem(args[0], 4), &a0.c4)
        && take_double(args[1], &a1)))
    return let_go(&held);
  result = predictors_kep_bends(a0, a1);
  let_go(&held);
  return give_T2d(result);
}
static PyObject *py_predictors_kep_derivative(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kep:derivative";
  Held held;
  const Py_buffer *view;
  predictors_kep_Quartic a0;
  predictors_kep_Quartic result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_tuple(args[0], law, "p", 5)
        && take_double(PyTuple_GetItem(args[0], 0), &a0.c0)
        && take_double(PyTuple_GetItem(args[0], 1), &a0.c1)
        && take_double(PyTuple_GetItem(args[0], 2), &a0.c2)
        && take_double(PyTuple_GetItem(args[0], 3), &a0.c3)
        && take_double(PyTuple_GetItem(args[0], 4), &a0.c4)))
    return let_go(&held);
  result = predictors_kep_derivative(a0);
  let_go(&held);
  return give_predictors_kep_Quartic(result);
}
static PyObject *py_predictors_kep_first_zero(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kep:first_zero";
  Held held;
  const Py_buffer *view;
  predictors_kep_Quartic a0;
  double a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_tuple(args[0], law, "p", 5)
        && take_double(PyTuple_GetItem(args[0], 0), &a0.c0)
        && take_double(PyTuple_GetItem(args[0], 1), &a0.c1)
        && take_double(PyTuple_GetItem(args[0], 2), &a0.c2)
        && take_double(PyTuple_GetItem(args[0], 3), &a0.c3)
        && take_double(PyTuple_GetItem(args[0], 4), &a0.c4)
        && take_double(args[1], &a1)))
    return let_go(&held);
  result = predictors_kep_first_zero(a0, a1);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_kep_judge(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kep:judge";
  Held held;
  const Py_buffer *view;
  predictors_kep_Check * a0;
  double a1;
  double a2;
  double a3;
  double a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "check", true, 4, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  predictors_kep_judge(a0, a1, a2, a3, a4);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_kep_remaining(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kep:remaining";
  Held held;
  const Py_buffer *view;
  predictors_kep_Fit * a0;
  int64_t a1;
  double a2;
  double a3;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "fit", true, 43, &view)
        && (a0 = view->buf, true)
        && take_int64_t(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  result = predictors_kep_remaining(a0, a1, a2, a3);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_kep_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kep:step";
  Held held;
  const Py_buffer *view;
  predictors_kep_Memory * a0;
  T10d a1;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "memory", true, 59, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "motion", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.f6)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.f7)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.f8)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.f9)))
    return let_go(&held);
  result = predictors_kep_step(a0, a1);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_predictors_kep_value(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kep:value";
  Held held;
  const Py_buffer *view;
  predictors_kep_Quartic a0;
  double a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_tuple(args[0], law, "p", 5)
        && take_double(PyTuple_GetItem(args[0], 0), &a0.c0)
        && take_double(PyTuple_GetItem(args[0], 1), &a0.c1)
        && take_double(PyTuple_GetItem(args[0], 2), &a0.c2)
        && take_double(PyTuple_GetItem(args[0], 3), &a0.c3)
        && take_double(PyTuple_GetItem(args[0], 4), &a0.c4)
        && take_double(args[1], &a1)))
    return let_go(&held);
  result = predictors_kep_value(a0, a1);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_kep_zero_between(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kep:zero_between";
  Held held;
  const Py_buffer *view;
  predictors_kep_Quartic a0;
  double a1;
  double a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_tuple(args[0], law, "p", 5)
        && take_double(PyTuple_GetItem(args[0], 0), &a0.c0)
        && take_double(PyTuple_GetItem(args[0], 1), &a0.c1)
        && take_double(PyTuple_GetItem(args[0], 2), &a0.c2)
        && take_double(PyTuple_GetItem(args[0], 3), &a0.c3)
        && take_double(PyTuple_GetItem(args[0], 4), &a0.c4)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = predictors_kep_zero_between(a0, a1, a2);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_kinematic_features_ahead(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kinematic.features:ahead";
  Held held;
  const Py_buffer *view;
  double a0;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_double(args[0], &a0)))
    return let_go(&held);
  result = predictors_kinematic_features_ahead(a0);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_kinematic_features_direction(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kinematic.features:direction";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double a2;
  double a3;
  T2d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  result = predictors_kinematic_features_direction(a0, a1, a2, a3);
  let_go(&held);
  return give_T2d(result);
}
static PyObject *py_predictors_kinematic_features_fill_lags(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kinematic.features:fill_lags";
  Held held;
  const Py_buffer *view;
  predictors_kinematic_history_State * a0;
  predictors_kinematic_history_Point a1;
  predictors_kinematic_features_Frame a2;
  predictors_kinematic_features_Values * a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", false, 202, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "point", 4)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.t)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.x)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.y)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.path)
        && take_tuple(args[2], law, "frame", 4)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.reach)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.hand)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.ux)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.uy)
        && take_memory(&held, args[3], law, "out", true, 65, &view)
        && (a3 = view->buf, true)))
    return let_go(&held);
  predictors_kinematic_features_fill_lags(a0, a1, a2, a3);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_kinematic_features_fill_pace(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kinematic.features:fill_pace";
  Held held;
  const Py_buffer *view;
  predictors_kinematic_track_State * a0;
  predictors_kinematic_history_Point a1;
  records_MotionRow a2;
  predictors_kinematic_features_Frame a3;
  predictors_kinematic_features_Values * a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "s", false, 29, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "point", 4)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.t)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.x)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.y)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.path)
        && take_tuple(args[2], law, "m", 10)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.vx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.vy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.ax)
        && take_double(PyTuple_GetItem(args[2], 6), &a2.ay)
        && take_double(PyTuple_GetItem(args[2], 7), &a2.settled)
        && take_double(PyTuple_GetItem(args[2], 8), &a2.start)
        && take_double(PyTuple_GetItem(args[2], 9), &a2.counts)
        && take_tuple(args[3], law, "frame", 4)
        && take_double(PyTuple_GetItem(args[3], 0), &a3.reach)
        && take_double(PyTuple_GetItem(args[3], 1), &a3.hand)
        && take_double(PyTuple_GetItem(args[3], 2), &a3.ux)
        && take_double(PyTuple_GetItem(args[3], 3), &a3.uy)
        && take_memory(&held, args[4], law, "out", true, 65, &view)
        && (a4 = view->buf, true)))
    return let_go(&held);
  predictors_kinematic_features_fill_pace(a0, a1, a2, a3, a4);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_kinematic_features_fill_shape(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kinematic.features:fill_shape";
  Held held;
  const Py_buffer *view;
  predictors_kinematic_track_State * a0;
  predictors_kinematic_history_Point a1;
  predictors_kinematic_features_Frame a2;
  predictors_kinematic_features_Values * a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", false, 29, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "point", 4)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.t)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.x)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.y)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.path)
        && take_tuple(args[2], law, "frame", 4)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.reach)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.hand)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.ux)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.uy)
        && take_memory(&held, args[3], law, "out", true, 65, &view)
        && (a3 = view->buf, true)))
    return let_go(&held);
  predictors_kinematic_features_fill_shape(a0, a1, a2, a3);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_kinematic_features_follow(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kinematic.features:follow";
  Held held;
  const Py_buffer *view;
  predictors_kinematic_features_State * a0;
  records_MotionRow a1;
  Tq_predictors_kinematic_history_Point_ result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "s", true, 273, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "m", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.t)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.x)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.y)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.vx)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.vy)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.ax)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.ay)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.settled)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.start)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.counts)))
    return let_go(&held);
  result = predictors_kinematic_features_follow(a0, a1);
  let_go(&held);
  return give_Tq_predictors_kinematic_history_Point_(result);
}
static PyObject *py_predictors_kinematic_features_frame_of(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kinematic.features:frame_of";
  Held held;
  const Py_buffer *view;
  predictors_kinematic_track_State * a0;
  predictors_kinematic_history_Point a1;
  records_MotionRow a2;
  predictors_kinematic_features_Frame result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "s", false, 29, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "point", 4)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.t)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.x)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.y)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.path)
        && take_tuple(args[2], law, "m", 10)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.vx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.vy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.ax)
        && take_double(PyTuple_GetItem(args[2], 6), &a2.ay)
        && take_double(PyTuple_GetItem(args[2], 7), &a2.settled)
        && take_double(PyTuple_GetItem(args[2], 8), &a2.start)
        && take_double(PyTuple_GetItem(args[2], 9), &a2.counts)))
    return let_go(&held);
  result = predictors_kinematic_features_frame_of(a0, a1, a2);
  let_go(&held);
  return give_predictors_kinematic_features_Frame(result);
}
static PyObject *py_predictors_kinematic_features_observe(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kinematic.features:observe";
  Held held;
  const Py_buffer *view;
  predictors_kinematic_features_State * a0;
  records_MotionRow a1;
  predictors_kinematic_features_Values * a2;
  Tq_predictors_kinematic_features_Frame_ result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "s", true, 273, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "m", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.t)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.x)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.y)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.vx)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.vy)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.ax)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.ay)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.settled)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.start)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.counts)
        && take_memory(&held, args[2], law, "out", true, 65, &view)
        && (a2 = view->buf, true)))
    return let_go(&held);
  result = predictors_kinematic_features_observe(a0, a1, a2);
  let_go(&held);
  return give_Tq_predictors_kinematic_features_Frame_(result);
}
static PyObject *py_predictors_kinematic_features_observe_all(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kinematic.features:observe_all";
  Held held;
  const Py_buffer *view;
  predictors_kinematic_features_State * a0;
  FlagVector a1;
  Table a2;
  Table a3;
  Table a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "s", true, 273, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "begin", 'b', 1, false, &view)
        && (a1 = (FlagVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "rows", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a2.m, 10)
        && take_array(&held, args[3], law, "out", 'd', 2, true, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[4], law, "frames", 'd', 2, true, &view)
        && (a4 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "frames", a4.m, 3)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS predictors_kinematic_features_observe_all(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_kinematic_features_rewind(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kinematic.features:rewind";
  Held held;
  const Py_buffer *view;
  predictors_kinematic_features_State * a0;
  bool a1;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "s", true, 273, &view)
        && (a0 = view->buf, true)
        && take_bool(args[1], &a1)))
    return let_go(&held);
  predictors_kinematic_features_rewind(a0, a1);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_kinematic_history_begin(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kinematic.history:begin";
  Held held;
  const Py_buffer *view;
  predictors_kinematic_history_State * a0;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "s", true, 202, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  predictors_kinematic_history_begin(a0);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_kinematic_history_extend(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kinematic.history:extend";
  Held held;
  const Py_buffer *view;
  predictors_kinematic_history_State * a0;
  T3d a1;
  T3d a2;
  predictors_kinematic_history_Point result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "s", true, 202, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "last", 3)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_tuple(args[2], law, "now", 3)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.f2)))
    return let_go(&held);
  result = predictors_kinematic_history_extend(a0, a1, a2);
  let_go(&held);
  return give_predictors_kinematic_history_Point(result);
}
static PyObject *py_predictors_kinematic_history_past(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kinematic.history:past";
  Held held;
  const Py_buffer *view;
  predictors_kinematic_history_State * a0;
  predictors_kinematic_history_Point a1;
  double a2;
  T3d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "s", false, 202, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "now", 4)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.t)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.x)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.y)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.path)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = predictors_kinematic_history_past(a0, a1, a2);
  let_go(&held);
  return give_T3d(result);
}
static PyObject *py_predictors_kinematic_network_activate(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kinematic.network:activate";
  Held held;
  const Py_buffer *view;
  Vector a0;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_array(&held, args[0], law, "sums", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  predictors_kinematic_network_activate(a0);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_kinematic_network_evaluate(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kinematic.network:evaluate";
  Held held;
  const Py_buffer *view;
  predictors_kinematic_network_Coefficients * a0;
  Vector a1;
  Vector a2;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "coefficients", false, 132, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "values", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "out", 'd', 1, true, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  result = predictors_kinematic_network_evaluate(a0, a1, a2);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_predictors_kinematic_network_factor(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kinematic.network:factor";
  Held held;
  const Py_buffer *view;
  predictors_kinematic_network_Calibration * a0;
  double a1;
  int64_t a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "calibration", false, 30, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_int64_t(args[2], &a2)))
    return let_go(&held);
  result = predictors_kinematic_network_factor(a0, a1, a2);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_kinematic_network_layer(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kinematic.network:layer";
  Held held;
  const Py_buffer *view;
  predictors_kinematic_network_Coefficients * a0;
  int64_t a1;
  Vector a2;
  Vector a3;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "coefficients", false, 132, &view)
        && (a0 = view->buf, true)
        && take_int64_t(args[1], &a1)
        && take_array(&held, args[2], law, "inputs", 'd', 1, false, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "sums", 'd', 1, true, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  result = predictors_kinematic_network_layer(a0, a1, a2, a3);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_predictors_kinematic_network_side(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kinematic.network:side";
  Held held;
  const Py_buffer *view;
  Vector a0;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_array(&held, args[0], law, "values", 'd', 1, false, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  result = predictors_kinematic_network_side(a0);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_kinematic_predictor_bounded_exp(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kinematic.predictor:bounded_exp";
  Held held;
  const Py_buffer *view;
  double a0;
  T2d a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_double(args[0], &a0)
        && take_tuple(args[1], law, "bounds", 2)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)))
    return let_go(&held);
  result = predictors_kinematic_predictor_bounded_exp(a0, a1);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_kinematic_predictor_follow(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kinematic.predictor:follow";
  Held held;
  const Py_buffer *view;
  predictors_kinematic_features_State * a0;
  T10d a1;
  predictors_kinematic_network_Coefficients * a2;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "s", true, 273, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "motion", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.f6)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.f7)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.f8)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.f9)
        && take_memory(&held, args[2], law, "coefficients", false, 132, &view)
        && (a2 = view->buf, true)))
    return let_go(&held);
  result = predictors_kinematic_predictor_follow(a0, a1, a2);
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_predictors_kinematic_predictor_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kinematic.predictor:step";
  Held held;
  const Py_buffer *view;
  predictors_kinematic_features_State * a0;
  T10d a1;
  predictors_kinematic_network_Coefficients * a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "s", true, 273, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "motion", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.f6)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.f7)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.f8)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.f9)
        && take_memory(&held, args[2], law, "coefficients", false, 132, &view)
        && (a2 = view->buf, true)))
    return let_go(&held);
  result = predictors_kinematic_predictor_step(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_predictors_kinematic_submovements_divide(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kinematic.submovements:divide";
  Held held;
  const Py_buffer *view;
  predictors_kinematic_submovements_State * a0;
  predictors_kinematic_history_Point a1;
  double a2;
  double a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", true, 13, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "point", 4)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.t)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.x)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.y)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.path)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  predictors_kinematic_submovements_divide(a0, a1, a2, a3);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_kinematic_track_advance(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.kinematic.track:advance";
  Held held;
  const Py_buffer *view;
  predictors_kinematic_track_State * a0;
  predictors_kinematic_history_Point a1;
  records_MotionRow a2;
  double a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", true, 29, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "point", 4)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.t)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.x)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.y)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.path)
        && take_tuple(args[2], law, "hand", 10)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.t)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.vx)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.vy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.ax)
        && take_double(PyTuple_GetItem(args[2], 6), &a2.ay)
        && take_double(PyTuple_GetItem(args[2], 7), &a2.settled)
        && take_double(PyTuple_GetItem(args[2], 8), &a2.start)
        && take_double(PyTuple_GetItem(args[2], 9), &a2.counts)
        && take_double(args[3], &a3)))
    return let_go(&held);
  predictors_kinematic_track_advance(a0, a1, a2, a3);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_ktm_conclude(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.ktm:conclude";
  Held held;
  const Py_buffer *view;
  predictors_ktm_Memory * a0;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "memory", true, 26, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  predictors_ktm_conclude(a0);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_ktm_distance(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.ktm:distance";
  Held held;
  const Py_buffer *view;
  predictors_movement_State * a0;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "s", false, 9, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  result = predictors_ktm_distance(a0);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_ktm_fill(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.ktm:fill";
  Held held;
  const Py_buffer *view;
  Vector a0;
  predictors_ktm_Settings * a1;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "values", 'd', 1, false, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_memory(&held, args[1], law, "settings", true, 26, &view)
        && (a1 = view->buf, true)))
    return let_go(&held);
  predictors_ktm_fill(a0, a1);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_ktm_forget(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.ktm:forget";
  Held held;
  const Py_buffer *view;
  predictors_ktm_Settings * a0;
  predictors_ktm_State * a1;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "settings", false, 26, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "s", true, 35, &view)
        && (a1 = view->buf, true)))
    return let_go(&held);
  predictors_ktm_forget(a0, a1);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_ktm_keep(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.ktm:keep";
  Held held;
  const Py_buffer *view;
  predictors_ktm_Memory * a0;
  predictors_ktm_State * a1;
  double a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "memory", true, 26, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "s", false, 35, &view)
        && (a1 = view->buf, true)
        && take_double(args[2], &a2)))
    return let_go(&held);
  predictors_ktm_keep(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_ktm_place_of_learned(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.ktm:place_of_learned";
  Held held;
  const Py_buffer *view;
  predictors_ktm_Settings * a0;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "settings", false, 26, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  result = predictors_ktm_place_of_learned(a0);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_predictors_ktm_place_of_template(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.ktm:place_of_template";
  Held held;
  const Py_buffer *view;
  predictors_ktm_Settings * a0;
  int64_t a1;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "settings", false, 26, &view)
        && (a0 = view->buf, true)
        && take_int64_t(args[1], &a1)))
    return let_go(&held);
  result = predictors_ktm_place_of_template(a0, a1);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_predictors_ktm_resample(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.ktm:resample";
  Held held;
  const Py_buffer *view;
  predictors_ktm_Memory * a0;
  predictors_ktm_State * a1;
  double a2;
  double a3;
  double a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "memory", false, 26, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "s", true, 35, &view)
        && (a1 = view->buf, true)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  predictors_ktm_resample(a0, a1, a2, a3, a4);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_ktm_sample(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.ktm:sample";
  Held held;
  const Py_buffer *view;
  predictors_ktm_Memory * a0;
  predictors_ktm_State * a1;
  double a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "memory", false, 26, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "s", true, 35, &view)
        && (a1 = view->buf, true)
        && take_double(args[2], &a2)))
    return let_go(&held);
  predictors_ktm_sample(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_ktm_samples_of(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.ktm:samples_of";
  Held held;
  const Py_buffer *view;
  double a0;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_double(args[0], &a0)))
    return let_go(&held);
  result = predictors_ktm_samples_of(a0);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_predictors_ktm_score(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.ktm:score";
  Held held;
  const Py_buffer *view;
  predictors_ktm_Settings * a0;
  int64_t a1;
  double a2;
  double a3;
  predictors_ktm_Template * a4;
  predictors_ktm_Match * a5;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_memory(&held, args[0], law, "settings", false, 26, &view)
        && (a0 = view->buf, true)
        && take_int64_t(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_memory(&held, args[4], law, "template", false, 2, &view)
        && (a4 = view->buf, true)
        && take_memory(&held, args[5], law, "match", true, 25, &view)
        && (a5 = view->buf, true)))
    return let_go(&held);
  predictors_ktm_score(a0, a1, a2, a3, a4, a5);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_ktm_sizes(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.ktm:sizes";
  Held held;
  const Py_buffer *view;
  Vector a0;
  T3q result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_array(&held, args[0], law, "values", 'd', 1, false, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  result = predictors_ktm_sizes(a0);
  let_go(&held);
  return give_T3q(result);
}
static PyObject *py_predictors_ktm_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.ktm:step";
  Held held;
  const Py_buffer *view;
  predictors_ktm_Memory * a0;
  T10d a1;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "memory", true, 26, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "motion", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.f6)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.f7)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.f8)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.f9)))
    return let_go(&held);
  result = predictors_ktm_step(a0, a1);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_predictors_ktm_template_count(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.ktm:template_count";
  Held held;
  const Py_buffer *view;
  predictors_ktm_Memory * a0;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "memory", false, 26, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  result = predictors_ktm_template_count(a0);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_predictors_ktm_winner(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.ktm:winner";
  Held held;
  const Py_buffer *view;
  predictors_ktm_Memory * a0;
  predictors_ktm_State * a1;
  double a2;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "memory", false, 26, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "s", true, 35, &view)
        && (a1 = view->buf, true)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = predictors_ktm_winner(a0, a1, a2);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_predictors_linear_before(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.linear:before";
  Held held;
  const Py_buffer *view;
  predictors_linear_Past * a0;
  double a1;
  double a2;
  Tb3d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "past", false, 25, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = predictors_linear_before(a0, a1, a2);
  let_go(&held);
  return give_Tb3d(result);
}
static PyObject *py_predictors_linear_remember(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.linear:remember";
  Held held;
  const Py_buffer *view;
  predictors_linear_Past * a0;
  double a1;
  double a2;
  double a3;
  double a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "past", true, 25, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  predictors_linear_remember(a0, a1, a2, a3, a4);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_linear_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.linear:step";
  Held held;
  const Py_buffer *view;
  predictors_linear_Memory * a0;
  T10d a1;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "memory", true, 36, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "motion", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.f6)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.f7)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.f8)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.f9)))
    return let_go(&held);
  result = predictors_linear_step(a0, a1);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_predictors_minimum_jerk_progress(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.minimum_jerk:progress";
  Held held;
  const Py_buffer *view;
  double a0;
  T2d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_double(args[0], &a0)))
    return let_go(&held);
  result = predictors_minimum_jerk_progress(a0);
  let_go(&held);
  return give_T2d(result);
}
static PyObject *py_predictors_minimum_jerk_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.minimum_jerk:step";
  Held held;
  const Py_buffer *view;
  predictors_movement_State * a0;
  T10d a1;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "s", true, 9, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "motion", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.f6)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.f7)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.f8)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.f9)))
    return let_go(&held);
  result = predictors_minimum_jerk_step(a0, a1);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_predictors_mixture_content(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.mixture:content";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  double a2;
  double a3;
  int64_t a4;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "parts", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_int64_t(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_int64_t(args[4], &a4)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = predictors_mixture_content(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_mixture_corrected_probability(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.mixture:corrected_probability";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double a2;
  double a3;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  result = predictors_mixture_corrected_probability(a0, a1, a2, a3);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_mixture_corrected_radius(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.mixture:corrected_radius";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = predictors_mixture_corrected_radius(a0, a1, a2);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_mixture_crossing(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.mixture:crossing";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  double a2;
  T3d a3;
  T3d a4;
  T2d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "parts", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_int64_t(args[1], &a1)
        && take_double(args[2], &a2)
        && take_tuple(args[3], law, "one", 3)
        && take_double(PyTuple_GetItem(args[3], 0), &a3.f0)
        && take_double(PyTuple_GetItem(args[3], 1), &a3.f1)
        && take_double(PyTuple_GetItem(args[3], 2), &a3.f2)
        && take_tuple(args[4], law, "other", 3)
        && take_double(PyTuple_GetItem(args[4], 0), &a4.f0)
        && take_double(PyTuple_GetItem(args[4], 1), &a4.f1)
        && take_double(PyTuple_GetItem(args[4], 2), &a4.f2)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = predictors_mixture_crossing(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T2d(result);
}
static PyObject *py_predictors_mixture_densities(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.mixture:densities";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  int64_t a2;
  Table a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_array(&held, args[0], law, "parts", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_int64_t(args[1], &a1)
        && take_int64_t(args[2], &a2)
        && take_array(&held, args[3], law, "out", 'd', 2, true, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS predictors_mixture_densities(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_mixture_density(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.mixture:density";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  double a2;
  double a3;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_array(&held, args[0], law, "parts", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_int64_t(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = predictors_mixture_density(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_mixture_edge_of(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.mixture:edge_of";
  Held held;
  const Py_buffer *view;
  int64_t a0;
  int64_t a1;
  int64_t a2;
  int64_t a3;
  int64_t a4;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_int64_t(args[0], &a0)
        && take_int64_t(args[1], &a1)
        && take_int64_t(args[2], &a2)
        && take_int64_t(args[3], &a3)
        && take_int64_t(args[4], &a4)))
    return let_go(&held);
  result = predictors_mixture_edge_of(a0, a1, a2, a3, a4);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_predictors_mixture_follow_cells(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.mixture:follow_cells";
  Held held;
  const Py_buffer *view;
  Table a0;
  Table a1;
  int64_t a2;
  int64_t a3;
  Vector a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "heights", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[1], law, "middles", 'd', 2, false, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_int64_t(args[2], &a2)
        && take_int64_t(args[3], &a3)
        && take_array(&held, args[4], law, "following", 'd', 1, true, &view)
        && (a4 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS predictors_mixture_follow_cells(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_mixture_heaviness(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.mixture:heaviness";
  Held held;
  const Py_buffer *view;
  double a0;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_double(args[0], &a0)))
    return let_go(&held);
  result = predictors_mixture_heaviness(a0);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_mixture_height(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.mixture:height";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  double a2;
  double a3;
  double a4;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "parts", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_int64_t(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = predictors_mixture_height(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_mixture_lines_of(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.mixture:lines_of";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  double a2;
  int64_t a3;
  Vector a4;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "parts", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_int64_t(args[1], &a1)
        && take_double(args[2], &a2)
        && take_int64_t(args[3], &a3)
        && take_array(&held, args[4], law, "out", 'd', 1, true, &view)
        && (a4 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = predictors_mixture_lines_of(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_predictors_mixture_outlines(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.mixture:outlines";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  double a2;
  Table a3;
  Vector a4;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "parts", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_int64_t(args[1], &a1)
        && take_double(args[2], &a2)
        && take_array(&held, args[3], law, "points", 'd', 2, true, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[4], law, "ends", 'd', 1, true, &view)
        && (a4 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = predictors_mixture_outlines(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_predictors_mixture_part_density(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.mixture:part_density";
  Held held;
  const Py_buffer *view;
  predictors_mixture_PartRow * a0;
  double a1;
  double a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "part", false, 7, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = predictors_mixture_part_density(a0, a1, a2);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_mixture_partner(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.mixture:partner";
  Held held;
  const Py_buffer *view;
  Vector a0;
  int64_t a1;
  double a2;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "sides", 'd', 1, false, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_int64_t(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = predictors_mixture_partner(a0, a1, a2);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_predictors_mixture_points_of(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.mixture:points_of";
  Held held;
  const Py_buffer *view;
  int64_t a0;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_int64_t(args[0], &a0)))
    return let_go(&held);
  result = predictors_mixture_points_of(a0);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_predictors_mixture_reach(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.mixture:reach";
  Held held;
  const Py_buffer *view;
  predictors_mixture_PartRow * a0;
  int64_t a1;
  double a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "part", false, 7, &view)
        && (a0 = view->buf, true)
        && take_int64_t(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = predictors_mixture_reach(a0, a1, a2);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_mixture_share_above(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.mixture:share_above";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  int64_t a2;
  Table a3;
  double a4;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "parts", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_int64_t(args[1], &a1)
        && take_int64_t(args[2], &a2)
        && take_array(&held, args[3], law, "known", 'd', 2, false, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_double(args[4], &a4)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = predictors_mixture_share_above(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_mixture_squared_radius(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.mixture:squared_radius";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)))
    return let_go(&held);
  result = predictors_mixture_squared_radius(a0, a1);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_mixture_squared_radius_over_tail(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.mixture:squared_radius_over_tail";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)))
    return let_go(&held);
  result = predictors_mixture_squared_radius_over_tail(a0, a1);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_mixture_threshold_of(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.mixture:threshold_of";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  double a2;
  int64_t a3;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_array(&held, args[0], law, "parts", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_int64_t(args[1], &a1)
        && take_double(args[2], &a2)
        && take_int64_t(args[3], &a3)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = predictors_mixture_threshold_of(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_movement_fault_of(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.movement:fault_of";
  Held held;
  const Py_buffer *view;
  predictors_movement_State * a0;
  records_MotionRow a1;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "s", false, 9, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "m", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.t)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.x)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.y)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.vx)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.vy)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.ax)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.ay)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.settled)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.start)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.counts)))
    return let_go(&held);
  result = predictors_movement_fault_of(a0, a1);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_predictors_movement_follow(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.movement:follow";
  Held held;
  const Py_buffer *view;
  predictors_movement_State * a0;
  records_MotionRow a1;
  Tqbd result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "s", true, 9, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "m", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.t)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.x)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.y)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.vx)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.vy)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.ax)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.ay)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.settled)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.start)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.counts)))
    return let_go(&held);
  result = predictors_movement_follow(a0, a1);
  let_go(&held);
  return give_Tqbd(result);
}
static PyObject *py_predictors_movement_phase(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.movement:phase";
  Held held;
  const Py_buffer *view;
  predictors_movement_State * a0;
  records_MotionRow a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "s", false, 9, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "m", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.t)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.x)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.y)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.vx)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.vy)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.ax)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.ay)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.settled)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.start)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.counts)))
    return let_go(&held);
  result = predictors_movement_phase(a0, a1);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_movement_refuse(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.movement:refuse";
  Held held;
  const Py_buffer *view;
  predictors_movement_State * a0;
  records_MotionRow a1;
  int64_t a2;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "s", false, 9, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "m", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.t)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.x)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.y)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.vx)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.vy)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.ax)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.ay)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.settled)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.start)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.counts)
        && take_int64_t(args[2], &a2)))
    return let_go(&held);
  result = predictors_movement_refuse(a0, a1, a2);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_predictors_switched_advance(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.switched:advance";
  Held held;
  const Py_buffer *view;
  predictors_switched_Settings * a0;
  predictors_switched_Axis * a1;
  double a2;
  double a3;
  double a4;
  double a5;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_memory(&held, args[0], law, "settings", false, 4, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "axis", true, 702, &view)
        && (a1 = view->buf, true)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)
        && take_double(args[5], &a5)))
    return let_go(&held);
  result = predictors_switched_advance(a0, a1, a2, a3, a4, a5);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_switched_direction_approach(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.switched_direction:approach";
  Held held;
  const Py_buffer *view;
  predictors_switched_direction_Settings * a0;
  predictors_switched_direction_Submovement * a1;
  double a2;
  double a3;
  double a4;
  double a5;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_memory(&held, args[0], law, "settings", false, 6, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "s", false, 8, &view)
        && (a1 = view->buf, true)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)
        && take_double(args[5], &a5)))
    return let_go(&held);
  result = predictors_switched_direction_approach(a0, a1, a2, a3, a4, a5);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_switched_direction_begin_submovement(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.switched_direction:begin_submovement";
  Held held;
  const Py_buffer *view;
  predictors_switched_direction_Submovement * a0;
  double a1;
  double a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "s", true, 8, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  predictors_switched_direction_begin_submovement(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_switched_direction_follow_submovement(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.switched_direction:follow_submovement";
  Held held;
  const Py_buffer *view;
  predictors_switched_direction_Submovement * a0;
  double a1;
  double a2;
  double a3;
  double a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "s", true, 8, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  predictors_switched_direction_follow_submovement(a0, a1, a2, a3, a4);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_predictors_switched_direction_gain(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.switched_direction:gain";
  Held held;
  const Py_buffer *view;
  predictors_switched_direction_Hand * a0;
  double a1;
  double a2;
  double a3;
  double a4;
  double a5;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_memory(&held, args[0], law, "hand", true, 6, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)
        && take_double(args[5], &a5)))
    return let_go(&held);
  result = predictors_switched_direction_gain(a0, a1, a2, a3, a4, a5);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_switched_direction_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.switched_direction:step";
  Held held;
  const Py_buffer *view;
  predictors_switched_direction_Memory * a0;
  T10d a1;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "memory", true, 29, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "motion", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.f6)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.f7)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.f8)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.f9)))
    return let_go(&held);
  result = predictors_switched_direction_step(a0, a1);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_predictors_switched_direction_time_constant(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.switched_direction:time_constant";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double a2;
  double a3;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  result = predictors_switched_direction_time_constant(a0, a1, a2, a3);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_predictors_switched_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.predictors.switched:step";
  Held held;
  const Py_buffer *view;
  predictors_switched_Memory * a0;
  T10d a1;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "memory", true, 1417, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "motion", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.f6)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.f7)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.f8)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.f9)))
    return let_go(&held);
  result = predictors_switched_step(a0, a1);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_records_endpoint(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.records:endpoint";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double a2;
  double a3;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  result = records_endpoint(a0, a1, a2, a3);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_records_event_at(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.records:event_at";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  T6d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "table", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "table", a0.m, 6)
        && take_int64_t(args[1], &a1)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = records_event_at(a0, a1); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T6d(result);
}
static PyObject *py_records_fault_of_event(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.records:fault_of_event";
  Held held;
  const Py_buffer *view;
  records_EventRow a0;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_tuple(args[0], law, "event", 6)
        && take_double(PyTuple_GetItem(args[0], 0), &a0.t)
        && take_double(PyTuple_GetItem(args[0], 1), &a0.x)
        && take_double(PyTuple_GetItem(args[0], 2), &a0.y)
        && take_double(PyTuple_GetItem(args[0], 3), &a0.dx)
        && take_double(PyTuple_GetItem(args[0], 4), &a0.dy)
        && take_double(PyTuple_GetItem(args[0], 5), &a0.buttons)))
    return let_go(&held);
  result = records_fault_of_event(a0);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_records_refused(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.records:refused";
  Held held;
  const Py_buffer *view;
  int64_t a0;
  double a1;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_int64_t(args[0], &a0)
        && take_double(args[1], &a1)))
    return let_go(&held);
  result = records_refused(a0, a1);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_records_row_at(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.records:row_at";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "table", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "table", a0.m, 10)
        && take_int64_t(args[1], &a1)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = records_row_at(a0, a1); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_regions_reach(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.regions:reach";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)))
    return let_go(&held);
  result = regions_reach(a0, a1);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_regression_delay_capacity(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.regression.delay:capacity";
  Held held;
  const Py_buffer *view;
  int64_t a0;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_int64_t(args[0], &a0)))
    return let_go(&held);
  result = regression_delay_capacity(a0);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_regression_delay_delayed(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.regression.delay:delayed";
  Held held;
  const Py_buffer *view;
  regression_delay_Ring * a0;
  int64_t a1;
  double a2;
  Vector a3;
  Tbd result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "ring", false, 2, &view)
        && (a0 = view->buf, true)
        && take_int64_t(args[1], &a1)
        && take_double(args[2], &a2)
        && take_array(&held, args[3], law, "w", 'd', 1, true, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  result = regression_delay_delayed(a0, a1, a2, a3);
  let_go(&held);
  return give_Tbd(result);
}
static PyObject *py_regression_delay_push(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.regression.delay:push";
  Held held;
  const Py_buffer *view;
  regression_delay_Ring * a0;
  int64_t a1;
  double a2;
  double a3;
  Vector a4;
  double a5;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_memory(&held, args[0], law, "ring", true, 2, &view)
        && (a0 = view->buf, true)
        && take_int64_t(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_array(&held, args[4], law, "w", 'd', 1, false, &view)
        && (a4 = (Vector){view->buf, view->shape[0]}, true)
        && take_double(args[5], &a5)))
    return let_go(&held);
  regression_delay_push(a0, a1, a2, a3, a4, a5);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_regression_delay_states(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.regression.delay:states";
  Held held;
  const Py_buffer *view;
  int64_t a0;
  int64_t a1;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_int64_t(args[0], &a0)
        && take_int64_t(args[1], &a1)))
    return let_go(&held);
  result = regression_delay_states(a0, a1);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_regression_drem_advance(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.regression.drem:advance";
  Held held;
  const Py_buffer *view;
  regression_drem_State * a0;
  regression_drem_Regression a1;
  double a2;
  double a3;
  double a4;
  double a5;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_memory(&held, args[0], law, "s", true, 4, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "r", 8)
        && take_array(&held, PyTuple_GetItem(args[1], 0), law, "r", 'd', 1, true, &view)
        && (a1.w = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 1), law, "r", 'd', 1, true, &view)
        && (a1.largest = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 2), law, "r", 'd', 1, true, &view)
        && (a1.theta = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 3), law, "r", 'd', 1, true, &view)
        && (a1.Y = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 4), law, "r", 'd', 1, true, &view)
        && (a1.mixed = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 5), law, "r", 'd', 2, true, &view)
        && (a1.Phi = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 6), law, "r", 'd', 1, true, &view)
        && (a1.scratch = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 7), law, "r", 'd', 1, true, &view)
        && (a1.past = (Vector){view->buf, view->shape[0]}, true)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)
        && take_double(args[5], &a5)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = regression_drem_advance(a0, a1, a2, a3, a4, a5); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_regression_drem_determinant(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.regression.drem:determinant";
  Held held;
  const Py_buffer *view;
  Table a0;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_array(&held, args[0], law, "a", 'd', 2, true, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = regression_drem_determinant(a0); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_regression_drem_extend(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.regression.drem:extend";
  Held held;
  const Py_buffer *view;
  regression_drem_Regression a0;
  double a1;
  double a2;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_tuple(args[0], law, "r", 8)
        && take_array(&held, PyTuple_GetItem(args[0], 0), law, "r", 'd', 1, true, &view)
        && (a0.w = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 1), law, "r", 'd', 1, true, &view)
        && (a0.largest = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 2), law, "r", 'd', 1, true, &view)
        && (a0.theta = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 3), law, "r", 'd', 1, true, &view)
        && (a0.Y = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 4), law, "r", 'd', 1, true, &view)
        && (a0.mixed = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 5), law, "r", 'd', 2, true, &view)
        && (a0.Phi = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 6), law, "r", 'd', 1, true, &view)
        && (a0.scratch = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 7), law, "r", 'd', 1, true, &view)
        && (a0.past = (Vector){view->buf, view->shape[0]}, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = regression_drem_extend(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_regression_drem_mix(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.regression.drem:mix";
  Held held;
  const Py_buffer *view;
  Table a0;
  Vector a1;
  Vector a2;
  Vector a3;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_array(&held, args[0], law, "a", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[1], law, "y", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "out", 'd', 1, true, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "scratch", 'd', 1, true, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = regression_drem_mix(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_regression_drem_mix3(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.regression.drem:mix3";
  Held held;
  const Py_buffer *view;
  Table a0;
  Vector a1;
  Vector a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "a", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "a", a0.m, 3)
        && take_array(&held, args[1], law, "y", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "out", 'd', 1, true, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = regression_drem_mix3(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_regression_drem_numbers(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.regression.drem:numbers";
  Held held;
  const Py_buffer *view;
  int64_t a0;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_int64_t(args[0], &a0)))
    return let_go(&held);
  result = regression_drem_numbers(a0);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_regression_drem_remember(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.regression.drem:remember";
  Held held;
  const Py_buffer *view;
  regression_drem_State * a0;
  regression_drem_Regression a1;
  double a2;
  double a3;
  double a4;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "s", true, 4, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "r", 8)
        && take_array(&held, PyTuple_GetItem(args[1], 0), law, "r", 'd', 1, true, &view)
        && (a1.w = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 1), law, "r", 'd', 1, true, &view)
        && (a1.largest = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 2), law, "r", 'd', 1, true, &view)
        && (a1.theta = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 3), law, "r", 'd', 1, true, &view)
        && (a1.Y = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 4), law, "r", 'd', 1, true, &view)
        && (a1.mixed = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 5), law, "r", 'd', 2, true, &view)
        && (a1.Phi = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 6), law, "r", 'd', 1, true, &view)
        && (a1.scratch = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 7), law, "r", 'd', 1, true, &view)
        && (a1.past = (Vector){view->buf, view->shape[0]}, true)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = regression_drem_remember(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_regression_gradient_descend(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.regression.gradient:descend";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double a2;
  double a3;
  double a4;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  result = regression_gradient_descend(a0, a1, a2, a3, a4);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_regression_gradient_descend_along(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.regression.gradient:descend_along";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Table a2;
  double a3;
  double a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "theta", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "w", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "gain", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS regression_gradient_descend_along(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_regression_least_squares_advance(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.regression.least_squares:advance";
  Held held;
  const Py_buffer *view;
  regression_least_squares_Sums * a0;
  regression_least_squares_Regression a1;
  double a2;
  double a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", true, 3, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "regression", 3)
        && take_array(&held, PyTuple_GetItem(args[1], 0), law, "regression", 'd', 1, true, &view)
        && (a1.w = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 1), law, "regression", 'd', 1, true, &view)
        && (a1.z = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 2), law, "regression", 'd', 2, true, &view)
        && (a1.R = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS regression_least_squares_advance(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_regression_least_squares_excitation(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.regression.least_squares:excitation";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "r", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_int64_t(args[1], &a1)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = regression_least_squares_excitation(a0, a1); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_regression_least_squares_numbers(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.regression.least_squares:numbers";
  Held held;
  const Py_buffer *view;
  int64_t a0;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_int64_t(args[0], &a0)))
    return let_go(&held);
  result = regression_least_squares_numbers(a0);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_regression_least_squares_solve(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.regression.least_squares:solve";
  Held held;
  const Py_buffer *view;
  regression_least_squares_Regression a0;
  double a1;
  Vector a2;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_tuple(args[0], law, "regression", 3)
        && take_array(&held, PyTuple_GetItem(args[0], 0), law, "regression", 'd', 1, false, &view)
        && (a0.w = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 1), law, "regression", 'd', 1, false, &view)
        && (a0.z = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 2), law, "regression", 'd', 2, false, &view)
        && (a0.R = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_double(args[1], &a1)
        && take_array(&held, args[2], law, "out", 'd', 1, true, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = regression_least_squares_solve(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_scoring_measures_endpoint_hits(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.measures.endpoint:hits";
  Held held;
  const Py_buffer *view;
  Table a0;
  Table a1;
  WholeVector a2;
  WholeVector a3;
  Table a4;
  Vector a5;
  Table a6;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 7)
        && take_array(&held, args[0], law, "rows", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a0.m, 3)
        && take_array(&held, args[1], law, "answers", 'd', 2, false, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[2], law, "offsets", 'q', 1, false, &view)
        && (a2 = (WholeVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "arrivals", 'q', 1, false, &view)
        && (a3 = (WholeVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[4], law, "discs", 'd', 2, false, &view)
        && (a4 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "discs", a4.m, 3)
        && take_array(&held, args[5], law, "shares", 'd', 1, false, &view)
        && (a5 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[6], law, "out", 'd', 2, true, &view)
        && (a6 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS scoring_measures_endpoint_hits(a0, a1, a2, a3, a4, a5, a6); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_scoring_measures_endpoint_measure(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.measures.endpoint:measure";
  Held held;
  const Py_buffer *view;
  Table a0;
  Table a1;
  Vector a2;
  WholeVector a3;
  WholeVector a4;
  Table a5;
  WholeVector a6;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 7)
        && take_array(&held, args[0], law, "rows", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[1], law, "answers", 'd', 2, false, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[2], law, "fractions", 'd', 1, false, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "offsets", 'q', 1, false, &view)
        && (a3 = (WholeVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[4], law, "arrivals", 'q', 1, false, &view)
        && (a4 = (WholeVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[5], law, "out", 'd', 2, true, &view)
        && (a5 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[6], law, "faults", 'q', 1, true, &view)
        && (a6 = (WholeVector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS scoring_measures_endpoint_measure(a0, a1, a2, a3, a4, a5, a6); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_scoring_measures_endpoint_measure_trial(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.measures.endpoint:measure_trial";
  Held held;
  const Py_buffer *view;
  Table a0;
  Table a1;
  Vector a2;
  int64_t a3;
  Vector a4;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "rows", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a0.m, 3)
        && take_array(&held, args[1], law, "answers", 'd', 2, false, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[2], law, "fractions", 'd', 1, false, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)
        && take_int64_t(args[3], &a3)
        && take_array(&held, args[4], law, "out", 'd', 1, true, &view)
        && (a4 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = scoring_measures_endpoint_measure_trial(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_scoring_measures_endpoint_moments(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.measures.endpoint:moments";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  int64_t a2;
  int64_t a3;
  Vector a4;
  WholeVector a5;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_array(&held, args[0], law, "rows", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a0.m, 1)
        && take_int64_t(args[1], &a1)
        && take_int64_t(args[2], &a2)
        && take_int64_t(args[3], &a3)
        && take_array(&held, args[4], law, "shares", 'd', 1, false, &view)
        && (a4 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[5], law, "out", 'q', 1, true, &view)
        && (a5 = (WholeVector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS scoring_measures_endpoint_moments(a0, a1, a2, a3, a4, a5); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_scoring_measures_regions_axis_score(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.measures.regions:axis_score";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = scoring_measures_regions_axis_score(a0, a1, a2);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_scoring_measures_regions_beta_fraction(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.measures.regions:beta_fraction";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = scoring_measures_regions_beta_fraction(a0, a1, a2);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_scoring_measures_regions_calibrate(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.measures.regions:calibrate";
  Held held;
  const Py_buffer *view;
  Table a0;
  Table a1;
  WholeVector a2;
  WholeVector a3;
  Table a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "rows", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a0.m, 3)
        && take_array(&held, args[1], law, "answers", 'd', 2, false, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "answers", a1.m, 9)
        && take_array(&held, args[2], law, "offsets", 'q', 1, false, &view)
        && (a2 = (WholeVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "arrivals", 'q', 1, false, &view)
        && (a3 = (WholeVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[4], law, "out", 'd', 2, true, &view)
        && (a4 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "out", a4.m, 1)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS scoring_measures_regions_calibrate(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_scoring_measures_regions_distribution(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.measures.regions:distribution";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)))
    return let_go(&held);
  result = scoring_measures_regions_distribution(a0, a1);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_scoring_measures_regions_incomplete_beta(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.measures.regions:incomplete_beta";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = scoring_measures_regions_incomplete_beta(a0, a1, a2);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_scoring_measures_regions_inside_by_time(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.measures.regions:inside_by_time";
  Held held;
  const Py_buffer *view;
  Table a0;
  Table a1;
  WholeVector a2;
  WholeVector a3;
  Vector a4;
  Table a5;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_array(&held, args[0], law, "rows", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a0.m, 3)
        && take_array(&held, args[1], law, "answers", 'd', 2, false, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "answers", a1.m, 9)
        && take_array(&held, args[2], law, "offsets", 'q', 1, false, &view)
        && (a2 = (WholeVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "arrivals", 'q', 1, false, &view)
        && (a3 = (WholeVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[4], law, "shares", 'd', 1, false, &view)
        && (a4 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[5], law, "out", 'd', 2, true, &view)
        && (a5 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS scoring_measures_regions_inside_by_time(a0, a1, a2, a3, a4, a5); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_scoring_measures_regions_log_beta(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.measures.regions:log_beta";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)))
    return let_go(&held);
  result = scoring_measures_regions_log_beta(a0, a1);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_scoring_measures_regions_ranked_score(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.measures.regions:ranked_score";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)))
    return let_go(&held);
  result = scoring_measures_regions_ranked_score(a0, a1);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_scoring_measures_regions_student_score(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.measures.regions:student_score";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = scoring_measures_regions_student_score(a0, a1, a2);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_scoring_measures_regions_surprise(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.measures.regions:surprise";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double a2;
  double a3;
  double a4;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  result = scoring_measures_regions_surprise(a0, a1, a2, a3, a4);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_scoring_measures_time_left_inside_by_time(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.measures.time_left:inside_by_time";
  Held held;
  const Py_buffer *view;
  Table a0;
  Table a1;
  WholeVector a2;
  WholeVector a3;
  Vector a4;
  Table a5;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_array(&held, args[0], law, "rows", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a0.m, 1)
        && take_array(&held, args[1], law, "answers", 'd', 2, false, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "answers", a1.m, 10)
        && take_array(&held, args[2], law, "offsets", 'q', 1, false, &view)
        && (a2 = (WholeVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "arrivals", 'q', 1, false, &view)
        && (a3 = (WholeVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[4], law, "shares", 'd', 1, false, &view)
        && (a4 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[5], law, "out", 'd', 2, true, &view)
        && (a5 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS scoring_measures_time_left_inside_by_time(a0, a1, a2, a3, a4, a5); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_scoring_measures_time_left_time_left(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.measures.time_left:time_left";
  Held held;
  const Py_buffer *view;
  Table a0;
  Table a1;
  WholeVector a2;
  WholeVector a3;
  double a4;
  Table a5;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_array(&held, args[0], law, "rows", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a0.m, 1)
        && take_array(&held, args[1], law, "answers", 'd', 2, false, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "answers", a1.m, 10)
        && take_array(&held, args[2], law, "offsets", 'q', 1, false, &view)
        && (a2 = (WholeVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "arrivals", 'q', 1, false, &view)
        && (a3 = (WholeVector){view->buf, view->shape[0]}, true)
        && take_double(args[4], &a4)
        && take_array(&held, args[5], law, "out", 'd', 2, true, &view)
        && (a5 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "out", a5.m, 4)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS scoring_measures_time_left_time_left(a0, a1, a2, a3, a4, a5); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_scoring_measures_time_left_within(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.measures.time_left:within";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double a2;
  double a3;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  result = scoring_measures_time_left_within(a0, a1, a2, a3);
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_scoring_summary_sums_add_trials(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.summary.sums:add_trials";
  Held held;
  const Py_buffer *view;
  Table a0;
  WholeVector a1;
  FlagTable a2;
  Table a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_array(&held, args[0], law, "columns", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[1], law, "person", 'q', 1, false, &view)
        && (a1 = (WholeVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "inside", 'b', 2, false, &view)
        && (a2 = (FlagTable){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[3], law, "sums", 'd', 2, true, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS scoring_summary_sums_add_trials(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_scoring_target_choice_account(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.target_choice:account";
  Held held;
  const Py_buffer *view;
  Table a0;
  Table a1;
  Table a2;
  Table a3;
  int64_t a4;
  double a5;
  double a6;
  double a7;
  Vector a8;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 9)
        && take_array(&held, args[0], law, "events", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "events", a0.m, 3)
        && take_array(&held, args[1], law, "answers", 'd', 2, false, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "answers", a1.m, 7)
        && take_array(&held, args[2], law, "table", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "table", a2.m, 3)
        && take_array(&held, args[3], law, "shares", 'd', 2, false, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_int64_t(args[4], &a4)
        && take_double(args[5], &a5)
        && take_double(args[6], &a6)
        && take_double(args[7], &a7)
        && take_array(&held, args[8], law, "out", 'd', 1, true, &view)
        && (a8 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS scoring_target_choice_account(a0, a1, a2, a3, a4, a5, a6, a7, a8); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_scoring_target_choice_nearest(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.target_choice:nearest";
  Held held;
  const Py_buffer *view;
  Table a0;
  double a1;
  double a2;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "table", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "table", a0.m, 2)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = scoring_target_choice_nearest(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_scoring_target_choice_read(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.target_choice:read";
  Held held;
  const Py_buffer *view;
  Table a0;
  Table a1;
  Table a2;
  int64_t a3;
  int64_t a4;
  Vector a5;
  Table a6;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 7)
        && take_array(&held, args[0], law, "events", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "events", a0.m, 3)
        && take_array(&held, args[1], law, "table", 'd', 2, false, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "table", a1.m, 2)
        && take_array(&held, args[2], law, "shares", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_int64_t(args[3], &a3)
        && take_int64_t(args[4], &a4)
        && take_array(&held, args[5], law, "fractions", 'd', 1, false, &view)
        && (a5 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[6], law, "out", 'd', 2, true, &view)
        && (a6 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "out", a6.m, 4)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS scoring_target_choice_read(a0, a1, a2, a3, a4, a5, a6); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_scoring_target_choice_weigh(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.target_choice:weigh";
  Held held;
  const Py_buffer *view;
  Table a0;
  Table a1;
  Table a2;
  targets_posterior_Coefficients * a3;
  double a4;
  Table a5;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_array(&held, args[0], law, "events", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "events", a0.m, 3)
        && take_array(&held, args[1], law, "answers", 'd', 2, false, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "answers", a1.m, 10)
        && take_array(&held, args[2], law, "table", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "table", a2.m, 5)
        && take_memory(&held, args[3], law, "coefficients", false, 32, &view)
        && (a3 = view->buf, true)
        && take_double(args[4], &a4)
        && take_array(&held, args[5], law, "shares", 'd', 2, true, &view)
        && (a5 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS scoring_target_choice_weigh(a0, a1, a2, a3, a4, a5); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_scoring_trials_cut(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.trials:cut";
  Held held;
  const Py_buffer *view;
  Table a0;
  WholeVector a1;
  WholeTable a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "rows", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[1], law, "offsets", 'q', 1, false, &view)
        && (a1 = (WholeVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "out", 'q', 2, true, &view)
        && (a2 = (WholeTable){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "out", a2.m, 5)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS scoring_trials_cut(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_scoring_trials_departure(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.trials:departure";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  int64_t a2;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "rows", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_int64_t(args[1], &a1)
        && take_int64_t(args[2], &a2)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = scoring_trials_departure(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_scoring_trials_divide(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.trials:divide";
  Held held;
  const Py_buffer *view;
  Table a0;
  WholeVector a1;
  FlagVector a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "motions", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "motions", a0.m, 5)
        && take_array(&held, args[1], law, "offsets", 'q', 1, false, &view)
        && (a1 = (WholeVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "out", 'b', 1, true, &view)
        && (a2 = (FlagVector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS scoring_trials_divide(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_scoring_trials_divided(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.trials:divided";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  int64_t a2;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "motions", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "motions", a0.m, 5)
        && take_int64_t(args[1], &a1)
        && take_int64_t(args[2], &a2)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = scoring_trials_divided(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_scoring_trials_fault(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.trials:fault";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  int64_t a2;
  T2q result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "rows", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_int64_t(args[1], &a1)
        && take_int64_t(args[2], &a2)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = scoring_trials_fault(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T2q(result);
}
static PyObject *py_scoring_trials_judge(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.trials:judge";
  Held held;
  const Py_buffer *view;
  Table a0;
  WholeVector a1;
  FlagVector a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "table", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "table", a0.m, 3)
        && take_array(&held, args[1], law, "offsets", 'q', 1, false, &view)
        && (a1 = (WholeVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "out", 'b', 1, true, &view)
        && (a2 = (FlagVector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS scoring_trials_judge(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_scoring_trials_selection(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.trials:selection";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  int64_t a2;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "rows", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a0.m, 6)
        && take_int64_t(args[1], &a1)
        && take_int64_t(args[2], &a2)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = scoring_trials_selection(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_scoring_trials_settling(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.trials:settling";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  int64_t a2;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "rows", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a0.m, 3)
        && take_int64_t(args[1], &a1)
        && take_int64_t(args[2], &a2)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = scoring_trials_settling(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_scoring_trials_straight_through(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.scoring.trials:straight_through";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  int64_t a2;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "table", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "table", a0.m, 3)
        && take_int64_t(args[1], &a1)
        && take_int64_t(args[2], &a2)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = scoring_trials_straight_through(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_simulation_hand_aim(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.hand:aim";
  Held held;
  const Py_buffer *view;
  simulation_hand_Hand * a0;
  double a1;
  double a2;
  double a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "hand", true, 1164, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  simulation_hand_aim(a0, a1, a2, a3);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_simulation_hand_begin(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.hand:begin";
  Held held;
  const Py_buffer *view;
  simulation_hand_Hand * a0;
  double a1;
  double a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "hand", true, 1164, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  simulation_hand_begin(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_simulation_hand_draw(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.hand:draw";
  Held held;
  const Py_buffer *view;
  simulation_hand_Stream * a0;
  simulation_person_Traits * a1;
  simulation_plan_Draws * a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "s", true, 6, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "traits", false, 20, &view)
        && (a1 = view->buf, true)
        && take_memory(&held, args[2], law, "draws", true, 36, &view)
        && (a2 = view->buf, true)))
    return let_go(&held);
  simulation_hand_draw(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_simulation_hand_normal(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.hand:normal";
  Held held;
  const Py_buffer *view;
  simulation_hand_Stream * a0;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "s", true, 6, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  result = simulation_hand_normal(a0);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_simulation_hand_report(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.hand:report";
  Held held;
  const Py_buffer *view;
  simulation_hand_Hand * a0;
  T5d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "hand", true, 1164, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  result = simulation_hand_report(a0);
  let_go(&held);
  return give_T5d(result);
}
static PyObject *py_simulation_hand_sow(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.hand:sow";
  Held held;
  const Py_buffer *view;
  simulation_hand_Stream * a0;
  double a1;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "s", true, 6, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)))
    return let_go(&held);
  simulation_hand_sow(a0, a1);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_simulation_hand_uniform(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.hand:uniform";
  Held held;
  const Py_buffer *view;
  simulation_hand_Stream * a0;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "s", true, 6, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  result = simulation_hand_uniform(a0);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_simulation_loop_acceleration(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.loop:acceleration";
  Held held;
  const Py_buffer *view;
  simulation_loop_Memory * a0;
  double a1;
  simulation_loop_Place a2;
  T2d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "memory", false, 1102, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_tuple(args[2], law, "place", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.u)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.v)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.vx)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.vy)))
    return let_go(&held);
  result = simulation_loop_acceleration(a0, a1, a2);
  let_go(&held);
  return give_T2d(result);
}
static PyObject *py_simulation_loop_advance(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.loop:advance";
  Held held;
  const Py_buffer *view;
  simulation_loop_Memory * a0;
  double a1;
  double a2;
  double a3;
  double a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "memory", true, 1102, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  simulation_loop_advance(a0, a1, a2, a3, a4);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_simulation_loop_assist(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.loop:assist";
  Held held;
  const Py_buffer *view;
  simulation_loop_Memory * a0;
  double a1;
  double a2;
  double a3;
  T2d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "memory", false, 1102, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  result = simulation_loop_assist(a0, a1, a2, a3);
  let_go(&held);
  return give_T2d(result);
}
static PyObject *py_simulation_loop_ballistic_force(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.loop:ballistic_force";
  Held held;
  const Py_buffer *view;
  simulation_loop_Memory * a0;
  double a1;
  T2d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "memory", false, 1102, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)))
    return let_go(&held);
  result = simulation_loop_ballistic_force(a0, a1);
  let_go(&held);
  return give_T2d(result);
}
static PyObject *py_simulation_loop_correct(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.loop:correct";
  Held held;
  const Py_buffer *view;
  simulation_loop_Memory * a0;
  double a1;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "memory", true, 1102, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)))
    return let_go(&held);
  simulation_loop_correct(a0, a1);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_simulation_loop_count(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.loop:count";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = simulation_loop_count(a0, a1, a2);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_simulation_loop_cursor_distance(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.loop:cursor_distance";
  Held held;
  const Py_buffer *view;
  simulation_loop_Settings * a0;
  double a1;
  double a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "settings", false, 55, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = simulation_loop_cursor_distance(a0, a1, a2);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_simulation_loop_cursor_in_mind(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.loop:cursor_in_mind";
  Held held;
  const Py_buffer *view;
  simulation_loop_Memory * a0;
  double a1;
  double a2;
  double a3;
  T2d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "memory", false, 1102, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  result = simulation_loop_cursor_in_mind(a0, a1, a2, a3);
  let_go(&held);
  return give_T2d(result);
}
static PyObject *py_simulation_loop_cursor_rate(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.loop:cursor_rate";
  Held held;
  const Py_buffer *view;
  simulation_loop_Settings * a0;
  double a1;
  double a2;
  T2d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "settings", false, 55, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = simulation_loop_cursor_rate(a0, a1, a2);
  let_go(&held);
  return give_T2d(result);
}
static PyObject *py_simulation_loop_decide(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.loop:decide";
  Held held;
  const Py_buffer *view;
  simulation_loop_Memory * a0;
  double a1;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "memory", true, 1102, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)))
    return let_go(&held);
  simulation_loop_decide(a0, a1);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_simulation_loop_enter(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.loop:enter";
  Held held;
  const Py_buffer *view;
  simulation_loop_State * a0;
  double a1;
  double a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "s", true, 1047, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  simulation_loop_enter(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_simulation_loop_hand_distance(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.loop:hand_distance";
  Held held;
  const Py_buffer *view;
  simulation_loop_Settings * a0;
  double a1;
  double a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "settings", false, 55, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = simulation_loop_hand_distance(a0, a1, a2);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_simulation_loop_launch(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.loop:launch";
  Held held;
  const Py_buffer *view;
  simulation_loop_Memory * a0;
  int64_t a1;
  double a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "memory", true, 1102, &view)
        && (a0 = view->buf, true)
        && take_int64_t(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  simulation_loop_launch(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_simulation_loop_play(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.loop:play";
  Held held;
  const Py_buffer *view;
  simulation_loop_Memory * a0;
  Table a1;
  Table a2;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "memory", true, 1102, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "rows", 'd', 2, false, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a1.m, 5)
        && take_array(&held, args[2], law, "out", 'd', 2, true, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = simulation_loop_play(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_simulation_loop_profile(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.loop:profile";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  T3d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)))
    return let_go(&held);
  result = simulation_loop_profile(a0, a1);
  let_go(&held);
  return give_T3d(result);
}
static PyObject *py_simulation_loop_report(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.loop:report";
  Held held;
  const Py_buffer *view;
  simulation_loop_Memory * a0;
  double a1;
  double a2;
  T2d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "memory", true, 1102, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = simulation_loop_report(a0, a1, a2);
  let_go(&held);
  return give_T2d(result);
}
static PyObject *py_simulation_loop_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.loop:step";
  Held held;
  const Py_buffer *view;
  simulation_loop_Memory * a0;
  T5d a1;
  T14d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "memory", true, 1102, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "chance", 5)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)))
    return let_go(&held);
  result = simulation_loop_step(a0, a1);
  let_go(&held);
  return give_T14d(result);
}
static PyObject *py_simulation_person_between(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.person:between";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double a2;
  double a3;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  result = simulation_person_between(a0, a1, a2, a3);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_simulation_person_grow(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.person:grow";
  Held held;
  const Py_buffer *view;
  simulation_person_Traits * a0;
  double a1;
  Vector a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "traits", true, 20, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_array(&held, args[2], law, "normals", 'd', 1, false, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  simulation_person_grow(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_simulation_plan_plan(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.plan:plan";
  Held held;
  const Py_buffer *view;
  simulation_loop_Settings * a0;
  simulation_person_Traits * a1;
  simulation_plan_Draws * a2;
  double a3;
  double a4;
  double a5;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_memory(&held, args[0], law, "settings", true, 55, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "traits", false, 20, &view)
        && (a1 = view->buf, true)
        && take_memory(&held, args[2], law, "draws", false, 36, &view)
        && (a2 = view->buf, true)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)
        && take_double(args[5], &a5)))
    return let_go(&held);
  simulation_plan_plan(a0, a1, a2, a3, a4, a5);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_simulation_plan_plan_piece(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.plan:plan_piece";
  Held held;
  const Py_buffer *view;
  simulation_loop_Settings * a0;
  simulation_person_Traits * a1;
  simulation_plan_Draws * a2;
  int64_t a3;
  double a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "settings", true, 55, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "traits", false, 20, &view)
        && (a1 = view->buf, true)
        && take_memory(&held, args[2], law, "draws", false, 36, &view)
        && (a2 = view->buf, true)
        && take_int64_t(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  simulation_plan_plan_piece(a0, a1, a2, a3, a4);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_simulation_plan_varied(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.simulation.plan:varied";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)))
    return let_go(&held);
  result = simulation_plan_varied(a0, a1);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_stage_copy_values(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.stage:copy_values";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "values", 'd', 1, false, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "memory", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  stage_copy_values(a0, a1);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_stage_first_refused(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.stage:first_refused";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_array(&held, args[0], law, "answers", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = stage_first_refused(a0); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_stage_learn_nothing(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.stage:learn_nothing";
  Held held;
  const Py_buffer *view;
  Vector a0;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_array(&held, args[0], law, "memory", 'd', 1, false, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  stage_learn_nothing(a0);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_aim_conclude(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.aim:conclude";
  Held held;
  const Py_buffer *view;
  targets_heading_Memory * a0;
  T_Table__Vector__Table__Vector_ a1;
  targets_posterior_Coefficients * a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "memory", true, 1586, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "targets", 4)
        && take_array(&held, PyTuple_GetItem(args[1], 0), law, "targets", 'd', 2, false, &view)
        && (a1.f0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 1), law, "targets", 'd', 1, false, &view)
        && (a1.f1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 2), law, "targets", 'd', 2, false, &view)
        && (a1.f2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 3), law, "targets", 'd', 1, false, &view)
        && (a1.f3 = (Vector){view->buf, view->shape[0]}, true)
        && take_memory(&held, args[2], law, "coefficients", false, 32, &view)
        && (a2 = view->buf, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS targets_aim_conclude(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_aim_fault(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.aim:fault";
  Held held;
  const Py_buffer *view;
  targets_heading_Person * a0;
  Tqd result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "learned", false, 198, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  result = targets_aim_fault(a0);
  let_go(&held);
  return give_Tqd(result);
}
static PyObject *py_targets_aim_lay_parts(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.aim:lay_parts";
  Held held;
  const Py_buffer *view;
  targets_heading_Memory * a0;
  T_Table__Vector__Table__Vector_ a1;
  Table a2;
  Tq2d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "memory", false, 1586, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "targets", 4)
        && take_array(&held, PyTuple_GetItem(args[1], 0), law, "targets", 'd', 2, false, &view)
        && (a1.f0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 1), law, "targets", 'd', 1, false, &view)
        && (a1.f1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 2), law, "targets", 'd', 2, false, &view)
        && (a1.f2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 3), law, "targets", 'd', 1, false, &view)
        && (a1.f3 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "out", 'd', 2, true, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = targets_aim_lay_parts(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_Tq2d(result);
}
static PyObject *py_targets_aim_learn_prediction(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.aim:learn_prediction";
  Held held;
  const Py_buffer *view;
  targets_heading_Memory * a0;
  T_Table__Vector__Table__Vector_ a1;
  targets_posterior_Coefficients * a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "memory", true, 1586, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "targets", 4)
        && take_array(&held, PyTuple_GetItem(args[1], 0), law, "targets", 'd', 2, false, &view)
        && (a1.f0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 1), law, "targets", 'd', 1, false, &view)
        && (a1.f1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 2), law, "targets", 'd', 2, false, &view)
        && (a1.f2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 3), law, "targets", 'd', 1, false, &view)
        && (a1.f3 = (Vector){view->buf, view->shape[0]}, true)
        && take_memory(&held, args[2], law, "coefficients", false, 32, &view)
        && (a2 = view->buf, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS targets_aim_learn_prediction(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_aim_learn_regions(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.aim:learn_regions";
  Held held;
  const Py_buffer *view;
  predictors_adaptation_region_widening_Radii * a0;
  targets_heading_Movement * a1;
  T2d a2;
  T2d a3;
  T_Table__Vector__Table__Vector_ a4;
  targets_posterior_Coefficients * a5;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_memory(&held, args[0], law, "s", true, 21, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "movement", false, 1371, &view)
        && (a1 = view->buf, true)
        && take_tuple(args[2], law, "end", 2)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_tuple(args[3], law, "span", 2)
        && take_double(PyTuple_GetItem(args[3], 0), &a3.f0)
        && take_double(PyTuple_GetItem(args[3], 1), &a3.f1)
        && take_tuple(args[4], law, "targets", 4)
        && take_array(&held, PyTuple_GetItem(args[4], 0), law, "targets", 'd', 2, false, &view)
        && (a4.f0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[4], 1), law, "targets", 'd', 1, false, &view)
        && (a4.f1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[4], 2), law, "targets", 'd', 2, false, &view)
        && (a4.f2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[4], 3), law, "targets", 'd', 1, false, &view)
        && (a4.f3 = (Vector){view->buf, view->shape[0]}, true)
        && take_memory(&held, args[5], law, "coefficients", false, 32, &view)
        && (a5 = view->buf, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS targets_aim_learn_regions(a0, a1, a2, a3, a4, a5); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_aim_record(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.aim:record";
  Held held;
  const Py_buffer *view;
  targets_heading_Movement * a0;
  targets_cursor_State * a1;
  targets_endpoint_Ellipse a2;
  T10d a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "movement", true, 1371, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "s", false, 15, &view)
        && (a1 = view->buf, true)
        && take_tuple(args[2], law, "region", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.sxx)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.sxy)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.syy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.tail)
        && take_tuple(args[3], law, "answer", 10)
        && take_double(PyTuple_GetItem(args[3], 0), &a3.f0)
        && take_double(PyTuple_GetItem(args[3], 1), &a3.f1)
        && take_double(PyTuple_GetItem(args[3], 2), &a3.f2)
        && take_double(PyTuple_GetItem(args[3], 3), &a3.f3)
        && take_double(PyTuple_GetItem(args[3], 4), &a3.f4)
        && take_double(PyTuple_GetItem(args[3], 5), &a3.f5)
        && take_double(PyTuple_GetItem(args[3], 6), &a3.f6)
        && take_double(PyTuple_GetItem(args[3], 7), &a3.f7)
        && take_double(PyTuple_GetItem(args[3], 8), &a3.f8)
        && take_double(PyTuple_GetItem(args[3], 9), &a3.f9)))
    return let_go(&held);
  targets_aim_record(a0, a1, a2, a3);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_aim_row_of(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.aim:row_of";
  Held held;
  const Py_buffer *view;
  Vector a0;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_array(&held, args[0], law, "values", 'd', 1, false, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  result = targets_aim_row_of(a0);
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_targets_aim_share_passed(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.aim:share_passed";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = targets_aim_share_passed(a0, a1, a2);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_targets_aim_size_of(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.aim:size_of";
  Held held;
  const Py_buffer *view;
  Table a0;
  Vector a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "rows", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a0.m, 4)
        && take_array(&held, args[1], law, "shares", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = targets_aim_size_of(a0, a1); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_targets_aim_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.aim:step";
  Held held;
  const Py_buffer *view;
  targets_heading_Memory * a0;
  T6d a1;
  T10d a2;
  T_Table__Vector__Table__Vector_ a3;
  targets_posterior_Coefficients * a4;
  T10d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "memory", true, 1586, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "event", 6)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_tuple(args[2], law, "answer", 10)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.f2)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.f3)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.f4)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.f5)
        && take_double(PyTuple_GetItem(args[2], 6), &a2.f6)
        && take_double(PyTuple_GetItem(args[2], 7), &a2.f7)
        && take_double(PyTuple_GetItem(args[2], 8), &a2.f8)
        && take_double(PyTuple_GetItem(args[2], 9), &a2.f9)
        && take_tuple(args[3], law, "targets", 4)
        && take_array(&held, PyTuple_GetItem(args[3], 0), law, "targets", 'd', 2, true, &view)
        && (a3.f0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[3], 1), law, "targets", 'd', 1, true, &view)
        && (a3.f1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[3], 2), law, "targets", 'd', 2, true, &view)
        && (a3.f2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[3], 3), law, "targets", 'd', 1, true, &view)
        && (a3.f3 = (Vector){view->buf, view->shape[0]}, true)
        && take_memory(&held, args[4], law, "coefficients", false, 32, &view)
        && (a4 = view->buf, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = targets_aim_step(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T10d(result);
}
static PyObject *py_targets_aim_walk(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.aim:walk";
  Held held;
  const Py_buffer *view;
  targets_heading_Memory * a0;
  FlagVector a1;
  Table a2;
  Table a3;
  T_Table__Vector__Table__Vector_ a4;
  targets_posterior_Coefficients * a5;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_memory(&held, args[0], law, "memory", true, 1586, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "begins", 'b', 1, false, &view)
        && (a1 = (FlagVector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "events", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "events", a2.m, 6)
        && take_array(&held, args[3], law, "answers", 'd', 2, true, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "answers", a3.m, 10)
        && take_tuple(args[4], law, "targets", 4)
        && take_array(&held, PyTuple_GetItem(args[4], 0), law, "targets", 'd', 2, true, &view)
        && (a4.f0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[4], 1), law, "targets", 'd', 1, true, &view)
        && (a4.f1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[4], 2), law, "targets", 'd', 2, true, &view)
        && (a4.f2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[4], 3), law, "targets", 'd', 1, true, &view)
        && (a4.f3 = (Vector){view->buf, view->shape[0]}, true)
        && take_memory(&held, args[5], law, "coefficients", false, 32, &view)
        && (a5 = view->buf, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS targets_aim_walk(a0, a1, a2, a3, a4, a5); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_arrival_mean(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.arrival:mean";
  Held held;
  const Py_buffer *view;
  targets_arrival_Durations * a0;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "s", false, 2, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  result = targets_arrival_mean(a0);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_targets_arrival_remember(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.arrival:remember";
  Held held;
  const Py_buffer *view;
  targets_arrival_Durations * a0;
  double a1;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "s", true, 2, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)))
    return let_go(&held);
  targets_arrival_remember(a0, a1);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_arrival_terms(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.arrival:terms";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double a2;
  double a3;
  double a4;
  T7d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  result = targets_arrival_terms(a0, a1, a2, a3, a4);
  let_go(&held);
  return give_T7d(result);
}
static PyObject *py_targets_choice_law_changes(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.choice_law:changes";
  Held held;
  const Py_buffer *view;
  T2q a0;
  T2q a1;
  T4q result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_tuple(args[0], law, "before", 2)
        && take_int64_t(PyTuple_GetItem(args[0], 0), &a0.f0)
        && take_int64_t(PyTuple_GetItem(args[0], 1), &a0.f1)
        && take_tuple(args[1], law, "now", 2)
        && take_int64_t(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_int64_t(PyTuple_GetItem(args[1], 1), &a1.f1)))
    return let_go(&held);
  result = targets_choice_law_changes(a0, a1);
  let_go(&held);
  return give_T4q(result);
}
static PyObject *py_targets_choice_law_decide(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.choice_law:decide";
  Held held;
  const Py_buffer *view;
  targets_cursor_State * a0;
  bool a1;
  double a2;
  T_Table_2_Vector_ a3;
  targets_decision_Settings a4;
  int64_t a5;
  T3q result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_memory(&held, args[0], law, "s", false, 15, &view)
        && (a0 = view->buf, true)
        && take_bool(args[1], &a1)
        && take_double(args[2], &a2)
        && take_tuple(args[3], law, "targets", 3)
        && take_array(&held, PyTuple_GetItem(args[3], 0), law, "targets", 'd', 2, true, &view)
        && (a3.f0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[3], 1), law, "targets", 'd', 1, true, &view)
        && (a3.f1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[3], 2), law, "targets", 'd', 1, true, &view)
        && (a3.f2 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[4], law, "settings", 3)
        && take_double(PyTuple_GetItem(args[4], 0), &a4.precision)
        && take_double(PyTuple_GetItem(args[4], 1), &a4.least_lead_s)
        && take_double(PyTuple_GetItem(args[4], 2), &a4.least_way_px)
        && take_int64_t(args[5], &a5)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = targets_choice_law_decide(a0, a1, a2, a3, a4, a5); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T3q(result);
}
static PyObject *py_targets_choice_law_enter(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.choice_law:enter";
  Held held;
  const Py_buffer *view;
  Table a0;
  Vector a1;
  double a2;
  double a3;
  bool a4;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "table", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[1], law, "inside", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_bool(args[4], &a4)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = targets_choice_law_enter(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_targets_choice_law_innermost(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.choice_law:innermost";
  Held held;
  const Py_buffer *view;
  Table a0;
  Vector a1;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "table", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "table", a0.m, 4)
        && take_array(&held, args[1], law, "inside", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = targets_choice_law_innermost(a0, a1); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_targets_choice_law_lay_places(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.choice_law:lay_places";
  Held held;
  const Py_buffer *view;
  Table a0;
  Table a1;
  Table a2;
  Vector a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_array(&held, args[0], law, "places", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "places", a0.m, 5)
        && take_array(&held, args[1], law, "table", 'd', 2, true, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "table", a1.m, 5)
        && take_array(&held, args[2], law, "keys", 'd', 2, true, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "keys", a2.m, 1)
        && take_array(&held, args[3], law, "shares", 'd', 1, true, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS targets_choice_law_lay_places(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_choice_law_place_of(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.choice_law:place_of";
  Held held;
  const Py_buffer *view;
  Table a0;
  double a1;
  int64_t a2;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "keys", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_double(args[1], &a1)
        && take_int64_t(args[2], &a2)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = targets_choice_law_place_of(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_targets_choice_law_replace(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.choice_law:replace";
  Held held;
  const Py_buffer *view;
  targets_choice_law_State * a0;
  double a1;
  T_Table__Vector_ a2;
  T_Table__Vector_ a3;
  targets_ledger_Account * a4;
  Table a5;
  T2b result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_memory(&held, args[0], law, "s", true, 2, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_tuple(args[2], law, "before", 2)
        && take_array(&held, PyTuple_GetItem(args[2], 0), law, "before", 'd', 2, false, &view)
        && (a2.f0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[2], 1), law, "before", 'd', 1, false, &view)
        && (a2.f1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[3], law, "now", 2)
        && take_array(&held, PyTuple_GetItem(args[3], 0), law, "now", 'd', 2, true, &view)
        && (a3.f0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[3], 1), law, "now", 'd', 1, true, &view)
        && (a3.f1 = (Vector){view->buf, view->shape[0]}, true)
        && take_memory(&held, args[4], law, "account", true, 16, &view)
        && (a4 = view->buf, true)
        && take_array(&held, args[5], law, "rows", 'd', 2, true, &view)
        && (a5 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = targets_choice_law_replace(a0, a1, a2, a3, a4, a5); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T2b(result);
}
static PyObject *py_targets_choice_law_reset(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.choice_law:reset";
  Held held;
  const Py_buffer *view;
  targets_choice_law_State * a0;
  Vector a1;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "s", true, 2, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "inside", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  targets_choice_law_reset(a0, a1);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_choice_law_update(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.choice_law:update";
  Held held;
  const Py_buffer *view;
  targets_choice_law_State * a0;
  targets_heading_Memory * a1;
  T_Table_2_Vector_ a2;
  Table a3;
  targets_decision_Settings a4;
  targets_ledger_Account * a5;
  Table a6;
  Vector a7;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 8)
        && take_memory(&held, args[0], law, "s", true, 2, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "memory", false, 1586, &view)
        && (a1 = view->buf, true)
        && take_tuple(args[2], law, "targets", 3)
        && take_array(&held, PyTuple_GetItem(args[2], 0), law, "targets", 'd', 2, true, &view)
        && (a2.f0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[2], 1), law, "targets", 'd', 1, true, &view)
        && (a2.f1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[2], 2), law, "targets", 'd', 1, true, &view)
        && (a2.f2 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "keys", 'd', 2, false, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_tuple(args[4], law, "settings", 3)
        && take_double(PyTuple_GetItem(args[4], 0), &a4.precision)
        && take_double(PyTuple_GetItem(args[4], 1), &a4.least_lead_s)
        && take_double(PyTuple_GetItem(args[4], 2), &a4.least_way_px)
        && take_memory(&held, args[5], law, "account", true, 16, &view)
        && (a5 = view->buf, true)
        && take_array(&held, args[6], law, "rows", 'd', 2, true, &view)
        && (a6 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[7], law, "out", 'd', 1, true, &view)
        && (a7 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = targets_choice_law_update(a0, a1, a2, a3, a4, a5, a6, a7); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_targets_cursor_begins(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.cursor:begins";
  Held held;
  const Py_buffer *view;
  targets_cursor_State * a0;
  double a1;
  double a2;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "s", false, 15, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = targets_cursor_begins(a0, a1, a2);
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_targets_cursor_follow(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.cursor:follow";
  Held held;
  const Py_buffer *view;
  targets_cursor_State * a0;
  double a1;
  double a2;
  double a3;
  double a4;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "s", true, 15, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  result = targets_cursor_follow(a0, a1, a2, a3, a4);
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_targets_cursor_until(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.cursor:until";
  Held held;
  const Py_buffer *view;
  targets_cursor_State * a0;
  double a1;
  double a2;
  double a3;
  double a4;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "s", false, 15, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  result = targets_cursor_until(a0, a1, a2, a3, a4);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_targets_cursor_usable(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.cursor:usable";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double a2;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = targets_cursor_usable(a0, a1, a2);
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_targets_decision_decide(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.decision:decide";
  Held held;
  const Py_buffer *view;
  targets_cursor_State * a0;
  Table a1;
  Vector a2;
  int64_t a3;
  double a4;
  T4d a5;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_memory(&held, args[0], law, "s", false, 15, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "table", 'd', 2, false, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[2], law, "shares", 'd', 1, false, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)
        && take_int64_t(args[3], &a3)
        && take_double(args[4], &a4)
        && take_tuple(args[5], law, "bounds", 4)
        && take_double(PyTuple_GetItem(args[5], 0), &a5.f0)
        && take_double(PyTuple_GetItem(args[5], 1), &a5.f1)
        && take_double(PyTuple_GetItem(args[5], 2), &a5.f2)
        && take_double(PyTuple_GetItem(args[5], 3), &a5.f3)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = targets_decision_decide(a0, a1, a2, a3, a4, a5); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_targets_decision_early(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.decision:early";
  Held held;
  const Py_buffer *view;
  targets_cursor_State * a0;
  Vector a1;
  double a2;
  double a3;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", false, 15, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "row", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  result = targets_decision_early(a0, a1, a2, a3);
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_targets_decision_likeliest(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.decision:likeliest";
  Held held;
  const Py_buffer *view;
  Vector a0;
  int64_t a1;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "shares", 'd', 1, false, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_int64_t(args[1], &a1)))
    return let_go(&held);
  result = targets_decision_likeliest(a0, a1);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_targets_decision_rank(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.decision:rank";
  Held held;
  const Py_buffer *view;
  Vector a0;
  int64_t a1;
  Vector a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "shares", 'd', 1, false, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_int64_t(args[1], &a1)
        && take_array(&held, args[2], law, "order", 'd', 1, true, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  targets_decision_rank(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_endpoint_ellipse(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.endpoint:ellipse";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  T2d a2;
  T2d a3;
  targets_endpoint_Ellipse result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_array(&held, args[0], law, "parts", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_int64_t(args[1], &a1)
        && take_tuple(args[2], law, "centre", 2)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_tuple(args[3], law, "way", 2)
        && take_double(PyTuple_GetItem(args[3], 0), &a3.f0)
        && take_double(PyTuple_GetItem(args[3], 1), &a3.f1)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = targets_endpoint_ellipse(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_targets_endpoint_Ellipse(result);
}
static PyObject *py_targets_endpoint_elsewhere(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.endpoint:elsewhere";
  Held held;
  const Py_buffer *view;
  targets_cursor_State * a0;
  T10d a1;
  targets_posterior_Law result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "s", false, 15, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "answer", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.f6)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.f7)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.f8)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.f9)))
    return let_go(&held);
  result = targets_endpoint_elsewhere(a0, a1);
  let_go(&held);
  return give_targets_posterior_Law(result);
}
static PyObject *py_targets_endpoint_geometric_median(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.endpoint:geometric_median";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  T2d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "parts", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_int64_t(args[1], &a1)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = targets_endpoint_geometric_median(a0, a1); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T2d(result);
}
static PyObject *py_targets_endpoint_mixture(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.endpoint:mixture";
  Held held;
  const Py_buffer *view;
  Table a0;
  Vector a1;
  targets_posterior_Law a2;
  double a3;
  Table a4;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "table", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[1], law, "shares", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "predicted", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.sxx)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.sxy)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.syy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.tail)
        && take_double(args[3], &a3)
        && take_array(&held, args[4], law, "out", 'd', 2, true, &view)
        && (a4 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = targets_endpoint_mixture(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_targets_endpoint_write_target(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.endpoint:write_target";
  Held held;
  const Py_buffer *view;
  Vector a0;
  targets_posterior_Law a1;
  double a2;
  predictors_mixture_PartRow * a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_array(&held, args[0], law, "row", 'd', 1, false, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[1], law, "predicted", 6)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.x)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.y)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.sxx)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.sxy)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.syy)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.tail)
        && take_double(args[2], &a2)
        && take_memory(&held, args[3], law, "part", true, 7, &view)
        && (a3 = view->buf, true)))
    return let_go(&held);
  targets_endpoint_write_target(a0, a1, a2, a3);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_heading_arrived(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.heading:arrived";
  Held held;
  const Py_buffer *view;
  targets_heading_Movement * a0;
  double a1;
  double a2;
  double a3;
  double a4;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "movement", false, 1371, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  result = targets_heading_arrived(a0, a1, a2, a3, a4);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_targets_heading_begin(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.heading:begin";
  Held held;
  const Py_buffer *view;
  targets_heading_Memory * a0;
  T_Table__Vector__Table__Vector_ a1;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "memory", true, 1586, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "targets", 4)
        && take_array(&held, PyTuple_GetItem(args[1], 0), law, "targets", 'd', 2, true, &view)
        && (a1.f0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 1), law, "targets", 'd', 1, true, &view)
        && (a1.f1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 2), law, "targets", 'd', 2, true, &view)
        && (a1.f2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 3), law, "targets", 'd', 1, true, &view)
        && (a1.f3 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS targets_heading_begin(a0, a1); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_heading_ended(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.heading:ended";
  Held held;
  const Py_buffer *view;
  targets_heading_Memory * a0;
  Table a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "memory", false, 1586, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "rows", 'd', 2, false, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = targets_heading_ended(a0, a1); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_targets_heading_follow(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.heading:follow";
  Held held;
  const Py_buffer *view;
  targets_heading_Memory * a0;
  T6d a1;
  T_Table__Vector__Table__Vector_ a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "memory", true, 1586, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "event", 6)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_tuple(args[2], law, "targets", 4)
        && take_array(&held, PyTuple_GetItem(args[2], 0), law, "targets", 'd', 2, true, &view)
        && (a2.f0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[2], 1), law, "targets", 'd', 1, true, &view)
        && (a2.f1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[2], 2), law, "targets", 'd', 2, true, &view)
        && (a2.f2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[2], 3), law, "targets", 'd', 1, true, &view)
        && (a2.f3 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS targets_heading_follow(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_heading_learn_target(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.heading:learn_target";
  Held held;
  const Py_buffer *view;
  targets_heading_Memory * a0;
  T_Table__Vector__Table__Vector_ a1;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "memory", true, 1586, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "targets", 4)
        && take_array(&held, PyTuple_GetItem(args[1], 0), law, "targets", 'd', 2, false, &view)
        && (a1.f0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 1), law, "targets", 'd', 1, false, &view)
        && (a1.f1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 2), law, "targets", 'd', 2, false, &view)
        && (a1.f2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 3), law, "targets", 'd', 1, false, &view)
        && (a1.f3 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS targets_heading_learn_target(a0, a1); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_heading_taken(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.heading:taken";
  Held held;
  const Py_buffer *view;
  Table a0;
  double a1;
  double a2;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "rows", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a0.m, 4)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = targets_heading_taken(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_targets_heading_weigh(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.heading:weigh";
  Held held;
  const Py_buffer *view;
  targets_heading_Memory * a0;
  T10d a1;
  T_Table__Vector__Table__Vector_ a2;
  targets_posterior_Coefficients * a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "memory", true, 1586, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "answer", 10)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.f6)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.f7)
        && take_double(PyTuple_GetItem(args[1], 8), &a1.f8)
        && take_double(PyTuple_GetItem(args[1], 9), &a1.f9)
        && take_tuple(args[2], law, "targets", 4)
        && take_array(&held, PyTuple_GetItem(args[2], 0), law, "targets", 'd', 2, true, &view)
        && (a2.f0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[2], 1), law, "targets", 'd', 1, true, &view)
        && (a2.f1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[2], 2), law, "targets", 'd', 2, true, &view)
        && (a2.f2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[2], 3), law, "targets", 'd', 1, true, &view)
        && (a2.f3 = (Vector){view->buf, view->shape[0]}, true)
        && take_memory(&held, args[3], law, "coefficients", false, 32, &view)
        && (a3 = view->buf, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS targets_heading_weigh(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_ledger_add(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.ledger:add";
  Held held;
  const Py_buffer *view;
  targets_ledger_Totals * a0;
  T5d a1;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "s", true, 7, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "movement", 5)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)))
    return let_go(&held);
  targets_ledger_add(a0, a1);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_ledger_begin(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.ledger:begin";
  Held held;
  const Py_buffer *view;
  targets_ledger_State * a0;
  Table a1;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "s", true, 8, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "rows", 'd', 2, true, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a1.m, 3)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS targets_ledger_begin(a0, a1); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_ledger_close(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.ledger:close";
  Held held;
  const Py_buffer *view;
  targets_ledger_State * a0;
  Table a1;
  double a2;
  int64_t a3;
  T3d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", false, 8, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "rows", 'd', 2, false, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a1.m, 3)
        && take_double(args[2], &a2)
        && take_int64_t(args[3], &a3)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = targets_ledger_close(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T3d(result);
}
static PyObject *py_targets_ledger_drop(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.ledger:drop";
  Held held;
  const Py_buffer *view;
  targets_ledger_Account * a0;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "s", true, 16, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  targets_ledger_drop(a0);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_ledger_enter(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.ledger:enter";
  Held held;
  const Py_buffer *view;
  targets_ledger_State * a0;
  Table a1;
  double a2;
  int64_t a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", false, 8, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "rows", 'd', 2, true, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_double(args[2], &a2)
        && take_int64_t(args[3], &a3)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS targets_ledger_enter(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_ledger_finish(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.ledger:finish";
  Held held;
  const Py_buffer *view;
  targets_ledger_Account * a0;
  Table a1;
  double a2;
  double a3;
  T6d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", true, 16, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "rows", 'd', 2, true, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a1.m, 4)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = targets_ledger_finish(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T6d(result);
}
static PyObject *py_targets_ledger_note_end(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.ledger:note_end";
  Held held;
  const Py_buffer *view;
  targets_ledger_Account * a0;
  Table a1;
  double a2;
  double a3;
  bool a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "s", true, 16, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "rows", 'd', 2, true, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a1.m, 4)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_bool(args[4], &a4)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS targets_ledger_note_end(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_ledger_note_entry(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.ledger:note_entry";
  Held held;
  const Py_buffer *view;
  targets_ledger_Account * a0;
  Table a1;
  double a2;
  double a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", true, 16, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "rows", 'd', 2, true, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a1.m, 4)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS targets_ledger_note_entry(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_ledger_note_proposal(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.ledger:note_proposal";
  Held held;
  const Py_buffer *view;
  targets_ledger_Account * a0;
  Table a1;
  double a2;
  double a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", true, 16, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "rows", 'd', 2, true, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a1.m, 4)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS targets_ledger_note_proposal(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_ledger_propose(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.ledger:propose";
  Held held;
  const Py_buffer *view;
  targets_ledger_State * a0;
  Table a1;
  double a2;
  int64_t a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", true, 8, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "rows", 'd', 2, true, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_double(args[2], &a2)
        && take_int64_t(args[3], &a3)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS targets_ledger_propose(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_ledger_row_of(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.ledger:row_of";
  Held held;
  const Py_buffer *view;
  targets_ledger_Account * a0;
  Table a1;
  double a2;
  bool a3;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", true, 16, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "rows", 'd', 2, true, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a1.m, 4)
        && take_double(args[2], &a2)
        && take_bool(args[3], &a3)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = targets_ledger_row_of(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_targets_ledger_withdraw(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.ledger:withdraw";
  Held held;
  const Py_buffer *view;
  targets_ledger_State * a0;
  double a1;
  int64_t a2;
  bool a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", true, 8, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_int64_t(args[2], &a2)
        && take_bool(args[3], &a3)))
    return let_go(&held);
  targets_ledger_withdraw(a0, a1, a2, a3);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_past_add_visit(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.past:add_visit";
  Held held;
  const Py_buffer *view;
  targets_past_Past * a0;
  int64_t a1;
  Table a2;
  Table a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", false, 136, &view)
        && (a0 = view->buf, true)
        && take_int64_t(args[1], &a1)
        && take_array(&held, args[2], law, "keys", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[3], law, "out", 'd', 2, true, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS targets_past_add_visit(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_past_elsewhere(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.past:elsewhere";
  Held held;
  const Py_buffer *view;
  targets_past_Past * a0;
  double a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "s", false, 136, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)))
    return let_go(&held);
  result = targets_past_elsewhere(a0, a1);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_targets_past_learn(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.past:learn";
  Held held;
  const Py_buffer *view;
  targets_past_Past * a0;
  Vector a1;
  Table a2;
  int64_t a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", true, 136, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "own", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "keys", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_int64_t(args[3], &a3)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS targets_past_learn(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_past_rule_weight(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.past:rule_weight";
  Held held;
  const Py_buffer *view;
  targets_past_Past * a0;
  int64_t a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "s", false, 136, &view)
        && (a0 = view->buf, true)
        && take_int64_t(args[1], &a1)))
    return let_go(&held);
  result = targets_past_rule_weight(a0, a1);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_targets_past_shares(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.past:shares";
  Held held;
  const Py_buffer *view;
  targets_past_Past * a0;
  Vector a1;
  Table a2;
  Table a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", false, 136, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "own", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "keys", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[3], law, "out", 'd', 2, true, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS targets_past_shares(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_past_weigh(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.past:weigh";
  Held held;
  const Py_buffer *view;
  targets_past_Past * a0;
  Vector a1;
  Table a2;
  Table a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", false, 136, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "own", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "keys", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[3], law, "table", 'd', 2, true, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "table", a3.m, 5)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS targets_past_weigh(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_posterior_direction(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.posterior:direction";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  T2d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)))
    return let_go(&held);
  result = targets_posterior_direction(a0, a1);
  let_go(&held);
  return give_T2d(result);
}
static PyObject *py_targets_posterior_feature(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.posterior:feature";
  Held held;
  const Py_buffer *view;
  Vector a0;
  targets_posterior_Situation a1;
  targets_posterior_Law a2;
  T6d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "row", 'd', 1, false, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[1], law, "now", 8)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.x)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.y)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.trail_x)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.trail_y)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.ux)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.uy)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.log_way)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.log_sweep)
        && take_tuple(args[2], law, "predicted", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.sxx)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.sxy)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.syy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.tail)))
    return let_go(&held);
  result = targets_posterior_feature(a0, a1, a2);
  let_go(&held);
  return give_T6d(result);
}
static PyObject *py_targets_posterior_features(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.posterior:features";
  Held held;
  const Py_buffer *view;
  targets_cursor_State * a0;
  Table a1;
  targets_posterior_Law a2;
  Table a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", false, 15, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "table", 'd', 2, false, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_tuple(args[2], law, "predicted", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.sxx)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.sxy)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.syy)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.tail)
        && take_array(&held, args[3], law, "out", 'd', 2, true, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "out", a3.m, 6)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS targets_posterior_features(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_posterior_lawful(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.posterior:lawful";
  Held held;
  const Py_buffer *view;
  targets_posterior_Law a0;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_tuple(args[0], law, "predicted", 6)
        && take_double(PyTuple_GetItem(args[0], 0), &a0.x)
        && take_double(PyTuple_GetItem(args[0], 1), &a0.y)
        && take_double(PyTuple_GetItem(args[0], 2), &a0.sxx)
        && take_double(PyTuple_GetItem(args[0], 3), &a0.sxy)
        && take_double(PyTuple_GetItem(args[0], 4), &a0.syy)
        && take_double(PyTuple_GetItem(args[0], 5), &a0.tail)))
    return let_go(&held);
  result = targets_posterior_lawful(a0);
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_targets_posterior_log_mass(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.posterior:log_mass";
  Held held;
  const Py_buffer *view;
  targets_posterior_Law a0;
  double a1;
  double a2;
  double a3;
  double a4;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_tuple(args[0], law, "predicted", 6)
        && take_double(PyTuple_GetItem(args[0], 0), &a0.x)
        && take_double(PyTuple_GetItem(args[0], 1), &a0.y)
        && take_double(PyTuple_GetItem(args[0], 2), &a0.sxx)
        && take_double(PyTuple_GetItem(args[0], 3), &a0.sxy)
        && take_double(PyTuple_GetItem(args[0], 4), &a0.syy)
        && take_double(PyTuple_GetItem(args[0], 5), &a0.tail)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  result = targets_posterior_log_mass(a0, a1, a2, a3, a4);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_targets_posterior_log_total(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.posterior:log_total";
  Held held;
  const Py_buffer *view;
  double a0;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_double(args[0], &a0)))
    return let_go(&held);
  result = targets_posterior_log_total(a0);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_targets_posterior_normalise(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.posterior:normalise";
  Held held;
  const Py_buffer *view;
  Vector a0;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_array(&held, args[0], law, "out", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  targets_posterior_normalise(a0);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_posterior_scores(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.posterior:scores";
  Held held;
  const Py_buffer *view;
  targets_cursor_State * a0;
  Table a1;
  T10d a2;
  targets_posterior_Coefficients * a3;
  double a4;
  Vector a5;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_memory(&held, args[0], law, "s", false, 15, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "table", 'd', 2, false, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "table", a1.m, 5)
        && take_tuple(args[2], law, "answer", 10)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.f2)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.f3)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.f4)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.f5)
        && take_double(PyTuple_GetItem(args[2], 6), &a2.f6)
        && take_double(PyTuple_GetItem(args[2], 7), &a2.f7)
        && take_double(PyTuple_GetItem(args[2], 8), &a2.f8)
        && take_double(PyTuple_GetItem(args[2], 9), &a2.f9)
        && take_memory(&held, args[3], law, "coefficients", false, 32, &view)
        && (a3 = view->buf, true)
        && take_double(args[4], &a4)
        && take_array(&held, args[5], law, "out", 'd', 1, true, &view)
        && (a5 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS targets_posterior_scores(a0, a1, a2, a3, a4, a5); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_posterior_situation(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.posterior:situation";
  Held held;
  const Py_buffer *view;
  targets_cursor_State * a0;
  targets_posterior_Situation result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "s", false, 15, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  result = targets_posterior_situation(a0);
  let_go(&held);
  return give_targets_posterior_Situation(result);
}
static PyObject *py_targets_posterior_unclaimed(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.posterior:unclaimed";
  Held held;
  const Py_buffer *view;
  targets_cursor_State * a0;
  double a1;
  double a2;
  T3d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "s", false, 15, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = targets_posterior_unclaimed(a0, a1, a2);
  let_go(&held);
  return give_T3d(result);
}
static PyObject *py_targets_prefetch_begin(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.prefetch:begin";
  Held held;
  const Py_buffer *view;
  targets_prefetch_State * a0;
  Table a1;
  Vector a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "s", true, 16, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "table", 'd', 2, false, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[2], law, "fired", 'd', 1, true, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS targets_prefetch_begin(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_prefetch_contact(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.prefetch:contact";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double a2;
  double a3;
  Vector a4;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_array(&held, args[4], law, "row", 'd', 1, false, &view)
        && (a4 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  result = targets_prefetch_contact(a0, a1, a2, a3, a4);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_targets_prefetch_expect(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.prefetch:expect";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  Table a2;
  Vector a3;
  Vector a4;
  targets_prefetch_Expected result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)
        && take_array(&held, args[2], law, "table", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[3], law, "visits", 'd', 1, false, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[4], law, "shares", 'd', 1, false, &view)
        && (a4 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = targets_prefetch_expect(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_targets_prefetch_Expected(result);
}
static PyObject *py_targets_prefetch_inside(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.prefetch:inside";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  Vector a2;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)
        && take_array(&held, args[2], law, "row", 'd', 1, false, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  result = targets_prefetch_inside(a0, a1, a2);
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_targets_prefetch_least_visit(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.prefetch:least_visit";
  Held held;
  const Py_buffer *view;
  double a0;
  targets_prefetch_Expected a1;
  targets_prefetch_Settings * a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_double(args[0], &a0)
        && take_tuple(args[1], law, "expected", 2)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.passed)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.sure)
        && take_memory(&held, args[2], law, "settings", false, 6, &view)
        && (a2 = view->buf, true)))
    return let_go(&held);
  result = targets_prefetch_least_visit(a0, a1, a2);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_targets_prefetch_log_odds(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.prefetch:log_odds";
  Held held;
  const Py_buffer *view;
  double a0;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_double(args[0], &a0)))
    return let_go(&held);
  result = targets_prefetch_log_odds(a0);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_targets_prefetch_score(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.prefetch:score";
  Held held;
  const Py_buffer *view;
  targets_cursor_State * a0;
  Vector a1;
  double a2;
  double a3;
  targets_prefetch_Expected a4;
  targets_prefetch_Settings * a5;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_memory(&held, args[0], law, "s", false, 15, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "row", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_tuple(args[4], law, "expected", 2)
        && take_double(PyTuple_GetItem(args[4], 0), &a4.passed)
        && take_double(PyTuple_GetItem(args[4], 1), &a4.sure)
        && take_memory(&held, args[5], law, "settings", false, 6, &view)
        && (a5 = view->buf, true)))
    return let_go(&held);
  result = targets_prefetch_score(a0, a1, a2, a3, a4, a5);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_targets_prefetch_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.prefetch:step";
  Held held;
  const Py_buffer *view;
  targets_prefetch_State * a0;
  T_Table_3_Vector_ a1;
  Vector a2;
  targets_prefetch_Settings * a3;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", true, 16, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "targets", 4)
        && take_array(&held, PyTuple_GetItem(args[1], 0), law, "targets", 'd', 2, true, &view)
        && (a1.f0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 1), law, "targets", 'd', 1, true, &view)
        && (a1.f1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 2), law, "targets", 'd', 1, true, &view)
        && (a1.f2 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 3), law, "targets", 'd', 1, true, &view)
        && (a1.f3 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "shares", 'd', 1, false, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)
        && take_memory(&held, args[3], law, "settings", false, 6, &view)
        && (a3 = view->buf, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = targets_prefetch_step(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_targets_prefetch_terms(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.prefetch:terms";
  Held held;
  const Py_buffer *view;
  targets_cursor_State * a0;
  Vector a1;
  double a2;
  double a3;
  targets_prefetch_Expected a4;
  T6d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "s", false, 15, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "row", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_tuple(args[4], law, "expected", 2)
        && take_double(PyTuple_GetItem(args[4], 0), &a4.passed)
        && take_double(PyTuple_GetItem(args[4], 1), &a4.sure)))
    return let_go(&held);
  result = targets_prefetch_terms(a0, a1, a2, a3, a4);
  let_go(&held);
  return give_T6d(result);
}
static PyObject *py_targets_prefetch_visit(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.prefetch:visit";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  Table a2;
  Vector a3;
  Vector a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)
        && take_array(&held, args[2], law, "table", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "table", a2.m, 2)
        && take_array(&held, args[3], law, "shares", 'd', 1, false, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[4], law, "out", 'd', 1, true, &view)
        && (a4 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS targets_prefetch_visit(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_rectangles_complete(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.rectangles:complete";
  Held held;
  const Py_buffer *view;
  Table a0;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_array(&held, args[0], law, "rows", 'd', 2, true, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a0.m, 5)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS targets_rectangles_complete(a0); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_targets_rectangles_holder(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.targets.rectangles:holder";
  Held held;
  const Py_buffer *view;
  Table a0;
  double a1;
  double a2;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "table", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "table", a0.m, 2)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = targets_rectangles_holder(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_training_calibration_fill_reaches(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.training.calibration:fill_reaches";
  Held held;
  const Py_buffer *view;
  double a0;
  Vector a1;
  Vector a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_double(args[0], &a0)
        && take_array(&held, args[1], law, "tail", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "far", 'd', 1, true, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  training_calibration_fill_reaches(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_transfer_assistance_add(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.transfer.assistance:add";
  Held held;
  const Py_buffer *view;
  transfer_assistance_Guard * a0;
  transfer_pixels_Carried * a1;
  double a2;
  T2d a3;
  T5d a4;
  T2d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "guard", false, 5, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "owed", true, 2, &view)
        && (a1 = view->buf, true)
        && take_double(args[2], &a2)
        && take_tuple(args[3], law, "own", 2)
        && take_double(PyTuple_GetItem(args[3], 0), &a3.f0)
        && take_double(PyTuple_GetItem(args[3], 1), &a3.f1)
        && take_tuple(args[4], law, "way", 5)
        && take_double(PyTuple_GetItem(args[4], 0), &a4.f0)
        && take_double(PyTuple_GetItem(args[4], 1), &a4.f1)
        && take_double(PyTuple_GetItem(args[4], 2), &a4.f2)
        && take_double(PyTuple_GetItem(args[4], 3), &a4.f3)
        && take_double(PyTuple_GetItem(args[4], 4), &a4.f4)))
    return let_go(&held);
  result = transfer_assistance_add(a0, a1, a2, a3, a4);
  let_go(&held);
  return give_T2d(result);
}
static PyObject *py_transfer_assistance_assisted_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.transfer.assistance:assisted_step";
  Held held;
  const Py_buffer *view;
  transfer_assistance_Assisted * a0;
  T5d a1;
  T3d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "memory", true, 19, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "report", 5)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)))
    return let_go(&held);
  result = transfer_assistance_assisted_step(a0, a1);
  let_go(&held);
  return give_T3d(result);
}
static PyObject *py_transfer_assistance_guarded_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.transfer.assistance:guarded_step";
  Held held;
  const Py_buffer *view;
  transfer_assistance_Guarded * a0;
  T8d a1;
  T5d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "memory", true, 24, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "report", 8)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)
        && take_double(PyTuple_GetItem(args[1], 6), &a1.f6)
        && take_double(PyTuple_GetItem(args[1], 7), &a1.f7)))
    return let_go(&held);
  result = transfer_assistance_guarded_step(a0, a1);
  let_go(&held);
  return give_T5d(result);
}
static PyObject *py_transfer_assistance_guide(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.transfer.assistance:guide";
  Held held;
  const Py_buffer *view;
  transfer_assistance_Guard * a0;
  double a1;
  T2d a2;
  T5d a3;
  T2d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "guard", false, 5, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_tuple(args[2], law, "own", 2)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_tuple(args[3], law, "way", 5)
        && take_double(PyTuple_GetItem(args[3], 0), &a3.f0)
        && take_double(PyTuple_GetItem(args[3], 1), &a3.f1)
        && take_double(PyTuple_GetItem(args[3], 2), &a3.f2)
        && take_double(PyTuple_GetItem(args[3], 3), &a3.f3)
        && take_double(PyTuple_GetItem(args[3], 4), &a3.f4)))
    return let_go(&held);
  result = transfer_assistance_guide(a0, a1, a2, a3);
  let_go(&held);
  return give_T2d(result);
}
static PyObject *py_transfer_assistance_guided_report_at(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.transfer.assistance:guided_report_at";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  T8d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "rows", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a0.m, 8)
        && take_int64_t(args[1], &a1)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = transfer_assistance_guided_report_at(a0, a1); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T8d(result);
}
static PyObject *py_transfer_assistance_offset_report_at(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.transfer.assistance:offset_report_at";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  T5d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "rows", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a0.m, 5)
        && take_int64_t(args[1], &a1)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = transfer_assistance_offset_report_at(a0, a1); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T5d(result);
}
static PyObject *py_transfer_assistance_pull(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.transfer.assistance:pull";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double a2;
  double a3;
  double a4;
  double a5;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)
        && take_double(args[5], &a5)))
    return let_go(&held);
  result = transfer_assistance_pull(a0, a1, a2, a3, a4, a5);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_transfer_assistance_spread(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.transfer.assistance:spread";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double a2;
  double a3;
  double a4;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  result = transfer_assistance_spread(a0, a1, a2, a3, a4);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_transfer_bands_learn(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.transfer.bands:learn";
  Held held;
  const Py_buffer *view;
  Vector a0;
  transfer_bands_Model a1;
  double a2;
  Vector a3;
  double a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[1], law, "model", 3)
        && take_int64_t(PyTuple_GetItem(args[1], 0), &a1.n)
        && take_int64_t(PyTuple_GetItem(args[1], 1), &a1.linear)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.forgetting)
        && take_double(args[2], &a2)
        && take_array(&held, args[3], law, "row", 'd', 1, false, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)
        && take_double(args[4], &a4)))
    return let_go(&held);
  transfer_bands_learn(a0, a1, a2, a3, a4);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_transfer_bands_states(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.transfer.bands:states";
  Held held;
  const Py_buffer *view;
  int64_t a0;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_int64_t(args[0], &a0)))
    return let_go(&held);
  result = transfer_bands_states(a0);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_transfer_functions_cursor_speed(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.transfer.functions:cursor_speed";
  Held held;
  const Py_buffer *view;
  transfer_functions_Function * a0;
  double a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "f", false, 8, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)))
    return let_go(&held);
  result = transfer_functions_cursor_speed(a0, a1);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_transfer_functions_evaluate(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.transfer.functions:evaluate";
  Held held;
  const Py_buffer *view;
  transfer_functions_Function * a0;
  Vector a1;
  bool a2;
  Vector a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "f", false, 8, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "speeds", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_bool(args[2], &a2)
        && take_array(&held, args[3], law, "out", 'd', 1, true, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  transfer_functions_evaluate(a0, a1, a2, a3);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_transfer_functions_gain(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.transfer.functions:gain";
  Held held;
  const Py_buffer *view;
  transfer_functions_Function * a0;
  double a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "f", false, 8, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)))
    return let_go(&held);
  result = transfer_functions_gain(a0, a1);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_transfer_identification_event_at(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.transfer.identification:event_at";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  T6d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "rows", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a0.m, 6)
        && take_int64_t(args[1], &a1)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = transfer_identification_event_at(a0, a1); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T6d(result);
}
static PyObject *py_transfer_identification_gather(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.transfer.identification:gather";
  Held held;
  const Py_buffer *view;
  transfer_identification_Settings * a0;
  transfer_identification_Window * a1;
  double a2;
  double a3;
  double a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "settings", false, 9, &view)
        && (a0 = view->buf, true)
        && take_memory(&held, args[1], law, "window", true, 18, &view)
        && (a1 = view->buf, true)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  transfer_identification_gather(a0, a1, a2, a3, a4);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_transfer_identification_learn(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.transfer.identification:learn";
  Held held;
  const Py_buffer *view;
  transfer_identification_Memory * a0;
  Vector a1;
  double a2;
  double a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "memory", true, 267, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "row", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  transfer_identification_learn(a0, a1, a2, a3);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_transfer_identification_learn_speeds(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.transfer.identification:learn_speeds";
  Held held;
  const Py_buffer *view;
  transfer_identification_Memory * a0;
  double a1;
  double a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "memory", true, 267, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  transfer_identification_learn_speeds(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_transfer_identification_open_window(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.transfer.identification:open_window";
  Held held;
  const Py_buffer *view;
  transfer_identification_State * a0;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "s", true, 24, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  transfer_identification_open_window(a0);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_transfer_identification_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.transfer.identification:step";
  Held held;
  const Py_buffer *view;
  transfer_identification_Memory * a0;
  T6d a1;
  Td result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "memory", true, 267, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "event", 6)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.f3)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.f4)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.f5)))
    return let_go(&held);
  result = transfer_identification_step(a0, a1);
  let_go(&held);
  return give_Td(result);
}
static PyObject *py_transfer_pixels_accept(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.transfer.pixels:accept";
  Held held;
  const Py_buffer *view;
  transfer_pixels_Memory * a0;
  double a1;
  double a2;
  double a3;
  Tbd result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "memory", false, 17, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  result = transfer_pixels_accept(a0, a1, a2, a3);
  let_go(&held);
  return give_Tbd(result);
}
static PyObject *py_transfer_pixels_carry(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.transfer.pixels:carry";
  Held held;
  const Py_buffer *view;
  transfer_pixels_Carried * a0;
  int64_t a1;
  double a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "carried", true, 2, &view)
        && (a0 = view->buf, true)
        && take_int64_t(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = transfer_pixels_carry(a0, a1, a2);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_transfer_pixels_lay_out(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.transfer.pixels:lay_out";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  T4d a2;
  transfer_functions_Function * a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_array(&held, args[0], law, "memory", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "own", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "device", 4)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.f2)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.f3)
        && take_memory(&held, args[3], law, "function", false, 8, &view)
        && (a3 = view->buf, true)))
    return let_go(&held);
  transfer_pixels_lay_out(a0, a1, a2, a3);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_transfer_pixels_report_at(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.transfer.pixels:report_at";
  Held held;
  const Py_buffer *view;
  Table a0;
  int64_t a1;
  T3d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "rows", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "rows", a0.m, 3)
        && take_int64_t(args[1], &a1)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = transfer_pixels_report_at(a0, a1); Py_END_ALLOW_THREADS
  let_go(&held);
  return give_T3d(result);
}
static PyObject *py_transfer_pixels_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.transfer.pixels:step";
  Held held;
  const Py_buffer *view;
  transfer_pixels_Memory * a0;
  T3d a1;
  T3d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "memory", true, 17, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "report", 3)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)))
    return let_go(&held);
  result = transfer_pixels_step(a0, a1);
  let_go(&held);
  return give_T3d(result);
}
static PyObject *py_transfer_pixels_turn(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.transfer.pixels:turn";
  Held held;
  const Py_buffer *view;
  transfer_pixels_Memory * a0;
  double a1;
  double a2;
  double a3;
  double a4;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "memory", true, 17, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  result = transfer_pixels_turn(a0, a1, a2, a3, a4);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyMethodDef methods[] = {
  {"pointpred.differentiators.difference:advance", (PyCFunction)(void (*)(void))py_differentiators_difference_advance, METH_FASTCALL, NULL},
  {"pointpred.differentiators.difference:step", (PyCFunction)(void (*)(void))py_differentiators_difference_step, METH_FASTCALL, NULL},
  {"pointpred.differentiators.homogeneous:advance", (PyCFunction)(void (*)(void))py_differentiators_homogeneous_advance, METH_FASTCALL, NULL},
  {"pointpred.differentiators.homogeneous:chatter", (PyCFunction)(void (*)(void))py_differentiators_homogeneous_chatter, METH_FASTCALL, NULL},
  {"pointpred.differentiators.homogeneous:fill", (PyCFunction)(void (*)(void))py_differentiators_homogeneous_fill, METH_FASTCALL, NULL},
  {"pointpred.differentiators.homogeneous:place_poles", (PyCFunction)(void (*)(void))py_differentiators_homogeneous_place_poles, METH_FASTCALL, NULL},
  {"pointpred.differentiators.homogeneous:settle", (PyCFunction)(void (*)(void))py_differentiators_homogeneous_settle, METH_FASTCALL, NULL},
  {"pointpred.differentiators.homogeneous:settling", (PyCFunction)(void (*)(void))py_differentiators_homogeneous_settling, METH_FASTCALL, NULL},
  {"pointpred.differentiators.homogeneous:step", (PyCFunction)(void (*)(void))py_differentiators_homogeneous_step, METH_FASTCALL, NULL},
  {"pointpred.differentiators.kalman:correct", (PyCFunction)(void (*)(void))py_differentiators_kalman_correct, METH_FASTCALL, NULL},
  {"pointpred.differentiators.kalman:fill", (PyCFunction)(void (*)(void))py_differentiators_kalman_fill, METH_FASTCALL, NULL},
  {"pointpred.differentiators.kalman:follow", (PyCFunction)(void (*)(void))py_differentiators_kalman_follow, METH_FASTCALL, NULL},
  {"pointpred.differentiators.kalman:narrow", (PyCFunction)(void (*)(void))py_differentiators_kalman_narrow, METH_FASTCALL, NULL},
  {"pointpred.differentiators.kalman:predict", (PyCFunction)(void (*)(void))py_differentiators_kalman_predict, METH_FASTCALL, NULL},
  {"pointpred.differentiators.kalman:restart", (PyCFunction)(void (*)(void))py_differentiators_kalman_restart, METH_FASTCALL, NULL},
  {"pointpred.differentiators.kalman:settle_s", (PyCFunction)(void (*)(void))py_differentiators_kalman_settle_s, METH_FASTCALL, NULL},
  {"pointpred.differentiators.kalman:spread", (PyCFunction)(void (*)(void))py_differentiators_kalman_spread, METH_FASTCALL, NULL},
  {"pointpred.differentiators.kalman:step", (PyCFunction)(void (*)(void))py_differentiators_kalman_step, METH_FASTCALL, NULL},
  {"pointpred.differentiators.sampling:accept", (PyCFunction)(void (*)(void))py_differentiators_sampling_accept, METH_FASTCALL, NULL},
  {"pointpred.differentiators.sampling:fill", (PyCFunction)(void (*)(void))py_differentiators_sampling_fill, METH_FASTCALL, NULL},
  {"pointpred.differentiators.sampling:motion", (PyCFunction)(void (*)(void))py_differentiators_sampling_motion, METH_FASTCALL, NULL},
  {"pointpred.differentiators.sampling:settled", (PyCFunction)(void (*)(void))py_differentiators_sampling_settled, METH_FASTCALL, NULL},
  {"pointpred.pipeline:_following (pointpred.predictors.adaptation.predictor:step)", (PyCFunction)(void (*)(void))py_follow__predictors_adaptation_predictor_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:_following (pointpred.predictors.delphian:step)", (PyCFunction)(void (*)(void))py_follow__predictors_delphian_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:_following (pointpred.predictors.hold:step)", (PyCFunction)(void (*)(void))py_follow__predictors_hold_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:_following (pointpred.predictors.kalman:step)", (PyCFunction)(void (*)(void))py_follow__predictors_kalman_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:_following (pointpred.predictors.kep:step)", (PyCFunction)(void (*)(void))py_follow__predictors_kep_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:_following (pointpred.predictors.ktm:step)", (PyCFunction)(void (*)(void))py_follow__predictors_ktm_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:_following (pointpred.predictors.linear:step)", (PyCFunction)(void (*)(void))py_follow__predictors_linear_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:_following (pointpred.predictors.minimum_jerk:step)", (PyCFunction)(void (*)(void))py_follow__predictors_minimum_jerk_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:_following (pointpred.predictors.switched_direction:step)", (PyCFunction)(void (*)(void))py_follow__predictors_switched_direction_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:_following (pointpred.predictors.switched:step)", (PyCFunction)(void (*)(void))py_follow__predictors_switched_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.difference:step) (pointpred.predictors.adaptation.predictor:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_difference_step__predictors_adaptation_predictor_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.difference:step) (pointpred.predictors.delphian:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_difference_step__predictors_delphian_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.difference:step) (pointpred.predictors.hold:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_difference_step__predictors_hold_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.difference:step) (pointpred.predictors.kalman:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_difference_step__predictors_kalman_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.difference:step) (pointpred.predictors.kep:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_difference_step__predictors_kep_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.difference:step) (pointpred.predictors.kinematic.predictor:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_difference_step__predictors_kinematic_predictor_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.difference:step) (pointpred.predictors.ktm:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_difference_step__predictors_ktm_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.difference:step) (pointpred.predictors.linear:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_difference_step__predictors_linear_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.difference:step) (pointpred.predictors.minimum_jerk:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_difference_step__predictors_minimum_jerk_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.difference:step) (pointpred.predictors.switched_direction:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_difference_step__predictors_switched_direction_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.difference:step) (pointpred.predictors.switched:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_difference_step__predictors_switched_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.homogeneous:step) (pointpred.predictors.adaptation.predictor:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_homogeneous_step__predictors_adaptation_predictor_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.homogeneous:step) (pointpred.predictors.delphian:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_homogeneous_step__predictors_delphian_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.homogeneous:step) (pointpred.predictors.hold:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_homogeneous_step__predictors_hold_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.homogeneous:step) (pointpred.predictors.kalman:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_homogeneous_step__predictors_kalman_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.homogeneous:step) (pointpred.predictors.kep:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_homogeneous_step__predictors_kep_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.homogeneous:step) (pointpred.predictors.kinematic.predictor:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_homogeneous_step__predictors_kinematic_predictor_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.homogeneous:step) (pointpred.predictors.ktm:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_homogeneous_step__predictors_ktm_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.homogeneous:step) (pointpred.predictors.linear:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_homogeneous_step__predictors_linear_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.homogeneous:step) (pointpred.predictors.minimum_jerk:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_homogeneous_step__predictors_minimum_jerk_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.homogeneous:step) (pointpred.predictors.switched_direction:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_homogeneous_step__predictors_switched_direction_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.homogeneous:step) (pointpred.predictors.switched:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_homogeneous_step__predictors_switched_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.kalman:step) (pointpred.predictors.adaptation.predictor:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_kalman_step__predictors_adaptation_predictor_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.kalman:step) (pointpred.predictors.delphian:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_kalman_step__predictors_delphian_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.kalman:step) (pointpred.predictors.hold:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_kalman_step__predictors_hold_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.kalman:step) (pointpred.predictors.kalman:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_kalman_step__predictors_kalman_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.kalman:step) (pointpred.predictors.kep:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_kalman_step__predictors_kep_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.kalman:step) (pointpred.predictors.kinematic.predictor:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_kalman_step__predictors_kinematic_predictor_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.kalman:step) (pointpred.predictors.ktm:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_kalman_step__predictors_ktm_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.kalman:step) (pointpred.predictors.linear:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_kalman_step__predictors_linear_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.kalman:step) (pointpred.predictors.minimum_jerk:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_kalman_step__predictors_minimum_jerk_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.kalman:step) (pointpred.predictors.switched_direction:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_kalman_step__predictors_switched_direction_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:joint_of (pointpred.differentiators.kalman:step) (pointpred.predictors.switched:step)", (PyCFunction)(void (*)(void))py_joint__differentiators_kalman_step__predictors_switched_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.difference:step) (pointpred.pipeline:_following (pointpred.predictors.adaptation.predictor:step)) (pointpred.predictors.adaptation.predictor:step)", (PyCFunction)(void (*)(void))py_last__differentiators_difference_step__follow__predictors_adaptation_predictor_step__predictors_adaptation_predictor_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.difference:step) (pointpred.pipeline:_following (pointpred.predictors.delphian:step)) (pointpred.predictors.delphian:step)", (PyCFunction)(void (*)(void))py_last__differentiators_difference_step__follow__predictors_delphian_step__predictors_delphian_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.difference:step) (pointpred.pipeline:_following (pointpred.predictors.hold:step)) (pointpred.predictors.hold:step)", (PyCFunction)(void (*)(void))py_last__differentiators_difference_step__follow__predictors_hold_step__predictors_hold_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.difference:step) (pointpred.pipeline:_following (pointpred.predictors.kalman:step)) (pointpred.predictors.kalman:step)", (PyCFunction)(void (*)(void))py_last__differentiators_difference_step__follow__predictors_kalman_step__predictors_kalman_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.difference:step) (pointpred.pipeline:_following (pointpred.predictors.kep:step)) (pointpred.predictors.kep:step)", (PyCFunction)(void (*)(void))py_last__differentiators_difference_step__follow__predictors_kep_step__predictors_kep_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.difference:step) (pointpred.pipeline:_following (pointpred.predictors.ktm:step)) (pointpred.predictors.ktm:step)", (PyCFunction)(void (*)(void))py_last__differentiators_difference_step__follow__predictors_ktm_step__predictors_ktm_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.difference:step) (pointpred.pipeline:_following (pointpred.predictors.linear:step)) (pointpred.predictors.linear:step)", (PyCFunction)(void (*)(void))py_last__differentiators_difference_step__follow__predictors_linear_step__predictors_linear_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.difference:step) (pointpred.pipeline:_following (pointpred.predictors.minimum_jerk:step)) (pointpred.predictors.minimum_jerk:step)", (PyCFunction)(void (*)(void))py_last__differentiators_difference_step__follow__predictors_minimum_jerk_step__predictors_minimum_jerk_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.difference:step) (pointpred.pipeline:_following (pointpred.predictors.switched_direction:step)) (pointpred.predictors.switched_direction:step)", (PyCFunction)(void (*)(void))py_last__differentiators_difference_step__follow__predictors_switched_direction_step__predictors_switched_direction_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.difference:step) (pointpred.pipeline:_following (pointpred.predictors.switched:step)) (pointpred.predictors.switched:step)", (PyCFunction)(void (*)(void))py_last__differentiators_difference_step__follow__predictors_switched_step__predictors_switched_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.difference:step) (pointpred.predictors.kinematic.predictor:follow) (pointpred.predictors.kinematic.predictor:step)", (PyCFunction)(void (*)(void))py_last__differentiators_difference_step__predictors_kinematic_predictor_follow__predictors_kinematic_predictor_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.homogeneous:step) (pointpred.pipeline:_following (pointpred.predictors.adaptation.predictor:step)) (pointpred.predictors.adaptation.predictor:step)", (PyCFunction)(void (*)(void))py_last__differentiators_homogeneous_step__follow__predictors_adaptation_predictor_step__predictors_adaptation_predictor_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.homogeneous:step) (pointpred.pipeline:_following (pointpred.predictors.delphian:step)) (pointpred.predictors.delphian:step)", (PyCFunction)(void (*)(void))py_last__differentiators_homogeneous_step__follow__predictors_delphian_step__predictors_delphian_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.homogeneous:step) (pointpred.pipeline:_following (pointpred.predictors.hold:step)) (pointpred.predictors.hold:step)", (PyCFunction)(void (*)(void))py_last__differentiators_homogeneous_step__follow__predictors_hold_step__predictors_hold_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.homogeneous:step) (pointpred.pipeline:_following (pointpred.predictors.kalman:step)) (pointpred.predictors.kalman:step)", (PyCFunction)(void (*)(void))py_last__differentiators_homogeneous_step__follow__predictors_kalman_step__predictors_kalman_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.homogeneous:step) (pointpred.pipeline:_following (pointpred.predictors.kep:step)) (pointpred.predictors.kep:step)", (PyCFunction)(void (*)(void))py_last__differentiators_homogeneous_step__follow__predictors_kep_step__predictors_kep_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.homogeneous:step) (pointpred.pipeline:_following (pointpred.predictors.ktm:step)) (pointpred.predictors.ktm:step)", (PyCFunction)(void (*)(void))py_last__differentiators_homogeneous_step__follow__predictors_ktm_step__predictors_ktm_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.homogeneous:step) (pointpred.pipeline:_following (pointpred.predictors.linear:step)) (pointpred.predictors.linear:step)", (PyCFunction)(void (*)(void))py_last__differentiators_homogeneous_step__follow__predictors_linear_step__predictors_linear_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.homogeneous:step) (pointpred.pipeline:_following (pointpred.predictors.minimum_jerk:step)) (pointpred.predictors.minimum_jerk:step)", (PyCFunction)(void (*)(void))py_last__differentiators_homogeneous_step__follow__predictors_minimum_jerk_step__predictors_minimum_jerk_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.homogeneous:step) (pointpred.pipeline:_following (pointpred.predictors.switched_direction:step)) (pointpred.predictors.switched_direction:step)", (PyCFunction)(void (*)(void))py_last__differentiators_homogeneous_step__follow__predictors_switched_direction_step__predictors_switched_direction_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.homogeneous:step) (pointpred.pipeline:_following (pointpred.predictors.switched:step)) (pointpred.predictors.switched:step)", (PyCFunction)(void (*)(void))py_last__differentiators_homogeneous_step__follow__predictors_switched_step__predictors_switched_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.homogeneous:step) (pointpred.predictors.kinematic.predictor:follow) (pointpred.predictors.kinematic.predictor:step)", (PyCFunction)(void (*)(void))py_last__differentiators_homogeneous_step__predictors_kinematic_predictor_follow__predictors_kinematic_predictor_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.kalman:step) (pointpred.pipeline:_following (pointpred.predictors.adaptation.predictor:step)) (pointpred.predictors.adaptation.predictor:step)", (PyCFunction)(void (*)(void))py_last__differentiators_kalman_step__follow__predictors_adaptation_predictor_step__predictors_adaptation_predictor_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.kalman:step) (pointpred.pipeline:_following (pointpred.predictors.delphian:step)) (pointpred.predictors.delphian:step)", (PyCFunction)(void (*)(void))py_last__differentiators_kalman_step__follow__predictors_delphian_step__predictors_delphian_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.kalman:step) (pointpred.pipeline:_following (pointpred.predictors.hold:step)) (pointpred.predictors.hold:step)", (PyCFunction)(void (*)(void))py_last__differentiators_kalman_step__follow__predictors_hold_step__predictors_hold_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.kalman:step) (pointpred.pipeline:_following (pointpred.predictors.kalman:step)) (pointpred.predictors.kalman:step)", (PyCFunction)(void (*)(void))py_last__differentiators_kalman_step__follow__predictors_kalman_step__predictors_kalman_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.kalman:step) (pointpred.pipeline:_following (pointpred.predictors.kep:step)) (pointpred.predictors.kep:step)", (PyCFunction)(void (*)(void))py_last__differentiators_kalman_step__follow__predictors_kep_step__predictors_kep_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.kalman:step) (pointpred.pipeline:_following (pointpred.predictors.ktm:step)) (pointpred.predictors.ktm:step)", (PyCFunction)(void (*)(void))py_last__differentiators_kalman_step__follow__predictors_ktm_step__predictors_ktm_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.kalman:step) (pointpred.pipeline:_following (pointpred.predictors.linear:step)) (pointpred.predictors.linear:step)", (PyCFunction)(void (*)(void))py_last__differentiators_kalman_step__follow__predictors_linear_step__predictors_linear_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.kalman:step) (pointpred.pipeline:_following (pointpred.predictors.minimum_jerk:step)) (pointpred.predictors.minimum_jerk:step)", (PyCFunction)(void (*)(void))py_last__differentiators_kalman_step__follow__predictors_minimum_jerk_step__predictors_minimum_jerk_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.kalman:step) (pointpred.pipeline:_following (pointpred.predictors.switched_direction:step)) (pointpred.predictors.switched_direction:step)", (PyCFunction)(void (*)(void))py_last__differentiators_kalman_step__follow__predictors_switched_direction_step__predictors_switched_direction_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.kalman:step) (pointpred.pipeline:_following (pointpred.predictors.switched:step)) (pointpred.predictors.switched:step)", (PyCFunction)(void (*)(void))py_last__differentiators_kalman_step__follow__predictors_switched_step__predictors_switched_step, METH_FASTCALL, NULL},
  {"pointpred.pipeline:last_of (pointpred.differentiators.kalman:step) (pointpred.predictors.kinematic.predictor:follow) (pointpred.predictors.kinematic.predictor:step)", (PyCFunction)(void (*)(void))py_last__differentiators_kalman_step__predictors_kinematic_predictor_follow__predictors_kinematic_predictor_step, METH_FASTCALL, NULL},
  {"pointpred.stage:loop_of (pointpred.predictors.adaptation.predictor:conclude) (pointpred.records:row_at) (pointpred.predictors.adaptation.predictor:step)", (PyCFunction)(void (*)(void))py_loop__predictors_adaptation_predictor_conclude__records_row_at__predictors_adaptation_predictor_step, METH_FASTCALL, NULL},
  {"pointpred.stage:loop_of (pointpred.predictors.ktm:conclude) (pointpred.records:row_at) (pointpred.predictors.ktm:step)", (PyCFunction)(void (*)(void))py_loop__predictors_ktm_conclude__records_row_at__predictors_ktm_step, METH_FASTCALL, NULL},
  {"pointpred.stage:loop_of (pointpred.stage:learn_nothing) (pointpred.records:event_at) (pointpred.differentiators.difference:step)", (PyCFunction)(void (*)(void))py_loop__stage_learn_nothing__records_event_at__differentiators_difference_step, METH_FASTCALL, NULL},
  {"pointpred.stage:loop_of (pointpred.stage:learn_nothing) (pointpred.records:event_at) (pointpred.differentiators.homogeneous:step)", (PyCFunction)(void (*)(void))py_loop__stage_learn_nothing__records_event_at__differentiators_homogeneous_step, METH_FASTCALL, NULL},
  {"pointpred.stage:loop_of (pointpred.stage:learn_nothing) (pointpred.records:event_at) (pointpred.differentiators.kalman:step)", (PyCFunction)(void (*)(void))py_loop__stage_learn_nothing__records_event_at__differentiators_kalman_step, METH_FASTCALL, NULL},
  {"pointpred.stage:loop_of (pointpred.stage:learn_nothing) (pointpred.records:row_at) (pointpred.predictors.delphian:step)", (PyCFunction)(void (*)(void))py_loop__stage_learn_nothing__records_row_at__predictors_delphian_step, METH_FASTCALL, NULL},
  {"pointpred.stage:loop_of (pointpred.stage:learn_nothing) (pointpred.records:row_at) (pointpred.predictors.hold:step)", (PyCFunction)(void (*)(void))py_loop__stage_learn_nothing__records_row_at__predictors_hold_step, METH_FASTCALL, NULL},
  {"pointpred.stage:loop_of (pointpred.stage:learn_nothing) (pointpred.records:row_at) (pointpred.predictors.kalman:step)", (PyCFunction)(void (*)(void))py_loop__stage_learn_nothing__records_row_at__predictors_kalman_step, METH_FASTCALL, NULL},
  {"pointpred.stage:loop_of (pointpred.stage:learn_nothing) (pointpred.records:row_at) (pointpred.predictors.kep:step)", (PyCFunction)(void (*)(void))py_loop__stage_learn_nothing__records_row_at__predictors_kep_step, METH_FASTCALL, NULL},
  {"pointpred.stage:loop_of (pointpred.stage:learn_nothing) (pointpred.records:row_at) (pointpred.predictors.kinematic.predictor:step)", (PyCFunction)(void (*)(void))py_loop__stage_learn_nothing__records_row_at__predictors_kinematic_predictor_step, METH_FASTCALL, NULL},
  {"pointpred.stage:loop_of (pointpred.stage:learn_nothing) (pointpred.records:row_at) (pointpred.predictors.linear:step)", (PyCFunction)(void (*)(void))py_loop__stage_learn_nothing__records_row_at__predictors_linear_step, METH_FASTCALL, NULL},
  {"pointpred.stage:loop_of (pointpred.stage:learn_nothing) (pointpred.records:row_at) (pointpred.predictors.minimum_jerk:step)", (PyCFunction)(void (*)(void))py_loop__stage_learn_nothing__records_row_at__predictors_minimum_jerk_step, METH_FASTCALL, NULL},
  {"pointpred.stage:loop_of (pointpred.stage:learn_nothing) (pointpred.records:row_at) (pointpred.predictors.switched_direction:step)", (PyCFunction)(void (*)(void))py_loop__stage_learn_nothing__records_row_at__predictors_switched_direction_step, METH_FASTCALL, NULL},
  {"pointpred.stage:loop_of (pointpred.stage:learn_nothing) (pointpred.records:row_at) (pointpred.predictors.switched:step)", (PyCFunction)(void (*)(void))py_loop__stage_learn_nothing__records_row_at__predictors_switched_step, METH_FASTCALL, NULL},
  {"pointpred.stage:loop_of (pointpred.stage:learn_nothing) (pointpred.transfer.assistance:guided_report_at) (pointpred.transfer.assistance:guarded_step)", (PyCFunction)(void (*)(void))py_loop__stage_learn_nothing__transfer_assistance_guided_report_at__transfer_assistance_guarded_step, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.arrival_intervals:judge", (PyCFunction)(void (*)(void))py_predictors_adaptation_arrival_intervals_judge, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.arrival_intervals:next_step", (PyCFunction)(void (*)(void))py_predictors_adaptation_arrival_intervals_next_step, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.arrival_intervals:spread", (PyCFunction)(void (*)(void))py_predictors_adaptation_arrival_intervals_spread, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.correction:adapt", (PyCFunction)(void (*)(void))py_predictors_adaptation_correction_adapt, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.correction:adapted_end", (PyCFunction)(void (*)(void))py_predictors_adaptation_correction_adapted_end, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.correction:ahead_of", (PyCFunction)(void (*)(void))py_predictors_adaptation_correction_ahead_of, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.correction:arrival", (PyCFunction)(void (*)(void))py_predictors_adaptation_correction_arrival, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.correction:by_distances", (PyCFunction)(void (*)(void))py_predictors_adaptation_correction_by_distances, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.correction:by_places", (PyCFunction)(void (*)(void))py_predictors_adaptation_correction_by_places, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.correction:conclude", (PyCFunction)(void (*)(void))py_predictors_adaptation_correction_conclude, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.correction:fading", (PyCFunction)(void (*)(void))py_predictors_adaptation_correction_fading, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.correction:fault", (PyCFunction)(void (*)(void))py_predictors_adaptation_correction_fault, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.correction:follow", (PyCFunction)(void (*)(void))py_predictors_adaptation_correction_follow, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.correction:heading_of", (PyCFunction)(void (*)(void))py_predictors_adaptation_correction_heading_of, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.correction:learn", (PyCFunction)(void (*)(void))py_predictors_adaptation_correction_learn, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.correction:learn_place", (PyCFunction)(void (*)(void))py_predictors_adaptation_correction_learn_place, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.correction:prepare", (PyCFunction)(void (*)(void))py_predictors_adaptation_correction_prepare, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.correction:stage_begun", (PyCFunction)(void (*)(void))py_predictors_adaptation_correction_stage_begun, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.correction:state", (PyCFunction)(void (*)(void))py_predictors_adaptation_correction_state, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.correction:with_centre_ahead", (PyCFunction)(void (*)(void))py_predictors_adaptation_correction_with_centre_ahead, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.correction:write_mixture", (PyCFunction)(void (*)(void))py_predictors_adaptation_correction_write_mixture, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.destination:candidates", (PyCFunction)(void (*)(void))py_predictors_adaptation_destination_candidates, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.destination:combine", (PyCFunction)(void (*)(void))py_predictors_adaptation_destination_combine, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.destination:favour_near", (PyCFunction)(void (*)(void))py_predictors_adaptation_destination_favour_near, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.destination:geometric_median", (PyCFunction)(void (*)(void))py_predictors_adaptation_destination_geometric_median, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.destination:likelihood", (PyCFunction)(void (*)(void))py_predictors_adaptation_destination_likelihood, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.destination:prepare", (PyCFunction)(void (*)(void))py_predictors_adaptation_destination_prepare, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.destination:scaled", (PyCFunction)(void (*)(void))py_predictors_adaptation_destination_scaled, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.destination:shift_law", (PyCFunction)(void (*)(void))py_predictors_adaptation_destination_shift_law, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.destination:spread_of", (PyCFunction)(void (*)(void))py_predictors_adaptation_destination_spread_of, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.destination:weigh", (PyCFunction)(void (*)(void))py_predictors_adaptation_destination_weigh, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.distances:age_weight", (PyCFunction)(void (*)(void))py_predictors_adaptation_distances_age_weight, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.distances:combine", (PyCFunction)(void (*)(void))py_predictors_adaptation_distances_combine, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.distances:fault", (PyCFunction)(void (*)(void))py_predictors_adaptation_distances_fault, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.distances:judge", (PyCFunction)(void (*)(void))py_predictors_adaptation_distances_judge, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.distances:likelihood", (PyCFunction)(void (*)(void))py_predictors_adaptation_distances_likelihood, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.distances:remember", (PyCFunction)(void (*)(void))py_predictors_adaptation_distances_remember, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.durations:fault", (PyCFunction)(void (*)(void))py_predictors_adaptation_durations_fault, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.durations:forget", (PyCFunction)(void (*)(void))py_predictors_adaptation_durations_forget, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.durations:judge", (PyCFunction)(void (*)(void))py_predictors_adaptation_durations_judge, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.durations:median", (PyCFunction)(void (*)(void))py_predictors_adaptation_durations_median, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.durations:mix", (PyCFunction)(void (*)(void))py_predictors_adaptation_durations_mix, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.durations:mixture", (PyCFunction)(void (*)(void))py_predictors_adaptation_durations_mixture, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.durations:remember", (PyCFunction)(void (*)(void))py_predictors_adaptation_durations_remember, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.durations:value_of_rank", (PyCFunction)(void (*)(void))py_predictors_adaptation_durations_value_of_rank, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.habits:blend", (PyCFunction)(void (*)(void))py_predictors_adaptation_habits_blend, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.habits:count_following", (PyCFunction)(void (*)(void))py_predictors_adaptation_habits_count_following, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.habits:count_last", (PyCFunction)(void (*)(void))py_predictors_adaptation_habits_count_last, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.habits:count_often", (PyCFunction)(void (*)(void))py_predictors_adaptation_habits_count_often, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.habits:density_ratio", (PyCFunction)(void (*)(void))py_predictors_adaptation_habits_density_ratio, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.habits:learn", (PyCFunction)(void (*)(void))py_predictors_adaptation_habits_learn, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.habits:returns", (PyCFunction)(void (*)(void))py_predictors_adaptation_habits_returns, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.habits:rule_weight", (PyCFunction)(void (*)(void))py_predictors_adaptation_habits_rule_weight, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.habits:share_visit", (PyCFunction)(void (*)(void))py_predictors_adaptation_habits_share_visit, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.habits:shares", (PyCFunction)(void (*)(void))py_predictors_adaptation_habits_shares, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.habits:usual_width", (PyCFunction)(void (*)(void))py_predictors_adaptation_habits_usual_width, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.habits:width_weight", (PyCFunction)(void (*)(void))py_predictors_adaptation_habits_width_weight, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.levels:learn", (PyCFunction)(void (*)(void))py_predictors_adaptation_levels_learn, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.levels:offset", (PyCFunction)(void (*)(void))py_predictors_adaptation_levels_offset, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.levels:step_after", (PyCFunction)(void (*)(void))py_predictors_adaptation_levels_step_after, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.mixed_region:claim", (PyCFunction)(void (*)(void))py_predictors_adaptation_mixed_region_claim, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.mixed_region:judge", (PyCFunction)(void (*)(void))py_predictors_adaptation_mixed_region_judge, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.mixed_region:likeliest", (PyCFunction)(void (*)(void))py_predictors_adaptation_mixed_region_likeliest, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.mixed_region:write", (PyCFunction)(void (*)(void))py_predictors_adaptation_mixed_region_write, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.mixed_region:write_part", (PyCFunction)(void (*)(void))py_predictors_adaptation_mixed_region_write_part, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.moments:has_come", (PyCFunction)(void (*)(void))py_predictors_adaptation_moments_has_come, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.moments:next_moment", (PyCFunction)(void (*)(void))py_predictors_adaptation_moments_next_moment, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.places:fault", (PyCFunction)(void (*)(void))py_predictors_adaptation_places_fault, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.places:nearest", (PyCFunction)(void (*)(void))py_predictors_adaptation_places_nearest, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.places:new_place", (PyCFunction)(void (*)(void))py_predictors_adaptation_places_new_place, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.places:visit", (PyCFunction)(void (*)(void))py_predictors_adaptation_places_visit, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.places:visited", (PyCFunction)(void (*)(void))py_predictors_adaptation_places_visited, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.predictor:conclude", (PyCFunction)(void (*)(void))py_predictors_adaptation_predictor_conclude, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.predictor:enter_scene", (PyCFunction)(void (*)(void))py_predictors_adaptation_predictor_enter_scene, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.predictor:last_end", (PyCFunction)(void (*)(void))py_predictors_adaptation_predictor_last_end, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.predictor:list_parts", (PyCFunction)(void (*)(void))py_predictors_adaptation_predictor_list_parts, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.predictor:list_places", (PyCFunction)(void (*)(void))py_predictors_adaptation_predictor_list_places, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.predictor:pace_of", (PyCFunction)(void (*)(void))py_predictors_adaptation_predictor_pace_of, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.predictor:sizes", (PyCFunction)(void (*)(void))py_predictors_adaptation_predictor_sizes, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.predictor:step", (PyCFunction)(void (*)(void))py_predictors_adaptation_predictor_step, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.predictor:write_mixture", (PyCFunction)(void (*)(void))py_predictors_adaptation_predictor_write_mixture, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.region_widening:learn", (PyCFunction)(void (*)(void))py_predictors_adaptation_region_widening_learn, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.region_widening:probability_within", (PyCFunction)(void (*)(void))py_predictors_adaptation_region_widening_probability_within, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.region_widening:record", (PyCFunction)(void (*)(void))py_predictors_adaptation_region_widening_record, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.region_widening:widen", (PyCFunction)(void (*)(void))py_predictors_adaptation_region_widening_widen, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.stages:belief", (PyCFunction)(void (*)(void))py_predictors_adaptation_stages_belief, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.stages:bias", (PyCFunction)(void (*)(void))py_predictors_adaptation_stages_bias, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.stages:bounded", (PyCFunction)(void (*)(void))py_predictors_adaptation_stages_bounded, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.stages:correct", (PyCFunction)(void (*)(void))py_predictors_adaptation_stages_correct, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.stages:forget", (PyCFunction)(void (*)(void))py_predictors_adaptation_stages_forget, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.stages:interpolation", (PyCFunction)(void (*)(void))py_predictors_adaptation_stages_interpolation, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.stages:interpolation_among", (PyCFunction)(void (*)(void))py_predictors_adaptation_stages_interpolation_among, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.stages:learn", (PyCFunction)(void (*)(void))py_predictors_adaptation_stages_learn, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.stages:scale", (PyCFunction)(void (*)(void))py_predictors_adaptation_stages_scale, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.stages:solve", (PyCFunction)(void (*)(void))py_predictors_adaptation_stages_solve, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.stages:tempo", (PyCFunction)(void (*)(void))py_predictors_adaptation_stages_tempo, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.stages:tempo_factor", (PyCFunction)(void (*)(void))py_predictors_adaptation_stages_tempo_factor, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.stages:width_log", (PyCFunction)(void (*)(void))py_predictors_adaptation_stages_width_log, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.time_left:factor", (PyCFunction)(void (*)(void))py_predictors_adaptation_time_left_factor, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.time_left:fault", (PyCFunction)(void (*)(void))py_predictors_adaptation_time_left_fault, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.time_left:learn", (PyCFunction)(void (*)(void))py_predictors_adaptation_time_left_learn, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.time_left:moment_at", (PyCFunction)(void (*)(void))py_predictors_adaptation_time_left_moment_at, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.time_left:solve", (PyCFunction)(void (*)(void))py_predictors_adaptation_time_left_solve, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.time_left:stated", (PyCFunction)(void (*)(void))py_predictors_adaptation_time_left_stated, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.time_left:terms", (PyCFunction)(void (*)(void))py_predictors_adaptation_time_left_terms, METH_FASTCALL, NULL},
  {"pointpred.predictors.adaptation.time_left:weighed", (PyCFunction)(void (*)(void))py_predictors_adaptation_time_left_weighed, METH_FASTCALL, NULL},
  {"pointpred.predictors.delphian:step", (PyCFunction)(void (*)(void))py_predictors_delphian_step, METH_FASTCALL, NULL},
  {"pointpred.predictors.hold:step", (PyCFunction)(void (*)(void))py_predictors_hold_step, METH_FASTCALL, NULL},
  {"pointpred.predictors.kalman:corrected", (PyCFunction)(void (*)(void))py_predictors_kalman_corrected, METH_FASTCALL, NULL},
  {"pointpred.predictors.kalman:expect", (PyCFunction)(void (*)(void))py_predictors_kalman_expect, METH_FASTCALL, NULL},
  {"pointpred.predictors.kalman:expect_rest", (PyCFunction)(void (*)(void))py_predictors_kalman_expect_rest, METH_FASTCALL, NULL},
  {"pointpred.predictors.kalman:step", (PyCFunction)(void (*)(void))py_predictors_kalman_step, METH_FASTCALL, NULL},
  {"pointpred.predictors.kep:add", (PyCFunction)(void (*)(void))py_predictors_kep_add, METH_FASTCALL, NULL},
  {"pointpred.predictors.kep:bends", (PyCFunction)(void (*)(void))py_predictors_kep_bends, METH_FASTCALL, NULL},
  {"pointpred.predictors.kep:derivative", (PyCFunction)(void (*)(void))py_predictors_kep_derivative, METH_FASTCALL, NULL},
  {"pointpred.predictors.kep:first_zero", (PyCFunction)(void (*)(void))py_predictors_kep_first_zero, METH_FASTCALL, NULL},
  {"pointpred.predictors.kep:judge", (PyCFunction)(void (*)(void))py_predictors_kep_judge, METH_FASTCALL, NULL},
  {"pointpred.predictors.kep:remaining", (PyCFunction)(void (*)(void))py_predictors_kep_remaining, METH_FASTCALL, NULL},
  {"pointpred.predictors.kep:step", (PyCFunction)(void (*)(void))py_predictors_kep_step, METH_FASTCALL, NULL},
  {"pointpred.predictors.kep:value", (PyCFunction)(void (*)(void))py_predictors_kep_value, METH_FASTCALL, NULL},
  {"pointpred.predictors.kep:zero_between", (PyCFunction)(void (*)(void))py_predictors_kep_zero_between, METH_FASTCALL, NULL},
  {"pointpred.predictors.kinematic.features:ahead", (PyCFunction)(void (*)(void))py_predictors_kinematic_features_ahead, METH_FASTCALL, NULL},
  {"pointpred.predictors.kinematic.features:direction", (PyCFunction)(void (*)(void))py_predictors_kinematic_features_direction, METH_FASTCALL, NULL},
  {"pointpred.predictors.kinematic.features:fill_lags", (PyCFunction)(void (*)(void))py_predictors_kinematic_features_fill_lags, METH_FASTCALL, NULL},
  {"pointpred.predictors.kinematic.features:fill_pace", (PyCFunction)(void (*)(void))py_predictors_kinematic_features_fill_pace, METH_FASTCALL, NULL},
  {"pointpred.predictors.kinematic.features:fill_shape", (PyCFunction)(void (*)(void))py_predictors_kinematic_features_fill_shape, METH_FASTCALL, NULL},
  {"pointpred.predictors.kinematic.features:follow", (PyCFunction)(void (*)(void))py_predictors_kinematic_features_follow, METH_FASTCALL, NULL},
  {"pointpred.predictors.kinematic.features:frame_of", (PyCFunction)(void (*)(void))py_predictors_kinematic_features_frame_of, METH_FASTCALL, NULL},
  {"pointpred.predictors.kinematic.features:observe", (PyCFunction)(void (*)(void))py_predictors_kinematic_features_observe, METH_FASTCALL, NULL},
  {"pointpred.predictors.kinematic.features:observe_all", (PyCFunction)(void (*)(void))py_predictors_kinematic_features_observe_all, METH_FASTCALL, NULL},
  {"pointpred.predictors.kinematic.features:rewind", (PyCFunction)(void (*)(void))py_predictors_kinematic_features_rewind, METH_FASTCALL, NULL},
  {"pointpred.predictors.kinematic.history:begin", (PyCFunction)(void (*)(void))py_predictors_kinematic_history_begin, METH_FASTCALL, NULL},
  {"pointpred.predictors.kinematic.history:extend", (PyCFunction)(void (*)(void))py_predictors_kinematic_history_extend, METH_FASTCALL, NULL},
  {"pointpred.predictors.kinematic.history:past", (PyCFunction)(void (*)(void))py_predictors_kinematic_history_past, METH_FASTCALL, NULL},
  {"pointpred.predictors.kinematic.network:activate", (PyCFunction)(void (*)(void))py_predictors_kinematic_network_activate, METH_FASTCALL, NULL},
  {"pointpred.predictors.kinematic.network:evaluate", (PyCFunction)(void (*)(void))py_predictors_kinematic_network_evaluate, METH_FASTCALL, NULL},
  {"pointpred.predictors.kinematic.network:factor", (PyCFunction)(void (*)(void))py_predictors_kinematic_network_factor, METH_FASTCALL, NULL},
  {"pointpred.predictors.kinematic.network:layer", (PyCFunction)(void (*)(void))py_predictors_kinematic_network_layer, METH_FASTCALL, NULL},
  {"pointpred.predictors.kinematic.network:side", (PyCFunction)(void (*)(void))py_predictors_kinematic_network_side, METH_FASTCALL, NULL},
  {"pointpred.predictors.kinematic.predictor:bounded_exp", (PyCFunction)(void (*)(void))py_predictors_kinematic_predictor_bounded_exp, METH_FASTCALL, NULL},
  {"pointpred.predictors.kinematic.predictor:follow", (PyCFunction)(void (*)(void))py_predictors_kinematic_predictor_follow, METH_FASTCALL, NULL},
  {"pointpred.predictors.kinematic.predictor:step", (PyCFunction)(void (*)(void))py_predictors_kinematic_predictor_step, METH_FASTCALL, NULL},
  {"pointpred.predictors.kinematic.submovements:divide", (PyCFunction)(void (*)(void))py_predictors_kinematic_submovements_divide, METH_FASTCALL, NULL},
  {"pointpred.predictors.kinematic.track:advance", (PyCFunction)(void (*)(void))py_predictors_kinematic_track_advance, METH_FASTCALL, NULL},
  {"pointpred.predictors.ktm:conclude", (PyCFunction)(void (*)(void))py_predictors_ktm_conclude, METH_FASTCALL, NULL},
  {"pointpred.predictors.ktm:distance", (PyCFunction)(void (*)(void))py_predictors_ktm_distance, METH_FASTCALL, NULL},
  {"pointpred.predictors.ktm:fill", (PyCFunction)(void (*)(void))py_predictors_ktm_fill, METH_FASTCALL, NULL},
  {"pointpred.predictors.ktm:forget", (PyCFunction)(void (*)(void))py_predictors_ktm_forget, METH_FASTCALL, NULL},
  {"pointpred.predictors.ktm:keep", (PyCFunction)(void (*)(void))py_predictors_ktm_keep, METH_FASTCALL, NULL},
  {"pointpred.predictors.ktm:place_of_learned", (PyCFunction)(void (*)(void))py_predictors_ktm_place_of_learned, METH_FASTCALL, NULL},
  {"pointpred.predictors.ktm:place_of_template", (PyCFunction)(void (*)(void))py_predictors_ktm_place_of_template, METH_FASTCALL, NULL},
  {"pointpred.predictors.ktm:resample", (PyCFunction)(void (*)(void))py_predictors_ktm_resample, METH_FASTCALL, NULL},
  {"pointpred.predictors.ktm:sample", (PyCFunction)(void (*)(void))py_predictors_ktm_sample, METH_FASTCALL, NULL},
  {"pointpred.predictors.ktm:samples_of", (PyCFunction)(void (*)(void))py_predictors_ktm_samples_of, METH_FASTCALL, NULL},
  {"pointpred.predictors.ktm:score", (PyCFunction)(void (*)(void))py_predictors_ktm_score, METH_FASTCALL, NULL},
  {"pointpred.predictors.ktm:sizes", (PyCFunction)(void (*)(void))py_predictors_ktm_sizes, METH_FASTCALL, NULL},
  {"pointpred.predictors.ktm:step", (PyCFunction)(void (*)(void))py_predictors_ktm_step, METH_FASTCALL, NULL},
  {"pointpred.predictors.ktm:template_count", (PyCFunction)(void (*)(void))py_predictors_ktm_template_count, METH_FASTCALL, NULL},
  {"pointpred.predictors.ktm:winner", (PyCFunction)(void (*)(void))py_predictors_ktm_winner, METH_FASTCALL, NULL},
  {"pointpred.predictors.linear:before", (PyCFunction)(void (*)(void))py_predictors_linear_before, METH_FASTCALL, NULL},
  {"pointpred.predictors.linear:remember", (PyCFunction)(void (*)(void))py_predictors_linear_remember, METH_FASTCALL, NULL},
  {"pointpred.predictors.linear:step", (PyCFunction)(void (*)(void))py_predictors_linear_step, METH_FASTCALL, NULL},
  {"pointpred.predictors.minimum_jerk:progress", (PyCFunction)(void (*)(void))py_predictors_minimum_jerk_progress, METH_FASTCALL, NULL},
  {"pointpred.predictors.minimum_jerk:step", (PyCFunction)(void (*)(void))py_predictors_minimum_jerk_step, METH_FASTCALL, NULL},
  {"pointpred.predictors.mixture:content", (PyCFunction)(void (*)(void))py_predictors_mixture_content, METH_FASTCALL, NULL},
  {"pointpred.predictors.mixture:corrected_probability", (PyCFunction)(void (*)(void))py_predictors_mixture_corrected_probability, METH_FASTCALL, NULL},
  {"pointpred.predictors.mixture:corrected_radius", (PyCFunction)(void (*)(void))py_predictors_mixture_corrected_radius, METH_FASTCALL, NULL},
  {"pointpred.predictors.mixture:crossing", (PyCFunction)(void (*)(void))py_predictors_mixture_crossing, METH_FASTCALL, NULL},
  {"pointpred.predictors.mixture:densities", (PyCFunction)(void (*)(void))py_predictors_mixture_densities, METH_FASTCALL, NULL},
  {"pointpred.predictors.mixture:density", (PyCFunction)(void (*)(void))py_predictors_mixture_density, METH_FASTCALL, NULL},
  {"pointpred.predictors.mixture:edge_of", (PyCFunction)(void (*)(void))py_predictors_mixture_edge_of, METH_FASTCALL, NULL},
  {"pointpred.predictors.mixture:follow_cells", (PyCFunction)(void (*)(void))py_predictors_mixture_follow_cells, METH_FASTCALL, NULL},
  {"pointpred.predictors.mixture:heaviness", (PyCFunction)(void (*)(void))py_predictors_mixture_heaviness, METH_FASTCALL, NULL},
  {"pointpred.predictors.mixture:height", (PyCFunction)(void (*)(void))py_predictors_mixture_height, METH_FASTCALL, NULL},
  {"pointpred.predictors.mixture:lines_of", (PyCFunction)(void (*)(void))py_predictors_mixture_lines_of, METH_FASTCALL, NULL},
  {"pointpred.predictors.mixture:outlines", (PyCFunction)(void (*)(void))py_predictors_mixture_outlines, METH_FASTCALL, NULL},
  {"pointpred.predictors.mixture:part_density", (PyCFunction)(void (*)(void))py_predictors_mixture_part_density, METH_FASTCALL, NULL},
  {"pointpred.predictors.mixture:partner", (PyCFunction)(void (*)(void))py_predictors_mixture_partner, METH_FASTCALL, NULL},
  {"pointpred.predictors.mixture:points_of", (PyCFunction)(void (*)(void))py_predictors_mixture_points_of, METH_FASTCALL, NULL},
  {"pointpred.predictors.mixture:reach", (PyCFunction)(void (*)(void))py_predictors_mixture_reach, METH_FASTCALL, NULL},
  {"pointpred.predictors.mixture:share_above", (PyCFunction)(void (*)(void))py_predictors_mixture_share_above, METH_FASTCALL, NULL},
  {"pointpred.predictors.mixture:squared_radius", (PyCFunction)(void (*)(void))py_predictors_mixture_squared_radius, METH_FASTCALL, NULL},
  {"pointpred.predictors.mixture:squared_radius_over_tail", (PyCFunction)(void (*)(void))py_predictors_mixture_squared_radius_over_tail, METH_FASTCALL, NULL},
  {"pointpred.predictors.mixture:threshold_of", (PyCFunction)(void (*)(void))py_predictors_mixture_threshold_of, METH_FASTCALL, NULL},
  {"pointpred.predictors.movement:fault_of", (PyCFunction)(void (*)(void))py_predictors_movement_fault_of, METH_FASTCALL, NULL},
  {"pointpred.predictors.movement:follow", (PyCFunction)(void (*)(void))py_predictors_movement_follow, METH_FASTCALL, NULL},
  {"pointpred.predictors.movement:phase", (PyCFunction)(void (*)(void))py_predictors_movement_phase, METH_FASTCALL, NULL},
  {"pointpred.predictors.movement:refuse", (PyCFunction)(void (*)(void))py_predictors_movement_refuse, METH_FASTCALL, NULL},
  {"pointpred.predictors.switched:advance", (PyCFunction)(void (*)(void))py_predictors_switched_advance, METH_FASTCALL, NULL},
  {"pointpred.predictors.switched_direction:approach", (PyCFunction)(void (*)(void))py_predictors_switched_direction_approach, METH_FASTCALL, NULL},
  {"pointpred.predictors.switched_direction:begin_submovement", (PyCFunction)(void (*)(void))py_predictors_switched_direction_begin_submovement, METH_FASTCALL, NULL},
  {"pointpred.predictors.switched_direction:follow_submovement", (PyCFunction)(void (*)(void))py_predictors_switched_direction_follow_submovement, METH_FASTCALL, NULL},
  {"pointpred.predictors.switched_direction:gain", (PyCFunction)(void (*)(void))py_predictors_switched_direction_gain, METH_FASTCALL, NULL},
  {"pointpred.predictors.switched_direction:step", (PyCFunction)(void (*)(void))py_predictors_switched_direction_step, METH_FASTCALL, NULL},
  {"pointpred.predictors.switched_direction:time_constant", (PyCFunction)(void (*)(void))py_predictors_switched_direction_time_constant, METH_FASTCALL, NULL},
  {"pointpred.predictors.switched:step", (PyCFunction)(void (*)(void))py_predictors_switched_step, METH_FASTCALL, NULL},
  {"pointpred.records:endpoint", (PyCFunction)(void (*)(void))py_records_endpoint, METH_FASTCALL, NULL},
  {"pointpred.records:event_at", (PyCFunction)(void (*)(void))py_records_event_at, METH_FASTCALL, NULL},
  {"pointpred.records:fault_of_event", (PyCFunction)(void (*)(void))py_records_fault_of_event, METH_FASTCALL, NULL},
  {"pointpred.records:refused", (PyCFunction)(void (*)(void))py_records_refused, METH_FASTCALL, NULL},
  {"pointpred.records:row_at", (PyCFunction)(void (*)(void))py_records_row_at, METH_FASTCALL, NULL},
  {"pointpred.regions:reach", (PyCFunction)(void (*)(void))py_regions_reach, METH_FASTCALL, NULL},
  {"pointpred.regression.delay:capacity", (PyCFunction)(void (*)(void))py_regression_delay_capacity, METH_FASTCALL, NULL},
  {"pointpred.regression.delay:delayed", (PyCFunction)(void (*)(void))py_regression_delay_delayed, METH_FASTCALL, NULL},
  {"pointpred.regression.delay:push", (PyCFunction)(void (*)(void))py_regression_delay_push, METH_FASTCALL, NULL},
  {"pointpred.regression.delay:states", (PyCFunction)(void (*)(void))py_regression_delay_states, METH_FASTCALL, NULL},
  {"pointpred.regression.drem:advance", (PyCFunction)(void (*)(void))py_regression_drem_advance, METH_FASTCALL, NULL},
  {"pointpred.regression.drem:determinant", (PyCFunction)(void (*)(void))py_regression_drem_determinant, METH_FASTCALL, NULL},
  {"pointpred.regression.drem:extend", (PyCFunction)(void (*)(void))py_regression_drem_extend, METH_FASTCALL, NULL},
  {"pointpred.regression.drem:mix", (PyCFunction)(void (*)(void))py_regression_drem_mix, METH_FASTCALL, NULL},
  {"pointpred.regression.drem:mix3", (PyCFunction)(void (*)(void))py_regression_drem_mix3, METH_FASTCALL, NULL},
  {"pointpred.regression.drem:numbers", (PyCFunction)(void (*)(void))py_regression_drem_numbers, METH_FASTCALL, NULL},
  {"pointpred.regression.drem:remember", (PyCFunction)(void (*)(void))py_regression_drem_remember, METH_FASTCALL, NULL},
  {"pointpred.regression.gradient:descend", (PyCFunction)(void (*)(void))py_regression_gradient_descend, METH_FASTCALL, NULL},
  {"pointpred.regression.gradient:descend_along", (PyCFunction)(void (*)(void))py_regression_gradient_descend_along, METH_FASTCALL, NULL},
  {"pointpred.regression.least_squares:advance", (PyCFunction)(void (*)(void))py_regression_least_squares_advance, METH_FASTCALL, NULL},
  {"pointpred.regression.least_squares:excitation", (PyCFunction)(void (*)(void))py_regression_least_squares_excitation, METH_FASTCALL, NULL},
  {"pointpred.regression.least_squares:numbers", (PyCFunction)(void (*)(void))py_regression_least_squares_numbers, METH_FASTCALL, NULL},
  {"pointpred.regression.least_squares:solve", (PyCFunction)(void (*)(void))py_regression_least_squares_solve, METH_FASTCALL, NULL},
  {"pointpred.scoring.measures.endpoint:hits", (PyCFunction)(void (*)(void))py_scoring_measures_endpoint_hits, METH_FASTCALL, NULL},
  {"pointpred.scoring.measures.endpoint:measure", (PyCFunction)(void (*)(void))py_scoring_measures_endpoint_measure, METH_FASTCALL, NULL},
  {"pointpred.scoring.measures.endpoint:measure_trial", (PyCFunction)(void (*)(void))py_scoring_measures_endpoint_measure_trial, METH_FASTCALL, NULL},
  {"pointpred.scoring.measures.endpoint:moments", (PyCFunction)(void (*)(void))py_scoring_measures_endpoint_moments, METH_FASTCALL, NULL},
  {"pointpred.scoring.measures.regions:axis_score", (PyCFunction)(void (*)(void))py_scoring_measures_regions_axis_score, METH_FASTCALL, NULL},
  {"pointpred.scoring.measures.regions:beta_fraction", (PyCFunction)(void (*)(void))py_scoring_measures_regions_beta_fraction, METH_FASTCALL, NULL},
  {"pointpred.scoring.measures.regions:calibrate", (PyCFunction)(void (*)(void))py_scoring_measures_regions_calibrate, METH_FASTCALL, NULL},
  {"pointpred.scoring.measures.regions:distribution", (PyCFunction)(void (*)(void))py_scoring_measures_regions_distribution, METH_FASTCALL, NULL},
  {"pointpred.scoring.measures.regions:incomplete_beta", (PyCFunction)(void (*)(void))py_scoring_measures_regions_incomplete_beta, METH_FASTCALL, NULL},
  {"pointpred.scoring.measures.regions:inside_by_time", (PyCFunction)(void (*)(void))py_scoring_measures_regions_inside_by_time, METH_FASTCALL, NULL},
  {"pointpred.scoring.measures.regions:log_beta", (PyCFunction)(void (*)(void))py_scoring_measures_regions_log_beta, METH_FASTCALL, NULL},
  {"pointpred.scoring.measures.regions:ranked_score", (PyCFunction)(void (*)(void))py_scoring_measures_regions_ranked_score, METH_FASTCALL, NULL},
  {"pointpred.scoring.measures.regions:student_score", (PyCFunction)(void (*)(void))py_scoring_measures_regions_student_score, METH_FASTCALL, NULL},
  {"pointpred.scoring.measures.regions:surprise", (PyCFunction)(void (*)(void))py_scoring_measures_regions_surprise, METH_FASTCALL, NULL},
  {"pointpred.scoring.measures.time_left:inside_by_time", (PyCFunction)(void (*)(void))py_scoring_measures_time_left_inside_by_time, METH_FASTCALL, NULL},
  {"pointpred.scoring.measures.time_left:time_left", (PyCFunction)(void (*)(void))py_scoring_measures_time_left_time_left, METH_FASTCALL, NULL},
  {"pointpred.scoring.measures.time_left:within", (PyCFunction)(void (*)(void))py_scoring_measures_time_left_within, METH_FASTCALL, NULL},
  {"pointpred.scoring.summary.sums:add_trials", (PyCFunction)(void (*)(void))py_scoring_summary_sums_add_trials, METH_FASTCALL, NULL},
  {"pointpred.scoring.target_choice:account", (PyCFunction)(void (*)(void))py_scoring_target_choice_account, METH_FASTCALL, NULL},
  {"pointpred.scoring.target_choice:nearest", (PyCFunction)(void (*)(void))py_scoring_target_choice_nearest, METH_FASTCALL, NULL},
  {"pointpred.scoring.target_choice:read", (PyCFunction)(void (*)(void))py_scoring_target_choice_read, METH_FASTCALL, NULL},
  {"pointpred.scoring.target_choice:weigh", (PyCFunction)(void (*)(void))py_scoring_target_choice_weigh, METH_FASTCALL, NULL},
  {"pointpred.scoring.trials:cut", (PyCFunction)(void (*)(void))py_scoring_trials_cut, METH_FASTCALL, NULL},
  {"pointpred.scoring.trials:departure", (PyCFunction)(void (*)(void))py_scoring_trials_departure, METH_FASTCALL, NULL},
  {"pointpred.scoring.trials:divide", (PyCFunction)(void (*)(void))py_scoring_trials_divide, METH_FASTCALL, NULL},
  {"pointpred.scoring.trials:divided", (PyCFunction)(void (*)(void))py_scoring_trials_divided, METH_FASTCALL, NULL},
  {"pointpred.scoring.trials:fault", (PyCFunction)(void (*)(void))py_scoring_trials_fault, METH_FASTCALL, NULL},
  {"pointpred.scoring.trials:judge", (PyCFunction)(void (*)(void))py_scoring_trials_judge, METH_FASTCALL, NULL},
  {"pointpred.scoring.trials:selection", (PyCFunction)(void (*)(void))py_scoring_trials_selection, METH_FASTCALL, NULL},
  {"pointpred.scoring.trials:settling", (PyCFunction)(void (*)(void))py_scoring_trials_settling, METH_FASTCALL, NULL},
  {"pointpred.scoring.trials:straight_through", (PyCFunction)(void (*)(void))py_scoring_trials_straight_through, METH_FASTCALL, NULL},
  {"pointpred.simulation.hand:aim", (PyCFunction)(void (*)(void))py_simulation_hand_aim, METH_FASTCALL, NULL},
  {"pointpred.simulation.hand:begin", (PyCFunction)(void (*)(void))py_simulation_hand_begin, METH_FASTCALL, NULL},
  {"pointpred.simulation.hand:draw", (PyCFunction)(void (*)(void))py_simulation_hand_draw, METH_FASTCALL, NULL},
  {"pointpred.simulation.hand:normal", (PyCFunction)(void (*)(void))py_simulation_hand_normal, METH_FASTCALL, NULL},
  {"pointpred.simulation.hand:report", (PyCFunction)(void (*)(void))py_simulation_hand_report, METH_FASTCALL, NULL},
  {"pointpred.simulation.hand:sow", (PyCFunction)(void (*)(void))py_simulation_hand_sow, METH_FASTCALL, NULL},
  {"pointpred.simulation.hand:uniform", (PyCFunction)(void (*)(void))py_simulation_hand_uniform, METH_FASTCALL, NULL},
  {"pointpred.simulation.loop:acceleration", (PyCFunction)(void (*)(void))py_simulation_loop_acceleration, METH_FASTCALL, NULL},
  {"pointpred.simulation.loop:advance", (PyCFunction)(void (*)(void))py_simulation_loop_advance, METH_FASTCALL, NULL},
  {"pointpred.simulation.loop:assist", (PyCFunction)(void (*)(void))py_simulation_loop_assist, METH_FASTCALL, NULL},
  {"pointpred.simulation.loop:ballistic_force", (PyCFunction)(void (*)(void))py_simulation_loop_ballistic_force, METH_FASTCALL, NULL},
  {"pointpred.simulation.loop:correct", (PyCFunction)(void (*)(void))py_simulation_loop_correct, METH_FASTCALL, NULL},
  {"pointpred.simulation.loop:count", (PyCFunction)(void (*)(void))py_simulation_loop_count, METH_FASTCALL, NULL},
  {"pointpred.simulation.loop:cursor_distance", (PyCFunction)(void (*)(void))py_simulation_loop_cursor_distance, METH_FASTCALL, NULL},
  {"pointpred.simulation.loop:cursor_in_mind", (PyCFunction)(void (*)(void))py_simulation_loop_cursor_in_mind, METH_FASTCALL, NULL},
  {"pointpred.simulation.loop:cursor_rate", (PyCFunction)(void (*)(void))py_simulation_loop_cursor_rate, METH_FASTCALL, NULL},
  {"pointpred.simulation.loop:decide", (PyCFunction)(void (*)(void))py_simulation_loop_decide, METH_FASTCALL, NULL},
  {"pointpred.simulation.loop:enter", (PyCFunction)(void (*)(void))py_simulation_loop_enter, METH_FASTCALL, NULL},
  {"pointpred.simulation.loop:hand_distance", (PyCFunction)(void (*)(void))py_simulation_loop_hand_distance, METH_FASTCALL, NULL},
  {"pointpred.simulation.loop:launch", (PyCFunction)(void (*)(void))py_simulation_loop_launch, METH_FASTCALL, NULL},
  {"pointpred.simulation.loop:play", (PyCFunction)(void (*)(void))py_simulation_loop_play, METH_FASTCALL, NULL},
  {"pointpred.simulation.loop:profile", (PyCFunction)(void (*)(void))py_simulation_loop_profile, METH_FASTCALL, NULL},
  {"pointpred.simulation.loop:report", (PyCFunction)(void (*)(void))py_simulation_loop_report, METH_FASTCALL, NULL},
  {"pointpred.simulation.loop:step", (PyCFunction)(void (*)(void))py_simulation_loop_step, METH_FASTCALL, NULL},
  {"pointpred.simulation.person:between", (PyCFunction)(void (*)(void))py_simulation_person_between, METH_FASTCALL, NULL},
  {"pointpred.simulation.person:grow", (PyCFunction)(void (*)(void))py_simulation_person_grow, METH_FASTCALL, NULL},
  {"pointpred.simulation.plan:plan", (PyCFunction)(void (*)(void))py_simulation_plan_plan, METH_FASTCALL, NULL},
  {"pointpred.simulation.plan:plan_piece", (PyCFunction)(void (*)(void))py_simulation_plan_plan_piece, METH_FASTCALL, NULL},
  {"pointpred.simulation.plan:varied", (PyCFunction)(void (*)(void))py_simulation_plan_varied, METH_FASTCALL, NULL},
  {"pointpred.stage:copy_values", (PyCFunction)(void (*)(void))py_stage_copy_values, METH_FASTCALL, NULL},
  {"pointpred.stage:first_refused", (PyCFunction)(void (*)(void))py_stage_first_refused, METH_FASTCALL, NULL},
  {"pointpred.stage:learn_nothing", (PyCFunction)(void (*)(void))py_stage_learn_nothing, METH_FASTCALL, NULL},
  {"pointpred.targets.aim:conclude", (PyCFunction)(void (*)(void))py_targets_aim_conclude, METH_FASTCALL, NULL},
  {"pointpred.targets.aim:fault", (PyCFunction)(void (*)(void))py_targets_aim_fault, METH_FASTCALL, NULL},
  {"pointpred.targets.aim:lay_parts", (PyCFunction)(void (*)(void))py_targets_aim_lay_parts, METH_FASTCALL, NULL},
  {"pointpred.targets.aim:learn_prediction", (PyCFunction)(void (*)(void))py_targets_aim_learn_prediction, METH_FASTCALL, NULL},
  {"pointpred.targets.aim:learn_regions", (PyCFunction)(void (*)(void))py_targets_aim_learn_regions, METH_FASTCALL, NULL},
  {"pointpred.targets.aim:record", (PyCFunction)(void (*)(void))py_targets_aim_record, METH_FASTCALL, NULL},
  {"pointpred.targets.aim:row_of", (PyCFunction)(void (*)(void))py_targets_aim_row_of, METH_FASTCALL, NULL},
  {"pointpred.targets.aim:share_passed", (PyCFunction)(void (*)(void))py_targets_aim_share_passed, METH_FASTCALL, NULL},
  {"pointpred.targets.aim:size_of", (PyCFunction)(void (*)(void))py_targets_aim_size_of, METH_FASTCALL, NULL},
  {"pointpred.targets.aim:step", (PyCFunction)(void (*)(void))py_targets_aim_step, METH_FASTCALL, NULL},
  {"pointpred.targets.aim:walk", (PyCFunction)(void (*)(void))py_targets_aim_walk, METH_FASTCALL, NULL},
  {"pointpred.targets.arrival:mean", (PyCFunction)(void (*)(void))py_targets_arrival_mean, METH_FASTCALL, NULL},
  {"pointpred.targets.arrival:remember", (PyCFunction)(void (*)(void))py_targets_arrival_remember, METH_FASTCALL, NULL},
  {"pointpred.targets.arrival:terms", (PyCFunction)(void (*)(void))py_targets_arrival_terms, METH_FASTCALL, NULL},
  {"pointpred.targets.choice_law:changes", (PyCFunction)(void (*)(void))py_targets_choice_law_changes, METH_FASTCALL, NULL},
  {"pointpred.targets.choice_law:decide", (PyCFunction)(void (*)(void))py_targets_choice_law_decide, METH_FASTCALL, NULL},
  {"pointpred.targets.choice_law:enter", (PyCFunction)(void (*)(void))py_targets_choice_law_enter, METH_FASTCALL, NULL},
  {"pointpred.targets.choice_law:innermost", (PyCFunction)(void (*)(void))py_targets_choice_law_innermost, METH_FASTCALL, NULL},
  {"pointpred.targets.choice_law:lay_places", (PyCFunction)(void (*)(void))py_targets_choice_law_lay_places, METH_FASTCALL, NULL},
  {"pointpred.targets.choice_law:place_of", (PyCFunction)(void (*)(void))py_targets_choice_law_place_of, METH_FASTCALL, NULL},
  {"pointpred.targets.choice_law:replace", (PyCFunction)(void (*)(void))py_targets_choice_law_replace, METH_FASTCALL, NULL},
  {"pointpred.targets.choice_law:reset", (PyCFunction)(void (*)(void))py_targets_choice_law_reset, METH_FASTCALL, NULL},
  {"pointpred.targets.choice_law:update", (PyCFunction)(void (*)(void))py_targets_choice_law_update, METH_FASTCALL, NULL},
  {"pointpred.targets.cursor:begins", (PyCFunction)(void (*)(void))py_targets_cursor_begins, METH_FASTCALL, NULL},
  {"pointpred.targets.cursor:follow", (PyCFunction)(void (*)(void))py_targets_cursor_follow, METH_FASTCALL, NULL},
  {"pointpred.targets.cursor:until", (PyCFunction)(void (*)(void))py_targets_cursor_until, METH_FASTCALL, NULL},
  {"pointpred.targets.cursor:usable", (PyCFunction)(void (*)(void))py_targets_cursor_usable, METH_FASTCALL, NULL},
  {"pointpred.targets.decision:decide", (PyCFunction)(void (*)(void))py_targets_decision_decide, METH_FASTCALL, NULL},
  {"pointpred.targets.decision:early", (PyCFunction)(void (*)(void))py_targets_decision_early, METH_FASTCALL, NULL},
  {"pointpred.targets.decision:likeliest", (PyCFunction)(void (*)(void))py_targets_decision_likeliest, METH_FASTCALL, NULL},
  {"pointpred.targets.decision:rank", (PyCFunction)(void (*)(void))py_targets_decision_rank, METH_FASTCALL, NULL},
  {"pointpred.targets.endpoint:ellipse", (PyCFunction)(void (*)(void))py_targets_endpoint_ellipse, METH_FASTCALL, NULL},
  {"pointpred.targets.endpoint:elsewhere", (PyCFunction)(void (*)(void))py_targets_endpoint_elsewhere, METH_FASTCALL, NULL},
  {"pointpred.targets.endpoint:geometric_median", (PyCFunction)(void (*)(void))py_targets_endpoint_geometric_median, METH_FASTCALL, NULL},
  {"pointpred.targets.endpoint:mixture", (PyCFunction)(void (*)(void))py_targets_endpoint_mixture, METH_FASTCALL, NULL},
  {"pointpred.targets.endpoint:write_target", (PyCFunction)(void (*)(void))py_targets_endpoint_write_target, METH_FASTCALL, NULL},
  {"pointpred.targets.heading:arrived", (PyCFunction)(void (*)(void))py_targets_heading_arrived, METH_FASTCALL, NULL},
  {"pointpred.targets.heading:begin", (PyCFunction)(void (*)(void))py_targets_heading_begin, METH_FASTCALL, NULL},
  {"pointpred.targets.heading:ended", (PyCFunction)(void (*)(void))py_targets_heading_ended, METH_FASTCALL, NULL},
  {"pointpred.targets.heading:follow", (PyCFunction)(void (*)(void))py_targets_heading_follow, METH_FASTCALL, NULL},
  {"pointpred.targets.heading:learn_target", (PyCFunction)(void (*)(void))py_targets_heading_learn_target, METH_FASTCALL, NULL},
  {"pointpred.targets.heading:taken", (PyCFunction)(void (*)(void))py_targets_heading_taken, METH_FASTCALL, NULL},
  {"pointpred.targets.heading:weigh", (PyCFunction)(void (*)(void))py_targets_heading_weigh, METH_FASTCALL, NULL},
  {"pointpred.targets.ledger:add", (PyCFunction)(void (*)(void))py_targets_ledger_add, METH_FASTCALL, NULL},
  {"pointpred.targets.ledger:begin", (PyCFunction)(void (*)(void))py_targets_ledger_begin, METH_FASTCALL, NULL},
  {"pointpred.targets.ledger:close", (PyCFunction)(void (*)(void))py_targets_ledger_close, METH_FASTCALL, NULL},
  {"pointpred.targets.ledger:drop", (PyCFunction)(void (*)(void))py_targets_ledger_drop, METH_FASTCALL, NULL},
  {"pointpred.targets.ledger:enter", (PyCFunction)(void (*)(void))py_targets_ledger_enter, METH_FASTCALL, NULL},
  {"pointpred.targets.ledger:finish", (PyCFunction)(void (*)(void))py_targets_ledger_finish, METH_FASTCALL, NULL},
  {"pointpred.targets.ledger:note_end", (PyCFunction)(void (*)(void))py_targets_ledger_note_end, METH_FASTCALL, NULL},
  {"pointpred.targets.ledger:note_entry", (PyCFunction)(void (*)(void))py_targets_ledger_note_entry, METH_FASTCALL, NULL},
  {"pointpred.targets.ledger:note_proposal", (PyCFunction)(void (*)(void))py_targets_ledger_note_proposal, METH_FASTCALL, NULL},
  {"pointpred.targets.ledger:propose", (PyCFunction)(void (*)(void))py_targets_ledger_propose, METH_FASTCALL, NULL},
  {"pointpred.targets.ledger:row_of", (PyCFunction)(void (*)(void))py_targets_ledger_row_of, METH_FASTCALL, NULL},
  {"pointpred.targets.ledger:withdraw", (PyCFunction)(void (*)(void))py_targets_ledger_withdraw, METH_FASTCALL, NULL},
  {"pointpred.targets.past:add_visit", (PyCFunction)(void (*)(void))py_targets_past_add_visit, METH_FASTCALL, NULL},
  {"pointpred.targets.past:elsewhere", (PyCFunction)(void (*)(void))py_targets_past_elsewhere, METH_FASTCALL, NULL},
  {"pointpred.targets.past:learn", (PyCFunction)(void (*)(void))py_targets_past_learn, METH_FASTCALL, NULL},
  {"pointpred.targets.past:rule_weight", (PyCFunction)(void (*)(void))py_targets_past_rule_weight, METH_FASTCALL, NULL},
  {"pointpred.targets.past:shares", (PyCFunction)(void (*)(void))py_targets_past_shares, METH_FASTCALL, NULL},
  {"pointpred.targets.past:weigh", (PyCFunction)(void (*)(void))py_targets_past_weigh, METH_FASTCALL, NULL},
  {"pointpred.targets.posterior:direction", (PyCFunction)(void (*)(void))py_targets_posterior_direction, METH_FASTCALL, NULL},
  {"pointpred.targets.posterior:feature", (PyCFunction)(void (*)(void))py_targets_posterior_feature, METH_FASTCALL, NULL},
  {"pointpred.targets.posterior:features", (PyCFunction)(void (*)(void))py_targets_posterior_features, METH_FASTCALL, NULL},
  {"pointpred.targets.posterior:lawful", (PyCFunction)(void (*)(void))py_targets_posterior_lawful, METH_FASTCALL, NULL},
  {"pointpred.targets.posterior:log_mass", (PyCFunction)(void (*)(void))py_targets_posterior_log_mass, METH_FASTCALL, NULL},
  {"pointpred.targets.posterior:log_total", (PyCFunction)(void (*)(void))py_targets_posterior_log_total, METH_FASTCALL, NULL},
  {"pointpred.targets.posterior:normalise", (PyCFunction)(void (*)(void))py_targets_posterior_normalise, METH_FASTCALL, NULL},
  {"pointpred.targets.posterior:scores", (PyCFunction)(void (*)(void))py_targets_posterior_scores, METH_FASTCALL, NULL},
  {"pointpred.targets.posterior:situation", (PyCFunction)(void (*)(void))py_targets_posterior_situation, METH_FASTCALL, NULL},
  {"pointpred.targets.posterior:unclaimed", (PyCFunction)(void (*)(void))py_targets_posterior_unclaimed, METH_FASTCALL, NULL},
  {"pointpred.targets.prefetch:begin", (PyCFunction)(void (*)(void))py_targets_prefetch_begin, METH_FASTCALL, NULL},
  {"pointpred.targets.prefetch:contact", (PyCFunction)(void (*)(void))py_targets_prefetch_contact, METH_FASTCALL, NULL},
  {"pointpred.targets.prefetch:expect", (PyCFunction)(void (*)(void))py_targets_prefetch_expect, METH_FASTCALL, NULL},
  {"pointpred.targets.prefetch:inside", (PyCFunction)(void (*)(void))py_targets_prefetch_inside, METH_FASTCALL, NULL},
  {"pointpred.targets.prefetch:least_visit", (PyCFunction)(void (*)(void))py_targets_prefetch_least_visit, METH_FASTCALL, NULL},
  {"pointpred.targets.prefetch:log_odds", (PyCFunction)(void (*)(void))py_targets_prefetch_log_odds, METH_FASTCALL, NULL},
  {"pointpred.targets.prefetch:score", (PyCFunction)(void (*)(void))py_targets_prefetch_score, METH_FASTCALL, NULL},
  {"pointpred.targets.prefetch:step", (PyCFunction)(void (*)(void))py_targets_prefetch_step, METH_FASTCALL, NULL},
  {"pointpred.targets.prefetch:terms", (PyCFunction)(void (*)(void))py_targets_prefetch_terms, METH_FASTCALL, NULL},
  {"pointpred.targets.prefetch:visit", (PyCFunction)(void (*)(void))py_targets_prefetch_visit, METH_FASTCALL, NULL},
  {"pointpred.targets.rectangles:complete", (PyCFunction)(void (*)(void))py_targets_rectangles_complete, METH_FASTCALL, NULL},
  {"pointpred.targets.rectangles:holder", (PyCFunction)(void (*)(void))py_targets_rectangles_holder, METH_FASTCALL, NULL},
  {"pointpred.training.calibration:fill_reaches", (PyCFunction)(void (*)(void))py_training_calibration_fill_reaches, METH_FASTCALL, NULL},
  {"pointpred.transfer.assistance:add", (PyCFunction)(void (*)(void))py_transfer_assistance_add, METH_FASTCALL, NULL},
  {"pointpred.transfer.assistance:assisted_step", (PyCFunction)(void (*)(void))py_transfer_assistance_assisted_step, METH_FASTCALL, NULL},
  {"pointpred.transfer.assistance:guarded_step", (PyCFunction)(void (*)(void))py_transfer_assistance_guarded_step, METH_FASTCALL, NULL},
  {"pointpred.transfer.assistance:guide", (PyCFunction)(void (*)(void))py_transfer_assistance_guide, METH_FASTCALL, NULL},
  {"pointpred.transfer.assistance:guided_report_at", (PyCFunction)(void (*)(void))py_transfer_assistance_guided_report_at, METH_FASTCALL, NULL},
  {"pointpred.transfer.assistance:offset_report_at", (PyCFunction)(void (*)(void))py_transfer_assistance_offset_report_at, METH_FASTCALL, NULL},
  {"pointpred.transfer.assistance:pull", (PyCFunction)(void (*)(void))py_transfer_assistance_pull, METH_FASTCALL, NULL},
  {"pointpred.transfer.assistance:spread", (PyCFunction)(void (*)(void))py_transfer_assistance_spread, METH_FASTCALL, NULL},
  {"pointpred.transfer.bands:learn", (PyCFunction)(void (*)(void))py_transfer_bands_learn, METH_FASTCALL, NULL},
  {"pointpred.transfer.bands:states", (PyCFunction)(void (*)(void))py_transfer_bands_states, METH_FASTCALL, NULL},
  {"pointpred.transfer.functions:cursor_speed", (PyCFunction)(void (*)(void))py_transfer_functions_cursor_speed, METH_FASTCALL, NULL},
  {"pointpred.transfer.functions:evaluate", (PyCFunction)(void (*)(void))py_transfer_functions_evaluate, METH_FASTCALL, NULL},
  {"pointpred.transfer.functions:gain", (PyCFunction)(void (*)(void))py_transfer_functions_gain, METH_FASTCALL, NULL},
  {"pointpred.transfer.identification:event_at", (PyCFunction)(void (*)(void))py_transfer_identification_event_at, METH_FASTCALL, NULL},
  {"pointpred.transfer.identification:gather", (PyCFunction)(void (*)(void))py_transfer_identification_gather, METH_FASTCALL, NULL},
  {"pointpred.transfer.identification:learn", (PyCFunction)(void (*)(void))py_transfer_identification_learn, METH_FASTCALL, NULL},
  {"pointpred.transfer.identification:learn_speeds", (PyCFunction)(void (*)(void))py_transfer_identification_learn_speeds, METH_FASTCALL, NULL},
  {"pointpred.transfer.identification:open_window", (PyCFunction)(void (*)(void))py_transfer_identification_open_window, METH_FASTCALL, NULL},
  {"pointpred.transfer.identification:step", (PyCFunction)(void (*)(void))py_transfer_identification_step, METH_FASTCALL, NULL},
  {"pointpred.transfer.pixels:accept", (PyCFunction)(void (*)(void))py_transfer_pixels_accept, METH_FASTCALL, NULL},
  {"pointpred.transfer.pixels:carry", (PyCFunction)(void (*)(void))py_transfer_pixels_carry, METH_FASTCALL, NULL},
  {"pointpred.transfer.pixels:lay_out", (PyCFunction)(void (*)(void))py_transfer_pixels_lay_out, METH_FASTCALL, NULL},
  {"pointpred.transfer.pixels:report_at", (PyCFunction)(void (*)(void))py_transfer_pixels_report_at, METH_FASTCALL, NULL},
  {"pointpred.transfer.pixels:step", (PyCFunction)(void (*)(void))py_transfer_pixels_step, METH_FASTCALL, NULL},
  {"pointpred.transfer.pixels:turn", (PyCFunction)(void (*)(void))py_transfer_pixels_turn, METH_FASTCALL, NULL},
  {NULL, NULL, 0, NULL},
};
extern const char digest_of_laws[];
static PyModuleDef_Slot slots[] = {{0, NULL}};
static PyModuleDef definition = {
  PyModuleDef_HEAD_INIT, "_laws", digest_of_laws, 0, methods, slots, NULL, NULL, NULL,
};
PyMODINIT_FUNC PyInit__laws(void) { return PyModuleDef_Init(&definition); }
