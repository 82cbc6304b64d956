"""The embedded sample for the page: its trials by name, and the events of one as columns."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from pointpred.datasets import sample
from pointpred.errors import ParameterError
from pointpred.recording import Recording


@cache
def _recording() -> Recording:
    return sample()


@cache
def _numbers() -> dict[str, int]:
    """The trial behind each name."""
    return {f"{trial.user}-{trial.trial}": i for i, trial in enumerate(_recording().trials)}


def listing() -> dict[str, Any]:
    """Every trial of the embedded sample by name."""
    recording = _recording()
    return {
        "version": 1,
        "recording": recording.name,
        "simulated": True,
        "samples": [
            {"name": name, "user": recording.trials[i].user, "events": len(recording.rows(i))}
            for name, i in _numbers().items()
        ],
    }


def trial(name: str) -> dict[str, Any]:
    """The events of one trial, times in s from its first event; raises ParameterError for an unknown name."""
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
    }


def _target(x: float, y: float, width: float) -> dict[str, float] | None:
    return None if np.isnan(x) or np.isnan(y) else {"x": x, "y": y, "width": width}
