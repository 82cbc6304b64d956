"""A compiler for tests: it has compiled a part when the test says so."""

from __future__ import annotations

import threading
from collections import defaultdict
from collections.abc import Sequence

from pointpred_server.compiling.compiler import Compiler
from pointpred_server.compiling.parts import Part
from pointpred_server.compiling.process import LOW_PRIORITY


class Awaited(Part):
    """A part that is not in the cache, and that costs nothing to run."""

    @property
    def awaits(self) -> bool:
        return True


class FakeProcesses:
    """Stands in the place of compiling processes; ``asked`` has what they were asked for, in order."""

    def __init__(self) -> None:
        self.asked: list[str] = []
        self.ended = 0
        self._allowed: dict[str, threading.Event] = defaultdict(threading.Event)
        self._all = threading.Event()

    def __call__(self) -> FakeProcesses:
        return self

    def compiling(self, names: Sequence[str]) -> Compiler:
        """What a service compiles with."""
        parts = [Awaited(name, lambda: None, ()) for name in names]
        return Compiler(parts, self)  # type: ignore[arg-type]

    def allow(self, *names: str) -> None:
        """These parts can be compiled now; all, where none is named."""
        for name in names:
            self._allowed[name].set()
        if not names:
            self._all.set()

    def compile(self, name: str) -> bool:
        self.asked.append(name)
        if name != LOW_PRIORITY:
            while not (self._all.is_set() or self._allowed[name].wait(0.005)):
                pass
        return True

    def kill(self) -> None:
        self._all.set()

    def end(self) -> None:
        self.ended += 1
