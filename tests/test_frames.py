"""Axes and angles of other systems, against the definitions that those systems give."""

from typing import Any

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from numpy.testing import assert_allclose
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

import chr_notes
from chr_notes import change_angles, change_axes, change_quaternion
from chr_notes.frames import System

from .attitudes import of_quaternion

Floats = NDArray[np.float64]
SYSTEMS: tuple[System, ...] = ("notes", "ros", "android", "browser")
angles = st.floats(-3.1, 3.1)
eulers = st.tuples(angles, st.floats(-1.5, 1.5), angles).map(np.array)
AXES = {"ros": ("enu", "flu"), "android": ("enu", "rfu"), "browser": ("enu", "rfu")}


def device_to_room(euler: Floats, system: str) -> Floats:
    """The matrix that other systems call the rotation: columns are the body's axes in the room."""
    room, body = AXES[system]
    down = chr_notes.matrix_from_euler(euler).T  # north-east-down from forward-right-down
    axes = change_axes(np.eye(3), body, "frd").T  # type: ignore[arg-type]
    return change_axes((down @ axes).T, "ned", room).T  # type: ignore[arg-type]


def test_named_axes_are_what_their_names_say() -> None:
    forward, right, down = np.eye(3)
    assert_allclose(change_axes([forward, -right, -down], "frd", "flu"), np.eye(3))
    assert_allclose(change_axes([right, forward, -down], "frd", "rfu"), np.eye(3))
    north, east = forward, right
    assert_allclose(change_axes([east, north, -down], "ned", "enu"), np.eye(3))
    # A phone that lies on its back with its top to the north: its x is east.
    assert_allclose(change_axes([1, 2, 3], "rfu", "flu"), [2, -1, 3])


@given(eulers)
def test_quaternions_turn_the_bodys_axes_into_the_rooms(euler: Floats) -> None:
    q = chr_notes.quaternion_from_euler(euler)
    for system in ("ros", "android", "browser"):
        found = change_quaternion(q, "notes", system)
        assert_allclose(of_quaternion(found).as_matrix(), device_to_room(euler, system), atol=1e-14)
        back = change_quaternion(found, system, "notes")
        assert (of_quaternion(back).inv() * of_quaternion(q)).magnitude() < 1e-14


@given(eulers)
def test_angles_of_ros_are_fixed_axis_angles_in_its_frames(euler: Floats) -> None:
    found = change_angles(euler, "notes", "ros")
    # REP 103: about fixed axes x, y, z of the room.
    expected = Rotation.from_matrix(device_to_room(euler, "ros"))
    assert (expected.inv() * Rotation.from_euler("xyz", found)).magnitude() < 1e-14
    roll, pitch, yaw = euler
    closed = np.array([roll, -pitch, np.pi / 2 - yaw])
    assert_allclose(np.exp(1j * found), np.exp(1j * closed), atol=1e-13)


@given(eulers)
def test_angles_of_android_are_those_of_its_source(euler: Floats) -> None:
    matrix = device_to_room(euler, "android").ravel()
    azimuth, pitch = np.arctan2(matrix[1], matrix[4]), np.arcsin(-matrix[7])
    roll = np.arctan2(-matrix[6], matrix[8])
    found = change_angles(euler, "notes", "android")
    assert_allclose(np.exp(1j * found), np.exp(1j * np.array([azimuth, pitch, roll])), atol=1e-7)
    assert_allclose(change_angles(found, "android", "notes"), euler, atol=1e-13)


@example(np.array([np.nextafter(np.pi / 2, 2), 0.3, 0.0]))
@example(np.array([1.447433435930676, 1.46875, 0.0]))  # alpha rounds to a whole turn
@given(eulers)
def test_angles_of_a_browser_turn_about_z_x_and_y(euler: Floats) -> None:
    found = change_angles(euler, "notes", "browser")
    expected = Rotation.from_matrix(device_to_room(euler, "browser"))
    assert (expected.inv() * Rotation.from_euler("ZXY", found)).magnitude() < 1e-13
    alpha, beta, gamma = found
    assert 0 <= alpha < 2 * np.pi
    assert -np.pi <= beta < np.pi
    assert -np.pi / 2 <= gamma < np.pi / 2
    assert_allclose(
        np.exp(1j * change_angles(found, "browser", "notes")), np.exp(1j * euler), atol=1e-12
    )


@pytest.mark.parametrize("source", SYSTEMS)
@pytest.mark.parametrize("target", SYSTEMS)
def test_there_and_back_is_the_same_attitude(source: System, target: System) -> None:
    given_ = np.random.default_rng(4).uniform(-1.5, 1.5, (50, 3))
    there = change_angles(given_, source, target)
    back = change_angles(there, target, source)
    rebuilt, meant = (
        of_quaternion(chr_notes.quaternion_from_euler(change_angles(each, source, "notes")))
        for each in (back, given_)
    )
    assert (rebuilt.inv() * meant).magnitude().max() < 1e-13


@pytest.mark.parametrize("pitch", [np.pi / 2, -np.pi / 2])
def test_the_pole_rebuilds_the_attitude(pitch: float) -> None:
    euler = np.array([0.4, pitch, 1.1])
    for system in SYSTEMS:
        there = change_angles(euler, "notes", system)
        back = of_quaternion(chr_notes.quaternion_from_euler(change_angles(there, system, "notes")))
        assert (
            back.inv() * of_quaternion(chr_notes.quaternion_from_euler(euler))
        ).magnitude() < 1e-7


def test_missing_numbers_stay_missing() -> None:
    for system in SYSTEMS:
        assert np.isnan(change_angles([np.nan, 0.0, 0.0], "notes", system)).all()


REFUSED: dict[str, tuple[Any, str]] = {
    "axes of body and room": (
        lambda: change_axes([1, 2, 3], "flu", "ned"),
        "expected source and target of frd, flu, rfu, or both of ned, enu, got 'flu' and 'ned'",
    ),
    "an unknown system": (
        lambda: change_angles([0, 0, 0], "unity", "notes"),  # type: ignore[arg-type]
        "source: expected one of notes, ros, android, browser, got 'unity'",
    ),
    "a pair": (lambda: change_axes([1, 2], "flu", "frd"), r"vector: expected shape"),
}


@pytest.mark.parametrize(("call", "message"), REFUSED.values(), ids=REFUSED)
def test_wrong_arguments_are_refused(call: Any, message: str) -> None:  # noqa: ANN401
    with pytest.raises(ValueError, match=message):
        call()
