/* The part of Python's stable ABI (3.11 and later) that the glue needs, so that no headers of Python must be installed. */
#include <stddef.h>
#include <stdint.h>

#define PyMODINIT_FUNC __attribute__((visibility("default"))) PyObject *

typedef intptr_t Py_ssize_t;
typedef struct { Py_ssize_t owners; struct PyTypeObject *type; } PyObject;
typedef struct PyTypeObject PyTypeObject;
typedef struct PyThreadState PyThreadState;
typedef struct { const char *name; void *function; int flags; const char *doc; } PyMethodDef;
typedef struct {
    PyObject head;
    void *init;
    Py_ssize_t index;
    PyObject *copy;
    const char *name, *doc;
    Py_ssize_t size;
    PyMethodDef *methods;
    void *slots, *traverse, *clear, *free;
} PyModuleDef;
typedef struct { int slot; void *function; } PyType_Slot;
typedef struct { const char *name; int basicsize, itemsize; unsigned flags; PyType_Slot *slots; } PyType_Spec;
typedef struct {
    void *buf;
    PyObject *obj;
    Py_ssize_t len, itemsize;
    int readonly, ndim;
    char *format;
    Py_ssize_t *shape, *strides, *suboffsets;
    void *internal;
} Py_buffer;

enum { METH_FASTCALL = 0x80, Py_bf_getbuffer = 1, Py_tp_dealloc = 52, Py_tp_free = 74 };
enum { PyBUF_WRITABLE = 1, PyBUF_FORMAT = 4, PyBUF_C_CONTIGUOUS = 0x38 };

extern PyObject _Py_NoneStruct, *PyExc_TypeError;
void Py_IncRef(PyObject *), Py_DecRef(PyObject *), PyErr_Clear(void), PyBuffer_Release(Py_buffer *);
void PyEval_RestoreThread(PyThreadState *), *PyType_GetSlot(PyTypeObject *, int);
PyThreadState *PyEval_SaveThread(void);
PyObject *PyErr_Occurred(void), *PyErr_NoMemory(void), *PyErr_Format(PyObject *, const char *, ...);
PyObject *PyImport_ImportModule(const char *), *PyObject_GetAttrString(PyObject *, const char *);
PyObject *PyObject_CallFunctionObjArgs(PyObject *, ...), *PyNumber_Index(PyObject *), *_PyObject_New(PyTypeObject *);
PyObject *PyFloat_FromDouble(double), *PyBool_FromLong(long), *PyTuple_Pack(Py_ssize_t, ...);
PyObject *PyTuple_GetItem(PyObject *, Py_ssize_t);
Py_ssize_t PyTuple_Size(PyObject *);
PyObject *PyLong_FromLongLong(long long), *PyLong_FromUnsignedLongLong(unsigned long long);
PyObject *PyType_FromSpec(PyType_Spec *), *PyModule_Create2(PyModuleDef *, int);
double PyFloat_AsDouble(PyObject *);
long long PyLong_AsLongLong(PyObject *);
unsigned long long PyLong_AsUnsignedLongLong(PyObject *);
int PyObject_IsTrue(PyObject *), PyObject_GetBuffer(PyObject *, Py_buffer *, int);
