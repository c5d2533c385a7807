"""The converter: its numbers are Python's, and what it writes out computes the same."""

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from traitlets import TraitError

import chr_notes
from chr_notes.demos import ConverterDemo
from chr_notes.demos.converter import CONVENTIONS, KINDS, SYSTEMS, convention
from chr_notes.sequences import SEQUENCES

from .modules import called
from .parts import Samples

Program = Callable[[str], str]
ULPS = 3e-15
NEAR = 1e-6  # radians from the lock, where angles by themselves say little
RANDOM, EXTREME = 380, 120


def states(ordinary: int, extreme: int) -> list[dict[str, Any]]:
    """Random attitudes in random conventions, and extreme ones."""
    random = np.random.default_rng(21)
    lock = [-np.pi / 2, np.pi / 2, 0.0, np.pi, np.pi / 2 - 1e-9, 1e-9, -1e-7]
    made = []
    for number in range(ordinary + extreme):
        kind = KINDS[number % 4]
        source, target = random.choice([*SYSTEMS], 2)
        one, other = random.choice(["", *SEQUENCES], 2)
        unit, another = random.choice(["", "degrees", "radians"], 2)
        own = convention(source, one, unit)
        q = random.normal(size=4)
        angles = random.uniform(-4, 4, 3)
        if number >= ordinary:
            q = random.choice([0.0, 1.0, -1.0, 1e-9, 1e-160], 4) * 10.0 ** random.integers(
                -150, 150
            )
            q = q if q.any() else np.array([0.0, 1.0, 0.0, 0.0])
            angles = random.choice(lock, 3) + random.choice([0.0, 0.0, 2e5 * np.pi])
        value = {
            "angles": np.degrees(angles) if own.degrees else angles,
            "quaternion": q,
            "axis angle": [*(q[1:] if q[1:].any() else [0, 0, 1.0]), angles[0]],
            "matrix": chr_notes.matrix_from_quaternion(q).ravel(),
        }[kind]
        made.append({
            "kind": kind, "value": [float(each) for each in value],
            "source": str(source), "source_sequence": str(one), "source_unit": str(unit),
            "target": str(target), "target_sequence": str(other), "target_unit": str(another),
        })  # fmt: skip
    return made


@pytest.fixture(scope="module")
def both(
    program: Program, samples: Samples, tmp_path_factory: pytest.TempPathFactory
) -> list[tuple[dict[str, Any], Any]]:
    """The states, and what the page's module makes of each."""
    program("node")
    given = states(samples(110, RANDOM), EXTREME)
    folder = tmp_path_factory.mktemp("node")
    made = called(folder, "converter_state.js", "computed", [[state] for state in given])
    return list(zip(given, made, strict=True))


def written(state: dict[str, Any], side: str) -> chr_notes.Convention:
    return convention(*(state[f"{side}{end}"] for end in ("", "_sequence", "_unit")))


def are_those_of_python(
    state: dict[str, Any], there: dict[str, np.ndarray], rounded: float = 0.0
) -> np.ndarray:
    """Compare numbers, rounded to so many times their size, with Python's; returns both angles."""
    own = written(state, "target")
    expected = ConverterDemo(**state).readouts()
    np.testing.assert_allclose(
        there["matrix"], expected["matrix"], rounded, ULPS, err_msg=str(state)
    )
    q, theirs = there["quaternion"], np.array(expected["quaternion"])
    half_turn = abs(q[0 if own.scalar_first else 3]) < ULPS  # either sign will do
    sign = np.sign(q @ theirs) if half_turn else 1.0
    np.testing.assert_allclose(q, sign * theirs, rounded, ULPS, err_msg=str(state))
    one, other = there["axis angle"], np.array(expected["axis angle"])
    turn = np.radians(one[3]) if own.degrees else one[3]
    sign = np.sign(one[:3] @ other[:3]) if half_turn else 1.0
    if turn > NEAR:
        np.testing.assert_allclose(one[:3], sign * other[:3], rounded, ULPS / min(1, turn))
    np.testing.assert_allclose(one[3], other[3], rounded, 2e-13 if own.degrees else ULPS)
    angles = np.array([there["angles"], expected["angles"]])
    turns = np.abs(np.radians(angles[1]) if own.degrees else angles[1]).sum()
    matrices = chr_notes.convert(angles, own, own, kind="angles", to="matrix")
    np.testing.assert_allclose(
        matrices[0], matrices[1], 0, ULPS + rounded * turns, err_msg=str(state)
    )
    return angles


def test_numbers_are_those_of_python(both: list[tuple[dict[str, Any], Any]]) -> None:
    locked = 0
    for state, made in both:
        own = written(state, "target")
        there = {kind: np.array(made["there"][kind], dtype=float) for kind in KINDS}
        angles = are_those_of_python(state, there)
        if np.radians(made["there"]["fromLock"]) > NEAR:
            apart = np.radians(angles[0] - angles[1]) if own.degrees else angles[0] - angles[1]
            assert np.abs(chr_notes.wrap_angle(apart)).max() < ULPS / np.sin(NEAR)
        locked += made["there"]["locked"]
    assert locked > 10


def test_all_triples_mean_the_same(both: list[tuple[dict[str, Any], Any]]) -> None:
    for state, made in both:
        own = written(state, "target")
        triples = made["there"]["triples"]
        assert len(triples) == (1 if made["there"]["locked"] else 2), state
        matrices = chr_notes.convert(triples, own, own, kind="angles", to="matrix")
        expected = np.reshape(made["there"]["matrix"], (3, 3))
        np.testing.assert_allclose(matrices, [expected] * len(triples), atol=1e-12)
        turns = np.radians(triples) if own.degrees else np.array(triples)
        if len(triples) == 2:
            assert np.abs(chr_notes.wrap_angle(turns[0] - turns[1])).max() > 3


def test_what_is_copied_computes_the_same(program: Program, tmp_path: Path) -> None:
    program("node")
    given = states(40, 0) + in_each_system()
    computed = called(tmp_path, "converter_state.js", "computed", [[state] for state in given])
    made = [
        [each | {"kind": state["kind"], "value": state["value"], "converted": each["there"]}]
        for state, each in zip(given, computed, strict=True)
    ]
    for language in ("Python", "SciPy", "C", "JavaScript", "LaTeX"):
        texts = called(tmp_path, "writing.js", f"LANGUAGES.{language}", made)
        for text, (each,) in zip(texts, made, strict=True):
            copied_is_right(language, text, each["there"])


def in_each_system() -> list[dict[str, Any]]:
    """One attitude given in each form and wanted by each system, in its own turns and unit."""
    given = {
        "angles": [10.0, 20.0, 30.0],
        "quaternion": [0.9, 0.1, -0.3, 0.2],
        "axis angle": [1.0, -2.0, 3.0, 50.0],
        "matrix": chr_notes.matrix_from_euler([0.4, -0.5, 2.6]).ravel().tolist(),
    }
    empty = {f"{side}{end}": "" for side in ("source", "target") for end in ("_sequence", "_unit")}
    return [
        {"kind": kind, "value": value, "source": "CHR", "target": target, **empty}
        for target in SYSTEMS
        for kind, value in given.items()
    ]


def copied_is_right(language: str, text: str, there: dict[str, list[float]]) -> None:
    names: dict[str, Any] = {}
    if language in ("Python", "SciPy"):
        exec(text, names)  # noqa: S102 (our own text)
    if language == "Python":
        for kind, value in names["converted"].items():
            assert np.ravel(value) == pytest.approx(there[kind], abs=1e-12), text
        assert set(names["converted"]) == set(KINDS)
    elif language == "SciPy":
        # The numbers of the page, in its order and with its signs.
        for kind in ("angles", "quaternion", "matrix"):
            assert np.ravel(names[kind]) == pytest.approx(there[kind], abs=1e-12), text
    elif language == "LaTeX":
        numbers = re.findall(r"-?\d[^ ]*(?: \\cdot 10\^\{-?\d+\})?", text.partition("R = ")[2])
        values = [float(re.sub(r" \\cdot 10\^\{(.*)\}", r"e\1", number)) for number in numbers]
        assert values == [*there["matrix"], *there["quaternion"]]
    else:
        for line in text.splitlines():
            value = line.partition(" = ")[2].partition(";")[0].translate(str.maketrans("{}", "[]"))
            kind = re.findall(r"angles|quaternion|axis_angle|matrix", line)[0].replace("_", " ")
            assert np.ravel(json.loads(value)).tolist() == there[kind]


def test_scipy_has_the_conjugate_where_a_system_has_it(program: Program, tmp_path: Path) -> None:
    program("node")
    q = np.array([0.5, 0.1, -0.7, 0.5])
    matrix = chr_notes.matrix_from_quaternion(q).ravel().tolist()
    for scalar_first, order in ((True, [0, 1, 2, 3]), (False, [1, 2, 3, 0])):
        target = CONVENTIONS["systems"]["ROS"] | {"conjugated": True, "scalarFirst": scalar_first}
        given = [[{"matrix": matrix, "target": target}]]
        (text,) = called(tmp_path, "writing.js", "LANGUAGES.SciPy", given)
        names: dict[str, Any] = {}
        exec(text, names)  # noqa: S102 (our own text)
        assert names["quaternion"] == pytest.approx((q * [1, -1, -1, -1])[order], abs=1e-14)


def test_no_turn_is_said_to_differ_where_it_does(program: Program, tmp_path: Path) -> None:
    program("node")
    tables = CONVENTIONS["systems"]
    pairs = [(one, other) for one in tables for other in tables]
    given = [[tables[one], tables[other]] for one, other in pairs]
    said = dict(
        zip(pairs, called(tmp_path, "converter_words.js", "noTurnWords", given), strict=True)
    )
    for (one, other), words in said.items():
        matrix = chr_notes.convert(np.eye(3), one, other, kind="matrix")
        assert (words == "") == np.allclose(matrix, np.eye(3)), (one, other)
    assert said["ROS", "Unity"].startswith("No turn faces east in ROS, north in Unity.")
    assert "choose ROS (local frame)" in said["ROS", "Unity"]
    assert "CH Robotics (UM6, UM7)" in said["CHR", "ROS"]


def test_what_is_shown_has_no_noise_and_reads_back(program: Program, tmp_path: Path) -> None:
    program("node")
    random = np.random.default_rng(5)
    given = [[[9.999999999999998, 19.999999999999996, 1.2e-17], "angles"],
             [[1e-9, 0.0, 0.0], "angles"],
             [[1.0, 0.0, 0.0, 3e-20], "axis angle"],
             [[0.1234567890123, 1.0, -2e-9], "angles", True]]  # fmt: skip
    attitudes = [chr_notes.matrix_from_quaternion(q).ravel() for q in random.normal(size=(40, 4))]
    given += [[each.tolist(), "matrix"] for each in attitudes]
    angles, small, turn, narrow, *matrices = called(tmp_path, "writing.js", "shown", given)
    assert angles == ["10", "20", "0"]
    assert small == ["1e-9", "0", "0"]
    assert turn[0] == "1"
    assert float(turn[3]) == 0
    assert narrow == ["0.12345679", "1", "-2e-9"]
    for matrix, texts in zip(attitudes, matrices, strict=True):
        np.testing.assert_allclose([*map(float, texts)], matrix, rtol=5e-15, atol=4e-16)


def test_a_state_that_is_none_is_refused() -> None:
    for wrong in (
        {"value": [1.0, 2.0]},
        {"kind": "quaternion", "value": [0.0] * 4},
        {"kind": "matrix", "value": [1.0] * 9},
        {"source": "Excel"},
        {"target_sequence": "ZZX"},
        {"kind": "euler"},
    ):
        with pytest.raises(TraitError):
            ConverterDemo(**wrong)
    demo = ConverterDemo(kind="matrix", value=np.eye(3).ravel().tolist(), source="Unity")
    assert eval(repr(demo)).state() == demo.state()  # noqa: S307 (our own text)
    assert "For ROS it is the angles 0.000, 0.000, 90.000 in degrees" in demo.fallback()
