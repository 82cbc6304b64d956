"""The thesis's figures 2.8 to 2.13 on simulated people."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from pages.scored import find
from pages.thinning import thin
from pointpred import build, run
from pointpred.columns import FloatArray
from pointpred.pipeline import Pipeline
from pointpred.scoring import Prepared, SetScore
from pointpred.scoring.results import AXIS_FRACTIONS
from pointpred.scoring.statistics import axis_profile

PRINTED, KEP = "switched-printed", "kep-quartic-gated"
HEADROOM = 1.6
"""The frame of the box plots ends at this many times the highest whisker."""
COLOURS = {"hold": "#777777", PRINTED: "#0072b2", "switched": "#009e73", KEP: "#d55e00"}


def write_figures(prepared: Prepared, scored: SetScore, folder: Path) -> None:
    """Draw all of them as SVG."""
    import matplotlib as mpl

    folder.mkdir(parents=True, exist_ok=True)
    with mpl.rc_context({"svg.hashsalt": "pointpred", "font.size": 9.0}):
        save(folder / "thesis-trials.svg", (10.0, 7.0), lambda figure: trials(figure, prepared))
        save(folder / "thesis-path.svg", (7.0, 4.0), lambda figure: path(figure, scored))
        save(folder / "thesis-boxes.svg", (10.0, 4.0), lambda figure: boxes(figure, scored))


def save(file: Path, size: tuple[float, float], draw: Callable[[Any], None]) -> None:
    """Draw one figure and write it without a date."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=size, layout="constrained")
    draw(figure)
    figure.savefig(file, metadata={"Date": None})
    thin(file)


def longer_axis(prepared: Prepared, trial: int) -> str:
    """The axis along which a trial goes farther."""
    rows = prepared.rows(trial)
    return "x" if abs(rows.x[-1] - rows.x[0]) >= abs(rows.y[-1] - rows.y[0]) else "y"


def trials(figure: Any, prepared: Prepared) -> None:
    """Figures 2.8 to 2.10: the corrective model alone, then switched without and with sub-movements."""
    whole = next(i for i, one in enumerate(prepared.trials) if not one.submovements)
    divided = next(i for i, one in enumerate(prepared.trials) if one.submovements)
    alone = build(PRINTED, cpi=2000.0, threshold=10.0)
    panels = (
        ("corrective model alone", alone, whole),
        ("switched, no sub-movements", build(PRINTED, cpi=2000.0), whole),
        ("switched, sub-movements", build(PRINTED, cpi=2000.0), divided),
    )
    axes = figure.subplots(2, 3, sharex="col")
    for column, (title, pipeline, trial) in enumerate(panels):
        draw_trial(axes[:, column], pipeline, prepared, trial)
        axes[0, column].set_title(title)
    figure.suptitle("Simulated people, one trial a column")
    axes[0, 0].set_ylabel("displacement, px")
    axes[1, 0].set_ylabel("hand speed along the axis, m/s")
    axes[0, 0].legend(loc="lower right")


def draw_trial(axes: Any, pipeline: Pipeline, prepared: Prepared, trial: int) -> None:
    """One trial: displacement and estimate above, velocity below."""
    rows, axis = prepared.rows(trial), longer_axis(prepared, trial)
    place = getattr(rows, axis)
    sign = np.sign(place[-1] - place[0])
    motion = pipeline.differentiator.fresh().run(rows)
    end = getattr(run(pipeline.fresh(), rows), axis)
    t = rows.t - rows.t[0]
    axes[0].plot(t, sign * (place - place[0]), color="#777777", label="cursor")
    axes[0].plot(t, sign * (end - place[0]), color="#0072b2", label="predicted endpoint")
    axes[0].axhline(sign * (place[-1] - place[0]), color="#d55e00", lw=0.8, ls="--", label="true endpoint")
    axes[1].plot(t, sign * getattr(motion, f"v{axis}"), color="#0072b2")
    axes[1].set_xlabel("time since onset, s")


def path(figure: Any, scored: SetScore) -> None:
    """Figure 2.12: mean absolute error along the longer axis."""
    axes = figure.subplots()
    share = 100.0 * np.array(AXIS_FRACTIONS)
    for errors in scored.predictors:
        if errors.name in COLOURS:
            axes.plot(share, axis_profile(errors).mae, color=COLOURS[errors.name], label=errors.name)
    axes.set_xlabel("way done along the longer axis, %")
    axes.set_ylabel("mean absolute error, px")
    axes.set_ylim(bottom=0.0)
    axes.set_title(f"{len(scored.trials)} trials of simulated people")
    axes.legend()


def boxes(figure: Any, scored: SetScore) -> None:
    """Figure 2.13: the distribution of the error."""
    axes = figure.subplots(1, 2, sharey=True)
    for panel, name in zip(axes, (PRINTED, KEP), strict=True):
        errors = find(scored, name)
        columns: list[FloatArray] = [errors.single_axis[:, i] for i in range(1, 20, 2)]
        labels = [f"{AXIS_FRACTIONS[i]:.0%}" for i in range(1, 20, 2)]
        panel.boxplot(columns, tick_labels=labels, flierprops={"marker": "+", "markersize": 3})
        panel.set_title(f"{name} (simulated)")
        panel.set_xlabel("way done along the longer axis")
    axes[0].set_ylabel("absolute error, px")
    highest = max(box.high for name in (PRINTED, KEP) for box in axis_profile(find(scored, name)).boxes)
    axes[0].set_ylim(0.0, HEADROOM * highest)
    beyond = sum(
        int((find(scored, name).single_axis[:, 1:20:2] > HEADROOM * highest).sum()) for name in (PRINTED, KEP)
    )
    figure.suptitle(f"Outliers above the frame: {beyond}")
