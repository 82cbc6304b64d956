"""The predicting side of a session: events in, frames of predictions out."""

from __future__ import annotations

import numpy as np

from pointpred.columns import EventColumns
from pointpred.errors import ParameterError
from pointpred.pipeline import run
from pointpred.registry import REGISTRY, build
from pointpred.server import answers
from pointpred.server.decoding import RefusedError
from pointpred.server.messages import ErrorMessage, Goal, Hello, Score
from pointpred.server.outbox import Outbox
from pointpred.server.trials import TrialKeeper


class Stream:
    """A pipeline as a client asked for it, and the trial it marks."""

    def __init__(self, hello: Hello) -> None:
        """Raises RefusedError, naming what is known, for an unknown predictor or a wrong parameter."""
        if hello.predictor not in REGISTRY:
            words = f"unknown predictor {hello.predictor!r}; known: {', '.join(REGISTRY)}"
            raise RefusedError("unknown_predictor", words, "$.predictor")
        self.hello = hello
        self.cpi = hello.device.cpi if hello.device else None
        self.dpi = hello.screen.dpi if hello.screen else 96.0
        try:
            self.pipeline = build(hello.predictor, cpi=self.cpi, dpi=self.dpi, **hello.parameters)
        except (ParameterError, TypeError) as error:
            raise RefusedError("bad_field", str(error), "$.parameters") from None
        self.events = 0
        """Events taken in."""
        self._last_t = -np.inf
        self._trial = TrialKeeper()

    def feed(self, events: EventColumns, outbox: Outbox) -> tuple[ErrorMessage | None, int]:
        """Predict; events before the last one are dropped, the rest of the frame is kept.

        Returns what to say of the dropped ones, and how many they are.
        """
        late, error = self._late(events)
        kept = events if error is None else EventColumns(events.table[~late])
        if len(kept):
            predictions = run(self.pipeline, kept)
            self.events += len(kept)
            self._last_t = float(kept.table[-1, 0])
            self._trial.add(kept)
            binary, each = self.hello.encoding == "binary", self.hello.reply == "event"
            outbox.predict(*answers.frames(predictions, binary=binary, each=each))
        return error, len(events) - len(kept)

    def reset(self) -> None:
        """Forget every event: the next one starts a movement."""
        self.pipeline.reset()
        self._last_t = -np.inf

    def start_trial(self, goal: Goal | None) -> None:
        """A movement starts at the next event; its events are kept until the trial ends."""
        self._trial.start(goal)
        self.reset()

    def end_trial(self, goal: Goal | None) -> Score:
        """Score the trial; raises RefusedError where none was started."""
        if not self._trial.running:
            words = "expected 'trial' with action 'start' before 'end'"
            raise RefusedError("out_of_place", words, "$.action")
        return self._trial.end(goal, self.pipeline, self.cpi, self.dpi)

    def _late(
        self, events: EventColumns
    ) -> tuple[np.ndarray[tuple[int], np.dtype[np.bool_]], ErrorMessage | None]:
        t = events.table[:, 0]
        before = np.maximum.accumulate(np.concatenate([[self._last_t], t[:-1]]))
        late = t < before
        if not late.any():
            return late, None
        row = int(late.argmax())
        more = int(late.sum()) - 1
        also = f" ({more} more in this frame)" if more else ""
        said = f"t must not run backwards: {float(t[row])!r} s after {float(before[row])!r} s; dropped{also}"
        return late, ErrorMessage("out_of_order", said, f"$.events[{row}][0]")
