"""Arrays that several generated functions take: their names and elements."""

from chr_notes.codegen import arguments as given

DT = ("dt", (given.PERIOD,))
ACCEL = ("accel", given.ACCEL)
Q = ("q", given.QUATERNION_ARGUMENTS)
EULER = ("euler", given.ANGLES)
BODY_RATES = ("body_rates", given.RATES)
MAG = ("mag", given.MAG)
GAIN = ("gain", (given.GAIN,))
TIME_CONSTANT = ("time_constant", (given.TIME_CONSTANT,))
SENSITIVITY = ("sensitivity", given.SENSITIVITY)
BIAS = ("bias", given.BIAS)
GRAVITY = ("gravity", (given.GRAVITY,))
MATRIX = ("matrix", given.MATRIX)
TERMS = (("misalignment", given.MISALIGNMENT), SENSITIVITY, BIAS)
TERMS_BACK = (("misalignment", given.REALIGNMENT), SENSITIVITY, BIAS)
G_SENSITIVITY = ("g_sensitivity", given.G_SENSITIVITY)
ACTUAL = ("actual", given.ACTUAL)
MEASURED = ("measured", given.READING)
