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
from pointpred.targets.posterior import FEATURES, MASS, NEAR, Law, features, unclaimed

SETS = (
    *("pvplib23714", "gofitts_demo", "freihaut2021", "cryslacks", "humanmovemouse", "jrcalgo"),
    "fitts_xp",
)
FRACTIONS = tuple(round(0.1 + 0.05 * i, 2) for i in range(18))
MOST_TRIALS = 200
"""Of each set."""
CLAIMING, SILENT = "kinematic", "minimum-jerk"
"""The predictors that it is fitted with: one that claims a law and one that does not."""
PENALTY = 1e-3
SLOTS = 24
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
    there = [len(part[0]) for part in parts]
    table, absent = np.zeros((len(parts), SLOTS, 2 * FEATURES + 2)), np.full((len(parts), SLOTS), -1e9)
    right = np.empty(len(parts), dtype=np.int64)
    for i, (rows, fast, own) in enumerate(parts):
        table[i, : there[i], :FEATURES], table[i, : there[i], FEATURES:-2] = (1.0 - fast) * rows, fast * rows
        table[i, -1, -2:] = 1.0 - fast, fast
        absent[i, : there[i]], absent[i, -1], right[i] = 0.0, 0.0, own
        if generator.uniform() < posterior.FITTED_NONE:
            absent[i, own], right[i] = -1e9, SLOTS - 1
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


def fit(sets: Sequence[Cases], only: Sequence[int] | None = None) -> FloatArray:
    """The coefficients of largest penalised likelihood, each set with the same weight.

    ``only``: the features that may count; the others are 0.
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
        bounds=[*bounds, *bounds, *[(None, None)] * 2],
    )
    weights: FloatArray = result.x / scale
    return weights


def coefficients(sets: Sequence[tuple[Cases, Cases]], only: Sequence[int] | None = None) -> FloatArray:
    """Coefficients as ``posterior`` takes them: for a claimed law, then for none."""
    return np.concatenate([fit([one[place] for one in sets], only) for place in range(2)])


def write(sets: Sequence[tuple[Cases, Cases]]) -> None:
    """Fit on these sets and write the coefficients."""
    ours, near = coefficients(sets), fit([one[1] for one in sets], [NEAR])
    file = ROOT / "pointpred" / "targets" / "coefficients.py"
    values = {"NEAREST": near[[NEAR, FEATURES + NEAR]], "NEAREST_NONE": near[2 * FEATURES :]}
    half = posterior.Weights.length
    for prefix, part in (("", ours[:half]), ("UNCLAIMED_", ours[half:])):
        values[f"{prefix}SLOW"], values[f"{prefix}FAST"] = part[:FEATURES], part[FEATURES : 2 * FEATURES]
        values[f"{prefix}NONE"] = part[2 * FEATURES :]
    lines = file.read_text(encoding="utf-8").splitlines()
    for i, line in enumerate(lines):
        name = line.split(" = ")[0]
        if name in values and " = " in line:
            lines[i] = f"{name} = ({', '.join(f'{value:.4g}' for value in values[name])})"
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print("\n".join(lines))
