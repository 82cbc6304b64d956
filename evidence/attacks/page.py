"""The numbers of the attacks, one file a command that measures."""

from __future__ import annotations

from typing import Any

import msgspec

from evidence.data import Table, Tables, file_of, read, stored
from tests.fuzz.corpus import corpus

COLUMNS = (
    "parser",
    "inputs",
    "seconds",
    "edges",
    "memory, MiB",
    "inputs kept",
    "breaches",
)


class Run(msgspec.Struct, frozen=True):
    """What a fuzzer did with one parser."""

    seconds: int
    executions: int
    edges: int
    most_mib: int
    """Of the whole process."""
    breaches: int
    date: str
    machine: str


def context() -> dict[str, Any]:
    """Every table of the page, and the limits that it names."""
    parts = ("conformance", "attacked")
    return {"fuzz": fuzzed(), **{part: stored("attacks", part) for part in parts}}


def fuzzed() -> Tables:
    """The runs of the fuzzer as a table, and their sums."""
    runs = read(file_of("attacks", "fuzz"), dict[str, Run])
    rows = [[name, *map(str, _numbers(name, run))] for name, run in runs.items()]
    sums = {
        "executions": sum(run.executions for run in runs.values()),
        "minutes": sum(run.seconds for run in runs.values()) // 60,
        "breaches": sum(run.breaches for run in runs.values()),
        "largest": max(runs, key=lambda name: runs[name].most_mib),
        "most_mib": max(run.most_mib for run in runs.values()),
        "date": max(run.date for run in runs.values()),
    }
    machine = next(iter(runs.values())).machine
    return Tables({"fuzz": Table.of(COLUMNS, rows)}, machine, sums)


def _numbers(name: str, run: Run) -> tuple[int, ...]:
    """One line of the table, without its name."""
    return run.executions, run.seconds, run.edges, run.most_mib, len(corpus(name)), run.breaches
