"""How the Euler-angle note is read: what its symbols mean."""

from sympy import (
    And,
    Basic,
    Eq,
    FiniteSet,
    ImmutableMatrix,
    Interval,
    MatrixSymbol,
    Ne,
    Set,
    Symbol,
    cos,
    pi,
    sin,
    symbols,
)

from chr_notes.derivations import euler as derived
from chr_notes.derivations import sequences
from chr_notes.derivations.sensors import specific_force
from chr_notes.ledger.case import NOTHING
from chr_notes.ledger.condition import Condition, Presumed
from chr_notes.ledger.reading import Meaning, elements, reading
from chr_notes.printed import euler as printed
from chr_notes.printed import euler_claims as claims
from chr_notes.printed.statement import words
from chr_notes.symbols import EULER, EULER_RATES, g, m, phi, psi, theta

FRAME_NAMES = {"v1": words("vehicle-1"), "v2": words("vehicle-2"), "B": words("body")}
VECTOR = ImmutableMatrix(symbols("v_N v_E v_D", real=True))
# Its components in the frame before a turn, which are no longer north, east and down.
BEFORE = ImmutableMatrix(symbols("v_x v_y v_z", real=True))
FIELD = ImmutableMatrix(symbols("m_N m_E m_D", real=True))

# Names for the steps of the derivations: one vector in the frames between, the axes of these
# frames, a turn, and the sum of the three turns that make up the body rates.
V_V1, V_V2 = (MatrixSymbol(rf"\mathbf{{v}}_{{{frame}}}", 3, 1) for frame in ("v1", "v2"))
AXES_V1, AXES_V2, AXES_B = (
    tuple(MatrixSymbol(rf"\mathbf{{{axis}}}_{{{frame}}}", 3, 1) for axis in "xyz")
    for frame in ("v1", "v2", "B")
)
ROLL_TURN, PITCH_TURN, YAW_TURN = (
    MatrixSymbol(rf"\boldsymbol{{\omega}}_{{\text{{{turn}}}}}", 3, 1)
    for turn in ("roll", "pitch", "yaw")
)
# The determinants of the axes of three turns, by the middle angle.
DETERMINANT_321, DETERMINANT_313 = (
    Symbol(rf"\det_{{\text{{{order}}}}}\left(\theta\right)", real=True)
    for order in ("3-2-1", "3-1-3")
)
# An angle by which yaw and roll change together.
SHIFT = Symbol("delta", real=True)


def _other_arguments_of_d() -> Set:
    return FiniteSet(*derived.euler_rates_matrix().free_symbols - set(EULER))


def _turns() -> tuple[ImmutableMatrix, ...]:
    """Each Euler rate as a turn about its axis, in the body frame."""
    axes, rates = derived.body_rates_matrix(), derived.euler_rates()
    return tuple(ImmutableMatrix(axes.col(n) * rates[n]) for n in range(3))


_TURNED = {
    name: axis
    for names, turn, angle in ((AXES_V1, 2, psi), (AXES_V2, 1, theta), (AXES_B, 0, phi))
    for name, axis in zip(names, derived.turned_axes(turn, angle), strict=True)
}
_MEANING: dict[Basic, Meaning] = {
    # What points up from the ground, in axes of which the last points down.
    printed.Z_I: (-printed.ALTITUDE * derived.Z)[2],
    printed.PITCH_AXIS: derived.rotation("v1", "I") * derived.Y,
    printed.FIGURE_3_FRAME: FRAME_NAMES[derived.FRAMES[2]],
    # The note speaks of pitching up.
    printed.LOCK_PITCHES: lambda: derived.lock_pitches(Interval(0, pi / 2)),
    printed.ROLL_FOR_YAW: -psi,
    # One vector in four frames: all its components come from the inertial ones.
    printed.V_I: VECTOR,
    V_V1: ImmutableMatrix(derived.rotation("I", "v1") * VECTOR),
    V_V2: ImmutableMatrix(derived.rotation("I", "v2") * VECTOR),
    printed.V_B: ImmutableMatrix(derived.rotation("I", "B") * VECTOR),
    **_TURNED,
    printed.D: derived.euler_rates_matrix,
    printed.OTHER_ARGUMENTS: _other_arguments_of_d,
    **elements(EULER_RATES, derived.euler_rates),
    **dict(zip((ROLL_TURN, PITCH_TURN, YAW_TURN), _turns(), strict=True)),
    # What is measured at rest comes off what is measured.
    claims.ACCELERATION: lambda: VECTOR - specific_force(NOTHING, m * g * derived.Z, m),
    claims.FIELD_I: FIELD,
    claims.FIELD_B: ImmutableMatrix(derived.rotation("I", "B") * FIELD),
    claims.ANY_ROTATION: derived.any_axes,
    claims.LOCK_321: lambda: sequences.locks("ZYX"),
    claims.LOCK_313: lambda: sequences.locks("ZXZ"),
    # The note's order of the rates is roll, pitch, yaw: of the last turn first, as with fixed axes.
    DETERMINANT_321: lambda: sequences.determinant("xyz"),
    DETERMINANT_313: lambda: sequences.determinant("zxz"),
    claims.OTHER_DETERMINANT: sequences.yaw_roll_yaw_upright,
}
READ = reading(
    _MEANING,
    presumed=(
        Presumed(Condition(Eq(theta, pi / 2)), "At a pitch of 90 degrees", "euler.6.c"),
        Presumed(Condition(Ne(cos(psi), 1)), "After some yaw", "euler.4.a"),
        Presumed(Condition(Ne(cos(phi), 1)), "in general", "euler.7.b"),
        Presumed(
            Condition(And(Ne(sin(phi), 0), Ne(cos(phi), 0))), "in general diverge", "euler.7.c"
        ),
    ),
)
