"""How much a session may send: the bytes and events of a frame, events and messages a second, targets."""

from __future__ import annotations

from pointpred.protocol.client_messages import Target
from pointpred.protocol.errors import ProtocolError
from pointpred.protocol.server_messages import Limits
from pointpred.protocol.token_bucket import TokenBucket
from pointpred_server.sessions.costs import TEXT_BYTE_S

MESSAGES_PER_S = 500
"""Messages other than events, a second: two for each refresh of a fast display."""
BYTES_A_MESSAGE = 4096
"""A frame that cannot be used counts once more for each so many bytes: finding what is wrong takes time."""
TARGETS_AN_EVENT = 64
"""An event counts once more for each so many targets: each target is looked at."""
EVENTS_FOR_PLACES = 7
"""An event counts so many times more where the client asked for places: they are read after it."""

USUAL = Limits()
SHARE = 0.3
"""Seconds of the processor that one session may use a second, by the costs of its messages; more in
proportion where the service is started with more events a second than usual."""


class Quota:
    """The limits of one session; every check raises ProtocolError."""

    def __init__(self, limits: Limits, now: float) -> None:
        self.limits = limits
        self.events = TokenBucket(limits.max_events_per_s, now)
        self._weight = 1  # what an event counts
        self._messages = TokenBucket(MESSAGES_PER_S, now)
        self._share = SHARE * max(1.0, limits.max_events_per_s / USUAL.max_events_per_s)
        self.costs = TokenBucket(self._share, now)

    def extend(self, seconds: float) -> None:
        """So long nothing was received, and all of it comes now."""
        self.events.extend(seconds)
        self._messages.extend(seconds)
        self.costs.extend(seconds)

    def check_size(self, frame: str | bytes) -> None:
        """The bytes of a frame; the session ends where it holds more."""
        most, size = self.limits.max_frame_bytes, len(frame)
        # A character takes at most four bytes: most texts need not be encoded to be measured.
        if isinstance(frame, str) and most < 4 * size <= 4 * most:
            size = len(frame.encode(errors="surrogatepass"))
        if size > most:
            sentence = f"a frame holds at most {most} bytes, received {size}"
            raise ProtocolError("too_large", sentence, close=1009)

    def take_events(self, count: int, now: float) -> None:
        """The events of a frame, and of the last second; a frame without any counts as one."""
        most = self.limits.max_events_per_frame
        if count > most:
            sentence = f"a frame holds at most {most} events, received {count}"
            raise ProtocolError("too_large", sentence, "$.events", close=1009)
        if not self.events.take((count or 1) * self._weight, now):
            sentence = f"at most {self.limits.max_events_per_s // self._weight} events a second"
            sentence += " with so many targets, or with places" if self._weight > 1 else ""
            raise ProtocolError("too_fast", sentence, close=1008)

    def allow(self, count: int, cost_s: float, now: float) -> bool:
        """``take_events`` and ``spend`` for several frames; False, and nothing taken, for too much."""
        if not self.events.take(count * self._weight, now):
            return False
        if not self.costs.take(cost_s, now):
            self.events.give_back(count * self._weight)
            return False
        return True

    def give_back(self, count: int, cost_s: float) -> None:
        """Put back what was taken for events that were not used."""
        self.events.give_back(count * self._weight)
        self.costs.give_back(cost_s)

    def take_message(self, now: float, count: int = 1) -> None:
        """A message other than events; the session ends where there are more in a second."""
        if not self._messages.take(count, now):
            sentence = f"at most {MESSAGES_PER_S} messages a second beside events; a long one counts more"
            raise ProtocolError("too_fast", sentence, close=1008)

    def spend(self, cost_s: float, now: float) -> None:
        """What a message costs, as ``costs`` has it; the session ends where they cost too much a second."""
        if not self.costs.take(cost_s, now):
            sentence = f"the messages of a session may take {self._share:g} s of the processor a second"
            raise ProtocolError("too_fast", sentence, close=1008)

    def take_text(self, frame: str, now: float) -> None:
        """What decoding a text costs."""
        self.spend(TEXT_BYTE_S * len(frame), now)

    def take_invalid(self, frame: str, now: float) -> None:
        """A text that is not a message."""
        self.take_message(now, 1 + len(frame) // BYTES_A_MESSAGE)

    def check_targets(self, targets: list[Target]) -> None:
        """The number of targets, and that no two have the same id."""
        count, most = len(targets), self.limits.max_targets
        if count > most:
            raise ProtocolError("too_many", f"at most {most} targets, received {count}", "$.targets")
        ids: set[str] = set()
        for place, target in enumerate(targets):
            if target.id in ids:
                sentence, path = f"id {target.id!r} occurs twice", f"$.targets[{place}].id"
                raise ProtocolError("bad_field", sentence, path, field="id", value=target.id)
            ids.add(target.id)

    def weigh_events(self, targets: int, *, places: bool) -> None:
        """From now on, each event counts as ``targets`` targets, and places, make it cost."""
        self._weight = 1 + targets // TARGETS_AN_EVENT + (EVENTS_FOR_PLACES if places else 0)
