"""Measure the prefetch policy beside ForesightJS's rule: ``python -m evidence intent``.

Recorded movements over every layout: firings a movement, the share of movements whose right target fired
before the cursor entered it, the median lead, and the same by threshold. The learned predictors do not know
the people, the evidence does not know the group of sets; in the rows "settings held out" the policy's
settings do not know it either. A page hears of events once a frame: so do both sides. Recordings come from
the folder named by POINTPRED_RECORDINGS.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from evidence import FIGURES
from evidence.arguments import parse
from evidence.data import Table, keep, stored
from evidence.intent.firing import (
    FRAME_S,
    HOVER_HEADS,
    HOVER_S,
    Score,
    by_policy,
    by_rule,
    hovered,
    shares_of,
)
from evidence.intent.fit import GROUPS, Fits, by_layout, fits, recorded
from evidence.intent.movements import Movement
from evidence.rendering import only
from evidence.thinning import save
from pointpred.drawing import GREY, PALETTE, canvas, legend_outside, picture
from pointpred.records import FloatArray
from pointpred.targets import prefetch

PREDICTORS = ("kinematic-adaptive", "kinematic", "minimum-jerk", "switched-direction")
THRESHOLDS = (0.2, 0.3, 0.4, 0.45, 0.5, 0.55, 0.6, 0.7, 0.8, 0.9)
RULE = "ForesightJS"
HEADS = ("firings", "of these, not where it started", "right before entry", "median lead", "of all movements")


def cells(one: Score) -> tuple[str, ...]:
    """Numbers as a table shows them."""
    return (
        f"{one.firings:.2f}",
        f"{one.elsewhere:.2f}",
        f"{100.0 * one.before:.1f}",
        f"{1e3 * one.lead_s:.0f}",
        f"{1e3 * one.lead_all_s:.0f}",
    )


def shares(movements: Sequence[Movement], predictor: str, fitted: Fits, frame_s: float) -> list[FloatArray]:
    """The shares in every movement, by evidence that does not know its group of sets."""
    evidence = [np.array(one.evidence) for one in fitted.without]
    return [shares_of(one, predictor, evidence[GROUPS[one.set]], frame_s) for one in movements]


def compared(movements: Sequence[Movement], fitted: Fits) -> tuple[Table, Table]:
    """The table of layouts and rules, and that by threshold."""
    rows, curve = [], []

    def add(name: str, fired: Sequence[FloatArray], seen: str) -> None:
        for layout, one in by_layout(movements, fired).items():
            rows.append((layout, name, seen, str(one.movements), *cells(one)))

    ours = np.array(prefetch.FITTED)
    for frame_s, seen in ((FRAME_S, "frames"), (0.0, "events")):
        add(RULE, [by_rule(one, frame_s) for one in movements], seen)
        for predictor in PREDICTORS if frame_s else PREDICTORS[:1]:
            weighed = shares(movements, predictor, fitted, frame_s)
            pairs = list(zip(movements, weighed, strict=True))
            add(f"`{predictor}`", [by_policy(*pair, ours, frame_s) for pair in pairs], seen)
            if frame_s == 0.0 or predictor != PREDICTORS[0]:
                continue
            apart = [np.array(one.settings) for one in fitted.without]
            own = [by_policy(*pair, apart[GROUPS[pair[0].set]], frame_s) for pair in pairs]
            add(f"`{predictor}`, settings held out", own, seen)
            for threshold in THRESHOLDS:
                fired = [by_policy(*pair, ours, frame_s, threshold) for pair in pairs]
                for layout, one in by_layout(movements, fired).items():
                    curve.append((layout, f"{threshold:g}", *cells(one)))
        print(f"measured by {seen}", flush=True)
    return (
        Table.of(("layout", "rule", "seen", "movements", *HEADS), sorted(rows, key=lambda row: row[0])),
        Table.of(("layout", "threshold", *HEADS), sorted(curve, key=lambda row: row[0])),
    )


def speculated(movements: Sequence[Movement]) -> Table:
    """Chrome's own rules, a row a layout and an eagerness."""
    layouts = sorted({one.layout for one in movements})
    rows = [
        (layout, eagerness, *hovered([one for one in movements if one.layout == layout], hover_s))
        for layout in layouts
        for eagerness, hover_s in HOVER_S.items()
    ]
    return Table.of(("layout", "eagerness", *HOVER_HEADS), rows)


def main() -> None:
    """Measure every set at hand."""
    everything = recorded(PREDICTORS)
    table, curve = compared(everything, fits())
    tables = {"policy": table, "thresholds": curve, "speculation": speculated(everything)}
    keep("intent", tables, part="policy")
    draw()


BESIDE = (
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
    return Table.of(BESIDE, rows)


def draw() -> None:
    """Ours over ForesightJS's on each layout, replayed and in the browser; what is asked for as lines."""
    tables = context()
    shown = {"replayed, settings held out": "replayed_held_out", "in one browser": "in_browser"}
    asked = {
        "firings": (1.0, "at most"),
        "before entry, %": (1.0, "at least"),
        "median lead, ms": (LEADS, "at least"),
    }
    with canvas(1, 3, width=11.0, height=3.6) as (figure, axes):
        for ax, (head, (line, word)) in zip(axes, asked.items(), strict=True):
            for place, (label, name) in enumerate(shown.items()):
                table = tables[name]
                column, layouts = table.columns.index(head), [str(row[0]) for row in table.rows]
                pairs = [str(row[column]).split(" / ") for row in table.rows]
                at = np.arange(len(layouts)) + 0.36 * (place - 0.5)
                ratios = [float(ours) / float(theirs) for ours, theirs in pairs]
                ax.barh(at, ratios, height=0.34, color=PALETTE[place], label=label)
            ax.axvline(line, color=GREY, linestyle="--")
            ax.set_yticks(np.arange(len(layouts)), layouts)
            ax.invert_yaxis()
            ax.set_title(f"{head.split(',')[0]}: {word} {line:g}")
        legend_outside(figure, axes[0], columns=2)
        alt = "Firings, share before entry and lead of onIntent over those of ForesightJS, for each layout."
        save(picture(figure, alt, "onIntent over ForesightJS.", wide=True).svg, FIGURES / "intent.svg")


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


if __name__ == "__main__":
    parse(__doc__)
    main()
