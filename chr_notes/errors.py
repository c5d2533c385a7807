"""Errors and warnings of the numeric functions."""


class GimbalLockWarning(UserWarning):
    """Some attitudes are at gimbal lock: roll was set to 0 and yaw carries the rest.

    In other sequences of turns than yaw, pitch, roll: the angle of the last turn about axes that
    turn along was set to 0, and that of the first one carries the rest.

    See Also
    --------
    GimbalLockError
    chr_notes.euler.euler_from_matrix

    Examples
    --------
    >>> import warnings
    >>> import chr_notes
    >>> with warnings.catch_warnings(record=True) as caught:
    ...     warnings.simplefilter("always")
    ...     angles = chr_notes.euler_from_matrix([[0, 0, -1], [0, 1, 0], [1, 0, 0]])
    >>> caught[0].category.__name__
    'GimbalLockWarning'
    """


class CalibrationWarning(UserWarning):
    """Readings are not what they should be, and something was left out or taken for granted.

    See Also
    --------
    chr_notes.sensors.magnetometer.fit_magnetometer
    """


class UnitWarning(UserWarning):
    """Readings are of a size that they cannot have in the unit in which they are expected.

    See Also
    --------
    chr_notes.sensors.logs.read_log

    Examples
    --------
    >>> import warnings
    >>> import chr_notes
    >>> with warnings.catch_warnings(record=True) as caught:
    ...     warnings.simplefilter("always")
    ...     angles = chr_notes.integrate_gyro([[0.0, 0.0, 200.0]] * 100, 0.01)  # in °/s
    >>> caught[0].category.__name__
    'UnitWarning'
    """


class GimbalLockError(ValueError):
    """Some attitudes are at gimbal lock, and the caller asked for an error.

    Parameters
    ----------
    indices
        Index of each attitude at the lock, over the leading axes.

    See Also
    --------
    GimbalLockWarning
    chr_notes.euler.euler_from_matrix

    Examples
    --------
    >>> import numpy as np
    >>> import chr_notes
    >>> nose_up = [[0, 0, -1], [0, 1, 0], [1, 0, 0]]
    >>> try:
    ...     chr_notes.euler_from_matrix([nose_up, np.eye(3)], on_gimbal_lock="raise")
    ... except chr_notes.GimbalLockError as error:
    ...     error.indices
    ((0,),)
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
