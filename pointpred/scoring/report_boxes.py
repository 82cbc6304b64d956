"""The thesis's box plots: distribution of the single-axis error at every tenth of the path."""

from __future__ import annotations

from collections.abc import Sequence

from pointpred.scoring.report_style import GREY, HOLD, PALETTE, Picture, canvas, picture
from pointpred.scoring.results import AXIS_FRACTIONS
from pointpred.scoring.statistics import AxisProfile, Box

TENTHS = tuple(i for i in range(len(AXIS_FRACTIONS)) if i % 2)
HEADROOM = 1.6
"""The frame ends at this many times the highest whisker; outliers beyond are counted in the caption."""


def boxes(name: str, profiles: Sequence[AxisProfile], *, simulated: bool = False) -> Picture:
    """A panel a predictor, all on one scale; ``name`` is the set's."""
    title = "Single axis: spread of the error" + (" (simulated)" if simulated else "")
    top = HEADROOM * max(profile.boxes[i].high for profile in profiles for i in TENTHS) or 1.0
    drawn = [[profile.boxes[i] for i in TENTHS] for profile in profiles]
    beyond = sum(value > top for row in drawn for one in row for value in one.outliers)
    with canvas(len(profiles), height=0.7 + 2.0 * len(profiles), share=True) as (figure, panels):
        colours = iter(PALETTE * (len(profiles) // len(PALETTE) + 1))
        for axes, profile, row in zip(panels, profiles, drawn, strict=True):
            colour = GREY if profile.name == HOLD else next(colours)
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
            axes.set(ylim=(0.0, top), ylabel="error [px]")
            axes.set_title(profile.name)
            axes.grid(axis="y")
        panels[-1].set(xlabel="share of the longer axis done [%]", xlim=(3, 107))
        panels[-1].set_xticks(range(10, 101, 10))
        said = [f"{p.name} median {p.boxes[TENTHS[4]].median:.3g} px at 50 %" for p in profiles]
        return picture(
            figure,
            f"{title} on {name}, box plots at every tenth of the path: {'; '.join(said)}.",
            f"{title}. Box: quartiles and median; whiskers: 1.5 interquartile ranges; dots: outliers"
            + (f", {beyond} more lie above the frame." if beyond else "."),
        )


def _stats(one: Box, top: float) -> dict[str, object]:
    fliers = [value for value in one.outliers if value <= top]
    return {
        "med": one.median, "q1": one.q1, "q3": one.q3, "whislo": one.low, "whishi": one.high, "fliers": fliers
    }  # fmt: skip
