"""Why half the angle, for any axis and any vector, and how a quaternion changes with time."""

from types import MappingProxyType

from sympy import ImmutableMatrix, MatMul, MatrixSymbol, cos, eye, sin, sqrt, symbols

from chr_notes.derivations import quaternions as derived
from chr_notes.derivations.hamilton import conjugate, multiply, pure
from chr_notes.derivations.steps import Step, equation
from chr_notes.derivations.telling import Told
from chr_notes.symbols import BODY_RATES, VECTOR, AngularRate, T, a, alpha, b, c, d, p, q, r

# Quaternions s + t n and s - t n; any unit axis, by two angles; any vector.
s, t = symbols("s t", real=True)
_AROUND, _DOWN = symbols("eta tau", real=True)
AXIS = ImmutableMatrix([sin(_DOWN) * cos(_AROUND), sin(_DOWN) * sin(_AROUND), cos(_DOWN)])
ANY = ImmutableMatrix(VECTOR)


def _column(latex: str) -> MatrixSymbol:
    return MatrixSymbol(latex, 4, 1)


V = _column(r"\mathbf{v}")
NV, VN = _column(r"\mathbf{n}\,\mathbf{v}"), _column(r"\mathbf{v}\,\mathbf{n}")
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
            "Now let q be s + t n, a part along 1 and a part along the axis. From the left it "
            "makes of a vector a vector and a scalar: the leak.",
            equation(LEFT, s * V + MatMul(t, CROSS - DOT)),
        ),
        Step(
            "From the right comes s − t n. The scalar cancels; what is across the axis turns on, "
            "and what is along it comes back.",
            equation(BOTH, (s**2 - t**2) * V + 2 * s * t * CROSS + 2 * t**2 * ALONG),
        ),
        Step(
            "Geometry says what a turn by α must do: leave the part along the axis, and take the "
            "rest round a circle.",
            equation(TURNED, cos(alpha) * V + sin(alpha) * CROSS + (1 - cos(alpha)) * ALONG),
        ),
        Step(
            "The two agree for every vector if the three numbers in front do. They are one "
            "condition, not three:",
            equation(
                ImmutableMatrix([s**2 - t**2, 2 * s * t, 2 * t**2]),
                ImmutableMatrix([cos(alpha), sin(alpha), 1 - cos(alpha)]),
            ),
        ),
        Step(
            "These are the formulas of the double angle. Of the two solutions one is the other's "
            "negative.",
            equation(ImmutableMatrix([s, t]), ImmutableMatrix([cos(alpha / 2), sin(alpha / 2)])),
        ),
    ),
    MappingProxyType(
        {
            V: pure(ANY),
            NV: multiply(pure(AXIS), pure(ANY)),
            VN: multiply(pure(ANY), pure(AXIS)),
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

_BODY = ImmutableMatrix(BODY_RATES)
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
            "In a short time T the gyros' rates stay as they are. The body turns about their axis "
            "by their size times T, which as a quaternion has half of that angle.",
            equation(
                SMALL,
                ImmutableMatrix(
                    [cos(SIZE * T / 2), *(sin(SIZE * T / 2) * each / SIZE for each in BODY_RATES)]
                ),
            ),
        ),
        Step(
            "The turn is about an axis of the body as it is by now, and later turns stand to the "
            "right.",
            equation(AFTER, THEN),
        ),
        Step(
            "Only the small turn changes with T. It begins at one, where a cosine has no slope "
            "and a sine has the slope one. The size drops out. What it changes by, twice, are the "
            "rates: half the angle again.",
            equation(2 * SLOPE, OMEGA),
        ),
        Step(
            "So the quaternion changes by half of itself times the rates.",
            equation(2 * RATE, Q_OMEGA),
        ),
        Step(
            "Multiplied out by the table of the units:",
            equation(
                RATE,
                ImmutableMatrix(
                    [
                        -(b * p + c * q + d * r) / 2,
                        (a * p + c * r - d * q) / 2,
                        (a * q - b * r + d * p) / 2,
                        (a * r + b * q - c * p) / 2,
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
            AFTER: derived.constant_rate_step(),
            THEN: multiply(derived.ATTITUDE, _TURN),
            SLOPE: ImmutableMatrix(_TURN.diff(T).subs(T, 0)),
            RATE: derived.rates(),
            Q_OMEGA: multiply(derived.ATTITUDE, pure(_BODY)),
        }
    ),
)
"""How a quaternion changes while the body turns."""
