"""The command line: `python -m chr_notes book`."""

import argparse
import sys
from collections.abc import Sequence


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit code."""
    parser = argparse.ArgumentParser(
        prog="chr-notes", description="The CH Robotics notes, checked."
    )
    commands = parser.add_subparsers(dest="command", required=True)
    book = commands.add_parser("book", help="build the book into book/_build/html")
    book.add_argument("--open", action="store_true", help="open it in the browser when built")
    options = parser.parse_args(arguments)
    # Each command loads what it needs: the book wants Sphinx, the ledger wants SymPy.
    from chr_notes.book import build  # noqa: PLC0415

    build(open_browser=options.open)
    return 0


if __name__ == "__main__":
    sys.exit(main())
