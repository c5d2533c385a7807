"""None for an argument that is required is refused by its name, by each public function."""

import inspect
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import chr_notes

ROWS = np.array([[0.01, 0.0, -0.02]]).repeat(40, axis=0)
UP, FIELD = np.array([0, 0, -9.8]), np.array([20.0, 0.0, 40.0])
GIVEN: dict[str, Any] = {
    "accel": ROWS + UP,
    "body_rates": ROWS,
    "dt": 0.01,
    "mag": ROWS + FIELD,
    "vector": ROWS + FIELD,
    "euler": ROWS,
    "gain": 0.1,
    "samples": ROWS,
    "readings": ROWS[:6] + UP,
    "strength": 45.0,
    "reference_down": 0.9,
    "p": [1.0, 0.0, 0.0, 0.0],
    "q": [1.0, 0.0, 0.0, 0.0],
    "matrix": np.eye(3),
    "axis": [1.0, 0.0, 0.0],
    "acceleration": ROWS,
    "angle": 0.3,
    "angle_error": 0.3,
    "angles": ROWS,
    "averaged": 3.0,
    "euler_rates": ROWS,
    "share": 0.5,
    "tilt": ROWS[:, :2],
    "time": 1.0,
    "time_constant": 1.0,
    "v_body": ROWS,
    "v_inertial": ROWS,
}
"""What is given for an argument of the name, where it is an array or a number."""
WORDS = {
    "sequence": "XYX",
    "source": "flu",
    "target": "frd",
    "length": 10,
    "turns": [(slice(0, 5), [0.0, 0.0, 1.0])],
    "monitor": chr_notes.Monitor(0.1, 3),
}
"""What is no array."""
NO_ARRAYS = {
    "calibrate_recording",
    "coasting_time",
    "convert",
    "find_conventions",
    "kernels_in_use",
    "read_log",
}
OWN: dict[str, dict[str, Any]] = {
    "change_angles": {"source": "ros", "target": "notes"},
    "change_quaternion": {"source": "ros", "target": "notes"},
    "observe_sample": {"euler": ROWS[0], "body_rates": ROWS[0], "accel": UP},
}
"""What single functions take under a name that means something else, or a row, for them."""
STREAMS = {
    "observe": lambda **sample: next(chr_notes.observe([tuple(sample.values())], 0.1)),
    "observe_averaging": lambda **sample: next(
        chr_notes.observe_averaging([tuple(sample.values())])
    ),
}
SAMPLE = {"body_rates": ROWS[0], "accel": UP, "dt": 0.01}


def _functions() -> dict[str, tuple[Callable[..., Any], dict[str, Any]]]:
    """Give each public function with arguments for all that it requires."""
    found: dict[str, tuple[Callable[..., Any], dict[str, Any]]] = {}
    for name in chr_notes.__all__:
        function = getattr(chr_notes, name)
        if name in NO_ARRAYS or inspect.isclass(function) or not callable(function):
            continue
        if name in STREAMS:
            found[name] = STREAMS[name], SAMPLE
            continue
        required = [
            each.name
            for each in inspect.signature(function).parameters.values()
            if each.default is inspect.Parameter.empty
        ]
        known = GIVEN | WORDS | OWN.get(name, {})
        found[name] = function, {each: known[each] for each in required}
    return found


FUNCTIONS = _functions()
CASES = [(name, each) for name, (_, given) in FUNCTIONS.items() for each in given if each in GIVEN]


@pytest.mark.filterwarnings("ignore::UserWarning")
@pytest.mark.parametrize(("name", "argument"), CASES)
def test_none_is_refused_by_name(name: str, argument: str) -> None:
    function, given = FUNCTIONS[name]
    with pytest.raises(TypeError, match=rf"^{argument}: expected real numbers, got None\b"):
        function(**given | {argument: None})


def test_what_is_left_out_of_a_log_is_told() -> None:
    rows = np.zeros((5, 3))
    with pytest.raises(TypeError, match=r"^body_rates: .* got None; a log without a gyro has none"):
        chr_notes.averaging_observer(None, rows, 0.01, mag=rows)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match=r"^dt: .* got None; .* pass rate= to read_log"):
        chr_notes.averaging_observer(rows, rows + UP, None)  # type: ignore[arg-type]
