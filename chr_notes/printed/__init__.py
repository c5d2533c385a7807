"""What each document prints, mistakes included, as SymPy objects with an id.

Nothing here is derived and nothing here is true because it is here: the ledger judges it.
"""

from chr_notes.printed import (
    dead_reckoning,
    dead_reckoning_claims,
    estimation,
    estimation_claims,
    euler,
    euler_claims,
    quaternions,
    quaternions_claims,
    sensors,
    sensors_claims,
    validation,
    validation_claims,
)
from chr_notes.printed.statement import Printed, Rotation

PRINTED: dict[str, tuple[Printed, ...]] = {
    "euler": euler.PRINTED,
    "quaternions": quaternions.PRINTED,
    "sensors": sensors.PRINTED,
    "estimation": estimation.PRINTED,
    "dead_reckoning": dead_reckoning.PRINTED,
    "validation": (*validation.PRINTED, *validation_claims.CLAIMS),
}
ADDITIONS: dict[str, tuple[Printed, ...]] = {
    "euler": euler_claims.ADDITIONS,
    "quaternions": quaternions_claims.ADDITIONS,
    "sensors": sensors_claims.ADDITIONS,
    "estimation": estimation_claims.ADDITIONS,
    "dead_reckoning": dead_reckoning_claims.ADDITIONS,
    "validation": validation_claims.ADDITIONS,
}
"""More claims of each document, which its chapter shows together at the end."""

DOCUMENTS: dict[str, tuple[Printed, ...]] = {
    name: (*printed, *ADDITIONS.get(name, ())) for name, printed in PRINTED.items()
}

BY_ID: dict[str, Printed] = {
    statement.id: statement for printed in DOCUMENTS.values() for statement in printed
}

__all__ = ["ADDITIONS", "BY_ID", "DOCUMENTS", "Printed", "Rotation"]
