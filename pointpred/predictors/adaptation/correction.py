"""What is known of a person laid over a prediction, and what a finished movement adds to it.

Any prediction that claims a region and the time left can be adapted: all that is asked of the predictor is
its answer, and where the movement started.
"""

from __future__ import annotations

from math import floor, hypot, sqrt

from pointpred.columns import FloatArray
from pointpred.compiled import law
from pointpred.predictors.adaptation import distances, durations, region_widening, stages
from pointpred.rows import TenFloats

# What is known of the person, relative to `known`: the stages, the distances, the durations, the regions.
DISTANCES = stages.LEARNED
CLOCK = DISTANCES + distances.LEARNED
LEVELS = CLOCK + durations.LEARNED
LEARNED = LEVELS + region_widening.LEARNED
SLOTS = (*stages.SLOTS, *distances.SLOTS, *durations.SLOTS, *region_widening.SLOTS)

# The movement, relative to `at`: whether there is one, its start, its last sample, how many
# places of the way were kept, samples of different times; the last of these places; a moment of each stage;
# the regions that were stated.
KNOWN, T0, X0, Y0, T, X, Y, LATELY, COUNT, TRACE = 0, 1, 2, 3, 4, 5, 6, 7, 8, 9
TRACED, APART_S = 96, 0.005
"""Places kept of the last way, and how far apart in time at least; while it stands none is kept."""
MOMENTS = TRACE + 3 * TRACED
STATED = MOMENTS + stages.STATES
STATES = STATED + region_widening.STATES
NEAR_PX, NEAR_SHARE = 8.0, 0.03
"""The movement has arrived when the cursor stays so near its end: px, share of the distance."""

SAMPLES_LEAST, LEAST_S = 6, 0.08
"""A movement of fewer samples of different times, or shorter, teaches nothing."""
BIAS_FADE, FADE = 0.2, 0.5
"""From these shares of the time on the bias and the last distances fade out: what is left is a correction."""
EARLY = 0.1
"""A stage is taken from this share of its length before its middle on."""


def doubt(known: FloatArray) -> str:
    """What is wrong with numbers that are within the bounds of ``SLOTS``; empty for nothing."""
    far, long = known[DISTANCES + distances.HELD], known[CLOCK + durations.HELD]
    if far != long:
        return f"distances held must be as many as durations held, are {far:g} and {long:g}"
    return distances.doubt(known[DISTANCES:CLOCK]) or durations.doubt(known[CLOCK:LEVELS])


@law
def arrived(memory: FloatArray, at: int, near: float) -> float:
    """When the cursor came near its end for good; the oldest time that is kept where that is longer ago."""
    kept = int(memory[at + LATELY])
    when = memory[at + T]
    for back in range(min(kept, TRACED)):
        place = at + TRACE + 3 * ((kept - 1 - back) % TRACED)
        if hypot(memory[place + 1] - memory[at + X], memory[place + 2] - memory[at + Y]) > near:
            return float(when)
        when = memory[place]
    return float(when)


@law
def conclude(memory: FloatArray, known: int, at: int, shortest: float) -> None:
    """The movement has ended where the cursor is: learn from it, and forget it."""
    x, y = memory[at + X], memory[at + Y]
    distance = hypot(x - memory[at + X0], y - memory[at + Y0])
    moved = arrived(memory, at, max(NEAR_PX, NEAR_SHARE * distance))
    teaches = memory[at + KNOWN] == 1.0 and memory[at + COUNT] >= SAMPLES_LEAST
    duration = moved - memory[at + T0]
    if teaches and duration >= LEAST_S and distance >= max(shortest, distances.SHORTEST_PX):
        told = memory[known + CLOCK + durations.HELD] > 0.0
        if told:
            durations.forget(memory, known + CLOCK)
        for stage in range(stages.STAGES):
            moment, of = at + MOMENTS + stage * stages.MOMENT, known + stage * stages.WIDTH
            if memory[moment + stages.TAKEN] == 1.0:
                when = memory[moment + stages.T]
                if told and when < moved:
                    said = memory[moment + stages.LEFT] * stages.slowed(memory, of)
                    durations.judge(
                        memory, known + CLOCK, when - memory[at + T0], said, moved - when, duration
                    )
                stages.learn(memory, of, moment, x, y, moved)
        distances.remember(memory, known + DISTANCES, distance)
        durations.remember(memory, known + CLOCK, duration)
        region_widening.learn(memory, known + LEVELS, at + STATED, x, y, memory[at + T0], moved)
    memory[at : at + STATES] = 0.0


@law
def follow(
    memory: FloatArray, at: int, t: float, x: float, y: float, t0: float, x0: float, y0: float
) -> None:
    """Take one sample in; the movement started at ``t0``, ``x0``, ``y0``."""
    kept = int(memory[at + LATELY])
    last = at + TRACE + 3 * ((kept - 1) % TRACED)
    if memory[at + KNOWN] == 0.0 or t > memory[at + T]:
        memory[at + COUNT] += 1.0
    moved = x != memory[last + 1] or y != memory[last + 2]
    if kept > 0 and t == memory[last]:
        memory[last + 1], memory[last + 2] = x, y
    elif kept == 0 or (moved and t - memory[last] >= APART_S):
        place = at + TRACE + 3 * (kept % TRACED)
        memory[place], memory[place + 1], memory[place + 2] = t, x, y
        memory[at + LATELY] = kept + 1.0
    memory[at + KNOWN] = 1.0
    memory[at + T0], memory[at + X0], memory[at + Y0] = t0, x0, y0
    memory[at + T], memory[at + X], memory[at + Y] = t, x, y


@law
def take(
    memory: FloatArray,
    at: int,
    share: float,
    ux: float,
    uy: float,
    reached: float,
    along: float,
    across: float,
    wide: float,
    broad: float,
    tail: float,
    left: float,
) -> None:
    """Keep the first moment of a stage, as its last sample has it; none leapt over, none that is behind."""
    stage = floor(share * stages.STAGES - 0.5 + EARLY)
    if stage < 0 or stage >= stages.STAGES:
        return
    moment = at + MOMENTS + stage * stages.MOMENT
    again = memory[moment + stages.TAKEN] == 1.0 and memory[moment + stages.T] == memory[at + T]
    for later in range(stage, stages.STAGES):
        if memory[at + MOMENTS + later * stages.MOMENT + stages.TAKEN] == 1.0 and not again:
            return
    memory[moment + stages.TAKEN], memory[moment + stages.T] = 1.0, memory[at + T]
    memory[moment + stages.X], memory[moment + stages.Y] = memory[at + X], memory[at + Y]
    memory[moment + stages.UX], memory[moment + stages.UY] = ux, uy
    memory[moment + stages.ALONG], memory[moment + stages.ACROSS] = along, across
    memory[moment + stages.SAID_WIDE], memory[moment + stages.SAID_BROAD] = wide, broad
    memory[moment + stages.TAIL] = tail
    memory[moment + stages.LEFT], memory[moment + stages.REACHED] = left, reached


@law
def fading(gone: float, since: float) -> float:
    """1 up to a share of the time, then falling to 0 at the end."""
    return min((1.0 - gone) / (1.0 - since), 1.0)


@law
def adapted(
    memory: FloatArray,
    known: int,
    at: int,
    ask: float,
    answer: TenFloats,
) -> TenFloats:
    """The prediction as it is for this person; as given where it claims too little or has no direction."""
    t, px, py, sxx, sxy, syy, left, phase, tail, spread = answer
    x, y = memory[at + X], memory[at + Y]
    away_x, away_y = x - memory[at + X0], y - memory[at + Y0]
    reached = hypot(away_x, away_y)
    if not (reached > 0.0 and left > 0.0 and tail > 0.0 and sxx + syy > 0.0):
        return answer
    ux, uy = away_x / reached, away_y / reached
    wide2 = sxx * ux * ux + 2.0 * sxy * ux * uy + syy * uy * uy
    broad2 = sxx * uy * uy - 2.0 * sxy * ux * uy + syy * ux * ux
    if not (wide2 > 0.0 and broad2 > 0.0):
        return answer
    wide, broad = sqrt(wide2), sqrt(broad2)
    along = (px - x) * ux + (py - y) * uy
    across = (py - y) * ux - (px - x) * uy
    since = memory[at + T] - memory[at + T0]
    share = since / (since + left)
    take(memory, at, share, ux, uy, reached, along, across, wide, broad, tail, left)
    if memory[known + DISTANCES + distances.HELD] == 0.0:
        region_widening.keep(memory, at + STATED, memory[at + T], x, y, (px, py, sxx, sxy, syy, tail))
        return answer
    total = hypot(reached + along, across)
    shift, widen, broaden, slow = stages.corrected(memory, known, share, total, along)
    left = durations.mixed(memory, known + CLOCK, since, left * slow)
    new_wide, new_broad = wide * widen, broad * broaden
    gone = since / (since + left)
    new_along = along + shift * fading(gone, BIAS_FADE)
    if ask == 1.0:
        drawn_along, drawn_wide = distances.drawn(
            memory, known + DISTANCES, reached, new_along, new_wide, new_broad, tail
        )
        still = fading(gone, FADE)
        new_along += still * (drawn_along - new_along)
        new_wide *= (drawn_wide / new_wide) ** still
    ratio, moved = new_wide / wide, new_along - along
    cross = (sxy * (ux * ux - uy * uy) + (syy - sxx) * ux * uy) * ratio * broaden
    factor, tail = region_widening.corrected(memory, known + LEVELS, gone, tail)
    wide2, broad2, cross = factor * new_wide * new_wide, factor * new_broad * new_broad, factor * cross
    px, py = px + moved * ux, py + moved * uy
    sxx = wide2 * ux * ux - 2.0 * cross * ux * uy + broad2 * uy * uy
    sxy = (wide2 - broad2) * ux * uy + cross * (ux * ux - uy * uy)
    syy = wide2 * uy * uy + 2.0 * cross * ux * uy + broad2 * ux * ux
    region_widening.keep(memory, at + STATED, memory[at + T], x, y, (px, py, sxx, sxy, syy, tail))
    return t, px, py, sxx, sxy, syy, left, phase, tail, spread
