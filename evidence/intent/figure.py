"""The figure of docs/evidence/intent.md: firings against lead, a curve by threshold."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from evidence import FIGURES
from evidence.data import Table, stored
from evidence.intent.measure import RULE
from evidence.intent.page import LEADS
from evidence.rendering import only
from evidence.thinning import thin
from pointpred.targets import prefetch

FILE = FIGURES / "intent.svg"
FIRINGS, LEAD = "firings", "median lead"
OURS, THEIRS, ASKED = "#0072b2", "#d55e00", "#e5f2e5"


def save(file: Path = FILE) -> None:
    """Draw it from the stored numbers."""
    import matplotlib as mpl
    from matplotlib.figure import Figure

    kept = stored("intent", "policy").tables
    layouts = list(dict.fromkeys(str(row[0]) for row in kept["thresholds"].rows))
    with mpl.rc_context({"svg.hashsalt": "pointpred", "font.size": 9.0}):
        figure = Figure(figsize=(10.0, 6.0), layout="constrained")
        for axes, layout in zip(figure.subplots(2, 3).flat, layouts, strict=True):
            _panel(axes, layout, kept)
        figure.axes[0].legend(fontsize=7.5, frameon=False, loc="upper left")
        figure.supxlabel("median lead, ms, of the movements with a firing before the entry")
        figure.supylabel("firings a movement")
        figure.savefig(file, metadata={"Date": None})
    thin(file)


def _panel(axes: Any, layout: str, kept: dict[str, Table]) -> None:
    """One layout: the curve, ForesightJS's rule, what is asked for, and what the browser showed."""
    curve = only(kept["thresholds"], layout=layout)
    lead, firings = _column(curve, LEAD), _column(curve, FIRINGS)
    frames = only(kept["policy"], layout=layout, seen="frames")
    rule = only(frames, rule=RULE)
    (x,), (y,) = _column(rule, LEAD), _column(rule, FIRINGS)
    right = 1.08 * max(*lead, LEADS * x)
    axes.fill_between([LEADS * x, right], 0.0, y, color=ASKED, label="asked for")
    axes.plot(lead, firings, ".-", color=OURS, lw=1.0, label="onIntent by threshold")
    usual = _column(curve, "threshold").index(prefetch.THRESHOLD)
    axes.plot(lead[usual], firings[usual], "o", color=OURS, label=f"threshold {prefetch.THRESHOLD:g}")
    axes.plot(x, y, "s", color=THEIRS, label="ForesightJS")
    for name, colour in (("`kinematic-adaptive`", OURS), (RULE, THEIRS)):
        seen = only(kept["browser"], layout=layout, rule=name)
        marker = {"mfc": "none", "color": colour, "label": "in Chromium" if colour == OURS else None}
        axes.plot(_column(seen, LEAD), _column(seen, FIRINGS), "o" if colour == OURS else "s", **marker)
    axes.set(title=layout, xlim=(0.0, right), ylim=(0.0, 1.15 * max(*firings, y)))


def _column(table: Table, name: str) -> list[float]:
    return [float(row[table.columns.index(name)]) for row in table.rows]
