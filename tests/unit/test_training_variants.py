"""What training is given and told: variants of movements."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred import EventColumns
from pointpred.recording import Recording, Trial
from pointpred.training.data import varied


def test_variants_are_as_large_and_as_fast_as_they_should_be() -> None:
    """An eighth of them tiny; both bounds are reached, none is passed; logarithms lie evenly."""
    t = np.linspace(0.0, 1.0, 11)
    path = EventColumns.of(t, 10_000.0 * t, np.zeros(11))
    many = Recording.of("many", [path] * 3000, [Trial("ann", str(k)) for k in range(3000)])
    seen = varied(many, 4)
    ends = np.array([seen.rows(k).table[-1, :3] for k in range(3000)])
    tempo, size = ends[:, 0], np.hypot(ends[:, 1], ends[:, 2]) / 10_000.0
    tiny = size < 0.4
    assert tiny.mean() == pytest.approx(0.13, abs=0.02)
    for values, low, high in ((size[tiny], 0.1, 0.4), (size[~tiny], 0.4, 2.5), (tempo[tiny], 0.25, 1.6),
                              (tempo[~tiny], 0.35, 1.6)):  # fmt: skip
        logs = np.log(values / low) / np.log(high / low)
        assert -1e-3 < logs.min() < 0.02
        assert 0.98 < logs.max() < 1.001
        assert logs.mean() == pytest.approx(0.5, abs=0.05)
