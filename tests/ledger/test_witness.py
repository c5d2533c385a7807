"""A witness is a point: it chooses free quantities, and leaves what is derived from them."""

from dataclasses import replace

import pytest
from sympy import Basic, Gt, ImmutableMatrix, Lt, MatrixSymbol, Transpose, oo, symbols

from chr_notes.ledger.case import CannotJudgeError
from chr_notes.ledger.cases import CASES
from chr_notes.ledger.condition import Condition
from chr_notes.ledger.dead_reckoning_reading import ADDED_G
from chr_notes.ledger.edits import Edit
from chr_notes.ledger.judgement import judge
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


def test_a_witness_has_all_that_matters() -> None:
    case = CASES["dead_reckoning.4.f"]
    witness = {name: value for name, value in case.witness.items() if name != ADDED_G}
    with pytest.raises(CannotJudgeError, match=r"expected a value for \\hat\{g\}"):
        check_witness(replace(case, witness=witness))
