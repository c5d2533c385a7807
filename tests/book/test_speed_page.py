"""The page on speed says what the stored run holds, whatever that is."""

import json
from typing import Any

from chr_notes.book import speed_page
from chr_notes.book.speed_page import MEMCPY, ONE_AT_A_TIME, OURS, SCALAR

STORED = json.loads(speed_page.SPEED.read_text(encoding="utf-8"))


def made_up() -> dict[str, Any]:
    rows = [
        {"size": size, "task": "turns", "library": library, "nanoseconds": time}
        for size, times in {
            1: {SCALAR: 100.0, OURS: 150.0, "A": 400.0, "B": 300.0, f"B{ONE_AT_A_TIME}": 50.0},
            100: {OURS: 90.0, "A": 45.0, "B": 4.5, MEMCPY: 1.0},
            1000: {OURS: 10.0, "A": 40.0, "B": 20.0, MEMCPY: 1.0},
        }.items()
        for library, time in times.items()
    ]
    rows += [
        {"size": 9, "task": "a filter", "library": library, "nanoseconds": time}
        for library, time in ((OURS, 80.0), ("C", 200.0))
    ]
    rows += [
        {"size": 9, "task": f"samples {of}shaken", "library": OURS, "nanoseconds": time}
        for of, time in (("", 70.0), ("of a stream ", 1234.0))
    ]
    return {
        "rows": rows,
        "cpu": "a processor",
        "vector_instructions": "none",
        "system": "a system",
        "python": "3",
        "rounds": 4,
        "libraries": {"A": "1.0"},
    }


def test_a_run_told() -> None:
    run = made_up()
    one, many = "1\N{NO-BREAK SPACE}row", "1,000\N{NO-BREAK SPACE}rows"
    _, row, faster = speed_page.factors(run)
    assert row == "| turns | 0.5 | 0.05 | 2.0 |"
    assert faster.strip() == (
        f"Faster here than ours: B, one at a time (turns: {one}); A (turns: 100); B (turns: 100)."
    )
    first, then, single, streamed = speed_page.choice(run)
    assert "took 100 to 100 ns in these runs, those of arrays with one row 150 to 150 ns" in first
    assert then.startswith("With 100 rows")
    assert single == (
        "In turns B took 50 ns for its own objects, one at a time, and 300 ns for arrays of one "
        "row; ours took 100 ns for plain numbers and 150 for such arrays."
    )
    assert streamed == (
        "Samples shaken: 70 ns for one of a recording, 1,234 ns for one of a stream."
    )
    (filtered,) = [line for line in speed_page.filters(run) if "C" in line]
    assert filtered == "|  | C | 200 | 2.5 |"
    title, picture = speed_page.curves(run)
    assert title == "### Turns\n"
    assert f"the shortest time to the longest: {MEMCPY}, {OURS}, B, A." in picture
    near = f"with {one} B takes 2.0 times as long and with {many} B takes 2.0 times as long."
    told = f"The nearest of the others, arrays against arrays: {near}"
    assert f"<figcaption>{told}</figcaption>" in picture
    assert speed_page.machine(run) == (
        "Timed on a processor, none, one thread, a system, Python 3, A 1.0. "
        "Each time is the shortest of 4 rounds or more.\n"
    )


def test_of_one_attitude_the_faster_of_ours_counts() -> None:
    run = made_up()
    run["rows"][1]["nanoseconds"] = 40.0
    assert "| turns | 1.2 |" in list(speed_page.factors(run))[1]


def test_where_arrays_never_take_less_nothing_is_said_of_it() -> None:
    run = made_up()
    for row in run["rows"]:
        if row["library"] == OURS:
            row["nanoseconds"] = 1e6
    assert len(list(speed_page.choice(run))) == 3


def test_the_page_names_those_that_are_faster() -> None:
    *table, last = speed_page.factors(STORED)
    start = "Faster here than ours: "
    told = last.strip().removeprefix(start).rstrip(".").split("; ") if start in last else []
    named = {}
    for who, sizes in (each.rstrip(")").split(": ") for each in told):
        named[who] = sizes.split(", ")
    times = {(r["task"], r["library"], r["size"]): r["nanoseconds"] for r in STORED["rows"]}
    faster: dict[str, list[str]] = {}
    for (task, library, size), time in times.items():
        if size not in speed_page.TOLD or task not in speed_page.of_rows(STORED):
            continue
        if library not in (OURS, SCALAR, MEMCPY):
            ours = times[task, SCALAR if size == 1 else OURS, size]
            own = faster.setdefault(f"{library} ({task}", [])
            own += [speed_page.TOLD[size]] if time < ours else []
    assert named == {who: sizes for who, sizes in faster.items() if sizes}
    assert len(table) >= len(speed_page.of_rows(STORED))


def test_the_stored_run_is_the_one_of_the_page() -> None:
    parts = speed_page.generated()
    assert STORED["cpu"] in parts["speed_machine.md"]
    drawn = {line[4:] for line in parts["speed_curves.md"].splitlines() if line.startswith("### ")}
    assert drawn == {f"{task[0].upper()}{task[1:]}" for task in speed_page.drawn(STORED)}
    for row in STORED["rows"]:
        if row["task"] not in speed_page.of_rows(STORED):
            assert f"| {row['library']} | {row['nanoseconds']:,g} |" in parts["speed_filters.md"]
