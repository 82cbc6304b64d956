"""What docs/evidence/reproduce.md shows: each figure with its differences, and the values that differ."""

from __future__ import annotations

from typing import Any

import msgspec

from evidence.data import Table, stored
from pointpred.reproduction.catalogue import ENTRIES
from pointpred.reproduction.figure import CAMERA, THESIS


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
