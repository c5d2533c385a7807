"""Forms of the models of calibration."""

from sympy import ImmutableMatrix, eye, symbols

from chr_notes.derivations import calibration
from chr_notes.derivations.computation import Computation, Let


def measured(offset: ImmutableMatrix | None = None) -> Computation:
    """Measure a vector: first along the sensor's own axes, then along those of its casing.

    Parameters
    ----------
    offset
        What else is added to the reading, 3 by 1; nothing by default.
    """
    reading = calibration.measured() if offset is None else calibration.measured(offset)
    names = symbols("own_x own_y own_z", real=True)
    aligned = dict(zip(calibration.MISALIGNMENT, eye(3), strict=True))
    return Computation(
        tuple(
            Let(name, value.xreplace(aligned)) for name, value in zip(names, reading, strict=True)
        ),
        ImmutableMatrix(calibration.MISALIGNMENT * ImmutableMatrix(names)),
    )
