"""Signals by which a command is ended from outside: told once, and by it to what it began."""

import math
import signal
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType

ENDS = [getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)]
TIDYING = 1.0  # s


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
