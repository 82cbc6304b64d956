"""How often the drawn regions hold the endpoint: ``python -m evidence person regions [FOLDER]``.

The movements of every person in POINTPRED_RECORDINGS, in the order of recording, through a pipeline whose
coefficients did not know the person; whether the endpoint lies inside the ellipse of each level. FOLDER:
coefficients as ``python -m evidence.held_out FOLDER`` writes them; unless given, those of the cache, fitted
where they are missing.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from evidence.arguments import parse
from evidence.held_out import HeldOut, held_out, stored
from evidence.person.region_tables import ADAPTIVE, LEVELS, MIDDLE, MIXTURE, SHARES, Drawn, written
from pointpred import Pipeline, PredictionColumns, run
from pointpred.recording import Recording
from pointpred.records import FloatArray
from pointpred.scoring import Prepared, prepare
from pointpred.scoring.measures.endpoint import moments
from pointpred.training import data

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
