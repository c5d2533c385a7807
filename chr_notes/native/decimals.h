/*
 * Decimal numbers out of text, as `float` of Python reads them: digits with at most a point, and a
 * power of ten. Whatever else stands in a field is left to the caller.
 */
#ifndef DECIMALS_H
#define DECIMALS_H

#include <float.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* Letters of a longer field are left to the caller; no number of a log has so many. */
enum { LONGEST_FIELD = 63, MOST_DIGITS = 19, EXACT_POWERS = 22 };

/* Every one of these powers is a double. */
static const double POWERS[EXACT_POWERS + 1] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9,
    1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/* Read digits behind those of `whole`, and say where they end. */
static const char *read_digits(const char *at, const char *end, uint64_t *whole, int *digits)
{
    for (; at < end && *at >= '0' && *at <= '9'; at++) {
        *whole = *whole * 10 + (uint64_t)(*at - '0');
        *digits += *whole != 0 || *digits != 0; /* zeros in front do not count */
    }
    return at;
}

/* Multiply by a power of ten; 0 where the rounding is not certain. */
static int scale(uint64_t whole, ptrdiff_t tens, double *value)
{
    if (whole <= (uint64_t)1 << 53) {
        /* One operation on two doubles that are exact is rounded once. */
        *value = tens < 0 ? (double)whole / POWERS[-tens] : (double)whole * POWERS[tens];
        return 1;
    }
#if LDBL_MANT_DIG >= 64
    if (tens <= 0) {
        /* Rounded to more digits first: certain where its neighbours become the same double. */
        const long double quotient = (long double)whole / POWERS[-tens];
        *value = (double)quotient;
        return (double)(quotient * (1 - LDBL_EPSILON)) == *value
            && (double)(quotient * (1 + LDBL_EPSILON)) == *value;
    }
#endif
    return 0;
}

/* Have Python read a field of digits, point and power; 0 where it is beyond all doubles. */
static int read_slowly(const char *start, const char *end, double *value)
{
    char field[LONGEST_FIELD + 1];
    memcpy(field, start, (size_t)(end - start));
    field[end - start] = 0;
    *value = PyOS_string_to_double(field, NULL, NULL);
    if (*value == -1.0 && PyErr_Occurred()) {
        PyErr_Clear();
        return 0;
    }
    return *value - *value == 0.0;
}

/* Read one field; 0 where it is no such number. */
static int read_decimal(const char *start, const char *end, double *value)
{
    const char *at = start, *mark;
    uint64_t whole = 0, power = 0;
    int digits = 0, power_digits = 0;
    ptrdiff_t tens = 0, letters;
    if (end - start > LONGEST_FIELD) return 0;
    at += at < end && (*at == '-' || *at == '+');
    mark = at;
    at = read_digits(at, end, &whole, &digits);
    letters = at - mark;
    if (at < end && *at == '.') {
        mark = ++at;
        at = read_digits(at, end, &whole, &digits);
        tens = mark - at;
        letters -= tens;
    }
    if (letters == 0) return 0;
    if (at < end && (*at == 'e' || *at == 'E')) {
        const int down = ++at < end && *at == '-';
        at += at < end && (*at == '-' || *at == '+');
        mark = at;
        at = read_digits(at, end, &power, &power_digits);
        if (at == mark || power_digits > 4) return 0;
        tens += down ? -(ptrdiff_t)power : (ptrdiff_t)power;
    }
    if (at != end) return 0;
    if (!(digits <= MOST_DIGITS && tens >= -EXACT_POWERS && tens <= EXACT_POWERS
            && scale(whole, tens, value)))
        return read_slowly(start, end, value);
    if (*start == '-') *value = -*value;
    return 1;
}

/* decimals(text, starts, ends): the numbers, and for which fields they are right. */
static PyObject *decimals(PyObject *self, PyObject *given)
{
    PyArrayObject *text, *starts, *ends;
    PyObject *values, *read;
    npy_intp fields, letters;
    (void)self;
    if (!PyArg_ParseTuple(given, "O!O!O!", &PyArray_Type, &text, &PyArray_Type, &starts,
            &PyArray_Type, &ends))
        return NULL;
    fields = PyArray_SIZE(starts), letters = PyArray_SIZE(text);
    if (PyArray_TYPE(text) != NPY_UINT8 || PyArray_TYPE(starts) != NPY_INT64
        || PyArray_TYPE(ends) != NPY_INT64 || PyArray_SIZE(ends) != fields
        || !PyArray_ISCARRAY_RO(text) || !PyArray_ISCARRAY_RO(starts)
        || !PyArray_ISCARRAY_RO(ends)) {
        PyErr_SetString(PyExc_TypeError, "decimals: expected bytes, and where fields start and end");
        return NULL;
    }
    values = PyArray_SimpleNew(1, &fields, NPY_DOUBLE);
    read = PyArray_SimpleNew(1, &fields, NPY_BOOL);
    if (values && read) {
        const char *const all = PyArray_DATA(text);
        const npy_int64 *const first = PyArray_DATA(starts), *const last = PyArray_DATA(ends);
        double *const to = PyArray_DATA((PyArrayObject *)values);
        npy_bool *const done = PyArray_DATA((PyArrayObject *)read);
        for (npy_intp field = 0; field < fields; field++) {
            to[field] = 0.0;
            done[field] = first[field] >= 0 && first[field] <= last[field]
                && last[field] <= letters
                && read_decimal(all + first[field], all + last[field], to + field);
        }
        given = PyTuple_Pack(2, values, read);
    } else {
        given = NULL;
    }
    Py_XDECREF(values);
    Py_XDECREF(read);
    return given;
}

#endif
