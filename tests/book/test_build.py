"""Building the book: what it says, and what it says when something is missing."""

import errno
import importlib.util
import os
import shutil
import signal
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path
from types import SimpleNamespace

import pytest
from sphinx.util import console

import chr_notes.book
from chr_notes.__main__ import main
from chr_notes.book import ROOT, SOURCES, build, ledger_pages, pages, pdf, run_sphinx, sources
from chr_notes.conventions import CONVENTIONS
from chr_notes.ledger import entries
from chr_notes.palette import PALETTE, css


def test_missing_package_names_the_command_that_brings_it(monkeypatch: pytest.MonkeyPatch) -> None:
    found = importlib.util.find_spec
    monkeypatch.setattr(
        importlib.util, "find_spec", lambda name: None if name == "jupyter_book" else found(name)
    )
    with pytest.raises(
        RuntimeError, match=r'jupyter_book; run: python -m pip install "chr-notes\[book'
    ):
        build()


def test_the_command_says_what_is_missing_in_a_line(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sources, "ORIGIN", tmp_path)
    assert main(["book"]) == 1
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.startswith("book: expected the sources of the book in ")
    assert said.err.count("\n") == 1


@pytest.mark.parametrize(("result", "code"), [(0, 0), (1, 1), (OSError("no such page"), 1)])
def test_a_program_that_found_errors_or_ended_in_one_says_so(
    result: int | OSError, code: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("jupyter_book.sphinx.build_sphinx", lambda *_, **__: result)
    assert run_sphinx.run(tmp_path, whole=True) == code


@pytest.mark.parametrize(
    ("variable", "said"), [("NO_COLOR", "begun"), ("TERM", "begun"), ("FORCE_COLOR", "<begun>")]
)
def test_colours_are_for_a_screen(
    variable: str,
    said: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    def builds(*_: object, **__: object) -> int:
        sys.stdout.write(console.colorize("bold", "begun"))
        return 0

    for each in ("NO_COLOR", "FORCE_COLOR"):
        monkeypatch.delenv(each, raising=False)
    monkeypatch.setenv(variable, "xterm")
    monkeypatch.setattr(console, "codes", {"bold": "<", "reset": ">"})
    monkeypatch.setattr("jupyter_book.sphinx.build_sphinx", builds)
    assert run_sphinx.run(tmp_path, whole=True) == 0
    assert capsys.readouterr().out == said


@pytest.mark.full
@pytest.mark.usefixtures("ctrl_c")
@pytest.mark.parametrize("after", [0.3, 1.0, 4.0])  # s: while it loads, and while it reads
def test_who_presses_ctrl_c_while_pages_are_built_gets_a_line(book: Path, after: float) -> None:
    run = [sys.executable, "-m", "chr_notes", "book"]
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True}
    (SOURCES / "index.md").touch()
    with subprocess.Popen(run, cwd=ROOT, start_new_session=True, **pipes) as command:
        begun = next(line for line in command.stdout if line.startswith("Building"))
        time.sleep(after)
        os.killpg(command.pid, signal.SIGINT)  # as a terminal does
        said = command.stdout.read()
    assert command.returncode == 130
    assert begun == "Building the pages that changed …\n"
    assert said.endswith("book: stopped before the end\n")
    assert "Traceback" not in said
    assert (book / "index.html").is_file()
    assert not [*SOURCES.glob(".build-*")]


@pytest.mark.parametrize(
    ("free", "told"), [(1_000, "No space left on device: {}"), (10**9, "Jupyter Book found errors")]
)
def test_what_jupyter_book_found_no_room_for_is_told_by_the_disk(
    free: int,
    told: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr(sources, "find", lambda _: tmp_path)
    monkeypatch.setattr(chr_notes.book, "_made_by", lambda _: "of today")
    monkeypatch.setattr(chr_notes.book, "write_generated", lambda *_: None)
    monkeypatch.setattr(subprocess, "run", lambda *_, **__: SimpleNamespace(returncode=1))
    monkeypatch.setattr(shutil, "disk_usage", lambda _: SimpleNamespace(free=free))
    assert main(["book"]) == 1
    assert f"book: {told.format(tmp_path / 'book')}" in capsys.readouterr().err
    assert list((tmp_path / "book").iterdir()) == []


@pytest.fixture
def runs(monkeypatch: pytest.MonkeyPatch) -> list[bool]:
    """Put a page of one word in place of the book's, and note whether each run is a whole one."""
    whole_ones = []

    def run(_: Path, aside: Path, *, whole: bool) -> None:
        whole_ones.append(whole)
        page = aside / "html" / "index.html"
        assert page.exists() == (not whole)
        sheet = page.with_name("mystnb.12.css")
        assert not sheet.exists()  # it would be said that it is overwritten
        page.parent.mkdir(parents=True, exist_ok=True)
        for file in (page, sheet):
            file.write_text(f"run {len(whole_ones)}", encoding="utf-8")
        if len(whole_ones) == 3:
            msg = "the third"
            raise RuntimeError(msg)

    monkeypatch.setattr(chr_notes.book, "_run_sphinx", run)
    monkeypatch.setattr(chr_notes.book, "write_generated", lambda *_: None)
    return whole_ones


def test_a_book_is_put_in_place_when_it_is_whole(runs: list[bool], tmp_path: Path) -> None:
    for number in (1, 2):
        assert build(output=tmp_path).read_text(encoding="utf-8") == f"run {number}"
    with pytest.raises(RuntimeError, match="the third"):
        build(output=tmp_path)
    # The one before stays, and nothing else does.
    assert (tmp_path / "_build/html/index.html").read_text(encoding="utf-8") == "run 2"
    assert [path.name for path in tmp_path.iterdir()] == ["_build"]
    assert runs == [True, False, False]


def test_sphinx_ends_without_a_word_where_nobody_reads(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "chr_notes.book.run_sphinx", str(tmp_path / "aside"), "--all"]
    unread, output = os.pipe()
    os.close(unread)
    done = subprocess.run(command, cwd=tmp_path, stdout=output, stderr=output, check=False)
    os.close(output)
    assert done.returncode == -signal.SIGPIPE


def test_a_book_that_nobody_reads_of_is_no_faulty_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    ended = SimpleNamespace(returncode=-signal.SIGPIPE)
    monkeypatch.setattr(chr_notes.book.subprocess, "run", lambda *_, **__: ended)
    with pytest.raises(BrokenPipeError):
        build(output=tmp_path)
    assert capsys.readouterr().err == ""


def test_who_stops_it_between_two_books_has_the_one_before(
    runs: list[bool], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    build(output=tmp_path)
    rename = Path.rename

    def stopped(self: Path, target: Path) -> Path:
        if self.parent.name.startswith(".build-") and self.name == "_build":
            raise KeyboardInterrupt
        return rename(self, target)

    monkeypatch.setattr(Path, "rename", stopped)
    with pytest.raises(KeyboardInterrupt):
        build(output=tmp_path)
    assert runs == [True, False]
    assert (tmp_path / "_build/html/index.html").read_text(encoding="utf-8") == "run 1"
    assert [path.name for path in tmp_path.iterdir()] == ["_build"]


def test_a_printed_book_lies_beside_its_pages_until_they_are_built_again(
    runs: list[bool], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(pdf, "browser", lambda: "")
    monkeypatch.setattr(pdf, "parts_of", lambda _: {})
    monkeypatch.setattr(pdf, "joined", lambda html, _: (html / "index.html").read_text())
    monkeypatch.setattr(pdf, "print_pdf", lambda page, target: target.write_text(page))
    build(output=tmp_path, as_pdf=True)
    printed = tmp_path / "_build" / "chr-notes.pdf"
    assert printed.read_text(encoding="utf-8") == "run 1"
    build(output=tmp_path)
    assert runs == [True, False]
    assert not printed.exists()


def test_another_program_makes_all_pages_anew(
    runs: list[bool], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    build(output=tmp_path)
    monkeypatch.setattr(chr_notes.book, "_MAKERS", ("numpy",))
    build(output=tmp_path)
    assert runs == [True, True]


def test_pages_from_data_are_written_where_their_makers_changed(
    runs: list[bool], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    generated = tmp_path / "book" / "_generated"
    generated.mkdir(parents=True)
    written = []
    monkeypatch.setattr(sources, "find", lambda _: tmp_path)
    monkeypatch.setattr(chr_notes.book, "_made_by", lambda _: "of today")
    monkeypatch.setattr(chr_notes.book, "write_generated", lambda *given: written.append(given))
    for made_by, times in (("of yesterday", 1), ("of today", 1)):
        (generated / "made_by").write_text(made_by, encoding="utf-8")
        build(output=tmp_path)
        assert len(written) == times
    assert runs == [True, False]


def test_a_folder_that_cannot_be_written_is_told_in_a_line(
    runs: list[bool], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(chr_notes.book, "_made_by", lambda _: "another program")

    def full(*_: object, **__: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), "page.html")

    monkeypatch.setattr(chr_notes.book, "write_generated", full)
    assert main(["book"]) == 1
    assert capsys.readouterr().err == "book: No space left on device: page.html\n"
    assert runs == []


def test_what_did_not_change_keeps_its_time(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text("one", encoding="utf-8")
    os.utime(page, (1, 1))
    chr_notes.book._write(page, "one")  # noqa: SLF001
    assert page.stat().st_mtime == 1
    chr_notes.book._write(page, "two")  # noqa: SLF001
    assert page.stat().st_mtime > 1


def test_each_convention_is_on_its_page() -> None:
    text = pages.conventions()
    for convention in CONVENTIONS:
        assert f"## {convention.title}\n\n{convention.statement}\n" in text


def test_counts_of_verdicts_are_those_of_the_ledger() -> None:
    text = pages.verdicts(entries())
    for verdict, count in Counter(entry.verdict for entry in entries()).items():
        assert f'<li><b>{count}</b> <span class="verdict verdict-{verdict}">' in text


def test_each_entry_says_what_the_derivation_has() -> None:
    text = "".join(ledger_pages.generated(entries()).values())
    for entry, said in {
        "euler.3.1": "The derivation gives the right-hand side that stands above.",
        "euler.6.e": "The derivation gives the right-hand side that stands above.",  # corrected
        "validation.3": "What the derivation gives:",  # its angle stands inside the print
        "validation.1": "It was decided on the equation itself",
        "euler.2.a": "The statement was decided as a proposition",
    }.items():
        after = text.partition(f"({entry})=")[2].partition(":::::\n")[0]
        assert f"\n{said}" in after, entry


def test_every_colour_is_a_variable_in_both_themes() -> None:
    for name, colour in PALETTE.items():
        assert f"--chr-{name}: {colour.light};" in css()
        assert f"--chr-{name}: {colour.dark};" in css()


def luminance(colour: str) -> float:
    """Relative luminance as the web's accessibility guidelines define it."""
    channels = (int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5))
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in channels]
    return float(0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2])


def contrast(a: str, b: str) -> float:
    low, high = sorted((luminance(a), luminance(b)))
    return (high + 0.05) / (low + 0.05)


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_colours_stand_out(theme: str) -> None:
    """Text at 4.5:1 and graphics at 3:1 on everything that they may stand on."""
    text = {"ink", "muted", "accent", "definition", "proved", "qualified", "corrected", "reported"}
    colour = {name: getattr(each, theme) for name, each in PALETTE.items()}
    for ground in ("page", "surface", "raised"):
        for name in text:
            assert contrast(colour[name], colour[ground]) >= 4.5, (name, ground)
        for name in ("x", "y", "z", "alert"):
            assert contrast(colour[name], colour[ground]) >= 3, (name, ground)
