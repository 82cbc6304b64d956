"""Somebody who watches the attached device over ``/v1/live``: is sent everything, and may say goodbye."""

from __future__ import annotations

from typing import Protocol

from pointpred.clock import Instant
from pointpred.protocol.client_messages import Bye
from pointpred.protocol.decoding import decode_client_message
from pointpred.protocol.errors import ProtocolError
from pointpred.protocol.server_messages import Attached, Curve, Limits, Status, encode
from pointpred_server.sessions.lifecycle import Session, State
from pointpred_server.sessions.quota import Address

READ_ONLY = "this stream is only read; expected nothing but 'bye', received "


class LiveSource(Protocol):
    """What a viewer is shown."""

    attached: Attached
    curve: Curve | None

    def status(self) -> Status:
        """How the reading goes."""


class ViewingSession(Session):
    """The server's side of one viewer's connection; messages are answered, and change nothing."""

    def __init__(
        self, name: str, limits: Limits, now: Instant, source: LiveSource, address: Address | None = None
    ) -> None:
        """``source``: what it is comes first, and again where that has changed."""
        super().__init__(name, limits, now, address, State.STREAMING)
        self._source = source
        self._attached: Attached | None = None
        self._curve: Curve | None = None
        self._send_status()

    def tick(self, now: Instant, late_s: float = 0.0) -> None:
        """Send how the reading goes, unless the last status is still unread."""
        if self.state is not State.CLOSED and not self.outbox:
            self._send_status()

    def _receive(self, frame: str | bytes, now: Instant) -> None:
        """Nothing but ``bye`` has a meaning here."""
        self._quota.take_message(now, len(frame))
        if isinstance(frame, bytes):
            raise ProtocolError("out_of_place", f"{READ_ONLY}a binary frame")
        message = decode_client_message(frame)
        if not isinstance(message, Bye):
            raise ProtocolError("out_of_place", f"{READ_ONLY}{message.__struct_config__.tag!r}")
        self.end(1000, message.reason or "bye")

    def _send_status(self) -> None:
        source = self._source
        if source.attached is not self._attached:
            self._attached = source.attached
            self._send_live(source.attached)
        self._send_live(source.status())
        if (curve := source.curve) is not None and curve is not self._curve:
            self._curve = curve
            self._send_live(curve)

    def _send_live(self, message: Attached | Status | Curve) -> None:
        self.outbox.add(encode(message).decode())
