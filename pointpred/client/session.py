"""The client's side of a session without a socket: what to send, and what an answer means.

``Connection`` and ``AsyncConnection`` add the socket, and nothing else.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from typing import Any, Self
from urllib.parse import urlsplit, urlunsplit

import msgspec
import numpy as np
from websockets.exceptions import ConnectionClosed
from websockets.typing import Subprotocol

from pointpred.errors import EventError, ParameterError, PointpredError, SourceError
from pointpred.protocol.client_messages import (
    SUBPROTOCOL,
    VERSION,
    Bye,
    ClientMessage,
    Conditions,
    Configure,
    Encoding,
    Enter,
    Forget,
    Goal,
    Hello,
    Person,
    Rectangle,
    Reply,
    Reset,
    Targets,
    TrialMark,
)
from pointpred.protocol.decoding import check_numbers, decode_server_message
from pointpred.protocol.errors import ProtocolError
from pointpred.protocol.frames import (
    NONE,
    PHASE,
    PREDICTION,
    Frame,
    event_frames,
    message_of,
    row_of_prediction,
    unpack_predictions,
)
from pointpred.protocol.server_messages import (
    ChoiceMessage,
    Cursor,
    ErrorMessage,
    Likely,
    Limits,
    PredictionMessage,
    TargetsTaken,
    Welcome,
    encode,
)
from pointpred.records import PHASES, EventColumns, FloatArray, PointerEvent, PredictionColumns
from pointpred.registry import RECOMMENDED

Row = Sequence[float | None]
"""t, x, y and then, where they are known, dx, dy, buttons."""
STREAM_PATH = "/v1/stream"
QUEUE = 1024
"""Frames kept for a script that does not read; then the service keeps only its newest prediction."""
OTHER_SERVICE = "does a service of this version of pointpred listen there?"
KEPT_NOTICES = 100
"""The newest notices that are kept; ``noticed`` counts them all."""
KEPT_CHOICES = 1000
"""The newest choices that are kept until they are taken."""

NEVER = float("-inf")
Target = str | msgspec.UnsetType | None
Targeted = list[Likely] | msgspec.UnsetType
"""Unset in a session without targets."""


class ServiceError(PointpredError, ValueError):
    """The service refused something: ``code``, ``path``, ``field``, ``value`` of its ``error`` message."""

    def __init__(self, answer: ErrorMessage) -> None:
        place = f" at {answer.path}" if answer.path else ""
        field = "" if answer.field is msgspec.UNSET else answer.field
        value = None if answer.value is msgspec.UNSET else answer.value
        super().__init__(
            f"{answer.code}{place}: {answer.message}", code=answer.code, field=field, value=value
        )
        self.path = answer.path
        self.recoverable = answer.recoverable


class ClientSession:
    """Remembers what was sent and what is still unanswered; not safe for threads."""

    def __init__(self, hello: Hello, timeout_s: float = 10.0) -> None:
        self.hello = hello
        self.timeout_s = timeout_s
        """The longest wait for an answer."""
        self.greeting: Welcome | None = None
        """The newest welcome of the service; ``None`` before the first."""
        self.notices: deque[ErrorMessage] = deque(maxlen=KEPT_NOTICES)
        """The newest messages about predictions that newer ones replaced; they break nothing."""
        self.noticed = 0
        """How many of them there were."""
        self.cursor: Cursor | None = None
        """Where the service has put the cursor, in a session opened with ``assist``; the newest received."""
        self._rows: deque[tuple[list[float], Target, Targeted]] = deque()
        self._choices: deque[ChoiceMessage] = deque(maxlen=KEPT_CHOICES)
        self._proposed: list[str] = []
        self._sent_ids: list[str] = []
        self._ids: list[str] = []  # of the targets that the service has
        self._unanswered = UnansweredFrames()

    @property
    def dialogue(self) -> Self:
        """The connection itself: earlier versions had ``notices`` and ``noticed`` here."""
        return self

    @property
    def welcome(self) -> Welcome:
        """The newest welcome of the service."""
        assert self.greeting is not None
        return self.greeting

    @property
    def limits(self) -> Limits:
        """What the session may do."""
        return self.welcome.limits

    @property
    def proposed(self) -> str | None:
        """The newest of the targets that are proposed, as far as it was received."""
        return self._proposed[-1] if self._proposed else None

    @property
    def answered(self) -> bool:
        """Whether every event has its prediction, or the error that refused it."""
        return not self._unanswered

    def choices(self) -> list[ChoiceMessage]:
        """What was proposed and retracted since the last call, oldest first, without waiting.

        The choices of an event are received before its prediction: once a prediction is there, so are its
        choices. The newest thousand are kept.
        """
        choices = list(self._choices)
        self._choices.clear()
        return choices

    def take(self) -> PredictionMessage | None:
        """The oldest prediction not yet taken, ``None`` where there is none."""
        if not self._rows:
            return None
        row, target, likely = self._rows.popleft()
        message = message_of(row)
        message.target, message.targets = target, likely
        return message

    def take_all(self) -> PredictionColumns:
        """Every prediction not yet taken."""
        rows = [row for row, _, _ in self._rows]
        self._rows.clear()
        return PredictionColumns(np.array(rows, dtype=np.float64).reshape(-1, len(PredictionColumns.names)))

    def hello_frame(self) -> Frame:
        """Begins the session."""
        return self._text(self.hello)

    def event_frames(self, events: EventColumns | Iterable[PointerEvent | Row]) -> Iterator[Frame]:
        """Frames to send, one after another; each counts as sent once it is taken."""
        if self.greeting is None:
            raise ParameterError("events may be sent after the service has sent welcome")
        for frame, part in event_frames(columns_of(events), self.hello.encoding, self.limits):
            self._unanswered.add(part.table, each=self.hello.reply == "event")
            yield frame

    def targets_frame(self, targets: Iterable[dict[str, Any] | Rectangle]) -> Frame:
        """Replaces the set of targets."""
        plain = [msgspec.to_builtins(each) for each in targets]
        message: Targets = _fit(Targets, {"type": "targets", "targets": plain})
        frame = self._text(message)
        self._sent_ids = [one.id for one in message.targets]
        return frame

    def trial_frame(
        self, action: str, target: dict[str, float] | Goal | None, conditions: Conditions | None
    ) -> Frame:
        """Starts or ends a trial; a start forgets every event, as ``reset`` does."""
        mark: dict[str, Any] = {"type": "trial", "action": action, "target": msgspec.to_builtins(target)}
        mark |= {"conditions": conditions} if conditions else {}
        frame = self._text(_fit(TrialMark, mark))
        if action == "start":
            self._unanswered.restart()
        return frame

    def configure_frame(self, **changes: Any) -> Frame:
        """Changes the predictor, its parameters or the kind of reply."""
        return self._text(_fit(Configure, {"type": "configure", **changes}))

    def configured(self, **changes: Any) -> None:
        """The service accepted the changes; to the service None and no parameters change nothing."""
        if changes.get("reply") is not None:
            self.hello.reply = changes["reply"]
        if changes.get("predictor") is not None or changes.get("parameters"):
            self._unanswered.restart()

    def person_frame(self, replacement: str | None) -> Frame:
        """Asks what is known of the person; with a ``replacement`` the session begins anew, knowing that."""
        frame = self._text(_fit(Person, {"type": "person", "person": replacement}))
        if replacement is not None:
            self._unanswered.restart()
        return frame

    def enter_frame(self, key: str, x: float, y: float) -> Frame:
        """Names the window of the next movement."""
        frame = self._text(_fit(Enter, {"type": "enter", "key": key, "x": x, "y": y}))
        self._unanswered.restart()
        return frame

    def forget_frame(self) -> Frame:
        """Forgets the person and every event."""
        self._unanswered.restart()
        return self._text(Forget())

    def reset_frame(self) -> Frame:
        """Forgets every event."""
        self._unanswered.restart()
        return self._text(Reset())

    def bye_frame(self) -> Frame:
        """Ends the session."""
        return self._text(Bye())

    def receive(self, frame: Frame) -> msgspec.Struct | None:
        """Take in a frame: returns a message that somebody waits for, ``None`` for what is kept here.

        Raises ServiceError for an error, and SourceError for a frame that no service of this protocol sends.
        """
        if isinstance(frame, bytes):
            for row, place in _rows_of(frame, self.hello.version):
                id = self._ids[place] if 0 <= place < len(self._ids) else None
                self._add_prediction(row, id if self._ids else msgspec.UNSET)
            return None
        message = _message_of(frame)
        if isinstance(message, PredictionMessage):
            if message.x is not None and message.phase is None:
                raise SourceError(f"received a prediction without a phase; {OTHER_SERVICE}")
            self._add_prediction(row_of_prediction(message), message.target, message.targets)
            return None
        if isinstance(message, ChoiceMessage):
            self._choices.append(message)
            self._proposed = [id for id in self._proposed if id != message.id]
            if message.action == "propose":
                self._proposed.append(message.id)
            return None
        if isinstance(message, Cursor):
            self.cursor = message
            return None
        if isinstance(message, ErrorMessage):
            if not (message.code == "slow" and message.recoverable):
                self._unanswered.refuse(message)
                raise ServiceError(message)
            self._unanswered.skip()
            self.notices.append(message)
            self.noticed += 1
            return None
        if isinstance(message, Welcome):
            self.greeting = message
        if isinstance(message, TargetsTaken):
            self._ids = self._sent_ids
        return message

    def _add_prediction(self, row: list[float], target: Target, likely: Targeted = msgspec.UNSET) -> None:
        self._rows.append((row, target, likely))
        self._unanswered.answer(row[0])

    def _text(self, message: ClientMessage) -> str:
        """Raises ParameterError where the service would end the session for the size of the message."""
        text = encode(message)
        if self.greeting is not None and len(text) > (most := self.limits.max_frame_bytes):
            kind = message.__struct_config__.tag
            sentence = f"{kind}: a frame holds at most {most} bytes, received {len(text)}"
            raise ParameterError(sentence, field=str(kind), value=len(text))
        return text.decode()


def _rows_of(frame: bytes, version: int) -> list[tuple[list[float], int]]:
    """The predictions of a binary frame, and the places of their targets; raises SourceError."""
    size = PREDICTION[version].itemsize
    if not frame or len(frame) % size:
        sentence = f"received a frame of {len(frame)} bytes, expected records of {size} bytes"
        raise SourceError(f"{sentence}; {OTHER_SERVICE}")
    rows, places = unpack_predictions(frame, version)
    if unknown := [row[PHASE] for row in rows if row[PHASE] >= len(PHASES)]:
        raise SourceError(f"received phase {unknown[0]:g}, expected 0 to {len(PHASES) - 1}; {OTHER_SERVICE}")
    return list(zip(rows, places, strict=True))


def _message_of(frame: str) -> msgspec.Struct | None:
    """The message of a text, ``None`` for a type that only newer services know; raises SourceError."""
    try:
        return decode_server_message(frame)
    except (msgspec.DecodeError, RecursionError) as error:
        raise SourceError(f"received what is no message of a service: {error}; {OTHER_SERVICE}") from error


def hello_message(
    predictor: str = RECOMMENDED,
    parameters: dict[str, Any] | None = None,
    device: dict[str, float] | None = None,
    screen: dict[str, float] | None = None,
    reply: Reply = "frame",
    encoding: Encoding = "binary",
    assist: dict[str, Any] | None = None,
    **others: Any,
) -> Hello:
    """The first message of a session; raises ParameterError where a field does not fit the protocol."""
    fields = {"predictor": predictor, "parameters": parameters or {}, "device": device, **others}
    fields |= {"screen": screen, "reply": reply, "encoding": encoding}
    fields |= {} if assist is None else {"assist": assist}
    hello: Hello = _fit(Hello, {"type": "hello", "version": VERSION, **fields})
    return hello


def service_address(url: str) -> str:
    """The address of the stream: ``http`` becomes ``ws``, a bare address gets the usual path.

    >>> service_address("http://127.0.0.1:8765/")
    'ws://127.0.0.1:8765/v1/stream'
    """
    parts = urlsplit(url)
    scheme = {"http": "ws", "https": "wss"}.get(parts.scheme, parts.scheme)
    if scheme not in ("ws", "wss") or not parts.netloc:
        sentence = f"the address must be ws://HOST:PORT or http://HOST:PORT, received {url!r}"
        raise ParameterError(sentence, field="url", value=url)
    path = parts.path if parts.path not in ("", "/") else STREAM_PATH
    return urlunsplit((scheme, parts.netloc, path, parts.query, ""))


def dial_options(token: str | None, timeout_s: float) -> dict[str, Any]:
    """What both clients pass to ``websockets`` to connect."""
    return {
        "subprotocols": [Subprotocol(SUBPROTOCOL)],
        "additional_headers": {} if token is None else {"Authorization": f"Bearer {token}"},
        "compression": None,
        "max_queue": QUEUE,
        "open_timeout": timeout_s,
        "proxy": None,
    }


def columns_of(events: EventColumns | Iterable[PointerEvent | Row]) -> EventColumns:
    """Events as a table, from records or from rows; raises EventError."""
    if isinstance(events, EventColumns):
        return events
    table = [_numbers(event) for event in events]
    return EventColumns(np.array(table, dtype=np.float64).reshape(-1, 6))


def _numbers(event: PointerEvent | Row) -> list[float]:
    if isinstance(event, PointerEvent):
        row: Row = msgspec.structs.astuple(event)
    elif 3 <= len(event) <= 6:
        row = (*event, *(None, None, 0)[len(event) - 3 :])
    else:
        raise EventError(f"an event is t, x, y[, dx, dy, buttons], received {len(event)} values")
    return [NONE if value is None else float(value) for value in row]


def no_answer(timeout_s: float) -> SourceError:
    """The error for an answer that did not come."""
    return SourceError(f"the service did not answer for {timeout_s:g} s", code="no_answer", value=timeout_s)


def no_connection(address: str, error: Exception) -> SourceError:
    """The error for a service that cannot be reached."""
    return SourceError(f"cannot connect to {address}: {error}", code="no_connection", value=address)


def connection_closed(closed: ConnectionClosed) -> SourceError:
    """The error for a connection that has ended, with the close code as its value."""
    frame = closed.rcvd
    if frame is None:
        return SourceError("the connection to the service was lost", code="connection_lost")
    sentence = f"the service closed the session: {frame.code} {frame.reason}".rstrip()
    return SourceError(sentence, code="session_closed", value=frame.code)


def _fit(kind: type[Any], fields: dict[str, Any]) -> Any:
    """A message from its fields; raises ParameterError where they do not fit."""
    try:
        return msgspec.convert(fields, kind)
    except msgspec.ValidationError as error:
        raise ParameterError(f"{fields['type']}: {error}", field=str(fields["type"])) from None


class _Frame:
    """One frame as sent; ``update`` determines the answers to expect."""

    def __init__(self, table: FloatArray, *, begins: bool, each: bool) -> None:
        self.table = table
        self.times: list[float] = table[:, 0].tolist()
        self.begins = begins
        self.each = each
        self.newest = NEVER
        self.expected: deque[float] = deque()
        """Times of the predictions to expect."""
        self.late = False
        """Whether to expect an error, because events run backwards."""

    def usable(self) -> bool:
        """Whether the service's own check accepts every number."""
        try:
            check_numbers(self.table)
        except ProtocolError:
            return False
        return True

    def update(self, newest: float) -> float:
        """Expect that events before ``newest`` are dropped; returns the newest time after this frame."""
        newest, used = NEVER if self.begins else newest, []
        for t in self.times:
            if t >= newest:
                newest = t
                used.append(t)
        self.expected = deque(used if self.each else used[-1:])
        self.late = len(used) < len(self.times)
        self.newest = newest
        return newest


class UnansweredFrames:
    """The frames of a session that are not answered yet, oldest first.

    Answers come in the order of the frames, but newer predictions may replace older ones: then errors come
    before the newest. Holds what was sent since the last answer, which is as much as the service takes
    before it ends the session of a client that does not read.
    """

    def __init__(self) -> None:
        self._frames: deque[_Frame] = deque()
        self._taken = NEVER  # the newest time the service had taken in before the oldest frame
        self._begins = False
        self._skipped = False

    def __bool__(self) -> bool:
        return bool(self._frames)

    def add(self, table: FloatArray, *, each: bool) -> None:
        """A frame is sent; ``each``: one prediction an event, otherwise one for the newest."""
        frame = _Frame(table, begins=self._begins, each=each)
        frame.update(self._frames[-1].newest if self._frames else self._taken)
        self._frames.append(frame)
        self._begins = False

    def restart(self) -> None:
        """The service forgets its events: the next one may have any time."""
        self._begins = True

    def skip(self) -> None:
        """The predictions that come next have replaced older ones."""
        self._skipped = True

    def answer(self, t: float) -> None:
        """A prediction came: nothing more is expected for the frames before its own."""
        frames = self._frames
        if self._skipped or not (frames and frames[0].expected and frames[0].expected[0] == t):
            place = self._index_of(t)
            self._skipped = False
            if place is None:
                return
            self._remove(place)
            if t not in frames[0].expected:  # taken for late, because of an event that the service refused
                frames[0].begins = True
                self._update()
        expected = frames[0].expected
        while expected and expected.popleft() != t:
            pass
        if not expected and not frames[0].late:
            self._remove(1)

    def refuse(self, error: ErrorMessage) -> None:
        """An error came; one about events answers a frame, others and the end of a session do not."""
        if not (error.recoverable and error.path is not None and error.path.startswith("$.events")):
            return
        if error.code == "out_of_order":
            late = next((k for k, frame in enumerate(self._frames) if frame.late), None)
            self._remove(0 if late is None else late + 1)
        elif self._frames:  # dropped whole: the service is as if it had not been sent
            # refused for its numbers: the oldest, unless predictions before it were replaced
            self._remove(next((k for k, frame in enumerate(self._frames) if not frame.usable()), 0))
            if self._frames.popleft().begins:
                self._taken = NEVER
            self._update()

    def _index_of(self, t: float) -> int | None:
        """Which frame a prediction answers; of equal times the newest one, where some were replaced."""
        holding = [k for k, frame in enumerate(self._frames) if t in frame.times]
        places = [k for k in holding if t in self._frames[k].expected] or holding
        return places[-1 if self._skipped else 0] if places else None

    def _remove(self, count: int) -> None:
        for _ in range(count):
            self._taken = self._frames.popleft().newest

    def _update(self) -> None:
        newest = self._taken
        for frame in self._frames:
            newest = frame.update(newest)
