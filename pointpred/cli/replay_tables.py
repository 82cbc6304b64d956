"""The outcome of a replay: one line a trial, and as JSON."""

from __future__ import annotations

import msgspec

from pointpred.console import results
from pointpred.live.socket import Replayed
from pointpred.protocol.server_messages import Score
from pointpred.recording import Skip


class ReplayedTrialRow(msgspec.Struct, frozen=True):
    """One trial of ``ReplayDocument``; ``score`` from the service's answers, ``batch`` from a local run."""

    user: str
    trial: str
    events: int
    predictions: int
    gave_way: int
    unlike: int
    seconds: float
    agree: bool
    score: Score
    batch: Score


class ReplayDocument(msgspec.Struct, frozen=True, kw_only=True):
    """What ``--json`` writes of a replay to a service."""

    version: int = 1
    recording: str
    predictor: str
    agree: bool
    trials: list[ReplayedTrialRow]
    skipped: tuple[Skip, ...]


class DrivenTrialRow(msgspec.Struct, frozen=True):
    """One trial of ``DriveDocument``: what was done to the mouse of the page."""

    trial: str
    moves: int
    presses: int
    releases: int
    seconds: float


class DriveDocument(msgspec.Struct, frozen=True, kw_only=True):
    """What ``--json`` writes of a replay as the mouse of a page."""

    version: int = 1
    recording: str
    trials: list[DrivenTrialRow]
    skipped: tuple[Skip, ...]


def document(played: Replayed) -> ReplayDocument:
    """The document of a replay to a service."""
    trials = [
        ReplayedTrialRow(
            one.user,
            one.trial,
            one.events,
            one.predictions,
            one.gave_way,
            one.unlike,
            one.seconds,
            one.agrees,
            one.score,
            one.local,
        )
        for one in played.trials
    ]
    return ReplayDocument(
        recording=played.recording,
        predictor=played.predictor,
        agree=played.agrees,
        trials=trials,
        skipped=played.skipped,
    )


def print_played(played: Replayed) -> None:
    """One line a trial, and how many are as the batch."""
    from rich.table import Table

    table = Table("trial", "events", "error, px", "batch, px", "no prediction, px", "s", "as the batch")
    for one in played.trials:
        own, local, none = (
            _px(v) for v in (one.score.time_averaged_px, one.local.time_averaged_px, one.score.hold_px)
        )
        verdict = "bit for bit" if one.agrees else f"{one.unlike} of {one.predictions} differ"
        if one.unlike == 0 and not one.agrees:
            verdict = "the scores differ"
        if one.gave_way:
            verdict += f", {one.gave_way} gave way"
        table.add_row(
            f"{one.user}-{one.trial}", str(one.events), own, local, none, f"{one.seconds:.2f}", verdict
        )
    results().print(table)
    same = sum(one.agrees for one in played.trials)
    results().print(
        f"{same} of {len(played.trials)} trials as the local batch, bit for bit ({played.predictor})"
    )


def _px(value: float | None) -> str:
    return "-" if value is None else f"{value:.1f}"
