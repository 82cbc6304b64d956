"""What a summary says of claims: regions, the time left, hits in the target; each with intervals."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from pointpred.columns import BoolArray, FloatArray
from pointpred.scoring import calibration, time_left
from pointpred.scoring.bootstrap import ratio_intervals
from pointpred.scoring.moments import DECILES
from pointpred.scoring.results import TIME_FRACTIONS, PredictorErrors

Json = dict[str, Any]


def claims(errors: PredictorErrors, mask: BoolArray, users: Sequence[str], *, seed: int, draws: int) -> Json:
    """``calibration``, ``time_left`` and ``hits`` of the chosen trials; ``None`` without claims."""

    def shares(told: FloatArray | None, below: FloatArray | None = None) -> list[Json] | None:
        if told is None or not mask.any():
            return None
        flat = told[mask].reshape(int(mask.sum()), -1)
        known = np.isfinite(flat).astype(np.float64) if below is None else below[mask].reshape(len(flat), -1)
        return _ratios(np.nan_to_num(flat, nan=0.0), known, users, seed, draws)

    regions = shares(errors.inside_by_time)
    times = shares(errors.time_inside_by_time)
    hits = shares(errors.hits)
    left = errors.time_left
    clock = None if left is None else shares(left[:, time_left.ERROR], left[:, time_left.CLOCK])
    return {
        "calibration": _calibration(errors, mask, regions),
        "time_left": None if left is None or clock is None else _time_left(left[mask], clock[0], times),
        "hits": None if hits is None else _hits(errors, mask, hits),
    }


def _ratios(above: FloatArray, below: FloatArray, users: Sequence[str], seed: int, draws: int) -> list[Json]:
    """Sum over sum of each column, with its interval over people."""
    bounds = ratio_intervals(above, below, users, seed=seed, draws=draws)
    found = []
    for i, (top, under) in enumerate(zip(above.sum(axis=0), below.sum(axis=0), strict=True)):
        pair = [number(bounds.low[i]), number(bounds.high[i])]
        found.append(
            {
                "share": number(top / under) if under > 0.0 else None,
                "interval": None if None in pair else pair,
                "trials": int((below[:, i] > 0.0).sum()),
            }
        )
    return found


def number(value: float) -> float | None:
    """A number that JSON can say."""
    return float(value) if np.isfinite(value) else None


def _levels(values: FloatArray) -> Json:
    return {str(level): number(value) for level, value in zip(calibration.LEVELS, values, strict=True)}


def _by_time(cells: list[Json]) -> Json:
    """At each decile of the time: how many trials claimed something, and the share of each level inside."""
    count, found = len(calibration.LEVELS), {}
    for k, share in enumerate(DECILES):
        row = cells[count * k : count * (k + 1)]
        found[str(share)] = {
            "trials": row[0]["trials"],
            "inside": {str(p): one["share"] for p, one in zip(calibration.LEVELS, row, strict=True)},
            "interval": {str(p): one["interval"] for p, one in zip(calibration.LEVELS, row, strict=True)},
        }
    return found


def _calibration(errors: PredictorErrors, mask: BoolArray, cells: list[Json] | None) -> Json | None:
    """How often predicted regions held the endpoint; means over the trials in which any was given."""
    if errors.calibration is None:
        return None
    rows = errors.calibration[mask]
    claimed = rows[:, calibration.CLAIMED]
    if not (claimed > 0.0).any():
        return None
    given = rows[claimed > 0.0].mean(axis=0)
    return {
        "claimed": number(claimed.mean()),
        "inside": _levels(given[calibration.INSIDE : calibration.RANKED]),
        "ranked_score_px": number(given[calibration.RANKED]),
        "by_time": None if cells is None else _by_time(cells),
    }


def _time_left(rows: FloatArray, ratio: Json, cells: list[Json] | None) -> Json:
    """The error beside the clock's; intervals where any were claimed."""
    spread = rows[rows[:, time_left.SPREAD] > 0.0]
    return {
        "claimed": number(rows[:, time_left.CLAIMED].mean()),
        "s": number(rows[:, time_left.ERROR].mean()),
        "clock_s": number(rows[:, time_left.CLOCK].mean()),
        "of_clock": ratio["share"],
        "interval": ratio["interval"],
        "inside": _levels(spread[:, time_left.INSIDE :].mean(axis=0)) if len(spread) else None,
        "by_time": _by_time(cells) if cells is not None and len(spread) else None,
    }


def _hits(errors: PredictorErrors, mask: BoolArray, cells: list[Json]) -> Json | None:
    """Share of trials whose prediction lies in the target, of those whose target is known."""
    known = cells[0]["trials"]
    if errors.hits is None or not known:
        return None
    named = zip(map(str, TIME_FRACTIONS), cells, strict=True)
    by_time = {name: {"share": one["share"], "interval": one["interval"]} for name, one in named}
    return {"trials": known, "by_time": by_time}
