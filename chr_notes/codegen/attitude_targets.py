"""The table of generated functions, part one: attitudes as Euler angles and as quaternions.

No formula stands here: each target names the derivation that it comes from.
"""

from functools import partial

from chr_notes.codegen import arguments as given
from chr_notes.codegen import array_arguments as array
from chr_notes.codegen.target import Target
from chr_notes.derivations import euler, hamilton, quaternions
from chr_notes.derivations.forms import euler as euler_forms
from chr_notes.derivations.forms import quaternions as forms

EULER = partial(Target, "euler")
QUATERNIONS = partial(Target, "quaternions")

TARGETS = (
    EULER(
        "matrix_from_euler",
        "Matrix from the inertial to the body frame, row by row",
        lambda: euler.rotation("I", "B"),
        ("euler.5.2", "euler.5.3"),
        arrays=(array.EULER,),
    ),
    EULER(
        "euler_from_matrix",
        "Roll, pitch and yaw, radians",
        euler_forms.euler_from_matrix,
        arrays=(array.MATRIX,),
    ),
    EULER(
        "rotation_defect",
        "How far a matrix is from a rotation: root mean square of R Rᵀ - 1, and the determinant",
        euler_forms.rotation_defect,
        arrays=(array.MATRIX,),
    ),
    EULER(
        "euler_rates_matrix",
        "Matrix D from body rates to Euler rates, row by row",
        euler.euler_rates_matrix,
        ("euler.7.2", "euler.7.d"),
        arrays=(array.EULER,),
        arguments=(given.ROLL, given.PITCH),
    ),
    EULER(
        "euler_rates_from_body_rates",
        "Derivatives of roll, pitch and yaw, rad/s",
        euler_forms.euler_rates,
        ("euler.7.3",),
        arrays=(array.EULER, array.BODY_RATES),
        arguments=(given.ROLL, given.PITCH, *given.RATES),
    ),
    EULER(
        "body_rates_from_euler_rates",
        "Body rates about x, y and z, rad/s",
        euler.body_rates,
        ("euler.7.a",),
        arrays=(array.EULER, ("euler_rates", given.ANGLE_RATES)),
        arguments=(given.ROLL, given.PITCH, *given.ANGLE_RATES),
    ),
    EULER(
        "euler_rates_determinant",
        "Determinant of the matrix D",
        euler.euler_rates_determinant,
        arguments=(given.PITCH,),
    ),
    EULER(
        "euler_rates_condition",
        "Condition number of the matrix D in the 2-norm",
        euler.euler_rates_condition,
        arguments=(given.PITCH,),
    ),
    EULER(
        "wrap_angle",
        "The angle less whole turns, from -pi up to but not including pi",
        euler_forms.wrap_angle,
        arrays=array.numbers(given.ANGLE),
    ),
    QUATERNIONS(
        "matrix_from_quaternion",
        "Matrix from the inertial to the body frame, row by row",
        forms.matrix_from_quaternion,
        ("quaternions.3.3",),
        arrays=(array.Q,),
    ),
    QUATERNIONS(
        "quaternion_from_matrix",
        "Unit quaternion with a >= 0",
        forms.quaternion_from_matrix,
        ("quaternions.3.3",),
        arrays=(array.MATRIX,),
    ),
    QUATERNIONS(
        "quaternion_from_euler",
        "Unit quaternion with a >= 0",
        forms.quaternion_from_euler,
        ("quaternions.2.2",),
        arrays=(array.EULER,),
    ),
    QUATERNIONS(
        "euler_from_quaternion",
        "Roll, pitch and yaw, radians",
        forms.euler_from_quaternion,
        ("quaternions.4.1", "quaternions.4.2", "quaternions.4.3"),
        arrays=(array.Q,),
    ),
    QUATERNIONS(
        "quaternion_from_axis_angle",
        "Unit quaternion with a >= 0",
        forms.quaternion_from_axis_angle,
        ("quaternions.2.2",),
        arrays=(("axis", given.AXIS_ARGUMENTS), *array.numbers(given.TURN)),
    ),
    QUATERNIONS(
        "axis_angle_from_quaternion",
        "Unit axis x, y, z and the angle in [0, pi] of the turn about it, radians",
        forms.axis_angle_from_quaternion,
        ("quaternions.2.2",),
        arrays=(array.Q,),
    ),
    QUATERNIONS(
        "inclination_from_quaternion",
        "Angle in [0, pi] between the body's z-axis and the vertical, radians",
        forms.inclination,
        arrays=(array.Q,),
    ),
    QUATERNIONS(
        "quaternion_multiply",
        "Product of two quaternions",
        hamilton.product,
        ("quaternions.3.2",),
        arrays=(("p", given.PRODUCT[:4]), ("q", given.PRODUCT[4:])),
    ),
    QUATERNIONS(
        "quaternion_conjugate",
        "Conjugate of the quaternion",
        lambda: hamilton.conjugate(quaternions.ATTITUDE),
        ("quaternions.3.c",),
        arrays=(array.Q,),
    ),
    QUATERNIONS(
        "quaternion_inverse",
        "Inverse of the quaternion",
        forms.quaternion_inverse,
        ("quaternions.3.a",),
        arrays=(array.Q,),
    ),
    QUATERNIONS(
        "rotate_to_inertial",
        "The vector in the inertial frame",
        forms.rotate_to_inertial,
        ("quaternions.3.1",),
        arrays=(array.Q, ("v_body", given.BODY_VECTOR)),
    ),
    QUATERNIONS(
        "rotate_to_body",
        "The vector in the body frame",
        forms.rotate_to_body,
        ("quaternions.3.1", "quaternions.3.4"),
        arrays=(array.Q, ("v_inertial", given.INERTIAL_VECTOR)),
    ),
    QUATERNIONS(
        "quaternion_after_constant_rates",
        "Attitude quaternion after a time during which the body rates do not change",
        forms.constant_rate_step,
        arguments=(*given.QUATERNION_ARGUMENTS, *given.RATES, given.PERIOD),
    ),
    QUATERNIONS(
        "quaternion_rates",
        "Derivatives of a, b, c and d, 1/s",
        quaternions.rates,
        arguments=(*given.QUATERNION_ARGUMENTS, *given.RATES),
    ),
)
