"""The contract at the pole, which all routes to Euler angles share."""

import warnings
from typing import Literal, get_args

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats
from chr_notes._rows import Rows
from chr_notes.errors import GimbalLockError, GimbalLockWarning

OnGimbalLock = Literal["warn", "ignore", "raise"]
_CHOICES = get_args(OnGimbalLock)
_ROLL = "roll is set to 0 and yaw carries the rest"
_LAST = "the angle of the last turn is set to 0 and that of the first carries the rest"


def with_lock(
    function: Rows,
    given: ArrayLike,
    on_gimbal_lock: OnGimbalLock,
    out: Floats | None,
    turns: Floats | None = None,
) -> Floats:
    """Compute Euler angles; warn of attitudes at gimbal lock, or raise, or keep silent.

    Parameters
    ----------
    function
        Computes them.
    given
        The attitudes.
    on_gimbal_lock
        "warn", "ignore" or "raise".
    out
        For the angles.
    turns
        Axes of the three turns, for a function that takes them.

    Raises
    ------
    ValueError
        If the choice is none of the three.
    GimbalLockError
        If attitudes are at gimbal lock and the choice is "raise".
    """
    if on_gimbal_lock not in _CHOICES:
        msg = f"on_gimbal_lock: expected one of {_CHOICES}, got {on_gimbal_lock!r}"
        raise ValueError(msg)
    raises = on_gimbal_lock == "raise"
    arguments = (given,) if turns is None else (given, turns)
    euler, locked = function.located(arguments, out, every_place=raises)
    if not locked.count or on_gimbal_lock == "ignore":
        return euler
    leading = euler.shape[:-1]
    # NumPy knows no places in a shape without axes.
    axes = np.array(np.unravel_index(locked.places, leading or (1,)))[: len(leading)]
    places = tuple(map(tuple, axes.T.tolist()))
    if raises:
        raise GimbalLockError(places)
    message = (
        f"{locked.count} attitude(s) at gimbal lock, the first at index {places[0]}: "
        f"{_ROLL if turns is None else _LAST}"
    )
    # The caller of the public function that calls this one.
    warnings.warn(message, GimbalLockWarning, stacklevel=3)
    return euler
