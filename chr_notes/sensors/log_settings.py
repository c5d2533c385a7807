"""What the caller of `read_log` gives, and what there is to say while a log is read."""

from dataclasses import dataclass, field

from chr_notes._arrays import Floats
from chr_notes.sensors.log_table import Table
from chr_notes.sensors.log_units import FACTORS, Unit


@dataclass(frozen=True)
class Settings:
    """What the caller of `read_log` gives, checked."""

    units: dict[str, Unit]
    axes: dict[str, Floats]
    rate: float | None
    full_range: dict[str, float]
    gravity: float
    level: bool
    refuse: bool


@dataclass
class Said:
    """What there is to say, while a log is read."""

    refuse: bool
    units: dict[str, str] = field(default_factory=dict)
    assumed: list[str] = field(default_factory=list)
    cannot_tell: list[str] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)

    def contradiction(self, what: str) -> None:
        """Refuse, or warn if that is wanted."""
        if self.refuse:
            raise ValueError(what) from None
        self.warnings.append(what)


@dataclass(frozen=True)
class Rest:
    """Where the accelerometer hardly varies: mean readings of blocks, and which they are."""

    means: Floats
    blocks: list[int]
    width: int


def known_unit(table: Table, settings: Settings, quantity: str) -> Unit | None:
    """Give the unit that is given, or else told by the names."""
    if quantity in settings.units:
        return settings.units[quantity]
    name = table.selected[quantity].unit
    if name is None:
        return None
    return Unit(name, FACTORS.get(quantity, {}).get(name), "told")
