"""Delphian prediction: the distance left at the speed peak, by a line that is fitted to the person."""

from __future__ import annotations

from math import hypot, nan

import numpy as np

from pointpred.compiled import law
from pointpred.differentiators import Differentiator
from pointpred.errors import ParameterError
from pointpred.layout import Layout, clear
from pointpred.parameter import parameter
from pointpred.predictors import movement
from pointpred.predictors.predictor import Predictor
from pointpred.recording import Recording
from pointpred.records import FINE, MotionRow, TenFloats, endpoint


class Settings(Layout):
    """The parameters."""

    slope: float
    offset: float
    fall: float


class Peak(Layout):
    """Where the speed was highest; its direction from the start; whether the speed has fallen since."""

    x: float
    y: float
    unit_x: float
    unit_y: float
    fallen: float


class State(Layout):
    """What is remembered of the movement."""

    movement: movement.State
    peak: Peak


class Memory(Layout):
    """The settings, then the state."""

    settings: Settings
    state: State


@law
def step(memory: Memory, motion: TenFloats) -> TenFloats:
    """Remember the peak; once the speed has fallen from it, the line says how far it is from there."""
    m = MotionRow(*motion)
    settings, s, peak = memory.settings, memory.state.movement, memory.state.peak
    before = s.peak
    fault, new, _ = movement.follow(s, m)
    if fault != FINE:
        return movement.refuse(s, m, fault)
    phase = movement.phase(s, m)
    if new:
        clear(peak)
    speed = hypot(m.vx, m.vy)
    if new or s.peak > before:
        away_x, away_y = m.x - s.x0, m.y - s.y0
        away = hypot(away_x, away_y)
        peak.x, peak.y, peak.fallen = m.x, m.y, 0.0
        peak.unit_x = away_x / away if away > 0.0 else 0.0
        peak.unit_y = away_y / away if away > 0.0 else 0.0
    elif speed < (1.0 - settings.fall) * s.peak and s.peak >= movement.STILL_M_S:
        peak.fallen = 1.0
    if peak.fallen == 0.0 or (peak.unit_x == 0.0 and peak.unit_y == 0.0):
        return endpoint(m.t, nan, nan, phase)
    ahead = max(settings.slope * s.peak + settings.offset, 0.0)
    return endpoint(m.t, peak.x + ahead * peak.unit_x, peak.y + ahead * peak.unit_y, phase)


class DelphianPredictor(Predictor):
    """Delphian prediction: the higher the speed peak, the farther the way that is left there.

    Assumes one straight movement with one peak, and that distance grows linearly with peak speed, with a line
    of each person and device. One answer a movement: it does not improve on the way, and corrections after it
    go unseen. The defaults are of other people's mice: fit the line (``fit_line``) to the person.

    d = max(slope v_peak + offset, 0); endpoint = position at the peak + d in the direction start -> there.
    The peak is the highest speed of the hand so far; it is known to be one once the speed has fallen below
    (1 - ``fall``) of it. A later, higher peak replaces it: ``None`` until it too is known; ``None`` before
    the first, and where the peak lies on the start. Noise above ``fall`` makes peaks too early.

    Parameters: ``slope_px_s_m`` px per m/s, ``offset_px`` px, ``fall`` a share. Memory: 17 floats. Claims
    neither region nor time of arrival. Raises ParameterError, and EventError from ``update``.

    Reference: Asano, Sharlin, Kitamura, Takashima, Kishino 2005 (the line gives the distance from the peak).

    >>> from pointpred import Motion
    >>> predictor = DelphianPredictor(slope_px_s_m=500.0, offset_px=10.0)
    >>> for i, speed in enumerate([0.0, 0.2, 0.4, 0.3]):
    ...     prediction = predictor.update(Motion(i / 10, 40.0 * i, 0.0, speed, 0.0, 0.0, 0.0, True))
    >>> round(prediction.x, 6)  # 80 px at the peak, 500 * 0.4 + 10 px to go
    290.0
    """

    slope_px_s_m: float = parameter(
        "px s/m", 0.0, 1e5, "distance left at the peak for each m/s of its speed", default=56.0
    )
    offset_px: float = parameter("px", -1e4, 1e4, "distance left at a peak without speed", default=111.0)
    fall: float = parameter(
        "", 0.0, 0.9, "share by which the speed must fall for a peak to be known", default=0.05
    )
    step = staticmethod(step)
    claims_time = False
    states = State.length


def fit_line(recording: Recording, differentiator: Differentiator) -> tuple[float, float]:
    """The line of a person: (``slope_px_s_m``, ``offset_px``) by least squares over the trials.

    Speed is the highest of each trial as this differentiator sees it, distance the straight way from there
    to the last position. Trials without speed are left out; raises ParameterError where fewer than two
    different speeds remain. A recording of one distance has no line worth having: vary the distance.

    >>> from pointpred import EventColumns, build
    >>> from pointpred.recording import Trial
    >>> t = np.arange(0.0, 1.0, 0.01)
    >>> reach = t**3 * (10 - 15 * t + 6 * t**2)
    >>> trials = [Trial("ann", str(d)) for d in (100, 300, 500)]
    >>> parts = [EventColumns.of(t, d * reach, 0 * t) for d in (100, 300, 500)]
    >>> slope, offset = fit_line(Recording.of("reaches", parts, trials), build("hold").differentiator)
    >>> bool(0.8 < slope / (0.5 / 1.875 * 96 / 0.0254) < 1.0), bool(abs(offset) < 1.0)
    (True, True)
    """
    peaks, ways = [], []
    for k in range(len(recording.trials)):
        rows = recording.rows(k)
        if len(rows) == 0:
            continue
        table = differentiator.fresh().run(rows).table
        speeds = np.hypot(table[:, 3], table[:, 4])
        at = int(speeds.argmax())
        if speeds[at] >= movement.STILL_M_S:
            peaks.append(float(speeds[at]))
            ways.append(float(np.hypot(rows.x[-1] - rows.x[at], rows.y[-1] - rows.y[at])))
    if len(set(peaks)) < 2:
        raise ParameterError(
            f"a line needs trials of at least 2 different peak speeds, received {len(set(peaks))}"
        )
    slope, offset = np.polyfit(peaks, ways, 1)
    return float(slope), float(offset)
