"""Where results go: `out` of every function of arrays, by the kernels and by NumPy."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_array_equal
from numpy.typing import NDArray

import chr_notes

Floats = NDArray[np.float64]
EULER, RATES = [0.3, -0.7, 1.9], [1.0, -2.0, 0.5]
Q, P = [0.5, -0.4, 0.6, 0.2], [0.1, 0.9, -0.3, 0.4]
MATRIX = chr_notes.matrix_from_euler(EULER)
SLANTED = [[1.0, 0.02, 0.0], [0.01, 1.0, 0.03], [0.0, 0.0, 1.0]]
THREE_AXIS = chr_notes.ThreeAxisCalibration(SLANTED, [1.0, 1.1, 0.9], [0.1, 0.2, 0.3])
GYRO = chr_notes.RateGyroCalibration(SLANTED, [1.0, 1.1, 0.9], [0.1, 0.2, 0.3], np.eye(3) / 100)
IRON = chr_notes.MagnetometerCalibration(SLANTED, [0.1, 0.2, 0.3])
# Each with arguments for one attitude.
FUNCTIONS: dict[str, tuple[Callable[..., Any], tuple[Any, ...]]] = {
    "matrix_from_euler": (chr_notes.matrix_from_euler, (EULER,)),
    "euler_from_matrix": (chr_notes.euler_from_matrix, (MATRIX,)),
    "euler_rates_matrix": (chr_notes.euler_rates_matrix, (EULER,)),
    "euler_rates_from_body_rates": (chr_notes.euler_rates_from_body_rates, (EULER, RATES)),
    "body_rates_from_euler_rates": (chr_notes.body_rates_from_euler_rates, (EULER, RATES)),
    "wrap_angle": (chr_notes.wrap_angle, (4.0,)),
    "matrix_from_quaternion": (chr_notes.matrix_from_quaternion, (Q,)),
    "quaternion_from_matrix": (chr_notes.quaternion_from_matrix, (MATRIX,)),
    "quaternion_from_euler": (chr_notes.quaternion_from_euler, (EULER,)),
    "euler_from_quaternion": (chr_notes.euler_from_quaternion, (Q,)),
    "quaternion_from_axis_angle": (chr_notes.quaternion_from_axis_angle, (RATES, 0.8)),
    "axis_angle_from_quaternion": (chr_notes.axis_angle_from_quaternion, (Q,)),
    "quaternion_multiply": (chr_notes.quaternion_multiply, (P, Q)),
    "quaternion_conjugate": (chr_notes.quaternion_conjugate, (Q,)),
    "quaternion_inverse": (chr_notes.quaternion_inverse, (Q,)),
    "inclination_from_quaternion": (chr_notes.inclination_from_quaternion, (Q,)),
    "rotate_to_inertial": (chr_notes.rotate_to_inertial, (Q, RATES)),
    "rotate_to_body": (chr_notes.rotate_to_body, (Q, RATES)),
    "tilt_from_accelerometer": (chr_notes.tilt_from_accelerometer, (RATES,)),
    "accelerometer_at_rest": (chr_notes.accelerometer_at_rest, (EULER, 9.8)),
    "heading_from_magnetometer": (chr_notes.heading_from_magnetometer, (RATES, EULER[:2])),
    "validation_factor": (chr_notes.validation_factor, (RATES, EULER[:2], 0.7)),
    "inertial_acceleration": (chr_notes.inertial_acceleration, (RATES, EULER, 9.8)),
    "accelerometer_from_acceleration": (
        chr_notes.accelerometer_from_acceleration,
        (RATES, EULER, 9.8),
    ),
    "drift_from_tilt_error": (chr_notes.drift_from_tilt_error, (0.01, 60.0, 9.8)),
    "ThreeAxisCalibration.measure": (THREE_AXIS.measure, (RATES,)),
    "ThreeAxisCalibration.correct": (THREE_AXIS.correct, (RATES,)),
    "RateGyroCalibration.measure": (GYRO.measure, (RATES, RATES)),
    "RateGyroCalibration.correct": (GYRO.correct, (RATES, RATES)),
    "MagnetometerCalibration.measure": (IRON.measure, (RATES,)),
    "MagnetometerCalibration.correct": (IRON.correct, (RATES,)),
}
pytestmark = pytest.mark.usefixtures("each_way")
every = pytest.mark.parametrize("name", FUNCTIONS)
ROWS = 7


def several(arguments: tuple[Any, ...]) -> list[Floats]:
    """Arguments for several attitudes, each row a little different."""
    if np.shape(arguments[0]) == (3, 3):
        return [chr_notes.matrix_from_euler(np.outer(1 + np.arange(ROWS) / 30, EULER))]
    return [
        np.multiply.outer(1 + np.arange(ROWS) / 30, np.asarray(argument)) for argument in arguments
    ]


def listed(result: Any) -> list[Floats]:  # noqa: ANN401 (an array, or several)
    return list(result) if isinstance(result, tuple) else [result]


def given_out(arrays: list[Floats]) -> Any:  # noqa: ANN401 (an array, or several)
    return arrays[0] if len(arrays) == 1 else tuple(arrays)


LAYOUTS: dict[str, Callable[[tuple[int, ...]], Floats]] = {
    "as it comes": np.empty,
    "every second row": lambda shape: np.empty((2 * shape[0], *shape[1:]))[::2],
    "by columns": lambda shape: np.empty(shape[::-1]).T,
}


@every
@pytest.mark.parametrize("laid_out", LAYOUTS.values(), ids=LAYOUTS)
def test_the_result_is_out(name: str, laid_out: Callable[[tuple[int, ...]], Floats]) -> None:
    call, one = FUNCTIONS[name]
    arguments = several(one)
    expected = listed(call(*arguments))
    out = [laid_out(array.shape) for array in expected]
    found = listed(call(*arguments, out=given_out(out)))
    for each, to, right in zip(found, out, expected, strict=True):
        assert each is to
        assert_array_equal(to, right)


@every
def test_one_attitude_goes_to_an_array_without_leading_axes(name: str) -> None:
    call, one = FUNCTIONS[name]
    expected = listed(call(*one))
    out = [np.empty(np.shape(array)) for array in expected]
    for each, to, right in zip(
        listed(call(*one, out=given_out(out))), out, expected, strict=True
    ):  # fmt: skip
        assert each is to
        assert_array_equal(to, right)


@every
def test_what_cannot_take_the_result_is_refused_with_what_was_expected(name: str) -> None:
    call, one = FUNCTIONS[name]
    arguments = several(one)
    shapes = [array.shape for array in listed(call(*arguments))]
    shape, kind = r"out: expected an array of shape \(7", "out: expected an array of float64, got "
    wrong: list[tuple[Callable[[tuple[int, ...]], Any], type[Exception], str]] = [
        (lambda s: np.empty((s[0] + 1, *s[1:])), ValueError, shape),
        (lambda s: np.empty((1, *s)), ValueError, shape),
        (lambda s: np.broadcast_to(0.0, s), ValueError, f"{shape}.* may not be written to"),
        (lambda s: np.empty(s, np.float32), TypeError, f"{kind}float32"),
        (lambda s: np.empty(s, np.int64), TypeError, f"{kind}int64"),
        (lambda s: np.empty(s).tolist(), TypeError, f"{kind}list"),
    ]
    for make, error, message in wrong:
        with pytest.raises(error, match=message):
            call(*arguments, out=given_out([make(shape) for shape in shapes]))
    if len(shapes) > 1:
        for out in (np.empty(shapes[0]), (np.empty(shapes[0]),)):
            with pytest.raises(TypeError, match=f"out: expected a tuple of {len(shapes)} arrays"):
                call(*arguments, out=out)


@every
@pytest.mark.parametrize("shift", [0, 1, 5])
def test_out_may_overlap_with_an_argument(name: str, shift: int) -> None:
    call, one = FUNCTIONS[name]
    arguments = several(one)
    expected = listed(call(*arguments))
    for place, argument in enumerate(arguments):
        memory = np.zeros(argument.size + shift + sum(array.size for array in expected))
        shared = memory[: argument.size].reshape(argument.shape)
        shared[:] = argument
        out, start = [], shift
        for array in expected:
            out.append(memory[start : start + array.size].reshape(array.shape))
            start += array.size
        call(*arguments[:place], shared, *arguments[place + 1 :], out=given_out(out))
        for to, right in zip(out, expected, strict=True):
            assert_array_equal(to, right)
