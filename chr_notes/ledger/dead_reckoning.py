"""The note on dead reckoning before the judgement."""

from sympy import (
    And,
    Eq,
    Expr,
    ImmutableMatrix,
    Ne,
    Rational,
    Symbol,
    cos,
    exp,
    expand,
    sin,
    symbols,
)

from chr_notes.derivations import dead_reckoning as derived
from chr_notes.derivations.euler import Z, rotation
from chr_notes.derivations.steps import Step
from chr_notes.ledger import table_1
from chr_notes.ledger.case import DEGREE, NOTHING, Case, Condition, complete
from chr_notes.ledger.reading import reading
from chr_notes.printed import dead_reckoning as printed
from chr_notes.symbols import T, g, phi, psi, theta

# The gravity that is added, which may not be the local one; the accelerometer's own error.
ADDED_G = Symbol(r"\hat{g}", positive=True)
OWN_ERROR = ImmutableMatrix(symbols("varepsilon_x:z", real=True))
# What the acceleration adds to velocity and position; sums of n steps.
GAINED_VELOCITY = ImmutableMatrix(symbols("u_N u_E u_D", real=True))
GAINED_POSITION = ImmutableMatrix(symbols("s_N s_E s_D", real=True))
SUMMED_VELOCITY, SUMMED_POSITION = symbols("v_n r_n", real=True)


def _by_exponentials(expression: Expr) -> Expr:
    return expand(expand(expression).rewrite(exp))


def estimated_acceleration() -> ImmutableMatrix:
    """Follow the note's step: the attitude exact, the reading and the added gravity not.

    The reading is the specific force in the body frame and an error of the accelerometer's own.
    """
    there_and_back = (rotation("B", "I") * rotation("I", "B")).applyfunc(_by_exponentials)
    measured = there_and_back * (derived.ACCELERATION - g * Z) + rotation("B", "I") * OWN_ERROR
    return ImmutableMatrix(measured + ADDED_G * Z)


READ = reading(
    {
        printed.A_I: derived.ACCELERATION,
        printed.A_B: lambda: ImmutableMatrix(rotation("I", "B") * derived.ACCELERATION),
        printed.A_M: derived.accelerometer_reading,
        printed.IN_GRAVITIES: lambda: derived.accelerometer_reading() / g,
        printed.V_I: derived.velocity_after(GAINED_VELOCITY),
        printed.R_I: derived.position_after(GAINED_POSITION),
        printed.INTEGRAL: GAINED_VELOCITY,
        printed.DOUBLE_INTEGRAL: GAINED_POSITION,
        printed.A_K: derived.ACCELERATION,
        printed.V_K: derived.VELOCITY,
        printed.R_K: derived.POSITION,
        printed.V_NEXT: derived.velocity_after_step,
        printed.R_NEXT: derived.position_after_step,
        printed.ESTIMATED: estimated_acceleration,
        printed.OWN_ERROR: OWN_ERROR,
        printed.RESIDUE: derived.residual_acceleration,
        SUMMED_VELOCITY: derived.velocity_by_steps,
        SUMMED_POSITION: derived.position_by_steps,
        **table_1.MEANING,
    }
)

_ACCELERATION, _VELOCITY, _POSITION, _JERK = (
    dict.fromkeys(vector, 0)
    for vector in (derived.ACCELERATION, derived.VELOCITY, derived.POSITION, derived.JERK)
)

RESIDUE_OF_TILT = Step(
    "At rest the accelerometer reads minus gravity. Turned by an attitude of which the vertical is "
    "off by ε, it does not cancel the gravity that is added: along the ground g sin ε stays, in "
    "the direction of the tilt, and a little along the vertical.",
    Eq(
        printed.RESIDUE,
        ImmutableMatrix(
            [
                g * sin(derived.tilt_error) * cos(derived.azimuth),
                g * sin(derived.tilt_error) * sin(derived.azimuth),
                g * (1 - cos(derived.tilt_error)),
            ]
        ),
    ),
)

SETTLED = (
    Case(
        "dead_reckoning.3.1",
        READ,
        condition=Condition(Eq(derived.VELOCITY, NOTHING)),
        witness={
            **_VELOCITY,
            **dict.fromkeys(GAINED_VELOCITY, 0),
            derived.VELOCITY[0]: 10,
            derived.t: 60,
        },
        steps=(
            Step(
                "The integral of the acceleration is what the velocity has gained since the "
                "start. The velocity at the start has to be added.",
                Eq(printed.V_I, derived.VELOCITY + printed.INTEGRAL),
            ),
        ),
        remark="The velocity at the start is missing, and an accelerometer cannot know it: at a "
        "steady 10 m/s it reads what it reads at rest.",
    ),
    Case(
        "dead_reckoning.3.2",
        READ,
        condition=Condition(
            And(
                Eq(derived.POSITION, NOTHING),
                Eq(derived.VELOCITY, NOTHING),
            ),
        ),
        witness={
            **_POSITION,
            **_VELOCITY,
            **dict.fromkeys(GAINED_POSITION, 0),
            derived.VELOCITY[0]: 10,
            derived.t: 60,
        },
        steps=(
            Step(
                "Position and velocity at the start have to be added, the velocity times the time "
                "that has gone by.",
                Eq(
                    printed.R_I,
                    derived.POSITION + derived.VELOCITY * derived.t + printed.DOUBLE_INTEGRAL,
                ),
            ),
        ),
        remark="Position and velocity at the start are missing. With 10 m/s at the start it is "
        "600 m off after a minute.",
    ),
    Case(
        "dead_reckoning.3.3",
        READ,
        condition=Condition(Eq(derived.JERK, NOTHING)),
        witness={
            **_VELOCITY,
            **_ACCELERATION,
            **_JERK,
            derived.JERK[0]: 10,
            T: Rational(1, 10),
        },
        steps=(
            Step(
                "With an acceleration that changes at the rate j within the step:",
                Eq(
                    printed.V_NEXT,
                    printed.V_K + T * printed.A_K + T**2 / 2 * derived.JERK,
                ),
            ),
        ),
        remark="Exact only if the acceleration stays constant during the step. Otherwise it is an "
        "approximation, the better the shorter the step.",
    ),
    Case(
        "dead_reckoning.3.4",
        READ,
        condition=Condition(
            And(
                Eq(derived.ACCELERATION, NOTHING),
                Eq(derived.JERK, NOTHING),
            ),
        ),
        witness={
            **_POSITION,
            **_VELOCITY,
            **_ACCELERATION,
            **_JERK,
            derived.ACCELERATION[0]: 2,
            T: Rational(1, 10),
        },
        steps=(
            Step(
                "With an acceleration a that changes at the rate j within the step:",
                Eq(
                    printed.R_NEXT,
                    printed.R_K
                    + T * printed.V_K
                    + T**2 / 2 * printed.A_K
                    + T**3 / 6 * derived.JERK,
                ),
            ),
            Step(
                "With a constant acceleration from rest, n of the note's two steps add up to the "
                "exact ½ a (nT)² less a remainder, as if each velocity came one period late.",
                Eq(
                    SUMMED_POSITION,
                    derived.a * (derived.n * T) ** 2 / 2 - derived.a * T * (derived.n * T) / 2,
                ),
            ),
        ),
        remark="Exact only if the velocity stays constant during the step, that is without "
        "acceleration. The remainder, ½ a T times the time, shrinks with the period T; adding "
        "½ T² a[k] to the step removes it.",
    ),
    Case(
        "dead_reckoning.4.f",
        READ,
        condition=Condition(Eq(ADDED_G, g)),
        witness={
            **dict.fromkeys((phi, theta, psi, *derived.ACCELERATION, *OWN_ERROR), 0),
            ADDED_G: table_1.PRINTED_G,
            g: Rational(9832, 1000),
        },
        remark="The gravity that is added must be the local one. It runs from 9.780 m/s² at the "
        "equator to 9.832 at the poles; with the note's 9.8 a body at rest at a pole seems to "
        "accelerate by 0.032 m/s², more than 0.1° of tilt would make.",
    ),
    Case(
        "dead_reckoning.4.g",
        READ,
        condition=Condition(Ne(cos(derived.tilt_error), 1)),
        witness={
            derived.tilt_error: 0,
            derived.azimuth: 0,
            derived.yaw_error: 5 * DEGREE,
            g: table_1.PRINTED_G,
        },
        steps=(RESIDUE_OF_TILT,),
        remark="It takes an error of tilt. An error of yaw alone turns everything about the "
        "vertical, and gravity with it into itself: at rest nothing is left over.",
    ),
)

CASES = complete(printed.PRINTED, READ, (*SETTLED, *table_1.SETTLED))
