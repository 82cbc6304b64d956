"""Nonlinearities of Persidskii systems, by name, which compiled stages can evaluate, or any function.

Whether slopes that a caller states are those of f is checked exactly for a name, by samples for a function.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import atan, cos, inf, pi, sin, tanh
from typing import Any, NamedTuple

import msgspec
import numpy as np

from pointpred.compiled import law
from pointpred.errors import ParameterError
from pointpred.records import FloatArray
from pointpred_observers.numerics.matrices import wrong

NARROWER = 1e-12
"""Slopes may be narrower than the true ones by this share, as when they were printed with all digits."""
SAMPLED = 1e-9
"""Differences of a function may violate its slopes by this share of its values."""
FARTHEST = 100.0
"""Without a domain a function is sampled up to here."""
SCALES = 9
"""At points of as many sizes, down to 1e-4 of the domain, one argument after the other is moved."""

IDENTITY, SIN, TANH, ATAN, SATURATION, CUBE = 0, 1, 2, 3, 4, 5
NAMED = dict(enumerate(("identity", "sin", "tanh", "atan", "saturation", "cube")))


@law
def value(code: float, s: float) -> float:
    """The nonlinearity with the given code at s."""
    if code == SIN:
        return sin(s)
    if code == TANH:
        return tanh(s)
    if code == ATAN:
        return atan(s)
    if code == SATURATION:
        return min(max(s, -1.0), 1.0)
    if code == CUBE:
        return s * s * s
    return s


def true_slopes(code: int, domain: float) -> tuple[float, float]:
    """The least and the largest slope of a named f within +-``domain``."""
    if code == SIN:
        return (cos(domain) if domain < pi else -1.0), 1.0
    if code == TANH:
        return 1.0 - tanh(domain) ** 2, 1.0
    if code == ATAN:
        return 1.0 / (1.0 + domain * domain), 1.0
    if code == SATURATION:
        return (1.0 if domain <= 1.0 else 0.0), 1.0
    if code == CUBE:
        return 0.0, 3.0 * domain * domain
    return 1.0, 1.0


class Known(NamedTuple):
    """A named nonlinearity: its code in compiled laws, and the bounds of its slope."""

    code: int
    low: float
    high: float


KNOWN = {name: Known(code, *true_slopes(code, inf)) for code, name in NAMED.items()}
"""What compiled stages can evaluate; ``cube`` has a bounded slope only where its argument is bounded."""


class Nonlinearity(msgspec.Struct, frozen=True):
    """The f of a Persidskii system, R^r to R^k; ``codes`` is ``None`` unless every component has a name."""

    function: Callable[[FloatArray], FloatArray]
    codes: tuple[int, ...] | None
    slopes: tuple[tuple[float, float], ...] | None
    """Bounds of each component's slope, ``None`` where f is not elementwise or they were not passed."""
    checked: float = 0.0
    """The largest domain within which the slopes were compared with f."""

    def __call__(self, s: Any) -> FloatArray:
        """The value at s."""
        return np.asarray(self.function(np.asarray(s, np.float64)), np.float64)


def nonlinearity(f: Any, count: int, slopes: Any = None) -> Nonlinearity:
    """The f of a name, of one name for each of ``count`` components, or of a function of the vector.

    Raises ParameterError for an unknown name and for slopes that are not intervals.
    """
    if isinstance(f, Nonlinearity):
        bounds = f.slopes if slopes is None else intervals(slopes, count)
        return msgspec.structs.replace(f, slopes=bounds, checked=f.checked if slopes is None else 0.0)
    bounds = None if slopes is None else intervals(slopes, count)
    if callable(f):
        return Nonlinearity(f, None, bounds)
    names = [f] * count if isinstance(f, str) else f
    if not isinstance(names, Sequence) or any(
        not isinstance(name, str) or name not in KNOWN for name in names
    ):
        raise wrong("f", f"must be a function or one of {', '.join(KNOWN)}", f)
    if len(names) != count:
        raise wrong("f", f"needs {count} components", f)
    parts = [KNOWN[name] for name in names]
    codes = tuple(part.code for part in parts)

    def function(s: FloatArray) -> FloatArray:
        return np.array([value(code, one) for code, one in zip(codes, s, strict=True)])

    return Nonlinearity(function, codes, bounds or tuple((part.low, part.high) for part in parts))


def same(one: Nonlinearity, other: Nonlinearity) -> bool:
    """Whether two are the same by their names, or the same Python function."""
    return one.codes == other.codes and (one.codes is not None or one.function is other.function)


def intervals(slopes: Any, count: int) -> tuple[tuple[float, float], ...]:
    """One (low, high) for each component; a single pair applies to all."""
    try:
        pairs = np.broadcast_to(np.array(slopes, np.float64), (count, 2))
    except (TypeError, ValueError, OverflowError) as unusable:
        raise wrong("slopes", f"must be (low, high) or {count} such pairs", slopes) from unusable
    if np.isnan(pairs).any() or (pairs[:, 0] > pairs[:, 1]).any():
        raise wrong("slopes", "need low <= high in each pair", slopes)
    return tuple((float(low), float(high)) for low, high in pairs)


def require_slopes(f: Nonlinearity, count: int, arguments: int, domain: float) -> None:
    """Raise ParameterError where f does not have the slopes that it is said to have within ``domain``.

    A function is sampled where all arguments are the same, and where one after the other moves.
    """
    where = "everywhere" if domain == inf else f"within {domain:g}"
    if f.codes is None:
        _require_samples(f, count, arguments, domain, where)
    for i, (code, (low, high)) in enumerate(zip(f.codes or (), f.slopes or (), strict=False)):
        least, most = true_slopes(code, domain)
        room = NARROWER * max(abs(least), abs(most)) if most < inf else 0.0
        if low > least + room or high < most - room:
            raise ParameterError(
                f"slopes of f, {NAMED[code]!r}, must hold {where}: its slopes there lie between {least:.6g} "
                f"and {most:.6g}, received ({low:.6g}, {high:.6g}) for component {i}; pass wider ones, or a "
                "smaller domain, the bound of abs(Hx)",
                field="slopes",
                value=f.slopes,
            )


def _require_samples(f: Nonlinearity, count: int, arguments: int, domain: float, where: str) -> None:
    if f.slopes is None:
        _values(f, np.zeros(arguments), count, finite=False)
        return
    reach = FARTHEST if domain == inf else domain
    positive = np.unique(np.concatenate([np.linspace(0.0, 1.0, 41), np.geomspace(1e-4, 1.0, 25)]))
    points = reach * np.concatenate([-positive[:0:-1], positive])
    values = np.array([_values(f, np.full(count, s), count) for s in points])
    steps = np.diff(points)[:, None]
    lows, highs = np.array(f.slopes).reshape(-1, 2).T
    change = np.diff(values, axis=0)
    room = SAMPLED * np.abs(change) + NARROWER * (np.abs(values[1:]) + np.abs(values[:-1]))
    outside = (change < lows * steps - room) | (change > highs * steps + room)
    if outside.any():
        i, one = map(int, np.argwhere(outside)[0])
        raise ParameterError(
            f"slopes of f must hold {where}: between {points[i]:.6g} and {points[i + 1]:.6g} component {one} "
            f"rises by {change[i, one] / steps[i, 0]:.6g} per unit, received ({lows[one]:.6g}, "
            f"{highs[one]:.6g}); pass wider slopes, or a smaller domain, the bound of abs(Hx)",
            field="slopes",
            value=f.slopes,
        )
    if count > 1:
        _require_elementwise(f, count, reach)


def _require_elementwise(f: Nonlinearity, count: int, reach: float) -> None:
    """Raise ParameterError where a component changes with another's argument: corners would prove nothing."""
    rng = np.random.default_rng(0)
    for scale in reach * np.geomspace(1.0, 1e-4, SCALES):
        here, there = scale * rng.uniform(-1.0, 1.0, (2, count))
        before = _values(f, here, count)
        for i in range(count):
            moved = here.copy()
            moved[i] = there[i]
            after = _values(f, moved, count)
            mixed = np.abs(after - before) > NARROWER * (np.abs(after) + np.abs(before))
            mixed[i] = False
            if mixed.any():
                one = np.flatnonzero(mixed)[0]
                raise ParameterError(
                    f"f must be elementwise where slopes are given: component {one} may depend upon argument "
                    f"{one} only, but changes as argument {i} moves from {here[i]:.6g} to {moved[i]:.6g}; "
                    "put the mixture into H, A1 and C1, or leave out slopes",
                    field="f",
                )


def _values(f: Nonlinearity, s: FloatArray, count: int, *, finite: bool = True) -> FloatArray:
    """The values of f at s; raises ParameterError unless they are as many numbers."""
    needed = f"f must return {count} finite numbers for {len(s)} arguments"
    shown = s[:1] if (s == s[:1]).all() else s
    place = f"at arguments of {', '.join(f'{one:.6g}' for one in shown)}"
    try:
        with np.errstate(all="ignore"):
            received = np.asarray(f.function(s.copy()))
            if np.iscomplexobj(received):
                raise TypeError("its values are complex")
            values = np.asarray(received, np.float64)
    except (ArithmeticError, TypeError, ValueError, IndexError) as failure:
        if isinstance(failure, ArithmeticError) and not finite:
            return np.zeros(count)  # f need not be defined at 0 where nothing is said of its slopes
        raise ParameterError(f"{needed}; {place} it fails: {failure}", field="f") from failure
    if values.shape != (count,):
        shapes = f"the shape {values.shape}, need ({count},)"
        raise ParameterError(f"{needed}; {place} its values have {shapes}", field="f")
    if finite and not np.isfinite(values).all():
        raise ParameterError(f"{needed}; {place} it returns {values.tolist()}", field="f", value=s.tolist())
    return values
