"""Make the figures and tables of both sources again: ``python -m evidence reproduce [2.12 3.4 ...]``.

All of them unless some are named. Draws them into docs/figures/reproduced. Figures of example 7 are those
of sniffer.csv in the folder that POINTPRED_RECORDINGS names, and of a stand-in without it. ``context`` is
what docs/evidence/reproduce.md shows: each figure with its differences, and the values that differ.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import msgspec

from evidence import FIGURES
from evidence.arguments import parse
from evidence.data import Table, keep, stored
from evidence.sets import folder_with
from evidence.thinning import save
from pointpred.cli.reproduce import AGREES, shown
from pointpred.reproduction.catalogue import ENTRIES
from pointpred.reproduction.figure import CAMERA, THESIS, Entry, Reproduction
from pointpred_observers.reproduction.thesis import SNIFFER

DRAWN = FIGURES / "reproduced"
HEADER = ("number", "value", "printed", "ours", "unit", "")


def rows_of(entry: Entry, made: Reproduction) -> list[tuple[str, ...]]:
    """The numbers of one figure, a row a number."""
    return [
        (entry.number, one.name, one.printed or "-", shown(one), one.unit, AGREES[one.agrees])
        for one in made.values
    ]


def main(numbers: list[str]) -> None:
    """Make, draw, keep the numbers."""
    recorded: Path | None = folder_with(SNIFFER)
    made_from = dict(stored("reproduce", "figures").numbers.get("data", {}))
    tables: dict[str, Table] = {}
    for number in numbers or ENTRIES:
        entry = ENTRIES[number]
        if entry.make is None:
            continue
        made = entry.make(recorded if entry.reads == SNIFFER else None)
        rows = [list(row) for row in rows_of(entry, made)]
        tables[number] = Table(list(HEADER), [None] * len(HEADER), rows)
        made_from[number] = made.data
        if made.draw is not None:
            save(made.draw().svg, DRAWN / entry.file_name)
    keep("reproduce", tables, part="figures", numbers={"data": made_from})


class Row(msgspec.Struct, frozen=True):
    """A figure or table that is computed."""

    number: str
    shows: str
    differs: str
    printed: str
    """How many printed numbers agree, of how many."""
    figure: str
    """The drawn figure, relative to docs/figures; empty for a table."""


def _row(number: str, tables: dict[str, Table]) -> Row:
    entry = ENTRIES[number]
    judged = [row[-1] for row in tables[number].rows if row[-1]]
    return Row(
        number,
        entry.shows,
        entry.differs,
        f"{judged.count('agrees')} of {len(judged)}" if judged else "-",
        "" if entry.is_table else f"reproduced/{entry.file_name}",
    )


def context() -> dict[str, Any]:
    """What the template needs."""
    kept = stored("reproduce", "figures")
    computed = {number: entry for number, entry in ENTRIES.items() if entry.make is not None}
    listed = [number for number in computed if number != "camera-table-1"]  # which the observers' page shows
    rows = [row[:-1] for number in listed for row in kept.tables[number].rows if row[-1] == "differs"]
    return {
        "groups": {
            title: [_row(number, kept.tables) for number, entry in computed.items() if entry.source == source]
            for title, source in (("Thesis", THESIS), ("Camera paper", CAMERA))
        },
        "diagrams": [number for number in ENTRIES if number not in computed],
        "different": Table(["number", "value", "printed", "ours", "unit"], [None] * 5, rows),
        "thesis": stored("reproduce", "thesis"),
        "switched": stored("reproduce", "switched"),
        "differentiators": stored("reproduce", "differentiators").tables["differentiators"],
    }


if __name__ == "__main__":
    main(parse(__doc__, metavar="number", choices=[*ENTRIES]))
