"""What tests share: recordings beside the project, and a browser without a network."""

import functools
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from functools import cache
from http import HTTPStatus
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from types import ModuleType

import pytest
from hypothesis import settings
from playwright.sync_api import (
    Browser,
    ConsoleMessage,
    Page,
    Request,
    expect,
    sync_playwright,
)

from chr_notes import _recordings
from chr_notes._kernels import kernel
from chr_notes._rows import Rows
from chr_notes.ledger.files import files_of

# A first call compiles and caches; how long one example takes says nothing.
# One commit gives one answer; other examples each time are for `--full`.
settings.register_profile("project", deadline=None, derandomize=True)
settings.register_profile("full", deadline=None, max_examples=2_000)

CHROMIUM_FLAGS = [
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
expect.set_options(timeout=PATIENCE)


def pytest_configure(config: pytest.Config) -> None:
    """Let hypothesis try more with `--full`."""
    settings.load_profile("full" if config.getoption("full") else "project")


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    item: pytest.Function, call: pytest.CallInfo[None]
) -> Iterator[pytest.TestReport]:
    """Say, below what a test of an entry or of a derivation finds, in which files to look."""
    report: pytest.TestReport = yield  # type: ignore[misc]
    if report.failed and call.when == "call":
        files = dict.fromkeys(files_to_mend(item))
        if files:
            report.sections.append(("where to mend it", "\n".join(files)))
    return report


def files_to_mend(item: pytest.Function) -> Iterator[str]:
    """Name the files of the entry that a test is of, and of the derivations that it compares."""
    callspec = getattr(item, "callspec", None)
    for value in callspec.params.values() if callspec is not None else ():
        if isinstance(value, str):
            yield from files_of(value)
    for name in item.function.__code__.co_names:
        module = item.function.__globals__.get(name)
        if isinstance(module, ModuleType) and module.__name__.startswith("chr_notes."):
            yield f"{module.__name__.replace('.', '/')}.py"


@pytest.fixture(scope="session")
def samples(pytestconfig: pytest.Config) -> Callable[[int, int], int]:
    """How many samples a test takes: of two numbers the small one, with `--full` the large one."""
    return max if pytestconfig.getoption("full") else min


@pytest.fixture(scope="session")
def rules(pytestconfig: pytest.Config) -> ModuleType:
    """The outermost conftest.py, with the list of what tests may wait for."""
    path = pytestconfig.rootpath / "conftest.py"
    plugin: ModuleType = pytestconfig.pluginmanager.get_plugin(str(path))
    return plugin


@pytest.fixture
def recordings(rules: ModuleType) -> Path:
    """The folder with other people's recordings."""
    rules.wait_for("../shared/data")
    return Path(__file__).resolve().parents[2] / "shared" / "data"


@pytest.fixture(params=[pytest.param("kernels", marks=pytest.mark.kernels), "NumPy"])
def each_way(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Compute by the kernels, and by NumPy."""
    if request.param == "kernels":
        yield
        return
    modules = [module for name, module in sys.modules.items() if name.startswith("chr_notes.")]
    values = [value for module in modules for value in vars(module).values()]
    rows = {id(value): value for value in values if isinstance(value, Rows)}
    assert len(rows) > 20
    for value in rows.values():
        value.use(None)
    monkeypatch.setattr(_recordings, "kernel", lambda _: None)
    yield
    for value in rows.values():
        value.use(kernel(value.name))


@pytest.fixture(scope="session")
def program(rules: ModuleType) -> Callable[[str], str]:
    """Find a program."""

    def find(name: str) -> str:
        rules.wait_for(name)
        return str(rules.program(name))

    return find


# Playwright keeps an event loop running in its thread, which notebooks' kernels cannot stand: so
# a browser lives for the tests of one folder, and is gone before nbval begins.
RUNNING = ExitStack()


@cache
def chromium(path: str) -> Browser:
    """Launch a browser, or give the one that runs."""
    RUNNING.callback(chromium.cache_clear)
    playwright = RUNNING.enter_context(sync_playwright())
    launched = playwright.chromium.launch(executable_path=path, args=CHROMIUM_FLAGS)
    RUNNING.callback(launched.close)
    return launched


@pytest.hookimpl(wrapper=True)
def pytest_runtest_teardown(item: pytest.Item, nextitem: pytest.Item | None) -> Iterator[None]:
    """Close the browser when the tests of a folder are over."""
    yield
    if nextitem is None or nextitem.path.parent != item.path.parent:
        RUNNING.close()


@pytest.fixture(scope="module")
def browser(program: Callable[[str], str]) -> Browser:
    """Debian's Chromium."""
    return chromium(program("chromium"))


Visit = Callable[..., Page]

# Demos come one after the other, when the page is there already.
TO_COME = "[data-demo]:not([data-failed]):not(:has(> .chr-demo))"


@pytest.fixture(scope="session")
def window() -> int:
    """How wide a page is that says nothing of it."""
    return 1280


@pytest.fixture
def visit(browser: Browser, window: int) -> Iterator[Visit]:
    """Open a page; in the end, any request to elsewhere or error on the console fails the test."""
    problems: list[str] = []
    contexts = []

    def listen(message: ConsoleMessage) -> None:
        if message.type in ("error", "warning"):
            problems.append(f"console {message.type}: {message.text}")

    def look(request: Request) -> None:
        if not request.url.startswith(("file:", "data:", "blob:", "http://127.0.0.1:")):
            problems.append(f"request to elsewhere: {request.url}")

    def opened(address: str, *, width: int = window, **settings: str | bool) -> Page:
        context = browser.new_context(viewport={"width": width, "height": 900}, **settings)  # type: ignore[arg-type]
        contexts.append(context)
        context.set_default_timeout(PATIENCE)
        page = context.new_page()
        page.on("console", listen)
        page.on("request", look)
        page.on("pageerror", lambda error: problems.append(f"uncaught: {error}"))
        page.on("requestfailed", lambda request: problems.append(f"failed: {request.url}"))
        page.on(
            "response",
            # 304 says of a file that the page has had before that it is as it was.
            lambda response: (
                response.ok
                or response.status == HTTPStatus.NOT_MODIFIED
                or problems.append(f"{response.status}: {response.url}")
            ),
        )
        page.goto(address)
        expect(page.locator(TO_COME)).to_have_count(0)
        return page

    yield opened
    for context in contexts:
        context.close()
    assert problems == []


class QuietHandler(SimpleHTTPRequestHandler):
    """Serves files and keeps no log."""

    def log_message(self, *_: object) -> None:
        """Say nothing."""


@pytest.fixture(scope="session")
def serve() -> Iterator[Callable[[Path], str]]:
    """Serve a folder on this machine and return its address."""
    servers = []

    def start(folder: Path) -> str:
        server = ThreadingHTTPServer(
            ("127.0.0.1", 0), functools.partial(QuietHandler, directory=str(folder))
        )
        servers.append((server, threading.Thread(target=server.serve_forever)))
        servers[-1][1].start()
        return f"http://127.0.0.1:{server.server_port}/"

    yield start
    for server, thread in servers:
        server.shutdown()
        thread.join()
        server.server_close()
