"""The note on attitude estimation before the judgement: gyro and accelerometer together."""

from sympy import Eq, Rational, cos, sqrt

from chr_notes.derivations import estimation as derived
from chr_notes.derivations.steps import Step
from chr_notes.ledger import ranges
from chr_notes.ledger.case import DEGREE, Case
from chr_notes.ledger.condition import Condition
from chr_notes.ledger.estimation_reading import BIAS, READ_PREDICTION, READ_UPDATE, SETTLED_ERROR
from chr_notes.ledger.shared_steps import held
from chr_notes.printed import estimation as printed
from chr_notes.printed import estimation_claims as claims
from chr_notes.symbols import T, pitch_rate, roll_rate

STEP_NOISE = derived.gyro_noise * T

SETTLED = (
    Case(
        "estimation.4.1", READ_PREDICTION, steps=held(pitch_rate, printed.PITCH, printed.PITCH_PLUS)
    ),
    Case("estimation.4.2", READ_PREDICTION, steps=held(roll_rate, printed.ROLL, printed.ROLL_PLUS)),
    Case(
        "estimation.4.3",
        READ_UPDATE,
        steps=(
            Step(
                "The prediction is one witness, the accelerometer's angle the other. The angle "
                "that fits both best, their squares weighted by 1 − L and L, is where the slope of "
                "the misfit is zero.",
                Eq(
                    (1 - printed.L) * (printed.PITCH - printed.PITCH_PLUS)
                    + printed.L * (printed.PITCH - printed.PITCH_ACCEL),
                    0,
                ),
            ),
        ),
    ),
    Case(
        "estimation.4.4",
        READ_UPDATE,
        condition=ranges.short_turn(printed.ROLL_PLUS, printed.ROLL_ACCEL),
        witness={
            printed.ROLL_PLUS: 170 * DEGREE,
            printed.ROLL_ACCEL: -80 * DEGREE,
            printed.L: Rational(2, 100),
        },
        root="seam",
        weight="misleads",
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
        remark="The note's arctangent gives angles between −90° and 90°. An estimate that has gone "
        "far beyond, to 170°, is 110° from −80° the shorter way, but the difference of the numbers "
        "is −250°. With a roll from all four quadrants the seam lies in wait everywhere: from 179° "
        "to −179° it is 2°. Pitch has no such seam.",
    ),
    Case("estimation.4.a", READ_UPDATE),
    Case("estimation.4.b", READ_UPDATE),
    Case(
        "estimation.4.c",
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
                "A step leaves the error as it is at this size, which is not zero.",
                Eq(SETTLED_ERROR, (1 - printed.L) / printed.L * derived.bias * T),
            ),
            Step(
                "From one step to the next the error grows by a share of what it lacks of that. "
                "The powers die out, and with them the growth.",
                Eq(
                    printed.GROWTH,
                    printed.L
                    * (1 - printed.L) ** printed.n
                    * (SETTLED_ERROR - derived.start_error),
                ),
            ),
        ),
        remark="Both sensors are combined, so the gain is not zero. (With L = 0, says the note, "
        "only the gyro counts, and the estimate drifts by 6° a minute with a bias of 0.1°/s.) Then "
        "the error stays bounded. It does not vanish: a constant bias leaves the constant error of "
        "the last step, and the accelerometer's own error stays whole.",
    ),
    Case(
        "estimation.4.d",
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
        remark="In general: a force that stays (ω = 0), as while a "
        "vehicle gathers speed, comes through whole with every gain above zero: a small L only "
        "delays it.",
    ),
    Case(
        "estimation.4.f",
        condition=Condition(Eq(BIAS, 0)),
        witness={
            BIAS: DEGREE,
            printed.L: Rational(2, 100),
            T: Rational(1, 100),
            derived.start_error: 0,
            claims.AVERAGE_ANGLE: 0,
        },
        root="bias-stays",
        weight="misleads",
        steps=(
            Step(
                "Over many trials the accelerometer's noise averages out. What is left besides its "
                "average angle is the error at the start, which dies out, and what the gyro's bias "
                "b adds in each step.",
                Eq(
                    claims.MEAN,
                    claims.AVERAGE_ANGLE
                    + (1 - printed.L) ** printed.n * derived.start_error
                    + (1 - (1 - printed.L) ** printed.n) * (1 - printed.L) / printed.L * BIAS * T,
                ),
            ),
        ),
        remark="A bias of the gyro holds the estimate beside the average angle, by 0.49° for 1°/s "
        "at 100 samples a second and L = 0.02. The validation paper says the same of its filter.",
    ),
    Case(
        "estimation.5.a",
        remark="A steady turn is one way, here with a bank of 30°: flown cleanly, it presses "
        "straight through the floor. The accelerometer shows a roll of zero for as long as the "
        "turn lasts.",
    ),
)
