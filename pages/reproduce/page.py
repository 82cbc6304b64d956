"""What docs/evidence/reproduce.md shows: each number with its command and its differences, and the values."""

from __future__ import annotations

from typing import Any

import msgspec

from pages.data import Table, stored
from pointpred.reproduction.catalogue import ENTRIES
from pointpred.reproduction.figure import CAMERA, THESIS
from pointpred_observers.reproduction.reversed_connection import SNIFFER


class Row(msgspec.Struct, frozen=True):
    """A line of the map from a number to its command."""

    number: str
    command: str
    shows: str
    differs: str
    printed: str
    """How many printed numbers agree, of how many."""
    figure: str
    """The drawn figure, relative to docs/figures; empty for a table and for a diagram."""


def _row(number: str, tables: dict[str, Table]) -> Row:
    entry = ENTRIES[number]
    verdicts = [row[-1] for row in tables[number].rows] if number in tables else []
    judged = [one for one in verdicts if one]
    named = "FOLDER" if entry.reads == SNIFFER else "FILE"
    option = f" [--recordings {named}]" if entry.reads else ""
    drawn = entry.make is not None and not entry.is_table
    return Row(
        number,
        f"pointpred reproduce {number}{option}",
        entry.shows,
        entry.differs,
        f"{judged.count('agrees')} of {len(judged)}" if judged else "-",
        f"reproduced/{entry.file_name}" if drawn else "",
    )


def context() -> dict[str, Any]:
    """What the template needs."""
    kept = stored("reproduce")
    groups = {
        title: [_row(number, kept.tables) for number, entry in ENTRIES.items() if entry.source == source]
        for title, source in (("Thesis", THESIS), ("Camera paper", CAMERA))
    }
    return {
        "groups": groups,
        "tables": {
            number: Table(one.columns[1:], one.decimals[1:], [row[1:] for row in one.rows])
            for number, one in ((number, kept.tables[number]) for number in ENTRIES if number in kept.tables)
        },
        "data": kept.numbers["data"],
    }
