"""The command line, as one meets it on any console."""

import io
import json
import os
import re
import signal
import sys
from pathlib import Path

import pytest
from typing_extensions import Buffer

from chr_notes import __main__ as command
from chr_notes import __version__
from chr_notes.book import sources
from chr_notes.ledger import entries, stored


@pytest.mark.parametrize(("there", "told"), [(True, "with"), (False, "without")])
def test_it_says_its_version(
    there: bool,  # noqa: FBT001 (one of two cases)
    told: str,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(command, "kernels_in_use", lambda: there)
    with pytest.raises(SystemExit) as ended:
        command.main(["--version"])
    assert ended.value.code == 0
    assert capsys.readouterr().out == f"chr-notes {__version__}, {told} compiled kernels\n"


@pytest.mark.parametrize("name", [None, *command.COMMANDS])
def test_help_has_whole_words_on_the_narrowest_screen(
    name: str | None, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    told = set()
    for columns in (1, 2, 15, 24, 200):
        monkeypatch.setenv("COLUMNS", str(columns))
        with pytest.raises(SystemExit) as ended:
            command.main([*filter(None, [name]), "--help"])
        assert ended.value.code == 0
        told.add(" ".join(capsys.readouterr().out.split("\n\n", 1)[1].split()))
    assert len(told) == 1


@pytest.mark.parametrize("columns", [40, 80])
@pytest.mark.parametrize("name", sorted(command.COMMANDS))
def test_help_tells_what_each_argument_does(
    name: str, columns: int, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", str(columns))
    with pytest.raises(SystemExit) as ended:
        command.main([name, "--help"])
    assert ended.value.code == 0
    _, _, told = capsys.readouterr().out.partition("\n\n")
    codes = " ".join(told[told.index("Exit codes: 0 done") :].split())
    assert f"; {command.SIGNALLED + signal.SIGINT} stopped" in codes
    assert f"; {command.UNREAD} nobody" in codes
    options, _, _ = told.partition("Exit codes")
    assert {*re.findall(r"--\w+", codes)} <= {*re.findall(r"--\w+", options)}
    # Commands stay whole, to be copied.
    lines = [line for line in told.splitlines() if not line.startswith("chr-notes ")]
    assert max(map(len, lines)) <= columns
    assert "-\n" not in told


def test_choices_are_those_of_the_ledger() -> None:
    assert command.DOCUMENTS == stored.DOCUMENTS
    assert {entry.verdict for entry in entries()} == {*command.VERDICTS}


def test_an_unknown_choice_is_answered_with_the_known_ones(
    capsys: pytest.CaptureFixture[str],
) -> None:
    with pytest.raises(SystemExit) as ended:
        command.main(["ledger", "--document", "nowhere"])
    assert ended.value.code == 2
    assert "'nowhere' (choose from" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["book", "--nope"], "usage: chr-notes book [-h]"),
        (["--nope", "ledger"], "usage: chr-notes ledger [-h]"),
        (["export", "js", ""], "argument folder: expected a folder, got an empty name"),
        (["notebooks", ""], "argument folder: expected a folder, got an empty name"),
    ],
)
def test_what_is_written_wrongly_is_told_with_the_usage(
    arguments: list[str],
    told: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(SystemExit) as ended:
        command.main(arguments)
    assert ended.value.code == 2
    assert told in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def written(arguments: list[str], encoding: str, monkeypatch: pytest.MonkeyPatch) -> str:
    """What a command writes to a console of that encoding."""
    console = io.TextIOWrapper(io.BytesIO(), encoding=encoding)
    monkeypatch.setattr(sys, "stdout", console)
    assert command.main(arguments) == 0
    return console.buffer.getvalue().decode(encoding)  # type: ignore[attr-defined] # a BytesIO


def test_a_console_of_ascii_gets_the_whole_ledger(monkeypatch: pytest.MonkeyPatch) -> None:
    table = written(["ledger"], "ascii", monkeypatch)
    assert len(table.splitlines()) == len(list(entries())) + 2
    assert "?" in table  # in place of a sign that it lacks
    rows = json.loads(written(["ledger", "--json"], "ascii", monkeypatch))
    assert [row["says"] for row in rows] == [entry.says for entry in entries()]


def on_a_screen(columns: int, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The lines of a table on a screen of that width, to which they keep."""
    monkeypatch.setenv("COLUMNS", str(columns))
    console = io.StringIO()
    monkeypatch.setattr(console, "isatty", lambda: True)
    monkeypatch.setattr(sys, "stdout", console)
    assert command.main(["ledger", "--document", "euler"]) == 0
    table = console.getvalue().splitlines()
    assert max(map(len, table)) <= columns
    return table


def test_on_a_screen_the_table_keeps_to_its_width(monkeypatch: pytest.MonkeyPatch) -> None:
    table = on_a_screen(70, monkeypatch)
    assert sum(not line.startswith(" ") for line in table[:-2]) < len(table) - 2
    # What another program reads has a line for each, however narrow the screen.
    own = [entry for entry in entries() if entry.document == "euler"]
    table = written(["ledger", "--document", "euler"], "utf-8", monkeypatch).splitlines()
    assert [line.split("  ")[-1].strip() for line in table[:-2]] == [each.says for each in own]


def test_on_a_narrow_screen_what_is_said_stands_below_the_name(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    table = on_a_screen(30, monkeypatch)
    own = [entry for entry in entries() if entry.document == "euler"]
    names = [line for line in table[: table.index("")] if not line.startswith(" ")]
    assert names == [f"{entry.id}  {entry.verdict}" for entry in own]
    said = " ".join(line.strip() for line in table if line.startswith("  "))
    assert said == " ".join(entry.says for entry in own)


def test_no_entries_are_a_line(capsys: pytest.CaptureFixture[str]) -> None:
    assert command.main(["ledger", "--document", "euler", "--verdict", "reported"]) == 0
    assert capsys.readouterr().out == "no entries\n"


def test_who_stops_it_gets_a_line(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted(_: object) -> int:
        raise KeyboardInterrupt

    monkeypatch.setitem(command.COMMANDS, "ledger", interrupted)
    assert command.main(["ledger"]) == 130
    assert capsys.readouterr().err == "ledger: stopped before the end\n"


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_who_ends_it_or_its_terminal_gets_a_line(
    number: int, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(command.COMMANDS, "ledger", lambda _: signal.raise_signal(number))
    before = signal.signal(number, signal.SIG_DFL)  # who runs the tests may be left running
    try:
        assert command.main(["ledger"]) == 128 + number
        assert signal.getsignal(number) is signal.SIG_DFL
    finally:
        signal.signal(number, before)
    assert capsys.readouterr().err == "ledger: stopped before the end\n"


@pytest.mark.usefixtures("ctrl_c")
def test_who_stops_it_twice_does_not_stop_what_tidies_up(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    tidied = []

    def tidying(_: object) -> int:
        try:
            signal.raise_signal(signal.SIGINT)
        finally:
            signal.raise_signal(signal.SIGINT)
            tidied.append(True)
        return 0

    monkeypatch.setitem(command.COMMANDS, "ledger", tidying)
    assert command.main(["ledger"]) == 130
    assert tidied == [True]
    assert capsys.readouterr().err == "ledger: stopped before the end\n"


def test_what_a_terminal_leaves_running_runs_on(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(command.COMMANDS, "ledger", lambda _: signal.raise_signal(signal.SIGHUP))
    before = signal.signal(signal.SIGHUP, signal.SIG_IGN)
    try:
        assert command.main(["ledger"]) is None
        assert signal.getsignal(signal.SIGHUP) is signal.SIG_IGN
    finally:
        signal.signal(signal.SIGHUP, before)


def test_a_reader_who_has_read_enough_is_no_error(monkeypatch: pytest.MonkeyPatch) -> None:
    ours, theirs = os.pipe()
    os.close(ours)
    with os.fdopen(theirs, "w", encoding="utf-8") as output:
        monkeypatch.setattr(sys, "stdout", output)
        assert command.main(["ledger"]) == command.UNREAD


def test_what_failed_leaves_the_output_to_what_comes_after(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    taken = tmp_path / "taken"
    taken.touch()
    with (tmp_path / "output").open("w", encoding="utf-8") as output:
        monkeypatch.setattr(sys, "stdout", output)
        assert command.main(["export", "c", str(taken)]) == 1
        output.write("after\n")
    assert (tmp_path / "output").read_text("utf-8") == "after\n"


def test_a_full_disk_is_told_in_a_line(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    with Path("/dev/full").open("w", encoding="utf-8") as output:
        monkeypatch.setattr(sys, "stdout", output)
        assert command.main(["ledger"]) == 1
    assert capsys.readouterr().err == "ledger: No space left on device\n"


@pytest.mark.parametrize("asked", [["--version"], ["ledger", "--help"]], ids=["version", "help"])
def test_a_full_disk_is_told_of_help_too(
    asked: list[str], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    with Path("/dev/full").open("w", encoding="utf-8") as output:
        monkeypatch.setattr(sys, "stdout", output)
        assert command.main(asked) == 1
    assert capsys.readouterr().err == "chr-notes: No space left on device\n"


class InParts(io.FileIO):
    """A file that takes seven bytes at a time."""

    def write(self, given: Buffer, /) -> int:
        return super().write(bytes(given)[:7])


def test_an_output_without_a_buffer_gets_all(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    parts = InParts(tmp_path / "output", "w")
    output = io.TextIOWrapper(parts, encoding="ascii", write_through=True)
    for name in ("stdout", "__stdout__"):
        monkeypatch.setattr(sys, name, output)
    with pytest.raises(SystemExit):
        command.main(["--version"])
    sys.stdout.close()
    told = (tmp_path / "output").read_text(encoding="ascii")
    assert re.fullmatch(r"chr-notes .* compiled kernels\n", told)


@pytest.mark.parametrize("asked", [["--version"], ["ledger"]], ids=["version", "ledger"])
def test_a_closed_output_is_told_in_a_line(
    asked: list[str], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, "stdout", None)  # as Python has it
    assert command.main(asked) == 1
    said = "chr-notes: expected an output to write to, but it is closed\n"
    assert capsys.readouterr().err == said
    monkeypatch.setattr(sys, "stderr", None)
    assert command.main(asked) == 1


@pytest.mark.parametrize("below", ["", "below"])
def test_a_file_in_the_place_of_a_folder_is_told_in_a_line(
    below: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    taken = tmp_path / "taken"
    taken.touch()
    for asked in (["export", "c"], ["notebooks"]):
        assert command.main([*asked, str(taken / below)]) == 1
        said = f"expected a folder at {taken}, but a file is there; name another folder"
        assert capsys.readouterr().err == f"{asked[0]}: {said}\n"


def test_a_device_in_the_place_of_a_folder_is_told_in_a_line(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert command.main(["export", "c", "/dev/null"]) == 1
    said = "expected a folder at /dev/null, but a file is there; name another folder"
    assert capsys.readouterr().err == f"export: {said}\n"


@pytest.mark.parametrize("place", ["taken", "taken/notebooks"])
def test_a_file_in_the_place_of_a_folder_of_the_book_is_told_before_any_is_made(
    place: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    taken = tmp_path / place
    taken.parent.mkdir(exist_ok=True)
    taken.touch()
    packed = {str(sources.PACKED / each): b"{}" for each in ("book/_toc.yml", "notebooks/one.json")}
    monkeypatch.setattr(sources, "ORIGIN", sources.PACKED)
    monkeypatch.setattr("chr_notes.book._require", lambda: None)  # nothing is built here
    monkeypatch.setattr(sources, "_require_sources", lambda: None)
    monkeypatch.setattr(sources, "archived", lambda: packed)
    assert command.main(["book", str(tmp_path / "taken")]) == 1
    said = f"expected a folder at {taken}, but a file is there; name another folder"
    assert capsys.readouterr().err == f"book: {said}\n"
    assert [path for path in tmp_path.rglob("*") if path not in (taken, taken.parent)] == []


def test_a_list_and_a_judgement_are_not_had_at_once(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as ended:
        command.main(["ledger", "--json", "--check"])
    assert ended.value.code == 2
    assert "not allowed with argument --json" in capsys.readouterr().err
