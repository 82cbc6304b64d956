"""Counts and the samples of an accelerometer as one: velocity and acceleration of the hand."""

from __future__ import annotations

from collections.abc import Sequence
from math import exp
from typing import NamedTuple

import numpy as np

from pointpred.columns import EventColumns, FloatArray
from pointpred.compiled import law, layout
from pointpred.differentiators import fused_path, sampling
from pointpred.differentiators.differentiator import Differentiator
from pointpred.differentiators.fused_path import (
    AXIS,
    COVARIANCE,
    DELAY,
    OFFSET,
    SIZE,
    STATE,
    VELOCITY,
    WEIGHT,
)
from pointpred.differentiators.kalman import SETTLED_RADIANS, START_ACCELERATION_M_S2, START_SPEED_M_S
from pointpred.errors import EventError, EventOrderError
from pointpred.events import LATEST_S
from pointpred.parameter import parameter
from pointpred.rows import REFUSED, EventRow, Row, TenFloats, event_at
from pointpred.stage import loop_beside, loop_of, offsets

FORCE_MOST_M_S2 = 1e4
"""Bound on the magnitude of a sample: a thousand times gravity."""
START_OFFSET_M_S2 = 1.0
START_WEIGHT, START_ACROSS = 0.7, 0.3
START_DELAY_S = 0.01
"""Standard deviations of what nobody has measured: offset, weights in the plane and across, delay."""
REST_M_S2 = 0.3
"""Standard deviation of the acceleration of a device that sends no events."""
DELAY_DRIFT = 1e-6
"""Variance by which the delay drifts, s^2 a second."""

# The parameters: those of sampling, the densities of the jerk m^2/s^5, of the noise m^2/s^3 and of the
# offset m^2/s^5, the variance of a position m^2, the memory of the acceleration s. What is learned: whether
# it is; the reference of the force m/s^2; state and covariance at the end of the last movement. The state:
# that of sampling; whether samples are used, whether they have a reference; the time of the filter, of the
# last sample; the reference; the averaged force; the filter.
_, JERK, NOISE, DENSITY, DRIFT, SMOOTHING_S, KNOWN = offsets(sampling.SETTINGS, 1, 1, 1, 1, 1)
_, OLD_REFERENCE, OLD, AT = offsets(KNOWN + 1, 3, SIZE + SIZE * SIZE)
_, FUSED, REFERRED, NOW, SAMPLED, REFERENCE, MEAN, FILTER, LENGTH = offsets(
    AT + sampling.STATES, 1, 1, 1, 1, 3, 3, fused_path.LENGTH
)


@layout
def fill(values: FloatArray, memory: FloatArray) -> None:
    """The settings; of the noise in m its variance."""
    sampling.fill(values, memory)
    memory[NOISE] = values[NOISE] * values[NOISE]


@law
def conclude(memory: FloatArray) -> None:
    """Keep what the movement's samples taught of the device: reference, offsets, weights, delay."""
    if memory[REFERRED] == 0.0 or memory[FUSED] == 0.0:
        return
    memory[KNOWN] = 1.0
    for i in range(3):
        memory[OLD_REFERENCE + i] = memory[REFERENCE + i]
    for i in range(SIZE + SIZE * SIZE):
        memory[OLD + i] = memory[FILTER + STATE + i]


@law
def start_fusion(memory: FloatArray) -> None:
    """From now on samples are used, with what is known of the device or with what nobody has measured."""
    memory[FUSED] = 1.0
    p = FILTER + COVARIANCE
    for i in range(OFFSET, SIZE):
        if i % AXIS >= OFFSET or i == DELAY:
            fused_path.forget(memory, FILTER, i, 0.0)
    for number in range(2):
        axis = number * AXIS
        for i in range(OFFSET, AXIS):
            own = WEIGHT + (1 if axis else 0)
            memory[FILTER + STATE + axis + i] = 1.0 if i == own else 0.0
            spread = START_WEIGHT if i < WEIGHT + 2 else START_ACROSS
            spread = START_OFFSET_M_S2 if i == OFFSET else spread
            memory[p + (axis + i) * (SIZE + 1)] = spread * spread
    memory[FILTER + STATE + DELAY] = 0.0
    memory[p + DELAY * (SIZE + 1)] = START_DELAY_S**2
    if memory[KNOWN] == 1.0:
        for i in range(SIZE):
            if i == DELAY or i % AXIS >= OFFSET:
                memory[FILTER + STATE + i] = memory[OLD + STATE + i]
                for j in range(SIZE):
                    if j == DELAY or j % AXIS >= OFFSET:
                        memory[p + i * SIZE + j] = memory[OLD + COVARIANCE + i * SIZE + j]


@law
def end_fusion(memory: FloatArray) -> None:
    """Samples are missing: from now on the offset is the acceleration, and the force is 0."""
    conclude(memory)
    for number in range(2):
        axis = number * AXIS
        now = fused_path.acceleration(memory, FILTER, axis, FILTER + fused_path.FORCE)
        memory[FILTER + STATE + axis + OFFSET] = now
        fused_path.forget(memory, FILTER, axis + OFFSET, START_ACCELERATION_M_S2**2)
        for i in range(3):
            fused_path.forget(memory, FILTER, axis + WEIGHT + i, 0.0)
    fused_path.forget(memory, FILTER, DELAY, 0.0)
    memory[FILTER + STATE + DELAY] = memory[FUSED] = 0.0
    for i in range(3):
        memory[FILTER + fused_path.FORCE + i] = 0.0


@law
def place(memory: FloatArray) -> None:
    """Put the path at its origin, at a speed that nobody knows; what is known of the device stays."""
    for number in range(2):
        axis = number * AXIS
        for i in range(VELOCITY + 1):
            memory[FILTER + STATE + axis + i] = 0.0
        fused_path.forget(memory, FILTER, axis, memory[NOISE])
        fused_path.forget(memory, FILTER, axis + VELOCITY, START_SPEED_M_S**2)
        if memory[FUSED] == 0.0:
            memory[FILTER + STATE + axis + OFFSET] = 0.0
            fused_path.forget(memory, FILTER, axis + OFFSET, START_ACCELERATION_M_S2**2)


@law
def advance(memory: FloatArray, t: float) -> None:
    """Carry the filter to ``t`` s, if that is later."""
    dt = t - memory[NOW]
    if dt <= 0.0:
        return
    if memory[FUSED] == 1.0:
        fused_path.predict(memory, FILTER, memory[DENSITY], memory[DRIFT], dt)
        memory[FILTER + COVARIANCE + DELAY * (SIZE + 1)] += DELAY_DRIFT * dt
        fused_path.remember(memory, FILTER, t - memory[AT + sampling.SINCE])
    else:
        fused_path.predict(memory, FILTER, 0.0, memory[JERK], dt)
    memory[NOW] = t


@law
def sample_at(table: FloatArray, i: int) -> tuple[float, float, float, float]:
    """A row of a table of samples as a tuple."""
    r = table[i]
    return r[0], r[1], r[2], r[3]


@law
def is_sample(sample: Row) -> bool:
    """Whether the values make a sample: all within their bounds."""
    t, fx, fy, fz = sample
    most = FORCE_MOST_M_S2
    return bool(abs(t) <= LATEST_S and abs(fx) <= most and abs(fy) <= most and abs(fz) <= most)


@law
def sense(memory: FloatArray, sample: Row) -> bool:
    """One sample of the accelerometer; whether it was accepted."""
    t, fx, fy, fz = sample
    if not is_sample(sample) or (memory[REFERRED] == 1.0 and t < memory[SAMPLED]):
        return False
    if memory[REFERRED] == 0.0:
        memory[REFERENCE], memory[REFERENCE + 1], memory[REFERENCE + 2] = fx, fy, fz
        if memory[KNOWN] == 1.0:
            for i in range(3):
                memory[REFERENCE + i] = memory[OLD_REFERENCE + i]
        memory[REFERRED], memory[SAMPLED] = 1.0, t
    if memory[FUSED] == 0.0:
        start_fusion(memory)
    keep = exp(-(t - memory[SAMPLED]) / memory[SMOOTHING_S])
    memory[SAMPLED] = t
    started = memory[AT + sampling.STARTED] == 1.0
    still = not started or t - memory[AT + sampling.T] > memory[sampling.GAP_S]
    now = fx - memory[REFERENCE], fy - memory[REFERENCE + 1], fz - memory[REFERENCE + 2]
    for i in range(3):
        force = FILTER + fused_path.FORCE + i
        memory[MEAN + i] = keep * memory[MEAN + i] + (1.0 - keep) * now[i]
        memory[force] = now[i] if still else 0.5 * (memory[force] + now[i])
    if still:
        fused_path.rest(memory, FILTER, 0, REST_M_S2**2)
        fused_path.rest(memory, FILTER, fused_path.SECOND, REST_M_S2**2)
    else:
        advance(memory, t)
    for i in range(3):
        memory[FILTER + fused_path.FORCE + i] = now[i]
    return True


@law
def settle_s(memory: FloatArray) -> float:
    """Time that the stationary filter without samples takes at the mean rate so far."""
    intervals = max(memory[AT + sampling.SAMPLES] - 1.0, 1.0)
    period = (memory[AT + sampling.T] - memory[AT + sampling.SINCE]) / intervals
    return float(SETTLED_RADIANS * (memory[NOISE] * period / memory[JERK]) ** (1.0 / 6.0))


@law
def step(memory: FloatArray, event: EventRow) -> TenFloats:
    """One event through the filter of both axes."""
    verdict, _, _, _, start = sampling.accept(memory, AT, event)
    if verdict == sampling.REFUSED:
        return REFUSED
    t = memory[AT + sampling.T]
    if memory[FUSED] == 1.0 and t - memory[SAMPLED] > memory[sampling.GAP_S]:
        end_fusion(memory)
    if verdict == sampling.RESTARTED:
        place(memory)
        memory[NOW] = t
        for i in range(fused_path.FIRST, fused_path.LENGTH):
            memory[FILTER + i] = 0.0
        fused_path.remember(memory, FILTER, 0.0)
    elif verdict == sampling.MOVED:
        advance(memory, t)
        now, ahead, noise = memory[NOW] - memory[AT + sampling.SINCE], memory[NOW] - t, memory[NOISE]
        fused_path.measure(memory, FILTER, 0, now, ahead, memory[AT + sampling.U], noise)
        fused_path.measure(memory, FILTER, fused_path.SECOND, now, ahead, memory[AT + sampling.V], noise)
    x = FILTER + STATE
    velocity = memory[x + VELOCITY], memory[x + fused_path.SECOND + VELOCITY]
    mean = MEAN if memory[FUSED] == 1.0 else FILTER + fused_path.FORCE
    acceleration = (
        fused_path.acceleration(memory, FILTER, 0, mean),
        fused_path.acceleration(memory, FILTER, fused_path.SECOND, mean),
    )
    settled = sampling.settled(memory, AT, 4.0, settle_s(memory))
    return sampling.motion(memory, AT, event, (velocity, acceleration), settled, start)


loop = loop_of(step, event_at, conclude)
loop_sensing = loop_beside(step, event_at, sense, sample_at, conclude)


class Sensor(NamedTuple):
    """How an accelerometer stands on its device: the acceleration is ``weights`` f + ``offset``, m/s^2.

    ``weights`` has shape (2, 3): alignment and scale, inverted; ``offset`` is gravity and bias as they act on
    the two axes, with their sign changed; positions are stamped ``delay_s`` s late.
    """

    weights: FloatArray
    offset: FloatArray
    delay_s: float


class InertialDifferentiator(Differentiator):
    """Fuses positions with the samples of an accelerometer that is fixed to the device, in one filter.

    Assumes a sensor whose angle, bias, scale and delay stay as they are but for a slow drift, and a device
    that rests where it sends no event for ``gap_s``. The weights of its three axes, gravity and bias as they
    act on the two axes of the device, and the delay of the positions behind the samples are estimated.
    Turning of the device is not in the model: it acts as noise. Without samples, or when the last is older
    than ``gap_s``, it is ``KalmanDifferentiator``.

    Parameters: ``jerk_density`` as for that, used without samples; ``noise_m`` the standard deviation of a
    position, which must also cover what quantisation leaves from one event to the next: the default suits
    counts; ``force_density`` m^2/s^3 of white noise in the acceleration, what the model leaves out included;
    ``drift_density`` m^2/s^5 of the offset; ``smoothing_s`` the time over which the acceleration is averaged.
    Memory: 886 floats. ``sense`` consumes a sample, ``update`` an event and returns a Motion. What it learns
    of the device stays over ``reset``. Raises ParameterError, and EventError and EventOrderError from
    ``update`` and ``sense``.

    Reference: docs/guide/accelerometer.md; proposed in Khalin 2022, section 5.1.
    """

    jerk_density: float = parameter("m^2/s^5", 1e-3, 1e9, "spectral density of the jerk", default=30.0)
    noise_m: float = parameter("m", 1e-8, 1e-1, "standard deviation of a measured position", default=1e-4)
    force_density: float = parameter(
        "m^2/s^3", 1e-12, 1e3, "spectral density of the noise in the acceleration", default=1e-4
    )
    drift_density: float = parameter(
        "m^2/s^5", 1e-12, 1e3, "spectral density of the drift of gravity and bias", default=1e-3
    )
    smoothing_s: float = parameter(
        "s", 1e-4, 1.0, "time over which the acceleration is averaged", default=3e-3
    )
    step = staticmethod(step)
    loop = staticmethod(loop)
    at = AT
    learned = AT - KNOWN
    states = LENGTH - AT
    fill = staticmethod(fill)
    conclude = staticmethod(conclude)

    def settings(self) -> FloatArray:
        """What stands first in the memory."""
        return self.filled(KNOWN)

    def sense(self, t: float, ax: float, ay: float, az: float) -> None:
        """Consume one sample: time in s, specific force in m/s^2 along the axes of the sensor.

        Raises EventError for what is no number within its bounds, and EventOrderError where the time runs
        backwards against the sample before; the memory is then unchanged.
        """
        if not sense(self._memory, (float(t), float(ax), float(ay), float(az))):
            raise refusal_of_sample((t, ax, ay, az), float(self._memory[SAMPLED]))

    def refusal_of_row(self, events: EventColumns, row: int) -> EventError:
        """Why ``run`` refuses a row of a table: one of the samples before it, or the event itself."""
        beside = events.rows(row, row + 1).accelerations.table
        earlier = events.rows(0, row).accelerations.table[:, 0]
        last_t = float(earlier[-1]) if len(earlier) and not events.begin[row] else -LATEST_S
        for sample in map(tuple, beside.tolist()):
            if not is_sample(sample) or sample[0] < last_t:
                reason = refusal_of_sample(sample, last_t)
                return type(reason)(f"row {row}: {reason}", field=reason.field, value=reason.value)
            last_t = sample[0]
        return super().refusal_of_row(events, row)

    @property
    def sensor(self) -> Sensor | None:
        """What is known of the sensor at the last sample; ``None`` where no sample is used."""
        memory = self._memory
        if memory[FUSED] == 0.0:
            return None
        state = memory[FILTER + STATE : FILTER + STATE + SIZE]
        weights = np.array([state[WEIGHT:AXIS], state[AXIS + WEIGHT : DELAY]])
        offset = state[[OFFSET, AXIS + OFFSET]] - weights @ memory[REFERENCE : REFERENCE + 3]
        return Sensor(weights, offset, float(state[DELAY]))

    def walk_events(self, events: EventColumns) -> FloatArray:
        """``walk`` over events with the samples beside them."""
        beside = events.accelerations
        if not len(beside):
            return self.walk(events.begin, events.table)
        out = np.full((len(events), self.width), np.nan)
        loop_sensing(self._memory, self._first, events.begin, events.table, out, beside.table, beside.before)
        return out


def refusal_of_sample(sample: Sequence[float], last_t: float) -> EventError:
    """Why a sample was refused; ``last_t`` s is the time of the one before it."""
    t, *force = sample
    if not abs(t) <= LATEST_S:
        return EventError(
            f"t of a sample must lie in [-{LATEST_S:g}, {LATEST_S:g}], received {t!r}", field="t"
        )
    for name, value in zip(("ax", "ay", "az"), force, strict=True):
        if not abs(value) <= FORCE_MOST_M_S2:
            bounds = f"[-{FORCE_MOST_M_S2:g}, {FORCE_MOST_M_S2:g}] m/s^2"
            return EventError(f"{name} of a sample must lie in {bounds}, received {value!r}", field=name)
    message = f"t of a sample must not run backwards: received {t!r} s after {last_t!r} s"
    return EventOrderError(message, field="t", value=t)
