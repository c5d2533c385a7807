"""Which columns hold what."""

import pytest

from chr_notes.sensors.columns import Selected, select


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
