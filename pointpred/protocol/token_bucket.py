"""The limit on events a second: a budget that refills with time and holds one second's worth."""

from __future__ import annotations


class TokenBucket:
    """``most`` events a second, and as many at once."""

    def __init__(self, most: float, now: float) -> None:
        self.most = float(most)
        self.left = float(most)
        """What it held when it was last refilled, less what was taken since."""
        self._since = now

    def take(self, count: float, now: float) -> bool:
        """Take ``count`` out of the budget; False, and nothing taken, where it does not hold so many."""
        left = self.left
        if now != self._since:
            if now > self._since:
                left = max(left, min(self.most, left + (now - self._since) * self.most))
            self._since = now
        self.left = left
        if count > left:
            return False
        self.left = left - count
        return True

    def extend(self, seconds: float) -> None:
        """Hold what comes in so many seconds, at most a minute's worth, until it is used."""
        self.left = max(self.left, (1.0 + min(seconds, 60.0)) * self.most)

    def give_back(self, count: float) -> None:
        """Put back what was taken and not used."""
        self.left += count
