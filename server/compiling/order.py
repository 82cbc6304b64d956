"""The order of compiling: what the first answer needs, then what a client waits for, then the rest."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from pointpred_server.compiling.parts import Part


class PartQueue:
    """Parts that are waiting, under way and done; changed by one thread at a time.

    Any thread may ask whether all is finished: a part is never in none of the three lists.
    """

    def __init__(self, parts: Sequence[Part], first: Collection[str]) -> None:
        """``first``: parts that come before all preferred ones."""
        self.waiting = list(parts)
        self.under_way: list[str] = []
        self.done: list[str] = []
        self.names = frozenset(part.name for part in parts)
        self._first = first
        self._preferred: dict[str, int] = {}

    @property
    def finished(self) -> bool:
        """Whether nothing waits and nothing is under way."""
        return not self.waiting and not self.under_way

    def take(self) -> Part | None:
        """The next part that can begin, which is then under way; ``None`` where none can begin yet."""
        for place, part in enumerate(self.waiting):
            if all(name in self.done for name in part.after):
                self.under_way.append(part.name)
                del self.waiting[place]
                return part
        return None

    def finish(self, name: str) -> None:
        """A part is compiled, or has failed."""
        self.done.append(name)
        self.under_way.remove(name)

    def prefer(self, names: Iterable[str]) -> None:
        """Somebody waits for these parts: they come before the others, the earliest preferred first.

        Unknown names are ignored: clients may send any.
        """
        before = {part.name: part.after for part in self.waiting}
        for name in filter(self.names.__contains__, names):
            for each in (*before.get(name, ()), name):
                self._preferred.setdefault(each, len(self._preferred))
        last = len(self._preferred)
        self.waiting.sort(
            key=lambda part: -1 if part.name in self._first else self._preferred.get(part.name, last)
        )

    def missing(self, names: Iterable[str]) -> list[str]:
        """Those of the names that are parts and not done."""
        return [name for name in names if name in self.names and name not in self.done]
