"""What adaptation is worth: ``python -m evidence person adaptation [FOLDER]``.

Lets the learned predictor, fitted to other people, predict the movements in POINTPRED_RECORDINGS without
adaptation and with parts of it, every person's movements in order of recording. Takes minutes.
FOLDER: coefficients as ``python -m evidence.held_out FOLDER`` writes them; unless given, those of the cache.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from itertools import pairwise
from pathlib import Path

import msgspec
import numpy as np

from evidence import FIGURES
from evidence.arguments import parse
from evidence.data import Table, keep
from evidence.held_out import HeldOut, held_out, stored
from evidence.thinning import save
from pointpred import Pipeline, build
from pointpred.drawing import GREY, MARKERS, PALETTE, canvas, legend_outside, picture
from pointpred.predictors import AdaptiveKinematicPredictor, KinematicPredictor
from pointpred.recording import Recording
from pointpred.records import FloatArray
from pointpred.scoring import Prepared, prepare, resolution
from pointpred.scoring.measures import time_left
from pointpred.scoring.replay import replay
from pointpred.scoring.results import TIME_FRACTIONS, PredictorErrors
from pointpred.training import data

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


NEAR_PX, LAST = 40.0, 64
"""An end repeats where one of so many earlier ones of the person lies so near."""


def parts(recording: Recording, coefficients: HeldOut) -> Iterator[tuple[Recording, Path]]:
    """The recording of each fold of its people, and the coefficients that were fitted to none of them."""
    folds = np.array([coefficients.fold_of[f"{recording.name} {one.user}"] for one in recording.trials])
    for fold in np.unique(folds).tolist():
        rows = np.flatnonzero(folds == fold).tolist()
        trials = [recording.trials[k] for k in rows]
        yield (
            Recording.of(recording.name, [recording.rows(k) for k in rows], trials),
            coefficients.folds[fold],
        )


def pipelines(recording: Recording, path: Path) -> list[Pipeline]:
    """No prediction, the learned predictor, and it with more and more parts of the adaptation."""
    floor = build(FLOOR, **resolution(recording, None, None))
    predictors = {
        PLAIN: KinematicPredictor(coefficients=path),
        UNPLACED: AdaptiveKinematicPredictor(places=0, coefficients=path),
        PLACED: AdaptiveKinematicPredictor(sequence=0, coefficients=path),
        ORDERED: AdaptiveKinematicPredictor(coefficients=path),
    }
    return [floor, *(Pipeline(name, floor.differentiator.fresh(), one) for name, one in predictors.items())]


def numbered(users: list[str]) -> FloatArray:
    """Place of each trial among those of its user, from 0."""
    counts: dict[str, int] = {}
    order = []
    for user in users:
        order.append(counts.get(user, 0))
        counts[user] = order[-1] + 1
    return np.array(order, dtype=np.float64)


def repeated(prepared: Prepared) -> FloatArray:
    """For each trial whether it ends near an earlier end of its user; NaN for the first of a user."""
    earlier: dict[str, list[FloatArray]] = {}
    result = []
    for k, scored in enumerate(prepared.trials):
        rows = prepared.rows(k)
        end, ends = np.array([rows.x[-1], rows.y[-1]]), earlier.setdefault(scored.trial.user, [])
        away = np.linalg.norm(np.array(ends[-LAST:]) - end, axis=1) if ends else np.array([np.nan])
        result.append(np.nan if np.isnan(away).any() else float(away.min() <= NEAR_PX))
        ends.append(end)
    return np.array(result)


def measure(coefficients: HeldOut) -> list[Measured]:
    """Every set, its people predicted by coefficients that knew none of them."""
    results: dict[str, Measured] = {}
    for recording in data.read_sets(data.folder()):
        for part, path in parts(recording, coefficients):
            one = results.setdefault(part.name, Measured(part.name, [], [], {}))
            settings = {k: v for k, v in resolution(part, None, None).items() if v is not None}
            prepared = prepare(part, **settings)
            one.order.append(numbered([scored.trial.user for scored in prepared.trials]))
            one.repeated.append(repeated(prepared))
            for pipeline in pipelines(part, path):
                one.errors.setdefault(pipeline.name, []).append(replay(prepared, pipeline, threads=1))
            print(f"{part.name}: {len(prepared.trials)} trials with {path.name}", file=sys.stderr, flush=True)
    return list(results.values())


if __name__ == "__main__":
    named = parse(__doc__, metavar="FOLDER", most=1)
    known = stored(Path(named[0])) if named else held_out(data.folder())
    written(measure(known))
