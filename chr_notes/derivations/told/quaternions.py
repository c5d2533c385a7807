"""Why half the angle, for any axis and any vector, and how a quaternion changes with time."""

from types import MappingProxyType

from sympy import ImmutableMatrix, MatMul, MatrixSymbol, Rational, cos, eye, sin, sqrt, symbols

from chr_notes.derivations import quaternions as derived
from chr_notes.derivations.hamilton import conjugate, multiply, pure
from chr_notes.derivations.steps import Step, equation
from chr_notes.derivations.told import Told
from chr_notes.symbols import BODY_RATES, VECTOR, AngularRate, T, a, alpha, b, c, d

# Quaternions s + t n and s - t n; any unit axis, by two angles; any vector.
s, t = symbols("s t", real=True)
_AROUND, _DOWN = symbols("eta tau", real=True)
AXIS = ImmutableMatrix([sin(_DOWN) * cos(_AROUND), sin(_DOWN) * sin(_AROUND), cos(_DOWN)])
ANY = ImmutableMatrix(VECTOR)


def _column(latex: str) -> MatrixSymbol:
    return MatrixSymbol(latex, 4, 1)


V = _column(r"\mathbf{v}")
NV, VN = _column(r"\mathbf{n}\,\mathbf{v}"), _column(r"\mathbf{v}\,\mathbf{n}")
NVN = _column(r"\mathbf{n}\,\mathbf{v}\,\mathbf{n}")
CROSS, DOT = (
    _column(r"\left(\mathbf{n}\times\mathbf{v}\right)"),
    _column(r"\mathbf{n}\cdot\mathbf{v}"),
)
ALONG = _column(r"\left(\mathbf{n}\cdot\mathbf{v}\right)\mathbf{n}")
LEFT, BOTH = _column(r"q\,\mathbf{v}"), _column(r"q\,\mathbf{v}\,q^{*}")
TURNED = _column(r"\mathbf{v}_{\text{turned}}")

_QUATERNION = ImmutableMatrix([s, *(t * AXIS)])
_FROM_LEFT = multiply(_QUATERNION, pure(ANY))

HALF_ANGLE = Told(
    (
        Step(
            "Write an axis of length one and any vector as quaternions without a scalar part, and "
            "multiply them by the table of the units. Nine products: equal units give minus the "
            "scalar product, unequal ones the vector product.",
            equation(NV, CROSS - DOT),
        ),
        Step(
            "In the other order the units change places, so the vector product changes its sign.",
            equation(VN, -CROSS - DOT),
        ),
        Step(
            "Now let q be s + t n. From the left it makes of a vector a vector and a scalar: the "
            "leak.",
            equation(LEFT, s * V + MatMul(t, CROSS - DOT)),
        ),
        Step(
            "From the right comes s − t n. Each part of the one meets each part of the other.",
            equation(BOTH, s**2 * V + MatMul(s * t, NV - VN) - t**2 * NVN),
        ),
        Step(
            "By the first two steps the bracket is twice the vector product. For n v n multiply "
            "the first step by n from the right: n × v is at right angles to n, so it gives no "
            "scalar, and (n × v) × n, which is v − (n·v) n; the scalar gives − (n·v) n.",
            equation(NVN, V - 2 * ALONG),
        ),
        Step(
            "Put both in, and sort.",
            equation(BOTH, (s**2 - t**2) * V + 2 * s * t * CROSS + 2 * t**2 * ALONG),
        ),
        Step(
            "Now what a turn by α does, whatever computes it. The part along the axis, (n·v) n, "
            "stays. The rest goes round a circle, of which that rest and n × v are two radii at "
            "right angles.",
            equation(TURNED, ALONG + MatMul(cos(alpha), V - ALONG) + sin(alpha) * CROSS),
        ),
        Step(
            "The two agree for every vector if the numbers before v, n × v and (n·v) n do. The "
            "third agrees with the first, since s² + t² = 1.",
            equation(
                ImmutableMatrix([s**2 - t**2, 2 * s * t, 2 * t**2]),
                ImmutableMatrix([cos(alpha), sin(alpha), 1 - cos(alpha)]),
            ),
        ),
        Step(
            "These are the formulas of the double angle. The other solution is the negative of "
            "this one.",
            equation(ImmutableMatrix([s, t]), ImmutableMatrix([cos(alpha / 2), sin(alpha / 2)])),
        ),
    ),
    MappingProxyType(
        {
            V: pure(ANY),
            NV: multiply(pure(AXIS), pure(ANY)),
            VN: multiply(pure(ANY), pure(AXIS)),
            NVN: multiply(multiply(pure(AXIS), pure(ANY)), pure(AXIS)),
            CROSS: pure(AXIS.cross(ANY)),
            DOT: ImmutableMatrix([AXIS.dot(ANY), 0, 0, 0]),
            ALONG: pure(AXIS.dot(ANY) * AXIS),
            LEFT: _FROM_LEFT,
            BOTH: multiply(_FROM_LEFT, conjugate(_QUATERNION)),
            TURNED: pure(derived.turned(AXIS, alpha, ANY)),
            s: derived.from_axis_angle(AXIS, alpha)[0],
            t: derived.from_axis_angle(ImmutableMatrix(eye(3).col(0)), alpha)[1],
        }
    ),
)
"""`q v q*` for any unit axis and any vector, and what it has to be."""

# What the gyros read, here without the letter q that the quaternion has.
_BODY = ImmutableMatrix(symbols(r"\omega_x \omega_y \omega_z", real=True))
_NAMED = dict(zip(BODY_RATES, _BODY, strict=True))
x, y, z = _BODY
_SPEED = sqrt(_BODY.dot(_BODY))
_TURN = derived.from_axis_angle(ImmutableMatrix(_BODY / _SPEED), _SPEED * T)
SIZE = AngularRate(r"\left|\boldsymbol{\omega}\right|", positive=True)
OMEGA = _column(r"\boldsymbol{\omega}")
SMALL = _column(r"q_{\text{turn}}")
AFTER, THEN = _column("q(t + T)"), _column(r"q(t)\,q_{\text{turn}}")
SLOPE = _column(r"\left.\frac{\mathrm{d}q_{\text{turn}}}{\mathrm{d}T}\right|_{T=0}")
RATE, Q_OMEGA = _column(r"\dot{q}"), _column(r"q\,\boldsymbol{\omega}")

RATES = Told(
    (
        Step(
            "In a short time T the rates stay as they are. The body turns about their axis by "
            "their size times T; as a quaternion that turn has half of the angle.",
            equation(
                SMALL,
                ImmutableMatrix(
                    [cos(SIZE * T / 2), *(sin(SIZE * T / 2) * each / SIZE for each in _BODY)]
                ),
            ),
        ),
        Step(
            "The axis is one of the body as it is by now. So the turn stands to the right.",
            equation(AFTER, THEN),
        ),
        Step(
            "Of this product only the small turn changes with T. At T = 0 a cosine has no slope. "
            "The sine of |ω| T/2 has the slope |ω|/2, and |ω| cancels: no division is left.",
            equation(SLOPE, MatMul(Rational(1, 2), OMEGA)),
        ),
        Step(
            "So the quaternion changes by half of itself times the rates.",
            equation(RATE, MatMul(Rational(1, 2), Q_OMEGA)),
        ),
        Step(
            "Multiplied out by the table of the units:",
            equation(
                RATE,
                ImmutableMatrix(
                    [
                        -(b * x + c * y + d * z) / 2,
                        (a * x + c * z - d * y) / 2,
                        (a * y - b * z + d * x) / 2,
                        (a * z + b * y - c * x) / 2,
                    ]
                ),
            ),
        ),
    ),
    MappingProxyType(
        {
            SIZE: _SPEED,
            OMEGA: pure(_BODY),
            SMALL: _TURN,
            AFTER: derived.constant_rate_step().xreplace(_NAMED),
            THEN: multiply(derived.ATTITUDE, _TURN),
            SLOPE: ImmutableMatrix(_TURN.diff(T).subs(T, 0)),
            RATE: derived.rates().xreplace(_NAMED),
            Q_OMEGA: multiply(derived.ATTITUDE, pure(_BODY)),
        }
    ),
)
"""How a quaternion changes while the body turns."""
