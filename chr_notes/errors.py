"""Errors and warnings of the numeric functions."""


class GimbalLockWarning(UserWarning):
    """Some attitudes are at gimbal lock: roll was set to 0 and yaw carries the rest.

    In other sequences of turns than yaw, pitch, roll: the angle of the last turn about axes that
    turn along was set to 0, and that of the first one carries the rest.
    """


class CalibrationWarning(UserWarning):
    """Readings are not what they should be, and something was left out or taken for granted."""


class UnitWarning(UserWarning):
    """Readings are of a size that they cannot have in the unit in which they are expected."""


class GimbalLockError(ValueError):
    """Some attitudes are at gimbal lock, and the caller asked for an error.

    Parameters
    ----------
    indices
        Index of each attitude at the lock, over the leading axes.
    """

    def __init__(self, indices: tuple[tuple[int, ...], ...]) -> None:
        self.indices = indices
        super().__init__(
            f"expected attitudes off gimbal lock, got {len(indices)} at it, "
            f"the first at index {indices[0]}"
        )

    def __reduce__(self) -> tuple[type, tuple[object, ...]]:
        """Let it be pickled, so that it comes back from another process as it was."""
        return type(self), (self.indices,)
