"""How true a predictor's claims are: its regions, its time left, and its point beside the target."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from pointpred.columns import BoolArray, FloatArray
from pointpred.scoring.measures import regions, time_left
from pointpred.scoring.measures.moments import DECILES
from pointpred.scoring.results import TIME_FRACTIONS, PredictorErrors
from pointpred.scoring.summary.bootstrap import ratio_intervals
from pointpred.scoring.summary.document import (
    Calibration,
    Hits,
    HitShare,
    InsideAtTime,
    Interval,
    Number,
    TimeLeft,
    interval,
    number,
)

Claims = tuple[Calibration | None, TimeLeft | None, Hits | None]


class Ratio(NamedTuple):
    """Sum over sum of one column."""

    share: Number
    interval: Interval
    trials: int
    """Rows that count."""


def claims(
    errors: PredictorErrors, mask: BoolArray, users: Sequence[str], *, seed: int, draws: int
) -> Claims:
    """What became of the claims in the trials of ``mask``, whose people are ``users``.

    ``seed`` and ``draws``: of the bootstrap behind each interval.
    """

    def shares(values: FloatArray | None, below: FloatArray | None = None) -> list[Ratio] | None:
        if values is None or not mask.any():
            return None
        flat = values[mask].reshape(int(mask.sum()), -1)
        counted = (
            np.isfinite(flat).astype(np.float64) if below is None else below[mask].reshape(len(flat), -1)
        )
        return _ratios(np.nan_to_num(flat, nan=0.0), counted, users, seed, draws)

    inside = shares(errors.inside_by_time)
    times = shares(errors.time_inside_by_time)
    targets = shares(errors.hits)
    left = errors.time_left
    clock = None if left is None else shares(left[:, time_left.ERROR], left[:, time_left.CLOCK])
    return (
        None if errors.calibration is None else _calibration(errors.calibration[mask], inside),
        None if left is None or clock is None else _time_left(left[mask], clock[0], times),
        None if targets is None or not targets[0].trials else _hits(targets),
    )


def _ratios(above: FloatArray, below: FloatArray, users: Sequence[str], seed: int, draws: int) -> list[Ratio]:
    """Sum over sum of each column, with its interval over people."""
    bounds = ratio_intervals(above, below, users, seed=seed, draws=draws)
    return [
        Ratio(
            number(top / under) if under > 0.0 else None,
            interval(bounds.low[i], bounds.high[i]),
            int((below[:, i] > 0.0).sum()),
        )
        for i, (top, under) in enumerate(zip(above.sum(axis=0), below.sum(axis=0), strict=True))
    ]


def _levels(values: FloatArray) -> dict[float, Number]:
    return {level: number(value) for level, value in zip(regions.LEVELS, values, strict=True)}


def _by_time(cells: list[Ratio]) -> dict[float, InsideAtTime]:
    """At each decile of the time the share of each level inside; ``cells`` has a row a decile and level."""
    count = len(regions.LEVELS)
    rows = (cells[count * k : count * (k + 1)] for k in range(len(DECILES)))
    return {
        share: InsideAtTime(
            row[0].trials,
            {level: one.share for level, one in zip(regions.LEVELS, row, strict=True)},
            {level: one.interval for level, one in zip(regions.LEVELS, row, strict=True)},
        )
        for share, row in zip(DECILES, rows, strict=True)
    }


def _calibration(rows: FloatArray, cells: list[Ratio] | None) -> Calibration | None:
    """Means over the trials in which any region was claimed."""
    claimed = rows[:, regions.CLAIMED]
    if not (claimed > 0.0).any():
        return None
    means = rows[claimed > 0.0].mean(axis=0)
    return Calibration(
        number(claimed.mean()),
        _levels(means[regions.INSIDE : regions.RANKED]),
        number(means[regions.RANKED]),
        None if cells is None else _by_time(cells),
    )


def _time_left(rows: FloatArray, clock: Ratio, cells: list[Ratio] | None) -> TimeLeft:
    """The error beside the clock's; shares inside where any intervals were claimed."""
    spread = rows[rows[:, time_left.SPREAD] > 0.0]
    return TimeLeft(
        number(rows[:, time_left.CLAIMED].mean()),
        number(rows[:, time_left.ERROR].mean()),
        number(rows[:, time_left.CLOCK].mean()),
        clock.share,
        clock.interval,
        _levels(spread[:, time_left.INSIDE :].mean(axis=0)) if len(spread) else None,
        _by_time(cells) if cells is not None and len(spread) else None,
    )


def _hits(cells: list[Ratio]) -> Hits:
    by_time = {
        share: HitShare(one.share, one.interval) for share, one in zip(TIME_FRACTIONS, cells, strict=True)
    }
    return Hits(cells[0].trials, by_time)
