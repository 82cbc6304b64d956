"""What docs/evidence/intent.md shows."""

from __future__ import annotations

from typing import Any

from evidence.data import Table, stored
from evidence.intent.measure import RULE
from evidence.rendering import only

HEADS = (
    "layout",
    "movements",
    "firings",
    "elsewhere",
    "before entry, %",
    "median lead, ms",
    "lead",
    "falls short in",
)
LEADS = 2.0
"""How many times ForesightJS's lead is asked for."""


def beside(whole: Table, ours: str, theirs: str = RULE) -> Table:
    """A rule of ours beside one of theirs, ours first in each cell; what is asked for and not reached."""
    left, right = ({str(row[0]): row for row in only(whole, rule=name).rows} for name in (ours, theirs))
    rows = []
    for layout, (_, count, firings, away, before, lead, _) in left.items():
        most, most_away, share, other = (float(cell) for cell in right[layout][2:6])
        short = {
            "firings": float(firings) > most,
            "before": float(before) < share,
            "lead": float(lead) < LEADS * other,
        }
        rows.append(
            (
                layout,
                f"{count:.0f}",
                f"{firings:.2f} / {most:.2f}",
                f"{away:.2f} / {most_away:.2f}",
                f"{before:.1f} / {share:.1f}",
                f"{lead:.0f} / {other:.0f}",
                f"{float(lead) / other:.2f} x",
                ", ".join(name for name, missed in short.items() if missed) or "nothing",
            )
        )
    return Table.of(HEADS, rows)


def context() -> dict[str, Any]:
    """The tables, and the comparisons made from them."""
    kept = stored("intent", "policy")
    frames = only(kept.tables["policy"], seen="frames")
    browser = kept.tables["browser"]
    return {
        "tables": kept.tables,
        "targets": stored("intent", "targets"),
        "proposals": stored("intent", "proposals"),
        "in_browser": beside(browser, "`kinematic-adaptive`"),
        "replayed": beside(frames, "`kinematic-adaptive`"),
        "replayed_held_out": beside(frames, "`kinematic-adaptive`, settings held out"),
    }
