"""What pyproject.toml cannot say: kernels for arrays, and what a wheel has and has not.

The kernels are left out, without an error, where there is no compiler.
"""

import bz2
import html
import json
import lzma
import re
import shutil
from collections.abc import Sequence
from pathlib import Path
from zipfile import ZIP_DEFLATED, ZIP_STORED, ZipFile

import numpy as np
from setuptools import Extension, setup
from setuptools.command.bdist_wheel import bdist_wheel
from setuptools.command.build_ext import build_ext
from setuptools.command.build_py import build_py

HERE = Path(__file__).resolve().parent
# Whoever installs the package has what is made by these, and can change nothing of it.
MAKERS = (
    "codegen",
    "demos/build.py",
    "derivations/computation.py",
    "derivations/further.py",
    "derivations/forms",
    "generated/c/kernels.c",
    "generated/c/stamp.h",
)
# What no Python imports is read from archives (chr_notes/_texts.py): prose and tables from one, in
# which they take less, code and pictures from the other, in the orders that pack best.
IMPORTED = {".py", ".pyd", ".so", ".typed"}
PROSE = (".md", ".bib", ".json", ".yml", ".ipynb")
CODE = (".css", ".js", ".h", ".mts", ".mjs", ".c", ".svg")
COMMENT = {
    ".css": re.compile(rb"/\*.*?\*/\s*", re.DOTALL),  # no string of a style sheet has one
    ".js": re.compile(rb"^ */\*.*?\*/\s*", re.DOTALL | re.MULTILINE),
    ".yml": re.compile(rb" +# .*"),
}
DRAWN = re.compile(r'data-drawn=\\"([^"\\]*)\\"')


class WithBook(build_py):
    """Build the package with the sources of the book, and notebooks without their outputs."""

    def run(self) -> None:
        """Build it."""
        super().run()
        if self.editable_mode:
            return
        package = Path(self.build_lib) / "chr_notes"
        for name in (*MAKERS, "prose.bz2", "code.xz"):  # the archives of a build before
            remove(package / name)
        texts = sources_of_the_book()
        for path in [*package.rglob("*.*")]:
            if path.is_file() and path.suffix not in IMPORTED:
                texts[path.relative_to(package).as_posix()] = path.read_bytes()
                path.unlink()
        for name in texts:
            if name.endswith((".ipynb", ".json")):
                content = json.loads(texts[name])
                texts[name] = json.dumps(
                    content, ensure_ascii=False, separators=(",", ":")
                ).encode()
            elif (kind := Path(name).suffix) in COMMENT:
                texts[name] = COMMENT[kind].sub(b"", texts[name])
        (package / "prose.bz2").write_bytes(bz2.compress(archive(texts, PROSE)))
        strongest = {"id": lzma.FILTER_LZMA2, "preset": 9 | lzma.PRESET_EXTREME, "pb": 0, "lc": 2}
        packed = lzma.compress(archive(texts, CODE), filters=[strongest])
        (package / "code.xz").write_bytes(packed)
        if texts:
            msg = f"in setup.py neither prose nor code: {', '.join(sorted(texts))}"
            raise RuntimeError(msg)


class CompiledAnew(build_ext):
    """Compile the kernels anew, or have none: those of a build before may be of other sources."""

    def run(self) -> None:
        """Compile them."""
        folders = (self.build_lib, HERE) if self.inplace else (self.build_lib,)
        for folder in folders:
            for each in self.extensions:
                remove(Path(folder) / self.get_ext_filename(each.name))
        super().run()


class DeflatedFurther(bdist_wheel):
    """Deflate the wheel as far as it goes, a thousand bytes further than setuptools does."""

    def run(self) -> None:
        """Write it, and once more."""
        super().run()
        path = self.distribution.dist_files[-1][2]
        with ZipFile(path) as wheel:
            parts = [(part, wheel.read(part)) for part in wheel.infolist()]
        with ZipFile(path, "w") as wheel:
            for part, content in parts:
                kind = ZIP_STORED if part.filename.endswith((".bz2", ".xz")) else ZIP_DEFLATED
                wheel.writestr(part, content, kind, compresslevel=9)


def remove(path: Path) -> None:
    """Remove a file or a folder, where it is there."""
    if path.is_dir():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)


def archive(texts: dict[str, bytes], kinds: Sequence[str]) -> bytes:
    """Take texts of these kinds, in this order, for an archive as chr_notes/_texts.py reads it."""
    names = [name for name in texts if Path(name).suffix in kinds]
    names.sort(key=lambda name: (kinds.index(Path(name).suffix), name))
    return b"\0".join(part for name in names for part in (name.encode(), texts.pop(name)))


def sources_of_the_book() -> dict[str, bytes]:
    """Read what a book is built of, by the place in the archive."""
    left_out = {"_build", "_generated", "images"}
    texts = {
        f"packed/{path.relative_to(HERE).as_posix()}": path.read_bytes()
        for path in (HERE / "book").rglob("*")
        if path.is_file() and not left_out & {*path.relative_to(HERE).parts}
    }
    for path in (HERE / "notebooks").glob("*.ipynb"):
        notebook = json.loads(path.read_text(encoding="utf-8"))
        for cell in notebook["cells"]:
            del cell["id"]  # copies number their cells
            if cell["cell_type"] == "code":
                # Which pictures an exercise shows: copies without solutions cannot compute it.
                if drawn := DRAWN.search(json.dumps(cell["outputs"])):
                    cell["metadata"]["drawn"] = html.unescape(drawn[1])
                cell.update(outputs=[], execution_count=None)
        texts[f"packed/notebooks/{path.name}"] = json.dumps(notebook).encode()
    return texts


setup(
    cmdclass={
        "build_py": WithBook,
        "build_ext": CompiledAnew,
        "bdist_wheel": DeflatedFurther,
    },
    ext_modules=[
        Extension(
            "chr_notes._compiled",
            sources=["chr_notes/native/module.c"],
            include_dirs=[np.get_include()],
            # Products and sums are rounded one by one, so that every instruction set gives the
            # same bits.
            extra_compile_args=[
                "-std=c99",
                "-O3",
                "-g0",
                "-fvect-cost-model=dynamic",
                "-ffp-contract=off",
                "-fno-math-errno",
                "-fno-trapping-math",
            ],
            optional=True,
            py_limited_api=True,
        )
    ],
)
