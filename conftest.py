"""Rules for every test, cells of notebooks included: none is left out without a permit.

A test may skip only where `PERMITTED` says so, for want of what stands there; any other skip, and
any expected failure, is a failure. Where `CI` is set, every program must be there.
"""

import gc
import os
import shutil
import sys
from collections import Counter
from collections.abc import Generator
from importlib.util import cache_from_source
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from xdist.remote import Producer
from xdist.scheduler import LoadScopeScheduling

from chr_notes import kernels_in_use

# Workers, kernels and programs of tests have these from here. SymPy keeps the thousand results that
# it used last, and what derives and judges again and again takes a sixth longer with so few. There
# is a worker for each processor: of more threads for matrices most would wait and turn. Where
# Python writes nothing beside the sources, and who installed did not either, as uv does not, each
# process would compile all libraries for itself.
os.environ.setdefault("SYMPY_CACHE_SIZE", "None")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
if sys.dont_write_bytecode and not Path(cache_from_source(pytest.__file__)).exists():
    COMPILED = TemporaryDirectory(prefix="compiled-", ignore_cleanup_errors=True)
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    os.environ["PYTHONPYCACHEPREFIX"] = COMPILED.name

ROOT = Path(__file__).resolve().parent
RECORDINGS = "../shared/data"
# Folders whose tests share what is made once a run.
ONCE = ("tests/book/", "tests/codegen/", "tests/ledger/")
# Files that take long though their tests are few: first, so that no worker is left with them alone.
DEAR = ("tests/book/", "notebooks/", "tests/demos/", "tests/ledger/", "tests/codegen/")

# What a test waits for: a program, or a folder beside the project. Then the tests that do.
PERMITTED = {
    RECORDINGS: (
        "tests/sensors/test_axes.py::test_recordings_with_permuted_axes_in_degrees",
        "tests/sensors/test_calibration.py::test_a_recorded_session_of_six_positions",
        "tests/sensors/test_calibration.py::test_bias_of_a_recording_at_rest",
        "tests/sensors/test_magnetometer.py::test_recorded_fields_are_calibrated",
        "tests/sensors/test_magnetometer.py::test_a_spiked_recording_is_calibrated_as_without",
        "tests/sensors/test_poses.py::test_a_recorded_session_is_cut_by_itself",
        "tests/sensors/test_poses.py::test_recorded_turns_give_the_sensitivity",
        "tests/estimation/test_averaging.py::test_broad",
        "tests/estimation/test_doubt.py::test_false_alarms_are_rare_by_the_true_attitude",
        "tests/estimation/test_doubt.py::test_holding_out_helps_where_the_rule_of_the_paper_hurts",
        "tests/test_zero_velocity.py::test_a_recorded_walk_with_rests_ends_near_its_start",
        "tests/test_zero_velocity.py::test_a_recorded_walk_ends_metres_off",
        "tests/sensors/test_log_calibration.py::test_a_fit_that_makes_a_recording_worse_is_not_taken",
        "tests/sensors/test_ellipsoid.py::test_a_recording_that_covers_too_little_is_refused",
        "tests/sensors/test_ellipsoid.py::test_recorded_fields_have_one_norm",
        "tests/sensors/test_still.py::test_a_recording_moves_where_it_was_marked",
        "tests/sensors/test_still.py::test_the_six_positions_of_a_session_are_found",
        "tests/sensors/test_recorded_logs.py::test_each_recording_is_read",
        "tests/test_units.py::test_a_recording_is_told_from_itself_in_degrees",
        "tests/sensors/test_recorded_logs.py::test_a_rest_without_times_is_told_in_rows",
        "tests/sensors/test_recorded_logs.py::test_axes_given_upside_down",
        "tests/sensors/test_recorded_logs.py::test_faults_planted_in_recordings",
        "tests/sensors/test_recorded_logs.py::test_what_no_log_tells_is_said",
        "tests/estimation/test_fixed_gain.py::test_inclination_on_a_recording_with_optical_truth",
    ),
    # The documents themselves: what the project keeps of them is compared where they are.
    "../shared/sources": ("tests/printed/test_places.py::test_statements_stand_in_their_places",),
    "chromium": ("tests/book/", "tests/demos/"),
    "gcc": (
        "tests/codegen/test_languages.py::test_c_",
        "tests/codegen/test_tumbling.py::test_exported_c",
        "tests/native/",
        "tests/test_export.py::",
    ),
    "node": (
        "tests/codegen/test_languages.py::test_javascript",
        "tests/codegen/test_tumbling.py::test_exported_javascript",
        "tests/test_export.py::",
    ),
    "npx": (
        "tests/demos/test_build.py::test_committed_bundles_are_as_made_now",
        "tests/test_export.py::test_typescript_accepts_right_uses_alone",
    ),
}

# Names of a program, the best one first: without a window Chromium takes less than half the time.
NAMES = {"chromium": ("chromium-headless-shell", "chromium")}


def program(wanted: str) -> str | None:
    """Find a program by any of its names."""
    return next(filter(None, map(shutil.which, NAMES.get(wanted, (wanted,)))), None)


def is_there(wanted: str) -> bool:
    """Tell whether a program or folder that tests wait for can be used."""
    return (ROOT / wanted).is_dir() if "/" in wanted else program(wanted) is not None


def wait_for(wanted: str) -> None:
    """Leave out the present test if a program or folder of the list is missing."""
    if not is_there(wanted):
        pytest.skip(f"waits for {wanted}")


def permitted(test: str, reason: str) -> bool:
    """Tell whether a test may be left out for that reason."""
    wanted = reason.removeprefix("Skipped: ").removeprefix("waits for ")
    # A test's whole name stands for it with any parameters, another for all that begin so.
    name, _, _ = test.partition("[")
    may = any(
        name == each or (each.endswith(("/", "::", "_")) and name.startswith(each))
        for each in PERMITTED.get(wanted, ())
    )
    return may and not is_there(wanted) and ("/" in wanted or not os.environ.get("CI"))


def judge(report: pytest.TestReport | pytest.CollectReport) -> None:
    """Make a failure of a test that was left out without a permit."""
    if report.outcome != "skipped":
        return
    expected_failure = getattr(report, "wasxfail", None)
    where = report.longrepr
    reason = str(where[2]) if isinstance(where, tuple) else f"expected to fail: {expected_failure}"
    if expected_failure is not None or not permitted(report.nodeid, reason):
        report.outcome = "failed"
        report.longrepr = f"left out without a permit in conftest.py: {reason}"
        vars(report).pop("wasxfail", None)


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_runtest_makereport() -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """Judge a test that skips."""
    report = yield
    judge(report)
    return report


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_make_collect_report() -> Generator[None, pytest.CollectReport, pytest.CollectReport]:
    """Judge a file that skips as a whole."""
    report = yield
    judge(report)
    return report


def pytest_terminal_summary(terminalreporter: "pytest.TerminalReporter") -> None:
    """Say what was measured, how many tests were left out, and why."""
    passed = terminalreporter.stats.get("passed", [])
    kept = [
        value for report in passed for name, value in report.user_properties if name == "measured"
    ]
    if kept:
        terminalreporter.write_line(f"Measured: {'; '.join(kept)}.")
    reports = terminalreporter.stats.get("skipped", [])
    reasons = Counter(str(report.longrepr[2]).removeprefix("Skipped: ") for report in reports)
    each = [f"{count} {reason}" for reason, count in sorted(reasons.items())]
    # These are not collected, by workers of whose collection nothing is known here.
    each += [] if kernels_in_use() else ["what needs compiled kernels"]
    terminalreporter.write_line(f"Left out: {'; '.join(each) or 'no test'}.")


def pytest_addoption(parser: pytest.Parser) -> None:
    """Offer the large samples."""
    parser.addoption("--full", action="store_true", help="large samples instead of small ones")


class Together(LoadScopeScheduling):
    """Files stay whole on a worker, and so do those that read the book, lower formulas or judge.

    Neither `--dist loadfile` nor marks would do: the first builds the book more than once, and a
    notebook's cells must stay together whatever `--dist` says.
    """

    def _split_scope(self, nodeid: str) -> str:
        file = nodeid.partition("::")[0]
        return next((folder for folder in ONCE if file.startswith(folder)), file)


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Producer) -> Together | None:
    """Give each worker whole files, in the order of the collection, as asked for or not."""
    config.option.loadscopereorder = False
    return None if config.getoption("dist") == "each" else Together(config, log)


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """Look for no garbage while tests are imported: all of it stays, in a sixth less time."""
    gc.disable()
    try:
        return (yield)
    finally:
        gc.enable()


def _place(item: pytest.Item) -> int:
    own = (place for place, folder in enumerate(DEAR) if item.nodeid.startswith(folder))
    return next(own, len(DEAR))


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Mark tests by what they use, and leave the large samples to `--full`."""
    for item in items:
        used = set(getattr(item, "fixturenames", ()))
        for name in ("browser", "book"):
            if name in used:
                item.add_marker(name)
    unasked = [] if config.getoption("full") else ["full"]
    unasked += [] if kernels_in_use() else ["kernels"]
    out = [item for item in items if any(map(item.get_closest_marker, unasked))]
    items[:] = sorted((item for item in items if item not in out), key=_place)
    config.hook.pytest_deselected(items=out)
