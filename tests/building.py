"""What tests of several rooms build: movements, recordings and files."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from pointpred.recording import Recording, Trial
from pointpred.records import EventColumns


def way(s: Any) -> Any:
    """Share of the way at a share of the time, at the speed of least jerk (Flash and Hogan 1985)."""
    return 10 * s**3 - 15 * s**4 + 6 * s**5


def reach(
    start: Sequence[float],
    end: Sequence[float],
    seconds: float = 0.6,
    *,
    rest_s: float = 0.15,
    rate_hz: float = 100.0,
) -> EventColumns:
    """A movement of least jerk, px, that then rests."""
    t = np.arange(0.0, seconds + rest_s, 1.0 / rate_hz)
    done = way(np.minimum(t / seconds, 1.0))
    return EventColumns.of(t, start[0] + (end[0] - start[0]) * done, start[1] + (end[1] - start[1]) * done)


def rows_of_reach(px: float) -> list[list[Any]]:
    """A movement along x as messages carry it: 0.5 s and a rest, every 10 ms."""
    return [[i / 100, px * way(min(i / 50, 1.0)), 0.0, None, None, 0] for i in range(60)]


def recording(parts: Sequence[EventColumns], name: str = "set", **fields: Any) -> Recording:
    """Movements of one person."""
    return Recording.of(name, list(parts), [Trial("ann", str(i)) for i in range(len(parts))], **fields)


def text_file(path: Path, text: str) -> Path:
    """A file of this text."""
    path.write_text(text, encoding="utf-8")
    return path


def lines_file(path: Path, *lines: str) -> Path:
    """A file of these lines."""
    return text_file(path, "\n".join([*lines, ""]))
