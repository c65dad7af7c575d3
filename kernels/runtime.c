/* What compiled kernels need of a runtime, and what Python needs to call them.

   A kernel's native function, as Numba lays it out: int f(result *, void **error, arguments...). An array is handed over
   as memory, parent, items, item size, data, shape..., strides...; memory and parent are NULL for what the caller owns.
   A result that is an array is a struct of the same; its memory has one owner, who is now us.
   Only the stable ABI of Python 3.11 is used: one file serves every later Python. */
#include "python.h"
#include <stdlib.h>
#include <string.h>

/* Memory that kernels ask for: a head, and 64 bytes further at the earliest what it heads. */

typedef struct {
    size_t owners;
    void (*end)(void *, size_t, void *);
    void *end_info;
    void *data;
    size_t size;
    void *allocator;
} Memory;

void *NRT_Allocate(size_t size) { return malloc(size ? size : 1); }

void NRT_Free(void *data) { free(data); }

void NRT_MemInfo_call_dtor(Memory *m) {
    if (m->end) m->end(m->data, m->size, m->end_info);
    free(m);
}

Memory *NRT_MemInfo_alloc_aligned(size_t size, unsigned align) {
    Memory *m = malloc(sizeof(Memory) + size + 2 * (size_t)align);
    if (!m) return NULL;
    uintptr_t at = (uintptr_t)(m + 1);
    at += align ? (align - at % align) % align : 0;
    *m = (Memory){1, NULL, NULL, (void *)at, size, NULL};
    return m;
}

Memory *NRT_MemInfo_alloc(size_t size) { return NRT_MemInfo_alloc_aligned(size, 16); }

/* Lists: their data moves as they grow. */

static void end_list(void *data, size_t size, void *info) {
    if (info) ((void (*)(void *, size_t, void *))info)(data, size, NULL);
    free(data);
}

Memory *NRT_MemInfo_new_varsize(size_t size) {
    Memory *m = malloc(sizeof(Memory));
    void *data = malloc(size ? size : 1);
    if (!m || !data) {
        free(m);
        free(data);
        return NULL;
    }
    *m = (Memory){1, end_list, NULL, data, size, NULL};
    return m;
}

Memory *NRT_MemInfo_new_varsize_dtor(size_t size, void *end) {
    Memory *m = NRT_MemInfo_new_varsize(size);
    if (m) m->end_info = end;
    return m;
}

void *NRT_MemInfo_varsize_alloc(Memory *m, size_t size) {
    m->data = malloc(size ? size : 1);
    m->size = size;
    return m->data;
}

void *NRT_MemInfo_varsize_realloc(Memory *m, size_t size) {
    void *data = realloc(m->data, size ? size : 1);
    if (!data) return NULL;
    m->data = data;
    m->size = size;
    return data;
}

void NRT_MemInfo_varsize_free(Memory *m, void *data) {
    free(data);
    if (m->data == data) m->data = NULL;
}

static void let_go(Memory *m) {
    if (m && __atomic_sub_fetch(&m->owners, 1, __ATOMIC_ACQ_REL) == 0) NRT_MemInfo_call_dtor(m);
}

/* Reshaping in place: only arrays in C order are ever reshaped by kernels, and those always can be. */

int numba_attempt_nocopy_reshape(intptr_t axes, const intptr_t *shape, const intptr_t *strides, intptr_t new_axes,
                                 const intptr_t *new_shape, intptr_t *new_strides, intptr_t item, int fortran) {
    intptr_t old = 1, made = 1, step = item;
    for (intptr_t k = axes - 1; k >= 0; k--) {
        if (fortran || (shape[k] != 1 && strides[k] != item * old)) return 0;
        old *= shape[k];
    }
    for (intptr_t k = 0; k < new_axes; k++) made *= new_shape[k];
    if (made != old) return 0;
    for (intptr_t k = new_axes - 1; k >= 0; k--) {
        new_strides[k] = step;
        step *= new_shape[k];
    }
    return 1;
}

/* A block: what a kernel has allocated, seen by Python as a buffer. */

typedef struct {
    PyObject head;
    Memory *memory;
    void *data;
    int axes;
    const char *format;
    Py_ssize_t item, shape[4], strides[4];
} Block;

static PyObject *block_type, *asarray;

static int block_buffer(PyObject *self, Py_buffer *view, int flags) {
    Block *b = (Block *)self;
    (void)flags;
    view->buf = b->data;
    view->len = b->item;
    for (int k = 0; k < b->axes; k++) view->len *= b->shape[k];
    view->itemsize = b->item;
    view->readonly = 0;
    view->ndim = b->axes;
    view->format = (char *)b->format;
    view->shape = b->shape;
    view->strides = b->strides;
    view->suboffsets = NULL;
    view->internal = NULL;
    Py_IncRef(self);
    view->obj = self;
    return 0;
}

static void block_end(PyObject *self) {
    PyTypeObject *type = self->type;
    let_go(((Block *)self)->memory);
    ((void (*)(void *))PyType_GetSlot(type, Py_tp_free))(self);
    Py_DecRef((PyObject *)type);
}

static PyType_Slot block_slots[] = {{Py_bf_getbuffer, block_buffer}, {Py_tp_dealloc, block_end}, {0, NULL}};
static PyType_Spec block_spec = {"tambour.Block", sizeof(Block), 0, 0, block_slots};

static PyObject *array(Memory *memory, void *data, int axes, const char *format, size_t item, const intptr_t *shape,
                       const intptr_t *strides) {
    Block *b = (Block *)_PyObject_New((PyTypeObject *)block_type);
    if (!b) {
        let_go(memory);
        return NULL;
    }
    b->memory = memory;
    b->data = data;
    b->axes = axes;
    b->format = format;
    b->item = item;
    for (int k = 0; k < axes; k++) {
        b->shape[k] = shape[k];
        b->strides[k] = strides[k];
    }
    PyObject *made = PyObject_CallFunctionObjArgs(asarray, (PyObject *)b, NULL);
    Py_DecRef((PyObject *)b);
    return made;
}

/* Arguments. Each gives 0, or -1 with an error that names the kernel and the argument. */

static int wrong(const char *kernel, const char *name, const char *wanted, PyObject *given) {
    PyObject *type = PyObject_GetAttrString((PyObject *)given->type, "__name__");
    PyErr_Clear();
    PyErr_Format(PyExc_TypeError, "%s: %s must be %s, not %S", kernel, name, wanted, type ? type : &_Py_NoneStruct);
    if (type) Py_DecRef(type);
    return -1;
}

static int take(Py_buffer *view, PyObject *given, const char *formats, int axes, const char *kernel, const char *name,
                const char *wanted) {
    if (PyObject_GetBuffer(given, view, PyBUF_C_CONTIGUOUS | PyBUF_WRITABLE | PyBUF_FORMAT))
        return wrong(kernel, name, wanted, given);
    if (view->ndim == axes && view->format && view->format[0] && !view->format[1] && strchr(formats, view->format[0]))
        return 0;
    PyBuffer_Release(view);
    return wrong(kernel, name, wanted, given);
}

static int take_double(double *out, PyObject *given, const char *kernel, const char *name) {
    *out = PyFloat_AsDouble(given);
    return *out == -1.0 && PyErr_Occurred() ? wrong(kernel, name, "a number", given) : 0;
}

static int take_int(int64_t *out, PyObject *given, const char *kernel, const char *name) {
    PyObject *whole = PyNumber_Index(given);
    *out = whole ? PyLong_AsLongLong(whole) : -1;
    if (whole) Py_DecRef(whole);
    return *out == -1 && PyErr_Occurred() ? wrong(kernel, name, "a whole number of 64 bits", given) : 0;
}

static int take_unsigned(uint64_t *out, PyObject *given, const char *kernel, const char *name) {
    PyObject *whole = PyNumber_Index(given);
    *out = whole ? PyLong_AsUnsignedLongLong(whole) : (uint64_t)-1;
    if (whole) Py_DecRef(whole);
    return *out == (uint64_t)-1 && PyErr_Occurred() ? wrong(kernel, name, "a whole number from 0, of 64 bits", given) : 0;
}

static int take_truth(uint8_t *out, PyObject *given, const char *kernel, const char *name) {
    int truth = PyObject_IsTrue(given);
    *out = truth > 0;
    return truth < 0 ? wrong(kernel, name, "a truth value", given) : 0;
}

static int spread(PyObject **out, PyObject *given, Py_ssize_t fields, const char *kernel, const char *name) {
    if (PyTuple_Size(given) != fields) return wrong(kernel, name, "a record as the kernel declares it", given);
    for (Py_ssize_t k = 0; k < fields; k++) out[k] = PyTuple_GetItem(given, k);
    return 0;
}

static PyObject *count(const char *kernel, Py_ssize_t wanted, Py_ssize_t given) {
    return PyErr_Format(PyExc_TypeError, "%s: takes %zd arguments, not %zd", kernel, wanted, given);
}
