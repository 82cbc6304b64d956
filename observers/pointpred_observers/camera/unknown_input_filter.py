"""The two-state Kalman filter of an unknown input: the point's place and d = chi (v_x, v_y)."""

from __future__ import annotations

from math import nan
from typing import NamedTuple

from pointpred.compiled import law
from pointpred.errors import EventError
from pointpred.parameter import parameter
from pointpred.records import LATEST_S, FloatArray, FloatTable
from pointpred.stage import CompiledStage, loop_of

SPREAD_START = 1.0
"""Standard deviation of d before the first image, 1/s."""

# The parameters. The state: whether there was a row, its time, whether there was an image; its position and
# d, the known part of the motion then, and the covariance of a position and d, shared by both axes.
NOISE, DENSITY, STARTED, T, IMAGED, X, Y, DX, DY, KX, KY, P00, P01, P11, END = range(15)


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
def predict(memory: FloatArray, eta: float, wx: float, wy: float, wz: float, h: float) -> None:
    """Y' = known - d over ``h`` s, the known part fed forward by Heun's rule; d' is white."""
    x, y, kx, ky = memory[X], memory[Y], memory[KX], memory[KY]
    dx, dy = memory[DX], memory[DY]
    lx, ly = flow(x + h * (kx - dx), y + h * (ky - dy), eta, wx, wy, wz)
    memory[X] = x + h * (0.5 * (kx + lx) - dx)
    memory[Y] = y + h * (0.5 * (ky + ly) - dy)
    q = memory[DENSITY]
    p01, p11 = memory[P01], memory[P11]
    memory[P00] += -2.0 * h * p01 + h * h * p11 + q * h**3 / 3.0
    memory[P01] += -h * p11 - q * h * h / 2.0
    memory[P11] += q * h


@law
def step(
    memory: FloatArray, row: tuple[float, float, float, float, float, float, float]
) -> tuple[float, float, float, float]:
    """One ``FlowRow``: t, d_x, d_y and their standard deviation, 1/s."""
    t, x, y, eta, wx, wy, wz = FlowRow(*row)
    if not abs(t) <= LATEST_S or eta != eta or (memory[STARTED] == 1.0 and not t > memory[T]):
        return nan, nan, nan, nan
    image = x == x
    if memory[IMAGED] == 1.0:
        predict(memory, eta, wx, wy, wz, t - memory[T])
        if image:
            total = memory[P00] + memory[NOISE]
            near, far = memory[P00] / total, memory[P01] / total
            ex, ey = x - memory[X], y - memory[Y]
            memory[X] += near * ex
            memory[Y] += near * ey
            memory[DX] += far * ex
            memory[DY] += far * ey
            memory[P11] -= far * memory[P01]
            memory[P01] *= 1.0 - near
            memory[P00] *= 1.0 - near
    elif image:
        memory[IMAGED], memory[X], memory[Y] = 1.0, x, y
        memory[P00], memory[P11] = memory[NOISE], SPREAD_START**2
    memory[STARTED], memory[T] = 1.0, t
    memory[KX], memory[KY] = flow(memory[X], memory[Y], eta, wx, wy, wz)
    if memory[IMAGED] == 0.0:
        return t, nan, nan, nan
    return t, memory[DX], memory[DY], memory[P11] ** 0.5


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
    states = END - STARTED
    width = 4
    loop = staticmethod(loop_of(step, row_at))

    def settings(self) -> list[float]:
        """The beginning of the memory."""
        return [float(self.noise) ** 2, float(self.density)]

    def update(self, row: tuple[float, ...], /) -> tuple[float, float, float, float]:
        """Consume one row; a refused one changes nothing."""
        t, x, y, eta, wx, wy, wz = map(float, row)
        answer = step(self._memory, (t, x, y, eta, wx, wy, wz))
        if answer[0] != answer[0]:
            raise EventError(f"t must increase and eta be a number, received {row!r}", value=row)
        return answer
