"""Attitude representation, derived, checked and taught.

Importing the package loads NumPy; SymPy is loaded when something is derived.
"""

from chr_notes import _signals  # noqa: F401 (before NumPy, whose import Ctrl-C may meet)
from chr_notes._kernels import kernels_in_use
from chr_notes.conventions import STANDARD_GRAVITY
from chr_notes.dead_reckoning import (
    accelerometer_from_acceleration,
    dead_reckon,
    drift_from_tilt_error,
    inertial_acceleration,
)
from chr_notes.differences import (
    angle_between_attitudes,
    angle_between_verticals,
    continuous_quaternions,
    inclination_from_quaternion,
    slerp,
)
from chr_notes.drift import DriftBudget, coasting_time, drift_budget
from chr_notes.errors import (
    CalibrationWarning,
    GimbalLockError,
    GimbalLockWarning,
    UnitWarning,
)
from chr_notes.estimation.averaging import (
    Averaged,
    averaged_attitude,
    averaging_observer,
)
from chr_notes.estimation.averaging_bound import averaging_bound
from chr_notes.estimation.averaging_stream import observe_averaging
from chr_notes.estimation.doubt import Doubts, accelerated, doubtful_sensors
from chr_notes.estimation.earth_field import EarthField
from chr_notes.estimation.fixed_gain import fixed_gain_observer, rejected_samples
from chr_notes.estimation.gains import gain_from_time_constant, time_constant_from_gain
from chr_notes.estimation.gyro import integrate_gyro
from chr_notes.estimation.monitor import Monitor, Monitored, Watch, monitored_observer
from chr_notes.estimation.streams import Estimate, observe, observe_sample
from chr_notes.estimation.tilt import accelerometer_at_rest, tilt_from_accelerometer
from chr_notes.euler import (
    body_rates_from_euler_rates,
    euler_from_matrix,
    euler_rates_from_body_rates,
    euler_rates_matrix,
    matrix_from_euler,
    wrap_angle,
)
from chr_notes.frames import change_angles, change_axes, change_quaternion
from chr_notes.quaternions.algebra import (
    quaternion_conjugate,
    quaternion_inverse,
    quaternion_multiply,
    rotate_to_body,
    rotate_to_inertial,
)
from chr_notes.quaternions.conversions import (
    axis_angle_from_quaternion,
    euler_from_quaternion,
    matrix_from_quaternion,
    quaternion_from_axis_angle,
    quaternion_from_euler,
    quaternion_from_matrix,
)
from chr_notes.sensors.axes import AxesRelation, relate_axes
from chr_notes.sensors.calibration import (
    fit_accelerometer,
    fit_gyro_bias,
)
from chr_notes.sensors.ellipsoid import Ellipsoid, fit_ellipsoid
from chr_notes.sensors.gyro import fit_gyro_at_rest, fit_gyro_scale
from chr_notes.sensors.log_calibration import CalibratedRecording, calibrate_recording
from chr_notes.sensors.logs import read_log
from chr_notes.sensors.magnetometer import fit_hard_iron, fit_magnetometer
from chr_notes.sensors.models import (
    MagnetometerCalibration,
    RateGyroCalibration,
    ThreeAxisCalibration,
)
from chr_notes.sensors.poses import fit_accelerometer_from_log
from chr_notes.sensors.recording import Recording, Report
from chr_notes.sensors.still import static_interval, static_intervals
from chr_notes.sequences import (
    angle_rates_matrix,
    angles_from_matrix,
    angles_from_quaternion,
    matrix_from_angles,
    quaternion_from_angles,
)
from chr_notes.systems.convention import Convention
from chr_notes.systems.converting import convert
from chr_notes.systems.detective import find_conventions
from chr_notes.systems.matches import Match
from chr_notes.validation import heading_from_magnetometer, validation_factor
from chr_notes.zero_velocity import zero_velocity

__version__ = "0.1.0"

__all__ = [
    "STANDARD_GRAVITY",
    "Averaged",
    "AxesRelation",
    "CalibratedRecording",
    "CalibrationWarning",
    "Convention",
    "Doubts",
    "DriftBudget",
    "EarthField",
    "Ellipsoid",
    "Estimate",
    "GimbalLockError",
    "GimbalLockWarning",
    "MagnetometerCalibration",
    "Match",
    "Monitor",
    "Monitored",
    "RateGyroCalibration",
    "Recording",
    "Report",
    "ThreeAxisCalibration",
    "UnitWarning",
    "Watch",
    "accelerated",
    "accelerometer_at_rest",
    "accelerometer_from_acceleration",
    "angle_between_attitudes",
    "angle_between_verticals",
    "angle_rates_matrix",
    "angles_from_matrix",
    "angles_from_quaternion",
    "averaged_attitude",
    "averaging_bound",
    "averaging_observer",
    "axis_angle_from_quaternion",
    "body_rates_from_euler_rates",
    "calibrate_recording",
    "change_angles",
    "change_axes",
    "change_quaternion",
    "coasting_time",
    "continuous_quaternions",
    "convert",
    "dead_reckon",
    "doubtful_sensors",
    "drift_budget",
    "drift_from_tilt_error",
    "euler_from_matrix",
    "euler_from_quaternion",
    "euler_rates_from_body_rates",
    "euler_rates_matrix",
    "find_conventions",
    "fit_accelerometer",
    "fit_accelerometer_from_log",
    "fit_ellipsoid",
    "fit_gyro_at_rest",
    "fit_gyro_bias",
    "fit_gyro_scale",
    "fit_hard_iron",
    "fit_magnetometer",
    "fixed_gain_observer",
    "gain_from_time_constant",
    "heading_from_magnetometer",
    "inclination_from_quaternion",
    "inertial_acceleration",
    "integrate_gyro",
    "kernels_in_use",
    "matrix_from_angles",
    "matrix_from_euler",
    "matrix_from_quaternion",
    "monitored_observer",
    "observe",
    "observe_averaging",
    "observe_sample",
    "quaternion_conjugate",
    "quaternion_from_angles",
    "quaternion_from_axis_angle",
    "quaternion_from_euler",
    "quaternion_from_matrix",
    "quaternion_inverse",
    "quaternion_multiply",
    "read_log",
    "rejected_samples",
    "relate_axes",
    "rotate_to_body",
    "rotate_to_inertial",
    "slerp",
    "static_interval",
    "static_intervals",
    "tilt_from_accelerometer",
    "time_constant_from_gain",
    "validation_factor",
    "wrap_angle",
    "zero_velocity",
]
