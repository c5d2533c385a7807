"""What the sensors measure, from the laws that govern them."""

from sympy import Expr, ImmutableMatrix, Symbol, cancel, solve, symbols


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
    proof_mass = Symbol("m_p", positive=True)
    holding = ImmutableMatrix(symbols("f_x f_y f_z"))
    # mass times acceleration, less the forces that act
    newton = proof_mass * force / mass - (holding + proof_mass * weight / mass)
    held = solve(list(newton), list(holding))
    return ImmutableMatrix([cancel(held[component] / proof_mass) for component in holding])
