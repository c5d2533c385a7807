"""Models of sensors, there and back."""

import copy
import pickle
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from chr_notes import MagnetometerCalibration, RateGyroCalibration, ThreeAxisCalibration

seeds = st.integers(0, 2**32 - 1)
shapes = st.sampled_from([(), (4,), (2, 5), (0,)])
EYE, ONES, ZEROS = np.eye(3), np.ones(3), np.zeros(3)


def terms(generator: np.random.Generator, degree: int) -> tuple[Any, Any, Any]:
    """Misalignment near the identity; sensitivities away from zero for temperatures up to 1."""
    sensitivity = np.concatenate(
        [generator.uniform(1.0, 3.0, (1, 3)), generator.uniform(-0.3, 0.3, (degree, 3))]
    )
    misalignment = EYE + generator.uniform(-0.2, 0.2, (3, 3))
    return misalignment, sensitivity, generator.normal(size=(degree + 1, 3))


@given(seeds, shapes, st.integers(0, 3))
def test_corrected_measurements_are_what_was_there(
    seed: int, shape: tuple[int, ...], degree: int
) -> None:
    generator = np.random.default_rng(seed)
    misalignment, sensitivity, bias = terms(generator, degree)
    actual, accel = generator.normal(size=(2, *shape, 3))
    temperature = generator.uniform(-1.0, 1.0, shape)
    sensor = ThreeAxisCalibration(misalignment, sensitivity, bias)
    measured = sensor.measure(actual, temperature)
    assert measured.shape == actual.shape
    assert_allclose(sensor.correct(measured, temperature), actual, atol=1e-12)
    coupling = generator.normal(size=(3, 3))
    gyro = RateGyroCalibration(misalignment, sensitivity, bias, coupling)
    measured = gyro.measure(actual, accel, temperature)
    assert_allclose(gyro.correct(measured, accel, temperature), actual, atol=1e-11)
    magnetometer = MagnetometerCalibration(misalignment, bias[0])
    assert_allclose(magnetometer.correct(magnetometer.measure(actual)), actual, atol=1e-12)


@given(seeds)
def test_measurements_follow_the_model(seed: int) -> None:
    generator = np.random.default_rng(seed)
    misalignment, sensitivity, bias = terms(generator, 2)
    actual, accel, hard_iron = generator.normal(size=(3, 3))
    coupling, degrees = generator.normal(size=(3, 3)), 0.7
    scale, offset = (c[0] + c[1] * degrees + c[2] * degrees**2 for c in (sensitivity, bias))
    assert_allclose(
        ThreeAxisCalibration(misalignment, sensitivity, bias).measure(actual, degrees),
        misalignment @ (scale * actual - offset),
        atol=1e-12,
    )
    assert_allclose(
        RateGyroCalibration(misalignment, sensitivity, bias, coupling).measure(
            actual, accel, degrees
        ),
        misalignment @ (scale * actual - offset + coupling @ accel),
        atol=1e-12,
    )
    assert_allclose(
        MagnetometerCalibration(misalignment, hard_iron).correct(actual),
        misalignment @ actual - hard_iron,
        atol=1e-12,
    )


def test_temperatures_broadcast_with_measurements() -> None:
    sensor = ThreeAxisCalibration(EYE, [ONES, ONES], ZEROS)
    assert sensor.measure(ONES, np.zeros((4, 2))).shape == (4, 2, 3)
    assert_allclose(sensor.measure(ONES, [0.0, 1.0, 2.0]), [ONES, 2 * ONES, 3 * ONES])


def test_nan_stays_in_its_row() -> None:
    sensor = ThreeAxisCalibration(EYE, ONES, ZEROS)
    rows = np.ones((3, 3))
    rows[1, 2] = np.nan
    kept = np.isfinite(sensor.correct(rows)).all(axis=1)
    assert kept.tolist() == [True, False, True]


def test_parameters_are_copied_and_cannot_be_changed() -> None:
    bias = np.zeros(3)
    sensor = ThreeAxisCalibration(EYE, ONES, bias)
    bias[0] = 9.0
    assert_array_equal(sensor.measure(ZEROS), ZEROS)
    with pytest.raises(ValueError, match="read-only"):
        sensor.misalignment[0, 0] = 2.0


SINGULAR = [[1.0, 2, 3], [2, 4, 6], [0, 0, 1]]
REFUSED = {
    "singular misalignment": (
        lambda: ThreeAxisCalibration(SINGULAR, ONES, ZEROS),
        r"misalignment: expected an invertible matrix, got a singular one: \[\[1\.0, 2\.0, 3\.0\]",
    ),
    "singular misalignment of a gyro": (
        lambda: RateGyroCalibration(SINGULAR, ONES, ZEROS, EYE),
        "misalignment: expected an invertible matrix",
    ),
    "singular soft iron": (
        lambda: MagnetometerCalibration(SINGULAR, ZEROS),
        "soft_iron: expected an invertible matrix",
    ),
    "zero sensitivity": (
        lambda: ThreeAxisCalibration(EYE, [1.0, 0, 1], ZEROS),
        "sensitivity: expected no zeros, got one on the y-axis",
    ),
    "zero sensitivity at every temperature": (
        lambda: RateGyroCalibration(EYE, [[1.0, 1, 0], [1, 1, 0]], ZEROS, EYE),
        "sensitivity: expected no zeros, got one on the z-axis",
    ),
    "zero sensitivity at a temperature": (
        lambda: ThreeAxisCalibration(EYE, [ONES, -ONES], ZEROS).measure(ONES, [0.0, 1.0]),
        "sensitivity: expected no zeros, got one on the x-axis at one of the temperatures",
    ),
    "no temperature": (
        lambda: ThreeAxisCalibration(EYE, ONES, [ZEROS, ONES]).correct(ONES),
        "temperature: expected one, because sensitivity or bias depends on it, got None",
    ),
    "shape of the misalignment": (
        lambda: ThreeAxisCalibration(ONES, ONES, ZEROS),
        r"misalignment: expected shape \(\.\.\., 3, 3\), got \(3,\)",
    ),
    "many misalignments": (
        lambda: ThreeAxisCalibration([EYE, EYE], ONES, ZEROS),
        r"misalignment: expected shape \(3, 3\), got \(2, 3, 3\)",
    ),
    "shape of the sensitivity": (
        lambda: ThreeAxisCalibration(EYE, [1.0, 1.0], ZEROS),
        r"sensitivity: expected shape \(3,\) or \(n, 3\), got \(2,\)",
    ),
    "shape of the bias": (
        lambda: ThreeAxisCalibration(EYE, ONES, 0.0),
        r"bias: expected shape \(3,\) or \(n, 3\), got \(\)",
    ),
    "NaN in the bias": (
        lambda: ThreeAxisCalibration(EYE, ONES, [0.0, np.nan, 0.0]),
        r"bias: expected finite numbers, got \[0\.0, nan, 0\.0\]",
    ),
    "shape of the coupling": (
        lambda: RateGyroCalibration(EYE, ONES, ZEROS, ONES),
        r"g_sensitivity: expected shape \(\.\.\., 3, 3\), got \(3,\)",
    ),
    "shape of the hard iron": (
        lambda: MagnetometerCalibration(EYE, 1.0),
        r"hard_iron: expected shape \(\.\.\., 3\), got \(\)",
    ),
    "shape of a measurement": (
        lambda: ThreeAxisCalibration(EYE, ONES, ZEROS).correct([1.0, 2.0]),
        r"measured: expected shape \(\.\.\., 3\), got \(2,\)",
    ),
    "lengths that differ": (
        lambda: RateGyroCalibration(EYE, ONES, ZEROS, EYE).correct(
            np.ones((2, 3)), np.ones((4, 3))
        ),
        r"expected accel and measured with leading axes .*, got shapes \(4, 3\) and \(2, 3\)",
    ),
    "temperatures of another length": (
        lambda: ThreeAxisCalibration(EYE, [ONES, ONES], ZEROS).measure(np.ones((2, 3)), np.ones(4)),
        r"expected temperature and actual with leading .*, got shapes \(4, 3\) and \(2, 3\)",
    ),
}


def test_complex_parameters_are_refused() -> None:
    with pytest.raises(TypeError, match="sensitivity: expected real numbers, got complex128"):
        ThreeAxisCalibration(EYE, np.array([1.0, 1j, 1.0]), ZEROS)


@pytest.mark.parametrize(("call", "message"), REFUSED.values(), ids=REFUSED)
def test_what_cannot_be_a_sensor_is_refused(call: Any, message: str) -> None:  # noqa: ANN401
    with pytest.raises(ValueError, match=message):
        call()


Calibration = ThreeAxisCalibration | RateGyroCalibration | MagnetometerCalibration
CALIBRATIONS: tuple[Calibration, ...] = (
    ThreeAxisCalibration(np.eye(3), [1.0, 2.0, 3.0], [0.1, 0.2, 0.3]),
    RateGyroCalibration(np.eye(3), [1.0, 2.0, 3.0], [0.1, 0.2, 0.3], np.zeros((3, 3))),
    MagnetometerCalibration(np.eye(3), [0.1, 0.2, 0.3]),
)


def pickled(calibration: Calibration) -> Calibration:
    found: Calibration = pickle.loads(pickle.dumps(calibration))  # noqa: S301 (our own)
    return found


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, pickled])
@pytest.mark.parametrize("calibration", CALIBRATIONS, ids=lambda c: type(c).__name__)
def test_a_copy_is_as_guarded_as_what_it_was_made_of(
    copied: Callable[[Calibration], Calibration], calibration: Calibration
) -> None:
    found = copied(calibration)
    assert type(found) is type(calibration)
    for name, value in vars(calibration).items():
        if name == "temperatures":
            assert getattr(found, name) == value
            continue
        assert_array_equal(getattr(found, name), value)
        with pytest.raises(ValueError, match="read-only"):
            getattr(found, name)[0] = 0.0
