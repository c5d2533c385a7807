"""Angles over time: what was estimated beside what was true."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib import pyplot as plt
from numpy.typing import ArrayLike, NDArray

from chr_notes.palette import DASHES, PALETTE
from chr_notes.plots.figure import line_style

ANGLES = (("roll", "x"), ("pitch", "y"), ("yaw", "z"))


def draw_angles(
    time: ArrayLike,
    estimates: Mapping[str, ArrayLike],
    truth: ArrayLike | None = None,
    *,
    shown: Sequence[str] = ("roll", "pitch", "yaw"),
    axes: Sequence[Any] | None = None,
) -> list[Any]:
    """Draw roll, pitch and yaw over time, one below the other, in degrees.

    A line breaks where its angle jumps by more than half a turn, from -180° to 180°.

    Parameters
    ----------
    time
        Seconds, shape (N,).
    estimates
        From the name of each estimate to roll, pitch, yaw in radians, shape (N, 3); at most four,
        told apart by the pattern of their lines.
    truth
        The true angles, drawn wide and pale below the estimates, shape (N, 3).
    shown
        Which of the angles.
    axes
        matplotlib axes, one for each shown angle; new ones are made without it.

    Returns
    -------
    list of Axes
        One for each shown angle.
    """
    if len(estimates) > len(DASHES):
        msg = f"estimates: expected at most {len(DASHES)}, got {len(estimates)}"
        raise ValueError(msg)
    if axes is None:
        size = (5.4, 0.6 + 1.5 * len(shown))
        _, made = plt.subplots(len(shown), 1, sharex=True, figsize=size, squeeze=False)
        axes = list(made[:, 0])
    seconds = np.asarray(time, dtype=np.float64)
    for name, panel in zip(shown, axes, strict=True):
        place = [angle for angle, _ in ANGLES].index(name)
        colour = PALETTE[ANGLES[place][1]].light
        if truth is not None:
            panel.plot(
                seconds, _degrees(truth, place), color=PALETTE["shade"].light, lw=4.5, label="truth"
            )
        for (label, estimate), line in zip(estimates.items(), DASHES, strict=False):
            panel.plot(
                seconds,
                _degrees(estimate, place),
                color=colour,
                lw=1.3,
                ls=line_style(line),
                label=label,
            )
        panel.set_ylabel(f"{name} (°)")
        panel.grid(color=PALETTE["line"].light, lw=0.6)
    axes[0].legend(
        loc="lower right", bbox_to_anchor=(1, 1), ncols=5, fontsize="small", frameon=False
    )
    axes[-1].set_xlabel("time (s)")
    return list(axes)


def _degrees(euler: ArrayLike, place: int) -> NDArray[np.float64]:
    """One angle in degrees, with NaN where it jumps, so that the line breaks."""
    degrees = np.degrees(np.asarray(euler, dtype=np.float64)[:, place])
    # Rounded far below what can be seen, so that a last bit does not make another figure.
    degrees = degrees.round(4)
    degrees[1:][np.abs(np.diff(degrees)) > 180] = np.nan  # noqa: PLR2004 (half a turn)
    return degrees
