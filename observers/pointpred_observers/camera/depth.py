"""The unknown input observer of depth at run time: its reduced form, two states without a gain."""

from __future__ import annotations

from math import ceil
from typing import Annotated, NamedTuple

import numpy as np

from pointpred.columns import Columns
from pointpred.compiled import law
from pointpred.errors import ParameterError
from pointpred.layout import Layout
from pointpred.parameter import option, parameter
from pointpred.records import FloatArray, FloatTable
from pointpred.stage import loop_into
from pointpred_observers.camera.model import SCHEDULED, C
from pointpred_observers.camera.samples import (
    FOCAL_PX,
    LARGEST_PX,
    SUBSTEP_S,
    CameraColumns,
    CameraSample,
    CameraStage,
    usable,
)
from pointpred_observers.numerics.matrices import instance
from pointpred_observers.unknown_input.observer import UnknownInputObserver

LARGEST_RATE = 1e3
"""Beyond this |eta| 1/s the camera meets the point within a millisecond: the estimate is lost."""


class Settings(Layout):
    """Focal length, the design's decay, start of chi and eta, longest silence; the certificate's box.

    The box has the bounds, low and high, of the zero of chi, eta, a_z, w_x, w_y.
    """

    focal_px: float
    decay: float
    start_chi: float
    start_eta: float
    gap_s: float
    box: Annotated[FloatTable, 5, 2]


class State(Layout):
    """The last sample; the observer's two states; whether there was an image, whether they are lost."""

    started: float
    t: float
    x: float
    y: float
    wx: float
    wy: float
    wz: float
    az: float
    chi: float
    r: float
    imaged: float
    lost: float


class Memory(Layout):
    """The settings, then the state."""

    settings: Settings
    state: State


class Measured(NamedTuple):
    """The measurements used by the observer: ``x y`` in focal lengths, ``wx wy wz`` rad/s, ``az`` m/s^2."""

    x: float
    y: float
    wx: float
    wy: float
    wz: float
    az: float


@law
def rate(chi: float, r: float, m: Measured, dwx: float, dwy: float) -> tuple[float, float]:
    """(chi, r)' with r = eta + w_y x - w_x y, the last row of T x: no unknown input in it."""
    x, y, wx, wy, wz, az = m
    eta = r - wy * x + wx * y
    flow_x = x * y * wx - (1.0 + x * x) * wy + y * wz
    flow_y = (1.0 + y * y) * wx - x * y * wy - x * wz
    driven = wy * flow_x - wx * flow_y + dwy * x - dwx * y
    return (y * wx - x * wy + eta) * chi, az * chi + eta * eta + driven


@law
def carry(state: State, m: Measured, dt: float) -> None:
    """Move (chi, r) over ``dt`` s by Runge-Kutta, with measurements linear between two samples."""
    x0, y0, az0 = state.x, state.y, state.az
    wx0, wy0, wz0 = state.wx, state.wy, state.wz
    dwx, dwy = (m.wx - wx0) / dt, (m.wy - wy0) / dt
    steps = ceil(dt / SUBSTEP_S)
    h = dt / steps
    for i in range(steps):
        chi, r = state.chi, state.r
        sum_chi, sum_r, k_chi, k_r = 0.0, 0.0, 0.0, 0.0
        for stage in range(4):
            inner = 0.0 if stage == 0 else (1.0 if stage == 3 else 0.5)
            s = (i + inner) / steps
            between = Measured(
                x0 + s * (m.x - x0),
                y0 + s * (m.y - y0),
                wx0 + s * (m.wx - wx0),
                wy0 + s * (m.wy - wy0),
                wz0 + s * (m.wz - wz0),
                az0 + s * (m.az - az0),
            )
            k_chi, k_r = rate(chi + inner * h * k_chi, r + inner * h * k_r, between, dwx, dwy)
            share = 1.0 if stage == 0 or stage == 3 else 2.0
            sum_chi += share * k_chi
            sum_r += share * k_r
        state.chi = chi + h / 6.0 * sum_chi
        state.r = r + h / 6.0 * sum_r
        if not (abs(state.r) <= LARGEST_RATE and abs(state.chi) <= LARGEST_PX):
            state.lost = 1.0
            state.chi, state.r = chi, r
            return


@law
def inside(memory: Memory, zero: float, eta: float) -> bool:
    """Whether the scheduling variables lie in the certificate's box; false without a certificate."""
    settings, s = memory.settings, memory.state
    values = (zero, eta, s.az, s.wx, s.wy)
    for i in range(5):
        if not settings.box[i, 0] <= values[i] <= settings.box[i, 1]:
            return False
    return bool(settings.box[0, 0] < 0.0)


@law
def step(memory: Memory, row: FloatArray, out: FloatArray) -> None:
    """One sample; a ``Depth`` into ``out``, which is NaN before."""
    settings, s = memory.settings, memory.state
    t, x, y, wx, wy, wz, az = row[0], row[1], row[2], row[3], row[4], row[5], row[8]
    if not usable(CameraSample(t, x, y, wx, wy, wz, row[6], row[7], az), s.started, s.t, settings.gap_s):
        return
    image = x == x
    flat_x = x / settings.focal_px if image else s.x
    flat_y = y / settings.focal_px if image else s.y
    if s.imaged == 0.0 and image:
        s.chi = settings.start_chi
        s.r = settings.start_eta + wy * flat_x - wx * flat_y
        s.imaged = 1.0
    elif s.imaged == 1.0 and s.lost == 0.0:
        carry(s, Measured(flat_x, flat_y, wx, wy, wz, az), t - s.t)
    s.started = 1.0
    s.t, s.x, s.y = t, flat_x, flat_y
    s.wx, s.wy, s.wz, s.az = wx, wy, wz, az
    out[0], out[4], out[5], out[6] = t, 0.0, 0.0, 1.0 if image else 0.0
    if s.imaged == 0.0 or s.lost == 1.0:
        return
    eta = s.r - wy * flat_x + wx * flat_y
    zero = flat_y * wx - flat_x * wy + eta
    out[1], out[2], out[3] = s.chi, eta, zero
    out[4] = 1.0 if zero < -settings.decay and eta < -settings.decay else 0.0
    out[5] = 1.0 if inside(memory, zero, eta) else 0.0


class Depth(NamedTuple):
    """The observer's estimate after a sample.

    ``chi`` = 1/Z 1/m, ``eta`` = v_z/Z 1/s and ``zero`` = y w_x - x w_y + eta 1/s, NaN before the first image
    and when the estimate is lost; ``detectable`` while both zeros, as estimated, lie below -decay;
    ``certified`` while they and the measured quantities lie in the box of the design as well.
    """

    t: float
    chi: float
    eta: float
    zero: float
    detectable: bool
    certified: bool
    image: bool


class DepthColumns(Columns[Depth]):
    """Depths as columns."""

    names = Depth._fields

    def _record(self, row: list[float]) -> Depth:
        return Depth(row[0], row[1], row[2], row[3], row[4] == 1.0, row[5] == 1.0, row[6] == 1.0)


class DepthObserver(CameraStage):
    """Depth and forward velocity of a point from its image, a gyroscope and an accelerometer.

    Limitation: with two unknown inputs and two outputs no measurement corrects chi and eta. The model
    propagates their start values; errors decay only while the camera recedes, v_z is the integral of the
    accelerometer from its start value, and the relative error of the depth converges to that of v_z.
    ``detectable`` is computed from the estimate: it cannot detect a start with the wrong sign of v_z
    (``CameraPipeline`` compares with the images).

    chi' = (y w_x - x w_y + eta) chi; r' = a_z chi + eta^2 + w_y B_1 w - w_x B_2 w + w_y' x - w_x' y with
    eta = r - w_y x + w_x y: the last two rows of T x, which no unknown input reaches. Between two samples
    every measured quantity is linear, so w' is the slope of the gyroscope's readings and no angular
    accelerometer is needed. Without an image x and y keep their last values.

    Parameters: ``focal_px`` px; ``start_chi`` 1/m and ``start_eta`` 1/s; ``gap_s`` s, the longest silence
    that is bridged; ``observer``, a design for ``camera_system`` whose decay and box define the flags:
    without one the decay is 0 and ``certified`` is false. Memory: 27 floats. Returns a Depth from ``update``,
    DepthColumns from ``run``. Raises ParameterError; EventError and EventOrderError from ``update`` and
    ``run``.

    Reference: Benyoucef et al. 2021, equations (12), (15) to (18), the signs corrected.

    >>> observer = DepthObserver(focal_px=800.0, start_chi=1.0, start_eta=-0.5)
    >>> for i in range(101):  # backwards at 0.5 m/s from 1 m
    ...     depth = observer.update(CameraSample(i / 100, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    >>> round(1.0 / depth.chi, 6), round(depth.eta / depth.chi, 6), depth.detectable, depth.certified
    (1.5, -0.5, True, False)
    """

    focal_px: float = parameter("px", *FOCAL_PX, "focal length: image plane to px")
    start_chi: float = parameter("1/m", 1e-6, 1e6, "inverse depth at the first image")
    start_eta: float = parameter("1/s", -1e3, 1e3, "v_z/Z at the first image")
    gap_s: float = parameter("s", 1e-3, 10.0, "longest silence that is bridged", default=1.0)
    observer: UnknownInputObserver | None = option("a design to speak of in the flags", default=None)
    states = State.length
    width = len(Depth._fields)
    loop = staticmethod(loop_into(step))
    step = staticmethod(step)
    layout = Memory

    @property
    def decay(self) -> float:
        """The design's decay in 1/s; 0 without one."""
        return 0.0 if self.observer is None else self.observer.decay

    def settings(self) -> list[float]:
        """The beginning of the memory."""
        bounds = {} if self.observer is None else _camera_bounds(self.observer)
        box = [bound for name in SCHEDULED[:5] for bound in bounds.get(name, (0.0, 0.0))]
        start = [float(self.start_chi), float(self.start_eta)]
        return [float(self.focal_px), self.decay, *start, float(self.gap_s), *box]

    def update(self, sample: CameraSample, /) -> Depth:
        """Consume one sample; a refused one changes nothing."""
        return DepthColumns(self.advance(sample)[None])[0]

    def run(self, columns: CameraColumns) -> DepthColumns:
        """Consume a table; when a row is refused the error names it and nothing is consumed."""
        return DepthColumns(self.table(columns.table))


def _camera_bounds(observer: UnknownInputObserver) -> dict[str, tuple[float, float]]:
    """The box of a design for the camera, by name; raises ParameterError for any other design."""
    bounds, system = instance("observer", observer, UnknownInputObserver).box.bounds, observer.system
    if set(bounds) != set(SCHEDULED) or system.time != "continuous" or not np.array_equal(system.c, C):
        received = f"one of {system.c.shape[1]} states in a box of {', '.join(bounds)}"
        words = f"observer must be a design for camera_system in a camera_box, received {received}"
        raise ParameterError(words, field="observer")
    return bounds
