"""More of what "Understanding Euler Angles" says in words."""

from sympy import (
    Eq,
    ImmutableMatrix,
    MatMul,
    MatrixSymbol,
    Ne,
    Symbol,
)

from chr_notes.printed.euler import (
    E_Y,
    E_Z,
    R_BI,
    R_IB,
    R_PITCH,
    R_ROLL,
    R_YAW,
    V_I,
)
from chr_notes.printed.statement import InOrder, Printed, as_printed, words

E_X = ImmutableMatrix([1, 0, 0])

# Names for what the words speak of: any rotation at all; the middle angle of three turns at which
# they lock; how far from its lock another sequence is where this one locks; the acceleration.
ANY_ROTATION = MatrixSymbol(r"R_{\text{any}}", 3, 3)
LOCK_321, LOCK_313 = (words(f"middle angle at the lock of {order}") for order in ("3-2-1", "3-1-3"))
OTHER_DETERMINANT = Symbol(r"\det_{\text{3-1-3}}", real=True)
ACCELERATION = MatrixSymbol(r"\mathbf{a}_I", 3, 1)
FIELD_I = MatrixSymbol(r"\mathbf{m}_I", 3, 1)
FIELD_B = MatrixSymbol(r"\mathbf{m}_B", 3, 1)

with as_printed():
    ADDITIONS = (
        Printed(
            "euler.1.a",
            "claim",
            "section 1, paragraph 3",
            "Three rotations about different axes can represent any orientation.",
            Eq(R_IB, ANY_ROTATION),
        ),
        Printed(
            "euler.6.c",
            "claim",
            "section 6, paragraph 2",
            "At a pitch of 90 degrees yaw and roll move the sensor in exactly the same fashion: "
            "both turn it about one axis in one sense, seen from the body.",
            Eq(MatMul(R_IB, E_Z), E_X),
        ),
        Printed(
            "euler.6.d",
            "claim",
            "section 6, paragraph 1",
            "Where the lock lies depends on the order of the rotations.",
            Ne(LOCK_321, LOCK_313),
        ),
        Printed(
            "euler.6.e",
            "claim",
            "section 6, paragraph 3",
            "An estimator that uses Euler angles always fails near a pitch of 90 degrees, and only "
            "another representation cures it: no other sequence of three angles would.",
            Eq(OTHER_DETERMINANT, 0),
        ),
        Printed(
            "euler.7.e",
            "claim",
            "section 7, paragraph 5",
            "Yaw turns about z of the inertial frame, pitch about y of vehicle-1, roll about x of "
            "vehicle-2: each turn leaves its axis where it is.",
            InOrder(
                Eq(MatMul(R_YAW, E_Z), E_Z),
                Eq(MatMul(R_PITCH, E_Y), E_Y),
                Eq(MatMul(R_ROLL, E_X), E_X),
            ),
        ),
        Printed(
            "euler.7.f",
            "claim",
            "section 7, paragraph 3",
            "The vector taken to the inertial frame is the measured acceleration, not the actual "
            "one.",
            Ne(V_I, ACCELERATION),
        ),
        Printed(
            "euler.7.g",
            "claim",
            "section 7, paragraph 4",
            "Magnetometer data can be taken to the inertial frame in the same fashion.",
            Eq(FIELD_I, MatMul(R_BI, FIELD_B)),
        ),
    )
