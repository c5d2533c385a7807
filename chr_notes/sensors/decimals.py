"""Decimal numbers out of text, many at a time, rounded as `float` rounds them.

A compiled function reads them (native/decimals.h). Where it was not built, eight letters are one
64-bit word, on which NumPy works for all fields of a text at once; three words hold 24 letters.
"""

import numpy as np
from numpy.typing import NDArray

from chr_notes._arrays import Floats
from chr_notes._kernels import kernel

Words = NDArray[np.uint64]
Places = NDArray[np.int64]

_COMPILED = kernel("decimals")
_PADDING = 24  # letters in front of the first field, which are not read
_LETTERS = 8  # of a word
_ZEROS = int.from_bytes(b"0" * 8)
_POINTS = int.from_bytes(b"." * 8)
_ONES, _HIGH, _TENS, _UNITS = (int.from_bytes(bytes([each]) * 8) for each in (1, 128, 240, 15))
_ALL = 2**64 - 1
# The last 0 to 8 letters of a word, which are its high bytes.
_KEPT = np.array([_ALL - 2 ** (64 - 8 * count) + 1 for count in range(9)], dtype=np.uint64)
_FILLED = ~_KEPT & np.uint64(_ZEROS)
_EXACT = 2**53  # below it every whole number is a double
_POWERS: Floats = 10.0 ** np.arange(23, dtype=np.float64)  # every one of them is a double
_MOST = 1843  # times 10^16: below 2^64, whatever stands in the other two words
_POWER_OF_TEN = 4  # letters, as in "e-05"
_NINE = 9
# Neighbours become one number: pairs of digits, then fours, then all eight.
_TOGETHER = (
    (np.uint64(10 * 2**8 + 1), np.uint64(8), np.uint64(0x00FF00FF00FF00FF)),
    (np.uint64(100 * 2**16 + 1), np.uint64(16), np.uint64(0x0000FFFF0000FFFF)),
    (np.uint64(10_000 * 2**32 + 1), np.uint64(32), np.uint64(_ALL)),
)
_SPLIT = 2.0**27 + 1


def decimals(
    text: NDArray[np.uint8], starts: Places, ends: Places
) -> tuple[Floats, NDArray[np.bool_]]:
    """Read fields such as "-12.5" or "1.25e+01".

    Parameters
    ----------
    text
        Bytes, shape (L,).
    starts, ends
        Place of each field's first letter, and of what comes after its last, shape (N,).

    Returns
    -------
    values, read : ndarray
        Numbers, and for which fields they are right. The others are no such numbers, are beyond
        what a double holds, or have very many letters.
    """
    return (_COMPILED or _by_numpy)(text, starts, ends)


def _by_numpy(
    text: NDArray[np.uint8], starts: Places, ends: Places
) -> tuple[Floats, NDArray[np.bool_]]:
    """Read digits with at most a point and a two-digit power of ten; no others."""
    text = np.concatenate([np.full(_PADDING, ord("0"), dtype=np.uint8), text])
    starts, ends = starts + _PADDING, ends + _PADDING
    first = text[starts]
    negative = first == ord("-")
    length = ends - starts - (negative | (first == ord("+")))
    ends, length, tens, read = _power_of_ten(text, ends, length)
    count = min(max(-(-int(length.max(initial=1)) // _LETTERS), 1), _PADDING // _LETTERS)
    overlapping: Words = np.ndarray((len(text) - 7,), "<u8", text, strides=(1,))
    words = []
    for place in range(count):
        kept = length - _LETTERS * place
        word = overlapping[ends - _LETTERS * (place + 1)]
        word &= _KEPT.take(kept, mode="clip")
        word |= _FILLED.take(kept, mode="clip")
        words.append(word)
    moved = _without_point(words)
    read &= (length > (moved > 0)) & (length <= _LETTERS * count)
    whole = np.zeros(len(starts), dtype=np.uint64)
    for place in reversed(range(count)):
        word = words[place]
        read &= (word & _TENS | (word + _ONES * 6 & _TENS) >> 4) == _ONES * 0x33
        number = _number(word)
        if place == 2:  # noqa: PLR2004 (the third word)
            read &= number <= _MOST
        whole = whole * 10**8 + number
    places = np.where(moved > 0, _LETTERS * count - moved.astype(np.int64), 0) - tens
    read &= np.abs(places) < len(_POWERS)
    powers: Floats = _POWERS[np.minimum(np.abs(places), len(_POWERS) - 1)]
    values = whole.astype(np.float64)
    up = places < 0
    np.divide(values, powers, where=~up, out=values)
    np.multiply(values, powers, where=up, out=values)
    if count > 1:
        long = np.flatnonzero(whole >= _EXACT)
        if long.size:
            values[long], near = _quotients(whole[long], powers[long])
            read[long[near | up[long]]] = False
    np.negative(values, where=negative, out=values)
    return values, read


def _power_of_ten(
    text: NDArray[np.uint8], ends: Places, length: Places
) -> tuple[Places, Places, Places | int, NDArray[np.bool_]]:
    """Cut off what says the power of ten, and say what it is and where it is a number."""
    has = text[ends - _POWER_OF_TEN] >= ord("E")  # no digit, sign or point is
    if has.any():
        has = ((text[ends - _POWER_OF_TEN] | 32) == ord("e")) & (length > _POWER_OF_TEN)
    if not has.any():
        return ends, length, 0, np.ones(len(ends), dtype=np.bool_)
    sign, ten, one = (text[ends - place] for place in (3, 2, 1))
    ten, one = ten - ord("0"), one - ord("0")  # any other letter is far above 9
    whole = ((sign == ord("+")) | (sign == ord("-"))) & (np.maximum(ten, one) <= _NINE)
    tens = np.where(sign == ord("-"), -1, 1) * (10 * ten.astype(np.int64) + one)
    cut = _POWER_OF_TEN * has
    return ends - cut, length - cut, np.where(has, tens, 0), ~has | whole


def _without_point(words: list[Words]) -> NDArray[np.uint8]:
    """Move what stands left of the last word's point one letter to the right, over the point.

    Returns
    -------
    ndarray
        How many letters of all words were moved, the point included; 0 without a point.
    """
    moved = np.zeros(len(words[0]), dtype=np.uint8)
    behind = np.zeros(len(words[0]), dtype=np.uint64)
    for place, word in enumerate(words):
        differing = word ^ _POINTS
        points = (differing - _ONES) & ~differing & _HIGH
        lowest = points & (~points + 1)
        mask = (lowest << 1) - (lowest != 0) | behind  # of the letters up to the point
        before = words[place + 1] >> 56 if place + 1 < len(words) else ord("0")
        words[place] = word & ~mask | (word << 8 | before) & mask
        moved += np.bitwise_count(mask) >> 3
        behind = np.where(mask != 0, np.uint64(_ALL), np.uint64(0))
    return moved


def _number(word: Words) -> Words:
    """Read eight digits."""
    number: Words = word & np.uint64(_UNITS)
    for factor, shift, mask in _TOGETHER:
        number = number * factor >> shift & mask
    return number


def _quotients(whole: Words, powers: Floats) -> tuple[Floats, NDArray[np.bool_]]:
    """Divide whole numbers of up to 64 bits, and say where the rounding is too close to call."""
    high = whole.astype(np.float64)
    low = (whole - high.astype(np.uint64)).view(np.int64).astype(np.float64)
    first = high / powers
    # What is left, exactly: Dekker's product of two doubles.
    product = first * powers
    one, two = _halves(first), _halves(powers)
    error = ((one[0] * two[0] - product) + one[0] * two[1] + one[1] * two[0]) + one[1] * two[1]
    second = ((high - product) - error + low) / powers
    values = first + second
    rest = np.abs(second - (values - first)) / np.spacing(values)
    # Below a power of two doubles lie twice as close.
    near = np.where(np.frexp(values)[0] == 0.5, np.abs(rest - 0.25), 1.0) < 1e-6  # noqa: PLR2004
    return values, near | (np.abs(rest - 0.5) < 1e-6)  # noqa: PLR2004


def _halves(values: Floats) -> tuple[Floats, Floats]:
    """Split doubles into two of half the digits each."""
    large = values * _SPLIT
    high = large - (large - values)
    return high, values - high
