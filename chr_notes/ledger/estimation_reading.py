"""How the note on attitude estimation is read: what its symbols mean."""

from functools import partial

from sympy import (
    Eq,
    Expr,
    FiniteSet,
    ImmutableMatrix,
    MatrixSymbol,
    Ne,
    Set,
    Symbol,
    cos,
    pi,
    symbols,
)

from chr_notes.derivations import calibration
from chr_notes.derivations import estimation as derived
from chr_notes.derivations.calibration import COUPLING
from chr_notes.derivations.euler import euler_rates
from chr_notes.derivations.sensors import specific_force
from chr_notes.ledger import ranges
from chr_notes.ledger.case import NOTHING
from chr_notes.ledger.condition import Condition, Presumed
from chr_notes.ledger.reading import elements, reading
from chr_notes.ledger.shared_steps import HOLDING, PROOF_MASS
from chr_notes.printed import estimation as printed
from chr_notes.printed import estimation_claims as claims
from chr_notes.symbols import BODY_RATES, EULER_RATES, AngularRate, T, m, phi, theta

# All forces on the body; the gyro's bias, of either sign.
FORCE = ImmutableMatrix(symbols("F_x F_y F_z", real=True))
BIAS = AngularRate("b", real=True)

# What steps speak of: what holds the body besides gravity, the reading in free fall, the error at
# which the observer comes to rest.
SUPPORT = MatrixSymbol(r"\text{all forces but gravity}", 3, 1)
FREE_FALL = MatrixSymbol(r"\text{reading under gravity alone}", 3, 1)
SETTLED_ERROR = Symbol(r"e_\infty", real=True)


def accelerometer() -> ImmutableMatrix:
    """Read an accelerometer under any forces."""
    return specific_force(FORCE, derived.weight(), m)


def arguments() -> Set:
    """Find what the rates of roll and pitch depend on."""
    roll_rate, pitch_rate, _ = euler_rates()
    return FiniteSet(*(roll_rate.free_symbols | pitch_rate.free_symbols))


def mean() -> Expr:
    """Average many estimates after n steps: the noise averages out, a bias of the gyro does not."""
    return claims.AVERAGE_ANGLE + derived.error_after().subs(derived.bias, BIAS)


READ = reading(
    {
        printed.A_M: accelerometer,
        **elements((printed.A_MX, printed.A_MY, printed.A_MZ), accelerometer),
        HOLDING: lambda: PROOF_MASS * accelerometer(),
        printed.F: FORCE,
        printed.F_G: derived.weight,
        SUPPORT: lambda: ImmutableMatrix(FORCE - derived.weight()),
        FREE_FALL: lambda: specific_force(derived.weight(), derived.weight(), m),
        **elements(EULER_RATES, euler_rates),
        claims.ARGUMENTS: arguments,
        claims.READING: ImmutableMatrix(BODY_RATES),
        claims.READING_ACCELERATED: lambda: ImmutableMatrix(
            ImmutableMatrix(BODY_RATES) + calibration.coupled()
        ),
        printed.GYRO_ERROR: lambda: derived.gyro_error_after().subs(derived.bias, BIAS),
        printed.GYRO_VARIANCE: derived.gyro_variance_after,
        printed.ERROR: derived.error_after,
        SETTLED_ERROR: derived.steady_bias_error,
        printed.GROWTH: derived.error_growth,
        claims.MEAN: mean,
        printed.KALMAN_GAIN: derived.kalman_gain,
        printed.BEST_GAIN: derived.best_gain,
        # Of all banks of level turns, this one.
        claims.BANK: pi / 6,
        claims.BANK_ACCEL: partial(derived.roll_in_level_turn, pi / 6, printed.n * T),
        **{
            name: partial(share, gain)
            for names, share in (
                (printed.BIAS, derived.steady_bias_error),
                (printed.GYRO_NOISE, derived.gyro_share),
                (printed.VIBRATION, derived.vibration_share),
            )
            for name, gain in zip(names, (printed.L_1, printed.L_2), strict=True)
        },
    },
    presumed=(
        Presumed(Condition(Ne(BIAS, 0)), "by its bias", "estimation.3.a"),
        Presumed(
            Condition(Eq(FORCE, NOTHING)),
            "add up to nothing",
            "estimation.2.2",
            ("estimation.2.2", "estimation.2.4", "estimation.2.5", "estimation.2.6"),
        ),
        Presumed(Condition(Eq(FORCE, NOTHING)), "add up to zero", "estimation.2.a"),
        Presumed(
            ranges.up_to_right_angle(theta),
            "Pitch",
            "estimation.2.5",
            ("estimation.2.5", "estimation.2.6"),
        ),
        # The note takes the arctangent of a quotient for it.
        Presumed(
            ranges.acute(printed.ROLL_ACCEL),
            "Roll from the accelerometer",
            "estimation.2.6",
            ("estimation.4.4",),
        ),
        Presumed(ranges.from_0_to_1(printed.L), "the gain L", "estimation.4.4"),
        Presumed(ranges.above_0_to_1(printed.L), "combined", "estimation.4.c"),
        Presumed(ranges.between_0_and_1(printed.L), "pull", "estimation.4.f"),
        Presumed(
            Condition(Eq(ImmutableMatrix(COUPLING), ImmutableMatrix.zeros(3, 3))),
            "nominally",
            "estimation.3.b",
        ),
        Presumed(Condition(Ne(cos(derived.omega * T), 1)), "in general more", "estimation.4.e"),
        Presumed(
            ranges.proper_fractions(printed.L_1, printed.L_2),
            "Of two gains, the larger",
            "estimation.4.e",
        ),
    ),
)
# At rest the accelerometer's angles are those of the body.
READ_TILT = READ.also({printed.ROLL_ACCEL: phi, printed.PITCH_ACCEL: theta})
# The note writes one letter for the estimate before and after: what is predicted, what is updated.
READ_PREDICTION = READ.also(
    {
        printed.ROLL_PLUS: lambda: derived.euler_step(printed.ROLL, euler_rates()[0]),
        printed.PITCH_PLUS: lambda: derived.euler_step(printed.PITCH, euler_rates()[1]),
    }
)
READ_UPDATE = READ.also(
    {
        printed.ROLL: lambda: derived.update_on_circle(printed.ROLL_PLUS, printed.ROLL_ACCEL),
        printed.PITCH: lambda: derived.update(printed.PITCH_PLUS, printed.PITCH_ACCEL),
    }
)
