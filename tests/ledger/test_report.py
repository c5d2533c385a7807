"""The ledger as a table and as JSON."""

import json
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import replace
from types import ModuleType

import pytest
from sympy import Eq

from chr_notes import ledger
from chr_notes.__main__ import main
from chr_notes.ledger import euler, report
from chr_notes.ledger.case import CannotJudgeError
from chr_notes.ledger.cases import CASES
from chr_notes.symbols import psi

FIELDS = {
    "id", "document", "kind", "place", "verdict", "printed_latex", "derived_latex",
    "correction_latex", "condition", "witness", "method",
}  # fmt: skip


def test_json_is_a_list_of_entries_and_nothing_else(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["ledger", "--document", "euler", "--json"]) == 0
    captured = capsys.readouterr()
    rows = json.loads(captured.out)
    assert [row["id"] for row in rows] == [name for name in CASES if "euler." in name]
    for row in rows:
        assert row.keys() >= FIELDS
        assert row["verdict"] == ledger.entry(row["id"]).verdict
    witness = next(row["witness"] for row in rows if row["id"] == "euler.5.5")
    assert witness["printed"] != witness["right"]


def test_table_has_a_line_an_entry_and_the_counts(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["ledger", "--document", "euler", "--verdict", "corrected"]) == 0
    lines = capsys.readouterr().out.splitlines()
    corrected = [n for n in CASES if "euler." in n and ledger.entry(n).verdict == "corrected"]
    assert [line.split()[0] for line in lines[: len(corrected)]] == corrected
    count, errors = len(corrected), len({ledger.entry(name).root for name in corrected})
    assert lines[-1] == f"{count} entries: {count} corrected; {count} places of {errors} errors"


def test_cases_that_do_not_go_together_are_told_in_a_line(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    class Refused(ModuleType):
        def __getattr__(self, _: str) -> None:
            msg = "euler.5.5: expected readings, got none\neuler.5.6: expected told_in …"
            raise CannotJudgeError(msg)

    monkeypatch.setitem(sys.modules, "chr_notes.ledger.euler", Refused("euler"))
    monkeypatch.setattr(report.stored, "is_stale", lambda document: document == "euler")
    for asked in ("--write", "--check"):
        assert main(["ledger", asked, "--document", "euler"]) == 1
        told = capsys.readouterr().err.splitlines()[:2]
        assert told == ["euler.5.5: expected readings, got none", "euler.5.6: expected told_in …"]


def test_all_that_is_wrong_with_all_cases_is_told_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    wrong = []
    for name in ("euler.3.1", "euler.4.1"):
        case = CASES[name]
        first = replace(case.steps[0], says="The conjugate, by a cube.")
        same = replace(case.steps[0], statement=Eq(psi, psi, evaluate=False))
        wrong.append(replace(case, root="gyro", steps=(first, same)))
    monkeypatch.setattr(euler, "CASES", tuple(wrong))
    entries, told = report.judged("euler")
    assert entries == []
    for case in wrong:
        own = [line for line in told if line.startswith(f"{case.id}: ")]
        assert len(own) == len(set(own)) == 4
        for what in ("no root", "“conjugate”.*“cube”", "nowhere", "step 2 shows the same"):
            assert re.search(what, "\n".join(own)), (what, own)
        assert all("; see chr_notes/printed/euler.py" in line for line in own)


JUDGES_FOR_LONG = """
import sys, time
from chr_notes import __main__
from chr_notes.ledger import report

def judged(_):
    time.sleep(60)

report.judged = judged
sys.argv = ["chr-notes", "ledger", "--check"]
__main__.run()
"""
CHECK = ("-m", "chr_notes", "ledger", "--check")
TWICE = pytest.param(("-c", JUDGES_FOR_LONG), 0.0, (0.0, 0.1), id="twice")
REALLY = [
    pytest.param(CHECK, after, presses, marks=pytest.mark.full)
    for after in (0.0, 0.1, 3.0)  # s: while processes begin, load, and judge
    for presses in ((0.0,), (0.0, 0.05), (0.0, 0.3))
]


@pytest.mark.usefixtures("ctrl_c")
@pytest.mark.parametrize(("run", "after", "presses"), [TWICE, *REALLY])
def test_ctrl_c_ends_all_that_judge_at_once(
    run: tuple[str, ...],
    after: float,
    presses: tuple[float, ...],
    record_property: Callable[[str, object], None],
) -> None:
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True}
    with subprocess.Popen([sys.executable, *run], start_new_session=True, **pipes) as command:
        assert command.stdout.readline().startswith("judging euler, ")
        time.sleep(after)
        begun = time.monotonic()
        for pause in presses:
            time.sleep(pause)
            os.killpg(command.pid, signal.SIGINT)  # as a terminal does
        said, _ = command.communicate(timeout=10)
    record_property("measured", f"Ctrl-C ends it after {time.monotonic() - begun:.1f} s")
    assert said == "ledger: stopped before the end\n"
    assert command.returncode == 130
    with pytest.raises(ProcessLookupError):
        os.killpg(command.pid, 0)
