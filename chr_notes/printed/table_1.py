"""Table 1 of "Using Accelerometers to Estimate Position and Velocity", as printed."""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from sympy import Symbol


@dataclass(frozen=True)
class Column:
    """One column of the table.

    Parameters
    ----------
    quantity
        The LaTeX symbol of the error.
    seconds
        After which time, zero where time does not matter.
    time
        The time as printed, LaTeX.
    means
        The error and its time in words.
    """

    quantity: str
    seconds: int
    time: str
    means: str


COLUMNS: Mapping[str, Column] = MappingProxyType(
    {
        "acceleration": Column("a", 0, "", "acceleration, m/s²"),
        "velocity_10s": Column("v", 10, r"10\,\mathrm{s}", "velocity after 10 s, m/s"),
        "position_10s": Column("r", 10, r"10\,\mathrm{s}", "position after 10 s, m"),
        "position_1min": Column("r", 60, r"1\,\mathrm{min}", "position after 1 minute, m"),
        "position_10min": Column("r", 600, r"10\,\mathrm{min}", "position after 10 minutes, m"),
        "position_1h": Column("r", 3600, r"1\,\mathrm{h}", "position after 1 hour, m"),
    }
)

ROWS: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "0.1": ("0.017", "0.17", "1.7", "61.2", "6120", "220 e 3"),
        "0.5": ("0.086", "0.86", "8.6", "309.6", "30960", "1.1 e 6"),
        "1.0": ("0.17", "1.7", "17", "612", "61200", "2.2 e 6"),
        "1.5": ("0.256", "2.56", "25.6", "921.6", "92160", "3.3 e 6"),
        "2.0": ("0.342", "3.42", "34.2", "1231.2", "123120", "4.4 e 6"),
        "3.0": ("0.513", "5.13", "51.3", "1846.8", "184680", "6.6 e 6"),
        "5.0": ("0.854", "8.54", "85.4", "3074.4", "307440", "11 e 6"),
    }
)


@dataclass(frozen=True)
class Cell:
    """One number of the table, with the degrees of its row and the name of its column."""

    degrees: str
    column: str
    number: str

    @property
    def quantity(self) -> Symbol:
        """The error that the number is given for."""
        return error(self.column, self.degrees)

    @property
    def means(self) -> str:
        """The error in words."""
        return COLUMNS[self.column].means


def error(column: str, degrees: str) -> Symbol:
    """Name the error of a column that so many degrees make."""
    of = COLUMNS[column]
    arguments = rf"{degrees}^{{\circ}}" + (f", {of.time}" if of.time else "")
    return Symbol(rf"\Delta {of.quantity}\left({arguments}\right)", real=True)


CELLS = tuple(
    Cell(degrees, column, number)
    for degrees, numbers in ROWS.items()
    for column, number in zip(COLUMNS, numbers, strict=True)
)
