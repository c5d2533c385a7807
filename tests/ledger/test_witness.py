"""A witness is a point: it chooses free quantities, and leaves what is derived from them."""

from collections.abc import Mapping
from dataclasses import replace
from random import Random

import pytest
from sympy import (
    Basic,
    Gt,
    ImmutableMatrix,
    Integer,
    Lt,
    MatrixSymbol,
    Symbol,
    Transpose,
    oo,
    symbols,
)

from chr_notes.ledger import entry
from chr_notes.ledger.case import CannotJudgeError, Case
from chr_notes.ledger.cases import CASES
from chr_notes.ledger.condition import Condition
from chr_notes.ledger.edits import Edit
from chr_notes.ledger.evaluation import parts, sides
from chr_notes.ledger.identities import equal, shape_of
from chr_notes.ledger.judgement import judge
from chr_notes.ledger.proof import fails
from chr_notes.ledger.show import show
from chr_notes.ledger.witness import check_witness
from chr_notes.printed import estimation, euler, quaternions, validation
from chr_notes.printed.statement import Rotation
from chr_notes.symbols import psi, theta

ZERO = ImmutableMatrix.zeros(3)
VECTOR = MatrixSymbol("v", 3, 1)
x, y = symbols("x y")


@pytest.mark.parametrize(
    ("name", "condition", "witness"),
    [
        ("estimation.4.3", Lt(estimation.L, 1), {estimation.L: 2, estimation.PITCH: 5}),
        ("validation.11", Lt(validation.ALPHA, 1), {validation.ALPHA: 2, validation.PITCH: 5}),
        ("quaternions.3.2", Gt(theta, 0), {quaternions.Q_1: 1, theta: -1}),
    ],
)
def test_no_condition_comes_from_another_value_for_what_is_derived(
    name: str, condition: Basic, witness: dict[Basic, int]
) -> None:
    brought = {"condition": Condition(condition), "witness": witness}
    with pytest.raises(CannotJudgeError, match="which is derived"):
        judge(replace(CASES[name], root="seam", weight="misleads", **brought))


@pytest.mark.parametrize(
    ("name", "edit", "witness"),
    [
        (
            "validation.2",
            Edit(validation.R_IB, Transpose(validation.R_BI)),
            {validation.R_IB: ZERO},
        ),
        (
            "euler.4.2",
            Edit(euler.R_PITCH, Transpose(Rotation("v2", "v1"))),
            {euler.R_PITCH: ZERO, theta: 1, psi: 1},
        ),
    ],
)
def test_no_correction_comes_from_another_value_for_what_is_derived(
    name: str, edit: Edit, witness: dict[Basic, Basic]
) -> None:
    with pytest.raises(CannotJudgeError, match="which is derived"):
        judge(replace(CASES[name], edits=(edit,), witness=witness, root="seam", weight="misleads"))


@pytest.mark.parametrize(
    ("name", "value"),
    [(x, 0.1), (x, "1"), (x, None), (x, True), (x, oo), (x, y), ("x", 1), (x, ZERO), (VECTOR, 1)],
)
def test_a_witness_is_of_exact_numbers(name: object, value: object) -> None:
    case = replace(CASES["estimation.2.6"], witness={name: value})
    with pytest.raises(CannotJudgeError, match="expected exact numbers of the right shape for"):
        check_witness(case)


FAILING = {name: case for name, case in CASES.items() if case.root is not None}
# What a witness tells besides, to make up a whole state: the statement is the same without it.
NEEDLESS = {
    "validation.3": {"g"},
    "validation.7": {"g", "phi", "theta"},
}
OF_NUMBERS = {name: case for name, case in FAILING.items() if case.witness}


def refused(case: Case, witness: Mapping[Basic, Basic]) -> str:
    """Say why a witness is refused: in one sentence that begins with the entry."""
    with pytest.raises(CannotJudgeError) as error:
        check_witness(replace(case, witness=witness))
    says = str(error.value)
    assert says.startswith(f"{case.id}: ")
    return says


@pytest.mark.parametrize("name", OF_NUMBERS)
def test_a_witness_has_all_that_matters(name: str) -> None:
    case = OF_NUMBERS[name]
    refused(case, {})
    matter = [each for each in case.witness if str(each) not in NEEDLESS.get(name, ())]
    left_out = Random(name).choice(matter)  # noqa: S311 (the same each time)
    refused(case, {each: value for each, value in case.witness.items() if each != left_out})


@pytest.mark.parametrize("name", OF_NUMBERS)
def test_a_witness_of_the_wrong_shape_or_of_strangers_is_refused(name: str) -> None:
    case = OF_NUMBERS[name]
    for each in case.witness:
        other = ImmutableMatrix([1]) if not shape_of(each) else Integer(1)
        assert "of the right shape" in refused(case, {**case.witness, each: other})
    assert "nothing that the statement depends on" in refused(case, {Symbol("stranger"): 1})


@pytest.mark.parametrize("name", [name for name in FAILING if name not in OF_NUMBERS])
def test_words_and_numbers_alone_have_no_witness(name: str) -> None:
    check_witness(FAILING[name])
    assert "nothing that the statement depends on" in refused(FAILING[name], {x: 1})


def test_a_witness_without_a_value_there_is_refused() -> None:
    case = CASES["sensors.4.3"]
    nothing = {
        name: ImmutableMatrix.zeros(*shape_of(name)) if shape_of(name) else Integer(0)
        for name in case.witness
    }
    assert "has no value" in refused(case, nothing)


@pytest.mark.parametrize("name", [name for name, case in OF_NUMBERS.items() if case.edits])
def test_printed_and_right_numbers_are_those_of_the_formulas_above_them(name: str) -> None:
    case, found, text = CASES[name], entry(name).witness, show(name).markdown()
    pairs = zip(parts(case.printed.statement), parts(case.right), strict=True)
    wrong, mended = next(pair for pair in pairs if fails(pair[0], case.reading, case.witness))
    formulas = [sides(each, case.reading, case.witness)[1] for each in (wrong, mended)]
    assert found is not None
    assert found.symbol == equal(*formulas)
    assert ("the printed symbol means" in text) == found.symbol
    if found.symbol:
        at, at_symbol = (str(each).split(" = ")[1] for each in (found.printed, found.right))
        assert f"after it gives ${found.printed}$" in text
        assert float(at) in [pytest.approx(float(each), abs=1e-4) for each in formulas[1]]
        meant = sides(wrong, case.reading, case.witness)[0]
        assert float(at_symbol) in [pytest.approx(float(each), abs=1e-4) for each in meant]


def test_a_refusal_names_the_files_to_mend() -> None:
    wrong = replace(CASES["euler.5.5"], witness={})
    with pytest.raises(CannotJudgeError) as error:
        judge(wrong)
    assert str(error.value) == (
        "euler.5.5: expected a value for phi at the witness, got none; "
        "see chr_notes/printed/euler.py and chr_notes/ledger/euler.py"
    )
