"""Predictions and events in, the targets to prefetch out."""

from __future__ import annotations

from collections.abc import Hashable, Sequence

import numpy as np

from pointpred.parameter import Parameter, check
from pointpred.records import FloatArray, PointerEvent, Prediction, prediction_row
from pointpred.targets import cursor, posterior, prefetch
from pointpred.targets.inputs import accepted
from pointpred.targets.rectangles import Target, table

SETTINGS: FloatArray = np.array(prefetch.FITTED)


class Prefetcher:
    """Fires prefetches: several targets at once, each early where its probability reaches the threshold.

    Each target fires once a movement, when the cursor enters it at the latest; a firing is never withdrawn.
    Parameters: ``threshold`` in (0, 1), how likely it must be that the cursor goes through the target, on a
    scale on which 0.5 fires about as often as a straight line of 120 ms does; higher fires later and less
    often, 1 at entry only. ``elsewhere``: the share of movements that go to none
    of the targets, before anything is seen. Memory: 17 floats of the cursor and the movement, 9 a target.
    Raises ParameterError, and EventError or EventOrderError from ``update``; nothing is then changed.

    >>> from pointpred import build
    >>> from pointpred.targets import around
    >>> pipeline = build("minimum-jerk")
    >>> prefetcher = Prefetcher([around("left", -400.0, 0.0, 40.0), around("right", 400.0, 0.0, 40.0)])
    >>> for i in range(60):
    ...     event = PointerEvent(i / 100, 400.0 * (i / 60) ** 2 * (3 - 2 * i / 60), 0.0)
    ...     for id in prefetcher.update(pipeline.update(event), event):
    ...         print(id)
    right
    """

    parameters = (
        Parameter("threshold", "", 0.0, 1.0, "how likely it must be that the cursor goes through the target"),
        Parameter("elsewhere", "", 1e-6, 0.999999, "share of movements that go to none of the targets"),
    )

    def __init__(
        self,
        targets: Sequence[Target] = (),
        *,
        threshold: float = prefetch.THRESHOLD,
        elsewhere: float = prefetch.ELSEWHERE,
    ) -> None:
        check(self.parameters, {"threshold": threshold, "elsewhere": elsewhere})
        self._threshold, self._elsewhere = threshold, elsewhere
        self._memory = np.zeros(prefetch.STATES)
        self._ids: tuple[Hashable, ...] = ()
        self._fired = np.zeros(0)
        self.replace(targets)

    def replace(self, targets: Sequence[Target]) -> None:
        """Take other targets, at any time; one that stays and has fired does not fire again.

        Raises ParameterError for too many, or for one out of bounds; the old ones are then kept.
        """
        rows, known = table(targets), dict(zip(self._ids, self._fired.tolist(), strict=True))
        self._table, self._ids = rows, tuple(target.id for target in targets)
        self._fired = np.array([known.get(id, prefetch.ARMED) for id in self._ids])
        self._thresholds = np.full(len(rows), self._threshold)
        self._visits, self._shares = np.zeros(len(rows)), np.zeros(len(rows) + 1)

    @property
    def visits(self) -> FloatArray:
        """How likely the cursor goes through each target after the last event, in their order."""
        return self._visits.copy()

    def update(self, prediction: Prediction | None, event: PointerEvent) -> tuple[Hashable, ...]:
        """Take an event and the prediction made at it; the targets that fire now, in their order."""
        memory = self._memory
        t, x, y, pressed = accepted(memory, event)
        cursor.follow(memory, t, x, y, pressed)
        answer = prediction_row(prediction)
        posterior.scores(memory, self._table, answer, posterior.FITTED_PAGES, self._elsewhere, self._shares)
        posterior.normalise(self._shares)
        targets = self._table, self._thresholds, self._visits, self._fired
        if prefetch.step(memory, targets, self._shares, SETTINGS) == 0:
            return ()
        return tuple(self._ids[i] for i in np.flatnonzero(self._fired >= prefetch.PREDICTED).tolist())

    def reset(self) -> None:
        """Forget every event; what has fired is armed again, but for a target that the next event lies in."""
        self._memory = np.zeros(prefetch.STATES)
        self._fired[self._fired != prefetch.ARMED] = prefetch.RESTING
