"""The built book as one PDF.

Its pages are joined to one without scripts, which Chromium prints: links lead within it, headings
are its outline, and a demo is the picture that stands there for readers without scripts. It has
some five hundred pages and takes minutes.
"""

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

__all__ = ["browser", "joined", "parts_of", "print_pdf"]

_VARIABLE: Final = "CHR_NOTES_CHROMIUM"
_BROWSERS: Final = (
    "chromium-headless-shell", "chromium", "chromium-browser", "google-chrome", "chrome", "msedge",
)  # fmt: skip
_SIDEBAR: Final = re.compile(
    r'class="caption-text">(.*?)<|<a class="reference internal" href="([^"#]+)\.html"'
)
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
h1, h2, h3, h4 { padding-top: 0.5em; break-after: avoid; } /* at the top of a page, too */
"""


def parts_of(html: Path) -> dict[str, list[str]]:
    """Take from the first page's sidebar the names of all pages, by the words above them."""
    first = "book/index"
    page = (html / f"{first}.html").read_text(encoding="utf-8")
    sidebar = page.partition('<nav class="bd-links')[2].partition("</nav>")[0]
    parts = {"The book": [first]}
    for words, name in _SIDEBAR.findall(sidebar):
        if words:
            parts[words] = []
        else:
            parts[[*parts][-1]].append(posixpath.normpath(f"book/{name}"))
    return parts


def joined(html: Path, parts: dict[str, list[str]]) -> str:
    """Join pages to one, whose links lead within it.

    What is folded is open, and what leads to no page of the book and to no other site is no link.
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


def browser() -> str:
    """Find what prints: the program that a variable names, else a Chromium on the path.

    Raises
    ------
    RuntimeError
        If there is none.
    """
    named = os.environ.get(_VARIABLE)
    names = (named,) if named else _BROWSERS
    found = next(filter(None, map(shutil.which, names)), None)
    if found is None:
        msg = (
            f"a PDF is printed by Chromium, and there is no {' or '.join(names)} on the path: "
            f"install one, or name a program in {_VARIABLE}"
        )
        raise RuntimeError(msg)
    return found


def print_pdf(page: str, target: Path) -> None:
    """Print HTML that has the whole addresses of what it loads; put in place when it is whole.

    Raises
    ------
    RuntimeError
        Without a Chromium, or if it prints nothing.
    """
    program = browser()
    with tempfile.TemporaryDirectory(dir=target.parent, prefix=".print-") as beside:
        path, printed = Path(beside) / "book.html", Path(beside) / "book.pdf"
        path.write_text(page, encoding="utf-8")
        command = [
            program, "--headless", "--disable-gpu", f"--user-data-dir={beside}/profile",
            # For a container's only user Chromium has no sandbox; the page has no scripts.
            *(["--no-sandbox"] if hasattr(os, "geteuid") and os.geteuid() == 0 else []),
            "--no-pdf-header-footer", "--generate-pdf-document-outline",
            f"--print-to-pdf={printed.resolve()}", path.resolve().as_uri(),
        ]  # fmt: skip
        done = subprocess.run(command, check=False, capture_output=True, text=True)  # noqa: S603 - a fixed command
        if done.returncode != 0 or not printed.is_file():
            msg = f"Chromium printed no PDF:\n{done.stderr.strip()}"
            raise RuntimeError(msg)
        printed.replace(target)
