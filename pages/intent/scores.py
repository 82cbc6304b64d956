"""What ForesightJS's rule and the prefetch policy come to over recorded movements."""

from __future__ import annotations

from collections.abc import Sequence

import msgspec
import numpy as np

from pages.intent import foresight, replay
from pages.intent.movements import Movement
from pointpred.records import FloatArray
from pointpred.targets import prefetch


class Score(msgspec.Struct, frozen=True):
    """Of many movements over one layout."""

    movements: int
    firings: float
    """A movement, with targets that the movement starts in."""
    elsewhere: float
    """A movement, without them."""
    before: float
    """Share of movements whose right target fired before the cursor entered it."""
    lead_s: float
    """Median time from the right firing to the entry, over the movements with one before the entry."""
    lead_all_s: float
    """The same over all movements, 0 where nothing fired before the entry."""


def by_rule(movement: Movement, frame_s: float) -> FloatArray:
    """When each target fires by ForesightJS's rule, s; infinite where it does not."""
    fired_at = np.empty(len(movement.table))
    foresight.fire(movement.events, movement.table, frame_s, fired_at)
    return fired_at


def shares_of(movement: Movement, predictor: str, coefficients: FloatArray, frame_s: float) -> FloatArray:
    """The shares of all targets at the end of each frame, a row an event."""
    shares = np.zeros((len(movement.events), len(movement.table) + 1))
    replay.weigh(movement.events, movement.answers[predictor], movement.table, coefficients, frame_s, shares)
    return shares


def by_policy(
    movement: Movement,
    shares: FloatArray,
    settings: FloatArray,
    frame_s: float,
    threshold: float = prefetch.THRESHOLD,
) -> FloatArray:
    """When each target fires by the prefetch policy, s; infinite where it does not."""
    fired_at = np.empty(len(movement.table))
    replay.fire(movement.events, shares, movement.table, settings, threshold, frame_s, fired_at)
    return fired_at


def score(movements: Sequence[Movement], fired: Sequence[FloatArray]) -> Score:
    """The score of movements, given when each of their targets fired."""
    counts, elsewhere, leads = [], [], []
    for movement, at in zip(movements, fired, strict=True):
        x, y = movement.events[0, 1:3].tolist()
        starts = np.array([prefetch.inside(x, y, row) for row in movement.table])
        counts.append(int(np.isfinite(at).sum()))
        elsewhere.append(int((np.isfinite(at) & ~starts).sum()))
        leads.append(movement.events[movement.entry, 0] - at[movement.right])
    lead = np.array(leads)
    early = lead > 0.0
    return Score(
        len(lead),
        float(np.mean(counts)),
        float(np.mean(elsewhere)),
        float(early.mean()),
        float(np.median(lead[early])) if early.any() else 0.0,
        float(np.median(np.where(early, lead, 0.0))),
    )
