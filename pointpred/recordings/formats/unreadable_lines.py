"""Lines of a log that cannot be read: skipped and counted; a note names the first of each kind."""

from __future__ import annotations

SHOWN = 60


class UnreadableLines:
    """Counts the lines of a file that are skipped, by kind."""

    def __init__(self) -> None:
        self._kinds: dict[str, tuple[int, str]] = {}

    def add(self, kind: str, number: int, line: str) -> None:
        """Count line ``number`` (from 1) as one of a kind, such as "reports that cannot be read"."""
        count, first = self._kinds.get(kind, (0, f"line {number} ({line.strip()[:SHOWN]!r})"))
        self._kinds[kind] = count + 1, first

    @property
    def notes(self) -> list[str]:
        """A note for each kind, in order of appearance."""
        return [
            f"{kind}, left aside: {count}, the first is {first}"
            for kind, (count, first) in self._kinds.items()
        ]
