"""An extended Kalman filter of a point's position and the camera's velocity, compared with the observer."""

from __future__ import annotations

from math import nan, sqrt

import msgspec
import numpy as np

from pointpred.compiled import law
from pointpred.parameter import parameter
from pointpred.records import BoolArray, FloatArray, Row
from pointpred.stage import loop_into, offsets
from pointpred_observers.camera import kinematics, starting
from pointpred_observers.camera.camera_stage import CameraStage, usable
from pointpred_observers.camera.samples import FOCAL_PX, CameraColumns, CameraSample, SampleRow

NEAREST_M = 1e-4
"""The filter restarts if the point comes closer than this or goes behind the camera."""

# The parameters. The state: whether there was a sample, its time, angular velocity and acceleration, the
# mode, the number of restarts; p then v, its covariance row by row, scratch space for a column, the
# initialisation.
FOCAL, NOISE, GYRO, ACCEL, SHARE, GAP_S, STARTED, T, WX, WY, WZ, AX, AY, AZ, MODE, RESTARTS, STATE = range(17)
_, SPREAD, COLUMN, START, END = offsets(STATE + 6, 36, 6, starting.STATES)
WAITING, STARTING, RUNNING = 0.0, 1.0, 2.0

# The answer: time, p then v and its covariance, the number of restarts, whether it runs.
_, OUT_STATE, OUT_SPREAD, OUT_RESTARTS, OUT_RUNNING, WIDTH = offsets(1, 6, 36, 1, 1)


@law
def correct(memory: FloatArray, measured: float, axis: int, x: float, y: float, z: float) -> None:
    """One coordinate of the image, linearised at the prediction (x, y, z)."""
    side = y if axis else x
    near, far = 1.0 / z, -side / (z * z)
    for i in range(6):
        memory[COLUMN + i] = memory[SPREAD + 6 * i + axis] * near + memory[SPREAD + 6 * i + 2] * far
    total = memory[COLUMN + axis] * near + memory[COLUMN + 2] * far + memory[NOISE]
    expected = side * near + (memory[STATE + axis] - side) * near + (memory[STATE + 2] - z) * far
    share = (measured - expected) / total
    for i in range(6):
        memory[STATE + i] += memory[COLUMN + i] * share
    for i in range(6):
        for j in range(6):
            memory[SPREAD + 6 * i + j] -= memory[COLUMN + i] * memory[COLUMN + j] / total


@law
def predict(memory: FloatArray, dt: float, w: kinematics.Vector, a: kinematics.Vector) -> None:
    """Propagate over ``dt`` s: the state and its covariance, or the sums of the initialisation."""
    turn = (
        0.5 * dt * (memory[WX] + w[0]),
        0.5 * dt * (memory[WY] + w[1]),
        0.5 * dt * (memory[WZ] + w[2]),
    )
    running = memory[MODE] == RUNNING
    # During the initialisation the point's position, and so the effect of a rotation error, is unknown.
    gyro, accel = memory[GYRO] * dt if running else 0.0, memory[ACCEL] * dt
    state = STATE if running else START + starting.FORCE
    spread = SPREAD if running else START + starting.NOISE
    if not running:
        for i in range(6):
            kinematics.carry(memory, START + starting.CARRY + i, 6, dt, turn)
    kinematics.carry(memory, state, 1, dt, turn)
    kinematics.push(memory, state, dt, turn, (memory[AX], memory[AY], memory[AZ]), a)
    kinematics.turn_covariance(memory, spread, dt, turn)
    kinematics.add_noise(memory, spread, state, gyro, accel)


@law
def look(memory: FloatArray, x: float, y: float) -> None:
    """Process an image: correct the state, or initialise it."""
    if memory[MODE] == WAITING:
        starting.begin(memory, START)
        memory[MODE] = STARTING
    if memory[MODE] == STARTING:
        starting.take(memory, START, x, y, memory[NOISE])
        if starting.start(memory, START, STATE, SPREAD, memory[NOISE], memory[SHARE]):
            memory[MODE] = RUNNING
        return
    px, py, pz = memory[STATE], memory[STATE + 1], memory[STATE + 2]
    if pz > NEAREST_M:
        correct(memory, x, 0, px, py, pz)
        correct(memory, y, 1, px, py, pz)


@law
def step(memory: FloatArray, row: FloatArray, out: FloatArray) -> None:
    """One ``SampleRow``: t, (p, v), covariance, restarts and running into ``out``, which is NaN before."""
    t, x, y, wx, wy, wz, ax, ay, az = row[0], row[1], row[2], row[3], row[4], row[5], row[6], row[7], row[8]
    sample = SampleRow(t, x, y, wx, wy, wz, ax, ay, az)
    if not usable(sample, memory[STARTED], memory[T], memory[GAP_S]):
        return
    if memory[MODE] != WAITING:
        predict(memory, t - memory[T], (wx, wy, wz), (ax, ay, az))
    if x == x:
        look(memory, x / memory[FOCAL], y / memory[FOCAL])
    if memory[MODE] == RUNNING and not memory[STATE + 2] > NEAREST_M:
        memory[MODE] = WAITING
        memory[RESTARTS] += 1.0
    memory[STARTED], memory[T] = 1.0, t
    memory[WX], memory[WY], memory[WZ] = wx, wy, wz
    memory[AX], memory[AY], memory[AZ] = ax, ay, az
    out[0], out[OUT_RESTARTS], out[OUT_RUNNING] = t, memory[RESTARTS], 0.0
    if memory[MODE] == RUNNING:
        for i in range(42):
            out[OUT_STATE + i] = memory[STATE + i]
        out[OUT_RUNNING] = 1.0


def answer(memory: FloatArray, sample: Row) -> FloatArray:
    """``step`` for one sample without a table."""
    out = np.empty(WIDTH)
    out.fill(nan)
    step(memory, np.array(sample), out)
    return out


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
        return sqrt(float(slope @ self.covariance[np.ix_((2, 5), (2, 5))] @ slope))


class PointTrack(msgspec.Struct, frozen=True):
    """Estimates as arrays, NaN before the filter started; a state is 6 numbers, a covariance 6 x 6."""

    t: FloatArray
    state: FloatArray
    covariance: FloatArray
    running: BoolArray
    restarts: int

    def at(self, row: int) -> PointEstimate | None:
        """One row as a record, ``None`` before the filter started."""
        if not self.running[row]:
            return None
        return PointEstimate(float(self.t[row]), self.state[row], self.covariance[row], self.restarts)


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

    >>> from pointpred_observers.camera.samples import simulate
    >>> from pointpred_observers.camera.scenario import SCENARIOS
    >>> samples, truth = simulate(SCENARIOS["paper"], focal_px=800.0, duration_s=5.0)
    >>> track = PointFilter(focal_px=800.0, noise_px=0.1).run(samples)
    >>> bool(abs(track.state[-1, 2] - truth.p[-1, 2]) < 5e-3)
    True
    """

    focal_px: float = parameter("px", *FOCAL_PX, "focal length: image plane to px")
    noise_px: float = parameter(
        "px", 1e-3, 1e3, "standard deviation of a coordinate in the image", default=1.0
    )
    gyro_noise: float = parameter(
        "rad/s/sqrt(Hz)", 0.0, 1.0, "density of the gyroscope's white noise", default=0.0
    )
    accel_noise: float = parameter(
        "m/s^2/sqrt(Hz)", 0.0, 10.0, "density of the accelerometer's white noise", default=0.0
    )
    share: float = parameter(
        "", 1e-3, 0.5, "relative standard deviation of the depth at which it starts", default=0.1
    )
    gap_s: float = parameter(
        "s", 1e-3, 10.0, "longest silence of the inertial sensor that is bridged", default=1.0
    )
    states = END - STARTED
    width = WIDTH
    loop = staticmethod(loop_into(step))
    step = staticmethod(answer)
    at_started, at_t, at_gap = STARTED, T, GAP_S

    def settings(self) -> list[float]:
        """The beginning of the memory, with variances instead of standard deviations."""
        image = (float(self.noise_px) / float(self.focal_px)) ** 2
        inertial = [float(self.gyro_noise) ** 2, float(self.accel_noise) ** 2]
        return [float(self.focal_px), image, *inertial, float(self.share), float(self.gap_s)]

    def update(self, sample: CameraSample, /) -> PointEstimate | None:
        """Consume one sample; ``None`` before the start. A refused sample changes nothing."""
        row = self.advance(sample)
        if row[OUT_RUNNING] != 1.0:
            return None
        state, covariance = row[OUT_STATE:OUT_SPREAD], row[OUT_SPREAD:OUT_RESTARTS]
        return PointEstimate(row[0], np.array(state), covariance.reshape(6, 6), int(row[OUT_RESTARTS]))

    def run(self, columns: CameraColumns) -> PointTrack:
        """Consume a table; a refused row raises its error and nothing is consumed."""
        out = self.table(columns)
        state, covariance = out[:, OUT_STATE:OUT_SPREAD], out[:, OUT_SPREAD:OUT_RESTARTS]
        restarts = int(out[-1, OUT_RESTARTS]) if len(out) else 0
        running = out[:, OUT_RUNNING] == 1.0
        return PointTrack(out[:, 0], state, covariance.reshape(-1, 6, 6), running, restarts)
