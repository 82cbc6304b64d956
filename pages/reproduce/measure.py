"""Make the figures and tables of both sources again: ``python -m pages.reproduce.measure [2.12 3.4 ...]``.

All of them unless some are named. Draws them into docs/figures/reproduced. Figures of example 7 are those
of sniffer.csv in the folder that POINTPRED_RECORDINGS names, and of a stand-in without it.
"""

from __future__ import annotations

from pathlib import Path

from pages import FIGURES
from pages.arguments import parse
from pages.data import Table, keep, stored
from pages.sets import folder_with
from pages.thinning import save
from pointpred.cli.reproduce import AGREES, shown
from pointpred.reproduction.catalogue import ENTRIES
from pointpred.reproduction.figure import Entry, Reproduction
from pointpred_observers.reproduction.reversed_connection import SNIFFER

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
    made_from = dict(stored("reproduce").numbers.get("data", {}))
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
    keep("reproduce", tables, numbers={"data": made_from})


if __name__ == "__main__":
    main(parse(__doc__, metavar="number", choices=[*ENTRIES]))
