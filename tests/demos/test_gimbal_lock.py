"""The gimbal-lock demo: its readouts are Python's numbers, at the lock as well."""

import math
import re
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import expect

import chr_notes
from chr_notes.demos import GimbalLockDemo
from chr_notes.demos.base import SOURCES, formatted, rounded

from .parts import SET_AND_READ, PageOf, Visit, drawn, output, picture, slider, state_of

# ── in Python ──────────────────────────────────────────────────────────────────────────────────


def test_text_has_the_state_and_the_numbers() -> None:
    text = GimbalLockDemo(yaw=-30.5, pitch=60, roll=20).fallback()
    assert "yaw −30.5°, pitch 60°, roll 20°" in text
    assert "Determinant of D: 2." in text
    assert "Condition number of D: 3.732." in text


def test_at_the_lock_the_numbers_have_no_bound() -> None:
    for pitch in (-90, 90):
        assert GimbalLockDemo(pitch=pitch).fallback().count("∞") == 2


def test_aircraft_stands_still_where_the_readout_says_so() -> None:
    for pitch, roll in ((90, 40), (-90, -40)):
        before = chr_notes.matrix_from_euler(np.radians([0, pitch, 0]))
        after = chr_notes.matrix_from_euler(np.radians([roll, pitch, 40]))
        np.testing.assert_allclose(after, before, atol=1e-15)


# ── in the browser ─────────────────────────────────────────────────────────────────────────────


def test_determinant_at_60_degrees_is_2(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(GimbalLockDemo()))
    slider(page, "pitch").fill("60")
    expect(output(page, "determinant")).to_have_text("2")
    expect(output(page, "condition")).to_have_text("3.732")


def entries(text: str) -> list[float]:
    return [float(entry) for entry in text.replace("−", "-").split()]


def test_readouts_are_the_numbers_of_python(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(GimbalLockDemo()))
    random = np.random.default_rng(2)
    low, high = [-180, -89, -180], [180, 89, 180]
    attitudes = random.integers(low, high, size=(50, 3), endpoint=True)
    attitudes = np.vstack([attitudes, [[-71, 90, 33], [10, -90, 20], [0, 0, 0], [180, 89, -180]]])
    states = [dict(zip(("roll", "pitch", "yaw"), row, strict=True)) for row in attitudes.tolist()]
    shown = page.evaluate(SET_AND_READ, states)
    for attitude, (_, texts) in zip(attitudes, shown, strict=True):
        euler = np.radians(attitude)
        roll_axis = chr_notes.matrix_from_euler(euler)[0]
        apart = math.degrees(math.atan2(math.hypot(*roll_axis[:2]), abs(roll_axis[2])))
        fastest = np.linalg.norm(chr_notes.euler_rates_matrix(euler)[2])
        rates = chr_notes.euler_rates_matrix(euler)
        assert texts["determinant"] == formatted(np.linalg.det(rates))
        assert texts["condition"] == formatted(np.linalg.cond(rates, 2))
        numbers = re.findall(r"\d+(?:\.\d+)?", texts["rings"])
        locked = abs(attitude[1]) == 90
        assert numbers == ([] if locked else [formatted(apart), formatted(fastest)])
        matrix = chr_notes.matrix_from_euler(euler).round(3)
        assert entries(texts["matrix"]) == matrix.ravel().tolist()
        assert texts["matrix"].count("\n") == 2
        quaternion = chr_notes.quaternion_from_euler(euler).round(3)
        assert entries(texts["quaternion"]) == quaternion.tolist()


def test_flight_and_rates_are_the_numbers_of_python(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(GimbalLockDemo()))
    random = np.random.default_rng(8)
    low, high = [1, -180, -89, -180, 1], [2, 180, 89, 180, 360]
    rows = random.integers(low, high, size=(40, 5), endpoint=True).tolist()
    rows += [[1, 20, 0, 0, 90], [2, 20, 0, 0, 90], [2, 0, 60, 55, 0], [1, 0, 0, 0, 360]]
    # To fly is to look at the flight, so the view comes last; the others show it before.
    states = [dict(reversed(list(zip(GimbalLockDemo.controls, row, strict=True)))) for row in rows]
    for state, (now, texts) in zip(states, page.evaluate(SET_AND_READ, states), strict=True):
        assert now == state
        start = np.radians([state["roll"], state["pitch"], state["yaw"]])
        flown = np.radians(state["flown"]) if state["view"] == 1 else 0.0
        turn = [np.cos(flown / 2), 0, np.sin(flown / 2), 0]  # over half a turn its sign stays
        q = chr_notes.quaternion_multiply(chr_notes.quaternion_from_euler(start), turn)
        assert entries(texts["quaternion"]) == pytest.approx(q, abs=5.1e-4)
        matrix = np.reshape(entries(texts["matrix"]), (3, 3))
        np.testing.assert_allclose(matrix, chr_notes.matrix_from_quaternion(q), atol=5.1e-4)
        numbers = entries(" ".join(re.findall(r"[−\d.]*\d", texts["rings"])))
        euler = chr_notes.euler_from_quaternion(q, on_gimbal_lock="ignore")
        if math.cos(euler[1]) < 1e-9:
            assert numbers == ([0.5] if state["view"] == 1 else [])
            continue
        rates = chr_notes.euler_rates_matrix(euler)[:, 1]
        further = [0.5] if state["view"] == 1 else [math.cos(euler[1]), 1]
        before = [] if state["view"] == 1 else [1]
        assert numbers == pytest.approx([*before, *rates, *further], rel=6e-4, abs=1e-12)
        sentence = GimbalLockDemo(**state).fallback()
        assert f"pitch {rounded(math.degrees(euler[1]))}°" in sentence


@pytest.mark.parametrize(("pitch", "sense"), [(90, "opposite senses"), (-90, "same sense")])
def test_lock_is_named_at_exactly_90_degrees(
    visit: Visit, page_of: PageOf, pitch: int, sense: str
) -> None:
    page = visit(page_of(GimbalLockDemo(yaw=33, pitch=pitch, roll=-71)))
    expect(output(page, "determinant")).to_have_text("∞")
    expect(output(page, "condition")).to_have_text("∞")
    expect(output(page, "rings")).to_contain_text(
        "Gimbal lock. Yaw and roll turn the aircraft about the same axis"
    )
    expect(output(page, "rings")).to_contain_text(sense)
    attitude = np.radians([-71, pitch, 33])
    matrix = entries(str(output(page, "matrix").text_content()))
    np.testing.assert_allclose(
        np.reshape(matrix, (3, 3)), chr_notes.matrix_from_euler(attitude), atol=5.1e-4
    )
    quaternion = entries(str(output(page, "quaternion").text_content()))
    np.testing.assert_allclose(quaternion, chr_notes.quaternion_from_euler(attitude), atol=5.1e-4)
    assert "−0.000" not in str(output(page, "matrix").text_content())


def test_letters_of_the_compass_stand_in_front(visit: Visit, page_of: PageOf) -> None:
    painted = [text for text, _ in drawn(visit(page_of(GimbalLockDemo(yaw=30, pitch=60))))]
    words = ["N", "E", "S", "W", "z yaw", "y pitch", "x roll"]
    last_area = max(i for i, text in enumerate(painted) if text == "")
    assert [text for text in painted[last_area:] if text != ""] == words


def test_in_the_story_the_aircraft_stands_still_at_the_lock(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(GimbalLockDemo()), reduced_motion="reduce")
    attitudes = {}
    page.get_by_role("button", name="Show me, step by step").click()
    while page.get_by_role("button", name="Next step").count() > 0:
        page.get_by_role("button", name="Next step").click()
        if slider(page, "pitch").input_value() == "90":
            attitudes[picture(page)] = output(page, "matrix").text_content()
    assert len(attitudes) == 2
    assert len(set(attitudes.values())) == 1


def test_matrix_and_quaternion_keep_apart(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(GimbalLockDemo(yaw=30, pitch=75, roll=20)))
    for width in (320, 390, 640, 774):
        page.set_viewport_size({"width": width, "height": 900})
        matrix = output(page, "matrix").bounding_box()
        quaternion = output(page, "quaternion").bounding_box()
        assert matrix is not None
        assert quaternion is not None
        beside = matrix["x"] + matrix["width"] + 8 <= quaternion["x"]
        below = matrix["y"] + matrix["height"] + 8 <= quaternion["y"]
        assert beside or below, width


def on_screen(state: dict[str, float]) -> tuple[float, float]:
    """True angle between the axes of yaw and roll, and the one seen on the screen, degrees."""
    source = (SOURCES / "gimbal_lock.js").read_text(encoding="utf-8")
    beside, above = map(float, re.findall(r"\[BESIDE, ABOVE\] = \[(\S+), (\S+)\]", source)[0])
    assert "viewpoint: ({ yaw }) => ({ heading: yaw + BESIDE, elevation: ABOVE })" in source
    angles = np.radians([state["roll"], state["pitch"], state["yaw"]])
    yaw_axis, roll_axis = np.array([0.0, 0.0, -1.42]), 1.17 * chr_notes.matrix_from_euler(angles)[0]
    view = chr_notes.matrix_from_euler(np.radians([0.0, above, state["yaw"] + beside]))
    seen = [(view @ axis)[1:] / (6 + (view @ axis)[0]) for axis in (yaw_axis, roll_axis)]
    apart = [abs(np.arctan2(*seen[0][::-1]) - np.arctan2(*seen[1][::-1]))]
    true = np.arccos(yaw_axis @ roll_axis / 1.42 / 1.17)
    return float(np.degrees(true)), float(np.degrees(apart[0]))


def opening_states() -> list[dict[str, float]]:
    """What the chapters open the demo with."""
    chapters = Path(__file__).resolve().parents[2] / "notebooks"
    calls = [
        call
        for chapter in sorted(chapters.glob("*.ipynb"))
        for call in re.findall(r'"GimbalLockDemo\((.*?)\)"', chapter.read_text(encoding="utf-8"))
    ]
    numbers = [dict(re.findall(r"(\w+)=([-\d.]+)", call)) for call in calls]
    level = {"roll": 0.0, "pitch": 0.0, "yaw": 0.0, "view": 0.0}
    states = [level | {k: float(v) for k, v in n.items()} for n in numbers]
    return [state for state in states if state["view"] != 1]  # which draws no axes


def test_the_angle_between_yaw_and_roll_is_seen_as_it_is_where_the_book_opens() -> None:
    states = opening_states()
    assert len(states) >= 2
    for state in states:
        true, seen = on_screen(state)
        assert seen == pytest.approx(true, abs=8), state


def test_to_fly_is_to_look_at_the_flight(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(GimbalLockDemo(pitch=60)))
    slider(page, "flown").fill("40")
    assert state_of(page)["view"] == 1
    slider(page, "view").select_option("the rings")
    # What the sliders of the angles say is what the rings show.
    expect(output(page, "rings")).to_contain_text("30° from the line of the yaw axis")
    assert "pitch 60°" in GimbalLockDemo(pitch=60, flown=40).fallback()


def test_axes_say_how_long_the_parts_along_them_are(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(GimbalLockDemo(view=2, pitch=88, roll=55)))
    texts = {text for text, _ in drawn(page)}
    assert {"roll 23.46", "pitch 0.5736", "yaw 23.47"} <= texts
    assert "box" not in texts, "it is a point there"
