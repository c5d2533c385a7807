"""What the page says of the documents' contradictions is what their formulas give."""

import numpy as np
from scipy.spatial.transform import Rotation

from chr_notes.book import cases_page
from chr_notes.ledger import entries

TO_INERTIAL = Rotation.from_euler("ZYX", [30, 20, 10], degrees=True)


def rows(lines: list[str]) -> list[list[str]]:
    return [line.strip("| ").split(" | ") for line in lines if line.startswith("| ")][1:]


def numbers(cell: str) -> list[float]:
    return [float(part) for part in cell.split(", ")]


def test_the_quaternion_note_goes_the_other_way_than_its_symbols() -> None:
    lines = list(cases_page.quaternion_note())
    quaternion, matrix, vector = rows("\n".join(lines).splitlines())
    for row in (quaternion, matrix, vector):
        assert row[2:] == ["body", "inertial"]
    theirs = TO_INERTIAL.as_quat()
    np.testing.assert_allclose(numbers(quaternion[1]), np.roll(theirs, 1), atol=6e-5)
    np.testing.assert_allclose(numbers(matrix[1]), TO_INERTIAL.as_matrix()[0], atol=6e-5)
    np.testing.assert_allclose(numbers(vector[1]), TO_INERTIAL.apply([1, 0, 0]), atol=6e-5)
    off = np.degrees((TO_INERTIAL * TO_INERTIAL).magnitude())
    assert f"here {off:.1f}°" in lines[-1]


def test_the_paper_uses_one_symbol_both_ways_and_gravity_for_a_reading() -> None:
    table = rows("\n".join(cases_page.validation_paper()).splitlines())
    matrix, there, back, _, gravity, reading = table
    assert [row[3] for row in (matrix, there, back)] == [
        "inertial",
        "body",
        "inertial",
    ]
    np.testing.assert_allclose(numbers(there[1]), TO_INERTIAL.inv().apply([0, 0, 9.8]), atol=6e-5)
    assert gravity[1:] == ["-20.0°", "gravity itself"]
    assert reading[1:] == ["20.0°", "minus gravity, as an accelerometer reads"]


def test_the_ledger_has_the_same_roots() -> None:
    roots = {entry.id: entry.root for entry in entries()}
    assert roots["quaternions.3.1"] == roots["quaternions.3.3"] == "quaternion-direction"
    assert roots["validation.1"] == roots["validation.5"] == "matrix-label"
    assert roots["validation.4"] == "gravity-or-reading"
