"""LaTeX of a formula, taken apart into terms and factors in their order.

Just enough to compare how a document prints a formula with how the ledger typesets it. What is
only layout comes out the same: a fraction and a slash, kinds of brackets, bold letters, spaces,
`c(x)` for `\\cos x`.
"""

import re
from typing import Any

Tree = Any  # a name, or a tuple of trees with what they make in front

SPELLINGS = (
    (r"\\nu ?1|v_1", "v1"),
    (r"\\nu ?2|v_2", "v2"),
    (r"(?<![a-z\\])([cs])\((?=\\)", lambda found: f"{FUNCTION[found[1]]}("),
    (r"\b([CS])_(?=\\)", lambda found: f"{FUNCTION[found[1].lower()]} "),
    (r"\\sin\^\{-1\}", r"\\arcsin"),
    (r"\\(?:mathrm|text)\{atan2\}", r"\\atan"),
    (r"\\math(?:bf|rm)\{(\w+)\}", r"\1"),
    (r"\\mathbf([a-z])", r"\1"),
    (r"R_i\^\{bT\}", "(R_i^b)^T"),
    (r"\{([SR]_\w)\}\(T\)\^\{-1\}", r"\1^{-1}(T)"),
    (r"\\(?:left|right|quad)(?![a-z])|\\[,;]|(?<!\\)\\ ", " "),
    (r"\\(?:begin|end)\{aligned\}", ""),
    (r"\\\\\s*&(?=\s*[=+])|&(?==)", ""),
    (r"\{\}=", "="),
    (r"\\(begin|end)\{[bp]matrix\}", r"\\\1 "),
    (r"\|(.*)\|", r"\\abs(\1)"),
)
FUNCTION = {"c": r"\cos", "s": r"\sin"}
FUNCTIONS = {
    rf"\{name}"
    for name in ["sin", "cos", "tan", "sec", "arcsin", "arccos", "arctan", "atan", "sqrt", "abs"]
}
TOKEN = re.compile(r"\\\\|\\[a-zA-Z]+|\\_|\d+(?:\.\d+)?|\[k(?:\+1)?\]|\S")
RELATION = re.compile(r"(=|\\approx|\\Rightarrow)")
ENDS = {")", "}", "&", "\\\\", r"\end", ",", "+", "-", ""}
POWERS = {"2", "-1", "T", "*"}


def relations(latex: str) -> list[Tree]:
    """Take a statement apart: trees with the signs of relation between them."""
    for pattern, spelling in SPELLINGS:
        # The brackets first: other spellings look at what stands beside them.
        latex = re.sub(r"\\(left|right)(?=[()|])", "", latex)
        latex = re.sub(pattern, spelling, latex)
    parts = [part.strip() for part in RELATION.split(latex)]
    while parts[0] in ("", r"\Rightarrow"):
        parts = parts[1:]
    return [part if RELATION.fullmatch(part) else Terms(part).whole() for part in parts]


class Terms:
    """A reader of one side."""

    def __init__(self, latex: str) -> None:
        self.pieces = [*TOKEN.findall(latex), ""]

    def whole(self) -> Tree:
        tree = self.sum()
        assert self.pieces == [""], f"left over: {self.pieces}"
        return tree

    def next(self, expected: str | None = None) -> str:
        piece = self.pieces.pop(0)
        assert expected is None or piece == expected, f"expected {expected}, got {piece}"
        return piece

    def sum(self) -> Tree:
        terms = []
        while not terms or self.pieces[0] in ("+", "-"):
            sign = self.next() if self.pieces[0] in ("+", "-") else "+"
            negative, above, below = self.product()
            terms.append(((sign == "-") != negative, above, below))
        alone = terms[0]
        if len(terms) == 1 and not alone[0] and not alone[2] and len(alone[1]) == 1:
            return alone[1][0]
        return ("sum", *terms)

    def product(self) -> tuple[bool, tuple[Tree, ...], tuple[Tree, ...]]:
        negative, above, below = False, [], []
        while self.pieces[0] not in ENDS:
            if self.pieces[0] == "/":
                self.next()
                below += [self.factor()]
                continue
            minus, more, less = factors(self.factor())
            negative, above, below = negative != minus, [*above, *more], [*below, *less]
        return negative, tuple(name for name in above if name != "1") or ("1",), tuple(below)

    def group(self) -> Tree:
        if self.pieces[0] != "{":
            return self.factor()
        self.next("{")
        inner = self.sum()
        self.next("}")
        return inner

    def factor(self) -> Tree:
        piece = self.next()
        if piece in FUNCTIONS:
            return (piece, self.group())
        if piece == r"\frac":
            over, under = factors(self.group()), factors(self.group())
            return ("sum", (over[0] != under[0], (*over[1], *under[2]), (*over[2], *under[1])))
        if piece == r"\begin":
            return self.matrix()
        if piece in ("(", "{"):
            inner = [self.sum()]
            while self.pieces[0] == ",":
                self.next()
                inner.append(self.sum())
            self.next({"(": ")", "{": "}"}[piece])
            tree = inner[0] if len(inner) == 1 else tuple(inner)
            return self.scripts(tree)
        if piece in (r"\hat", r"\dot"):
            return self.scripts(f"{piece} {self.name()}")
        return self.scripts(piece)

    def scripts(self, base: Tree) -> Tree:
        below, above, power = "", "", ""
        while self.pieces[0] in ("_", "^", "'"):
            which = self.next()
            text = "'" if which == "'" else self.name()
            if which == "_":
                below = text
            elif text in POWERS:
                power = text
            else:
                above += text
        if below or above:
            assert isinstance(base, str), (
                f"expected one of POWERS of tests/printed/terms.py beside a bracket, "
                f"got {above or below!r}"
            )
            base = f"{base}_{below}^{above}"
        return (f"to the {power}", base) if power else base

    def name(self) -> str:
        """Read what stands above or below a letter, as text."""
        if self.pieces[0] != "{":
            return self.next()
        depth, text = 0, ""
        while True:
            piece = self.next()
            depth += (piece == "{") - (piece == "}")
            text += piece if piece not in ("{", "}") else ""
            if depth == 0:
                return text

    def matrix(self) -> Tree:
        rows: list[list[Tree]] = [[self.sum()]]
        while (piece := self.next()) != r"\end":
            if piece == "&":
                rows[-1].append(self.sum())
            else:
                assert piece == "\\\\"
                rows.append([self.sum()])
        tree = self.scripts("matrix")
        if tree != "matrix":
            rows = [list(column) for column in zip(*rows, strict=True)]
        return ("matrix", *map(tuple, rows))


def factors(tree: Tree) -> tuple[bool, list[Tree], list[Tree]]:
    """Take what stands in brackets or over a line into the product around it, if it is one."""
    if isinstance(tree, tuple) and tree[0] == "sum" and len(tree) == 2:
        negative, above, below = tree[1]
        return negative, list(above), list(below)
    return False, [tree], []
