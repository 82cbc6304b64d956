"""Repeated-measures analysis of variance: whether the model, the distance or the width change the error."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.errors import ParameterError
from pointpred.records import BoolArray, FloatArray

IndexArray = NDArray[np.int64]
LEAST_USERS = 3
MOST_FACTORS = 4
MOST_LEVELS = 12
KEPT_USERS = 0.9
"""A factor is left out when more than a tenth of the people miss one of its combinations."""
FLAT = 1e-12
"""Share of the total variance below which a term's variance over people is rounding."""


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
            complete = _complete(everyone, len(people), inside * len(levels) + index, cells * len(levels))
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


def _complete(user: IndexArray, users: int, cell: IndexArray, cells: int) -> BoolArray:
    """Which people have a trial in every cell."""
    present = np.zeros((users, cells), dtype=np.bool_)
    present[user, cell] = True
    complete: BoolArray = np.logical_and.reduce(present, axis=1)
    return complete


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
