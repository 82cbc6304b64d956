"""The scorer's errors of one trial as a ``score`` message."""

from __future__ import annotations

from pointpred.protocol.server_messages import Score
from pointpred.records import FloatArray
from pointpred.scoring import Prepared
from pointpred.scoring.results import PATH_FRACTIONS, TIME_FRACTIONS, PredictorErrors


def score_of(prepared: Prepared, row: int, errors: PredictorErrors, floor: PredictorErrors) -> Score:
    """The errors of one prepared trial, beside those of ``hold``, which predicts no movement."""
    own, none = float(errors.time_averaged[row]), float(floor.time_averaged[row])
    return Score(
        prepared.trials[row].events,
        time_averaged_px=own,
        hold_px=none,
        skill=1.0 - own / none if none > 0.0 else None,
        by_time=_named(TIME_FRACTIONS, errors.by_time[row]),
        by_path=_named(PATH_FRACTIONS, errors.by_path[row]),
    )


def _named(fractions: tuple[float, ...], errors: FloatArray) -> dict[str, float]:
    pairs = zip(fractions, errors.tolist(), strict=True)
    return {f"{share:g}": value for share, value in pairs if value == value}
