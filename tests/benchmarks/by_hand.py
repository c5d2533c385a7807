"""The same functions in plain NumPy, as one writes them in a few lines, without any check.

Each sine, cosine and product is taken once. Quaternions are unit quaternions, and matrices
rotations; nothing is at gimbal lock. Two have all the duties of ours: `checked_euler`, and
`true_heading`.
"""

import numpy as np
from numpy.typing import NDArray

import chr_notes

Floats = NDArray[np.float64]


def matrix_from_euler(euler: Floats) -> Floats:
    """Work out matrices from Euler angles."""
    sine_roll, sine_pitch, sine_yaw = np.sin(euler.T)
    cosine_roll, cosine_pitch, cosine_yaw = np.cos(euler.T)
    matrix = np.empty((len(euler), 3, 3))
    matrix[:, 0, 0] = cosine_pitch * cosine_yaw
    matrix[:, 0, 1] = cosine_pitch * sine_yaw
    matrix[:, 0, 2] = -sine_pitch
    matrix[:, 1, 0] = sine_roll * sine_pitch * cosine_yaw - cosine_roll * sine_yaw
    matrix[:, 1, 1] = sine_roll * sine_pitch * sine_yaw + cosine_roll * cosine_yaw
    matrix[:, 1, 2] = sine_roll * cosine_pitch
    matrix[:, 2, 0] = cosine_roll * sine_pitch * cosine_yaw + sine_roll * sine_yaw
    matrix[:, 2, 1] = cosine_roll * sine_pitch * sine_yaw - sine_roll * cosine_yaw
    matrix[:, 2, 2] = cosine_roll * cosine_pitch
    return matrix


def euler_from_matrix(matrix: Floats) -> Floats:
    """Read Euler angles off matrices."""
    roll = np.arctan2(matrix[:, 1, 2], matrix[:, 2, 2])
    yaw = np.arctan2(matrix[:, 0, 1], matrix[:, 0, 0])
    return np.stack([roll, -np.arcsin(matrix[:, 0, 2]), yaw], axis=-1)


def checked_euler(matrix: Floats) -> Floats:
    """Read Euler angles off matrices, at the pole too, and refuse what is no rotation."""
    defect = matrix @ matrix.swapaxes(1, 2) - np.eye(3)
    if not np.abs(defect).max() < 1e-4 or not np.linalg.det(matrix).min() > 0:
        msg = "expected rotations"
        raise ValueError(msg)
    across = np.hypot(matrix[:, 0, 0], matrix[:, 0, 1])
    pitch = np.arctan2(-matrix[:, 0, 2], across)
    locked = across < 1e-12
    roll = np.where(locked, 0.0, np.arctan2(matrix[:, 1, 2], matrix[:, 2, 2]))
    yaw = np.where(
        locked,
        np.arctan2(-matrix[:, 1, 0], matrix[:, 1, 1]),
        np.arctan2(matrix[:, 0, 1], matrix[:, 0, 0]),
    )
    return np.stack([roll, pitch, yaw], axis=-1)


def euler_rates_from_body_rates(euler: Floats, rates: Floats) -> Floats:
    """Work out Euler rates."""
    roll, pitch = euler[:, 0], euler[:, 1]
    p, q, r = rates.T
    sine, cosine = np.sin(roll), np.cos(roll)
    across = q * sine + r * cosine
    return np.stack(
        [p + across * np.tan(pitch), q * cosine - r * sine, across / np.cos(pitch)], axis=-1
    )


def wrap_angle(angle: Floats) -> Floats:
    """Wrap angles in the shortest way, which loses digits of large ones."""
    return np.asarray((angle + np.pi) % (2 * np.pi) - np.pi)


def matrix_from_quaternion(q: Floats) -> Floats:
    """Work out matrices from quaternions."""
    a, b, c, d = q.T
    matrix = np.empty((len(q), 3, 3))
    matrix[:, 0, 0] = 1 - 2 * (c * c + d * d)
    matrix[:, 0, 1] = 2 * (b * c + a * d)
    matrix[:, 0, 2] = 2 * (b * d - a * c)
    matrix[:, 1, 0] = 2 * (b * c - a * d)
    matrix[:, 1, 1] = 1 - 2 * (b * b + d * d)
    matrix[:, 1, 2] = 2 * (c * d + a * b)
    matrix[:, 2, 0] = 2 * (b * d + a * c)
    matrix[:, 2, 1] = 2 * (c * d - a * b)
    matrix[:, 2, 2] = 1 - 2 * (b * b + c * c)
    return matrix


def quaternion_from_matrix(matrix: Floats) -> Floats:
    """Find quaternions, from the largest of four numbers as is usual (Bar-Itzhack's way)."""
    traces = np.trace(matrix, axis1=1, axis2=2)
    choice = np.argmax(
        np.column_stack([traces, matrix[:, 0, 0], matrix[:, 1, 1], matrix[:, 2, 2]]), axis=1
    )
    q = np.empty((len(matrix), 4))
    rows = np.flatnonzero(choice == 0)
    q[rows, 0] = 1 + traces[rows]
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        q[rows, i + 1] = matrix[rows, j, k] - matrix[rows, k, j]
        here = np.flatnonzero(choice == i + 1)
        m = matrix[here]
        q[here, 0] = m[:, j, k] - m[:, k, j]
        q[here, i + 1] = 1 + 2 * m[:, i, i] - traces[here]
        q[here, j + 1] = m[:, i, j] + m[:, j, i]
        q[here, k + 1] = m[:, i, k] + m[:, k, i]
    return q / np.linalg.norm(q, axis=1, keepdims=True) * np.where(q[:, :1] < 0, -1.0, 1.0)


def quaternion_from_euler(euler: Floats) -> Floats:
    """Work out quaternions from Euler angles."""
    sine_roll, sine_pitch, sine_yaw = np.sin(euler.T / 2)
    cosine_roll, cosine_pitch, cosine_yaw = np.cos(euler.T / 2)
    q = np.empty((len(euler), 4))
    q[:, 0] = cosine_roll * cosine_pitch * cosine_yaw + sine_roll * sine_pitch * sine_yaw
    q[:, 1] = sine_roll * cosine_pitch * cosine_yaw - cosine_roll * sine_pitch * sine_yaw
    q[:, 2] = cosine_roll * sine_pitch * cosine_yaw + sine_roll * cosine_pitch * sine_yaw
    q[:, 3] = cosine_roll * cosine_pitch * sine_yaw - sine_roll * sine_pitch * cosine_yaw
    return q * np.where(q[:, :1] < 0, -1.0, 1.0)


def euler_from_quaternion(q: Floats) -> Floats:
    """Work out Euler angles from quaternions."""
    a, b, c, d = q.T
    roll = np.arctan2(2 * (a * b + c * d), 1 - 2 * (b * b + c * c))
    pitch = np.arcsin(np.clip(2 * (a * c - b * d), -1, 1))
    yaw = np.arctan2(2 * (a * d + b * c), 1 - 2 * (c * c + d * d))
    return np.stack([roll, pitch, yaw], axis=-1)


def quaternion_multiply(p: Floats, q: Floats) -> Floats:
    """Multiply quaternions."""
    a, b, c, d = p.T
    e, f, g, h = q.T
    return np.stack(
        [
            a * e - b * f - c * g - d * h,
            a * f + b * e + c * h - d * g,
            a * g - b * h + c * e + d * f,
            a * h + b * g - c * f + d * e,
        ],
        axis=-1,
    )


def rotate_to_inertial(q: Floats, vector: Floats) -> Floats:
    """Turn vectors by quaternions: two vector products, written out."""
    a, b, c, d = q.T
    x, y, z = vector.T
    u, v, w = 2 * (c * z - d * y), 2 * (d * x - b * z), 2 * (b * y - c * x)
    return np.stack(
        [x + a * u + c * w - d * v, y + a * v + d * u - b * w, z + a * w + b * v - c * u], axis=-1
    )


def tilt_from_accelerometer(accel: Floats) -> Floats:
    """Work out roll and pitch."""
    x, y, z = accel.T
    return np.stack([np.arctan2(-y, -z), np.arctan2(x, np.sqrt(y * y + z * z))], axis=-1)


def heading_from_magnetometer(mag: Floats, tilt: Floats) -> Floats:
    """Work out yaw from magnetic north."""
    x, y, z = mag.T
    roll, pitch = tilt.T
    sine, cosine = np.sin(roll), np.cos(roll)
    down = y * sine + z * cosine
    return np.asarray(np.arctan2(z * sine - y * cosine, x * np.cos(pitch) + down * np.sin(pitch)))


DECLINATION = 0.05


def true_heading(mag: Floats, tilt: Floats) -> Floats:
    """Work out yaw from true north, and NaN of no field."""
    yaw = heading_from_magnetometer(mag, tilt) + DECLINATION
    return np.where((mag == 0).all(axis=1), np.nan, wrap_angle(yaw))


def accelerometer_at_rest(euler: Floats) -> Floats:
    """Work out what an accelerometer at rest reads."""
    roll, pitch = euler[:, 0], euler[:, 1]
    across = -chr_notes.STANDARD_GRAVITY * np.cos(pitch)
    down = chr_notes.STANDARD_GRAVITY * np.sin(pitch)
    return np.stack([down, across * np.sin(roll), across * np.cos(roll)], axis=-1)


MISALIGNMENT = np.array([[1.0, 0.02, 0.01], [-0.01, 1.0, 0.03], [0.02, -0.02, 1.0]])
TERMS = SENSITIVITY, BIAS = np.array([1.01, 0.98, 1.02]), np.array([0.1, -0.2, 0.05])
CALIBRATION = chr_notes.ThreeAxisCalibration(MISALIGNMENT, SENSITIVITY, BIAS)
REALIGNMENT = np.linalg.inv(MISALIGNMENT)


def measured(actual: Floats) -> Floats:
    """Apply the model of a sensor."""
    return np.asarray((actual * SENSITIVITY - BIAS) @ MISALIGNMENT.T)


def corrected(reading: Floats) -> Floats:
    """Undo it, the inverse of the matrix being known."""
    return np.asarray((reading @ REALIGNMENT.T + BIAS) / SENSITIVITY)
