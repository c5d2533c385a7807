"""What holds for each demo in Python: what it refuses, and what it hands to a notebook."""

import html
import json
import re
import subprocess
import sys
import urllib.parse
from html.parser import HTMLParser
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from traitlets import TraitError

from chr_notes.demos.base import Demo, formatted, rounded
from chr_notes.palette import PALETTE

from .parts import DEMOS, each_demo


def test_demos_do_not_load_sympy() -> None:
    code = "import sys, chr_notes.demos; print('sympy' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    assert done.stdout.strip() == "False"


@each_demo
def test_notebook_gets_widget_html_and_text(demo: type[Demo]) -> None:
    data, _ = demo()._repr_mimebundle_()
    assert "application/vnd.jupyter.widget-view+json" in data
    assert data["text/plain"] == repr(demo())
    assert data["text/html"] == demo().to_html()


@each_demo
def test_html_holds_the_state_and_the_text(demo: type[Demo]) -> None:
    found: dict[str, str | None] = {}
    words: list[str] = []

    class Parser(HTMLParser):
        def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
            if tag == "div":
                found.update(attrs)

        def handle_data(self, data: str) -> None:
            words.append(data)

    Parser().feed(demo().to_html())
    assert found["data-demo"] == demo.element
    assert json.loads(str(found["data-state"])) == demo().state()
    assert "".join(words) == demo().fallback()


@each_demo
def test_state_outside_a_slider_is_refused(demo: type[Demo]) -> None:
    for name in demo.controls:
        trait = demo.class_traits()[name]
        for limit, beyond in ((trait.min, trait.min - 1), (trait.max, trait.max + 1)):
            assert demo(**{name: limit}).state()[name] == limit
            with pytest.raises(TraitError):
                demo(**{name: beyond})


@each_demo
def test_what_is_no_number_is_refused(demo: type[Demo]) -> None:
    for name in demo.controls:
        with pytest.raises(TraitError, match=f"'{name}' trait"):
            demo(**{name: float("nan")})


@each_demo
def test_minus_zero_is_zero(demo: type[Demo]) -> None:
    zeros = {name: -0.0 for name in demo.controls if demo.class_traits()[name].min <= 0}
    made = demo(**zeros)
    assert "-0" not in repr(made) + made.to_html()
    assert "−0" not in made.fallback()


@each_demo
def test_widget_carries_its_module_and_styles(demo: type[Demo]) -> None:
    state = demo().get_state()
    assert "export" in state["_esm"]
    assert "--chr-x" in state["_css"]


def opened() -> set[str]:
    """The calls of demos in the chapters."""
    chapters = Path(__file__).resolve().parents[2] / "notebooks"
    names = "|".join(each.__name__ for each in DEMOS)
    return {
        call
        for chapter in chapters.glob("*.ipynb")
        for cell in json.loads(chapter.read_text(encoding="utf-8"))["cells"]
        for call in re.findall(rf"^(?:{names})\(.*\)$", "".join(cell["source"]), re.MULTILINE)
    }


def test_each_state_that_a_chapter_opens_with_has_a_still_picture() -> None:
    calls = opened()
    assert len(calls) >= 9
    for call in calls:
        demo = eval(call, {each.__name__: each for each in DEMOS})  # noqa: S307 (our own text)
        picture = re.findall(
            r'<img alt="(.+?)" width="420" src="data:image/svg\+xml,(.+?)">', demo.to_html()
        )
        assert len(picture) == 1, call
        words, source = picture[0]
        svg = ET.fromstring(urllib.parse.unquote(source))  # noqa: S314 (our own text)
        assert svg.findtext("{*}title") == html.unescape(words)
        texts = [each.text for each in svg.iterfind(".//{*}text")]
        assert len(texts) > 5, "the picture says nothing"
        each_colour_has_one_for_the_dark(svg)
        assert len(demo.to_html()) < 90_000


def each_colour_has_one_for_the_dark(svg: ET.Element) -> None:
    """The rules under `prefers-color-scheme: dark` stand for each colour of the light theme."""
    style = str(svg.findtext("{*}style"))
    assert style.startswith("@media(prefers-color-scheme:dark){")
    rules = dict(re.findall(r"\.(s\w+)\{((?:fill|stroke|color):[^}]+)\}", style))
    seen = set()
    for part in svg.iter():
        for name in ("fill", "stroke", "color"):
            colour = part.get(name)
            if colour in (None, "none", "currentColor"):
                continue
            kind, _, dark = rules[str(part.get("class"))].partition(":")
            assert kind == name
            seen.add((colour, dark))
    palette = {(each.light, each.dark) for each in PALETTE.values()}
    assert {pair for pair in seen if pair[0] in ("#ffffff", "#17202b", "#566274")} <= palette
    assert ("#ffffff", PALETTE["page"].dark) in seen


def test_a_state_without_a_still_picture_has_its_numbers() -> None:
    assert DEMOS[0](time=77).to_html().endswith(f"<p>{DEMOS[0](time=77).fallback()}</p></div>")
    assert "<img" not in DEMOS[0](time=77).to_html()


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (1.9999999999999996, "2"),
        (57.298688498550185, "57.3"),
        (12345.678, "12350"),
        (-0.5, "−0.5"),
        (-0.0, "0"),
        (1.6e16, "∞"),
        (float("inf"), "∞"),
        (float("-inf"), "−∞"),
    ],
)
def test_numbers_are_shown_with_four_digits(value: float, text: str) -> None:
    assert formatted(value) == text


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (29.999999999999996, "30"),
        (-0.001, "0"),
        (-0.0, "0"),
        (-12.345678, "−12.35"),
        (179.5, "179.5"),
    ],
)
def test_angles_are_shown_with_two_decimals(value: float, text: str) -> None:
    assert rounded(value) == text
