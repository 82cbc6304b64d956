"""The figure of docs/guide/assistance.md: when help helps and when it harms."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import msgspec

from pages.assistance.movements import SKILLS
from pages.thinning import thin

COLOURS = {"novices": "#2563a8", "middling": "#3f7d4f", "experts": "#c2410c"}
STYLES = {"sure": "-", "honest": ":"}
Change = tuple[float, float]


class Curves(msgspec.Struct, frozen=True):
    """Changes of the time by how wrong a prediction is: [claim][group] a (mean, half interval) a place."""

    places: Sequence[float]
    changes: Mapping[str, Mapping[str, Sequence[Change]]]


def draw(
    curves: Mapping[str, tuple[Curves, Curves]], bars: Mapping[str, Mapping[str, float]], path: Path
) -> None:
    """Write it.

    ``curves``: by what the people know of the help, errors of direction and of distance; ``bars``:
    [prediction][law] the time over that without help.
    """
    import matplotlib as mpl

    mpl.use("Agg")
    import matplotlib.pyplot as plt

    with mpl.rc_context({"svg.hashsalt": "pointpred", "font.size": 9.0}):
        figure = plt.figure(figsize=(11.0, 6.4), layout="constrained")
        grid = figure.add_gridspec(2, 3, width_ratios=(1.0, 1.0, 1.25))
        for row, (people, (angles, factors)) in enumerate(curves.items()):
            left = figure.add_subplot(grid[row, 0])
            _curves(left, angles, "error of direction, degrees", people)
            if row == 0:
                left.legend(loc="lower right", fontsize=7.5, frameon=False, ncols=2)
            _curves(figure.add_subplot(grid[row, 1]), factors, "predicted / true distance", people)
        _bars(figure.add_subplot(grid[:, 2]), bars)
        figure.suptitle("Simulated people, help of strength 0.5: what an error of the prediction costs")
        path.parent.mkdir(parents=True, exist_ok=True)
        figure.savefig(path, metadata={"Date": None})
        thin(path)
        plt.close(figure)


def _curves(axes: Any, curves: Curves, label: str, title: str) -> None:
    for claim, groups in curves.changes.items():
        for group in SKILLS:
            means = [100.0 * mean for mean, _ in groups[group]]
            colour = COLOURS[group]
            name = group if claim == "sure" else None
            axes.plot(curves.places, means, STYLES[claim], color=colour, marker=".", label=name)
            if claim == "sure":
                bands = [[100.0 * (m + s * half) for m, half in groups[group]] for s in (-1.0, 1.0)]
                axes.fill_between(curves.places, *bands, color=colour, alpha=0.12, lw=0)
    axes.axhline(0.0, color="0.3", lw=0.8)
    axes.set(xlabel=label, ylabel="change of time, %", title=title, ylim=(-25.0, 25.0))
    axes.plot([], [], STYLES["sure"], color="0.4", label="claims a small region")
    axes.plot([], [], STYLES["honest"], color="0.4", label="claims an honest region")


def _bars(axes: Any, bars: Mapping[str, Mapping[str, float]]) -> None:
    laws = list(next(iter(bars.values())))
    shades = ("0.15", "0.55", "#9db8d8", "#2563a8")
    height = 0.8 / len(laws)
    for j, law in enumerate(laws):
        places = [i + (j - 0.5 * (len(laws) - 1)) * height for i in range(len(bars))]
        values = [bars[row][law] for row in bars]
        axes.barh(places, [v - 1.0 for v in values], height, left=1.0, color=shades[j], label=law)
    axes.axvline(1.0, color="0.3", lw=0.8)
    axes.set_xscale("log")
    ticks = (0.8, 1.0, 1.5, 2.0, 3.0, 4.0)
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.set_xticks([], minor=True)
    axes.set_yticks(range(len(bars)), list(bars))
    axes.invert_yaxis()
    axes.set(xlim=(0.75, 4.2), xlabel="time / time without help", title="with and without the safety rule")
    axes.legend(loc="upper right", fontsize=8.0, frameon=False)
