"""How the kernels are found: by a stamp, and by an environment variable."""

import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from math import cos, nan, pi, sin
from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

import chr_notes
from chr_notes import _kernels
from chr_notes._kernels import _load
from chr_notes.generated import STAMP
from chr_notes.generated.scalar import estimation, quaternions

STALE = "the kernels were built from other sources than these: install chr_notes again"


@pytest.fixture
def found(monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[[str, object], None]]:
    """Set the variable, and what an import of the kernels finds: a module or an error."""

    def settle(choice: str, module: object) -> None:
        def load(name: str) -> object:
            assert name == "chr_notes._compiled"
            if isinstance(module, Exception):
                raise module
            return module

        monkeypatch.setenv(_kernels.VARIABLE, choice)
        monkeypatch.setattr(_kernels, "import_module", load)

    return settle


Settle = Callable[[str, object], None]
FRESH, OLD = SimpleNamespace(stamp=STAMP), SimpleNamespace(stamp="of last year")
FOREIGN = SimpleNamespace()
MISSING = ModuleNotFoundError("No module named 'chr_notes._compiled'")


@pytest.mark.parametrize("choice", ["", "require"])
def test_kernels_of_these_sources_are_used(found: Settle, choice: str) -> None:
    found(choice, FRESH)
    assert _load() is FRESH


@pytest.mark.parametrize("module", [OLD, FOREIGN])
def test_kernels_of_other_sources_are_not_used_and_this_is_said(
    found: Settle, module: object
) -> None:
    found("", module)
    with pytest.warns(RuntimeWarning, match=f"{STALE}; until then NumPy computes") as said:
        assert _load() is None
    assert len(said) == 1


def test_without_kernels_nothing_is_said(found: Settle) -> None:
    found("", MISSING)
    assert _load() is None


@pytest.mark.parametrize("module", [FRESH, OLD, MISSING])
def test_kernels_that_are_off_are_not_looked_for(found: Settle, module: object) -> None:
    found("off", module)
    assert _load() is None


@pytest.mark.parametrize(
    ("module", "message"),
    [(OLD, STALE), (MISSING, "expected the kernels, but they were not built")],
)
def test_kernels_that_are_required_have_to_be_there(
    found: Settle, module: object, message: str
) -> None:
    found("require", module)
    with pytest.raises(ImportError, match=message):
        _load()


def test_another_word_is_refused(found: Settle) -> None:
    found("on", FRESH)
    with pytest.raises(ValueError, match="CHR_NOTES_KERNELS: expected off or require, got 'on'"):
        _load()


def in_a_fresh_python(code: str, choice: str) -> subprocess.CompletedProcess[str]:
    """Run code in a process of its own, in which warnings come once, as users see them."""
    return subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, _kernels.VARIABLE: choice},
        capture_output=True,
        text=True,
        check=False,
    )


def test_off_leaves_all_to_numpy() -> None:
    code = "import chr_notes, sys; print(chr_notes.kernels_in_use(), *sys.modules)"
    said, *modules = in_a_fresh_python(code, "off").stdout.split()
    assert said == "False"
    assert "chr_notes._compiled" not in modules


CALLS = 20
PAGES_TAKEN = f"""
import chr_notes, numpy as np, resource
q = np.random.default_rng(1).normal(size=(4000, 4))
def pages():
    for _ in range({CALLS}):
        chr_notes.matrix_from_quaternion(q)
    return resource.getrusage(resource.RUSAGE_SELF).ru_minflt
print(-pages() + pages())
"""


def test_numpy_computes_in_memory_that_it_had_before() -> None:
    # A hundred pages a call else, which take longer than the computing.
    assert int(in_a_fresh_python(PAGES_TAKEN, "off").stdout) < CALLS


@pytest.mark.kernels
def test_require_uses_them() -> None:
    code = "import chr_notes; print(chr_notes.kernels_in_use())"
    assert in_a_fresh_python(code, "require").stdout == "True\n"


STALE_USE = """
import sys, types, numpy as np
sys.modules["chr_notes._compiled"] = types.SimpleNamespace(stamp="of last year")
import chr_notes
for _ in range(3):
    print(chr_notes.matrix_from_euler([0, 0, 0]).tolist() == np.eye(3).tolist())
print(chr_notes.kernels_in_use())
"""


def test_stale_kernels_say_so_once_and_numpy_serves() -> None:
    done = in_a_fresh_python(STALE_USE, "")
    assert done.stdout.split() == ["True"] * 3 + ["False"]
    assert done.stderr.count(STALE) == 1
    refused = in_a_fresh_python(STALE_USE, "require")
    assert refused.returncode != 0
    assert f"ImportError: {STALE}" in refused.stderr


@pytest.mark.kernels
@pytest.mark.parametrize("rest", [0, 13])  # whole blocks, and not
@pytest.mark.parametrize("place", range(8))  # where in a line of the cache it begins
def test_a_result_past_the_cache_is_that_of_its_rows(place: int, rest: int) -> None:
    rows = (2**20 // 9 // 16 + 1) * 16 + rest
    euler = np.random.default_rng(0).uniform(-3, 3, (rows, 3))
    matrices = np.full(9 * rows + 16, nan)
    large = matrices[place:][: 9 * rows].reshape(rows, 3, 3)
    chr_notes.matrix_from_euler(euler, out=large)
    parts = (euler[start : start + 5000] for start in range(0, rows, 5000))
    assert_array_equal(large, np.concatenate([chr_notes.matrix_from_euler(part) for part in parts]))
    assert np.isnan(matrices).sum() == 16  # nothing else is written


def test_a_result_in_new_memory_is_that_of_its_rows() -> None:
    axis = np.array([[0.0, 0.6, 0.8]])  # one for all
    angle = np.linspace(-9, 9, (1 << 20) + 77)
    odd = [5, 1 << 14, (3 << 14) + 9, len(angle) - 1]
    angle[odd] = nan
    large = chr_notes.quaternion_from_axis_angle(axis, angle)
    edges = np.array([*odd, 0, (1 << 14) - 1, 5 << 14, len(angle) - 2])
    assert_array_equal(large[edges], chr_notes.quaternion_from_axis_angle(axis, angle[edges]))
    assert np.isnan(large).sum() == 4 * len(odd)


@pytest.mark.kernels
def test_a_state_is_moved_on_by_a_sample() -> None:
    take = _kernels.sampled(estimation.observer_turn, quaternions.euler_from_quaternion)
    assert take is not None
    level, still, force = np.array([1.0, 0.0, 0.0, 0.0]), np.zeros(3), np.array([0.0, 0.0, -1.0])
    state = level.copy()
    assert_allclose(take(state, np.array([0.0, 0.0, 0.5]), force, 0.2, 0.0), [0, 0, 0.1])
    assert_allclose(state, [cos(0.05), 0, 0, sin(0.05)])
    # Where nobody has to look an array comes, and where nothing can be done nothing is done.
    for wrong in ([0.0] * 4, np.zeros(4), np.zeros((1, 3)), np.zeros(3, dtype=int), None):
        state = level.copy()
        assert take(state, wrong, force, 0.2, 0.0) is None
        assert_array_equal(state, level)
    assert take(level.tolist(), still, force, 0.2, 0.0) is None  # nowhere to go on from
    for rates, dt in ((np.full(3, nan), 0.2), (np.full(3, 4.0), 0.6), (still, -0.1), (still, nan)):
        assert take(level.copy(), rates, force, dt, 0.0) is False
    assert take(level.copy(), still, still, 0.2, 0.0) is False
    up = np.array([1.0, 0.0, 1.0, 0.0]) / np.sqrt(2)
    assert take(up, still, force, 0.2, 0.0) is False  # at gimbal lock
    half = take(np.array([0.0, 1.0, 0.0, 0.0]), still, force, 0.2, 0.0)
    assert half.tolist() == [-pi, 0, 0]
    state.flags.writeable = False
    assert take(state, still, force, 0.2, 0.0) is None
    with pytest.raises(TypeError, match="expected 5 arguments, got 4"):
        take(state, still, force, 0.2)


@pytest.mark.kernels
def test_a_few_plain_numbers_are_a_row() -> None:
    take = _kernels.kernel("rotate_to_inertial")
    assert take is not None
    q, vector = np.array([0.6, 0.0, 0.8, 0.0]), np.array([1.0, 2.0, -3.0])
    expected = take(q, vector, None)
    for row in ([1, 2, -3], (1.0, 2.0, -3), [np.float64(1), 2.0, -3]):
        assert_array_equal(take(q.tolist(), row, None), expected)
    assert_array_equal(take(q.tolist(), np.tile(vector, (5, 1)), None), [expected] * 5)
    # What else may stand in a list is not for a kernel to judge, and no error comes of it.
    for other in (None, "2", True, np.float32(2), [2.0], np.array([2.0]), 10**400):
        assert take(q, [1.0, other, -3.0], None) is None
    for row in ([1.0, 2.0], [[1.0, 2.0, -3.0]], {1.0, 2.0, -3.0}):
        assert take(q, row, None) is None
    matrix = _kernels.kernel("euler_from_matrix")
    assert matrix is not None
    assert matrix(np.eye(3).ravel().tolist(), None) is None


@pytest.mark.kernels
@pytest.mark.parametrize("count", [1, 7, 1000])
def test_rows_that_are_parts_of_longer_ones_are_taken_as_they_are(count: int) -> None:
    wide = np.random.default_rng(0).normal(size=(count, 9))
    q, one = wide[:, 2:6], np.broadcast_to(wide[0, 5:8], (count, 3))
    product = _kernels.kernel("rotate_to_inertial")
    assert product is not None
    assert_array_equal(product(q, one, None), product(q.copy(), one.copy(), None))
    # A result is no part of a longer row, and lies apart from what it is made of.
    assert product(q, one, wide[:, :3]) is None or count == 1
    assert product(q, one, wide.reshape(-1)[: 3 * count].reshape(count, 3)) is None
    # What goes backwards, or by half a number, is left.
    assert product(q[::-1], one, None) is None or count == 1
    bytewise = np.ndarray((count, 4), np.float64, bytes(36 * count), strides=(36, 8))
    assert product(bytewise, one, None) is None or count == 1


def test_without_kernels_none_is_found(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(_kernels, "_MODULE", None)
    assert _kernels.kernel("quaternion_from_euler") is None
    assert not _kernels.kernels_in_use()
