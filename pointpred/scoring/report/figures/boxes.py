"""The thesis's box plots: distribution of the single-axis error at every tenth of the path."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pointpred.drawing.style import Picture, canvas, picture
from pointpred.scoring.report.figures.style import line_style
from pointpred.scoring.results import AXIS_FRACTIONS
from pointpred.scoring.statistics import AxisProfile, Box

TENTHS = tuple(i for i in range(len(AXIS_FRACTIONS)) if i % 2)
MOST_DOTS = 100
HEADROOM = 1.6
"""The frame ends at this many times the highest whisker; outliers beyond are counted in the caption."""


def boxes(
    name: str,
    profiles: Sequence[AxisProfile],
    shown: Sequence[str],
    *,
    simulated: bool = False,
    unit: str = "px",
) -> Picture:
    """A panel a predictor, all on one scale, in the colours of the curves; ``name`` is the set's."""
    title = "Single axis: spread of the error" + (" (simulated)" if simulated else "")
    top = HEADROOM * max(profile.boxes[i].high for profile in profiles for i in TENTHS) or 1.0
    statistics = [[profile.boxes[i] for i in TENTHS] for profile in profiles]
    beyond = sum(value > top for row in statistics for one in row for value in one.outliers)
    rows = (len(profiles) + 1) // 2
    with canvas(rows, 2, width=8.0, height=0.6 + 2.4 * rows, share=True) as (figure, panels):
        for axes, profile, row in zip(panels, profiles, statistics, strict=False):
            colour = line_style(profile.name, shown)["color"]
            line = {"color": colour, "linewidth": 1.3}
            axes.bxp(
                [_stats(one, top) for one in row],
                positions=[round(100 * AXIS_FRACTIONS[i]) for i in TENTHS],
                widths=6,
                boxprops=line,
                whiskerprops=line,
                capprops=line,
                medianprops={**line, "linewidth": 2.6},
                flierprops={"marker": ".", "markersize": 3, "markeredgecolor": colour, "alpha": 0.5},
                manage_ticks=False,
            )
            axes.tick_params(labelbottom=True)
            axes.set_title(profile.name)
            axes.grid(axis="y")
        for axes in panels[len(profiles) :]:
            axes.set_visible(False)
        panels[0].set(xlim=(3, 107), ylim=(0.0, top))
        panels[0].set_xticks(range(10, 101, 10))
        figure.supxlabel("share of the longer axis done [%]", fontsize=10.5)
        figure.supylabel(f"error [{unit}]", fontsize=10.5)
        words = [f"{p.name} median {p.boxes[TENTHS[4]].median:.3g} {unit} at 50 %" for p in profiles]
        return picture(
            figure,
            f"{title} on {name}, box plots at every tenth of the path: {'; '.join(words)}.",
            f"{title}. Box: quartiles and median; whiskers: 1.5 interquartile ranges; dots: "
            f"outliers, at most {MOST_DOTS} a box"
            + (f", {beyond} more lie above the frame." if beyond else "."),
            wide=True,
        )


def _stats(one: Box, top: float) -> dict[str, object]:
    fliers = [value for value in one.outliers if value <= top]
    if len(fliers) > MOST_DOTS:
        ranks = np.linspace(0, len(fliers) - 1, MOST_DOTS).round().astype(int)
        fliers = [fliers[rank] for rank in ranks]  # evenly over the ranks, extremes included
    return {
        "med": one.median, "q1": one.q1, "q3": one.q3, "whislo": one.low, "whishi": one.high, "fliers": fliers
    }  # fmt: skip
