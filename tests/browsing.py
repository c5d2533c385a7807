"""Pages in a browser without a network: what they do wrong is noted, and they serve once more."""

from collections.abc import Iterable
from contextlib import ExitStack
from dataclasses import dataclass, field
from functools import cache
from http import HTTPStatus
from urllib.parse import urlsplit

from playwright.sync_api import Browser, ConsoleMessage, Page, Request, Response, sync_playwright

FLAGS = [
    "--no-sandbox",  # a container's only user is root, for whom Chromium has no sandbox
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",  # no name but this machine's
]

PATIENCE = 120_000  # milliseconds; the machine may be busy

# Playwright keeps an event loop running in its thread, which notebooks' kernels cannot stand: so
# a browser lives for the tests of one folder, and is gone before nbval begins.
RUNNING = ExitStack()


@cache
def chromium(path: str) -> Browser:
    """Launch a browser, or give the one that runs."""
    RUNNING.callback(chromium.cache_clear)
    RUNNING.callback(SPARE.clear)
    playwright = RUNNING.enter_context(sync_playwright())
    launched = playwright.chromium.launch(executable_path=path, args=FLAGS)
    RUNNING.callback(launched.close)
    return launched


Settings = tuple[tuple[str, str | bool], ...]


@dataclass(frozen=True)
class Watched:
    """A page, what it did wrong, and from where it had its documents."""

    page: Page
    settings: Settings
    problems: list[str] = field(default_factory=list)
    origins: set[str] = field(default_factory=set)


# A page in a process of its own takes twice as long as one that goes on in the one before. So a
# page that a test leaves as it was when new is the next one's that wants such a page: from files or
# from a server, with these settings.
SPARE: dict[tuple[str, Settings], Watched] = {}

# What an empty page shows of what stays with it: another clock, scripts for each document, media.
SIGNS = """() => [
  [Date, setTimeout, requestAnimationFrame, fetch].map(String),
  Object.getOwnPropertyNames(window).length,
  ["print", "(prefers-color-scheme: dark)", "(prefers-reduced-motion: reduce)",
   "(forced-colors: active)", "(hover: hover)"].map((query) => matchMedia(query).matches),
  navigator.maxTouchPoints, devicePixelRatio, navigator.onLine,
]"""
FORGET = "() => { localStorage.clear(); sessionStorage.clear(); }"


@cache
def signs_of_a_new_page(browser: Browser, settings: Settings) -> object:
    """Return what an empty page shows on which nothing was."""
    with browser.new_context(**dict(settings)) as context:  # type: ignore[arg-type]
        page = context.new_page()
        page.goto("about:blank")
        return page.evaluate(SIGNS)


def new_page(browser: Browser, size: tuple[int, int], settings: Settings) -> Watched:
    """Open an empty page with a context of its own, and watch it."""
    width, height = size
    viewport = {"width": width, "height": height}
    context = browser.new_context(viewport=viewport, **dict(settings))  # type: ignore[arg-type]
    context.set_default_timeout(PATIENCE)
    watched = Watched(context.new_page(), settings)
    page, problems = watched.page, watched.problems

    def listen(message: ConsoleMessage) -> None:
        if message.type in ("error", "warning"):
            problems.append(f"console {message.type}: {message.text}")

    def look(request: Request) -> None:
        if not request.url.startswith(("file:", "data:", "blob:", "http://127.0.0.1:")):
            problems.append(f"request to elsewhere: {request.url}")
        if request.is_navigation_request():
            watched.origins.add(origin(request.url))

    def check(response: Response) -> None:
        # 304 says of a file that the page has had before that it is as it was.
        if not response.ok and response.status != HTTPStatus.NOT_MODIFIED:
            problems.append(f"{response.status}: {response.url}")

    page.on("console", listen)
    page.on("request", look)
    page.on("pageerror", lambda error: problems.append(f"uncaught: {error}"))
    page.on("requestfailed", lambda request: problems.append(f"failed: {request.url}"))
    page.on("response", check)
    return watched


def origin(address: str) -> str:
    """Return who may read what a page at that address keeps."""
    parts = urlsplit(address)
    return f"{parts.scheme}://{parts.netloc}"


def shared_page(
    browser: Browser, address: str, size: tuple[int, int], settings: Settings
) -> Watched:
    """Return the page that a test before left for such an address, or a new one."""
    watched = SPARE.pop((urlsplit(address).scheme, settings), None)
    if watched is None:
        return new_page(browser, size, settings)
    width, height = size
    watched.page.set_viewport_size({"width": width, "height": height})
    return watched


def keep_nothing(page: Page) -> None:
    """Load each file anew from now on, as for a reader who comes for the first time."""
    page.context.new_cdp_session(page).send("Network.setCacheDisabled", {"cacheDisabled": True})


def close(opened: Iterable[Watched]) -> list[str]:
    """Close pages of their own, and return what they did wrong."""
    problems = []
    for watched in opened:
        watched.page.context.close()
        problems += watched.problems
    return problems


def put_back(browser: Browser, opened: Iterable[Watched]) -> list[str]:
    """Keep pages for the tests that come, and return what is wrong with them."""
    problems = []
    for watched in opened:
        page, origins = watched.page, set(watched.origins)
        kind = (urlsplit(page.url).scheme, watched.settings)
        # What a page keeps of others than the last one is beyond reach.
        if origins != {origin(page.url)} or kind in SPARE:
            problems += close([watched])
            continue
        page.evaluate(FORGET)
        page.mouse.move(0, 0)
        problems += watched.problems  # what it still loads when it is left is none
        page.goto("about:blank")
        if page.evaluate(SIGNS) != signs_of_a_new_page(browser, watched.settings):
            problems.append("the page was left changed: visit it with own=True")
        if problems:
            page.context.close()
            continue
        watched.problems.clear()
        watched.origins.clear()
        SPARE[kind] = watched
    return problems
