"""Changes that look like misprints and are none, each with the reason.

The test proves each one: what the print says with it is still what the ledger says of it.
"""

from sympy import Add, Eq, pi

from chr_notes.ledger.cases import CASES
from chr_notes.symbols import Angle

NOTHING = "minus nothing, and twice nothing, is nothing"
VERTICAL = "a turn about the vertical, by yaw, leaves gravity as it is"
RENAMED = "the elements of any quaternion are called otherwise, on both sides"

ANGLES_RENAMED = "the angles are called otherwise, on both sides"
AXIS_STAYS = "the axis of a turn stays where it is on the way back as well"
ANY_ANGLE = "the axis stays whatever the angle is called"
BOTH_WAYS = "what differs, or is the same, is so both ways"

EQUIVALENT: dict[tuple[str, str], str] = {
    **{("quaternions.3.a", f"swapped symbols, throughout {n}"): RENAMED for n in range(1, 7)},
    ("quaternions.3.d", "factors in reverse order 1"): "the turn back leaves no real part either",
    **{
        ("quaternions.4.b", f"swapped symbols, in one place {n}"): "at the lock a² = c² and b² = d²"
        for n in (14, 17, 34, 38)
    },
    **{
        ("quaternions.4.b", kind): "a multiple of nothing is nothing"
        for kind in ("lost factor 1", "lost factor 9", "digit 1", "digit 6")
    },
    **{
        ("quaternions.4.b", f"swapped symbols, throughout {n}"): "roll and yaw change places"
        for n in (2, 5)
    },
    ("quaternions.4.c", "swapped symbols, throughout 1"): BOTH_WAYS,
    **{("euler.3.a", kind): AXIS_STAYS for kind in ("transposed 1", "wrong frame 1")},
    ("euler.4.2", "swapped symbols, throughout 1"): ANGLES_RENAMED,
    **{
        (f"euler.5.{entry}", f"swapped symbols, throughout {n}"): ANGLES_RENAMED
        for entry in "234a"
        for n in range(1, 4)
    },
    ("euler.5.a", "factors in reverse order 1"): "there after back is the same as back after there",
    ("euler.6.b", "swapped symbols, throughout 1"): "each is the negative of the other",
    ("euler.6.c", "swapped symbols, throughout 1"): "at the lock the column has neither angle",
    ("euler.6.d", "swapped symbols, throughout 1"): BOTH_WAYS,
    **{("euler.7.e", f"transposed {n}"): AXIS_STAYS for n in range(1, 4)},
    **{("euler.7.e", f"wrong frame {n}"): AXIS_STAYS for n in (1, 6, 11)},
    **{("euler.7.e", f"swapped symbols, throughout {n}"): ANY_ANGLE for n in range(1, 4)},
    ("euler.7.b", "transposed 1"): "a matrix is the identity when its transpose is",
    **{(f"sensors.2.{n}", "transposed 1"): "a diagonal matrix is its own transpose" for n in "45"},
    **{("sensors.2.b", kind): "nothing is left" for kind in ("sign 1", "added term 1")},
    ("sensors.2.d", "swapped symbols, throughout 1"): "the same is said of both angles",
    **{
        (f"sensors.{entry}", f"swapped symbols, throughout {n}"): BOTH_WAYS
        for entry, n in (("4.a", 1), ("4.b", 3), ("4.c", 1))
    },
    **{("sensors.4.f", f"swapped symbols, throughout {n}"): BOTH_WAYS for n in (1, 6, 7)},
    **{
        ("sensors.4.f", f"transposed {n}"): "a diagonal matrix is its own transpose" for n in (1, 2)
    },
    ("sensors.2.j", "swapped symbols, throughout 1"): BOTH_WAYS,
    **{
        (f"sensors.4.{entry}", f"swapped symbols, throughout {n}"): "solved for the other vector"
        for entry, n in (("3", 5), ("e", 2))
    },
    ("sensors.4.g", "swapped symbols, throughout 3"): "a vector is as long as the opposite one",
    ("sensors.4.h", "transposed 1"): "the product of a matrix's transpose and itself is symmetric",
    ("sensors.2.g", "swapped symbols, throughout 1"): "the order of a sum does not matter",
    ("euler.7.f", "swapped symbols, throughout 1"): BOTH_WAYS,
    ("estimation.2.3", "wrong frame 2"): VERTICAL,
    ("estimation.2.a", "sign 1"): NOTHING,
    ("estimation.2.a", "added term 1"): NOTHING,
    **{(f"estimation.{n}", "swapped symbols, throughout 1"): BOTH_WAYS for n in ("3.b", "4.d")},
    ("estimation.5.a", "swapped symbols, in one place 3"): "the reading stays, whatever goes on",
    ("estimation.5.a", "swapped symbols, in one place 4"): "the angle that is read is zero",
    ("dead_reckoning.4.i", "swapped symbols, throughout 1"): "the other of the two is said first",
    ("validation.b", "swapped symbols, throughout 1"): BOTH_WAYS,
    ("dead_reckoning.2.1", "wrong frame 2"): VERTICAL,
    ("dead_reckoning.2.2", "wrong frame 2"): VERTICAL,
    ("dead_reckoning.3.1", "swapped symbols, throughout 1"): BOTH_WAYS,
    ("dead_reckoning.3.2", "swapped symbols, throughout 1"): BOTH_WAYS,
    ("validation.e", "sign 3"): NOTHING,
    ("validation.f", "swapped symbols, throughout 1"): BOTH_WAYS,
    **{
        ("validation.i", f"swapped symbols, in one place {n}"): "alpha is the accelerometer's share"
        for n in (9, 12)
    },
    **{
        ("validation.16", f"swapped symbols, in one place {n}"): "the paper calls yaw by both names"
        for n in range(1, 4)
    },
    **{("validation.l", f"transposed {n}"): AXIS_STAYS for n in range(1, 4)},
    ("validation.k", "swapped symbols, throughout 1"): BOTH_WAYS,
}

# A whole turn more on the right side of an equation for an angle is the same angle: roll, pitch and
# yaw are read up to whole turns (`same_angle`), so that no such change is a misprint; half a turn
# more is one. Of any other quantity 2 pi more is another number.
ANGLES = [
    name
    for name, case in CASES.items()
    if isinstance(case.printed.statement, Eq) and isinstance(case.printed.statement.lhs, Angle)
]


def turned_further(name: str, half_turns: int) -> Eq:
    """Print an angle so many half turns further."""
    statement = CASES[name].printed.statement
    more = Add(statement.rhs, half_turns * pi, evaluate=False)
    return statement.func(statement.lhs, more, evaluate=False)
