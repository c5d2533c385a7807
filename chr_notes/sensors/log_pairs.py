"""Whether the sensors of a log have the same axes, and the gyro its unit: what pairs of them tell.

Gyro and another sensor: by `relate_axes`, and gyro and accelerometer more surely by rests, between
which the gyro has to turn the vertical as the accelerometer says. Accelerometer and magnetometer:
the angle between the vertical and the field is the same however they are turned.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise, permutations, product

import numpy as np
from numpy.typing import NDArray

from chr_notes._arrays import Floats
from chr_notes.quaternions.algebra import quaternion_multiply, rotate_to_body
from chr_notes.quaternions.conversions import quaternion_from_axis_angle
from chr_notes.sensors.axes import AxesRelation, relate_axes
from chr_notes.sensors.log_axes import named

SIGNED = np.array(
    [
        np.diag(signs)[list(order)]
        for order in permutations(range(3))
        for signs in product((1.0, -1.0), repeat=3)
    ]
)
"""All signed permutations."""

_ROWS = 6_000
_RATE = 50.0  # Hz; enough for how sensors turn together
_FEW = 5  # one row of so many chooses the part of a long log
_SURE = 0.75  # share of an accelerometer's changes that turning explains, so that it tells
_TURNED = np.cos(np.radians(20.0))  # between two rests, at least
_LONGEST, _MOST, _FEWEST = 40.0, 6, 3  # seconds between rests; how many pairs of them
FITS, _FAILS = np.radians(12.0), np.radians(20.0)
_GAP = 0.1  # seconds, over which a gyro's reading is held at most
_STEADY, _AHEAD = 0.12, 2.0  # spread of the angle's cosine; how far the next best is behind
_NEAR_GRAVITY = 0.1
_OUTLIER = 5.0  # medians
_FEWEST_ANGLES = 50
_LEAST = float(np.finfo(np.float64).tiny)


@dataclass(frozen=True)
class Pair:
    """What a log tells of two sensors.

    Parameters
    ----------
    fitting
        Signed permutations from the second sensor's axes to the first's that are not ruled out, the
        best one first, shape (K, 3, 3); all 48 if the log does not tell.
    known
        Whether one is left, or one and its negative where the log cannot tell these apart.
    how
        A sentence.
    """

    fitting: Floats
    known: bool
    how: str

    @property
    def same(self) -> bool:
        """Whether both may have the same axes."""
        return any(np.array_equal(each, np.eye(3)) for each in self.fitting)


def relations(gyro: Floats, others: Mapping[str, Floats], dt: Floats) -> dict[str, AxesRelation]:
    """Relate a gyro to other sensors, in a long log where the gyro turns most."""
    every = max(1, round(1 / (float(np.median(dt)) * _RATE)))
    length = every * _ROWS
    start = 0
    if others and len(gyro) > length:
        # Glitches must not choose the part, and cube roots hardly notice them.
        some = np.nan_to_num(gyro[:: every * _FEW])
        turning = np.cbrt(np.abs(some - np.median(some, axis=0))).sum(axis=1)
        total = np.concatenate([[0.0], np.cumsum(turning)])
        wide = _ROWS // _FEW
        start = every * _FEW * int(np.argmax(total[wide:] - total[:-wide]))
    stop = start + min(length, len(gyro) - start) // every * every

    def means(values: Floats) -> Floats:
        return np.asarray(values[start:stop].reshape(-1, every, 3).mean(axis=1))

    steps = dt[start:stop].reshape(-1, every).sum(axis=1)
    return {name: relate_axes(means(gyro), means(values), steps) for name, values in others.items()}


def by_turning(found: AxesRelation, *, steady: bool) -> Pair:
    """Take what `relate_axes` says, of a vector that is steady in the room or an accelerometer."""
    tells = bool(np.isfinite(found.factors).all()) and (steady or found.explained >= _SURE)
    return Pair(found.candidates if tells else SIGNED, tells and found.known, str(found))


@dataclass(frozen=True)
class Rests:
    """How far from what the accelerometer says each reading of the gyro turns the vertical.

    Parameters
    ----------
    residuals
        Radians, root mean square over pairs of rests, for each factor and signed permutation,
        shape (F, 48).
    count
        How many pairs of rests there are.
    """

    residuals: Floats
    count: int

    @property
    def tells(self) -> bool:
        """Whether there are enough turns, of which one reading explains all."""
        return self.count >= _FEWEST and bool(self.residuals.min() < FITS)

    def pair(self, factor: int) -> Pair:
        """Compare the axes, with one of the factors."""
        residuals = self.residuals[factor]
        order = np.argsort(residuals, kind="stable")
        least = float(residuals[order[0]])
        how = (
            f"the gyro turns the vertical from rest to rest, {self.count} times, and ends "
            f"{np.degrees(least):.1f}° off the accelerometer's with the axes that fit best"
        )
        if self.count < _FEWEST or least >= FITS:
            return Pair(SIGNED, known=False, how=how)
        fitting = SIGNED[order[residuals[order] < _FAILS]]
        return Pair(fitting, len(fitting) == 1, how)


def between_rests(
    gyro: Floats, accel: Floats, dt: Floats, rests: list[tuple[int, int]], factors: list[float]
) -> Rests:
    """Turn the vertical by the gyro from one rest to the next.

    Parameters
    ----------
    gyro, accel
        Readings, shape (N, 3), in any unit.
    dt
        Seconds, shape (N,).
    rests
        First and last row of each.
    factors
        From readings of the gyro to rad/s, that are tried.
    """
    verticals = [_direction(accel[start:stop].mean(axis=0)) for start, stop in rests]
    squares, count = np.zeros((len(factors), len(SIGNED))), 0
    bias = np.median(
        [gyro[start:stop].mean(axis=0) for start, stop in rests] or [[0.0] * 3], axis=0
    )
    for (before, after), (first, second) in zip(pairwise(rests), pairwise(verticals), strict=True):
        rows = slice(sum(before) // 2, sum(after) // 2)
        passed = dt[rows]
        unfit = not first @ second < _TURNED or passed.sum() > _LONGEST
        usual = float(np.median(passed))
        if unfit or not np.isfinite(gyro[rows]).all() or passed.max() > max(_GAP, 3 * usual):
            continue
        angles = _together((gyro[rows] - bias) * passed[:, np.newaxis], usual)
        for place, factor in enumerate(factors):
            turned = rotate_to_body(_turn(factor * angles @ SIGNED.transpose(0, 2, 1)), first)
            cosines = np.clip(turned @ second, -1.0, 1.0)
            squares[place] += np.arccos(cosines) ** 2
        count += 1
        if count == _MOST:
            break
    return Rests(np.sqrt(squares / max(count, 1)), count)


def _direction(vector: Floats) -> Floats:
    return vector / max(float(np.linalg.norm(vector)), _LEAST)


def _together(angles: Floats, step: float) -> Floats:
    """Add small angles that follow each other, where there are more than are needed."""
    every = max(1, round(1 / (step * _RATE)))
    return np.add.reduceat(angles, np.arange(0, len(angles), every), axis=0)


def _turn(angles: Floats) -> Floats:
    """Turn by one angle after another, shape (48, N, 3) to (48, 4)."""
    sizes = np.sqrt((angles**2).sum(axis=-1))
    axes = np.where(sizes[..., np.newaxis] > 0, angles, [1.0, 0.0, 0.0])
    turns = quaternion_from_axis_angle(axes, sizes)
    while turns.shape[1] > 1:
        even = turns.shape[1] // 2 * 2
        pairs = quaternion_multiply(turns[:, 0:even:2], turns[:, 1:even:2])
        turns = np.concatenate([pairs, turns[:, even:]], axis=1)
    return turns[:, 0]


def by_angle(accel: Floats, mag: Floats) -> Pair:
    """Compare accelerometer and magnetometer by the angle between vertical and field.

    A reading and its negative give angles that vary as little: both fit or none.
    """
    every = max(1, 2 * len(accel) // _ROWS)
    accel, mag = accel[::every], mag[::every]
    norms = np.sqrt((accel**2).sum(axis=1))
    known = np.isfinite(norms) & np.isfinite(mag).all(axis=1) & (mag != 0).any(axis=1)
    if known.any():
        known &= np.abs(norms / np.median(norms[known]) - 1) < _NEAR_GRAVITY
        strengths = np.sqrt((mag**2).sum(axis=1))
        known &= strengths <= _OUTLIER * np.median(strengths[known])
    up, field = accel[known] / norms[known, np.newaxis], mag[known]
    if len(up) < _FEWEST_ANGLES:
        return Pair(SIGNED, known=False, how="there are too few whole readings")
    # As it is read, and less the iron that explains most, a vector in the magnetometer's axes.
    sizes = np.sqrt((field**2).sum(axis=1))[:, np.newaxis]
    # einsum runs in one thread: for so little several cost more than they save.
    turned = SIGNED.reshape(-1, 9)
    products = (up[:, :, np.newaxis] * field[:, np.newaxis]).reshape(-1, 9)
    along = np.einsum("np,kp->nk", products, turned)
    base = np.column_stack([up, np.ones(len(up))])
    normal = np.einsum("ni,nj->ij", base, base)
    iron = np.linalg.pinv(normal) @ np.einsum("ni,nk->ik", base, along)
    spread = float(np.sqrt(field.var(axis=0).sum()))
    plain = (along / sizes).std(axis=0)
    rest = along - np.einsum("ni,ik->nk", base, iron)
    less_iron = rest.std(axis=0) / max(spread, _LEAST)
    best, next_best, order = min(
        map(_compared, (plain, less_iron)), key=lambda each: each[0] / each[1]
    )
    how = (
        "the cosine of the angle between vertical and field, which should stay the same, varies by "
        f"{best:.2g} with the axes that fit best and by {next_best:.2g} with the next best"
    )
    tells = best < _STEADY and next_best > _AHEAD * best
    return Pair(SIGNED[order[:2]] if tells else SIGNED, tells, how)


def _compared(spreads: Floats) -> tuple[float, float, NDArray[np.intp]]:
    """Give the least spread, the next one but for a sign, and the order."""
    order = np.argsort(spreads, kind="stable")
    return float(spreads[order[0]]), max(float(spreads[order[2]]), _LEAST), order


def disagreement(pairs: Mapping[tuple[str, str], Pair]) -> str | None:
    """Say what to pass where sensors do not have the same axes; None where they may."""
    wrong = {sensors: pair for sensors, pair in pairs.items() if not pair.same}
    if not wrong:
        return None
    right = {
        each for sensors, pair in pairs.items() if pair.known and pair.same for each in sensors
    }
    blamed = [each for sensors in wrong for each in sensors if each not in right]
    blamed = blamed or [each for sensors in wrong for each in sensors]
    odd = {each for each in blamed if blamed.count(each) == max(map(blamed.count, blamed))}
    advice: dict[str, list[Floats]] = {}
    for sensors, pair in wrong.items():
        for sensor in sorted(odd & {*sensors}, reverse=True):
            matrix = pair.fitting[0] if sensor == sensors[1] else pair.fitting[0].T
            if sensor == "gyro":
                advice.setdefault(sensor, [matrix])
            elif "gyro" not in sensors or np.linalg.det(matrix) > 0:
                # A vector's negative turns as it does.
                advice.setdefault(sensor, [matrix, -matrix])
    texts = [f"{{'{each}': '{named(m)}'}}" for each, matrices in advice.items() for m in matrices]
    names = ", ".join(" and ".join(sensors) for sensors in wrong)
    how = "; ".join(pair.how for pair in wrong.values())
    return f"axes: expected the same of {names}, got others ({how}); pass axes={' or '.join(texts)}"
