"""Curves and bars of a report, drawn from the numbers that ``summary`` made: nothing is measured here."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from operator import itemgetter
from typing import Any

import numpy as np

from pointpred.columns import FloatArray
from pointpred.drawing.style import FAINT, GREY, MARKERS, PALETTE, Picture, canvas, legend_outside, picture
from pointpred.scoring.report.figures.style import HOLD, line_style
from pointpred.scoring.summary import SERIES, Measure, Measures, PredictorSummary, SetSummary

KINDS = {
    "by_path": ("Error against path", "share of the path done [%]"),
    "by_time": ("Error against time", "share of the time to arrival [%]"),
    "single_axis": ("Single-axis MAE against path", "share of the longer axis done [%]"),
}
LAST_SHARE = 0.9
"""Further along the path hold itself is as good as right, and shares of its error say little."""
SHARE_LABEL = "share of hold's error (left is better)"


def marked(summary: SetSummary, title: str) -> str:
    """A title that states where people were simulated."""
    return f"{title} (simulated)" if summary.simulated else title


def numbers(measures: PredictorSummary | Measures, kind: str, quantity: str) -> FloatArray:
    """One series of a predictor or of a group in it, NaN where a number means nothing."""
    cells: dict[float, Measure] = getattr(measures, kind)
    return np.array([getattr(cell, quantity) for cell in cells.values()], dtype=np.float64)


def curves(summary: SetSummary, shown: Sequence[str], kind: str, quantity: str = "px") -> Picture:
    """Mean error of every predictor against path or time: ``kind`` of KINDS, ``quantity`` px or of_hold."""
    what, across = KINDS[kind]
    shares = quantity == "of_hold"
    title = marked(summary, what + (", share of hold" if shares else ""))
    ended = shares and kind == "by_path"
    fractions = [f for f in SERIES[kind] if f <= LAST_SHARE or not ended]
    series = {p.name: numbers(p, kind, quantity)[: len(fractions)] for p in summary.predictors}
    with canvas() as (figure, (axes,)):
        _lines(axes, series, shown, fractions)
        axes.set_ylim(0.0, _top([series], shown))
        ylabel = "share of hold's error" if shares else f"mean error [{summary.unit}]"
        axes.set(title=title, xlabel=across, ylabel=ylabel)
        legend_outside(figure, axes)
        unit = "" if shares else " " + summary.unit
        others = _thin(series, shown)
        if ended:
            others += (
                f" Beyond {LAST_SHARE:.0%} hold is as good as right, and shares of its error say little."
            )
        return picture(
            figure,
            f"{title} on {summary.name}: {_in_words(series, shown, fractions, unit)}",
            f"{title}; number of trials averaged: {summary.trials}.{others}",
        )


def _thin(series: Iterable[str], shown: Sequence[str]) -> str:
    """Which predictors the thin lines are."""
    hidden = [name for name in series if name not in (*shown, HOLD)]
    return f" Thin lines: {', '.join(hidden)}." if hidden else ""


def group_curves(summary: SetSummary, shown: Sequence[str], groups: Sequence[str]) -> Picture:
    """The single-axis error in several groups of trials, a panel a group, one scale."""
    title = marked(summary, "Single-axis MAE by group")
    fractions = SERIES["single_axis"]
    rows = (len(groups) + 1) // 2
    with canvas(rows, 2, width=8.0, height=0.8 + 2.6 * rows, share=True) as (figure, panels):
        lines = [
            {p.name: numbers(p.groups[key], "single_axis", "px") for p in summary.predictors}
            for key in groups
        ]
        for axes, key, series in zip(panels, groups, lines, strict=False):
            _lines(axes, series, shown, fractions)
            axes.tick_params(labelbottom=True)
            group = summary.groups[key]
            axes.set_title(f"{group.label} ({group.trials})")
        for axes in panels[len(groups) :]:
            axes.set_visible(False)
        panels[0].set_ylim(0.0, _top(lines, shown))
        figure.supxlabel(KINDS["single_axis"][1], fontsize=10.5)
        figure.supylabel(f"mean error [{summary.unit}]", fontsize=10.5)
        legend_outside(figure, panels[0], above=True, columns=4)
        return picture(
            figure,
            f"{title} on {summary.name}: a panel each for "
            f"{', '.join(summary.groups[key].label for key in groups)}.",
            f"{title}. Numbers of trials in brackets; the table says what the groups are."
            + _thin(lines[0], shown),
            wide=True,
        )


def _lines(
    axes: Any, series: dict[str, FloatArray], shown: Sequence[str], fractions: Sequence[float]
) -> None:
    """A line a predictor."""
    for name, values in series.items():
        axes.plot(100 * np.array(fractions), values, **line_style(name, shown))
    axes.set_xticks([0, 20, 40, 60, 80, 100])
    axes.grid(axis="y")


def _top(panels: Sequence[dict[str, FloatArray]], shown: Sequence[str]) -> float:
    """Upper end of a frame that holds every named line; a stray faint one may leave it."""
    named = [v for series in panels for name, v in series.items() if name in shown or name == HOLD]
    return 1.05 * max((float(v[np.isfinite(v)].max()) for v in named if np.isfinite(v).any()), default=1.0)


def _in_words(
    series: dict[str, FloatArray], shown: Sequence[str], fractions: Sequence[float], unit: str
) -> str:
    """The named lines at their first, middle and last fraction."""
    places = (0, len(fractions) // 2, len(fractions) - 1)
    words = [
        f"{name} " + ", ".join(f"{series[name][i]:.3g}{unit} at {fractions[i]:.0%}" for i in places)
        for name in series
        if name in shown or name == HOLD
    ]
    return "; ".join(words) + "."


def skill_bars(summary: SetSummary) -> Picture:
    """Time-averaged error as a share of hold's, with intervals, best first."""
    ordered = _by_share(summary)
    title = marked(summary, "Error, share of hold")
    better = []
    with canvas(height=1.2 + 0.28 * len(ordered)) as (figure, (axes,)):
        for place, (share, predictor) in enumerate(ordered):
            cell = predictor.time_averaged
            low, high = cell.interval or (share, share)
            surely = cell.interval is not None and high < 1.0
            better += [predictor.name] if surely else []
            colour = GREY if predictor.name == HOLD else PALETTE[0] if surely else PALETTE[1]
            axes.plot([low, high], [place, place], color=colour, linewidth=2.6)
            axes.plot([share], [place], "o" if surely else "s", color=colour, markersize=6.5)
        _rows(axes, [predictor.name for _, predictor in ordered], title)
        units = "people" if summary.interval.resampled == "users" else "trials (one person)"
        return picture(
            figure,
            f"{title} on {summary.name}. Interval wholly below 1: {', '.join(better) or 'none'}.",
            f"Bars: {summary.interval.level:.0%} bootstrap interval over {units}. Blue circle: "
            "wholly below 1, better than no prediction; square: not.",
        )


def clean_against_all(summary: SetSummary) -> Picture:
    """Share of hold's time-averaged error over all trials and over clean ones, side by side."""
    ordered = [p for _, p in _by_share(summary) if "clean_trials" in p.groups]
    title = marked(summary, "Clean trials against all")
    with canvas(height=1.5 + 0.28 * len(ordered)) as (figure, (axes,)):
        both = [[p.time_averaged, p.groups["clean_trials"].time_averaged] for p in ordered]
        shares = np.array([[cell.of_hold for cell in cells] for cells in both], dtype=float)
        for place, pair in enumerate(shares):
            axes.plot(pair, [place, place], color=FAINT, linewidth=2.6)
        counts = (summary.trials, summary.groups["clean_trials"].trials)
        for k, kind in enumerate(("all", "clean")):
            label = f"{kind} trials ({counts[k]})"
            axes.plot(
                shares[:, k],
                range(len(ordered)),
                MARKERS[k],
                color=PALETTE[k],
                markersize=8.5 - 3 * k,
                label=label,
            )
        _rows(axes, [p.name for p in ordered], title)
        legend_outside(figure, axes)
        return picture(
            figure,
            f"{title} on {summary.name}: time-averaged error of each predictor as a share of hold's.",
            "Time-averaged error as a share of hold's on the same trials. A trial is clean as the recording "
            "says, or else when it goes 80 px, straight enough and without a stop.",
        )


def _by_share(summary: SetSummary) -> list[tuple[float, PredictorSummary]]:
    """Shares of hold's error with their predictors, the lowest first."""
    pairs = ((p.time_averaged.of_hold, p) for p in summary.predictors)
    return sorted(((share, p) for share, p in pairs if share is not None), key=itemgetter(0))


def _rows(axes: Any, names: Sequence[str], title: str) -> None:
    """Predictors down the side, the share of hold's error along the bottom."""
    axes.axvline(1.0, color=GREY, linestyle="--", linewidth=1.2)
    axes.set_yticks(range(len(names)), names)
    axes.set(title=title, xlabel=SHARE_LABEL, ylim=(len(names) - 0.4, -0.6))
    axes.grid(axis="x")


def cost(summary: SetSummary) -> Picture:
    """Processor time an event beside the time-averaged error."""
    from matplotlib.ticker import LogLocator

    points = [(p.us_per_event, share, p.name) for share, p in _by_share(summary) if p.us_per_event]
    names = [p.name for p in summary.predictors]
    title = marked(summary, "Cost beside accuracy")
    with canvas(height=5.2) as (figure, (axes,)):
        for us_per_event, share, name in points:
            style: Any = line_style(name, names) | {"linestyle": "none", "markersize": 7.5}
            axes.plot([us_per_event], [share], **({"marker": "o"} | style))
        if points:
            axes.set_xscale("log")
            axes.xaxis.set_major_formatter("{x:g}")  # the usual one writes powers as mathematics
            axes.xaxis.set_minor_formatter("")
            axes.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
            axes.margins(x=0.25)
            legend_outside(figure, axes)
        axes.set(title=title, xlabel="cost [µs per event, one core]", ylabel="share of hold's error")
        axes.grid()
        words = [f"{name} {us_per_event:.2g} µs, {share:.2f}" for us_per_event, share, name in points]
        return picture(
            figure,
            f"{title} on {summary.name}: {'; '.join(words)}.",
            "Cost of the whole pipeline in the batch; further down and left is better.",
        )
