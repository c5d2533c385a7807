"""The book under a strict content-security policy: what the theme needs beyond it is named here."""

import base64
import hashlib
import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Page, Route, expect

Visit = Callable[..., Page]

# The theme sets styles in attributes, and writes a few lines of script into each page. The font of
# the formulas stands in its style sheet.
POLICY = (
    "default-src 'self'; img-src 'self' data:; font-src 'self' data:; "
    "style-src 'self' 'unsafe-inline'; script-src 'self' {}"
)
INLINE = re.compile(r"<script(?![^>]* src=)[^>]*>(.*?)</script>", re.DOTALL)


def guarded(route: Route) -> None:
    """Answer with the policy, in which each script that stands in the page has its hash."""
    answer = route.fetch()
    scripts = (
        base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()
        for text in INLINE.findall(answer.text())
    )
    hashes = " ".join(f"'sha256-{each}'" for each in scripts)
    headers = answer.headers | {"content-security-policy": POLICY.format(hashes)}
    route.fulfill(response=answer, headers=headers)


# `visit` fails on each violation, which is an error on the console.
@pytest.mark.parametrize("name", ["notebooks/euler", "book/ledger", "book/converter"])
def test_nothing_violates_a_strict_policy(visit: Visit, served: str, name: str) -> None:
    page = visit("about:blank")
    page.route("**/*.html", guarded)
    page.goto(f"{served}{name}.html")
    expect(page.locator("[data-demo] > .chr-demo")).to_have_count(
        page.locator("[data-demo]").count()
    )
    page.locator("button.theme-switch-button").first.click()
