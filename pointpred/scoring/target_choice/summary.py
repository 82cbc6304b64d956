"""The numbers of scored choices: how often the likeliest target is right, and what proposals came to."""

from __future__ import annotations

import msgspec
import numpy as np

from pointpred.records import FloatArray
from pointpred.scoring import target_choice as replaying
from pointpred.scoring.results import TIME_FRACTIONS
from pointpred.scoring.summary.document import Number, Unread, number
from pointpred.scoring.target_choice import ASKS, TargetScore, TargetSet

LEVEL = 0.8
"""The precision at which predictors are compared."""


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
