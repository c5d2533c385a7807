"""Times of the functions of arrays without kernels, beside the same by hand in plain NumPy.

`python tests/benchmarks/without_kernels.py` prints, for each function and number of rows, the
shortest time of a call of both in microseconds, and those that are slower by more than half and by
more than 5 µs; no file of the default run.
"""

import os

os.environ["CHR_NOTES_KERNELS"] = "off"  # before the import

import sys
from collections.abc import Callable, Iterator
from time import perf_counter
from typing import Any

import by_hand
import numpy as np
from numpy.typing import NDArray

import chr_notes

Floats = NDArray[np.float64]
SIZES = (1, 10, 100, 1_000, 10_000, 100_000, 1_000_000)
ROUNDS, LEAST = 7, 0.01  # of each of the two in turn, and seconds that one takes at least
FACTOR, MORE = 1.5, 5e-6


def cases(rows: int) -> Iterator[tuple[str, Callable[[], Any], Callable[[], Any]]]:
    """Give each function, ours and by hand, with the same random arguments."""
    rng = np.random.default_rng(4)
    p, q = (each / np.linalg.norm(each, axis=1)[:, None] for each in rng.normal(size=(2, rows, 4)))
    euler = rng.uniform([-np.pi, -1.5, -np.pi], [np.pi, 1.5, np.pi], (rows, 3))
    vectors = rng.normal(size=(rows, 3))
    given: dict[str, tuple[Floats, ...]] = {
        "matrix_from_euler": (euler,),
        "euler_from_matrix": (chr_notes.matrix_from_euler(euler),),
        "euler_rates_from_body_rates": (euler, vectors),
        "matrix_from_quaternion": (q,),
        "quaternion_from_matrix": (chr_notes.matrix_from_quaternion(q),),
        "quaternion_from_euler": (euler,),
        "euler_from_quaternion": (q,),
        "quaternion_multiply": (p, q),
        "rotate_to_inertial": (q, vectors),
        "wrap_angle": (3 * euler[:, 0],),
        "tilt_from_accelerometer": (vectors,),
        "heading_from_magnetometer": (vectors, euler[:, :2].copy()),
        "accelerometer_at_rest": (euler,),
    }
    for name, arrays in given.items():
        ours, plain = getattr(chr_notes, name), getattr(by_hand, name)
        yield name, lambda: ours(*arrays), lambda: plain(*arrays)  # noqa: B023 (called at once)
    # By hand with the duties that ours have, beyond a line that is right where nothing is odd.
    matrix, tilt = given["euler_from_matrix"][0], euler[:, :2].copy()
    angles, heading = chr_notes.euler_from_matrix, chr_notes.heading_from_magnetometer
    north = np.cos(by_hand.DECLINATION), np.sin(by_hand.DECLINATION)
    yield "rotations, refused or not", lambda: angles(matrix), lambda: by_hand.checked_euler(matrix)
    yield (
        "heading from true north",
        lambda: heading(vectors, tilt, north),
        lambda: by_hand.true_heading(vectors, tilt),
    )
    calibration = by_hand.CALIBRATION
    yield "measure", lambda: calibration.measure(vectors), lambda: by_hand.measured(vectors)
    yield "correct", lambda: calibration.correct(vectors), lambda: by_hand.corrected(vectors)


def shortest(*functions: Callable[[], Any]) -> list[float]:
    """Take the shortest time of a call of each, in seconds, turn by turn."""
    calls = []
    for function in functions:
        start = perf_counter()
        function()
        calls.append(max(1, int(LEAST / (perf_counter() - start))))
    times = [np.inf] * len(functions)
    for _ in range(ROUNDS):
        for place, (function, count) in enumerate(zip(functions, calls, strict=True)):
            start = perf_counter()
            for _ in range(count):
                function()
            times[place] = min(times[place], (perf_counter() - start) / count)
    return times


def main() -> None:
    """Print the times."""
    assert not chr_notes.kernels_in_use()
    say = sys.stdout.write
    say("µs a call without kernels / by hand in NumPy, for so many rows; * more than allowed\n")
    say(f"{'':28}" + "".join(f"{size:>20,}" for size in SIZES) + "\n")
    told: dict[str, str] = {}
    for size in SIZES:
        for name, ours, plain in cases(size):
            np.testing.assert_allclose(np.abs(ours()), np.abs(plain()), atol=1e-9)
            one, other = shortest(ours, plain)
            slow = "*" if one > max(FACTOR * other, other + MORE) else " "
            both = f"{one * 1e6:11.1f} /{other * 1e6:6.1f}{slow}"
            told[name] = told.get(name, f"{name:28}") + both
    say("\n".join(told.values()) + "\n")


if __name__ == "__main__":
    main()
