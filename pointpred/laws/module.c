#include "abi3.h"
#include "laws.h"

static PyObject *py_total(PyObject *module, PyObject *const *args, Py_ssize_t count) {
  Py_buffer values;
  (void)module;
  if (count != 1) {
    PyErr_SetString(PyExc_TypeError, "total takes one array");
    return NULL;
  }
  if (PyObject_GetBuffer(args[0], &values, PyBUF_C_CONTIGUOUS | PyBUF_FORMAT)) return NULL;
  if (values.itemsize != 8 || values.format[0] != 'd' || values.format[1] != 0) {
    PyBuffer_Release(&values);
    PyErr_SetString(PyExc_TypeError, "total takes an array of float64");
    return NULL;
  }
  double sum;
  Py_BEGIN_ALLOW_THREADS sum = total(values.buf, values.len / 8);
  Py_END_ALLOW_THREADS PyBuffer_Release(&values);
  return PyFloat_FromDouble(sum);
}

static PyMethodDef methods[] = {{"total", (PyCFunction)(void *)py_total, METH_FASTCALL, NULL}, {NULL, NULL, 0, NULL}};
static PyModuleDef_Slot slots[] = {{0, NULL}};
static PyModuleDef definition = {PyModuleDef_HEAD_INIT, "_laws", NULL, 0, methods, slots, NULL, NULL, NULL};

PyMODINIT_FUNC PyInit__laws(void) { return PyModuleDef_Init(&definition); }
