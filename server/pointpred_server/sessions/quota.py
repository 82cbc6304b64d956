"""How much a session may send: the bytes and events of a frame, events and other messages a second, targets.

Events and messages are also counted by address, so that many sessions of one client, one after another or at
a time, share what they may send. The limits of a frame keep the work that one of them asks for to some
milliseconds: other sessions wait no longer.
"""

from __future__ import annotations

from pointpred.clock import Instant
from pointpred.protocol.client_messages import Rectangle
from pointpred.protocol.errors import ProtocolError
from pointpred.protocol.server_messages import Limits
from pointpred.protocol.token_bucket import TokenBucket

MESSAGES_PER_S = 250
"""Messages other than events, pieces of messages, pings and pongs: two for each refresh of a fast display."""
BUILDING = 25
"""A message that builds a pipeline, or has a trial scored, counts so many times."""
BYTES_A_MESSAGE = 2**14
"""A message counts once more for each so many bytes: reading it takes time."""
TARGETS_AN_EVENT = 16
"""An event counts once more for each so many targets: each target is looked at."""
EVENTS_FOR_PLACES = 12
"""An event counts so many times more where the client asked for places: they are read after it."""
SESSIONS_OF_AN_ADDRESS = 16
"""All sessions of one address may send as much as so many."""


class Rates:
    """What may still come this second: of a session, or of all sessions of an address."""

    def __init__(self, limits: Limits, now: Instant, sessions: int = 1) -> None:
        self.events = TokenBucket(sessions * limits.max_events_per_s, now)
        self.messages = TokenBucket(sessions * MESSAGES_PER_S, now)

    def extend(self, seconds: float) -> None:
        """So long nothing was received, and all of it comes now."""
        self.events.extend(seconds)
        self.messages.extend(seconds)

    def full(self, now: Instant) -> bool:
        """Whether nothing has come lately."""
        return self.events.full(now) and self.messages.full(now)


class Address(Rates):
    """What the sessions of one address share, and how many they are now."""

    def __init__(self, limits: Limits, now: Instant) -> None:
        super().__init__(limits, now, SESSIONS_OF_AN_ADDRESS)
        self.sessions = 0


class Addresses:
    """The addresses that have sessions, or had some in the last second: memory grows with their number."""

    def __init__(self, limits: Limits) -> None:
        self._limits = limits
        self._known: dict[str, Address] = {}

    def of(self, name: str, now: Instant) -> Address:
        """The address of a name; those that nothing is left to count of are forgotten."""
        if name not in self._known:
            self._known = {one: it for one, it in self._known.items() if it.sessions or not it.full(now)}
            self._known[name] = Address(self._limits, now)
        return self._known[name]


class Quota:
    """The limits of one session; every check raises ProtocolError.

    ``address``: what it shares with the other sessions of its address.
    """

    def __init__(self, limits: Limits, now: Instant, address: Address | None = None) -> None:
        self.limits = limits
        self._weight = 1  # what an event counts
        self._own = Rates(limits, now)
        self._shared = address or Address(limits, now)

    def extend(self, seconds: float) -> None:
        """So long nothing was received, and all of it comes now."""
        self._own.extend(seconds)
        self._shared.extend(seconds)

    def check_size(self, frame: str | bytes) -> None:
        """The bytes of a frame; the session ends where it holds more."""
        most, size = self.limits.max_frame_bytes, len(frame)
        # A character takes at most four bytes: most texts need not be encoded to be measured.
        if isinstance(frame, str) and most < 4 * size <= 4 * most:
            size = len(frame.encode(errors="surrogatepass"))
        if size > most:
            sentence = f"a frame holds at most {most} bytes, received {size}"
            raise ProtocolError("too_large", sentence, close=1009)

    def take_events(self, count: int, now: Instant) -> None:
        """The events of a frame, and of the last second; a frame without any counts as one."""
        most = self.limits.max_events_per_frame
        if count > most:
            sentence = f"a frame holds at most {most} events, received {count}"
            raise ProtocolError("too_large", sentence, "$.events", close=1009)
        weight = (count or 1) * self._weight
        if not self._own.events.take(weight, now):
            sentence = f"at most {self.limits.max_events_per_s // self._weight} events a second"
            sentence += " with so many targets, or with places" if self._weight > 1 else ""
            raise ProtocolError("too_fast", sentence, close=1008)
        if not self._shared.events.take(weight, now):
            sentence = "the sessions of this address send too many events a second"
            raise ProtocolError("too_fast", sentence, close=1008)

    def take_message(self, now: Instant, bytes_: int = 0, count: int = 1) -> None:
        """A message other than events; the session ends where there are more in a second."""
        count += bytes_ // BYTES_A_MESSAGE
        if not self._own.messages.take(count, now):
            sentence = f"at most {MESSAGES_PER_S} messages a second beside events; long ones count more"
            raise ProtocolError("too_fast", sentence, close=1008)
        if not self._shared.messages.take(count, now):
            sentence = "the sessions of this address send too many messages a second"
            raise ProtocolError("too_fast", sentence, close=1008)

    def check_targets(self, targets: list[Rectangle]) -> None:
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
