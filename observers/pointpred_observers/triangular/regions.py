"""Regions of a generator's or a plant's states: an interval for each, by symbol, by name or in order."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import inf
from typing import Any

from pointpred.errors import ParameterError

StateRegion = Mapping[Any, tuple[float, float]] | Sequence[tuple[float, float]] | None
"""(low, high) of each state: a dictionary by symbol or name, or pairs in order; ``None``: no bounds."""


def intervals_of(region: StateRegion, over: Sequence[Any]) -> dict[Any, tuple[float, float]]:
    """The intervals by symbol; a dictionary may leave some out, pairs may not.

    Raises ParameterError for an unknown state, a wrong number of pairs, and what is no finite interval.

    >>> import sympy as sp
    >>> w = sp.symbols("w1 w2")
    >>> intervals_of({"w2": (-1, 1)}, w)
    {w2: (-1.0, 1.0)}
    >>> intervals_of([(0.0, 1.0)], w)
    Traceback (most recent call last):
    pointpred.errors.ParameterError: region needs 2 pairs (low, high), received [(0.0, 1.0)]
    """
    known = {str(one): one for one in over}
    if isinstance(region, Mapping):
        if unknown := [str(one) for one in region if str(one) not in known]:
            raise ParameterError(
                f"region may hold {', '.join(known)}, received {unknown[0]!r}", field="region", value=region
            )
        return {known[str(name)]: _interval(str(name), pair) for name, pair in region.items()}
    if not isinstance(region, list | tuple) or len(region) != len(over):
        raise ParameterError(
            f"region needs {len(over)} pairs (low, high), received {region!r}", field="region", value=region
        )
    return {one: _interval(str(one), pair) for one, pair in zip(over, region, strict=True)}


def _interval(name: str, pair: Any) -> tuple[float, float]:
    try:
        low, high = (float(one) for one in pair)
    except (TypeError, ValueError) as unusable:
        raise ParameterError(
            f"{name} needs (low, high), received {pair!r}", field="region", value=pair
        ) from unusable
    if not -inf < low <= high < inf:
        raise ParameterError(
            f"{name} needs finite low <= high, received {pair!r}", field="region", value=pair
        )
    return low, high
