"""What "Fundamentals of Attitude Estimation" prints."""

from sympy import (
    Abs,
    Eq,
    Gt,
    ImmutableMatrix,
    IndexedBase,
    Limit,
    Lt,
    MatAdd,
    MatMul,
    MatrixSymbol,
    Subs,
    Symbol,
    ZeroMatrix,
    asin,
    atan,
    cos,
    oo,
    sin,
    symbols,
    tan,
)

from chr_notes.printed.statement import InOrder, Printed, Rotation, as_printed, chain, words
from chr_notes.symbols import (
    EULER_RATES,
    Angle,
    T,
    g,
    m,
    p,
    phi,
    pitch_rate,
    q,
    r,
    roll_rate,
    theta,
)

A_M = MatrixSymbol(r"\mathbf{a}_m", 3, 1)
F = MatrixSymbol(r"\mathbf{F}", 3, 1)
F_G = MatrixSymbol(r"\mathbf{F}_g", 3, 1)
A_MX, A_MY, A_MZ = symbols("a_{m\\,x} a_{m\\,y} a_{m\\,z}", real=True)
ROLL_ACCEL, PITCH_ACCEL = (
    Angle(rf"\hat{{\{name}}}_{{accel}}", real=True) for name in ("phi", "theta")
)
ROLL, PITCH = (Angle(rf"\hat{{\{name}}}", real=True) for name in ("phi", "theta"))
ROLL_PLUS, PITCH_PLUS = (Angle(rf"\hat{{\{name}}}^{{+}}", real=True) for name in ("phi", "theta"))
L = Symbol("L", real=True)
RATES = ImmutableMatrix(EULER_RATES)

# Names for what the words speak of: the error of the estimate after n steps, its variance, and
# what two gains leave of a gyro's bias, of its noise, and of a vibration.
n = Symbol("n", integer=True, positive=True)
ERROR, GROWTH, GYRO_ERROR, GYRO_VARIANCE = (
    IndexedBase(name)[n]
    for name in ("e", r"\Delta e", r"e^{\text{gyro}}", r"\operatorname{var} e^{\text{gyro}}")
)
KALMAN_GAIN = words("gain of the settled Kalman filter")
BEST_GAIN = words("gain of least variance")
L_1, L_2 = symbols("L_1 L_2", real=True)
BIAS, GYRO_NOISE, VIBRATION = (
    tuple(Symbol(rf"{of}\left({gain}\right)", positive=True) for gain in (L_1, L_2))
    for of in (r"e_{\text{bias}}", r"\sigma^2_{\text{gyro}}", r"\sigma^2_{\text{vibration}}")
)

with as_printed():
    PREDICT_PITCH = Eq(PITCH_PLUS, PITCH + T * pitch_rate)
    PREDICT_ROLL = Eq(ROLL_PLUS, ROLL + T * roll_rate)

with as_printed():
    PRINTED = (
        Printed(
            "estimation.2.1",
            "equation",
            "section 2, paragraph 1",
            "What an accelerometer reads: all forces on the body less that of gravity.",
            Eq(A_M, MatMul(1 / m, MatAdd(F, -F_G))),
        ),
        Printed(
            "estimation.2.2",
            "equation",
            "section 2, paragraph 2",
            "What it reads when the forces on the body add up to nothing.",
            Eq(A_M, MatMul(-1, F_G, 1 / m)),
        ),
        Printed(
            "estimation.2.3",
            "equation",
            "section 2, paragraph 4",
            "Gravity's force, rotated into the body frame.",
            chain(
                F_G,
                MatMul(Rotation("I", "B"), ImmutableMatrix([0, 0, m * g])),
                ImmutableMatrix(
                    [
                        -m * g * sin(theta),
                        m * g * cos(theta) * sin(phi),
                        m * g * cos(phi) * cos(theta),
                    ]
                ),
            ),
        ),
        Printed(
            "estimation.2.4",
            "equation",
            "section 2, paragraph 5",
            "What an accelerometer at rest is expected to read.",
            Eq(
                A_M,
                ImmutableMatrix(
                    [g * sin(theta), -g * cos(theta) * sin(phi), -g * cos(phi) * cos(theta)]
                ),
            ),
        ),
        Printed(
            "estimation.2.5",
            "equation",
            "section 2, paragraph 6",
            "Pitch from the accelerometer.",
            Eq(PITCH_ACCEL, asin(A_MX / g)),
        ),
        Printed(
            "estimation.2.6",
            "equation",
            "section 2, paragraph 6",
            "Roll from the accelerometer.",
            Eq(ROLL_ACCEL, atan(A_MY / A_MZ)),
        ),
        Printed(
            "estimation.2.a",
            "claim",
            "section 2, paragraph 8",
            "The forces on the sensor add up to zero, which is said to mean that gravity is the "
            "only one.",
            InOrder(Eq(F, ZeroMatrix(3, 1)), Eq(F, F_G)),
        ),
        Printed(
            "estimation.3.1",
            "equation",
            "section 3, paragraph 3",
            "Euler rates from the gyros.",
            Eq(
                RATES,
                ImmutableMatrix(
                    [
                        p + q * sin(phi) * tan(theta) + r * cos(phi) * tan(theta),
                        q * cos(phi) - r * sin(phi),
                        q * sin(phi) / cos(theta) + r * cos(phi) / cos(theta),
                    ]
                ),
            ),
        ),
        Printed(
            "estimation.3.2",
            "equation",
            "section 3, paragraph 5",
            "Roll by Euler integration.",
            PREDICT_ROLL,
        ),
        Printed(
            "estimation.3.3",
            "equation",
            "section 3, paragraph 5",
            "Pitch by Euler integration.",
            PREDICT_PITCH,
        ),
        Printed(
            "estimation.3.a",
            "claim",
            "section 3, paragraph 7",
            "The errors of a gyro add up: by its bias, and by its noise, the angle drifts away.",
            InOrder(
                Eq(Limit(Abs(GYRO_ERROR), n, oo), oo),
                Eq(Limit(GYRO_VARIANCE, n, oo), oo),
            ),
        ),
        Printed(
            "estimation.4.1",
            "equation",
            "section 4, paragraph 3",
            "Prediction of pitch.",
            PREDICT_PITCH,
        ),
        Printed(
            "estimation.4.2",
            "equation",
            "section 4, paragraph 3",
            "Prediction of roll.",
            PREDICT_ROLL,
        ),
        Printed(
            "estimation.4.3",
            "equation",
            "section 4, paragraph 4",
            "Update of pitch with the gain L.",
            Eq(PITCH, PITCH_PLUS + L * (PITCH_ACCEL - PITCH_PLUS)),
        ),
        Printed(
            "estimation.4.4",
            "equation",
            "section 4, paragraph 4",
            "Update of roll with the gain L.",
            Eq(ROLL, ROLL_PLUS + L * (ROLL_ACCEL - ROLL_PLUS)),
        ),
        Printed(
            "estimation.4.a",
            "claim",
            "section 4, paragraph 5",
            "With L = 0 only the gyros count.",
            Eq(Subs(PITCH, L, 0), PITCH_PLUS),
        ),
        Printed(
            "estimation.4.b",
            "claim",
            "section 4, paragraph 5",
            "With L = 1 the estimate is the accelerometer's angle.",
            Eq(Subs(PITCH, L, 1), PITCH_ACCEL),
        ),
        Printed(
            "estimation.4.c",
            "claim",
            "section 4, paragraph 1",
            "The combined estimate does not drift: in the long run its error stops growing.",
            Eq(Limit(GROWTH, n, oo), 0),
        ),
        Printed(
            "estimation.4.d",
            "claim",
            "section 4, paragraph 9",
            "A Kalman filter chooses the gain L optimally.",
            Eq(KALMAN_GAIN, BEST_GAIN),
        ),
        Printed(
            "estimation.4.e",
            "claim",
            "section 4, paragraph 6",
            "Of two gains, the larger one makes the estimate less sensitive to bias and noise of "
            "the gyro, and in general more to vibration and other forces.",
            InOrder(
                Lt(BIAS[1], BIAS[0]),
                Lt(GYRO_NOISE[1], GYRO_NOISE[0]),
                Gt(VIBRATION[1], VIBRATION[0]),
            ),
        ),
    )
