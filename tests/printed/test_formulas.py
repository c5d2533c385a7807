"""What the ledger typesets is what the document prints, term by term and in its order."""

import csv
from pathlib import Path

import pytest

from chr_notes.ledger.files import see
from chr_notes.printed import (
    DOCUMENTS,
    dead_reckoning_claims,
    estimation_claims,
    euler_claims,
    quaternions_claims,
    sensors_claims,
    validation_claims,
)
from chr_notes.printed.statement import Nearly
from chr_notes.typeset import latex

from .terms import relations


def written(name: str) -> dict[str, str]:
    """The LaTeX of a file beside this one, by id."""
    with (Path(__file__).parent / name).open(encoding="utf-8") as file:
        return {row["id"]: row["latex"] for row in csv.DictReader(file, delimiter="\t", quoting=3)}


FORMULAS = written("formulas.tsv")
CLAIMS = written("claims.tsv")
MORE = (
    euler_claims,
    quaternions_claims,
    sensors_claims,
    estimation_claims,
    dead_reckoning_claims,
    validation_claims,
)
STATEMENTS = {
    each.id: each
    for document in (*DOCUMENTS.values(), *(claims.ADDITIONS for claims in MORE))
    for each in document
}
EQUATIONS = {name: each for name, each in STATEMENTS.items() if each.kind == "equation"}


def test_there_is_a_formula_for_every_equation() -> None:
    for name in FORMULAS.keys() ^ EQUATIONS.keys():
        assert name in FORMULAS, f"{name} has no row in tests/printed/formulas.tsv; {see(name)}"
        assert name in EQUATIONS, f"{name} of tests/printed/formulas.tsv is no printed equation"


def test_claims_read_as_they_were_written_down() -> None:
    """What a claim is read as is our own: it is written twice, names and all, and compared."""
    read = {each.id: each for each in STATEMENTS.values() if each.kind == "claim"}
    for name in read.keys() ^ CLAIMS.keys():
        assert name in CLAIMS, f"{name} has no row in tests/printed/claims.tsv; {see(name)}"
        assert name in read, f"{name} of tests/printed/claims.tsv is no printed claim"
    for name, each in read.items():
        found = latex(each.statement, as_written=True)
        assert found == CLAIMS[name], f"{name}: tests/printed/claims.tsv differs; {see(name)}"


@pytest.mark.parametrize("name", FORMULAS)
def test_terms_stand_as_the_document_has_them(name: str) -> None:
    statement = EQUATIONS[name].statement
    printed = relations(FORMULAS[name])
    if isinstance(statement, Nearly):  # the words before the formula say so, not its sign
        assert printed[1] == "="
        printed[1] = r"\approx"
    found = relations(latex(statement, as_written=True))
    assert found == printed, f"{name}: tests/printed/formulas.tsv differs; {see(name)}"


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("a + b", "b + a"),
        ("a b", "b a"),
        ("a - (b - c)", "a - b + c"),
        ("a (b + c)", "a b + a c"),
        (r"\sin x", r"\cos x"),
        (r"\frac{a}{b}", r"\frac{b}{a}"),
        ("x_1", "x_2"),
        ("x^2", "x"),
        (r"(a b)^{*}", r"a^{*} b"),
        (r"\begin{pmatrix}a & b\end{pmatrix}", r"\begin{pmatrix}a \\ b\end{pmatrix}"),
        ("a = b = c", "a = c = b"),
        ("a = b", r"a \Rightarrow b"),
    ],
)
def test_what_is_not_layout_makes_a_difference(one: str, other: str) -> None:
    assert relations(one) != relations(other)


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (r"\frac{a b}{c}", "a b / c"),
        (r"\mathbf{a} {b}", "a(b)"),
        (r"\sin\left(x\right)", r"\sin {x}"),
        (r"s(\phi) S_\theta", r"\sin\phi \sin\theta"),
        (r"\begin{pmatrix}a & b\end{pmatrix}^T", r"\begin{bmatrix}a \\ b\end{bmatrix}"),
        (r"-\frac{a}{b}", r"\frac{-a}{b}"),
        (r"(a \otimes b)^*", r"\left(a \otimes b\right)^{*}"),
    ],
)
def test_layout_makes_none(one: str, other: str) -> None:
    assert relations(one) == relations(other)


def test_what_cannot_be_read_is_told() -> None:
    with pytest.raises(AssertionError, match=r"POWERS of tests/printed/terms\.py .* got '\+'"):
        relations("(a b)^+")
