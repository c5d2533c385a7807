"""Keep of runs of the benchmarks what the book tells: `python tests/benchmarks/store.py run.json`.

Written to `book/speed.json`: what they ran on, without the name of the machine, and the shortest
time of each case in all of them, which other work on the machine disturbs least.
"""

import importlib.metadata
import json
import sys
from pathlib import Path
from typing import Any

STORED = Path(__file__).resolve().parents[2] / "book" / "speed.json"
LIBRARIES = (
    "numpy",
    "scipy",
    "ahrs",
    "numpy-quaternion",
    "pytransform3d",
    "transforms3d",
    "symforce",
    "vqf",
)


def stored(runs: list[dict[str, Any]]) -> dict[str, Any]:
    """Take from runs of pytest-benchmark, with the same cases, what is kept."""
    machine = runs[0]["machine_info"]
    cpu = machine["cpu"]
    return {
        "cpu": cpu["brand_raw"],
        "threads": 1,
        "vector_instructions": "AVX-512" if "avx512f" in cpu["flags"] else "none beyond AVX2",
        "system": machine["system"],
        "python": machine["python_version"],
        "libraries": {name: importlib.metadata.version(name) for name in LIBRARIES},
        "rounds": min(
            sum(case["stats"]["rounds"] for case in cases)
            for cases in zip(*(run["benchmarks"] for run in runs), strict=True)
        ),
        "rows": [
            {
                **case["extra_info"],
                "nanoseconds": float(
                    f"{shortest([case, *others]) / case['extra_info']['size'] * 1e9:.3g}"
                ),
            }
            for case, *others in zip(*(run["benchmarks"] for run in runs), strict=True)
        ],
    }


def shortest(cases: list[dict[str, Any]]) -> float:
    """Give the shortest time of one case, in seconds; refuse cases that are not the same."""
    (_,) = {case["fullname"] for case in cases}
    return min(float(case["stats"]["min"]) for case in cases)


def main(*paths: str) -> None:
    """Read runs and write what is kept of them."""
    if not paths:
        sys.exit("expected the file of a run or more, as --benchmark-json writes them")
    runs = [json.loads(Path(path).read_text(encoding="utf-8")) for path in paths]
    STORED.write_text(json.dumps(stored(runs), indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
