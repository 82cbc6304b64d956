"""What a replay has shown: one line a trial, and the same as JSON."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pointpred.console import results

if TYPE_CHECKING:
    from pointpred.replaying import Replayed


def described(played: Replayed) -> dict[str, Any]:
    """What ``--json`` writes."""
    return {
        "version": 1,
        "recording": played.recording,
        "predictor": played.predictor,
        "agree": played.agrees,
        "trials": [
            {
                "user": one.user,
                "trial": one.trial,
                "events": one.events,
                "predictions": one.predictions,
                "gave_way": one.gave_way,
                "unlike": one.unlike,
                "seconds": one.seconds,
                "agree": one.agrees,
                "score": plain(one.score),
                "batch": plain(one.local),
            }
            for one in played.trials
        ],
        "skipped": [plain(skip) for skip in played.skipped],
    }


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


def plain(value: Any) -> Any:
    """A struct as what JSON knows."""
    import msgspec

    return msgspec.to_builtins(value)
