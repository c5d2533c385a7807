"""What the names of columns tell."""

import pytest

from chr_notes.sensors.columns import Selected, meaning, select, unit_of

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


def test_columns_may_stand_in_any_order() -> None:
    names = ["az_g", "id", "ax_g", "ay_g", "time_ms", "gyro[1]", "gyro[3]", "gyro[2]"]
    assert select(names) == {
        "time": Selected((4,), "ms"),
        "gyro": Selected((5, 7, 6), None),
        "accel": Selected((2, 3, 0), "g"),
    }


def test_what_is_given_goes_before_names() -> None:
    names = ["ax", "ay", "az", "u [deg/s]", "v [deg/s]", "w [deg/s]"]
    given = {"gyro": (names[3], 4, names[5]), "accel": None}
    assert select(names, given) == {"gyro": Selected((3, 4, 5), "deg/s")}


@pytest.mark.parametrize(
    ("names", "given", "message"),
    [
        (["a", "b"], None, "expected columns such as 'ax'"),
        (["ax", "ay"], None, "accel: expected columns for x, y and z, got \\['ax', 'ay'\\]"),
        (["ax", "ay", "az", "acc_x"], None, "accel: expected one column for x, got \\['ax', 'acc_"),
        (["ax_g", "ay_g", "az_mg"], None, "accel: expected one unit for all three axes"),
        (["ax", "ay", "az"], {"gyro": ("a", "b", "c")}, "expected a column of .*, got 'a'"),
        (["ax", "ay", "az"], {"gyro": ("ax", "ay")}, "expected 3 columns"),
        (["ax", "ay", "az"], {"speed": "ax"}, "expected quantities of .*, got 'speed'"),
    ],
)
def test_what_cannot_be_told_is_refused(
    names: list[str], given: dict[str, tuple[str, ...]] | None, message: str
) -> None:
    with pytest.raises(ValueError, match=message):
        select(names, given)  # type: ignore[arg-type]
