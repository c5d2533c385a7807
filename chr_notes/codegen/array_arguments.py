"""Arrays that several generated functions take: their names and elements."""

from chr_notes.codegen import arguments as given
from chr_notes.codegen.target import Argument, Array


def numbers(*arguments: Argument) -> tuple[Array, ...]:
    """Arrays with one element a row, each called as its argument."""
    return tuple((argument.name, (argument,)) for argument in arguments)


DT, GAIN, TIME_CONSTANT, GRAVITY = numbers(
    given.PERIOD, given.GAIN, given.TIME_CONSTANT, given.GRAVITY
)
ACCEL = ("accel", given.ACCEL)
Q = ("q", given.QUATERNION_ARGUMENTS)
EULER = ("euler", given.ANGLES)
BODY_RATES = ("body_rates", given.RATES)
MAG = ("mag", given.MAG)
SENSITIVITY = ("sensitivity", given.SENSITIVITY)
BIAS = ("bias", given.BIAS)
MATRIX = ("matrix", given.MATRIX)
TERMS = (("misalignment", given.MISALIGNMENT), SENSITIVITY, BIAS)
TERMS_BACK = (("misalignment", given.REALIGNMENT), SENSITIVITY, BIAS)
G_SENSITIVITY = ("g_sensitivity", given.G_SENSITIVITY)
ACTUAL = ("actual", given.ACTUAL)
MEASURED = ("measured", given.READING)
