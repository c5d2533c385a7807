"""The detective finds the convention in which numbers were printed."""

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import chr_notes
from chr_notes import Convention, Match, convert, find_conventions
from chr_notes.sequences import SEQUENCES
from chr_notes.systems.convention import DOCUMENTED, PRESETS
from chr_notes.systems.converting import from_matrix

CASES = json.loads((Path(__file__).parents[1] / "published.json").read_text(encoding="utf-8"))
WAYS = ("to body", "to navigation")
FIELDS = {
    "angles": ("sequence", "degrees"),
    "matrix": ("matrix_is_transposed",),
    "quaternion": ("scalar_first", "quaternion_is_conjugated"),
    "vectors": ("vectors",),
    "accel": ("accelerometer",),
}
Random = np.random.Generator


def drawn(random: Random) -> Convention:
    way = [WAYS[i] for i in random.integers(2, size=3)]
    return Convention(
        SEQUENCES[random.integers(24)],
        degrees=bool(random.integers(2)),
        matrix=way[0],  # type: ignore[arg-type]
        quaternion=way[1],  # type: ignore[arg-type]
        scalar_first=bool(random.integers(2)),
        vectors=way[2],  # type: ignore[arg-type]
        accelerometer=(-1, 1)[random.integers(2)],  # type: ignore[arg-type]
    )


def printed(c: Convention, random: Random) -> dict[str, Any]:
    """What two programs print of a random attitude in a convention, with 4 to 8 digits."""
    own = chr_notes.matrix_from_euler(random.uniform(-3, 3, 3) * [1, 0.5, 1])
    digits = int(random.integers(4, 9))
    before = random.normal(size=3)
    after = (own if c.vectors == "to body" else own.T) @ before
    said = {k: from_matrix(own, c, k) for k in ("angles", "matrix", "quaternion")}
    said["accel"] = 9.81 * c.accelerometer * own[:, 2]
    first = ("angles", "matrix", "quaternion")[random.integers(3)]
    second = [k for k in FIELDS if k != first][random.integers(4)]
    made = {k: v.round(digits) for k, v in said.items() if k in (first, second)}
    if second == "vectors":
        made["vectors"] = (before.round(digits), after.round(digits))
    return made


def explains(match: Match, c: Convention, kinds: Any) -> bool:  # noqa: ANN401
    return any(
        all(getattr(each, f) == getattr(c, f) for kind in kinds for f in FIELDS[kind])
        for each in (match.convention, *match.others)
    )


def test_random_pairs(samples: Callable[[int, int], int]) -> None:
    random = np.random.default_rng(16)
    count, first = samples(40, 200), 0
    for _ in range(count):
        convention = drawn(random)
        given = printed(convention, random)
        matches = find_conventions(**given)
        found = [explains(match, convention, given) for match in matches]
        assert any(found), (convention, given)
        first += found[0]
        assert len(matches) == 1 or all(match.example for match in matches)
    assert first >= 0.95 * count


def test_wrong_pairs_are_told(samples: Callable[[int, int], int]) -> None:
    random = np.random.default_rng(17)
    for _ in range(samples(8, 40)):
        given = printed(drawn(random), random)
        if "matrix" not in given or {*given} & {"accel", "vectors"}:
            continue
        # Turned by 3° more.
        given["matrix"] = given["matrix"] @ chr_notes.matrix_from_euler([0.03, -0.03, 0.03])
        one, other = given
        with pytest.raises(ValueError, match=rf"expected {one} and {other} .* at least .*° apart"):
            find_conventions(**given)


def test_a_tie_is_broken_by_an_example() -> None:
    # A turn about z alone says nothing of the other axes.
    given = [[0.866, 0.5, 0.0], [-0.5, 0.866, 0.0], [0.0, 0.0, 1.0]]
    matches = find_conventions(angles=[30.0, 0.0, 0.0], matrix=given)
    assert len(matches) > 2
    assert matches[0].convention.sequence == "ZYX"
    said = []
    for match in matches:
        assert match.example is not None
        said.append(match.example["matrix"])
        # Asked for the example, a program of that convention would be told from all others.
        again = find_conventions(
            angles=[[30.0, 0.0, 0.0], match.example["angles"]],
            matrix=[
                [[0.866, 0.5, 0], [-0.5, 0.866, 0], [0, 0, 1]],
                match.example["matrix"].round(4),
            ],
        )
        assert [other.convention for other in again] == [match.convention]
    for place, one in enumerate(said):
        assert all(np.abs(one - other).max() > 1e-2 for other in said[:place])


def two_ways(case: dict[str, Any]) -> dict[str, Any]:
    """What a published case says of one rotation, as two programs would."""
    given, said, kind = case["inputs"], case["expected"], case["kind"]

    def angles(values: dict[str, float]) -> list[float]:
        return [values[name] for name in ("yaw", "pitch", "roll")]

    made: dict[str, Callable[[], dict[str, Any]]] = {
        "euler_to_R_nav_to_body": lambda: {"angles": angles(given), "matrix": said},
        "euler_to_quat": lambda: {"angles": angles(given), "quaternion": said},
        "quat_to_euler": lambda: {"quaternion": given["q"], "angles": angles(said)},
        "quat_to_R_nav_to_body": lambda: {"quaternion": given["q"], "matrix": said},
        "R_nav_to_body_to_quat": lambda: {"matrix": given["R"], "quaternion": said},
        "R_nav_to_body_to_euler": lambda: {"matrix": given["R"], "angles": angles(said)},
        "rotate_nav_vector_into_body": lambda: {
            "quaternion": given["q"], "vectors": (given["v_nav"], said)
        },
    }  # fmt: skip
    return made[kind]() if kind in made else {}


TWO_WAYS = {case["id"]: two for case in CASES if (two := two_ways(case))}


@pytest.mark.parametrize("name", TWO_WAYS)
def test_published_cases(name: str) -> None:
    """Numbers of MATLAB, PX4 and others, brought to this book's matrix and quaternion."""
    right, given = Convention("ZYX"), TWO_WAYS[name]
    matches = find_conventions(**given)
    found = [explains(match, right, given) for match in matches]
    assert any(found)
    # Where nothing is left open it is the only one.
    if name in ("ml_angle2dcm", "ml_angle2quat", "px4_euler_quat", "px4_euler_dcm"):
        assert found[0]
    assert len(matches) == 1 or all(match.example for match in matches)


def test_there_are_published_cases_enough() -> None:
    assert len(TWO_WAYS) >= 15


def test_the_quaternion_chapters_contradiction() -> None:
    """Its matrix is to the body; its sentence has the quaternion lead there too."""
    q = np.array([0.8, 0.3, -0.4, 0.2])
    a, b, c, d = q / np.linalg.norm(q)
    row = [a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)]
    matrix = chr_notes.matrix_from_quaternion(q).T
    assert np.allclose(matrix[0], row)
    (match,) = find_conventions(quaternion=q, matrix=matrix)
    ways = {(c.matrix, c.quaternion) for c in (match.convention, *match.others)}
    assert ("to navigation", "to navigation") in ways
    assert ("to body", "to body") in ways


def test_several_examples_scale_and_units() -> None:
    euler = np.array([[0.1, 0.2, 0.3], [1.0, -0.4, 2.0]])
    q = 3 * chr_notes.quaternion_from_euler(euler)
    (match,) = find_conventions(angles=np.degrees(euler), quaternion=q)
    assert match.convention == Convention(degrees=True)
    with pytest.raises(ValueError, match="no convention explains the second example"):
        find_conventions(angles=[euler[0], euler[1] + 0.2], quaternion=q)
    with pytest.raises(ValueError, match="at least"):
        find_conventions(angles=np.degrees(euler[0]), quaternion=q[0], degrees=False)


@pytest.mark.parametrize("second", ["quaternion", "matrix"])
def test_programs_in_different_axes(second: str, samples: Callable[[int, int], int]) -> None:
    """What is found of one attitude holds of others."""
    random, systems = np.random.default_rng(18), PRESETS | DOCUMENTED
    for _ in range(samples(6, 60)):
        one, other = (systems[random.choice([*systems])] for _ in range(2))
        q = random.normal(size=(2, 4))
        angles, said = (
            convert(q, "this book", system, kind="quaternion", to=kind).round(5)  # type: ignore[arg-type]
            for system, kind in ((one, "angles"), (other, second))
        )
        match = find_conventions(**{"angles": angles[0], second: said[0]})[0]
        axes = match.axes or dict.fromkeys(("angles", second), ("ned", "frd"))
        read, written = (
            replace(match.convention, navigation=axes[kind][0], body=axes[kind][1])
            for kind in ("angles", second)
        )
        again = convert(angles[1], read, written, kind="angles", to=second)  # type: ignore[arg-type]
        sign = np.sign(again @ said[1]) if second == "quaternion" else 1
        np.testing.assert_allclose(sign * again, said[1], atol=2e-4)


def test_angles_that_are_written_in_another_order() -> None:
    """Yaw shows as roll: the three stand in another order than a program thinks."""
    q = chr_notes.quaternion_from_euler(np.radians([10.0, 20.0, 30.0]))
    (match,) = find_conventions(angles=[20.0, 30.0, 10.0], quaternion=q.round(5))
    assert (match.convention.sequence, match.convention.written) == ("ZYX", "yzx")
    assert match.axes is None


def test_wrong_input_is_refused() -> None:
    for given, said in (
        ({"angles": [0, 0, 0]}, "two or more"),
        ({"accel": [0, 0, 1], "vectors": ([1, 0, 0], [1, 0, 0])}, "one of them an attitude"),
        ({"angles": [0, 0], "accel": [0, 0, 1]}, "angles: expected shape"),
        ({"angles": [[0, 0, 0]] * 2, "accel": [0, 0, 1]}, "as many examples"),
        ({"angles": [0, 0, np.nan], "accel": [0, 0, 1]}, "angles: expected numbers"),
        ({"angles": [0, 0, 0], "quaternion": [0, 0, 0, 0]}, "quaternion: expected no row of zeros"),
        ({"angles": [0, 0, 0], "matrix": np.diag([1, 1, -1])}, "reflection in the first example"),
    ):
        with pytest.raises(ValueError, match=said):
            find_conventions(**given)  # type: ignore[arg-type]
