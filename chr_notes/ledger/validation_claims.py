"""What the paper on validating Euler angles says in words, before the judgement."""

from sympy import (
    Abs,
    EmptySet,
    Eq,
    ImmutableMatrix,
    Integer,
    MatMul,
    Ne,
    Pow,
    Rational,
    S,
    cos,
    sin,
    sqrt,
)

from chr_notes.derivations import estimation
from chr_notes.derivations import validation as derived
from chr_notes.derivations.steps import Step
from chr_notes.ledger.case import DEGREE, Case
from chr_notes.ledger.condition import Condition
from chr_notes.ledger.edits import Edit
from chr_notes.ledger.validation_attitude import NO_INFORMATION, ROTATED_GRAVITY, TANGENT
from chr_notes.ledger.validation_presumed import BIAS, SEEN
from chr_notes.ledger.validation_reading import (
    ALTITUDE,
    E_ALONG_FIELD,
    FIELD_X_NORTH,
    GROUND_DIRECTION,
    GROWTH,
    HIGH_DIRECTION,
    READ_GRAVITY,
    READ_SOUTH,
    READ_STEPS,
    READINGS,
    SIGNED_GROWTH,
    SOME_ATTITUDE,
    SOME_FIELD,
    WITHOUT_YAW,
)
from chr_notes.printed import validation as printed
from chr_notes.printed import validation_claims as claims
from chr_notes.printed.statement import Approximately, InOrder, chain
from chr_notes.symbols import (
    g,
    phi,
    theta,
)

SETTLED = (
    Case("validation.17", definition=True),
    Case(
        "validation.a",
        readings=READINGS,
        remark="The sentence says what the label says. The elements that equation 1 prints under "
        "it take the components the other way, from the body to the inertial frame: that error "
        "counts there.",
    ),
    Case(
        "validation.b",
        edits=(Edit(EmptySet, S.Reals),),
        root="no-information",
        weight="small print",
        told_in="validation.k",
        steps=(
            Step(
                "As formulas, of any components, the two are minus inverse to each other. If both "
                "were the tangent of one yaw, its square would be −1, and no number has that for a "
                "square.",
                InOrder(Eq(claims.BY_6 * claims.BY_7, -1), Ne(TANGENT**2, -1, evaluate=False)),
            ),
            NO_INFORMATION,
            Step(
                "The reason is this: a turn about the vertical leaves gravity as it is, so what "
                "the accelerometer reads is the same at every yaw.",
                chain(printed.G_B, ROTATED_GRAVITY, MatMul(WITHOUT_YAW, printed.G_I)),
            ),
        ),
        remark="As formulas, of any three components, equations 6 and 7 are minus inverse to each "
        "other; only so does the premise hold, and the conclusion follows from gravity, not from "
        "it. Of gravity's they do not contradict each other: both read 0/0, and from a division "
        "by zero anything seems to follow. Multiplied out they hold for every yaw. That yaw cannot "
        "be told, the paper's conclusion, is right: see validation.k.",
    ),
    Case(
        "validation.h",
        edits=(Edit(printed.G_B, -printed.G_B),),
        witness={phi: 0, theta: 30 * DEGREE, g: Rational(98, 10)},
        root="gravity-or-reading",
        weight="misleads",
        steps=(
            Step(
                "Gravity points down. In the body frame it has these components, by equation 2.",
                Eq(
                    printed.G_B,
                    ImmutableMatrix(
                        [-g * sin(theta), g * cos(theta) * sin(phi), g * cos(theta) * cos(phi)]
                    ),
                ),
            ),
            Step(
                "At rest all forces cancel, so the force that holds the proof mass up is minus its "
                "weight. Per unit of mass it is the reading: level, one g upwards.",
                Eq(
                    claims.READING,
                    ImmutableMatrix(
                        [g * sin(theta), -g * cos(theta) * sin(phi), -g * cos(theta) * cos(phi)]
                    ),
                ),
            ),
        ),
        remark="An accelerometer measures the force that holds it up. At rest that is minus "
        "gravity, in each component.",
    ),
    Case(
        "validation.k",
        remark="This is the whole reason why an accelerometer cannot give yaw, see validation.b.",
    ),
    Case("validation.o", READ_GRAVITY),
    Case(
        "validation.c",
        condition=Condition(Eq(BIAS, 0)),
        witness={
            BIAS: DEGREE,
            printed.ALPHA: Rational(2, 100),
            printed.DT: Rational(1, 100),
            estimation.start_error: 0,
            printed.ROLL_ACCEL: 0,
        },
        root="bias-stays",
        weight="misleads",
        steps=(
            Step(
                "Each sample multiplies the distance to the accelerometer's angle by 1 - α, after "
                "the gyro has added what it reads at rest.",
                Eq(
                    printed.SETTLING,
                    printed.ROLL_ACCEL
                    + (1 - printed.ALPHA) ** printed.n * estimation.start_error
                    + (1 - (1 - printed.ALPHA) ** printed.n)
                    * (1 - printed.ALPHA)
                    / printed.ALPHA
                    * BIAS
                    * printed.DT,
                ),
            ),
        ),
        remark="Only if the gyro reads zero when it does not move. The paper's own Figure 2 shows "
        "that it does not; with a bias the filter comes to rest beside the accelerometer's angle, "
        "by 0.49° for 1°/s at 100 samples a second and α = 0.02.",
    ),
    Case(
        "validation.d",
        condition=Condition(Eq(SEEN[2], printed.M_ZI)),
        witness={
            **SOME_ATTITUDE,
            printed.ROLL_COMP: SOME_ATTITUDE[phi],
            printed.PITCH_COMP: SOME_ATTITUDE[theta],
            **SOME_FIELD,
            # The field of the reference with a twentieth of it added downwards, normalised.
            SEEN[0]: 12 / sqrt(433),
            SEEN[2]: 17 / sqrt(433),
        },
        root="factor-needs-field",
        weight="misleads",
        steps=(
            Step(
                "At exact roll and pitch the brackets of equation 17 are the third line of "
                "equation 12: the part down of the normalised field that the magnetometer sees.",
                Eq(
                    printed.M_ZB * cos(phi) * cos(theta)
                    + printed.M_YB * cos(theta) * sin(phi)
                    - printed.M_XB * sin(theta),
                    SEEN[2],
                ),
            ),
        ),
        remark="Exact angles are not enough: the field must still point down as much as when the "
        "reference was taken, and the magnetometer must be faultless. Where the field points 53° "
        "down, iron that adds five percent of it downwards makes E = 0.017 with the best of "
        "angles.",
    ),
    Case(
        "validation.e",
        READ_SOUTH,
        edits=(
            Edit(
                printed.M_E * cos(printed.INCLINATION),
                -printed.M_E * cos(printed.INCLINATION),
            ),
        ),
        witness={printed.INCLINATION: 68 * DEGREE, derived.declination: 0, printed.M_E: 1},
        root="south-field",
        weight="misleads",
        steps=(
            Step(
                "With x to the magnetic north and z down, the inclination α below the horizon "
                "shares the field between the two.",
                Eq(
                    FIELD_X_NORTH,
                    ImmutableMatrix(
                        [
                            printed.M_E * cos(printed.INCLINATION),
                            0,
                            printed.M_E * sin(printed.INCLINATION),
                        ]
                    ),
                ),
            ),
            Step(
                "Half a turn about the vertical points x to the south: the level parts change "
                "their signs.",
                Eq(
                    printed.M_I,
                    MatMul(ImmutableMatrix([[-1, 0, 0], [0, -1, 0], [0, 0, 1]]), FIELD_X_NORTH),
                ),
            ),
        ),
        remark="The horizontal part of the field points to magnetic north, against an x-axis that "
        "points south: its sign is wrong. South is read as magnetic south, since the y component "
        "is zero: the declination δ would leave one. (z is down, as for gravity in equation 2; "
        "as the paper normalises its vectors, $M_e$ is 1.)",
    ),
    Case(
        "validation.f",
        READ_STEPS,
        steps=(
            Step(
                "To first approximation the Earth is a dipole: its field falls with the third "
                "power of the distance from the centre, and keeps its direction above one place.",
                InOrder(
                    Eq(
                        claims.GROUND_MAGNITUDE,
                        derived.dipole_strength
                        * sqrt(1 + 3 * sin(derived.latitude) ** 2)
                        / derived.radius**3,
                    ),
                    Eq(HIGH_DIRECTION, GROUND_DIRECTION),
                ),
            ),
            Step(
                "A height h above the ground it is weaker by the cube of a quotient of distances. "
                "A kilometre up that is half a thousandth only.",
                InOrder(
                    Eq(
                        claims.HIGH_MAGNITUDE / claims.GROUND_MAGNITUDE,
                        (derived.radius / (derived.radius + ALTITUDE)) ** 3,
                    ),
                    Approximately(Pow(Rational(6371, 6372), 3, evaluate=False), "0.9995"),
                ),
            ),
        ),
        remark="True, and small. What normalising removes above all is an error of the "
        "magnetometer's scale, and the difference between places.",
    ),
    Case(
        "validation.g",
        READ_STEPS,
        edits=(Edit(Integer(3), Integer(2)),),
        root="factor-blind",
        weight="misleads",
        steps=(
            Step(
                "Let the attitude be off by a small turn about an axis n. With its sign, before "
                "the magnitude is taken, the difference changes by the vertical part of n × M.",
                Eq(
                    SIGNED_GROWTH,
                    derived.ERROR_AXIS[0] * printed.M_YI - derived.ERROR_AXIS[1] * printed.M_XI,
                ),
            ),
            Step(
                "E is its magnitude and begins at zero, so it grows by the magnitude of that. A "
                "tilt ε about the field's own horizontal direction shows only in second order, "
                "and yaw not at all, for it turns about the vertical. Roll turns about the nose "
                "and pitch about a level axis, which only at single headings point along the "
                "field.",
                InOrder(
                    Eq(GROWTH, Abs(SIGNED_GROWTH)),
                    Eq(E_ALONG_FIELD, Abs(printed.M_ZI * (1 - cos(derived.error_angle)))),
                    Eq(claims.SHOWN_BY_E, 2),
                ),
            ),
        ),
        remark="E is blind to yaw altogether: yaw does not stand in it. Roll and pitch it does not "
        "tell apart: at any moment it tells one combination of the two, the tilt about the "
        "horizontal line across the field.",
    ),
)
