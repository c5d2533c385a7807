"""LaTeX as MathML: what browsers need is there, and nothing is lost without a word."""

from xml.etree.ElementTree import Element, fromstring

import pytest

from chr_notes.book.mathml import mathml
from chr_notes.ledger import entries


def converted(latex: str) -> Element:
    return fromstring(mathml(latex, display=True))  # noqa: S314 (our own)


def drawn(latex: str) -> str:
    """The characters that are shown."""
    return "".join(converted(latex)[0][0].itertext())


def one(latex: str, text: str) -> Element:
    """The only element with this text."""
    (found,) = (each for each in converted(latex).iter() if each.text == text)
    return found


def test_each_formula_of_the_ledger_is_set_whole() -> None:
    for entry in entries():
        for name in ("printed_latex", "derived_latex", "correction_latex", "condition"):
            latex = getattr(entry, name)
            if latex is not None:
                shown = drawn(latex)
                assert not set(shown) & set("\\&$"), f"{entry.id}: {shown}"
                digits = [c for c in latex.replace(r"\\[0.6em]", "") if c.isdigit()]
                assert sorted(digits) == sorted(c for c in shown if c.isdigit()), entry.id


@pytest.mark.parametrize(
    ("latex", "reason"),
    [
        (r"\gimbal", "gimbal"),
        (r"\begin{spiral} a \end{spiral}", "spiral"),
        (r"\frac{a}", "argument"),
        (r"\left( a", "right"),
        (r"a & b", "&"),
        (r"a \\ b", "a line break outside of an environment"),
        (r"\begin{pmatrix}a\\b\end{pmatrix} \\ c", "a line break outside of an environment"),
        ("a\n\nb", "an empty line"),
    ],
)
def test_what_cannot_be_set_is_refused(latex: str, reason: str) -> None:
    with pytest.raises(ValueError, match=reason):
        mathml(latex, display=True)


def test_line_breaks_within_environments_are_fine() -> None:
    matrix = r"\begin{pmatrix}1\\2\end{pmatrix}"
    assert (
        drawn(rf"{matrix} = \begin{{aligned}}&{matrix}\\[0.6em]&3\end{{aligned}}") == "(12)=(12)3"
    )


def test_the_latex_is_kept() -> None:
    latex = r"\left. x \right|_{\substack{ L=0 }} < 1"
    annotation = one(latex, latex)
    assert annotation.tag == "annotation"
    assert annotation.get("encoding") == "application/x-tex"


@pytest.mark.parametrize(
    ("latex", "before", "after"),
    [
        (r"\begin{pmatrix}a \sin {\theta}\end{pmatrix}", "0.1667em", "0.1667em"),
        (r"\begin{pmatrix}1 & - \sin {\theta}\end{pmatrix}", "0.1667em", "0.1667em"),
        (r"\begin{pmatrix}1 & - \sin^{2} {\theta}\end{pmatrix}", "0.1667em", "0.1667em"),
        (r"\begin{pmatrix}a - \sin {\theta}\end{pmatrix}", "0", "0.1667em"),
        (r"\begin{pmatrix}\sin{\left(a - b\right)}\end{pmatrix}", "0", "0"),
    ],
)
def test_a_function_in_a_matrix_stands_apart(latex: str, before: str, after: str) -> None:
    name = one(latex, "sin")
    assert (name.get("lspace"), name.get("rspace")) == (before, after)


@pytest.mark.parametrize(
    ("latex", "space"),
    [(r"\cos {\psi}", "0.1667em"), (r"\cos \psi", "0.1667em"), (r"\cos{\left(a\right)}", None)],
)
def test_a_function_stands_apart_from_its_argument(latex: str, space: str | None) -> None:
    assert one(latex, "\u2061").get("lspace") == space


@pytest.mark.parametrize(
    ("latex", "stretchy"),
    [
        (r"R_{v_1}^{v_2}\left(\dot{\theta}\right)", "false"),
        (r"\left(\frac{\pi}{2}\right)", None),
        (r"\begin{pmatrix}0\\1\end{pmatrix}", None),
    ],
)
def test_only_brackets_around_something_high_grow(latex: str, stretchy: str | None) -> None:
    assert one(latex, "(").get("stretchy") == stretchy
    assert one(latex, ")").get("stretchy") == stretchy


@pytest.mark.parametrize(
    ("latex", "space"),
    [
        (r"(1,\ -2)", "0"),
        ("(1, -2)", "0"),
        (r"1\ - 2", None),
        (r"1, \frac{a}{b} - 2", None),
        (r"1, \text{x} - 2", None),
    ],
)
def test_a_sign_stands_close_to_its_number(latex: str, space: str | None) -> None:
    sign = one(latex, "−")
    assert (sign.get("lspace"), sign.get("rspace")) == (space, space)


def test_words_are_no_space() -> None:
    assert one(r"\text{frame} = 3", "frame").tag == "mi"
    assert one(r"\text{a} = 3", "a").get("mathvariant") == "normal"


def test_an_accent_stands_on_the_letter_that_is_shown() -> None:
    assert "\U0001d713" in drawn(r"\dot{\psi}")


def test_a_bar_is_none_that_hangs_on_the_letter_before() -> None:
    assert drawn(r"\overline{a}") == "\U0001d44e\u203e"


def test_a_box_is_left_to_the_style_sheet() -> None:
    assert '<mrow class="boxed"><mrow>' in mathml(r"x = \boxed{\cos y}", display=True)
    assert "menclose" not in mathml(r"x = \boxed{\cos y}", display=True)
