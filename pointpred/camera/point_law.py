"""The law of the peer: an extended Kalman filter of (p, v), which does use the image."""

from __future__ import annotations

import numpy as np

from pointpred.camera import kinematics, starting
from pointpred.camera.camera_stage import usable
from pointpred.columns import BoolArray, FloatArray
from pointpred.compiled import law

NONE = float("nan")
NEAREST_M = 1e-4
"""A filter whose point comes closer than this, or goes behind the camera, begins anew."""

FOCAL_PX, NOISE, GYRO, ACCEL, SHARE, GAP_S = 0, 1, 2, 3, 4, 5
STARTED, T, WX, WY, WZ, AX, AY, AZ, MODE, AGAIN = range(6, 16)
STATE = 16  # p then v, and its covariance row by row
SPREAD = STATE + 6
START = SPREAD + 36
STATES = START + starting.STATES - 6
WAITING, STARTING, RUNNING = 0.0, 1.0, 2.0
WIDTH = 45


@law
def correct(memory: FloatArray, measured: float, axis: int, x: float, y: float, z: float) -> None:
    """One coordinate of the image, linearised at (x, y, z), where the prediction was."""
    side = y if axis else x
    near, far = 1.0 / z, -side / (z * z)
    h = np.empty(6)
    for i in range(6):
        h[i] = memory[SPREAD + 6 * i + axis] * near + memory[SPREAD + 6 * i + 2] * far
    total = h[axis] * near + h[2] * far + memory[NOISE]
    expected = side * near + (memory[STATE + axis] - side) * near + (memory[STATE + 2] - z) * far
    share = (measured - expected) / total
    for i in range(6):
        memory[STATE + i] += h[i] * share
    for i in range(6):
        for j in range(6):
            memory[SPREAD + 6 * i + j] -= h[i] * h[j] / total


@law
def predict(
    memory: FloatArray, dt: float, wx: float, wy: float, wz: float, ax: float, ay: float, az: float
) -> None:
    """Carry what is known over ``dt`` s: the state and its covariance, or the sums of the start."""
    rx = 0.5 * dt * (memory[WX] + wx)
    ry = 0.5 * dt * (memory[WY] + wy)
    rz = 0.5 * dt * (memory[WZ] + wz)
    running = memory[MODE] == RUNNING
    # While it starts the place of the point is not known yet, nor what a misjudged turn does to it.
    gyro, accel = memory[GYRO] * dt if running else 0.0, memory[ACCEL] * dt
    state = STATE if running else START + starting.FORCE
    spread = SPREAD if running else START + starting.SHAKEN
    if not running:
        for i in range(6):
            kinematics.carry(memory, START + starting.CARRY + i, 6, dt, rx, ry, rz)
    kinematics.carry(memory, state, 1, dt, rx, ry, rz)
    kinematics.push(memory, state, dt, rx, ry, rz, memory[AX], memory[AY], memory[AZ], ax, ay, az)
    kinematics.turned(memory, spread, dt, rx, ry, rz)
    kinematics.shaken(memory, spread, state, gyro, accel)


@law
def look(memory: FloatArray, x: float, y: float) -> None:
    """Take in an image: correct, or start."""
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
def step(
    memory: FloatArray,
    t: float,
    x: float,
    y: float,
    wx: float,
    wy: float,
    wz: float,
    ax: float,
    ay: float,
    az: float,
    out: FloatArray,
) -> None:
    """One sample: t, (p, v), its covariance, restarts and running into ``out``."""
    out[:] = NONE
    if not usable(t, x, y, wx, wy, wz, ax, ay, az, memory[STARTED], memory[T], memory[GAP_S]):
        return
    if memory[MODE] != WAITING:
        predict(memory, t - memory[T], wx, wy, wz, ax, ay, az)
    if x == x:
        look(memory, x / memory[FOCAL_PX], y / memory[FOCAL_PX])
    if memory[MODE] == RUNNING and not memory[STATE + 2] > NEAREST_M:
        memory[MODE] = WAITING
        memory[AGAIN] += 1.0
    memory[STARTED], memory[T] = 1.0, t
    memory[WX], memory[WY], memory[WZ] = wx, wy, wz
    memory[AX], memory[AY], memory[AZ] = ax, ay, az
    out[0], out[43], out[44] = t, memory[AGAIN], 0.0
    if memory[MODE] == RUNNING:
        out[1:43] = memory[STATE : STATE + 42]
        out[44] = 1.0


def answered(memory: FloatArray, *values: float) -> FloatArray:
    """One sample through the law, for those who have no table to write into."""
    out = np.empty(WIDTH)
    t, x, y, wx, wy, wz, ax, ay, az = values
    step(memory, t, x, y, wx, wy, wz, ax, ay, az, out)
    return out


@law
def loop(memory: FloatArray, first: int, begin: BoolArray, rows: FloatArray, out: FloatArray) -> None:
    """The same step over a table."""
    for i in range(len(rows)):
        if begin[i]:
            memory[first:] = 0.0
        r = rows[i]
        step(memory, r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8], out[i])
