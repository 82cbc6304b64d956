"""What the offline scorer says of trials, in the words of the service."""

from __future__ import annotations

from collections.abc import Sequence

from pointpred.columns import FloatArray
from pointpred.pipeline import Pipeline
from pointpred.recording import Recording
from pointpred.registry import build
from pointpred.scoring import Prepared, prepare, replay
from pointpred.scoring.results import PATH_FRACTIONS, TIME_FRACTIONS, PredictorErrors
from pointpred.server.messages import Score


def local_scores(
    recording: Recording, places: Sequence[int], pipeline: Pipeline, *, cpi: float | None, dpi: float
) -> dict[int, Score]:
    """The batch's score of each trial, all replayed in one table."""
    parts = [recording.rows(k) for k in places]
    trials = [recording.trials[k] for k in places]
    prepared = prepare(Recording.of("replay", parts, trials), cpi=cpi, dpi=dpi)
    errors, floor = replay(prepared, pipeline), replay(prepared, build("hold", cpi=cpi, dpi=dpi))
    scored = {id(one.trial): row for row, one in enumerate(prepared.trials)}
    reasons = {(skip.user, skip.trial): skip.reason for skip in prepared.skipped}
    return {
        k: _score(prepared, scored[id(trial)], errors, floor)
        if id(trial) in scored
        else Score(len(part), reason=reasons[trial.user, trial.trial])
        for k, part, trial in zip(places, parts, trials, strict=True)
    }


def _score(prepared: Prepared, row: int, errors: PredictorErrors, floor: PredictorErrors) -> Score:
    own, none = float(errors.time_averaged[row]), float(floor.time_averaged[row])
    return Score(
        prepared.trials[row].events,
        time_averaged_px=own,
        hold_px=none,
        skill=1.0 - own / none if none > 0.0 else None,
        by_time=_known(TIME_FRACTIONS, errors.by_time[row]),
        by_path=_known(PATH_FRACTIONS, errors.by_path[row]),
    )


def _known(fractions: tuple[float, ...], errors: FloatArray) -> dict[str, float]:
    pairs = zip(fractions, errors.tolist(), strict=True)
    return {f"{share:g}": value for share, value in pairs if value == value}
