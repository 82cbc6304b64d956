"""Chrome's Speculation Rules over recorded movements: a link is fetched after a hover or at the press.

By the eagerness of a rule: ``moderate`` after 200 ms over a link or at the press of a button, ``eager``
(since Chrome 141 on desktops) after 10 ms. Every movement ends with a press.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pages.intent.movements import Movement, inside
from pointpred.records import FloatArray

HOVER_S = {"eager": 0.01, "moderate": 0.2}
HEADS = ("firings", "after the entry", "before the press")


def by_hover(movement: Movement, hover_s: float) -> FloatArray:
    """When each target fires, s; infinite where it does not."""
    t = movement.events[:, 0]
    return np.array([_first_hover(t, inside(row, movement.events), hover_s) for row in movement.table])


def _first_hover(t: FloatArray, within: np.ndarray[tuple[int], np.dtype[np.bool_]], hover_s: float) -> float:
    """When the cursor has first been in a target for so long, or is in it at the end; infinite if never."""
    changes = np.flatnonzero(np.diff(within.astype(np.int8), prepend=0, append=0))
    for begin, end in zip(changes[::2], changes[1::2], strict=True):
        if end == len(t):
            return float(min(t[begin] + hover_s, t[-1]))
        if t[end] - t[begin] >= hover_s:
            return float(t[begin] + hover_s)
    return float("inf")


def hovered(movements: Sequence[Movement], hover_s: float) -> tuple[str, str, str]:
    """Firings a movement; medians of how late after the entry and how early before the press it fires, ms."""
    fired = [by_hover(one, hover_s) for one in movements]
    after = [at[one.right] - one.events[one.entry, 0] for one, at in zip(movements, fired, strict=True)]
    early = [one.events[-1, 0] - at[one.right] for one, at in zip(movements, fired, strict=True)]
    counts = [np.isfinite(at).sum() for at in fired]
    return (
        f"{np.mean(counts):.2f}",
        f"{1e3 * np.median(after):.0f}",
        f"{1e3 * np.median(np.maximum(early, 0.0)):.0f}",
    )
