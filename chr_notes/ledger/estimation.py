"""The note on attitude estimation before the judgement; its section 4, `estimation_observer`."""

from sympy import (
    Eq,
    ImmutableMatrix,
    MatAdd,
    MatMul,
    Rational,
    ZeroMatrix,
    atan2,
    cos,
    sin,
    sqrt,
)
from sympy.matrices.expressions import Inverse

from chr_notes.derivations import estimation as derived
from chr_notes.derivations.calibration import COUPLING
from chr_notes.derivations.steps import Step
from chr_notes.ledger import ranges
from chr_notes.ledger.case import DEGREE, Case, complete
from chr_notes.ledger.edits import Edit
from chr_notes.ledger.estimation_observer import SETTLED as OBSERVER
from chr_notes.ledger.estimation_reading import (
    BIAS,
    FORCE,
    FREE_FALL,
    READ,
    READ_PREDICTION,
    READ_TILT,
    SUPPORT,
)
from chr_notes.ledger.euler_rates import AXES_OF_THE_TURNS, PROJECTIONS
from chr_notes.ledger.shared_steps import felt, held
from chr_notes.printed import BY_ID, DOCUMENTS
from chr_notes.printed import estimation as printed
from chr_notes.printed import estimation_claims as claims
from chr_notes.printed.statement import InOrder, Rotation, chain
from chr_notes.symbols import (
    ACCELEROMETER,
    BODY_RATES,
    T,
    g,
    m,
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

NO_FORCE = dict.fromkeys(FORCE, 0)
WEIGHT_DOWN = ImmutableMatrix([0, 0, m * g])
BODY = ImmutableMatrix(BODY_RATES)

SETTLED = (
    Case(
        "estimation.2.1",
        steps=felt(printed.A_M, printed.F, printed.F_G),
    ),
    Case(
        "estimation.2.2",
        steps=(
            Step(
                "Without a net force only gravity is left in the equation before.",
                Eq(MatAdd(printed.F, -printed.F_G), -printed.F_G),
            ),
        ),
    ),
    Case(
        "estimation.2.3",
        steps=(
            Step(
                "Yaw turns about the vertical and leaves it as it is.",
                Eq(MatMul(Rotation("I", "v1"), WEIGHT_DOWN), WEIGHT_DOWN),
            ),
            Step(
                "Pitch brings some of the force to the tail.",
                Eq(
                    MatMul(Rotation("v1", "v2"), WEIGHT_DOWN),
                    ImmutableMatrix([-m * g * sin(theta), 0, m * g * cos(theta)]),
                ),
            ),
            Step(
                "Roll shares out what is left between right and down.",
                Eq(
                    MatMul(Rotation("v2", "B"), ImmutableMatrix([0, 0, m * g * cos(theta)])),
                    ImmutableMatrix(
                        [0, m * g * cos(theta) * sin(phi), m * g * cos(theta) * cos(phi)]
                    ),
                ),
            ),
        ),
    ),
    Case(
        "estimation.2.4",
        steps=(
            Step(
                "In the body frame the force of gravity has these components, see estimation.2.3.",
                Eq(
                    printed.F_G,
                    ImmutableMatrix(
                        [
                            -m * g * sin(theta),
                            m * g * cos(theta) * sin(phi),
                            m * g * cos(theta) * cos(phi),
                        ]
                    ),
                ),
            ),
            Step(
                "At rest the reading is minus the force of gravity, per mass.",
                Eq(printed.A_M, MatMul(-1 / m, printed.F_G)),
            ),
        ),
    ),
    Case(
        "estimation.2.5",
        READ_TILT,
        steps=(
            Step(
                "The first component of the equation before is all that pitch needs.",
                Eq(printed.A_MX, g * sin(theta)),
            ),
            Step(
                "The direction of the reading holds the pitch, too: compare the x component with "
                "the rest of the reading, and no value of g is needed.",
                Eq(
                    printed.PITCH_ACCEL,
                    atan2(printed.A_MX, sqrt(printed.A_MY**2 + printed.A_MZ**2)),
                ),
            ),
        ),
        remark="Right where the note's assumption holds that there is no net force. Otherwise the "
        "reading has not the magnitude g: in a lift that starts upwards with 1 m/s² it is "
        "10.8 m/s², and a pitch of 30° comes out as 33.4°; where the x component comes out "
        "above g the arcsine has no value at all. An error of scale does the same. The last step "
        "shows a form that needs no g.",
    ),
    Case(
        "estimation.2.6",
        READ_TILT,
        condition=ranges.acute(phi),
        witness={**NO_FORCE, phi: 150 * DEGREE, theta: 0, m: 1, g: Rational(98, 10)},
        root="roll-quadrant",
        weight="misleads",
        steps=(
            Step(
                "Minus y and minus z are sine and cosine of roll with one common factor, the "
                "cosine of pitch times the magnitude. The two-argument arctangent takes both and "
                "knows all four quadrants.",
                Eq(printed.ROLL_ACCEL, atan2(-printed.A_MY, -printed.A_MZ)),
            ),
        ),
        remark="A quotient forgets the signs of its two parts. Rolled beyond 90° either way, "
        "upside down included, the arctangent is off by 180°.",
    ),
    Case(
        "estimation.2.a",
        edits=(Edit(printed.F_G, MatAdd(printed.F_G, SUPPORT)),),
        witness={**NO_FORCE, phi: 0, theta: 0, m: 1, g: Rational(98, 10)},
        root="gravity-alone",
        weight="label",
        told_in="estimation.2.2",
        steps=(
            Step(
                "All forces are gravity and what holds the body, whatever they add up to.",
                Eq(MatAdd(BY_ID["estimation.2.a"].statement.args[-1].rhs, SUPPORT), printed.F),
            ),
            Step(
                "If gravity were the only force, F would be the force of gravity, and the model "
                "of the reading would give zero. That is free fall.",
                chain(
                    FREE_FALL,
                    MatMul(1 / m, MatAdd(printed.F_G, MatMul(-1, printed.F_G), evaluate=False)),
                    ZeroMatrix(3, 1),
                ),
            ),
            Step(
                "F = 0 says that something holds the body against gravity. This force is what the "
                "accelerometer reads.",
                Eq(printed.A_M, SUPPORT / m),
            ),
        ),
        remark="The assumption F = 0 leads to the right reading, see estimation.2.2. "
        "But it does not say that only "
        "gravity acts: it says that all other forces together just cancel gravity.",
    ),
    Case(
        "estimation.3.1",
        steps=(
            Step(
                "The gyros read the three turns together, each about its own axis: roll about the "
                "body's x, pitch about y as it was before roll, yaw about the vertical.",
                Eq(BODY, MatMul(AXES_OF_THE_TURNS, printed.RATES)),
            ),
            Step(
                "The last two lines, turned back by roll, are two equations for the rates of pitch "
                "and yaw; the first one then gives the rate of roll.",
                InOrder(
                    Eq(pitch_rate, q * cos(phi) - r * sin(phi)),
                    Eq(yaw_rate * cos(theta), q * sin(phi) + r * cos(phi)),
                    Eq(roll_rate, p + sin(theta) * yaw_rate),
                ),
            ),
        ),
    ),
    Case("estimation.3.2", READ_PREDICTION, steps=held(roll_rate, printed.ROLL, printed.ROLL_PLUS)),
    Case(
        "estimation.3.3", READ_PREDICTION, steps=held(pitch_rate, printed.PITCH, printed.PITCH_PLUS)
    ),
    Case(
        "estimation.3.a",
        steps=(
            Step(
                "Each period adds the bias b times T to the angle, and a fresh error of the noise, "
                "of variance σ²T². After n periods from the error e₀:",
                InOrder(
                    Eq(printed.GYRO_ERROR, derived.start_error + printed.n * BIAS * T),
                    Eq(printed.GYRO_VARIANCE, printed.n * derived.gyro_noise**2 * T**2),
                ),
            ),
        ),
    ),
    Case(
        "estimation.3.b",
        steps=(
            Step(
                "An acceleration adds to each axis of the gyro what couples in from all three.",
                Eq(
                    MatAdd(claims.READING_ACCELERATED, -claims.READING),
                    MatMul(ImmutableMatrix(COUPLING), ImmutableMatrix(ACCELEROMETER)),
                ),
            ),
        ),
        remark="Nominally: its companion on sensors has the term that is left out here, the "
        "coupling C of a gyro to acceleration.",
    ),
    Case(
        "estimation.3.c",
        edits=(Edit(PROJECTIONS, MatMul(Inverse(AXES_OF_THE_TURNS), BODY)),),
        witness={phi: 0, theta: 60 * DEGREE, psi: 0, p: 0, q: 0, r: 90 * DEGREE},
        root="rates-by-projection",
        weight="misleads",
        steps=(
            Step(
                "The gyros read the three turns together, each about its own axis.",
                Eq(BODY, MatMul(AXES_OF_THE_TURNS, printed.RATES)),
            ),
            Step(
                "The axes of roll and yaw are not at right angles: of the products of two axes "
                "that one does not vanish. So no rate can be read off as a projection; one has to "
                "solve for the three together.",
                Eq(
                    MatMul(AXES_OF_THE_TURNS.T, AXES_OF_THE_TURNS),
                    ImmutableMatrix([[1, 0, -sin(theta)], [0, 1, 0], [-sin(theta), 0, 1]]),
                ),
            ),
        ),
        remark="Said as in the note on Euler angles, see euler.7.a. The rates that follow are "
        "right, but these words do not lead to them: the rotation goes from the Euler rates to the "
        "body, and then has to be inverted.",
    ),
)

CASES = complete(DOCUMENTS["estimation"], READ, (*SETTLED, *OBSERVER))
