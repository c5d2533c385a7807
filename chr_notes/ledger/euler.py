"""The Euler-angle note before the judgement."""

from sympy import (
    And,
    Eq,
    FiniteSet,
    Ge,
    Identity,
    ImmutableMatrix,
    Interval,
    MatAdd,
    MatMul,
    Ne,
    Set,
    Symbol,
    cos,
    pi,
    sin,
    symbols,
    tan,
)

from chr_notes.derivations import euler as derived
from chr_notes.derivations.steps import Step
from chr_notes.ledger.case import DEGREE, Case, Condition, complete
from chr_notes.ledger.reading import elements, reading
from chr_notes.printed import BY_ID
from chr_notes.printed import euler as printed
from chr_notes.printed.statement import Rotation, words
from chr_notes.symbols import (
    BODY_RATES,
    EULER,
    EULER_RATES,
    p,
    phi,
    pitch_rate,
    psi,
    q,
    r,
    roll_rate,
    theta,
    yaw_rate,
)

GROUND = Symbol(r"z_{\text{ground}}", real=True)
FRAME_NAMES = {"v1": words("vehicle-1"), "v2": words("vehicle-2"), "B": words("body")}
VECTOR = ImmutableMatrix(symbols("v_N v_E v_D", real=True))


def _other_arguments_of_d() -> Set:
    return FiniteSet(*derived.euler_rates_matrix().free_symbols - set(EULER))


MEANING = {
    printed.Z_I: GROUND - printed.ALTITUDE,
    printed.PITCH_AXIS: derived.rotation("v1", "I") * derived.Y,
    printed.FIGURE_3_FRAME: FRAME_NAMES[derived.FRAMES[2]],
    printed.LOCK_PITCHES: derived.lock_pitches,
    printed.ROLL_FOR_YAW: -psi,
    # One vector in two frames: its body components come from its inertial ones.
    printed.V_I: VECTOR,
    printed.V_B: ImmutableMatrix(derived.rotation("I", "B") * VECTOR),
    printed.D: derived.euler_rates_matrix,
    printed.OTHER_ARGUMENTS: _other_arguments_of_d,
    **elements(EULER_RATES, derived.euler_rates),
}
READ = reading(MEANING)
READ_UPWARDS = reading({**MEANING, printed.LOCK_PITCHES: derived.lock_pitches(Interval(0, pi / 2))})

_SINE, _COSINE = (Symbol(name, positive=True) for name in ("s", "c"))

SETTLED = (
    Case(
        "euler.2.a",
        READ,
        condition=Condition(Eq(GROUND, 0)),
        witness={GROUND: 100, printed.ALTITUDE: 30},
        remark="The sign is right: down is positive. But a coordinate counts from the frame's "
        "origin, and altitude above ground from the ground. With the origin 100 m above the "
        "ground, a point 30 m above the ground lies at z = +70 m.",
    ),
    Case(
        "euler.4.a",
        READ,
        condition=Condition(Ne(cos(psi), 1)),
        witness={psi: 0},
        remark="Pitch turns about the y-axis of vehicle-1. That one coincides with the inertial "
        "y-axis as long as there is no yaw.",
    ),
    Case(
        "euler.4.b",
        READ,
        correction=Eq(printed.FIGURE_3_FRAME, FRAME_NAMES["v2"]),
        remark="There are four frames in all, and no vehicle-3 among them.",
    ),
    Case(
        "euler.5.5",
        READ,
        correction=Eq(printed.R_BI, BY_ID["euler.5.5"].statement.rhs),
        witness={phi: 30 * DEGREE, theta: 20 * DEGREE, psi: 60 * DEGREE},
        steps=(
            Step(
                "A matrix made of three orthonormal rows is undone by its transpose. So the way "
                "back is the transpose of the way there.",
                Eq(MatMul(derived.rotation("I", "B").T, derived.rotation("I", "B")), Identity(3)),
            ),
            Step(
                "Transposed, the derived matrix is what the note prints on the right-hand side. "
                "The elements are right; the symbol in front of them names the other direction.",
                Eq(derived.rotation("I", "B").T, derived.rotation("B", "I"), evaluate=False),
            ),
        ),
        remark="The right-hand side is the matrix from body to inertial, as the sentence before "
        "it says; the symbol on the left repeats the one of the opposite direction.",
    ),
    Case(
        "euler.6.a",
        READ_UPWARDS,
        given=(Condition(Ge(theta, 0)),),
        steps=(
            Step(
                "Euler rates come from body rates by undoing the matrix that leads the other way. "
                "That fails where its determinant is zero.",
                Eq(derived.body_rates_matrix().det(), cos(theta), evaluate=False),
            ),
        ),
        remark="Straight down, at −90°, it is locked as well; the note's last section says so.",
    ),
    Case(
        "euler.6.b",
        READ,
        steps=(
            Step(
                "At a pitch of 90° the matrix depends on roll and yaw only through their "
                "difference.",
                Eq(
                    derived.rotation("I", "B").subs(theta, pi / 2),
                    ImmutableMatrix(
                        [
                            [0, 0, -1],
                            [sin(phi - psi), cos(phi - psi), 0],
                            [cos(phi - psi), -sin(phi - psi), 0],
                        ]
                    ),
                    evaluate=False,
                ),
            ),
        ),
        remark="The roll is the negative of the yaw: at +90° the two turn the aircraft about the "
        "same line in opposite senses. At −90° they turn it in the same sense.",
    ),
    Case(
        "euler.7.a",
        READ,
        correction=Eq(
            ImmutableMatrix(BODY_RATES),
            MatAdd(
                ImmutableMatrix([roll_rate, 0, 0]),
                MatMul(Rotation("v2", "B", phi), ImmutableMatrix([0, pitch_rate, 0])),
                MatMul(Rotation("v1", "B"), ImmutableMatrix([0, 0, yaw_rate])),
            ),
            evaluate=False,
        ),
        witness={phi: 0, theta: 60 * DEGREE, psi: 0, p: 0, q: 0, r: 1},
        steps=(
            Step(
                "Each Euler rate is a turn about one known axis: roll about x of vehicle-2, pitch "
                "about y of vehicle-1, yaw about z of the inertial frame. Brought to the body "
                "frame, they add up to what the gyros read.",
                Eq(
                    ImmutableMatrix(derived.body_rates()),
                    ImmutableMatrix(
                        derived.rotation("v2", "B") * derived.X * roll_rate
                        + derived.rotation("v1", "B") * derived.Y * pitch_rate
                        + derived.rotation("I", "B") * derived.Z * yaw_rate
                    ),
                    evaluate=False,
                ),
            ),
            Step(
                "The three axes are not at right angles, so one cannot read off each rate as a "
                "projection. One has to solve for the three together: D is an inverse.",
                Eq(
                    MatMul(derived.euler_rates_matrix(), derived.body_rates_matrix()),
                    Identity(3),
                    evaluate=False,
                ),
            ),
        ),
        remark="The matrix D that follows is right, but these words do not lead to it: rotating "
        "each gyro's output and reading off one component gives factors of cos(pitch) where D "
        "divides by it. The rotation has to go from the Euler rates to the body, and then be "
        "inverted.",
    ),
    Case(
        "euler.7.b",
        READ,
        condition=Condition(Ne((q * sin(phi) + r * cos(phi)) * tan(theta), 0)),
        witness={phi: 0, theta: 0, p: 1, q: 2, r: 3},
        remark="In level flight the gyros do report the Euler rates: there D is the identity.",
    ),
    Case(
        "euler.7.c",
        READ,
        condition=Condition(
            And(Ne(sin(phi), 0), Ne(cos(phi), 0)),
        ),
        witness={phi: 0},
        remark="With no roll the middle element is zero at every pitch and does not diverge; with "
        "90° of roll the last one is. One of the two always does. The first row diverges as well, "
        "for tan(pitch) divides by cos(pitch) too.",
    ),
    Case(
        "euler.7.d",
        READ,
        steps=(
            Step(
                "Turning the whole picture about the vertical changes yaw and nothing else, so "
                "yaw cannot matter: as derived, no element of D has it.",
                Eq(printed.D, derived.euler_rates_matrix(), evaluate=False),
            ),
        ),
        remark="Nor does it depend on yaw: roll and pitch are enough.",
    ),
)

CASES = complete(printed.PRINTED, READ, SETTLED)
