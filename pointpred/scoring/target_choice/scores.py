"""How often a predictor finds the target of a movement, beside the nearest target to the cursor."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import msgspec
import numpy as np

from pointpred.pipeline import Pipeline, run
from pointpred.recording import Recording
from pointpred.records import FloatArray
from pointpred.registry import build
from pointpred.scoring import target_choice as replaying
from pointpred.scoring.results import TIME_FRACTIONS
from pointpred.scoring.spans import in_threads
from pointpred.scoring.target_layouts import Layout, layouts
from pointpred.scoring.trials import Prepared, prepare, resolution
from pointpred.targets import posterior

NEAREST = "nearest to the cursor"
ASKS = tuple(round(0.2 + 0.02 * i, 2) for i in range(40))
"""Precisions asked for, from which curves are drawn."""
FRACTIONS: FloatArray = np.array(TIME_FRACTIONS)


class TargetScore(msgspec.Struct, frozen=True):
    """What one predictor's choices came to, a row a trial."""

    name: str
    by_time: FloatArray
    """(trials, TIME_FRACTIONS, 4) as ``target_replay`` names them"""
    accounts: FloatArray
    """(trials, ASKS, 6) as ``target_replay`` names them"""


class TargetSet(msgspec.Struct, frozen=True):
    """One recording: what the candidates were, and the choices of each predictor."""

    name: str
    layout: str
    trials: int
    scores: tuple[TargetScore, ...]


def score_targets(
    recording: Recording,
    predictors: Sequence[str | Pipeline],
    *,
    seed: int = 0,
    threads: int | None = None,
    cpi: float | None = None,
    dpi: float | None = None,
    coefficients: FloatArray = posterior.FITTED,
    nearest: FloatArray = posterior.FITTED_NEAREST,
    elsewhere: float = 0.02,
    least_lead_s: float = 0.0,
    least_way_px: float = 3.0,
    parameters: Mapping[str, Mapping[str, Any]] | None = None,
) -> list[TargetSet]:
    """Score the choices of predictors among the targets of a recording, and the nearest to the cursor.

    One result for each kind of layout that the recording's trials have.

    ``predictors`` and ``parameters``: as for ``score``; the laws are those of ``Chooser``. The baseline's
    shares depend on the distance from the cursor to each target alone, with coefficients of their own. Raises
    what a pipeline raises.
    """
    settings = resolution(recording, cpi, dpi)
    prepared = prepare(recording, **settings, threads=threads)
    least = (least_lead_s, least_way_px)
    pipelines = {NEAREST: build("hold", **settings)}
    for predictor in predictors:
        if isinstance(predictor, Pipeline):
            pipelines[predictor.name] = predictor
        else:
            pipelines[predictor] = build(predictor, **settings, **(parameters or {}).get(predictor, {}))
    sets = []
    for kind, candidates in layouts(prepared, seed).items():
        scores = []
        for name, pipeline in pipelines.items():
            weights = nearest if name == NEAREST else coefficients
            work = partial(_judge, prepared, candidates, pipeline, weights, elsewhere, least)
            parts = list(in_threads(work, prepared.offsets, threads))
            by_time, accounts = (np.concatenate(column) for column in zip(*parts, strict=True))
            scores.append(TargetScore(name, by_time, accounts))
        sets.append(TargetSet(recording.name, kind, len(candidates), tuple(scores)))
    return sets


def _judge(
    prepared: Prepared,
    candidates: list[Layout],
    pipeline: Pipeline,
    coefficients: FloatArray,
    elsewhere: float,
    least: tuple[float, float],
    first: int,
    stop: int,
) -> tuple[FloatArray, FloatArray]:
    """The choices in trials ``first`` up to ``stop`` that have candidates."""
    inside = [layout for layout in candidates if first <= layout.trial < stop]
    by_time = np.empty((len(inside), len(FRACTIONS), replaying.READ))
    accounts = np.empty((len(inside), len(ASKS), replaying.ACCOUNT))
    base = int(prepared.offsets[first])
    rows = prepared.events.rows(base, int(prepared.offsets[stop]))
    answers = run(pipeline.fresh(), rows).table
    for place, layout in enumerate(inside):
        k, targets, right = layout.trial, layout.table, layout.right
        a, b = int(prepared.offsets[k]) - base, int(prepared.offsets[k + 1]) - base
        events, own = rows.table[a:b], answers[a:b]
        shares = np.empty((b - a, len(targets) + 1))
        replaying.weigh(events, own, targets, coefficients, elsewhere, shares)
        arrival = int(prepared.arrivals[k]) - base - a
        replaying.read(events, targets, shares, arrival, right, FRACTIONS, by_time[place])
        for i, ask in enumerate(ASKS):
            replaying.account(events, own, targets, shares, right, ask, *least, accounts[place, i])
    return by_time, accounts
