"""The predicting side of a session: tables of events in, frames of predictions out."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from copy import copy
from functools import partial
from pathlib import Path
from typing import Protocol

import numpy as np
from msgspec import structs

from pointpred.errors import EventError
from pointpred.person import person_of, portable, restore
from pointpred.pipeline import Pipeline
from pointpred.protocol.client_messages import (
    Conditions,
    Configure,
    Enter,
    Goal,
    Hello,
    Rectangle,
    cpi_of,
    dpi_of,
)
from pointpred.protocol.decoding import check_numbers
from pointpred.protocol.errors import ProtocolError
from pointpred.protocol.frames import Likeliest, prediction_frames, row_encoder
from pointpred.protocol.server_messages import ErrorMessage, Score
from pointpred.records import EventColumns, FloatArray, PredictionColumns, Row, refusal
from pointpred_server.sessions.assistance import Assistance
from pointpred_server.sessions.outbox import Outbox
from pointpred_server.sessions.pipelines import NO_COEFFICIENTS, pipeline_of
from pointpred_server.sessions.place_tracker import PlaceTracker
from pointpred_server.sessions.target_tracker import TargetTracker
from pointpred_server.sessions.trials import TrialBuffer

EARLIEST_T = float("-inf")


class SessionObserver(Protocol):
    """Follows the events of a session, as a recorder does; no method may raise."""

    def configure(self, hello: Hello) -> None:
        """The predictor and its parameters from now on."""

    def events(self, table: EventColumns, predictions: PredictionColumns) -> None:
        """The events that the pipeline took in, and the prediction after each."""

    def trial(self, action: str, target: Goal | None = None, conditions: Conditions | None = None) -> None:
        """A trial starts, or ends: then with all that it was."""

    def close(self) -> None:
        """The session has ended."""


class PredictionStream:
    """A pipeline as a client asked for it, the targets it decides among, and the trial that is marked."""

    def __init__(
        self, hello: Hello, outbox: Outbox, coefficients: Mapping[str, Path] = NO_COEFFICIENTS
    ) -> None:
        """Raises ProtocolError for an unknown predictor, a wrong parameter or an unusable person.

        ``coefficients``: the files that the client may ask for by name.
        """
        self._build = partial(pipeline_of, coefficients=coefficients)
        self.pipeline = self._build(hello)
        self.hello = structs.replace(hello, person="")  # the pipeline knows it, and learns on
        self.observer: SessionObserver | None = None
        self.precision: float | None = None
        """The share of proposals that shall be right, where the client has chosen it."""
        self.tracker: TargetTracker | None = None
        """Decides among the targets, where there are any."""
        self.place_tracker: PlaceTracker | None = None
        """Decides among the person's places, where the client asked for that and events came."""
        self.assistance = None if hello.assist is None else Assistance(hello, hello.assist)
        self.targets = 0
        """How many are registered."""
        self.events = 0
        """Events taken in."""
        self._outbox = outbox
        self._aimed = False
        self._window: Enter | None = None
        self._last_t = EARLIEST_T
        self._trial = TrialBuffer()
        self._answer_as(self.hello)

    def _answer_as(self, hello: Hello) -> None:
        """Answer as a hello asks from now on."""
        self.hello = hello
        self._encode = row_encoder(binary=hello.encoding == "binary", version=hello.version)
        self._all_wanted = hello.reply == "event" or hello.places or self.assistance is not None

    def push(self, rows: Sequence[Row]) -> tuple[ErrorMessage | None, int]:
        """Predict from rows of events, and answer; those before the last one are dropped, the rest is used.

        Returns the error for those that were dropped, and how many they are. Raises ProtocolError or
        EventError, nothing changed, where a number cannot be used.
        """
        if not rows:
            return None, 0
        if not self._watched:
            try:
                self._take_in(rows)
            except EventError:  # the pipeline finds that something is wrong, the protocol says where
                pass
            else:
                return None, 0
        table = np.array(rows)
        (self.assistance.check if self.assistance else check_numbers)(table)
        error, used = self._in_order(table)
        if len(used):
            self._take_in([tuple(row) for row in used.tolist()])
        return error, len(table) - len(used)

    @property
    def _watched(self) -> bool:
        """Whether something is to be done after each event: a cursor assisted, a target or place chosen."""
        return self.assistance is not None or self.tracker is not None or self.hello.places

    def _take_in(self, rows: Sequence[Row]) -> None:
        """Predict from events in order, and answer.

        Raises EventError, nothing changed, where something is wrong; ``push`` has looked where much is done.
        """
        if not (self._all_wanted or self.observer or self.tracker or self._trial.running):  # most frames
            if len(rows) == 1:
                answer = self.pipeline.advance(rows[0])
                if answer[0] != answer[0]:
                    raise refusal(rows[0], answer)
            else:
                answer = self.pipeline.push(np.array(rows), want="last")
            self.events += len(rows)
            self._last_t = rows[-1][0]
            self._outbox.predict([self._encode(answer)], 1)
            return
        table, aims = np.array(rows), None
        if self._watched:
            table, predictions, aims = self._follow(table)
        else:
            predictions = self.pipeline.push(table)
        self.events += len(rows)
        self._last_t = rows[-1][0]
        if self._trial.running:
            self._trial.add(table)
        if self.observer:
            self.observer.events(EventColumns(table), PredictionColumns(predictions))
        each = self.hello.reply == "event"
        frames, count = prediction_frames(
            predictions,
            binary=self.hello.encoding == "binary",
            each=each,
            version=self.hello.version,
            aims=aims if each or aims is None else aims[-1:],
        )
        if self.assistance:  # the cursor goes first, as text in either encoding
            frames = [self.assistance.cursor(self._last_t), *frames]
        self._outbox.predict(frames, count)

    def _follow(self, table: FloatArray) -> tuple[FloatArray, FloatArray, list[Likeliest] | None]:
        """The events as assistance moved the cursor, their predictions, what the targets make of each."""
        assistance, pipeline, tracker = self.assistance, self.pipeline, self.tracker
        if tracker is None and self.hello.places and self.place_tracker is None:
            self.place_tracker, self._aimed = PlaceTracker(self._outbox, pipeline, self.precision), True
        events, predictions, aims = table.copy(), np.empty((len(table), 10)), []
        before = (copy(pipeline), assistance.remembered()) if assistance else None
        try:
            for i, row in enumerate(table.tolist()):
                moved = assistance.move(row) if assistance else tuple(row)
                answer = pipeline.advance(moved)
                if answer[0] != answer[0]:
                    raise refusal(moved, answer)
                events[i], predictions[i] = moved, answer
                if assistance:
                    assistance.guide(answer)
                if tracker:
                    aims.append(tracker.follow())
                elif self.place_tracker:
                    self.place_tracker.follow()
            before = None
        finally:
            if before and assistance:
                self._use(before[0])
                assistance.recall(before[1])
        return events, predictions, aims if tracker else None

    def configure(self, message: Configure) -> None:
        """Another predictor or other parameters begin without memory; raises ProtocolError, nothing changed.

        Parameters add to those chosen before, but another predictor begins with its own. What is known of
        the person stays while the predictor has the same name and learns. A running trial goes on, and is
        scored with the predictor it ends with.
        """
        if message.assist is not None and self.assistance is None:
            sentence = "expected assistance to be asked for in 'hello'; it may be changed afterwards"
            raise ProtocolError("out_of_place", sentence, "$.assist")
        another = message.predictor is not None
        parameters = {} if another else self.hello.parameters
        hello = structs.replace(
            self.hello,
            predictor=self.hello.predictor if message.predictor is None else message.predictor,
            parameters={**parameters, **message.parameters},
            reply=message.reply or self.hello.reply,
            assist=message.assist or self.hello.assist,
            places=self.hello.places if message.places is None else message.places,
        )
        if another or message.parameters:
            pipeline = self._in_window(self._build(hello))
            if pipeline.name == self.pipeline.name and portable(pipeline.predictor):
                restore(pipeline.predictor, person_of(self.pipeline.predictor))
            if self._aimed:
                restore(pipeline.aim, person_of(self.pipeline.aim))
                pipeline.register(self.tracker.targets if self.tracker else ())
            self._go_on_with(pipeline)
        if message.assist is not None and self.assistance is not None:
            before, self.assistance = self.assistance, Assistance(hello, message.assist)
            self.assistance.follow(before)
        self._answer_as(hello)
        if not hello.places:
            self._leave_places()
        if message.precision is not None:
            self.precision = message.precision
            if self.tracker:
                self.tracker.configure(message.precision)
            if self.place_tracker:
                self.place_tracker.configure(message.precision)
        if self.observer:
            self.observer.configure(hello)

    def _leave_places(self) -> None:
        if self.place_tracker:
            self.place_tracker.reset()
            self.place_tracker = None

    def replace_targets(self, targets: list[Rectangle]) -> None:
        """Replace the set of targets; raises ProtocolError, nothing changed."""
        tracker = self.tracker or TargetTracker(self._outbox, self.pipeline, self.precision)
        tracker.replace(targets)
        self.tracker, self._aimed = tracker if targets else None, True
        if self.place_tracker:
            self.place_tracker.reset()
        self.targets = len(targets)

    def reset(self) -> None:
        """Forget every event: the next one starts a movement."""
        self.pipeline.reset()
        self._forget()

    def person(self, replacement: str | None) -> str:
        """What is known of the person; with a ``replacement`` the session begins anew, knowing that.

        Raises ProtocolError for what the predictor cannot use, nothing changed.
        """
        if replacement is not None:
            pipeline = self._in_window(self._build(structs.replace(self.hello, person=replacement)))
            if self.tracker:
                pipeline.register(self.tracker.targets)
            self._go_on_with(pipeline)
        return self.pipeline.person

    def _go_on_with(self, pipeline: Pipeline) -> None:
        """Another pipeline begins without a movement."""
        pipeline.reset()
        self._use(pipeline)
        self._forget()

    def _use(self, pipeline: Pipeline) -> None:
        self.pipeline = pipeline
        for tracker in (self.tracker, self.place_tracker):
            if tracker:
                tracker.pipeline = pipeline

    def enter(self, window: Enter) -> None:
        """The next movement is in this window."""
        self._window = window
        self._in_window(self.pipeline)

    def forget(self) -> str:
        """Forget the person and the movement; returns what is then known of the person: ""."""
        self.pipeline.forget()
        self._in_window(self.pipeline)
        self._forget()
        return self.pipeline.person

    def _in_window(self, pipeline: Pipeline) -> Pipeline:
        """The pipeline, in the window that the client named last."""
        if self._window is not None:
            pipeline.enter(self._window.key, self._window.x, self._window.y)
        return pipeline

    def start_trial(self, goal: Goal | None, conditions: Conditions) -> None:
        """A movement starts at the next event; its events are kept until the trial ends.

        Raises ProtocolError for a condition that has no column in the session's trials.
        """
        self._trial.start(goal, conditions)
        self.reset()
        if self.observer:
            self.observer.trial("start", goal)

    def end_trial(self, goal: Goal | None, conditions: Conditions) -> Callable[[], Score]:
        """What scores the trial, in any thread; raises ProtocolError where none runs, or for a condition."""
        if not self._trial.running:
            sentence = "expected 'trial' with action 'start' before 'end'"
            raise ProtocolError("out_of_place", sentence, "$.action")
        known = self._trial.described(conditions)
        if self.observer:
            self.observer.trial("end", goal, known)
        outcome = self.tracker.finish_trial(goal or self._trial.goal) if self.tracker else None
        return self._trial.end(goal, self.pipeline, cpi_of(self.hello), dpi_of(self.hello), outcome)

    def _forget(self) -> None:
        self._last_t = EARLIEST_T
        if self.assistance:
            self.assistance.reset()
        if self.tracker:
            self.tracker.reset()
        if self.place_tracker:
            self.place_tracker.reset()

    def _in_order(self, table: FloatArray) -> tuple[ErrorMessage | None, FloatArray]:
        """The error for the events that run backwards, and the events that do not."""
        t = table[:, 0]
        before = np.maximum.accumulate(np.concatenate([[self._last_t], t[:-1]]))
        late = t < before
        if not late.any():
            return None, table
        row, more = int(late.argmax()), int(late.sum()) - 1
        also = f" ({more} more in this frame)" if more else ""
        time = float(t[row])
        sentence = f"t must not run backwards: {time!r} s after {float(before[row])!r} s; dropped{also}"
        error = ErrorMessage("out_of_order", sentence, f"$.events[{row}][0]", field="t", value=time)
        return error, table[~late]
