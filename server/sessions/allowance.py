"""What a session may send: the size of frames, events a frame and a second, targets."""

from __future__ import annotations

from pointpred.protocol.client_messages import Target
from pointpred.protocol.errors import ProtocolError
from pointpred.protocol.server_messages import Limits
from pointpred.protocol.token_bucket import TokenBucket

MESSAGES_PER_S = 500
"""Messages other than events, a second: a display's refreshing twice over, and some."""
BYTES_A_MESSAGE = 4096
"""A frame that cannot be used counts once for each so many bytes: saying what is wrong takes time."""
TARGETS_AN_EVENT = 64
"""An event counts once more for each so many targets: each of them is looked at."""


class Allowance:
    """The limits of one session; every check raises ProtocolError."""

    def __init__(self, limits: Limits, now: float) -> None:
        self.limits = limits
        self.burden = 1
        """What an event counts."""
        self.rate = TokenBucket(limits.max_events_per_s, now)
        self._messages = TokenBucket(MESSAGES_PER_S, now)

    def check_size(self, frame: str | bytes) -> None:
        """The bytes of a frame; the session ends where it holds more."""
        most, size = self.limits.max_frame_bytes, len(frame)
        # A character takes at most four bytes: most texts need not be encoded to be measured.
        if isinstance(frame, str) and most < 4 * size <= 4 * most:
            size = len(frame.encode(errors="surrogatepass"))
        if size > most:
            words = f"a frame holds at most {most} bytes, received {size}"
            raise ProtocolError("too_large", words, close=1009)

    def take(self, count: int, now: float) -> None:
        """The events of a frame, and of the last second; a frame without any counts as one."""
        most = self.limits.max_events_per_frame
        if count > most:
            words = f"a frame holds at most {most} events, received {count}"
            raise ProtocolError("too_large", words, "$.events", close=1009)
        if not self.rate.allows((count or 1) * self.burden, now):
            words = f"at most {self.limits.max_events_per_s // self.burden} events a second"
            words += " with so many targets" if self.burden > 1 else ""
            raise ProtocolError("too_fast", words, close=1008)

    def take_message(self, now: float, count: int = 1) -> None:
        """A message other than events; the session ends where there are more in a second."""
        if not self._messages.allows(count, now):
            words = f"at most {MESSAGES_PER_S} messages a second beside events; a long one counts more"
            raise ProtocolError("too_fast", words, close=1008)

    def take_unusable(self, frame: str, now: float) -> None:
        """A text that is no message."""
        self.take_message(now, 1 + len(frame) // BYTES_A_MESSAGE)

    def check_targets(self, targets: list[Target]) -> None:
        """How many targets, and that each has a name of its own."""
        count, most = len(targets), self.limits.max_targets
        if count > most:
            raise ProtocolError("too_many", f"at most {most} targets, received {count}", "$.targets")
        seen: set[str] = set()
        for place, target in enumerate(targets):
            if target.id in seen:
                raise ProtocolError("bad_field", f"id {target.id!r} occurs twice", f"$.targets[{place}].id")
            seen.add(target.id)
