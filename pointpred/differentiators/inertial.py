"""Counts and the samples of an accelerometer as one: velocity and acceleration of the hand."""

from __future__ import annotations

from math import exp

import numpy as np

from pointpred.compiled import law, layout
from pointpred.differentiators import constant_acceleration, fused_path, kalman, sampling
from pointpred.differentiators.constant_acceleration import START_ACCELERATION_M_S2, START_SPEED_M_S
from pointpred.differentiators.differentiator import Differentiator
from pointpred.differentiators.force_samples import (
    Sensor,
    is_sample,
    numbers_of_sample,
    refusal_of_sample,
    sample_at,
)
from pointpred.differentiators.fused_path import (
    AXIS,
    COVARIANCE,
    DELAY,
    DELAY_MOST_S,
    FORCE,
    OFFSET,
    SECOND,
    SIZE,
    STATE,
    VELOCITY,
    WEIGHT,
)
from pointpred.errors import EventError
from pointpred.parameter import parameter
from pointpred.records import LATEST_S, REFUSED, EventColumns, EventRow, FloatArray, Row, TenFloats, event_at
from pointpred.stage import loop_beside, loop_of, offsets

START_WEIGHT, START_ACROSS = 0.7, 0.3
START_DELAY_S = 0.01
"""Standard deviations of what nobody has measured: weights in the plane and across, delay."""
REST_M_S2, REST_S = 0.3, 0.05
"""Standard deviation of the acceleration of a device that rests, and how long its errors last."""
REST_SIGMAS = 3.0
"""A device whose acceleration is farther from 0 does not rest, although it sends no events."""
DELAY_DRIFT = 1e-6
"""Variance by which the delay drifts, s^2 a second."""
REACH_S = 0.04
"""A sample says nothing of an event that is farther from it."""
LAG_FADES = 1e-3
"""By so many s a second the lag falls, so that one sample that was late does not last."""
LATE_S = 0.004
"""Samples that come later than this after the counts of their time say less than the counts."""
FORCE_M_S2, KNOWN_M_S2, KNOWN_DELAY_S = 3.0, 0.7, 0.003
"""The sensor is known once the acceleration under such a force, and the delay, are known this well."""
STRANGE_SIGMAS = 5.0
"""A position that is farther off contradicts the samples: what is known of the sensor is forgotten."""

# The parameters: those of sampling, the densities of the jerk m^2/s^5, of the noise m^2/s^3 and of the
# offset m^2/s^5, the variance of a position m^2, the memory of the acceleration s. What is learned: whether
# it is; the reference of the force m/s^2; state and covariance at the end of the last movement. The state:
# that of sampling; the filter without samples; whether samples are used, whether one came; the time of the
# filter, of the last and of the first sample, how far samples are stamped behind the events that came before
# them; the reference; the averaged force; the filter.
_, JERK, NOISE, DENSITY, DRIFT, SMOOTHING_S, KNOWN = offsets(sampling.SETTINGS, 1, 1, 1, 1, 1)
_, OLD_REFERENCE, OLD, AT = offsets(KNOWN + 1, 3, SIZE + SIZE * SIZE)
_, PLAIN, FUSED, SENSED, NOW, SAMPLED, BEGAN, LAG, REFERENCE, MEAN, FILTER, LENGTH = offsets(
    AT + sampling.STATES, constant_acceleration.PLANE, 1, 1, 1, 1, 1, 1, 3, 3, fused_path.LENGTH
)


@layout
def fill(values: FloatArray, memory: FloatArray) -> None:
    """The settings; of the noise in m its variance."""
    sampling.fill(values, memory)
    memory[NOISE] = values[NOISE] * values[NOISE]


@law
def conclude(memory: FloatArray) -> None:
    """Keep what the movement's samples taught of the device: reference, offsets, weights, delay."""
    if memory[FUSED] == 0.0:
        return
    memory[KNOWN] = 1.0
    for i in range(3):
        memory[OLD_REFERENCE + i] = memory[REFERENCE + i]
    for i in range(SIZE + SIZE * SIZE):
        memory[OLD + i] = memory[FILTER + STATE + i]


@law
def start_path(memory: FloatArray) -> None:
    """The path goes on from the filter without samples; what is known of the device stays."""
    p = PLAIN + 2 * constant_acceleration.AXIS
    for number in range(2):
        axis, x = number * AXIS, PLAIN + number * constant_acceleration.AXIS
        memory[FILTER + STATE + axis] = memory[x]
        memory[FILTER + STATE + axis + VELOCITY] = memory[x + 1]
        fused_path.forget(memory, FILTER, axis, memory[p])
        fused_path.forget(memory, FILTER, axis + VELOCITY, memory[p + 3])
        row = FILTER + COVARIANCE + axis * (SIZE + 1)
        memory[row + VELOCITY] = memory[row + VELOCITY * SIZE] = memory[p + 1]
    for i in range(fused_path.FIRST, fused_path.LENGTH):
        memory[FILTER + i] = 0.0
    fused_path.remember(memory, FILTER, memory[NOW] - memory[AT + sampling.SINCE])


@law
def start_fusion(memory: FloatArray) -> None:
    """From now on samples are used, with what is known of the device or with what nobody has measured."""
    memory[FUSED] = 1.0
    p = FILTER + COVARIANCE
    for i in range(SIZE):
        fused_path.forget(memory, FILTER, i, 0.0)
    for number in range(2):
        axis = number * AXIS
        for i in range(OFFSET, AXIS):
            own = WEIGHT + (1 if axis else 0)
            memory[FILTER + STATE + axis + i] = 1.0 if i == own else 0.0
            spread = START_WEIGHT if i < WEIGHT + 2 else START_ACROSS
            spread = START_ACCELERATION_M_S2 if i == OFFSET else spread
            memory[p + (axis + i) * (SIZE + 1)] = spread * spread
        memory[p + (axis + VELOCITY) * (SIZE + 1)] = START_SPEED_M_S**2
    memory[FILTER + STATE + DELAY] = 0.0
    memory[p + DELAY * (SIZE + 1)] = START_DELAY_S**2
    if memory[KNOWN] == 1.0:
        for i in range(SIZE):
            if i == DELAY or i % AXIS >= OFFSET:
                memory[FILTER + STATE + i] = memory[OLD + STATE + i]
                for j in range(SIZE):
                    if j == DELAY or j % AXIS >= OFFSET:
                        memory[p + i * SIZE + j] = memory[OLD + COVARIANCE + i * SIZE + j]
    if memory[AT + sampling.STARTED] == 1.0:
        memory[NOW] = memory[AT + sampling.T]
        start_path(memory)


@law
def advance(memory: FloatArray, t: float) -> None:
    """Carry the filter to ``t`` s on the clock of the samples, if that is later.

    The longer ago the last sample, the less is known of the force: its error grows as the jerk's would.
    """
    dt = t - memory[NOW]
    if dt <= 0.0:
        return
    age = min(max(t - memory[SAMPLED], 0.0), REACH_S)
    density = memory[DENSITY] + memory[JERK] * age * age
    fused_path.predict(memory, FILTER, density, memory[DRIFT], dt)
    memory[FILTER + COVARIANCE + DELAY * (SIZE + 1)] += DELAY_DRIFT * dt
    memory[NOW] = t
    fused_path.remember(memory, FILTER, t - memory[AT + sampling.SINCE])


@law
def set_force(memory: FloatArray, force: tuple[float, float, float], share: float) -> None:
    """The force that acts now: ``share`` of the new one, the rest of the old one."""
    fx, fy, fz = force
    at, kept = FILTER + FORCE, 1.0 - share
    memory[at] = kept * memory[at] + share * fx
    memory[at + 1] = kept * memory[at + 1] + share * fy
    memory[at + 2] = kept * memory[at + 2] + share * fz


@law
def rest(memory: FloatArray, since: float) -> None:
    """A sample, ``since`` s after the last, of a device that sends no events: it rests or is carried."""
    off = fused_path.sigmas_from_rest(memory, FILTER, 0, REST_M_S2**2)
    if max(off, fused_path.sigmas_from_rest(memory, FILTER, SECOND, REST_M_S2**2)) <= REST_SIGMAS:
        variance = REST_M_S2**2 * max(REST_S / since, 1.0)
        fused_path.rest(memory, FILTER, 0, variance)
        fused_path.rest(memory, FILTER, SECOND, variance)


@law
def sense(memory: FloatArray, sample: Row) -> bool:
    """One sample of the accelerometer; whether it was accepted."""
    t, fx, fy, fz = sample
    if not is_sample(sample) or (memory[SENSED] == 1.0 and t < memory[SAMPLED]):
        return False
    if memory[SENSED] == 0.0:
        memory[REFERENCE], memory[REFERENCE + 1], memory[REFERENCE + 2] = fx, fy, fz
        if memory[KNOWN] == 1.0:
            for i in range(3):
                memory[REFERENCE + i] = memory[OLD_REFERENCE + i]
        memory[SENSED], memory[SAMPLED], memory[BEGAN] = 1.0, t, t
    force = fx - memory[REFERENCE], fy - memory[REFERENCE + 1], fz - memory[REFERENCE + 2]
    since = t - memory[SAMPLED]
    keep = exp(-since / memory[SMOOTHING_S])
    if memory[FUSED] == 0.0:
        start_fusion(memory)
        set_force(memory, force, 1.0)
        keep = 0.0
    ox, oy, oz = force
    memory[MEAN] = keep * memory[MEAN] + (1.0 - keep) * ox
    memory[MEAN + 1] = keep * memory[MEAN + 1] + (1.0 - keep) * oy
    memory[MEAN + 2] = keep * memory[MEAN + 2] + (1.0 - keep) * oz
    started = memory[AT + sampling.STARTED] == 1.0
    still = t - (memory[AT + sampling.T] if started else memory[BEGAN]) > memory[sampling.GAP_S]
    if started and not still:
        behind = max(memory[LAG] - LAG_FADES * since, memory[AT + sampling.T] - t)
        memory[LAG] = min(max(behind, 0.0), DELAY_MOST_S)
        set_force(memory, force, 0.5)
        advance(memory, t)
    set_force(memory, force, 1.0)
    if still and 0.0 < since <= REACH_S:
        rest(memory, since)
    memory[SAMPLED] = t
    return True


@law
def is_known(memory: FloatArray) -> bool:
    """Whether enough is known of the sensor to answer with its samples, and whether they come in time."""
    if memory[FUSED] == 0.0:
        return False
    # A clock that runs ahead has no lag, and a delay below 0.
    if memory[LAG] > 0.0 and memory[LAG] - memory[FILTER + STATE + DELAY] > LATE_S:
        return False
    if memory[FILTER + COVARIANCE + DELAY * (SIZE + 1)] > KNOWN_DELAY_S**2:
        return False
    first = fused_path.acceleration_variance(memory, FILTER, 0, FORCE_M_S2)
    second = fused_path.acceleration_variance(memory, FILTER, SECOND, FORCE_M_S2)
    return bool(first <= KNOWN_M_S2**2 and second <= KNOWN_M_S2**2)


@law
def settle_s(memory: FloatArray) -> float:
    """Time that the stationary filter without samples takes at the mean rate so far."""
    intervals = max(memory[AT + sampling.SAMPLES] - 1.0, 1.0)
    period = (memory[AT + sampling.T] - memory[AT + sampling.SINCE]) / intervals
    return float(kalman.SETTLED_RADIANS * (memory[NOISE] * period / memory[JERK]) ** (1.0 / 6.0))


@law
def follow(memory: FloatArray, verdict: int, dt: float) -> None:
    """An accepted event through both filters, that without samples and that with them."""
    t, place = memory[AT + sampling.T], (memory[AT + sampling.U], memory[AT + sampling.V])
    u, v = place
    if memory[FUSED] == 1.0 and abs(t - memory[SAMPLED]) > REACH_S:
        conclude(memory)
        memory[FUSED] = 0.0
    if verdict == sampling.RESTARTED:
        constant_acceleration.restart(memory, PLAIN, memory[NOISE])
        if memory[FUSED] == 1.0:
            memory[NOW] = max(t - memory[LAG], memory[SAMPLED])
            start_path(memory)
    elif verdict == sampling.MOVED:
        constant_acceleration.follow(memory, PLAIN, memory[JERK], memory[NOISE], dt, place)
        if memory[FUSED] == 1.0:
            advance(memory, t - memory[LAG])
            now, ahead = memory[NOW] - memory[AT + sampling.SINCE], memory[NOW] - t
            off = fused_path.measure(memory, FILTER, 0, now, ahead, u, memory[NOISE])
            off = max(off, fused_path.measure(memory, FILTER, SECOND, now, ahead, v, memory[NOISE]))
            if off > STRANGE_SIGMAS:
                memory[KNOWN] = memory[FUSED] = 0.0


@law
def hand(memory: FloatArray) -> tuple[tuple[float, float], tuple[float, float]]:
    """Velocity and acceleration: by the samples once their sensor is known, without them before."""
    if not is_known(memory):
        x, y = PLAIN, PLAIN + constant_acceleration.AXIS
        return (memory[x + 1], memory[y + 1]), (memory[x + 2], memory[y + 2])
    ax = fused_path.acceleration(memory, FILTER, 0, MEAN)
    ay = fused_path.acceleration(memory, FILTER, SECOND, MEAN)
    x = FILTER + STATE
    # Samples that came late have not brought the filter to the event yet.
    missing = max(memory[AT + sampling.T] - memory[x + DELAY] - memory[NOW], 0.0)
    now_x = fused_path.acceleration(memory, FILTER, 0, FILTER + FORCE)
    now_y = fused_path.acceleration(memory, FILTER, SECOND, FILTER + FORCE)
    vx, vy = memory[x + VELOCITY] + missing * now_x, memory[x + SECOND + VELOCITY] + missing * now_y
    return (vx, vy), (ax, ay)


@law
def step(memory: FloatArray, event: EventRow) -> TenFloats:
    """One event through the filter of both axes."""
    verdict, dt, _, _, start = sampling.accept(memory, AT, event)
    if verdict == sampling.REFUSED:
        return REFUSED
    follow(memory, verdict, dt)
    settled = sampling.settled(memory, AT, 4.0, settle_s(memory))
    return sampling.motion(memory, AT, event, hand(memory), settled, start)


loop = loop_of(step, event_at, conclude)
loop_sensing = loop_beside(step, event_at, sense, sample_at, conclude)


class InertialDifferentiator(Differentiator):
    """Fuses positions with the samples of an accelerometer that is fixed to the device, in one filter.

    Assumes a sensor whose angle, bias, scale and delay stay as they are but for a slow drift, whose third
    axis is about upright, and a device that rests where it sends no event for ``gap_s``. The weights of its
    three axes, gravity and bias as they act on the two axes of the device, and the delay of the positions
    behind the samples are estimated. Turning of the device is not in the model: it acts as noise.
    Until these are known, again after a position that contradicts them, without samples, and where samples
    come more than 4 ms after the counts of their time, the answer is that of ``KalmanDifferentiator``, bit
    for bit.

    Samples are used in the order in which they come. One whose time runs backwards against the one before is
    refused; one of the same time replaces it; where they are missing, the last one holds, with an error that
    grows, for 0.04 s; those that are stamped behind the events, by at most 0.02 s, or ahead of them move the
    filter by their own clock.

    Parameters: ``jerk_density`` as for that, used without samples; ``noise_m`` the standard deviation of a
    position, which must also cover what quantisation leaves from one event to the next: the default suits
    counts; ``force_density`` m^2/s^3 of white noise in the acceleration, what the model leaves out included;
    ``drift_density`` m^2/s^5 of the offset; ``smoothing_s`` the time over which the acceleration is averaged,
    and by which it is late: the default suits `switched`, and 0.003 is closer to the true one;
    ``cpi``, ``dpi``, ``gap_s``, ``pause_s`` as for all differentiators.
    Memory: 7 kB. ``sense`` consumes a sample, ``update`` an event and returns a Motion. What it learns
    of the device stays over ``reset``. Raises ParameterError, and EventError and EventOrderError from
    ``update`` and ``sense``.

    Reference: docs/guide/accelerometer.md; proposed in Khalin 2022, section 5.1.

    >>> differentiator = InertialDifferentiator()
    >>> differentiator.sense(0.0, 0.1, 0.0, 9.81)  # s, then m/s^2 along the axes of the sensor
    >>> differentiator.sensor.known, differentiator.sensor.delay_s
    (False, 0.0)
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
        "s", 1e-4, 1.0, "time over which the acceleration is averaged", default=2e-2
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
        if not float is type(t) is type(ax) is type(ay) is type(az):  # most samples are floats
            t, ax, ay, az = numbers_of_sample((t, ax, ay, az))
        if not sense(self._memory, (t, ax, ay, az)):
            raise refusal_of_sample((t, ax, ay, az), float(self._memory[SAMPLED]))

    def refusal_of_row(self, events: EventColumns, row: int) -> EventError:
        """Why ``run`` refuses a row of a table: one of the samples before it, or the event itself."""
        beside = events.rows(row, row + 1).accelerations.table
        begins = events.begin[: row + 1].nonzero()[0]
        first = int(begins[-1]) if len(begins) else 0
        earlier = events.rows(first, row).accelerations.table[:, 0]
        last_t = -LATEST_S
        if len(earlier):
            last_t = float(earlier[-1])
        elif not len(begins) and self._memory[SENSED] == 1.0:
            last_t = float(self._memory[SAMPLED])
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
        return Sensor(weights, offset, float(state[DELAY]), is_known(memory))

    def walk_events(self, events: EventColumns) -> FloatArray:
        """``walk`` over events with the samples beside them."""
        beside = events.accelerations
        if not len(beside):
            return self.walk(events.begin, events.table)
        out = np.full((len(events), self.width), np.nan)
        loop_sensing(self._memory, self._first, events.begin, events.table, out, beside.table, beside.before)
        return out
