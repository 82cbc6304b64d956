"""What the offline scorer says of trials, in the words of the service."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec import structs

from pointpred.pipeline import Pipeline
from pointpred.protocol.scores import score_of
from pointpred.protocol.server_messages import Score
from pointpred.recording import Recording
from pointpred.registry import build
from pointpred.scoring import prepare, replay


def local_scores(
    recording: Recording, places: Sequence[int], pipeline: Pipeline, *, cpi: float | None, dpi: float
) -> dict[int, Score]:
    """The batch's score of each trial, all replayed in one table.

    Each as of a user of its own: a service scores a marked trial with a predictor that knows nobody.
    """
    parts = [recording.rows(k) for k in places]
    trials = [structs.replace(recording.trials[k], user=str(k)) for k in places]
    prepared = prepare(Recording.of("replay", parts, trials), cpi=cpi, dpi=dpi)
    errors, floor = replay(prepared, pipeline), replay(prepared, build("hold", cpi=cpi, dpi=dpi))
    scored = {id(one.trial): row for row, one in enumerate(prepared.trials)}
    reasons = {(skip.user, skip.trial): skip.reason for skip in prepared.skipped}
    return {
        k: score_of(prepared, scored[id(trial)], errors, floor)
        if id(trial) in scored
        else Score(len(part), reason=reasons[trial.user, trial.trial])
        for k, part, trial in zip(places, parts, trials, strict=True)
    }
