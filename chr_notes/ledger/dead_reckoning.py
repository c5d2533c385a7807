"""The note on dead reckoning before the judgement."""

from functools import partial

from sympy import (
    And,
    Basic,
    Eq,
    ImmutableMatrix,
    Ne,
    Rational,
    Symbol,
    cos,
    pi,
    sin,
    symbols,
)

from chr_notes.derivations import dead_reckoning as derived
from chr_notes.derivations.euler import Z, rotation
from chr_notes.derivations.steps import Step
from chr_notes.ledger.case import Case, Condition, complete
from chr_notes.ledger.reading import reading
from chr_notes.printed import dead_reckoning as printed
from chr_notes.printed.statement import Approximately
from chr_notes.printed.table_1 import CELLS, COLUMNS, ROWS, Cell, error
from chr_notes.symbols import T, g, phi, psi, theta

DEGREE = pi / 180
PRINTED_G = Rational(98, 10)
NOTHING = ImmutableMatrix.zeros(3, 1)

# The gravity that is added, which may not be the local one; the accelerometer's own error.
ADDED_G = Symbol(r"\hat{g}", positive=True)
OWN_ERROR = ImmutableMatrix(symbols("varepsilon_x:z", real=True))
# Errors of any tilt after any time, and the sums that n steps give.
ACCELERATION, VELOCITY, POSITION = (
    Symbol(rf"\Delta {letter}", real=True) for letter in ("a", "v", "r")
)
SUMMED_VELOCITY, SUMMED_POSITION = symbols("v_n r_n", real=True)


def drift(column: str, degrees: str) -> Basic:
    """Derive the error of a column of Table 1, with the note's value of g."""
    place = {"a": 0, "v": 1, "r": 2}[COLUMNS[column].quantity]
    at = {
        derived.tilt_error: Rational(degrees) * DEGREE,
        derived.t: COLUMNS[column].seconds,
        g: PRINTED_G,
    }
    return derived.drift()[place].subs(at)


def estimated_acceleration() -> ImmutableMatrix:
    """Follow the note's step: the attitude exact, the reading and the added gravity not."""
    at_hand = derived.accelerometer_reading() + OWN_ERROR
    return ImmutableMatrix(rotation("B", "I") * at_hand + ADDED_G * Z)


def product(cell: Cell) -> Symbol:
    """Name the product of a row's printed acceleration with a column's time squared."""
    seconds = COLUMNS[cell.column].seconds
    return Symbol(rf"{ROWS[cell.degrees][0]} \cdot {seconds}^2")


READ = reading(
    {
        printed.A_I: derived.ACCELERATION,
        printed.A_B: lambda: ImmutableMatrix(rotation("I", "B") * derived.ACCELERATION),
        printed.A_M: derived.accelerometer_reading,
        printed.IN_GRAVITIES: lambda: derived.accelerometer_reading() / g,
        printed.V_I: derived.velocity_after,
        printed.R_I: derived.position_after,
        printed.INTEGRAL: derived.velocity_gained,
        printed.DOUBLE_INTEGRAL: derived.position_gained,
        printed.A_K: derived.ACCELERATION,
        printed.V_K: derived.VELOCITY,
        printed.R_K: derived.POSITION,
        printed.V_NEXT: derived.velocity_after_step,
        printed.R_NEXT: derived.position_after_step,
        printed.ESTIMATED: estimated_acceleration,
        printed.OWN_ERROR: OWN_ERROR,
        printed.RESIDUE: derived.residual_acceleration,
        ACCELERATION: lambda: derived.drift()[0],
        VELOCITY: lambda: derived.drift()[1],
        POSITION: lambda: derived.drift()[2],
        SUMMED_VELOCITY: derived.velocity_by_steps,
        SUMMED_POSITION: derived.position_by_steps,
        **{
            error(column, degrees): partial(drift, column, degrees)
            for column in COLUMNS
            for degrees in ROWS
        },
        **{
            product(cell): Rational(ROWS[cell.degrees][0]) * COLUMNS[cell.column].seconds ** 2
            for cell in CELLS
        },
    }
)

_BY_ID = {statement.id: statement for statement in printed.PRINTED}
_ACCELERATION, _VELOCITY, _POSITION, _JERK = (
    dict.fromkeys(vector, 0)
    for vector in (derived.ACCELERATION, derived.VELOCITY, derived.POSITION, derived.JERK)
)

# The right numbers where Table 1 has wrong ones, by row and column.
CORRECTED_CELLS = {
    "0.1": {
        "position_10s": "0.86",
        "position_1min": "30.8",
        "position_10min": "3079",
        "position_1h": "111 e 3",
    },
    "0.5": {
        "position_10s": "4.3",
        "position_1min": "153.9",
        "position_10min": "15394",
        "position_1h": "0.55 e 6",
    },
    "1.0": {
        "position_10s": "8.6",
        "position_1min": "308",
        "position_10min": "30786",
        "position_1h": "1.1 e 6",
    },
    "1.5": {
        "acceleration": "0.257",
        "velocity_10s": "2.57",
        "position_10s": "12.8",
        "position_1min": "461.8",
        "position_10min": "46176",
        "position_1h": "1.7 e 6",
    },
    "2.0": {
        "position_10s": "17.1",
        "position_1min": "615.6",
        "position_10min": "61563",
        "position_1h": "2.2 e 6",
    },
    "3.0": {
        "position_10s": "25.6",
        "position_1min": "923.2",
        "position_10min": "92321",
        "position_1h": "3.3 e 6",
    },
    "5.0": {
        "position_10s": "42.7",
        "position_1min": "1537.4",
        "position_10min": "153743",
        "position_1h": "5.5 e 6",
    },
}

RESIDUE_OF_TILT = Step(
    "At rest the accelerometer reads minus gravity. Turned by an attitude of which the vertical is "
    "off by ε, it does not cancel the gravity that is added: along the ground g sin ε stays, in "
    "the direction of the tilt, and a little along the vertical.",
    Eq(
        printed.RESIDUE,
        ImmutableMatrix(
            [
                g * sin(derived.tilt_error) * cos(derived.azimuth),
                g * sin(derived.tilt_error) * sin(derived.azimuth),
                g * (1 - cos(derived.tilt_error)),
            ]
        ),
    ),
)
LEVEL_ACCELERATION = Step(
    "A body at rest with an error of tilt ε seems to accelerate along the ground by g sin ε.",
    Eq(ACCELERATION, g * sin(derived.tilt_error)),
)
GROWTH = (
    LEVEL_ACCELERATION,
    Step(
        "A constant acceleration, integrated once, gives a velocity that grows with time.",
        Eq(VELOCITY, ACCELERATION * derived.t),
    ),
    Step(
        "Integrated once more, it gives half the acceleration times the time squared: on average "
        "the velocity was half of what it is in the end.",
        Eq(POSITION, ACCELERATION * derived.t**2 / 2),
    ),
)


def _corrected_cell(cell: Cell) -> Case:
    statement = _BY_ID[f"dead_reckoning.t1.{cell.degrees}.{cell.column}"]
    right = Approximately(cell.quantity, CORRECTED_CELLS[cell.degrees][cell.column])
    if COLUMNS[cell.column].quantity != "r":
        last_digit = Step(
            "With more digits the acceleration is this; rounded, its last digit is a seven.",
            Approximately(error("acceleration", cell.degrees), "0.25653"),
        )
        return Case(
            statement,
            READ,
            correction=right,
            steps=(LEVEL_ACCELERATION, last_digit),
            remark="Cut off after the last digit instead of rounded.",
        )
    no_half = Step(
        "What is printed is the printed acceleration times the time squared, without the half.",
        Approximately(product(cell), cell.number),
    )
    return Case(
        statement,
        READ,
        correction=right,
        steps=(*GROWTH, no_half),
        remark="Position under a constant acceleration is half the acceleration times the time "
        "squared; the half is missing, so the printed number is about twice too large.",
    )


SETTLED = (
    Case(
        _BY_ID["dead_reckoning.3.1"],
        READ,
        condition=Condition(Eq(derived.VELOCITY, NOTHING), (_VELOCITY,)),
        witness={**_VELOCITY, derived.VELOCITY[0]: 10, derived.t: 60},
        steps=(
            Step(
                "The integral of the acceleration is what the velocity has gained since the "
                "start. The velocity at the start has to be added.",
                Eq(printed.V_I, derived.VELOCITY + printed.INTEGRAL),
            ),
        ),
        remark="The velocity at the start is missing, and an accelerometer cannot know it: at a "
        "steady 10 m/s it reads what it reads at rest.",
    ),
    Case(
        _BY_ID["dead_reckoning.3.2"],
        READ,
        condition=Condition(
            And(
                Eq(derived.POSITION, NOTHING),
                Eq(derived.VELOCITY, NOTHING),
            ),
            ({**_POSITION, **_VELOCITY},),
        ),
        witness={**_POSITION, **_VELOCITY, derived.VELOCITY[0]: 10, derived.t: 60},
        steps=(
            Step(
                "Position and velocity at the start have to be added, the velocity times the time "
                "that has gone by.",
                Eq(
                    printed.R_I,
                    derived.POSITION + derived.VELOCITY * derived.t + printed.DOUBLE_INTEGRAL,
                ),
            ),
        ),
        remark="Position and velocity at the start are missing. With 10 m/s at the start it is "
        "600 m off after a minute.",
    ),
    Case(
        _BY_ID["dead_reckoning.3.3"],
        READ,
        condition=Condition(Eq(derived.JERK, NOTHING), (_JERK,)),
        witness={
            **_VELOCITY,
            **_ACCELERATION,
            **_JERK,
            derived.JERK[0]: 10,
            T: Rational(1, 10),
        },
        steps=(
            Step(
                "With an acceleration that changes at the rate j within the step:",
                Eq(
                    printed.V_NEXT,
                    printed.V_K + T * printed.A_K + T**2 / 2 * derived.JERK,
                ),
            ),
        ),
        remark="Exact only if the acceleration stays constant during the step. Otherwise it is an "
        "approximation, the better the shorter the step.",
    ),
    Case(
        _BY_ID["dead_reckoning.3.4"],
        READ,
        condition=Condition(
            And(
                Eq(derived.ACCELERATION, NOTHING),
                Eq(derived.JERK, NOTHING),
            ),
            ({**_ACCELERATION, **_JERK},),
        ),
        witness={
            **_POSITION,
            **_VELOCITY,
            **_ACCELERATION,
            **_JERK,
            derived.ACCELERATION[0]: 2,
            T: Rational(1, 10),
        },
        steps=(
            Step(
                "With an acceleration a that changes at the rate j within the step:",
                Eq(
                    printed.R_NEXT,
                    printed.R_K
                    + T * printed.V_K
                    + T**2 / 2 * printed.A_K
                    + T**3 / 6 * derived.JERK,
                ),
            ),
            Step(
                "With a constant acceleration from rest, n of the note's two steps add up to the "
                "exact ½ a (nT)² less a remainder, as if each velocity came one period late.",
                Eq(
                    SUMMED_POSITION,
                    derived.a * (derived.n * T) ** 2 / 2 - derived.a * T * (derived.n * T) / 2,
                ),
            ),
        ),
        remark="Exact only if the velocity stays constant during the step, that is without "
        "acceleration. The remainder, ½ a T times the time, shrinks with the period T; adding "
        "½ T² a[k] to the step removes it.",
    ),
    Case(
        _BY_ID["dead_reckoning.4.f"],
        READ,
        condition=Condition(Eq(ADDED_G, g), ({ADDED_G: g},)),
        witness={
            **dict.fromkeys((phi, theta, psi, *derived.ACCELERATION, *OWN_ERROR), 0),
            ADDED_G: PRINTED_G,
            g: Rational(9832, 1000),
        },
        remark="The gravity that is added must be the local one. It runs from 9.780 m/s² at the "
        "equator to 9.832 at the poles; with the note's 9.8 a body at rest at a pole seems to "
        "accelerate by 0.032 m/s², more than 0.1° of tilt would make.",
    ),
    Case(
        _BY_ID["dead_reckoning.4.g"],
        READ,
        condition=Condition(Ne(cos(derived.tilt_error), 1)),
        witness={
            derived.tilt_error: 0,
            derived.azimuth: 0,
            derived.yaw_error: 5 * DEGREE,
            g: PRINTED_G,
        },
        steps=(RESIDUE_OF_TILT,),
        remark="It takes an error of tilt. An error of yaw alone turns everything about the "
        "vertical, and gravity with it into itself: at rest nothing is left over.",
    ),
    *(
        _corrected_cell(cell)
        for cell in CELLS
        if cell.column in CORRECTED_CELLS.get(cell.degrees, {})
    ),
    Case(
        _BY_ID["dead_reckoning.4.b"],
        READ,
        correction=Approximately(error("position_10s", "1.0"), "8.6"),
        steps=GROWTH,
        remark="The half is missing.",
    ),
    Case(
        _BY_ID["dead_reckoning.4.c"],
        READ,
        correction=Approximately(error("position_1min", "1.0"), "308"),
        steps=GROWTH,
        remark="It is 308 m. Even the note's own table has 612 m, which is hardly almost a "
        "kilometre.",
    ),
    Case(
        _BY_ID["dead_reckoning.4.d"],
        READ,
        correction=Approximately(error("position_10min", "1.0"), "31 e 3"),
        steps=GROWTH,
        remark="The half is missing; besides, the note's own table has 61.2 km.",
    ),
    Case(
        _BY_ID["dead_reckoning.4.e"],
        READ,
        correction=And(
            Approximately(error("position_10s", "2.0"), "17.1"),
            Approximately(error("velocity_10s", "2.0"), "3.4"),
        ),
        steps=GROWTH,
        remark="The velocity is right. In the position the half is missing.",
    ),
)

CASES = complete(printed.PRINTED, READ, SETTLED)
