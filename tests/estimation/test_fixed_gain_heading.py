"""The fixed-gain observer with a magnetometer."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from chr_notes import (
    accelerometer_at_rest,
    fixed_gain_observer,
    heading_from_magnetometer,
    integrate_gyro,
    matrix_from_euler,
    observe,
    wrap_angle,
)


def test_a_magnetometer_corrects_yaw() -> None:
    count = 3000
    rates = np.full((count, 3), 0.0)
    rates[:, 2] = 0.5
    truth = integrate_gyro(rates, 0.01, [0.0, 0.0, 1.0])
    forces = accelerometer_at_rest(truth)
    field = matrix_from_euler(truth) @ [20.0, 0.0, 40.0]
    drifting = rates + np.array([0.0, 0.0, 0.01])
    for gain in (0.02, 1.0):
        euler = fixed_gain_observer(drifting, forces, 0.01, 0.02, mag=field, heading_gain=gain)
        assert abs(wrap_angle(euler[0, 2] - truth[0, 2])) < 1e-9
        # As of any angle: the bias times the step, times what is kept, over the gain.
        stated = 0.01 * 0.01 * (1 - gain) / gain
        assert wrap_angle(euler[-1, 2] - truth[-1, 2]) == pytest.approx(stated, abs=1e-3)
    alone = heading_from_magnetometer(field, euler[:, :2])
    assert_allclose(wrap_angle(alone - euler[:, 2]), 0, atol=1e-9)
    gyros = fixed_gain_observer(drifting, forces, 0.01, 0.02, mag=field, heading_gain=0.0)
    assert_allclose(gyros[1:, :2], euler[1:, :2], atol=1e-3)
    assert abs(wrap_angle(gyros[-1, 2] - truth[-1, 2])) > 0.2


def test_a_field_that_is_none_changes_nothing() -> None:
    rates, forces = np.full((5, 3), 0.1), np.full((5, 3), [0.0, 0.1, -9.8])
    without = fixed_gain_observer(rates, forces, 0.01, 0.1)
    for none in (np.nan, 0.0, np.inf):
        field = np.full((5, 3), none)
        assert_allclose(fixed_gain_observer(rates, forces, 0.01, 0.1, mag=field), without)
    assert fixed_gain_observer(rates[:0], forces[:0], 0.01, 0.1, mag=field[:0]).shape == (0, 3)


def test_a_magnetometer_is_refused_where_it_has_no_meaning() -> None:
    rates = forces = np.ones((5, 3))
    with pytest.raises(ValueError, match='none for the method "euler"'):
        fixed_gain_observer(rates, forces, 0.01, 0.1, mag=forces, method="euler")
    with pytest.raises(ValueError, match="heading_gain: expected a number from 0 to 1"):
        fixed_gain_observer(rates, forces, 0.01, 0.1, mag=forces, heading_gain=2.0)
    for reference in ((0.0, 0.0), (np.nan, 1.0), 1.0, (1.0, 2.0, 3.0)):
        with pytest.raises(ValueError, match="reference: expected"):
            fixed_gain_observer(rates, forces, 0.01, 0.1, mag=forces, reference=reference)


def test_a_stream_gives_the_same_numbers() -> None:
    generator = np.random.default_rng(3)
    rates = generator.normal([0, 0, 20.0], 2.0, (300, 3))  # yaw goes round several times
    forces = generator.normal([0, 0, -9.8], 3.0, (300, 3))
    field = generator.normal([20, 5, 40.0], 5.0, (300, 3))
    forces[100], field[150], field[200] = np.nan, np.nan, 0.0
    steps = generator.uniform(0.001, 0.02, 300)
    said = {"heading_gain": 0.1, "reference": (2.0, 0.3)}
    for initial in (None, [0.1, -0.2, 3.0]):
        expected = fixed_gain_observer(rates, forces, steps, 0.05, initial, mag=field, **said)
        stream = zip(rates, forces, steps, field, strict=True)
        streamed = list(observe(stream, 0.05, initial, **said))
        assert_allclose([each.euler for each in streamed], expected, rtol=0, atol=2e-14)
        assert streamed[-1].held_out == 1


def test_a_stream_refuses_what_a_recording_refuses() -> None:
    sample = ([0.0] * 3, [0.0, 0.0, -9.8], 0.01, [20.0, 0.0, 40.0])
    with pytest.raises(ValueError, match='none for the method "euler"'):
        next(observe([sample], 0.1, method="euler"))
    with pytest.raises(ValueError, match="heading_gain: expected a number from 0 to 1"):
        next(observe([sample], 0.1, heading_gain=2.0))
    with pytest.raises(ValueError, match="reference: expected"):
        next(observe([sample], 0.1, reference=(0.0, 0.0)))
    with pytest.raises(ValueError, match=r"mag: expected shape"):
        next(observe([(*sample[:3], [1.0, 2.0])], 0.1))
