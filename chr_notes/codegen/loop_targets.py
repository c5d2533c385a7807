"""The table of generated loops: which targets make up which filter."""

from math import radians

from chr_notes.codegen import arguments as given
from chr_notes.codegen.loops import Loop, Stage

_ANGLES = ("roll", "pitch", "yaw")
_QUATERNION = ("a", "b", "c", "d")
_VELOCITY = tuple(argument.name for argument in given.VELOCITY)
_POSITION = tuple(argument.name for argument in given.POSITION)

# Beyond this pitch the rates of the angles grow without bound, so an exact turn replaces the step
# by them; and roll and yaw turn about nearly the same axis, so a correction of one moves both.
_STEEP = radians(75.0)
_EXACT_TURN = (
    ("quaternion_from_euler", _QUATERNION),
    ("quaternion_after_constant_rates", _QUATERNION),
    ("euler_from_quaternion", _ANGLES),
)

LOOPS = (
    Loop(
        "integrate_angles",
        "estimation",
        "Integrate gyros by Euler's method, angle by angle",
        _ANGLES,
        (),
        (*given.RATES, given.PERIOD),
        (Stage("gyro_step", _ANGLES, needs="p"),),
    ),
    Loop(
        "integrate_quaternion",
        "estimation",
        "Integrate gyros by a turn for each sample",
        _QUATERNION,
        (),
        (*given.RATES, given.PERIOD),
        (Stage("quaternion_after_constant_rates", _QUATERNION, needs="p"),),
    ),
    Loop(
        "fixed_gain_observer",
        "estimation",
        "Predict by the gyros, correct by the accelerometer",
        _ANGLES,
        (given.GAIN,),
        (*given.RATES, given.ROLL_ACCEL, given.PITCH_ACCEL, given.PERIOD),
        (
            Stage(
                "gyro_step",
                _ANGLES,
                needs="p",
                within=("pitch", _STEEP),
                otherwise=_EXACT_TURN,
            ),
            Stage(
                "correct_tilt",
                ("roll", "pitch"),
                needs="roll_accel",
                within=("pitch", _STEEP),
                otherwise=(("correct_steep_tilt", _ANGLES),),
            ),
        ),
    ),
    Loop(
        "dead_reckon",
        "dead_reckoning",
        "Integrate accelerations to velocity and position",
        (*_VELOCITY, *_POSITION),
        (),
        (*given.ACCELERATION, given.PERIOD),
        (
            # Position comes first: it goes on by the velocity before the sample.
            Stage("position_step", _POSITION, needs="dt"),
            Stage("velocity_step", _VELOCITY, needs="accel_north"),
        ),
    ),
)
