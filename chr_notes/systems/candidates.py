"""What the detective tries: the readings of each kind of numbers, the simplest first."""

from itertools import permutations
from typing import Any

from chr_notes.sequences import SEQUENCES
from chr_notes.systems.convention import DOCUMENTED, PRESETS

Fields = dict[str, Any]
"""Some fields of a convention."""
PLAIN = ("xyz", "ZYX", *(name for name in SEQUENCES if name not in ("xyz", "ZYX")))
FIELDS: dict[str, tuple[Fields, ...]] = {
    "angles": tuple({"sequence": s, "degrees": d} for d in (False, True) for s in PLAIN),
    "matrix": ({"matrix": "to body"}, {"matrix": "to navigation"}),
    "quaternion": tuple(
        {"scalar_first": first, "quaternion": way}
        for first in (True, False)
        for way in ("to navigation", "to body")
    ),
    "vectors": ({"vectors": "to body"}, {"vectors": "to navigation"}),
    "accel": ({"accelerometer": -1}, {"accelerometer": 1}),
}
# Three different axes have six orders to be written in, of which two are those of a sequence.
REORDERED: tuple[Fields, ...] = tuple(
    {"sequence": s, "written": "".join(order), "degrees": d}
    for d in (False, True)
    for s in PLAIN
    if s.isupper() and s[0] != s[2]
    for order in permutations("xyz")
    if "".join(order) not in (s.lower(), s[::-1].lower())
)
SIGNED: tuple[Fields, ...] = tuple(
    {"sequence": each.sequence, "written": each.written, "negated": each.negated, "degrees": d}
    for d in (False, True)
    for each in (PRESETS | DOCUMENTED).values()
    if each.negated
)
"""Angles of known systems that count against the rule of the hand."""
NAMED: tuple[Fields, ...] = (
    {"matrix": "to body"},
    *({"scalar_first": first, "quaternion": "to navigation"} for first in (True, False)),
)
"""Those of a kind that may be the first, where its direction is but a name."""
KEPT = 0.25
"""Share of the tolerance below which one error is as good as another."""
