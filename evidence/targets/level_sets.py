"""Where movements end beside the level sets of the mixture given the targets, and how large these are."""

from __future__ import annotations

import msgspec
import numpy as np

from evidence.person.regions import LEVELS, MIDDLE, SHARES, rows_of_shares, turns
from pointpred import Pipeline, PredictionColumns, run
from pointpred.predictors.mixture import HEAVINESS_LEAST, Mixture, content, corrected_probability
from pointpred.records import FloatArray
from pointpred.scoring import Prepared

POINTS = 64
"""Of each part of a mixture, by which the probability of what is denser than the end is found."""
EVERY = 3
"""The area of every third movement is measured, which takes 10 ms."""


class Read(msgspec.Struct, frozen=True):
    """A row a movement."""

    inside: FloatArray
    """(movements, shares, levels): 1 where the level set holds the endpoint, NaN where nothing is stated."""
    narrower: FloatArray
    """Area of the ellipse at half of the time with targets over that without."""
    level_set: FloatArray
    """Area of the level set of 80 % at half of the time over that of the ellipse, both with targets."""


def read(prepared: Prepared, given: Pipeline, plain: Pipeline) -> Read:
    """The movements of each person in order, through a pipeline that has the targets and one without."""
    assert prepared.candidates is not None
    count = len(prepared.trials)
    inside = np.full((count, len(SHARES), len(LEVELS)), np.nan)
    narrower, level_set = np.full(count, np.nan), np.full(count, np.nan)
    for _, trials in turns(prepared):
        told, alone = given.fresh(), plain.fresh()
        for k in trials:
            told.reset()
            told.register(prepared.candidates.targets[k])
            events, rows = prepared.rows(k), rows_of_shares(prepared, k)
            before = run(alone, events).table[rows[MIDDLE]]
            at, now = 0, before
            for share, row in enumerate(rows.tolist()):
                if row >= at:
                    now, at = run(told, events.rows(at, row + 1)).table[-1], row + 1
                mixture = told.mixture
                if mixture is None:
                    continue
                inside[k, share] = holds(mixture, float(events.x[-1]), float(events.y[-1]))
                if share == MIDDLE:
                    narrower[k] = area(now) / area(before)
                    if k % EVERY == 0:
                        level_set[k] = mixture.region(LEVELS[1]).area / area(now)
            if at < len(events):
                run(told, events.rows(at, len(events)))
    return Read(inside, narrower, level_set)


def holds(mixture: Mixture, x: float, y: float) -> list[bool]:
    """Whether the level set of each level holds a point: what is denser has no more probability."""
    table, tail = mixture.table, mixture.parts[0].tail or 2.0 / HEAVINESS_LEAST
    denser = content(table, len(table), x, y, POINTS)
    return [denser <= corrected_probability(level, tail, *mixture.offsets) for level in LEVELS]


def area(row: FloatArray) -> float:
    """Of the ellipse of 80 %; NaN where none is stated."""
    major, minor = PredictionColumns(row[None]).region(LEVELS[1]).table[0, 2:4].tolist()
    return float(np.pi * major * minor)
