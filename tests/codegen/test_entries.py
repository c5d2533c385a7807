"""What a generated function computes is what the entries of the ledger say that it names."""

import inspect
import re
from pathlib import Path

import pytest

import chr_notes
from chr_notes.codegen.targets import TARGETS
from chr_notes.derivations.computation import Computation
from chr_notes.ledger.cases import CASES
from chr_notes.ledger.proof import examine
from chr_notes.printed import DOCUMENTS

from .reckoning_ties import RECKONING
from .sensor_ties import SENSORS
from .ties import ATTITUDES, Tie

PACKAGE = Path(chr_notes.__file__).parent
TIES = ATTITUDES | SENSORS | RECKONING
PAIRS = [(target.name, entry) for target in TARGETS for entry in target.entries]
BY_NAME = {target.name: target for target in TARGETS}
TOPICS = "|".join(DOCUMENTS)
ID = re.compile(rf"\b(?:{TOPICS})\.(?:\d+|t1)(?:\.\w+)*|\b(?:{TOPICS})\.[a-z]\b")


@pytest.mark.parametrize(("name", "entry"), PAIRS)
def test_the_function_computes_what_the_entry_says(name: str, entry: str) -> None:
    case = CASES[entry]
    right = case.right if case.right is not None else case.printed.statement
    tie = TIES.get((name, entry), Tie())
    formula = BY_NAME[name].formula()
    formulas = [formula]
    if isinstance(formula, Computation):
        formulas = [formula.inlined(*branches) for branches in (tie.branches, *tie.others)]
    conditions = (*case.given, *([case.condition] if case.condition is not None else []))
    for each in formulas:
        relations = list(tie.states(each, right))
        assert relations
        for relation in relations:
            for finding in examine(relation, case.reading, *conditions):
                assert finding.holds, finding.left_over()


def test_each_tie_is_of_a_function_that_names_the_entry() -> None:
    assert TIES.keys() <= set(PAIRS)


@pytest.mark.parametrize("name", [name for name in BY_NAME if hasattr(chr_notes, name)])
def test_documentation_names_the_entries_of_the_table(name: str) -> None:
    text = inspect.getdoc(getattr(chr_notes, name)) or ""
    _, _, named = text.partition("Ledger: ")
    assert set(ID.findall(named)) == set(BY_NAME[name].entries)


def test_each_entry_that_documentation_names_exists() -> None:
    for path in PACKAGE.glob("*.py"):
        for line in re.findall(r"Ledger: [^\n]*(?:\n +[^\n]+)*", path.read_text(encoding="utf-8")):
            for entry in ID.findall(line):
                assert entry in CASES, (path.name, entry)
