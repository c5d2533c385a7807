"""Decimal numbers out of text: what is read is what `float` reads."""

import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from chr_notes.sensors import decimals

PLAIN = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", re.ASCII)
# The same one twice where the kernels are not in use.
WAYS = [decimals.decimals, decimals._by_numpy]  # noqa: SLF001


def read(fields: list[str], way: Callable[..., Any]) -> tuple[list[float], list[bool]]:
    text = np.frombuffer("".join(f"{f}," for f in fields).encode(), np.uint8)
    ends = np.flatnonzero(text == ord(","))
    starts = np.concatenate([[0], ends[:-1] + 1])
    values, done = way(text, starts, ends)
    return values.tolist(), done.tolist()


def assert_right(fields: list[str]) -> None:
    for way in WAYS:
        for text, value, done in zip(fields, *read(fields, way), strict=True):
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


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize(
    "text",
    [
        *("0", "-12.5", "+3", ".5", "5.", "0.000001", "123456789012345", "-0.12345678901234567"),
        *("1.000000000000000000e+01", "-9.80665E-03", "00000000001.50"),
    ],
)
def test_ordinary_numbers_are_read(text: str, way: Callable[..., Any]) -> None:
    values, done = read(["1", text, "2"], way)
    assert done == [True] * 3
    assert values == [1.0, float(text), 2.0]


@pytest.mark.kernels
@pytest.mark.parametrize("text", ["1e5", "1e-300", "0.1234567890123456789012345", "9" * 40, "-0"])
def test_the_kernel_reads_whatever_is_a_number(text: str) -> None:
    values, done = read([text], decimals.decimals)
    assert done == [True]
    assert values == [float(text)]


@pytest.mark.kernels
@pytest.mark.parametrize("text", ["1e400", "-1e99999999999999999999", "1" * 64, "1e", "e5", ""])
def test_the_kernel_leaves_the_rest(text: str) -> None:
    assert read([text], decimals.decimals)[1] == [False]


@pytest.mark.kernels
def test_the_kernel_stays_within_its_text() -> None:
    text, outside = np.frombuffer(b"12", np.uint8), np.array([-1, 0, 1, 2])
    _, done = decimals.decimals(text, outside, np.array([1, 3, 0, 2]))
    assert not done.any()
    with pytest.raises(TypeError, match="expected bytes"):
        decimals.decimals(text, outside, outside[:2])


@pytest.mark.parametrize("way", WAYS)
def test_all_digits_of_doubles_are_read(way: Callable[..., Any]) -> None:
    generator = np.random.default_rng(0)
    fields = [repr(value) for value in generator.normal(0, 10, 20_000).tolist()]
    values, done = read(fields, way)
    assert np.mean(done) > 0.999
    assert values[0] == float(fields[0])
    assert_right(fields)
