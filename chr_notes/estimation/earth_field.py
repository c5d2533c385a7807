"""What is known of the Earth's magnetic field by a filter that takes heading from it."""

from dataclasses import dataclass

import numpy as np

from chr_notes._samples import horizontal, positive
from chr_notes.validation import part_down

TOLERANCE = 0.1
"""Of E, for all that holds a magnetometer out; by the true attitude it is exceeded in less than one
of 100 samples in motion, on three trials of the BROAD data set."""


@dataclass(frozen=True)
class EarthField:
    """What is known of the Earth's magnetic field, and when another field is not it.

    Parameters
    ----------
    reference
        Its horizontal part, north and east, any unit: (1, 0) counts yaw from magnetic north,
        (cos(declination), sin(declination)) from true north.
    length
        Its magnitude, in the unit of the readings. Without it, magnitude and part down are means
        over the readings themselves, and a field that stays different for as long as those have
        held, at most for `patience`, replaces them.
    down
        Its part down divided by its magnitude, the sine of the inclination; goes with `length`.
    tolerance
        A reading is held out while its magnitude is off by more than this part of it, or its part
        down, the factor E, by more than this part of the whole. A tenth is what iron left over
        by a calibration may do; a field that is off by a part e across the true one turns the
        heading by e over the cosine of the inclination, in radians.
    patience
        Seconds.

    Raises
    ------
    ValueError
        If the reference is zero, the length not positive, one of length and down is missing, the
        part down not from -1 to 1, or tolerance or patience not positive.

    See Also
    --------
    chr_notes.estimation.averaging.averaged_attitude

    Examples
    --------
    >>> EarthField(length=49.5, down=0.92).tolerance
    0.1
    """

    reference: tuple[float, float] = (1.0, 0.0)
    length: float | None = None
    down: float | None = None
    tolerance: float = TOLERANCE
    patience: float = 60.0

    def __post_init__(self) -> None:
        """Check the field."""
        horizontal("reference", self.reference)
        if (self.length is None) != (self.down is None):
            msg = f"expected length and down together, got {self.length} and {self.down}"
            raise ValueError(msg)
        if self.length is not None and self.down is not None:
            positive("length", self.length)
            part_down(self.down)
        positive("tolerance", self.tolerance)
        positive("patience", self.patience)

    def begin(self) -> tuple[float, float, float, float]:
        """Give what is known before the first reading: heading, length, part down, how well."""
        if self.length is None or self.down is None:
            return (0.0, 0.0, 0.0, 0.0)
        return (0.0, float(self.length), float(self.down), np.inf)
