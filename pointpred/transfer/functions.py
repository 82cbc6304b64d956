"""Pointing transfer functions (PTF): from the speed of the hand to the speed of the cursor.

A function is a kind and its numbers, a ``Function`` within any memory, so that one compiled law (a simulated
loop, pixels) works with all of them.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import atan, copysign, inf, isfinite, isnan
from typing import Annotated, ClassVar, Protocol, Self, runtime_checkable

import msgspec
import numpy as np
from numpy.typing import ArrayLike

from pointpred.compiled import law
from pointpred.errors import EventError, ParameterError, RecordingError
from pointpred.layout import Layout
from pointpred.parameter import Parameter
from pointpred.records import FloatArray

CONSTANT, SIGMOID, ARCTAN, POLYNOMIAL, BOUNDED = 1.0, 2.0, 3.0, 4.0, 5.0
COEFFICIENTS_MOST = 7
BOUNDED_COEFFICIENTS = 5
MACOS = (1.0, 15.0, 0.05, 0.6)
"""The numbers of a sigmoid function that is like that of macOS."""


class Function(Layout):
    """A kind and its numbers, then zeros.

    CONSTANT: the gain. SIGMOID: the gains of slow and of fast movements, and the speeds in m/s. POLYNOMIAL:
    c_0 ... c_6. BOUNDED: c_1 ... c_5, then the range in m/s outside which the gain is constant.
    """

    kind: float
    numbers: Annotated[FloatArray, COEFFICIENTS_MOST]


SLOTS = Function.length


@law
def gain(f: Function, speed: float) -> float:
    """PTF(V) / V, the control-display gain; at V = 0 its limit (infinite for a polynomial with c_0)."""
    if f.kind == CONSTANT:
        return float(f.numbers[0])
    if f.kind == SIGMOID:
        gain_min, gain_max, speed_low, speed_high = f.numbers[0], f.numbers[1], f.numbers[2], f.numbers[3]
        share = (speed - speed_low) / (speed_high - speed_low)
        share = min(max(share, 0.0), 1.0)
        return float(gain_min + share * (gain_max - gain_min))
    if f.kind == ARCTAN:
        return atan(speed) / speed if speed > 0.0 else 1.0
    value = 0.0
    if f.kind == BOUNDED:
        low, high = f.numbers[BOUNDED_COEFFICIENTS], f.numbers[BOUNDED_COEFFICIENTS + 1]
        within = min(max(speed, low), high)
        for i in range(BOUNDED_COEFFICIENTS - 1, -1, -1):
            value = value * within + f.numbers[i]
        return value
    for i in range(COEFFICIENTS_MOST - 1, 0, -1):
        value = value * speed + f.numbers[i]
    if f.numbers[0] == 0.0:
        return value
    return value + f.numbers[0] / speed if speed > 0.0 else copysign(inf, f.numbers[0])


@law
def cursor_speed(f: Function, speed: float) -> float:
    """PTF(V): the speed of the cursor in m/s on the screen for a hand's speed >= 0 in m/s."""
    if f.kind == POLYNOMIAL:
        value = 0.0
        for i in range(COEFFICIENTS_MOST - 1, -1, -1):
            value = value * speed + f.numbers[i]
        return value
    if f.kind == ARCTAN:
        return atan(speed)
    return gain(f, speed) * speed


@law
def evaluate(f: Function, speeds: FloatArray, wanted_gain: bool, out: FloatArray) -> None:
    """Evaluate one of the two laws at many speeds."""
    for i in range(len(speeds)):
        out[i] = gain(f, speeds[i]) if wanted_gain else cursor_speed(f, speeds[i])


@runtime_checkable
class TransferFunction(Protocol):
    """The interface of pointing transfer functions."""

    @property
    def slots(self) -> FloatArray:
        """The kind and its numbers, for compiled laws that call ``gain`` or ``cursor_speed``."""
        ...

    def gain(self, speed_m_s: ArrayLike) -> FloatArray:
        """The dimensionless control-display gain PTF(V) / V at speeds of the hand in m/s."""
        ...

    def cursor_speed(self, speed_m_s: ArrayLike) -> FloatArray:
        """The speed of the cursor in m/s on the screen, PTF(V)."""
        ...


class SlotsFunction:
    """A transfer function of a kind and its numbers, bounded by its ``parameters`` if it has any."""

    parameters: ClassVar[tuple[Parameter, ...]] = ()

    def __init__(self, kind: float, numbers: Sequence[float]) -> None:
        """Check the numbers; raises ParameterError."""
        for one, number in zip(self.parameters, numbers, strict=False):
            one.check(number)
        self.slots: FloatArray = np.zeros(SLOTS)
        self.slots[0] = kind
        self.slots[1 : 1 + len(numbers)] = numbers
        self.slots.flags.writeable = False

    def gain(self, speed_m_s: ArrayLike) -> FloatArray:
        """The control-display gain at each speed; raises EventError for a speed that is not >= 0."""
        return self._evaluate(speed_m_s, True)

    def cursor_speed(self, speed_m_s: ArrayLike) -> FloatArray:
        """PTF(V) in m/s on the screen at each speed; raises EventError for a speed that is not >= 0."""
        return self._evaluate(speed_m_s, False)

    def _evaluate(self, speed_m_s: ArrayLike, wanted_gain: bool) -> FloatArray:
        speeds = np.asarray(speed_m_s, np.float64)
        wrong = ~((speeds >= 0.0) & (speeds < inf))
        if wrong.any():
            value = float(speeds[wrong].flat[0])
            raise EventError(
                f"speed must lie in [0, inf) m/s, received {value!r}", field="speed", value=value
            )
        out = np.empty(speeds.size)
        evaluate(self.slots, speeds.ravel(), wanted_gain, out)
        return out.reshape(speeds.shape)


class ConstantGain(SlotsFunction):
    """The same gain at every speed: PTF(V) = g V.

    Parameters: ``gain`` in [0, 1000], 4 in the thesis's experiment (section 2.6.1, function b).
    Memory: 8 floats, never changed. Raises ParameterError.

    >>> float(ConstantGain(4.0).cursor_speed(0.1))
    0.4
    """

    parameters = (Parameter("gain", "", 0.0, 1e3, "control-display gain"),)

    def __init__(self, gain: float = 4.0) -> None:
        super().__init__(CONSTANT, [gain])


class SigmoidGain(SlotsFunction):
    """The piecewise-linear gain of the thesis's experiment, modelled on the macOS function.

    gain(V) = ``gain_min`` below ``speed_low``, ``gain_max`` above ``speed_high``, linear between. A
    polynomial cannot reproduce its corners.

    Parameters: gains in [0, 1000], speeds in m/s in [0, 100], ``speed_low`` below ``speed_high``.
    Memory: 8 floats, never changed. Raises ParameterError.
    Reference: Khalin 2022, section 2.6.1, function a.

    >>> function = SigmoidGain()
    >>> [round(float(g), 3) for g in function.gain([0.01, 0.1, 0.7])]
    [1.0, 2.273, 15.0]
    """

    parameters = (
        Parameter("gain_min", "", 0.0, 1e3, "control-display gain of slow movements"),
        Parameter("gain_max", "", 0.0, 1e3, "control-display gain of fast movements"),
        Parameter("speed_low", "m/s", 0.0, 1e2, "below it the gain is gain_min"),
        Parameter("speed_high", "m/s", 0.0, 1e2, "above it the gain is gain_max"),
    )

    def __init__(
        self,
        gain_min: float = MACOS[0],
        gain_max: float = MACOS[1],
        speed_low: float = MACOS[2],
        speed_high: float = MACOS[3],
    ) -> None:
        super().__init__(SIGMOID, [gain_min, gain_max, speed_low, speed_high])
        if speed_low >= speed_high:
            raise ParameterError(
                f"speed_low must lie below speed_high = {speed_high!r} m/s, received {speed_low!r} m/s",
                field="speed_low",
                value=speed_low,
            )


class Arctan(SlotsFunction):
    """PTF(V) = arctan V, the bounded function of the thesis's model validation (section 2.6.2).

    V and PTF share a unit: the validation uses V and x' in px/s, so the cursor never exceeds 1.57 px/s. No
    device behaves like this.
    Memory: 8 floats, never changed.

    >>> round(float(Arctan().cursor_speed(1.0)), 4), float(Arctan().gain(0.0))
    (0.7854, 1.0)
    """

    def __init__(self) -> None:
        super().__init__(ARCTAN, [])


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
