"""Roots and weights agree with what can be computed of them."""

import re
from dataclasses import replace

import pytest

from chr_notes.ledger import ties
from chr_notes.ledger.case import CannotJudgeError, complete
from chr_notes.ledger.cases import CASES
from chr_notes.ledger.roots import KNOWN_BY
from chr_notes.ledger.ties import check_place, check_weight, fitting_weights, traits
from chr_notes.printed import DOCUMENTS

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
def known() -> dict[str, frozenset[str]]:
    """The traits of all that fails, worked out once."""
    return {name: traits(case) for name, case in ROOTED.items()}


@pytest.mark.parametrize("root", KNOWN_BY)
def test_a_root_is_known_by_what_no_stranger_has(
    root: str, known: dict[str, frozenset[str]]
) -> None:
    found = [
        name
        for name, has in known.items()
        if any(re.fullmatch(KNOWN_BY[root], trait) for trait in has)
    ]
    assert found == ROOTS[root]


def test_a_wrong_root_is_told() -> None:
    for name, root in (("validation.4", "south-field"), ("estimation.4.4", "roll-quadrant")):
        with pytest.raises(CannotJudgeError, match=f"{name}: expected of a place of '{root}' what"):
            check_place(replace(CASES[name], root=root))
    turned = CASES["quaternions.3.1"]
    for readings in ((), turned.readings[:1]):  # by the first it is wrong
        with pytest.raises(CannotJudgeError, match="expected of a place of 'quaternion-direction'"):
            check_place(replace(turned, readings=readings))


def test_a_root_that_is_known_by_nothing_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ties, "KNOWN_BY", {})
    with pytest.raises(CannotJudgeError, match=r"validation\.4: expected a pattern for .* of: ."):
        check_place(CASES["validation.4"])


def test_a_root_that_misleads_and_does_nothing_on_a_device_is_told(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(ties, "HARM", {})
    check_place(replace(CASES["sensors.4.3"], weight="label"))
    with pytest.raises(
        CannotJudgeError, match=r"4\.3: expected a line for .* in HARM of .*harm\.py"
    ):
        check_place(CASES["sensors.4.3"])


# Lighter than they could be, by a statement of the document that has it right.
LIGHTER = [name for name, case in ROOTED.items() if case.told_in is not None]


def test_what_weighs_less_than_it_could_is_told_right_elsewhere() -> None:
    assert len(LIGHTER) == 15
    for name in LIGHTER:
        with pytest.raises(
            CannotJudgeError, match=f"{name}: expected a statement that has it right"
        ):
            check_weight(replace(CASES[name], told_in=None))
        with pytest.raises(CannotJudgeError, match=f"{name}: expected a remark that leads to"):
            check_weight(replace(CASES[name], remark="None."))


@pytest.mark.parametrize(
    ("name", "weight"),
    [
        ("validation.h", "small print"),
        ("validation.e", "small print"),
        ("euler.7.a", "small print"),
    ],
)
def test_a_weight_is_not_made_less_without_a_reason(name: str, weight: str) -> None:
    with pytest.raises(CannotJudgeError, match="expected a statement that has it right"):
        check_weight(replace(CASES[name], weight=weight))  # type: ignore[arg-type]
    with pytest.raises(CannotJudgeError, match="expected None as told_in"):
        check_weight(replace(CASES[name], told_in="euler.7.2"))


def test_what_is_told_in_holds_and_is_of_the_document() -> None:
    document, case = DOCUMENTS["validation"], CASES["validation.b"]
    read = CASES["validation.a"].reading
    for where in ("validation.h", "euler.5.4", "validation.z"):
        lean, wrong = replace(case, told_in=where, given=()), CASES["validation.h"]
        with pytest.raises(CannotJudgeError, match="expected as told_in a statement"):
            complete(document, read, (lean, replace(wrong, given=())))
