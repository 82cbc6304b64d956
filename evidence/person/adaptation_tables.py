"""Tables and figure of docs/guide/adaptation.md."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import msgspec
import numpy as np

from evidence import FIGURES
from evidence.data import Table, keep
from evidence.thinning import save
from pointpred.drawing import GREY, MARKERS, PALETTE, canvas, legend_outside, picture
from pointpred.records import FloatArray
from pointpred.scoring.measures import time_left
from pointpred.scoring.results import TIME_FRACTIONS, PredictorErrors

FIGURE = FIGURES / "adaptation.svg"
FLOOR, PLAIN, ORDERED = "hold", "kinematic", "kinematic-adaptive"
UNPLACED, PLACED = "without places", "places, without their order"
ALL = (PLAIN, UNPLACED, PLACED, ORDERED)
STAGES = ((0, 5, "1-5"), (5, 10, "6-10"), (10, 20, "11-20"), (20, 10**9, "21+"))
LATE, LATE_OF_FEW = 20, 12
"""Movements after which a person is known."""
EDGES = (0, 1, 2, 3, 5, 8, 12, 20, 48, 150, 10**9)


class Measured(msgspec.Struct):
    """A set, a row a trial: its number in its user's order, whether its end repeats, errors by predictor."""

    name: str
    order: list[FloatArray]
    repeated: list[FloatArray]
    errors: dict[str, list[PredictorErrors]]


def column(one: Measured, name: str, field: str) -> FloatArray:
    """One measure of one predictor, a row a trial."""
    return np.concatenate([np.asarray(getattr(errors, field)) for errors in one.errors[name]])


def ratio(one: Measured, name: str, over: str, low: int = 0, high: int = 10**9) -> float:
    """Mean time-averaged error over that of another, of the trials low .. high of each person."""
    order = np.concatenate(one.order)
    rows = (order >= low) & (order < high)
    if not rows.any():
        return float("nan")
    own, other = (column(one, who, "time_averaged")[rows].mean() for who in (name, over))
    return float(own / other)


def number(value: float) -> str:
    """Three digits; nothing where there is none."""
    return "" if np.isnan(value) else f"{value:.3f}"


def by_trial(sets: Sequence[Measured]) -> Table:
    """Error over `hold`, by how many movements of the person came before."""
    rows = []
    for one in sets:
        users = int((np.concatenate(one.order) == 0).sum())
        for name in ALL:
            cells = [number(ratio(one, name, FLOOR, low, high)) for low, high, _ in STAGES]
            near = f"{100 * np.nanmean(np.concatenate(one.repeated)):.0f} %"
            rows.append((one.name, str(users), near, label(name), *cells, number(ratio(one, name, FLOOR))))
    header = ("set", "people", "ends that repeat", "predictor", *(words for _, _, words in STAGES), "all")
    return Table.of(header, rows)


def label(name: str) -> str:
    """A predictor's name as tables show it."""
    return name if name in (UNPLACED, PLACED) else f"`{name}`"


def by_time(sets: Sequence[Measured]) -> Table:
    """Error over `hold` at shares of the time."""
    rows = []
    for one in sets:
        floor = column(one, FLOOR, "by_time").mean(axis=0)
        for name in ALL:
            shares = column(one, name, "by_time").mean(axis=0) / floor
            rows.append((one.name, label(name), *(f"{share:.2f}" for share in shares)))
    return Table.of(("set", "predictor", *(f"{100 * share:.0f} %" for share in TIME_FRACTIONS)), rows)


def arrivals(sets: Sequence[Measured]) -> Table:
    """The time left and its intervals, from the 21st movement on, the 13th where nobody makes so many."""
    rows = []
    for one in sets:
        order = np.concatenate(one.order)
        late = order >= (LATE if (order >= LATE).any() else LATE_OF_FEW)
        cells: list[str] = []
        for name in (PLAIN, ORDERED):
            left = column(one, name, "time_left")[late]
            error, clock = np.nanmean(left[:, [time_left.ERROR, time_left.CLOCK]], axis=0)
            inside = np.nanmean(left[:, time_left.INSIDE :][:, :2], axis=0)
            cells += [f"{error / clock:.2f}", " / ".join(f"{100 * share:.0f}" for share in inside)]
        rows.append((one.name, str(int(late.sum())), *cells))
    header = (
        "set",
        "movements",
        "over the clock",
        "intervals",
        "over the clock, adapted",
        "adapted",
    )
    return Table.of(header, rows)


def figure(sets: Sequence[Measured]) -> None:
    """Error of the adapted over the unadapted, by how many movements came before."""
    with canvas(width=6.5, height=4.3) as (drawing, (axes,)):
        for place, one in enumerate(sets):
            order = np.concatenate(one.order)
            xs, ys = [], []
            for low, high in pairwise(EDGES):
                rows = (order >= low) & (order < high)
                if rows.any():
                    xs.append(float(order[rows].mean()) + 1.0)
                    ys.append(ratio(one, ORDERED, PLAIN, low, high))
            colour, marker = PALETTE[place % len(PALETTE)], MARKERS[place % len(MARKERS)]
            dash = "solid" if place < len(PALETTE) else "dotted"
            axes.plot(xs, ys, color=colour, marker=marker, linestyle=dash, markersize=4, label=one.name)
        axes.axhline(1.0, color=GREY, linewidth=0.8)
        axes.set(xscale="log", xlabel="movement of the person", ylabel="error over that of kinematic")
        axes.xaxis.set_major_formatter("{x:g}")
        legend_outside(drawing, axes, columns=4)
        image = picture(drawing, "error over that of kinematic, by movement", "")
    save(image.svg, FIGURE)


def written(sets: Sequence[Measured]) -> None:
    """Keep the tables and draw the figure."""
    keep(
        "person",
        {
            "by trial": by_trial(sets),
            "by time": by_time(sets),
            "arrivals": arrivals(sets),
        },
        part="adaptation",
    )
    figure(sets)
