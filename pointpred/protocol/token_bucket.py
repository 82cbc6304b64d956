"""The limit on what comes a second: a budget that refills with time and holds one second's worth."""

from __future__ import annotations

from pointpred.clock import Instant


class TokenBucket:
    """``most`` a second, and as many at once."""

    def __init__(self, most: float, now: Instant) -> None:
        self.most = float(most)
        self.left = float(most)
        """What it held when it was last refilled, less what was taken since."""
        self._since = now

    def take(self, count: float, now: Instant) -> bool:
        """Take ``count`` out of the budget; False, and nothing taken, where it does not hold so many."""
        passed_s = now.s - self._since.s
        left = self.left
        if passed_s != 0.0:
            if passed_s > 0.0:
                left = max(left, min(self.most, left + passed_s * self.most))
            self._since = now
        self.left = left
        if count > left:
            return False
        self.left = left - count
        return True

    def full(self, now: Instant) -> bool:
        """Whether nothing that was taken is still missing."""
        return self.take(0.0, now) and self.left >= self.most

    def extend(self, seconds: float) -> None:
        """Hold what comes in so many seconds, at most a minute's worth, until it is used."""
        self.left = max(self.left, (1.0 + min(seconds, 60.0)) * self.most)
