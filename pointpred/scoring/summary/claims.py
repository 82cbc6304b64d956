"""How true a predictor's claims are: its regions, its time left, and its point beside the target."""

from __future__ import annotations

from typing import NamedTuple

import msgspec

from pointpred.columns import FloatArray
from pointpred.scoring.measures import regions
from pointpred.scoring.measures.endpoint import DECILES
from pointpred.scoring.results import TIME_FRACTIONS, PredictorErrors
from pointpred.scoring.summary import sums
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
RATIOS = (
    (sums.INSIDE, sums.INSIDE_MADE, sums.CELLS),
    (sums.LEFT_INSIDE, sums.LEFT_MADE, sums.CELLS),
    (sums.HITS, sums.HITS_MADE, sums.TIMES),
    (sums.LEFT, sums.CLOCK, 1),
)
"""Columns that are divided by columns, and how many; each ratio has an interval."""


class Totals(msgspec.Struct, frozen=True):
    """The sums of one predictor over the trials of a group."""

    trials: int
    sums: FloatArray
    """(WIDTH,)"""
    low: FloatArray
    high: FloatArray
    """(WIDTH,): bounds of the ratios of RATIOS, at the places of what is divided"""


class Ratio(NamedTuple):
    """Sum over sum of one column."""

    share: Number
    interval: Interval
    trials: int
    """Trials with such a claim."""


def claims(errors: PredictorErrors, totals: Totals) -> Claims:
    """What became of the claims in a group of trials; ``errors`` says which there are in the set."""
    if not totals.trials:
        return None, None, None
    inside, times, hits, (clock,) = (_ratios(totals, *columns) for columns in RATIOS)
    return (
        None if errors.calibration is None else _calibration(errors, totals, inside),
        None if errors.time_left is None else _time_left(errors, totals, clock, times),
        None if errors.hits is None or not hits[0].trials else _hits(hits),
    )


def _ratios(totals: Totals, above: int, below: int, count: int) -> list[Ratio]:
    return [
        Ratio(
            number(totals.sums[above + i] / totals.sums[below + i]) if totals.sums[below + i] > 0.0 else None,
            interval(totals.low[above + i], totals.high[above + i]),
            int(totals.sums[below + i]),
        )
        for i in range(count)
    ]


def _levels(values: FloatArray) -> dict[float, Number]:
    return {level: number(value) for level, value in zip(regions.LEVELS, values, strict=True)}


def _by_time(cells: list[Ratio]) -> dict[float, InsideAtTime]:
    """At each decile of the time the share of each level inside; ``cells`` has a row a decile and level."""
    rows = (cells[sums.LEVELS * k : sums.LEVELS * (k + 1)] for k in range(len(DECILES)))
    return {
        share: InsideAtTime(
            row[0].trials,
            {level: one.share for level, one in zip(regions.LEVELS, row, strict=True)},
            {level: one.interval for level, one in zip(regions.LEVELS, row, strict=True)},
        )
        for share, row in zip(DECILES, rows, strict=True)
    }


def _calibration(errors: PredictorErrors, totals: Totals, cells: list[Ratio]) -> Calibration | None:
    """Means over the trials in which any region was claimed."""
    claimed = totals.sums[sums.REGIONS]
    if not claimed:
        return None
    means = totals.sums[sums.REGION : sums.TIMED] / claimed
    return Calibration(
        number(totals.sums[sums.CLAIMED] / totals.trials),
        _levels(means[: sums.LEVELS]),
        number(means[sums.LEVELS]),
        None if errors.inside_by_time is None else _by_time(cells),
    )


def _time_left(errors: PredictorErrors, totals: Totals, clock: Ratio, cells: list[Ratio]) -> TimeLeft:
    """The error beside the clock's; shares inside where any intervals were claimed."""
    spread = totals.sums[sums.SPREADS]
    return TimeLeft(
        number(totals.sums[sums.TIMED] / totals.trials),
        number(totals.sums[sums.LEFT] / totals.trials),
        number(totals.sums[sums.CLOCK] / totals.trials),
        clock.share,
        clock.interval,
        _levels(totals.sums[sums.SPREAD :] / spread) if spread else None,
        _by_time(cells) if errors.time_inside_by_time is not None and spread else None,
    )


def _hits(cells: list[Ratio]) -> Hits:
    by_time = {
        share: HitShare(one.share, one.interval) for share, one in zip(TIME_FRACTIONS, cells, strict=True)
    }
    return Hits(cells[0].trials, by_time)
