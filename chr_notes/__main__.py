"""The command line: build the book, copy notebooks, print the ledger, export generated code."""

import argparse
import io
import os
import shutil
import signal
import sys
import textwrap
from collections.abc import Iterable, Mapping, Sequence
from contextlib import redirect_stdout
from pathlib import Path
from typing import NoReturn

from chr_notes import __version__, kernels_in_use
from chr_notes._signals import ENDS, stopper

# As shells tell of a program that a signal ended, and of one whose output nobody reads.
SIGNALLED, UNREAD = 128, 141
VERDICTS = ("definition", "proved", "qualified", "corrected", "reported")
DOCUMENTS = ("euler", "quaternions", "sensors", "estimation", "dead_reckoning", "validation")
EXIT_CODES = (
    "Exit codes: 0 done; 1 it failed{}; 2 the command is written wrongly; 130 stopped by Ctrl-C; "
    "141 nobody read its output to the end."
)


def run() -> NoReturn:
    """Run the command and end, by its exit code; then Ctrl-C has nothing to stop any more."""
    code = main()
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    sys.exit(code)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit code."""
    if sys.stderr is None:  # closed by the shell, as the output may be
        sys.stderr = io.StringIO()
    if sys.stdout is None:
        print("chr-notes: expected an output to write to, but it is closed", file=sys.stderr)
        return 1
    # Ended from outside, it ends what it began, as when it is interrupted, but by nohup.
    stop = stopper()
    ends = [number for number in ENDS if signal.getsignal(number) is not signal.SIG_IGN]
    before = {number: signal.signal(number, stop) for number in ends}
    name = "chr-notes"
    try:
        options = _read(arguments)
        name = options.command
        code = COMMANDS[name](options)
        sys.stdout.flush()
    except KeyboardInterrupt as stopped:
        print(f"{name}: stopped before the end", file=sys.stderr)
        return SIGNALLED + (stopped.args[0] if stopped.args else signal.SIGINT)
    except BrokenPipeError:
        _end_output()
        return UNREAD
    except (OSError, RuntimeError) as error:
        # It says what is missing or wrong; where in the program does not help.
        print(f"{name}: {_said(error)}", file=sys.stderr)
        _end_output()
        return 1
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
    return code


def _read(arguments: Sequence[str] | None) -> argparse.Namespace:
    """Read what is asked for, or say how to ask."""
    _keep_whole()
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")  # a sign that a console lacks is no reason to stop
    parser, commands = _parsers()
    helped = io.StringIO()
    try:
        with redirect_stdout(helped):  # argparse does not say that a disk is full
            options, unknown = parser.parse_known_args(arguments)
    except SystemExit:
        print(helped.getvalue(), end="", flush=True)
        raise
    if unknown:  # its own usage helps, not that of all commands
        commands[options.command].error(f"unrecognized arguments: {' '.join(unknown)}")
    return options


def _keep_whole() -> None:
    """Give the output a buffer if it has none: Python would drop what it takes in part."""
    out = sys.__stdout__
    raw: object = out.buffer if isinstance(out, io.TextIOWrapper) else None
    if out is sys.stdout and isinstance(raw, io.RawIOBase):
        whole = io.BufferedWriter(raw)
        sys.stdout = io.TextIOWrapper(whole, encoding=out.encoding, line_buffering=True)


def _end_output() -> None:
    """Write what is still to be printed; where that cannot be, it goes nowhere."""
    try:
        sys.stdout.flush()
    except OSError:  # nobody reads it, or the disk is full; Python's own end would complain again
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _said(error: Exception) -> str:
    """Return what happened and where, without the number that a system has for it."""
    if not isinstance(error, OSError) or error.strerror is None:
        return str(error)
    if isinstance(error, FileExistsError | NotADirectoryError) and error.filename:
        path = Path(error.filename)
        for taken in (path, *path.parents):
            if taken.exists() and not taken.is_dir():
                return f"expected a folder at {taken}, but a file is there; name another folder"
    place = f": {error.filename}" if error.filename else ""
    return f"{error.strerror}{place}"


# Each command loads what it needs: the book wants Sphinx, judging wants SymPy.
def _book(options: argparse.Namespace) -> int:
    from chr_notes.book import build  # noqa: PLC0415

    build(folder=options.folder, open_browser=options.open, as_pdf=options.pdf)
    return 0


def _notebooks(options: argparse.Namespace) -> int:
    from chr_notes.book.sources import copy_notebooks  # noqa: PLC0415

    return _say_written(copy_notebooks(options.folder, solutions=options.solutions))


def _ledger(options: argparse.Namespace) -> int:
    from chr_notes.ledger import report  # noqa: PLC0415

    if options.write:
        return report.refresh(options.document)
    if options.check:
        return report.check(options.document)
    width = shutil.get_terminal_size().columns if sys.stdout.isatty() else None
    report.run(options.document, options.verdict, as_json=options.json, width=width)
    return 0


def _export(options: argparse.Namespace) -> int:
    from chr_notes.export import export  # noqa: PLC0415

    return _say_written(export(options.language, options.folder))


def _say_written(written: Iterable[Path]) -> int:
    for path in written:
        print(path)
    return 0


COMMANDS = {"book": _book, "notebooks": _notebooks, "ledger": _ledger, "export": _export}


def _folder(name: str) -> Path:
    if not name:
        msg = "expected a folder, got an empty name"
        raise argparse.ArgumentTypeError(msg)
    return Path(name)


class _Help(argparse.HelpFormatter):
    """Help filled to the width of the terminal; words stay whole, and commands, to be copied."""

    def _split_lines(self, text: str, width: int) -> list[str]:
        words = " ".join(text.split())
        return textwrap.wrap(words, width, break_long_words=False, break_on_hyphens=False)

    def _fill_text(self, text: str, width: int, indent: str) -> str:
        return "\n\n".join(
            each
            if each.startswith("chr-notes ")
            else "\n".join(indent + line for line in self._split_lines(each, width))
            for each in text.split("\n\n")
        )


def _parsers() -> tuple[argparse.ArgumentParser, Mapping[str, argparse.ArgumentParser]]:
    """Return the parser of the command line, and those of the commands by their names."""

    def command(name: str, told: str, *more: str) -> argparse.ArgumentParser:
        codes = EXIT_CODES.format(", or --check found a difference" if name == "ledger" else "")
        return commands.add_parser(
            name, help=told, description=f"{told[0].upper()}{told[1:]}.",
            epilog="\n\n".join((*more, codes)), formatter_class=_Help,
        )  # fmt: skip

    parser = argparse.ArgumentParser(
        prog="chr-notes",
        description="The CH Robotics notes on attitude, checked, taught and made into code.",
        epilog="`chr-notes COMMAND --help` says more of each.",
        formatter_class=_Help,
    )
    at_work = "with" if kernels_in_use() else "without"
    parser.add_argument(
        "--version",
        action="version",
        version=f"chr-notes {__version__}, {at_work} compiled kernels",
        help="show the version, and whether there are compiled kernels or NumPy computes, and exit",
    )
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")

    book = command(
        "book", "build the book, in a clone into book/_build/html",
        'Needs the extra "book": python -m pip install -e ".[book]" in a clone, "chr-notes[book]" '
        "elsewhere. Takes a minute or two; elsewhere three to five, for it runs notebooks.",
    )  # fmt: skip
    book.add_argument("--open", action="store_true", help="open it in the browser when built")
    told = "print it as one PDF too, by Chromium, which takes minutes"
    book.add_argument("--pdf", action="store_true", help=told)
    told = "%(default)s if not given: where, without a clone, its sources and the book go"
    book.add_argument("folder", type=_folder, nargs="?", default="chr-notes-book", help=told)

    notebooks = command(
        "notebooks", "copy the notebooks of the chapters, to run and change them",
        "chr-notes notebooks my_notebooks && jupyter lab my_notebooks",
        'To run them takes the extra "notebooks". Where one is there already it writes none.',
    )  # fmt: skip
    notebooks.add_argument("folder", type=_folder, help="copied to; made if it is not there")
    notebooks.add_argument(
        "--without-solutions", dest="solutions", action="store_false",
        help="for a class: exercises have their questions only, and an empty cell for the answer",
    )  # fmt: skip

    ledger = command(
        "ledger", "print every statement that the documents print, with its verdict",
        "chr-notes ledger --document euler --verdict corrected\n"
        "chr-notes ledger --json | python -m json.tool",
        "On a screen the table keeps to its width; in a file and for another program an entry is a "
        "line.",
    )  # fmt: skip
    for name, choices in (("document", DOCUMENTS), ("verdict", VERDICTS)):
        told = f"only the entries of this one: {', '.join(choices)}"
        ledger.add_argument(f"--{name}", choices=choices, metavar=name.upper(), help=told)
    what = ledger.add_mutually_exclusive_group()
    what.add_argument("--json", action="store_true", help="a list of objects, not a table")
    what.add_argument("--write", action="store_true", help="judge what changed, and store it")
    what.add_argument(
        "--check", action="store_true", help="judge all, compare with the stored; a minute"
    )

    code = command(
        "export", "write the generated code for a program of your own, with a README",
        "chr-notes export c my_rocket/attitude\n"
        "chr-notes export js node_modules/attitude",
        "What it wrote before it replaces; of other files it touches none.",
    )  # fmt: skip
    code.add_argument("language", choices=("c", "js"), help="C99, or a module of JavaScript")
    code.add_argument("folder", type=_folder, help="written to; made if it is not there")
    return parser, commands.choices


if __name__ == "__main__":
    run()
