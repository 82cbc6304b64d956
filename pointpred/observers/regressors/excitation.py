"""How much a recorded signal excites: definitions 1.3.12, 1.3.13 and 3.3.1 as measures."""

from __future__ import annotations

import msgspec
import numpy as np
from numpy.typing import ArrayLike

from pointpred.errors import ParameterError
from pointpred.records import FloatArray


class Excitation(msgspec.Struct, frozen=True):
    """The least eigenvalue over all windows, the window where it occurs, and its direction.

    ``level`` is mu of the definition over the record; ``at`` the start of the weakest window (s, or
    the index of its first sample); ``direction`` the least excited combination of the components there.
    """

    level: float
    at: float
    direction: tuple[float, ...]


def persistent_excitation(t: ArrayLike, signal: ArrayLike, window_s: float) -> Excitation:
    """The least excitation of a signal over all windows of a record.

    Assumes the signal linear between its samples, and describes the record only: later data may excite less.
    A level is in the square of the signal's unit times s, and grows with the window.

    mu = min over t of the least eigenvalue of the integral over [t, t + T] of phi phi' ds, for windows
    that start at the samples.

    Parameters: ``t`` s, increasing; ``signal`` of shape (samples, n), or (samples, p, n) for a regressor of
    p outputs, where phi phi' stands for D'D; ``window_s`` T, positive and within the record.
    Returns an ``Excitation``. Raises ParameterError.

    Reference: Khalin 2022, definition 1.3.12.

    >>> t = np.linspace(0.0, 20.0, 4001)
    >>> found = persistent_excitation(t, np.stack([np.ones_like(t), np.sin(t)], axis=1), 2 * np.pi)
    >>> round(found.level, 3)  # pi: the integral of sin^2 over a period
    3.142
    """
    times = increasing(t)
    starts, sums = _windows(times, products(len(times), signal, signal), _window(times, window_s))
    return _weakest(starts, sums)


def discrete_excitation(signal: ArrayLike, window: int) -> Excitation:
    """The least excitation of a sequence over all windows of so many samples.

    Assumes nothing between the samples, and describes the record only.

    mu = min over k of the least eigenvalue of the sum of phi_i phi_i' for i = k ... k + l - 1.

    Parameters: ``signal`` of shape (samples, n) or (samples, p, n); ``window`` l, from 1 to the number
    of samples. Returns an ``Excitation``. Raises ParameterError.

    Reference: Khalin 2022, definition 3.3.1.

    >>> discrete_excitation([[1.0, 0.0], [0.0, 2.0], [1.0, 0.0], [0.0, 2.0]], 2).level
    1.0
    >>> discrete_excitation([[1.0, 0.0], [0.0, 2.0], [1.0, 0.0], [0.0, 2.0]], 1).level
    0.0
    """
    phi = samples(signal, None)
    if isinstance(window, bool) or not isinstance(window, int) or not 1 <= window <= len(phi):
        raise ParameterError(
            f"window must be a whole number in [1, {len(phi)}], received {window!r}",
            field="window",
            value=window,
        )
    total = np.cumsum(np.einsum("kpi,kpj->kij", phi, phi), axis=0)
    total = np.concatenate([np.zeros_like(total[:1]), total])
    return _weakest(np.arange(len(phi) - window + 1.0), total[window:] - total[:-window])


def linear_independence(t: ArrayLike, first: ArrayLike, second: ArrayLike, window_s: float) -> float:
    """How far two signals are from linear dependence: 0 if one is a fixed combination of the other.

    Assumes both excited over every window, and describes the record and this window only: the definition
    needs some window, so a 0 for one window proves nothing.

    The regressions of each signal on the other over [t, t + T], (int phi phi')^-1 int phi psi', are
    compared from window to window; the result is the smaller of the two ranges of their entries,
    relative to the ratio of the signals' sizes.

    Parameters: ``t`` s, increasing; ``first`` of shape (samples, n), ``second`` of shape (samples, m);
    ``window_s`` T, positive and shorter than the record. Returns a number, 0 or more.
    Raises ParameterError, also if a signal is not excited over a window.

    Reference: Khalin 2022, definition 1.3.13.

    >>> t = np.linspace(0.0, 20.0, 2001)
    >>> both = np.stack([np.sin(t), np.cos(t)], axis=1)
    >>> linear_independence(t, both, 3.0 * np.sin(t)[:, None], 1.0) < 1e-9
    True
    >>> linear_independence(t, both, np.sin(2 * t)[:, None], 1.0) > 0.5
    True
    """
    times = increasing(t)
    window = _window(times, window_s)
    spreads = []
    for one, other in ((first, second), (second, first)):
        _, own = _windows(times, products(len(times), one, one), window)
        _, cross = _windows(times, products(len(times), one, other), window)
        values = np.linalg.eigvalsh(own)
        weakest = float((values[:, 0] / values[:, -1]).min()) if values[:, -1].min() > 0.0 else 0.0
        if weakest < 1e-12:
            raise ParameterError(
                f"both signals must be excited over every window of {window_s:g} s; the least excitation is "
                f"{weakest:.2g} of the largest: choose a longer window"
            )
        ratio = np.linalg.solve(own, cross)
        _, whole = _windows(times, products(len(times), other, other), window)
        usual = np.sqrt(np.trace(whole, axis1=1, axis2=2).mean() / np.trace(own, axis1=1, axis2=2).mean())
        spreads.append(float(np.ptp(ratio, axis=0).max() / usual))
    return min(spreads)


def increasing(t: ArrayLike) -> FloatArray:
    """Times as numbers; raises ParameterError unless there are two and they increase."""
    times = numbers("t", t)
    if times.ndim != 1 or len(times) < 2 or not np.isfinite(times).all() or np.diff(times).min() <= 0.0:
        raise ParameterError(
            f"t must be at least two finite, increasing times, received shape {times.shape}", field="t"
        )
    return times


def numbers(name: str, value: ArrayLike) -> FloatArray:
    """An array of any shape; raises ParameterError for what is no array of numbers."""
    try:
        return np.asarray(value, np.float64)
    except (TypeError, ValueError) as unusable:
        raise ParameterError(
            f"{name} must be an array of numbers, received {value!r:.80}", field=name, value=value
        ) from unusable


def samples(signal: ArrayLike, count: int | None) -> FloatArray:
    """A signal of shape (samples, p, n); raises ParameterError for any other or if not finite."""
    values = numbers("signal", signal)
    if values.ndim == 2:
        values = values[:, None, :]
    if values.ndim != 3 or values.size == 0 or (count is not None and len(values) != count):
        rows = "samples" if count is None else str(count)
        raise ParameterError(
            f"a signal needs shape ({rows}, n) or ({rows}, p, n), received {values.shape}", field="signal"
        )
    if not np.isfinite(values).all():
        raise ParameterError("a signal must be finite in every sample", field="signal")
    return values


def products(count: int, first: ArrayLike, second: ArrayLike) -> tuple[FloatArray, FloatArray]:
    """Both signals with as many samples as there are times and as many outputs as each other."""
    one, other = samples(first, count), samples(second, count)
    if one.shape[1] != other.shape[1]:
        raise ParameterError(
            f"both signals need as many outputs, received {one.shape[1]} and {other.shape[1]}"
        )
    return one, other


def _window(times: FloatArray, window_s: float) -> float:
    length = float(times[-1] - times[0])
    if isinstance(window_s, bool) or not isinstance(window_s, int | float) or not 0.0 < window_s <= length:
        raise ParameterError(
            f"window_s must lie in (0, {length:g}] s, the record, received {window_s!r}",
            field="window_s",
            value=window_s,
        )
    return float(window_s)


def _windows(
    times: FloatArray, pair: tuple[FloatArray, FloatArray], window: float
) -> tuple[FloatArray, FloatArray]:
    """Starts of all windows, and the integral of the product over each, exact for linear pieces."""
    one, other = pair
    total = np.zeros((len(times), one.shape[2], other.shape[2]))
    total[1:] = np.cumsum(_piece(np.diff(times), one[:-1], one[1:], other[:-1], other[1:]), axis=0)
    starts = times[: np.searchsorted(times, times[-1] - window, side="right")]
    if len(starts) == 0:  # rounding of a window as long as the record
        starts = times[:1]
    ends = np.minimum(starts + window, times[-1])
    before = np.clip(np.searchsorted(times, ends, side="right") - 1, 0, len(times) - 2)
    rest = ends - times[before]
    share = (rest / (times[before + 1] - times[before]))[:, None, None]
    one_end = one[before] + share * (one[before + 1] - one[before])
    other_end = other[before] + share * (other[before + 1] - other[before])
    tail = _piece(rest, one[before], one_end, other[before], other_end)
    return starts, total[before] + tail - total[: len(starts)]


def _piece(h: FloatArray, a: FloatArray, b: FloatArray, c: FloatArray, d: FloatArray) -> FloatArray:
    """The integral over h of the product of a line from a to b and a line from c to d."""
    outer = "kpi,kpj->kij"
    ends = np.einsum(outer, a, c) + np.einsum(outer, b, d)
    mixed = np.einsum(outer, a, d) + np.einsum(outer, b, c)
    return np.asarray(h[:, None, None] * (2.0 * ends + mixed) / 6.0)


def _weakest(starts: FloatArray, sums: FloatArray) -> Excitation:
    values, vectors = np.linalg.eigh(sums)
    worst = int(values[:, 0].argmin())
    level = max(float(values[worst, 0]), 0.0)
    return Excitation(level, float(starts[worst]), tuple(vectors[worst, :, 0].tolist()))
