"""What each document prints, mistakes included, as SymPy objects with an id.

Nothing here is derived and nothing here is true because it is here: the ledger judges it.
"""

from chr_notes.printed import (
    dead_reckoning,
    estimation,
    euler,
    quaternions,
    quaternions_claims,
    sensors,
    validation,
)
from chr_notes.printed.statement import Printed, Rotation

DOCUMENTS: dict[str, tuple[Printed, ...]] = {
    "euler": euler.PRINTED,
    "quaternions": (*quaternions.PRINTED, *quaternions_claims.ADDITIONS),
    "sensors": sensors.PRINTED,
    "estimation": estimation.PRINTED,
    "dead_reckoning": dead_reckoning.PRINTED,
    "validation": validation.PRINTED,
}

BY_ID: dict[str, Printed] = {
    statement.id: statement for printed in DOCUMENTS.values() for statement in printed
}

__all__ = ["BY_ID", "DOCUMENTS", "Printed", "Rotation"]
