"""More of what "Fundamentals of Attitude Estimation" says in words."""

from sympy import Eq, FiniteSet, IndexedBase, Limit, MatrixSymbol, Ne, oo

from chr_notes.printed.estimation import n
from chr_notes.printed.euler import ROTATED_ONE_BY_ONE
from chr_notes.printed.statement import Printed, as_printed, words
from chr_notes.symbols import Angle, p, phi, q, r, theta

# Names for what the words speak of: what a gyro reads while the body accelerates and while it does
# not; what the rates of roll and pitch depend on; the mean of many estimates after n steps, and
# that of the accelerometer's angle; an aircraft's roll in a level turn, and what its accelerometer
# makes of it after n samples.
READING_ACCELERATED, READING = (
    MatrixSymbol(rf"\mathbf{{p}}_m\left({at}\right)", 3, 1) for at in (r"\mathbf{a}", "0")
)
ARGUMENTS = words("arguments of the rates of roll and pitch")
MEAN = IndexedBase(r"\overline{\hat{\theta}}")[n]
AVERAGE_ANGLE = Angle(r"\overline{\hat{\theta}}_{accel}", real=True)
BANK = Angle(r"\phi_{\text{level turn}}", real=True)
BANK_ACCEL = IndexedBase(r"\hat{\phi}_{accel,\,\text{level turn}}")[n]

with as_printed():
    ADDITIONS = (
        Printed(
            "estimation.3.b",
            "claim",
            "section 3, paragraph 1",
            "Rate gyros are nominally not affected by acceleration.",
            Eq(READING_ACCELERATED, READING),
        ),
        Printed(
            "estimation.3.c",
            "claim",
            "section 3, paragraph 2",
            "How the Euler rates come about: the gyros' outputs are rotated into the frames in "
            "which roll, pitch and yaw occur.",
            ROTATED_ONE_BY_ONE,
        ),
        Printed(
            "estimation.3.d",
            "claim",
            "section 3, paragraph 4",
            "The line for yaw can be left out where only roll and pitch are estimated.",
            Eq(ARGUMENTS, FiniteSet(phi, theta, p, q, r)),
        ),
        Printed(
            "estimation.4.f",
            "claim",
            "section 4, paragraph 8",
            "The accelerometers pull the estimate towards their average angle.",
            Eq(Limit(MEAN, n, oo), AVERAGE_ANGLE),
        ),
        Printed(
            "estimation.5.a",
            "claim",
            "section 5, paragraph 1",
            "In an aircraft accelerometers can give a wrong angle for arbitrarily long.",
            Ne(Limit(BANK_ACCEL, n, oo), BANK),
        ),
    )
