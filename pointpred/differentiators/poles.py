"""What the gains of the homogeneous differentiator must satisfy where it is linear."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pointpred.differentiators.sampling import is_number
from pointpred.errors import ParameterError


def check_step(gains: Sequence[float], step_s: float) -> None:
    """The Euler step must keep the linear law stable, alpha = 0.

    With alpha < 0 the gain is k_j |e|^(j alpha): smaller than the linear law's for errors above 1 m, so that
    it stays bounded, and larger below.
    """
    poles = np.roots([1.0, *gains])
    longest_s = float(np.min(-2.0 * poles.real / np.abs(poles) ** 2))
    if step_s >= longest_s:
        raise ParameterError(
            f"step_s must be below {longest_s:g} s, where Euler's method with these gains becomes unstable, "
            f"received {step_s!r}"
        )


def check_gains(gains: Sequence[float], order: int) -> list[float]:
    """Given gains must be one positive number an order, and make a stable linear law."""
    listed = isinstance(gains, Sequence | np.ndarray) and not isinstance(gains, str | bytes)
    whole = listed and len(gains) == order and all(is_number(k) and 0.0 < k < np.inf for k in gains)
    if not whole:
        raise ParameterError(f"gains must be {order} positive numbers, received {gains!r:.80}")
    slowest = float(np.max(np.roots([1.0, *gains]).real))
    if slowest >= 0.0:
        raise ParameterError(f"gains {list(gains)!r} make an unstable law: a pole has real part {slowest:g}")
    return [float(k) for k in gains]
