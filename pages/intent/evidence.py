"""Fit the evidence to pages: cards, links and menus, at the moments before the cursor enters the target.

The same features and the same conditional logit as ``pages.targets.fit``, whose situations are circles,
scattered squares and grids at fractions of the whole movement.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pages.intent.movements import PAGES, Movement
from pages.targets import fit as targets_fit
from pages.targets.fit import Cases
from pointpred.records import FloatArray
from pointpred.targets import cursor, posterior
from pointpred.targets.evidence import FEATURES, Law, features, unclaimed

CLAIMING, SILENT = "kinematic-adaptive", "minimum-jerk"
"""The predictors that it is fitted with: one that claims a law and one that does not."""
MOMENTS, LATEST_S, EARLIEST_S = 8, 0.06, 0.42
"""Of each movement, drawn evenly from so long before the entry: when a firing is of use and may be right."""
FIRST_S = 0.01
"""None is nearer to the movement's start."""
MOST_MOVEMENTS = 330
"""Of each layout and each group of sets."""


def coefficients(movements: Sequence[Movement], groups: dict[str, int]) -> FloatArray:
    """Coefficients as ``posterior`` takes them, each layout of each group of sets with the same weight."""
    fitted = []
    for predictor in (CLAIMING, SILENT):
        parts = []
        for layout in PAGES:
            for group in sorted({groups[one.set] for one in movements}):
                own = [one for one in movements if one.layout == layout and groups[one.set] == group]
                if own:
                    parts.append(cases(own, predictor, np.random.default_rng([group, len(layout)])))
        fitted.append(targets_fit.fit(parts))
    return np.concatenate(fitted)


def cases(movements: Sequence[Movement], predictor: str, generator: np.random.Generator) -> Cases:
    """The situations of movements; in a quarter of them the right target is taken away."""
    chosen = generator.permutation(len(movements))[:MOST_MOVEMENTS].tolist()
    parts = [part for k in chosen for part in _moments(movements[k], predictor, generator)]
    slots = max(len(rows) for rows, _, _ in parts) + 1
    table, absent = np.zeros((len(parts), slots, 2 * FEATURES + 2)), np.full((len(parts), slots), -1e9)
    right = np.empty(len(parts), dtype=np.int64)
    for i, (rows, fast, own) in enumerate(parts):
        count = len(rows)
        table[i, :count, :FEATURES], table[i, :count, FEATURES:-2] = (1.0 - fast) * rows, fast * rows
        table[i, -1, -2:] = 1.0 - fast, fast
        absent[i, :count], absent[i, -1], right[i] = 0.0, 0.0, own
        if generator.uniform() < posterior.FITTED_NONE:
            absent[i, own], right[i] = -1e9, slots - 1
    return Cases(table, absent, right)


def _moments(
    movement: Movement, predictor: str, generator: np.random.Generator
) -> list[tuple[FloatArray, float, int]]:
    """Features of all candidates at moments of one movement before it enters its target."""
    events, answers, last = movement.events, movement.answers[predictor], movement.entry
    t = events[:, 0]
    drawn = t[last] - generator.uniform(LATEST_S, EARLIEST_S, MOMENTS)
    wanted = set(np.searchsorted(t[: last + 1], np.maximum(drawn, t[0] + FIRST_S)).tolist())
    memory, parts = np.zeros(cursor.STATES), []
    for i in range(last):
        cursor.follow(memory, t[i], events[i, 1], events[i, 2], 0.0)
        if i in wanted:
            rows = np.empty((len(movement.table), FEATURES))
            x, y, sxx, sxy, syy, tail = answers[i][[1, 2, 3, 4, 5, 8]].tolist()
            if x != x:
                x, y = float(memory[cursor.X]), float(memory[cursor.Y])
            if not (sxx > 0.0 and syy > 0.0 and sxx * syy > sxy * sxy):
                (sxx, sxy, syy), tail = unclaimed(memory, x, y), float("nan")
            features(memory, movement.table, Law(x, y, sxx, sxy, syy, tail), rows)
            fast = memory[cursor.SPEED] / memory[cursor.PEAK] if memory[cursor.PEAK] > 0.0 else 0.0
            parts.append((rows, min(float(fast), 1.0), movement.right))
    return parts
