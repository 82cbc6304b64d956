"""The thesis's single-axis protocol (section 2.6.3): error against path, box plots, analysis of variance."""

from __future__ import annotations

from collections.abc import Sequence

import msgspec
import numpy as np

from pointpred.errors import ParameterError
from pointpred.records import BoolArray, FloatArray
from pointpred.scoring.results import AXIS_FRACTIONS, PredictorErrors, SetScore
from pointpred.scoring.statistics import LEAST_USERS, Effect, anova, balance, cell_means, factors_of

WHISKER = 1.5
"""Whiskers reach the last value within this many interquartile ranges of the box; the rest are outliers."""


class Box(msgspec.Struct, frozen=True):
    """The distribution of one predictor's error at one path fraction, px."""

    count: int
    mean: float
    q1: float
    median: float
    q3: float
    low: float
    high: float
    """Ends of the whiskers: the extreme values that are not outliers."""
    outliers: tuple[float, ...]
    mean_replaced: float
    """Mean with every outlier replaced by the nearer quartile."""


class AxisProfile(msgspec.Struct, frozen=True):
    """Distributions of one predictor, a box a path fraction of AXIS_FRACTIONS."""

    name: str
    boxes: tuple[Box, ...]

    @property
    def mae(self) -> FloatArray:
        """Mean absolute error at each path fraction, px."""
        return np.array([box.mean for box in self.boxes])

    @property
    def mae_replaced(self) -> FloatArray:
        """The same with outliers replaced by the quartile bound, px."""
        return np.array([box.mean_replaced for box in self.boxes])


class AnovaSeries(msgspec.Struct, frozen=True):
    """The analysis at every path fraction; ``effects`` is empty where it cannot be run, and notes say why."""

    models: tuple[str, ...]
    users: int
    factors: tuple[str, ...]
    levels: tuple[tuple[str, ...], ...]
    effects: tuple[tuple[Effect, ...], ...]
    """A tuple of effects for each of AXIS_FRACTIONS."""
    effects_replaced: tuple[tuple[Effect, ...], ...]
    """The same on errors whose outliers were replaced by the quartile bound."""
    notes: tuple[str, ...]


def replace_outliers(values: FloatArray) -> FloatArray:
    """Values with every outlier replaced by the quartile on its side, 0.25 or 0.75, column by column.

    An outlier lies more than 1.5 interquartile ranges outside the box. NaN stay NaN.

    >>> replace_outliers(np.array([0.0, 1.0, 2.0, 3.0, 100.0])).tolist()
    [0.0, 1.0, 2.0, 3.0, 3.0]
    """
    if len(values) == 0:
        return values.copy()
    q1, q3 = _quartiles(values)
    reach = WHISKER * (q3 - q1)
    return np.where(values > q3 + reach, q3, np.where(values < q1 - reach, q1, values))


def _quartiles(values: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Quartiles of each column that has a value; NaN for a column without."""
    filled = np.where(np.isfinite(values).any(axis=0), values, 0.0)
    empty = ~np.isfinite(values).any(axis=0)
    low, high = np.nanquantile(filled, [0.25, 0.75], axis=0)
    return np.where(empty, np.nan, low), np.where(empty, np.nan, high)


def box(values: FloatArray) -> Box:
    """Quartiles, whiskers and outliers of one sample; NaN are not counted.

    Quartiles interpolate linearly (Hyndman and Fan's type 7). Raises ParameterError for an empty sample.

    >>> box(np.array([0.0, 1.0, 2.0, 3.0, 100.0])).outliers
    (100.0,)
    """
    finite = values[np.isfinite(values)]
    if len(finite) == 0:
        message = f"a box needs at least one finite value, received {len(values)} without one"
        raise ParameterError(message, field="values", value=len(values))
    q1, median, q3 = (float(q) for q in np.quantile(finite, [0.25, 0.5, 0.75]))
    reach = WHISKER * (q3 - q1)
    inside = (finite >= q1 - reach) & (finite <= q3 + reach)
    return Box(
        count=len(finite),
        mean=float(finite.mean()),
        q1=q1,
        median=median,
        q3=q3,
        low=float(finite[inside].min()),
        high=float(finite[inside].max()),
        outliers=tuple(np.sort(finite[~inside]).tolist()),
        mean_replaced=float(replace_outliers(finite).mean()),
    )


def axis_profile(predictor: PredictorErrors, mask: BoolArray | None = None) -> AxisProfile:
    """Boxes of the errors along the longer axis, over the trials of ``mask`` or over all."""
    rows = predictor.single_axis if mask is None else predictor.single_axis[mask]
    return AxisProfile(predictor.name, tuple(box(column) for column in rows.T))


def axis_anova(score: SetScore, names: Sequence[str]) -> AnovaSeries:
    """Repeated-measures ANOVA of the single-axis error over people at every path fraction.

    Within factors: the model (the predictors ``names``) and whatever the trials' conditions cross. Trials
    are averaged per person and cell. A trial without a finite error at some fraction is left out and noted.
    Raises ParameterError for a name that was not scored.
    """
    by_name = {predictor.name: predictor for predictor in score.predictors}
    missing = [name for name in names if name not in by_name]
    if missing:
        message = f"{', '.join(missing)} not scored on {score.name}; scored: {', '.join(by_name)}"
        raise ParameterError(message, field="names", value=missing[0])
    errors = np.stack([by_name[name].single_axis for name in names], axis=-1)
    usable = np.logical_and.reduce(np.isfinite(errors), axis=(1, 2))
    trials = [trial for trial, good in zip(score.trials, usable, strict=True) if good]
    notes = [f"trials without an error at some fraction: {(~usable).sum()}"] if not usable.all() else []
    design = balance([trial.trial.user for trial in trials], factors_of(trials))
    people = len({trial.trial.user for trial in trials})
    notes += design.notes if people >= LEAST_USERS else ()
    models = ("model",) if len(names) > 1 else ()
    factors, levels = (*models, *design.factors), design.levels
    if models:
        levels = (tuple(names), *levels)
    who = "1 person" if people == 1 else f"{people} people"
    enough = len(design.users) >= LEAST_USERS and factors != ()
    if not enough:
        notes.append(
            f"not run: only {who}, at least {LEAST_USERS} are needed"
            if factors
            else "not run: one predictor and no condition that varies"
        )
    series = []
    for values in (errors[usable], replace_outliers(errors[usable])) if enough else ():
        tables = [cell_means(design, values[:, i]) for i in range(len(AXIS_FRACTIONS))]
        series.append(tuple(anova(table if models else table[:, 0], factors) for table in tables))
    none: tuple[tuple[Effect, ...], ...] = ((),) * len(AXIS_FRACTIONS)
    plain, replaced = series or (none, none)
    return AnovaSeries(tuple(names), len(design.users), factors, levels, plain, replaced, tuple(notes))
