"""The parts of pages on conventions say what is derived, and what is computed."""

import pytest

from chr_notes.book import sequence_page
from chr_notes.derivations import sequences


@pytest.fixture(scope="module")
def made() -> dict[str, str]:
    return sequence_page.generated()


def test_each_sequence_has_a_card(made: dict[str, str]) -> None:
    heads = [line for line in made["sequences.md"].splitlines() if line.startswith("## ")]
    assert [head[3:6] for head in heads] == list(sequences.ROTATING)
    assert "## ZYX, or 3-2-1" in heads
    text = made["sequences.md"].split("## ZYX")[1].split("## ")[0]
    assert "is ±90°" in text
    assert "`xyz`" in text
    assert made["sequences.md"].count("is 0° and 180°") == 6


def test_an_attitude_in_each_system(made: dict[str, str]) -> None:
    rows = {line.split(" | ")[0]: line for line in made["presets.md"].splitlines()}
    # Pitch has the other sign there, and yaw counts from east to the left: 60°.
    assert "0.1745, -0.3491, 1.0472 rad (`xyz`)" in rows["| ROS"]
    assert "10.00, 20.00, 30.00° (`xyz`)" in rows["| CH Robotics (UM6, UM7)"]
    assert "-20.00, 30.00, -10.00° (`zxy`, written `xyz`)" in made["documented.md"]
