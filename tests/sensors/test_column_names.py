"""What the name of a column tells."""

import pytest

from chr_notes.sensors.column_names import meaning, unit_of

NAMES = {
    "ax": ("accel", "x", None),
    "acc_y": ("accel", "y", None),
    "accel_x [m/s^2]": ("accel", "x", "m/s^2"),
    "Accelerometer Z (g)": ("accel", "z", "g"),
    "acc y [m·s⁻²]": ("accel", "y", "m/s^2"),
    "az_mg": ("accel", "z", "mg"),
    "accelerometer_m_s2[2]": ("accel", "2", "m/s^2"),
    "field.linear_acceleration.x": ("accel", "x", None),
    "x_acc": ("accel", "x", None),
    "ax_raw": ("accel", "x", "counts"),
    "gx": ("gyro", "x", None),
    "GyrX": ("gyro", "x", None),
    "gyroscope x (deg/s)": ("gyro", "x", "deg/s"),
    "Gyroscope_Z_dps": ("gyro", "z", "deg/s"),
    "gyro_x (°/s)": ("gyro", "x", "deg/s"),
    "gx_rad_s": ("gyro", "x", "rad/s"),
    "gyro_rad[0]": ("gyro", "0", "rad/s"),
    "angular_velocity.y": ("gyro", "y", None),
    "gyroRotationX(rad/s)": ("gyro", "x", "rad/s"),
    "omega_z": ("gyro", "z", None),
    "p": ("gyro", "x", None),
    "mx_uT": ("mag", "x", "uT"),
    "Magnetometer X (µT)": ("mag", "x", "uT"),
    "magnetic_field.z": ("mag", "z", None),
    "mag_x_mG": ("mag", "x", "mgauss"),
    "timestamp": ("time", None, None),
    "Time (s)": ("time", None, "s"),
    "t_ms": ("time", None, "ms"),
    "time_us": ("time", None, "us"),
    "TimeUS": ("time", None, "us"),
    "Timestamp (ns)": ("time", None, "ns"),
    "seconds_elapsed": ("time", None, "s"),
    "field.header.stamp": ("time", None, None),
    "temperature": ("temperature", None, None),
    "T (°C)": ("temperature", None, "degC"),
    "gyro_temp_K": ("temperature", None, "K"),
}
OTHERS = [
    *("qw", "roll_deg", "moving", "n_samples", "", "x", "motionUserAccelerationX(G)", "gravity_x"),
    *("linear_acceleration_covariance[0]", "orientation.x", "SampleTimeFine", "lat", "acc_x_std"),
]


@pytest.mark.parametrize(("name", "told"), NAMES.items())
def test_a_name_tells(name: str, told: tuple[str, str | None, str | None]) -> None:
    found = meaning(name)
    assert found is not None
    assert (found.quantity, found.axis, found.unit) == told


@pytest.mark.parametrize("name", OTHERS)
def test_other_names_tell_nothing(name: str) -> None:
    assert meaning(name) is None


@pytest.mark.parametrize(
    ("quantity", "text", "unit"),
    [
        ("gyro", "deg/s", "deg/s"),
        ("gyro", "rad s^-1", "rad/s"),
        ("accel", "m/s²", "m/s^2"),
        ("mag", "gauss", "gauss"),
        ("time", "parsecs", None),
    ],
)
def test_units_are_read_as_they_are_written(quantity: str, text: str, unit: str | None) -> None:
    assert unit_of(quantity, text) == unit
