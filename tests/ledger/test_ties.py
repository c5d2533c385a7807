"""Roots and weights agree with what can be computed of them."""

from dataclasses import replace

import pytest

from chr_notes.ledger.case import CannotJudgeError
from chr_notes.ledger.cases import CASES
from chr_notes.ledger.ties import check_weight, fitting_weights, traits, unlike

ROOTED = {name: case for name, case in CASES.items() if case.root is not None}
ROOTS: dict[str, list[str]] = {}
for _name, _case in ROOTED.items():
    ROOTS.setdefault(str(_case.root), []).append(_name)


@pytest.mark.parametrize(
    ("name", "weight"),
    [
        # Words for words, formulas, numbers that are off, and one that is cut off.
        ("euler.4.b", "misleads"),
        ("sensors.2.i", "misleads"),
        ("estimation.2.6", "small print"),
        ("estimation.4.4", "label"),
        ("quaternions.3.1", "label"),
        ("validation.4", "label"),
        ("validation.7", "small print"),
        ("validation.12", "small print"),
        ("euler.5.5", "small print"),
        ("validation.c", "label"),
        ("dead_reckoning.4.b", "small print"),
        ("dead_reckoning.t1.5.0.position_1h", "label"),
        ("dead_reckoning.t1.1.5.velocity_10s", "misleads"),
    ],
)
def test_a_weight_fits_what_is_wrong(name: str, weight: str) -> None:
    with pytest.raises(CannotJudgeError, match=rf"as weight, got {weight}"):
        check_weight(replace(CASES[name], weight=weight))  # type: ignore[arg-type]


def test_most_weights_are_the_only_ones_that_fit() -> None:
    single = [name for name, case in ROOTED.items() if fitting_weights(case) == (case.weight,)]
    assert len(single) > len(ROOTED) // 2


@pytest.fixture(scope="module")
def known() -> dict[str, frozenset[object]]:
    """The traits of all that fails, worked out once."""
    return {name: traits(case) for name, case in ROOTED.items()}


@pytest.mark.parametrize("root", [root for root, names in ROOTS.items() if len(names) > 1])
def test_no_stranger_is_a_place_of_a_root(root: str, known: dict[str, frozenset[object]]) -> None:
    names = ROOTS[root]
    common = frozenset.intersection(*(known[name] for name in names))
    assert common
    assert [name for name in ROOTED if name not in names and known[name] & common] == []


def test_a_place_that_is_unlike_is_told() -> None:
    stranger = replace(CASES["estimation.4.4"], root="roll-quadrant")
    (told,) = unlike([CASES["validation.3"], stranger])
    assert told == (
        "expected something in common of all places of 'roll-quadrant': "
        "validation.3, estimation.4.4"
    )


def test_readings_that_are_left_out_are_missed_by_the_root() -> None:
    for one, other in (("quaternions.3.1", "quaternions.3.3"), ("validation.8", "validation.5")):
        assert list(unlike([CASES[one], CASES[other]])) == []
        assert len(list(unlike([replace(CASES[one], readings=()), CASES[other]]))) == 1
