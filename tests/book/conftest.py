"""The book, built once for all its tests."""

from collections.abc import Callable
from pathlib import Path

import pytest

from chr_notes.book import build


@pytest.fixture(scope="session")
def book(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of the built pages."""
    return build(output=tmp_path_factory.mktemp("book")).parent


@pytest.fixture(scope="session", params=["http", "file"])
def address(request: pytest.FixtureRequest, book: Path, serve: Callable[[Path], str]) -> str:
    """Where the book is read: from a server, or straight from the disk."""
    return serve(book) if request.param == "http" else f"{book.as_uri()}/"
