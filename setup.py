"""Kernels for arrays: left out, without an error, where there is no compiler."""

import numpy as np
from setuptools import Extension, setup

setup(
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
    ]
)
