"""What pyproject.toml cannot say: kernels for arrays, and the sources of the book in the package.

The kernels are left out, without an error, where there is no compiler.
"""

import json
import shutil
from pathlib import Path

import numpy as np
from setuptools import Extension, setup
from setuptools.command.build_py import build_py

HERE = Path(__file__).resolve().parent


class WithBook(build_py):
    """Build the package with the sources of the book, and notebooks without their outputs."""

    def run(self) -> None:
        """Build it."""
        super().run()
        if self.editable_mode:
            return
        packed = Path(self.build_lib) / "chr_notes" / "book" / "packed"
        shutil.rmtree(packed, ignore_errors=True)
        left_out = shutil.ignore_patterns("_build", "_generated", "images")
        shutil.copytree(HERE / "book", packed / "book", ignore=left_out)
        (packed / "notebooks").mkdir()
        for path in sorted((HERE / "notebooks").glob("*.ipynb")):
            notebook = json.loads(path.read_text(encoding="utf-8"))
            for cell in notebook["cells"]:
                if cell["cell_type"] == "code":
                    cell.update(outputs=[], execution_count=None)
            text = json.dumps(notebook, indent=1, ensure_ascii=False) + "\n"
            (packed / "notebooks" / path.name).write_text(text, encoding="utf-8")


setup(
    cmdclass={"build_py": WithBook},
    ext_modules=[
        Extension(
            "chr_notes._compiled",
            sources=["chr_notes/native/module.c"],
            depends=[
                "chr_notes/native/columns.h",
                "chr_notes/native/decimals.h",
                "chr_notes/native/elementary.h",
                "chr_notes/generated/c/kernels.c",
                "chr_notes/generated/c/stamp.h",
            ],
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
