"""Transfer functions as polynomials, and the averaged gain of any function."""

from __future__ import annotations

from collections.abc import Sequence
from math import inf, isfinite, isnan
from typing import Self

import msgspec
import numpy as np

from pointpred.errors import ParameterError, RecordingError
from pointpred.transfer.functions import (
    BOUNDED,
    BOUNDED_COEFFICIENTS,
    COEFFICIENTS_MOST,
    POLYNOMIAL,
    SlotsFunction,
    TransferFunction,
)

NODES = 4096


class _Saved(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A polynomial as JSON."""

    version: int
    coefficients: tuple[float, ...]
    speed_low: float
    speed_high: float | None


class PolynomialFunction(SlotsFunction):
    """PTF(V) = c_0 + c_1 V + ... + c_q V^q, with V and PTF in m/s.

    Valid only where it was identified: outside ``speed_low`` ... ``speed_high`` it may take any value. A gain
    needs c_0 = 0; with another c_0 it is infinite at V = 0. Corners of a function are rounded.

    Parameters: ``coefficients`` c_0 ... c_q, one to seven finite numbers; ``speed_low``, ``speed_high`` in
    m/s, the range it was identified in. Memory: 8 floats, never changed. Raises ParameterError.
    Reference: Khalin 2022, section 2.4.1.

    >>> function = PolynomialFunction([0.0, 1.0, 10.0])
    >>> [round(float(g), 6) for g in function.gain([0.0, 0.1])]
    [1.0, 2.0]
    >>> PolynomialFunction.from_json(function.to_json()).coefficients
    (0.0, 1.0, 10.0)
    """

    def __init__(
        self, coefficients: Sequence[float], *, speed_low: float = 0.0, speed_high: float = inf
    ) -> None:
        self.coefficients = tuple(float(c) for c in coefficients)
        if not 1 <= len(self.coefficients) <= COEFFICIENTS_MOST or not all(map(isfinite, self.coefficients)):
            raise ParameterError(
                f"coefficients must be 1 to {COEFFICIENTS_MOST} finite numbers, received {coefficients!r}",
                field="coefficients",
                value=coefficients,
            )
        if isnan(speed_high) or not 0.0 <= speed_low < speed_high:
            raise ParameterError(
                f"speed_low must lie in [0, speed_high) m/s, received {speed_low!r} and {speed_high!r}",
                field="speed_low",
                value=speed_low,
            )
        self.speed_low, self.speed_high = float(speed_low), float(speed_high)
        super().__init__(POLYNOMIAL, list(self.coefficients))

    def to_json(self) -> str:
        """The function as JSON text; an unbounded range has ``speed_high`` null."""
        high = self.speed_high if self.speed_high < inf else None
        return msgspec.json.encode(_Saved(1, self.coefficients, self.speed_low, high)).decode()

    @classmethod
    def from_json(cls, text: str | bytes) -> Self:
        """The function that ``to_json`` wrote; raises RecordingError for any other text."""
        try:
            saved = msgspec.json.decode(text, type=_Saved)
        except msgspec.DecodeError as error:
            raise RecordingError(f"not a saved transfer function: {error}") from error
        if saved.version != 1:
            raise RecordingError(f"saved transfer function: version must be 1, received {saved.version}")
        high = inf if saved.speed_high is None else saved.speed_high
        return cls(saved.coefficients, speed_low=saved.speed_low, speed_high=high)


class HeldPolynomial(SlotsFunction):
    """An identified polynomial made safe for moving a cursor: its gain is constant beyond both ends.

    Assumes that the range is the one in which the polynomial was identified: outside it a polynomial of
    order 5 soon moves the cursor backwards. The constant ends are a safe guess.

    PTF(V) = gain(V) V, gain(V) = c_1 + c_2 U + ... + c_5 U^4, U = V clipped to ``speed_low`` and
    ``speed_high``.

    Parameters: ``polynomial`` of order 5 at most, without c_0, with a bounded range.
    Memory: 8 floats, never changed. Raises ParameterError.

    >>> held = HeldPolynomial(PolynomialFunction([0.0, 1.0, 10.0], speed_low=0.1, speed_high=0.2))
    >>> [round(float(g), 6) for g in held.gain([0.0, 0.15, 5.0])]
    [2.0, 2.5, 3.0]
    """

    def __init__(self, polynomial: PolynomialFunction) -> None:
        offset, *rest = polynomial.coefficients
        if offset != 0.0 or len(rest) > BOUNDED_COEFFICIENTS or not rest:
            raise ParameterError(
                f"polynomial must have c_0 = 0 and order 1 to {BOUNDED_COEFFICIENTS}, received "
                f"{polynomial.coefficients!r}",
                field="polynomial",
                value=polynomial.coefficients,
            )
        if polynomial.speed_high == inf:
            raise ParameterError(
                "polynomial needs the range it was identified in, received no speed_high", field="polynomial"
            )
        self.polynomial = polynomial
        self.speed_low, self.speed_high = polynomial.speed_low, polynomial.speed_high
        numbers = [*rest, *[0.0] * (BOUNDED_COEFFICIENTS - len(rest)), self.speed_low, self.speed_high]
        super().__init__(BOUNDED, numbers)


def averaged_gain(function: TransferFunction, speed_max_m_s: float) -> float:
    """The gain c of a whole ballistic movement: the cursor's displacement over the hand's.

    Assumes the ballistic profile V = Vmax sin(phi) of section 2.4.2. Corrects the printed
    c = (1 / Vmax) int PTF(s) ds, which has the dimension of a speed:

    c = 1 / (2 Vmax) int_0^pi PTF(Vmax sin phi) dphi.

    ``speed_max_m_s`` is the peak speed of the hand, above 0. Raises ParameterError.
    Reference: Khalin 2022, section 2.4.2, corrected.

    >>> from pointpred.transfer import ConstantGain, SigmoidGain
    >>> round(averaged_gain(ConstantGain(4.0), 0.2), 6)
    4.0
    >>> round(averaged_gain(SigmoidGain(), 0.1), 2), round(averaged_gain(SigmoidGain(), 0.3), 2)
    (1.78, 5.73)
    """
    if not 0.0 < speed_max_m_s < inf:
        raise ParameterError(
            f"speed_max_m_s must lie in (0, inf) m/s, received {speed_max_m_s!r}",
            field="speed_max_m_s",
            value=speed_max_m_s,
        )
    middles = (np.arange(NODES) + 0.5) * (np.pi / NODES)
    speeds = function.cursor_speed(speed_max_m_s * np.sin(middles))
    return float(np.mean(speeds)) * np.pi / (2.0 * speed_max_m_s)
