/*
 * The kernels as functions of Python, for one binary that serves every version from 3.11 on.
 *
 * A function of arrays takes them, and None or an array for the result. It returns
 * - the result,
 * - or the result and the rows that are left to the general way, a byte each,
 * - or None where an argument is not a NumPy array of float64 in C order, or its shape does not
 *   fit without a copy; then nothing is done.
 *
 * A function of numbers, whose name ends in _of_numbers, takes the elements of one row of each
 * array. It returns those of the result, or None where the row is left to the general way.
 */
#define Py_LIMITED_API 0x030B0000
#include <Python.h>
#include <stdlib.h>

#include "../generated/c/kernels.c"
#include "../generated/c/stamp.h"

enum { MOST_AXES = 32, LONG = 10000, MOST_ELEMENTS = 9 };

static PyTypeObject *array_type;
static PyObject *empty;

typedef struct {
    Py_buffer buffers[MOST_ARRAYS + 1];
    int held;
} Held;

static void release(Held *held)
{
    while (held->held) PyBuffer_Release(&held->buffers[--held->held]);
}

/* Last axes of an array by the number of its elements. */
static int last_axes(int elements) { return elements == 9 ? 2 : elements > 0; }

/* Look at an array; NULL where it is not as the kernels need it. */
static Py_buffer *look(Held *held, PyObject *value, int elements, int flags)
{
    Py_buffer *buffer = &held->buffers[held->held];
    const int axes = last_axes(elements);
    if (Py_TYPE(value) != array_type) return NULL;
    if (PyObject_GetBuffer(value, buffer, flags | PyBUF_FORMAT | PyBUF_C_CONTIGUOUS)) {
        PyErr_Clear();
        return NULL;
    }
    held->held++;
    if (buffer->itemsize != sizeof(double) || buffer->format[0] != 'd' || buffer->format[1])
        return NULL;
    if (buffer->ndim < axes || buffer->ndim > MOST_AXES) return NULL;
    if (axes == 1 && buffer->shape[buffer->ndim - 1] != elements) return NULL;
    if (axes == 2 && (buffer->shape[buffer->ndim - 1] != 3 || buffer->shape[buffer->ndim - 2] != 3))
        return NULL;
    return buffer;
}

static Py_ssize_t rows_of(const Py_buffer *buffer, int axes)
{
    Py_ssize_t rows = 1;
    for (int axis = 0; axis < axes; axis++) rows *= buffer->shape[axis];
    return rows;
}

static int overlap(const Py_buffer *one, const Py_buffer *other)
{
    const char *const first = one->buf, *const second = other->buf;
    return first < second + other->len && second < first + one->len;
}

static PyObject *new_result(const Kernel *kernel, const Py_buffer *model, int leading)
{
    const int axes = last_axes(kernel->result);
    PyObject *const shape = PyTuple_New(leading + axes);
    PyObject *result;
    if (!shape) return NULL;
    for (int axis = 0; axis < leading + axes; axis++) {
        const Py_ssize_t size = axis < leading ? model->shape[axis] : axes == 2 ? 3 : kernel->result;
        PyTuple_SetItem(shape, axis, PyLong_FromSsize_t(size));
    }
    result = PyObject_CallFunctionObjArgs(empty, shape, NULL);
    Py_DECREF(shape);
    return result;
}

/* Compute into `result`, a new reference, which is returned or given up. */
static PyObject *compute(const Kernel *kernel, Py_ssize_t rows, const double *const *in,
    const ptrdiff_t *step, double *out, PyObject *result)
{
    unsigned char *const odd = calloc(rows ? (size_t)rows : 1, 1);
    int64_t any;
    if (!odd) {
        Py_DECREF(result);
        return PyErr_NoMemory();
    }
    if (rows < LONG) {
        any = kernel->run(rows, in, step, out, odd);
    } else {
        Py_BEGIN_ALLOW_THREADS
        any = kernel->run(rows, in, step, out, odd);
        Py_END_ALLOW_THREADS
    }
    if (any) {
        PyObject *const which = PyBytes_FromStringAndSize((const char *)odd, rows);
        PyObject *const both = which ? PyTuple_Pack(2, result, which) : NULL;
        Py_XDECREF(which);
        Py_DECREF(result);
        result = both;
    }
    free(odd);
    return result;
}

static PyObject *call(PyObject *self, PyObject *const *given, Py_ssize_t count)
{
    const Kernel *const kernel = PyCapsule_GetPointer(self, NULL);
    const double *in[MOST_ARRAYS];
    ptrdiff_t step[MOST_ARRAYS];
    Py_ssize_t rows = 1;
    int model = 0, leading = -1;
    Held held = {.held = 0};
    PyObject *result = NULL;
    Py_buffer *target;
    if (!kernel) return NULL;
    if (count != kernel->arrays + 1) {
        PyErr_Format(PyExc_TypeError, "%s: expected %d arrays and a result, got %zd arguments",
            kernel->name, kernel->arrays, count);
        return NULL;
    }
    for (int array = 0; array < kernel->arrays; array++) {
        const int elements = kernel->shape[array];
        const Py_buffer *const buffer = look(&held, given[array], elements, 0);
        int axes;
        Py_ssize_t own;
        if (!buffer) goto unlike;
        axes = buffer->ndim - last_axes(elements);
        own = rows_of(buffer, axes);
        in[array] = buffer->buf;
        step[array] = own == 1 ? 0 : elements ? elements : 1;
        if (own != 1 ? rows == 1 : rows == 1 && axes > leading) {
            if (own != 1 && axes < leading) goto unlike;
            rows = own;
            model = array;
            leading = axes;
        } else if (own != 1) {
            if (axes != leading) goto unlike;
            for (int axis = 0; axis < axes; axis++)
                if (buffer->shape[axis] != held.buffers[model].shape[axis]) goto unlike;
        } else if (axes > leading) {
            goto unlike;
        }
    }
    result = given[count - 1];
    if (result == Py_None) {
        result = new_result(kernel, &held.buffers[model], leading);
        if (!result) goto failed;
        target = look(&held, result, kernel->result, PyBUF_WRITABLE);
    } else {
        Py_INCREF(result);
        target = look(&held, result, kernel->result, PyBUF_WRITABLE);
        if (!target || target->ndim != leading + last_axes(kernel->result)) goto unlike;
        for (int axis = 0; axis < leading; axis++)
            if (target->shape[axis] != held.buffers[model].shape[axis]) goto unlike;
        for (int array = 0; array < kernel->arrays; array++)
            if (overlap(target, &held.buffers[array])) goto unlike;
    }
    if (!target) goto unlike;
    result = compute(kernel, rows, in, step, target->buf, result);
    release(&held);
    return result;
unlike:
    Py_XDECREF(result);
    release(&held);
    Py_RETURN_NONE;
failed:
    release(&held);
    return NULL;
}

static PyObject *call_with_numbers(PyObject *self, PyObject *const *given, Py_ssize_t count)
{
    const Kernel *const kernel = PyCapsule_GetPointer(self, NULL);
    static const ptrdiff_t step[MOST_ARRAYS];
    double numbers[MOST_ARRAYS * MOST_ELEMENTS], out[MOST_ELEMENTS];
    const double *in[MOST_ARRAYS];
    unsigned char odd = 0;
    const int size = kernel && kernel->result ? kernel->result : 1;
    int expected = 0;
    PyObject *result;
    if (!kernel) return NULL;
    for (int array = 0; array < kernel->arrays; array++) {
        in[array] = numbers + expected;
        expected += kernel->shape[array] ? kernel->shape[array] : 1;
    }
    if (count != expected) {
        PyErr_Format(PyExc_TypeError, "%s: expected %d numbers, got %zd arguments", kernel->name,
            expected, count);
        return NULL;
    }
    for (int number = 0; number < expected; number++) {
        numbers[number] = PyFloat_AsDouble(given[number]);
        if (numbers[number] == -1.0 && PyErr_Occurred()) return NULL;
    }
    kernel->run(1, in, step, out, &odd);
    if (odd) Py_RETURN_NONE;
    result = PyTuple_New(size);
    for (int element = 0; result && element < size; element++)
        PyTuple_SetItem(result, element, PyFloat_FromDouble(out[element]));
    return result;
}

static PyMethodDef of_arrays = {"kernel", (PyCFunction)(void (*)(void))call, METH_FASTCALL, NULL};
static PyMethodDef of_numbers = {
    "kernel_of_numbers", (PyCFunction)(void (*)(void))call_with_numbers, METH_FASTCALL, NULL};

static int add(PyObject *module, const char *name, PyMethodDef *method, PyObject *kernel)
{
    PyObject *const function = PyCFunction_NewEx(method, kernel, NULL);
    const int failed = !function || PyObject_SetAttrString(module, name, function);
    Py_XDECREF(function);
    return failed;
}

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, .m_name = "_compiled", .m_doc = "Generated kernels.", .m_size = -1};

PyMODINIT_FUNC PyInit__compiled(void)
{
    PyObject *const module = PyModule_Create(&definition);
    PyObject *const numpy = PyImport_ImportModule("numpy");
    if (!module || !numpy) goto failed;
    array_type = (PyTypeObject *)PyObject_GetAttrString(numpy, "ndarray");
    empty = PyObject_GetAttrString(numpy, "empty");
    if (!array_type || !empty || PyModule_AddStringConstant(module, "stamp", STAMP)) goto failed;
    for (const Kernel *kernel = KERNELS; kernel->name; kernel++) {
        PyObject *const self = PyCapsule_New((void *)kernel, NULL, NULL);
        PyObject *const name = PyUnicode_FromFormat("%s_of_numbers", kernel->name);
        const char *const told = name ? PyUnicode_AsUTF8AndSize(name, NULL) : NULL;
        const int wrong = !self || !told || add(module, kernel->name, &of_arrays, self)
            || add(module, told, &of_numbers, self);
        Py_XDECREF(self);
        Py_XDECREF(name);
        if (wrong) goto failed;
    }
    Py_DECREF(numpy);
    return module;
failed:
    Py_XDECREF(numpy);
    Py_XDECREF(module);
    return NULL;
}
