"""Descriptions of conventions: each preset by a number of that system, and conversion."""

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

import chr_notes
from chr_notes import Convention, convert
from chr_notes.systems.convention import DOCUMENTED, PRESETS
from tests.sampling import few

CASES = json.loads((Path(__file__).parents[1] / "published.json").read_text(encoding="utf-8"))
PUBLISHED = {case["id"]: case for case in CASES}
KINDS = ("angles", "matrix", "quaternion")
ELEMENT = st.floats(-1, -0.01) | st.floats(0.01, 1)


def expected(name: str) -> np.ndarray:
    return np.asarray(PUBLISHED[name]["expected"])


def within(system: str, angles: Any, kind: Any) -> np.ndarray:  # noqa: ANN401
    """What a system says of an attitude that it has as angles."""
    own = PRESETS[system]
    made = chr_notes.matrix_from_angles if kind == "matrix" else chr_notes.quaternion_from_angles
    return convert(made(angles, own.sequence), room_of(own), own, kind=kind)


def room_of(convention: Convention) -> Convention:
    """This package's convention with the axes of another."""
    return Convention(navigation=convention.navigation, body=convention.body)


def test_matlab() -> None:
    angles = [0.7854, 0.1, 0.0]  # yaw, pitch, roll
    assert_allclose(within("MATLAB", angles, "matrix"), expected("ml_angle2dcm"), atol=6e-5)
    assert_allclose(within("MATLAB", angles, "quaternion"), expected("ml_angle2quat"), atol=6e-5)


def test_px4() -> None:
    angles = [0.1, 0.2, 0.3]
    assert_allclose(within("PX4", angles, "quaternion"), expected("px4_euler_quat"), atol=2e-8)
    # The case has it transposed: PX4's own leads from body to navigation.
    assert_allclose(within("PX4", angles, "matrix"), expected("px4_euler_dcm").T, atol=2e-8)


def test_scipy() -> None:
    angles = [0.3, -0.2, 0.1]
    theirs = Rotation.from_euler("ZYX", angles)
    assert_allclose(within("SciPy", angles, "matrix"), theirs.as_matrix(), atol=1e-15)
    assert_allclose(within("SciPy", angles, "quaternion"), theirs.as_quat(), atol=1e-15)
    v = [1.0, 2.0, 3.0]
    match = chr_notes.find_conventions(quaternion=theirs.as_quat(), angles=angles,
                                       vectors=(v, theirs.apply(v)), degrees=False)[0]  # fmt: skip
    assert match.convention == replace(PRESETS["SciPy"], matrix="to body")


def test_three_js() -> None:
    # Computed by its release 187: Quaternion.setFromEuler and Matrix4.makeRotationFromEuler.
    angles = [0.1, -0.3, 0.25]
    q = [0.03042450650213978, -0.1542480354593522, 0.11571018945327342, 0.9807614618334669]
    assert_allclose(within("three.js", angles, "quaternion"), q, atol=1e-15)
    columns = [
        [0.9256373912272359, 0.21758234839888901, 0.3096019083068793],
        [-0.23635402982999043, 0.9713710029215775, 0.02398222813360712],
        [-0.29552020666133955, -0.09537450575679464, 0.9505637859220633],
    ]
    assert_allclose(within("three.js", angles, "matrix"), np.transpose(columns), atol=1e-15)


@pytest.mark.parametrize("name", ["ROS", "ROS (local frame)"])
def test_ros_angles(name: str) -> None:
    # From the documentation of tf.transformations: quaternion_from_euler(1, 2, 3, 'ryxz').
    own = replace(PRESETS[name], sequence="YXZ")
    q = convert(chr_notes.quaternion_from_angles([1, 2, 3], "YXZ"), room_of(own), own,
                kind="quaternion")  # fmt: skip
    assert_allclose(q, [0.310622, -0.718287, 0.444435, 0.435953], atol=1e-6)
    # And the sum of the first row of euler_matrix(1, 2, 3, 'syxz').
    own = replace(PRESETS[name], sequence="yxz")
    matrix = convert(chr_notes.matrix_from_angles([1, 2, 3], "yxz"), room_of(own), own,
                     kind="matrix")  # fmt: skip
    assert matrix[0].sum() == pytest.approx(-1.34786452, abs=1e-8)


def test_ros_axes() -> None:
    # REP 103: x forward, y left, z up; east, north, up.
    assert_allclose(convert([1, 2, 3], "ROS", "this book", kind="body vector"), [1, -2, -3])
    assert_allclose(convert([1, 2, 3], "ROS", "this book", kind="navigation vector"), [2, 1, -3])


@few(10)
@given(q=st.tuples(ELEMENT, ELEMENT, ELEMENT, ELEMENT))
def test_ros_in_its_local_frame(q: tuple[float, ...]) -> None:
    """Unity's own connector (ROSGeometry, FLU) has (-y, z, x, -w); for the Earth's frame (ENU) it
    turns by 90° of yaw as well, where z of the scene is north."""
    x, y, z, w = np.array(q) / np.linalg.norm(q) * np.sign(q[3])
    local = convert([x, y, z, w], "ROS (local frame)", "Unity", kind="quaternion")
    assert_allclose(local, [y, -z, -x, w], atol=1e-15)
    unreal = convert([x, y, z, w], "ROS (local frame)", "Unreal", kind="quaternion")
    assert_allclose(unreal, [-x, y, -z, w], atol=1e-15)
    earth = convert([0, 0, 0, 1], "ROS", "Unity", kind="quaternion", to="angles")
    assert_allclose(earth, [0, 90, 0], atol=1e-13)


def test_chr() -> None:
    a, b, c, d = q = np.array([0.8, 0.3, -0.4, 0.2]) / np.linalg.norm([0.8, 0.3, -0.4, 0.2])
    # Section 4 of the note, which the sensors compute.
    said = [
        np.arctan2(2 * (a * b + c * d), a**2 - b**2 - c**2 + d**2),
        -np.arcsin(2 * (b * d - a * c)),
        np.arctan2(2 * (a * d + b * c), a**2 + b**2 - c**2 - d**2),
    ]
    back = convert(np.degrees(said), "CHR", "this book", kind="angles")
    assert_allclose(chr_notes.quaternion_from_euler(back), q, atol=1e-15)


def top_and_screen(angles: list[float]) -> tuple[np.ndarray, np.ndarray]:
    """Where a phone's top and its screen point, east, north and up, by a browser's angles."""
    matrix = convert(angles, "browser", "browser", kind="angles", to="matrix")
    return matrix[:, 1].round(12), matrix[:, 2].round(12)


def test_browser() -> None:
    # The examples of the specification: flat with its top to the west; upright, as someone holds it
    # who looks 30° east of north; and with one longer edge down.
    east, north, up = np.eye(3)
    top, screen = top_and_screen([90.0, 0.0, 0.0])
    assert_allclose([top, screen], [-east, up])
    top, screen = top_and_screen([360.0 - 30.0, 90.0, 0.0])
    assert_allclose([top, screen], [up, -np.sqrt(0.75) * north - 0.5 * east])
    top, screen = top_and_screen([270.0 - 30.0, 0.0, 90.0])
    assert_allclose([abs(top @ up), screen @ up], [0.0, 0.0], atol=1e-12)
    assert_allclose(screen, -np.sqrt(0.75) * north - 0.5 * east)


def test_android() -> None:
    # getOrientation of a matrix of getRotationMatrix, as its source has it.
    q = np.array([0.8, 0.3, -0.4, 0.2])
    r = convert(q, "Android", "Android", kind="quaternion", to="matrix").ravel()
    said = [np.arctan2(r[1], r[4]), np.arcsin(-r[7]), np.arctan2(-r[6], r[8])]
    found = convert(q, "Android", "Android", kind="quaternion", to="angles")
    assert_allclose(found, said, atol=1e-15)
    # The rows of its matrix are east, north and up: with its top raised and facing east, the
    # azimuth is a quarter and the pitch negative.
    raised = convert([np.pi / 2, -0.3, 0.0], "Android", "CHR", kind="angles")
    assert_allclose(raised, [0.0, np.degrees(0.3), 90.0], atol=1e-12)


def test_fusion() -> None:
    # Computed by its release 1.3.3, in single precision: quaternion_to_euler, quaternion_to_matrix.
    q = [0.8, 0.3, -0.4, 0.2]
    angles = convert(q, "Fusion", "Fusion", kind="quaternion", to="angles")
    assert_allclose(angles, [36.65611, -54.8059, 8.583618], atol=1e-5)
    matrix = convert(q, "Fusion", "Fusion", kind="quaternion", to="matrix")
    row = [0.5698925, -0.60215056, -0.5591398]
    assert_allclose(matrix[:2], [row, [0.08602148, 0.72043014, -0.6881721]], atol=1e-6)


def test_unreal_by_its_formulas() -> None:
    pitch, yaw, roll = 20.0, 30.0, 10.0
    (sp, cp), (sy, cy), (sr, cr) = (
        (np.sin(half), np.cos(half)) for half in np.radians([pitch, yaw, roll]) / 2
    )
    said = [
        cr * sp * sy - sr * cp * cy,
        -cr * sp * cy - sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
        cr * cp * cy + sr * sp * sy,
    ]
    found = convert([pitch, yaw, roll], "Unreal", "Unreal", kind="angles", to="quaternion")
    assert_allclose(found, said, atol=1e-15)
    # The nose up, the right side down and to the right are positive, as here.
    assert_allclose(
        convert([10.0, 20.0, 30.0], "CHR", "Unreal", kind="angles"), [20, 30, 10], atol=1e-12
    )
    assert DOCUMENTED["Unreal"].handedness == "left"


def test_madgwick_by_his_formulas() -> None:
    q = np.array([0.8, 0.3, -0.4, 0.2]) / np.linalg.norm([0.8, 0.3, -0.4, 0.2])
    a, b, c, d = q * [1, -1, -1, -1]  # conjugated first, as in his programs
    said = [
        np.arctan2(2 * b * c - 2 * a * d, 2 * a**2 + 2 * b**2 - 1),
        -np.arcsin(2 * b * d + 2 * a * c),
        np.arctan2(2 * c * d - 2 * a * b, 2 * a**2 + 2 * d**2 - 1),
    ]
    found = convert(q, "Madgwick", "Madgwick", kind="quaternion", to="angles")
    assert_allclose(found, said, atol=1e-15)


@pytest.mark.parametrize("name", PRESETS | DOCUMENTED)
@few(5)
@given(q=st.tuples(ELEMENT, ELEMENT, ELEMENT, ELEMENT))
def test_there_and_back(name: str, q: tuple[float, ...]) -> None:
    matrix = chr_notes.matrix_from_quaternion(q)
    values = {
        "angles": chr_notes.euler_from_matrix(matrix, on_gimbal_lock="ignore"),
        "matrix": matrix,
        "quaternion": chr_notes.quaternion_from_matrix(matrix),
    }
    for kind in KINDS:
        there = convert(values[kind], "this book", name, kind=kind)  # type: ignore[arg-type]
        back = convert(there, name, "this book", kind=kind)  # type: ignore[arg-type]
        assert_allclose(_matrix(back, kind), matrix, atol=1e-14)


def _matrix(value: np.ndarray, kind: str) -> np.ndarray:
    if kind == "matrix":
        return value
    from_angles = kind == "angles"
    return (chr_notes.matrix_from_euler if from_angles else chr_notes.matrix_from_quaternion)(value)


def test_a_body_seen_in_either_system_points_the_same_way() -> None:
    euler = [0.1, 0.2, 0.3]
    matrix = chr_notes.matrix_from_euler(euler)
    for name, system in (PRESETS | DOCUMENTED).items():
        theirs = convert(matrix, "this book", name, kind="matrix")
        nose = convert([1.0, 0.0, 0.0], "this book", name, kind="body vector")
        to_room = theirs if system.matrix_is_transposed else theirs.T
        ahead = convert(to_room @ nose, name, "this book", kind="navigation vector")
        assert_allclose(ahead, matrix[0], atol=1e-15)


def test_unity_turns_by_the_left_hand() -> None:
    assert DOCUMENTED["Unity"].handedness == "left"
    assert PRESETS["ROS"].handedness == "right"
    # x raises the nose when negative, y turns it to the right, z rolls to the left.
    angles = convert([10.0, 20.0, 30.0], "CHR", "Unity", kind="angles")
    assert_allclose(angles, [-20.0, 30.0, -10.0], atol=1e-12)


def test_what_is_no_description_is_refused() -> None:
    for wrong, said in (
        ({"sequence": "ZZX"}, "sequence: expected"),
        ({"matrix": "body"}, "matrix: expected"),
        ({"body": "frf"}, "body: expected three"),
        ({"body": "fru"}, "one handedness"),
        ({"sequence": "ZYX", "written": "xyy"}, "written: expected"),
        ({"sequence": "ZXZ", "negated": "y"}, "negated: expected"),
    ):
        with pytest.raises(ValueError, match=said):
            Convention(**wrong)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="source: expected a Convention or one of"):
        convert([0, 0, 0], "Excel", "ROS", kind="angles")
    with pytest.raises(ValueError, match="kind: expected"):
        convert([0, 0, 0], "CHR", "ROS", kind="euler")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="expected rotations"):
        convert(np.ones((3, 3)), "CHR", "ROS", kind="matrix")
