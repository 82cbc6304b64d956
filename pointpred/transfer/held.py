"""An identified polynomial made safe to move a cursor with: beyond its range the gain stays what it was."""

from __future__ import annotations

from math import inf

from pointpred.errors import ParameterError
from pointpred.transfer.known import HELD, HELD_COEFFICIENTS, SlotsFunction
from pointpred.transfer.polynomial import PolynomialFunction


class HeldPolynomial(SlotsFunction):
    """PTF(V) = gain(V) V, the gain a polynomial within its range and constant beyond both ends.

    Assumes that the range is the one in which the polynomial was identified: outside it a polynomial of
    order 5 soon moves the cursor backwards. The constant ends are a guess, but a tame one.

    gain(V) = c_1 + c_2 U + ... + c_5 U^4, U = V held between ``speed_low`` and ``speed_high``.

    Parameters: ``polynomial`` of order 5 at most, without c_0, with a bounded range.
    Memory: 8 floats, never changed. Raises ParameterError.

    >>> held = HeldPolynomial(PolynomialFunction([0.0, 1.0, 10.0], speed_low=0.1, speed_high=0.2))
    >>> [round(float(g), 6) for g in held.gain([0.0, 0.15, 5.0])]
    [2.0, 2.5, 3.0]
    """

    def __init__(self, polynomial: PolynomialFunction) -> None:
        offset, *rest = polynomial.coefficients
        if offset != 0.0 or len(rest) > HELD_COEFFICIENTS or not rest:
            raise ParameterError(
                f"polynomial must have c_0 = 0 and order 1 to {HELD_COEFFICIENTS}, received "
                f"{polynomial.coefficients!r}"
            )
        if polynomial.speed_high == inf:
            raise ParameterError("polynomial needs the range it was identified in, received no speed_high")
        self.polynomial = polynomial
        self.speed_low, self.speed_high = polynomial.speed_low, polynomial.speed_high
        numbers = [*rest, *[0.0] * (HELD_COEFFICIENTS - len(rest)), self.speed_low, self.speed_high]
        super().__init__(HELD, numbers)
