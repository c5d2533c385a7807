"""Calibration of gyros from a log: at rest, over temperature, and by turns of known angle."""

from collections.abc import Sequence
from operator import index

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats, floats
from chr_notes._samples import complete, periods, same_length, samples
from chr_notes.sensors.calibration import fit_gyro_bias
from chr_notes.sensors.models import RateGyroCalibration
from chr_notes.sensors.still import STILL_LIMIT, static_interval, steady_mean, without_glitches

_LEAST_SPAN = 2.0  # °C, below which noise makes any slope
_MOST_OFF = 0.3  # of a turn, that a wrong sensitivity explains
_STILL_VERTICAL = np.radians(2.0)
_PARTS = 20
_NOTHING = np.zeros((3, 3))


def fit_gyro_at_rest(
    body_rates: ArrayLike,
    temperature: ArrayLike | None = None,
    *,
    degree: int = 2,
    accel: ArrayLike | None = None,
) -> RateGyroCalibration:
    """Find the bias of a gyro that lies still, and how it depends on temperature.

    The calibration's `correct` makes the readings zero. Its bias is minus what the gyro read, for
    the model of the notes subtracts it; `fit_gyro_bias` gives the same. From rates alone nobody
    tells a steady turn from a bias; an accelerometer does, unless the turn is about the vertical.

    Parameters
    ----------
    body_rates
        Readings at rest, rad/s, shape (N, 3). Rows with NaN are left out, and glitches.
    temperature
        °C, shape (N,); without it the bias is one number an axis.
    degree
        Of the polynomial in temperature.
    accel
        What an accelerometer read meanwhile, any unit, shape (N, 3).

    Returns
    -------
    RateGyroCalibration
        With sensitivity 1, no misalignment and no g-sensitivity.

    Raises
    ------
    ValueError
        If the sensor moved: if the rates vary about the polynomial by more than 0.02 rad/s. If the
        temperature changes by less than 2 °C, or the degree is negative. If the accelerometer
        turned by more than 2°.
    TypeError
        If the degree is no whole number.

    See Also
    --------
    chr_notes.sensors.calibration.fit_gyro_bias
    fit_gyro_scale

    Notes
    -----
    Ledger: sensors.3.2.

    Examples
    --------
    >>> import numpy as np
    >>> warmth = np.linspace(20, 40, 500)
    >>> rates = np.stack([0.01 + 0.001 * (warmth - 20), 0 * warmth, 0 * warmth], axis=1)
    >>> found = fit_gyro_at_rest(rates, warmth, degree=1)
    >>> found.correct([0.02, 0, 0], accel=[0, 0, -9.8], temperature=30.0).round(9).tolist()
    [0.0, 0.0, 0.0]
    """
    rates = samples("body_rates", body_rates)
    if accel is not None:
        _refuse_turning(rates, samples("accel", accel))
    if temperature is None:
        return _gyro(np.eye(3), np.ones(3), fit_gyro_bias(rates))
    warmth = _temperatures(temperature, len(rates))
    known = complete(rates) & np.isfinite(warmth)
    rates, warmth = rates[known], warmth[known]
    coefficients = _over_temperature(warmth, rates, degree)
    for _ in range(2):  # again without what lies off
        off = rates - np.polynomial.polynomial.polyval(warmth, coefficients).T
        kept = ~(without_glitches(off)[1] & (np.abs(off).max(axis=1) > STILL_LIMIT))
        coefficients = _over_temperature(warmth[kept], rates[kept], degree)
    off = rates[kept] - np.polynomial.polynomial.polyval(warmth[kept], coefficients).T
    spread = off.std(axis=0)
    if not spread.max() <= STILL_LIMIT:
        msg = (
            f"body_rates: expected a sensor at rest, with a standard deviation of at most "
            f"{STILL_LIMIT} rad/s about a polynomial in temperature, got {spread.max():.3g} rad/s "
            f"about the {'xyz'[int(spread.argmax())]}-axis"
        )
        raise ValueError(msg)
    return _gyro(np.eye(3), np.ones(3), -coefficients, warmth)


def fit_gyro_scale(  # noqa: PLR0913 (what was known before, and what of temperature)
    body_rates: ArrayLike,
    dt: ArrayLike,
    turns: Sequence[tuple[slice, ArrayLike]],
    *,
    at_rest: RateGyroCalibration | None = None,
    temperature: ArrayLike | None = None,
    degree: int = 1,
) -> RateGyroCalibration:
    """Find sensitivity and misalignment of a gyro from turns of known angle.

    Over a turn about a fixed axis, readings without bias add up to what the sensor makes of the
    axis times the angle. Turns about three axes give the whole matrix by least squares. In
    directions in which nothing was turned, the sensor is taken to be as it should be.

    Parameters
    ----------
    body_rates
        Readings, rad/s, shape (N, 3).
    dt
        Time step of each sample, seconds: a number, or shape (N,).
    turns
        Of each turn the rows that hold it, from rest to rest, and its axis times its angle in
        radians, shape (3,), such as `(slice(100, 400), [0, 0, 2 * np.pi])`.
    at_rest
        From `fit_gyro_at_rest`; by default the bias of the stillest second of the log.
    temperature
        °C, shape (N,). With it the sensitivity is a polynomial in temperature, found from turns
        about each axis at several temperatures, and there is no misalignment.
    degree
        Of that polynomial.

    Returns
    -------
    RateGyroCalibration
        With the bias, and without g-sensitivity.

    Raises
    ------
    ValueError
        If there is no turn, a row of one is missing, or an angle is more than 30 % off what the
        gyro says: it turned the other way, or the unit is another.

    See Also
    --------
    fit_gyro_at_rest

    Notes
    -----
    Ledger: sensors.3.2. The matrix from three turns is that of Ferraris, Grimaldi and Parvis,
    Procedure for effortless in-field calibration of three-axial rate gyro and accelerometers, 1995.

    Examples
    --------
    >>> import numpy as np
    >>> rates = np.zeros((400, 3))
    >>> rates[200:300, 2] = 1.05 * np.pi / 2
    >>> found = fit_gyro_scale(rates, 0.01, [(slice(200, 300), [0, 0, np.pi / 2])])
    >>> found.sensitivity.round(6).tolist()
    [[1.0, 1.0, 1.05]]
    """
    rates = samples("body_rates", body_rates)
    steps = np.broadcast_to(periods(dt, len(rates)), (len(rates),))
    if not turns:
        msg = "turns: expected at least one turn, got none"
        raise ValueError(msg)
    if at_rest is None:
        second = int(np.clip(1 / max(float(np.median(steps)), 1e-6), 2, len(rates)))
        at_rest = fit_gyro_at_rest(rates[static_interval(rates, second)])
    warmth = None if temperature is None else _temperatures(temperature, len(rates))
    steady = at_rest.correct(rates, np.zeros(3), warmth)
    angles = np.array([_turn(number, turn) for number, (_, turn) in enumerate(turns)])
    seen = np.array([(steady[part] * steps[part, np.newaxis]).sum(axis=0) for part, _ in turns])
    _refuse_other_turns(seen, angles)
    if warmth is None:
        matrix = np.eye(3) + (np.linalg.pinv(angles) @ (seen - angles)).T
        sensitivity = np.diagonal(matrix)
        misalignment = matrix / sensitivity
        bias = np.linalg.solve(misalignment, at_rest.bias.T).T
        return RateGyroCalibration(misalignment, sensitivity, bias, _NOTHING, at_rest.temperatures)
    means = np.array([warmth[part].mean() for part, _ in turns])
    coefficients = np.zeros((degree + 1, 3))
    coefficients[0] = 1.0
    largest = np.abs(angles).argmax(axis=1)
    for axis in np.unique(largest):
        own = largest == axis
        ratio = seen[own, axis] / angles[own, axis]
        coefficients[:, axis] = _over_temperature(means[own], ratio[:, np.newaxis], degree)[:, 0]
    told = np.concatenate([warmth[part] for part, _ in turns])
    return _gyro(np.eye(3), coefficients, at_rest.bias, told)


def _gyro(
    misalignment: Floats, sensitivity: Floats, bias: Floats, warmth: Floats | None = None
) -> RateGyroCalibration:
    span = None if warmth is None else (float(warmth.min()), float(warmth.max()))
    return RateGyroCalibration(misalignment, sensitivity, bias, _NOTHING, span)


def _turn(number: int, turn: ArrayLike) -> Floats:
    vector = floats(f"turns: the vector of turn {number}", turn, 3)
    if vector.ndim != 1 or not np.isfinite(vector).all() or not vector.any():
        msg = f"turns: expected an axis times an angle, got {vector.tolist()} for turn {number}"
        raise ValueError(msg)
    return vector


def _refuse_turning(rates: Floats, forces: Floats) -> None:
    """Refuse a log in which the vertical turns in the axes of the sensor."""
    same_length(("body_rates", rates), ("accel", forces))
    known = forces[complete(forces)]
    parts = np.array_split(known, max(1, min(_PARTS, len(known))))
    means = np.array([steady_mean(part) for part in parts if len(part)]).reshape(-1, 3)
    sizes = np.linalg.norm(means, axis=1)
    if not (len(sizes) and (sizes > 0).all()):
        msg = f"accel: expected readings of gravity, got {len(known)} whole ones, or zero"
        raise ValueError(msg)
    up = means / sizes[:, np.newaxis]
    turned = float(2 * np.arcsin(np.linalg.norm(up - up[:1], axis=1).max() / 2))
    if turned > _STILL_VERTICAL:
        msg = (
            "body_rates: expected a sensor at rest, got one whose accelerometer turned by "
            f"{np.degrees(turned):.1f}° meanwhile; cut out a rest with static_intervals"
        )
        raise ValueError(msg)


def _refuse_other_turns(seen: Floats, angles: Floats) -> None:
    for number, (found, given) in enumerate(zip(seen, angles, strict=True)):
        size = np.linalg.norm(given)
        if not np.linalg.norm(found - given) <= _MOST_OFF * size:
            about = float(found @ given / size)
            msg = (
                f"turns: expected turn {number} to be {np.degrees(size):.0f}° about its axis, as "
                f"given, got {np.degrees(about):.0f}° from the gyro: was it the other way round, "
                "about another axis, or are the rates not in rad/s?"
            )
            raise ValueError(msg)


def _temperatures(value: ArrayLike, count: int) -> Floats:
    warmth = floats("temperature", value)
    if warmth.shape != (count,):
        msg = f"temperature: expected shape ({count},), got {warmth.shape}"
        raise ValueError(msg)
    return warmth


def _over_temperature(warmth: Floats, values: Floats, degree: int) -> Floats:
    """Fit a polynomial to each column; coefficients by power, shape (degree + 1, columns)."""
    degree = index(degree)
    if degree < 0:
        msg = f"degree: expected 0 or more, got {degree}"
        raise ValueError(msg)
    span = float(np.ptp(warmth)) if len(warmth) else 0.0
    if degree and not span >= _LEAST_SPAN:
        msg = (
            f"temperature: expected a change of at least {_LEAST_SPAN:.0f} °C, got {span:.2g} °C; "
            "warm the sensor up while it rests, or take degree=0"
        )
        raise ValueError(msg)
    if len(np.unique(warmth)) <= degree:
        msg = f"temperature: expected more than {degree} temperatures, got {len(np.unique(warmth))}"
        raise ValueError(msg)
    # About the middle of the temperatures the powers are told apart best.
    fits = [np.polynomial.Polynomial.fit(warmth, column, degree) for column in values.T]
    kept = [np.resize(fit.convert().coef, degree + 1) for fit in fits]
    return np.stack(kept, axis=1)
