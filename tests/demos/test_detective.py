"""The detective on a page finds what Python's does."""

import re
from collections.abc import Callable
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose
from playwright.sync_api import expect
from scipy.spatial.transform import Rotation
from traitlets import TraitError

import chr_notes
from chr_notes import Convention
from chr_notes.demos import DetectiveDemo
from chr_notes.demos.detective import SHAPES
from chr_notes.sequences import SEQUENCES
from chr_notes.systems.convention import DOCUMENTED, PRESETS
from tests.systems.test_detective import drawn, printed

from .modules import called
from .parts import PageOf, Visit, output

SYSTEMS = PRESETS | DOCUMENTED
KINDS = ("angles", "matrix", "quaternion")


def pairs(count: int) -> list[dict[str, Any]]:
    """Random pairs in one convention, in the axes of two systems, and some that do not fit."""
    random = np.random.default_rng(31)
    made = [printed(drawn(random), random) for _ in range(count)]
    for number in range(count // 5):
        q = random.normal(size=4)
        one, other = random.choice([*SYSTEMS], 2)
        first, second = random.permutation(KINDS)[:2]
        made.append({
            kind: chr_notes.convert(q, "this book", name, kind="quaternion", to=kind).round(4)
            for kind, name in sorted([(first, one), (second, other)])
        })  # fmt: skip
        if number % 4 == 0:
            made[-1][first] = made[-1][first] + 0.2
    turn = [[0.866, 0.5, 0.0], [-0.5, 0.866, 0.0], [0.0, 0.0, 1.0]]
    made.append({"angles": np.array([30.0, 0.0, 0.0]), "matrix": np.array(turn)})
    made.append({"matrix": np.array(turn), "quaternion": np.array([0.9659, 0.0, 0.0, 0.2588])})
    return made


def rows(given: dict[str, Any]) -> dict[str, list[list[float]]]:
    return {
        kind: np.reshape(value, (-1, int(np.prod(SHAPES[kind])))).tolist()
        for kind, value in given.items()
    }


def test_it_finds_what_python_finds(
    program: Callable[[str], str], tmp_path: Path, samples: Callable[[int, int], int]
) -> None:
    program("node")
    given = pairs(samples(60, 200))
    made = called(tmp_path, "detective_search.js", "findConventions", [[rows(g)] for g in given])
    faults = 0
    for pair, found in zip(given, made, strict=True):
        if "fault" in found:
            faults += 1
            with pytest.raises(ValueError, match=f"^{re.escape(found['fault'])}$"):
                chr_notes.find_conventions(**pair)
            continue
        expected = chr_notes.find_conventions(**pair)
        assert len(found["matches"]) == len(expected), pair
        for one, other in zip(found["matches"], expected, strict=True):
            assert one["convention"] == asdict(other.convention), pair
            assert one["others"] == [asdict(each) for each in other.others]
            assert one["error"] == pytest.approx(other.error, abs=1e-9)
            assert (one["axes"] is None) == (other.axes is None)
            if other.axes is not None:
                assert {kind: tuple(each) for kind, each in one["axes"].items()} == other.axes
            assert (one["example"] is None) == (other.example is None)
            for kind, value in (other.example or {}).items():
                assert_allclose(one["example"][kind], np.ravel(value), atol=1e-12)
    assert faults > 2


def test_a_product_of_turns_is_the_matrix(program: Callable[[str], str], tmp_path: Path) -> None:
    """R = Rz(α)·Ry(β)·Rx(γ) and so on: by SciPy's turns about one axis each."""
    program("node")
    own = [Convention(sequence) for sequence in SEQUENCES]
    own += [each for each in SYSTEMS.values() if each.written or each.negated]
    made = called(tmp_path, "detective_words.js", "productOf", [[asdict(each)] for each in own])
    for convention, factors in zip(own, made, strict=True):
        angles = [20.0, -30.0, 50.0]
        free = replace(convention, degrees=True, matrix="to navigation", row_vectors=False)
        expected = chr_notes.convert(angles, free, free, kind="angles", to="matrix")
        turns = [
            Rotation.from_euler(f["axis"], f["sign"] * angles[f["place"]], degrees=True)
            for f in factors
        ]
        assert_allclose((turns[0] * turns[1] * turns[2]).as_matrix(), expected, atol=1e-14)


def test_a_verdict_tells_what_it_needs(program: Callable[[str], str], tmp_path: Path) -> None:
    """Different axes explain a wrong sign too: what is less unusual is said beside it."""
    program("node")
    angles, q = [10.0, 20.0, 30.0], [0.95155, 0.03813, 0.18931, 0.23930]
    given = [
        {"angles": [angles], "quaternion": [[-v if i == place else v for i, v in enumerate(q)]]}
        for place in range(-1, 4)
    ]
    given.append({"angles": [[20.0, 30.0, 10.0]], "quaternion": [q]})
    found = called(tmp_path, "detective_search.js", "findConventions", [[each] for each in given])
    asked = [[each["matches"], rows, None] for each, rows in zip(found, given, strict=True)]
    plain, conjugate, *slipped, reordered = called(
        tmp_path, "detective_words.js", "verdictOf", asked
    )
    # A scalar with the other sign makes the conjugate, which is plain.
    assert plain == conjugate == "One answer."
    for place, each in enumerate(slipped, 1):
        assert "only if the programs use different axes" in each
        said = f"number {place} of the angles, or of number {place + 1} of the quaternion"
        assert said in each
    assert "only if the angles stand in another order" in reordered


def test_what_is_asked_for_has_a_unit(program: Callable[[str], str], tmp_path: Path) -> None:
    program("node")
    degrees, radians = ({"convention": {"degrees": each}} for each in (True, False))
    asked = [[[degrees, other], ["angles"], "angles 1, 2, 3"] for other in (degrees, radians)]
    made = called(tmp_path, "detective_words.js", "askedWords", asked)
    assert [each["ask"] for each in made] == [
        "angles 1, 2, 3 degrees", "angles 1, 2, 3 in their own unit"
    ]  # fmt: skip


def test_a_state_that_is_none_is_refused() -> None:
    for wrong in ({"angles": [1.0, 2.0]}, {"quaternion": [np.nan] * 4}, {"unit": "grad"}):
        with pytest.raises(TraitError):
            DetectiveDemo(**wrong)
    demo = DetectiveDemo(angles=[], matrix=np.eye(3).ravel().tolist(), unit="degrees")
    assert eval(repr(demo)).state() == demo.state()  # noqa: S307 (our own text)
    assert "Found 1, first: angles ZYX in degrees" in DetectiveDemo().fallback()
    assert "Found nothing: expected two or more" in DetectiveDemo(angles=[]).fallback()


def test_on_a_page_from_a_file(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(DetectiveDemo()))
    found = page.locator(".chr-found")
    expect(output(page, "verdict")).to_have_text("One answer.")
    expect(found).to_contain_text(
        "about rotating axes, in degrees — as SciPy, MATLAB, Eigen, Madgwick, JPL. "
        "R = Rz(α)·Ry(β)·Rx(γ)"
    )
    # The example that the page opens with is no answer of the reader's programs.
    page.locator('textarea[name="matrix"]').fill("0.36 0.48 -0.8 -0.8 0.6 0 0.48 0.64 0.6")
    expect(output(page, "verdict")).to_contain_text("Two kinds of numbers are needed")
    expect(page.locator('textarea[name="quaternion"]')).to_have_value("")
    page.locator('textarea[name="angles"]').fill("10 20 30")
    page.locator('textarea[name="matrix"]').fill("0.36 0.48 -0.8 -0.8 0.6 0 0.48 0.46 0.6")
    expect(output(page, "verdict")).to_contain_text("row 3, column 2, 0.46, where 0.64 would fit")
    page.get_by_role("button", name="Clear").click()
    # What a UM7 and ROS say, each in its own axes.
    page.locator('textarea[name="angles"]').fill("10 20 30")
    page.locator('textarea[name="quaternion"]').fill("x: 0.1608\ny: −0.1069\nz: 0.5036\nw: 0.8421")
    expect(found).to_contain_text("as this book, CH Robotics (UM6, UM7)")
    expect(output(page, "verdict")).to_contain_text("only if the programs use different axes")
    expect(found).to_contain_text("in east-north-up and forward-left-up — as ROS")
    page.wait_for_function("location.hash.includes('0.8421')")
    page.reload()
    expect(found).to_contain_text("as ROS")
    page.locator('textarea[name="quaternion"]').fill("0.9 0.1 0.2 0.3")
    expect(output(page, "verdict")).to_contain_text("at least")
    page.locator('textarea[name="quaternion"]').fill("0.9 0.1 0.2")
    expect(output(page, "verdict")).to_contain_text("expected 4 numbers an example, found 3")
    page.get_by_role("button", name="Clear").click()
    expect(output(page, "verdict")).to_contain_text("Two kinds of numbers are needed")
    # A turn about one axis leaves several, and one further attitude decides.
    page.locator('textarea[name="angles"]').fill("30, 0, 0")
    page.locator('textarea[name="matrix"]').fill("0.866 0.5 0; -0.5 0.866 0; 0 0 1")
    expect(output(page, "verdict")).to_contain_text("answers, the simplest first")
    expect(found).to_contain_text(
        re.compile("To decide, ask your programs for angles [0-9, ]+ degrees")
    )
