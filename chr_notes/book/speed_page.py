"""The page on speed: curves of a stored run, and what of it to use when."""

import json
from collections.abc import Iterator, Mapping
from itertools import cycle
from math import inf
from typing import Any, Final

from matplotlib import pyplot as plt
from matplotlib.ticker import LogLocator, NullLocator

from chr_notes._texts import read
from chr_notes.book import sources
from chr_notes.palette import PALETTE
from chr_notes.plots.figure import line_style, show

__all__ = ["generated"]

SPEED: Final = sources.ORIGIN / "book" / "speed.json"
OURS: Final = "chr_notes"
ONE_AT_A_TIME: Final = ", one at a time"
SCALAR: Final = OURS + ONE_AT_A_TIME
MEMCPY: Final = "memcpy of the result"
PLAIN_NUMPY: Final = "plain NumPy"
TOLD: Final = {1: "1\N{NO-BREAK SPACE}row", 100: "100", 1_000: "1,000", 1_000_000: "10⁶"}
"""Numbers of rows in the table; the curves have all."""
LOOKS: Final = (("z", "y", "s"), ("y", "z", "^"), ("qualified", "alert", "D"), ("ink", "y", "v"))
"""Colour, dashes and marker of other libraries."""
OF_A_STREAM: Final = "samples of a stream "
"""How the tasks begin that take samples one by one, and otherwise "samples "."""
TENTH: Final = 0.1
"""Factors below it have two decimals, so that none reads as zero."""

Times = dict[str, dict[int, float]]


def generated() -> dict[str, str]:
    """Return the text of each part of the page by its file name."""
    run = json.loads(read(SPEED))
    return {
        "speed_choice.md": "\n".join(choice(run)),
        "speed_factors.md": "\n".join(factors(run)),
        "speed_curves.md": "\n".join(curves(run)),
        "speed_filters.md": "\n".join(filters(run)),
        "speed_machine.md": machine(run),
    }


def tasks(run: Mapping[str, Any]) -> dict[str, Times]:
    """Take the nanoseconds a row from a run, by task, library and number of rows.

    Parameters
    ----------
    run
        What `tests/benchmarks/store.py` keeps of a run.
    """
    found: dict[str, Times] = {}
    for row in run["rows"]:
        times = found.setdefault(row["task"], {})
        times.setdefault(row["library"], {})[row["size"]] = row["nanoseconds"]
    return found


def of_rows(run: Mapping[str, Any]) -> dict[str, Times]:
    """Take the tasks that were timed for one row and for many."""
    return {task: times for task, times in tasks(run).items() if SCALAR in times}


def choice(run: Mapping[str, Any]) -> Iterator[str]:
    """Yield which of our functions takes least, by the number of rows."""
    timed = of_rows(run).values()
    sizes = sorted({size for times in timed for size in times[OURS]})
    always = [n for n in sizes if all(t[OURS][n] < t[SCALAR][1] for t in timed)]
    one = [times[SCALAR][1] for times in timed]
    array = [times[OURS][1] for times in timed]
    yield (
        f"For one attitude the functions of plain numbers took {min(one):,.0f} to {max(one):,.0f} "
        f"ns in these runs, those of arrays with one row {min(array):,.0f} to {max(array):,.0f} ns."
    )
    if always:
        yield (
            f"With {always[0]:,} rows those of arrays took less for each row than those of plain "
            "numbers for one, in every task."
        )
    for task, times in of_rows(run).items():
        for name in (name for name in times if name != SCALAR and ONE_AT_A_TIME in name):
            library = name.removesuffix(ONE_AT_A_TIME)
            yield (
                f"In {task} {library} took {times[name][1]:,.0f} ns for its own objects, one at a "
                f"time, and {times[library][1]:,.0f} ns for arrays of one row; ours took "
                f"{times[SCALAR][1]:,.0f} ns for plain numbers and {times[OURS][1]:,.0f} for such "
                "arrays."
            )
    found = {task: next(iter(times[OURS].values())) for task, times in tasks(run).items()}
    for task in (task for task in found if task.startswith(OF_A_STREAM)):
        alike = task.replace(OF_A_STREAM, "samples ")
        yield (
            f"{alike[0].upper()}{alike[1:]}: {found[alike]:,.0f} ns for one of a recording, "
            f"{found[task]:,.0f} ns for one of a stream."
        )


def factor(ratio: float) -> str:
    """Write how many times as long something takes."""
    return f"{ratio:.1f}" if ratio >= TENTH else f"{ratio:.2f}"


def others(times: Times, size: int) -> dict[str, float]:
    """Take the times of the other libraries at a number of rows."""
    own = (OURS, SCALAR, MEMCPY)
    return {name: each[size] for name, each in times.items() if name not in own and size in each}


def factors(run: Mapping[str, Any]) -> Iterator[str]:
    """Yield a table: how many times as long the fastest other library takes, and who is faster.

    Of one attitude the faster of our functions is compared, of plain numbers or of arrays.
    """
    timed = of_rows(run)
    sizes = [n for n in TOLD if all(n in times[OURS] for times in timed.values())]
    yield f"| task | {' | '.join(TOLD[size] for size in sizes)} |\n|---|{'--:|' * len(sizes)}"
    faster: dict[str, list[str]] = {}
    for task, times in timed.items():
        cells = []
        for size in sizes:
            ours = min(times[OURS][size], times[SCALAR].get(size, inf))
            rest = others(times, size)
            cells.append(factor(min(rest.values()) / ours))
            for name in (name for name, time in rest.items() if time < ours):
                faster.setdefault(f"{name} ({task}", []).append(TOLD[size])
        yield f"| {task} | {' | '.join(cells)} |"
    if faster:
        told = (f"{who}: {', '.join(where)})" for who, where in faster.items())
        yield f"\nFaster here than ours: {'; '.join(told)}."


def drawn(run: Mapping[str, Any]) -> dict[str, Times]:
    """Tasks that another library does too, which NumPy by hand is not."""
    by_hand = {OURS, SCALAR, MEMCPY, PLAIN_NUMPY}
    return {task: times for task, times in of_rows(run).items() if times.keys() - by_hand}


def curves(run: Mapping[str, Any]) -> Iterator[str]:
    """Yield a picture for each task that a library does: the time of a call against the rows."""
    for task, times in drawn(run).items():
        figure, axes = plt.subplots(figsize=(4.4, 3.2))
        looks = cycle(LOOKS)
        shown = {name: each for name, each in times.items() if len(each) > 1}
        for name, each in shown.items():
            sizes = sorted(each)
            calls = [each[size] * size / 1000 for size in sizes]
            known = {OURS: ("x", "x", "o"), MEMCPY: ("muted", "z", ".")}
            colour, dash, marker = known.get(name) or next(looks)
            axes.plot(
                sizes, calls, color=PALETTE[colour].light, ls=line_style(dash), marker=marker,
                lw=2.6 if name == OURS else 1.4, ms=5 if name == OURS else 4, label=name,
                markevery=1 if name == OURS else max(1, len(sizes) - 1),
            )  # fmt: skip
        axes.set(xscale="log", yscale="log", xlabel="rows", ylabel="time of a call (µs)")
        for axis in (axes.xaxis, axes.yaxis):  # few marks make small pictures
            axis.set_major_locator(LogLocator(base=100))
            axis.set_minor_locator(NullLocator())
        axes.grid(color=PALETTE["line"].light, lw=0.6)
        axes.legend(fontsize="small")
        last = max(shown[OURS])
        ends = sorted((each[last], name) for name, each in shown.items() if last in each)
        order = ", ".join(name for _, name in ends)
        words = (
            f"Time of a call against the number of rows, both on logarithmic scales, for {task}, a "
            f"line a library. With {last:,} rows, from the shortest time to the longest: {order}."
        )
        yield f"### {task[0].upper()}{task[1:]}\n"
        picture = show(figure, words, nearest(shown))
        yield f'<div class="curves">{picture._repr_html_()}</div>\n'


def nearest(times: Times) -> str:
    """Say which of the others that are drawn comes nearest with fewest and with most rows."""
    ends = []
    for rows in (min(times[OURS]), max(times[OURS])):
        rest = others(times, rows).items()
        time, name = min((time, name) for name, time in rest)
        many = f"{rows:,}\N{NO-BREAK SPACE}row{'s' if rows > 1 else ''}"
        ends.append(f"with {many} {name} takes {factor(time / times[OURS][rows])} times as long")
    told = " and ".join(ends)
    return f"The nearest of the others, arrays against arrays: {told}."


def filters(run: Mapping[str, Any]) -> Iterator[str]:
    """Yield a table of the filters: nanoseconds a sample, and times as long as ours."""
    yield ":::{div} speed\n| task | filter | ns a sample | times as long |\n|---|---|--:|--:|"
    for task, times in tasks(run).items():
        if SCALAR not in times:
            for place, (name, each) in enumerate(times.items()):
                ((size, time),) = each.items()
                ratio = factor(time / times[OURS][size])
                yield f"| {'' if place else task} | {name} | {time:,g} | {ratio} |"
    yield ":::"


def machine(run: Mapping[str, Any]) -> str:
    """Say what was timed where."""
    libraries = ", ".join(f"{name} {version}" for name, version in run["libraries"].items())
    return (
        f"Timed on {run['cpu']}, {run['vector_instructions']}, one thread, {run['system']}, "
        f"Python {run['python']}, {libraries}. "
        f"Each time is the shortest of {run['rounds']} rounds or more.\n"
    )
