"""What is said of ranges and NaN is what the functions do."""

import math
from dataclasses import replace

import pytest

from chr_notes.codegen import edges
from chr_notes.codegen.targets import TARGETS
from chr_notes.generated.scalar import dead_reckoning, estimation, validation

from . import languages
from .reference import DOUBLE
from .vectors import Vector, vectors

READINGS = ("p", "q", "r", "accel_x", "accel_y", "accel_z", "mag_x", "mag_y", "mag_z")
ENDS = {"pi": math.pi, "-pi": -math.pi, "pi/2": math.pi / 2, "-pi/2": -math.pi / 2}
Results = list[tuple[Vector, list[float]]]


@pytest.fixture(scope="module")
def results() -> Results:
    made = vectors(DOUBLE)
    return [(v, got) for v, got in zip(made, languages.python(made), strict=True) if got]


def test_the_tables_name_functions() -> None:
    names = {target.name for target in TARGETS}
    assert names >= edges.RANGES.keys()
    assert names >= edges.OF_NAN.keys()


@pytest.mark.parametrize("name", edges.RANGES)
def test_results_lie_in_their_ranges(name: str, results: Results) -> None:
    own = [(vector, got) for vector, got in results if vector.target.name == name]
    if name == "validation_factor":  # its last argument is the reference
        own = [(vector, got) for vector, got in own if abs(vector.arguments[-1]) <= 1]
    for stated in edges.RANGES[name]:
        low, high = (ENDS[end] if end in ENDS else float(end) for end in (stated.low, stated.high))
        reached = []
        for _, got in own:
            reached += [got[place] for place in stated.places if not math.isnan(got[place])]
        assert low - 1e-15 <= min(reached)
        assert max(reached) <= high + 1e-15
        # Not far beyond what is reached.
        assert max(reached) > (low + high) / 2


def without_a_number(vector: Vector) -> list[str]:
    """Names of the arguments that are NaN or infinite."""
    pairs = zip(vector.target.arguments, vector.arguments, strict=True)
    return [argument.name for argument, value in pairs if not math.isfinite(value)]


def with_number(vector: Vector, number: float) -> Vector:
    """The same with a number in place of NaN."""
    return replace(
        vector, arguments=tuple(number if math.isnan(a) else a for a in vector.arguments)
    )


def test_elsewhere_nan_gives_nan(results: Results) -> None:
    seen = set()
    for vector, got in results:
        if vector.target.name not in edges.OF_NAN and any(map(math.isnan, vector.arguments)):
            if not any(map(math.isnan, got)):
                # What does not enter at all, such as an element of a matrix that tells no more.
                assert languages.python([with_number(vector, 0.5)])[0] == got, vector
                assert languages.python([with_number(vector, 0.25)])[0] == got, vector
            seen.add(vector.target.name)
    assert seen == {target.name for target in TARGETS} - edges.OF_NAN.keys()


@pytest.mark.parametrize("name", [n for n, told in edges.OF_NAN.items() if edges.HELD_OUT in told])
def test_what_is_held_out_leaves_numbers(name: str, results: Results) -> None:
    own = [(v, got) for v, got in results if v.target.name == name]
    held = [(v, got) for v, got in own if (bad := without_a_number(v)) and {*bad} <= {*READINGS}]
    assert len(held) >= 6
    for vector, got in held:
        assert all(map(math.isfinite, got)), vector


@pytest.mark.parametrize("name", [n for n, told in edges.OF_NAN.items() if edges.NOT_HEARD in told])
def test_a_reading_that_is_none_gives_nan(name: str, results: Results) -> None:
    for vector, got in results:
        if vector.target.name != name:
            continue
        names = [argument.name for argument in vector.target.arguments]
        reading = [v for n, v in zip(names, vector.arguments, strict=True) if n in READINGS]
        if not any(reading) or not all(map(math.isfinite, reading)):
            assert all(map(math.isnan, got)), vector


def test_the_other_sentences() -> None:
    assert validation.monitor_gain(math.nan, 5, 0.02, 0.01, 0.07) == 0.02
    assert validation.monitor_count(3.0, math.nan, 0.1) == 3.0
    assert estimation.tilt_from_accelerometer(-0.0, 0.0, 0.0) != (0.0, 0.0)
    assert estimation.tilt_from_accelerometer(9.8, -0.0, 0.0)[0] == 0.0
    state = (1.0, 2.0, 3.0, 4.0, 5.0, 6.0)
    after = dead_reckoning.dead_reckoning_held(*state, math.nan, 1.0, 1.0, 0.5)
    assert after == (1.0, 2.0, 3.0, 4.5, 6.0, 7.5)
    assert abs(estimation.gyro_step(3.1, 0.0, 0.0, 1.0, 0.0, 0.0, 0.5)[0]) > math.pi
