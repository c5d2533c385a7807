"""How an error grows with time."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib import pyplot as plt
from numpy.typing import ArrayLike

from chr_notes.palette import DASHES, PALETTE
from chr_notes.plots.figure import line_style


def draw_growth(
    time: ArrayLike,
    errors: Mapping[str, ArrayLike],
    unit: str,
    *,
    expected: ArrayLike | None = None,
    axes: Any = None,  # noqa: ANN401 (matplotlib is untyped)
) -> Any:  # noqa: ANN401
    """Draw magnitudes of errors over time, each line with its name at its end.

    Parameters
    ----------
    time
        Seconds, shape (N,).
    errors
        From a name to an error, shape (N,), of which the magnitude is drawn; at most four.
    unit
        Of the errors, for the label of the axis.
    expected
        What theory says, drawn wide and pale below, shape (N,).
    axes
        matplotlib axes; new ones are made without it. On logarithmic ones growth by a power of
        time is a straight line.

    Returns
    -------
    Axes
    """
    if len(errors) > len(DASHES):
        msg = f"errors: expected at most {len(DASHES)}, got {len(errors)}"
        raise ValueError(msg)
    if axes is None:
        axes = plt.subplots(figsize=(5.4, 3.4))[1]
    seconds = np.asarray(time, dtype=np.float64)
    if expected is not None:
        axes.plot(seconds, np.abs(expected), color=PALETTE["shade"].light, lw=4.5, label="expected")
    for (label, error), line in zip(errors.items(), DASHES, strict=False):
        axes.plot(
            seconds, np.abs(error), color=PALETTE[line].light, lw=1.4, ls=line_style(line),
            label=label,
        )  # fmt: skip
    axes.set_xlabel("time (s)")
    axes.set_ylabel(f"error ({unit})")
    axes.grid(color=PALETTE["line"].light, lw=0.6)
    axes.legend(fontsize="small")
    return axes
