"""Table 1 of the note on dead reckoning, and what is said of it, before the judgement."""

from functools import partial

from sympy import And, Basic, Eq, Rational, Symbol, pi, sin

from chr_notes.derivations import dead_reckoning as derived
from chr_notes.derivations.steps import Step
from chr_notes.ledger.case import Case
from chr_notes.ledger.reading import reading
from chr_notes.printed.statement import Approximately
from chr_notes.printed.table_1 import CELLS, COLUMNS, ROWS, Cell, error
from chr_notes.symbols import g

PRINTED_G = Rational(98, 10)
# Errors of any tilt after any time.
ACCELERATION, VELOCITY, POSITION = (
    Symbol(rf"\Delta {letter}", real=True) for letter in ("a", "v", "r")
)


def drift(column: str, degrees: str) -> Basic:
    """Derive the error of a column of Table 1, with the note's value of g."""
    place = {"a": 0, "v": 1, "r": 2}[COLUMNS[column].quantity]
    at = {
        derived.tilt_error: Rational(degrees) * pi / 180,
        derived.t: COLUMNS[column].seconds,
        g: PRINTED_G,
    }
    return derived.drift()[place].subs(at)


def product(cell: Cell) -> Symbol:
    """Name the product of a row's printed acceleration with a column's time squared."""
    seconds = COLUMNS[cell.column].seconds
    return Symbol(rf"{ROWS[cell.degrees][0]} \cdot {seconds}^2")


MEANING = {
    ACCELERATION: lambda: derived.drift()[0],
    VELOCITY: lambda: derived.drift()[1],
    POSITION: lambda: derived.drift()[2],
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
READ = reading(MEANING)


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
    statement = f"dead_reckoning.t1.{cell.degrees}.{cell.column}"
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
    *(
        _corrected_cell(cell)
        for cell in CELLS
        if cell.column in CORRECTED_CELLS.get(cell.degrees, {})
    ),
    Case(
        "dead_reckoning.4.b",
        READ,
        correction=Approximately(error("position_10s", "1.0"), "8.6"),
        steps=GROWTH,
        remark="The half is missing.",
    ),
    Case(
        "dead_reckoning.4.c",
        READ,
        correction=Approximately(error("position_1min", "1.0"), "308"),
        steps=GROWTH,
        remark="It is 308 m. Even the note's own table has 612 m, which is hardly almost a "
        "kilometre.",
    ),
    Case(
        "dead_reckoning.4.d",
        READ,
        correction=Approximately(error("position_10min", "1.0"), "31 e 3"),
        steps=GROWTH,
        remark="The half is missing; besides, the note's own table has 61.2 km.",
    ),
    Case(
        "dead_reckoning.4.e",
        READ,
        correction=And(
            Approximately(error("position_10s", "2.0"), "17.1"),
            Approximately(error("velocity_10s", "2.0"), "3.4"),
        ),
        steps=GROWTH,
        remark="The velocity is right. In the position the half is missing.",
    ),
)
