"""Each number in a remark is one that it chooses for an example, or follows from these.

The table lists the numbers of each remark: those that it chooses, and those that follow, each
with the computation that gives it from the chosen ones.
"""

import math
import re
from collections.abc import Callable
from functools import cache
from typing import NamedTuple

import pytest
from sympy import (
    Expr,
    ImmutableMatrix,
    Integer,
    Rational,
    asin,
    atan,
    cos,
    deg,
    limit,
    oo,
    pi,
    rad,
    sin,
    solve,
)

from chr_notes import STANDARD_GRAVITY
from chr_notes.derivations import calibration, dead_reckoning, estimation, hamilton, validation
from chr_notes.derivations import euler as derived
from chr_notes.derivations import quaternions as quaternion
from chr_notes.derivations import sensors as spring
from chr_notes.ledger import entries
from chr_notes.ledger.cases import CASES
from chr_notes.ledger.files import see
from chr_notes.printed.table_1 import COLUMNS, ROWS
from chr_notes.symbols import EULER, MAGNETOMETER, T, g, phi

from .remark_numbers import numbers, rounded, says

# Normal gravity of the reference ellipsoid GRS80 (H. Moritz, Journal of Geodesy 74, 2000).
EQUATOR, POLE = 9.7803267715, 9.8321863685
REMARKS = {entry.id: entry.remark for entry in entries() if entry.remark}
CELL = re.compile(r"dead_reckoning\.t1\.(\d\.\d)\.(position_\w+)")

Follows = tuple[str, Callable[..., Expr | float]]


class Row(NamedTuple):
    """Numbers of a remark: those that it chooses, and those that follow from these."""

    chosen: tuple[str, ...] = ()
    follow: tuple[Follows, ...] = ()


def constant(written: str, value: Expr | float) -> Follows:
    """A number that follows from nothing that the remark chooses."""
    return written, lambda *_: value


def drift(seconds: float, acceleration: Expr | float) -> Expr:
    """Metres after some time at a constant acceleration, from rest."""
    by = {dead_reckoning.a: acceleration}
    return dead_reckoning.constant_acceleration(seconds)[1].subs(by)


def steady_error(rate: Expr, samples: Expr, gain: Expr) -> Expr:
    """Degrees by which a bias in degrees a second holds the fixed-gain observer off."""
    by = {estimation.bias: rate, T: 1 / samples}
    return estimation.steady_bias_error(gain).subs(by)


def short_way(before: Expr, after: Expr) -> Expr:
    """Degrees of the shorter turn."""
    return deg(estimation.shortest_turn(rad(after - before)))


def too_large(share: Expr) -> Expr:
    """Percent by which the deflection at a share of the natural frequency is above a held one."""
    vibrating = spring.deflection().subs(spring.frequency, share * spring.natural_frequency)
    return 100 * (vibrating / spring.deflection_held() - 1)


def pitch_in_lift(upwards: Expr, pitch: Expr) -> Expr:
    """Degrees of pitch by the printed arcsine, where the reading is larger than gravity."""
    formula = CASES["estimation.2.5"].printed.statement.rhs
    (reading,) = formula.free_symbols - {g}
    larger = sin(rad(pitch)) * (STANDARD_GRAVITY + upwards)
    return deg(formula.subs({reading: larger, g: STANDARD_GRAVITY}))


def factor_with_iron(percent: Expr, dip: Expr) -> Expr:
    """Factor E of a level body in a field of magnitude one, some percent more of it downwards."""
    north, _, down = validation.REFERENCE
    field = {north: cos(rad(dip)), down: sin(rad(dip))}
    seen = zip(MAGNETOMETER, (field[north], 0, field[down] + percent / 100), strict=True)
    level = dict.fromkeys(derived.rotation("I", "B").free_symbols, 0)
    return validation.factor().subs(level).subs({**field, **dict(seen)})


@cache
def gravity_across() -> Expr:
    """Sum of squares of what gravity has along the level, of which 6 and 7 make a quotient."""
    gravity = -estimation.accelerometer_at_rest()
    level = validation.level_field().subs(dict(zip(MAGNETOMETER, gravity, strict=True)))
    return (level[0] ** 2 + level[1] ** 2).simplify()


def yawed(yaw: Expr) -> ImmutableMatrix:
    """Quaternion of a yaw in degrees."""
    angles = dict(zip(EULER, (0, 0, rad(yaw)), strict=True))
    return quaternion.from_euler().subs(angles)


def drift_of_gyro(rate: Expr) -> Expr:
    """Degrees that a bias in degrees a second adds up to in a minute."""
    error = estimation.gyro_error_after().subs(estimation.n, 60 / T)
    return error.subs({estimation.bias: rate, estimation.start_error: 0})


def half_way(*turn: Expr) -> Expr:
    """Degrees, from zero, of what lies half way between the third and the fourth."""
    before, after = turn[2:]
    return before + short_way(before, after) / 2


def times_too_large(cell: str) -> float:
    """How many times the right position Table 1 prints."""
    angle, column = CELL.fullmatch(cell).groups()  # type: ignore[union-attr]
    printed = float(ROWS[angle][list(COLUMNS).index(column)].replace(" ", ""))
    tilted = STANDARD_GRAVITY * sin(rad(float(angle)))
    return printed / float(drift(COLUMNS[column].seconds, tilted))


LOCKS = cache(derived.lock_pitches)
DOWN, UP = ("−90", lambda *_: deg(min(LOCKS()))), ("+90", lambda *_: deg(max(LOCKS())))
ATAN = tuple(
    constant(said, deg(limit(atan(T), T, end))) for said, end in (("−90", -oo), ("90", oo))
)
SIGNS = constant("180", deg(pi))  # of turn where sine and cosine both change their signs
SEAM = (
    *ATAN,
    ("110", lambda far, other, *_: short_way(far, other)),
    ("−250", lambda far, other, *_: other - far),
)
BESIDE = ("1", "100", "0.02")
ACROSS = ("170", "−80", "179", "−179")
NO_GRAVITY = ("0", lambda *_: gravity_across())
HALF = constant("half", drift(Integer(1), 1))
STEPS_LEAVE = (
    dead_reckoning.constant_acceleration(T * dead_reckoning.n)[1]
    - dead_reckoning.position_by_steps()
) / (dead_reckoning.a * T**2 * dead_reckoning.n)
UNIT = hamilton.UNITS[0]
AS_PRINTED = (
    calibration.MISALIGNMENT,
    calibration.SENSITIVITY,
    calibration.BIAS,
    calibration.SOFT_IRON,
    calibration.HARD_IRON,
)
TERMS = sum(len(each) for each in AS_PRINTED)
TILTED = STANDARD_GRAVITY * sin(rad(1))

TABLE = {
    "euler.2.a": Row(("100", "30"), (("+70", lambda origin, point: origin - point),)),
    "euler.6.a": Row((), (DOWN,)),
    "euler.6.b": Row((), (UP, DOWN)),
    "euler.6.c": Row((), (UP, DOWN)),
    "euler.7.c": Row(
        (), (constant("90", deg(min(solve(derived.euler_rates_matrix()[2, 2], phi)))),)
    ),
    "quaternions.2.a": Row((), (constant("−1", hamilton.unit_products()[UNIT, UNIT]),)),
    "quaternions.3.1": Row(
        ("90",),
        tuple(
            (said, lambda yaw, place=place: yawed(yaw)[place])
            for place, said in enumerate(("√½", "0", "0", "√½"))
        ),
    ),
    "quaternions.3.a": Row(
        ("2",), (("½", lambda scalar: hamilton.inverse(ImmutableMatrix([scalar, 0, 0, 0]))[0]),)
    ),
    "quaternions.4.1": Row((), (*ATAN, SIGNS)),
    "quaternions.4.2": Row((), (constant("−90", deg(asin(-1))), constant("90", deg(asin(1))))),
    "quaternions.4.3": Row((), (*ATAN, SIGNS)),
    "sensors.2.2": Row(("1",)),
    "sensors.2.f": Row(
        ("tenth", "half"),
        (
            ("1", lambda tenth, _: too_large(tenth)),
            ("33", lambda _, half: too_large(half)),
        ),
    ),
    "sensors.4.3": Row(("20", "40"), (constant("9.8", STANDARD_GRAVITY),)),
    "sensors.4.e": Row(
        (),
        (
            constant("twelve", len(calibration.with_iron().free_symbols - set(calibration.INPUT))),
            constant("27", TERMS),
        ),
    ),
    "estimation.2.5": Row(
        ("1", "30"),
        (
            ("10.8", lambda upwards, _: STANDARD_GRAVITY + upwards),
            ("33.4", pitch_in_lift),
        ),
    ),
    "estimation.2.6": Row((), (ATAN[1], SIGNS)),
    "estimation.2.a": Row(("0",)),
    "estimation.4.4": Row(ACROSS, (*SEAM, ("2", lambda *turn: short_way(*turn[2:])))),
    "estimation.4.c": Row(
        ("0.1",),
        (
            constant("0", solve(estimation.update().diff(estimation.measured), estimation.L)[0]),
            ("6", drift_of_gyro),
        ),
    ),
    "estimation.4.e": Row(("0",)),
    "estimation.4.f": Row(BESIDE, (("0.49", steady_error),)),
    "estimation.5.a": Row(("30",)),
    "dead_reckoning.3.1": Row(("10",)),
    "dead_reckoning.3.2": Row(("10",), (("600", lambda speed: 60 * speed),)),
    "dead_reckoning.3.4": Row(
        (), (constant("½", STEPS_LEAVE.simplify()), constant("½", STEPS_LEAVE.simplify()))
    ),
    "dead_reckoning.4.f": Row(
        ("9.8", "0.1"),
        (
            constant("9.780", EQUATOR),
            constant("9.832", POLE),
            ("0.032", lambda noted, _: POLE - noted),
        ),
    ),
    "dead_reckoning.4.b": Row((), (HALF,)),
    "dead_reckoning.4.c": Row(
        (), (constant("308", drift(60, TILTED)), constant("612", float(ROWS["1.0"][3])))
    ),
    "dead_reckoning.4.d": Row((), (HALF, constant("61.2", float(ROWS["1.0"][4]) / 1000))),
    "dead_reckoning.4.e": Row((), (HALF,)),
    **{
        cell: Row((), (HALF, HALF, constant("twice", times_too_large(cell))))
        for cell in REMARKS
        if CELL.fullmatch(cell)
    },
    "validation.3": Row((), (ATAN[1], SIGNS)),
    "validation.6": Row((), (NO_GRAVITY, NO_GRAVITY)),
    "validation.7": Row((), (NO_GRAVITY, NO_GRAVITY)),
    "validation.10": Row(ACROSS, (*SEAM, ("180", half_way))),
    "validation.15": Row((), (SIGNS,)),
    "validation.b": Row((), (NO_GRAVITY, NO_GRAVITY)),
    "validation.c": Row(BESIDE, (("0.49", steady_error),)),
    "validation.d": Row(("five", "53"), (("0.017", factor_with_iron),)),
    "validation.e": Row(("1",)),
}


@pytest.mark.parametrize("name", REMARKS)
def test_the_table_has_the_numbers_of_the_remark(name: str) -> None:
    row = TABLE.get(name, Row())
    listed = [*row.chosen, *(said for said, _ in row.follow)]
    found = [number.lower() for number in numbers(REMARKS[name])]
    assert sorted(found) == sorted(listed), f"{name}: tests/ledger/test_remarks.py; {see(name)}"


@pytest.mark.parametrize("name", [name for name, row in TABLE.items() if row.follow])
def test_what_follows_comes_out(name: str) -> None:
    chosen = [Rational(str(says(number))) for number in TABLE[name].chosen]
    for said, compute in TABLE[name].follow:
        value = float(compute(*chosen))
        assert rounded(value, said) == says(said), f"{name}: {value}, not {said}; {see(name)}"


def test_no_row_without_a_remark() -> None:
    assert TABLE.keys() <= REMARKS.keys()


def test_the_wrong_gravity_at_a_pole_is_more_than_a_tenth_of_a_degree_of_tilt_makes() -> None:
    noted, tilt = (float(number) for number in TABLE["dead_reckoning.4.f"].chosen)
    assert POLE - noted > POLE * math.sin(math.radians(tilt))


def test_a_changed_digit_and_a_number_too_many_are_seen() -> None:
    assert numbers("By 0.49° for 1°/s, see estimation.4.f and equations 2, 5 and 12.") == [
        "0.49",
        "1",
    ]
    error = float(steady_error(*(Rational(each) for each in BESIDE)))
    assert rounded(error, "0.49") == says("0.49")
    assert rounded(error, "0.48") != says("0.48")
