"""The page on notation has every symbol that the layers share or that the documents use often."""

from collections import Counter

from sympy import Basic, MatrixSymbol, Symbol, preorder_traversal

from chr_notes import symbols
from chr_notes.book.notation import NOTATION, first_entry, notation
from chr_notes.ledger.cases import CASES
from chr_notes.typeset import latex

OFTEN = 4
LINES = [line for lines in NOTATION.values() for line in lines]
LISTED = {symbol for line in LINES for symbol in line.symbols}


def shared() -> set[Symbol]:
    """The symbols that `chr_notes.symbols` defines, alone or several together."""
    found = set()
    for value in vars(symbols).values():
        several = value if isinstance(value, tuple) else (value,)
        found |= {each for each in several if isinstance(each, Symbol)}
    return found


def test_each_shared_symbol_has_a_line() -> None:
    assert len(shared()) > 30
    assert shared() <= LISTED


def test_what_the_documents_use_often_has_a_line() -> None:
    used: Counter[Basic] = Counter()
    for case in CASES.values():
        parts = set(preorder_traversal(case.printed.statement))
        used.update(part for part in parts if isinstance(part, Symbol | MatrixSymbol))
    often = {symbol for symbol, times in used.items() if times >= OFTEN}
    signs = {symbol for symbol in often if symbol.name in "+-"}
    assert often - signs <= LISTED


def test_each_symbol_is_typeset_on_the_page() -> None:
    text = notation()
    for symbol in LISTED:
        assert f"${latex(symbol)}$" in text


def test_first_entry_has_the_symbol_and_none_before_it_prints_it() -> None:
    for topic, lines in NOTATION.items():
        own = [name for name in CASES if name.startswith(f"{topic}.")]
        for line in lines:
            name = first_entry(line, topic)
            if name is None:  # the code alone has it
                assert line.symbols == symbols.MAGNETOMETER
                continue
            before = own[: own.index(name)] if name in own else own
            for other in before:
                parts = set(preorder_traversal(CASES[other].printed.statement))
                assert parts.isdisjoint(line.symbols)
