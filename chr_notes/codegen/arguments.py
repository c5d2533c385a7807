"""Arguments of the generated functions: name, symbol in the derivation, meaning and unit."""

from collections.abc import Iterable, Sequence

from sympy import ImmutableMatrix, Symbol

from chr_notes.codegen.target import Argument
from chr_notes.derivations import calibration, dead_reckoning, estimation, validation
from chr_notes.derivations.averaging import speed
from chr_notes.derivations.forms import averaging, gains, heading, monitor, rest
from chr_notes.derivations.forms.dead_reckoning import NEXT as ACCELERATION_AFTER
from chr_notes.derivations.forms.euler import ANGLE as WRAPPED
from chr_notes.derivations.quaternions import MATRIX as ELEMENTS
from chr_notes.symbols import (
    ACCELEROMETER,
    AXIS,
    BODY_RATES,
    EULER,
    EULER_RATES,
    FIRST,
    MAGNETOMETER,
    QUATERNION,
    SECOND,
    VECTOR,
    T,
    alpha,
    g,
)

_ANGLES = (
    ("roll", "roll about the body x-axis, radians"),
    ("pitch", "pitch about the vehicle-1 y-axis, radians"),
    ("yaw", "yaw about the inertial z-axis, radians"),
)
ROLL, PITCH, YAW = ANGLES = tuple(
    Argument(name, symbol, says) for symbol, (name, says) in zip(EULER, _ANGLES, strict=True)
)
RATES = tuple(
    Argument(name, symbol, f"body rate about {axis}, rad/s")
    for symbol, name, axis in zip(BODY_RATES, "pqr", "xyz", strict=True)
)


def matrix(letter: str, symbols: ImmutableMatrix, says: str) -> tuple[Argument, ...]:
    """Elements of a matrix, row by row.

    Parameters
    ----------
    letter
        Start of their names, such as "r" for r11, r12 and so on.
    symbols
        The matrix in the derivation, 3 by 3.
    says
        What the matrix is.
    """
    return tuple(
        Argument(
            f"{letter}{row}{column}",
            symbols[row - 1, column - 1],
            f"row {row}, column {column} of {says}",
        )
        for row in (1, 2, 3)
        for column in (1, 2, 3)
    )


def axes(
    pattern: str, symbols: Iterable[Symbol], says: str, ways: Sequence[str] = "xyz"
) -> tuple[Argument, ...]:
    """One argument an axis: x, y, z, or what else the elements are called, such as north.

    Parameters
    ----------
    pattern
        Format of the name, such as "accel_{}".
    symbols
        Symbols in the derivation.
    says
        Format of the meaning and unit.
    ways
        What stands for {} in turn.
    """
    return tuple(
        Argument(pattern.format(way), symbol, says.format(way))
        for way, symbol in zip(ways, symbols, strict=True)
    )


ANGLE_RATES = axes("{}_rate", EULER_RATES, "derivative of {}, rad/s", ("roll", "pitch", "yaw"))
MATRIX = matrix("r", ELEMENTS, "the matrix from the inertial to the body frame")
_ELEMENTS = ("scalar part", "factor of i", "factor of j", "factor of k")
QUATERNION_ARGUMENTS = tuple(
    Argument(name, symbol, f"{says} of the attitude quaternion")
    for symbol, name, says in zip(QUATERNION, "abcd", _ELEMENTS, strict=True)
)
PRODUCT = tuple(
    Argument(f"{name}{number}", symbol, f"{says} of the {which} factor")
    for number, which, symbols in ((1, "first", FIRST), (2, "second", SECOND))
    for symbol, name, says in zip(symbols, "abcd", _ELEMENTS, strict=True)
)
AXIS_ARGUMENTS = axes("{}", AXIS, "{} of the axis, any length")
TURN = Argument("angle", alpha, "angle of the turn about the axis, radians")
ANGLE = Argument("angle", WRAPPED, "angle, radians")
PERIOD = Argument("dt", T, "time that passes, s")
GRAVITY = Argument("gravity", g, "magnitude of gravity, m/s²")
BODY_VECTOR = axes("{}", VECTOR, "{} of a vector in the body frame")
INERTIAL_VECTOR = axes("{}", VECTOR, "{} of a vector in the inertial frame")

ACCEL = axes("accel_{}", ACCELEROMETER, "reading of the accelerometer along {}, m/s²")
MAG = axes("mag_{}", MAGNETOMETER, "reading of the magnetometer along {}, any unit")
_REFERENCE = (
    ("north", "horizontal field at yaw 0 along x, any unit"),
    ("east", "horizontal field at yaw 0 along y, any unit"),
    ("reference_down", "part of the field that points down, the whole field being 1"),
)
NORTH, EAST, DOWN = (
    Argument(name, symbol, says)
    for symbol, (name, says) in zip(validation.REFERENCE, _REFERENCE, strict=True)
)
ABOVE = Argument(
    "above", monitor.ABOVE, "for how many samples in a row E has been above the threshold"
)
FACTOR = Argument("factor", monitor.FACTOR, "the factor E, NaN where it is not known")
THRESHOLD = Argument("threshold", monitor.THRESHOLD, "of E, positive")
PATIENCE = Argument("patience", monitor.PATIENCE, "samples for which each other gain is tried")
GAINS = (
    Argument("gain", monitor.USUAL, "weight of the accelerometer otherwise, from 0 to 1"),
    Argument("lowest", monitor.LOWEST, "the gain that is tried second"),
    Argument("highest", monitor.HIGHEST, "the gain that is tried first"),
)
GAIN = Argument("gain", estimation.L, "weight of the accelerometer, from 0 to 1")
TIME_CONSTANT = Argument("time_constant", gains.TIME_CONSTANT, "mean age of what is averaged, s")

AVERAGED = Argument("averaged", averaging.AVERAGED, "time that the mean stands for, s")
AVERAGING = (
    *QUATERNION_ARGUMENTS,
    Argument("mean_length", averaging.LENGTH, "length of the mean force, in its unit"),
    *(
        Argument(f"slope_{way[0]}", symbol, f"change of the mean {way} in a time constant")
        for way, symbol in zip(("north", "east", "down"), averaging.SLOPES, strict=True)
    ),
    AVERAGED,
    Argument("settled", averaging.SETTLED, "whether the low-pass has run in, 0 or 1"),
)
LONGEST_STEP = Argument("longest_step", averaging.LONGEST, "beyond which a step is a gap, s")
HEADING = (
    Argument("heading_averaged", heading.HEADING_AVERAGED, "time that the heading stands for, s"),
    Argument("field_length", heading.FIELD_LENGTH, "length of the field so far, any unit"),
    Argument("field_down", heading.FIELD_DOWN, "its part down, the whole field being 1"),
    Argument("field_known", heading.FIELD_KNOWN, "time for which the two have held, s"),
)
HEADING_TIME_CONSTANT = Argument(
    "heading_time_constant", heading.TIME_CONSTANT, "mean age of the heading, s"
)
FIELD_TOLERANCE = Argument(
    "field_tolerance", heading.TOLERANCE, "by which a field may differ, as part of the whole"
)
FIELD_PATIENCE = Argument(
    "field_patience", heading.PATIENCE, "after which a field that differs is the field, s"
)
HEADING_GAIN = Argument(
    "heading_gain", heading.HEADING_GAIN, "weight of the magnetometer, from 0 to 1"
)
RESTS = (
    *axes("rest_rate_{}", rest.RATE_MEANS, "mean rate about {} over the rest so far, rad/s"),
    *axes("rest_force_{}", rest.FORCE_MEANS, "mean force along {} over the rest so far"),
    Argument("still", rest.STILL, "for how long it has been one, s"),
    *axes("learnt_{}", rest.LEARNT, "reading at rest about {} as learnt last, rad/s"),
)
REST = Argument("rest", rest.REST, "after which it is learnt, s")
SPEED = Argument("speed", speed, "that the body stays below, m/s")
BIAS_BOUND = Argument("bias_bound", estimation.bias, "that a gyro's bias stays below, rad/s")

MISALIGNMENT = matrix("m", calibration.MISALIGNMENT, "the misalignment")
REALIGNMENT = matrix("n", calibration.REALIGNMENT, "the inverse of the misalignment")
SENSITIVITY = axes("sensitivity_{}", calibration.SENSITIVITY, "sensitivity along {}")
BIAS = axes("bias_{}", calibration.BIAS, "bias along {}")
G_SENSITIVITY = matrix("c", calibration.COUPLING, "the g-sensitivity")
SOFT_IRON = matrix("d", calibration.SOFT_IRON, "the soft-iron matrix")
DISTORTION = matrix("n", calibration.REALIGNMENT, "the inverse of the soft-iron matrix")
HARD_IRON = axes("hard_{}", calibration.HARD_IRON, "hard-iron bias along {}")
TO_SPHERE = axes(
    "a_{}",
    calibration.TO_SPHERE,
    "element {} of the symmetric matrix to the unit sphere",
    ("xx", "xy", "xz", "yy", "yz", "zz"),
)
CENTRE = axes("centre_{}", calibration.CENTRE, "centre of the readings along {}")
ACTUAL = axes("{}", VECTOR, "what is there along {}")
READING = axes("{}", VECTOR, "what the sensor reads along {}")

_WAYS = ("north", "east", "down")
VELOCITY = axes("velocity_{}", dead_reckoning.VELOCITY, "velocity {}, m/s", _WAYS)
POSITION = axes("position_{}", dead_reckoning.POSITION, "position {}, m", _WAYS)
ACCELERATION = axes("accel_{}", dead_reckoning.ACCELERATION, "acceleration {} now, m/s²", _WAYS)
NEXT = axes("next_{}", ACCELERATION_AFTER, "acceleration {} at the end of the step, m/s²", _WAYS)
TILT_ERROR = Argument(
    "angle_error", dead_reckoning.tilt_error, "angle between true and estimated vertical, radians"
)
TIME = Argument("time", dead_reckoning.t, "time that passes, s")
ERRORS = (
    TILT_ERROR,
    Argument("accel_bias", dead_reckoning.accel_bias, "bias of the accelerometer, m/s²"),
    Argument("gyro_bias", dead_reckoning.gyro_bias, "bias of the gyro about a level axis, rad/s"),
    Argument("scale_error", dead_reckoning.scale_error, "relative error of the sensitivity"),
    Argument("acceleration", dead_reckoning.moving, "acceleration of the body, m/s²"),
    Argument("accel_noise", dead_reckoning.accel_noise, "noise density, m/s²/√Hz"),
    Argument("gyro_noise", dead_reckoning.gyro_noise, "noise density, rad/s/√Hz"),
)
