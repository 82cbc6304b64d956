"""The camera's velocity from the observer's depth, (40) to (42), and all stages together with their flags."""

from __future__ import annotations

from math import nan
from typing import Self

import msgspec
import numpy as np

from pointpred.columns import Columns
from pointpred.compiled import law
from pointpred.errors import EventError
from pointpred.layout import Layout
from pointpred.parameter import parameter
from pointpred.records import LATEST_S, FloatArray
from pointpred.stage import loop_into
from pointpred_observers.camera.depth import Depth, DepthColumns, DepthObserver
from pointpred_observers.camera.point_filter import PointEstimate, PointFilter
from pointpred_observers.camera.samples import FOCAL_PX, CameraColumns, CameraSample, CameraStage, usable

FLOOR = 1e-4
"""chi at or below this (a depth of 10 km) is invalid: the velocity is then NaN, never clipped."""
EVER_S = 2.0 * LATEST_S
"""No gap is longer: the filter predicts over any."""
SURE = 2.0
"""Standard deviations by which the filter's eta must exceed -decay to clear ``detectable``."""
SPREAD_START = 1.0
"""Standard deviation of d before the first image, 1/s."""


class Settings(Layout):
    """The focal length, the variance of an image, the density of the unknown input's rate in 1/s^3."""

    focal_px: float
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
def step(memory: Memory, row: FloatArray, out: FloatArray) -> None:
    """A ``CameraSample``, then the observer's eta: t, d_x, d_y and their spread, 1/s, into ``out``."""
    settings, s = memory.settings, memory.state
    t, wx, wy, wz, eta = row[0], row[3], row[4], row[5], row[9]
    if not usable(
        CameraSample(t, row[1], row[2], wx, wy, wz, row[6], row[7], row[8]), s.started, s.t, EVER_S
    ):
        return
    x, y = row[1] / settings.focal_px, row[2] / settings.focal_px
    out[0] = t
    image = x == x
    known = eta == eta  # where it is not, the last estimate stays
    if known and s.imaged == 1.0:
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
    elif known and image:
        s.imaged, s.x, s.y = 1.0, x, y
        s.p00, s.p11 = settings.noise, SPREAD_START**2
    if known:
        s.started, s.t = 1.0, t
        s.kx, s.ky = flow(s.x, s.y, eta, wx, wy, wz)
    if s.imaged == 1.0:
        out[1], out[2], out[3] = s.dx, s.dy, s.p11**0.5


class UnknownInputFilter(CameraStage):
    """Kalman filter of (x, y) and d = chi (v_x, v_y) with the known motion of the image fed forward.

    Assumes that d changes as a random walk and that eta and w are correct: the error of eta times (x, y)
    enters d. The known part of (x, y)' is integrated, not differentiated, so the filter needs only the
    bandwidth of d: at 4 px of noise it is ten times better than differences of the image.

    (x, y)' = (x, y) eta + B_y w - d, d' white of density q; image noise r; both axes share one covariance.

    Parameters: ``focal_px`` px; ``noise_px`` px, standard deviation of a coordinate; ``density`` 1/s^3, q.
    Memory: 15 floats. Raises ParameterError; EventError if time does not increase.

    Reference: Benyoucef et al. 2021, equations (39) to (41), with a filter instead of the derivative.

    >>> unknown = UnknownInputFilter(focal_px=1e3, noise_px=1.0, density=1e-2)
    >>> for i in range(200):
    ...     sample = CameraSample(i / 50, -100.0 * i / 50, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    ...     dx, dy, spread = unknown.update(sample, 0.0)
    >>> round(dx, 4)  # x' = -d_x
    0.1
    """

    focal_px: float = parameter("px", *FOCAL_PX, "focal length: image plane to px")
    noise_px: float = parameter("px", 1e-3, 1e3, "standard deviation in the image", default=1.0)
    density: float = parameter("1/s^3", 1e-12, 1e6, "density of the unknown input's rate", default=3e-4)
    states = State.length
    width = 4
    layout = Memory
    loop = staticmethod(loop_into(step))
    step = staticmethod(step)

    def settings(self) -> list[float]:
        """The beginning of the memory."""
        focal_px = float(self.focal_px)
        return [focal_px, (float(self.noise_px) / focal_px) ** 2, float(self.density)]

    def update(self, sample: CameraSample, /, eta: float) -> tuple[float, float, float]:
        """D and its standard deviation after a sample and the observer's eta; a refused one changes nothing.

        NaN before the first image; where eta is NaN the last estimate stays.
        """
        _, dx, dy, spread = self.advance(sample, (float(eta),)).tolist()
        return dx, dy, spread

    def run(self, samples: CameraColumns, eta: FloatArray) -> FloatArray:
        """D at each row of a table, (rows, 2); a refused row raises its error."""
        return self.table(np.column_stack([samples.table, eta]))[:, 1:3]


def velocities(d: FloatArray, depth: DepthColumns) -> FloatArray:
    """(v_x, v_y, v_z) m/s by (41), (42); NaN if chi is at its floor or unknown.

    >>> depth = DepthColumns([[0.0, 0.5, -0.1, -0.1, 1.0, 1.0, 1.0], [1.0, 1e-5, -0.1, -0.1, 1.0, 1.0, 1.0]])
    >>> velocities(np.array([[0.1, 0.0], [0.1, 0.0]]), depth).tolist()
    [[0.2, 0.0, -0.2], [nan, nan, nan]]
    """
    chi = np.where(depth.chi > FLOOR, depth.chi, np.nan)
    rates: FloatArray = np.column_stack([d, depth.eta]) / chi[:, None]
    return rates


class CameraEstimate(msgspec.Struct, frozen=True):
    """Estimates after a sample: the observer's depth and velocity, and the Kalman filter's (``peer``).

    ``detectable``: the observer's own zeros lie below -decay and the filter does not contradict. If it is
    false the observer's errors do not decay: use ``peer`` if it is not ``None``.
    """

    depth: Depth
    velocity: tuple[float, float, float]
    detectable: bool
    peer: PointEstimate | None


class CameraTable(Columns[tuple[float, ...]]):
    """Estimates as columns, NaN if unknown; ``peer_`` columns are the filter's."""

    names = (
        *("t", "chi", "eta", "vx", "vy", "vz", "detectable", "certified", "image"),
        *("peer_chi", "peer_eta", "peer_vx", "peer_vy", "peer_vz", "peer_depth_spread"),
    )

    def _record(self, row: list[float]) -> tuple[float, ...]:
        return tuple(row)


class CameraPipeline:
    """A ``Stage[CameraSample, CameraEstimate]``: the unknown input observer with the filter as a check.

    The observer alone cannot distinguish an approaching from a receding camera if it was started with the
    wrong sign. The filter can, once the images determine the depth: if its eta lies above -decay by two
    standard deviations, ``detectable`` is false whatever the observer's estimate.

    Parameters: ``observer``; ``peer``; ``noise_px`` px, the standard deviation of the image, for the filter
    of the velocity. Raises EventError and EventOrderError and is then unchanged.
    """

    def __init__(self, observer: DepthObserver, peer: PointFilter, *, noise_px: float = 1.0) -> None:
        self.observer, self.peer = observer, peer
        self.unknown = UnknownInputFilter(focal_px=observer.focal_px, noise_px=noise_px)

    def reset(self) -> None:
        """Forget every sample."""
        for stage in (self.observer, self.peer, self.unknown):
            stage.reset()

    def fresh(self) -> Self:
        """The same parameters, without memory."""
        return type(self)(self.observer.fresh(), self.peer.fresh(), noise_px=self.unknown.noise_px)

    def update(self, sample: CameraSample, /) -> CameraEstimate:
        """Consume one sample; a refused one changes nothing."""
        memory = self.observer.remembered()  # it has moved on when the filter refuses the sample
        depth = self.observer.update(sample)
        try:
            peer = self.peer.update(sample)
        except EventError:
            self.observer.recall(memory)
            raise
        d = self.unknown.update(sample, depth.eta)[:2]
        vx, vy, vz = velocities(np.array([d]), DepthColumns([depth]))[0].tolist()
        denied = peer is not None and peer.eta - SURE * peer.eta_spread > -self.observer.decay
        return CameraEstimate(depth, (vx, vy, vz), depth.detectable and not denied, peer)

    def run(self, samples: CameraColumns) -> CameraTable:
        """Consume a table; when a row is refused the error names it and nothing is consumed."""
        rows, stages = [], (self.observer, self.peer, self.unknown)
        before = [stage.remembered() for stage in stages]
        for number, sample in enumerate(samples):
            try:
                rows.append(_row(self.update(sample)))
            except EventError as refused:
                for stage, memory in zip(stages, before, strict=True):
                    stage.recall(memory)
                words = f"row {number}: {refused}"
                raise type(refused)(words, field=refused.field, value=refused.value) from refused
        return CameraTable(np.array(rows).reshape(-1, len(CameraTable.names)))


def _row(one: CameraEstimate) -> tuple[float, ...]:
    depth, peer, other = one.depth, one.peer, (nan,) * 6
    if peer is not None:
        other = (peer.chi, peer.eta, *peer.state[3:].tolist(), peer.depth_spread)
    flags = (float(one.detectable), float(depth.certified), float(depth.image))
    return (depth.t, depth.chi, depth.eta, *one.velocity, *flags, *other)
