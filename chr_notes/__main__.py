"""The command line: build the book, print the ledger, export the generated code."""

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

VERDICTS = ("definition", "proved", "qualified", "corrected", "reported")


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit code."""
    options = _parser().parse_args(arguments)
    # Each command loads what it needs: the book wants Sphinx, judging wants SymPy.
    if options.command == "book":
        from chr_notes.book import build  # noqa: PLC0415

        try:
            build(open_browser=options.open)
        except RuntimeError as error:
            # It says what is missing or wrong; where in the program does not help.
            print(f"book: {error}", file=sys.stderr)
            return 1
        return 0
    if options.command == "ledger":
        return _ledger(options)
    from chr_notes.export import export  # noqa: PLC0415

    try:
        written = export(options.language, options.folder)
    except OSError as error:
        # Where it is to go is the user's choice, so it is no fault of the program's.
        print(f"export: {error}", file=sys.stderr)
        return 2
    for path in written:
        print(path)
    return 0


def _ledger(options: argparse.Namespace) -> int:
    """Print, check or refresh the stored verdicts."""
    from chr_notes.ledger import report  # noqa: PLC0415

    if options.write:
        return report.refresh(options.document)
    if options.check:
        return report.check(options.document)
    return report.run(options.document, options.verdict, as_json=options.json)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="chr-notes", description="The CH Robotics notes, checked."
    )
    commands = parser.add_subparsers(dest="command", required=True)
    book = commands.add_parser("book", help="build the book into book/_build/html")
    book.add_argument("--open", action="store_true", help="open it in the browser when built")
    ledger = commands.add_parser("ledger", help="print every printed statement with its verdict")
    ledger.add_argument("--document", help="only this one, such as euler")
    ledger.add_argument("--verdict", choices=VERDICTS, help="only entries with this one")
    ledger.add_argument("--json", action="store_true", help="a list of objects, not a table")
    ledger.add_argument("--write", action="store_true", help="judge what changed, and store it")
    ledger.add_argument("--check", action="store_true", help="judge all, compare with the stored")
    code = commands.add_parser("export", help="write the generated code for another program")
    code.add_argument("language", choices=("c", "js"))
    code.add_argument("folder", type=Path, help="written to; made if it is not there")
    return parser


if __name__ == "__main__":
    sys.exit(main())
