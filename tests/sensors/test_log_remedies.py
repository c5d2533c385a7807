"""What a refusal of a log says: the cause that it has, and what helps."""

import bz2
import gzip
import inspect
import io
import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose

from chr_notes import accelerometer_at_rest, integrate_gyro, matrix_from_euler, read_log
from chr_notes.sensors.log_table import read_text

NAMES = "t,gx,gy,gz,ax,ay,az\n"


def rows(down: float = -9.81, delimiter: str = ",", count: int = 200) -> str:
    """A sensor that lies still and reads so much along z."""
    lines = ([0.01 * k, 0.001 * (k % 3), 0, 0, 0.01 * (k % 2), 0, down] for k in range(count))
    return "".join(delimiter.join(f"{each:.4f}" for each in line) + "\n" for line in lines)


def read(text: str | bytes, **given: Any) -> Any:  # noqa: ANN401 (as read_log takes and gives)
    file = io.BytesIO(text) if isinstance(text, bytes) else io.StringIO(text)
    return read_log(file, units={"gyro": "rad/s"}, **given)


@pytest.mark.parametrize(("down", "axes", "right"), [(-9.8, "flu", "frd"), (9.8, "frd", "flu")])
def test_axes_that_are_advised_are_right(down: float, axes: str, right: str) -> None:
    with pytest.raises(ValueError, match=f"pass axes='{right}'"):
        read(NAMES + rows(down), axes=axes)
    assert read(NAMES + rows(down), axes=right).accel[0, 2] == pytest.approx(-9.8)


@pytest.mark.parametrize(
    "before", ["# written by me\n", "written by me\n", "# ax ay az: m/s2\n\n", "# ax,ay,az\n"]
)
def test_words_before_the_names_are_none(before: str) -> None:
    assert read(before + NAMES + rows()).accel.shape == (200, 3)
    assert read("# " + NAMES + rows()).accel.shape == (200, 3)


def test_a_line_of_names_with_a_fault_is_told_of() -> None:
    with pytest.raises(ValueError, match="line 2, column 1: accel: expected columns for x, y and"):
        read("# by me\n" + NAMES.replace("ay", "note") + rows())


@pytest.mark.parametrize(
    ("columns", "said"),
    [
        ({"accel": ("ax", "ay", "foo")}, r"expected a column of \['t', 'gx'.*, got 'foo'"),
        ({"accel": ("a", "b", "c")}, r"expected a column of \['t', 'gx'.*, got 'a'"),
        ({"accel": ("ax", "ax", "az")}, r"columns\['accel'\]: expected 3 different columns, got"),
        (
            {"accel": ("ax", "ay", "az"), "gyro": ("gx", "gy", "az")},
            "columns: expected each once, got 'az' for gyro and accel",
        ),
    ],
)
def test_columns_that_cannot_be(columns: dict[str, object], said: str) -> None:
    with pytest.raises(ValueError, match=f"line 1, column 1: .*{said}"):
        read(NAMES + rows(), columns=columns)


def test_fields_are_shown_as_they_stand() -> None:
    comma = rows(delimiter=";").replace(".", ",")
    quoted = "".join(
        ",".join(f'"{each}"' for each in line.split(";")) + "\n" for line in comma.splitlines()
    )
    assert_allclose(read(NAMES + quoted).accel, read(NAMES + rows()).accel)
    semicolons = NAMES.replace(",", ";") + comma
    for text, field in (
        (NAMES + rows() + '3,0,0,0,0,0,"-9,81"\n', "a number, got '-9,81'"),
        (semicolons + '3,0;0;0;0;0;0;"-1.009,81"\n', "a number, got '-1.009,81'"),
        (semicolons + "3,0;0;0;0;0;0;-9.81\n", "a number with a decimal comma, got '-9.81'"),
    ):
        where = r"^line 202, column 7 \(az\): expected " + re.escape(field) + "$"
        with pytest.raises(ValueError, match=where):
            read(text)


def test_gravity_that_was_taken_away() -> None:
    for names in (NAMES, NAMES.replace("ax", "ax_ms2").replace("ay", "ay_ms2")):
        with pytest.raises(ValueError, match=r"readings.* (have it|still have gravity)"):
            read(names.replace("az", "az_ms2" if "ms2" in names else "az") + rows(0.02))
    with pytest.raises(ValueError, match=r"norm of 0; pass readings that still have gravity"):
        read(NAMES + rows(0.0).replace("0.0100,0", "0.0000,0"))


@pytest.mark.parametrize(("pack", "kind"), [(gzip.compress, "gzip"), (bz2.compress, "bzip2")])
def test_packed_files_are_named(pack: Callable[[bytes], bytes], kind: str) -> None:
    packed = pack((NAMES + rows()).encode())
    with pytest.raises(ValueError, match=f"line 1, column 1: expected text, got a {kind} file"):
        read(packed)
    if kind == "gzip":
        opened = gzip.open(io.BytesIO(packed))  # noqa: SIM115 (of bytes)
        assert len(read_text(opened, None).values["accel"]) == 200


@pytest.mark.parametrize("heard", [("accel",), ("accel", "mag")])
def test_six_seconds_are_enough_to_tell_a_unit_that_a_name_tells_wrong(
    heard: tuple[str, ...],
) -> None:
    count = np.arange(600)[:, np.newaxis]
    noise = np.random.default_rng(0).normal(size=(600, 6))
    rates = np.sin(count * [0.02, 0.015, 0.01] + [0, 1.6, 0]) * [1.5, 1.0, 0.8]
    euler = integrate_gyro(rates, 0.01)
    vectors = {
        "accel": accelerometer_at_rest(euler) + 0.03 * noise[:, :3],
        "mag": matrix_from_euler(euler) @ [20.0, 0.0, 43.0],
    }
    log: dict[str, object] = {"t_s": 0.01 * count[:, 0], **{name: vectors[name] for name in heard}}
    rates = rates + 0.005 * noise[:, 3:]
    for unit, wrong in (("rad/s", rates * 180 / np.pi), ("°/s", rates)):
        right = np.radians(wrong) if unit == "rad/s" else np.degrees(wrong)
        read_log({**log, f"gyro ({unit})": right})
        with pytest.raises(ValueError, match=r"gyro: expected rates in .*; pass units=\{'gyro'"):
            read_log({**log, f"gyro ({unit})": wrong})


def test_the_signature_can_be_read() -> None:
    assert len(str(inspect.signature(read_log))) < 400
