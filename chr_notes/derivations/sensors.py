"""What the sensors measure, from the laws that govern them."""

from functools import cache

from sympy import Expr, I, ImmutableMatrix, Symbol, cancel, exp, solve, symbols

from chr_notes.derivations import hamilton, quaternions
from chr_notes.symbols import QUATERNION, VECTOR

# Angular frequency of a vibration of the casing, and the natural one of proof mass and spring.
frequency = Symbol("omega", nonnegative=True)
natural_frequency = Symbol("omega_0", positive=True)


def specific_force(force: ImmutableMatrix, weight: ImmutableMatrix, mass: Expr) -> ImmutableMatrix:
    """Solve Newton's second law for what holds an accelerometer's proof mass: its reading.

    The proof mass is held in its casing, so it accelerates as the body does. Two forces act on
    it: its own weight, and the force with which the casing holds it. The second one is what the
    accelerometer senses; per unit of the proof mass it is what it reads.

    Parameters
    ----------
    force
        All forces on the body, gravity included, 3 by 1 in any frame, N.
    weight
        The force of gravity on the body, in the same frame, N.
    mass
        Mass of the body, kg.

    Returns
    -------
    ImmutableMatrix
        3 by 1 in that frame, m/s².
    """
    component, along = _held()
    return ImmutableMatrix(
        [
            cancel(component.subs(dict(zip(along, (*parts, mass), strict=True)), simultaneous=True))
            for parts in zip(force, weight, strict=True)
        ]
    )


@cache
def _held() -> tuple[Expr, tuple[Symbol, ...]]:
    """Solve for the holding force along one axis, per unit of the proof mass."""
    force, weight, holding = symbols("F F_g f")
    mass, proof_mass = symbols("m m_p", positive=True)
    # mass times acceleration, less the forces that act
    newton = proof_mass * force / mass - (holding + proof_mass * weight / mass)
    return cancel(solve(newton, holding)[0] / proof_mass), (force, weight, mass)


def deflection_held() -> Expr:
    """Find the deflection per unit of an acceleration that stays: the spring balances it."""
    deflected = Symbol("x", real=True)
    return solve(natural_frequency**2 * deflected - 1, deflected)[0]


def deflection() -> Expr:
    """Find the deflection of the proof mass per unit of acceleration of its vibrating casing.

    Seen from the casing, the spring pulls the proof mass back and the casing's acceleration pushes
    it the other way. Without friction the deflection vibrates along.
    """
    t, amplitude = symbols("t x", real=True)
    vibration = exp(I * frequency * t)
    moving = amplitude * vibration
    newton = moving.diff(t, 2) + natural_frequency**2 * moving + vibration
    return -cancel(solve(cancel(newton / vibration), amplitude)[0])


@cache
def vector_rate() -> ImmutableMatrix:
    """Differentiate the body components of a vector that is at rest in the inertial frame.

    They are `v = q* u q` with u constant; what changes is q, by its rates. A unit quaternion's
    squared norm is 1.
    """
    fixed = dict(zip(VECTOR, quaternions.rotate_to_inertial(), strict=True))
    elements = zip(QUATERNION, quaternions.rates(), strict=True)
    seen = quaternions.rotate_to_body()
    change = sum((seen.diff(element) * rate for element, rate in elements), 0 * seen)
    norm = hamilton.norm_squared(quaternions.ATTITUDE)
    return ImmutableMatrix(
        [cancel(part / norm**2) for part in change.subs(fixed, simultaneous=True)]
    )
