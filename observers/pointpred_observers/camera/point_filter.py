"""An extended Kalman filter of a point's position and the camera's velocity, compared with the observer."""

from __future__ import annotations

from math import sqrt
from typing import Annotated

import msgspec
import numpy as np

from pointpred.compiled import law
from pointpred.layout import Layout
from pointpred.parameter import parameter
from pointpred.records import BoolArray, FloatArray
from pointpred.stage import loop_into
from pointpred_observers.camera import kinematics
from pointpred_observers.camera.samples import FOCAL_PX, CameraColumns, CameraSample, CameraStage, usable

NEAREST_M = 1e-4
"""The filter restarts if the point comes closer than this or goes behind the camera."""

WAITING, STARTING, RUNNING = 0.0, 1.0, 2.0


class Settings(Layout):
    """Focal length in px; variances: of a coordinate of the image, densities of the sensors; share, gap."""

    focal_px: float
    noise: float
    gyro: float
    accel: float
    share: float
    gap_s: float


class State(Layout):
    """The last sample of the inertial sensor, the mode; (p, v), its covariance, and what starts them."""

    started: float
    t: float
    wx: float
    wy: float
    wz: float
    ax: float
    ay: float
    az: float
    mode: float
    restarts: float
    state: Annotated[FloatArray, 6]
    spread: kinematics.Matrix
    column: Annotated[FloatArray, 6]
    """Space for a correction."""
    start: kinematics.Start


class Memory(Layout):
    """The settings, then the state."""

    settings: Settings
    state: State


class Answer(Layout):
    """Time, (p, v) and its covariance, the number of restarts, whether it runs."""

    t: float
    state: Annotated[FloatArray, 6]
    spread: kinematics.Matrix
    restarts: float
    running: float


@law
def correct(s: State, noise: float, measured: float, axis: int, predicted: kinematics.Vector) -> None:
    """One coordinate of the image, linearised at the prediction (x, y, z)."""
    x, y, z = predicted
    side = y if axis else x
    near, far = 1.0 / z, -side / (z * z)
    for i in range(6):
        s.column[i] = s.spread.m[i, axis] * near + s.spread.m[i, 2] * far
    total = s.column[axis] * near + s.column[2] * far + noise
    expected = side * near + (s.state[axis] - side) * near + (s.state[2] - z) * far
    share = (measured - expected) / total
    for i in range(6):
        s.state[i] += s.column[i] * share
    for i in range(6):
        for j in range(6):
            s.spread.m[i, j] -= s.column[i] * s.column[j] / total


@law
def predict(memory: Memory, dt: float, w: kinematics.Vector, a: kinematics.Vector) -> None:
    """Propagate over ``dt`` s: the state and its covariance, or the sums of the initialisation."""
    settings, s = memory.settings, memory.state
    turn = 0.5 * dt * (s.wx + w[0]), 0.5 * dt * (s.wy + w[1]), 0.5 * dt * (s.wz + w[2])
    before, accel = (s.ax, s.ay, s.az), settings.accel * dt
    if s.mode == RUNNING:
        kinematics.propagate(s.state, s.spread, dt, turn, (before, a), settings.gyro * dt, accel)
        return
    # During the initialisation the point's position, and so the effect of a rotation error, is unknown.
    for i in range(6):
        kinematics.carry_column(s.start.phi, i, dt, turn)
    kinematics.propagate(s.start.g, s.start.noise, dt, turn, (before, a), 0.0, accel)


@law
def look(memory: Memory, x: float, y: float) -> None:
    """Process an image: correct the state, or initialise it."""
    settings, s = memory.settings, memory.state
    if s.mode == WAITING:
        kinematics.begin_start(s.start)
        s.mode = STARTING
    if s.mode == STARTING:
        kinematics.take_image(s.start, x, y, settings.noise)
        if kinematics.started(s.start, s.state, s.spread, settings.noise, settings.share):
            s.mode = RUNNING
        return
    predicted = s.state[0], s.state[1], s.state[2]
    if predicted[2] > NEAREST_M:
        correct(s, settings.noise, x, 0, predicted)
        correct(s, settings.noise, y, 1, predicted)


@law
def step(memory: Memory, row: FloatArray, out: Answer) -> None:
    """One ``CameraSample``: t, (p, v), covariance, restarts and running into ``out``, which is NaN before."""
    t, x, y, wx, wy, wz, ax, ay, az = row[0], row[1], row[2], row[3], row[4], row[5], row[6], row[7], row[8]
    settings, s = memory.settings, memory.state
    if not usable(CameraSample(t, x, y, wx, wy, wz, ax, ay, az), s.started, s.t, settings.gap_s):
        return
    if s.mode != WAITING:
        predict(memory, t - s.t, (wx, wy, wz), (ax, ay, az))
    if x == x:
        look(memory, x / settings.focal_px, y / settings.focal_px)
    if s.mode == RUNNING and not s.state[2] > NEAREST_M:
        s.mode = WAITING
        s.restarts += 1.0
    s.started, s.t = 1.0, t
    s.wx, s.wy, s.wz = wx, wy, wz
    s.ax, s.ay, s.az = ax, ay, az
    out.t, out.restarts, out.running = t, s.restarts, 0.0
    if s.mode == RUNNING:
        for i in range(6):
            out.state[i] = s.state[i]
            for j in range(6):
                out.spread.m[i, j] = s.spread.m[i, j]
        out.running = 1.0


class PointEstimate(msgspec.Struct, frozen=True):
    """Point position m and camera velocity m/s, both in the camera's frame, with their covariance.

    ``state`` = (X, Y, Z, v_x, v_y, v_z); ``restarts`` counts the filter's restarts.
    """

    t: float
    state: FloatArray
    covariance: FloatArray
    restarts: int = 0

    @property
    def chi(self) -> float:
        """1/Z, 1/m."""
        return 1.0 / float(self.state[2])

    @property
    def eta(self) -> float:
        """v_z/Z, 1/s."""
        return float(self.state[5]) * self.chi

    @property
    def depth_spread(self) -> float:
        """Standard deviation of Z, m."""
        return sqrt(float(self.covariance[2, 2]))

    @property
    def eta_spread(self) -> float:
        """Standard deviation of v_z/Z, 1/s, to first order."""
        slope = np.array([-self.eta * self.chi, self.chi])
        return sqrt(float(slope @ self.covariance[2::3, 2::3] @ slope))


class PointTrack(msgspec.Struct, frozen=True):
    """Estimates as arrays, NaN before the filter started; a state is 6 numbers, a covariance 6 x 6."""

    t: FloatArray
    state: FloatArray
    covariance: FloatArray
    running: BoolArray
    restarts: int


class PointFilter(CameraStage):
    """Extended Kalman filter of (p, v) from a tracked point, a gyroscope and an accelerometer.

    Assumes sensors without bias, gravity already removed, and independent pixel errors of known size.
    Prediction is exactly linear in these coordinates; only the image is linearised, so the filter needs a
    rough depth first: noise-compensated pseudo-linear least squares over the images so far starts it once the
    depth's standard deviation is ``share`` of the depth. Before, it returns ``None``, and always if the
    images do not determine the depth: a camera at rest, pure rotation, or motion along the ray of the point.
    It restarts, and counts that, if the point comes closer than 0.1 mm.

    p' = -v - w x p, v' = a - w x v; x = X/Z, y = Y/Z.

    Parameters: ``focal_px`` px; ``noise_px`` px, standard deviation of a coordinate (n / sqrt(3) for noise
    uniform in +-n); ``gyro_noise`` rad/s/sqrt(Hz); ``accel_noise`` m/s^2/sqrt(Hz); ``share`` of the depth:
    above 0.15 some runs start wrong and do not recover; ``gap_s`` s. Memory: 274 floats. Returns
    PointEstimate or ``None`` from ``update``, PointTrack from ``run``. Raises ParameterError; EventError and
    EventOrderError from ``update`` and ``run``.

    Reference: Bar-Shalom, Li, Kirubarajan 2001, section 10.3 (extended Kalman filter) and 5.4 (consistency).

    >>> from pointpred_observers.camera import SCENARIOS, simulate
    >>> samples, truth = simulate(SCENARIOS["paper"], focal_px=800.0, duration_s=5.0)
    >>> track = PointFilter(focal_px=800.0, noise_px=0.1).run(samples)
    >>> bool(abs(track.state[-1, 2] - truth.p[-1, 2]) < 5e-3)
    True
    """

    focal_px: float = parameter("px", *FOCAL_PX, "focal length: image plane to px")
    noise_px: float = parameter("px", 1e-3, 1e3, "standard deviation in the image", default=1.0)
    gyro_noise: float = parameter("rad/s/sqrt(Hz)", 0.0, 1.0, "white noise of the gyroscope", default=0.0)
    accel_noise: float = parameter("m/s^2/sqrt(Hz)", 0.0, 10.0, "that of the accelerometer", default=0.0)
    share: float = parameter("", 1e-3, 0.5, "relative spread of the depth at which it starts", default=0.1)
    gap_s: float = parameter("s", 1e-3, 10.0, "longest silence that is bridged", default=1.0)
    states = State.length
    width = Answer.length
    layout = Memory
    loop = staticmethod(loop_into(step))
    step = staticmethod(step)

    def settings(self) -> list[float]:
        """The beginning of the memory, with variances instead of standard deviations."""
        image = (float(self.noise_px) / float(self.focal_px)) ** 2
        inertial = [float(self.gyro_noise) ** 2, float(self.accel_noise) ** 2]
        return [float(self.focal_px), image, *inertial, float(self.share), float(self.gap_s)]

    def update(self, sample: CameraSample, /) -> PointEstimate | None:
        """Consume one sample; ``None`` before the start. A refused sample changes nothing."""
        found = Answer(self.advance(sample))
        estimate = PointEstimate(found.t, found.state.copy(), found.spread.m, int(found.restarts))
        return estimate if found.running == 1.0 else None

    def run(self, columns: CameraColumns) -> PointTrack:
        """Consume a table; a refused row raises its error and nothing is consumed."""
        out = self.table(columns.table)
        t, state, covariance, restarts, running = np.split(out, (1, 7, 43, 44), axis=1)
        restarted = int(restarts[-1, 0]) if len(out) else 0
        return PointTrack(t[:, 0], state, covariance.reshape(-1, 6, 6), running[:, 0] == 1.0, restarted)
