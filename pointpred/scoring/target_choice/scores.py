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
from pointpred.scoring.chunks import in_threads
from pointpred.scoring.results import TIME_FRACTIONS
from pointpred.scoring.summary.document import Number, Unread, number
from pointpred.scoring.target_choice import decisions as replaying
from pointpred.scoring.target_choice.layouts import Layout, layouts
from pointpred.scoring.trials import Prepared, prepare, resolution
from pointpred.targets import posterior

NEAREST = "nearest to the cursor"
ASKS = tuple(round(0.2 + 0.02 * i, 2) for i in range(40))
"""Precisions asked for, from which curves are drawn."""
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


class Decisions(msgspec.Struct, frozen=True):
    """What proposals at one precision asked for came to."""

    asked: float
    """Precision asked for."""
    precision: Number
    """Share of proposals that were right."""
    before_entry: Number
    """Share of movements in which the right target stood when the cursor entered it."""
    lead_entry_s: Number
    """Median time from that proposal to the entry, s."""
    lead_a_movement_s: Number
    """The same as a mean over all movements, 0 where nothing right stood, s."""
    lead_click_s: Number
    """Median time from that proposal to the end of the movement, s."""
    proposals: Number
    """Proposals a movement."""
    retractions: Number
    """Retractions a movement."""


class ChoiceSummary(msgspec.Struct, frozen=True):
    """The choices of one predictor; mappings by share of the time from onset to arrival, or by precision."""

    name: str
    right: dict[float, Number]
    """Share of movements whose likeliest target is the right one."""
    log_loss: dict[float, Number]
    """Mean of minus the logarithm of the right target's share."""
    abstained: dict[float, Number]
    """Share of movements with no target as likely as LEVEL."""
    decisions: dict[float, Decisions]
    """By each of ASKS."""
    at_precision: dict[float, Decisions | None]
    """As ``at_precision`` of LEVEL."""


class TargetSummary(msgspec.Struct, frozen=True):
    """One recording and kind of layout; ``None`` where a number means nothing."""

    name: str
    layout: str
    """What the candidates were."""
    trials: int
    nearest_centre: dict[float, Number]
    """Share of movements in which the target nearest to the cursor is the right one, by share of the time."""
    predictors: tuple[ChoiceSummary, ...]


class TargetDocument(msgspec.Struct, frozen=True):
    """What ``pointpred score --targets --json`` writes."""

    version: int
    targets: tuple[TargetSummary, ...]
    unread: tuple[Unread, ...]


def summarise_targets(scored: TargetSet) -> TargetSummary:
    """The numbers of a scored set."""
    return TargetSummary(
        scored.name,
        scored.layout,
        scored.trials,
        _by_time(scored.scores[0].by_time[:, :, replaying.NEAREST]),
        tuple(_summarise(score) for score in scored.scores),
    )


def target_summary(scored: TargetSet) -> dict[str, Any]:
    """The same as plain dictionaries."""
    plain: dict[str, Any] = msgspec.to_builtins(summarise_targets(scored), str_keys=True)
    return plain


def _summarise(score: TargetScore) -> ChoiceSummary:
    return ChoiceSummary(
        score.name,
        _by_time(score.by_time[:, :, replaying.RIGHT]),
        _by_time(score.by_time[:, :, replaying.LOSS]),
        _by_time((score.by_time[:, :, replaying.SURENESS] < LEVEL).astype(np.float64)),
        {ask: decisions(score, i) for i, ask in enumerate(ASKS)},
        {LEVEL: at_precision(score, LEVEL)},
    )


def _by_time(values: FloatArray) -> dict[float, Number]:
    means = values.mean(axis=0) if len(values) else np.full(len(TIME_FRACTIONS), np.nan)
    return dict(zip(TIME_FRACTIONS, map(number, means.tolist()), strict=True))


def decisions(score: TargetScore, ask: int) -> Decisions:
    """What the proposals at the precision ``ASKS[ask]`` came to."""
    account = score.accounts[:, ask]
    trials, proposed = len(account), account[:, replaying.PROPOSED].sum()
    hit = account[:, replaying.HIT] == 1.0
    lead_s = account[hit, replaying.LEAD_ENTRY]
    return Decisions(
        asked=ASKS[ask],
        precision=number(account[:, replaying.PROPOSED_RIGHT].sum() / proposed) if proposed else None,
        before_entry=number(hit.mean()) if trials else None,
        lead_entry_s=_middle(lead_s),
        lead_a_movement_s=number(lead_s.sum() / trials) if trials else None,
        lead_click_s=_middle(account[hit, replaying.LEAD_CLICK]),
        proposals=number(proposed / trials) if trials else None,
        retractions=number(account[:, replaying.RETRACTED].mean()) if trials else None,
    )


def at_precision(score: TargetScore, level: float) -> Decisions | None:
    """The decisions with the lowest precision asked for at which at least ``level`` of proposals were right.

    ``None`` where no dial reaches it. This looks at the trials it reports on, alike for every predictor.
    """
    for ask in range(len(ASKS)):
        one = decisions(score, ask)
        if one.precision is not None and one.precision >= level:
            return one
    return None


def _middle(values: FloatArray) -> float | None:
    return float(np.median(values)) if len(values) else None
