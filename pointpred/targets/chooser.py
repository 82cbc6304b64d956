"""Predictions and events in, proposals out: the object that a session holds."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from math import nan
from typing import Literal, NamedTuple

import numpy as np

from pointpred.columns import BoolArray, FloatArray, PredictionColumns
from pointpred.errors import EventError, EventOrderError, ParameterError
from pointpred.events import PointerEvent, Prediction
from pointpred.stage import Parameter, check
from pointpred.targets import cursor, decision, posterior
from pointpred.targets.choosing import step
from pointpred.targets.ledger import Ledger, Movement
from pointpred.targets.rectangles import Target, table


class Choice(NamedTuple):
    """A change of mind: the target, its share at that moment, and what to do with it."""

    id: Hashable
    p: float
    action: Literal["propose", "retract"]


class Chooser:
    """Which rectangle the cursor is heading for, and whether that is sure enough to say so.

    Parameters: ``precision`` is the share of proposals that shall be right; ``elsewhere`` the share of
    movements that go to none of the targets, before anything is seen; ``least_lead_s`` s, a target that the
    cursor enters sooner is not proposed. Memory: 15 floats of the cursor, 13 floats a target, the ledger.
    Raises ParameterError, and EventError or EventOrderError from ``update``; nothing is then changed.

    >>> from pointpred import build
    >>> from pointpred.targets import around
    >>> chooser, pipeline = Chooser(precision=0.6), build("minimum-jerk")
    >>> _ = chooser.replace([around("left", -400.0, 0.0, 40.0), around("right", 400.0, 0.0, 40.0)])
    >>> for i in range(30):
    ...     event = PointerEvent(i / 100, 400.0 * (i / 60) ** 2 * (3 - 2 * i / 60), 0.0)
    ...     for choice in chooser.update(pipeline.update(event), event):
    ...         print(choice.id, choice.action)
    right propose
    """

    parameters = (
        Parameter("precision", "", 0.01, 0.999, "share of proposals that shall be right"),
        Parameter("elsewhere", "", 1e-6, 0.999999, "share of movements that go to none of the targets"),
        Parameter("least_lead_s", "s", 0.0, 10.0, "what the cursor enters sooner is not proposed"),
    )

    def __init__(
        self,
        targets: Sequence[Target] = (),
        *,
        precision: float = 0.8,
        elsewhere: float = 0.02,
        least_lead_s: float = 0.05,
        coefficients: FloatArray = posterior.FITTED,
    ) -> None:
        self._last: Prediction | None = None
        self._settings = np.zeros(len(self.parameters))
        self.configure(precision=precision, elsewhere=elsewhere, least_lead_s=least_lead_s)
        if np.shape(coefficients) != (posterior.COEFFICIENTS,) or not np.isfinite(coefficients).all():
            raise ParameterError(f"coefficients must be {posterior.COEFFICIENTS} finite numbers")
        self._coefficients = np.array(coefficients, dtype=np.float64)
        self._memory = np.zeros(cursor.STATES)
        self._standing = decision.NOBODY
        self._ids: tuple[Hashable, ...] = ()
        self.ledger = Ledger()
        self.replace(targets)

    def configure(
        self,
        *,
        precision: float | None = None,
        elsewhere: float | None = None,
        least_lead_s: float | None = None,
    ) -> None:
        """Change what is given, from the next event on; raises ParameterError and then changes nothing."""
        given = {"precision": precision, "elsewhere": elsewhere, "least_lead_s": least_lead_s}
        values = {name: value for name, value in given.items() if value is not None}
        check(tuple(p for p in self.parameters if p.name in values), values)
        for place, parameter in enumerate(self.parameters):
            self._settings[place] = values.get(parameter.name, self._settings[place])

    def replace(self, targets: Sequence[Target]) -> tuple[Choice, ...]:
        """Take other targets, at any time; a proposal of one that is gone is withdrawn.

        Raises ParameterError for too many, or for one out of bounds; the old ones are then kept.
        """
        rows, standing = table(targets), self.standing
        self._table, self._ids = rows, tuple(target.id for target in targets)
        self._rows = np.empty((len(rows), posterior.FEATURES))
        self._shares = np.zeros(len(rows) + 1)
        self._shares[-1] = 1.0
        self._inside: BoolArray = np.zeros(len(rows), dtype=np.bool_)
        self._standing = decision.NOBODY
        if standing is None:
            return ()
        if standing in self._ids:
            self._standing = self._ids.index(standing)
            return ()
        self.ledger.retract(self._memory[cursor.T], standing)
        return (Choice(standing, 0.0, "retract"),)

    @property
    def standing(self) -> Hashable | None:
        """The target that is proposed now."""
        return None if self._standing == decision.NOBODY else self._ids[self._standing]

    @property
    def shares(self) -> FloatArray:
        """How likely each target is after the last event, in their order; the last is *none of them*."""
        return self._shares.copy()

    def likeliest(self, most: int = 5) -> list[tuple[Hashable, float]]:
        """The likeliest targets and their shares, best first."""
        shares = self._shares[:-1]
        order = np.argsort(-shares, kind="stable")[:most]
        return [(self._ids[i], float(shares[i])) for i in order.tolist()]

    def heading_to(self, target: Target, *, elsewhere: float = 0.5) -> float:
        """How likely the cursor is heading for this rectangle, which need not be among the targets.

        The choice is between it and anywhere else, where ``elsewhere`` of movements go before anything is
        seen; as it was after the last event. Raises ParameterError.
        """
        check(self.parameters[1:2], {"elsewhere": elsewhere})
        rows, shares = table([target]), np.empty(2)
        scratch = np.empty((1, posterior.FEATURES))
        answer = _row(self._last)
        posterior.scores(self._memory, rows, answer, self._coefficients, elsewhere, scratch, shares)
        posterior.normalise(shares)
        return float(shares[0])

    def update(self, prediction: Prediction | None, event: PointerEvent) -> tuple[Choice, ...]:
        """Take an event and the prediction made at it; what has changed, at most two choices.

        Raises EventError for an event that is not finite, EventOrderError for one before the last.
        """
        t, x, y = float(event.t), float(event.x), float(event.y)
        if not cursor.usable(t, x, y):
            raise EventError(f"an event needs finite numbers within bounds, received {event!r}")
        memory = self._memory
        if memory[cursor.KNOWN] == 1.0 and t < memory[cursor.T]:
            raise EventOrderError(f"t must not run backwards: {t!r} after {memory[cursor.T]!r}")
        self._shares, self._last = np.empty(len(self._table) + 1), prediction
        chosen = step(
            memory,
            self._table,
            t,
            x,
            y,
            float(event.buttons & 1),
            _row(prediction),
            self._coefficients,
            self._settings,
            self._standing,
            self._rows,
            self._shares,
        )
        self._note_entries(t, x, y)
        return self._change(t, chosen)

    def finish(self, target: Hashable | None) -> Movement:
        """Close the movement at the last event, a click on ``target``, in the ledger.

        The proposal stands until the next movement starts.
        """
        return self.ledger.finish(float(self._memory[cursor.T]), target)

    def reset(self) -> None:
        """Forget every event and the proposal; targets, parameters and the ledger's counts stay."""
        self._memory = np.zeros(cursor.STATES)
        self._standing, self._last = decision.NOBODY, None
        self._shares[:] = 0.0
        self._shares[-1] = 1.0
        self._inside[:] = False
        self.ledger.drop()

    def _note_entries(self, t: float, x: float, y: float) -> None:
        """Tell the ledger which targets the cursor has just gone into."""
        off = np.abs(self._table[:, :2] - (x, y))
        inside: BoolArray = np.asarray((off <= 0.5 * self._table[:, 2:4]).all(axis=1))
        for i in np.flatnonzero(inside & ~self._inside).tolist():
            self.ledger.enter(t, self._ids[i])
        self._inside = inside

    def _change(self, t: float, chosen: int) -> tuple[Choice, ...]:
        """From the proposal that stands to the chosen one."""
        before, self._standing = self._standing, chosen
        if chosen == before:
            return ()
        changed: list[Choice] = []
        if before != decision.NOBODY:
            self.ledger.retract(t, self._ids[before])
            changed.append(Choice(self._ids[before], float(self._shares[before]), "retract"))
        if chosen != decision.NOBODY:
            self.ledger.propose(t, self._ids[chosen])
            changed.append(Choice(self._ids[chosen], float(self._shares[chosen]), "propose"))
        return tuple(changed)


def _row(prediction: Prediction | None) -> FloatArray:
    """A prediction as a row of ``PredictionColumns``, NaN for what is not claimed; the phase is not used."""
    row = np.full(len(PredictionColumns.names), nan)
    if prediction is not None:
        row[1:3] = prediction.x, prediction.y
        if prediction.covariance is not None:
            row[3:6] = prediction.covariance
        if prediction.remaining_s is not None:
            row[6] = prediction.remaining_s
        if prediction.tail is not None:
            row[8] = prediction.tail
    return row
