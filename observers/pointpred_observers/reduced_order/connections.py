"""The matrices that the theorems of section 3.3 speak of: those of an observer, or printed ones."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from pointpred.errors import ParameterError
from pointpred_observers.numerics.matrices import matrix, moments
from pointpred_observers.plants.nonlinearity import intervals, nonlinearity, require_slopes
from pointpred_observers.plants.persidskii import Persidskii, column, row
from pointpred_observers.reduced_order.reversed_connection import Connection, InvariantObserver

Slopes = tuple[tuple[float, float], ...] | None


def connections_of(
    observer: Any, slopes: Any = None, times: Sequence[float] | None = None
) -> tuple[list[Connection], Slopes]:
    """The matrices at each time, of an observer or as printed, with the slopes of f.

    Raises ParameterError for anything else, for slopes that the f of an observer's plant does not have, and
    for printed matrices whose shapes do not fit; the slopes of a printed f are the caller's own.

    >>> one = connections_of({"S0": [[-1.0]], "S1": [1.0], "J": [2.0]}, [(0.0, 1.0)])[0][0]
    >>> one.S0.tolist(), one.S1.tolist(), one.J.tolist()
    ([[-1.0]], [[1.0]], [[2.0]])
    """
    if isinstance(observer, InvariantObserver):
        varying = "the observer" if observer.varying else ""
        connections = [observer.at(t) for t in moments(varying, times, "checked")]
        slopes = _slopes_of(observer.plant, slopes, any(one.S1.any() for one in connections))
    elif isinstance(observer, Mapping):
        connections = [_printed(observer)]
    elif isinstance(observer, list) and observer and all(isinstance(one, Connection) for one in observer):
        connections = observer
    else:
        raise ParameterError(
            "a theorem of section 3.3 needs an InvariantObserver, or printed matrices {'S0': ..., 'S1': ..., "
            f"'J': ...}}, received {observer!r:.80}",
            field="observer",
        )
    k = connections[0].S1.shape[1]
    return connections, intervals(slopes, k) if k and slopes is not None else slopes


def _slopes_of(plant: Persidskii, slopes: Any, sloped: bool) -> Slopes:
    """The slopes of a plant's f, or those passed; raises ParameterError where f does not have them."""
    if slopes is None:
        return plant.slopes
    stated = intervals(slopes, plant.k)
    if sloped:
        require_slopes(nonlinearity(plant.f, plant.k, stated), plant.k, plant.r, plant.domain)
    return stated


def _printed(given: Mapping[str, Any]) -> Connection:
    if "S0" not in given or set(given) - {"S0", "S1", "J"}:
        raise ParameterError(
            f"printed matrices are S0 and, where f matters, S1 and J, received {', '.join(map(str, given))}",
            field="observer",
        )
    q = len(matrix("S0", given["S0"]))
    s0, s1 = matrix("S0", given["S0"], q, q), column("S1", given.get("S1"), q)
    j = row("J", given.get("J"), q)
    if len(j) != s1.shape[1]:
        raise ParameterError(
            f"J has {len(j)} rows, needs {s1.shape[1]}, one for each column of S1", field="J"
        )
    none = np.zeros((q, 0))
    return Connection(none, s0, s1, j, none, none, np.zeros((len(j), 0)), {}, True, none)
