"""The axes of a log: given, or found from how the sensors turn together and where up is."""

import re
from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats, floats
from chr_notes.frames import Axes as Named
from chr_notes.frames import change_axes
from chr_notes.sensors.column_names import SENSORS

Axes = str | ArrayLike

_NAMES = ("frd", "flu", "rfu")
_SLANTED = 0.7  # cosine: the vertical axis of a level sensor is nearer to the vertical


def matrix_of(name: str, axes: Axes) -> Floats:
    """Give the matrix from the axes of a log to forward-right-down.

    Raises
    ------
    ValueError
        If it is neither a name, nor a signed permutation, nor an orthogonal matrix.
    """
    if isinstance(axes, str):
        if axes.lower() in _NAMES:
            source: Named = axes.lower()  # type: ignore[assignment]
            return change_axes(np.eye(3), source, "frd").T
        words = re.fullmatch(r"\s*([+-]?[xyz])[\s,]+([+-]?[xyz])[\s,]+([+-]?[xyz])\s*", axes)
        if words and {word[-1] for word in words.groups()} == {*"xyz"}:
            signs = [-1.0 if word[0] == "-" else 1.0 for word in words.groups()]
            return np.diag(signs)[:, ["xyz".index(word[-1]) for word in words.groups()]]
    else:
        matrix = floats(name, axes, 3, 3)
        if matrix.ndim == 2 and np.allclose(matrix @ matrix.T, np.eye(3), atol=1e-4):  # noqa: PLR2004
            return matrix
    msg = (
        f"{name}: expected one of {[*_NAMES]}, three axes such as '-y x z' or an orthogonal "
        f"matrix, got {axes!r:.100}"
    )
    raise ValueError(msg)


def named(matrix: Floats) -> str:
    """Say a signed permutation as three axes; another matrix as its numbers."""
    if not np.allclose(np.abs(matrix).max(axis=1), 1):
        return str(matrix.round(4).tolist())
    places = np.abs(matrix).argmax(axis=1)
    return " ".join(
        ("-" if row[place] < 0 else "") + "xyz"[place]
        for row, place in zip(matrix, places, strict=True)
    )


def given_axes(axes: Axes | Mapping[str, Axes] | None) -> dict[str, Floats]:
    """Read the axes that the caller gives: of "all", or of single sensors."""
    if axes is None:
        return {}
    each = axes if isinstance(axes, Mapping) else {"all": axes}
    if unknown := [*each.keys() - {"all", *SENSORS}]:
        msg = f"axes: expected sensors of {['all', *SENSORS]}, got {unknown[0]!r}"
        raise ValueError(msg)
    matrices = {name: matrix_of(f"axes[{name!r}]", value) for name, value in each.items()}
    if "all" in matrices and np.linalg.det(matrices["all"]) < 0:
        msg = (
            f"axes: expected right-handed ones, got {named(matrices['all'])}; pass a mirrored "
            "sensor by itself, such as axes={'accel': '-x -y -z'}"
        )
        raise ValueError(msg)
    return matrices


def turn(values: Floats, matrix: Floats) -> None:
    """Turn vectors where they stand."""
    order, permuted = np.abs(matrix).argmax(axis=1), np.abs(matrix).max(axis=1)
    signs = matrix[range(3), order]
    for start in range(0, len(values), 2**14):
        part = values[start : start + 2**14]
        # Matrices of three by three take NumPy several times longer than columns.
        part[:] = part[:, order] * signs if (permuted == 1).all() else part @ matrix.T
        part += 0.0  # no minus zeros


def levelled(up: Floats) -> tuple[Floats | None, bool]:
    """Tell the axes of a log by the specific force of a level sensor.

    Parameters
    ----------
    up
        Mean specific force at rest, shape (3,).

    Returns
    -------
    matrix, level : ndarray or None, bool
        From the axes of the log to forward-right-down, None where z is not near the vertical; and
        whether it is.
    """
    cosine = float(up[2] / max(np.linalg.norm(up), 1e-12))
    if cosine > _SLANTED:
        return np.diag([1.0, -1.0, -1.0]), True
    return (np.eye(3), True) if cosine < -_SLANTED else (None, False)
