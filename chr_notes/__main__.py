"""The command line: build the book, copy notebooks, print the ledger, export generated code."""

import argparse
import io
import os
import shutil
import signal
import sys
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

from chr_notes import __version__, kernels_in_use

# As shells tell of a program that was interrupted, and of one whose output nobody reads.
INTERRUPTED, UNREAD = 130, 141
VERDICTS = ("definition", "proved", "qualified", "corrected", "reported")
DOCUMENTS = ("euler", "quaternions", "sensors", "estimation", "dead_reckoning", "validation")
EXIT_CODES = "Exit codes: 0 done, 1 something is wrong, 2 what was asked cannot be done."


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit code."""
    options = _parser().parse_args(arguments)
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")  # a sign that a console lacks is no reason to stop
    try:
        code = COMMANDS[options.command](options)
        sys.stdout.flush()
    except KeyboardInterrupt:
        print(f"{options.command}: stopped before the end", file=sys.stderr)
        return INTERRUPTED
    except BrokenPipeError:
        _write_no_more()
        return UNREAD
    except OSError as error:
        # A full disk, most often; the output's own end would complain again.
        print(f"{options.command}: {_said(error)}", file=sys.stderr)
        _write_no_more()
        return 1
    return code


def _write_no_more() -> None:
    """Let what is still to be printed go nowhere."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _said(error: Exception) -> str:
    """Return what happened and where, without the number that a system has for it."""
    if not isinstance(error, OSError) or error.strerror is None:
        return str(error)
    if isinstance(error, FileExistsError | NotADirectoryError) and error.filename:
        path = Path(error.filename)
        for taken in (path, *path.parents):
            if taken.is_file():
                return f"expected a folder at {taken}, but a file is there; name another folder"
    place = f": {error.filename}" if error.filename else ""
    return f"{error.strerror}{place}"


# Each command loads what it needs: the book wants Sphinx, judging wants SymPy.
def _book(options: argparse.Namespace) -> int:
    from chr_notes.book import build  # noqa: PLC0415

    # Ended from outside, it ends what it began, as when it is interrupted.
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        build(folder=options.folder, open_browser=options.open)
    except (RuntimeError, OSError) as error:
        # It says what is missing or wrong; where in the program does not help.
        print(f"book: {_said(error)}", file=sys.stderr)
        return 1
    return 0


def _notebooks(options: argparse.Namespace) -> int:
    from chr_notes.book.sources import copy_notebooks  # noqa: PLC0415

    return _say_written(
        "notebooks", lambda: copy_notebooks(options.folder, solutions=options.solutions)
    )


def _ledger(options: argparse.Namespace) -> int:
    from chr_notes.ledger import report  # noqa: PLC0415

    if options.write:
        return report.refresh(options.document)
    if options.check:
        return report.check(options.document)
    width = shutil.get_terminal_size().columns if sys.stdout.isatty() else None
    return report.run(options.document, options.verdict, as_json=options.json, width=width)


def _export(options: argparse.Namespace) -> int:
    from chr_notes.export import export  # noqa: PLC0415

    return _say_written("export", lambda: export(options.language, options.folder))


def _say_written(command: str, write: Callable[[], Iterable[Path]]) -> int:
    """Write files and print where they are."""
    try:
        written = write()
    except (OSError, RuntimeError) as error:
        # Where it is to go is the user's choice, so it is no fault of the program's.
        print(f"{command}: {_said(error)}", file=sys.stderr)
        return 2
    for path in written:
        print(path)
    return 0


COMMANDS = {"book": _book, "notebooks": _notebooks, "ledger": _ledger, "export": _export}


def _parser() -> argparse.ArgumentParser:
    def command(name: str, told: str, example: str) -> argparse.ArgumentParser:
        return commands.add_parser(
            name, help=told, description=f"{told[0].upper()}{told[1:]}.",
            epilog=f"{example}\n\n{EXIT_CODES}",
            formatter_class=argparse.RawDescriptionHelpFormatter,
        )  # fmt: skip

    parser = argparse.ArgumentParser(
        prog="chr-notes",
        description="The CH Robotics notes on attitude, checked, taught and made into code.",
        epilog="`chr-notes COMMAND --help` says more of each.",
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
        'Needs the extra "book": python -m pip install -e ".[book]" in a clone,\n'
        '"chr-notes[book]" elsewhere. Takes about a minute; elsewhere two more, to run\n'
        "the notebooks.",
    )  # fmt: skip
    book.add_argument("--open", action="store_true", help="open it in the browser when built")
    told = "without a clone: where its sources and the book go; %(default)s if not given"
    book.add_argument("folder", type=Path, nargs="?", default=Path("chr-notes-book"), help=told)

    notebooks = command(
        "notebooks", "copy the notebooks of the chapters, to run and change them",
        "chr-notes notebooks my_notebooks && jupyter lab my_notebooks\n\n"
        'To run them takes the extra "notebooks". What is there already it leaves alone.',
    )  # fmt: skip
    notebooks.add_argument("folder", type=Path, help="copied to; made if it is not there")
    notebooks.add_argument(
        "--without-solutions", dest="solutions", action="store_false",
        help="for a class: exercises have their questions only, and an empty cell for the answer",
    )  # fmt: skip

    ledger = command(
        "ledger", "print every statement that the documents print, with its verdict",
        "chr-notes ledger --document euler --verdict corrected\n"
        "chr-notes ledger --json | python -m json.tool",
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
        "chr-notes export js node_modules/attitude\n\n"
        "What it wrote before it replaces; of other files it touches none.",
    )  # fmt: skip
    code.add_argument("language", choices=("c", "js"), help="C99, or a module of JavaScript")
    code.add_argument("folder", type=Path, help="written to; made if it is not there")
    return parser


if __name__ == "__main__":
    sys.exit(main())
