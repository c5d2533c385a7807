"""What tests share: recordings beside the project, and a browser without a network."""

import functools
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from types import ModuleType

import pytest
from hypothesis import settings
from playwright.sync_api import Browser, Page, expect

from chr_notes import _recordings
from chr_notes._kernels import kernel
from chr_notes._rows import Rows
from chr_notes.ledger.files import files_of

from . import browsing

# A first call compiles and caches; how long one example takes says nothing.
# One commit gives one answer; other examples each time are for `--full`.
settings.register_profile("project", deadline=None, derandomize=True)
settings.register_profile("full", deadline=None, max_examples=2_000)

expect.set_options(timeout=browsing.PATIENCE)


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


@pytest.fixture
def ctrl_c() -> Iterator[None]:
    """Hear Ctrl-C, here and in programs begun here: who runs the tests may keep it from them."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.fixture(scope="session")
def program(rules: ModuleType) -> Callable[[str], str]:
    """Find a program."""

    def find(name: str) -> str:
        rules.wait_for(name)
        return str(rules.program(name))

    return find


@pytest.hookimpl(wrapper=True)
def pytest_runtest_teardown(item: pytest.Item, nextitem: pytest.Item | None) -> Iterator[None]:
    """Close the browser when the tests of a folder are over."""
    yield
    if nextitem is None or nextitem.path.parent != item.path.parent:
        browsing.RUNNING.close()


@pytest.fixture(scope="module")
def browser(program: Callable[[str], str]) -> Browser:
    """Debian's Chromium."""
    return browsing.chromium(program("chromium"))


Visit = Callable[..., Page]

# Demos come one after the other, when the page is there already.
TO_COME = "[data-demo]:not([data-failed]):not(:has(> .chr-demo))"


@pytest.fixture(scope="session")
def window() -> tuple[int, int]:
    """How wide and how high a page is that says nothing of it."""
    return 1280, 900


@pytest.fixture
def visit(
    request: pytest.FixtureRequest, browser: Browser, window: tuple[int, int]
) -> Iterator[Visit]:
    """Open a page; in the end, any request to elsewhere or error on the console fails the test.

    Another test goes on with it, unless it is this one's own: where time is stopped, or scripts,
    routes or media are set for all that the page will show. A cold one has no file from before.
    """
    shared: list[browsing.Watched] = []
    alone: list[browsing.Watched] = []
    failed = request.session.testsfailed

    def opened(
        address: str,
        *,
        width: int = window[0],
        own: bool = False,
        cold: bool = False,
        **settings: str | bool,
    ) -> Page:
        kind = tuple(sorted(settings.items()))
        if own or address == "about:blank":
            alone.append(browsing.new_page(browser, (width, window[1]), kind))
            page = alone[-1].page
        else:
            shared.append(browsing.shared_page(browser, address, (width, window[1]), kind))
            page = shared[-1].page
        if cold:
            browsing.keep_nothing(page)
        page.goto(address)
        expect(page.locator(TO_COME)).to_have_count(0)
        return page

    yield opened
    problems = browsing.close(alone)
    if request.session.testsfailed > failed:  # nobody knows how it left them
        problems += browsing.close(shared)
    else:
        problems += browsing.put_back(browser, shared)
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
