"""No function of arrays lets a warning or error of NumPy's arithmetic out, whatever the numbers."""

import inspect
import warnings
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import chr_notes
from chr_notes import CalibrationWarning, GimbalLockWarning, UnitWarning

Floats = NDArray[np.float64]
Call = Callable[..., object]

NUMBERS = [
    np.nan, np.inf, -np.inf, 0.0, -0.0, 5e-324, 1e-310, 1e-200, 1e-30, 1.0, np.pi / 2, -np.pi,
    1e3, 1e6, 1e16, 1e155, 1e200, 1.7e308, -1.7e308,
]  # fmt: skip
# An ordinary value of each argument of arrays, by its name.
Q, EULER, V = [0.5, -0.4, 0.6, 0.2], [0.3, -0.7, 1.9], [0.6, -0.4, 0.3]
ARRAYS: dict[str, Any] = (
    {"q": Q, "p": [0.1, 0.9, -0.3, 0.4]}
    | dict.fromkeys(("euler", "angles"), EULER)
    | dict.fromkeys(("axis", "v_body", "v_inertial", "vector", "body_rates", "euler_rates"), V)
    | dict.fromkeys(("accel", "mag", "acceleration", "actual", "measured", "field", "samples"), V)
    | dict.fromkeys(("angle", "angle_error", "time", "averaged", "time_constant", "gain"), 0.3)
    | dict.fromkeys(("dt", "share"), 0.1)
    | {"matrix": np.eye(3), "tilt": [0.3, -0.7]}
)
# What the other arguments are.
FIXED: dict[str, Any] = {
    "sequence": "zxz",
    "source": "ros",
    "target": "notes",
    "reference_down": 0.7,
    "monitor": chr_notes.Monitor(0.1, 5),
    "strength": 1.0,
    "length": 1,
}
AXES = {"source": "ned", "target": "enu"}
STEEP = chr_notes.matrix_from_euler([0.3, np.pi / 2, 0.2])
SLANTED = np.eye(3) + 0.02
MODELS = (
    chr_notes.ThreeAxisCalibration(SLANTED, [1.0, 1.1, 0.9], [0.1, 0.2, 0.3]),
    chr_notes.RateGyroCalibration(SLANTED, [1.0, 1.1, 0.9], [0.1, 0.2, 0.3], np.eye(3) / 100),
    chr_notes.MagnetometerCalibration(SLANTED, [0.1, 0.2, 0.3]),
)
# What goes in are no rows of numbers alone, but poses, turns, streams.
OTHERS = {"coasting_time", "convert", "drift_budget", "find_conventions", "fit_accelerometer",
          "fit_gyro_scale", "kernels_in_use", "observe", "observe_averaging",
          "read_log", "calibrate_recording"}  # fmt: skip


def found() -> Iterator[tuple[str, Call]]:
    """Find the public functions, and the methods of calibrations that take `out`."""
    for name in chr_notes.__all__:
        thing = getattr(chr_notes, name)
        if inspect.isfunction(thing) and name not in OTHERS:
            yield name, thing
    for model in MODELS:
        for name in ("measure", "correct"):
            yield f"{type(model).__name__}.{name}", getattr(model, name)


EVERY = dict(found())


def needed(call: Call) -> dict[str, Any]:
    """Give an ordinary value for each argument that has no default."""
    given = ARRAYS | FIXED | (AXES if call is chr_notes.change_axes else {})
    return {
        name: given[name]
        for name, parameter in inspect.signature(call).parameters.items()
        if parameter.default is parameter.empty
    }


def rows(ordinary: Any) -> Floats:  # noqa: ANN401 (a number or an array)
    """Give rows of one argument: each number in one place, and in all places."""
    usual = np.asarray(ordinary, dtype=float)
    made = [np.full(usual.shape, number) for number in NUMBERS]
    for place in {0, usual.size - 1}:
        for number in NUMBERS:
            made.append(usual.copy())
            made[-1].flat[place] = number
    return np.array([*made, STEEP] if usual.shape == (3, 3) else made)


def tried(call: Call, given: dict[str, Any]) -> bool:
    """Call it; say whether it takes this, rather than refuse it in words of its own."""
    try:
        call(**given)
    except ValueError as error:
        if type(error) is not ValueError:
            raise
        return False
    return True


@pytest.mark.parametrize("name", EVERY)
@pytest.mark.usefixtures("each_way")
def test_nothing_leaks(name: str) -> None:
    call = EVERY[name]
    usual = needed(call)
    arrays = [argument for argument in usual if argument in ARRAYS]
    assert arrays, "put it in OTHERS if it takes no rows of numbers"
    with warnings.catch_warnings(), np.errstate(all="raise"):
        warnings.simplefilter("error")
        for meant in (GimbalLockWarning, UnitWarning, CalibrationWarning):
            warnings.simplefilter("ignore", meant)
        warnings.filterwarnings("ignore", "bias: ", UserWarning)
        for argument in arrays:
            wild = rows(usual[argument])
            others = {other: [usual[other]] for other in arrays if other != argument}
            one = partial(tried, call)
            kept = [row for row in wild if one({**usual, **others, argument: [row]})]
            if kept:
                many = {other: np.repeat(value, 1000, axis=0) for other, value in others.items()}
                one({**usual, **many, argument: np.resize(kept, (1000, *wild.shape[1:]))})
