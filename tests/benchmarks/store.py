"""Keep of a run of the benchmarks what the book tells: `python tests/benchmarks/store.py run.json`.

Written to `book/speed.json`: what it ran on, without the name of the machine, and the shortest
time of each case, which other work on the machine disturbs least.
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


def stored(run: dict[str, Any]) -> dict[str, Any]:
    """Take from a run of pytest-benchmark what is kept."""
    machine = run["machine_info"]
    cpu = machine["cpu"]
    return {
        "cpu": cpu["brand_raw"],
        "threads": 1,
        "vector_instructions": "AVX-512" if "avx512f" in cpu["flags"] else "none beyond AVX2",
        "system": machine["system"],
        "python": machine["python_version"],
        "libraries": {name: importlib.metadata.version(name) for name in LIBRARIES},
        "rows": [
            {
                **case["extra_info"],
                "nanoseconds": float(
                    f"{case['stats']['min'] / case['extra_info']['size'] * 1e9:.3g}"
                ),
            }
            for case in run["benchmarks"]
        ],
    }


def main(path: str) -> None:
    """Read a run and write what is kept of it."""
    run = json.loads(Path(path).read_text(encoding="utf-8"))
    STORED.write_text(json.dumps(stored(run), indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1])
