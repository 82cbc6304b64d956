"""How well a predictor tells which of some targets a movement is for, beside the nearest to the cursor."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import msgspec
import numpy as np

from pointpred.columns import FloatArray
from pointpred.pipeline import Pipeline, run
from pointpred.recording import Recording
from pointpred.registry import build
from pointpred.scoring import target_replay as replaying
from pointpred.scoring.chunks import in_threads
from pointpred.scoring.results import TIME_FRACTIONS
from pointpred.scoring.target_layouts import Layout, layouts
from pointpred.scoring.trials import Prepared, prepare, resolution
from pointpred.targets import posterior

Json = dict[str, Any]

NEAREST = "nearest to the cursor"
ASKS = tuple(round(0.2 + 0.02 * i, 2) for i in range(40))
"""Precisions asked for, from which curves are drawn."""
DIALS = (0.5, 0.65, 0.8, 0.9)
"""Those that tables show."""
LEVEL = 0.8
"""The precision at which predictors are compared."""
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
    shares hang on the distance from the cursor to each target alone, with coefficients of their own. Raises
    what a pipeline raises.
    """
    settings = resolution(recording, cpi, dpi)
    prepared = prepare(recording, **settings, threads=threads)
    sets = []
    for words, found in layouts(prepared, seed).items():
        scores = []
        for given in (NEAREST, *predictors):
            name = given.name if isinstance(given, Pipeline) else given
            pipeline = (
                given
                if isinstance(given, Pipeline)
                else build(
                    "hold" if name == NEAREST else name, **settings, **(parameters or {}).get(name, {})
                )
            )
            chosen = nearest if name == NEAREST else coefficients
            least = (least_lead_s, least_way_px)
            work = partial(_judge, prepared, found, pipeline, chosen, elsewhere, least)
            parts = list(in_threads(work, prepared.offsets, threads))
            by_time, accounts = (np.concatenate(kind) for kind in zip(*parts, strict=True))
            scores.append(TargetScore(name, by_time, accounts))
        sets.append(TargetSet(recording.name, words, len(found), tuple(scores)))
    return sets


def _judge(
    prepared: Prepared,
    found: list[Layout],
    pipeline: Pipeline,
    coefficients: FloatArray,
    elsewhere: float,
    least: tuple[float, float],
    first: int,
    stop: int,
) -> tuple[FloatArray, FloatArray]:
    """The choices in trials ``first`` up to ``stop`` that have candidates."""
    chosen = [layout for layout in found if first <= layout.trial < stop]
    by_time = np.empty((len(chosen), len(FRACTIONS), replaying.READ))
    accounts = np.empty((len(chosen), len(ASKS), replaying.ACCOUNT))
    base = int(prepared.offsets[first])
    rows = prepared.events.rows(base, int(prepared.offsets[stop]))
    answers = run(pipeline.fresh(), rows).table
    for place, layout in enumerate(chosen):
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


def target_summary(scored: TargetSet) -> Json:
    """A scored set as plain dictionaries and lists; ``None`` where a number means nothing."""
    return {
        "name": scored.name,
        "layout": scored.layout,
        "trials": scored.trials,
        "nearest_centre": _by_time(scored.scores[0].by_time[:, :, replaying.NEAREST]),
        "predictors": [_described(score) for score in scored.scores],
    }


def _described(score: TargetScore) -> Json:
    read, asked = score.by_time, [decisions(score, i) for i in range(len(ASKS))]
    return {
        "name": score.name,
        "right": _by_time(read[:, :, replaying.RIGHT]),
        "log_loss": _by_time(read[:, :, replaying.LOSS]),
        "abstained": _by_time((read[:, :, replaying.SURENESS] < LEVEL).astype(np.float64)),
        "decisions": {str(ask): one for ask, one in zip(ASKS, asked, strict=True)},
        "at_precision": {str(LEVEL): at_precision(score, LEVEL)},
    }


def _by_time(values: FloatArray) -> Json:
    means = values.mean(axis=0) if len(values) else np.full(len(TIME_FRACTIONS), np.nan)
    return dict(zip(map(str, TIME_FRACTIONS), map(_number, means.tolist()), strict=True))


def decisions(score: TargetScore, ask: int) -> Json:
    """What the proposals at the precision ``ASKS[ask]`` came to."""
    account = score.accounts[:, ask]
    proposed = account[:, replaying.PROPOSED].sum()
    hit = account[:, replaying.HIT] == 1.0
    return {
        "asked": ASKS[ask],
        "precision": _number(account[:, replaying.PROPOSED_RIGHT].sum() / proposed) if proposed else None,
        "before_entry": _number(hit.mean()) if len(hit) else None,
        "lead_entry_s": _middle(account[hit, replaying.LEAD_ENTRY]),
        "lead_a_movement_s": _number(account[hit, replaying.LEAD_ENTRY].sum() / len(hit))
        if len(hit)
        else None,
        "lead_click_s": _middle(account[hit, replaying.LEAD_CLICK]),
        "proposals": _number(proposed / len(hit)) if len(hit) else None,
        "retractions": _number(account[:, replaying.RETRACTED].mean()) if len(hit) else None,
    }


def at_precision(score: TargetScore, level: float) -> Json | None:
    """The decisions with the lowest precision asked for at which at least ``level`` of proposals were right.

    ``None`` where no dial reaches it. This looks at the trials it reports on, alike for every predictor.
    """
    for ask in range(len(ASKS)):
        one = decisions(score, ask)
        if one["precision"] is not None and one["precision"] >= level:
            return one
    return None


def _middle(values: FloatArray) -> float | None:
    return float(np.median(values)) if len(values) else None


def _number(value: float) -> float | None:
    return float(value) if np.isfinite(value) else None
