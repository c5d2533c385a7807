"""Times of many digits, and dates, counted from the first one of a log, many at a time."""

import numpy as np
from numpy.typing import NDArray

from chr_notes._arrays import Floats
from chr_notes.sensors.log_fields import Fields
from chr_notes.sensors.log_numbers import DATE, Origin

_LETTERS = 40  # of a time, at most
_LENGTHS = 20  # kinds of them
_DIGITS = 18  # that a whole number of 64 bits holds
_LAST = (24, 60, 60)  # hours, minutes, seconds are below
_NANOSECONDS = 9  # digits of them
_CLOCK, _FRACTION = 11, 20  # letters before them, in "2024-05-01 12:30:00.25"

Letters = NDArray[np.uint8]
Whole = NDArray[np.int64]


def since_first(first: Origin, times: Fields) -> tuple[Floats, NDArray[np.bool_]]:
    """Count times from the first one, as `log_numbers.since` does one by one.

    Parameters
    ----------
    first
        As `log_numbers.origin` gives it.
    times
        Fields without white space or quotes around them.

    Returns
    -------
    values, read : ndarray
        In the unit of the log, or for dates in seconds, and for which fields they are right: all
        that are written alike.
    """
    values, read = np.full(len(times.ends), np.nan), np.zeros(len(times.ends), dtype=np.bool_)
    lengths = times.ends - times.starts
    for length in np.unique(lengths)[:_LENGTHS].tolist():
        if not 0 < length <= _LETTERS:
            continue
        rows = np.flatnonzero(lengths == length)
        letters = times.all[times.starts[rows, np.newaxis] + np.arange(length)]
        digits = letters - np.uint8(ord("0"))  # any other letter is above 9
        alike = ((digits[0] < 10) & (digits < 10) | (letters == letters[0])).all(axis=1)  # noqa: PLR2004
        count = _dates if isinstance(first, np.datetime64) else _numbers
        found, right = count(first, letters, digits.astype(np.int64))
        values[rows], read[rows] = found, right & alike
    return values, read


def _whole(digits: Whole) -> Whole:
    """Put digits together, shape (N, count) to (N,)."""
    number = np.zeros(len(digits), dtype=np.int64)
    for column in digits.T:
        number = 10 * number + column
    return number


def _none(letters: Letters) -> tuple[Floats, NDArray[np.bool_]]:
    return np.full(len(letters), np.nan), np.zeros(len(letters), dtype=np.bool_)


def _numbers(first: Origin, letters: Letters, digits: Whole) -> tuple[Floats, NDArray[np.bool_]]:
    """Count numbers of digits with at most a point."""
    text = letters[0].tobytes().decode("latin-1")
    whole, point, part = text.partition(".")
    figures = whole + part
    # Of all digits but the first ones, which only a long log changes.
    if not (figures.isascii() and figures.isdigit() and len(figures) <= _DIGITS + 1 and whole):
        return _none(letters)
    kept = np.delete(digits, len(whole), axis=1) if point else digits
    beyond = max(len(figures) - _DIGITS, 0)
    scaled = int(first.scaleb(len(part)).to_integral_value())  # type: ignore[union-attr]
    if first.scaleb(len(part)) != scaled:  # type: ignore[union-attr]
        return _none(letters)
    # Leading digits that an integer does not hold are the same in all.
    ahead = int(figures[:beyond] or "0") * 10 ** (len(figures) - beyond)
    if abs(scaled - ahead) >= 10**_DIGITS:
        return _none(letters)
    passed = _whole(kept[:, beyond:]) - (scaled - ahead)
    right = (kept[:, :beyond] == kept[0, :beyond]).all(axis=1) & (np.abs(passed) < 2**53)
    return passed / 10.0 ** len(part), right


def _dates(first: Origin, letters: Letters, digits: Whole) -> tuple[Floats, NDArray[np.bool_]]:
    """Count dates of one form and zone."""
    match = DATE.fullmatch(letters[0].tobytes().decode("latin-1"))
    if match is None:
        return _none(letters)
    zone = match.start(3) if match[3] else letters.shape[1]
    right = (letters[:, zone:] == letters[0, zone:]).all(axis=1)
    days = np.zeros(len(letters), dtype=np.int64)
    written, which = np.unique(
        _whole(np.delete(digits[:, :10], (4, 7), axis=1)), return_inverse=True
    )
    for place, day in enumerate(written.tolist()):
        own = which == place
        try:
            since = np.datetime64(f"{day // 10000:04d}-{day // 100 % 100:02d}-{day % 100:02d}", "D")
        except ValueError:  # a thirteenth month
            right[own] = False
        else:
            days[own] = since.astype(np.int64)
    seconds, start = 86400 * days, _CLOCK
    for last, unit in zip(_LAST, (3600, 60, 1), strict=True):
        if start + 2 <= zone:
            part = _whole(digits[:, start : start + 2])
            right &= part < last
            seconds += unit * part
        start += 3
    fraction = digits[:, min(_FRACTION, zone) : zone]
    nano = _whole(fraction) * 10 ** (_NANOSECONDS - fraction.shape[1])
    if match[3] and match[3] != "Z":
        minutes = 60 * int(match[3][1:3]) + int(match[3][-2:])
        seconds -= 60 * minutes * (1 if match[3][0] == "+" else -1)
    begin = int(first.astype(np.int64))  # type: ignore[union-attr]
    # A nanosecond count of 64 bits ends in 2262.
    right &= np.abs(seconds) < 2**33
    passed = (np.where(right, seconds, 0) * 10**9 + nano) - begin
    return passed * 1e-9, right
