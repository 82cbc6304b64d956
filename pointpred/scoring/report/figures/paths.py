"""The worst trials of a predictor, drawn: where the cursor went and where it was words to end."""

from __future__ import annotations

from typing import Any

import numpy as np

from pointpred.drawing.style import GREY, INK, PALETTE, Picture, canvas, picture
from pointpred.scoring.results import SetScore, WorstTrial

MIDDLE = np.linspace(0.3, 0.85, 64)
"""The part of matplotlib's plasma that stands out from a light page and from a dark one."""


def draw_worst(score: SetScore) -> Picture | None:
    """A panel a trial: path, predicted endpoints coloured by time, true endpoint, target where known.

    ``None`` where no trials were kept.
    """
    worst, unit = score.worst, score.unit
    if worst is None:
        return None
    drawings = worst.trials
    title = f"Worst trials of {worst.predictor}" + (" (simulated)" if score.simulated else "")
    rows = (len(drawings) + 1) // 2
    with canvas(rows, 2, width=8.0, height=0.9 + 3.0 * rows) as (figure, panels):
        colours = None
        for place, (axes, drawing) in enumerate(zip(panels, drawings, strict=False)):
            colours = _panel(axes, drawing)
            axes.set_title(
                f"{place + 1}: mean error {drawing.error_px:.0f} {unit}, "
                f"distance {drawing.trial.distance_px:.0f} {unit}"
            )
        for axes in panels[len(drawings) :]:
            axes.set_visible(False)
        if colours is not None:
            figure.colorbar(colours, ax=panels, location="bottom", shrink=0.6, aspect=40,
                            label="time of the prediction [% of onset to arrival]")  # fmt: skip
            handles, labels = panels[0].get_legend_handles_labels()
            figure.legend(handles, labels, loc="outside upper center", ncols=4)
        worst_of_all = max((drawing.error_px for drawing in drawings), default=0.0)
        return picture(
            figure,
            f"{title} on {score.name}: paths with the predicted endpoints, panels: {len(drawings)}; "
            f"largest error {worst_of_all:.3g} {unit}.",
            f"{title}, which has the lowest time-averaged error on this set, hold apart. Each dot is an "
            "endpoint it predicted, coloured by when. Above each panel: time-averaged error and distance. "
            f"Positions in {unit}, y down; predictions far outside the frame are not drawn.",
            wide=True,
        )


def _panel(axes: Any, drawing: WorstTrial) -> Any:
    """One trial; returns what the colour bar explains."""
    from matplotlib import colormaps
    from matplotlib.colors import LinearSegmentedColormap
    from matplotlib.patches import Circle

    events, answers, about = drawing.events, drawing.answers, drawing.trial.trial
    share = 100 * (events.t - events.t[0]) / drawing.trial.arrival_s
    axes.plot(events.x, events.y, color=GREY, linewidth=1.4, label="cursor")
    axes.plot(events.x[:1], events.y[:1], "o", color=INK, markersize=6, label="start")
    if np.isfinite([about.target_x, about.target_y, about.target_w]).all():
        axes.add_patch(Circle((about.target_x, about.target_y), about.target_w / 2, fill=False,
                              edgecolor=PALETTE[2], linewidth=1.6, label="target"))  # fmt: skip
    shown = axes.scatter(
        answers.x,
        answers.y,
        c=np.minimum(share, 100),
        cmap=LinearSegmentedColormap.from_list("middle", colormaps["plasma"](MIDDLE)),
        s=16,
        linewidths=0,
        vmin=0,
        vmax=100,
    )
    axes.plot(events.x[-1:], events.y[-1:], "X", color=PALETTE[1], markersize=9, label="true endpoint")
    half = 0.65 * max(np.ptp(events.x), np.ptp(events.y), 50.0)
    middle_x, middle_y = (v.min() + np.ptp(v) / 2 for v in (events.x, events.y))
    axes.set(xlim=(middle_x - half, middle_x + half), ylim=(middle_y + half, middle_y - half), aspect="equal")
    return shown
