"""Times of each task in each library; no file of the default run.

python -m pytest tests/benchmarks/bench_*.py --benchmark-json=run.json
python tests/benchmarks/store.py run.json
"""

import warnings
from typing import Any

import numpy as np
import pytest

from .tasks import MANY, MEMCPY, ONE, OURS, data, memcpy

SIZES = (1, 10, 100, 1_000, 10_000, 100_000, 1_000_000)
CASES = [
    pytest.param(size, task, library, id=f"{size}-{task}-{library}")
    for size in SIZES
    for task, libraries in (ONE if size == 1 else MANY).items()
    for library in (*libraries, *([MEMCPY] if size > 1 else []))
]


def numbers(result: Any, size: int) -> np.ndarray:  # noqa: ANN401 (each library has its own type)
    """Give a result as a row of numbers an attitude, whose order does not matter."""
    if hasattr(result, "as_quat"):
        result = result.as_quat()
    elif hasattr(result, "to_storage"):
        result = result.to_storage()
    elif hasattr(result, "components"):
        result = result.components
    array = np.asarray(result)
    if array.dtype.names or array.dtype.name == "quaternion":
        array = array.view(np.float64).reshape(*array.shape, 4)
    # A flag is no number. Matrices may be transposed, quaternions end with their scalar part or
    # have the other sign, Euler angles stand in another order.
    return np.sort(np.abs(array.astype(float).reshape(size, -1)), axis=1)


@pytest.mark.parametrize(("size", "task", "library"), CASES)
def test_speed(benchmark: Any, size: int, task: str, library: str) -> None:  # noqa: ANN401
    rows = data(size)
    table = (ONE if size == 1 else MANY)[task]
    run = memcpy(table[OURS], rows) if library == MEMCPY else table[library](rows)
    with warnings.catch_warnings():
        # Other libraries' warnings are not ours to judge.
        warnings.simplefilter("ignore")
        if not library.startswith(OURS):
            expected = numbers(table[OURS](rows)(), size)
            np.testing.assert_allclose(numbers(run(), size), expected, atol=1e-7)
        benchmark.extra_info.update(size=size, task=task, library=library)
        benchmark(run)
