"""No test is left out without a permit."""

import ast
import re
import shutil
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).resolve().parents[1]
TESTS = {str(path.relative_to(ROOT)): path for path in sorted((ROOT / "tests").rglob("test_*.py"))}


def functions(path: Path) -> Iterator[ast.FunctionDef]:
    body = ast.parse(path.read_text(encoding="utf-8")).body
    return (node for node in body if isinstance(node, ast.FunctionDef))


@pytest.fixture(scope="module")
def permits(rules: ModuleType) -> dict[str, tuple[str, ...]]:
    permitted: dict[str, tuple[str, ...]] = rules.PERMITTED
    return permitted


def test_tests_on_recordings_are_those_of_the_list(permits: dict[str, tuple[str, ...]]) -> None:
    use = {
        f"{name}::{function.name}"
        for name, path in TESTS.items()
        for function in functions(path)
        if "recordings" in [argument.arg for argument in function.args.args]
        and function.name.startswith("test_")
    }
    assert use == {*permits["../shared/data"]}


def test_each_program_of_the_list_is_installed_by_the_check_of_changes(
    rules: ModuleType, permits: dict[str, tuple[str, ...]]
) -> None:
    text = (ROOT / ".ci" / "run").read_text(encoding="utf-8")
    assert {*re.findall(r"command -v ([\w-]+)", text)} == {
        rules.NAMES.get(name, (name,))[0] for name in permits if "/" not in name
    }


def test_a_name_that_only_begins_like_a_permitted_one_has_no_permit(
    rules: ModuleType, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(rules, "is_there", lambda _: False)
    test, *_ = rules.PERMITTED["../shared/data"]
    assert rules.permitted(test, "waits for ../shared/data")
    assert rules.permitted(f"{test}[one]", "waits for ../shared/data")
    assert not rules.permitted(f"{test}_and_more", "waits for ../shared/data")


LEFT_OUT = """
import pytest

@pytest.mark.skip(reason="for now")
def test_marked(): ...

@pytest.mark.skipif(True, reason="for now")
def test_marked_on_a_condition(): ...

@pytest.mark.xfail(reason="for now")
def test_expected_to_fail():
    assert False

@pytest.mark.parametrize("nothing", [])
def test_of_nothing(nothing): ...

def test_that_skips_itself():
    pytest.skip("for now")

def test_that_says_it_waits_for_what_is_there():
    pytest.skip("waits for python3")

def test_for_want_of_a_package():
    pytest.importorskip("no_such_package")
"""
IN_ALL = 'import pytest\n\npytest.skip("for now", allow_module_level=True)\n'


@pytest.mark.slow
def test_what_is_left_out_without_a_permit_fails(pytester: pytest.Pytester) -> None:
    for name in ("pyproject.toml", "conftest.py"):
        shutil.copy(ROOT / name, pytester.path)
    pytester.makepyfile(test_parts=LEFT_OUT, test_whole=IN_ALL)
    given = ("test_parts.py", "test_whole.py", "-n0", "--continue-on-collection-errors")
    done = pytester.runpytest_inprocess(*given)
    assert done.ret == 1
    failed = re.findall(r"^(?:FAILED|ERROR) test_parts\.py::(\w+)", done.stdout.str(), re.MULTILINE)
    assert {*failed} == {*re.findall(r"def (\w+)", LEFT_OUT)}
    done.stdout.fnmatch_lines(["Left out: no test.", "ERROR test_whole.py*"])


@pytest.mark.slow
def test_a_run_without_kernels_says_so(
    pytester: pytest.Pytester, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("pyproject.toml", "conftest.py"):
        shutil.copy(ROOT / name, pytester.path)
    pytester.makepyfile(test_numbers="def test_of_numbers(): ...")
    monkeypatch.setenv("CHR_NOTES_KERNELS", "off")
    done = pytester.runpytest_subprocess("test_numbers.py", "-n0")
    assert done.ret == 0
    done.stdout.fnmatch_lines(["Left out: what needs compiled kernels."])
