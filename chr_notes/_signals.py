"""Signals by which a command is ended from outside: told once, and by it to what it began."""

import math
import os
import signal
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType
from typing import NoReturn

ENDS = [getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)]
TIDYING = 1.0  # s
# Known while the package is imported, which takes the longest of a short command.
IS_COMMAND = (sys.argv[:1] == ["-m"] and "-m chr_notes " in f"{' '.join(sys.orig_argv)} ") or (
    "".join(sys.argv[:1]).endswith(("chr-notes", "chr-notes.exe"))
)


def stopper() -> Callable[[int, FrameType | None], None]:
    """Return what ends a command, but not a second time while it tidies up."""
    last = -math.inf

    def stop(number: int, _: FrameType | None) -> None:
        nonlocal last
        if time.monotonic() > last + TIDYING:
            last = time.monotonic()
            raise KeyboardInterrupt(number)

    return stop


@contextmanager
def held_back() -> Iterator[None]:
    """Begin processes before Ctrl-C is heard: who knows of them all can end them all."""
    heard: list[int] = []
    before = {number: signal.signal(number, lambda end, _: heard.append(end)) for number in ENDS}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
        for number in heard[:1]:
            signal.raise_signal(number)


def hear_nothing() -> None:
    """Leave it to who began this process to end it, but for one signal, if nobody is left to."""
    for number in ENDS:
        signal.signal(number, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)


def _stop_importing(number: int, _: FrameType | None) -> NoReturn:
    """End at once: there is nothing to tidy up, and NumPy would take an exception for its own."""
    os.write(2, b"chr-notes: stopped before the end\n")
    os._exit(128 + number)


if IS_COMMAND and signal.getsignal(signal.SIGINT) is signal.default_int_handler:
    signal.signal(signal.SIGINT, _stop_importing)
