"""The drift demo: its readouts are Python's numbers, and its row is the note's."""

import re

import numpy as np
import pytest
from playwright.sync_api import Locator, Page, expect

from chr_notes import drift_budget, drift_from_tilt_error
from chr_notes.conventions import NOTES_GRAVITY
from chr_notes.demos import DriftDemo
from chr_notes.demos.base import formatted
from chr_notes.printed.table_1 import COLUMNS, ROWS

from .parts import SET_AND_READ, PageOf, Visit, drawn, output, slider

STEPS = 64
PLACES = {"the room": 2.5, "the house": 10, "the street": 100, "the city": 5e3, "the country": 3e5}


def expected(state: dict[str, float]) -> dict[str, float]:
    """The readouts from the array functions; what is printed lacks the factor one half."""
    angle = np.radians(state["angle_error"])
    acceleration, velocity, position = drift_from_tilt_error(angle, state["time"])
    budget = drift_budget(
        state["time"],
        accel_bias=state.get("accel_bias", 0),
        gyro_bias=np.radians(state.get("gyro_bias", 0)),
        accel_noise=state.get("accel_noise", 0),
        gravity=NOTES_GRAVITY,
    )
    return {
        "acceleration_error": float(acceleration),
        "velocity_error": float(velocity),
        "position_error": float(position),
        "accel_bias_error": float(budget.accel_bias),
        "gyro_bias_error": float(budget.gyro_bias),
        "noise_error": float(budget.noise),
        "total_error": float(position + budget.worst),
        "printed_position_error": float(acceleration * state["time"] ** 2),
    }


def length(metres: float) -> str:
    value, unit = (metres, "m") if metres < 1000 else (metres / 1000, "km")
    value, unit = (100 * metres, "cm") if metres < 1 else (value, unit)
    return f"{float(f'{value:.3g}'):.15g}\u00a0{unit}"


def readout(name: str, value: float) -> str:
    """Four digits, and for a length its unit, kilometres from ten of them on."""
    if name in {"acceleration_error", "velocity_error"}:
        return formatted(value)
    return f"{formatted(value)} m" if value < 1e4 else f"{formatted(value / 1000)} km"


def in_words(numbers: dict[str, float]) -> list[str]:
    """The quantities that the sentence names, in its order."""
    causes = [numbers[f"{cause}_error"] for cause in ("position", "accel_bias", "gyro_bias")]
    if any((*causes[1:], numbers["noise_error"])):
        named = [*causes, numbers["noise_error"]]
        # Noise alone takes the sensor nowhere on average: no length is named for that.
        far = [numbers["total_error"]] if any(causes) else []
        return [length(each) for each in (*far, *(each for each in named if each > 0))]
    if causes[0] == 0:
        return []
    return [
        length(numbers["position_error"]),
        formatted(numbers["velocity_error"]) + "\u00a0m/s",
    ]


def meant(sentence: str) -> list[str]:
    return re.findall(r"[\d.]+\u00a0(?:cm|km|m/s|m)\b", sentence)


def test_readouts_are_the_numbers_of_python(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(DriftDemo()))
    random = np.random.default_rng(4)
    names = ("angle_error", "time", "accel_bias", "gyro_bias", "accel_noise")
    most, parts = [50, STEPS, 50, 20, 50], [10, 1, 100, 1000, 1000]
    rows = random.integers(0, most, size=(50, 5), endpoint=True) / parts
    rows[:25, 2:] = 0
    rows[40:, :1] = 0
    positions = [dict(zip(names, row, strict=True)) for row in rows.tolist()]
    quiet = dict.fromkeys(names, 0)
    positions += [quiet, quiet | {"angle_error": 5, "time": STEPS}]
    positions += [quiet | {"gyro_bias": 0.02, "time": STEPS}, quiet | {"accel_noise": 0.05}]
    times = set()
    for position, (state, texts) in zip(
        positions, page.evaluate(SET_AND_READ, positions), strict=True
    ):
        assert state["angle_error"] == position["angle_error"]
        assert state["time"] == pytest.approx(3600 ** (position["time"] / STEPS), rel=0.05)
        times.add(state["time"])
        numbers = DriftDemo(**state).readouts()
        assert numbers == pytest.approx(expected(state), rel=1e-14)
        for name, value in numbers.items():
            # Where two decimals are as near as each other, JavaScript may take the other one.
            near = {readout(name, value * (1 + part)) for part in (-4e-16, 0, 4e-16)}
            assert texts[name] in near, (name, state)
        assert meant(texts["meaning"]) == in_words(numbers)
        left = [name for name, far in PLACES.items() if far < numbers["total_error"]]
        words = re.findall(r"away(?:, out of (the \w+))?[,:.]", texts["meaning"])
        assert words == ((left or [""])[-1:] if numbers["total_error"] else [])
        assert ("too far for these" in texts["meaning"]) == (
            state["gyro_bias"] * state["time"] > 20
        )
    assert len(times) > 20


def test_slider_of_time_goes_through_the_times_of_the_table(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(DriftDemo()))
    positions = [{"time": step} for step in range(STEPS + 1)]
    times = [state["time"] for state, _ in page.evaluate(SET_AND_READ, positions)]
    assert sorted(set(times)) == times, "each step goes forward"
    assert {1, 3600, *(column.seconds for column in COLUMNS.values() if column.seconds)} <= {*times}


def test_time_is_said_in_words(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(DriftDemo(time=60)))
    expect(slider(page, "time")).to_have_attribute("aria-valuetext", "1 minute")
    slider(page, "time").focus()
    page.keyboard.press("ArrowRight")
    expect(slider(page, "time")).to_have_attribute("aria-valuetext", "1 minute 8 seconds")
    page.keyboard.press("End")
    expect(slider(page, "time")).to_have_attribute("aria-valuetext", "1 hour")


@pytest.mark.parametrize("degrees", ROWS)
def test_as_printed_means_as_the_table_prints(degrees: str) -> None:
    """The printed positions follow from the row's printed acceleration without the half."""
    acceleration = float(ROWS[degrees][0])
    for column, text in zip(COLUMNS.values(), ROWS[degrees], strict=True):
        if column.quantity != "r":
            continue
        printed = float(text.replace(" ", ""))
        shown = DriftDemo(angle_error=float(degrees), time=column.seconds).readouts()
        without_half = acceleration * column.seconds**2
        digits = len(text.split(" e ")[0].replace(".", ""))
        assert float(f"{without_half:.{digits}g}") == pytest.approx(printed, rel=1e-12)
        ratio = shown["printed_position_error"] / shown["acceleration_error"]
        assert ratio * acceleration == pytest.approx(without_half)
        assert shown["printed_position_error"] == pytest.approx(2 * shown["position_error"])


def cells(page: Page | Locator) -> list[list[str]]:
    rows = page.locator(".chr-table tr").all()
    return [row.locator("th, td").all_text_contents() for row in rows]


def test_rows_are_those_of_the_note(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(*(DriftDemo(angle_error=float(degrees)) for degrees in ROWS)))
    for demo, degrees in zip(page.locator(".chr-demo").all(), ROWS, strict=True):
        head, *body = cells(demo)
        assert head == [f"at {float(degrees):g}°", "right", "printed"]
        assert tuple(row[2] for row in body) == ROWS[degrees]
        for (_, right, _), column in zip(body, COLUMNS.values(), strict=True):
            state = {"angle_error": float(degrees), "time": float(column.seconds)}
            number = dict(zip("avr", list(expected(state).values())[:3], strict=True))
            assert right == formatted(number[column.quantity])


def test_between_the_rows_nothing_is_printed(visit: Visit, page_of: PageOf) -> None:
    head, *body = cells(visit(page_of(DriftDemo(angle_error=0.7))))
    assert head[2] == "no such row"
    assert {row[2] for row in body} == {"–"}


def test_without_an_error_there_is_no_drift(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(DriftDemo(angle_error=0, time=3600)))
    expect(output(page, "position_error")).to_have_text("0 m")
    expect(output(page, "meaning")).to_contain_text("at rest")


def test_the_growth_has_a_line_for_each_cause(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(DriftDemo(view=1, gyro_bias=0.003, accel_noise=0.01)))
    words = {text for text, _ in drawn(page)}
    assert {"position", "gyro bias", "noise"} <= words
    assert "accel. bias" not in words


def test_map_shows_where_the_sensor_believes_to_be(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(DriftDemo(time=60)))
    words = [text for text, _ in drawn(page) if text]
    assert {"the street", "100\u00a0m", "● 308\u00a0m after 1 min"} <= set(words)
    page.get_by_label("Show").select_option("the growth of the errors")
    assert {"velocity", "position", "without ½"} <= {text for text, _ in drawn(page)}


def test_text_has_the_numbers() -> None:
    assert DriftDemo(angle_error=1, time=600).fallback() == (
        "An attitude that is off by 1°, after 600 s: acceleration is off by 0.171 m/s², velocity "
        "by 102.6 m/s, position by 30790 m. As the note reckons, position would be off by 61570 m."
    )
    assert (
        DriftDemo(accel_bias=0.02, time=60)
        .fallback()
        .endswith("bias moves it by 36 m, the gyro's by 0 m, noise by 0 m RMS.")
    )
