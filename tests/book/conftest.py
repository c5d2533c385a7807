"""The book, built once for all its tests."""

from collections.abc import Callable
from pathlib import Path

import pytest

from chr_notes.book import build


@pytest.fixture(scope="session")
def book() -> Path:
    """The folder of the pages: those of the clone, of which only what changed is built anew."""
    return build().parent


@pytest.fixture(scope="session")
def served(book: Path, serve: Callable[[Path], str]) -> str:
    """Where a server has the book."""
    return serve(book)


@pytest.fixture(params=["http", "file"])
def address(request: pytest.FixtureRequest, book: Path, served: str) -> str:
    """Where the book is read: from a server, and straight from the disk."""
    return served if request.param == "http" else f"{book.as_uri()}/"
