"""Which axis of a gyro is which axis of another sensor, with sign and unit, from a log alone.

A vector that keeps its direction in the room, gravity or the Earth's field, changes in the body's
axes only because the body turns: dv/dt = v × ω. A log that holds both sides of this equation tells
how the axes of its sensors belong together.
"""

from dataclasses import dataclass
from itertools import permutations, product

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats
from chr_notes._rows import Rows
from chr_notes._samples import complete, periods, same_length, samples
from chr_notes.generated.arrays import sensors as generated

_vector_rate = Rows(generated.vector_rate)

_SMOOTHED = 0.1  # seconds: shorter than a turn by hand takes, longer than most vibrations
_WINDOW = 0.2  # seconds over which the equation is integrated
_GAP = 3.0  # a step of so many usual ones is not integrated over
_BLOCK = 0.5  # seconds that count as one observation: neighbouring windows say the same
_EXPLAINED = 0.5  # share of the changes that has to be explained
_CERTAIN = 3.0  # standard deviations
_NEAR = 1.25  # by how much a factor may differ from a unit
_USUAL, _MARGIN = 0.9, 1.5
_LEAST = np.finfo(np.float64).tiny
_SIGNED = np.array(
    [
        np.diag(signs)[list(order)]
        for order in permutations(range(3))
        for signs in product((1.0, -1.0), repeat=3)
    ]
)
_UNITS = {"rad/s": 1.0, "deg/s": np.pi / 180, "rev/min": np.pi / 30}


@dataclass(frozen=True, eq=False)
class AxesRelation:
    """How the axes of a gyro belong to those of another sensor.

    Parameters
    ----------
    matrix
        M, with body rates in the other sensor's axes and in rad/s = M times the gyro's reading:
        least squares, shape (3, 3).
    permutation
        The signed permutation that explains the log best, shape (3, 3).
    factor
        What it is multiplied by: 1 if the gyro reads rad/s, 0.01745 if it reads deg/s.
    explained
        Share of the other sensor's changes that permutation and factor explain, at most 1.
    certainty
        By how many standard deviations they explain more than the next best permutation.
    candidates
        The signed permutations that the log does not rule out, the best one first: those behind
        which it is by less than three standard deviations, shape (K, 3, 3); all 48 if not even
        the best one explains half of the changes.
    factors
        The factor of each, shape (K,); NaN where not even half is explained. With several
        candidates of one factor, the log knows the unit but not the axes.

    See Also
    --------
    relate_axes
    """

    matrix: Floats
    permutation: Floats
    factor: float
    explained: float
    certainty: float
    candidates: Floats
    factors: Floats

    @property
    def known(self) -> bool:
        """Whether the log can tell, and one permutation is left. Otherwise the best is a guess."""
        return len(self.candidates) == 1

    def __str__(self) -> str:
        """Say it in a sentence."""
        how = (
            f"explains {self.explained:.0%} of the changes, the next best {self.certainty:.1f} "
            "standard deviations worse"
        )
        if not self.known:
            return f"cannot tell ({how}): turn the sensor about all of its axes"
        axes = ", ".join(_named(row) for row in self.permutation)
        ratios = {name: self.factor / unit for name, unit in _UNITS.items()}
        near = (name for name, ratio in ratios.items() if max(ratio, 1 / ratio) < _NEAR)
        unit = next(near, f"{self.factor:.3g} rad/s")
        return f"x, y, z are the gyro's {axes}, in {unit} ({how})"


def relate_axes(body_rates: ArrayLike, vector: ArrayLike, dt: ArrayLike) -> AxesRelation:
    """Tell from a log which gyro axis is which axis of another sensor, with sign and unit.

    The other sensor is a magnetometer, for which dv/dt = v × ω holds exactly in a steady field, or
    an accelerometer, whose reading follows it as long as the body turns more than it accelerates.
    A vector and its opposite obey the same equation: a sensor that is negated as a whole is not
    found out, and one whose single axis is negated looks like one that is turned by 180°.

    Parameters
    ----------
    body_rates
        What the gyro reads, in any unit and in its own axes, shape (N, 3).
    vector
        What the other sensor reads, in any unit and in its own axes, shape (N, 3). Iron has to be
        small beside the field, or calibrated away.
    dt
        Time step before each sample, seconds: a number, or shape (N,).

    Returns
    -------
    AxesRelation
        Signed permutation, factor and matrix, and whether the log can tell. Rows with NaN or
        infinity, and gaps, are left out.

    Raises
    ------
    ValueError
        If a shape is wrong, or a time step is negative or no number.

    See Also
    --------
    chr_notes.frames.change_axes

    Notes
    -----
    The equation is integrated over a fifth of a second, which needs no derivative of noise, and
    solved by least squares; windows with large turns count as much as those with ordinary ones.
    Permutations are compared as Vuong does with models that are not nested ("Likelihood ratio
    tests for model selection and non-nested hypotheses", Econometrica 57, 1989): by the sum over
    seconds of the difference between their residuals, over the root of its sum of squares.

    Examples
    --------
    A sensor that is turned by hand, whose gyro has x and y swapped and reads degrees:

    >>> import numpy as np
    >>> import chr_notes
    >>> time = np.arange(0, 30, 0.01)
    >>> rates = np.stack([np.sin(2 * time), np.cos(1.3 * time), np.sin(0.7 * time)], axis=1)
    >>> euler = chr_notes.integrate_gyro(rates, 0.01)
    >>> mag = chr_notes.rotate_to_body(chr_notes.quaternion_from_euler(euler), [20.0, 0.0, 43.0])
    >>> found = chr_notes.relate_axes(np.degrees(rates)[:, [1, 0, 2]], mag, 0.01)
    >>> found.permutation.tolist()
    [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]
    >>> print(f"{found.factor:.4f}")
    0.0175
    """
    rates, readings = samples("body_rates", body_rates), samples("vector", vector)
    count = same_length(("body_rates", rates), ("vector", readings))
    steps = np.broadcast_to(periods(dt, count), (count,))
    step = float(np.median(steps)) if count else 0.0
    if not step > 0:
        return _UNKNOWN
    usable = complete(rates) & complete(readings) & (steps <= _GAP * step)
    rates, readings = (np.where(usable[:, np.newaxis], each, np.nan) for each in (rates, readings))
    with np.errstate(all="ignore"):
        changes, terms = _equations(rates, readings, steps, step)
        return _solved(changes, terms, max(1, round(2 * _BLOCK / _WINDOW)))


_UNKNOWN = AxesRelation(
    np.full((3, 3), np.nan), np.eye(3), np.nan, 0.0, 0.0, _SIGNED, np.full(len(_SIGNED), np.nan)
)


def _equations(
    rates: Floats, readings: Floats, steps: Floats, step: float
) -> tuple[Floats, Floats]:
    """Integrate over windows that overlap by half: changes (K, 3), and terms (K, 3, 9) of M."""
    width = max(1, round(min(_SMOOTHED / step, len(steps))))
    half = max(1, round(min(_WINDOW / step / 2, len(steps))))
    rates, readings = _smoothed(rates, width), _smoothed(readings, width)
    steps = steps[width - 1 :]
    starts = np.arange(0, len(readings) - 1, half)
    if len(starts) < 3:  # noqa: PLR2004 (two halves and an end)
        return np.empty((0, 3)), np.empty((0, 3, 9))
    changes = readings[starts[2:]] - readings[starts[:-2]]
    terms = np.empty((len(changes), 3, 9))
    for place, axis in enumerate(np.eye(3)):
        slopes = _vector_rate(readings, axis)
        for other in range(3):
            flow = slopes * rates[:, other, np.newaxis]
            parts = (flow[1:] + flow[:-1]) / 2 * steps[1:, np.newaxis]
            halves = np.add.reduceat(parts, starts, axis=0)[:-1]
            terms[:, :, 3 * place + other] = halves[1:] + halves[:-1]
    whole = np.isfinite(terms).all(axis=(1, 2)) & np.isfinite(changes).all(axis=1)
    return changes[whole], terms[whole]


def _smoothed(values: Floats, width: int) -> Floats:
    """Average over so many samples; NaN stays where it is."""
    mean = np.full(width, 1 / width)
    return np.stack([np.convolve(column, mean, mode="valid") for column in values.T], axis=1)


def _solved(changes: Floats, terms: Floats, block: int) -> AxesRelation:
    """Solve for M, and compare all signed permutations."""
    sizes = np.linalg.norm(terms, axis=(1, 2))
    strong = 0.3 * np.quantile(sizes, 0.99) if len(sizes) else 0.0
    if not strong > 0:
        return _UNKNOWN
    # No turn changes a vector by more than its own angle: what does is a disturbance, or noise. The
    # size of the terms is the same for every signed permutation, so this favours none.
    ratios = np.linalg.norm(changes, axis=1) / np.maximum(sizes, _LEAST)
    turns = ratios <= _MARGIN * np.quantile(ratios[sizes >= strong], _USUAL)
    changes, terms, sizes = changes[turns], terms[turns], sizes[turns]
    weights = 1 / np.maximum(sizes, strong)
    changes, terms = changes * weights[:, np.newaxis], terms * weights[:, np.newaxis, np.newaxis]
    # einsum runs in one thread: for so little several cost more than they save.
    left, right = terms.reshape(-1, 9), changes.reshape(-1)
    normal, projected = np.einsum("ni,nj->ij", left, left), np.einsum("ni,n->i", left, right)
    matrix = np.linalg.lstsq(normal, projected)[0].reshape(3, 3)
    signed = _SIGNED.reshape(-1, 9)
    along = signed @ projected
    power = np.einsum("ij,jk,ik->i", signed, normal, signed)
    factors = np.maximum(along, 0) / np.where(power > 0, power, np.inf)
    gains = along * factors
    order = np.argsort(-gains, kind="stable")
    best = order[0]
    told = np.einsum("nij,kj->kni", terms, factors[:, np.newaxis] * signed)
    residuals = ((changes - told) ** 2).sum(axis=2)
    blocks = np.arange(0, len(changes), block)
    margins = np.empty(len(signed))
    for place, residual in enumerate(residuals):
        sums = np.add.reduceat(residual - residuals[best], blocks)
        margins[place] = sums.sum() / max(np.sqrt((sums**2).sum()), _LEAST)
    explained = float(gains[best] / max(right @ right, _LEAST))
    left_over = order[margins[order] < _CERTAIN] if explained >= _EXPLAINED else order
    return AxesRelation(
        np.asarray(matrix, dtype=np.float64),
        _SIGNED[best],
        float(factors[best]),
        explained,
        float(np.partition(margins, 1)[1]),
        _SIGNED[left_over],
        factors[left_over] if explained >= _EXPLAINED else np.full(len(left_over), np.nan),
    )


def _named(row: Floats) -> str:
    """Name the gyro axis that a row of a signed permutation picks."""
    place = int(np.argmax(np.abs(row)))
    return f"{'-' if row[place] < 0 else ''}{'xyz'[place]}"
