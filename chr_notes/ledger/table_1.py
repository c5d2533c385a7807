"""Table 1 of the note on dead reckoning, and what is said of it, before the judgement."""

from functools import partial

from sympy import Basic, Eq, Rational, Symbol, pi, sin

from chr_notes.derivations import dead_reckoning as derived
from chr_notes.derivations.steps import Step
from chr_notes.ledger.case import Case
from chr_notes.ledger.edits import Edit
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

# Where Table 1 has wrong numbers, by row and column: what is printed, and what is right.
CORRECTED_CELLS = {
    "0.1": {
        "position_10s": ("1.7", "0.86"),
        "position_1min": ("61.2", "30.8"),
        "position_10min": ("6120", "3079"),
        "position_1h": ("220 e 3", "111 e 3"),
    },
    "0.5": {
        "position_10s": ("8.6", "4.3"),
        "position_1min": ("309.6", "153.9"),
        "position_10min": ("30960", "15394"),
        "position_1h": ("1.1 e 6", "0.55 e 6"),
    },
    "1.0": {
        "position_10s": ("17", "8.6"),
        "position_1min": ("612", "308"),
        "position_10min": ("61200", "30786"),
        "position_1h": ("2.2 e 6", "1.1 e 6"),
    },
    "1.5": {
        "acceleration": ("0.256", "0.257"),
        "velocity_10s": ("2.56", "2.57"),
        "position_10s": ("25.6", "12.8"),
        "position_1min": ("921.6", "461.8"),
        "position_10min": ("92160", "46176"),
        "position_1h": ("3.3 e 6", "1.7 e 6"),
    },
    "2.0": {
        "position_10s": ("34.2", "17.1"),
        "position_1min": ("1231.2", "615.6"),
        "position_10min": ("123120", "61563"),
        "position_1h": ("4.4 e 6", "2.2 e 6"),
    },
    "3.0": {
        "position_10s": ("51.3", "25.6"),
        "position_1min": ("1846.8", "923.2"),
        "position_10min": ("184680", "92321"),
        "position_1h": ("6.6 e 6", "3.3 e 6"),
    },
    "5.0": {
        "position_10s": ("85.4", "42.7"),
        "position_1min": ("3074.4", "1537.4"),
        "position_10min": ("307440", "153743"),
        "position_1h": ("11 e 6", "5.5 e 6"),
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
    edit = Edit(*CORRECTED_CELLS[cell.degrees][cell.column])
    if COLUMNS[cell.column].quantity != "r":
        last_digit = Step(
            "With more digits the acceleration is this; rounded, its last digit is a seven.",
            Approximately(error("acceleration", cell.degrees), "0.25653"),
        )
        return Case(
            statement,
            edits=(edit,),
            root="cut-off",
            weight="small print",
            steps=(
                LEVEL_ACCELERATION,
                last_digit,
                *(GROWTH[1:2] if COLUMNS[cell.column].quantity == "v" else ()),
            ),
            remark="Cut off after the last digit instead of rounded.",
        )
    no_half = Step(
        "What is printed is the printed acceleration times the time squared, without the half.",
        Approximately(product(cell), cell.number),
    )
    return Case(
        statement,
        edits=(edit,),
        root="missing-half",
        weight="misleads",
        steps=(*GROWTH, no_half),
        remark="Position under a constant acceleration is half the acceleration times the time "
        "squared; the half is missing, so the printed number is about twice too large.",
    )


def _without_half(letter: str, wrong: str, right: str, remark: str) -> Case:
    return Case(
        f"dead_reckoning.4.{letter}",
        edits=(Edit(wrong, right),),
        root="missing-half",
        weight="misleads",
        steps=GROWTH,
        remark=remark,
    )


SETTLED = (
    *(
        _corrected_cell(cell)
        for cell in CELLS
        if cell.column in CORRECTED_CELLS.get(cell.degrees, {})
    ),
    _without_half("b", "17.1", "8.6", "The half is missing."),
    Case(
        "dead_reckoning.4.c",
        edits=(Edit("1 e 3", "308"),),
        root="kilometre",
        weight="misleads",
        steps=GROWTH,
        remark="It is 308 m, less than a third of a kilometre. The note's own table has 612 m, "
        "which is a kilometre only by such rounding.",
    ),
    _without_half(
        "d",
        "62 e 3",
        "31 e 3",
        "The half is missing; besides, the note's own table has 61.2 km.",
    ),
    _without_half(
        "e", "34.2", "17.1", "The velocity is right. In the position the half is missing."
    ),
)
