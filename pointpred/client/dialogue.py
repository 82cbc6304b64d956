"""The client's side of a session without a socket: what to send, and what an answer means."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator
from typing import Any

import msgspec
import numpy as np

from pointpred.client.awaited import Awaited
from pointpred.client.wire import Row, columns_of
from pointpred.columns import EventColumns, PredictionColumns
from pointpred.errors import ParameterError, PointpredError
from pointpred.events import PointerEvent
from pointpred.protocol.client_messages import (
    VERSION,
    ClientMessage,
    Configure,
    Encoding,
    Goal,
    Hello,
    Person,
    Reply,
    Reset,
    Target,
    Targets,
    TrialMark,
)
from pointpred.protocol.decoding import decode_server_message
from pointpred.protocol.frames import Frame, event_frames, message_of, row_of
from pointpred.protocol.records import unpack_predictions
from pointpred.protocol.server_messages import (
    Choice,
    Cursor,
    ErrorMessage,
    Likely,
    PredictionMessage,
    Welcome,
    encode,
)
from pointpred.registry import RECOMMENDED

KEPT_NOTICES = 100
"""The newest notices that are kept; ``noticed`` counts them all."""
KEPT_CHOICES = 1000
"""The newest choices that are kept until they are taken."""


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


class Dialogue:
    """Remembers what was asked and what is still unanswered; not safe for threads."""

    def __init__(
        self,
        predictor: str = RECOMMENDED,
        parameters: dict[str, Any] | None = None,
        device: dict[str, float] | None = None,
        screen: dict[str, float] | None = None,
        reply: Reply = "frame",
        encoding: Encoding = "binary",
        assist: dict[str, Any] | None = None,
        **others: Any,
    ) -> None:
        """Raises ParameterError where the hello would not fit the protocol."""
        described = {"predictor": predictor, "parameters": parameters or {}, "device": device, **others}
        described |= {"screen": screen, "reply": reply, "encoding": encoding}
        described |= {} if assist is None else {"assist": assist}
        self.hello = _fit(Hello, {"type": "hello", "version": VERSION, **described})
        self.welcome: Welcome | None = None
        self.notices: deque[ErrorMessage] = deque(maxlen=KEPT_NOTICES)
        """Remarks of the service that break nothing: predictions that gave way to newer ones. The newest."""
        self.noticed = 0
        """How many there were in all."""
        self.cursor: Cursor | None = None
        """Where the service has put the cursor, in a session that asked for assistance."""
        self._rows: deque[tuple[list[float], list[Likely] | msgspec.UnsetType]] = deque()
        self._choices: deque[Choice] = deque(maxlen=KEPT_CHOICES)
        self._proposed: list[str] = []
        self._awaited = Awaited()

    def events(self, events: EventColumns | Iterable[PointerEvent | Row]) -> Iterator[Frame]:
        """Frames to send, one after another; what they ask for counts as asked once it is taken."""
        if self.welcome is None:
            raise ParameterError("events may be sent after the service has said welcome")
        for frame, part in event_frames(columns_of(events), self.hello.encoding, self.welcome.limits):
            self._awaited.ask(part.table, each=self.hello.reply == "event")
            yield frame

    def targets(self, targets: Iterable[dict[str, Any] | Target]) -> Frame:
        """Replaces the set of targets."""
        return self._text(_fit(Targets, {"type": "targets", "targets": [_plain(each) for each in targets]}))

    def trial(self, action: str, target: dict[str, float] | Goal | None) -> Frame:
        """A trial starts or ends; a start begins anew, as ``reset`` does."""
        mark = {"type": "trial", "action": action, "target": None if target is None else _plain(target)}
        frame = self._text(_fit(TrialMark, mark))
        if action == "start":
            self._awaited.restart()
        return frame

    def configure(self, **changes: Any) -> Frame:
        """Changes the predictor, its parameters or the kind of reply."""
        return self._text(_fit(Configure, {"type": "configure", **changes}))

    def configured(self, **changes: Any) -> None:
        """The service took the changes."""
        if "reply" in changes:
            self.hello.reply = changes["reply"]
        if {"predictor", "parameters"} & changes.keys():
            self._awaited.restart()

    def person(self, known: str | None) -> Frame:
        """Asks for what is known of the person, or begins anew knowing ``known``."""
        frame = self._text(_fit(Person, {"type": "person", "person": known}))
        if known is not None:
            self._awaited.restart()
        return frame

    def reset(self) -> Frame:
        """Forget every event."""
        self._awaited.restart()
        return self._text(Reset())

    def heard(self, frame: Frame) -> msgspec.Struct | None:
        """Take in a frame: ``None`` for what is kept, such as predictions; raises ServiceError."""
        if isinstance(frame, bytes):
            for row in unpack_predictions(frame):
                self._predicted(row)
            return None
        message = decode_server_message(frame)
        if isinstance(message, PredictionMessage):
            self._predicted(row_of(message), message.targets)
            return None
        if isinstance(message, Choice):
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
                self._awaited.refused(message)
                raise ServiceError(message)
            self._awaited.gave_way()
            self.notices.append(message)
            self.noticed += 1
            return None
        if isinstance(message, Welcome):
            self.welcome = message
        return message

    def _predicted(self, row: list[float], likely: list[Likely] | msgspec.UnsetType = msgspec.UNSET) -> None:
        self._rows.append((row, likely))
        self._awaited.predicted(row[0])

    @property
    def proposed(self) -> str | None:
        """The newest of the targets that the service proposes, as far as it was heard."""
        return self._proposed[-1] if self._proposed else None

    @property
    def answered(self) -> bool:
        """Whether every event has its prediction, or the error that refused it."""
        return not self._awaited

    def take(self) -> PredictionMessage | None:
        """The oldest prediction not yet taken."""
        return message_of(*self._rows.popleft()) if self._rows else None

    def take_all(self) -> PredictionColumns:
        """Every prediction not yet taken."""
        rows = [row for row, _ in self._rows]
        self._rows.clear()
        return PredictionColumns(np.array(rows, dtype=np.float64).reshape(-1, len(PredictionColumns.names)))

    def take_choices(self) -> list[Choice]:
        """Every choice not yet taken."""
        choices = list(self._choices)
        self._choices.clear()
        return choices

    def _text(self, message: ClientMessage) -> str:
        """Raises ParameterError where the service would end the session for the size of the message."""
        text = encode(message)
        if self.welcome is not None and len(text) > (most := self.welcome.limits.max_frame_bytes):
            kind = message.__struct_config__.tag
            raise ParameterError(f"{kind}: a frame holds at most {most} bytes, received {len(text)}")
        return text.decode()


def _plain(value: Any) -> Any:
    return msgspec.to_builtins(value)


def _fit(kind: type[Any], described: dict[str, Any]) -> Any:
    """A message of a kind from its fields; raises ParameterError where they do not fit."""
    try:
        return msgspec.convert(described, kind)
    except msgspec.ValidationError as error:
        raise ParameterError(f"{described['type']}: {error}") from None
