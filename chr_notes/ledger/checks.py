"""What the judgement refuses before it proves anything: what is brought must not lie.

Each check raises a `CannotJudgeError` that says what is wrong with the case.
"""

from collections.abc import Iterator

from sympy import (
    And,
    Basic,
    Eq,
    Ge,
    Le,
    Limit,
    MatrixBase,
    MatrixSymbol,
    Ne,
    Subs,
    Symbol,
)
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational

from chr_notes.ledger.case import CannotJudgeError, Case
from chr_notes.ledger.condition import Condition
from chr_notes.ledger.edits import in_order
from chr_notes.ledger.evaluation import evaluate, parts
from chr_notes.ledger.identities import difference, is_zero
from chr_notes.ledger.proof import proves
from chr_notes.ledger.roots import ROOTS
from chr_notes.ledger.search import is_met_somewhere
from chr_notes.printed import BY_ID, DOCUMENTS
from chr_notes.printed.statement import Approximately
from chr_notes.symbols import BODY_RATES, EULER, EULER_RATES, g, m

DERIVED_NAMES = frozenset((*EULER, *EULER_RATES, *BODY_RATES, g, m))


def check_root(case: Case, *, failing: bool) -> None:
    """Refuse a root or weight where nothing is wrong, or none where something is."""
    if failing != (case.root is not None) or failing != (case.weight is not None):
        msg = (
            f"{case.id}: expected {'a' if failing else 'no'} root and weight, "
            f"got {case.root!r} and {case.weight!r}"
        )
        raise CannotJudgeError(msg)
    if case.root is not None and case.root not in ROOTS:
        msg = (
            f"{case.id}: expected as root one of ROOTS of chr_notes/ledger/roots.py, "
            f"{', '.join(ROOTS)}; got {case.root!r}"
        )
        raise CannotJudgeError(msg)


def check_reported(case: Case) -> None:
    """Refuse as reported what a derivation could check, and what was not written down twice.

    A fact about a product compares one quantity, named in words, with a number.
    """
    statement = case.printed.statement
    names = statement.free_symbols
    if any(case.reading(name) != name for name in names):
        msg = f"{case.id}: brought as reported, yet a symbol of it is derived"
        raise CannotJudgeError(msg)
    in_words = all(isinstance(each, Symbol) and each.name.startswith(r"\text{") for each in names)
    plain = isinstance(statement, Relational) and all(
        isinstance(side, Symbol) or side.is_number for side in statement.args
    )
    if not (names and in_words and plain):
        msg = f"{case.id}: brought as reported, yet it has mathematics to check: {statement}"
        raise CannotJudgeError(msg)
    if case.reported is None or in_order(statement) != in_order(case.reported):
        msg = f"{case.id}: expected in print {case.reported}, found {statement}"
        raise CannotJudgeError(msg)


def check_definition(case: Case) -> None:
    """Refuse a definition that is not brought as one, and one that gives no new name."""
    if case.replaces is not None:
        _check_replaces(case)
    introduces = _introduces_name(case)
    if introduces and not case.definition:
        msg = f"{case.id}: a name without a meaning; read it, or bring it with definition=True"
        raise CannotJudgeError(msg)
    if case.definition and (not introduces or case.condition is not None or case.edits):
        msg = f"{case.id}: brought as a definition, yet it gives no new name"
        raise CannotJudgeError(msg)


def _check_replaces(case: Case) -> None:
    """Let a definition take only the place of an earlier equation for the same name."""
    before = [printed.id for printed in DOCUMENTS[case.printed.document]]
    earlier = case.replaces in before[: before.index(case.id)]
    other = BY_ID[str(case.replaces)].statement if earlier else None
    mine = case.printed.statement
    if not (case.definition and isinstance(other, Eq) and isinstance(mine, Eq)) or (
        other.lhs != mine.lhs
    ):
        msg = f"{case.id}: expected to replace an earlier meaning of its name, got {case.replaces}"
        raise CannotJudgeError(msg)


def _introduces_name(case: Case) -> bool:
    """Whether a statement only gives a name: one that nothing knows yet, nor itself uses.

    Known are the names of the derivations, those that the document's reading gives a meaning
    otherwise than by this statement, and those that an earlier statement of the document has on
    its left side, unless the case says that it replaces that one.
    """
    statement = case.printed.statement
    if not isinstance(statement, Eq):
        return False
    known = DERIVED_NAMES | _left_sides_before(case)
    names = tuple(statement.lhs) if isinstance(statement.lhs, MatrixBase) else (statement.lhs,)
    return all(
        isinstance(name, Symbol | MatrixSymbol | AppliedUndef)
        and name not in known
        and case.reading.defines(name, by=case.id)
        and not name.free_symbols & _all_names(statement.rhs, case)
        for name in names
    )


def _all_names(side: Basic, case: Case) -> set[Basic]:
    """List the names in an expression, and those in what these are read as."""
    return side.free_symbols | case.reading(side).free_symbols


def _left_sides_before(case: Case) -> set[Basic]:
    names = set()
    for printed in DOCUMENTS[case.printed.document]:
        if printed.id == case.id:
            break
        for part in parts(printed.statement):
            if isinstance(part, Eq):
                names |= set(part.lhs) if isinstance(part.lhs, MatrixBase) else {part.lhs}
    return names - {BY_ID[case.replaces].statement.lhs} if case.replaces else names


def check_says_something(case: Case) -> None:
    """Refuse the same on both sides, and the same statement twice."""
    stated = [in_order(part) for part in parts(case.printed.statement)]
    if len(set(stated)) < len(stated):
        msg = f"{case.id}: the statement says one thing twice"
        raise CannotJudgeError(msg)
    if any(isinstance(part, Eq) and _plain(part.lhs) == _plain(part.rhs) for part in stated):
        msg = f"{case.id}: the statement says nothing, it has the same on both sides"
        raise CannotJudgeError(msg)
    for part in stated:
        if isinstance(part, Ge | Le) and _is_equality(part, case):
            msg = f"{case.id}: both sides of {part} are equal, it says less than is so"
            raise CannotJudgeError(msg)


def _is_equality(part: Relational, case: Case) -> bool:
    under = (*case.given, *((case.condition,) if case.condition is not None else ()))
    return proves(Eq(*part.args, evaluate=False), case.reading, *under)


def _plain(side: Basic) -> Basic:
    """Take a value or limit of a name that does not change there for the name itself."""
    if isinstance(side, Limit):
        return side.args[0] if side.args[1] not in side.args[0].free_symbols else side
    return side.doit() if isinstance(side, Subs) else side


def check_conditions(case: Case) -> None:
    """Refuse conditions that cannot be met, that say the statement once more, or too much."""
    own = () if case.condition is None else (case.condition,)
    if (case.given or own) and not is_met_somewhere(case):
        msg = f"{case.id}: no point was found that meets the condition and what is given"
        raise CannotJudgeError(msg)
    for condition in (*case.given, *own):
        if _restates(condition, case):
            msg = f"{case.id}: {condition.holds} says what the statement says, and proves nothing"
            raise CannotJudgeError(msg)
    statement = case.printed.statement if case.right is None else case.right
    for narrower in _with_less(case):
        if proves(statement, case.reading, *narrower) and not any(
            proves(step.statement, case.reading, *case.given)
            and not proves(step.statement, case.reading, *narrower)
            for step in case.steps
        ):
            left_out = {*case.given, *own} - {*narrower}
            msg = f"{case.id}: it holds with less than {[each.holds for each in left_out]}"
            raise CannotJudgeError(msg)


def _with_less(case: Case) -> Iterator[tuple[Condition, ...]]:
    """Leave out one thing that is given, or one part of the condition.

    What is given beside a condition also bounds where the statement may fail; it stays.
    """
    if case.condition is None:
        for each in case.given:
            yield tuple(other for other in case.given if other is not each)
    elif isinstance(case.condition.holds, And):
        relations = case.condition.holds.args
        for each in relations:
            rest = [other for other in relations if other is not each]
            yield (*case.given, Condition(And(*rest, evaluate=False)))


def _restates(condition: Condition, case: Case) -> bool:
    """Whether a condition is the statement itself, or all of it in names that are read."""
    relations = [
        part
        for way in condition.holds.args
        if not isinstance(condition.holds, Relational)
        for part in parts(way)
    ] or [condition.holds]
    stated = [p for p in parts(case.printed.statement) if not isinstance(p, Approximately)]
    keys = {_key(part, case) for part in stated}
    if any(_key(relation, case) in keys for relation in relations):
        return True
    if not any(case.reading(name) != name for name in condition.holds.free_symbols):
        return False
    kinds = {type(part) for part in (*stated, *relations)}
    if kinds not in ({Eq}, {Ne}):
        return False
    said = [each for relation in relations for each in _components(relation, case)]
    return all(
        any(is_zero(each - sign * other) for other in said for sign in (1, -1))
        for part in stated
        for each in _components(part, case)
        if not is_zero(each)
    )


def _key(relation: Basic, case: Case) -> tuple[type, frozenset[Basic]]:
    return type(relation), frozenset(in_order(case.reading(side)) for side in relation.args)


def _components(relation: Relational, case: Case) -> tuple[Basic, ...]:
    left, right = (evaluate(side, case.reading, {}) for side in relation.args)
    scalars = not (left.is_Matrix or right.is_Matrix)
    same = scalars or getattr(left, "shape", ()) == getattr(right, "shape", ())
    return difference(left, right) if same else ()
