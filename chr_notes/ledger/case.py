"""What is brought before the judgement with one printed statement."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from itertools import combinations
from types import MappingProxyType, NoneType

from sympy import Basic, Eq, ImmutableMatrix, pi, preorder_traversal
from sympy.logic.boolalg import Boolean

from chr_notes.derivations.steps import Step
from chr_notes.ledger.condition import Condition
from chr_notes.ledger.edits import Edit, edited
from chr_notes.ledger.entry import Weight
from chr_notes.ledger.files import see, see_case
from chr_notes.ledger.reading import Defined, Read
from chr_notes.printed import BY_ID, Printed

DEGREE = pi / 180
NOTHING = ImmutableMatrix.zeros(3, 1)


class CannotJudgeError(Exception):
    """A statement is neither proved nor shown to fail with what was brought before it."""


@dataclass(frozen=True)
class Reading:
    """One of several ways to read a document that contradicts itself.

    Parameters
    ----------
    convention
        What this way of reading presumes.
    read
        The meaning of the document's symbols then.
    point
        Values at which a statement that does not hold under this reading fails.
    """

    convention: Boolean
    read: Read
    point: Mapping[Basic, Basic]


@dataclass(frozen=True)
class Case:
    """A printed statement with all that is needed to judge it; the verdict is computed.

    Parameters
    ----------
    id
        Of the printed statement.
    read
        The document's symbols as derived quantities; the document's own reading if left out.
    given
        Everything is judged within it, the witness included: what the document's reading says that
        it presumes. `complete` adds it.
    condition
        For a statement that holds only under it.
    edits
        For a wrong statement: which parts of the print to replace by what; the rest is kept.
    witness
        Values at which the statement fails, angles in radians. None for words without symbols.
    root, weight
        For a statement that does not hold as printed: which error it is one place of, see
        `chr_notes.ledger.roots`, and how much that matters.
    told_in
        For an error that could weigh more than it does: the statement of the same document that
        has it right.
    definition
        That the statement only gives a name, by which other statements are read.
    replaces
        For a definition of a name that the document had given another meaning before: the entry
        that did so.
    reported
        For a fact about a product: the statement once more, written down independently.
    readings
        For statements that contradict one another: the readings under which some of them hold. One
        with a misprint besides, which holds under none, has `edits` too, right under the first.
    steps
        The derivation of the right form or of the condition.
    remark
        Markdown for the reader.
    """

    id: str
    read: Read | None = None
    given: tuple[Condition, ...] = ()
    condition: Condition | None = None
    edits: tuple[Edit, ...] = ()
    witness: Mapping[Basic, Basic] = field(default_factory=dict)
    root: str | None = None
    weight: Weight | None = None
    told_in: str | None = None
    definition: bool = False
    replaces: str | None = None
    reported: Boolean | None = None
    readings: tuple[Reading, ...] = ()
    steps: tuple[Step, ...] = ()
    remark: str | None = None

    def check(self) -> None:
        """Refuse what is not of its kind, and conditions that say nothing.

        Raises
        ------
        CannotJudgeError
            Then. It names the entry, what was expected and what came.
        """
        try:
            for name, kind in KINDS.items():
                _check_kind(getattr(self, name), kind, name)
            for name, kind in EACH.items():
                for value in getattr(self, name):
                    _check_kind(value, kind, f"one of {name}")
            for step in self.steps:
                if not (isinstance(step.statement, Boolean) and step.statement.args):
                    msg = f"expected a relation as step, got {step.statement!r}"
                    raise ValueError(msg)  # noqa: TRY301 (named below)
            for condition in filter(None, (*self.given, self.condition)):
                condition.check()
        except (TypeError, ValueError) as error:
            msg = f"{self.id}: {error}; {see(self.id)}"
            raise CannotJudgeError(msg) from error

    @property
    def printed(self) -> Printed:
        """What the document prints."""
        return BY_ID[self.id]

    @property
    def reading(self) -> Read:
        """How the document's symbols are read."""
        if self.read is None:
            msg = f"{self.id}: no reading; `complete` gives the document's own"
            raise CannotJudgeError(msg)
        return self.read

    @property
    def right(self) -> Boolean | None:
        """The corrected statement: the printed one, edited. Nothing if there are no edits."""
        if not self.edits:
            return None
        try:
            return edited(self.printed.statement, self.edits)
        except ValueError as error:
            msg = f"{self.id}: {error}"
            raise CannotJudgeError(msg) from error


# What a case is made of; and of what there may be several, each one.
KINDS: Mapping[str, tuple[type, ...]] = MappingProxyType(
    {
        "read": (Read, NoneType),
        "given": (tuple,),
        "condition": (Condition, NoneType),
        "edits": (tuple,),
        "witness": (Mapping,),
        "reported": (Boolean, NoneType),
        "readings": (tuple,),
        "steps": (tuple,),
    }
)
EACH: Mapping[str, tuple[type, ...]] = MappingProxyType(
    {"given": (Condition,), "edits": (Edit,), "readings": (Reading,), "steps": (Step,)}
)


def _check_kind(value: object, kinds: tuple[type, ...], name: str) -> None:
    if not isinstance(value, kinds):
        called = " or ".join("None" if kind is NoneType else kind.__name__ for kind in kinds)
        msg = f"expected {called} as {name}, got {value!r}"
        raise TypeError(msg)


def complete(
    printed: tuple[Printed, ...], read: Read, settled: tuple[Case, ...]
) -> tuple[Case, ...]:
    """List the cases of a document in printed order, those that need nothing brought included.

    Parameters
    ----------
    printed
        All statements of the document.
    read
        The document's reading, for all statements that bring none.
    settled
        Cases with a condition, a correction, steps, or more names than the document's reading.
        Each is judged under what the reading presumes for it.

    Raises
    ------
    CannotJudgeError
        If a case is not made of what it should be, has no printed statement, or reads a symbol
        otherwise than the document, or if no statement is read by what is brought as a definition,
        or one otherwise. Of several cases it tells all.
    """
    faults = []
    for case in settled:
        try:
            case.check()
        except CannotJudgeError as error:
            faults.append(str(error))
    if faults:
        raise CannotJudgeError("\n".join(faults))
    by_id = {case.id: case for case in settled}
    names = {statement.id for statement in printed}
    if len(by_id) < len(settled) or by_id.keys() - names:
        seen = [case.id for case in settled]
        odd = sorted({name for name in seen if name not in names or seen.count(name) > 1})
        faults.append(f"expected one case at most for a printed statement, got {', '.join(odd)}")
    cases = []
    for statement in printed:
        case = by_id.get(statement.id, Case(statement.id))
        if case.read is None:
            case = replace(case, read=read)
        elif not case.read.extends(read):
            faults.append(
                f"{case.id}: read otherwise than the document; give more names by `READ.also`"
            )
        presumed = (each.holds for each in read.presumed if case.id in each.presuming)
        cases.append(replace(case, given=(*case.given, *presumed)))
    faults += [
        f"{case.id}: {odd}; {see_case(case.id)}"
        for case in cases
        for odd in _odd_among(case, cases)
    ]
    if faults:
        raise CannotJudgeError("\n".join(faults))
    return tuple(cases)


def _odd_among(case: Case, cases: list[Case]) -> Iterator[str]:
    """Yield what about a case does not go with the others of its document."""
    if case.definition and not any(_uses(other, case) for other in cases):
        yield "brought as a definition, yet no statement is read by it"
    if not case.readings and (like := [each.id for each in cases if _is_contested(case, each)]):
        yield (
            f"expected readings as of {like[0]}, for the document contradicts itself in what it "
            "names; got none"
        )
    if case.told_in is not None and not any(
        each.id == case.told_in and each.root is None for each in cases
    ):
        yield f"expected as told_in a statement of its document that holds, got {case.told_in!r}"
    other = next((each for each in cases if _means_otherwise(each, case)), None)
    if other is not None:
        yield f"brought as a definition, yet {other.id} reads its name otherwise"


def _is_contested(case: Case, other: Case) -> bool:
    """Whether a statement has what a statement with several readings is about."""
    statement = case.printed.statement
    for one, two in combinations(other.readings, 2):
        names, kinds = one.read.contested(two.read)
        if statement.has(*kinds) or not names.isdisjoint(preorder_traversal(statement)):
            return True
    return False


def _means_otherwise(case: Case, definition: Case) -> bool:
    """Whether a name that is defined once has another meaning for a statement."""
    defining = definition.printed.statement
    return (
        definition.definition
        and definition.replaces is None
        and isinstance(defining, Eq)
        and not case.reading.defines(defining.lhs, by=definition.id)
    )


def _uses(case: Case, definition: Case) -> bool:
    """Whether a statement that is derived has the name that another one defines, read by it."""
    defining = definition.printed.statement
    return (
        not (case.definition or case.reported is not None)
        and isinstance(defining, Eq)
        and case.printed.statement.has(defining.lhs)
        and case.reading.definition(defining.lhs) == Defined(definition.id)
    )
