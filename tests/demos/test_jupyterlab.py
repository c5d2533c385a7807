"""In a live JupyterLab: a slider moves the trait in Python, and the trait moves the slider."""

import os
import re
import secrets
import subprocess
import sys
import time
from collections.abc import Iterator
from importlib.metadata import distribution
from pathlib import Path
from urllib.error import URLError
from urllib.request import urlopen

import nbformat
import pytest
from playwright.sync_api import Browser, Page, expect

from .parts import output, slider, state_of

pytestmark = pytest.mark.full  # a server, a kernel and their page: half a minute

PATIENCE = 120  # seconds until the server answers
CELLS = (
    "from chr_notes.demos import GimbalLockDemo\ndemo = GimbalLockDemo(yaw=30.0)\ndemo",
    'print("pitch in Python:", demo.pitch)',
    "demo.pitch = 60.0",
)


@pytest.fixture
def lab(tmp_path: Path) -> Iterator[str]:
    """The address of a notebook in a JupyterLab that runs on this machine alone."""
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(each) for each in CELLS])
    notebook.metadata["kernelspec"] = {"name": "python3", "display_name": "Python 3"}
    nbformat.write(notebook, tmp_path / "demo.ipynb")
    token = secrets.token_hex(16)
    settings = [
        *("--no-browser", "--allow-root", "--ip=127.0.0.1", f"--notebook-dir={tmp_path}"),
        *(f"--IdentityProvider.token={token}", "--LabApp.news_url=None"),
        *("--LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate",),
    ]
    # Where the widgets' extensions are, also where the environment is one on top of another.
    files = distribution("anywidget").files or ()
    extension = next(each for each in files if each.match("labextensions/anywidget/package.json"))
    share = Path(extension.locate()).resolve().parents[2]
    folders = {f"JUPYTER_{name}": str(tmp_path / name) for name in ("CONFIG_DIR", "RUNTIME_DIR")}
    folders["JUPYTER_PATH"] = str(share)
    log = tmp_path / "log"
    with log.open("w", encoding="utf-8") as written:
        server = subprocess.Popen(
            [sys.executable, "-m", "jupyterlab", *settings],
            stderr=written, stdout=written, cwd=tmp_path, env=os.environ | folders,
        )  # fmt: skip
        try:
            yield f"{answering(log)}lab/tree/demo.ipynb?token={token}"
        finally:
            server.terminate()
            server.wait(timeout=PATIENCE)


def answering(log: Path) -> str:
    """Wait until the server says where it is, and answers there."""
    for _ in range(PATIENCE):
        found = re.search(r"http://127\.0\.0\.1:\d+/", log.read_text(encoding="utf-8"))
        if found is not None:
            try:
                urlopen(found[0] + "api", timeout=5).close()  # noqa: S310 (this machine's)
            except URLError:
                pass
            else:
                return found[0]
        time.sleep(1)
    raise AssertionError(log.read_text(encoding="utf-8"))


def run(page: Page, number: int) -> None:
    """Run a cell, and wait until it has been."""
    cell = page.locator(".jp-CodeCell").nth(number)
    before = cell.locator(".jp-InputPrompt").inner_text()
    cell.locator(".cm-content").click()
    page.keyboard.press("Control+Enter")
    expect(cell.locator(".jp-InputPrompt")).not_to_have_text(before)
    expect(cell.locator(".jp-InputPrompt")).to_have_text(re.compile(r"\[\d+\]"))


def test_traits_follow_the_page_and_the_page_the_traits(browser: Browser, lab: str) -> None:
    page = browser.new_page(viewport={"width": 1280, "height": 1400})
    page.set_default_timeout(120_000)
    page.goto(lab)
    expect(page.get_by_text("| Idle")).to_be_visible()  # the kernel: what is run before is lost
    run(page, 0)
    demo = page.locator(".chr-demo")
    expect(demo).to_have_count(1)
    assert state_of(page)["yaw"] == 30
    slider(page, "pitch").fill("59")
    slider(page, "pitch").press("ArrowRight")
    slider(page, "pitch").press("ArrowRight")  # a key for the slider is none of the notebook's
    expect(output(page, "condition")).to_have_text(re.compile(r"^3\.8"))
    page.wait_for_timeout(500)  # the model is told five times a second
    run(page, 1)
    expect(page.locator(".jp-OutputArea-output pre")).to_have_text(["pitch in Python: 61.0\n"])
    run(page, 2)
    expect(slider(page, "pitch")).to_have_value("60")
    expect(output(page, "determinant")).to_have_text("2")
    page.close()
