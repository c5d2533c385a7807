"""Ties of functions and entries, part three: dead reckoning."""

from collections.abc import Iterator, Mapping

from sympy import Basic, Eq, ImmutableMatrix, Rational, integrate, pi
from sympy.logic.boolalg import Boolean

from chr_notes.derivations.dead_reckoning import ACCELERATION, POSITION, VELOCITY, t, tilt_error
from chr_notes.derivations.forms.dead_reckoning import NEXT
from chr_notes.printed import dead_reckoning as printed
from chr_notes.printed.statement import Approximately
from chr_notes.symbols import T, g

from .sensor_ties import READING, by, put
from .ties import Formula, States, Tie


def stepped(part: slice, names: Mapping[Basic, Basic]) -> States:
    """A part of the state returned is the right side."""

    def states(formula: Formula, entry: Basic) -> Iterator[Boolean]:
        yield Eq(ImmutableMatrix(formula[part, 0]), put(entry.rhs, names), evaluate=False)

    return states


STATE = {
    printed.V_K: VELOCITY,
    printed.R_K: POSITION,
    printed.A_K: ACCELERATION,
}
# The acceleration between two samples, on a straight line, and its integrals over the period.
_BETWEEN = ACCELERATION + (NEXT - ACCELERATION) * t / T
_GAINED = _BETWEEN.applyfunc(lambda part: integrate(part, (t, 0, t)))
_INTEGRALS = {
    printed.INTEGRAL: VELOCITY + _GAINED.subs(t, T),
    printed.DOUBLE_INTEGRAL: POSITION
    + T * VELOCITY
    + _GAINED.applyfunc(lambda part: integrate(part, (t, 0, T))),
}


def after_ten_seconds(place: int) -> States:
    """With an error of one degree, computed to the printed digits."""
    values = {tilt_error: pi / 180, t: 10, g: Rational(98, 10)}

    def states(formula: Formula, entry: Basic) -> Iterator[Boolean]:
        yield Approximately(formula[place].xreplace(values), entry.args[1])

    return states


RECKONING: dict[tuple[str, str], Tie] = {
    ("inertial_acceleration", "dead_reckoning.2.3"): Tie(by({printed.A_M: READING})),
    ("dead_reckoning_held", "dead_reckoning.3.3"): Tie(stepped(slice(0, 3), STATE), (0,)),
    ("dead_reckoning_held", "dead_reckoning.3.4"): Tie(stepped(slice(3, 6), STATE), (0,)),
    ("dead_reckoning_step", "dead_reckoning.3.1"): Tie(stepped(slice(0, 3), _INTEGRALS)),
    ("dead_reckoning_step", "dead_reckoning.3.2"): Tie(stepped(slice(3, 6), _INTEGRALS)),
    ("drift_from_tilt_error", "dead_reckoning.4.a"): Tie(after_ten_seconds(1)),
    ("drift_from_tilt_error", "dead_reckoning.4.b"): Tie(after_ten_seconds(2)),
}
