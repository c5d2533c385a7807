"""The reference of the functions is complete."""

import re
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

import chr_notes
from chr_notes.generated.scalar.quaternions import euler_from_quaternion

BOOK = Path(__file__).resolve().parents[2] / "book"
PAGES = "".join(path.read_text("utf-8") for path in sorted(BOOK.glob("api*.md")))
FIRST = (BOOK / "api.md").read_text("utf-8")
MEMBERS = dict(re.findall(r"automodule:: (\S+)\n\s+:members:(.*)\n", PAGES))


NAMES = [name for name in chr_notes.__all__ if name != "STANDARD_GRAVITY"]


def test_each_public_name_is_in_the_reference() -> None:
    for name in NAMES:
        module = getattr(chr_notes, name).__module__
        assert module in MEMBERS, name
        chosen = MEMBERS[module].replace(",", " ").split()
        assert not chosen or name in chosen, name


def documented(name: str) -> str:
    return getattr(chr_notes, name).__doc__ or ""


def test_each_public_name_has_an_example_and_a_neighbour() -> None:
    """What only comes as a result may have its example where it is made."""
    own_line = re.compile(r"^    (?:chr_notes\.[\w.]+\.)?(\w+)$", re.MULTILINE)
    for name in NAMES:
        makers = [each for each in own_line.findall(documented(name)) if each in chr_notes.__all__]
        assert any(">>>" in documented(each) for each in (name, *makers)), name
        assert "See Also\n" in documented(name) or name in ("kernels_in_use", "read_log"), name


def test_the_guides_name_functions_that_are_there() -> None:
    guide = FIRST.partition("## Coming from")[2].partition("\n## ")[0]
    here = [line.split("|")[2] for line in guide.splitlines() if line.startswith("| ")]
    called = [name for cell in here for name in re.findall(r"`(\w+)\(", cell)]
    assert len(called) > 10
    assert {*called} <= {*chr_notes.__all__}


def test_the_guide_from_scipy_is_right() -> None:
    euler, vector = np.array([0.3, 0.5, -1.0]), [1.0, 2.0, 3.0]
    there = Rotation.from_euler("ZYX", euler[::-1])
    here = chr_notes.quaternion_from_euler(euler)
    np.testing.assert_allclose(there.as_quat(canonical=True)[[3, 0, 1, 2]], here)
    np.testing.assert_allclose(there.as_matrix(), chr_notes.matrix_from_euler(euler).T)
    np.testing.assert_allclose(there.apply(vector), chr_notes.rotate_to_inertial(here, vector))


def test_the_scalar_example_has_its_names() -> None:
    assert "roll, pitch, yaw, locked = euler_from_quaternion(0.5, 0.5, 0.5, 0.5)" in FIRST
    *angles, locked = euler_from_quaternion(0.5, 0.5, 0.5, 0.5)
    assert len(angles) == 3
    assert locked is False


def test_types_have_the_names_that_one_calls_them_by(book: Path) -> None:
    pages = [path.read_text("utf-8") for path in sorted((book / "book").glob("api*.html"))]
    types = re.findall(r"<strong>\w+</strong> \((.*?)\) – ", "".join(pages), re.DOTALL)
    words = {re.sub(r"<[^>]*>", "", each) for each in types}
    assert "ndarray | None" in words
    assert not [each for each in words if re.search(r"numpy\.|chr_notes\.|collections|proxy", each)]


def test_what_sphinx_makes_of_fields_values_and_colons_is_not_told(book: Path) -> None:
    pages = [path.read_text("utf-8") for path in sorted((book / "book").glob("api*.html"))]
    text = re.sub(r"<[^>]*>", "", "".join(pages))
    assert "Alias for field" not in text
    assert "Type:" not in text  # of what stands before a colon
    assert "chr_notes.estimation.earth_field.TOLERANCE = 0.1" in text
    assert "PRESETS = {" not in text


def test_names_that_share_a_sentence_share_a_line(book: Path) -> None:
    page = (book / "book" / "api_sensors.html").read_text(encoding="utf-8")
    assert "<strong>value</strong>, <strong>first</strong>, <strong>second</strong> – " in page
