"""The table of generated functions: which derived formula becomes which function.

No formula stands here: each target names the derivation that it comes from.
"""

from chr_notes.codegen import arguments as given
from chr_notes.codegen.target import Target
from chr_notes.derivations import euler, hamilton, quaternions
from chr_notes.derivations.forms import euler as euler_forms
from chr_notes.derivations.forms import quaternions as forms

TARGETS = (
    Target(
        "matrix_from_euler",
        "euler",
        "Matrix from the inertial to the body frame, row by row",
        given.ANGLES,
        lambda: euler.rotation("I", "B"),
        ("euler.5.2", "euler.5.3"),
    ),
    Target(
        "euler_from_matrix",
        "euler",
        "Roll, pitch and yaw, radians",
        given.MATRIX,
        euler_forms.euler_from_matrix,
    ),
    Target(
        "euler_rates_matrix",
        "euler",
        "Matrix D from body rates to Euler rates, row by row",
        (given.ROLL, given.PITCH),
        euler.euler_rates_matrix,
        ("euler.7.2", "euler.7.d"),
    ),
    Target(
        "euler_rates_from_body_rates",
        "euler",
        "Derivatives of roll, pitch and yaw, rad/s",
        (given.ROLL, given.PITCH, *given.RATES),
        euler_forms.euler_rates,
        ("euler.7.3",),
    ),
    Target(
        "body_rates_from_euler_rates",
        "euler",
        "Body rates about x, y and z, rad/s",
        (given.ROLL, given.PITCH, *given.ANGLE_RATES),
        euler.body_rates,
        ("euler.7.a",),
    ),
    Target(
        "euler_rates_determinant",
        "euler",
        "Determinant of the matrix D",
        (given.PITCH,),
        euler.euler_rates_determinant,
        ("euler.7.c",),
    ),
    Target(
        "euler_rates_condition",
        "euler",
        "Condition number of the matrix D in the 2-norm",
        (given.PITCH,),
        euler.euler_rates_condition,
        ("euler.7.c",),
    ),
    Target(
        "wrap_angle",
        "euler",
        "The angle less whole turns, from -pi up to but not including pi",
        (given.ANGLE,),
        euler_forms.wrap_angle,
    ),
    Target(
        "matrix_from_quaternion",
        "quaternions",
        "Matrix from the inertial to the body frame, row by row",
        given.QUATERNION_ARGUMENTS,
        forms.matrix_from_quaternion,
        ("quaternions.3.3",),
    ),
    Target(
        "quaternion_from_matrix",
        "quaternions",
        "Unit quaternion with a >= 0",
        given.MATRIX,
        forms.quaternion_from_matrix,
        ("quaternions.3.3",),
    ),
    Target(
        "quaternion_from_euler",
        "quaternions",
        "Unit quaternion with a >= 0",
        given.ANGLES,
        forms.quaternion_from_euler,
    ),
    Target(
        "euler_from_quaternion",
        "quaternions",
        "Roll, pitch and yaw, radians",
        given.QUATERNION_ARGUMENTS,
        forms.euler_from_quaternion,
        ("quaternions.4.1", "quaternions.4.2", "quaternions.4.3", "quaternions.4.b"),
    ),
    Target(
        "quaternion_from_axis_angle",
        "quaternions",
        "Unit quaternion with a >= 0",
        (*given.AXIS_ARGUMENTS, given.TURN),
        forms.quaternion_from_axis_angle,
        ("quaternions.2.2",),
    ),
    Target(
        "axis_angle_from_quaternion",
        "quaternions",
        "Unit axis x, y, z and the angle in [0, pi] of the turn about it, radians",
        given.QUATERNION_ARGUMENTS,
        forms.axis_angle_from_quaternion,
        ("quaternions.2.2",),
    ),
    Target(
        "quaternion_multiply",
        "quaternions",
        "Product of two quaternions",
        given.PRODUCT,
        hamilton.product,
        ("quaternions.3.2",),
    ),
    Target(
        "quaternion_conjugate",
        "quaternions",
        "Conjugate of the quaternion",
        given.QUATERNION_ARGUMENTS,
        lambda: hamilton.conjugate(quaternions.ATTITUDE),
        ("quaternions.3.c",),
    ),
    Target(
        "quaternion_inverse",
        "quaternions",
        "Inverse of the quaternion",
        given.QUATERNION_ARGUMENTS,
        forms.quaternion_inverse,
        ("quaternions.3.a",),
    ),
    Target(
        "rotate_to_inertial",
        "quaternions",
        "The vector in the inertial frame",
        (*given.QUATERNION_ARGUMENTS, *given.vector("a vector in the body frame")),
        forms.rotate_to_inertial,
        ("quaternions.3.1",),
    ),
    Target(
        "rotate_to_body",
        "quaternions",
        "The vector in the body frame",
        (*given.QUATERNION_ARGUMENTS, *given.vector("a vector in the inertial frame")),
        forms.rotate_to_body,
        ("quaternions.3.1", "quaternions.3.4"),
    ),
    Target(
        "quaternion_after_constant_rates",
        "quaternions",
        "Attitude quaternion after a time during which the body rates do not change",
        (*given.QUATERNION_ARGUMENTS, *given.RATES, given.PERIOD),
        forms.constant_rate_step,
    ),
)
