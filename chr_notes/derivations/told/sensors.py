"""What readings of a magnetometer near iron lie on, and what a fit of it can tell."""

from types import MappingProxyType

from sympy import ImmutableMatrix, Inverse, MatMul, MatrixSymbol, Symbol, Transpose, sqrt, symbols

from chr_notes.derivations import calibration as derived
from chr_notes.derivations.euler import rotation
from chr_notes.derivations.steps import Step, equation
from chr_notes.derivations.told import Told

READING, CENTRE = (MatrixSymbol(rf"\mathbf{{{name}}}", 3, 1) for name in "bc")
HARD, FIELD = (MatrixSymbol(name, 3, 1) for name in (r"\beta_h", r"\mathbf{b}_c"))
INSIDE = MatrixSymbol(r"\mathbf{u}", 3, 1)
SOFT, TURN, ROOT = (MatrixSymbol(name, 3, 3) for name in ("D_s", "R", "A"))
MISFIT = Symbol(r"\text{misfit}")
_PARTS = symbols("u_1:4", real=True)
_xx, _xy, _xz, _yy, _yz, _zz = derived.TO_SPHERE
_SYMMETRIC = ImmutableMatrix([[_xx, _xy, _xz], [_xy, _yy, _yz], [_xz, _yz, _zz]])
_INSIDE = _SYMMETRIC * (derived.INPUT - ImmutableMatrix(derived.CENTRE))

ELLIPSOID = Told(
    (
        Step(
            "In the correction the matrix acts on the reading alone. Take it in front of both "
            "terms, which asks for its inverse in the second.",
            equation(FIELD, MatMul(SOFT, READING - MatMul(Inverse(SOFT), HARD))),
        ),
        Step(
            "What is taken off the reading now is the centre of the cloud, where the corrected "
            "field is zero. It is not the hard-iron term itself, unless there is no soft iron.",
            equation(CENTRE, MatMul(Inverse(SOFT), HARD)),
        ),
        Step(
            "With it the correction is a shift first, and a matrix then.",
            equation(FIELD, MatMul(SOFT, READING - CENTRE)),
        ),
        Step(
            "The field has the same length at each attitude. Its square is a form of second degree "
            "in the reading, constant on an ellipsoid about the centre.",
            equation(
                MatMul(Transpose(FIELD), FIELD),
                MatMul(Transpose(READING - CENTRE), Transpose(SOFT), SOFT, READING - CENTRE),
            ),
        ),
        Step(
            "Only this product of the matrix with itself stands in it. A rotation R in front drops "
            "out: no cloud of points can tell by how much the corrected axes are turned.",
            equation(
                MatMul(Transpose(MatMul(TURN, SOFT)), MatMul(TURN, SOFT)),
                MatMul(Transpose(SOFT), SOFT),
            ),
        ),
    ),
    MappingProxyType(
        {
            READING: derived.INPUT,
            CENTRE: derived.readings_centre().subs(
                dict(zip(derived.REALIGNMENT, derived.SOFT_IRON.inv(), strict=True))
            ),
            FIELD: derived.without_iron(),
            SOFT: derived.SOFT_IRON,
            HARD: ImmutableMatrix(derived.HARD_IRON),
            TURN: rotation("I", "B"),
        }
    ),
)
"""What the readings lie on."""

FIT = Told(
    (
        Step(
            "Look for a symmetric matrix A and a centre c that bring each reading to the sphere of "
            "radius one.",
            equation(INSIDE, MatMul(ROOT, READING - CENTRE)),
        ),
        Step(
            "What a reading is off by is its length less one. Six numbers of the matrix and three "
            "of the centre are changed until the sum of the squares is least.",
            equation(MISFIT, sqrt(sum(part**2 for part in _PARTS)) - 1),
        ),
    ),
    MappingProxyType(
        {
            READING: derived.INPUT,
            CENTRE: ImmutableMatrix(derived.CENTRE),
            ROOT: _SYMMETRIC,
            INSIDE: ImmutableMatrix(_PARTS),
            **dict(zip(_PARTS, _INSIDE, strict=True)),
            MISFIT: derived.norm_misfit()[0],
        }
    ),
)
"""How the ellipsoid is found."""
