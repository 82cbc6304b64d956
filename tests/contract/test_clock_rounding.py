"""No rule of any pipeline hangs on how the stamps of a clock are rounded."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred import EventColumns, run
from tests.contract.test_stage_laws import EVERY, make


@EVERY
@pytest.mark.parametrize("rate", [100, 125, 1000])
@pytest.mark.parametrize("shift", [1, 1000, 86400])
def test_no_rule_hangs_on_how_a_clock_is_rounded(name: str, rate: int, shift: int) -> None:
    """A grid whose stamps are no binary fractions: each shift rounds them otherwise."""
    s = np.clip(np.arange(rate) / (0.7 * rate), 0.0, 1.0)
    reach = 10 * s**3 - 15 * s**4 + 6 * s**5
    ticks = np.arange(rate)

    def at(origin: int) -> np.ndarray:
        t = (ticks + origin * rate) / rate
        return run(make(name), EventColumns.of(t, 400 * reach, 300 * reach)).table

    assert np.array_equal(np.isnan(at(shift)), np.isnan(at(0)))
    np.testing.assert_allclose(at(shift)[:, 1:3], at(0)[:, 1:3], rtol=0.0, atol=1e-2)
