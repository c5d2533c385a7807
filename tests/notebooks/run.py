"""Run notebooks in place, as they are committed: `python tests/notebooks/run.py NOTEBOOK ...`."""

import sys
from pathlib import Path

from chr_notes.book.sources import run

if __name__ == "__main__":
    for name in sys.argv[1:]:
        run(Path(name).resolve())
