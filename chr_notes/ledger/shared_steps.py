"""Steps that several entries share: Euler integration, and what an accelerometer feels."""

from sympy import Eq, Expr, Integral, MatAdd, MatMul, MatrixExpr, MatrixSymbol, Symbol

from chr_notes.derivations.steps import Step
from chr_notes.symbols import T, m

_TIME = Symbol("t", real=True)
# An accelerometer's proof mass, and the force with which the casing holds it.
PROOF_MASS = Symbol("m_p", positive=True)
HOLDING = MatrixSymbol(r"\mathbf{F}_p", 3, 1)


def held(rate: Expr, before: Expr, after: Expr) -> tuple[Step, ...]:
    """Tell how an angle goes on with its rate held through one period."""
    gain = Integral(rate, (_TIME, 0, T))
    return (
        Step("An angle gains what its rate adds up to in one period.", Eq(after, before + gain)),
        Step("The rate is held until the next sample comes.", Eq(gain, T * rate)),
    )


def felt(reading: MatrixExpr, force: MatrixExpr, weight: MatrixExpr) -> tuple[Step, ...]:
    """Tell what an accelerometer feels of all forces on the body and of its weight."""
    return (
        Step(
            "The proof mass is held in its casing and accelerates as the body does, by F/m. Two "
            "forces do that: its own share of the weight, and the force with which the casing "
            "holds it. Newton's second law for the proof mass:",
            Eq(
                MatMul(PROOF_MASS / m, force),
                MatAdd(HOLDING, MatMul(PROOF_MASS / m, weight)),
            ),
        ),
        Step(
            "What stretches the spring, and so what the sensor feels, is the force that holds the "
            "proof mass. The reading is that force per unit of the proof mass.",
            Eq(reading, MatMul(1 / PROOF_MASS, HOLDING)),
        ),
    )
