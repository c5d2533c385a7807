"""What is timed: each task in each library that can do it, for one attitude or for many.

Objects that a library keeps attitudes in are made before the clock starts, which favours the
libraries that have such objects.
"""

import operator
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import ahrs
import numpy as np
import pytransform3d.batch_rotations as batch
import quaternion as numpy_quaternion
import sym
import transforms3d
from numpy.typing import NDArray
from pytransform3d import rotations
from scipy.spatial.transform import Rotation

import chr_notes
from chr_notes.generated.scalar import estimation as scalar_estimation
from chr_notes.generated.scalar import euler as scalar_euler
from chr_notes.generated.scalar import quaternions as scalar
from chr_notes.generated.scalar import sensors as scalar_sensors
from chr_notes.generated.scalar import validation as scalar_validation

from . import by_hand

Floats = NDArray[np.float64]
OURS, SCALAR = "chr_notes", "chr_notes, one at a time"
MEMCPY = "memcpy of the result"
PLAIN_NUMPY = "plain NumPy"
# Its functions return arrays, so what goes from one to the next is an array; lists are taken too,
# and Python's own numbers in them are multiplied faster.
TRANSFORMS3D, ON_LISTS = "transforms3d", "transforms3d, given lists"
# Arrays of its quaternions, of which some have one row, and single ones, which are no arrays.
OBJECTS = "numpy-quaternion, one at a time"


@dataclass(frozen=True)
class Data:
    """Random attitudes, vectors and rates, a row each."""

    q: Floats
    p: Floats
    euler: Floats
    vectors: Floats

    @property
    def scipy(self) -> Rotation:
        """The attitudes as SciPy keeps them."""
        return Rotation.from_quat(self.q, scalar_first=True)


def data(rows: int) -> Data:
    """Make the same data each time."""
    rng = np.random.default_rng(4)
    q, p = rng.normal(size=(2, rows, 4))
    angles = rng.uniform([-np.pi, -1.5, -np.pi], [np.pi, 1.5, np.pi], (rows, 3))
    unit = [each / np.linalg.norm(each, axis=1, keepdims=True) for each in (q, p)]
    return Data(*unit, angles, rng.normal(size=(rows, 3)))


def _symforce(row: Floats) -> Any:  # noqa: ANN401 (the library has no types)
    return sym.Rot3([*row[1:], row[0]])


Task = Callable[[Data], Callable[[], Any]]


def memcpy(task: Task, rows: Data) -> Callable[[], Floats]:
    """Copy our result to a new array, which is the least that can be asked of anyone."""
    result: Floats = task(rows)()
    return result.copy


# For many attitudes: by task, then by library.
MANY: dict[str, dict[str, Task]] = {
    "Euler angles from quaternions": {
        OURS: lambda d: partial(chr_notes.euler_from_quaternion, d.q),
        "SciPy": lambda d: partial(d.scipy.as_euler, "ZYX"),
        "ahrs": lambda d: ahrs.QuaternionArray(d.q).to_angles,
    },
    "matrices from Euler angles": {
        OURS: lambda d: partial(chr_notes.matrix_from_euler, d.euler),
        "SciPy": lambda d: lambda: Rotation.from_euler("ZYX", d.euler[:, ::-1]).as_matrix(),
        PLAIN_NUMPY: lambda d: partial(by_hand.matrix_from_euler, d.euler),
        "pytransform3d": lambda d: partial(
            batch.active_matrices_from_intrinsic_euler_angles, 2, 1, 0, d.euler[:, ::-1]
        ),
    },
    "Euler rates from body rates": {
        OURS: lambda d: partial(chr_notes.euler_rates_from_body_rates, d.euler, d.vectors),
        PLAIN_NUMPY: lambda d: partial(by_hand.euler_rates_from_body_rates, d.euler, d.vectors),
    },
    "products of quaternions": {
        OURS: lambda d: partial(chr_notes.quaternion_multiply, d.p, d.q),
        "SciPy": lambda d: partial(
            Rotation.__mul__, Rotation.from_quat(d.p, scalar_first=True), d.scipy
        ),
        "numpy-quaternion": lambda d: partial(
            np.multiply,
            numpy_quaternion.as_quat_array(d.p),
            numpy_quaternion.as_quat_array(d.q),
        ),
        "pytransform3d": lambda d: partial(batch.batch_concatenate_quaternions, d.p, d.q),
    },
    "rotated vectors": {
        OURS: lambda d: partial(chr_notes.rotate_to_inertial, d.q, d.vectors),
        "SciPy": lambda d: partial(d.scipy.apply, d.vectors),
    },
    "matrices from quaternions": {
        OURS: lambda d: partial(chr_notes.matrix_from_quaternion, d.q),
        "SciPy": lambda d: d.scipy.as_matrix,
        "ahrs": lambda d: ahrs.QuaternionArray(d.q).to_DCM,
        "numpy-quaternion": lambda d: partial(
            numpy_quaternion.as_rotation_matrix, numpy_quaternion.as_quat_array(d.q)
        ),
        "pytransform3d": lambda d: partial(batch.matrices_from_quaternions, d.q),
    },
}


# By hand, for many as for one.
BY_HAND: dict[str, dict[str, Task]] = {
    "wrapped angles": {
        OURS: lambda d: partial(chr_notes.wrap_angle, 3 * d.euler[:, 0]),
        PLAIN_NUMPY: lambda d: partial(by_hand.wrap_angle, 3 * d.euler[:, 0]),
    },
    "tilt from accelerometers": {
        OURS: lambda d: partial(chr_notes.tilt_from_accelerometer, d.vectors),
        PLAIN_NUMPY: lambda d: partial(by_hand.tilt_from_accelerometer, d.vectors),
    },
    "heading from magnetometers": {
        OURS: lambda d: partial(
            chr_notes.heading_from_magnetometer, d.vectors, np.ascontiguousarray(d.euler[:, :2])
        ),
        PLAIN_NUMPY: lambda d: partial(
            by_hand.heading_from_magnetometer, d.vectors, np.ascontiguousarray(d.euler[:, :2])
        ),
    },
    "readings of accelerometers at rest": {
        OURS: lambda d: partial(chr_notes.accelerometer_at_rest, d.euler),
        PLAIN_NUMPY: lambda d: partial(by_hand.accelerometer_at_rest, d.euler),
    },
    "readings by a calibration": {
        OURS: lambda d: partial(by_hand.CALIBRATION.measure, d.vectors),
        PLAIN_NUMPY: lambda d: partial(by_hand.measured, d.vectors),
    },
    "readings corrected": {
        OURS: lambda d: partial(by_hand.CALIBRATION.correct, d.vectors),
        PLAIN_NUMPY: lambda d: partial(by_hand.corrected, d.vectors),
    },
}
MANY |= BY_HAND

# For one attitude.
ONE: dict[str, dict[str, Task]] = {
    "Euler angles from quaternions": {
        SCALAR: lambda d: partial(scalar.euler_from_quaternion, *d.q[0].tolist()),
        OURS: lambda d: partial(chr_notes.euler_from_quaternion, d.q[0]),
        "SciPy": lambda d: partial(d.scipy[0].as_euler, "ZYX"),
        "ahrs": lambda d: ahrs.Quaternion(d.q[0]).to_angles,
        "pytransform3d": lambda d: partial(
            rotations.euler_from_quaternion, d.q[0], 2, 1, 0, extrinsic=False
        ),
        TRANSFORMS3D: lambda d: partial(transforms3d.euler.quat2euler, d.q[0], "rzyx"),
        ON_LISTS: lambda d: partial(transforms3d.euler.quat2euler, d.q[0].tolist(), "rzyx"),
        "symforce": lambda d: _symforce(d.q[0]).to_yaw_pitch_roll,
    },
    "matrices from Euler angles": {
        SCALAR: lambda d: partial(scalar_euler.matrix_from_euler, *d.euler[0].tolist()),
        OURS: lambda d: partial(chr_notes.matrix_from_euler, d.euler[0]),
        "SciPy": lambda d: lambda: Rotation.from_euler("ZYX", d.euler[0, ::-1]).as_matrix(),
        "pytransform3d": lambda d: partial(
            rotations.matrix_from_euler, d.euler[0, ::-1], 2, 1, 0, extrinsic=False
        ),
        TRANSFORMS3D: lambda d: partial(
            transforms3d.euler.euler2mat, *d.euler[0, ::-1].tolist(), "rzyx"
        ),
        "symforce": lambda d: (
            lambda angles: sym.Rot3.from_yaw_pitch_roll(*angles).to_rotation_matrix()
        ).__get__(d.euler[0, ::-1].tolist()),
    },
    "Euler rates from body rates": {
        SCALAR: lambda d: partial(
            scalar_euler.euler_rates_from_body_rates,
            *d.euler[0, :2].tolist(),
            *d.vectors[0].tolist(),
        ),
        OURS: lambda d: partial(chr_notes.euler_rates_from_body_rates, d.euler[0], d.vectors[0]),
        PLAIN_NUMPY: lambda d: partial(
            by_hand.euler_rates_from_body_rates, d.euler[:1], d.vectors[:1]
        ),
    },
    "products of quaternions": {
        SCALAR: lambda d: partial(scalar.quaternion_multiply, *d.p[0].tolist(), *d.q[0].tolist()),
        OURS: lambda d: partial(chr_notes.quaternion_multiply, d.p[:1], d.q[:1]),
        "SciPy": lambda d: partial(
            Rotation.__mul__, Rotation.from_quat(d.p[0], scalar_first=True), d.scipy[0]
        ),
        "ahrs": lambda d: partial(ahrs.Quaternion(d.p[0]).product, d.q[0]),
        "numpy-quaternion": MANY["products of quaternions"]["numpy-quaternion"],
        OBJECTS: lambda d: partial(
            operator.mul,
            numpy_quaternion.quaternion(*d.p[0]),
            numpy_quaternion.quaternion(*d.q[0]),
        ),
        "pytransform3d": lambda d: partial(rotations.concatenate_quaternions, d.p[0], d.q[0]),
        TRANSFORMS3D: lambda d: partial(transforms3d.quaternions.qmult, d.p[0], d.q[0]),
        ON_LISTS: lambda d: partial(
            transforms3d.quaternions.qmult, d.p[0].tolist(), d.q[0].tolist()
        ),
        "symforce": lambda d: partial(sym.Rot3.__mul__, _symforce(d.p[0]), _symforce(d.q[0])),
    },
    "rotated vectors": {
        SCALAR: lambda d: partial(
            scalar.rotate_to_inertial, *d.q[0].tolist(), *d.vectors[0].tolist()
        ),
        OURS: lambda d: partial(chr_notes.rotate_to_inertial, d.q[0], d.vectors[0]),
        "SciPy": lambda d: partial(d.scipy[0].apply, d.vectors[0]),
        "ahrs": lambda d: partial(ahrs.Quaternion(d.q[0]).rotate, d.vectors[0]),
        "numpy-quaternion": lambda d: partial(
            numpy_quaternion.rotate_vectors, numpy_quaternion.quaternion(*d.q[0]), d.vectors[0]
        ),
        "pytransform3d": lambda d: partial(rotations.q_prod_vector, d.q[0], d.vectors[0]),
        TRANSFORMS3D: lambda d: partial(
            transforms3d.quaternions.rotate_vector, d.vectors[0], d.q[0]
        ),
        ON_LISTS: lambda d: partial(
            transforms3d.quaternions.rotate_vector, d.vectors[0].tolist(), d.q[0].tolist()
        ),
        "symforce": lambda d: partial(sym.Rot3.__mul__, _symforce(d.q[0]), d.vectors[0]),
    },
    "matrices from quaternions": {
        SCALAR: lambda d: partial(scalar.matrix_from_quaternion, *d.q[0].tolist()),
        OURS: lambda d: partial(chr_notes.matrix_from_quaternion, d.q[0]),
        "SciPy": lambda d: d.scipy[0].as_matrix,
        "ahrs": lambda d: ahrs.Quaternion(d.q[0]).to_DCM,
        "numpy-quaternion": lambda d: partial(
            numpy_quaternion.as_rotation_matrix, numpy_quaternion.quaternion(*d.q[0])
        ),
        "pytransform3d": lambda d: partial(rotations.matrix_from_quaternion, d.q[0]),
        TRANSFORMS3D: lambda d: partial(transforms3d.quaternions.quat2mat, d.q[0]),
        ON_LISTS: lambda d: partial(transforms3d.quaternions.quat2mat, d.q[0].tolist()),
        "symforce": lambda d: _symforce(d.q[0]).to_rotation_matrix,
    },
}
_SCALAR: dict[str, Task] = {
    "wrapped angles": lambda d: partial(scalar_euler.wrap_angle, 3 * float(d.euler[0, 0])),
    "tilt from accelerometers": lambda d: partial(
        scalar_estimation.tilt_from_accelerometer, *d.vectors[0].tolist()
    ),
    "heading from magnetometers": lambda d: partial(
        scalar_validation.heading_from_magnetometer,
        *d.vectors[0].tolist(),
        *d.euler[0, :2].tolist(),
        1.0,
        0.0,
    ),
    "readings of accelerometers at rest": lambda d: partial(
        scalar_sensors.accelerometer_at_rest,
        *d.euler[0, :2].tolist(),
        chr_notes.STANDARD_GRAVITY,
    ),
    "readings by a calibration": lambda d: partial(
        scalar_sensors.sensor_measures,
        *np.r_[
            by_hand.MISALIGNMENT.ravel(), by_hand.SENSITIVITY, by_hand.BIAS, d.vectors[0]
        ].tolist(),
    ),
    "readings corrected": lambda d: partial(
        scalar_sensors.sensor_corrected,
        *np.r_[
            by_hand.REALIGNMENT.ravel(), by_hand.SENSITIVITY, by_hand.BIAS, d.vectors[0]
        ].tolist(),
    ),
}
ONE |= {task: {SCALAR: _SCALAR[task], **libraries} for task, libraries in BY_HAND.items()}
