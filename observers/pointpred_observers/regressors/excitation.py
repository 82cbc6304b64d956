"""What a record allows a regressor: definitions 1.3.12, 1.3.13 and 3.3.1, and Theorem 3.3.3, as measures."""

from __future__ import annotations

import msgspec
import numpy as np
from numpy.typing import ArrayLike

from pointpred.errors import ParameterError, UndecidedError
from pointpred.parameter import is_number
from pointpred.records import FloatArray
from pointpred_observers.numerics.matrices import TIMES, matrix, one_of, positive, vector, wrong

PASSES_MOST = 200
"""Most passes over a record in which P of Theorem 3.3.3 must settle."""


class Excitation(msgspec.Struct, frozen=True):
    """The least eigenvalue over all windows, the window where it occurs, and its direction.

    ``level`` is mu of the definition over the record; ``at`` the start of the weakest window (s, or
    the index of its first sample); ``direction`` the least excited combination of the components there.
    """

    level: float
    at: float
    direction: tuple[float, ...]


def persistent_excitation(
    t: ArrayLike | None, signal: ArrayLike, window: float, *, time: str = "continuous"
) -> Excitation:
    """The least excitation of a signal over all windows of a record.

    Assumes the signal linear between its samples, in discrete time nothing, and describes the record only:
    later data may excite less. A level is in the square of the signal's unit times s, in discrete time
    without s.

    mu = min over t of the least eigenvalue of the integral over [t, t + T] of phi phi' ds, for windows
    that start at the samples; in discrete time of the sum of l samples.

    Parameters: ``t`` s, increasing, ``None`` in discrete time; ``signal`` of shape (samples, n), or
    (samples, p, n) for a regressor of p outputs, where phi phi' stands for D'D; ``window`` T in s, within
    the record, in discrete time l, from 1 to the number of samples. Raises ParameterError.

    Reference: Khalin 2022, definitions 1.3.12 and 3.3.1.

    >>> t = np.linspace(0.0, 20.0, 4001)
    >>> found = persistent_excitation(t, np.stack([np.ones_like(t), np.sin(t)], axis=1), 2 * np.pi)
    >>> round(found.level, 3)  # pi: the integral of sin^2 over a period
    3.142
    >>> turns = [[1.0, 0.0], [0.0, 2.0], [1.0, 0.0], [0.0, 2.0]]
    >>> [persistent_excitation(None, turns, l, time="discrete").level for l in (1, 2)]
    [0.0, 1.0]
    """
    if one_of("time", time, TIMES) == "continuous":
        times = _increasing(t)
        phi = _samples(signal, len(times))
        starts, sums = _windows(times, phi, phi, _within(times, window))
    else:
        phi = _samples(signal)
        if isinstance(window, bool) or not isinstance(window, int) or not 1 <= window <= len(phi):
            raise wrong("window", f"must be a whole number in [1, {len(phi)}]", window)
        total = np.zeros((len(phi) + 1, *phi.shape[2:] * 2))
        total[1:] = np.cumsum(np.einsum("kpi,kpj->kij", phi, phi), axis=0)
        starts, sums = np.arange(len(phi) - window + 1.0), total[window:] - total[:-window]
    values, vectors = np.linalg.eigh(sums)
    worst = int(values[:, 0].argmin())
    level = max(float(values[worst, 0]), 0.0)
    return Excitation(level, float(starts[worst]), tuple(vectors[worst, :, 0].tolist()))


def linear_independence(t: ArrayLike, first: ArrayLike, second: ArrayLike, window_s: float) -> float:
    """How far two signals are from linear dependence: 0 if one is a fixed combination of the other.

    Assumes both excited over every window. The regressions of each signal on the other over [t, t + T],
    (int phi phi')^-1 int phi psi', are compared from window to window; the result is the smaller of the two
    ranges of their entries, relative to the ratio of the signals' sizes. It describes this window only:
    the definition needs some window, so a 0 for one proves nothing.

    Parameters: ``t`` s, increasing; ``first`` of shape (samples, n), ``second`` of shape (samples, m);
    ``window_s`` T, within the record. Raises ParameterError, also if a signal is not excited over a window.

    Reference: Khalin 2022, definition 1.3.13.

    >>> t = np.linspace(0.0, 20.0, 2001)
    >>> both = np.stack([np.sin(t), np.cos(t)], axis=1)
    >>> linear_independence(t, both, 3.0 * np.sin(t)[:, None], 1.0) < 1e-9
    True
    >>> linear_independence(t, both, np.sin(2 * t)[:, None], 1.0) > 0.5
    True
    """
    times = _increasing(t)
    window = _within(times, window_s)
    pair = _samples(first, len(times)), _samples(second, len(times))
    if pair[0].shape[1] != pair[1].shape[1]:
        raise ParameterError(
            f"both signals need as many outputs, received {pair[0].shape[1]} and {pair[1].shape[1]}"
        )
    spreads = []
    for one, other in (pair, pair[::-1]):
        products = ((one, one), (one, other), (other, other))
        own, cross, whole = (_windows(times, *two, window)[1] for two in products)
        values = np.linalg.eigvalsh(own)
        weakest = float((values[:, 0] / values[:, -1]).min()) if values[:, -1].min() > 0.0 else 0.0
        if weakest < 1e-12:
            raise ParameterError(
                f"both signals must be excited over every window of {window_s:g} s, the least excitation is "
                f"{weakest:.2g} of the largest: choose a longer window"
            )
        ratio = np.linalg.solve(own, cross)
        usual = np.sqrt(np.trace(whole, axis1=1, axis2=2).mean() / np.trace(own, axis1=1, axis2=2).mean())
        spreads.append(float(np.ptp(ratio, axis=0).max() / usual))
    return min(spreads)


class RegressionMargin(msgspec.Struct, frozen=True):
    """The least ``margin`` of Theorem 3.3.3 over the record, the time ``at`` which it occurs, and P there.

    With a positive margin V = e'Pe decreases by at least 2 margin abs(e)^2.
    """

    margin: float
    at: float
    P: FloatArray


def regression_margin(
    t: ArrayLike, regressor: ArrayLike, weight: ArrayLike, gain: float, *, flattest: float = 0.0
) -> RegressionMargin:
    """The margin of Theorem 3.3.3 on a record of J and D1 that repeats periodically.

    Assumes f with slopes between ``flattest`` and 1, and J, D1 constant within a sample's interval.
    The theorem shows asymptotic stability, not the input-to-state stability that it claims.

    P' = g (P J'J + J'J P) - I, solved backwards; with f(Jw) - f(Jz) = s J e the condition
    -g D1 e'P J'(f(Jw) - f(Jz) - J e) < e'e / 2 is g D1 (1 - s) max eig sym(P J'J) < 1/2 at the flattest s.

    Parameters: ``t`` s, increasing; ``regressor`` (samples, n) or (samples, r, n); ``weight`` D1 in [0, 1];
    ``gain`` g > 0; ``flattest`` in [0, 1]. Raises ParameterError; UndecidedError if P does not converge, as
    without excitation.

    Reference: Khalin 2022, (3.52), Theorem 3.3.3.

    >>> t = np.linspace(0.0, 2 * np.pi, 200)
    >>> j = np.stack([np.cos(t), np.sin(t)], axis=1)
    >>> round(regression_margin(t, j, np.full(200, 0.2), 1.0).margin, 3)
    0.288
    """
    times = _increasing(t)
    j = _samples(regressor, len(times))
    d1 = vector("weight", weight, len(times))
    gain, flattest = positive("gain", gain), positive("flattest", flattest, zero=True)
    for name, shares in (("weight", d1), ("flattest", np.array([flattest]))):
        if not ((shares >= 0.0) & (shares <= 1.0)).all():
            raise wrong(name, "must lie in [0, 1]", shares.tolist())
    squares = np.einsum("kri,krj->kij", j, j)
    middle, h = 0.5 * (squares[:-1] + squares[1:]), np.diff(times)
    values, vectors = np.linalg.eigh(middle)
    rate = gain * np.maximum(values, 0.0) * h[:, None]
    fade = np.einsum("kia,ka,kja->kij", vectors, np.exp(-rate), vectors)
    twice = 2.0 * np.maximum(rate, 1e-300)
    share = -np.expm1(-twice) / twice  # (1 - exp(-x)) / x, 1 at 0
    gained = np.einsum("kia,ka,kja->kij", vectors, share * h[:, None], vectors)
    p = np.zeros(squares.shape[1:])
    for _ in range(PASSES_MOST):
        first, backwards = p, []
        for forget, new in zip(fade[::-1], gained[::-1], strict=True):
            p = new + forget @ p @ forget
            backwards.append(p)
        last = float(np.abs(p - first).max()) / float(np.abs(p).max())
        if last < 1e-9:
            break
    else:
        raise UndecidedError(
            f"P still changes by {last:.2g} of itself after {PASSES_MOST} passes: no excitation?"
        )
    forms = np.array(backwards[::-1])
    product = forms @ squares[:-1]
    worst = np.linalg.eigvalsh(0.5 * (product + np.swapaxes(product, 1, 2)))[:, -1]
    margins = 0.5 - gain * (1.0 - flattest) * d1[:-1] * worst
    k = int(margins.argmin())
    return RegressionMargin(float(margins[k]), float(times[k]), forms[k])


def _increasing(t: ArrayLike | None) -> FloatArray:
    """Times as numbers; raises ParameterError unless there are two and they increase."""
    times: FloatArray = matrix("t", t, 1)[0]
    if len(times) < 2 or np.diff(times).min() <= 0.0:
        raise ParameterError(f"t must be at least two increasing times, received {t!r:.80}", field="t")
    return times


def _samples(signal: ArrayLike, count: int | None = None) -> FloatArray:
    """A signal of shape (samples, p, n); raises ParameterError for any other or if not finite."""
    try:
        values = np.asarray(signal, np.float64)
    except (TypeError, ValueError, OverflowError) as unusable:
        raise ParameterError(
            f"a signal must be numbers, received {signal!r:.80}", field="signal"
        ) from unusable
    values = values[:, None, :] if values.ndim == 2 else values
    if (
        values.ndim != 3
        or not values.size
        or count not in (None, len(values))
        or not np.isfinite(values).all()
    ):
        rows = "samples" if count is None else str(count)
        raise ParameterError(
            f"a signal must be finite, of shape ({rows}, n) or ({rows}, p, n), received {values.shape}",
            field="signal",
        )
    return values


def _within(times: FloatArray, window: float) -> float:
    """The window; raises ParameterError for one that is not within the record."""
    length = float(times[-1] - times[0])
    if not is_number(window) or not 0.0 < window <= length:
        raise wrong("window", f"must lie in (0, {length:g}] s, the record", window)
    return float(window)


def _windows(
    times: FloatArray, one: FloatArray, other: FloatArray, window: float
) -> tuple[FloatArray, FloatArray]:
    """Starts of all windows, and the integral of the product over each, exact for linear pieces."""
    from scipy.interpolate import make_interp_spline

    starts = times[: max(1, np.searchsorted(times, times[-1] - window, side="right"))]
    ends = np.minimum(starts + window, times[-1])
    grid = np.union1d(times, ends)
    a, b = (make_interp_spline(times, signal, k=1)(grid) for signal in (one, other))
    # The product of two lines is integrated exactly by Simpson's rule.
    outer = "kpi,kpj->kij"
    knots, middles = np.einsum(outer, a, b), np.einsum(outer, a[:-1] + a[1:], b[:-1] + b[1:])
    total = np.zeros(knots.shape)
    total[1:] = np.cumsum(np.diff(grid)[:, None, None] * (knots[:-1] + middles + knots[1:]) / 6.0, axis=0)
    return starts, total[np.searchsorted(grid, ends)] - total[np.searchsorted(grid, starts)]
