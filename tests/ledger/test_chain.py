"""Steps lead to the formula: what has nothing to do with it is refused, however true it is."""

from dataclasses import replace

import pytest
from sympy import Eq, Ne, cos, sin

from chr_notes.derivations.steps import Step
from chr_notes.ledger.case import CannotJudgeError
from chr_notes.ledger.cases import CASES
from chr_notes.ledger.chain import check_steps
from chr_notes.ledger.reading import reading
from chr_notes.symbols import phi

from .tried import NAME, OTHER, Say, x, y, z

TRUE = Eq(y, x * x)
ALONG = Step("So.", Eq(y * z, z * x**2))
FOREIGN = Step("So.", Eq(OTHER, z**3))
READ_BOTH = reading({y: x**2, OTHER: z**3})


def test_a_true_step_that_leads_nowhere_is_refused(say: Say) -> None:
    nowhere = r"tried.1.1: step 1 has no name or expression in common with the formula"
    with pytest.raises(CannotJudgeError, match=rf"{nowhere}, it leads nowhere"):
        say(TRUE, read=READ_BOTH, steps=(FOREIGN,))
    with pytest.raises(CannotJudgeError, match=r"step 2 .* formula, it leads nowhere"):
        say(TRUE, read=READ_BOTH, steps=(ALONG, FOREIGN))
    # With a later step it is enough, and that one leads on.
    assert say(TRUE, read=READ_BOTH, steps=(FOREIGN, ALONG)).derivation
    with pytest.raises(CannotJudgeError, match=rf"{nowhere} or with a later step"):
        say(TRUE, read=reading({y: x**2, OTHER: NAME}), steps=(Step("So.", Eq(OTHER, NAME)), ALONG))


def test_a_step_that_is_true_whatever_its_names_stand_for_is_no_link_by_a_name(say: Say) -> None:
    with pytest.raises(CannotJudgeError, match="leads nowhere"):
        say(TRUE, steps=(Step("So.", Eq(y * (1 + z), y + y * z)), Step("So.", Eq(2 * y, y + x**2))))
    for always in (Eq(sin(x) ** 2 + cos(x) ** 2, 1), Ne(x**2, -1, evaluate=False)):
        with pytest.raises(CannotJudgeError, match="leads nowhere"):
            say(TRUE, steps=(Step("So.", always),))


def test_an_everyday_name_alone_links_nothing(say: Say) -> None:
    read = reading({y: cos(phi), OTHER: sin(phi)})
    angle = Step("So.", Eq(OTHER, sin(phi)))
    with pytest.raises(CannotJudgeError, match="leads nowhere"):
        say(Eq(y, cos(phi)), read=read, steps=(angle,))


def test_what_is_to_be_derived_has_steps() -> None:
    for name, case in CASES.items():
        to_derive = case.printed.kind == "equation" and not case.definition
        if to_derive or case.edits:
            with pytest.raises(CannotJudgeError, match=f"{name}: expected a step at least"):
                check_steps(replace(case, steps=()))
        elif not case.steps:
            check_steps(case)


@pytest.mark.parametrize("name", ["euler.7.2", "quaternions.3.2", "sensors.4.3", "validation.e"])
@pytest.mark.parametrize("of", ["estimation.4.d", "dead_reckoning.4.b"])
def test_a_step_of_another_document_is_refused(name: str, of: str) -> None:
    case, foreign = CASES[name], CASES[of].steps[0]
    for steps in ((foreign, *case.steps), (*case.steps, foreign)):
        with pytest.raises(CannotJudgeError, match="leads nowhere"):
            check_steps(replace(case, steps=steps))
