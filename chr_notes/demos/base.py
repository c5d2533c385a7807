"""What the demos have in common on the Python side.

A demo is one anywidget: live with a kernel, and without one a ``div`` that the script of the
book's pages mounts with the stored state. Both run the same script, and a reader who has neither
gets a picture and its numbers as text.
"""

import html
import json
import math
import urllib.parse
from pathlib import Path
from typing import Any, ClassVar

import anywidget
import traitlets

from chr_notes import palette
from chr_notes._texts import is_there, read

__all__ = [
    "BUILT",
    "BUNDLE",
    "SOURCES",
    "Control",
    "Demo",
    "entry",
    "formatted",
    "page_script",
    "rounded",
    "styles",
]

SOURCES = Path(__file__).resolve().parent
BUILT = SOURCES / "built"
BUNDLE = "chrDemos"
"""What the built script calls all that it has."""
_BEYOND = 1e12  # above this a double near a pole says no more than "without bound"


def styles() -> str:
    """Return the style sheet of the demos, with the colours of the project in it."""
    return palette.css() + read(SOURCES / "demos.css")


def _script(ending: str, bundle: str) -> str:
    return read(BUILT / f"{bundle}.js") + ending + "\n"


def page_script(bundle: str = "demos") -> str:
    """Return the script that mounts the demos of a page: "demos", or "converter" for that one."""
    return _script(f"{BUNDLE}.mountAll();", bundle)


def formatted(value: float) -> str:
    """Return four significant digits, or the sign of infinity, as the demos show it."""
    if not abs(value) < _BEYOND:
        return "−∞" if value < 0 else "∞"
    return f"{float(f'{value:.4g}') + 0.0:.15g}".replace("-", "−")


def rounded(value: float) -> str:
    """Return two decimals at most, as the demos show an angle."""
    return f"{float(f'{value:.2f}') + 0.0:.15g}".replace("-", "−")


def entry(value: float) -> str:
    """Return three decimals, as the demos show an element of a matrix or a quaternion."""
    return f"{round(value, 3) + 0.0:.3f}".replace("-", "−")


class Control(traitlets.Float[float, float]):
    """The value of a slider: a number within its range, and a whole one where it is to be."""

    info_text = "a number"

    def __init__(self, default: float, *, min: float, max: float, whole: bool = False) -> None:  # noqa: A002 - traitlets' names
        """Take the default, the range, and whether only whole numbers count."""
        super().__init__(default, min=min, max=max)
        self.whole = whole

    def validate(self, obj: Any, value: Any) -> float:  # noqa: ANN401 - traitlets' signature
        """Refuse what is not a number, and make minus zero zero."""
        number = super().validate(obj, value)
        if math.isnan(number) or (self.whole and number != round(number)):
            self.error(obj, value)
        return number + 0.0


class Demo(anywidget.AnyWidget):
    """Base of the demos: a subclass names its element and its traits, and says its numbers.

    One that draws nothing has no still picture: it is not `pictured`.

    Raises
    ------
    traitlets.TraitError
        For a state that is not a number or is outside the range of its slider.
    """

    element: ClassVar[str]
    bundle: ClassVar[str] = "demos"
    controls: ClassVar[tuple[str, ...]]
    texts: ClassVar[tuple[str, ...]] = ()
    pictured: ClassVar[bool] = True

    _esm = traitlets.Unicode().tag(sync=True)
    _css = traitlets.Unicode().tag(sync=True)

    @traitlets.default("_esm")
    def _read_module(self) -> str:
        return _script(f'export default {BUNDLE}.widgetOf("{self.element}");', self.bundle)

    @traitlets.default("_css")
    def _make_styles(self) -> str:
        return styles()

    def state(self) -> dict[str, Any]:
        """Return the value of each control by its name, and of what is a text."""
        numbers = {name: float(getattr(self, name)) for name in self.controls}
        return numbers | {name: getattr(self, name) for name in self.texts}

    def fallback(self) -> str:
        """Return what a reader without JavaScript sees."""
        raise NotImplementedError

    def to_html(self) -> str:
        """Return the element that the script of the book's pages turns into the demo."""
        state = html.escape(json.dumps(self.state()))
        text = html.escape(self.fallback())
        start = f'<div data-demo="{self.element}" data-state="{state}">'
        return f"{start}{self._picture()}<p>{text}</p></div>"

    def still_name(self) -> str:
        """Return the name of the file with the still picture of this state."""
        told = (each for each in self.state().values() if each != "")
        written = (f"{each:g}" if isinstance(each, float) else str(each) for each in told)
        return "_".join([self.element, *written]) + ".svg"

    def _picture(self) -> str:
        """Return the still picture with its words, where the state has one."""
        path = BUILT / self.still_name()
        if not self.pictured or not is_there(path):
            return ""
        drawn = read(path)
        words = drawn.partition("<title>")[2].partition("</title>")[0]
        source = urllib.parse.quote(drawn.strip(), safe=" =:/,;()'-.")
        return f'<img alt="{words}" width="420" src="data:image/svg+xml,{source}">'

    def __repr__(self) -> str:
        """Return the call that makes this demo."""
        values = ", ".join(
            f"{name}={value:.15g}" if isinstance(value, float) else f"{name}={value!r}"
            for name, value in self.state().items()
            if value != ""
        )
        return f"{type(self).__name__}({values})"

    def _repr_mimebundle_(self, **kwargs: Any) -> tuple[dict[str, Any], dict[str, Any]]:  # noqa: ANN401 - Jupyter's signature
        data, metadata = super()._repr_mimebundle_(**kwargs) or ({}, {})
        return {**data, "text/html": self.to_html()}, metadata
