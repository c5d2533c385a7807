"""Notebooks for a class: the exercises without their worked solutions and known mistakes."""

import ast
import html
import re
from collections.abc import Iterable
from typing import Any

Cell = dict[str, Any]


def without_solutions(notebook: dict[str, Any]) -> None:
    """Leave of each exercise its question, and an empty cell below for the answer.

    Parameters
    ----------
    notebook
        As read from JSON; changed in place. What an exercise defines stays if its question or
        another cell uses it.
    """
    cells: list[Cell] = []
    for cell in notebook["cells"]:
        cells.append(cell)
        if cell["cell_type"] != "code" or not _source(cell).rstrip().endswith(")"):
            continue
        others = [other for other in notebook["cells"] if other is not cell]
        asked = _asked(cell, others)
        if asked is not None:
            cell["source"] = asked
            cell["outputs"] = [_question(output) for output in cell["outputs"]]
            cells.append(_empty(f"{cell['id']}-answer"))
    notebook["cells"] = cells


def _source(cell: Cell) -> str:
    return "".join(cell["source"])


def _asked(cell: Cell, others: Iterable[Cell]) -> str | None:
    """Rewrite an exercise so that it only asks; nothing for any other cell."""
    *before, last = ast.parse(_source(cell)).body
    if not (isinstance(last, ast.Expr) and isinstance(last.value, ast.Call)):
        return None
    call = last.value
    if not (isinstance(call.func, ast.Name) and call.func.id == "exercise"):
        return None
    # An arrow's plane and pictures belong to the question, a unit does not.
    by_hand = [each for each in call.args[3:4] if not isinstance(each, ast.Constant)]
    for each in by_hand:
        if isinstance(each, ast.Call):
            each.keywords = [ast.keyword("drawn", ast.parse(_drawn(cell), mode="eval").body)]
    asking = ast.Call(call.func, call.args[:2], [ast.keyword("asked", each) for each in by_hand])
    needed = _names(asking).union(*(_used(_source(other)) for other in others if _is_code(other)))
    kept: list[ast.stmt] = []
    for statement in reversed(before):
        if isinstance(statement, ast.FunctionDef) and statement.name == "worked":
            continue
        if needed & _defined(statement):
            needed |= _names(statement)
            kept.insert(0, statement)
    return ast.unparse(ast.Module([*kept, ast.Expr(asking)], []))


def _is_code(cell: Cell) -> bool:
    return bool(cell["cell_type"] == "code")


def _used(source: str) -> set[str]:
    return _names(ast.parse(source))


def _names(node: ast.AST, context: type[ast.expr_context] = ast.Load) -> set[str]:
    found = (part for part in ast.walk(node) if isinstance(part, ast.Name))
    return {name.id for name in found if isinstance(name.ctx, context)}


def _defined(statement: ast.stmt) -> set[str]:
    if isinstance(statement, ast.FunctionDef):
        return {statement.name}
    return _names(statement, ast.Store)


def _drawn(cell: Cell) -> str:
    """Read what the pictures of an exercise show, in their order, where a run has left it.

    That is its stored output, or in a package, which has no outputs, what setup.py has kept of it.
    """
    if "drawn" in cell["metadata"]:
        return str(cell["metadata"].pop("drawn"))
    shown = "".join("".join(each["data"]["text/markdown"]) for each in cell["outputs"])
    found = re.search('data-drawn="([^"]*)"', shown)
    return html.unescape(found[1]) if found else ""


def _question(output: Cell) -> Cell:
    """Cut a stored output off before its answer box."""
    shown = "".join(output["data"]["text/markdown"]).split('<div class="chr-answer"')[0]
    words = output["data"]["text/plain"]
    return {**output, "data": {"text/markdown": f"{shown}\n</div>\n", "text/plain": words}}


def _empty(name: str) -> Cell:
    return {
        "cell_type": "code", "id": name, "metadata": {}, "source": "", "outputs": [],
        "execution_count": None,
    }  # fmt: skip
