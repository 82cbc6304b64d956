"""The tables of the page about predictions given the registered targets."""

from __future__ import annotations

from typing import Any

from evidence.data import Table, stored

ASKED = {"a tenth": 0.02, "a third": 0.03, "all": 0.05}
"""By how much the error may be larger where the right target is not registered."""
JUDGED = {"kinematic": "all", "kinematic-adaptive": "after 20"}
"""The movements over which the regions of a predictor are asked for."""
LEVELS = {"50 %": 50, "80 %": 80}
REGIONS = ("ellipse without", "ellipse with", "level set with")
AREAS = ("ellipse, with over without", "level set over ellipse")


def context() -> dict[str, Any]:
    """The tables, and what is made from them."""
    kept = stored("targets")
    regions = [row for row in kept.tables["regions"].texts() if JUDGED[row[1]] == row[2]]
    columns, left = kept.tables["regions"].columns, kept.tables["left"]
    return {
        "tables": kept.tables,
        "numbers": kept.numbers,
        "by_time": by_time(kept.tables["by time"]),
        "worst": worst(kept.tables["none"]),
        "elsewhere": by_predictor(kept.tables["none"], 2),
        "learned": by_predictor(kept.tables["learned"], 2),
        "costs": max(float(after) - float(before) for *_, before, after in kept.tables["learned"].texts()),
        "left": by_predictor(
            Table.of(left.columns, [row for row in left.texts() if JUDGED[row[1]] == row[2]]), 3
        ),
        "regions": {level: coverage(level, columns, regions) for level in LEVELS},
        "areas": Table.of(
            ("set", "predictor", *AREAS),
            [(*row[:2], *(row[columns.index(name)] for name in AREAS)) for row in regions],
        ),
    }


def by_predictor(whole: Table, keys: int) -> Table:
    """A row a set, the cells of a predictor as one; the first ``keys`` cells of a row name it."""
    rows: dict[str, dict[str, str]] = {}
    for row in whole.texts():
        rows.setdefault(row[0], {})[f"`{row[1]}`"] = " / ".join(row[keys:])
    heads = next(iter(rows.values()))
    return Table.of(("set", *heads), [(set, *cells.values()) for set, cells in rows.items()])


def by_time(whole: Table) -> Table:
    """The learned predictors by time, with what the targets change at the decile where that is least."""
    rows: dict[tuple[str, ...], list[list[str]]] = {}
    for set, predictor, given, *cells in whole.texts():
        if predictor in JUDGED:
            rows.setdefault((set, predictor), []).append([given, *cells])
    shown = []
    for key, ((_, *without), (_, *given)) in rows.items():
        most = max(float(one) - float(other) for one, other in zip(given, without, strict=True))
        cells = (f"{a} / {b}" for a, b in zip(hundredths(without), hundredths(given), strict=True))
        shown.append((*key, *cells, f"{most:+.3f}"))
    return Table.of(("set", "predictor", *whole.columns[3:], "worst decile"), shown)


def hundredths(cells: list[str]) -> list[str]:
    """Numbers with two decimals."""
    return [f"{float(cell):.2f}" for cell in cells]


def worst(whole: Table) -> list[str]:
    """Where movements to none of the targets are predicted worse than is asked for."""
    return [
        f"`{predictor}` on {set}, {share}: {float(cell):.3f}"
        for set, predictor, *cells in whole.texts()
        for (share, most), cell in zip(ASKED.items(), cells, strict=True)
        if float(cell) > most
    ]


def coverage(level: str, columns: list[str], rows: list[list[str]]) -> Table:
    """Shares inside the regions of a level, and how far those with targets are from it."""
    shown = []
    for row in rows:
        cells = [row[columns.index(f"{level}: {region}")] for region in REGIONS]
        off = (
            max(abs(int(share) - LEVELS[level]) for share in cell.split(" / "))
            for cell in cells[1:]  # those with targets
        )
        shown.append((*row[:2], *cells, *(str(points) for points in off)))
    heads = ("set", "predictor", *REGIONS, "ellipse with, farthest off", "level set, farthest off")
    return Table.of(heads, shown)
