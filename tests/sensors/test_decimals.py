"""Decimal numbers out of text: what is read is what `float` reads."""

import re

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from chr_notes.sensors.decimals import PADDING, decimals

PLAIN = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]\d\d)?", re.ASCII)


def read(fields: list[str]) -> tuple[list[float], list[bool]]:
    text = np.frombuffer(b"7" * PADDING + "".join(f"{f}," for f in fields).encode(), np.uint8)
    ends = np.flatnonzero(text == ord(","))
    starts = np.concatenate([[PADDING], ends[:-1] + 1])
    values, done = decimals(text, starts, ends)
    return values.tolist(), done.tolist()


def assert_right(fields: list[str]) -> None:
    for text, value, done in zip(fields, *read(fields), strict=True):
        if done:
            assert PLAIN.fullmatch(text), text
            assert np.array([value]).tobytes() == np.array([float(text)]).tobytes(), text


letters = st.text("0123456789.-+eE _,x".replace(",", ""), max_size=28)
numbers = st.floats(allow_nan=False, allow_infinity=False)
texts = st.one_of(
    letters,
    numbers.map(repr),
    st.tuples(numbers, st.integers(0, 19)).map(lambda pair: f"{pair[0]:.{pair[1]}e}"),
    st.tuples(st.floats(-1e6, 1e6), st.integers(0, 19)).map(lambda pair: f"{pair[0]:.{pair[1]}f}"),
    st.integers(-(10**25), 10**25).map(str),
    # Halfway between two doubles, and beside it.
    st.tuples(st.integers(2**53, 2**54), st.integers(-1, 1)).map(
        lambda p: str(4 * p[0] + 2 + p[1])
    ),
)


@given(st.lists(texts, min_size=1, max_size=40))
@example(["", ".", "-", "+.", "1.2.3", "1-2", "1e5", "e+05", "1e+0x", "0x10", "1_000", "-0", "5."])
@example(["9007199254740993", "18446744073709551616", "0.1234567890123456789012345"])
def test_what_is_read_is_right(fields: list[str]) -> None:
    assert_right(fields)


@pytest.mark.parametrize(
    "text",
    [
        *("0", "-12.5", "+3", ".5", "5.", "0.000001", "123456789012345", "-0.12345678901234567"),
        *("1.000000000000000000e+01", "-9.80665E-03", "00000000001.50"),
    ],
)
def test_ordinary_numbers_are_read(text: str) -> None:
    values, done = read(["1", text, "2"])
    assert done == [True] * 3
    assert values == [1.0, float(text), 2.0]


def test_all_digits_of_doubles_are_read() -> None:
    generator = np.random.default_rng(0)
    fields = [repr(value) for value in generator.normal(0, 10, 20_000).tolist()]
    values, done = read(fields)
    assert np.mean(done) > 0.999
    assert_right(fields)
    assert values[0] == float(fields[0])
