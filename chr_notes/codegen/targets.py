"""The table of generated functions: which derived formula becomes which function.

No formula stands here: each target names the derivation that it comes from.
"""

from collections.abc import Callable
from dataclasses import dataclass

from sympy import Expr, ImmutableMatrix, Symbol

from chr_notes.derivations import euler
from chr_notes.symbols import p, phi, pitch_rate, psi, q, r, roll_rate, theta, yaw_rate


@dataclass(frozen=True)
class Argument:
    """One scalar argument of a generated function.

    Parameters
    ----------
    name
        Its name in the generated code.
    symbol
        The symbol that it stands for in the derivation.
    says
        Meaning and unit.
    """

    name: str
    symbol: Symbol
    says: str


@dataclass(frozen=True)
class Target:
    """One generated function.

    Parameters
    ----------
    name
        Its name, `target_from_source`.
    topic
        The stem of the file that it stands in.
    says
        What it returns.
    arguments
        Its scalar arguments in order.
    formula
        Gives the derived formula: a scalar, or a matrix returned row by row.
    entries
        Ids of the ledger entries that state it.
    """

    name: str
    topic: str
    says: str
    arguments: tuple[Argument, ...]
    formula: Callable[[], Expr | ImmutableMatrix]
    entries: tuple[str, ...]


ROLL = Argument("roll", phi, "roll about the body x-axis, radians")
PITCH = Argument("pitch", theta, "pitch about the vehicle-1 y-axis, radians")
YAW = Argument("yaw", psi, "yaw about the inertial z-axis, radians")
P = Argument("p", p, "body rate about x, rad/s")
Q = Argument("q", q, "body rate about y, rad/s")
R = Argument("r", r, "body rate about z, rad/s")
ROLL_RATE = Argument("roll_rate", roll_rate, "derivative of roll, rad/s")
PITCH_RATE = Argument("pitch_rate", pitch_rate, "derivative of pitch, rad/s")
YAW_RATE = Argument("yaw_rate", yaw_rate, "derivative of yaw, rad/s")

TARGETS = (
    Target(
        "matrix_from_euler",
        "euler",
        "Matrix from the inertial to the body frame, row by row",
        (ROLL, PITCH, YAW),
        lambda: euler.rotation("I", "B"),
        ("euler.5.2", "euler.5.3"),
    ),
    Target(
        "euler_rates_matrix",
        "euler",
        "Matrix D from body rates to Euler rates, row by row",
        (ROLL, PITCH),
        euler.euler_rates_matrix,
        ("euler.7.2", "euler.7.d"),
    ),
    Target(
        "euler_rates_from_body_rates",
        "euler",
        "Derivatives of roll, pitch and yaw, rad/s",
        (ROLL, PITCH, P, Q, R),
        euler.euler_rates,
        ("euler.7.3",),
    ),
    Target(
        "body_rates_from_euler_rates",
        "euler",
        "Body rates about x, y and z, rad/s",
        (ROLL, PITCH, ROLL_RATE, PITCH_RATE, YAW_RATE),
        euler.body_rates,
        ("euler.7.a",),
    ),
    Target(
        "euler_rates_determinant",
        "euler",
        "Determinant of the matrix D",
        (PITCH,),
        euler.euler_rates_determinant,
        ("euler.7.c",),
    ),
    Target(
        "euler_rates_condition",
        "euler",
        "Condition number of the matrix D in the 2-norm",
        (PITCH,),
        euler.euler_rates_condition,
        ("euler.7.c",),
    ),
)
