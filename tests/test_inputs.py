"""What the functions of attitudes take and refuse: shapes, types, zeros, NaN, layout, memory."""

import tracemalloc
from collections.abc import Callable
from fractions import Fraction

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from numpy.typing import NDArray

import chr_notes
from chr_notes._rows import BLOCK

from .functions import EULER, FUNCTIONS, Function, P, Q

Floats = NDArray[np.float64]


every = pytest.mark.parametrize("function", FUNCTIONS.values(), ids=FUNCTIONS)
with_zero = pytest.mark.parametrize(
    "function",
    [f for f in FUNCTIONS.values() if f.zero],
    ids=[n for n, f in FUNCTIONS.items() if f.zero],
)


def assert_same(first: list[Floats], second: list[Floats], tolerance: float = 1e-15) -> None:
    for one, other in zip(first, second, strict=True):
        assert one.shape == other.shape
        assert one.dtype == np.float64
        assert_allclose(one, other, rtol=tolerance, atol=tolerance)


@every
def test_one_attitude_and_many_give_the_same(function: Function) -> None:
    arguments = function.many(5)
    together = function(*arguments)
    for row in range(5):
        assert_same(function(*(a[row] for a in arguments)), [r[row] for r in together])


@every
@pytest.mark.parametrize("leading", [(), (1,), (0,), (2, 3), (3, 0, 2), (2, 1, 3)])
def test_leading_axes_are_kept(function: Function, leading: tuple[int, ...]) -> None:
    arguments = [
        np.broadcast_to(value, (*leading, *np.shape(value))) for value in function.given.values()
    ]
    one = function(*function.given.values())
    for result, single in zip(function(*arguments), one, strict=True):
        assert result.shape == (*leading, *single.shape)
        assert_allclose(result, np.broadcast_to(single, result.shape), rtol=1e-15, atol=1e-15)


@every
def test_leading_axes_broadcast(function: Function) -> None:
    if len(function.given) == 1:
        return
    first, second = (np.asarray(value) for value in function.given.values())
    spread = function(
        np.broadcast_to(first, (4, 1, *first.shape)), np.broadcast_to(second, (5, *second.shape))
    )
    assert spread[0].shape[:2] == (4, 5)
    names = " and ".join(function.given)
    with pytest.raises(ValueError, match=f"expected {names} with leading axes that broadcast"):
        function(np.stack([first] * 2), np.stack([second] * 3))


@every
def test_a_wrong_shape_states_both(function: Function) -> None:
    for place, (name, value) in enumerate(function.given.items()):
        shape = np.shape(value)
        if not shape:
            continue
        arguments = list(function.given.values())
        sizes = ", ".join(map(str, shape))
        for wrong in (np.ones((2, 5)), np.ones(()), np.ones((0,))):
            arguments[place] = wrong
            expected = f"{name}: expected shape (..., {sizes}), got {wrong.shape}"
            with pytest.raises(ValueError, match=r"^" + _escaped(expected) + "$"):
                function(*arguments)


def _escaped(text: str) -> str:
    return "".join(f"\\{letter}" if letter in "().," else letter for letter in text)


@with_zero
@pytest.mark.parametrize("place", [0, 3, 2 * BLOCK + 1])
def test_a_row_of_zeros_is_refused_by_its_index(function: Function, place: int) -> None:
    arguments = function.many(2 * BLOCK + 4)
    arguments[0][[place, 2 * BLOCK + 3]] = 0
    message = rf"^{function.zero}: expected no row of zeros, got one at index \({place},\)$"
    with pytest.raises(ValueError, match=message):
        function(*arguments)
    with pytest.raises(ValueError, match=r"index \(\)$"):
        function(*(a[place] for a in arguments))


@with_zero
@pytest.mark.parametrize("factor", [1e-320, 1e-290, 1e-100, -1.0, 1e100, 1e300])
def test_length_does_not_matter(function: Function, factor: float) -> None:
    if function.call is chr_notes.quaternion_inverse:
        return
    first, *rest = function.many(7)
    # A power of two near the factor scales exactly, unless digits of a denormal number are lost.
    power = np.copysign(2.0 ** np.round(np.log2(np.abs(factor))), factor)
    scaled = function(first * power, *rest)
    kept = first * power / power
    if factor < 0 and function.zero == "axis":
        kept = -kept
    assert_same(scaled, function(kept, *rest), 1e-14)


@with_zero
def test_length_costs_no_digit(function: Function) -> None:
    first, *rest = function.given.values()
    argument = np.array([3.7, -2.1, 1.3, 4.9])[: len(first)]
    expected = function(argument, *rest)
    degree = -1 if function.call is chr_notes.quaternion_inverse else 0
    # A power of two scales exactly, as long as no number becomes a denormal one.
    for power in range(-1020, 1021, 7):
        results = function(np.ldexp(argument, power), *rest)
        for one, other in zip(results, expected, strict=True):
            assert_allclose(np.ldexp(one, -degree * power), other, rtol=1e-15, atol=1e-15)


def test_inverse_of_quaternions_of_any_length() -> None:
    for factor in (1e-300, 1e-150, 1.0, 1e150, 1e300):
        q = factor * np.array([Q, P])
        product = chr_notes.quaternion_multiply(q, chr_notes.quaternion_inverse(q))
        assert_allclose(product, [[1, 0, 0, 0]] * 2, atol=1e-14)


@pytest.mark.parametrize("name", ["euler_from_matrix", "quaternion_from_matrix"])
def test_matrices_that_are_no_rotations_are_refused(name: str) -> None:
    function = FUNCTIONS[name]
    good = function.many(2 * BLOCK)[0]
    for wrong in (
        np.zeros((3, 3)),
        np.ones((3, 3)),
        1.001 * np.eye(3),
        -np.eye(3),
        np.eye(3)[[1, 0, 2]],
    ):
        matrices = good.copy()
        matrices[[BLOCK + 2, BLOCK + 9]] = wrong
        message = rf"^matrix: expected rotations .* got one at index \({BLOCK + 2},\)"
        with pytest.raises(ValueError, match=message):
            function(matrices)
    # Four digits, as books print.
    function(np.round(good, 4))


# Matrices whose R Rᵀ is off the identity by a root mean square of so much.
NOT_QUITE: dict[str, Callable[[float], Floats]] = {
    "rows too long": lambda off: np.sqrt(1 + np.sqrt(3) * off) * np.eye(3),
    "rows too short": lambda off: np.sqrt(1 - np.sqrt(3) * off) * np.eye(3),
    "one row too long": lambda off: np.diag([1, np.sqrt(1 + 3 * off), 1]),
    "rows not at right angles": lambda off: np.array(
        [[1, 0, 0], [3 * off / np.sqrt(2), np.sqrt(1 - 9 * off**2 / 2), 0], [0, 0, 1]]
    ),
}


@pytest.mark.parametrize("matrix", NOT_QUITE.values(), ids=NOT_QUITE)
@pytest.mark.parametrize("name", ["euler_from_matrix", "quaternion_from_matrix"])
def test_a_matrix_may_be_off_by_a_ten_thousandth(
    name: str, matrix: Callable[[float], Floats]
) -> None:
    turned = chr_notes.matrix_from_euler(EULER)
    FUNCTIONS[name](matrix(0.95e-4) @ turned)
    with pytest.raises(ValueError, match=r"R Rᵀ off by 0\.00011 "):
        FUNCTIONS[name](matrix(1.1e-4) @ turned)


@every
@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_what_is_no_number_stays_in_its_row_and_is_silent(function: Function, bad: float) -> None:
    count = 2 * BLOCK
    clean = function(*function.many(count))
    for place in range(len(function.given)):
        arguments = function.many(count)
        arguments[place].reshape(count, -1)[BLOCK + 3, 0] = bad
        if bad == np.inf and "matrix" in function.given:
            # R Rᵀ is not the identity, by any amount.
            with pytest.raises(ValueError, match="expected rotations"):
                function(*arguments)
            continue
        others = np.arange(count) != BLOCK + 3
        for result, expected in zip(function(*arguments), clean, strict=True):
            assert_array_equal(result[others], expected[others])
        if np.isnan(bad):
            assert not all(np.isfinite(r[~others]).all() for r in function(*arguments))


@every
def test_integers_lists_float32_and_fractions(function: Function) -> None:
    arguments = [np.asarray(a, dtype=np.float64) for a in function.many(3)]
    single = [a.astype(np.float32) for a in arguments]
    if "matrix" not in function.given:
        exact = [np.round(4 * a) for a in arguments]
        expected = function(*exact)
        assert_same(function(*(a.astype(int) for a in exact)), expected)
        assert_same(function(*(a.astype(int).tolist() for a in exact)), expected)
        assert_same(function(*(a.astype(np.int8) for a in exact)), expected)
        quarters = [np.vectorize(Fraction, otypes=[object])(a) / 4 for a in exact]
        assert_same(function(*quarters), function(*(a / 4 for a in exact)))
    assert_same(function(*single), function(*(a.astype(np.float64) for a in single)))
    assert_same(function(*(a.tolist() for a in arguments)), function(*arguments))


@every
def test_what_is_masked_out_is_no_number(function: Function) -> None:
    if "matrix" in function.given:
        return
    first, *rest = (np.asarray(a, dtype=np.float64) for a in function.many(3))
    masked = np.ma.masked_array(first, mask=np.zeros(first.shape, dtype=bool))
    assert_same(function(masked, *rest), function(first, *rest))
    masked[1, ...] = np.ma.masked
    first[1] = np.nan
    for result, expected in zip(function(masked, *rest), function(first, *rest), strict=True):
        assert_array_equal(result, expected)
        assert not np.isfinite(result[1]).all()


@every
def test_one_attitude_gives_a_scalar_or_an_array(function: Function) -> None:
    for result in function(*function.given.values()):
        assert type(result) is (np.ndarray if result.ndim else np.float64)


@every
def test_complex_numbers_and_words_are_refused(function: Function) -> None:
    arguments = [np.asarray(a) for a in function.given.values()]
    with pytest.raises(TypeError, match="expected real numbers, got complex128"):
        function(arguments[0] + 0j, *arguments[1:])
    with pytest.raises(TypeError, match="expected real numbers, got"):
        function(np.full(arguments[0].shape, "0.5"), *arguments[1:])
    with pytest.raises(TypeError, match="expected real numbers, got None at index"):
        function(np.full(arguments[0].shape, None), *arguments[1:])


@every
def test_arguments_of_any_layout_are_read_and_not_changed(function: Function) -> None:
    count = BLOCK + 3
    arguments = function.many(count)
    expected = function(*arguments)
    layouts: list[Callable[[Floats], Floats]] = [
        np.asfortranarray,
        lambda a: np.repeat(a, 2, axis=0)[::2],
        lambda a: a[::-1].copy()[::-1],
        lambda a: np.repeat(a[..., np.newaxis], 2, axis=-1)[..., 0],
        lambda a: a.astype(">f8"),
    ]
    for layout in layouts:
        laid_out = [layout(a) for a in arguments]
        for argument in laid_out:
            argument.flags.writeable = False
        assert_same(function(*laid_out), expected)
        for argument, original in zip(laid_out, arguments, strict=True):
            assert_array_equal(argument, original)


def unaligned(array: Floats) -> Floats:
    """Lay it out as it stands in a file behind a head of any length."""
    return np.frombuffer(b"-" + array.tobytes(), offset=1).reshape(array.shape)


@pytest.mark.kernels
@every
def test_numbers_at_any_place_of_a_file_give_the_same_bits(function: Function) -> None:
    arguments = function.many(50)
    got = function(*map(unaligned, arguments))
    for one, other in zip(got, function(*arguments), strict=True):
        assert_array_equal(one, other)


@pytest.mark.parametrize("large", [10**400, Fraction(10**400)], ids=["integer", "fraction"])
def test_a_number_that_is_too_large_is_refused_by_its_name(large: int | Fraction) -> None:
    with pytest.raises(ValueError, match=r"^euler: expected numbers below .*at index \(1,\)$"):
        chr_notes.matrix_from_euler([0, large, 0])  # type: ignore[list-item]


def test_wider_numbers_become_ordinary_ones_in_silence() -> None:
    with np.errstate(all="ignore"):  # where long double is double
        wide = np.longdouble(10) ** np.array([0, 400, -400])
    with np.errstate(all="raise"):
        assert_array_equal(chr_notes.wrap_angle(wide), [1, np.nan, 0])


@every
def test_results_are_new_arrays_in_c_order(function: Function) -> None:
    arguments = function.many(4)
    for result in function(*arguments):
        assert result.flags.c_contiguous
        assert result.flags.writeable
        assert not any(np.shares_memory(result, argument) for argument in arguments)


@every
@pytest.mark.parametrize("kind", [np.float64, np.float32])
def test_memory_beyond_input_and_output_does_not_grow(function: Function, kind: type) -> None:
    arguments = [a.astype(kind) for a in function.many(1_000_000)]
    tracemalloc.start()
    try:
        results = function(*arguments)
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    # Numbers of another type are converted as a whole.
    copies = sum(8 * a.size for a in arguments) if kind is not np.float64 else 0
    if len(results) > 1:  # computed side by side, then taken apart
        copies += sum(result.nbytes for result in results)
    assert peak - copies - sum(result.nbytes for result in results) < 8_000_000
