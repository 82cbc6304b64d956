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
