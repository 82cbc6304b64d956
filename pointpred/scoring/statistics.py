"""Predictors compared over people: pairs of them, and the thesis's single-axis protocol.

The protocol (section 2.6.3): error against path, box plots, analysis of variance.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.errors import ParameterError
from pointpred.records import BoolArray, FloatArray
from pointpred.scoring.results import AXIS_FRACTIONS, PredictorErrors, ScoredTrial, SetScore

FIRST = ("distance", "width", "transfer", "ptf")
"""Factors of the thesis, tried before whatever else a recording knows; a name that begins so counts."""
OUTCOMES = (
    *("hit", "miss", "correct", "error", "clean", "end_", "duration", "onset", "t_", "begins"),
    *("clicks", "lost_"),
)
"""Conditions that begin so say how or when a trial went: what was measured is no cause of its error."""
MOST_VALUES = 12
"""A number with more values than this is a measurement and no condition, unless its name is in FIRST."""
LEAST_USERS = 3
MOST_FACTORS = 4
MOST_LEVELS = 12
KEPT_USERS = 0.9
"""A factor is left out when more than a tenth of the people miss one of its combinations."""
EVERY_PAIR = ("all",)
"""In the place of two predictors to be compared: each of them with each other."""
FLAT = 1e-12
"""Share of the total variance below which a term's variance over people is rounding."""
WHISKER = 1.5
"""Whiskers reach the last value within this many interquartile ranges of the box; the rest are outliers."""


def factors_of(trials: Sequence[ScoredTrial]) -> dict[str, list[str]]:
    """Every condition that all trials know, as labels with a row a trial, the thesis's factors first.

    Outcomes and measured numbers are not among them. The target's width is a factor where no condition
    says it.
    """
    if not trials:
        return {}
    shared = set.intersection(*(set(trial.trial.condition) for trial in trials))
    shared = {name for name in shared if not name.startswith(OUTCOMES) and not _measured(name, trials)}
    factors = {name: [_label(trial.trial.condition[name]) for trial in trials] for name in sorted(shared)}
    widths = [trial.trial.target_w for trial in trials]
    if not any(name.startswith("width") for name in factors) and np.isfinite(widths).all():
        factors["width"] = [_label(width) for width in widths]
    return {name: factors[name] for name in sorted(factors, key=_rank)}


def _measured(name: str, trials: Sequence[ScoredTrial]) -> bool:
    """Whether a condition is a number that hardly comes twice."""
    values = {trial.trial.condition[name] for trial in trials}
    words = any(isinstance(value, str) for value in values)
    return len(values) > MOST_VALUES and not words and not name.startswith(FIRST)


def _rank(name: str) -> tuple[int, str]:
    places = [place for place, start in enumerate(FIRST) if name.startswith(start)]
    return (places[0] if places else len(FIRST)), name


def _label(value: str | float) -> str:
    return value if isinstance(value, str) else f"{value:g}"


IndexArray = NDArray[np.int64]


class Effect(msgspec.Struct, frozen=True):
    """One term: how much the error differs between its levels, against how people differ in that."""

    factors: tuple[str, ...]
    f: float
    df1: int
    df2: int
    p: float
    eta2: float
    """Partial eta squared: F df1 / (F df1 + df2)."""
    epsilon: float
    """Greenhouse-Geisser epsilon: 1 where the differences between levels vary alike over people."""
    p_corrected: float
    """p with both degrees of freedom times epsilon."""


class Design(msgspec.Struct, frozen=True):
    """The balanced table that the trials allow: people x levels of each factor, and what did not fit."""

    users: tuple[str, ...]
    factors: tuple[str, ...]
    levels: tuple[tuple[str, ...], ...]
    cell: IndexArray
    """(trials,): number of the trial's cell in the flattened table, -1 where the trial is left out."""
    notes: tuple[str, ...]


def balance(users: Sequence[str], factors: Mapping[str, Sequence[str]]) -> Design:
    """The largest fully crossed design: factors are tried in order, and one with missing cells is left out.

    ``users`` and each factor's labels have a row a trial. A person missing a cell of an accepted factor is
    left out; every omission has a note. Memory: a number a trial.

    >>> balance(["a", "a", "b", "b", "c", "c"], {"width": ["10", "20"] * 3}).cell.tolist()
    [0, 1, 2, 3, 4, 5]
    """
    people, everyone = np.unique(np.asarray(users, dtype=str), return_inverse=True)
    crossed: dict[str, tuple[str, ...]] = {}
    reasons: dict[str, list[str]] = {}
    inside = np.zeros(len(everyone), dtype=np.int64)
    cells = 1
    included = np.ones(len(people), dtype=np.bool_)
    for name, labels in factors.items():
        levels, index = np.unique(np.asarray(labels, dtype=str), return_inverse=True)
        reason = _unfit(len(crossed), len(levels))
        if not reason:
            present = np.zeros((len(people), cells * len(levels)), dtype=np.bool_)
            present[everyone, inside * len(levels) + index] = True
            complete: BoolArray = np.logical_and.reduce(present, axis=1)
            if complete.sum() < max(KEPT_USERS * len(people), LEAST_USERS):
                reason = f"only {complete.sum()} of {len(people)} people did every combination"
            if complete.sum() < LEAST_USERS:
                reason += f", at least {LEAST_USERS} are needed"
        if reason:
            reasons.setdefault(reason, []).append(name)
            continue
        crossed[name] = tuple(levels.tolist())
        inside, cells, included = inside * len(levels) + index, cells * len(levels), complete
    notes = [f"{', '.join(names)}: not a factor, {reason}" for reason, names in reasons.items()]
    if not included.all():
        notes.append(f"{(~included).sum()} of {len(people)} people not counted: they miss a combination")
    row = np.cumsum(included) - 1
    cell = np.where(included[everyone], row[everyone] * cells + inside, -1)
    return Design(
        tuple(people[included].tolist()), tuple(crossed), tuple(crossed.values()), cell, tuple(notes)
    )


def _unfit(accepted: int, levels: int) -> str:
    """Why a factor cannot enter, empty where it can."""
    if levels < 2:
        return "it is the same in every trial"
    if levels > MOST_LEVELS:
        return f"more than {MOST_LEVELS} levels"
    if accepted == MOST_FACTORS - 1:
        return f"at most {MOST_FACTORS} factors with the model are crossed"
    return ""


def cell_means(design: Design, values: FloatArray) -> FloatArray:
    """Mean of ``values`` (trials, models) in each cell, shape (users, models, levels of each factor ...)."""
    shape = tuple(len(levels) for levels in design.levels)
    inside = design.cell >= 0
    cell = design.cell[inside]
    size = len(design.users) * int(np.prod(shape, dtype=np.int64))
    count = np.bincount(cell, minlength=size)
    sums = [np.bincount(cell, weights=column[inside], minlength=size) for column in values.T]
    means = np.stack([total / count for total in sums], axis=-1)
    table: FloatArray = np.moveaxis(means.reshape(len(design.users), *shape, values.shape[1]), -1, 1)
    return table


def anova(table: FloatArray, factors: Sequence[str]) -> tuple[Effect, ...]:
    """Repeated-measures ANOVA of a table of shape (people, levels of each factor ...).

    Every person fills every cell; errors are taken as normal. F and p come from statsmodels' ``AnovaRM``,
    which takes all differences between levels to vary alike; with more than two levels read
    ``p_corrected`` (Greenhouse and Geisser 1959). A term that does not vary over people has no F and is
    left out.

        F = (SS / df1) / (SS_people / df2),   partial eta^2 = F df1 / (F df1 + df2)

    Raises ParameterError for fewer than 3 people, a factor with one level, or a value that is not finite.

    >>> effects = anova(np.array([[1.0, 2.0], [2.0, 4.0], [3.0, 6.0]]), ["model"])
    >>> round(effects[0].f, 6), effects[0].df1, effects[0].df2
    (12.0, 1, 2)
    """
    if table.ndim != len(factors) + 1 or table.shape[0] < LEAST_USERS or min(table.shape) < 2:
        raise ParameterError(
            f"an analysis of variance needs at least {LEAST_USERS} people and 2 levels of each of "
            f"{len(factors)} factors, received shape {table.shape}",
            field="table",
            value=table.shape,
        )
    if not np.isfinite(table).all():
        count = np.count_nonzero(~np.isfinite(table))
        raise ParameterError(f"{count} cells are not finite", field="table", value=count)
    spread = float(table.std())
    if spread == 0.0:
        return ()
    scaled = (table - table.mean()) / spread
    terms = [term for size in range(1, len(factors) + 1) for term in combinations(range(len(factors)), size)]
    sizes = {term: _covariance(scaled, term) for term in terms}
    fitted = _fit(scaled)
    return tuple(
        _effect(tuple(factors[i] for i in term), *fitted[term], sizes[term])
        for term in terms
        if np.trace(sizes[term]) > FLAT
    )


def _covariance(table: FloatArray, term: tuple[int, ...]) -> FloatArray:
    """Covariance over people of the term's orthonormal contrasts."""
    from scipy.linalg import helmert

    others = tuple(axis for axis in range(1, table.ndim) if axis - 1 not in term)
    contrast = table.mean(axis=others)
    for axis in range(1, contrast.ndim):
        contrast = np.moveaxis(np.tensordot(contrast, helmert(contrast.shape[axis]), (axis, 1)), -1, axis)
    covariance: FloatArray = np.atleast_2d(np.cov(contrast.reshape(len(table), -1), rowvar=False))
    return covariance


def _fit(table: FloatArray) -> dict[tuple[int, ...], tuple[float, int, int, float]]:
    """F, degrees of freedom and p of every term."""
    import pandas as pd
    from statsmodels.stats.anova import AnovaRM

    names = [f"f{axis}" for axis in range(1, table.ndim)]
    rows = dict(zip(["person", *names], (i.ravel() for i in np.indices(table.shape)), strict=True))
    with np.errstate(divide="ignore", invalid="ignore"):
        result = AnovaRM(pd.DataFrame({"y": table.ravel(), **rows}), "y", "person", within=names).fit()
    return {
        tuple(names.index(name) for name in term.split(":")): (float(f), int(df1), int(df2), float(p))
        for term, (f, df1, df2, p) in zip(
            result.anova_table.index,
            result.anova_table[["F Value", "Num DF", "Den DF", "Pr > F"]].to_numpy(),
            strict=True,
        )
    }


def _effect(
    factors: tuple[str, ...], f: float, df1: int, df2: int, p: float, covariance: FloatArray
) -> Effect:
    from scipy.stats import f as f_distribution

    epsilon = float(np.trace(covariance) ** 2 / (df1 * np.sum(covariance**2)))
    corrected = float(f_distribution.sf(f, epsilon * df1, epsilon * df2))
    return Effect(factors, f, df1, df2, p, f * df1 / (f * df1 + df2), epsilon, corrected)


class Contrast(msgspec.Struct, frozen=True):
    """Two predictors compared by a paired t test over people."""

    first: str
    second: str
    people: int
    px: float
    """Mean over people of their error with the first minus that with the second, px."""
    interval: tuple[float, float]
    """95 % of Student's t, px."""
    t: float | None
    df: int
    p: float | None
    """``None``, as t, where nobody differs between the two."""
    p_holm: float | None
    """p corrected by Holm for the number of pairs compared."""


def contrasts(errors: Mapping[str, FloatArray], pair: Sequence[str] | None = None) -> tuple[Contrast, ...]:
    """Every pair of predictors compared, or only ``pair``; ``errors``: the mean error of each person, px.

    People are taken as drawn independently, their differences as normal. t and p come from scipy's
    ``ttest_rel``, p for all pairs from statsmodels' ``multipletests`` by Holm's method, which holds however
    the pairs depend on each other. Needs two people at least.

    >>> errors = {"a": np.array([1.0, 2.0, 4.0]), "b": np.array([2.0, 4.0, 7.0])}
    >>> one, = contrasts(errors)
    >>> one.px, round(one.t, 4), one.df, round(one.p, 4) == round(one.p_holm, 4)
    (-2.0, -3.4641, 2, True)
    """
    from scipy.stats import ttest_rel
    from statsmodels.stats.multitest import multipletests

    found = []
    for first, second in combinations(errors, 2) if pair is None else [pair]:
        difference = errors[first] - errors[second]
        if float(np.ptp(difference)) == 0.0:  # no spread to compare with
            mean = float(difference.mean())
            found.append(Contrast(first, second, len(difference), mean, (mean, mean), None, 0, None, None))
            continue
        test = ttest_rel(errors[first], errors[second])
        low, high = test.confidence_interval(0.95)
        values = float(test.statistic), int(test.df), float(test.pvalue)
        found.append(
            Contrast(
                first, second, len(difference), float(difference.mean()), (float(low), float(high)),
                *values, None,
            )
        )  # fmt: skip
    tested = [one.p for one in found if one.p is not None]
    corrected = iter(multipletests(tested, method="holm")[1].tolist() if tested else ())
    return tuple(
        one if one.p is None else msgspec.structs.replace(one, p_holm=next(corrected)) for one in found
    )


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
