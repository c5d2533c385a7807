"""The note on attitude estimation before the judgement."""

from functools import partial

from sympy import (
    And,
    Eq,
    ImmutableMatrix,
    MatrixSymbol,
    Ne,
    Rational,
    Symbol,
    ZeroMatrix,
    atan2,
    cos,
    sqrt,
    symbols,
)

from chr_notes.derivations import estimation as derived
from chr_notes.derivations.euler import euler_rates
from chr_notes.derivations.sensors import specific_force
from chr_notes.derivations.steps import Step
from chr_notes.ledger import ranges
from chr_notes.ledger.case import DEGREE, NOTHING, Case, Condition, complete
from chr_notes.ledger.reading import elements, reading
from chr_notes.printed import estimation as printed
from chr_notes.symbols import EULER_RATES, T, g, m, phi, pitch_rate, roll_rate, theta

FORCE = ImmutableMatrix(symbols("F_x F_y F_z", real=True))
# What holds the body besides gravity, and the magnitude of what the accelerometer reads.
SUPPORT = MatrixSymbol(r"\text{all forces but gravity}", 3, 1)
FREE_FALL = MatrixSymbol(r"\text{reading under gravity alone}", 3, 1)
MAGNITUDE = Symbol(r"\left\lVert\mathbf{a}_m\right\rVert", positive=True)

SETTLED_ERROR = Symbol(r"e_\infty", real=True)

# Any forces; no net force; the reading's direction as at rest, its magnitude whatever it is.
READ = reading(
    {
        printed.A_M: lambda: specific_force(FORCE, derived.weight(), m),
        printed.F: FORCE,
        printed.F_G: derived.weight,
        **elements(EULER_RATES, euler_rates),
    }
)
READ_AT_REST = reading(
    {
        printed.A_M: derived.accelerometer_at_rest,
        printed.F: NOTHING,
        printed.F_G: derived.weight,
        SUPPORT: lambda: ImmutableMatrix(-derived.weight()),
        FREE_FALL: lambda: specific_force(derived.weight(), derived.weight(), m),
    }
)
READ_TILT = reading(
    {
        **elements(
            (printed.A_MX, printed.A_MY, printed.A_MZ),
            lambda: MAGNITUDE * derived.accelerometer_at_rest() / g,
        ),
        printed.ROLL_ACCEL: phi,
        printed.PITCH_ACCEL: theta,
    }
)
READ_GYRO = reading(
    {
        printed.ROLL_PLUS: derived.euler_step(printed.ROLL, roll_rate),
        printed.PITCH_PLUS: derived.euler_step(printed.PITCH, pitch_rate),
        printed.GYRO_ERROR: derived.gyro_error_after,
        printed.GYRO_VARIANCE: derived.gyro_variance_after,
    }
)
READ_OBSERVER = reading(
    {
        printed.PITCH: lambda: derived.update(printed.PITCH_PLUS, printed.PITCH_ACCEL),
        printed.ROLL: lambda: derived.update_on_circle(printed.ROLL_PLUS, printed.ROLL_ACCEL),
        printed.ERROR: derived.error_after,
        SETTLED_ERROR: derived.steady_bias_error,
        printed.GROWTH: derived.error_growth,
        printed.KALMAN_GAIN: derived.kalman_gain,
        printed.BEST_GAIN: derived.best_gain,
        **{
            name: partial(share, gain)
            for names, share in (
                (printed.BIAS, derived.steady_bias_error),
                (printed.GYRO_NOISE, derived.gyro_share),
                (printed.VIBRATION, derived.vibration_share),
            )
            for name, gain in zip(names, (printed.L_1, printed.L_2), strict=True)
        },
    }
)

PITCH_RANGE = ranges.up_to_right_angle(theta)
STEP_NOISE = derived.gyro_noise * T
COSINE_GAP = Symbol("c", positive=True)

SETTLED = (
    *(Case(f"estimation.2.{equation}", READ_AT_REST) for equation in (2, 4)),
    Case(
        "estimation.2.5",
        READ_TILT,
        given=(PITCH_RANGE,),
        condition=Condition(Eq(MAGNITUDE, g)),
        witness={phi: 0, theta: 30 * DEGREE, MAGNITUDE: Rational(108, 10), g: Rational(98, 10)},
        steps=(
            Step(
                "The direction of the reading holds the pitch; its length should not matter. So "
                "compare the x component with the rest of the reading, not with a number that the "
                "rest may contradict.",
                Eq(
                    printed.PITCH_ACCEL,
                    atan2(printed.A_MX, sqrt(printed.A_MY**2 + printed.A_MZ**2)),
                ),
            ),
        ),
        remark="The reading must have exactly the magnitude g. In a lift that starts upwards with "
        "1 m/s² it is 10.8 m/s², and a pitch of 30° comes out as 33.4°; a little above g the "
        "arcsine has no value at all. An error of scale does the same. The step shows a form that "
        "needs no g.",
    ),
    Case(
        "estimation.2.6",
        READ_TILT,
        given=(PITCH_RANGE,),
        condition=ranges.acute(phi, theta),
        witness={phi: 150 * DEGREE, theta: 0},
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
        READ_AT_REST,
        correction=And(Eq(printed.F, ZeroMatrix(3, 1)), Eq(SUPPORT, -printed.F_G)),
        witness={phi: 0, theta: 0, m: 1, g: Rational(98, 10)},
        steps=(
            Step(
                "If gravity were the only force, F would be the force of gravity, and the model "
                "of the reading would give zero. That is free fall.",
                Eq(FREE_FALL, ZeroMatrix(3, 1)),
            ),
            Step(
                "F = 0 says that something holds the body against gravity. This force is what the "
                "accelerometer reads.",
                Eq(printed.A_M, SUPPORT / m),
            ),
        ),
        remark="The assumption F = 0 leads to the right reading. But it does not say that only "
        "gravity acts: it says that all other forces together just cancel gravity.",
    ),
    *(Case(f"estimation.{name}", READ_GYRO) for name in ("3.2", "3.3", "3.a", "4.1", "4.2")),
    Case(
        "estimation.4.4",
        READ_OBSERVER,
        condition=ranges.short_turn(printed.ROLL_PLUS, printed.ROLL_ACCEL),
        witness={
            printed.ROLL_PLUS: 179 * DEGREE,
            printed.ROLL_ACCEL: -179 * DEGREE,
            printed.L: Rational(2, 100),
        },
        steps=(
            Step(
                "Roll goes all the way round. The correction must be the shorter way from the "
                "predicted to the measured roll: the difference less whole turns.",
                Eq(
                    printed.ROLL,
                    printed.ROLL_PLUS
                    + printed.L * derived.shortest_turn(printed.ROLL_ACCEL - printed.ROLL_PLUS),
                ),
            ),
        ),
        remark="From 179° to -179° it is 2°, but their difference is -358°: as printed, the update "
        "turns the estimate back by a good part of a revolution. Pitch has no such seam.",
    ),
    Case(
        "estimation.4.c",
        READ_OBSERVER,
        given=(ranges.from_0_to_1(printed.L),),
        condition=ranges.above_0_to_1(printed.L),
        witness={
            printed.L: 0,
            derived.bias: DEGREE / 10,
            derived.start_error: 0,
            T: Rational(1, 100),
        },
        steps=(
            Step(
                "One step multiplies the error by 1 - L, after the gyro's bias b has added bT to "
                "it. Solved for the error after n steps:",
                Eq(
                    printed.ERROR,
                    (1 - printed.L) ** printed.n * derived.start_error
                    + (1 - (1 - printed.L) ** printed.n)
                    * (1 - printed.L)
                    / printed.L
                    * derived.bias
                    * T,
                ),
            ),
            Step(
                "The powers die out. The error stops growing where a step leaves it as it is, and "
                "there it is not zero.",
                Eq(SETTLED_ERROR, (1 - printed.L) / printed.L * derived.bias * T),
            ),
        ),
        remark="The note allows L = 0, and there the estimate drifts as the gyro alone does, by 6° "
        "a minute with a bias of 0.1°/s. With any larger gain the error stays bounded. It does not "
        "vanish: a constant bias leaves the constant error of the last step, and the "
        "accelerometer's own error stays whole.",
    ),
    Case(
        "estimation.4.d",
        READ_OBSERVER,
        steps=(
            Step(
                "The settled Kalman gain for one angle, with white noise on gyro and "
                "accelerometer:",
                Eq(
                    printed.KALMAN_GAIN,
                    STEP_NOISE
                    * (sqrt(4 * derived.accel_noise**2 + STEP_NOISE**2) - STEP_NOISE)
                    / (2 * derived.accel_noise**2),
                ),
            ),
        ),
        remark="Optimal means: the least variance of the error, once settled, for white noise of "
        "known strength and one angle. A bias is not white noise; a filter that is to be optimal "
        "with one has to estimate it.",
    ),
    Case(
        "estimation.4.e",
        READ_OBSERVER,
        given=(ranges.proper_fractions(printed.L_1, printed.L_2),),
        condition=Condition(Ne(cos(derived.omega * T), 1)),
        witness={
            derived.omega: 0,
            T: Rational(1, 100),
            printed.L_1: Rational(2, 100),
            printed.L_2: Rational(5, 100),
        },
        steps=(
            Step(
                "Of a constant bias b of the gyro, this error stays. It falls as L grows.",
                Eq(
                    printed.BIAS[0],
                    (1 - printed.L_1) / printed.L_1 * derived.bias * T,
                ),
            ),
            Step(
                "Of white noise of the gyro, of variance one, this variance stays. It falls, too.",
                Eq(
                    printed.GYRO_NOISE[0],
                    (1 - printed.L_1) ** 2 / (printed.L_1 * (2 - printed.L_1)) * T**2,
                ),
            ),
            Step(
                "Of a vibration of angular frequency ω in the accelerometer's angle, this part of "
                "its power comes through. It grows with L, unless the cosine is 1.",
                Eq(
                    printed.VIBRATION[0],
                    printed.L_1**2
                    / (printed.L_1**2 + 2 * (1 - printed.L_1) * (1 - cos(derived.omega * T))),
                ),
            ),
        ),
        remark="True of bias, noise and vibration. But a force that stays (ω = 0), as while a "
        "vehicle gathers speed, comes through whole with every gain above zero: a small L only "
        "delays it.",
    ),
)

CASES = complete(
    printed.PRINTED,
    READ,
    (*SETTLED, *(Case(f"estimation.4.{name}", READ_OBSERVER) for name in ("3", "a", "b"))),
)
