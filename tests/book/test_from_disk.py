"""Pages opened straight from the disk, where a browser refuses some of what a server may."""

import re
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Page

from .test_pages import PAGES, looked_at

# Scripts do the same on each page as on another of its kind; the others are tried with `--full`.
KINDS = (
    PAGES[0],
    "book/converter.html",
    "book/ledger.html",
    "book/ledger/sensors.html",
    "book/speed.html",
    "notebooks/estimation.html",
    "search.html",
)


def test_pages_stand_from_the_disk(
    visit: Callable[..., Page], book: Path, pytestconfig: pytest.Config
) -> None:
    page = visit("about:blank", color_scheme="dark")
    for name in PAGES if pytestconfig.getoption("full") else KINDS:
        page.goto((book / name).as_uri())
        looked_at(page)


def test_each_script_is_tried_from_the_disk(book: Path) -> None:
    scripts = {
        name: {
            *re.findall(r'<script[^>]* src="(?:[^"]*/)?([\w.-]+)', (book / name).read_text("utf-8"))
        }
        for name in PAGES
    }
    assert set().union(*scripts.values()) == set().union(*(scripts[name] for name in KINDS))
