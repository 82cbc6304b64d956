"""The predicting side of a session: events in, frames of predictions out."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path

import numpy as np
from msgspec import structs

from pointpred.errors import EventError
from pointpred.person import portable, restore
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
from pointpred.protocol.frames import Aim, Frame, prediction_frames, row_encoder
from pointpred.protocol.server_messages import ErrorMessage
from pointpred.records import EventColumns, FloatArray, Place, PredictionColumns
from pointpred_server.sessions.costs import REFUSED_BYTE_S, REFUSED_S, Costs, costs_of, memory_of
from pointpred_server.sessions.observer import SessionObserver
from pointpred_server.sessions.outbox import Outbox
from pointpred_server.sessions.pipelines import NO_COEFFICIENTS, pipeline_of
from pointpred_server.sessions.place_tracker import PlaceTracker
from pointpred_server.sessions.target_tracker import TargetTracker
from pointpred_server.sessions.trials import Scoring, TrialBuffer, with_outcome
from pointpred_server.sessions.work import Slices, result_of

NEVER = float("-inf")


Finish = Callable[[], tuple[ErrorMessage | None, int]]
"""Sends the answers to a frame; returns the error for events that were dropped, and how many they are."""


class PredictionStream:
    """A pipeline as a client asked for it, the targets it decides among, and the trial that is marked."""

    def __init__(
        self,
        hello: Hello,
        observer: SessionObserver | None = None,
        coefficients: Mapping[str, Path] = NO_COEFFICIENTS,
    ) -> None:
        """Raises ProtocolError for an unknown predictor, a wrong parameter or an unusable person.

        ``coefficients``: the files that the client may ask for by name.
        """
        self._build = partial(pipeline_of, coefficients=coefficients)
        self.pipeline = self._build(hello)
        self.hello = structs.replace(hello, person="")  # the pipeline knows it, and learns on
        self.precision: float | None = None
        """The share of proposals that shall be right, where the client has chosen it."""
        self.tracker: TargetTracker | None = None
        """Decides among the targets, where there are any."""
        self.place_tracker: PlaceTracker | None = None
        """Decides among the person's places, where the client asked for that and events came."""
        self._window: Enter | None = None
        self.events = 0
        """Events taken in."""
        self.observer = observer
        self.costs = Costs(0.0, 0.0, 0.0)
        """What frames of events cost, with the settings in force."""
        self._binary = hello.encoding == "binary"
        self._encode_row = row_encoder(binary=self._binary, version=hello.version)
        self._last_t = NEVER
        self._trial = TrialBuffer()
        self._targets = 0
        self._weigh()

    def take_in(self, table: FloatArray, outbox: Outbox) -> Slices[Finish]:
        """Predict; events before the last one are dropped, the rest of the frame is used.

        Any thread may run each slice, while nothing else is asked of the stream; what comes of them is to be
        called in the session's own. Raises ProtocolError, nothing changed, where a number cannot be used.
        """
        if (finish := self.take_in_last(table, outbox)) is not None:
            return finish
        before = self._memories_for_places()
        if (predictions := self._predict_whole(table)) is not None:
            return (yield from self._decide(table, None, table, predictions, outbox, before))
        # The pipeline finds that something is wrong, the protocol says where.
        check_numbers(table)
        error, used = self._in_order(table)
        predictions = self.pipeline.push(used)
        return (yield from self._decide(table, error, used, predictions, outbox, before))

    def take_in_whole(self, table: FloatArray, outbox: Outbox) -> Finish | None:
        """``take_in`` where nothing is wrong with any event; otherwise ``None``, and nothing has changed."""
        if (finish := self.take_in_last(table, outbox)) is not None:
            return finish
        before = self._memories_for_places()
        if (predictions := self._predict_whole(table)) is None:
            return None
        return result_of(self._decide(table, None, table, predictions, outbox, before))

    def take_in_last(self, table: FloatArray, outbox: Outbox) -> Finish | None:
        """``take_in_whole`` where nothing but the newest event's prediction is wanted."""
        if (last := self._last_prediction(table)) is None:
            return None
        return partial(self._send_last, table, last, outbox)

    def _predict_whole(self, table: FloatArray) -> FloatArray | None:
        """Every prediction; ``None``, and nothing changed, where an event is refused or there is none."""
        if not len(table):
            return None
        try:
            return self.pipeline.push(table)
        except EventError:
            return None

    def _decide(
        self,
        table: FloatArray,
        error: ErrorMessage | None,
        used: FloatArray,
        predictions: FloatArray,
        outbox: Outbox,
        before: tuple[bytes, ...],
    ) -> Slices[Finish]:
        """Decide after the events that were used, in any thread.

        ``before``: the pipeline's memories before the events, where the client asked for places.
        """
        if not len(used):
            return lambda: (error, len(table))
        answer = yield from self._answer(used, predictions, outbox, before)

        def finish() -> tuple[ErrorMessage | None, int]:
            self._record(used, predictions)
            answer()
            return error, len(table) - len(used)

        return finish

    def _memories_for_places(self) -> tuple[bytes, ...]:
        """What ``_places_after`` needs of the pipeline before the events; nothing without places."""
        if not self.hello.places:
            return ()
        return tuple(one.remembered() for one in (self.pipeline.differentiator, self.pipeline.predictor))

    def _places_after(self, table: FloatArray, before: tuple[bytes, ...]) -> Slices[list[tuple[Place, ...]]]:
        """Take in events again that are known to be good, one by one, for the places after each."""
        for stage, memory in zip(
            (self.pipeline.differentiator, self.pipeline.predictor), before, strict=True
        ):
            stage.recall(memory)
        seen = []
        for part in self.costs.slices_of(len(table)):
            if part.start:
                yield
            for row in table[part].tolist():
                self.pipeline.advance(tuple(row))
                seen.append(self.pipeline.places)
        return seen

    def feed_event(self, row: tuple[float, ...], outbox: Outbox) -> bool:
        """``take_in`` of the one event of most frames, without a table: the same steps, the same answer.

        False, and nothing changed, where the event is refused, somebody observes, a trial runs, there are
        targets or places are asked for: then ``take_in`` has to be called.
        """
        if self._trial.running or self._needs_every_prediction:
            return False
        prediction = self.pipeline.advance(row)
        if prediction[0] != prediction[0]:
            return False
        self.events += 1
        self._last_t = row[0]
        outbox.predict([self._encode_row(prediction)], 1)
        return True

    def _last_prediction(self, table: FloatArray) -> tuple[float, ...] | None:
        """The newest event's prediction where nothing but that is wanted.

        ``None``, and nothing changed, where there is no event, one is refused, or every prediction is needed.
        """
        if not len(table) or self.hello.reply == "event" or self._needs_every_prediction:
            return None
        try:
            return tuple(self.pipeline.push(table, want="last")[0].tolist())
        except EventError:
            return None

    def _send_last(
        self, table: FloatArray, prediction: tuple[float, ...], outbox: Outbox
    ) -> tuple[ErrorMessage | None, int]:
        self._note(table)
        outbox.predict([self._encode_row(prediction)], 1)
        return None, 0

    @property
    def _needs_every_prediction(self) -> bool:
        """Whether somebody reads the predictions of all events, whatever the client is sent."""
        return bool(self.observer or self.tracker or self.hello.places)

    def _answer(
        self, events: FloatArray, predictions: FloatArray, outbox: Outbox, before: tuple[bytes, ...]
    ) -> Slices[Callable[[], None]]:
        """What puts the predictions into the outbox, after their choices."""
        parts, aims = self.costs.slices_of(len(events)), None
        announce: Callable[[], None] | None = None
        seen = (yield from self._places_after(events, before)) if self.hello.places else None
        if self.tracker is not None:
            each = self.hello.reply == "event"
            changes = yield from self.tracker.follow(events, predictions, parts, seen, each=each)
            announce, aims = partial(self.tracker.announce, changes.choices), changes.aims
        elif seen is not None:
            tracker = self.place_tracker = self.place_tracker or PlaceTracker(outbox, self.precision)
            choices = yield from tracker.follow(events, predictions, parts, seen)
            announce = partial(tracker.announce, choices)
        frames = self._frames(predictions, aims)

        def send() -> None:
            if announce is not None:
                announce()
            outbox.predict(*frames)

        return send

    def _frames(self, predictions: FloatArray, aims: list[Aim] | None = None) -> tuple[list[Frame], int]:
        each, version = self.hello.reply == "event", self.hello.version
        return prediction_frames(predictions, binary=self._binary, each=each, version=version, aims=aims)

    def configure(self, message: Configure) -> None:
        """Another predictor or other parameters begin without memory; raises ProtocolError, nothing changed.

        Parameters add to those chosen before, but another predictor begins with its own. What is known of
        the person stays while the predictor has the same name and learns. A running trial goes on, and is
        scored with the predictor it ends with.
        """
        self._check_assist(message)
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
                restore(pipeline.predictor, self.pipeline.person)
            self.pipeline = pipeline
            self._forget()
        self.hello = hello
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
        self._weigh()

    def _leave_places(self) -> None:
        if self.place_tracker:
            self.place_tracker.reset()
            self.place_tracker = None
        if self.tracker:
            self.tracker.expect(())

    def replace_targets(self, targets: list[Rectangle], outbox: Outbox) -> None:
        """Replace the set of targets; raises ProtocolError, nothing changed."""
        tracker = self.tracker or TargetTracker(outbox, self.precision)
        tracker.replace(targets)
        self.tracker = tracker if targets else None
        if self.place_tracker:
            self.place_tracker.reset()
        self._targets = len(targets)
        self._weigh()

    def _weigh(self) -> None:
        """Note what frames cost from now on."""
        hello = self.hello
        self.costs = costs_of(
            self.pipeline,
            targets=self._targets,
            places=hello.places,
            assisted=hello.assist is not None,
            each=hello.reply == "event",
        )

    @property
    def refusal_s(self) -> float:
        """What looking for the reason costs when events are refused, s."""
        return REFUSED_S + REFUSED_BYTE_S * memory_of(self.pipeline)

    def reset(self) -> None:
        """Forget every event: the next one starts a movement."""
        self.pipeline.reset()
        self._forget()

    def person(self, replacement: str | None) -> str:
        """What is known of the person; with a ``replacement`` the session begins anew, knowing that.

        Raises ProtocolError for what the predictor cannot use, nothing changed.
        """
        if replacement is not None:
            self.pipeline = self._in_window(self._build(structs.replace(self.hello, person=replacement)))
            self._forget()
        return self.pipeline.person

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

    @property
    def trial_events(self) -> int:
        """Events of the trial that runs."""
        return self._trial.count

    def start_trial(self, goal: Goal | None, conditions: Conditions) -> None:
        """A movement starts at the next event; its events are kept until the trial ends.

        Raises ProtocolError for a condition that has no column in the session's trials.
        """
        self._trial.start(goal, conditions)
        self.reset()
        if self.observer:
            self.observer.trial("start", goal)

    def end_trial(self, goal: Goal | None, conditions: Conditions) -> Scoring:
        """The function that scores the trial; raises ProtocolError where none runs, or for a condition."""
        if not self._trial.running:
            sentence = "expected 'trial' with action 'start' before 'end'"
            raise ProtocolError("out_of_place", sentence, "$.action")
        known = self._trial.described(conditions)
        if self.observer:
            self.observer.trial("end", goal, known)
        outcome = self.tracker.finish_trial(goal or self._trial.goal) if self.tracker else None
        scoring = self._trial.end(goal, self.pipeline, cpi_of(self.hello), dpi_of(self.hello))
        return scoring if outcome is None else partial(with_outcome, scoring, outcome)

    def _check_assist(self, message: Configure) -> None:
        if message.assist is not None:
            sentence = "expected assistance to be asked for in 'hello'; it may be changed afterwards"
            raise ProtocolError("out_of_place", sentence, "$.assist")

    def _forget(self) -> None:
        self._last_t = NEVER
        if self.tracker:
            self.tracker.reset()
        if self.place_tracker:
            self.place_tracker.reset()

    def _record(self, table: FloatArray, predictions: FloatArray) -> None:
        """Note events that were used, and give them to the observer."""
        self._note(table)
        if self.observer:
            self.observer.events(EventColumns(table), PredictionColumns(predictions))

    def _note(self, table: FloatArray) -> None:
        """Note events that were used: how many, the time of the last, for the trial."""
        self.events += len(table)
        self._last_t = float(table[-1, 0])
        self._trial.add(table)

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
