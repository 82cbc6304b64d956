"""Measure the service under load: ``python -m evidence costs load``, in some ten minutes.

It needs Linux, a C compiler and two cores: a server has the first, the load generator the last. ``--short``
takes about three minutes and prints its tables without writing the page; ``--before COMMIT`` measures another
build of this repository in turns with this one.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from contextlib import ExitStack
from importlib.metadata import version
from typing import Any

from evidence.costs.load.curves import LOADS, WINDOWS, Overload, Point, Series, curves, knee, overload
from evidence.costs.load.generator import built, recording
from evidence.costs.load.servers import checkout, echo, service
from evidence.data import Table, keep
from evidence.machine import LAST, machine, on_cores
from evidence.rendering import shown

PREDICTORS = ("switched", "kinematic", "kinematic-adaptive")
PREDICTORS_BEFORE = ("switched", "kinematic")
TODAY = "this build"
FULL = {"rounds": 3, "seconds": 1.2, "overload": 30.0}
SHORT = {"rounds": 1, "seconds": 0.6, "overload": 6.0}
SHOWN = "the round with the median p99 is shown"
PACKAGES = ("uvicorn", "uvloop", "websockets", "msgspec")


def several(stack: ExitStack, before: str | None) -> list[Series]:
    """Everything that is measured, its servers started."""
    one = stack.enter_context(service())
    series = [Series(TODAY, stack.enter_context(echo("asgi")), "")]
    series += [Series(TODAY, one, name) for name in PREDICTORS]
    if before is not None:
        old = stack.enter_context(service(root=checkout(before)))
        series += [Series(before, old, name) for name in PREDICTORS_BEFORE]
    return series


def notices(counted: dict[str, int]) -> str:
    """What else a server answered."""
    return ", ".join(f"{count} {name}" for name, count in sorted(counted.items())) or "-"


def knee_table(points: Sequence[Point]) -> Table:
    """The knee of each curve."""
    rows = []
    for key in dict.fromkeys((p.size, p.build, p.name) for p in points):
        size, build, name = key
        of_series = [p for p in points if (p.size, p.build, p.name) == key]
        within, growing = knee(of_series)
        at = [p.server_us for p in of_series if p.clients == within]
        rows.append(
            (
                *(LOADS[size], name, build, f"{within}" if within else "none"),
                f"{growing}" if growing else f"not up to {of_series[-1].clients}",
                f"{at[0]:.1f}" if at else "-",
            )
        )
    heads = ("load", "what", "build", "clients with p99 under 1 ms", "the delay grows from")
    return Table.of((*heads, "server, us a frame"), rows)


def delay_tables(points: Sequence[Point]) -> dict[str, Table]:
    """For each load the delays of this build: a row for each number of clients."""
    tables = {}
    for size in LOADS:
        some = [p for p in points if (p.size, p.build) == (size, TODAY)]
        names = list(dict.fromkeys(p.name for p in some))
        rows = []
        for clients in dict.fromkeys(p.clients for p in some):
            here = {p.name: p for p in some if p.clients == clients}
            cells = [
                f"{here[n].p50_ms:.2f} / {here[n].p99_ms:.2f} / {here[n].p999_ms:.2f}" if n in here else "-"
                for n in names
            ]
            own = max(p.own_share for p in here.values())
            late = max(p.late_ms for p in here.values())
            rows.append((f"{clients}", *cells, f"{100 * own:.0f} %", f"{late:.2f}"))
        tables[f"{size}"] = Table.of(("clients", *names, "generator", "generator late, p99"), rows)
    return tables


def overload_table(rows: Sequence[Overload], seconds: float) -> Table:
    """The p99 of each part of the run."""
    part = seconds / WINDOWS
    heads = [f"{part * i:g} to {part * (i + 1):g} s" for i in range(WINDOWS)]
    cells = [
        (
            row.clients,
            row.build,
            *(f"{value:.0f}" for value in row.p99_ms),
            f"{100 * row.answered:.1f} %",
            f"{row.answers:.2f}",
            f"{row.server_us:.1f}",
            f"{100 * row.own_share:.0f} %",
            notices(row.notices),
        )
        for row in rows
    ]
    last = ("frames answered", "answers a frame", "server, us a frame", "generator", "other answers")
    return Table.of(("clients", "build", *heads, *last), cells)


def measured(lengths: dict[str, Any], before: str | None) -> dict[str, Table]:
    """Everything."""
    with ExitStack() as stack:
        stack.enter_context(on_cores(LAST))
        series = several(stack, before)
        points = curves(series, lengths["rounds"], lengths["seconds"])
        return {
            "knees": knee_table(points),
            **delay_tables(points),
            "overload": overload_table(overload(series, lengths["overload"]), lengths["overload"]),
        }


def main(words: argparse.Namespace) -> None:
    """Measure, and write the page's numbers or print them."""
    built()
    where = machine(load=True)
    tables = measured(SHORT if words.short else FULL, words.before)
    versions = ", ".join(f"{name} {version(name)}" for name in PACKAGES)
    if words.short:
        for name, table in tables.items():
            print(f"\n{name}\n\n{shown(table)}")
        return
    numbers = {
        "recording": recording().name,
        "before": words.before or "",
        "shown": SHOWN,
        **FULL,
    }
    keep("costs", tables, part="load", machine=f"{where}; {versions}", numbers=numbers)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--short", action="store_true", help="three minutes; prints and writes nothing")
    parser.add_argument("--before", metavar="COMMIT", help="another build to measure in turns with this one")
    main(parser.parse_args())
