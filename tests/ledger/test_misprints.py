"""Each misprint, in an entry of whatever verdict, changes the verdict or is refused."""

from random import Random

import pytest
from sympy import Basic

from chr_notes.ledger import entry, proof, stored
from chr_notes.ledger.case import CannotJudgeError
from chr_notes.ledger.cases import CASES
from chr_notes.ledger.files import see
from chr_notes.ledger.judgement import judge
from chr_notes.printed import BY_ID

from .equivalents import ANGLES, EQUIVALENT, turned_further
from .misprints import misprints
from .planting import planted

# Without `--full` one misprint is made of each definition, and of one entry in eight.
ONE_IN = 8
TRIED = [
    pytest.param(name, marks=() if number % ONE_IN == 0 or case.definition else pytest.mark.full)
    for number, (name, case) in enumerate(CASES.items())
]


def is_seen(name: str, wrong: Basic) -> bool:
    """Whether the ledger says something else, or refuses to speak, once a statement is wrong.

    A definition is tied to its use: there another entry of the document may say it.
    """
    own = entry(name).verdict
    try:
        with planted(name, wrong) as cases:
            if judge(cases[name]).verdict != own:
                return True
            if own == "definition":
                document, defined = cases[name].printed.document, BY_ID[name].statement.lhs
                others = [each for each in stored.read(document) if each.id != name]
                # It most likely shows where the name stands.
                others.sort(key=lambda each: not BY_ID[each.id].statement.has(defined))
                return any(judge(cases[each.id]).verdict != each.verdict for each in others)
    except (CannotJudgeError, IndexError, TypeError, ValueError):
        return True  # refused, or no mathematics at all: a vector added to a number
    return False


@pytest.fixture(autouse=True)
def _without_messages(monkeypatch: pytest.MonkeyPatch) -> None:
    """Do not simplify what is left over for a message that nobody reads."""
    monkeypatch.setattr(proof, "_gap", lambda *_: "something")


@pytest.mark.parametrize("name", TRIED)
def test_misprints_are_seen(name: str, pytestconfig: pytest.Config) -> None:
    made = list(misprints(BY_ID[name].statement))
    assert made
    if not pytestconfig.getoption("full", default=False):
        made = [Random(name).choice(made)]  # noqa: S311 (the same ones each time)
    survivors = [
        f"{kind}: {wrong}"
        for kind, wrong in made
        if is_seen(name, wrong) == ((name, kind) in EQUIVALENT)
    ]
    told = "nobody sees, and tests/ledger/equivalents.py has not, or the other way round"
    assert not survivors, "\n".join([f"{name}: misprints that {told}; {see(name)}", *survivors])


def test_equivalents_are_misprints_that_exist() -> None:
    for name in {name for name, _ in EQUIVALENT}:
        kinds = {kind for entry, kind in EQUIVALENT if entry == name}
        assert kinds <= {kind for kind, _ in misprints(BY_ID[name].statement)}


# Without `--full` a few, one of each kind of angle.
FEW = ("quaternions.4.1", "estimation.2.5", "estimation.3.2", "validation.3")


@pytest.mark.parametrize(
    "name", [pytest.param(n, marks=() if n in FEW else pytest.mark.full) for n in ANGLES]
)
def test_a_whole_turn_more_is_the_same_angle_and_half_a_turn_is_another(name: str) -> None:
    assert not is_seen(name, turned_further(name, 2))
    assert is_seen(name, turned_further(name, 1))
