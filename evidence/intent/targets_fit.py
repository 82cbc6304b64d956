"""Fit the coefficients of the evidence for targets, for ``python -m evidence intent targets``.

A conditional logit (McFadden 1974): the share of a target is proportional to the exponential of a
weighted sum of its features. Fitted on the recordings of POINTPRED_RECORDINGS and the embedded sample, each
movement at each twentieth of its time. In a quarter of these situations, drawn at random, the right target
is taken away, so that *none of them* is right. Each set has the same say, whatever its size. Written to
pointpred/targets/coefficients.py.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from math import log
from pathlib import Path
from typing import NamedTuple

import numpy as np
from scipy.optimize import minimize

from evidence import ROOT
from pointpred import build, run
from pointpred.datasets import sample
from pointpred.pipeline import Pipeline
from pointpred.recording import Recording
from pointpred.recordings import read
from pointpred.records import FloatArray, PredictionColumns
from pointpred.scoring.target_layouts import Layout, layouts
from pointpred.scoring.trials import Prepared, prepare, resolution
from pointpred.targets import cursor, posterior
from pointpred.targets.posterior import FEATURES, MASS, NEAR, Law, features, log_total, unclaimed

SETS = (
    *("pvplib23714", "gofitts_demo", "freihaut2021", "cryslacks", "humanmovemouse", "jrcalgo"),
    "fitts_xp",
)
SCORED_ONLY = ("fitts_xp",)
"""Its licence is not stated: nothing is fitted to it."""
FRACTIONS = tuple(round(0.1 + 0.05 * i, 2) for i in range(18))
MOST_TRIALS = 200
"""Of each set."""
CLAIMING, SILENT = "kinematic", "minimum-jerk"
"""The predictors that it is fitted with: one that claims a law and one that does not."""
PENALTY = 1e-3
WEIGHTS = posterior.Weights.length
SIGNS = {MASS: (0.0, None), 1: (None, 0.0), 2: (None, 0.0), NEAR: (None, 0.0)}
"""A likelier rectangle, a straighter way and a nearer target never speak against a target."""


class Cases(NamedTuple):
    """Situations as arrays: features of each candidate, whether it is there, which one is right."""

    features: FloatArray
    absent: FloatArray
    right: np.ndarray[tuple[int], np.dtype[np.int64]]


def recordings(names: Sequence[str] = SETS) -> list[Recording]:
    """The embedded sample and the sets that are there."""
    folder = Path(os.environ["POINTPRED_RECORDINGS"])
    return [sample(), *(read(next(folder.rglob(f"{name}_samples.parquet"))) for name in names)]


def cases(recording: Recording, predictors: Iterable[str | Pipeline], seed: int = 0) -> Cases:
    """The situations of one set, with the predictions of each predictor."""
    settings = resolution(recording, None, None)
    prepared = prepare(recording, **settings)
    choices = [layout for kind in layouts(prepared, seed).values() for layout in kind]
    generator = np.random.default_rng([seed, 1])
    picked = generator.permutation(len(choices))[:MOST_TRIALS].tolist()
    parts = []
    for predictor in predictors:
        pipeline = predictor.fresh() if isinstance(predictor, Pipeline) else build(predictor, **settings)
        answers = run(pipeline, prepared.events)
        parts += [part for k in picked for part in _trial(prepared, choices[k], answers)]
    return arranged(parts, generator)


def arranged(parts: Sequence[tuple[FloatArray, float, int]], generator: np.random.Generator) -> Cases:
    """Situations as arrays; in a share of FITTED_NONE of them the right target is taken away.

    The candidates of each count as if they were FITTED_TARGETS.
    """
    slots = max(len(rows) for rows, _, _ in parts) + 1
    table, absent = np.zeros((len(parts), slots, WEIGHTS)), np.full((len(parts), slots), -1e9)
    right = np.empty(len(parts), dtype=np.int64)
    for i, (rows, fast, own) in enumerate(parts):
        there = np.ones(len(rows), dtype=bool)
        if taken := generator.uniform() < posterior.FITTED_NONE:
            there[own] = False
        right[i] = slots - 1 if taken else own
        around = log_total(float(np.exp(rows[there, MASS]).sum()) / there.sum())
        table[i, : len(rows)][:, :FEATURES] = (1.0 - fast) * rows
        table[i, : len(rows)][:, FEATURES : 2 * FEATURES] = fast * rows
        table[i, -1, 2 * FEATURES :] = 1.0 - fast, fast, (1.0 - fast) * around, fast * around
        absent[i, : len(rows)][there], absent[i, -1] = log(posterior.FITTED_TARGETS / there.sum()), 0.0
    return Cases(table, absent, right)


def _trial(
    prepared: Prepared, layout: Layout, answers: PredictionColumns
) -> list[tuple[FloatArray, float, int]]:
    """Features of all candidates at FRACTIONS of one movement's time."""
    first, arrival = int(prepared.offsets[layout.trial]), int(prepared.arrivals[layout.trial])
    t = prepared.events.t
    at = t[first] + np.array(FRACTIONS) * (t[arrival] - t[first])
    wanted = set((first - 1 + np.searchsorted(t[first : arrival + 1], at, side="right")).tolist())
    now, parts = cursor.State(np.zeros(cursor.State.length)), []
    for i in range(first, max(wanted) + 1):
        cursor.follow(now.memory, t[i], prepared.events.x[i], prepared.events.y[i], 0.0)
        if i in wanted:
            rows = np.empty((len(layout.table), FEATURES))
            x, y, sxx, sxy, syy, tail = answers.table[i][[1, 2, 3, 4, 5, 8]].tolist()
            if x != x:
                x, y = float(now.x), float(now.y)
            if not (sxx > 0.0 and syy > 0.0 and sxx * syy > sxy * sxy):
                (sxx, sxy, syy), tail = unclaimed(now.memory, x, y), float("nan")
            features(now.memory, layout.table, Law(x, y, sxx, sxy, syy, tail), rows)
            fast = now.speed / now.peak if now.peak > 0.0 else 0.0
            parts.append((rows, float(fast), layout.right))
    return parts


def fit(sets: Sequence[Cases], only: Sequence[int] | None = None, around: bool = True) -> FloatArray:
    """The coefficients of largest penalised likelihood, each set with the same weight.

    ``only``: the features that may count; the others are 0. ``around``: whether what falls to all may count.
    """
    scale = np.sqrt(np.mean([(one.features**2).mean(axis=(0, 1)) for one in sets], axis=0)) + 1e-9
    scaled = [one.features / scale for one in sets]

    def loss(weights: FloatArray) -> tuple[float, FloatArray]:
        total, slope = PENALTY * float(weights @ weights), 2.0 * PENALTY * weights
        for one, table in zip(sets, scaled, strict=True):
            score = table @ weights + one.absent
            score -= score.max(axis=1, keepdims=True)
            share = np.exp(score)
            share /= share.sum(axis=1, keepdims=True)
            rows = np.arange(len(share))
            total -= float(np.log(share[rows, one.right] + 1e-12).mean()) / len(sets)
            share[rows, one.right] -= 1.0
            slope = slope + np.tensordot(share, table, 2) / len(share) / len(sets)
        return total, slope

    bounds = [
        SIGNS.get(i, (None, None)) if only is None or i in only else (0.0, 0.0) for i in range(FEATURES)
    ]
    result = minimize(
        loss,
        np.zeros(len(scale)),
        jac=True,
        method="L-BFGS-B",
        bounds=[*bounds, *bounds, *[(None, None)] * 2, *[(None, None) if around else (0.0, 0.0)] * 2],
    )
    weights: FloatArray = result.x / scale
    return weights


def coefficients(sets: Sequence[tuple[Cases, Cases]], only: Sequence[int] | None = None) -> FloatArray:
    """Coefficients as ``posterior`` takes them: for a claimed law, then for none."""
    return np.concatenate([fit([one[place] for one in sets], only, only is None) for place in range(2)])


def write(sets: Sequence[tuple[Cases, Cases]]) -> None:
    """Fit on these sets and write the coefficients."""
    ours, near = coefficients(sets), fit([one[1] for one in sets], [NEAR], around=False)
    values = {"NEAREST": near[[NEAR, FEATURES + NEAR]], "NEAREST_NONE": near[-4:-2]}
    put(values | named("", ours[:WEIGHTS]) | named("UNCLAIMED_", ours[WEIGHTS:]))


def named(prefix: str, part: FloatArray) -> dict[str, FloatArray]:
    """A law's coefficients by their names in the package."""
    cut = {"SLOW": part[:FEATURES], "FAST": part[FEATURES:-4], "NONE": part[-4:-2], "AROUND": part[-2:]}
    return {prefix + name: values for name, values in cut.items()}


def put(values: dict[str, FloatArray]) -> None:
    """Put coefficients into the package."""
    file = ROOT / "pointpred" / "targets" / "coefficients.py"
    lines = file.read_text(encoding="utf-8").splitlines()
    for i, line in enumerate(lines):
        name = line.split(" = ")[0]
        if name in values and " = " in line:
            lines[i] = f"{name} = ({', '.join(f'{value:.4g}' for value in values[name])})"
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print("\n".join(lines))
