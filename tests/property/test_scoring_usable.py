"""What the scorer calls good, every differentiator accepts."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pointpred import EventColumns
from pointpred.differentiators import DIFFERENTIATORS
from pointpred.scoring.trials import CUTS, GOOD, cut

NAN = float("nan")
EDGES = [0.0, 1.0, -1.0, 1e9, -1e9, 1.01e9, 1.7e9, 1e11, 1.01e11, 1.7e12, 1e300, float("inf"), NAN]
VALUES = st.floats(-100.0, 100.0) | st.sampled_from(EDGES)
COUNTS = st.sampled_from([(NAN, NAN), (3.0, -4.0), (NAN, 1.0), (1.0, NAN), (float("inf"), NAN), (0.0, 2e9)])


@st.composite
def trials(draw: st.DrawFn) -> np.ndarray:
    """A reach, up to two cells of which are anything."""
    t = np.cumsum(draw(st.lists(st.sampled_from([0.0, 0.01, 0.2]), min_size=1, max_size=12)))
    table = np.full((len(t), 6), np.nan)
    table[:, 0] = t + draw(st.sampled_from([0.0, 1.7e9, -1e9]))
    table[:, 1], table[:, 2], table[:, 5] = 40.0 * np.arange(len(t)), 0.0, 0.0
    for row in draw(st.sets(st.integers(0, len(t) - 1), max_size=2)):
        if draw(st.booleans()):
            table[row, 3:5] = draw(COUNTS)
        else:
            table[row, draw(st.sampled_from([0, 1, 2, 5]))] = draw(VALUES)
    return table


@pytest.mark.parametrize("cpi", [None, 1600.0])
@given(parts=st.lists(trials(), min_size=1, max_size=5))
def test_every_differentiator_accepts_what_is_good(cpi: float | None, parts: list[np.ndarray]) -> None:
    table = np.concatenate(parts)
    offsets = np.concatenate([[0], np.cumsum([len(part) for part in parts])]).astype(np.int64)
    cuts = np.empty((len(parts), CUTS), dtype=np.int64)
    cut(table, offsets, cuts)
    for verdict, _, onset, stop, _ in cuts:
        if verdict == GOOD:
            for kind in DIFFERENTIATORS.values():
                kind(cpi=cpi).run(EventColumns(table[onset:stop]))
