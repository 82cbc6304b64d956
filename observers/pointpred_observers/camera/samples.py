"""Samples of a camera with an inertial sensor: records, columns, the stages on them, gravity removed."""

from __future__ import annotations

from math import nan, sqrt
from typing import Annotated, Any, ClassVar, NamedTuple

import numpy as np

from pointpred.columns import Columns
from pointpred.compiled import law
from pointpred.errors import EventError, EventOrderError
from pointpred.layout import Layout
from pointpred.parameter import is_number, option, parameter
from pointpred.records import LATEST_S, FloatArray
from pointpred.stage import CompiledStage, loop_into
from pointpred_observers.camera.kinematics import back
from pointpred_observers.numerics.matrices import matrix, wrong

FOCAL_PX = (1.0, 1e6)
LARGEST_PX, LARGEST_W, LARGEST_A = 1e6, 1e3, 1e4
"""Bounds on positions px, angular velocities rad/s and accelerations m/s^2."""
AT_REST = 0.1
"""A camera counts as resting if the measured force differs from g by less than this share."""
SUBSTEP_S = 0.05
"""Longest step of an integration."""


class CameraSample(NamedTuple):
    """A reading of the inertial sensor, with the tracked point if an image was taken at that time.

    ``t`` s; ``x y`` px from the principal point, x right, y down, both NaN without an image; ``wx wy wz``
    rad/s; ``ax ay az`` m/s^2 of the motion in the camera's frame, gravity already removed (10): ``Gravity``.
    """

    t: float
    x: float
    y: float
    wx: float
    wy: float
    wz: float
    ax: float
    ay: float
    az: float


class CameraColumns(Columns[CameraSample]):
    """Camera samples as columns; x and y are NaN where there is no image."""

    names = CameraSample._fields

    def _record(self, row: list[float]) -> CameraSample:
        return CameraSample(*row)


@law
def usable(sample: CameraSample, started: float, last_t: float, gap_s: float) -> bool:
    """Whether a sample can be used: within the bounds, after the last one and within the longest gap."""
    t, x, y, wx, wy, wz, ax, ay, az = sample
    if not (abs(t) <= LATEST_S and abs(wx) <= LARGEST_W and abs(wy) <= LARGEST_W and abs(wz) <= LARGEST_W):
        return False
    if not (abs(ax) <= LARGEST_A and abs(ay) <= LARGEST_A and abs(az) <= LARGEST_A):
        return False
    if not ((x != x and y != y) or (abs(x) <= LARGEST_PX and abs(y) <= LARGEST_PX)):
        return False
    return started != 1.0 or (last_t < t <= last_t + gap_s)


class CameraStage(CompiledStage):
    """A stage whose rows are camera samples.

    A subclass names its law ``step(memory, row, out)``, which leaves out[0] NaN where it refuses a row, and
    its ``layout``, with ``started`` and ``t`` in the state and ``gap_s`` in the settings.
    """

    layout: ClassVar[Any]

    def advance(self, sample: CameraSample, more: tuple[float, ...] = ()) -> Any:
        """The row of answers to one sample; raises EventError or EventOrderError and then changes nothing."""
        values = _numbers(sample) + more
        out = np.full(self.width, nan)
        type(self).step(self._memory, np.array(values), out)
        if out[0] != out[0]:
            raise self._reason(values, self._last())
        return out

    def table(self, rows: FloatArray) -> FloatArray:
        """The rows of answers to a table; a refused row raises its error and nothing is consumed."""
        before = self.remembered()
        out = self.walk(np.zeros(len(rows), np.bool_), rows)
        refused = out[:, 0] != out[:, 0]
        if refused.any():
            row = int(refused.argmax())
            self.recall(before)
            last_t = float(rows[row - 1, 0]) if row else self._last()
            reason = self._reason(tuple(rows[row].tolist()), last_t)
            raise type(reason)(f"row {row}: {reason}", field=reason.field, value=reason.value)
        return out

    def _last(self) -> float | None:
        state = self.layout(self._memory).state
        return float(state.t) if state.started == 1.0 else None

    def _reason(self, values: tuple[float, ...], last_t: float | None) -> EventError:
        bounds = (LATEST_S, LARGEST_PX, LARGEST_PX, *[LARGEST_W] * 3, *[LARGEST_A] * 3)
        missing = [one != one for one in values[1:3]]
        if any(missing) and not all(missing):
            return EventError(f"x and y come together or not at all, received {values[1:3]}")
        for name, value, most in zip(CameraColumns.names, values, bounds, strict=False):
            if not abs(value) <= most and not (name in "xy" and all(missing)):
                words = f"{name} must lie in [{-most:g}, {most:g}], received {value!r}"
                return EventError(words, field=name, value=value)
        t = values[0]
        if last_t is not None and t <= last_t:
            words = f"t must increase: received {t!r} s after {last_t!r} s"
            return EventOrderError(words, field="t", value=t)
        most = float(self.layout(self._memory).settings.gap_s)
        words = f"the inertial sensor was silent from {last_t!r} s to {t!r} s, at most {most:g} s are bridged"
        return EventError(words, field="t", value=t)


def _numbers(sample: CameraSample) -> CameraSample:
    """A sample as plain numbers."""
    if not isinstance(sample, CameraSample):
        raise EventError(f"a sample must be a CameraSample, received {sample!r:.80}")
    for name, value in zip(CameraColumns.names, sample, strict=True):
        if not is_number(value):
            raise EventError(f"{name} must be a number, received {value!r}", field=name, value=value)
    return CameraSample(*map(float, sample))


class Settings(Layout):
    """g in m/s^2, up at the first sample (zero: along the force measured there), the longest gap in s."""

    g: float
    up: Annotated[FloatArray, 3]
    gap_s: float


class State(Layout):
    """The last sample, and the unit vector of up in the camera's frame."""

    started: float
    t: float
    wx: float
    wy: float
    wz: float
    up: Annotated[FloatArray, 3]


class Memory(Layout):
    """The settings, then the state."""

    settings: Settings
    state: State


@law
def step(memory: Memory, row: FloatArray, out: FloatArray) -> None:
    """A sample, then up there (NaN: not given): the sample without gravity into ``out``, or nothing."""
    settings, s = memory.settings, memory.state
    t, wx, wy, wz, ax, ay, az = row[0], row[3], row[4], row[5], row[6], row[7], row[8]
    if not usable(CameraSample(t, row[1], row[2], wx, wy, wz, ax, ay, az), s.started, s.t, settings.gap_s):
        return
    ux, uy, uz = row[9], row[10], row[11]
    if ux != ux:
        if s.started == 1.0:
            h = 0.5 * (t - s.t)
            turn = h * (s.wx + wx), h * (s.wy + wy), h * (s.wz + wz)
            ux, uy, uz = back(turn, (s.up[0], s.up[1], s.up[2]))
        else:
            ux, uy, uz = settings.up[0], settings.up[1], settings.up[2]
    if ux == 0.0 and uy == 0.0 and uz == 0.0:
        ux, uy, uz = ax, ay, az
        if not abs(sqrt(ax * ax + ay * ay + az * az) - settings.g) <= AT_REST * settings.g:
            return
    size = sqrt(ux * ux + uy * uy + uz * uz)
    s.up[0], s.up[1], s.up[2] = ux / size, uy / size, uz / size
    s.started, s.t = 1.0, t
    s.wx, s.wy, s.wz = wx, wy, wz
    for i in range(6):
        out[i] = row[i]
    for i in range(3):
        out[6 + i] = row[6 + i] - settings.g * s.up[i]


class Gravity(CameraStage):
    """Removes gravity from what an accelerometer measures: a stage before ``CameraPipeline`` and the others.

    An accelerometer measures the specific force, the acceleration of the motion and g upwards, also at rest.
    Up in the camera's frame is given at the first sample or follows from the force there, which assumes that
    the camera rests; from then on the gyroscope turns it, or it is given at samples, as an estimator of the
    attitude knows it. A bias of the gyroscope turns it away: an error of 0.1 degrees is 0.017 m/s^2.

    a = f - g R'e_z, up = R'e_z, up' = -w x up, exact for w that is linear between two samples and does not
    change its direction.

    Parameters: ``up`` at the first sample, 3 numbers of any length, such as (0, -1, 0) for a level camera,
    or ``None``; ``g`` m/s^2; ``gap_s`` s. Memory: 13 floats. Raises ParameterError; EventError and
    EventOrderError from ``update`` and ``run``.

    Reference: Benyoucef et al. 2021, equations (9), (10), remark 2.

    >>> gravity = Gravity(up=(0.0, -1.0, 0.0))
    >>> gravity.update(CameraSample(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -9.80665, 0.5))[6:]
    (0.0, 0.0, 0.5)
    """

    up: Any = option("opposite to gravity at the first sample, in the camera's frame", default=None)
    g: float = parameter("m/s^2", 1e-3, 1e3, "size of gravity", default=9.80665)
    gap_s: float = parameter("s", 1e-3, 10.0, "longest silence that is bridged", default=1.0)
    states = State.length
    width = len(CameraSample._fields)
    layout = Memory
    loop = staticmethod(loop_into(step))
    step = staticmethod(step)

    def settings(self) -> list[float]:
        """The beginning of the memory."""
        up = np.zeros(3) if self.up is None else _directions(self.up, 1)[0]
        return [float(self.g), *up.tolist(), float(self.gap_s)]

    def update(self, sample: CameraSample, /, up: Any = None) -> CameraSample:
        """The sample without gravity; ``up`` there if it is known. A refused one changes nothing."""
        given = (nan, nan, nan) if up is None else tuple(_directions(up, 1)[0].tolist())
        return CameraSample(*self.advance(sample, given).tolist())

    def run(self, columns: CameraColumns, up: Any = None) -> CameraColumns:
        """A table without gravity; ``up`` at each row if it is known, (rows, 3)."""
        rows = len(columns)
        given = np.full((rows, 3), nan) if up is None else _directions(up, rows)
        return CameraColumns(self.table(np.hstack([columns.table, given])))

    def _reason(self, values: tuple[float, ...], last_t: float | None) -> EventError:
        if last_t is None and usable(CameraSample(*values[:9]), 0.0, 0.0, 0.0):
            felt = f"{np.linalg.norm(values[6:9]):g} m/s^2 were measured for g = {self.g:g} m/s^2"
            return EventError(f"the camera must rest at the first sample, where {felt}, or give up")
        return super()._reason(values, last_t)


def _directions(up: Any, rows: int) -> FloatArray:
    found = matrix("up", up, rows, 3)
    if not found.any(axis=1).all():
        raise wrong("up", "must not be zero", up)
    return found
