"""The checks by name: `nox -l` lists them, `nox -s quick` runs one, `nox -s quick -- -x` passes on.

The README's two commands need none of this. An environment is made once for each name and kept;
`--no-venv --no-install` uses the one that is active.
"""

from pathlib import Path

import nox

nox.options.default_venv_backend = "uv|virtualenv"
nox.options.reuse_existing_virtualenvs = True
nox.options.sessions = ["lint", "quick"]


def pytest(session: nox.Session, *given: str) -> None:
    """Run tests in an environment that has what they need."""
    session.install("-e", ".[test]")
    session.run("python", "-m", "pytest", *given, *session.posargs)


@nox.session
def lint(session: nox.Session) -> None:
    """Check style, layers, generated files, types and all verdicts, the cheapest first."""
    session.install("-e", ".[dev]")
    session.run("ruff", "check", ".")
    session.run("ruff", "format", "--check", ".")
    session.run("python", "-m", "pytest", "-q", "-n0", "tests/test_layers.py")
    session.run("python", "-m", "chr_notes.demos.build", "--check")
    session.run("python", "-m", "chr_notes.codegen", "--check")
    session.run("mypy")
    session.run("python", "-m", "chr_notes", "ledger", "--check")


@nox.session
def quick(session: nox.Session) -> None:
    """Run what needs neither browser, book, notebooks nor the verdicts of the whole ledger."""
    aside = ("--ignore=tests/book", "--ignore=tests/ledger")
    pytest(session, "tests", "-m", "not browser and not slow", *aside)


@nox.session
def notebooks(session: nox.Session) -> None:
    """Check every notebook as it is stored, and run it again."""
    pytest(session, "--nbval", "notebooks", "tests/notebooks")


@nox.session
def browser(session: nox.Session) -> None:
    """Try the demos in Chromium."""
    pytest(session, "tests", "-m", "browser and not book")


@nox.session
def book(session: nox.Session) -> None:
    """Build the book and try its pages in Chromium."""
    pytest(session, "tests/book")


@nox.session
def full(session: nox.Session) -> None:
    """Run all of it with the large samples, which takes its time."""
    pytest(session, "--full")


@nox.session
def compilers(session: nox.Session) -> None:
    """Compile the exported C by the line of its README, with clang, as C++, and for a Cortex-M4."""
    session.install("-e", ".")
    folder = Path(session.create_tmp()) / "c"
    session.run("chr-notes", "export", "c", str(folder))
    readme = (folder / "README.md").read_text(encoding="utf-8")
    line = next(line for line in readme.splitlines() if line.endswith("-c attitude.c"))
    options = line.split()[1:]
    as_cpp = ["-x", "c++", *(option for option in options if not option.startswith("-std"))]
    m4 = ["-mcpu=cortex-m4", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"]
    with session.chdir(folder):
        session.run("clang", *options, external=True)
        session.run("g++", *as_cpp, external=True)
        session.run("clang++", *as_cpp, external=True)
        session.run("arm-none-eabi-gcc", *m4, *options, external=True)


@nox.session
def newest(session: nox.Session) -> None:
    """Build the book by Sphinx, and run tests and notebooks, with the newest of all."""
    drawn = ("anywidget", "fonttools[woff]", "jupyterlab", "math-core", "matplotlib", "ziamath")
    extensions = ("book-theme", "comments", "copybutton", "design", "external-toc", "togglebutton")
    names = ("sphinx", "myst-nb", "sphinxcontrib-bibtex", *(f"sphinx-{e}" for e in extensions))
    tests = ("hypothesis", "jsonschema", "mpmath", "nbval", "playwright", "scipy")
    tests += ("pytest", "pytest-benchmark", "pytest-xdist")
    session.install("--upgrade", "-e", ".", *drawn, *names, *tests)
    pages = "from chr_notes import book; book.write_generated(book.SOURCES, 'sphinx-build')"
    session.run("python", "-c", pages)
    out = str(Path(session.create_tmp()) / "html")
    options = ("-W", "-n", "--keep-going", "-q", "-c", "tools/plain_sphinx")
    session.run("python", "-m", "sphinx", *options, "-b", "html", ".", out)
    aside = [f"--ignore=tests/{name}" for name in ("book", "demos")]
    session.run("python", "-m", "pytest", "-m", "not slow", *aside, *session.posargs)


@nox.session
def generate(session: nox.Session) -> None:
    """Write the generated code and the demos' bundles."""
    session.install("-e", ".[book]")
    session.run("python", "-m", "chr_notes.codegen")
    session.run("python", "-m", "chr_notes.demos.build")


@nox.session(python="3.11", venv_backend="uv")
def oldest(session: nox.Session) -> None:
    """Try the core and the ledger with the lowest versions that pyproject.toml permits."""
    session.install("--resolution", "lowest-direct", "-e", ".[test]")
    aside = [f"--ignore=tests/{name}" for name in ("book", "demos", "notebooks", "plots")]
    session.run("python", "-m", "pytest", "tests", "-m", "not slow", *aside, *session.posargs)
