"""What a learned predictor sees of a movement: numbers that know neither rotation nor the screen's scale.

Lengths on the screen count in ``reach``, the px travelled and what the cursor's peak speed adds; lengths of
the hand in the hand's own ``reach``. How large a movement is stands only in what is measured in metres.
"""

from __future__ import annotations

from math import hypot, log

from pointpred.columns import FloatArray
from pointpred.compiled import law
from pointpred.predictors import minimum_jerk
from pointpred.predictors.kinematic import history, track

LAGS_S = (0.01, 0.02, 0.03, 0.045, 0.065, 0.09, 0.12, 0.16, 0.21, 0.28, 0.37, 0.5)
NAMES = (
    "log reach",
    "log time",
    "time",
    "d",
    "straight",
    "back",
    "cursor peak",
    "log peak",
    "log speed",
    "v along",
    "a along",
    "speed of peak",
    "v aligned",
    "since peak",
    "peak share",
    "peak at",
    "d at peak",
    "path at peak",
    "mean of peak",
    "push",
    "brake",
    "since push",
    "subs",
    "since sub",
    "sub peak",
    "speed of sub",
    "since sub peak",
    "falling",
    "sub along",
    "sub path",
    "jerk ahead",
    "sub jerk ahead",
    "slow for",
    "slower for",
    "still for",
    "log mean",
    "stop time",
    "stop way",
)
EVEN = len(NAMES)
V_ALONG, SUB_ALONG = NAMES.index("v along"), NAMES.index("sub along")
LAG_ALONG = EVEN
ODD = EVEN + len(LAGS_S)
"""From here on features change their sign in a mirror: across the direction instead of along it."""
V_ACROSS, A_ACROSS, SUB_ACROSS, LAG_ACROSS = ODD, ODD + 1, ODD + 2, ODD + 3
FEATURES = LAG_ACROSS + len(LAGS_S)
REACH_S = 0.06
"""Seconds of the peak speed that count as reach."""
SOON_S = 0.1
"""Velocities count as the way of so long, accelerations as the change of velocity within a tenth of it."""


@law
def ahead(ratio: float) -> float:
    """What a minimum-jerk movement has ahead as a share of its way done, from speed over peak."""
    _, done = minimum_jerk.progress(ratio)
    return float((1.0 - done) / done)


@law
def direction(x: float, y: float, vx: float, vy: float) -> tuple[float, float]:
    """From the start to the cursor; at the start the hand's, without one along x."""
    d = hypot(x, y)
    if d > 0.0:
        return x / d, y / d
    speed = hypot(vx, vy)
    if speed > 0.0:
        return vx / speed, vy / speed
    return 1.0, 0.0


@law
def shape(
    memory: FloatArray, at: int, path: float, reach: float, hand: float, t: float, out: FloatArray
) -> None:
    """Features of the way so far: its length, its peak, its sub-movements."""
    x, y = memory[at + track.X], memory[at + track.Y]
    d, peak = hypot(x, y), memory[at + track.PEAK] + 1e-9
    out[0] = log(hand)
    out[1] = log(t + 0.02)
    out[2] = t
    out[3] = d / reach
    out[4] = d / path
    out[5] = d / max(memory[at + track.FAR], 1e-9)
    out[6] = memory[at + track.CURSOR_PEAK] * SOON_S / reach
    out[7] = log(memory[at + track.PEAK] + 3e-4)
    out[13] = t - memory[at + track.PEAK_T]
    out[14] = memory[at + track.PEAK_T] / (t + 1e-3)
    out[15] = memory[at + track.PEAK_T]
    out[16] = memory[at + track.PEAK_D] / reach
    out[17] = memory[at + track.PEAK_PATH] / path
    out[18] = memory[at + track.WAY] / (t + 1e-3) / peak
    out[19] = memory[at + track.PUSH] * SOON_S * 0.1 / hand
    out[20] = memory[at + track.BRAKE] * SOON_S * 0.1 / hand
    out[21] = t - memory[at + track.PUSH_T]
    out[22] = min(memory[at + track.SUBS], 6.0)
    out[23] = t - memory[at + track.SUB_T]
    out[24] = memory[at + track.SUB_PEAK] / peak
    out[26] = t - memory[at + track.SUB_PEAK_T]
    out[27] = memory[at + track.FALLING]
    out[29] = (path - memory[at + track.SUB_PATH]) / reach
    out[32] = t - memory[at + track.FAST_T]
    out[33] = t - memory[at + track.MOVING_T]
    out[34] = t - memory[at + track.MOVED_T]
    out[35] = log(memory[at + track.WAY] / (t + 0.01) + 3e-4)


@law
def pace(
    memory: FloatArray,
    at: int,
    t: float,
    reach: float,
    hand: float,
    v: float,
    va: float,
    aa: float,
    out: FloatArray,
) -> None:
    """Features of the present speed: against its peaks, and what it says is left."""
    x, y = memory[at + track.X], memory[at + track.Y]
    sub_x, sub_y = x - memory[at + track.SUB_X], y - memory[at + track.SUB_Y]
    peak, sub_peak = memory[at + track.PEAK] + 1e-9, memory[at + track.SUB_PEAK] + 1e-9
    out[8] = log(v + 3e-3)
    out[9] = va * SOON_S / hand
    out[10] = aa * SOON_S * 0.1 / hand
    out[11] = v / peak
    out[12] = va / (v + 1e-6)
    out[25] = v / sub_peak
    out[30] = ahead(v / peak if t > memory[at + track.PEAK_T] else 1.0) * hypot(x, y) / reach
    out[31] = ahead(v / sub_peak if t > memory[at + track.SUB_PEAK_T] else 1.0) * hypot(sub_x, sub_y) / reach
    braking = max(-aa, 1e-3)
    out[36] = min(1.0, max(-1.0, va / braking))
    out[37] = min(4.0, va * va / (2.0 * braking) / hand)


@law
def features(
    memory: FloatArray,
    track_at: int,
    history_at: int,
    t: float,
    vx: float,
    vy: float,
    ax: float,
    ay: float,
    out: FloatArray,
) -> tuple[float, float, float]:
    """Fill ``out``; returns the reach in px, 0 before the cursor has moved, and the direction."""
    x, y = memory[track_at + track.X], memory[track_at + track.Y]
    path = history.travelled(memory, history_at, x, y)
    ux, uy = direction(x, y, vx, vy)
    if not path > 0.0:
        return 0.0, ux, uy
    reach = path + REACH_S * memory[track_at + track.CURSOR_PEAK]
    hand = memory[track_at + track.WAY] + REACH_S * memory[track_at + track.PEAK] + 1e-4
    va, aa = vx * ux + vy * uy, ax * ux + ay * uy
    shape(memory, track_at, path, reach, hand, t, out)
    pace(memory, track_at, t, reach, hand, hypot(vx, vy), va, aa, out)
    sub_x, sub_y = x - memory[track_at + track.SUB_X], y - memory[track_at + track.SUB_Y]
    out[SUB_ALONG] = (sub_x * ux + sub_y * uy) / reach
    out[SUB_ACROSS] = (sub_y * ux - sub_x * uy) / reach
    out[V_ACROSS] = (vy * ux - vx * uy) * SOON_S / hand
    out[A_ACROSS] = (ay * ux - ax * uy) * SOON_S * 0.1 / hand
    for i in range(len(LAGS_S)):
        past_x, past_y, _ = history.past(memory, history_at, t, x, y, path, LAGS_S[i])
        lag_x, lag_y = x - past_x, y - past_y
        out[LAG_ALONG + i] = (lag_x * ux + lag_y * uy) / reach
        out[LAG_ACROSS + i] = (lag_y * ux - lag_x * uy) / reach
    return reach, ux, uy
