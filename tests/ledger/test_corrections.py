"""A correction is the print made right: what says less, or something else, is refused."""

from dataclasses import replace

import pytest
from sympy import Basic, Identity, ZeroMatrix, asin, sin, sqrt, tan

from chr_notes.ledger.case import CannotJudgeError
from chr_notes.ledger.cases import CASES
from chr_notes.ledger.corrections import check_correction
from chr_notes.ledger.edits import Edit
from chr_notes.ledger.evaluation import parts
from chr_notes.ledger.judgement import judge
from chr_notes.ledger.validation_presumed import SEEN
from chr_notes.printed import BY_ID
from chr_notes.printed import quaternions as quaternion
from chr_notes.printed import sensors as sensor
from chr_notes.printed import validation as paper
from chr_notes.printed.hamilton import Pure
from chr_notes.printed.table_1 import error
from chr_notes.symbols import g, phi, psi, theta

PITCH, YAW = paper.PITCH_ACCEL, paper.YAW_ACCEL
ARCSINE = asin(paper.G_XB / sqrt(paper.G_XB**2 + paper.G_YB**2 + paper.G_ZB**2))
NONE = paper.G_XB + g * sin(theta)  # by equation 2
BY_NAMES = "true by its names alone"
BOTH = "changes both sides"


def right_side(name: str, by: Basic, part: int = 0) -> tuple[Edit, ...]:
    return (Edit(parts(BY_ID[name].statement)[part].rhs, by),)


@pytest.mark.parametrize(
    ("name", "edits", "says"),
    [
        # A number to fewer digits, without any, or for something else.
        ("dead_reckoning.4.b", (Edit("17.1", "0 e 3"),), "fewer decimals"),
        ("dead_reckoning.4.b", (Edit("17.1", "9"),), "fewer decimals"),
        ("dead_reckoning.t1.0.1.position_10s", (Edit("1.7", "1"),), "fewer decimals"),
        ("dead_reckoning.4.c", (Edit("1 e 3", "0 e 3"),), "no digit that counts"),
        (
            "dead_reckoning.4.b",
            (Edit(error("position_10s", "1.0"), 2 * error("position_10s", "1.0")),),
            "changes the quantity",
        ),
        # What the other side is read as, alone or with something that adds nothing to it.
        ("validation.4", right_side("validation.4", theta), BY_NAMES),
        ("validation.4", right_side("validation.4", 2 * theta - PITCH), BY_NAMES),
        ("validation.4", right_side("validation.4", theta + NONE), BY_NAMES),
        ("validation.4", right_side("validation.4", PITCH + NONE), BY_NAMES),
        ("validation.4", right_side("validation.4", PITCH), "says nothing"),
        ("validation.6", right_side("validation.6", tan(psi)), BY_NAMES),
        ("validation.7", right_side("validation.7", tan(psi)), BY_NAMES),
        ("validation.12", right_side("validation.12", SEEN), BY_NAMES),
        ("quaternions.3.1", right_side("quaternions.3.1", Pure(quaternion.V_B)), BY_NAMES),
        ("sensors.4.3", right_side("sensors.4.3", BY_ID["sensors.4.2"].statement.rhs), BY_NAMES),
        # Both sides made something that tells less of them.
        ("validation.4", (Edit(PITCH, PITCH * NONE), Edit(ARCSINE, ARCSINE * NONE)), BOTH),
        ("validation.4", (Edit(PITCH, PITCH**2), Edit(ARCSINE, ARCSINE**2)), BOTH),
        ("validation.4", (Edit(PITCH, abs(PITCH)), Edit(ARCSINE, abs(ARCSINE))), BOTH),
        ("validation.6", (Edit(tan(YAW), NONE), *right_side("validation.6", 2 * NONE)), BOTH),
    ],
)
def test_what_says_less_is_refused(name: str, edits: tuple[Edit, ...], says: str) -> None:
    with pytest.raises(CannotJudgeError, match=says):
        check_correction(replace(CASES[name], edits=edits))


def test_a_division_by_nothing_is_multiplied_out_by_nothing_else() -> None:
    yaw_alone, quotient = CASES["validation.6"].edits
    assert isinstance(yaw_alone.by, Basic)
    for factor in (NONE, sin(phi), 2):
        more = (Edit(yaw_alone.part, factor * yaw_alone.by), quotient)
        with pytest.raises(CannotJudgeError, match=BOTH):
            check_correction(replace(CASES["validation.6"], edits=more))


def test_equations_and_numbers_are_corrected_and_nothing_else() -> None:
    unequal = CASES["euler.4.a"]
    axis = unequal.printed.statement.rhs
    with pytest.raises(CannotJudgeError, match="neither an equation nor a number"):
        check_correction(replace(unequal, edits=(Edit(axis, 2 * axis),)))


def test_more_digits_than_printed_are_welcome() -> None:
    check_correction(replace(CASES["dead_reckoning.4.b"], edits=(Edit("17.1", "8.55"),)))


def test_a_name_for_a_name_is_no_excuse_beside_another_edit() -> None:
    edits = (
        Edit(sensor.S_A.I, Identity(3)),
        Edit(sensor.M_A.I, Identity(3)),
        Edit(sensor.A_M, sensor.B),
        Edit(sensor.BETA_A, ZeroMatrix(3, 1)),
    )
    with pytest.raises(CannotJudgeError, match=BY_NAMES):
        judge(replace(CASES["sensors.4.3"], edits=edits))
