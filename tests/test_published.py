"""Other people's numbers: what vendors and libraries document."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import chr_notes

Case = dict[str, Any]
CASES: list[Case] = json.loads(Path(__file__).with_name("published.json").read_text("utf-8"))


def euler(inputs: Case) -> list[float]:
    return [inputs["roll"], inputs["pitch"], inputs["yaw"]]


def rotation_vector(q: list[float]) -> np.ndarray:
    axis, angle = chr_notes.axis_angle_from_quaternion(q)
    return axis * angle


def from_rotation_vector(vector: list[float]) -> np.ndarray:
    return chr_notes.quaternion_from_axis_angle(vector, np.linalg.norm(vector))


def heading(inputs: Case) -> np.ndarray:
    return np.degrees(chr_notes.wrap_angle(np.radians(inputs["yaw_deg"]))) % 360


COMPUTE: dict[str, Callable[[Case], Any]] = {
    "euler_to_R_nav_to_body": lambda i: chr_notes.matrix_from_euler(euler(i)),
    "euler_to_quat": lambda i: chr_notes.quaternion_from_euler(euler(i)),
    "euler_to_quat_list": lambda i: chr_notes.quaternion_from_euler(i["rpy"]),
    "quat_to_R_nav_to_body": lambda i: chr_notes.matrix_from_quaternion(i["q"]),
    "rotate_nav_vector_into_body": lambda i: chr_notes.rotate_to_body(i["q"], i["v_nav"]),
    "quat_to_euler": lambda i: chr_notes.euler_from_quaternion(i["q"], on_gimbal_lock="ignore"),
    "R_nav_to_body_to_quat": lambda i: chr_notes.quaternion_from_matrix(i["R"]),
    "R_nav_to_body_to_euler": lambda i: chr_notes.euler_from_matrix(i["R"]),
    "quat_product": lambda i: chr_notes.quaternion_multiply(i["p"], i["q"]),
    "rotvec_to_quat": lambda i: from_rotation_vector(i["rotvec"]),
    "quat_to_rotvec": lambda i: rotation_vector(i["q"]),
    "heading_wrap_0_360": heading,
    "wrap_to_pi": lambda i: chr_notes.wrap_angle(np.radians(i["angle_deg"])),
    "tilt_from_accel": lambda i: np.degrees(chr_notes.tilt_from_accelerometer(i["f_body"])),
}
QUATERNIONS = ("euler_to_quat", "euler_to_quat_list", "R_nav_to_body_to_quat", "rotvec_to_quat")


def test_there_are_cases() -> None:
    assert len(CASES) == 25


@pytest.mark.parametrize("case", CASES, ids=lambda case: str(case["id"]))
def test_case(case: Case) -> None:
    got = np.asarray(COMPUTE[case["kind"]](case["inputs"]))
    expected = case["expected"]
    if isinstance(expected, dict):
        expected = list(expected.values())
    expected = np.asarray(expected, dtype=float)
    assert got.shape == expected.shape
    off = np.abs(got - expected)
    if case["kind"] in QUATERNIONS:
        # The documents write a quaternion with either sign.
        off = np.minimum(np.abs(got - expected).max(axis=-1), np.abs(got + expected).max(axis=-1))
    assert off.max() <= case["abs_tol"]
