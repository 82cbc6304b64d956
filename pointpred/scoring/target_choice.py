"""Which of several targets a movement is for: choices among candidates, and how often they are right."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from math import log
from typing import Any

import msgspec
import numpy as np

from pointpred.compiled import law
from pointpred.pipeline import Pipeline, run
from pointpred.recording import Recording
from pointpred.records import FloatArray, FloatTable, row_at
from pointpred.registry import build, settings_in
from pointpred.scoring.results import TIME_FRACTIONS
from pointpred.scoring.selection import Where, names_of
from pointpred.scoring.spans import in_threads
from pointpred.scoring.summary.document import Document, Number, number
from pointpred.scoring.target_layouts import Layout, layouts
from pointpred.scoring.trials import Prepared, prepare, resolution
from pointpred.targets import cursor, decision, ledger, posterior
from pointpred.targets.choice_law import KEEP
from pointpred.targets.rectangles import NOBODY

NEAREST = "nearest to the cursor"
ASKS = tuple(round(0.2 + 0.02 * i, 2) for i in range(40))
"""Precisions asked for, from which curves are drawn."""
FRACTIONS: FloatArray = np.array(TIME_FRACTIONS)
LEVEL = 0.8
"""The precision at which predictors are compared."""

# At each time fraction: whether the likeliest target is the right one, minus the logarithm of the right
# one's share, the largest share, and whether the nearest target is the right one.
RIGHT, LOSS, SURENESS, NEAREST_RIGHT = 0, 1, 2, 3
READ = 4

# Of a trial at one precision: proposals, right ones, retractions, whether the right one stood when the cursor
# entered it, and since when before the entry and before the end.
PROPOSED, PROPOSED_RIGHT, RETRACTED, HIT, LEAD_ENTRY, LEAD_CLICK = 0, 1, 2, 3, 4, 5
ACCOUNT = 6

SMALLEST = 1e-12
"""Of a share in the logarithm of the log loss."""


@law
def weigh(
    events: FloatTable,
    answers: FloatTable,
    table: FloatTable,
    coefficients: posterior.Coefficients,
    elsewhere: float,
    shares: FloatTable,
) -> None:
    """The shares of all targets after each event, in a row of ``shares``."""
    memory = cursor.State(np.zeros(cursor.State.length))
    for i in range(len(events)):
        cursor.follow(memory, events[i, 0], events[i, 1], events[i, 2], 0.0)
        posterior.scores(memory, table, row_at(answers, i), coefficients, elsewhere, shares[i])
        posterior.normalise(shares[i])


@law
def nearest(table: FloatTable, x: float, y: float) -> int:
    """The target whose centre is nearest."""
    best, least = 0, np.inf
    for i in range(len(table)):
        far = (table[i, 0] - x) ** 2 + (table[i, 1] - y) ** 2
        if far < least:
            best, least = i, far
    return best


@law
def read(
    events: FloatTable,
    table: FloatTable,
    shares: FloatTable,
    arrival: int,
    right: int,
    fractions: FloatArray,
    out: FloatTable,
) -> None:
    """Read the shares at fractions of the time from the first event to the arrival."""
    i = 0
    for k in range(len(fractions)):
        until = events[0, 0] + fractions[k] * (events[arrival, 0] - events[0, 0])
        while i + 1 < len(events) and events[i + 1, 0] <= until:
            i += 1
        best = decision.likeliest(shares[i], len(table))
        out[k, RIGHT] = 1.0 if best == right else 0.0
        out[k, LOSS] = -log(max(shares[i, right], SMALLEST))
        out[k, SURENESS] = shares[i, best]
        out[k, NEAREST_RIGHT] = 1.0 if nearest(table, events[i, 1], events[i, 2]) == right else 0.0


@law
def account(
    events: FloatTable,
    answers: FloatTable,
    table: FloatTable,
    shares: FloatTable,
    right: int,
    ask: float,
    least_s: float,
    least_px: float,
    out: FloatArray,
) -> None:
    """Decide after each event at one precision, and the account of the movement by the laws of the ledger.

    The ledger has one row for the right target and one for all others.
    """
    memory = cursor.State(np.zeros(cursor.State.length))
    movement = ledger.State(np.zeros(ledger.State.length))
    rows = np.zeros((2, ledger.FIELDS))
    ledger.begin(movement, rows)
    standing = NOBODY
    for i in range(len(events)):
        t, x, y = events[i, 0], events[i, 1], events[i, 2]
        cursor.follow(memory, t, x, y, 0.0)
        inside = abs(x - table[right, 0]) <= 0.5 * table[right, 2]
        if inside and abs(y - table[right, 1]) <= 0.5 * table[right, 3]:
            ledger.enter(movement, rows, t, 0)
        bounds = ask, KEEP * ask, least_s, least_px
        chosen = decision.decide(memory, table, shares[i], standing, answers[i, 6], bounds)
        if chosen != standing:
            if standing != NOBODY:
                ledger.withdraw(movement, t, 0 if standing == right else 1, False)
            if chosen != NOBODY:
                ledger.propose(movement, rows, t, 0 if chosen == right else 1)
            standing = chosen
    made, lead_entry_s, lead_click_s = ledger.close(movement, rows, events[len(events) - 1, 0], 0)
    out[PROPOSED], out[PROPOSED_RIGHT] = movement.proposed, made
    out[RETRACTED], out[HIT] = movement.retracted, 1.0 if lead_click_s == lead_click_s else 0.0
    out[LEAD_ENTRY], out[LEAD_CLICK] = lead_entry_s, lead_click_s


class TargetScore(msgspec.Struct, frozen=True):
    """What one predictor's choices came to, a row a trial."""

    name: str
    by_time: FloatArray
    """(trials, TIME_FRACTIONS, 4) as ``read`` names them"""
    accounts: FloatArray
    """(trials, ASKS, 6) as ``account`` names them"""


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
    where: Where | None = None,
) -> list[TargetSet]:
    """Score the choices of predictors among the targets of a recording, and the nearest to the cursor.

    One result for each kind of layout that the recording's trials have.

    ``predictors``, ``parameters`` and ``where``: as for ``score``; the laws are those of ``Chooser``. The
    baseline's shares depend on the distance from the cursor to each target alone, with coefficients of their
    own. Raises what a pipeline raises.
    """
    settings = resolution(recording, cpi, dpi)
    prepared = prepare(recording, **settings, threads=threads)
    least = (least_lead_s, least_way_px)
    pipelines = {NEAREST: build("hold", **settings)}
    for predictor in predictors:
        if isinstance(predictor, Pipeline):
            pipelines[predictor.name] = predictor
        else:
            known, said = settings_in(predictor)
            pipelines[predictor] = build(known, **settings, **{**(parameters or {}).get(known, {}), **said})
    mask = None if where is None else where.mask(prepared.trials, names_of(prepared.trials))
    sets = []
    for kind, every in layouts(prepared, seed).items():
        candidates = [one for one in every if mask is None or mask[one.trial]]
        if not candidates:
            continue
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
    by_time = np.empty((len(inside), len(FRACTIONS), READ))
    accounts = np.empty((len(inside), len(ASKS), ACCOUNT))
    base = int(prepared.offsets[first])
    rows = prepared.events.rows(base, int(prepared.offsets[stop]))
    answers = run(pipeline.fresh(), rows).table
    for place, layout in enumerate(inside):
        k, targets, right = layout.trial, layout.table, layout.right
        a, b = int(prepared.offsets[k]) - base, int(prepared.offsets[k + 1]) - base
        events, own = rows.table[a:b], answers[a:b]
        shares = np.empty((b - a, len(targets) + 1))
        weigh(events, own, targets, coefficients, elsewhere, shares)
        arrival = int(prepared.arrivals[k]) - base - a
        read(events, targets, shares, arrival, right, FRACTIONS, by_time[place])
        for i, ask in enumerate(ASKS):
            account(events, own, targets, shares, right, ask, *least, accounts[place, i])
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


class TargetDocument(Document, frozen=True, kw_only=True):
    """What ``pointpred score --targets --json`` writes."""

    targets: tuple[TargetSummary, ...]


def summarise_targets(scored: TargetSet) -> TargetSummary:
    """The numbers of a scored set."""
    return TargetSummary(
        scored.name,
        scored.layout,
        scored.trials,
        _by_time(scored.scores[0].by_time[:, :, NEAREST_RIGHT]),
        tuple(_summarise(score) for score in scored.scores),
    )


def _summarise(score: TargetScore) -> ChoiceSummary:
    return ChoiceSummary(
        score.name,
        _by_time(score.by_time[:, :, RIGHT]),
        _by_time(score.by_time[:, :, LOSS]),
        _by_time((score.by_time[:, :, SURENESS] < LEVEL).astype(np.float64)),
        {ask: decisions(score, i) for i, ask in enumerate(ASKS)},
        {LEVEL: at_precision(score, LEVEL)},
    )


def _by_time(values: FloatArray) -> dict[float, Number]:
    means = values.mean(axis=0) if len(values) else np.full(len(TIME_FRACTIONS), np.nan)
    return dict(zip(TIME_FRACTIONS, map(number, means.tolist()), strict=True))


def decisions(score: TargetScore, ask: int) -> Decisions:
    """What the proposals at the precision ``ASKS[ask]`` came to."""
    account = score.accounts[:, ask]
    trials, proposed = len(account), account[:, PROPOSED].sum()
    hit = account[:, HIT] == 1.0
    lead_s = account[hit, LEAD_ENTRY]
    return Decisions(
        asked=ASKS[ask],
        precision=number(account[:, PROPOSED_RIGHT].sum() / proposed) if proposed else None,
        before_entry=number(hit.mean()) if trials else None,
        lead_entry_s=_middle(lead_s),
        lead_a_movement_s=number(lead_s.sum() / trials) if trials else None,
        lead_click_s=_middle(account[hit, LEAD_CLICK]),
        proposals=number(proposed / trials) if trials else None,
        retractions=number(account[:, RETRACTED].mean()) if trials else None,
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
