"""Coordinates in which the entries of an observer's error equation are near 1, whatever units it came in."""

from __future__ import annotations

from typing import Any, NamedTuple

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.errors import ParameterError
from pointpred.records import FloatArray

STEPS_MOST = 200
MUTUAL = float(np.log(1e-2))
"""The logarithm of a product of entries there and back above which two parts are one."""
STEP_MOST = 4.0
"""Largest change of the logarithm of an entry in one step."""


class Coordinates(msgspec.Struct, frozen=True):
    """The units of the balanced equation, each in the user's: e = ``states`` e~, t = ``seconds`` t~.

    ``states`` of the error (q), ``outputs`` (p), ``values`` of f (k), ``arguments`` of f (r), and the unit of
    time, ``seconds``, 1 in discrete time.
    """

    states: FloatArray
    outputs: FloatArray
    values: FloatArray
    arguments: FloatArray
    seconds: float

    @property
    def plain(self) -> Coordinates:
        """The user's units, and this unit of time."""
        given = (self.states, self.outputs, self.values, self.arguments)
        states, outputs, values, arguments = (np.ones(len(one)) for one in given)
        return Coordinates(states, outputs, values, arguments, self.seconds)

    def slopes(
        self, slopes: tuple[tuple[float, float], ...] | None
    ) -> tuple[tuple[float, float], ...] | None:
        """The slopes of f in the balanced units."""
        if slopes is None:
            return None
        shares = self.arguments / self.values
        return tuple(
            (float(low * one), float(high * one)) for (low, high), one in zip(slopes, shares, strict=True)
        )


def inward(matrix: Any, rows: FloatArray, columns: FloatArray, unit: float = 1.0) -> FloatArray:
    """A matrix of the user's in balanced units: its rows have the units ``rows``, and it acts on ``columns``.

    ``unit`` is what else it is multiplied by: the unit of time for a matrix in 1/s.
    """
    entries: FloatArray = unit * np.asarray(matrix, np.float64) * columns / rows[:, None]
    return entries


def outward(matrix: Any, rows: FloatArray, columns: FloatArray, unit: float = 1.0) -> FloatArray:
    """The inverse of ``inward``."""
    entries: FloatArray = np.asarray(matrix, np.float64) * rows[:, None] / columns / unit
    return entries


def balanced(
    drift: Any,
    *,
    seen: Any = None,
    driven: Any = None,
    shown: Any = None,
    inner: Any = None,
    moved: Any = None,
    slopes: tuple[tuple[float, float], ...] | None = None,
    rates: tuple[float, ...] = (),
    time: str = "continuous",
    plain: bool = False,
) -> Coordinates:
    """The coordinates in which e' = ``drift`` e + ``driven`` df, dy = ``seen`` e + ``shown`` df is balanced.

    df = f(s + ``inner`` e) - f(s). Each argument may be a stack of matrices, of which the largest entries
    count. ``rates`` in 1/s, such as a required decay, are entries as well.

    Minimises the sum of m - log m over the entries m other than 0 (their distance from 1 after Itakura and
    Saito) over all positive units: convex in their logarithms, with a unique minimum also for a reducible
    matrix, whatever units were given. Units that no entry depends on stay as near to 1 as possible.

    Each output has the states that it shows best, by the largest entries in the user's units. An entry
    between states of different outputs counts only where these act on each other, or where it lies above 1
    otherwise: a weak coupling of two plants would else move their units apart, and the gains with them.
    ``moved``, the matrix of inputs, does the same for a feedback; its own entries are not balanced.

    In discrete time the unit of time is the step. There, and if ``plain``, f and its arguments keep theirs:
    theorems 3.3.2 and 3.2.3 weigh all components of f alike.

    Reference: Osborne 1960 minimises the sum of m^2, which has no minimum for a reducible matrix.

    >>> slow = balanced([[0.0, 1e-3], [-1e-9, -1e-6]], seen=[[1e3, 0.0]])
    >>> fast = balanced([[0.0, 1.0], [-1.0, -1.0]], seen=[[1.0, 0.0]])
    >>> bool(np.isclose(slow.seconds / fast.seconds, 1e6))
    True
    """
    a = _largest(drift)
    n = len(a)
    c, d = _largest(seen, None, n), _largest(driven, n, None)
    h = _largest(inner, None, n)
    p, k, r = len(c), d.shape[1], len(h)
    spread = np.zeros((r, k))
    if slopes is not None and r == k:
        spread = np.diag([max(abs(low), abs(high)) for low, high in slopes])
    x, y, value, argument, clock = 0, n, n + p, n + p + k, n + p + k + r
    ticks = time == "continuous"
    fixed = slice(value, clock) if plain or not ticks else slice(0, 0)
    speeds = [(np.array([[max(one, 0.0)]]), 0, 0, True) for one in rates if ticks]
    entries = _Entries([], [], [])
    for sizes, row, column, timed in (
        (a, x, x, ticks),
        (c, y, x, False),
        (d, x, value, ticks),
        (_largest(shown, p, k), y, value, False),
        (h, argument, x, False),
        (spread, value, argument, False),
        *speeds,
    ):
        for i, j in np.argwhere(sizes).tolist():
            on = np.zeros(clock + 1)
            on[row + i] -= 1.0
            on[column + j] += 1.0
            on[clock] += float(timed)
            on[fixed] = 0.0
            entries.rows.append(on)
            entries.logs.append(float(np.log(sizes[i, j])))
            entries.places.append((row + i, column + j))
    parts = np.zeros(clock, np.int64)
    if p:
        parts = entries.parts(clock, [(y + i, x + j, c[i, j]) for i, j in np.argwhere(c)])
    elif moved is not None:
        b = _largest(moved, n, None)
        # An input is not among the units: it counts as a node behind them.
        parts = entries.parts(clock, [(clock + i, x + j, b[j, i]) for j, i in np.argwhere(b)], onward=True)
    units = np.exp(entries.apart(parts, clock + 1))
    return Coordinates(
        units[x:y], units[y:value], units[value:argument], units[argument:clock], float(units[clock])
    )


class _Entries(NamedTuple):
    """The logarithms of the entries, affine in the logarithms of the units."""

    rows: list[FloatArray]
    """What each unit adds."""
    logs: list[float]
    places: list[tuple[int, int]]
    """The units of its row and of its column, by entry."""

    def parts(
        self, count: int, ends: list[tuple[int, int, float]], *, onward: bool = False
    ) -> NDArray[np.int64]:
        """For each of ``count`` units the number of the end that shows it best, 0 where none does.

        ``ends``: the unit of an output (an input if ``onward``), that of a state, and the size of the entry.
        Each end has the state of its largest entry; ends with the same state are one. From there the largest
        entry that leads on is taken next, rates in units of the fastest.
        """
        rates, logs = np.array([one[-1] for one in self.rows]), np.array(self.logs)
        fastest = logs[rates > 0.0].max(initial=-np.inf)
        sizes = np.exp(np.where(rates > 0.0, logs - fastest, logs)).tolist()
        labels = dict[int, int]()
        for end in {one[0] for one in ends}:
            state = max((one for one in ends if one[0] == end), key=lambda one: one[2])[1]
            labels[end] = labels.setdefault(state, end + 1)
        links = [(size, end, state) for end, state, size in ends]
        for size, (row, column) in zip(sizes, self.places, strict=True):
            links.append((size, column, row) if onward else (size, row, column))
        links.sort(reverse=True)
        while True:
            onto = (one[1:] for one in links if one[1] in labels and one[2] not in labels)
            against = (one[:0:-1] for one in links if one[2] in labels and one[1] not in labels)
            found = next(onto, None) or next(against, None)
            if found is None:
                return np.array([labels.get(i, 0) for i in range(count)], np.int64)
            labels[found[1]] = labels[found[0]]

    def apart(self, parts: NDArray[np.int64], units: int) -> FloatArray:
        """The least logarithms, where an entry between two parts counts only if they need it.

        They do if the largest entries one way and the other have a product that is not small, which no unit
        changes, or if the entry lies above 1 without.
        """
        ends = [(int(parts[i]), int(parts[j])) for i, j in self.places]
        kept = np.array([one == other for one, other in ends], bool)
        matrix, start = np.array(self.rows).reshape(-1, units), np.array(self.logs)
        logs = start + matrix @ _least(matrix, start, kept)
        largest = dict[tuple[int, int], float]()
        for pair, size in zip(ends, logs, strict=True):
            largest[pair] = max(float(size), largest.get(pair, -np.inf))
        both = [largest[pair] + largest.get(pair[::-1], -np.inf) > MUTUAL for pair in ends]
        kept |= np.array(both, bool)
        while True:
            found = _least(matrix, start, kept)
            above = ~kept & (start + matrix @ found > 0.0)
            if not above.any():
                return found
            kept |= above


def _least(rows: FloatArray, logs: FloatArray, kept: NDArray[np.bool_]) -> FloatArray:
    """The logarithms of the units at the minimum over the entries ``kept``, by damped Newton steps.

    Raises ParameterError where the numbers leave no direction to go on.
    """
    if not kept.any():
        return np.zeros(rows.shape[1])
    matrix, start = rows[kept], logs[kept]
    _, sizes, turned = np.linalg.svd(matrix, full_matrices=False)
    moving = turned[sizes > 1e-9 * sizes[0]].T
    if not moving.size:  # no unit changes an entry, as with one state in discrete time
        return np.zeros(rows.shape[1])
    slopes = matrix @ moving
    at = np.linalg.lstsq(slopes, -start, rcond=None)[0]
    for _ in range(STEPS_MOST):
        now = start + slopes @ at
        m = np.exp(now)
        gradient = slopes.T @ (m - 1.0)
        if np.abs(gradient).max() < 1e-12 * len(m):
            break
        # The second term keeps the step finite where every entry along a direction is tiny.
        curvature = slopes.T @ (slopes * m[:, None]) + 1e-12 * np.eye(len(at))
        try:
            step = np.linalg.solve(curvature, -gradient)
        except np.linalg.LinAlgError as failure:
            raise ParameterError(
                "the entries of the matrices and the decay lie too many powers of ten apart to compute with: "
                "check the units of the largest and of the smallest"
            ) from failure
        change = slopes @ step
        share = min(1.0, STEP_MOST / max(float(np.abs(change).max()), 1e-300))
        while share > 1e-12 and (np.exp(now + share * change) - now - share * change).sum() > (m - now).sum():
            share *= 0.5
        at = at + share * step
    return np.asarray(moving @ at, np.float64)


def _largest(given: Any, rows: int | None = None, columns: int | None = None) -> FloatArray:
    """The largest sizes of the entries of a matrix, or of a stack of them; ``None`` is a matrix of zeros."""
    if given is None:
        return np.zeros((rows or 0, columns or 0))
    entries = np.abs(np.asarray(given, np.float64))
    leading = tuple(range(entries.ndim - 2))
    return np.asarray(entries.max(axis=leading, initial=0.0), np.float64)
