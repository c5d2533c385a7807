/*
 * What the generated kernels share. A kernel goes through arrays in blocks of rows: it loads the
 * elements of a block into columns, computes row after row without a branch, and stores columns.
 */
#ifndef COLUMNS_H
#define COLUMNS_H

#include <stddef.h>

#include "elementary.h"

enum { BLOCK = 64, TOGETHER = 8, MOST_ARRAYS = 12 };

/* The fastest instruction set is chosen at run time, where compiler and system can. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__gnu_linux__) \
    && !defined(ONE_INSTRUCTION_SET)
#define EVERY_INSTRUCTION_SET \
    __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#else
#define EVERY_INSTRUCTION_SET
#endif

/*
 * in: the arrays; step: how many numbers lie between two rows of each, 0 where one row is for all;
 * odd: set to 1 for rows that are left to the general way, zero before. Returns whether any is.
 */
typedef int64_t Run(ptrdiff_t rows, const double *const *in, const ptrdiff_t *step, double *out,
    unsigned char *odd);

/* Last axes of an array: none, one of that size, or 3 by 3 where it is 9. */
typedef struct {
    const char *name;
    Run *run;
    int result;
    int arrays;
    int shape[MOST_ARRAYS];
} Kernel;

/* For the rest of a block that is not full its first row is computed again. */
#define FOR_EACH_BLOCK(rows) \
    for (ptrdiff_t start = 0, count, padded; start < (rows) \
        && (count = (rows) - start < BLOCK ? (rows) - start : BLOCK, \
            padded = (count + TOGETHER - 1) / TOGETHER * TOGETHER, 1); start += BLOCK)

#define LOAD(columns, array, width) \
    if (step[array] == 0) { \
        for (int element = 0; element < (width); element++) \
            for (ptrdiff_t row = 0; row < padded; row++) \
                (columns)[element][row] = in[array][element]; \
    } else { \
        const double *const first = in[array] + start * (width); \
        for (ptrdiff_t row = 0; row < count; row++) \
            for (int element = 0; element < (width); element++) \
                (columns)[element][row] = first[row * (width) + element]; \
        for (int element = 0; element < (width); element++) \
            for (ptrdiff_t row = count; row < padded; row++) \
                (columns)[element][row] = first[element]; \
    }

#define STORE(columns, width) \
    for (ptrdiff_t row = 0; row < count; row++) \
        for (int element = 0; element < (width); element++) \
            out[(start + row) * (width) + element] = (columns)[element][row];

/* Whether the numbers whose sum this is are numbers, and neither infinite nor nearly so. */
#define FINITE(sum) ((sum) - (sum) == 0.0)
/* A squared length within these bounds lost nothing, and neither did its square. */
#define IN_RANGE(square) (((square) > 0x1p-400) & ((square) < 0x1p400))

#endif
