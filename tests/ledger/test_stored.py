"""The stored verdicts are those that are reached now; without that they are not used."""

import dataclasses
import json
import subprocess
import sys
from pathlib import Path

import pytest

from chr_notes.__main__ import main
from chr_notes.ledger import report, stored
from chr_notes.ledger.cases import CASES
from chr_notes.ledger.entry import Entry
from chr_notes.ledger.judgement import judge


@pytest.mark.parametrize("document", stored.DOCUMENTS)
def test_nothing_is_out_of_date(document: str) -> None:
    assert not stored.is_stale(document), f"run: {stored.REFRESH}"


# One verdict in twenty-four; all of them with `--full`, and by `ledger --check` in CI.
ONE_IN = 24
JUDGED = [
    pytest.param(name, marks=pytest.mark.full if number % ONE_IN else ())
    for number, name in enumerate(CASES)
]


@pytest.mark.parametrize("name", JUDGED)
def test_each_verdict_is_reached_again(name: str) -> None:
    document = CASES[name].printed.document
    assert {entry.id: entry for entry in stored.read(document)}[name] == judge(CASES[name])


def test_what_is_stored_are_all_cases_in_their_order() -> None:
    ids = [entry.id for document in stored.DOCUMENTS for entry in stored.read(document)]
    assert ids == list(CASES)


def test_a_change_of_any_source_is_seen(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    before = {document: stored.stamp(document) for document in stored.DOCUMENTS}
    copy = tmp_path / "chr_notes"
    for folder in ("printed", "derivations", "ledger"):
        for file in (stored.PACKAGE / folder).glob("*.py"):
            (copy / folder).mkdir(parents=True, exist_ok=True)
            (copy / folder / file.name).write_bytes(file.read_bytes())
    for name in ("symbols.py", "typeset.py"):
        (copy / name).write_bytes((stored.PACKAGE / name).read_bytes())
    monkeypatch.setattr(stored, "PACKAGE", copy)
    assert {document: stored.stamp(document) for document in stored.DOCUMENTS} == before
    for path, changed in (
        ("printed/quaternions.py", {"quaternions"}),
        ("ledger/quaternions_reading.py", {"quaternions"}),
        ("ledger/identities.py", set(stored.DOCUMENTS)),
        ("symbols.py", set(stored.DOCUMENTS)),
    ):
        file = copy / path
        text = file.read_bytes()
        file.write_bytes(text + b"# changed\n")
        now = {document: stored.stamp(document) for document in stored.DOCUMENTS}
        assert {document for document in now if now[document] != before[document]} >= changed
        if len(changed) == 1:
            assert {d for d in now if now[d] != before[d]} == changed
        file.write_bytes(text)


def test_stale_verdicts_are_not_read(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    content = json.loads((stored.FOLDER / "euler.json").read_text(encoding="utf-8"))
    (tmp_path / "euler.json").write_text(json.dumps(content | {"sources": "others"}))
    monkeypatch.setattr(stored, "FOLDER", tmp_path)
    stored.read.cache_clear()
    with pytest.raises(stored.StaleError, match="ledger --write"):
        stored.read("euler")
    assert main(["ledger", "--document", "euler"]) == 1
    assert capsys.readouterr().err.startswith("ledger: the stored verdicts on euler are out of ")
    stored.read.cache_clear()


def test_what_is_written_is_read_back(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    entries = stored.read("quaternions")
    monkeypatch.setattr(stored, "FOLDER", tmp_path)
    stored.read.cache_clear()
    stored.write("quaternions", entries, stored.stamp("quaternions"))
    assert stored.read("quaternions") == entries
    stored.read.cache_clear()


def test_a_source_that_changes_while_it_is_judged_leaves_the_verdicts_stale(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    entries, stamp, changed = stored.read("quaternions"), stored.stamp, []

    def judged(_: str) -> tuple[list[Entry], list[str]]:
        changed.append("a source")
        return [*entries], []

    monkeypatch.setattr(stored, "FOLDER", tmp_path)
    monkeypatch.setattr(stored, "stamp", lambda document: f"{stamp(document)} {changed}")
    monkeypatch.setattr(report, "judged", judged)
    assert report.refresh("quaternions") == 0
    assert stored.is_stale("quaternions")


def test_check_names_what_differs(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    entries = stored.read("sensors")
    other = dataclasses.replace(entries[0], verdict="reported")
    monkeypatch.setattr(report, "judged", lambda _: ([other, *entries[1:]], []))
    assert report.check("sensors") == 1
    assert capsys.readouterr().err == f"{other.id}: judged otherwise than stored\n"
    monkeypatch.setattr(report, "judged", lambda _: (list(entries), []))
    assert report.check("sensors") == 0
    assert capsys.readouterr().out == f"{len(entries)} entries judged again: each as stored\n"


def test_who_stores_what_is_stored_already_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    assert report.refresh("sensors") == 0
    assert capsys.readouterr().out == "nothing is out of date\n"


def test_the_stored_ledger_is_printed_without_sympy() -> None:
    program = (
        "import sys; from chr_notes.__main__ import main; main(['ledger']); "
        "assert 'sympy' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", program], check=True, stdout=subprocess.DEVNULL)
