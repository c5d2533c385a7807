"""The converter: its numbers are Python's, whatever is typed, pasted or copied."""

import json
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from playwright.sync_api import Page, expect
from traitlets import TraitError

import chr_notes
from chr_notes import Convention
from chr_notes.demos import ConverterDemo
from chr_notes.demos.converter import KINDS, SYSTEMS, convention
from chr_notes.sequences import SEQUENCES

from .modules import called
from .parts import PageOf, Visit, output

Program = Callable[[str], str]
ULPS = 3e-15
NEAR = 1e-6  # radians from the lock, where angles by themselves say little
RANDOM, EXTREME = 380, 120


def states() -> list[dict[str, Any]]:
    """Random attitudes in random conventions, and extreme ones."""
    random = np.random.default_rng(21)
    lock = [-np.pi / 2, np.pi / 2, 0.0, np.pi, np.pi / 2 - 1e-9, 1e-9, -1e-7]
    made = []
    for number in range(RANDOM + EXTREME):
        kind = KINDS[number % 4]
        source, target = random.choice([*SYSTEMS], 2)
        one, other = random.choice(["", *SEQUENCES], 2)
        unit, another = random.choice(["", "degrees", "radians"], 2)
        own = convention(source, one, unit)
        q = random.normal(size=4)
        angles = random.uniform(-4, 4, 3)
        if number >= RANDOM:
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
    program: Program, tmp_path_factory: pytest.TempPathFactory
) -> list[tuple[dict[str, Any], Any]]:
    """The states, and what the page's module makes of each."""
    program("node")
    given = states()
    folder = tmp_path_factory.mktemp("node")
    made = called(folder, "converter_state.js", "computed", [[state] for state in given])
    return list(zip(given, made, strict=True))


def written(state: dict[str, Any], side: str) -> chr_notes.Convention:
    return convention(*(state[f"{side}{end}"] for end in ("", "_sequence", "_unit")))


def test_numbers_are_those_of_python(both: list[tuple[dict[str, Any], Any]]) -> None:
    assert len(both) == RANDOM + EXTREME
    locked = 0
    for state, made in both:
        own = written(state, "target")
        expected = ConverterDemo(**state).readouts()
        there = {kind: np.array(made["there"][kind], dtype=float) for kind in KINDS}
        np.testing.assert_allclose(there["matrix"], expected["matrix"], atol=ULPS, err_msg=state)
        q, theirs = there["quaternion"], np.array(expected["quaternion"])
        half_turn = abs(q[0 if own.scalar_first else 3]) < ULPS  # either sign will do
        sign = np.sign(q @ theirs) if half_turn else 1.0
        np.testing.assert_allclose(q, sign * theirs, atol=ULPS, err_msg=state)
        one, other = there["axis angle"], np.array(expected["axis angle"])
        turn = np.radians(one[3]) if own.degrees else one[3]
        sign = np.sign(one[:3] @ other[:3]) if half_turn else 1.0
        if turn > NEAR:
            np.testing.assert_allclose(one[:3], sign * other[:3], atol=ULPS / min(1, turn))
        assert one[3] == pytest.approx(other[3], abs=2e-13 if own.degrees else ULPS)
        angles = np.array([there["angles"], expected["angles"]])
        matrices = chr_notes.convert(angles, own, own, kind="angles", to="matrix")
        np.testing.assert_allclose(matrices[0], matrices[1], atol=ULPS, err_msg=state)
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


ROTATION = np.round(chr_notes.matrix_from_euler([0.1, 0.2, 0.3]), 6).tolist()
TEXTS = {
    "brackets": ("matrix", str(ROTATION)),
    "numpy": ("matrix", repr(np.array(ROTATION))),
    "matlab": ("matrix", "; ".join(" ".join(map(str, row)) for row in ROTATION)),
    "lines": ("matrix", "\n".join("\t".join(map(str, row)) for row in ROTATION)),
    "latex": ("matrix", r" \\ ".join(" & ".join(map(str, row)) for row in ROTATION)),
    "unicode minus": ("matrix", str(ROTATION).replace("-", "−")),
    "C": ("matrix", "const float R[3][3] = {{"
          + "}, {".join(", ".join(f"{v}f" for v in row) for row in ROTATION) + "}};"),
    "Fortran": ("matrix", "\n".join(f"{v:.8E}".replace("E", "D") for r in ROTATION for v in r)),
    "4 by 4": ("matrix", str([[*row, 7.5] for row in ROTATION] + [[0, 0, 0, 1]])),
    "decimal commas": (
        "matrix",
        "\n".join(" ".join(map(str, row)) for row in ROTATION).replace(".", ","),
    ),
}  # fmt: skip


def test_a_matrix_in_any_notation(program: Program, tmp_path: Path) -> None:
    program("node")
    own = {"scalarFirst": True}
    given = [[text, kind, own] for kind, text in TEXTS.values()]
    # In the field of another kind it is a matrix all the same.
    given += [[text, "quaternion", own] for _, text in TEXTS.values()]
    made = called(tmp_path, "converter_state.js", "understood", given)
    for name, found in zip([*TEXTS, *TEXTS], made, strict=True):
        assert found.get("kind") == "matrix", (name, found)
        np.testing.assert_allclose(found["value"], np.ravel(ROTATION), atol=1e-15, err_msg=name)


TABLE = {  # text: (kind, scalar first, values)
    "0.5 -0.5 0.5 -0.5": ("quaternion", True, [0.5, -0.5, 0.5, -0.5]),
    "Quaternion(w=0.5, x=-0.1, y=.2, z=3.)": ("quaternion", True, [0.5, -0.1, 0.2, 3]),
    "x: -0.1\ny: 0.2\nz: 3.0\nw: 0.5": ("quaternion", True, [0.5, -0.1, 0.2, 3]),
    '{"w": 0.5, "x": -0.1, "y": 0.2, "z": 3}': ("quaternion", False, [-0.1, 0.2, 3, 0.5]),
    "0.98 - 0.1i + 2e-1j - .3k": ("quaternion", False, [-0.1, 0.2, -0.3, 0.98]),
    "0.98-0.1i+0.2j-0.3k": ("quaternion", True, [0.98, -0.1, 0.2, -0.3]),
    "√2/2, 0, 1/sqrt(2), -√3/2": ("quaternion", True, [0.5**0.5, 0, 0.5**0.5, -(0.75**0.5)]),
    "pi/2, -π/4, 2pi": ("angles", True, [np.pi / 2, -np.pi / 4, 2 * np.pi]),
    "yaw = 30°, pitch = 20°, roll = 10°": ("angles", True, [10, 20, 30]),
    "1.5D+01; -2.0d0; 3": ("angles", True, [15, -2, 3]),
    "- 0.1\n- 0.2\n- -0.3": ("angles", True, [0.1, 0.2, -0.3]),
    "1,2,3": ("angles", True, [1, 2, 3]),
    "0,5 1,5 -2,5": ("angles", True, [0.5, 1.5, -2.5]),
    "0, -1, 0,\n1, 0, 0,\n0, 0, 1": ("matrix", True, [0, -1, 0, 1, 0, 0, 0, 0, 1]),
    "0,-1,0\n1,0,0\n0,0,1": ("matrix", True, [0, -1, 0, 1, 0, 0, 0, 0, 1]),
    "std::array<float64, 3>": None,
    "1 2": None,
    "1.0e-03 *\n1 2 3": ("quaternion", True, [0.001, 1, 2, 3]),
    "0 0 0 0": None,
    "1e999 0 0": None,
    "1 0 0 0 1 0 0 0 -1": None,
    "0.9 0 0 0 1 0 0 0 1": None,
    "nan 1 2": None,
    "": None,
}


def test_texts_are_read(program: Program, tmp_path: Path) -> None:
    program("node")
    names = {"along": ["forward", "right", "down"], "sequence": "xyz", "order": [0, 1, 2]}
    given = [
        [text, "angles" if e is None else e[0], {"scalarFirst": e is None or e[1], **names}]
        for text, e in TABLE.items()
    ]
    made = called(tmp_path, "converter_state.js", "understood", given)
    for (text, expected), found in zip(TABLE.items(), made, strict=True):
        if expected is None:
            assert found["fault"]["words"], text
        else:
            assert found.get("kind") == expected[0], (text, found)
            np.testing.assert_allclose(found["value"], expected[2], rtol=1e-15, err_msg=text)


def test_what_is_no_rotation_is_told_by_how_much(program: Program, tmp_path: Path) -> None:
    program("node")
    rough = np.round(ROTATION, 2)
    texts = [[str(rough.tolist()), "matrix", {}], [str(np.diag([1, 1, -1]).tolist()), "matrix", {}]]
    off, reflected = called(tmp_path, "converter_state.js", "understood", texts)
    defect = np.sqrt(((rough @ rough.T - np.eye(3)) ** 2).mean())
    assert f"off the unit matrix by {float(f'{defect:.3g}')}" in off["fault"]["words"]
    assert "reflection" in reflected["fault"]["words"]
    random = np.random.default_rng(3)
    matrices = random.normal(size=(40, 3, 3))
    nearest = called(
        tmp_path, "nearest.js", "nearestRotation", [[m.ravel().tolist()] for m in matrices]
    )
    for matrix, found in zip([*matrices], nearest, strict=True):
        left, _, right = np.linalg.svd(matrix)
        if np.linalg.det(matrix) < 0:
            assert found is None
        else:
            np.testing.assert_allclose(found, (left @ right).ravel(), atol=1e-12)


def test_what_is_copied_computes_the_same(program: Program, tmp_path: Path) -> None:
    program("node")
    given = states()[:40]
    computed = called(tmp_path, "converter_state.js", "computed", [[state] for state in given])
    made = [
        [each | {"kind": state["kind"], "value": state["value"], "converted": each["there"]}]
        for state, each in zip(given, computed, strict=True)
    ]
    for language in ("Python", "SciPy", "C", "JavaScript", "LaTeX"):
        texts = called(tmp_path, "writing.js", f"LANGUAGES.{language}", made)
        for text, state, (each,) in zip(texts, given, made, strict=True):
            copied_is_right(language, text, state, each["there"])


def copied_is_right(
    language: str, text: str, state: dict[str, Any], there: dict[str, list[float]]
) -> None:
    names: dict[str, Any] = {}
    if language in ("Python", "SciPy"):
        exec(text, names)  # noqa: S102 (our own text)
    if language == "Python":
        for kind, value in names["converted"].items():
            assert np.ravel(value) == pytest.approx(there[kind], abs=1e-12), text
    elif language == "SciPy":
        own = written(state, "target")
        to_body = chr_notes.convert(names["matrix"].T, Convention(), Convention(), kind="matrix")
        matrix = to_body.T if own.matrix_is_transposed else to_body
        assert matrix.ravel() == pytest.approx(there["matrix"], abs=1e-14)
        free = replace(own, written="", matrix="to navigation", row_vectors=False)
        again = chr_notes.convert(names["angles"], free, free, kind="angles", to="matrix")
        assert again == pytest.approx(names["matrix"], abs=1e-14)
    elif language == "LaTeX":
        numbers = re.findall(r"-?\d[^ ]*(?: \\cdot 10\^\{-?\d+\})?", text.partition("R = ")[2])
        values = [float(re.sub(r" \\cdot 10\^\{(.*)\}", r"e\1", number)) for number in numbers]
        assert values == [*there["matrix"], *there["quaternion"]]
    else:
        for line in text.splitlines():
            value = line.partition(" = ")[2].partition(";")[0].translate(str.maketrans("{}", "[]"))
            kind = re.findall(r"angles|quaternion|matrix", line)[0]
            assert np.ravel(json.loads(value)).tolist() == there[kind]


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


# ── on a page ──────────────────────────────────────────────────────────────────────────────────


def numbers(page: Page, name: str) -> list[float]:
    text = str(output(page, name).text_content())
    return [float(each) for each in re.split(r"[,\n]\s*", text)]


def test_on_a_page_from_a_file(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(ConverterDemo()))
    page.locator('textarea[name="matrix"]').fill(str(ROTATION).replace("-", "−"))
    page.locator('select[name="target"]').select_option("SciPy")
    expected = ConverterDemo(
        kind="matrix", value=np.ravel(ROTATION).tolist(), target="SciPy", target_unit=""
    ).readouts()
    for kind in KINDS:
        got = numbers(page, f"target_{kind.replace(' ', '_')}")
        assert got == pytest.approx(expected[kind], abs=1e-13)
    # What is no rotation is said, no number is left, and the nearest one is offered.
    page.locator('textarea[name="matrix"]').fill(str(np.round(ROTATION, 2).tolist()))
    expect(page.locator(".chr-fault")).to_contain_text("No rotation: R Rᵀ is off")
    expect(output(page, "target_quaternion")).to_have_text("–")
    page.get_by_role("button", name="Take the nearest rotation").click()
    expect(page.locator(".chr-fault")).to_be_hidden()
    assert numbers(page, "target_quaternion") == pytest.approx(expected["quaternion"], abs=5e-3)
    # The address keeps all digits.
    page.locator('textarea[name="quaternion"]').fill("0.5 0.1 0.2 0.3333333333333333")
    page.wait_for_function("location.hash.includes('0.3333333333333333')")
    before = numbers(page, "target_matrix")
    page.reload()
    assert numbers(page, "target_matrix") == before
    page.get_by_role("button", name="Swap").click()
    page.get_by_role("button", name="Swap").click()
    assert numbers(page, "target_matrix") == pytest.approx(before, abs=1e-15)
    page.get_by_role("button", name="Reset").click()
    expect(page.locator('textarea[name="angles"]')).to_have_value("10, 20, 30")
    page.locator('input[type="range"][name="turn_2"]').press("End")
    expect(page.locator('textarea[name="angles"]')).to_have_value("10, 180, 30")
    page.locator('textarea[name="angles"]').fill("10 90 30")
    expect(output(page, "source_lock")).to_contain_text("At the lock")
    expect(output(page, "target_lock")).to_contain_text("At the lock")


def test_another_spelling_is_the_same_attitude(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(ConverterDemo()))
    before = numbers(page, "target_matrix")
    page.locator('select[name="source_unit"]').select_option("radians")
    page.locator('select[name="source_sequence"]').select_option("ZXZ")
    assert numbers(page, "target_matrix") == pytest.approx(before, abs=1e-14)
    # Another system takes the numbers for its own.
    page.locator('select[name="source"]').select_option("CHR")
    page.locator('textarea[name="angles"]').fill("10, 20, 30")
    page.locator('select[name="source"]').select_option("this book")
    expect(page.locator('textarea[name="angles"]')).to_have_value("10, 20, 30")
    assert numbers(page, "target_matrix") != pytest.approx(before, abs=1e-2)


def test_an_address_that_means_nothing_changes_nothing(visit: Visit, page_of: PageOf) -> None:
    address = page_of(ConverterDemo())
    page = visit(address)
    for query in ("kind=matrix&value=1,2,3", "value=a,b,c", "source=Excel", "target_sequence=ZZX"):
        page.goto("about:blank")
        page.goto(f"{address}#converter?{query}")
        state = json.loads(str(page.locator(".chr-demo").get_attribute("data-state")))
        assert state == ConverterDemo().state(), query
