"""Statistics while a device is read: reports per second, and the delays of predictions."""

from __future__ import annotations

from collections import deque
from math import log10

SHORTEST_S, LONGEST_S, A_DECADE = 1e-6, 1e2, 50
BINS = int(A_DECADE * log10(LONGEST_S / SHORTEST_S)) + 1
SPAN_S, PIECE_S = 1.0, 0.02


class Delays:
    """How long something took, as a histogram: percentiles to 5 %, whatever the number of values.

    Values below a microsecond count as one, above 100 s as 100 s. Memory: 401 integers.

    >>> delays = Delays()
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

    def joined(self, other: Delays) -> Delays:
        """Both together."""
        both = Delays()
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
    """``Delays`` of the last seconds: between one and two spans of them. Memory: twice that of ``Delays``.

    >>> recent = RecentDelays(span_s=10.0)
    >>> for t in range(100):
    ...     recent.add(float(t), 0.5 if t < 80 else 0.001)
    >>> recent.percentile(0.99) < 0.0011
    True
    """

    def __init__(self, span_s: float = 10.0) -> None:
        self._span = span_s
        self._now, self._before = Delays(), Delays()
        self._until = float("-inf")

    def add(self, t: float, seconds: float) -> None:
        """Count one value, seen at ``t`` s."""
        if t >= self._until:
            self._now, self._before = Delays(), self._now
            self._until = t + self._span
        self._now.add(seconds)

    def percentile(self, share: float) -> float | None:
        """As ``Delays.percentile``."""
        return self._now.joined(self._before).percentile(share)


class Pace:
    """How many came in the last second; memory is bounded, whatever the rate.

    >>> pace = Pace()
    >>> for i in range(3000):
    ...     pace.add(0.001 * i, 1)
    >>> 970 <= pace.rate(3.0) <= 1030, pace.rate(9.0)
    (True, 0.0)
    """

    def __init__(self) -> None:
        self._pieces: deque[tuple[float, int]] = deque(maxlen=2 + int(SPAN_S / PIECE_S))

    def add(self, now: float, count: int) -> None:
        """So many came at ``now`` s."""
        pieces = self._pieces
        if pieces and now - pieces[-1][0] < PIECE_S:
            pieces[-1] = (pieces[-1][0], pieces[-1][1] + count)
        else:
            pieces.append((now, count))

    def rate(self, now: float) -> float:
        """So many a second, seen from ``now`` s."""
        return sum(count for at, count in tuple(self._pieces) if now - at < SPAN_S) / SPAN_S
