"""Somebody who looks at the attached device over ``/v1/live``: hears everything, may say goodbye."""

from __future__ import annotations

from typing import Protocol

from pointpred.protocol.client_messages import Bye
from pointpred.protocol.decoding import decode_client_message
from pointpred.protocol.errors import ProtocolError
from pointpred.protocol.live_messages import Attached, Curve, Status
from pointpred.protocol.server_messages import Limits, encode
from pointpred.server.sessions.allowance import Allowance
from pointpred.server.sessions.conversation import SLOW, Conversation

READ_ONLY = "this stream is only read; expected nothing but 'bye', received "


class Shown(Protocol):
    """What a viewer looks at."""

    attached: Attached
    curve: Curve | None

    def status(self) -> Status:
        """How the reading goes."""


class Viewer(Conversation):
    """The server's side of one viewer's connection; what it says is answered, and changes nothing."""

    def __init__(self, name: str, limits: Limits, now: float) -> None:
        super().__init__(name, limits, now)
        self.state = "streaming"
        self._allowance = Allowance(limits, now)
        self._shown: Shown | None = None
        self._attached: Attached | None = None
        self._curve: Curve | None = None

    def show(self, shown: Shown) -> None:
        """Look at something from now on; what it is comes first, and again where it has changed."""
        self._shown = shown
        self._tell()

    def receive(self, frame: str | bytes, now: float) -> None:
        """Answer one frame; nothing but ``bye`` has a meaning here."""
        if self.state == "closed":
            return
        try:
            self._allowance.check_size(frame)
            if isinstance(frame, bytes):
                self._allowance.take_message(now)
                raise ProtocolError("out_of_place", f"{READ_ONLY}a binary frame")
            self._hear(frame, now)
        except ProtocolError as refused:
            self.refuse(refused.answer)
            if refused.close is not None:
                self.shut(refused.close, refused.answer.message)
        if self.outbox.full:
            self.end("slow", SLOW, 1013)

    def tick(self, now: float) -> None:
        """Say how the reading goes, unless the last word is still unread."""
        if self.state == "closed":
            return
        if self.outbox.full:
            self.end("slow", SLOW, 1013)
        elif not self.outbox:
            self._tell()

    def _hear(self, text: str, now: float) -> None:
        """Raises ProtocolError for everything but a goodbye."""
        try:
            message = decode_client_message(text)
        except ProtocolError:
            self._allowance.take_unusable(text, now)
            raise
        if isinstance(message, Bye):
            self.shut(1000, message.reason or "bye")
            return
        self._allowance.take_message(now)
        raise ProtocolError("out_of_place", f"{READ_ONLY}{message.__struct_config__.tag!r}")

    def _tell(self) -> None:
        shown = self._shown
        if shown is None:
            return
        if shown.attached is not self._attached:
            self._attached = shown.attached
            self._say(shown.attached)
        self._say(shown.status())
        if (curve := shown.curve) is not None and curve is not self._curve:
            self._curve = curve
            self._say(curve)

    def _say(self, message: Attached | Status | Curve) -> None:
        self.outbox.say(encode(message).decode())
