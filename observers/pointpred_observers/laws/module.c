/* Written by `make laws` from the laws: change those and run it again. */
#define MOST_ARRAYS 18
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

static PyObject *give_T2d(T2d value) {
  PyObject *tuple = PyTuple_New(2);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, PyFloat_FromDouble(value.f0));
  PyTuple_SetItem(tuple, 1, PyFloat_FromDouble(value.f1));
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
static PyObject *give_T2_T3d_(T2_T3d_ value) {
  PyObject *tuple = PyTuple_New(2);
  if (tuple == NULL) return NULL;
  PyTuple_SetItem(tuple, 0, give_T3d(value.f0));
  PyTuple_SetItem(tuple, 1, give_T3d(value.f1));
  return tuple;
}
static PyObject *py_camera_depth_carry(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.camera.depth:carry";
  Held held;
  const Py_buffer *view;
  camera_depth_State * a0;
  camera_depth_Measured a1;
  double a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "state", true, 12, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "m", 6)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.x)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.y)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.wx)
        && take_double(PyTuple_GetItem(args[1], 3), &a1.wy)
        && take_double(PyTuple_GetItem(args[1], 4), &a1.wz)
        && take_double(PyTuple_GetItem(args[1], 5), &a1.az)
        && take_double(args[2], &a2)))
    return let_go(&held);
  camera_depth_carry(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_camera_depth_inside(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.camera.depth:inside";
  Held held;
  const Py_buffer *view;
  camera_depth_Memory * a0;
  double a1;
  double a2;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "memory", false, 27, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  result = camera_depth_inside(a0, a1, a2);
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_camera_depth_rate(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.camera.depth:rate";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  camera_depth_Measured a2;
  double a3;
  double a4;
  T2d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_double(args[0], &a0)
        && take_double(args[1], &a1)
        && take_tuple(args[2], law, "m", 6)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.x)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.y)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.wx)
        && take_double(PyTuple_GetItem(args[2], 3), &a2.wy)
        && take_double(PyTuple_GetItem(args[2], 4), &a2.wz)
        && take_double(PyTuple_GetItem(args[2], 5), &a2.az)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  result = camera_depth_rate(a0, a1, a2, a3, a4);
  let_go(&held);
  return give_T2d(result);
}
static PyObject *py_camera_depth_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.camera.depth:step";
  Held held;
  const Py_buffer *view;
  camera_depth_Memory * a0;
  Vector a1;
  Vector a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "memory", true, 27, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "row", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "out", 'd', 1, true, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  camera_depth_step(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_camera_kinematics_add_noise(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.camera.kinematics:add_noise";
  Held held;
  const Py_buffer *view;
  camera_kinematics_Matrix * a0;
  Vector a1;
  double a2;
  double a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "p", true, 36, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "s", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  camera_kinematics_add_noise(a0, a1, a2, a3);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_camera_kinematics_back(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.camera.kinematics:back";
  Held held;
  const Py_buffer *view;
  T3d a0;
  T3d a1;
  T3d result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_tuple(args[0], law, "turn", 3)
        && take_double(PyTuple_GetItem(args[0], 0), &a0.f0)
        && take_double(PyTuple_GetItem(args[0], 1), &a0.f1)
        && take_double(PyTuple_GetItem(args[0], 2), &a0.f2)
        && take_tuple(args[1], law, "vector", 3)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)))
    return let_go(&held);
  result = camera_kinematics_back(a0, a1);
  let_go(&held);
  return give_T3d(result);
}
static PyObject *py_camera_kinematics_begin_start(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.camera.kinematics:begin_start";
  Held held;
  const Py_buffer *view;
  camera_kinematics_Start * a0;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "s", true, 210, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  camera_kinematics_begin_start(a0);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_camera_kinematics_carried(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.camera.kinematics:carried";
  Held held;
  const Py_buffer *view;
  T3d a0;
  T3d a1;
  double a2;
  T3d a3;
  T2_T3d_ result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_tuple(args[0], law, "p", 3)
        && take_double(PyTuple_GetItem(args[0], 0), &a0.f0)
        && take_double(PyTuple_GetItem(args[0], 1), &a0.f1)
        && take_double(PyTuple_GetItem(args[0], 2), &a0.f2)
        && take_tuple(args[1], law, "v", 3)
        && take_double(PyTuple_GetItem(args[1], 0), &a1.f0)
        && take_double(PyTuple_GetItem(args[1], 1), &a1.f1)
        && take_double(PyTuple_GetItem(args[1], 2), &a1.f2)
        && take_double(args[2], &a2)
        && take_tuple(args[3], law, "turn", 3)
        && take_double(PyTuple_GetItem(args[3], 0), &a3.f0)
        && take_double(PyTuple_GetItem(args[3], 1), &a3.f1)
        && take_double(PyTuple_GetItem(args[3], 2), &a3.f2)))
    return let_go(&held);
  result = camera_kinematics_carried(a0, a1, a2, a3);
  let_go(&held);
  return give_T2_T3d_(result);
}
static PyObject *py_camera_kinematics_carry(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.camera.kinematics:carry";
  Held held;
  const Py_buffer *view;
  Vector a0;
  double a1;
  T3d a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "s", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_double(args[1], &a1)
        && take_tuple(args[2], law, "turn", 3)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.f2)))
    return let_go(&held);
  camera_kinematics_carry(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_camera_kinematics_carry_column(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.camera.kinematics:carry_column";
  Held held;
  const Py_buffer *view;
  camera_kinematics_Matrix * a0;
  int64_t a1;
  double a2;
  T3d a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "phi", true, 36, &view)
        && (a0 = view->buf, true)
        && take_int64_t(args[1], &a1)
        && take_double(args[2], &a2)
        && take_tuple(args[3], law, "turn", 3)
        && take_double(PyTuple_GetItem(args[3], 0), &a3.f0)
        && take_double(PyTuple_GetItem(args[3], 1), &a3.f1)
        && take_double(PyTuple_GetItem(args[3], 2), &a3.f2)))
    return let_go(&held);
  camera_kinematics_carry_column(a0, a1, a2, a3);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_camera_kinematics_factor(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.camera.kinematics:factor";
  Held held;
  const Py_buffer *view;
  camera_kinematics_Matrix * a0;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_memory(&held, args[0], law, "lower", true, 36, &view)
        && (a0 = view->buf, true)))
    return let_go(&held);
  result = camera_kinematics_factor(a0);
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_camera_kinematics_propagate(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.camera.kinematics:propagate";
  Held held;
  const Py_buffer *view;
  Vector a0;
  camera_kinematics_Matrix * a1;
  double a2;
  T3d a3;
  T2_T3d_ a4;
  double a5;
  double a6;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 7)
        && take_array(&held, args[0], law, "s", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_memory(&held, args[1], law, "p", true, 36, &view)
        && (a1 = view->buf, true)
        && take_double(args[2], &a2)
        && take_tuple(args[3], law, "turn", 3)
        && take_double(PyTuple_GetItem(args[3], 0), &a3.f0)
        && take_double(PyTuple_GetItem(args[3], 1), &a3.f1)
        && take_double(PyTuple_GetItem(args[3], 2), &a3.f2)
        && take_tuple(args[4], law, "a", 2)
        && take_tuple(PyTuple_GetItem(args[4], 0), law, "a", 3)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[4], 0), 0), &a4.f0.f0)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[4], 0), 1), &a4.f0.f1)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[4], 0), 2), &a4.f0.f2)
        && take_tuple(PyTuple_GetItem(args[4], 1), law, "a", 3)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[4], 1), 0), &a4.f1.f0)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[4], 1), 1), &a4.f1.f1)
        && take_double(PyTuple_GetItem(PyTuple_GetItem(args[4], 1), 2), &a4.f1.f2)
        && take_double(args[5], &a5)
        && take_double(args[6], &a6)))
    return let_go(&held);
  camera_kinematics_propagate(a0, a1, a2, a3, a4, a5, a6);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_camera_kinematics_push(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.camera.kinematics:push";
  Held held;
  const Py_buffer *view;
  Vector a0;
  double a1;
  T3d a2;
  T3d a3;
  T3d a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "s", 'd', 1, true, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_double(args[1], &a1)
        && take_tuple(args[2], law, "turn", 3)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.f2)
        && take_tuple(args[3], law, "before", 3)
        && take_double(PyTuple_GetItem(args[3], 0), &a3.f0)
        && take_double(PyTuple_GetItem(args[3], 1), &a3.f1)
        && take_double(PyTuple_GetItem(args[3], 2), &a3.f2)
        && take_tuple(args[4], law, "after", 3)
        && take_double(PyTuple_GetItem(args[4], 0), &a4.f0)
        && take_double(PyTuple_GetItem(args[4], 1), &a4.f1)
        && take_double(PyTuple_GetItem(args[4], 2), &a4.f2)))
    return let_go(&held);
  camera_kinematics_push(a0, a1, a2, a3, a4);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_camera_kinematics_solve(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.camera.kinematics:solve";
  Held held;
  const Py_buffer *view;
  camera_kinematics_Matrix * a0;
  Vector a1;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_memory(&held, args[0], law, "lower", false, 36, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "v", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  camera_kinematics_solve(a0, a1);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_camera_kinematics_started(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.camera.kinematics:started";
  Held held;
  const Py_buffer *view;
  camera_kinematics_Start * a0;
  Vector a1;
  camera_kinematics_Matrix * a2;
  double a3;
  double a4;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "s", true, 210, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "state", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_memory(&held, args[2], law, "spread", true, 36, &view)
        && (a2 = view->buf, true)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)))
    return let_go(&held);
  result = camera_kinematics_started(a0, a1, a2, a3, a4);
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_camera_kinematics_take_image(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.camera.kinematics:take_image";
  Held held;
  const Py_buffer *view;
  camera_kinematics_Start * a0;
  double a1;
  double a2;
  double a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "s", true, 210, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  camera_kinematics_take_image(a0, a1, a2, a3);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_camera_kinematics_turn_covariance(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.camera.kinematics:turn_covariance";
  Held held;
  const Py_buffer *view;
  camera_kinematics_Matrix * a0;
  double a1;
  T3d a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "p", true, 36, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_tuple(args[2], law, "turn", 3)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.f2)))
    return let_go(&held);
  camera_kinematics_turn_covariance(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_camera_point_filter_correct(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.camera.point_filter:correct";
  Held held;
  const Py_buffer *view;
  camera_point_filter_State * a0;
  double a1;
  double a2;
  int64_t a3;
  T3d a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "s", true, 268, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_int64_t(args[3], &a3)
        && take_tuple(args[4], law, "predicted", 3)
        && take_double(PyTuple_GetItem(args[4], 0), &a4.f0)
        && take_double(PyTuple_GetItem(args[4], 1), &a4.f1)
        && take_double(PyTuple_GetItem(args[4], 2), &a4.f2)))
    return let_go(&held);
  camera_point_filter_correct(a0, a1, a2, a3, a4);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_camera_point_filter_look(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.camera.point_filter:look";
  Held held;
  const Py_buffer *view;
  camera_point_filter_Memory * a0;
  double a1;
  double a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "memory", true, 274, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)))
    return let_go(&held);
  camera_point_filter_look(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_camera_point_filter_predict(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.camera.point_filter:predict";
  Held held;
  const Py_buffer *view;
  camera_point_filter_Memory * a0;
  double a1;
  T3d a2;
  T3d a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "memory", true, 274, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_tuple(args[2], law, "w", 3)
        && take_double(PyTuple_GetItem(args[2], 0), &a2.f0)
        && take_double(PyTuple_GetItem(args[2], 1), &a2.f1)
        && take_double(PyTuple_GetItem(args[2], 2), &a2.f2)
        && take_tuple(args[3], law, "a", 3)
        && take_double(PyTuple_GetItem(args[3], 0), &a3.f0)
        && take_double(PyTuple_GetItem(args[3], 1), &a3.f1)
        && take_double(PyTuple_GetItem(args[3], 2), &a3.f2)))
    return let_go(&held);
  camera_point_filter_predict(a0, a1, a2, a3);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_camera_point_filter_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.camera.point_filter:step";
  Held held;
  const Py_buffer *view;
  camera_point_filter_Memory * a0;
  Vector a1;
  camera_point_filter_Answer * a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "memory", true, 274, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "row", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_memory(&held, args[2], law, "out", true, 45, &view)
        && (a2 = view->buf, true)))
    return let_go(&held);
  camera_point_filter_step(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_camera_samples_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.camera.samples:step";
  Held held;
  const Py_buffer *view;
  camera_samples_Memory * a0;
  Vector a1;
  Vector a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "memory", true, 13, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "row", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "out", 'd', 1, true, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  camera_samples_step(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_camera_samples_usable(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.camera.samples:usable";
  Held held;
  const Py_buffer *view;
  camera_samples_CameraSample a0;
  double a1;
  double a2;
  double a3;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_tuple(args[0], law, "sample", 9)
        && take_double(PyTuple_GetItem(args[0], 0), &a0.t)
        && take_double(PyTuple_GetItem(args[0], 1), &a0.x)
        && take_double(PyTuple_GetItem(args[0], 2), &a0.y)
        && take_double(PyTuple_GetItem(args[0], 3), &a0.wx)
        && take_double(PyTuple_GetItem(args[0], 4), &a0.wy)
        && take_double(PyTuple_GetItem(args[0], 5), &a0.wz)
        && take_double(PyTuple_GetItem(args[0], 6), &a0.ax)
        && take_double(PyTuple_GetItem(args[0], 7), &a0.ay)
        && take_double(PyTuple_GetItem(args[0], 8), &a0.az)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)))
    return let_go(&held);
  result = camera_samples_usable(a0, a1, a2, a3);
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_camera_velocity_flow(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.camera.velocity:flow";
  Held held;
  const Py_buffer *view;
  double a0;
  double a1;
  double a2;
  double a3;
  double a4;
  double a5;
  T2d result;
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
  result = camera_velocity_flow(a0, a1, a2, a3, a4, a5);
  let_go(&held);
  return give_T2d(result);
}
static PyObject *py_camera_velocity_predict(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.camera.velocity:predict";
  Held held;
  const Py_buffer *view;
  camera_velocity_State * a0;
  double a1;
  double a2;
  double a3;
  double a4;
  double a5;
  double a6;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 7)
        && take_memory(&held, args[0], law, "s", true, 12, &view)
        && (a0 = view->buf, true)
        && take_double(args[1], &a1)
        && take_double(args[2], &a2)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)
        && take_double(args[5], &a5)
        && take_double(args[6], &a6)))
    return let_go(&held);
  camera_velocity_predict(a0, a1, a2, a3, a4, a5, a6);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_camera_velocity_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.camera.velocity:step";
  Held held;
  const Py_buffer *view;
  camera_velocity_Memory * a0;
  Vector a1;
  Vector a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "memory", true, 15, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "row", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "out", 'd', 1, true, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  camera_velocity_step(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_interconnected_persidskii_law_advance(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.interconnected.persidskii_law:advance";
  Held held;
  const Py_buffer *view;
  interconnected_persidskii_law_Memory * a0;
  interconnected_persidskii_law_Matrices a1;
  interconnected_persidskii_law_State a2;
  Vector a3;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_memory(&held, args[0], law, "memory", false, 8, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "m", 8)
        && take_array(&held, PyTuple_GetItem(args[1], 0), law, "m", 'd', 1, false, &view)
        && (a1.codes = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 1), law, "m", 'd', 2, false, &view)
        && (a1.inner = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 2), law, "m", 'd', 2, false, &view)
        && (a1.change = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 3), law, "m", 'd', 2, false, &view)
        && (a1.shown = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 4), law, "m", 'd', 2, false, &view)
        && (a1.missing = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 5), law, "m", 'd', 1, false, &view)
        && (a1.start = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 6), law, "m", 'd', 1, false, &view)
        && (a1.valued = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 7), law, "m", 'd', 1, false, &view)
        && (a1.first = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "s", 8)
        && take_array(&held, PyTuple_GetItem(args[2], 0), law, "s", 'd', 1, true, &view)
        && (a2.clock = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[2], 1), law, "s", 'd', 1, true, &view)
        && (a2.both = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[2], 2), law, "s", 'd', 1, true, &view)
        && (a2.total = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[2], 3), law, "s", 'd', 1, true, &view)
        && (a2.stage = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[2], 4), law, "s", 'd', 1, true, &view)
        && (a2.change = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[2], 5), law, "s", 'd', 1, true, &view)
        && (a2.first = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[2], 6), law, "s", 'd', 1, true, &view)
        && (a2.nonlinear = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[2], 7), law, "s", 'd', 1, true, &view)
        && (a2.absent = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "row", 'd', 1, false, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = interconnected_persidskii_law_advance(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_interconnected_persidskii_law_along(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.interconnected.persidskii_law:along";
  Held held;
  const Py_buffer *view;
  double a0;
  Vector a1;
  Vector a2;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_double(args[0], &a0)
        && take_array(&held, args[1], law, "row", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "vector", 'd', 1, false, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  result = interconnected_persidskii_law_along(a0, a1, a2);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_interconnected_persidskii_law_along_all(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.interconnected.persidskii_law:along_all";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Vector a1;
  Vector a2;
  Vector a3;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_array(&held, args[0], law, "row", 'd', 1, false, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "w", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "nonlinear", 'd', 1, false, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "inputs", 'd', 1, false, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  result = interconnected_persidskii_law_along_all(a0, a1, a2, a3);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_interconnected_persidskii_law_along_both(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.interconnected.persidskii_law:along_both";
  Held held;
  const Py_buffer *view;
  double a0;
  Vector a1;
  Vector a2;
  Vector a3;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_double(args[0], &a0)
        && take_array(&held, args[1], law, "row", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "one", 'd', 1, false, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "other", 'd', 1, false, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  result = interconnected_persidskii_law_along_both(a0, a1, a2, a3);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_interconnected_persidskii_law_bend(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.interconnected.persidskii_law:bend";
  Held held;
  const Py_buffer *view;
  interconnected_persidskii_law_Matrices a0;
  Vector a1;
  Vector a2;
  Vector a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_tuple(args[0], law, "m", 8)
        && take_array(&held, PyTuple_GetItem(args[0], 0), law, "m", 'd', 1, false, &view)
        && (a0.codes = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 1), law, "m", 'd', 2, false, &view)
        && (a0.inner = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 2), law, "m", 'd', 2, false, &view)
        && (a0.change = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 3), law, "m", 'd', 2, false, &view)
        && (a0.shown = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 4), law, "m", 'd', 2, false, &view)
        && (a0.missing = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 5), law, "m", 'd', 1, false, &view)
        && (a0.start = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 6), law, "m", 'd', 1, false, &view)
        && (a0.valued = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 7), law, "m", 'd', 1, false, &view)
        && (a0.first = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "w", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "inputs", 'd', 1, false, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "to", 'd', 1, true, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS interconnected_persidskii_law_bend(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_interconnected_persidskii_law_flow(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.interconnected.persidskii_law:flow";
  Held held;
  const Py_buffer *view;
  interconnected_persidskii_law_Matrices a0;
  interconnected_persidskii_law_State a1;
  Vector a2;
  double a3;
  double a4;
  bool a5;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_tuple(args[0], law, "m", 8)
        && take_array(&held, PyTuple_GetItem(args[0], 0), law, "m", 'd', 1, false, &view)
        && (a0.codes = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 1), law, "m", 'd', 2, false, &view)
        && (a0.inner = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 2), law, "m", 'd', 2, false, &view)
        && (a0.change = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 3), law, "m", 'd', 2, false, &view)
        && (a0.shown = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 4), law, "m", 'd', 2, false, &view)
        && (a0.missing = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 5), law, "m", 'd', 1, false, &view)
        && (a0.start = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 6), law, "m", 'd', 1, false, &view)
        && (a0.valued = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 7), law, "m", 'd', 1, false, &view)
        && (a0.first = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[1], law, "s", 8)
        && take_array(&held, PyTuple_GetItem(args[1], 0), law, "s", 'd', 1, true, &view)
        && (a1.clock = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 1), law, "s", 'd', 1, true, &view)
        && (a1.both = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 2), law, "s", 'd', 1, true, &view)
        && (a1.total = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 3), law, "s", 'd', 1, true, &view)
        && (a1.stage = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 4), law, "s", 'd', 1, true, &view)
        && (a1.change = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 5), law, "s", 'd', 1, true, &view)
        && (a1.first = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 6), law, "s", 'd', 1, true, &view)
        && (a1.nonlinear = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 7), law, "s", 'd', 1, true, &view)
        && (a1.absent = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "row", 'd', 1, false, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)
        && take_bool(args[5], &a5)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS interconnected_persidskii_law_flow(a0, a1, a2, a3, a4, a5); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_interconnected_persidskii_law_measure(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.interconnected.persidskii_law:measure";
  Held held;
  const Py_buffer *view;
  interconnected_persidskii_law_State a0;
  Vector a1;
  Vector a2;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_tuple(args[0], law, "s", 8)
        && take_array(&held, PyTuple_GetItem(args[0], 0), law, "s", 'd', 1, true, &view)
        && (a0.clock = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 1), law, "s", 'd', 1, true, &view)
        && (a0.both = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 2), law, "s", 'd', 1, true, &view)
        && (a0.total = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 3), law, "s", 'd', 1, true, &view)
        && (a0.stage = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 4), law, "s", 'd', 1, true, &view)
        && (a0.change = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 5), law, "s", 'd', 1, true, &view)
        && (a0.first = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 6), law, "s", 'd', 1, true, &view)
        && (a0.nonlinear = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 7), law, "s", 'd', 1, true, &view)
        && (a0.absent = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "last", 'd', 1, true, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "row", 'd', 1, false, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  interconnected_persidskii_law_measure(a0, a1, a2);
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_interconnected_persidskii_law_move(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.interconnected.persidskii_law:move";
  Held held;
  const Py_buffer *view;
  interconnected_persidskii_law_Memory * a0;
  interconnected_persidskii_law_Matrices a1;
  interconnected_persidskii_law_State a2;
  Vector a3;
  bool a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_memory(&held, args[0], law, "memory", false, 8, &view)
        && (a0 = view->buf, true)
        && take_tuple(args[1], law, "m", 8)
        && take_array(&held, PyTuple_GetItem(args[1], 0), law, "m", 'd', 1, false, &view)
        && (a1.codes = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 1), law, "m", 'd', 2, false, &view)
        && (a1.inner = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 2), law, "m", 'd', 2, false, &view)
        && (a1.change = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 3), law, "m", 'd', 2, false, &view)
        && (a1.shown = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 4), law, "m", 'd', 2, false, &view)
        && (a1.missing = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 5), law, "m", 'd', 1, false, &view)
        && (a1.start = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 6), law, "m", 'd', 1, false, &view)
        && (a1.valued = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 7), law, "m", 'd', 1, false, &view)
        && (a1.first = (Vector){view->buf, view->shape[0]}, true)
        && take_tuple(args[2], law, "s", 8)
        && take_array(&held, PyTuple_GetItem(args[2], 0), law, "s", 'd', 1, true, &view)
        && (a2.clock = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[2], 1), law, "s", 'd', 1, true, &view)
        && (a2.both = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[2], 2), law, "s", 'd', 1, true, &view)
        && (a2.total = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[2], 3), law, "s", 'd', 1, true, &view)
        && (a2.stage = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[2], 4), law, "s", 'd', 1, true, &view)
        && (a2.change = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[2], 5), law, "s", 'd', 1, true, &view)
        && (a2.first = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[2], 6), law, "s", 'd', 1, true, &view)
        && (a2.nonlinear = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[2], 7), law, "s", 'd', 1, true, &view)
        && (a2.absent = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "row", 'd', 1, false, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)
        && take_bool(args[4], &a4)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS interconnected_persidskii_law_move(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_interconnected_persidskii_law_replace(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.interconnected.persidskii_law:replace";
  Held held;
  const Py_buffer *view;
  interconnected_persidskii_law_Matrices a0;
  Vector a1;
  Vector a2;
  Vector a3;
  Vector a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_tuple(args[0], law, "m", 8)
        && take_array(&held, PyTuple_GetItem(args[0], 0), law, "m", 'd', 1, false, &view)
        && (a0.codes = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 1), law, "m", 'd', 2, false, &view)
        && (a0.inner = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 2), law, "m", 'd', 2, false, &view)
        && (a0.change = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 3), law, "m", 'd', 2, false, &view)
        && (a0.shown = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 4), law, "m", 'd', 2, false, &view)
        && (a0.missing = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 5), law, "m", 'd', 1, false, &view)
        && (a0.start = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 6), law, "m", 'd', 1, false, &view)
        && (a0.valued = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 7), law, "m", 'd', 1, false, &view)
        && (a0.first = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "w", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "inputs", 'd', 1, true, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "nonlinear", 'd', 1, true, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[4], law, "absent", 'd', 1, false, &view)
        && (a4 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS interconnected_persidskii_law_replace(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_interconnected_persidskii_law_slope(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.interconnected.persidskii_law:slope";
  Held held;
  const Py_buffer *view;
  interconnected_persidskii_law_Matrices a0;
  Vector a1;
  Vector a2;
  Vector a3;
  Vector a4;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_tuple(args[0], law, "m", 8)
        && take_array(&held, PyTuple_GetItem(args[0], 0), law, "m", 'd', 1, false, &view)
        && (a0.codes = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 1), law, "m", 'd', 2, false, &view)
        && (a0.inner = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 2), law, "m", 'd', 2, false, &view)
        && (a0.change = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 3), law, "m", 'd', 2, false, &view)
        && (a0.shown = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 4), law, "m", 'd', 2, false, &view)
        && (a0.missing = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 5), law, "m", 'd', 1, false, &view)
        && (a0.start = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 6), law, "m", 'd', 1, false, &view)
        && (a0.valued = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 7), law, "m", 'd', 1, false, &view)
        && (a0.first = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "w", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "inputs", 'd', 1, false, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "nonlinear", 'd', 1, true, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[4], law, "to", 'd', 1, true, &view)
        && (a4 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS interconnected_persidskii_law_slope(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_interconnected_persidskii_law_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.interconnected.persidskii_law:step";
  Held held;
  const Py_buffer *view;
  interconnected_persidskii_law_Memory * a0;
  Vector a1;
  Vector a2;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "memory", true, 8, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "row", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "out", 'd', 1, true, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  result = interconnected_persidskii_law_step(a0, a1, a2);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_loop__camera_depth_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.stage:loop_into (pointpred_observers.camera.depth:step)";
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
        && take_array(&held, args[4], law, "out", 'd', 2, true, &view)
        && (a4 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS loop__camera_depth_step(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_loop__camera_point_filter_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.stage:loop_into (pointpred_observers.camera.point_filter:step)";
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
        && take_array(&held, args[4], law, "out", 'd', 2, true, &view)
        && (a4 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS loop__camera_point_filter_step(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_loop__camera_samples_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.stage:loop_into (pointpred_observers.camera.samples:step)";
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
        && take_array(&held, args[4], law, "out", 'd', 2, true, &view)
        && (a4 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS loop__camera_samples_step(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_loop__camera_velocity_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred.stage:loop_into (pointpred_observers.camera.velocity:step)";
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
        && take_array(&held, args[4], law, "out", 'd', 2, true, &view)
        && (a4 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS loop__camera_velocity_step(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_plants_boxes_weigh(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.plants.boxes:weigh";
  Held held;
  const Py_buffer *view;
  Table a0;
  Vector a1;
  Vector a2;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_array(&held, args[0], law, "axes", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && has_columns(law, "axes", a0.m, 2)
        && take_array(&held, args[1], law, "p", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "weights", 'd', 1, true, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = plants_boxes_weigh(a0, a1, a2); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_plants_nonlinearity_value(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.plants.nonlinearity:value";
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
  result = plants_nonlinearity_value(a0, a1);
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_regressors_gradient_bend(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.regressors.gradient:bend";
  Held held;
  const Py_buffer *view;
  double a0;
  regressors_gradient_Parts a1;
  Vector a2;
  double a3;
  double a4;
  double a5;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 6)
        && take_double(args[0], &a0)
        && take_tuple(args[1], law, "s", 9)
        && take_array(&held, PyTuple_GetItem(args[1], 0), law, "s", 'd', 1, true, &view)
        && (a1.start = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 1), law, "s", 'd', 2, true, &view)
        && (a1.gain = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 2), law, "s", 'd', 1, true, &view)
        && (a1.clock = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 3), law, "s", 'd', 1, true, &view)
        && (a1.theta = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 4), law, "s", 'd', 1, true, &view)
        && (a1.last = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 5), law, "s", 'd', 1, true, &view)
        && (a1.between = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 6), law, "s", 'd', 1, true, &view)
        && (a1.stage = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 7), law, "s", 'd', 1, true, &view)
        && (a1.change = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 8), law, "s", 'd', 1, true, &view)
        && (a1.total = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "new", 'd', 1, false, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)
        && take_double(args[3], &a3)
        && take_double(args[4], &a4)
        && take_double(args[5], &a5)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS regressors_gradient_bend(a0, a1, a2, a3, a4, a5); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_regressors_gradient_flow(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.regressors.gradient:flow";
  Held held;
  const Py_buffer *view;
  regressors_gradient_Parts a0;
  double a1;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_tuple(args[0], law, "s", 9)
        && take_array(&held, PyTuple_GetItem(args[0], 0), law, "s", 'd', 1, true, &view)
        && (a0.start = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 1), law, "s", 'd', 2, true, &view)
        && (a0.gain = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 2), law, "s", 'd', 1, true, &view)
        && (a0.clock = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 3), law, "s", 'd', 1, true, &view)
        && (a0.theta = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 4), law, "s", 'd', 1, true, &view)
        && (a0.last = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 5), law, "s", 'd', 1, true, &view)
        && (a0.between = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 6), law, "s", 'd', 1, true, &view)
        && (a0.stage = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 7), law, "s", 'd', 1, true, &view)
        && (a0.change = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 8), law, "s", 'd', 1, true, &view)
        && (a0.total = (Vector){view->buf, view->shape[0]}, true)
        && take_double(args[1], &a1)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS regressors_gradient_flow(a0, a1); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_regressors_gradient_jump(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.regressors.gradient:jump";
  Held held;
  const Py_buffer *view;
  regressors_gradient_Parts a0;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 1)
        && take_tuple(args[0], law, "s", 9)
        && take_array(&held, PyTuple_GetItem(args[0], 0), law, "s", 'd', 1, true, &view)
        && (a0.start = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 1), law, "s", 'd', 2, true, &view)
        && (a0.gain = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 2), law, "s", 'd', 1, true, &view)
        && (a0.clock = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 3), law, "s", 'd', 1, true, &view)
        && (a0.theta = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 4), law, "s", 'd', 1, true, &view)
        && (a0.last = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 5), law, "s", 'd', 1, true, &view)
        && (a0.between = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 6), law, "s", 'd', 1, true, &view)
        && (a0.stage = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 7), law, "s", 'd', 1, true, &view)
        && (a0.change = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[0], 8), law, "s", 'd', 1, true, &view)
        && (a0.total = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS regressors_gradient_jump(a0); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_regressors_gradient_slope(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.regressors.gradient:slope";
  Held held;
  const Py_buffer *view;
  double a0;
  regressors_gradient_Parts a1;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_double(args[0], &a0)
        && take_tuple(args[1], law, "s", 9)
        && take_array(&held, PyTuple_GetItem(args[1], 0), law, "s", 'd', 1, true, &view)
        && (a1.start = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 1), law, "s", 'd', 2, true, &view)
        && (a1.gain = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 2), law, "s", 'd', 1, true, &view)
        && (a1.clock = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 3), law, "s", 'd', 1, true, &view)
        && (a1.theta = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 4), law, "s", 'd', 1, true, &view)
        && (a1.last = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 5), law, "s", 'd', 1, true, &view)
        && (a1.between = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 6), law, "s", 'd', 1, true, &view)
        && (a1.stage = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 7), law, "s", 'd', 1, true, &view)
        && (a1.change = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, PyTuple_GetItem(args[1], 8), law, "s", 'd', 1, true, &view)
        && (a1.total = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS regressors_gradient_slope(a0, a1); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_regressors_gradient_steepness(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.regressors.gradient:steepness";
  Held held;
  const Py_buffer *view;
  Table a0;
  Table a1;
  double result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 2)
        && take_array(&held, args[0], law, "d", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[1], law, "gain", 'd', 2, false, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = regressors_gradient_steepness(a0, a1); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyFloat_FromDouble(result);
}
static PyObject *py_regressors_gradient_step(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.regressors.gradient:step";
  Held held;
  const Py_buffer *view;
  regressors_gradient_Memory * a0;
  Vector a1;
  Vector a2;
  int64_t result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 3)
        && take_memory(&held, args[0], law, "memory", true, 6, &view)
        && (a0 = view->buf, true)
        && take_array(&held, args[1], law, "row", 'd', 1, false, &view)
        && (a1 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[2], law, "out", 'd', 1, true, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  result = regressors_gradient_step(a0, a1, a2);
  let_go(&held);
  return PyLong_FromLongLong(result);
}
static PyObject *py_unknown_input_stage_estimated(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.unknown_input.stage:estimated";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Table a1;
  double a2;
  Table a3;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 4)
        && take_array(&held, args[0], law, "block", 'd', 1, false, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "ends", 'd', 2, false, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_double(args[2], &a2)
        && take_array(&held, args[3], law, "space", 'd', 2, true, &view)
        && (a3 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS unknown_input_stage_estimated(a0, a1, a2, a3); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyObject *py_unknown_input_stage_mix(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.unknown_input.stage:mix";
  Held held;
  const Py_buffer *view;
  Table a0;
  Table a1;
  Vector a2;
  Vector a3;
  Vector a4;
  bool result;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 5)
        && take_array(&held, args[0], law, "corners", 'd', 2, false, &view)
        && (a0 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[1], law, "axes", 'd', 2, false, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[2], law, "p", 'd', 1, false, &view)
        && (a2 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[3], law, "weights", 'd', 1, true, &view)
        && (a3 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[4], law, "block", 'd', 1, true, &view)
        && (a4 = (Vector){view->buf, view->shape[0]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS result = unknown_input_stage_mix(a0, a1, a2, a3, a4); Py_END_ALLOW_THREADS
  let_go(&held);
  return PyBool_FromLong(result);
}
static PyObject *py_unknown_input_stage_push(PyObject *self, PyObject *const *args, Py_ssize_t count) {
  static const char law[] = "pointpred_observers.unknown_input.stage:push";
  Held held;
  const Py_buffer *view;
  Vector a0;
  Table a1;
  Table a2;
  double a3;
  int64_t a4;
  double a5;
  Table a6;
  (void)self, (void)view;
  held.count = 0;
  if (!(counted(law, count, 7)
        && take_array(&held, args[0], law, "block", 'd', 1, false, &view)
        && (a0 = (Vector){view->buf, view->shape[0]}, true)
        && take_array(&held, args[1], law, "c", 'd', 2, false, &view)
        && (a1 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_array(&held, args[2], law, "ends", 'd', 2, false, &view)
        && (a2 = (Table){view->buf, view->shape[0], view->shape[1]}, true)
        && take_double(args[3], &a3)
        && take_int64_t(args[4], &a4)
        && take_double(args[5], &a5)
        && take_array(&held, args[6], law, "space", 'd', 2, true, &view)
        && (a6 = (Table){view->buf, view->shape[0], view->shape[1]}, true)))
    return let_go(&held);
  Py_BEGIN_ALLOW_THREADS unknown_input_stage_push(a0, a1, a2, a3, a4, a5, a6); Py_END_ALLOW_THREADS
  let_go(&held);
  return (Py_IncRef(Py_None), Py_None);
}
static PyMethodDef methods[] = {
  {"pointpred_observers.camera.depth:carry", (PyCFunction)(void (*)(void))py_camera_depth_carry, METH_FASTCALL, NULL},
  {"pointpred_observers.camera.depth:inside", (PyCFunction)(void (*)(void))py_camera_depth_inside, METH_FASTCALL, NULL},
  {"pointpred_observers.camera.depth:rate", (PyCFunction)(void (*)(void))py_camera_depth_rate, METH_FASTCALL, NULL},
  {"pointpred_observers.camera.depth:step", (PyCFunction)(void (*)(void))py_camera_depth_step, METH_FASTCALL, NULL},
  {"pointpred_observers.camera.kinematics:add_noise", (PyCFunction)(void (*)(void))py_camera_kinematics_add_noise, METH_FASTCALL, NULL},
  {"pointpred_observers.camera.kinematics:back", (PyCFunction)(void (*)(void))py_camera_kinematics_back, METH_FASTCALL, NULL},
  {"pointpred_observers.camera.kinematics:begin_start", (PyCFunction)(void (*)(void))py_camera_kinematics_begin_start, METH_FASTCALL, NULL},
  {"pointpred_observers.camera.kinematics:carried", (PyCFunction)(void (*)(void))py_camera_kinematics_carried, METH_FASTCALL, NULL},
  {"pointpred_observers.camera.kinematics:carry", (PyCFunction)(void (*)(void))py_camera_kinematics_carry, METH_FASTCALL, NULL},
  {"pointpred_observers.camera.kinematics:carry_column", (PyCFunction)(void (*)(void))py_camera_kinematics_carry_column, METH_FASTCALL, NULL},
  {"pointpred_observers.camera.kinematics:factor", (PyCFunction)(void (*)(void))py_camera_kinematics_factor, METH_FASTCALL, NULL},
  {"pointpred_observers.camera.kinematics:propagate", (PyCFunction)(void (*)(void))py_camera_kinematics_propagate, METH_FASTCALL, NULL},
  {"pointpred_observers.camera.kinematics:push", (PyCFunction)(void (*)(void))py_camera_kinematics_push, METH_FASTCALL, NULL},
  {"pointpred_observers.camera.kinematics:solve", (PyCFunction)(void (*)(void))py_camera_kinematics_solve, METH_FASTCALL, NULL},
  {"pointpred_observers.camera.kinematics:started", (PyCFunction)(void (*)(void))py_camera_kinematics_started, METH_FASTCALL, NULL},
  {"pointpred_observers.camera.kinematics:take_image", (PyCFunction)(void (*)(void))py_camera_kinematics_take_image, METH_FASTCALL, NULL},
  {"pointpred_observers.camera.kinematics:turn_covariance", (PyCFunction)(void (*)(void))py_camera_kinematics_turn_covariance, METH_FASTCALL, NULL},
  {"pointpred_observers.camera.point_filter:correct", (PyCFunction)(void (*)(void))py_camera_point_filter_correct, METH_FASTCALL, NULL},
  {"pointpred_observers.camera.point_filter:look", (PyCFunction)(void (*)(void))py_camera_point_filter_look, METH_FASTCALL, NULL},
  {"pointpred_observers.camera.point_filter:predict", (PyCFunction)(void (*)(void))py_camera_point_filter_predict, METH_FASTCALL, NULL},
  {"pointpred_observers.camera.point_filter:step", (PyCFunction)(void (*)(void))py_camera_point_filter_step, METH_FASTCALL, NULL},
  {"pointpred_observers.camera.samples:step", (PyCFunction)(void (*)(void))py_camera_samples_step, METH_FASTCALL, NULL},
  {"pointpred_observers.camera.samples:usable", (PyCFunction)(void (*)(void))py_camera_samples_usable, METH_FASTCALL, NULL},
  {"pointpred_observers.camera.velocity:flow", (PyCFunction)(void (*)(void))py_camera_velocity_flow, METH_FASTCALL, NULL},
  {"pointpred_observers.camera.velocity:predict", (PyCFunction)(void (*)(void))py_camera_velocity_predict, METH_FASTCALL, NULL},
  {"pointpred_observers.camera.velocity:step", (PyCFunction)(void (*)(void))py_camera_velocity_step, METH_FASTCALL, NULL},
  {"pointpred_observers.interconnected.persidskii_law:advance", (PyCFunction)(void (*)(void))py_interconnected_persidskii_law_advance, METH_FASTCALL, NULL},
  {"pointpred_observers.interconnected.persidskii_law:along", (PyCFunction)(void (*)(void))py_interconnected_persidskii_law_along, METH_FASTCALL, NULL},
  {"pointpred_observers.interconnected.persidskii_law:along_all", (PyCFunction)(void (*)(void))py_interconnected_persidskii_law_along_all, METH_FASTCALL, NULL},
  {"pointpred_observers.interconnected.persidskii_law:along_both", (PyCFunction)(void (*)(void))py_interconnected_persidskii_law_along_both, METH_FASTCALL, NULL},
  {"pointpred_observers.interconnected.persidskii_law:bend", (PyCFunction)(void (*)(void))py_interconnected_persidskii_law_bend, METH_FASTCALL, NULL},
  {"pointpred_observers.interconnected.persidskii_law:flow", (PyCFunction)(void (*)(void))py_interconnected_persidskii_law_flow, METH_FASTCALL, NULL},
  {"pointpred_observers.interconnected.persidskii_law:measure", (PyCFunction)(void (*)(void))py_interconnected_persidskii_law_measure, METH_FASTCALL, NULL},
  {"pointpred_observers.interconnected.persidskii_law:move", (PyCFunction)(void (*)(void))py_interconnected_persidskii_law_move, METH_FASTCALL, NULL},
  {"pointpred_observers.interconnected.persidskii_law:replace", (PyCFunction)(void (*)(void))py_interconnected_persidskii_law_replace, METH_FASTCALL, NULL},
  {"pointpred_observers.interconnected.persidskii_law:slope", (PyCFunction)(void (*)(void))py_interconnected_persidskii_law_slope, METH_FASTCALL, NULL},
  {"pointpred_observers.interconnected.persidskii_law:step", (PyCFunction)(void (*)(void))py_interconnected_persidskii_law_step, METH_FASTCALL, NULL},
  {"pointpred.stage:loop_into (pointpred_observers.camera.depth:step)", (PyCFunction)(void (*)(void))py_loop__camera_depth_step, METH_FASTCALL, NULL},
  {"pointpred.stage:loop_into (pointpred_observers.camera.point_filter:step)", (PyCFunction)(void (*)(void))py_loop__camera_point_filter_step, METH_FASTCALL, NULL},
  {"pointpred.stage:loop_into (pointpred_observers.camera.samples:step)", (PyCFunction)(void (*)(void))py_loop__camera_samples_step, METH_FASTCALL, NULL},
  {"pointpred.stage:loop_into (pointpred_observers.camera.velocity:step)", (PyCFunction)(void (*)(void))py_loop__camera_velocity_step, METH_FASTCALL, NULL},
  {"pointpred_observers.plants.boxes:weigh", (PyCFunction)(void (*)(void))py_plants_boxes_weigh, METH_FASTCALL, NULL},
  {"pointpred_observers.plants.nonlinearity:value", (PyCFunction)(void (*)(void))py_plants_nonlinearity_value, METH_FASTCALL, NULL},
  {"pointpred_observers.regressors.gradient:bend", (PyCFunction)(void (*)(void))py_regressors_gradient_bend, METH_FASTCALL, NULL},
  {"pointpred_observers.regressors.gradient:flow", (PyCFunction)(void (*)(void))py_regressors_gradient_flow, METH_FASTCALL, NULL},
  {"pointpred_observers.regressors.gradient:jump", (PyCFunction)(void (*)(void))py_regressors_gradient_jump, METH_FASTCALL, NULL},
  {"pointpred_observers.regressors.gradient:slope", (PyCFunction)(void (*)(void))py_regressors_gradient_slope, METH_FASTCALL, NULL},
  {"pointpred_observers.regressors.gradient:steepness", (PyCFunction)(void (*)(void))py_regressors_gradient_steepness, METH_FASTCALL, NULL},
  {"pointpred_observers.regressors.gradient:step", (PyCFunction)(void (*)(void))py_regressors_gradient_step, METH_FASTCALL, NULL},
  {"pointpred_observers.unknown_input.stage:estimated", (PyCFunction)(void (*)(void))py_unknown_input_stage_estimated, METH_FASTCALL, NULL},
  {"pointpred_observers.unknown_input.stage:mix", (PyCFunction)(void (*)(void))py_unknown_input_stage_mix, METH_FASTCALL, NULL},
  {"pointpred_observers.unknown_input.stage:push", (PyCFunction)(void (*)(void))py_unknown_input_stage_push, METH_FASTCALL, NULL},
  {NULL, NULL, 0, NULL},
};
extern const char digest_of_laws[];
static PyModuleDef_Slot slots[] = {{0, NULL}};
static PyModuleDef definition = {
  PyModuleDef_HEAD_INIT, "_laws", digest_of_laws, 0, methods, slots, NULL, NULL, NULL,
};
PyMODINIT_FUNC PyInit__laws(void) { return PyModuleDef_Init(&definition); }
