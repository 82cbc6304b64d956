"""The README's score table, from a scoring run on the embedded sample."""

from __future__ import annotations

from pathlib import Path

from pages.held_out import seen, trained
from pages.markdown import filled, table
from pointpred.cli.tables import title
from pointpred.datasets import sample
from pointpred.registry import RECOMMENDED
from pointpred.scoring import HEADINGS, rows, score, summarise

NAMES = ("hold", "minimum-jerk", "switched", "kinematic", RECOMMENDED)
"""Rows of the table: no prediction, no training, the thesis, and what has learned."""
SHOWN = ("predictor", "share of hold's error", "95 % interval", "time 30 %", "time 50 %", "time 70 %")
"""Columns of the table; the cost is left out because it differs from machine to machine."""


def scores() -> str:
    """The embedded sample scored with five predictors, as Markdown."""
    described = summarise(score([sample()], list(NAMES))[0])
    places = [HEADINGS.index(heading) for heading in SHOWN]
    cells = [(f"`{row[0]}`", *(row[i] for i in places[1:])) for row in rows(described)]
    learned = [f"`{name}`" for name in trained() if described.name not in seen()]
    verb = "was" if len(learned) == 1 else "were"
    said = f"\n\n{' and '.join(learned)} {verb} fitted to other people, never to these." if learned else ""
    return f"{title(described)}\n\n{table(SHOWN, cells)}{said}"


def write_scores(root: Path) -> Path:
    """Put the table into the README."""
    path = root / "README.md"
    path.write_text(filled(path.read_text(encoding="utf-8"), "scores", scores()), encoding="utf-8")
    return path
