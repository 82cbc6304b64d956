"""A device followed live: its reports, where the cursor is, what is predicted of each, rates and delays."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator, Sequence
from math import log10
from threading import Event

import msgspec

from pointpred.clock import NEVER, Instant, now
from pointpred.devices.cursor_paths import CursorPath, MotorPath, PlaceEvent, Space
from pointpred.devices.first_moving import moves
from pointpred.devices.source import DeviceSource
from pointpred.errors import EventError
from pointpred.records import Pair, PointerEvent, Prediction
from pointpred.stage import Stage

Watcher = Callable[[Sequence[Pair]], None]
"""Called on the session's thread with the pairs of each batch, empty where nothing came in time; an exception
ends the session."""

WAIT_S = 0.1
"""How long a session waits for a report before it looks whether it is to stop."""
SHORTEST_S, LONGEST_S, A_DECADE = 1e-6, 1e2, 50
BINS = int(A_DECADE * log10(LONGEST_S / SHORTEST_S)) + 1
SPAN_S, PIECE_S = 1.0, 0.02


class LiveState(msgspec.Struct, frozen=True):
    """Counts, rates and delays of a session at a moment.

    ``idle_s`` since something was reported, infinite before. ``lost`` reports nobody took in time,
    ``unreadable`` ones that could not be decoded, ``resynchronised`` recoveries after the kernel dropped
    events, ``refused`` events that the pipeline did not take, the newest reason in ``why``. Delays are those
    from a report's stamp to its prediction over the last 10 to 20 s of reports, in s; ``None`` where nothing
    came yet or the stamps are of another clock than the session's. ``note``: what a person should know of the
    device now, such as that nothing moves; ``None`` where there is nothing to say. ``target``: the likeliest
    one and its share, in words; ``None`` without targets.
    """

    plugged: bool
    reports: int
    rate_hz: float
    idle_s: float
    lost: int
    unreadable: int
    resynchronised: int
    refused: int
    why: str | None
    delay_p50_s: float | None
    delay_p99_s: float | None
    note: str | None = None
    target: str | None = None


class LiveSession:
    """Pairs of a pointer event and what is predicted at it, from a device.

    Assumes an open source, which the caller closes. ``path`` makes events of reports, ``None``
    integrates the counts and says so in ``words``. ``pipeline`` is any stage from events to predictions: the
    step is the one that runs everywhere. One thread drives a session, others may ask for ``state`` and read
    ``newest``. Memory is bounded over any time. Limitation: reports that the source lost leave a hole in a
    path that integrates. ``clock`` is that of sources that call theirs monotonic.

    >>> from types import SimpleNamespace
    >>> from pointpred import build
    >>> from pointpred.devices.source import Report
    >>> reports = [Report(0.01 * i, 2 * i, 0) for i in range(9)]
    >>> source = SimpleNamespace(clock="made up", take=lambda timeout_s: reports)
    >>> session = LiveSession(source, None, build("hold"))
    >>> [(event.x, prediction.x) for event, prediction in session.advance(0.0)][-1]
    (72.0, 72.0)
    """

    def __init__(
        self,
        source: DeviceSource,
        path: CursorPath | None,
        pipeline: Stage[PointerEvent, Prediction | None],
        *,
        watchers: Sequence[Watcher] = (),
        clock: Callable[[], Instant] = now,
    ) -> None:
        self.source = source
        self.path = path or MotorPath()
        self.pipeline = pipeline
        self.watchers = list(watchers)
        self.newest: Pair | None = None
        self.reports = 0
        self.refused = 0
        self.moved = False
        """Whether the device has moved, were it by one count."""
        self.silent_s = 0.0
        """How long nothing has moved since the beginning: the sum of the waits without a report, s."""
        self.note: Callable[[], str | None] = lambda: None
        """What ``state`` says of the device in words; replace it to say something."""
        self.target: str | None = None
        """What ``state`` says of the targets."""
        self._why: str | None = None
        self._last_t, self._reported_at = float("-inf"), NEVER
        self._clock = clock
        self.delays = DelayHistogram()
        """From a report's stamp to its prediction, over the whole session."""
        self._recent, self._pace = RecentDelays(), ReportRate()

    @property
    def space(self) -> Space:
        """What the positions are: the screen's cursor, a transfer function's, or the hand's own."""
        return self.path.space

    @property
    def words(self) -> str:
        """The same for people."""
        return self.path.words

    def advance(self, timeout_s: float = WAIT_S) -> list[Pair]:
        """Predictions for the pending reports, after waiting at most ``timeout_s`` for some.

        An event that the pipeline refuses is left out and counted. Where a contact begins, the pipeline
        forgets the movement before it. Raises what a watcher raises.
        """
        reports = self.source.take(timeout_s)
        if reports:
            self.reports += len(reports)
            self._reported_at = self._clock()
            self._pace.add(self._reported_at, len(reports))
        if not self.moved:
            self.moved = moves(reports)
            self.silent_s += 0.0 if reports else timeout_s
        comparable = "monotonic" in self.source.clock
        pairs: list[Pair] = []
        for event in self.path.events(reports):
            if isinstance(event, PlaceEvent) and event.begins:
                self.pipeline.reset()
            try:
                prediction = self.pipeline.update(event)
            except EventError as error:
                self.refused += 1
                self._why = str(error)
                continue
            pairs.append((event, prediction))
            if comparable and event.t > self._last_t:  # not for a correction of an earlier place
                delay = self._clock().since(Instant(event.t))
                self.delays.add(delay)
                self._recent.add(event.t, delay)
            self._last_t = event.t
        if pairs:
            self.newest = pairs[-1]
        for watcher in self.watchers:
            watcher(pairs)
        return pairs

    def run(self, stopping: Event) -> None:
        """Follow the device until ``stopping`` is set, including the reports pending then."""
        while not stopping.is_set():
            self.advance()
        self.advance(0.0)

    def __iter__(self) -> Iterator[Pair]:
        """Pairs without end, as they come."""
        while True:
            yield from self.advance()

    def state(self) -> LiveState:
        """Counts, rates and delays now; any thread may ask."""
        source, recent, moment = self.source, self._recent, self._clock()
        return LiveState(
            source.plugged,
            self.reports,
            self._pace.rate(moment),
            moment.since(self._reported_at),
            source.lost,
            source.unreadable,
            source.resynchronised,
            self.refused,
            self._why,
            recent.percentile(0.5),
            recent.percentile(0.99),
            self.note(),
            self.target,
        )


class DelayHistogram:
    """How long something took, as a histogram: percentiles to 5 %, whatever the number of values.

    Values below a microsecond count as one, above 100 s as 100 s. Memory: 401 integers.

    >>> delays = DelayHistogram()
    >>> for i in range(100):
    ...     delays.add(0.001 * (i + 1))
    >>> delays.count, round(delays.percentile(0.5), 3), round(delays.percentile(0.99), 3)
    (100, 0.05, 0.1)
    """

    def __init__(self) -> None:
        self.count = 0
        self.longest = 0.0
        self._bins = [0] * BINS

    def add(self, seconds: float) -> None:
        """Count one value."""
        place = int(A_DECADE * log10(seconds / SHORTEST_S)) if seconds > SHORTEST_S else 0
        self._bins[min(place, BINS - 1)] += 1
        self.count += 1
        self.longest = max(self.longest, seconds)

    def joined(self, other: DelayHistogram) -> DelayHistogram:
        """Both together."""
        both = DelayHistogram()
        both.count, both.longest = self.count + other.count, max(self.longest, other.longest)
        both._bins = [one + two for one, two in zip(self._bins, other._bins, strict=True)]
        return both

    def percentile(self, share: float) -> float | None:
        """A bound in s that this share of the values did not pass; ``None`` where there are none."""
        if not self.count:
            return None
        left = share * self.count
        for place, count in enumerate(self._bins):
            left -= count
            if count and left <= 1e-9 * self.count:
                return float(min(SHORTEST_S * 10.0 ** ((place + 1) / A_DECADE), self.longest))
        return self.longest


class RecentDelays:
    """``DelayHistogram`` of the last seconds: between one and two spans of them. Memory: that of two.

    >>> recent = RecentDelays(span_s=10.0)
    >>> for t in range(100):
    ...     recent.add(float(t), 0.5 if t < 80 else 0.001)
    >>> recent.percentile(0.99) < 0.0011
    True
    """

    def __init__(self, span_s: float = 10.0) -> None:
        self._span = span_s
        self._now, self._before = DelayHistogram(), DelayHistogram()
        self._until = float("-inf")

    def add(self, t: float, seconds: float) -> None:
        """Count one value, seen at ``t`` s."""
        if t >= self._until:
            self._now, self._before = DelayHistogram(), self._now
            self._until = t + self._span
        self._now.add(seconds)

    def percentile(self, share: float) -> float | None:
        """As ``DelayHistogram.percentile``."""
        return self._now.joined(self._before).percentile(share)


class ReportRate:
    """How many came in the last second; memory is bounded, whatever the rate.

    >>> pace = ReportRate()
    >>> for i in range(3000):
    ...     pace.add(Instant(0.001 * i), 1)
    >>> 970 <= pace.rate(Instant(3.0)) <= 1030, pace.rate(Instant(9.0))
    (True, 0.0)
    """

    def __init__(self) -> None:
        self._pieces: deque[tuple[Instant, int]] = deque(maxlen=2 + int(SPAN_S / PIECE_S))

    def add(self, at: Instant, count: int) -> None:
        """So many came at this moment."""
        pieces = self._pieces
        if pieces and at.since(pieces[-1][0]) < PIECE_S:
            pieces[-1] = (pieces[-1][0], pieces[-1][1] + count)
        else:
            pieces.append((at, count))

    def rate(self, seen: Instant) -> float:
        """So many a second, seen from this moment."""
        return sum(count for at, count in tuple(self._pieces) if seen.since(at) < SPAN_S) / SPAN_S
