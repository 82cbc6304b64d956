"""The embedded sample for the replay view: one trial and the predictions along it, as columns."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from pointpred.datasets import sample
from pointpred.errors import ParameterError
from pointpred.pipeline import run
from pointpred.recording import Recording
from pointpred.records import FloatArray
from pointpred.registry import REGISTRY, build


@cache
def _recording() -> Recording:
    return sample()


@cache
def _numbers() -> dict[str, int]:
    """The trial behind each name."""
    return {f"{trial.user}-{trial.trial}": i for i, trial in enumerate(_recording().trials)}


def listing() -> dict[str, Any]:
    """Every trial of the embedded sample by name, and the predictors that can be shown along it."""
    recording = _recording()
    shown = [{"name": entry.name, "title": entry.title} for entry in REGISTRY.values()]
    return {
        "version": 1,
        "recording": recording.name,
        "simulated": True,
        "predictors": shown,
        "samples": [
            {"name": name, "user": recording.trials[i].user, "events": len(recording.rows(i))}
            for name, i in _numbers().items()
        ],
    }


def trial(name: str, predictors: tuple[str, ...]) -> dict[str, Any]:
    """One trial with the predictions of some predictors; raises ParameterError for an unknown name."""
    number = _numbers().get(name)
    if number is None:
        raise ParameterError(f"unknown sample {name!r}; GET /v1/samples lists the names")
    recording = _recording()
    events, about = recording.rows(number), recording.trials[number]
    return {
        "version": 1,
        "name": name,
        "user": about.user,
        "target": _target(about.target_x, about.target_y, about.target_w),
        "dpi": recording.provenance.dpi,
        "cpi": recording.provenance.cpi,
        "t": (events.t - events.t[0]).tolist(),
        "x": events.x.tolist(),
        "y": events.y.tolist(),
        "dx": events.dx.tolist(),
        "dy": events.dy.tolist(),
        "buttons": events.buttons.tolist(),
        "predictions": {which: _predict(which, recording, number) for which in predictors},
    }


def _predict(predictor: str, recording: Recording, number: int) -> dict[str, Any]:
    """Predictions after each event; NaN, which JSON shows as null, where nothing was justified.

    ``region``: the numbers of a region as columns; ``None`` where none is claimed at any event.
    """
    origin = recording.provenance
    predicted = run(build(predictor, cpi=origin.cpi, dpi=origin.dpi), recording.rows(number))
    scale = {name: _significant(getattr(predicted, name)) for name in ("sxx", "sxy", "syy", "tail")}
    claimed = bool(np.isfinite(predicted.sxx).any())
    return {
        "x": _column(predicted.x, 2),
        "y": _column(predicted.y, 2),
        "region": scale if claimed else None,
    }


def _target(x: float, y: float, width: float) -> dict[str, float] | None:
    return None if np.isnan(x) or np.isnan(y) else {"x": x, "y": y, "width": width}


def _column(values: FloatArray, digits: int) -> list[float]:
    rounded: list[float] = np.round(values, digits).tolist()
    return rounded


def _significant(values: FloatArray) -> list[float]:
    """Matrices need the same digits at every size: a thin one is lost to rounding."""
    return [float(f"{value:.9g}") for value in values.tolist()]
