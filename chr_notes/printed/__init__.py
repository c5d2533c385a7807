"""What each document prints, mistakes included, as SymPy objects with an id.

Nothing here is derived and nothing here is true because it is here: the ledger judges it.
"""

from chr_notes.printed import (
    dead_reckoning,
    estimation,
    euler,
    euler_claims,
    quaternions,
    quaternions_claims,
    sensors,
    validation,
)
from chr_notes.printed.statement import Printed, Rotation

TOPICS = {
    "euler": euler,
    "quaternions": quaternions,
    "sensors": sensors,
    "estimation": estimation,
    "dead_reckoning": dead_reckoning,
    "validation": validation,
}
ADDITIONS: dict[str, tuple[Printed, ...]] = {
    "euler": euler_claims.ADDITIONS,
    "quaternions": quaternions_claims.ADDITIONS,
}
"""More claims of each document, which its chapter shows together at the end."""

DOCUMENTS: dict[str, tuple[Printed, ...]] = {
    name: (*topic.PRINTED, *ADDITIONS.get(name, ())) for name, topic in TOPICS.items()
}

BY_ID: dict[str, Printed] = {
    statement.id: statement for printed in DOCUMENTS.values() for statement in printed
}

__all__ = ["ADDITIONS", "BY_ID", "DOCUMENTS", "Printed", "Rotation"]
