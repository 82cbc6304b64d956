"""The predicting side of a session: events in, frames of predictions out."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path

import numpy as np
from msgspec import structs

from pointpred.columns import EventColumns, FloatArray, PredictionColumns
from pointpred.person import portable, restore
from pointpred.pipeline import run
from pointpred.protocol.client_messages import Configure, Goal, Hello, Target
from pointpred.protocol.decoding import check_numbers
from pointpred.protocol.errors import ProtocolError
from pointpred.protocol.frames import Frame, prediction_frames, row_encoder
from pointpred.protocol.server_messages import ErrorMessage, Likely
from pointpred.server.sessions.building import NO_COEFFICIENTS, cpi_of, dpi_of, pipeline_of
from pointpred.server.sessions.choices import Choices, Taken
from pointpred.server.sessions.outbox import Outbox
from pointpred.server.sessions.trials import Scoring, TrialKeeper, with_account
from pointpred.server.sessions.watch import Watch

Work = Callable[[], Callable[[], None]]
"""Takes long, and any thread may run it; what it returns says what came of it, where the session is."""
NEVER = float("-inf")
NOWHERE = np.zeros(100_000, np.bool_)
"""A frame resets nothing between its events; as long as the longest frame that settings allow."""


class Stream:
    """A pipeline as a client asked for it, and the trial it marks."""

    def __init__(
        self,
        hello: Hello,
        watch: Watch | None = None,
        coefficients: Mapping[str, Path] = NO_COEFFICIENTS,
    ) -> None:
        """Raises ProtocolError for an unknown predictor, a wrong parameter or a person that cannot be taken.

        ``coefficients``: the files that the client may ask for by name.
        """
        self._build = partial(pipeline_of, coefficients=coefficients)
        self.pipeline = self._build(hello)
        self.hello = structs.replace(hello, person="")  # the pipeline knows it, and learns on
        self.precision: float | None = None
        """The precision a client wishes proposals to have."""
        self.choices: Choices | None = None
        """Decides among the targets, where there are any."""
        self.events = 0
        """Events taken in."""
        self.watch = watch
        self.work: Work | None = None
        """What is to be run before the next frame is taken in, and what it returns after it."""
        self._binary = hello.encoding == "binary"
        self._frame = row_encoder(binary=self._binary)
        self._last_t = NEVER
        self._trial = TrialKeeper()

    def feed(self, table: FloatArray, outbox: Outbox) -> tuple[ErrorMessage | None, int]:
        """Predict; events before the last one are dropped, the rest of the frame is kept.

        Returns what to say of the dropped ones, and how many they are. Raises ProtocolError, nothing changed,
        where a number cannot be used.
        """
        error, kept, count = None, table, len(table)
        predictions = self.pipeline.advance_all(NOWHERE[:count], table)
        if predictions is None:  # the pipeline knows that something is wrong, the protocol says where
            check_numbers(table)
            error, kept = self._without_late(table)
            predictions = run(self.pipeline, EventColumns(kept)).table
        if len(kept):
            self._keep(kept, predictions)
            self._answer(kept, predictions, outbox)
        return error, count - len(kept)

    def _answer(self, kept: FloatArray, predictions: FloatArray, outbox: Outbox) -> None:
        """Say the predictions, with targets after what they change; many targets are looked at later."""
        choices = self.choices
        told = partial(self._frames, predictions)
        if choices is None:
            outbox.predict(*told())
            return
        look = partial(choices.take, kept, predictions, each=self.hello.reply == "event")

        def say(taken: Taken) -> None:
            choices.say(taken.changes)
            outbox.predict(*told(taken.likely))

        def work() -> Callable[[], None]:
            return partial(say, look())

        if choices.heavy(len(kept)):
            self.work = work
        else:
            say(look())

    def _frames(
        self, predictions: FloatArray, likely: list[list[Likely]] | None = None
    ) -> tuple[list[Frame], int]:
        each = self.hello.reply == "event"
        return prediction_frames(predictions, binary=self._binary, each=each, likely=likely)

    def feed_one(self, row: Sequence[float], outbox: Outbox) -> bool:
        """``feed`` for the one event of most frames, without a table: the same steps, the same answer.

        False, and nothing changed, where the event is refused, somebody keeps it or there are targets: then
        it is for ``feed``.
        """
        if self.watch or self._trial.running or self.choices:
            return False
        prediction = self.pipeline.advance(tuple(row))
        if prediction is None:
            return False
        self.events += 1
        self._last_t = row[0]
        outbox.predict([self._frame(prediction)], 1)
        return True

    def configure(self, message: Configure) -> None:
        """Another predictor or other parameters begin without memory; raises ProtocolError, nothing changed.

        Parameters add to those said before, but another predictor begins with its own. What is known of the
        person stays while the predictor has the same name and learns. A running trial goes on, and is scored
        with the predictor it ends with.
        """
        self._check_assist(message)
        another = message.predictor is not None
        known = {} if another else self.hello.parameters
        hello = structs.replace(
            self.hello,
            predictor=self.hello.predictor if message.predictor is None else message.predictor,
            parameters={**known, **message.parameters},
            reply=message.reply or self.hello.reply,
            assist=message.assist or self.hello.assist,
        )
        if another or message.parameters:
            pipeline = self._build(hello)
            if pipeline.name == self.pipeline.name and portable(pipeline.predictor):
                restore(pipeline.predictor, self.pipeline.person)
            self.pipeline = pipeline
            self._forget()
        self.hello = hello
        if message.precision is not None:
            self.precision = message.precision
            if self.choices:
                self.choices.configure(message.precision)
        if self.watch:
            self.watch.configure(hello)

    def take_targets(self, targets: list[Target], outbox: Outbox) -> None:
        """Replace the set of targets; raises ProtocolError, nothing changed."""
        choices = self.choices or Choices(outbox, self.precision)
        choices.replace(targets)
        self.choices = choices if targets else None

    def reset(self) -> None:
        """Forget every event: the next one starts a movement."""
        self.pipeline.reset()
        self._forget()

    def person(self, known: str | None) -> str:
        """What is known of the person; of ``known``, where it is given, the session begins anew knowing that.

        Raises ProtocolError for what the predictor cannot take, nothing changed.
        """
        if known is not None:
            self.pipeline = self._build(structs.replace(self.hello, person=known))
            self._forget()
        return self.pipeline.person

    def start_trial(self, goal: Goal | None) -> None:
        """A movement starts at the next event; its events are kept until the trial ends."""
        self._trial.start(goal)
        self.reset()
        if self.watch:
            self.watch.trial("start", goal)

    def end_trial(self, goal: Goal | None) -> Scoring:
        """What makes the score of the trial; raises ProtocolError where none was started."""
        if not self._trial.running:
            words = "expected 'trial' with action 'start' before 'end'"
            raise ProtocolError("out_of_place", words, "$.action")
        if self.watch:
            self.watch.trial("end", goal)
        account = self.choices.account(goal or self._trial.goal) if self.choices else {}
        scoring = self._trial.end(goal, self.pipeline, cpi_of(self.hello), dpi_of(self.hello))
        return partial(with_account, scoring, account) if account else scoring

    def _check_assist(self, message: Configure) -> None:
        if message.assist is not None:
            words = "expected assistance to be asked for in 'hello'; it may be changed afterwards"
            raise ProtocolError("out_of_place", words, "$.assist")

    def _forget(self) -> None:
        self._last_t = NEVER
        if self.choices:
            self.choices.reset()

    def _keep(self, table: FloatArray, predictions: FloatArray) -> None:
        self.events += len(table)
        self._last_t = float(table[-1, 0])
        self._trial.add(table)
        if self.watch:
            self.watch.events(EventColumns(table), PredictionColumns(predictions))

    def _without_late(self, table: FloatArray) -> tuple[ErrorMessage | None, FloatArray]:
        """The events that do not run backwards, and what to say of the others."""
        t = table[:, 0]
        before = np.maximum.accumulate(np.concatenate([[self._last_t], t[:-1]]))
        late = t < before
        if not late.any():
            return None, table
        row, more = int(late.argmax()), int(late.sum()) - 1
        also = f" ({more} more in this frame)" if more else ""
        said = f"t must not run backwards: {float(t[row])!r} s after {float(before[row])!r} s; dropped{also}"
        return ErrorMessage("out_of_order", said, f"$.events[{row}][0]"), table[~late]
