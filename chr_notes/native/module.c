/*
 * The kernels as functions of Python, for one binary that serves every version from 3.11 on.
 *
 * A function of arrays takes them, and None or an array for the result. It returns
 * - the result,
 * - or the result and the rows that are left to the general way, a byte each,
 * - or None where an argument is neither a NumPy array of float64 in C order, or rows of one, nor
 *   plain numbers, or its shape does not fit without a copy; then nothing is done.
 *
 * completed(function of arrays, rest) is a function that returns the result alone: rest(what the
 * first one returned, a tuple of its arguments) gives it where that was anything else.
 *
 * sampled(step of a filter, other) is a function of a state, which it moves on, and of a sample. It
 * returns what the other one makes of the state; or False where somebody should look, at a sample
 * that the step does not call usual, or at the state; or None where nothing is done, as above.
 *
 * decimals(text, starts, ends) reads fields of a text as numbers.
 */
#define Py_LIMITED_API 0x030B0000
#define PY_SSIZE_T_CLEAN
#include <Python.h>
#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#define NPY_TARGET_VERSION NPY_2_0_API_VERSION
#include <numpy/arrayobject.h>

#include "decimals.h"
#include "../generated/c/kernels.c"
#include "../generated/c/stamp.h"

enum { LONG = 10000, MOST_AXES = 32, LISTED = 4 };
/* Numbers that fill 32 MB, and rows that leave a cache room. */
enum { NEW_MEMORY = 1 << 22, FEW_ROWS = 1 << 14 };

/* An argument: its rows, how far it is from one to the next, and the axes over which they stand. */
typedef struct {
    const double *first;
    const double *end;
    const npy_intp *shape;
    int axes;
    npy_intp rows;
    npy_intp step;
} Rows;

/* Last axes of an array by the number of its elements, and how many: none, one, or 3 by 3. */
static int last_axes(int elements, npy_intp *sizes)
{
    sizes[0] = elements == 9 ? 3 : elements;
    sizes[1] = 3;
    return elements == 9 ? 2 : elements > 0;
}

/* Whether an array is one axis of rows, each of them a part of a longer one, or all the same. */
static int is_of_parts(PyArrayObject *array, int last, npy_intp width)
{
    const npy_intp *const strides = PyArray_STRIDES(array), number = sizeof(double);
    return PyArray_ISBEHAVED_RO(array) && PyArray_NDIM(array) == 1 + last
        && (strides[0] == 0 || strides[0] >= width * number) && strides[0] % number == 0
        && (!last || strides[last] == number) && (last < 2 || strides[1] == 3 * number);
}

/* Look at an array; 0 where it is not as the kernels need it. */
static int look(PyObject *value, int elements, Rows *rows)
{
    PyArrayObject *const array = (PyArrayObject *)value;
    npy_intp sizes[2];
    const int last = last_axes(elements, sizes);
    const npy_intp width = elements ? elements : 1;
    if (!PyArray_CheckExact(value) || PyArray_TYPE(array) != NPY_DOUBLE) return 0;
    rows->step = width;
    if (!PyArray_ISCARRAY_RO(array)) {
        if (!is_of_parts(array, last, width)) return 0;
        rows->step = PyArray_STRIDES(array)[0] / (npy_intp)sizeof(double);
    }
    rows->first = PyArray_DATA(array);
    rows->shape = PyArray_DIMS(array);
    rows->axes = PyArray_NDIM(array) - last;
    if (rows->axes < 0 || rows->axes > MOST_AXES) return 0;
    rows->rows = PyArray_MultiplyList(rows->shape, rows->axes);
    rows->end = rows->first + (rows->rows ? (rows->rows - 1) * rows->step + width : 0);
    return PyArray_CompareLists(rows->shape + rows->axes, sizes, last);
}

/* The arguments of a kernel; of several rows, those with the most are the model of the result. */
typedef struct {
    const double *in[MOST_ARRAYS];
    ptrdiff_t step[MOST_ARRAYS];
    double numbers[MOST_ARRAYS][LISTED];
    Rows arrays[MOST_ARRAYS];
    const Rows *model;
} Arguments;

static int same_axes(const Rows *one, const Rows *other)
{
    return one->axes == other->axes && PyArray_CompareLists(one->shape, other->shape, one->axes);
}

static int overlap(const Rows *one, const Rows *other)
{
    return one->first < other->end && other->first < one->end;
}

static PyObject *new_result(const Kernel *kernel, const Rows *model)
{
    npy_intp shape[MOST_AXES + 2];
    const int last = last_axes(kernel->result, shape + model->axes);
    for (int axis = 0; axis < model->axes; axis++) shape[axis] = model->shape[axis];
    return PyArray_SimpleNew(model->axes + last, shape, NPY_DOUBLE);
}

/*
 * Memory that is new comes to the cache when the system clears it, page after page, so it is
 * written to there and not past the cache, as kernels do with many rows. Smaller results get the
 * memory of earlier ones.
 */
static int64_t run(
    const Kernel *kernel, const Arguments *all, double *out, unsigned char *odd, int is_new)
{
    const npy_intp rows = all->model->rows, width = kernel->result ? kernel->result : 1;
    const npy_intp part = is_new && rows * width > NEW_MEMORY ? FEW_ROWS : rows;
    const double *from[MOST_ARRAYS];
    int64_t any = 0;
    for (npy_intp start = 0; start < rows; start += part) {
        const npy_intp count = rows - start < part ? rows - start : part;
        for (int array = 0; array < kernel->arrays; array++)
            from[array] = all->in[array] + start * all->step[array];
        any |= kernel->run(count, from, all->step, out + start * width, odd + start);
    }
    return any;
}

/* Compute into `result`, a new reference, which is returned or given up. */
static PyObject *compute(
    const Kernel *kernel, const Arguments *all, PyObject *result, int is_new)
{
    const npy_intp rows = all->model->rows;
    double *const out = PyArray_DATA((PyArrayObject *)result);
    unsigned char *const odd = PyMem_Calloc((size_t)rows, 1);
    PyThreadState *others;
    int64_t any;
    if (!odd) {
        Py_DECREF(result);
        return PyErr_NoMemory();
    }
    others = rows < LONG ? NULL : PyEval_SaveThread();
    any = run(kernel, all, out, odd, is_new);
    if (others) PyEval_RestoreThread(others);
    if (any) result = Py_BuildValue("Ny#", result, (const char *)odd, rows);
    PyMem_Free(odd);
    return result;
}

/* Take a float, or a few floats and integers in a list or tuple, as a row; 0 for all else. */
static int plain_numbers(PyObject *value, int elements, double *numbers, Rows *row)
{
    *row = (Rows){.first = numbers, .end = numbers + (elements ? elements : 1), .rows = 1};
    if (elements == 0 && PyFloat_Check(value)) {
        numbers[0] = PyFloat_AsDouble(value);
        return 1;
    }
    if (!(PyList_CheckExact(value) || PyTuple_CheckExact(value)) || elements > LISTED
        || PySequence_Size(value) != elements)
        return 0;
    for (int element = 0; element < elements; element++) {
        PyObject *const each = PySequence_GetItem(value, element);
        const int is_number = each && (PyFloat_Check(each) || PyLong_CheckExact(each));
        numbers[element] = is_number ? PyFloat_AsDouble(each) : 0.0;
        Py_XDECREF(each);
        if (!is_number || PyErr_Occurred()) {
            PyErr_Clear(); /* an integer that is too large */
            return 0;
        }
    }
    return elements > 0;
}

/* Find them; 0 where they are not as the kernels need them. */
static int find(const Kernel *kernel, PyObject *const *given, Arguments *all)
{
    all->model = all->arrays;
    for (int array = 0; array < kernel->arrays; array++) {
        const int elements = kernel->shape[array];
        const Rows *const model = all->model;
        Rows *const own = all->arrays + array;
        if (!look(given[array], elements, own)
            && !plain_numbers(given[array], elements, all->numbers[array], own))
            return 0;
        all->in[array] = own->first;
        all->step[array] = own->rows == 1 ? 0 : own->step;
        /* The result has the axes of the array with the most rows, and a row for all has fewer. */
        if (own->rows != 1 && model->rows != 1 && !same_axes(own, model)) return 0;
        if (own->rows != 1 && own->axes < model->axes) return 0;
        if (model->rows != 1 && own->axes > model->axes) return 0;
        if (own->rows != 1 || own->axes > model->axes) all->model = own;
    }
    return 1;
}

static int has_count(const Kernel *kernel, Py_ssize_t count, int more)
{
    if (count == kernel->arrays + more) return 1;
    PyErr_Format(PyExc_TypeError, "%s: expected %d arguments, got %zd", kernel->name,
        kernel->arrays + more, count);
    return 0;
}

static PyObject *call(PyObject *self, PyObject *const *given, Py_ssize_t count)
{
    const Kernel *const kernel = PyCapsule_GetPointer(self, NULL);
    Arguments all;
    Rows target;
    PyObject *result;
    if (!kernel || !has_count(kernel, count, 1)) return NULL;
    if (!find(kernel, given, &all)) Py_RETURN_NONE;
    result = given[count - 1];
    if (result == Py_None) {
        result = new_result(kernel, all.model);
        if (!result) return NULL;
    } else {
        if (!look(result, kernel->result, &target) || !same_axes(&target, all.model)
            || !PyArray_ISCARRAY((PyArrayObject *)result))
            Py_RETURN_NONE;
        for (int array = 0; array < kernel->arrays; array++)
            if (overlap(&target, all.arrays + array)) Py_RETURN_NONE;
        Py_INCREF(result);
    }
    return compute(kernel, &all, result, result != given[count - 1]);
}

static PyObject *call_completed(PyObject *self, PyObject *const *given, Py_ssize_t count)
{
    PyObject *const done = call(PyTuple_GetItem(self, 0), given, count), *all, *result;
    if (!done || PyArray_CheckExact(done)) return done;
    all = PyTuple_New(count);
    if (!all) {
        Py_DECREF(done);
        return NULL;
    }
    for (Py_ssize_t place = 0; place < count; place++)
        PyTuple_SetItem(all, place, Py_NewRef(given[place]));
    result = PyObject_CallFunctionObjArgs(PyTuple_GetItem(self, 1), done, all, NULL);
    Py_DECREF(all);
    Py_DECREF(done);
    return result;
}

static PyMethodDef of_completed = {"completed_kernel",
    (PyCFunction)(void (*)(void))call_completed, METH_FASTCALL, NULL};

/* Filters write half a turn in one way. */
static PyObject *call_sampled(PyObject *self, PyObject *const *given, Py_ssize_t count)
{
    const Kernel *const step = PyCapsule_GetPointer(PyTuple_GetItem(self, 0), NULL);
    const Kernel *const finish
        = PyCapsule_GetPointer(PyCFunction_GetSelf(PyTuple_GetItem(self, 1)), NULL);
    Arguments all;
    unsigned char odd = 0;
    PyObject *result;
    double *out;
    if (!step || !finish || !has_count(step, count, 0)) return NULL;
    if (!find(step, given, &all) || all.model->axes || !PyArray_CheckExact(given[0])
        || !PyArray_ISWRITEABLE((PyArrayObject *)given[0]))
        Py_RETURN_NONE;
    result = new_result(finish, all.model);
    if (!result) return NULL;
    out = PyArray_DATA((PyArrayObject *)result);
    step->run(1, all.in, all.step, PyArray_DATA((PyArrayObject *)given[0]), &odd);
    finish->run(1, all.in, all.step, out, &odd);
    for (int element = 0; element < finish->result; element++)
        if (out[element] >= 4 * EIGHTH) out[element] = -4 * EIGHTH;
    if (!odd) return result;
    Py_DECREF(result);
    Py_RETURN_FALSE;
}

static PyMethodDef of_sampled = {"sampled_kernel",
    (PyCFunction)(void (*)(void))call_sampled, METH_FASTCALL, NULL};

/* Make a function of a kernel and of another function. */
static PyObject *of_two(PyMethodDef *method, PyObject *given)
{
    PyObject *function, *other, *both, *result;
    if (!PyArg_ParseTuple(given, "O!O", &PyCFunction_Type, &function, &other)) return NULL;
    both = PyTuple_Pack(2, PyCFunction_GetSelf(function), other);
    if (!both) return NULL;
    result = PyCFunction_NewEx(method, both, NULL);
    Py_DECREF(both);
    return result;
}

static PyObject *completed(PyObject *self, PyObject *given)
{
    (void)self;
    return of_two(&of_completed, given);
}

static PyObject *sampled(PyObject *self, PyObject *given)
{
    (void)self;
    return of_two(&of_sampled, given);
}

static PyMethodDef methods[] = {{"completed", completed, METH_VARARGS, NULL},
    {"sampled", sampled, METH_VARARGS, NULL}, {"decimals", decimals, METH_VARARGS, NULL},
    {NULL, NULL, 0, NULL}};

static PyMethodDef of_arrays = {"kernel", (PyCFunction)(void (*)(void))call, METH_FASTCALL, NULL};
static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, .m_name = "_compiled", .m_doc = "Generated kernels.", .m_size = -1,
    .m_methods = methods};

PyMODINIT_FUNC PyInit__compiled(void)
{
    PyObject *module;
    int wrong;
    import_array();
    module = PyModule_Create(&definition);
    wrong = !module || PyModule_AddStringConstant(module, "stamp", STAMP);
    for (const Kernel *kernel = KERNELS; kernel->name && !wrong; kernel++) {
        PyObject *const self = PyCapsule_New((void *)kernel, NULL, NULL);
        PyObject *const function = self ? PyCFunction_NewEx(&of_arrays, self, NULL) : NULL;
        wrong = PyModule_AddObjectRef(module, kernel->name, function);
        Py_XDECREF(self);
        Py_XDECREF(function);
    }
    if (wrong) Py_CLEAR(module);
    return module;
}
