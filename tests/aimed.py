"""A pipeline that is told its predictions: what choosers decide by, without a predictor."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from pointpred import Place, PointerEvent, Prediction
from pointpred.records import TenFloats, event_row, prediction_row
from pointpred.targets import Target
from pointpred.targets.aim import Aim


class Told:
    """Targets and a person's places; ``settings`` are those of ``Aim``, which learns nothing unless told."""

    def __init__(self, targets: Sequence[Target] = (), places: Sequence[Place] = (), **settings: Any) -> None:
        self.aim = Aim(**{"learn": 0, **settings})
        self.aim.register(targets)
        self.places = tuple(places)

    def take(self, prediction: Prediction | None, event: PointerEvent) -> TenFloats:
        """Take an event and the prediction made at it, and answer the prediction given the targets."""
        return self.aim.given(event_row(event), prediction_row(prediction, event.t))
