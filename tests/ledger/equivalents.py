"""Changes that look like misprints and are none, each with the reason.

The test proves each one: what the print says with it is still what the ledger says of it.
"""

RENAMED = "the elements of any quaternion are called otherwise, on both sides"

EQUIVALENT: dict[tuple[str, str], str] = {
    **{("quaternions.3.a", f"swapped symbols, throughout {n}"): RENAMED for n in range(1, 7)},
    ("quaternions.4.c", "swapped symbols, throughout 1"): "what differs, differs both ways",
}
