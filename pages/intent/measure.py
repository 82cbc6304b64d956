"""Measure the prefetch policy beside ForesightJS's rule: ``python -m pages.intent.measure``.

Recorded movements over every layout: firings a movement, the share of movements whose right target fired
before the cursor entered it, the median lead, and the same by threshold. The learned predictors do not know
the people, the evidence does not know the group of sets; in the rows "settings held out" the policy's
settings do not know it either. A page hears of events once a frame: so do both sides. Recordings come from
the folder named by POINTPRED_RECORDINGS.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pages.arguments import parse
from pages.data import Table, keep
from pages.intent import speculation
from pages.intent.fit import GROUPS, Fits, by_layout, fits, recorded
from pages.intent.foresight import FRAME_S
from pages.intent.movements import Movement
from pages.intent.scores import Score, by_policy, by_rule, shares_of
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
        (layout, eagerness, *speculation.hovered([one for one in movements if one.layout == layout], hover_s))
        for layout in layouts
        for eagerness, hover_s in speculation.HOVER_S.items()
    ]
    return Table.of(("layout", "eagerness", *speculation.HEADS), rows)


def main() -> None:
    """Measure every set at hand."""
    everything = recorded(PREDICTORS)
    table, curve = compared(everything, fits())
    keep("intent", {"policy": table, "thresholds": curve, "speculation": speculated(everything)})


if __name__ == "__main__":
    parse(__doc__)
    main()
