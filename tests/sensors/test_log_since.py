"""Times of a log counted all at once are those that are counted one by one; so are its words."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_array_equal

from chr_notes.sensors.log_fields import Fields, lines_of_words
from chr_notes.sensors.log_numbers import origin, since
from chr_notes.sensors.log_since import since_first

SECONDS = st.integers(0, 10**9)
ZONES = st.sampled_from(["", "Z", "+02:00", "-0930"])
ODD = ["", "x", "2024-13-01T00:00:00", "2024-02-30 10:00", "1e18", "2024-05-01T24:00:00", "17"]


def together(texts: list[str]) -> Fields:
    letters = np.frombuffer("".join(texts).encode(), dtype=np.uint8)
    ends = np.cumsum([len(text) for text in texts])
    return Fields(letters, np.r_[0, ends[:-1]], ends)


def one_by_one(texts: list[str]) -> list[float | None]:
    first, found = origin(texts[0]), list[float | None]()
    assert first is not None
    for text in texts:
        try:
            found.append(since(first, text))
        except ValueError:
            found.append(None)
    return found


def check(texts: list[str], *, fast: int) -> None:
    first = origin(texts[0])
    assert first is not None
    values, read = since_first(first, together(texts))
    assert read.sum() >= fast
    for value, told, right in zip(values, read, one_by_one(texts), strict=True):
        if told:
            assert value == right, texts


@settings(max_examples=60)
@given(
    st.lists(SECONDS, min_size=2), st.integers(0, 9), ZONES, st.sampled_from("T "), st.booleans()
)
def test_dates(numbers: list[int], digits: int, zone: str, mark: str, odd: bool) -> None:  # noqa: FBT001
    begin = np.datetime64("2024-05-01T00:00:00", "ns")
    moments = [begin + np.timedelta64(100 * each, "ms") for each in numbers]
    cut = 19 + (1 + digits if digits else 0)
    texts = [str(each).replace("T", mark)[:cut] + zone for each in moments]
    check(texts, fast=len(texts))
    check([*texts, *ODD] if odd else texts[::-1], fast=len(texts))


@settings(max_examples=60)
@given(st.lists(SECONDS, min_size=2), st.integers(0, 9))
def test_long_numbers(numbers: list[int], digits: int) -> None:
    whole = [f"{1_700_000_000_000_000_000 + 7_654_321 * each:019d}" for each in numbers]
    texts = [f"{each[: 19 - digits]}.{each[19 - digits :]}" if digits else each for each in whole]
    check(texts, fast=len(texts))
    check([*texts, *ODD, "-" + texts[0], texts[0][:9] + "x" + texts[0][10:]], fast=len(texts))


WORDS = st.text("01.-e\"'é\x0b", min_size=1, max_size=4)
GAPS = st.sampled_from([" ", "\t", "   ", " \t"])


@settings(max_examples=100)
@given(st.lists(st.lists(WORDS, min_size=1, max_size=4), min_size=1, max_size=4), st.data())
def test_words(lines: list[list[str]], data: st.DataObject) -> None:
    pad = st.sampled_from(["", " ", "\t "])
    text = "".join(
        data.draw(pad) + "".join(word + data.draw(GAPS) for word in line) + "\n" for line in lines
    )
    letters = np.frombuffer(text.encode(), dtype=np.uint8)
    found = lines_of_words(letters, len(lines), len(lines[0]))
    even = all(len(line.split()) == len(lines[0]) for line in text.split("\n")[:-1])
    plain = text.isascii() and not any(mark in text for mark in '"\x0b')
    assert (found is not None) == (even and plain)
    if found is not None:
        words = [found.of([*range(len(lines[0]))]).text(place) for place in range(found.ends.size)]
        assert_array_equal(words, text.split())
