"""One pointing session without a socket: frames in, frames out, and when to close."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from pointpred.errors import EventError
from pointpred.person import portable
from pointpred.protocol.client_messages import (
    VERSIONS,
    Bye,
    ClientMessage,
    Configure,
    Enter,
    Events,
    Forget,
    Hello,
    Person,
    Reset,
    Targets,
    TrialMark,
)
from pointpred.protocol.decoding import decode_client_message, decode_event, table_of_bytes, table_of_rows
from pointpred.protocol.errors import ProtocolError
from pointpred.protocol.frames import EVENT, unpack_events
from pointpred.protocol.server_messages import (
    KnownPerson,
    Limits,
    ServerMessage,
    TargetsTaken,
    Welcome,
)
from pointpred.records import FloatArray, SixFloats
from pointpred_server.sessions.assisted_stream import open_stream
from pointpred_server.sessions.costs import AT_ONCE_S, BUILD_S, PERSON_S, TARGET_S, TRIAL_EVENT_S, TRIAL_S
from pointpred_server.sessions.lifecycle import (
    TRANSITIONS,
    TRIGGERS,
    Session,
    State,
    Trigger,
    bad_event,
)
from pointpred_server.sessions.observer import SessionObserver
from pointpred_server.sessions.pipelines import NO_COEFFICIENTS
from pointpred_server.sessions.prediction_stream import Finish, PredictionStream
from pointpred_server.sessions.trials import Scoring
from pointpred_server.sessions.work import Completion, Slices, Work, result_of

RECORD_BYTES = EVENT.itemsize
CLOSED, STREAMING, MESSAGE = State.CLOSED, State.STREAMING, Trigger.MESSAGE
Handler = Callable[[Any, Any, float], ServerMessage | None]


class PointingSession(Session):
    """The server's side of one connection to ``/v1/stream``.

    ``observe`` makes, at the client's hello, an observer of the session's events, such as a recorder.
    ``coefficients``: the files that the client may ask for by name.
    """

    def __init__(
        self,
        name: str,
        limits: Limits,
        now: float,
        observe: Callable[[str, Hello], SessionObserver | None] | None = None,
        coefficients: Mapping[str, Path] = NO_COEFFICIENTS,
    ) -> None:
        super().__init__(name, limits, now)
        self.stream: PredictionStream | None = None
        self._observe = observe
        self._coefficients = coefficients
        self._targets = 0  # how many are registered
        self._apart = 0  # of so many frames it is known that they cannot all be joined

    @property
    def events(self) -> int:
        """How many events the session has taken in."""
        return self.stream.events if self.stream else 0

    def receive(self, frame: str | bytes, now: float) -> None:
        """Take in one frame, as ``Session.receive``; what is left to do for the frame before comes first."""
        if self.work is not None:
            self.finish(self.work())
        stream = self.stream
        if stream is not None and self.state is not CLOSED:
            if now > self.last_received:  # a frame that was kept waiting came before
                self.last_received = now
            # Most frames of a fast device, and cheap: one event with nothing wrong about it.
            row = decode_event(frame)
            if row is not None and self._receive_event(stream, row, now):
                return
        Session.receive(self, frame, now)  # super() would cost as much as decoding the frame

    def receive_together(self, frames: Sequence[str | bytes], now: float) -> int:
        """Take in frames of events that have waited as one table: every event is used, the newest answered.

        Only where nothing is wrong with any of them, and each ends later than the one before: the client
        then knows which frames an answer is for.
        """
        if self._apart:
            self._apart -= 1
        elif len(tables := self._joinable(frames, now)) > 1:
            if self._feed_whole(np.concatenate(tables), now):
                return len(tables)
            self._apart = len(tables) - 1
        self.receive(frames[0], now)
        return 1

    def _joinable(self, frames: Sequence[str | bytes], now: float) -> list[FloatArray]:
        """The events of the first of some frames, as far as one table of them is allowed and cheap."""
        tables: list[FloatArray] = []
        events, ended = 0, float("-inf")
        for frame in frames:
            table = self._usable_table(frame, now)
            if table is None or not ended < table[-1, 0]:
                break
            events, ended = events + len(table), float(table[-1, 0])
            costly = self._open_stream.costs.of(events) > AT_ONCE_S
            if costly or events > self.limits.max_events_per_frame:
                break
            tables.append(table)
        return tables

    def _usable_table(self, frame: str | bytes, now: float) -> FloatArray | None:
        """The events of a frame of an allowed size; ``None`` for everything else.

        A text that is not used is decoded again in its turn, and pays for both.
        """
        if self.stream is None or not frame or len(frame) > self.limits.max_frame_bytes:
            return None
        if isinstance(frame, bytes):
            return None if len(frame) % RECORD_BYTES else unpack_events(frame)
        try:
            self._quota.check_size(frame)
            self._quota.take_text(frame, now)
            message = decode_client_message(frame)
        except ProtocolError:
            return None
        return table_of_rows(message.events) if isinstance(message, Events) and message.events else None

    def _feed_whole(self, table: FloatArray, now: float) -> bool:
        """Predict from several frames as one; False, and nothing taken, where one would be refused."""
        stream = self.stream
        if stream is None or self.state is CLOSED or self.work is not None:
            return False
        cost_s = stream.costs.of(len(table))
        if not self._quota.allow(len(table), cost_s, now):
            return False
        finish = stream.take_in_whole(table, self.outbox)
        if finish is None:
            self._quota.give_back(len(table), cost_s)
            return False
        self.last_received = max(now, self.last_received)
        self._send_answers(finish, len(table), stream.refusal_s, now)
        return True

    def _receive_event(self, stream: PredictionStream, row: SixFloats, now: float) -> bool:
        """Predict from one event; False, and nothing taken, where there is more to do for it."""
        rate, costs = self._quota.events, self._quota.costs
        if not rate.take(1, now):
            return False
        costs.left -= stream.costs.single_s  # by hand, and refilled where it has to be: most frames come here
        if costs.left < 0.0 and not costs.take(0.0, now):
            self._give_back(stream)
            return False
        try:
            used = stream.feed_event(row, self.outbox)
        except EventError as error:
            self.refuse(bad_event(error))
            self.check_unread()
            return True
        if not used:
            self._give_back(stream)
            return False
        if self.state is not STREAMING:
            self.move(Trigger.EVENTS)
        return True

    def _give_back(self, stream: PredictionStream) -> None:
        """Put back what was taken for one event that was not used."""
        self._quota.events.give_back(1)
        self._quota.costs.give_back(stream.costs.single_s)

    def _receive(self, frame: str | bytes, now: float) -> None:
        if isinstance(frame, bytes):
            self._receive_table(frame, now)
            return
        self._quota.take_text(frame, now)
        try:
            message = decode_client_message(frame)
        except ProtocolError:
            self._quota.take_invalid(frame, now)
            raise
        kind = type(message)
        if isinstance(message, Events) and self.stream is not None:  # most messages
            self.handle_events(message, now)
            return
        in_place = TRIGGERS.get(kind, MESSAGE) in TRANSITIONS[self.state]
        if kind is not Bye:
            self._quota.take_message(now)
        if not in_place:
            if kind is Hello:
                raise ProtocolError("out_of_place", f"expected 'hello' once, the session is {self.state}")
            raise _no_hello(repr(message.__struct_config__.tag))
        reply = self.handlers[kind](self, message, now)
        if reply is not None:
            self.send(reply)

    def _receive_table(self, frame: bytes, now: float) -> None:
        """Predict from packed events."""
        self._quota.take_events(len(frame) // RECORD_BYTES, now)
        if self.stream is None:
            raise _no_hello("a binary frame")
        self._feed(self.stream, table_of_bytes(frame), now)

    @property
    def _open_stream(self) -> PredictionStream:
        """The stream, which every state but the first has."""
        assert self.stream is not None
        return self.stream

    def handle_hello(self, message: Hello, now: float) -> Welcome:
        """Open the stream that the client asks for."""
        if message.version not in VERSIONS:
            sentence = f"version must be {' or '.join(map(str, VERSIONS))}, received {message.version}"
            raise ProtocolError("bad_field", sentence, "$.version")
        self._quota.spend(PERSON_S if message.person else BUILD_S, now)
        stream = open_stream(message, self._coefficients)
        stream.observer = self._observe(self.name, message) if self._observe else None
        self.stream = stream
        self._weigh_events()
        self.move(Trigger.HELLO)
        self.last_received = max(now, self.last_received)
        return self._welcome()

    def handle_events(self, message: Events, now: float) -> None:
        """Predict from events in JSON."""
        self._quota.take_events(len(message.events), now)
        self._feed(self._open_stream, table_of_rows(message.events), now)

    def handle_targets(self, message: Targets, now: float) -> TargetsTaken:
        """Replace the set of targets."""
        self._quota.spend(TARGET_S * len(message.targets), now)
        self._quota.check_targets(message.targets)
        self._open_stream.replace_targets(message.targets, self.outbox)
        self._targets = len(message.targets)
        self._weigh_events()
        return TargetsTaken(len(message.targets))

    def handle_trial(self, message: TrialMark, now: float) -> None:
        """Start a trial, or end it: its score is sent once the work is done."""
        stream = self._open_stream
        if message.action == "start":
            stream.start_trial(message.target, message.conditions)
            return
        self._quota.spend(TRIAL_S + TRIAL_EVENT_S * stream.trial_events, now)
        scoring = stream.end_trial(message.target, message.conditions)
        self.work = Work(self._score(scoring), divided=False)

    def handle_configure(self, message: Configure, now: float) -> Welcome:
        """Change the predictor, its parameters or the kind of reply."""
        stream = self._open_stream
        stays = portable(stream.pipeline.predictor) and (message.parameters or message.predictor)
        self._quota.spend(PERSON_S if stays else BUILD_S, now)
        stream.configure(message)
        self._weigh_events()
        return self._welcome()

    def handle_reset(self, message: Reset, now: float) -> None:
        """Forget every event."""
        self._open_stream.reset()

    def handle_person(self, message: Person, now: float) -> KnownPerson:
        """Send what is known of the person."""
        self._quota.spend(PERSON_S if message.person else BUILD_S, now)
        return KnownPerson(self._open_stream.person(message.person))

    def handle_enter(self, message: Enter, now: float) -> None:
        """Remember places for this window."""
        self._open_stream.enter(message)

    def handle_forget(self, message: Forget, now: float) -> KnownPerson:
        """Forget the person."""
        return KnownPerson(self._open_stream.forget())

    def handle_bye(self, message: Bye, now: float) -> None:
        """Close as the client asks."""
        self.end(1000, message.reason or "bye")

    handlers: ClassVar[Mapping[type[ClientMessage], Handler]] = {
        Hello: handle_hello,
        Events: handle_events,
        Targets: handle_targets,
        TrialMark: handle_trial,
        Configure: handle_configure,
        Enter: handle_enter,
        Forget: handle_forget,
        Reset: handle_reset,
        Person: handle_person,
        Bye: handle_bye,
    }
    """The method for each message. It returns the message that answers, if any, and raises ProtocolError."""

    def end(self, code: int, reason: str) -> None:
        """As ``Session.end``; the observer is told, too."""
        if self.state is not CLOSED and self.stream is not None and self.stream.observer is not None:
            self.stream.observer.close()
        super().end(code, reason)

    def _feed(self, stream: PredictionStream, table: FloatArray, now: float) -> None:
        """Take in a frame of events, in another thread where that takes long."""
        cost_s = stream.costs.of(len(table))
        self._quota.spend(cost_s, now)
        if cost_s > AT_ONCE_S:
            self.work = Work(self._take_in(stream, table, now))
        elif (finish := stream.take_in_last(table, self.outbox)) is not None:  # most frames, and fast
            self._send_answers(finish, len(table), stream.refusal_s, now)
        else:
            result_of(self._take_in(stream, table, now))()

    def _take_in(self, stream: PredictionStream, table: FloatArray, now: float) -> Slices[Completion]:
        """Predict, in any thread; what comes of it sends the answers, or what is wrong with the frame."""
        try:
            finish = yield from stream.take_in(table, self.outbox)
        except (ProtocolError, EventError) as error:
            return partial(self._refuse_events, error, stream.refusal_s, now)
        return partial(self._send_answers, finish, len(table), stream.refusal_s, now)

    def _score(self, scoring: Scoring) -> Slices[Completion]:
        """Score a trial, in any thread; what comes of it sends the score."""
        yield  # all of it is one slice
        return partial(self.send, scoring())

    def _send_answers(self, finish: Finish, events: int, refusal_s: float, now: float) -> None:
        error, dropped = finish()
        if events and self.state is not STREAMING:
            self.move(Trigger.EVENTS)
        if error is not None:
            self.refuse(error, dropped)
            self._spend(refusal_s, now)

    def _refuse_events(self, error: ProtocolError | EventError, refusal_s: float, now: float) -> None:
        self.answer_error(error)
        self._spend(refusal_s, now)

    def _spend(self, cost_s: float, now: float) -> None:
        """Count what has been spent; the session ends where it is too much."""
        try:
            self._quota.spend(cost_s, now)
        except ProtocolError as error:
            self.answer_error(error)

    def _weigh_events(self) -> None:
        """What an event counts, with the targets and the settings in force."""
        self._quota.weigh_events(self._targets, places=self._open_stream.hello.places)

    def _welcome(self) -> Welcome:
        hello = self._open_stream.hello
        return Welcome(hello.version, self.name, hello.predictor, self.limits)


def _no_hello(received: str) -> ProtocolError:
    return ProtocolError("out_of_place", f"expected 'hello' first, received {received}")
