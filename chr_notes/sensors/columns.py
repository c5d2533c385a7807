"""Which columns of a log hold which quantity: given, or found by their names."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import cast

from chr_notes.sensors.column_names import (
    BRACKETS,
    QUANTITIES,
    SENSORS,
    Meaning,
    meaning,
    unit_of,
)

Given = Mapping[str, str | int | Sequence[str | int] | None]


@dataclass(frozen=True)
class Selected:
    """Columns of a log that hold one quantity.

    Parameters
    ----------
    places
        Of the columns, counted from 0: one, or three for x, y and z.
    unit
        As `UNITS` calls it, or None where the names do not tell.
    """

    places: tuple[int, ...]
    unit: str | None


def select(names: Sequence[str], given: Given | None = None) -> dict[str, Selected]:
    """Find the columns of each quantity.

    Parameters
    ----------
    names
        Of the columns, in order.
    given
        Of a quantity, the columns by name or by number from 0: one for time and temperature, else
        three; None leaves it out. What is not given is found by the names.

    Returns
    -------
    dict
        For each quantity that there is, its columns.

    Raises
    ------
    ValueError
        If no sensor is found, an axis is missing, two columns claim to be the same, or units
        within a quantity differ.
    """
    given = given or {}
    if unknown := [*given.keys() - QUANTITIES.keys()]:
        msg = f"columns: expected quantities of {[*QUANTITIES]}, got {unknown[0]!r}"
        raise ValueError(msg)
    told = [meaning(name) for name in names]
    result = {}
    for quantity in QUANTITIES:
        if quantity in given:
            places = _given(quantity, given[quantity], names)
        else:
            places = _found(quantity, told, names)
        if not places:
            continue
        units = {_unit(quantity, names[place], told[place]) for place in places}
        if len(units) > 1:
            labels = [names[place] for place in places]
            msg = f"{quantity}: expected one unit for all three axes, got the columns {labels}"
            raise ValueError(msg)
        result[quantity] = Selected(tuple(places), units.pop())
    _refuse_shared(names, {each: result[each].places for each in result if each in given})
    if result.keys().isdisjoint(SENSORS):
        msg = (
            "expected columns such as 'ax', 'acc_y' or 'Gyroscope Z (deg/s)', "
            f"got {[*names]!r:.200}; pass columns={{'accel': (three names), ...}}"
        )
        raise ValueError(msg)
    return result


def _refuse_shared(names: Sequence[str], given: Mapping[str, tuple[int, ...]]) -> None:
    """Refuse a column that is given for two quantities."""
    for one, other in combinations(given, 2):
        for place in {*given[one]} & {*given[other]}:
            msg = f"columns: expected each once, got {names[place]!r} for {one} and {other}"
            raise ValueError(msg)


def _unit(quantity: str, name: str, told: Meaning | None) -> str | None:
    if told is not None and told.quantity == quantity:
        return told.unit
    return next(filter(None, (unit_of(quantity, text) for text in BRACKETS.findall(name))), None)


def _given(quantity: str, wanted: object, names: Sequence[str]) -> list[int]:
    """Find the columns that the caller names."""
    if wanted is None:
        return []
    each = [wanted] if isinstance(wanted, str | int) else [*cast("Iterable[object]", wanted)]
    count = 3 if quantity in SENSORS else 1
    if len(each) != count:
        msg = f"columns[{quantity!r}]: expected {count} columns, got {each!r:.100}"
        raise ValueError(msg)
    places = []
    for name in each:
        if isinstance(name, int) and 0 <= name < len(names):
            places.append(name)
        elif isinstance(name, str) and [*names].count(name.strip()) == 1:
            places.append([*names].index(name.strip()))
        else:
            msg = f"columns[{quantity!r}]: expected a column of {[*names]!r:.200}, got {name!r}"
            raise ValueError(msg)
    if len({*places}) < len(places):
        msg = f"columns[{quantity!r}]: expected {count} different columns, got {each!r:.100}"
        raise ValueError(msg)
    return places


def _found(quantity: str, told: Sequence[Meaning | None], names: Sequence[str]) -> list[int]:
    """Find the columns whose names tell."""
    of_axes: dict[str | None, list[int]] = {}
    for place, each in enumerate(told):
        if each is not None and each.quantity == quantity:
            of_axes.setdefault(each.axis, []).append(place)
    if quantity not in SENSORS:
        several = of_axes.get(None, [])
        # Of several times the one at which the sample was taken.
        return sorted(several, key=lambda place: "stamp" not in names[place].lower())[:1]
    of_axes.pop(None, None)
    if not of_axes:
        return []
    for axes in ("xyz", "012", "123"):
        if {*axes} == of_axes.keys():
            break
    else:
        labels = [names[place] for places in of_axes.values() for place in places]
        msg = (
            f"{quantity}: expected columns for x, y and z, got {labels}; "
            f"pass columns={{{quantity!r}: (three names)}}, or None to leave it out"
        )
        raise ValueError(msg)
    for axis in axes:
        if len(of_axes[axis]) > 1:
            labels = [names[place] for place in of_axes[axis]]
            msg = (
                f"{quantity}: expected one column for {axis}, got {labels}; "
                f"pass columns={{{quantity!r}: (three names)}}, or None to leave it out"
            )
            raise ValueError(msg)
    return [of_axes[axis][0] for axis in axes]
