/*
 * What the generated kernels share. A kernel goes through arrays in blocks of rows: it loads the
 * elements of a block into columns, computes row after row without a branch, loads the next block,
 * so that no row waits for what has just been written, and stores columns.
 */
#ifndef COLUMNS_H
#define COLUMNS_H

#include <stddef.h>

#include "elementary.h"

enum { BLOCK = 16, TOGETHER = 8, AHEAD = 128, LINE = 8, MANY = 1 << 20, MOST_ARRAYS = 12 };

/* The fastest instruction set is chosen at run time, where compiler and system can. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__gnu_linux__) \
    && !defined(ONE_INSTRUCTION_SET)
#define EVERY_INSTRUCTION_SET \
    __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
/* Whether the last of them is: its registers hold eight numbers. */
#define EIGHT_AT_ONCE __builtin_cpu_supports("avx512dq")
#else
#define EVERY_INSTRUCTION_SET
#define EIGHT_AT_ONCE 0
#endif

/*
 * in: the arrays; step: how many numbers it is from one row of each to the next, 0 where one row is
 * for all;
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

#if defined(__clang__) || __GNUC__ >= 12
#define TILE 4
#define PICK __builtin_shufflevector
#define AT(type, address) (*(type *)(address))
#define BOTH(one, other) PICK(AT(const Four, one), AT(const Four, other), 0, 1, 2, 3, 4, 5, 6, 7)
typedef double Four __attribute__((vector_size(32), aligned(8)));
typedef double Eight __attribute__((vector_size(64), aligned(8)));

/* Write four rows of four numbers as columns. */
INLINE void tile(double *to, ptrdiff_t across, const double *from, ptrdiff_t down)
{
    const Four a = AT(const Four, from), b = AT(const Four, from + down);
    const Four c = AT(const Four, from + 2 * down), d = AT(const Four, from + 3 * down);
    const Four p = PICK(a, b, 0, 4, 2, 6), q = PICK(a, b, 1, 5, 3, 7);
    const Four r = PICK(c, d, 0, 4, 2, 6), s = PICK(c, d, 1, 5, 3, 7);
    AT(Four, to) = PICK(p, r, 0, 1, 4, 5);
    AT(Four, to + across) = PICK(q, s, 0, 1, 4, 5);
    AT(Four, to + 2 * across) = PICK(p, r, 2, 3, 6, 7);
    AT(Four, to + 3 * across) = PICK(q, s, 2, 3, 6, 7);
}

/* The same of eight rows. */
INLINE void two_tiles(double *to, ptrdiff_t across, const double *from, ptrdiff_t down)
{
    const double *const later = from + 4 * down;
    const Eight a = BOTH(from, later), b = BOTH(from + down, later + down);
    const Eight c = BOTH(from + 2 * down, later + 2 * down);
    const Eight d = BOTH(from + 3 * down, later + 3 * down);
    const Eight p = PICK(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
    const Eight q = PICK(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
    const Eight r = PICK(c, d, 0, 8, 2, 10, 4, 12, 6, 14);
    const Eight s = PICK(c, d, 1, 9, 3, 11, 5, 13, 7, 15);
    AT(Eight, to) = PICK(p, r, 0, 1, 8, 9, 4, 5, 12, 13);
    AT(Eight, to + across) = PICK(q, s, 0, 1, 8, 9, 4, 5, 12, 13);
    AT(Eight, to + 2 * across) = PICK(p, r, 2, 3, 10, 11, 6, 7, 14, 15);
    AT(Eight, to + 3 * across) = PICK(q, s, 2, 3, 10, 11, 6, 7, 14, 15);
}
#else
#define TILE BLOCK /* none */
#define tile(to, across, from, down)
#define two_tiles(to, across, from, down)
#endif

/* Fetch early what comes AHEAD rows later: a processor does not look as far ahead. */
#if defined(__GNUC__)
#define FETCH(address) __builtin_prefetch(address)
#else
#define FETCH(address)
#endif

/* A row that is one for all fills the first block, and stays; the first row fills up a block. */
INLINE void load(double *columns, int width, const double *in, ptrdiff_t step, ptrdiff_t start,
    ptrdiff_t rows)
{
    const ptrdiff_t count = rows - start < BLOCK ? rows - start : BLOCK;
    const ptrdiff_t close = step == width ? count : 0;
    const ptrdiff_t tiles = width < TILE ? 0 : close / TILE * TILE;
    const int tiled = width / TILE * TILE;
    const double *first;
    ptrdiff_t row = 0;
    if (count <= 0 || (step == 0 && start > 0)) return;
    first = in + start * step;
    for (int number = 0; number < BLOCK * width; number += LINE)
        FETCH(first + AHEAD * width + number);
    if (EIGHT_AT_ONCE)
        for (; row + 2 * TILE <= tiles; row += 2 * TILE)
            for (int element = 0; element < tiled; element += TILE)
                two_tiles(
                    columns + element * BLOCK + row, BLOCK, first + row * width + element, width);
    for (; row < tiles; row += TILE)
        for (int element = 0; element < tiled; element += TILE)
            tile(columns + element * BLOCK + row, BLOCK, first + row * width + element, width);
    for (int element = tiled; element < width; element++)
        for (row = 0; row < tiles; row++)
            columns[element * BLOCK + row] = first[row * width + element];
    for (row = tiles; row < close; row++)
        for (int element = 0; element < width; element++)
            columns[element * BLOCK + row] = first[row * width + element];
    for (row = close; row < count; row++)
        for (int element = 0; element < width; element++)
            columns[element * BLOCK + row] = first[row * step + element];
    for (int element = 0; element < width; element++)
        for (row = count; row % TOGETHER; row++)
            columns[element * BLOCK + row] = in[element];
}

INLINE void store(double *first, const double *columns, int width, ptrdiff_t count)
{
    const ptrdiff_t rows = width < TILE ? 0 : count / TILE * TILE;
    const int tiled = width / TILE * TILE;
    for (ptrdiff_t row = 0; row < rows; row += TILE) {
        for (int element = 0; element < tiled; element += TILE)
            tile(first + row * width + element, width, columns + element * BLOCK + row, BLOCK);
        for (int element = tiled; element < width; element++)
            for (ptrdiff_t each = row; each < row + TILE; each++)
                first[each * width + element] = columns[element * BLOCK + each];
    }
    for (ptrdiff_t row = rows; row < count; row++)
        for (int element = 0; element < width; element++)
            first[row * width + element] = columns[element * BLOCK + row];
}

#define LOAD(columns, array, width, start) \
    load((columns)[0], width, in[array], step[array], start, rows);

/*
 * A result that no cache holds goes to memory without being read from there before, in whole lines:
 * numbers of one that is not full wait in front of those of the next block.
 */
#if defined(__SSE2__)
#include <emmintrin.h>
INLINE void stream(double *to, double *lines, int numbers, int is_first, int is_last)
{
    const int waiting = (int)((uintptr_t)to / sizeof *to % LINE);
    const int known = is_first ? waiting : 0;
    double *const line = to - waiting;
    int number = known ? LINE : 0;
    for (int each = known; each < number; each++) line[each] = lines[each];
    for (; number + LINE <= waiting + numbers; number += LINE)
        for (int each = number; each < number + LINE; each += 2)
            _mm_stream_pd(line + each, _mm_loadu_pd(lines + each));
    if (is_last)
        for (; number < waiting + numbers; number++) line[number] = lines[number];
    memcpy(lines, lines + numbers, LINE * sizeof *lines);
}
#define LINES(width) double lines[BLOCK * (width) + LINE];
#define STORE(columns, width) \
    if (rows * (width) > MANY && count == BLOCK && (uintptr_t)out % sizeof *out == 0) { \
        double *const to = out + start * (width); \
        store(lines + (uintptr_t)to / sizeof *to % LINE, (columns)[0], width, BLOCK); \
        stream(to, lines, BLOCK * (width), start == 0, rows - start < 2 * BLOCK); \
    } else { \
        store(out + start * (width), (columns)[0], width, count); \
    }
#define FINISH _mm_sfence();
#else
#define LINES(width)
#define STORE(columns, width) store(out + start * (width), (columns)[0], width, count);
#define FINISH
#endif

/*
 * Any three turns are turns about z, y, x, or about z, y, z, in a frame whose z is the axis of the
 * first turn, y that of the second, and x = y × z, along an axis or against it. Elements of arrays
 * stand elsewhere there, and some with the other sign.
 */
typedef struct {
    int place[9];
    double sign[9];
} Order;

typedef struct {
    Order turns, axes, quaternion, matrix, rates;
} Frame;

INLINE Order order_of(const Order *rows, const Order *columns)
{
    Order order;
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 3; column++) {
            order.place[3 * row + column] = 3 * rows->place[row] + columns->place[column];
            order.sign[3 * row + column] = rows->sign[row] * columns->sign[column];
        }
    return order;
}

INLINE Frame frame_of(const double *axes)
{
    const int first = (int)axes[0], second = (int)axes[1], again = axes[2] == axes[0];
    const double sign = (first - second + 3) % 3 == 1 ? 1.0 : -1.0;
    Frame frame = {
        .turns = {{0, 1, 2}, {1.0, 1.0, again ? 1.0 : sign}},
        .axes = {{5 - first - second, second - 1, first - 1}, {sign, 1.0, 1.0}},
        .quaternion = {{0, 6 - first - second, second, first}, {1.0, sign, 1.0, 1.0}},
    };
    frame.matrix = order_of(&frame.axes, &frame.axes);
    frame.rates = order_of(&frame.turns, &frame.axes);
    return frame;
}

/* Whether these are axes of three turns, none of which goes on with the last one. */
INLINE int are_axes(const double *axes)
{
    for (int turn = 0; turn < 3; turn++)
        if (axes[turn] != 1.0 && axes[turn] != 2.0 && axes[turn] != 3.0) return 0;
    return axes[0] != axes[1] && axes[1] != axes[2];
}

/* A zero stays one without a sign, so that a half turn is told on the same side. */
#define ARRANGE(to, TO, from, FROM, width, order) \
    for (int element = 0; element < (width); element++) \
        for (int row = 0; row < BLOCK; row++) \
            (to)[TO][row] = frame.order.sign[element] * (from)[FROM][row] + 0.0;
#define TO_FRAME(to, from, width, order) \
    ARRANGE(to, element, from, frame.order.place[element], width, order)
#define FROM_FRAME(to, from, width, order) \
    ARRANGE(to, frame.order.place[element], from, element, width, order)
/* A kernel of any turns: rows with the same axes go together to one of the usual axes. */
#define BY_AXES(name, width) \
    static int64_t name(ptrdiff_t rows, const double *const *in, const ptrdiff_t *step, \
        double *out, unsigned char *odd) \
    { \
        int64_t any = 0; \
        for (ptrdiff_t start = 0, end; start < rows; start = end) { \
            const double *const axes = in[1] + start * step[1]; \
            const double *const from[] = {in[0] + start * step[0], axes}; \
            for (end = step[1] ? start + 1 : rows; end < rows; end++) \
                if (memcmp(axes, in[1] + end * step[1], 3 * sizeof *axes)) break; \
            if (are_axes(axes)) { \
                any |= (axes[0] == axes[2] ? name##_zyz : name##_zyx)( \
                    end - start, from, step, out + start * (width), odd + start); \
            } else { \
                any = 1; \
                for (ptrdiff_t row = start; row < end; row++) odd[row] = 1; \
                for (ptrdiff_t place = start * (width); place < end * (width); place++) \
                    out[place] = (double)NAN; \
            } \
        } \
        return any; \
    }

/* Whether the numbers whose sum this is are numbers, and neither infinite nor nearly so. */
#define FINITE(sum) ((sum) - (sum) == 0.0)
/* A squared length within these bounds lost nothing, and neither did its square. */
#define IN_RANGE(square) (((square) > 0x1p-400) & ((square) < 0x1p400))

#endif
