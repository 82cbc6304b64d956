"""The figures of a report, drawn from the numbers of a summary: nothing is measured here."""

from __future__ import annotations

import zlib
from collections.abc import Iterable, Sequence
from operator import itemgetter
from typing import Any

import numpy as np

from pointpred.drawing import (
    FAINT,
    GREY,
    INK,
    MARKERS,
    PALETTE,
    Picture,
    canvas,
    legend_outside,
    picture,
)
from pointpred.records import FloatArray
from pointpred.scoring.measures.regions import LEVELS
from pointpred.scoring.results import AXIS_FRACTIONS, SetScore, WorstTrial
from pointpred.scoring.statistics import AxisProfile, Box
from pointpred.scoring.summary import (
    FLOOR,
    SERIES,
    Calibration,
    Measure,
    Measures,
    PredictorSummary,
    SetSummary,
    TimeLeft,
)
from pointpred.scoring.summary.document import or_nan

MOST_LINES = 6
DASHED = (0, (3, 1.2))
STYLES: dict[str, tuple[int, str, object]] = {
    "linear": (5, "v", "solid"),
    "kalman": (4, "p", "solid"),
    "minimum-jerk": (2, "^", "solid"),
    "kep-quadratic": (3, "h", "solid"),
    "kep-quadratic-gated": (3, "P", DASHED),
    "kep-quartic": (1, "X", "solid"),
    "kep-quartic-gated": (1, "*", DASHED),
    "ktm": (2, "<", DASHED),
    "delphian": (4, ">", DASHED),
    "switched": (0, "s", "solid"),
    "switched-printed": (0, "H", DASHED),
    "switched-direction": (0, "d", "dotted"),
    "kinematic": (3, "D", "solid"),
    "kinematic-adaptive": (4, "o", "solid"),
}
"""Place in PALETTE, marker and dash of each name of the registry; the marker is that of no other name."""


def line_style(name: str, shown: Sequence[str]) -> dict[str, object]:
    """Colour, marker and dash of a predictor: ``hold`` is the grey reference, what is not shown is faint.

    A name keeps its marker in every figure, which tells it apart in grey, and its colour unless a name shown
    before it has the same: then it takes the next one that is free. A name of the registry with words in
    brackets behind it has that name's look; where another of that name is drawn before it the line is dotted
    and the marker hollow. Any other name has a look of its own too, derived from its letters.
    """
    if name == FLOOR:
        return {"color": GREY, "linestyle": (0, (4, 2)), "label": "hold (no prediction)", "zorder": 2.5}
    if name not in shown:
        return {"color": FAINT, "linewidth": 0.8, "zorder": 1.5}
    base, marker, dash, _ = _look(name)
    before = list(shown[: list(shown).index(name)])
    hollow = base in STYLES and any(_look(one)[0] == base for one in before)
    dash = "dotted" if hollow else dash
    return {
        "color": PALETTE[_colours([*before, name])[base]],
        "marker": marker,
        "linestyle": dash,
        "label": name,
        "zorder": 3.0,
        **({"markerfacecolor": "none"} if hollow else {}),
    }


def _look(name: str) -> tuple[str, str, object, int]:
    """The name without words in brackets, its marker and dash, and its own place in PALETTE."""
    other = zlib.crc32(name.encode("utf-8", "replace"))
    base = name.partition(" (")[0]
    place, marker, dash = STYLES.get(base, (other % 6, MARKERS[other // 6 % 6], "dotted"))
    return base if base in STYLES else name, marker, dash, place


def _colours(names: Sequence[str]) -> dict[str, int]:
    """The place in PALETTE of each name: its own, or the next that is free while any is."""
    taken: dict[str, int] = {}
    for name in names:
        base, _, _, place = _look(name)
        if base != FLOOR and base not in taken:
            nearest = [(place + step) % len(PALETTE) for step in range(len(PALETTE))]
            taken[base] = next((one for one in nearest if one not in taken.values()), place)
    return taken


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
    hidden = [name for name in series if name not in (*shown, FLOOR)]
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
    named = [v for series in panels for name, v in series.items() if name in shown or name == FLOOR]
    return 1.05 * max((float(v[np.isfinite(v)].max()) for v in named if np.isfinite(v).any()), default=1.0)


def _in_words(
    series: dict[str, FloatArray], shown: Sequence[str], fractions: Sequence[float], unit: str
) -> str:
    """The named lines at their first, middle and last fraction."""
    places = (0, len(fractions) // 2, len(fractions) - 1)
    words = [
        f"{name} " + ", ".join(f"{series[name][i]:.3g}{unit} at {fractions[i]:.0%}" for i in places)
        for name in series
        if name in shown or name == FLOOR
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
            colour = GREY if predictor.name == FLOOR else PALETTE[0] if surely else PALETTE[1]
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


WORDS = {
    "calibration": ("Endpoints inside the predicted regions", "regions"),
    "time_left": ("Arrivals inside the predicted intervals", "intervals of the time left"),
}
ALLOWED = 0.03
"""How far off a share may be before a claim is called false."""


def inside_curves(summary: SetSummary, kind: str) -> Picture | None:
    """Shares inside against time, a panel a predictor; ``kind`` of WORDS. ``None`` without claims."""
    made: list[tuple[str, Calibration | TimeLeft | None]]
    made = [(p.name, getattr(p, kind)) for p in summary.predictors]
    claiming = [(name, claims) for name, claims in made if claims and claims.by_time]
    if not claiming:
        return None
    what, noun = WORDS[kind]
    title = marked(summary, what)
    rows = (len(claiming) + 1) // 2
    with canvas(rows, 2, width=8.0, height=1.1 + 2.4 * rows, share=True) as (figure, panels):
        for axes, (name, claims) in zip(panels, claiming, strict=False):
            for place, level in enumerate(LEVELS):
                band = 100 * (level - ALLOWED), 100 * (level + ALLOWED)
                axes.axhspan(*band, color=PALETTE[place], alpha=0.22, linewidth=0)
                by_time = claims.by_time or {}
                inside = [100 * or_nan(cell.inside[level]) for cell in by_time.values()]
                axes.plot(
                    [100 * t for t in by_time],
                    inside,
                    MARKERS[place],
                    linestyle="-",
                    color=PALETTE[place],
                    label=f"{level:.0%}",
                )
            axes.set_title(name)
            axes.grid(axis="y")
            axes.tick_params(labelbottom=True)
        for axes in panels[len(claiming) :]:
            axes.set_visible(False)
        panels[0].set(ylim=(0, 101), xlim=(5, 95))
        panels[0].set_xticks(range(10, 91, 20))
        figure.supxlabel("share of the time to arrival [%]", fontsize=10.5)
        figure.supylabel("share inside [%]", fontsize=10.5)
        legend_outside(figure, panels[0], above=True, columns=3)
        *first, last = (f"{100 * level:g}" for level in LEVELS)
        words = []
        for name, claims in claiming:
            shares = "/".join(f"{100 * or_nan((claims.inside or {})[level]):.0f}" for level in LEVELS)
            words.append(f"{name} {shares} % over all the time")
        return picture(
            figure,
            f"{title} on {summary.name}: {'; '.join(words)}, wanted "
            f"{'/'.join(f'{level:.0%}' for level in LEVELS)}.",
            f"{title} of {', '.join(first)} and {last} %, at each decile of the time, over the trials with "
            f"{noun} there. A claim is true within the band of its colour, {ALLOWED:.0%} to either side.",
            wide=True,
        )


def time_left_bars(summary: SetSummary) -> Picture | None:
    """Error of the time left over that of a clock, with intervals, best first; ``None`` without claims."""
    claiming = [(p.name, p.time_left) for p in summary.predictors if p.time_left and p.time_left.of_clock]
    if not claiming:
        return None
    ordered = sorted(claiming, key=lambda one: or_nan(one[1].of_clock))
    title = marked(summary, "Time left beside a clock")
    clock = 1e3 * or_nan(ordered[0][1].clock_s)
    with canvas(width=6.2, height=1.4 + 0.28 * len(ordered)) as (figure, (axes,)):
        for place, (_, left) in enumerate(ordered):
            ratio, bounds = or_nan(left.of_clock), left.interval
            low, high = bounds or (ratio, ratio)
            surely = bounds is not None and high < 1.0
            colour = PALETTE[0] if surely else PALETTE[1]
            axes.plot([low, high], [place, place], color=colour, linewidth=2.6)
            axes.plot([ratio], [place], "o" if surely else "s", color=colour, markersize=6.5)
        axes.axvline(1.0, color=GREY, linestyle="--", linewidth=1.2)
        axes.set_yticks(range(len(ordered)), [name for name, _ in ordered])
        axes.set(title=title, xlabel="share of the clock's error")
        axes.set(ylim=(len(ordered) - 0.4, -0.6))
        axes.grid(axis="x")
        words = [f"{name} {left.of_clock:.2f}" for name, left in ordered]
        return picture(
            figure,
            f"{title} on {summary.name}: {'; '.join(words)}.",
            f"Time-averaged absolute error of the time left. The clock, {clock:.0f} ms off, knows only the "
            f"median movement time of the set. Bars: {100 * summary.interval.level:g} % bootstrap interval. "
            "Where a predictor claims no time the clock is scored in its place.",
        )


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
