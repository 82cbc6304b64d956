"""The two-state Kalman filter of an unknown input: the point's place and d = chi (v_x, v_y)."""

from __future__ import annotations

from math import nan
from typing import NamedTuple

from pointpred.compiled import law
from pointpred.errors import EventError
from pointpred.layout import Layout
from pointpred.parameter import parameter
from pointpred.records import LATEST_S, FloatTable
from pointpred.stage import CompiledStage, loop_of

SPREAD_START = 1.0
"""Standard deviation of d before the first image, 1/s."""


class Settings(Layout):
    """The variance of an image, the density of the unknown input's rate in 1/s^3."""

    noise: float
    density: float


class State(Layout):
    """The time; of the last image the position, d and the known part of its motion, 1/s.

    ``p00 p01 p11`` is the covariance of a position and d, which both axes share.
    """

    started: float
    t: float
    imaged: float
    x: float
    y: float
    dx: float
    dy: float
    kx: float
    ky: float
    p00: float
    p01: float
    p11: float


class Memory(Layout):
    """The settings, then the state."""

    settings: Settings
    state: State


class FlowRow(NamedTuple):
    """``t`` s; the point ``x y`` in focal lengths, NaN without an image; ``eta`` 1/s; ``wx wy wz`` rad/s."""

    t: float
    x: float
    y: float
    eta: float
    wx: float
    wy: float
    wz: float


@law
def flow(x: float, y: float, eta: float, wx: float, wy: float, wz: float) -> tuple[float, float]:
    """The known part of the image's motion: (x, y) eta + B w; the rest of (x, y)' is -d."""
    flow_x = x * eta + x * y * wx - (1.0 + x * x) * wy + y * wz
    flow_y = y * eta + (1.0 + y * y) * wx - x * y * wy - x * wz
    return flow_x, flow_y


@law
def predict(s: State, density: float, eta: float, wx: float, wy: float, wz: float, h: float) -> None:
    """Y' = known - d over ``h`` s, the known part fed forward by Heun's rule; d' is white."""
    x, y, kx, ky = s.x, s.y, s.kx, s.ky
    dx, dy = s.dx, s.dy
    lx, ly = flow(x + h * (kx - dx), y + h * (ky - dy), eta, wx, wy, wz)
    s.x = x + h * (0.5 * (kx + lx) - dx)
    s.y = y + h * (0.5 * (ky + ly) - dy)
    p01, p11 = s.p01, s.p11
    s.p00 += -2.0 * h * p01 + h * h * p11 + density * h**3 / 3.0
    s.p01 += -h * p11 - density * h * h / 2.0
    s.p11 += density * h


@law
def step(
    memory: Memory, row: tuple[float, float, float, float, float, float, float]
) -> tuple[float, float, float, float]:
    """One ``FlowRow``: t, d_x, d_y and their standard deviation, 1/s."""
    settings, s = memory.settings, memory.state
    t, x, y, eta, wx, wy, wz = FlowRow(*row)
    if not abs(t) <= LATEST_S or eta != eta or (s.started == 1.0 and not t > s.t):
        return nan, nan, nan, nan
    image = x == x
    if s.imaged == 1.0:
        predict(s, settings.density, eta, wx, wy, wz, t - s.t)
        if image:
            total = s.p00 + settings.noise
            near, far = s.p00 / total, s.p01 / total
            ex, ey = x - s.x, y - s.y
            s.x += near * ex
            s.y += near * ey
            s.dx += far * ex
            s.dy += far * ey
            s.p11 -= far * s.p01
            s.p01 *= 1.0 - near
            s.p00 *= 1.0 - near
    elif image:
        s.imaged, s.x, s.y = 1.0, x, y
        s.p00, s.p11 = settings.noise, SPREAD_START**2
    s.started, s.t = 1.0, t
    s.kx, s.ky = flow(s.x, s.y, eta, wx, wy, wz)
    if s.imaged == 0.0:
        return t, nan, nan, nan
    return t, s.dx, s.dy, s.p11**0.5


@law
def row_at(rows: FloatTable, i: int) -> tuple[float, float, float, float, float, float, float]:
    """A row of a table as a tuple."""
    r = rows[i]
    return r[0], r[1], r[2], r[3], r[4], r[5], r[6]


class UnknownInputFilter(CompiledStage):
    """Kalman filter of (y, d) for both axes of the image, with the known motion fed forward.

    Assumes that d changes as a random walk and that eta and w are correct: their errors enter d. The known
    part of y' is integrated, not differentiated, so the filter needs only the bandwidth of d.

    y' = eta y + B_y w - d, d' white of density q; image noise r; both axes share one covariance.

    Parameters: ``noise`` of x and y (image units, px / focal length); ``density`` 1/s^3, q. Memory: 14
    floats. A row is t, x, y, eta, w_x, w_y, w_z; returns (t, d_x, d_y, spread). Raises ParameterError;
    EventError if time does not increase or a value is not a number.

    Reference: Benyoucef et al. 2021, equations (39) to (41), with a filter instead of the derivative.

    >>> unknown = UnknownInputFilter(noise=1e-3, density=1e-2)
    >>> for i in range(200):
    ...     row = unknown.update((i / 50, -0.1 * i / 50, 0.0, 0.0, 0.0, 0.0, 0.0))
    >>> round(row[1], 4)  # x' = -d_x
    0.1
    """

    noise: float = parameter("", 1e-9, 1.0, "standard deviation of x and y, in units of the focal length")
    density: float = parameter(
        "1/s^3", 1e-12, 1e6, "spectral density of the unknown input's rate", default=3e-4
    )
    states = State.length
    width = 4
    loop = staticmethod(loop_of(step, row_at))
    step = staticmethod(step)

    def settings(self) -> list[float]:
        """The beginning of the memory."""
        return [float(self.noise) ** 2, float(self.density)]

    def update(self, row: tuple[float, ...], /) -> tuple[float, float, float, float]:
        """Consume one row; a refused one changes nothing."""
        t, x, y, eta, wx, wy, wz = map(float, row)
        answer: tuple[float, float, float, float] = self.advance((t, x, y, eta, wx, wy, wz))
        if answer[0] != answer[0]:
            raise EventError(f"t must increase and eta be a number, received {row!r}", value=row)
        return answer
