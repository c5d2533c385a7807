"""What is lowered computes what was derived."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sympy import Add, Expr, ImmutableMatrix, Integer, Mul, Symbol, expand, symbols

from chr_notes.codegen.lowering import Program, lower
from chr_notes.codegen.rewriting import by_library
from chr_notes.codegen.target import Argument, Target
from chr_notes.derivations.computation import Computation, Let

SYMBOLS = symbols("a b c d", real=True)
FOREIGN, LOCAL = symbols("e local", real=True)
ARGUMENTS = tuple(Argument(symbol.name, symbol, "a number") for symbol in SYMBOLS)


def lowered(*results: Expr) -> Program:
    """Lower a few formulas of the four numbers."""
    matrix = ImmutableMatrix(results)
    return lower(
        Target("topic", "several", "what", lambda: matrix, arguments=ARGUMENTS), by_library
    )


def put_together(program: Program) -> list[Expr]:
    """Put the steps into the results again; a step that needs a later one is an error."""
    known: dict[Symbol, Expr] = {symbol: symbol for symbol in SYMBOLS}
    for step in program.steps:
        assert isinstance(step, Let)
        assert step.value.free_symbols <= known.keys()
        known[step.name] = step.value.xreplace(known)
    return [expand(result.xreplace(known)) for result in program.results]


# Sums of a few products, with the signs and factors of rotation formulas.
numbers = st.sampled_from((-2, -1, 1, 2))
letters = st.sampled_from(SYMBOLS)
letters_or_one = st.sampled_from((Integer(1), *SYMBOLS))
products = st.tuples(numbers, letters, letters_or_one).map(lambda factors: Mul(*factors))
sums = st.lists(products, min_size=1, max_size=3).map(lambda terms: Add(*terms))
polynomials = st.tuples(sums, letters_or_one).map(lambda factors: Mul(*factors))


@given(st.lists(polynomials, min_size=2, max_size=5))
def test_the_steps_give_the_formulas(formulas: list[Expr]) -> None:
    assert put_together(lowered(*formulas)) == [expand(formula) for formula in formulas]


@pytest.mark.parametrize(
    "formula",
    [
        ImmutableMatrix([SYMBOLS[0] + FOREIGN]),
        Computation((Let(LOCAL, FOREIGN),), ImmutableMatrix([LOCAL])),
        Computation((Let(LOCAL, SYMBOLS[0]),), ImmutableMatrix([LOCAL * FOREIGN])),
        # A step that is needed before it is there.
        Computation(
            (Let(LOCAL, FOREIGN), Let(FOREIGN, SYMBOLS[0])), ImmutableMatrix([LOCAL + FOREIGN])
        ),
    ],
    ids=["in a formula", "in a step", "in a result", "before its time"],
)
def test_a_formula_that_needs_what_is_not_given_is_refused(
    formula: ImmutableMatrix | Computation,
) -> None:
    target = Target("topic", "several", "what", lambda: formula, arguments=ARGUMENTS)
    with pytest.raises(
        ValueError, match=r"several: expected a formula in \['a', .* got also \[e\]"
    ):
        lower(target, by_library)


def test_a_cheap_value_within_a_shared_one_is_written_out() -> None:
    a, b, _, d = SYMBOLS
    formulas = (-2 * b**2 - 2 * b * d, -2 * a * b * d + a * d)
    assert put_together(lowered(*formulas)) == list(formulas)


def test_products_that_are_added_here_and_subtracted_there_are_computed_once() -> None:
    a, b, c, d = SYMBOLS
    steps = lowered(a * d + c * b, c * b - a * d).steps
    assert {step.value for step in steps if isinstance(step, Let)} == {a * d, b * c}
