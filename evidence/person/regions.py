"""How often the drawn regions hold the endpoint: ``python -m evidence person regions [FOLDER]``.

The movements of every person in POINTPRED_RECORDINGS, in the order of recording, through a pipeline whose
coefficients did not know the person; whether the endpoint lies inside the ellipse of each level. FOLDER:
coefficients as ``python -m evidence.held_out FOLDER`` writes them; unless given, those of the cache, fitted
where they are missing.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

import msgspec
import numpy as np
from numpy.typing import NDArray

from evidence.arguments import parse
from evidence.data import Table, keep
from evidence.held_out import HeldOut, held_out, stored
from pointpred import Pipeline, PredictionColumns, run
from pointpred.recording import Recording
from pointpred.records import BoolArray, FloatArray
from pointpred.scoring import Prepared, prepare
from pointpred.scoring.measures.endpoint import moments
from pointpred.training import data

LEVELS, SHARES = (0.5, 0.8), (0.3, 0.5, 0.7)
"""The ellipses that are drawn, and when: shares of the time from onset to arrival."""
LEARNT, LEARNT_OF_FEW = 20, 12
"""Movements of a person after which an adaptive predictor is judged once more; where nobody makes so many."""
ADAPTIVE, MIXTURE = "kinematic-adaptive", "mixture"
MIDDLE = SHARES.index(0.5)
EVERY = "all"


class Drawn(msgspec.Struct, frozen=True):
    """A set and a predictor, a row a movement."""

    set: str
    predictor: str
    people: NDArray[np.str_]
    order: NDArray[np.int64]
    """Place among the movements of the person, from 0."""
    inside: FloatArray
    """(movements, shares, levels): 1 where the ellipse holds the endpoint, NaN where none is drawn."""
    size: FloatArray
    """(movements, levels): root of the product of the half axes at half of the time, px."""
    way: FloatArray
    """From the cursor to the endpoint at half of the time, px."""


def pooled(sets: Sequence[Drawn]) -> Drawn:
    """All movements of all sets, each counted once."""
    columns = {
        name: np.concatenate([getattr(one, name) for one in sets]) for name in Drawn.__struct_fields__[3:]
    }
    people = np.concatenate([np.char.add(f"{one.set} ", one.people) for one in sets])
    return Drawn(EVERY, sets[0].predictor, people, **columns)


def coverage(sets: Sequence[Drawn]) -> Table:
    """Shares inside, %, of all movements and of those after the first ones of each person."""
    rows = []
    for one in (*sets, pooled(sets)):
        for label, some in parts(one):
            people = len(set(one.people[some].tolist()))
            shares = [share(one.inside[some, :, k]) for k in range(len(LEVELS))]
            rows.append((one.set, label, str(people), str(int(some.sum())), *shares))
    times = " / ".join(f"{100 * share:.0f}" for share in SHARES)
    sentences = (f"in the {100 * level:.0f} % ellipse at {times} % of the time" for level in LEVELS)
    return Table.of(("set", "movements", "people", "number", *sentences), rows)


def parts(one: Drawn) -> list[tuple[str, BoolArray]]:
    """All movements, and those after the person's first ones where there are any."""
    learnt = learnt_of(one)
    every = ("all", np.ones(len(one.order), np.bool_))
    later = one.order >= learnt
    return [every, (f"after {learnt}", later)] if later.any() else [every]


def learnt_of(one: Drawn) -> int:
    """Movements after which the people of a set are known."""
    return LEARNT if (one.order >= LEARNT).any() else LEARNT_OF_FEW


def share(inside: FloatArray) -> str:
    """Shares of a column each, %; a dash where nothing is drawn at any movement."""
    return " / ".join(_mean(inside[:, k], lambda mean: f"{100 * mean:.0f}") for k in range(inside.shape[1]))


def sizes(sets: Sequence[Drawn]) -> Table:
    """Median size at half of the time, beside the way that is left."""
    rows = []
    for one in (*sets, pooled(sets)):
        half = [f"{np.nanmedian(one.size[:, k]):.0f}" for k in range(len(LEVELS))]
        rows.append((one.set, *half, f"{np.median(one.way):.0f}"))
    names = (f"{100 * level:.0f} % ellipse, px" for level in LEVELS)
    return Table.of(("set", *names, "from the cursor to the endpoint, px"), rows)


def areas(single: Sequence[Drawn], mixture: Sequence[Drawn]) -> Table:
    """The region of the mixture over the ellipse at half of the time, of people who are known."""
    rows = []
    for one, other in zip(single, mixture, strict=True):
        later = one.order >= learnt_of(one)
        logs = 2.0 * np.log(other.size[later] / one.size[later])
        means = [f"{np.exp(np.nanmean(logs[:, k])):.2f}" for k in range(len(LEVELS))]
        medians = [
            f"{np.pi * np.nanmedian(which.size[later, k]) ** 2:.0f}" for k in (0, 1) for which in (one, other)
        ]
        rows.append((one.set, str(int(later.sum())), *means, *medians))
    return Table.of(
        (
            "set",
            "number",
            "50 %: mixture over ellipse",
            "80 %: mixture over ellipse",
            *("50 % ellipse, px^2", "mixture, px^2", "80 % ellipse, px^2", "mixture, px^2"),
        ),
        rows,
    )


def _mean(values: FloatArray, text: Callable[[float], str]) -> str:
    there = values[~np.isnan(values)]
    return text(float(there.mean())) if len(there) else "-"


def written(results: Sequence[Drawn]) -> None:
    """Keep the tables."""
    tables = {}
    for name in dict.fromkeys(one.predictor for one in results):
        mine = [one for one in results if one.predictor == name]
        tables[f"coverage {name}"] = coverage(mine)
        tables[f"sizes {name}"] = sizes(mine)
    one, other = ([result for result in results if result.predictor == name] for name in (ADAPTIVE, MIXTURE))
    tables["areas"] = areas(one, other)
    keep("person", tables, part="regions")


NAMES = ("kinematic", ADAPTIVE)


def drawn(name: str, coefficients: HeldOut, recording: Recording) -> Drawn:
    """What is drawn along the movements of a set, by coefficients that did not know the person."""
    prepared, pipelines = prepare(recording), coefficients.of_people(name, recording)
    who, order, columns = [], [], []
    for user, trials in turns(prepared):
        pipeline = pipelines[user].fresh()
        who += [user] * len(trials)
        order += range(len(trials))
        columns += [read(prepared, k, run(pipeline, prepared.rows(k))) for k in trials]
    inside, size, way = (np.array(column) for column in zip(*columns, strict=True))
    return Drawn(recording.name, name, np.array(who), np.array(order), inside, size, way)


def mixed(coefficients: HeldOut, recording: Recording) -> Drawn:
    """The regions of the mixture along the movements of a set."""
    prepared, pipelines = prepare(recording), coefficients.of_people(ADAPTIVE, recording)
    who, order, columns = [], [], []
    for user, trials in turns(prepared):
        pipeline = pipelines[user].fresh()
        who += [user] * len(trials)
        order += range(len(trials))
        columns += [read_mixture(prepared, k, pipeline) for k in trials]
    inside, size, way = (np.array(column) for column in zip(*columns, strict=True))
    return Drawn(recording.name, MIXTURE, np.array(who), np.array(order), inside, size, way)


def read_mixture(prepared: Prepared, k: int, pipeline: Pipeline) -> tuple[FloatArray, FloatArray, float]:
    """One movement: what ``read`` says, of the mixture; the size is that of a disc of the same area."""
    events, rows, at = prepared.rows(k), rows_of_shares(prepared, k), 0
    end = float(events.x[-1]), float(events.y[-1])
    inside = np.full((len(SHARES), len(LEVELS)), np.nan)
    sizes = np.full(len(LEVELS), np.nan)
    for share, row in enumerate(rows.tolist()):
        if row >= at:
            run(pipeline, events.rows(at, row + 1))
            at = row + 1
        mixture = pipeline.mixture
        for which, level in enumerate(LEVELS):
            if mixture is not None:
                region = mixture.region(level)
                inside[share, which] = region.contains(*end)
                if share == MIDDLE:
                    sizes[which] = np.sqrt(region.area / np.pi)
    if at < len(events):
        run(pipeline, events.rows(at, len(events)))
    here = events.table[rows[MIDDLE], 1:3]
    return inside, sizes, float(np.hypot(end[0] - here[0], end[1] - here[1]))


def turns(prepared: Prepared) -> Iterator[tuple[str, list[int]]]:
    """The movements of each person, in the order of recording."""
    users = [one.trial.user for one in prepared.trials]
    for user in dict.fromkeys(users):
        yield user, [k for k, own in enumerate(users) if own == user]


def read(prepared: Prepared, k: int, answers: PredictionColumns) -> tuple[FloatArray, FloatArray, float]:
    """One movement: whether each ellipse holds the endpoint, their sizes half-way, and the way then left."""
    events, rows = prepared.rows(k), rows_of_shares(prepared, k)
    end, then = (events.x[-1], events.y[-1]), PredictionColumns(answers.table[rows])
    regions = [then.region(level).table for level in LEVELS]
    inside = np.stack([holds(one, *end) for one in regions], axis=-1)
    sizes = np.array([np.sqrt(one[MIDDLE, 2] * one[MIDDLE, 3]) for one in regions])
    here = events.table[rows[MIDDLE], 1:3]
    return inside, sizes, float(np.hypot(end[0] - here[0], end[1] - here[1]))


def rows_of_shares(prepared: Prepared, k: int) -> NDArray[np.int64]:
    """The row of a movement at each of SHARES of its time."""
    events, rows = prepared.rows(k), np.empty(len(SHARES), np.int64)
    arrival = int(prepared.arrivals[k] - prepared.offsets[k])
    moments(events.table, 0, arrival, len(events) - 1, np.array(SHARES), rows)
    return rows


def holds(regions: FloatArray, x: float, y: float) -> FloatArray:
    """1 where an ellipse, a row of ``RegionColumns``, holds a point, NaN where there is none."""
    at_x, at_y, major, minor, angle = regions.T
    along = (x - at_x) * np.cos(angle) + (y - at_y) * np.sin(angle)
    across = (y - at_y) * np.cos(angle) - (x - at_x) * np.sin(angle)
    far = (along / major) ** 2 + (across / minor) ** 2
    return np.where(np.isnan(far), np.nan, (far <= 1.0).astype(np.float64))


def main(coefficients: HeldOut, recordings: list[Recording]) -> None:
    """Every set with every predictor."""
    results = []
    for recording in recordings:
        for name in NAMES:
            results.append(drawn(name, coefficients, recording))
            print(f"{recording.name} {name}: {len(results[-1].order)}", file=sys.stderr, flush=True)
        results.append(mixed(coefficients, recording))
    written(results)


if __name__ == "__main__":
    arguments = parse(__doc__, metavar="folder", most=1)
    folder = data.folder()
    main(stored(Path(arguments[0])) if arguments else held_out(folder), data.read_sets(folder))
