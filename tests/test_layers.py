"""Which layer may import which; anything else is a mistake."""

import ast
from pathlib import Path

import pytest

PACKAGE = Path(__file__).resolve().parents[1] / "chr_notes"

# Each layer with the modules and layers of the package that it may import.
NOTATION = {"symbols"}
NUMERIC = {"conventions", "errors", "_arrays", "_signals", "generated", "numeric"}
ALLOWED = {
    "symbols": set(),
    "conventions": set(),
    "errors": set(),
    "palette": set(),
    "aircraft": set(),
    "_texts": set(),
    "_signals": set(),
    "plots": {"palette", "aircraft", "plots"},
    "lesson": {"palette", "aircraft", "lesson", "_texts"},
    "printed": NOTATION | {"printed"},
    "derivations": NOTATION | {"derivations"},
    "typeset": set(),
    "ledger": NOTATION | {"printed", "derivations", "typeset", "ledger", "_texts", "_signals"},
    "codegen": NOTATION | {"derivations", "typeset", "codegen"},  # and parts of a page
    "generated": set(),
    "_arrays": set(),
    "numeric": NUMERIC,
    # Of what is printed, Table 1 goes into the bundles.
    "demos": {
        "demos",
        "_texts",
        "palette",
        "aircraft",
        "generated",
        "conventions",
        "printed",
        "numeric",
        "_arrays",
    },
    "book": NOTATION
    | {"ledger", "conventions", "palette", "demos", "lesson", "book", "_texts"}
    | {"plots"}  # for the curves of the page on speed
    # One page follows a formula through these, and one says what the documents' symbols mean.
    | {"derivations", "generated", "typeset", "printed"}
    | {"numeric", "__init__"},  # for one attitude as other systems write it, and all public names
    "__init__": NUMERIC,
    "export": {"numeric", "_texts"},  # the version
    "__main__": {"book", "ledger", "export", "numeric", "_signals"},
}


def layer(module: str) -> str:
    """The layer of a module: its folder or its own name, 'numeric' for the numeric API."""
    first = module.split(".", maxsplit=1)[0]
    return first if first in ALLOWED else "numeric"


def imported(path: Path) -> set[str]:
    """The modules of the package that a file imports, anywhere in it."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}: a relative import"
            base = str(node.module)
            found |= {f"{base}.{alias.name}" for alias in node.names}
    # Who imports the package itself can reach all that it has.
    whole = {"__init__" for name in found if name == "chr_notes"}
    return whole | {n.removeprefix("chr_notes.") for n in found if n.startswith("chr_notes.")}


FILES = sorted(PACKAGE.rglob("*.py"))


def test_imports_stay_within_the_layers() -> None:
    for path in FILES:
        own = layer(".".join(path.relative_to(PACKAGE).with_suffix("").parts))
        used = {layer(module) for module in imported(path)}
        assert used - {own} <= ALLOWED[own], path


@pytest.mark.parametrize(
    ("line", "found"),
    [
        ("import chr_notes", {"__init__"}),
        ("import chr_notes as notes", {"__init__"}),
        ("import chr_notes.printed.euler", {"printed"}),
        ("from chr_notes import ledger", {"ledger"}),
        ("def later():\n    from chr_notes.demos import build", {"demos"}),
        ("import numpy", set()),
    ],
)
def test_every_form_of_import_is_seen(line: str, found: set[str], tmp_path: Path) -> None:
    path = tmp_path / "module.py"
    path.write_text(line + "\n", encoding="utf-8")
    assert {layer(module) for module in imported(path)} == found


def test_numeric_api_does_not_load_sympy() -> None:
    for path in FILES:
        own = layer(".".join(path.relative_to(PACKAGE).with_suffix("").parts))
        if own in ("numeric", "generated", "_arrays", "conventions", "errors", "__init__"):
            assert "sympy" not in path.read_text(encoding="utf-8"), path
