"""The homogeneous differentiator (HOMD), thesis section 2.3.1, equation (2.2)."""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, floor
from typing import Annotated, Any, Literal

import numpy as np

from pointpred.compiled import law
from pointpred.differentiators import sampling
from pointpred.differentiators.differentiator import Differentiator
from pointpred.errors import ParameterError
from pointpred.layout import Layout, clear
from pointpred.parameter import is_number, option, parameter
from pointpred.records import METRES_PER_INCH, EventRow, FloatArray, TenFloats, refused

ORDER_MOST = 8
SUBSTEPS_MOST = 10_000
"""Bound on the cost of one event."""
SETTLING_SPEED_M_S = 0.3
"""Speed of the hand at which the settling time is measured."""
CHATTER_MOST_M_S = 0.05
"""Speed that a device at rest may seem to have at the longest Euler step: a sixth of a usual reach."""
STEPS_M = (METRES_PER_INCH / 2000.0, METRES_PER_INCH / 96.0)
"""Displacements after which that is looked at: a count of a 2000 CPI mouse, a pixel at 96 dpi."""


class Axis(Layout):
    """What the law estimates of an axis: u, u', ... in m, m/s, ..."""

    z: Annotated[FloatArray, ORDER_MOST]


class Estimates(Layout):
    """The estimates of x and y; the last z_n' of both, which is the acceleration where the order is 2."""

    x: Axis
    y: Axis
    slope: Annotated[FloatArray, 2]


class State(Layout):
    """What is remembered of the samples."""

    sampling: sampling.State
    estimates: Estimates


class Settings(Layout):
    """The parameters; whether the position is held between samples, the settling time, the gains."""

    sampling: sampling.Settings
    order: float
    alpha: float
    step_s: float
    hold: float
    settle_s: float
    gain: Annotated[FloatArray, ORDER_MOST]


class Memory(Layout):
    """The settings, then the state."""

    settings: Settings
    state: State


# The values of the parameters behind those of sampling.
ORDER_OF, LAMBDA_OF, XI_OF, ALPHA_OF, STEP_OF = range(sampling.Settings.length, sampling.Settings.length + 5)


@law
def advance(settings: Settings, axis: Axis, before: float, now: float, h: float, steps: int) -> float:
    """Integrate (2.2) by explicit Euler over ``steps`` sub-steps of ``h`` s; returns the last z_n'."""
    order = int(settings.order)
    slope = 0.0
    for i in range(steps):
        y = now if settings.hold == 1.0 else before + (now - before) * (i / steps)
        error = axis.z[0] - y
        size = abs(error)
        scale = size**settings.alpha if size > 0.0 else 0.0
        push = error
        for j in range(order):
            push *= scale
            carried = axis.z[j + 1] if j + 1 < order else 0.0
            slope = carried - settings.gain[j] * push
            axis.z[j] += h * slope
    return slope


@law
def step(memory: Memory, event: EventRow) -> TenFloats:
    """One event through the differentiator of both axes."""
    settings, samples, z = memory.settings, memory.state.sampling, memory.state.estimates
    verdict, dt, before_u, before_v, start = sampling.accept(settings.sampling, samples, event)
    if verdict < 0:
        return refused(-verdict, samples.t)
    if verdict == sampling.RESTARTED:
        clear(z)
    elif verdict == sampling.MOVED:
        steps = ceil(dt / settings.step_s)
        h = dt / steps
        z.slope[0] = advance(settings, z.x, before_u, samples.u, h, steps)
        z.slope[1] = advance(settings, z.y, before_v, samples.v, h, steps)
    second = settings.order == 2.0
    velocity = z.x.z[1], z.y.z[1]
    acceleration = z.slope[0] if second else z.x.z[2], z.slope[1] if second else z.y.z[2]
    settled = sampling.settled(samples, settings.order + 1.0, settings.settle_s)
    return sampling.motion(samples, event, (velocity, acceleration), settled, start)


@law
def settling(memory: Memory, speed: float, h: float, steps: int) -> float:
    """Seconds until the velocity stays within 5 % of a ramp's ``speed`` m/s, from rest; spoils ``memory``."""
    axis = memory.state.estimates.x
    settled_s = 0.0
    for i in range(steps):
        advance(memory.settings, axis, speed * i * h, speed * (i + 1) * h, h, 1)
        if abs(axis.z[1] - speed) > 0.05 * speed:
            settled_s = (i + 1) * h
    return settled_s


@law
def chatter(memory: Memory, place: float, h: float, steps: int) -> float:
    """Largest speed in m/s long after the position stepped to ``place`` m and rests; spoils ``memory``."""
    axis = memory.state.estimates.x
    advance(memory.settings, axis, place, place, h, steps)
    fastest = 0.0
    for _ in range(steps // 4):
        advance(memory.settings, axis, place, place, h, 1)
        speed = abs(axis.z[1])
        if not speed <= fastest:  # NaN too is not at rest
            fastest = speed
    return fastest


@law
def place_poles(settings: Settings, gain_lambda: float, gain_xi: float) -> None:
    """The gains k_1 ... k_n: coefficients of (s + lambda)(s + lambda xi) ... (s + lambda xi^(n-1)).

    >>> settings = Settings(np.zeros(Settings.length))
    >>> settings.order = 4.0
    >>> place_poles(settings.memory, 5.0, 2.0)
    >>> settings.gain[:4].tolist()
    [75.0, 1750.0, 15000.0, 40000.0]
    """
    for i in range(int(settings.order)):
        rate = gain_lambda * gain_xi**i
        for j in range(i, 0, -1):
            settings.gain[j] += rate * settings.gain[j - 1]
        settings.gain[0] += rate


@law
def fill(values: FloatArray, settings: Settings) -> None:
    """The settings but for the settling time; between two samples the position runs on a line."""
    sampling.fill(values, settings.memory)
    settings.order, settings.alpha, settings.step_s = values[ORDER_OF], values[ALPHA_OF], values[STEP_OF]
    settings.hold = settings.settle_s = 0.0
    place_poles(settings, values[LAMBDA_OF], values[XI_OF])


@law
def settle(memory: Memory) -> None:
    """Measure how long the law takes to settle, in a memory without states."""
    h = min(memory.settings.step_s, 1e-3)
    memory.settings.settle_s = settling(memory, SETTLING_SPEED_M_S, h, floor(2.0 / h + 0.5))
    clear(memory.state)


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
            f"received {step_s!r}",
            field="step_s",
            value=step_s,
        )


def check_gains(gains: Sequence[float], order: int) -> list[float]:
    """Raise ParameterError unless gains are one positive number an order that make a stable linear law."""
    listed = isinstance(gains, Sequence | np.ndarray) and not isinstance(gains, str | bytes)
    whole = listed and len(gains) == order and all(is_number(k) and 0.0 < k < np.inf for k in gains)
    if not whole:
        raise ParameterError(
            f"gains must be {order} positive numbers, received {gains!r:.80}", field="gains", value=gains
        )
    slowest = float(np.max(np.roots([1.0, *gains]).real))
    if slowest >= 0.0:
        raise ParameterError(
            f"gains {list(gains)!r} make an unstable law: a pole has real part {slowest:g}",
            field="gains",
            value=gains,
        )
    return [float(k) for k in gains]


class HomogeneousDifferentiator(Differentiator):
    """Homogeneous finite-time differentiator of any order from 2 to 8 (HOMD), one for each axis.

    Assumes a position that is smooth between samples. It is homogeneous, not scale free: gains that suit
    metres make another filter of pixels. Explicit Euler costs grow with the gap between events, and with
    alpha < 0 the velocity chatters at rest; settings by which it would by more than 0.05 m/s are refused.

    z_j' = z_(j+1) - k_j |e|^(1 + j alpha) sgn e, e = z_1 - y, z_(n+1) = 0; velocity is z_2, acceleration z_3
    (for order 2 the last slope of z_2). ``alpha`` 0 is the linear high-gain observer, -1/order Levant's
    sliding-mode differentiator. A restart puts z_1 on the position and the rest at zero; the motion is
    settled after the time in which the law comes within 5 % of a hand that already moves at 0.3 m/s
    (2 s at most).

    Parameters: ``gain_lambda`` 1/s and ``gain_xi`` place the poles, or ``gains`` gives k_1 ... k_n;
    ``alpha`` in [-1/order, 0]; ``step_s`` the longest Euler step; ``between`` what the position does between
    two samples, ``"line"`` or ``"hold"``;
    ``cpi``, ``dpi``, ``gap_s``, ``pause_s`` as for all differentiators.
    Memory: 47 floats. Raises ParameterError, and EventError and EventOrderError from ``update``.

    Reference: Khalin 2022, section 2.3.1, equation (2.2), with the sign of the discrete last line corrected;
    Perruquetti, Floquet, Moulay 2008; Levant 2003 for alpha = -1/n.

    >>> from pointpred import PointerEvent
    >>> differentiator = HomogeneousDifferentiator()
    >>> for i in range(300):
    ...     motion = differentiator.update(PointerEvent(i / 1000, 2.0 * i, 0.0))
    >>> round(motion.vx, 2)  # 2000 px/s at 96 dpi
    0.53
    """

    order: int = parameter(
        "", 2, ORDER_MOST, "number of estimated quantities: position, velocity, ...", default=4, whole=True
    )
    gain_lambda: float = parameter("1/s", 1e-3, 1e4, "slowest pole of the linear law", default=5.0)
    gain_xi: float = parameter("", 1e-3, 1e2, "ratio of neighbouring poles", default=2.0)
    alpha: float = parameter(
        "", -0.5, 0.0, "degree of homogeneity: 0 linear, -1/order sliding mode", default=-0.2
    )
    step_s: float = parameter(
        "s", 1e-5, 1e-1, "longest Euler step; longer gaps are cut into sub-steps", default=0.0015
    )
    gains: Sequence[float] | None = option("the gains themselves, instead of the poles", default=None)
    between: Literal["line", "hold"] = option(
        "the position between two samples: 'line' or 'hold'", default="line"
    )
    step = staticmethod(step)
    states = State.length
    fill = staticmethod(fill)
    settle = staticmethod(settle)

    def declare(self, **values: Any) -> None:
        """Check each value, and which of them go together."""
        super().declare(**values)
        self.order = int(self.order)
        lowest, alpha = -1.0 / self.order, self.alpha
        if alpha * self.order < -1.0 - 1e-12:
            raise ParameterError(
                f"alpha must lie in [-1/order, 0] = [{lowest:g}, 0], received {alpha!r}",
                field="alpha",
                value=alpha,
            )
        if self.between not in ("line", "hold"):
            raise ParameterError(
                f"between must be 'line' or 'hold', received {self.between!r}",
                field="between",
                value=self.between,
            )
        longest_s = SUBSTEPS_MOST * self.step_s
        if self.gap_s > longest_s:
            raise ParameterError(
                f"gap_s must be at most {SUBSTEPS_MOST} sub-steps = {longest_s:g} s, received {self.gap_s!r}",
                field="gap_s",
                value=self.gap_s,
            )
        if self.gains is None:
            self.gains = tuple(Settings(self.filled(Settings.length)).gain[: self.order].tolist())
        else:
            self.gains = tuple(check_gains(self.gains, self.order))
        check_step(self.gains, self.step_s)

    def settings(self) -> FloatArray:
        """The settings, with the gains themselves, which may have been given, and with what is held."""
        settings = Settings(self.filled(Settings.length))
        settings.gain[: self.order] = self.gains
        settings.hold = 1.0 if self.between == "hold" else 0.0
        return settings.memory

    @property
    def position(self) -> tuple[float, float]:
        """The filtered position z_1 of x and of y in m, from where the law last began."""
        z = Memory(self._memory).state.estimates
        return float(z.x.z[0]), float(z.y.z[0])

    def lay_out(self, settings: list[float] | FloatArray, states: int) -> None:
        """Make the memory, and measure how long the law takes to settle and whether it comes to rest."""
        super().lay_out(settings, states)
        if self.alpha < 0.0:
            _check_rest(self._memory, self.alpha, self.step_s)
        settle(Memory(self._memory))


def _check_rest(memory: FloatArray, alpha: float, step_s: float) -> None:
    """With alpha < 0 the gain k_j |e|^(j alpha) grows without bound as e -> 0: Euler's method must chatter.

    How far depends on the step; it is measured by running the law, from each of the two displacements.
    """
    steps = min(max(round(2.0 / step_s), 2_000), 20_000)
    speeds = [chatter(Memory(memory.copy()), place, step_s, steps) for place in STEPS_M]
    if not all(speed <= CHATTER_MOST_M_S for speed in speeds):
        raise ParameterError(
            f"with step_s = {step_s:g} s, alpha = {alpha:g} and these gains the velocity of a device at rest "
            f"chatters by {max(speeds):.2g} m/s, at most {CHATTER_MOST_M_S:g} m/s: choose a smaller step_s, "
            "smaller gains (gain_lambda) or an alpha nearer to 0",
            field="step_s",
            value=step_s,
        )
