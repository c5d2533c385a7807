"""The table of generated functions, attitudes as any three turns about axes.

No formula stands here: each target names the derivation that it comes from.
"""

from collections.abc import Iterator
from dataclasses import replace
from functools import partial

from sympy import Integer

from chr_notes.codegen import array_arguments as array
from chr_notes.codegen.arguments import axes
from chr_notes.codegen.target import Target
from chr_notes.derivations.forms import sequences as forms

_WHICH = ("first", "second", "third")
ANGLES = axes("{}", forms.ANGLES, "angle of the {} turn, radians", _WHICH)
AXES = axes(
    "{}_axis", forms.AXES, "axis of the {} turn, as turned so far: 1, 2, 3 for x, y, z", _WHICH
)
_BOTH = (("angles", ANGLES), ("axes", AXES))

SEQUENCES = partial(Target, "sequences")

TARGETS = (
    SEQUENCES(
        "matrix_from_angles",
        "Matrix to the turned frame, row by row",
        forms.matrix_from_angles,
        arrays=_BOTH,
    ),
    SEQUENCES(
        "angles_from_matrix",
        "Angles of the three turns, radians",
        forms.angles_from_matrix,
        arrays=(array.MATRIX, ("axes", AXES)),
    ),
    SEQUENCES(
        "quaternion_from_angles",
        "Unit quaternion with a >= 0",
        forms.quaternion_from_angles,
        arrays=_BOTH,
    ),
    SEQUENCES(
        "angles_from_quaternion",
        "Angles of the three turns, radians",
        forms.angles_from_quaternion,
        arrays=(array.Q, ("axes", AXES)),
    ),
    SEQUENCES(
        "angle_rates_matrix",
        "Matrix D from rates about the turned frame's axes to rates of the angles, row by row",
        forms.angle_rates_matrix,
        arrays=_BOTH,
        arguments=(*ANGLES[1:], *AXES),
    ),
)


def of_usual_axes(target: Target) -> Iterator[Target]:
    """Make the functions for turns about z, y, x and about z, y, z.

    All other turns are one of these in a frame whose axes are named otherwise.
    """
    for letters in ("zyx", "zyz"):
        numbers = (Integer(1 + "xyz".index(letter)) for letter in letters)
        values = dict(zip(forms.AXES, numbers, strict=True))
        yield replace(
            target,
            name=f"{target.name}_{letters}",
            formula=partial(target.computation().at, values),
            arrays=target.arrays[:1],
            arguments=(),
        )
