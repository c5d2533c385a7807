"""The columns of a log as numbers, from a table or a mapping of arrays."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Protocol, cast

import numpy as np
from numpy.typing import NDArray

from chr_notes._arrays import Floats
from chr_notes.sensors.column_names import SENSORS
from chr_notes.sensors.columns import Given, select
from chr_notes.sensors.log_numbers import number
from chr_notes.sensors.log_table import LARGEST, Table


class Arrays(Protocol):
    """What gives a column by its name: a mapping, a DataFrame, an array with names."""

    def __getitem__(self, name: Any, /) -> Any:  # noqa: ANN401 (whatever the table's columns are)
        """Give a column."""


def names_of(source: object) -> list[Any] | None:
    """Give the names of the columns, or None for what has none."""
    if isinstance(source, Mapping):
        return [*source]
    named = getattr(source, "columns", None)
    if named is None:
        named = getattr(getattr(source, "dtype", None), "names", None)
    return None if named is None else [*cast("Iterable[Any]", named)]


def read_arrays(source: Arrays, keys: Sequence[Any], columns: Given | None) -> Table:
    """Read a table or a mapping of arrays.

    Raises
    ------
    ValueError
        If a column that is read holds anything but numbers, or columns differ in length.
    """
    names: list[str] = []
    arrays: list[tuple[Any, int | None]] = []
    for key in keys:
        shape = np.shape(source[key])
        if shape[1:] == (3,):
            names += [f"{key}.{axis}" for axis in "xyz"]
            arrays += [(key, axis) for axis in range(3)]
        else:
            names.append(str(key))
            arrays.append((key, None))
    selected = select(names, columns)
    values: dict[str, Floats] = {}
    for quantity, each in selected.items():
        read = []
        for place in each.places:
            key, axis = arrays[place]
            column = source[key] if axis is None else np.asarray(source[key])[:, axis]
            read.append(_column(names[place], column, quantity))
        lengths = {len(column) for column in read}
        lengths |= {len(other) for other in values.values()}
        if len(lengths) > 1:
            name = names[each.places[0]]
            msg = f"column {name!r}: expected as many rows as in others, got {sorted(lengths)}"
            raise ValueError(msg)
        values[quantity] = np.stack(read, axis=1)
    return Table(values, selected, tuple(names), lambda row: f"row {row}", (), ())


def _column(name: str, value: Any, quantity: str) -> Floats:  # noqa: ANN401 (of any table)
    """Take one column as numbers, counted from the first for times of many digits."""
    mask = np.ma.getmaskarray(value) if isinstance(value, np.ma.MaskedArray) else None
    array: NDArray[Any] = np.asarray(value)
    if array.ndim != 1:
        msg = f"column {name!r}: expected shape (N,) or (N, 3), got {array.shape}"
        raise ValueError(msg)
    if array.dtype.kind == "M" and quantity == "time":
        numbers = _dates(array)
    elif array.dtype.kind in "iu" and quantity == "time" and len(array):
        # In whole numbers: a double does not hold nanoseconds since 1970.
        numbers = np.array(
            [float(each) for each in (array.astype(object) - int(array[0])).tolist()]
        )
    elif array.dtype.kind in "biuf":
        numbers = np.array(array, dtype=np.float64)
    else:
        numbers = np.array([_number(name, row, each) for row, each in enumerate(array.tolist())])
    if mask is not None:
        numbers[mask] = np.nan
    wrong = np.isinf(numbers) | ((np.abs(numbers) > LARGEST) & (quantity in SENSORS))
    if wrong.any():
        row = int(np.argmax(wrong))
        msg = f"row {row}, column {name!r}: expected a reading, got {numbers[row]:g}"
        raise ValueError(msg)
    return np.asarray(numbers, dtype=np.float64)


def _dates(array: NDArray[Any]) -> Floats:
    """Count seconds from the first date."""
    since = (array - array[:1]).astype("timedelta64[ns]")
    return np.where(np.isnat(since), np.nan, since.astype(np.int64) * 1e-9)


def _number(name: str, row: int, value: object) -> float:
    """Read what stands in a column of objects: numbers, text, and what is missing."""
    try:
        return number("" if value is None else str(value))
    except ValueError as error:
        msg = f"row {row}, column {name!r}: {error}"
        raise ValueError(msg) from None
