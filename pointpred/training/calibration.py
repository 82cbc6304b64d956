"""The table that makes regions as sure as they log, from people the network was not fitted to."""

from __future__ import annotations

from math import log

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.compiled import law
from pointpred.predictors.kinematic import features
from pointpred.predictors.kinematic import network as net
from pointpred.records import FloatArray
from pointpred.scoring.measures.endpoint import DECILES
from pointpred.scoring.measures.regions import LEVELS, reach
from pointpred.scoring.measures.time_left import DEVIATIONS
from pointpred.training.data import Examples
from pointpred.training.fitting import FittedNetwork, Settings, point, truth

STRETCHES = len(DECILES)
"""Of the true share of the time, around 10, 20 ... 90 %."""
SOFT = 0.15
"""Width, in logarithms of distance, over which an endpoint counts as half inside."""
SMOOTH = 0.02
"""What a bend of the table between three knots costs, against a coverage that is off."""
ROWS_MOST = 40_000


class Claims(msgspec.Struct, frozen=True):
    """What a network predicted for moments of people it was not fitted to, and how it turned out."""

    predicted_share: FloatArray
    """Share of the time that has passed, as the network predicts."""
    share: FloatArray
    surprise: FloatArray
    """Squared Mahalanobis distance of the endpoint."""
    tail: FloatArray
    late: FloatArray
    """Deviations of the logarithm of the time left."""
    weight: FloatArray

    def only(self, rows: NDArray[np.bool_] | NDArray[np.int64]) -> Claims:
        """Some of the rows."""
        return Claims(*(getattr(self, name)[rows] for name in self.__struct_fields__))


def claims_of(fitted: FittedNetwork, examples: Examples, settings: Settings) -> Claims:
    """A fitted network's claims about examples, before any calibration."""
    outputs, target = fitted.outputs(examples.features), truth(examples, settings)
    along, across = point(outputs, target)
    values = outputs.astype(np.float64)
    wide = np.exp(np.clip(values[:, net.WIDE], *net.WIDTH_LOGS))
    broad = np.exp(np.clip(values[:, net.BROAD], *net.WIDTH_LOGS))
    left = _left(values, examples)
    spread = np.exp(np.clip(values[:, net.SPREAD], *net.SPREAD_LOGS))
    return Claims(
        target.since_s / (target.since_s + left),
        examples.share,
        ((along - target.along) / wide) ** 2 + ((across - target.across) / broad) ** 2,
        np.exp(np.clip(values[:, net.TAIL], *net.TAIL_LOGS)),
        np.log(np.maximum(examples.left_s, 1e-4) / left) / spread,
        target.law_weight.astype(np.float64),
    )


def _left(values: FloatArray, examples: Examples) -> FloatArray:
    since = examples.features[:, features.PLACE["time"]].astype(np.float64)
    ahead: FloatArray = np.exp(np.clip(values[:, net.LEFT], *net.LEFT_LOGS))
    return (since + net.HEAD_START_S) * ahead


def time_left(fitted: FittedNetwork, examples: Examples) -> FloatArray:
    """The time left in s that a network says for examples."""
    return _left(fitted.outputs(examples.features).astype(np.float64), examples)


def join(parts: list[Claims]) -> Claims:
    """Rows of several networks together."""
    names = Claims.__struct_fields__
    return Claims(*(np.concatenate([getattr(part, name) for part in parts]) for name in names))


def factors(table: FloatArray, share: FloatArray, which: int) -> FloatArray:
    """``network.factor`` of many shares."""
    knots = (np.arange(net.KNOTS) + 0.5) / net.KNOTS
    scales: FloatArray = np.exp(np.interp(share, knots, table[:, which]))
    return scales


@law
def fill_reaches(level: float, tail: FloatArray, far: FloatArray) -> None:
    """``reaches`` into an array."""
    for i in range(len(tail)):
        far[i] = reach(level, tail[i])


def reaches(level: float, tail: FloatArray) -> FloatArray:
    """Squared Mahalanobis distance up to which a Student law's region of a level goes, for many tails."""
    far = np.empty(len(tail))
    fill_reaches(level, np.ascontiguousarray(tail), far)
    return far


def fit_table(claims: Claims, seed: int = 0) -> FloatArray:
    """The table with which each level's share of endpoints inside is right at every decile of the time."""
    from scipy.optimize import least_squares

    if len(claims.share) > ROWS_MOST:
        sample = np.random.default_rng(seed).choice(len(claims.share), ROWS_MOST, replace=False)
        claims = claims.only(np.sort(sample))
    decile = np.clip(np.round(claims.share * 10.0).astype(int) - 1, 0, STRETCHES - 1)
    total = np.bincount(decile, claims.weight, STRETCHES)
    place = np.clip(claims.predicted_share * net.KNOTS - 0.5, 0.0, net.KNOTS - 1.0)
    knot = np.minimum(place.astype(int), net.KNOTS - 2)
    part = place - knot

    def at(values: FloatArray) -> FloatArray:
        low = values[knot]
        between: FloatArray = low + part * (values[knot + 1] - low)
        return between

    def off(logs: list[FloatArray], columns: list[FloatArray]) -> FloatArray:
        shares = []
        for level, gap in zip(LEVELS, logs, strict=False):
            inside = 1.0 / (1.0 + np.exp(np.clip(-gap / SOFT, -40.0, 40.0)))
            shares.append(np.bincount(decile, claims.weight * inside, STRETCHES) / total - level)
        bends = [SMOOTH * np.diff(column, 2) for column in columns] + [0.1 * SMOOTH * c for c in columns]
        return np.concatenate([*shares, *bends])

    surprise = np.log(np.maximum(claims.surprise, 1e-12))

    def regions(values: FloatArray) -> FloatArray:
        width, tail = values[: net.KNOTS], values[net.KNOTS :]
        heavy = claims.tail * np.exp(np.clip(at(tail), -3.0, 3.0))
        return off(
            [np.log(reaches(level, heavy)) + 2.0 * at(width) - surprise for level in LEVELS], [width, tail]
        )

    late = np.log(np.maximum(np.abs(claims.late), 1e-6))

    def times(values: FloatArray) -> FloatArray:
        return off([2.0 * (log(z) + at(values) - late) for z in DEVIATIONS[:2]], [values])

    solution = least_squares(regions, np.zeros(2 * net.KNOTS), max_nfev=15).x
    spread = least_squares(times, np.zeros(net.KNOTS), max_nfev=40).x
    table = np.empty((net.KNOTS, net.FACTORS))
    table[:, net.WIDTH_FACTOR] = solution[: net.KNOTS]
    table[:, net.TAIL_FACTOR] = np.clip(solution[net.KNOTS :], -3.0, 3.0)
    table[:, net.SPREAD_FACTOR] = spread
    return np.round(table, 6)


def apply_table(claims: Claims, table: FloatArray) -> Claims:
    """The claims after calibration."""
    widths = factors(table, claims.predicted_share, net.WIDTH_FACTOR)
    return msgspec.structs.replace(
        claims,
        surprise=claims.surprise / widths**2,
        tail=claims.tail * factors(table, claims.predicted_share, net.TAIL_FACTOR),
        late=claims.late / factors(table, claims.predicted_share, net.SPREAD_FACTOR),
    )


def coverage(claims: Claims) -> FloatArray:
    """Shares inside, a row a decile, a column a level: regions, then intervals of the time left."""
    decile = np.clip(np.round(claims.share * 10.0).astype(int) - 1, 0, STRETCHES - 1)
    total = np.bincount(decile, claims.weight, STRETCHES)
    columns = [claims.surprise <= reaches(level, claims.tail) for level in LEVELS]
    columns += [np.abs(claims.late) <= z for z in DEVIATIONS]
    return np.stack([np.bincount(decile, claims.weight * c, STRETCHES) / total for c in columns], axis=1)
