/* What the laws use of Python's stable ABI (3.11 and later), declared here: compiling them needs no headers of Python, which many
   systems do not install, and one machine can compile for all. tests/architecture/test_building.py compares it with Python.h. */
#ifndef POINTPRED_ABI3_H
#define POINTPRED_ABI3_H

#include <stddef.h>
#include <stdint.h>

#ifdef _WIN32
#define API extern __declspec(dllimport)
#define PyMODINIT_FUNC __declspec(dllexport) PyObject *
#else
#define API extern
#define PyMODINIT_FUNC __attribute__((visibility("default"))) PyObject *
#endif

typedef intptr_t Py_ssize_t;
typedef struct _typeobject PyTypeObject;
typedef struct _ts PyThreadState;
typedef struct _object {
  Py_ssize_t ob_refcnt;
  PyTypeObject *ob_type;
} PyObject;

typedef PyObject *(*PyCFunction)(PyObject *, PyObject *);
typedef struct {
  const char *ml_name;
  PyCFunction ml_meth;
  int ml_flags;
  const char *ml_doc;
} PyMethodDef;
#define METH_FASTCALL 0x0080

typedef struct {
  int slot;
  void *value;
} PyModuleDef_Slot;
typedef struct {
  struct {
    PyObject ob_base;
    PyObject *(*m_init)(void);
    Py_ssize_t m_index;
    PyObject *m_copy;
  } m_base;
  const char *m_name;
  const char *m_doc;
  Py_ssize_t m_size;
  PyMethodDef *m_methods;
  PyModuleDef_Slot *m_slots;
  int (*m_traverse)(PyObject *, int (*)(PyObject *, void *), void *);
  int (*m_clear)(PyObject *);
  void (*m_free)(void *);
} PyModuleDef;
#define PyModuleDef_HEAD_INIT {{1, NULL}, NULL, 0, NULL}
API PyObject *PyModuleDef_Init(PyModuleDef *);

typedef struct {
  void *buf;
  PyObject *obj;
  Py_ssize_t len;
  Py_ssize_t itemsize;
  int readonly;
  int ndim;
  char *format;
  Py_ssize_t *shape;
  Py_ssize_t *strides;
  Py_ssize_t *suboffsets;
  void *internal;
} Py_buffer;
#define PyBUF_WRITABLE 0x0001
#define PyBUF_FORMAT 0x0004
#define PyBUF_ND 0x0008
#define PyBUF_STRIDES (0x0010 | PyBUF_ND)
#define PyBUF_C_CONTIGUOUS (0x0020 | PyBUF_STRIDES)
API int PyObject_CheckBuffer(PyObject *);
API int PyObject_GetBuffer(PyObject *, Py_buffer *, int);
API void PyBuffer_Release(Py_buffer *);

API PyObject *PyFloat_FromDouble(double);
API double PyFloat_AsDouble(PyObject *);
API PyObject *PyLong_FromLongLong(long long);
API long long PyLong_AsLongLong(PyObject *);
API PyObject *PyBool_FromLong(long);
API int PyObject_IsTrue(PyObject *);
API PyObject *PyTuple_New(Py_ssize_t);
API Py_ssize_t PyTuple_Size(PyObject *);
API PyObject *PyTuple_GetItem(PyObject *, Py_ssize_t);
API int PyTuple_SetItem(PyObject *, Py_ssize_t, PyObject *);
API unsigned long PyType_GetFlags(PyTypeObject *);
#define PyTuple_Check(one) ((PyType_GetFlags((one)->ob_type) & (1UL << 26)) != 0)

API PyObject *PyObject_GetAttrString(PyObject *, const char *);
API void Py_IncRef(PyObject *);
API void Py_DecRef(PyObject *);
API PyObject _Py_NoneStruct;
#define Py_None (&_Py_NoneStruct)

API PyObject *PyErr_Occurred(void);
API void PyErr_Clear(void);
API PyObject *PyErr_Format(PyObject *, const char *, ...);
API PyObject *PyExc_TypeError;

API PyThreadState *PyEval_SaveThread(void);
API void PyEval_RestoreThread(PyThreadState *);
#define Py_BEGIN_ALLOW_THREADS { PyThreadState *_save = PyEval_SaveThread();
#define Py_END_ALLOW_THREADS PyEval_RestoreThread(_save); }

#endif
