"""What each document prints, mistakes included, as SymPy objects with an id.

Nothing here is derived and nothing here is true because it is here: the ledger judges it.
"""

from chr_notes.printed import dead_reckoning, estimation, euler, quaternions, sensors, validation
from chr_notes.printed.statement import Printed, Rotation

DOCUMENTS: dict[str, tuple[Printed, ...]] = {
    "euler": euler.PRINTED,
    "quaternions": quaternions.PRINTED,
    "sensors": sensors.PRINTED,
    "estimation": estimation.PRINTED,
    "dead_reckoning": dead_reckoning.PRINTED,
    "validation": validation.PRINTED,
}

__all__ = ["DOCUMENTS", "Printed", "Rotation"]
