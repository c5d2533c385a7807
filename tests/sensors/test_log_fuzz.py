"""Damaged logs: an error that names line and column, or right numbers; nothing else."""

import io
import random
import re
import warnings
from collections import Counter
from collections.abc import Callable

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from chr_notes import Recording, read_log
from chr_notes.sensors.log_numbers import MISSING, NUMBER

ROWS = 24
NAMES = ["t_ms", "gx_dps", "gy_dps", "gz_dps", "ax_g", "ay_g", "az_g", "temp_C", "note"]
PLACES = re.compile(
    r"^(line \d+(, column \d+|:)|time: |rate: |accel: |gyro: |axes: )", re.MULTILINE
)
TOKENS = (
    *("", "nan", "inf", "-inf", "1e999", "-", "abc", "1e5", "0x1F", "1_0", "1.2.3", "1,5", "--1"),
    *(
        "9" * 400,
        "1e-400",
        "\u0661",
        "NaN",
        '"',
        '"1"',
        "\x00",
        "\ufffd",
        "#",
        "99999999999999999999",
    ),
)


def table(generator: random.Random) -> tuple[list[list[str]], str, str]:
    """A log in one of the ways in which people write them."""
    rows = [[*NAMES]]
    for n in range(ROWS):
        row = [
            f"{10 * n}",
            *(f"{generator.gauss(0, 2):.{generator.randrange(1, 12)}f}" for _ in "xyz"),
        ]
        row += [f"{generator.gauss(m, 0.002):.17g}" for m in (0, 0, 1)]
        rows.append([*row, f"{generator.uniform(15, 30):.2e}", "ok"])
    return rows, generator.choice(",;\t|"), generator.choice(["\n", "\r\n", "\r"])


def written_otherwise(generator: random.Random, rows: list[list[str]]) -> bytes:
    """The same numbers in another of the ways in which programs write them."""
    delimiter = generator.choice([",", ";", "\t", "|", " "])
    comma, padded = generator.random() < 0.5, generator.choice(["", "", " ", "  "])
    quotes = generator.choice([0.0, 0.0, 0.2, 1.0])
    lines = []
    for number, row in enumerate(rows):
        fields = [each.replace(".", ",") if comma and number else each for each in row]
        fields = [
            f'"{each}"' if delimiter in each or generator.random() < quotes else each
            for each in fields
        ]
        lines.append(f"{padded}{delimiter}{padded}".join(fields))
        if generator.random() < 0.1:
            lines.append(generator.choice(["", "# by ax", "% 1,2,3", "  "]))
    if not generator.randrange(4):
        lines.insert(0, generator.choice(["# by me", "Logger 3", "# ax ay az", ""]))
    end = generator.choice(["\n", "\r\n", "\r"])
    text = end.join(lines) + end
    encoding = generator.choice(["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-32"])
    return text.encode(encoding)


def change_rows(generator: random.Random, rows: list[list[str]]) -> None:
    """Replace, add, remove fields, or rows."""
    row = generator.choice(rows)
    place = generator.randrange(len(row))
    change = generator.randrange(5)
    if change == 0:
        row[place] = generator.choice(TOKENS)
    elif change == 1:
        row.insert(place, generator.choice(TOKENS))
    elif change == 2 and len(row) > 1:
        del row[place]
    elif change == 3:
        rows.insert(generator.randrange(len(rows)), [generator.choice(["# note", "", "x", "1"])])
    else:
        rows[generator.randrange(len(rows))] = [*generator.choice(rows)]


def change_bytes(generator: random.Random, data: bytearray) -> None:
    """Replace, add, remove bytes, or all from a place on."""
    place = generator.randrange(len(data) + 1)
    change = generator.randrange(4)
    if change == 0:
        data[place : place + 1] = [generator.randrange(256)]
    elif change == 1:
        data.insert(place, generator.randrange(256))
    else:
        del data[place : place + generator.randrange(1, 40) if change == 2 else None]


def damaged(generator: random.Random) -> bytes:
    """A log of which something has been changed, in its fields or in its bytes."""
    if generator.random() < 0.02:
        return generator.randbytes(generator.randrange(600))
    rows, delimiter, end = table(generator)
    for _ in range(generator.randrange(3)):
        change_rows(generator, rows)
    text = end.join(delimiter.join(row) for row in rows) + end * generator.randrange(2)
    encoding = generator.choice(["utf-8", "utf-8", "utf-8", "utf-8-sig", "utf-16", "latin-1"])
    data = bytearray(text.encode(encoding, errors="replace"))
    for _ in range(generator.choice([0, 0, 1, 1, 2, 5])):
        change_bytes(generator, data)
    return bytes(data)


def expected(data: bytes) -> list[list[str]] | None:
    """Read it slowly and plainly: the fields of each line, or None for what is not so plain."""
    encoding = "utf-16" if data.startswith(b"\xff\xfe") else "utf-8-sig"
    try:
        text = data.decode(encoding)
    except UnicodeDecodeError:
        return None
    lines = [line for line in re.split(r"\r\n|\r|\n", text) if line.strip()]
    lines = [line for line in lines if not line.strip().startswith(("#", "%", "//"))]
    if '"' in text or not lines:
        return None
    counts = {mark: lines[0].count(mark) for mark in ",;\t|"}
    delimiter = max(counts, key=lambda mark: counts[mark])
    rows = [[field.strip() for field in line.split(delimiter)] for line in lines]
    return rows if rows[0] == NAMES else None


def read(data: bytes) -> Recording | str:
    """Read a damaged log, or give what the error says."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            return read_log(
                io.BytesIO(data), on_contradiction="warn", columns={"time": None}, rate=100.0
            )
        except ValueError as error:
            return str(error)


def assert_stands_there(found: Recording, data: bytes) -> None:
    """Compare a log that is not so plain at least with all numbers that stand in it."""
    text = data.decode("utf-16" if data.startswith(b"\xff\xfe") else "latin-1", "replace")
    numbers = NUMBER.finditer(re.sub(r"(?<=\d),(?=\d)", lambda _: ", ", text))
    there = np.unique([abs(float(each[0])) for each in numbers])
    for readings, factor in ((found.body_rates, np.pi / 180), (found.accel, 9.80665)):
        assert readings is not None
        sizes = np.abs(readings[np.isfinite(readings)]) / factor
        near = np.abs(there - sizes[:, np.newaxis]).min(axis=1)
        assert (near <= 1e-12 * np.maximum(sizes, 1)).all()


def field(text: str) -> float:
    """Read a field as it stands."""
    text = text.replace(",", ".")
    assert NUMBER.fullmatch(text) or text.lower() in MISSING, text
    return np.nan if text.lower() in MISSING else float(text)


def outcome(seed: int) -> str:
    """Read one and judge it: "refused", "read", or "right" where it was compared."""
    data = damaged(random.Random(seed))  # noqa: S311
    found = read(data)
    if isinstance(found, str):
        assert PLACES.search(found), (seed, found)
        return "refused"
    rows = expected(data)
    if rows is None:
        assert_stands_there(found, data)
        return "read"
    assert found.body_rates is not None
    assert found.accel is not None
    assert found.report().units["gyro"] == "deg/s"
    body = rows[1 : len(found.accel) + 1]
    assert len(body) == len(found.accel)
    assert len(rows) - 1 - len(body) <= 1  # a last line that was cut
    numbers = np.array([[field(text) for text in row[1:7]] for row in body])
    signs = [1, -1, -1] if "-" in found.report().axes else [1, 1, 1]
    for readings, values, factor in (
        (found.body_rates, numbers[:, :3], np.pi / 180),
        (found.accel, numbers[:, 3:], 9.80665),
    ):
        assert_allclose(readings, values * factor * signs, rtol=1e-14, err_msg=str(seed))
    return "right"


def test_damaged_logs_are_refused_by_place_or_read_right(
    samples: Callable[[int, int], int], record_property: Callable[[str, object], None]
) -> None:
    outcomes = Counter(outcome(seed) for seed in range(samples(200, 20_000)))
    assert outcomes["right"] > 0.2 * outcomes.total()
    assert outcomes["refused"] > 0.2 * outcomes.total()
    text = ", ".join(f"{count} {what}" for what, count in sorted(outcomes.items()))
    record_property("measured", f"of {outcomes.total()} damaged logs {text}")


def test_what_is_written_otherwise_is_the_same_recording(
    samples: Callable[[int, int], int],
) -> None:
    for seed in range(samples(60, 20_000)):
        generator = random.Random(seed)  # noqa: S311
        rows, _, _ = table(generator)
        plain = "\n".join(",".join(row) for row in rows) + "\n"
        other = written_otherwise(generator, rows)
        one, same = (read_log(io.BytesIO(each)) for each in (plain.encode(), other))
        for name in ("time", "body_rates", "accel", "temperature", "dt"):
            assert_array_equal(getattr(same, name), getattr(one, name), err_msg=str((seed, other)))
        assert same.report().axes == one.report().axes
        assert same.report().warnings == one.report().warnings


@pytest.mark.parametrize("size", [0, 1, 2, 3, 100, 5000])
def test_random_bytes_are_refused(size: int) -> None:
    for seed in range(20):
        with pytest.raises(ValueError, match=r"^line \d+, column \d+: "):
            read_log(io.BytesIO(random.Random(seed).randbytes(size)))  # noqa: S311
