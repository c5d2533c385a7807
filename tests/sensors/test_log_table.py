"""Text of logs as it comes: what is read is right, what is not names line and column."""

import io
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from chr_notes.sensors.log_table import Table, read_text

HEAD = "t,ax,ay,az\n"
ROWS = np.array([[0.0, 0.01, -0.02, 9.8], [0.01, 0.015, -1.5e-3, 9.81], [0.02, 0.1, 0.2, 9.79]])


def table(text: str | bytes) -> Table:
    file = io.StringIO(text) if isinstance(text, str) else io.BytesIO(text)
    return read_text(file, None)


def written(delimiter: str = ",", end: str = "\n", decimal: str = ".", head: str = HEAD) -> str:
    lines = [head.strip().replace(",", delimiter)]
    lines += [delimiter.join(repr(v).replace(".", decimal) for v in row) for row in ROWS.tolist()]
    return end.join(lines) + end


def assert_read(found: Table) -> None:
    assert_array_equal(found.values["time"], ROWS[:, :1])
    assert_array_equal(found.values["accel"], ROWS[:, 1:])


@pytest.mark.parametrize("delimiter", [",", ";", "\t", " ", "|", ", ", "  ", " ; "])
@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_delimiters_and_ends_of_lines(delimiter: str, end: str) -> None:
    assert_read(table(written(delimiter, end)))


@pytest.mark.parametrize("delimiter", [";", "\t", " "])
def test_decimal_commas(delimiter: str) -> None:
    found = table(written(delimiter, decimal=","))
    assert_read(found)
    assert "decimal comma" in found.notes[0]
    with pytest.raises(ValueError, match=r"line 3, column 2 \(ax\): expected a number"):
        table("t;ax;ay;az\n0;0,1;0;1\n1;1.234,5;0;1\n")


@pytest.mark.parametrize(
    "encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be", "utf-32", "latin-1"]
)
def test_encodings(encoding: str) -> None:
    head = "t,ax (m/s²),ay (m/s²),az (m/s²)"
    found = table(written(head=head).encode(encoding))
    assert_read(found)
    assert found.selected["accel"].unit == "m/s^2"


@pytest.mark.parametrize(
    "text",
    [
        "Logger 3\nserial,17\n\n" + written(),
        "# a comment\n" + written(),
        "# " + written(),
        written().replace("\n0.01", "\n# here\n\n0.01"),
        written().replace("\n", "\n\n"),
        '"' + written().replace(",", '","').replace("\n", '"\n"')[:-1],
        "s,m/s^2,m/s^2,m/s^2\n".join(written().split("\n", 1)).replace(HEAD.strip(), HEAD),
        written().replace("\n0.", ",\n0.").replace("az,", "az").rstrip("\n") + ",\n",
        written()[:-1],
    ],
)
def test_what_stands_around_numbers(text: str) -> None:
    assert_read(table(text))


def test_a_row_that_is_commented_out_is_none() -> None:
    text = "t,ax,ay,az\n0,1,2,3\n#1,4,5,6\n 2,7,8,9\n"
    assert_array_equal(table(text).values["accel"], [[1, 2, 3], [7, 8, 9]])
    text = "note,ax,ay,az\na,1,2,3\n  # b,4,5,6\n50%,7,8,9\n"
    assert_array_equal(table(text).values["accel"], [[1, 2, 3], [7, 8, 9]])


def test_columns_of_text_are_passed_over() -> None:
    text = 't,note,ax,ay,az\n0,"a, b",1,2,3\n0.01,c;d,1,2,3\n'
    assert_array_equal(table(text).values["accel"], [[1, 2, 3], [1, 2, 3]])


@pytest.mark.parametrize("missing", ["", "nan", "NaN", "NA", "null", "None", '""', " "])
def test_missing_numbers_are_nan(missing: str) -> None:
    found = table(HEAD + f"0,1,{missing},3\n1,4,5,{missing}\n")
    assert_array_equal(found.values["accel"], [[1, np.nan, 3], [4, 5, np.nan]])


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", r"line 1, column 1: expected a line with the names"),
        ("\n\n", r"line 1, column 1: expected a line with the names"),
        ("1,2,3\n4,5,6\n", r"line 1, column 1: .* pass columns=\[names\]"),
        (HEAD, r"line 2, column 1: expected rows of numbers, got the end"),
        (HEAD + "0,1,2,3\n1,4,x,6\n", r"line 3, column 3 \(ay\): expected a number, got 'x'"),
        (HEAD + "0,1,2,3\n1,4,5\n2,1,2,3\n", r"line 3, column 3: expected 4 fields, got 3"),
        (HEAD + "0,1,2,3\n1,4,5,6,7\n", r"line 3, column 5: expected 4 fields, got 5"),
        (HEAD + "12:00:00.5,1,2,3\n", "got '12:00:00.5', a time of day: put its date before it"),
        (HEAD + "0,1,inf,3\n", r"line 2, column 3 \(ay\): expected a number, got 'inf'"),
        (HEAD + "0,1,1e999,3\n", r"line 2, column 3 \(ay\): .*'1e999'"),
        (HEAD + "0,1,1e300,3\n", r"line 2, column 3 \(ay\): expected a reading, got 1e\+300"),
        (HEAD + "0,1,'2,3\n", r"line 2, column 3 \(ay\): expected a number, got \"'2\""),
        (HEAD + "0,1,1_0,3\n", r"line 2, column 3 \(ay\): expected a number, got '1_0'"),
        (HEAD + "0,1,0x1A,3\n", r"line 2, column 3 \(ay\): expected a number, got '0x1A'"),
        (HEAD + "0,1,1 2,3\n", r"line 2, column 3 \(ay\): expected a number, got '1 2'"),
        (HEAD + "0,1,١,3\n", r"line 2, column 3 \(ay\): expected a number"),
        (HEAD + "#\n\n0,1,2,3\n\n1,1,?,3\n", r"line 6, column 3 \(ay\)"),
        (HEAD + "0,1,2,3\nt,ax,ay,az\n", r"line 3, column 1 \(t\): expected a number, got 't'"),
        ("\x00\x01\x02\x03" * 90, r"line 1, column 1: expected text, got a byte 0"),
        ("ax,ay\n1,2\n", r"line 1, column 1: accel: expected columns for x, y and z"),
        (HEAD + "0,1,2,3\n" * 9 + "1" * 3_000_000, r"line 11, column 1: .* got one of over a meg"),
        (HEAD + "# a,b,c,d\n0,1,2,3\n0,1,?,3\n", r"line 4, column 3 \(ay\)"),
        ("x" * 2_000_000, r"line 1, column 1: expected lines of text, got one of over a megabyte"),
    ],
)
def test_what_is_no_log_is_refused_by_line_and_column(text: str, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        table(text)


def test_a_last_line_that_was_cut_is_left_out_or_told() -> None:
    whole = HEAD + "0,1,2,3\n0.01,1,2,3\n"
    found = table(whole + "0.02,1,")
    assert len(found.values["accel"]) == 2
    assert found.warnings == ("line 4, the last, has 3 of 4 fields and no end: left out",)
    assert "its last number may be cut" in table(whole + "0.02,1,2,3").warnings[0]


def test_long_times_lose_nothing() -> None:
    for stamps in (
        [1617181723123456789, 1617181723133456789, 1617181723143456790],
        ["1617181723.123456789", "1617181723.133456789", "1617181723.14345679"],
    ):
        found = table(HEAD + "".join(f"{stamp},1,2,3\n" for stamp in stamps))
        unit = 1e9 if isinstance(stamps[0], int) else 1.0
        assert_array_equal(found.values["time"][:, 0], np.array([0, 0.01, 0.020000001]) * unit)


def test_dates_are_counted_in_seconds() -> None:
    days = ["2024-02-29T23:59:59.990", "2024-03-01 00:00:00", "2024-03-01T01:00:00.01+01:00"]
    found = table(HEAD + "".join(f"{day},1,2,3\n" for day in days))
    np.testing.assert_allclose(found.values["time"][:, 0], [0, 0.01, 0.02], rtol=1e-12)
    with pytest.raises(ValueError, match=r"line 3, column 1 \(t\): expected a time as the first"):
        table(HEAD + f"{days[0]},1,2,3\nyesterday,1,2,3\n")


def test_blocks_join(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    values = np.random.default_rng(0).normal(0, 1, (500, 4)).round(5)
    path = tmp_path / "log.csv"
    np.savetxt(path, values, delimiter=",", header=HEAD.strip(), comments="", fmt="%.5f")
    lines = path.read_text(encoding="utf-8").split("\n")
    lines.insert(300, "# here")
    path.write_bytes("\r\n".join(lines).encode())
    monkeypatch.setattr("chr_notes.sensors.log_text._BLOCK", 333)
    found = read_text(path, None)
    assert_array_equal(found.values["accel"], values[:, 1:])
    assert [found.place(row) for row in (0, 298, 299, 499)] == [
        *("line 2", "line 300", "line 302", "line 502")
    ]


def test_names_may_be_given_for_a_file_without() -> None:
    found = read_text(io.StringIO("7;0;1;2;3\n8;1;4;5;6\n"), ["id", "t", "ax", "ay", "az"])
    assert_array_equal(found.values["accel"], [[1, 2, 3], [4, 5, 6]])
    with pytest.raises(ValueError, match=r"line 1, column 1: expected a line of 4 numbers"):
        read_text(io.StringIO("7;0;1;2;3\n"), ["t", "ax", "ay", "az"])
