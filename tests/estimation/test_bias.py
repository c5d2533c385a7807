"""The bias of a recording: where it is taken from, and where there is none to take."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from numpy.typing import NDArray

from chr_notes.estimation.bias import bias_of
from chr_notes.sensors.still import static_interval

Floats = NDArray[np.float64]
STEP, LONGEST = np.array(0.01), 0.15
BIAS = np.array([0.01, -0.02, 0.005])


def moving(count: int, seed: int = 0) -> Floats:
    """Rates of a body that turns this way and that, and rests from sample 3000 to 3500."""
    random = np.random.default_rng(seed)
    rates = np.sin(np.arange(count) * 0.03)[:, np.newaxis] * [1.0, 0.7, 0.4]
    rates[3000:3500] = 0.0
    return np.asarray(rates + BIAS + 0.002 * random.normal(size=(count, 3)))


@pytest.mark.parametrize("count", [4000, 60_000])
def test_the_stillest_two_seconds(count: int) -> None:
    rates = moving(count)
    found = next(bias_of("stillest", rates, rates, STEP, LONGEST)[0])
    assert_allclose(found, rates[static_interval(rates, 200)].mean(axis=0), atol=1e-12)
    assert_allclose(found, BIAS, atol=6e-4)


@pytest.mark.parametrize("glitch", [1.0, 1e7, 1e200, np.nan, np.inf])
@pytest.mark.parametrize("place", [100, 3140, 3150])
def test_one_glitch_moves_nothing(glitch: float, place: int) -> None:
    rates = moving(20_000)
    rates[place, 1] = glitch
    assert_allclose(next(bias_of("stillest", rates, rates, STEP, LONGEST)[0]), BIAS, atol=6e-4)


def test_given_ones() -> None:
    rates = moving(10)
    assert_array_equal(next(bias_of(0.1, rates, rates, STEP, LONGEST)[0]), [-0.1] * 3)
    assert_array_equal(next(bias_of(BIAS, rates, rates, STEP, LONGEST)[0]), -BIAS)
    with pytest.raises(ValueError, match="bias: expected finite numbers"):
        next(bias_of(np.nan, rates, rates, STEP, LONGEST)[0])


def test_no_rest_is_said() -> None:
    rates = moving(2000)
    with pytest.warns(UserWarning, match=r"standard deviation of .* no rest.*pass one"):
        assert not next(bias_of("stillest", rates, rates, STEP, LONGEST)[0]).any()
    rates[::50] = np.nan
    with pytest.warns(UserWarning, match="no stretch as long without a gap"):
        assert not next(bias_of("stillest", rates, rates, STEP, LONGEST)[0]).any()
    steady = np.full((500, 3), 0.3)
    with pytest.warns(UserWarning, match=r"reads 0.3 rad/s, which is taken for the bias"):
        assert_allclose(next(bias_of("stillest", steady, rates, STEP, LONGEST)[0]), 0.3)


def test_a_short_recording_is_one_stretch() -> None:
    rates = moving(4000)[3000:3100]
    found = next(bias_of("stillest", rates, rates, STEP, LONGEST)[0])
    assert_allclose(found, rates.mean(axis=0), atol=1e-12)


def test_running_learns_after_two_seconds_of_rest_and_keeps_it() -> None:
    rates = moving(6000)
    forces = np.tile([0.0, 0.0, -9.8], (6000, 1))
    forces[:3000, 0] += np.sin(np.arange(3000))
    found = np.concatenate([*bias_of("running", rates, forces, STEP, LONGEST)[0]])
    assert not found[:3199].any()
    assert_allclose(found[3210], BIAS, atol=6e-4)
    assert_allclose(found[3501:], np.tile(found[3501], (2499, 1)), atol=1e-12)


def test_a_turn_is_no_rest() -> None:
    forces = np.tile([0.0, 0.0, -9.8], (2000, 1))
    steady = np.full((2000, 3), 0.1)  # too fast for a bias
    assert not any(part.any() for part in bias_of("running", steady, forces, STEP, LONGEST)[0])
