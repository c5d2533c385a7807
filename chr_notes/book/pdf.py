"""The whole book as one PDF: its pages joined to one without scripts, which Chromium prints."""

import os
import posixpath
import re
import shutil
import subprocess
import tempfile
from html import escape
from pathlib import Path
from typing import Final
from urllib.parse import urldefrag

__all__ = ["joined", "print_pdf"]

_BROWSERS: Final = (
    "chromium-headless-shell", "chromium", "chromium-browser", "google-chrome", "chrome", "msedge",
)  # fmt: skip
_TAG: Final = re.compile(r"<[a-z][^<>]*>")
_PLACES: Final = re.compile(r' (id|for|aria-labelledby|aria-describedby|href|src)="([^"]*)"')
_LEFT_OUT: Final = re.compile(r"<script\b.*?</script>|<a class=\"headerlink\".*?</a>", re.DOTALL)
# What is folded on a page is open on paper, and of several lines not one alone.
_FOLDED: Final = re.compile(r'<details(?: name="[^"]*")?(?= |>)')
_STYLES: Final = """
@page { size: A4; margin: 18mm 16mm; @bottom-center { content: counter(page); } }
html { font-size: 13px; }
body { display: block; }
.bd-article { padding: 0; break-before: page; }
h1, h2, h3, h4 { break-after: avoid; }
img, tr, .entry, .admonition { break-inside: avoid; }
pre { white-space: pre-wrap; overflow-wrap: anywhere; }
button, .toggle-button { display: none; }
"""


def joined(html: Path, parts: dict[str, list[str]]) -> str:
    """Join pages to one, whose links lead within it.

    Parameters
    ----------
    html
        The folder of the built book.
    parts
        Names of pages, without their endings, by the words above them in the contents.

    Returns
    -------
    str
        A page without scripts, with the contents first. A demo is the picture that stands there
        for readers without them; what is folded is open; what leads to no page of the book and to
        no other site is no link.
    """
    names = [name for part in parts.values() for name in part]
    articles = {name: _article(html, name, names) for name in names}
    titles = {name: _title(article) for name, article in articles.items()}
    first = (html / f"{names[0]}.html").read_text(encoding="utf-8")
    sheets = [
        f'<link rel="stylesheet" href="{_uri(html, names[0], href)}">'
        for href in re.findall(r'<link[^>]*? href="([^"?]*\.css)[^>]*>', first)
    ]
    contents = [
        f"<li>{escape(words)}<ul>"
        + "".join(f'<li><a href="#{_key(name)}">{titles[name]}</a></li>' for name in part)
        + "</ul></li>"
        for words, part in parts.items()
    ]
    return "\n".join(
        [
            '<!doctype html><html lang="en" data-theme="light" data-mode="light">',
            f'<head><meta charset="utf-8"><title>{titles[names[0]]}</title>',
            *sheets,
            f"<style>{_STYLES}</style></head><body>",
            f"<nav><h1>Contents</h1><ul>{''.join(contents)}</ul></nav>",
            *articles.values(),
            "</body></html>",
        ]
    )


def _article(html: Path, name: str, names: list[str]) -> str:
    page = (html / f"{name}.html").read_text(encoding="utf-8")
    article = page.partition('<article class="bd-article">')[2].partition("</article>")[0]
    article = _FOLDED.sub("<details open", _LEFT_OUT.sub("", article))

    def placed(found: re.Match[str]) -> str:
        attribute, value = found.groups()
        if attribute == "href":
            value = _link(name, value, names)
        elif attribute == "src":
            value = _uri(html, name, value)
        else:
            value = " ".join(f"{_key(name)}-{each}" for each in value.split())
        return f' {attribute}="{value}"' if value else ""

    article = _TAG.sub(lambda tag: _PLACES.sub(placed, tag.group()), article)
    return f'<article class="bd-article" id="{_key(name)}">{article}</article>'


def _key(name: str) -> str:
    return name.replace("/", "-")


def _link(name: str, href: str, names: list[str]) -> str:
    if re.match(r"[a-z]+:", href):
        return href
    page, place = urldefrag(href)
    target = posixpath.normpath(posixpath.join(posixpath.dirname(name), page)) if page else name
    target = target.removesuffix(".html")
    if target not in names:
        return ""
    return f"#{_key(target)}-{place}" if place else f"#{_key(target)}"


def _uri(html: Path, name: str, src: str) -> str:
    return src if src.startswith("data:") else (html / name).parent.joinpath(src).resolve().as_uri()


def _title(article: str) -> str:
    found = re.search(r"<h1>(.*?)</h1>", article, re.DOTALL)
    return re.sub(r"<[^>]*>", "", found[1]).strip() if found else ""


def print_pdf(page: str, target: Path) -> None:
    """Print a page, with an outline of its headings.

    Parameters
    ----------
    page
        HTML, with the whole addresses of what it loads.
    target
        The PDF.

    Raises
    ------
    RuntimeError
        If there is no Chromium, or if it printed nothing.
    """
    browser = next(filter(None, map(shutil.which, _BROWSERS)), None)
    if browser is None:
        msg = f"a PDF is printed by Chromium, and none is on the path, by any name: {_BROWSERS}"
        raise RuntimeError(msg)
    with tempfile.TemporaryDirectory() as beside:
        path = Path(beside) / "book.html"
        path.write_text(page, encoding="utf-8")
        command = [
            browser, "--headless", "--disable-gpu", f"--user-data-dir={beside}/profile",
            # For a container's only user Chromium has no sandbox; the page has no scripts.
            *(["--no-sandbox"] if hasattr(os, "geteuid") and os.geteuid() == 0 else []),
            "--no-pdf-header-footer", "--generate-pdf-document-outline",
            f"--print-to-pdf={target.resolve()}", path.as_uri(),
        ]  # fmt: skip
        done = subprocess.run(command, check=False, capture_output=True, text=True)  # noqa: S603 - a fixed command
    if done.returncode != 0 or not target.is_file():
        msg = f"Chromium printed no PDF:\n{done.stderr.strip()}"
        raise RuntimeError(msg)
