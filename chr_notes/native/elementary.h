/*
 * Sine, cosine and arctangent without branches, so that a compiler computes several at a time, and
 * from sums and products alone, so that every machine gives the same bits (without contraction of
 * a product and a sum). tools/minimax.py derives the numbers below.
 *
 * Errors, measured against mpmath by tests/native: sine and cosine at most 2 units in the last
 * place for magnitudes below LARGEST_ANGLE, arctangent at most 2.
 */
#ifndef ELEMENTARY_H
#define ELEMENTARY_H

#include <math.h>
#include <stdint.h>
#include <string.h>

#if defined(__GNUC__)
#define INLINE static inline __attribute__((always_inline))
#elif defined(_MSC_VER)
#define INLINE static __forceinline
#else
#define INLINE static inline
#endif

#define LARGEST_ANGLE 1e6

/* pi/2 in three parts: a whole number below 2^20 times the first is exact, and so with the next. */
#define HALF_PI_1 0x1.921fb544p+0
#define HALF_PI_2 0x1.0b4611a6p-34
#define HALF_PI_3 0x1.3198a2e037073p-69
#define TWO_OVER_PI 0x1.45f306dc9c883p-1
/* pi/4, an eighth of a turn, and the tangent of half of it. */
#define EIGHTH 0x1.921fb54442d18p-1
#define TAN_SIXTEENTH 0x1.a827999fcef32p-2

/* An angle less whole quarter turns. */
INLINE double less_quarters(double angle, double turns)
{
    return ((angle - turns * HALF_PI_1) - turns * HALF_PI_2) - turns * HALF_PI_3;
}

/* What is left of an angle after whole quarter turns, and how many those are. */
INLINE double quarter_turns_off(double angle, int64_t *quarters)
{
    const double round = 0x1.8p52; /* added and taken away again, it leaves a whole number */
    const double turns = angle * TWO_OVER_PI + round;
    memcpy(quarters, &turns, sizeof turns);
    return less_quarters(angle, turns - round);
}

/*
 * Polynomials are added up in pairs, pairs of pairs and so on: a processor does not wait for one
 * sum before the next.
 */

/* What the polynomials below add to the first terms, of squares. */
INLINE double sine_tail(double z)
{
    const double z2 = z * z;
    const double low = -0x1.5555555555549p-3 + z * 0x1.111111110f87dp-7;
    const double middle = -0x1.a01a019c12029p-13 + z * 0x1.71de357815c43p-19;
    const double high = -0x1.ae5e6687ebf3p-26 + z * 0x1.5d9318300cd1ep-33;
    return (low + z2 * middle) + z2 * z2 * high;
}

INLINE double arctangent_tail(double z)
{
    const double z2 = z * z, z4 = z2 * z2;
    const double one = -0x1.555555555553dp-2 + z * 0x1.99999999958ebp-3;
    const double two = -0x1.24924922b11d2p-3 + z * 0x1.c71c70e7a126dp-4;
    const double three = -0x1.745cf90afef0cp-4 + z * 0x1.3b111c62e06a8p-4;
    const double four = -0x1.10ebdd8da9adcp-4 + z * 0x1.df1166a2ad2ecp-5;
    const double five = -0x1.9cdc233d9077p-5 + z * 0x1.37ed377704b8dp-5;
    const double six = -0x1.259d3665679fbp-6;
    return (one + z2 * two) + z4 * ((three + z2 * four) + z4 * (five + z2 * six));
}

/* Sine on [-pi/4, pi/4]. */
INLINE double near_sine(double x)
{
    const double z = x * x;
    return x + x * z * sine_tail(z);
}

/* Cosine of an angle up to pi/4 by its square; what 1 - z/2 loses by rounding is added again. */
INLINE double cosine_of_square(double z)
{
    const double z2 = z * z, half = 0.5 * z, most = 1.0 - half;
    const double low = 0x1.555555555554cp-5 + z * -0x1.6c16c16c15181p-10;
    const double middle = 0x1.a01a019cb216ep-16 + z * -0x1.27e4f80a33e95p-22;
    const double high = 0x1.1ee9ec18bf103p-29 + z * -0x1.8faeb5fdf837bp-37;
    return most + (((1.0 - most) - half) + z2 * ((low + z2 * middle) + z2 * z2 * high));
}

/* Arctangent on [-tan(pi/8), tan(pi/8)], less its argument. */
INLINE double near_arctangent_less(double t)
{
    const double z = t * t;
    return t * z * arctangent_tail(z);
}

/* The second of four signs or values by the quarter: every odd one the other function. */
INLINE double by_quarter(int64_t quarters, double even, double odd)
{
    const double value = quarters & 1 ? odd : even;
    const uint64_t sign = (uint64_t)(quarters & 2) << 62;
    uint64_t bits;
    double result;
    memcpy(&bits, &value, sizeof bits);
    bits ^= sign;
    memcpy(&result, &bits, sizeof bits);
    return result;
}

INLINE double column_sin(double angle)
{
    int64_t quarters;
    const double rest = quarter_turns_off(angle, &quarters);
    return by_quarter(quarters, near_sine(rest), cosine_of_square(rest * rest));
}

INLINE double column_cos(double angle)
{
    int64_t quarters;
    const double rest = quarter_turns_off(angle, &quarters);
    return by_quarter(quarters + 1, near_sine(rest), cosine_of_square(rest * rest));
}

/* What is left of an angle after whole turns, in [-pi, pi). */
INLINE double column_principal(double angle)
{
    const double round = 0x1.8p52;
    const double turns = 4.0 * ((angle * (0.25 * TWO_OVER_PI) + round) - round);
    const double rest = less_quarters(angle, turns);
    /* The number of turns was rounded: near half a turn it can be one off. */
    const double back = rest > 4.0 * EIGHTH ? 4.0 : rest < -4.0 * EIGHTH ? -4.0 : 0.0;
    const double found = less_quarters(rest, back);
    return found >= 4.0 * EIGHTH ? -4.0 * EIGHTH : found;
}

/* Of finite numbers. */
INLINE double column_atan2(double y, double x)
{
    const double along = fabs(x), across = fabs(y);
    const int steep = across > along;
    const double longer = steep ? across : along, shorter = steep ? along : across;
    /* Above tan(pi/8) the angle is taken from pi/4. */
    const int wide = shorter > TAN_SIXTEENTH * longer;
    const double above = wide ? shorter - longer : shorter;
    const double below = wide ? shorter + longer : longer;
    const double t = above / (below == 0.0 ? 1.0 : below), rest = near_arctangent_less(t);
    /* The angle is a number of times pi/4, plus or minus what the polynomial gives. */
    double eighths = wide ? 1.0 : 0.0, sign = steep ? -1.0 : 1.0, result;
    int64_t bits;
    memcpy(&bits, &x, sizeof bits); /* negative for a zero with a minus too */
    eighths = steep ? 2.0 - eighths : eighths;
    eighths = bits < 0 ? 4.0 - eighths : eighths;
    sign = bits < 0 ? -sign : sign;
    result = eighths * EIGHTH
        + (sign * t + (sign * rest + eighths * 0x1.1a62633145c07p-55));
    return copysign(result, y);
}

/*
 * The same for any number, in a loop over samples, where a branch costs nothing, and each number
 * waits for the one before: small angles, which are the rule, take the shortest way.
 */
INLINE double step_sin(double angle)
{
    const double size = fabs(angle);
    return size < EIGHTH ? near_sine(angle) : size < LARGEST_ANGLE ? column_sin(angle) : sin(angle);
}

INLINE double step_cos(double angle)
{
    const double size = fabs(angle);
    return size < EIGHTH ? cosine_of_square(angle * angle)
        : size < LARGEST_ANGLE ? column_cos(angle) : cos(angle);
}

INLINE double step_atan2(double y, double x)
{
    const double most = fabs(y) + fabs(x);
    if (fabs(y) <= TAN_SIXTEENTH * x && x > 0.0 && most - most == 0.0) {
        const double t = y / x;
        return t + near_arctangent_less(t);
    }
    return most - most == 0.0 ? column_atan2(y, x) : atan2(y, x);
}

/*
 * The same of factor * sqrt(square), where a small angle needs no root: its cosine, and its sine
 * divided by it. Below 1.2 degrees, as from sample to sample, fewer terms do.
 */
#define SMALL_SQUARE 0x1p-11

INLINE double step_cos_of_root(double factor, double square)
{
    const double z = factor * factor * square, half = 0.5 * z, most = 1.0 - half;
    if (z < SMALL_SQUARE)
        return most + (((1.0 - most) - half) + z * z * (1.0 / 24.0 - z * (1.0 / 720.0)));
    return z < EIGHTH * EIGHTH ? cosine_of_square(z) : step_cos(factor * sqrt(square));
}

INLINE double step_sinc_of_root(double factor, double square)
{
    const double z = factor * factor * square, angle = factor * sqrt(square);
    if (z < SMALL_SQUARE)
        return 1.0 - z * (1.0 / 6.0 - z * (1.0 / 120.0 - z * (1.0 / 5040.0)));
    return z < EIGHTH * EIGHTH ? 1.0 + z * sine_tail(z) : step_sin(angle) / angle;
}

/*
 * And of share * atan2(sqrt(square), x), with a share of at most 1/2: the cosine, and the sine
 * divided by the root. A root of zero counts as no angle, whatever x is. sides: square + x * x, where
 * it is known earlier.
 *
 * Up to 7 degrees both are series in the squared sine of the whole angle. Each factor is the one
 * before times (n * n - share * share) / ((n + 1) * (n + 2)), with n = 0, 2, 4... for the cosine
 * and 1, 3, 5... for the sine divided by that of the whole angle. None of them waits for the angle,
 * and quotients wait for the sides alone.
 */
INLINE int is_narrow(double square, double x, double sides)
{
    return x > 0.0 && square <= 0x1p-6 * sides;
}

/* Such a series at z, from the first factor and the first n; below 0.6 degrees, half of it. */
INLINE double in_squared_sine(double first, double n, double share, double z)
{
    const double z2 = z * z;
    double by[8] = {first}, sum;
    for (int k = 1; k < 8; k++, n += 2.0)
        by[k] = by[k - 1] * ((n * n - share * share) * (1.0 / ((n + 1.0) * (n + 2.0))));
    sum = (by[0] + z * by[1]) + z2 * (by[2] + z * by[3]);
    return z < 0x1p-13 ? sum : sum + z2 * z2 * ((by[4] + z * by[5]) + z2 * (by[6] + z * by[7]));
}

INLINE double step_cos_of_share(double share, double square, double x, double sides)
{
    if (is_narrow(square, x, sides)) return in_squared_sine(1.0, 0.0, share, square * (1.0 / sides));
    return square > 0.0 ? step_cos(share * step_atan2(sqrt(square), x)) : 1.0;
}

INLINE double step_sin_of_share(double share, double square, double x, double sides)
{
    if (is_narrow(square, x, sides))
        return in_squared_sine(share, 1.0, share, square * (1.0 / sides)) * (1.0 / sqrt(sides));
    return square > 0.0 ? step_sin(share * step_atan2(sqrt(square), x)) / sqrt(square) : 0.0;
}

#endif
