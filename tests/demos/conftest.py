"""A page with demos on it and nothing else."""

from collections.abc import Callable
from pathlib import Path

import pytest

from chr_notes.demos.base import Demo, page_script, styles

MakePage = Callable[..., str]


@pytest.fixture(scope="session")
def window() -> tuple[int, int]:
    """Small, which takes two fifths less to draw; tests of the layout have sizes of their own."""
    return 480, 600


@pytest.fixture
def page_of(tmp_path: Path) -> MakePage:
    """Write a page with these demos, and return its address."""

    def write(*demos: Demo, theme: str = "light") -> str:
        body = "\n".join(demo.to_html() for demo in demos)
        bundles = sorted({each.bundle for each in demos} or {"demos"})
        script = "\n".join(map(page_script, bundles))
        path = tmp_path / "page.html"
        path.write_text(
            f'<!doctype html><html lang="en" data-theme="{theme}"><meta charset="utf-8">'
            f'<meta name="viewport" content="width=device-width"><title>Demos</title>'
            f"<style>{styles()}</style><body>{body}<script>{script}</script></body></html>",
            encoding="utf-8",
        )
        return path.as_uri()

    return write
