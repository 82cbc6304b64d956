"""The correction of a prediction for one person, and its update by a finished movement.

Any prediction that claims a region and the time left can be adapted: the predictor only provides its answer
and the start of the movement.
"""

from __future__ import annotations

from math import floor, hypot, sqrt
from typing import NamedTuple

from pointpred.compiled import law, layout
from pointpred.predictors.adaptation import (
    arrival_intervals,
    destination,
    distances,
    durations,
    habits,
    mixed_region,
    places,
    region_widening,
    stages,
    time_left,
)
from pointpred.predictors.adaptation.destination import Heading
from pointpred.predictors.adaptation.distances import Ahead
from pointpred.predictors.adaptation.stages import Moment
from pointpred.predictors.adaptation.time_left import Estimates, Pace, Way
from pointpred.predictors.adaptation.time_left_prior import PRIOR
from pointpred.records import FloatArray, SixFloats, TenFloats
from pointpred.scene import Scene
from pointpred.stage import offsets

# What is known of the person, relative to `person`: the stages, the distances, the durations, the regions,
# the time left, its intervals, the places, the habits.
_, DISTANCES, DURATIONS, REGIONS, TIME_LEFT, INTERVALS, KNOWN, HABITS, LEARNED = offsets(
    *(stages.LEARNED, distances.LEARNED, durations.LEARNED, region_widening.LEARNED),
    *(time_left.LEARNED, arrival_intervals.LEARNED, places.LEARNED, habits.LEARNED),
)
SLOTS = (
    *(*stages.SLOTS, *distances.SLOTS, *durations.SLOTS, *region_widening.SLOTS),
    *(*time_left.SLOTS, *arrival_intervals.SLOTS, *places.SLOTS, *habits.SLOTS),
)

TRACE_PLACES, APART_S = 96, 0.005
"""Places of the last way that are remembered, and how far apart in time at least; none while it stands."""
# The movement, relative to `at`: whether there is one, its start, its last sample; how many places of the way
# there were, samples of different times; the last places; a moment of each stage; the regions stated; the
# time left stated; where it may go; the mixture that is claimed now.
STARTED, T0, X0, Y0, T, X, Y, PLACES, SAMPLES = range(9)
_, TRACE, MOMENTS, STATED, TIMED, DESTINATION, NOW, STATES = offsets(
    *(SAMPLES + 1, 3 * TRACE_PLACES, stages.STATES, region_widening.STATES),
    *(time_left.STATES, destination.STATES, mixed_region.STATES),
)
NEAR_PX, NEAR_SHARE = 8.0, 0.03
"""The movement has arrived when the cursor stays so near its end: px, share of the distance."""

SAMPLES_LEAST, LEAST_S = 6, 0.08
"""A movement of fewer samples of different times, or shorter, teaches nothing."""
BIAS_FADE, FADE, PLACES_FADE = 0.2, 0.5, 0.7
"""From these shares of the time on the bias, the last distances and the places fade out."""
EARLY = 0.1
"""A stage begins at this share of its length before its middle."""


class Parts(NamedTuple):
    """Which parts of the adaptation answer, 1 or 0 each."""

    distances: float
    places: float
    sequence: float


UNEQUAL = 21


@layout
def fault(learned: FloatArray) -> tuple[int, float]:
    """What is wrong with numbers that are within the bounds of ``SLOTS``, and the number that is wrong."""
    held = learned[DISTANCES + distances.COUNT]
    if held != learned[DURATIONS + durations.COUNT]:
        return UNEQUAL, held
    wrong, value = distances.fault(learned[DISTANCES:DURATIONS])
    if wrong != distances.FINE:
        return wrong, value
    wrong, value = durations.fault(learned[DURATIONS:REGIONS])
    if wrong != durations.FINE:
        return wrong, value
    wrong, value = time_left.fault(learned[TIME_LEFT:INTERVALS])
    if wrong != time_left.FINE:
        return wrong, value
    return places.fault(learned[KNOWN:HABITS])


def doubt(learned: FloatArray) -> str:
    """``fault`` in words; empty for nothing."""
    wrong, held = fault(learned)
    if wrong == UNEQUAL:
        other = learned[DURATIONS + durations.COUNT]
        return f"distances held must be as many as durations held, are {held:g} and {other:g}"
    return (
        distances.doubt(learned[DISTANCES:DURATIONS])
        or durations.doubt(learned[DURATIONS:REGIONS])
        or time_left.doubt(learned[TIME_LEFT:INTERVALS])
        or places.doubt(learned[KNOWN:HABITS])
    )


@law
def arrival(memory: FloatArray, at: int, near: float) -> float:
    """When the cursor came near its end for good; the oldest time remembered where that is longer ago."""
    places = int(memory[at + PLACES])
    when = memory[at + T]
    for back in range(min(places, TRACE_PLACES)):
        place = at + TRACE + 3 * ((places - 1 - back) % TRACE_PLACES)
        if hypot(memory[place + 1] - memory[at + X], memory[place + 2] - memory[at + Y]) > near:
            return float(when)
        when = memory[place]
    return float(when)


@law
def learn_place(memory: FloatArray, person: int, at: int, parts: Parts, scene: Scene) -> None:
    """Learn which place the movement went to; before its distance is taken in."""
    x0, y0 = memory[at + X0] - scene.x, memory[at + Y0] - scene.y
    x, y = memory[at + X] - scene.x, memory[at + Y] - scene.y
    distance, usual = hypot(x - x0, y - y0), 1.0
    if parts.distances == 1.0:
        usual = distances.likelihood(memory, person + DISTANCES, distance)
    where, habit, near = person + KNOWN, person + HABITS, places.NEAR_SHARE * distance
    habits.learn(memory, where, habit, (scene.key, parts.sequence, near), (x0, y0, x, y), usual)
    places.visit(memory, where, scene.key, (x, y), near)


@law
def learn(memory: FloatArray, person: int, at: int, distance: float, end: float) -> None:
    """Learn from a movement over ``distance`` px that arrived at ``end`` s where the cursor is."""
    x, y, start = memory[at + X], memory[at + Y], memory[at + T0]
    duration = end - start
    clock = person + DURATIONS
    not_first = memory[clock + durations.COUNT] > 0.0
    if not_first:
        durations.forget(memory, clock)
    for number in range(stages.STAGES):
        place, stage = at + MOMENTS + number * stages.MOMENT, person + number * stages.WIDTH
        if memory[place + stages.PRESENT] == 1.0:
            m = stages.moment_at(memory, place)
            if not_first and m.t < end:
                left = m.left * stages.tempo_factor(memory, stage)
                durations.judge(memory, clock, m.t - start, left, end - m.t, duration)
            stages.learn(memory, stage, m, x, y, end)
    if not_first:
        timed = (person + TIME_LEFT, person + INTERVALS, at + TIMED)
        median = memory[clock + durations.MEDIAN]
        time_left.learn(memory, timed, (start, end), median, PRIOR)
    distances.remember(memory, person + DISTANCES, distance)
    durations.remember(memory, clock, duration)
    region_widening.learn(memory, person + REGIONS, at + STATED, (x, y), (start, end))


@law
def conclude(memory: FloatArray, person: int, at: int, shortest: float, parts: Parts, scene: Scene) -> None:
    """The movement has ended where the cursor is: learn from it, and forget it."""
    distance = hypot(memory[at + X] - memory[at + X0], memory[at + Y] - memory[at + Y0])
    end = arrival(memory, at, max(NEAR_PX, NEAR_SHARE * distance))
    whole = memory[at + STARTED] == 1.0 and memory[at + SAMPLES] >= SAMPLES_LEAST
    if whole and end - memory[at + T0] >= LEAST_S and distance >= max(shortest, distances.SHORTEST_PX):
        if parts.places == 1.0:
            learn_place(memory, person, at, parts, scene)
        learn(memory, person, at, distance, end)
    memory[at : at + STATES] = 0.0


@law
def follow(
    memory: FloatArray, at: int, now: tuple[float, float, float], start: tuple[float, float, float]
) -> None:
    """Take in one sample (t, x, y) of the movement that started at ``start``."""
    t, x, y = now
    places = int(memory[at + PLACES])
    last = at + TRACE + 3 * ((places - 1) % TRACE_PLACES)
    if memory[at + STARTED] == 0.0 or t > memory[at + T]:
        memory[at + SAMPLES] += 1.0
    moved = x != memory[last + 1] or y != memory[last + 2]
    if places > 0 and t == memory[last]:
        memory[last + 1], memory[last + 2] = x, y
    elif places == 0 or (moved and t - memory[last] >= APART_S):
        place = at + TRACE + 3 * (places % TRACE_PLACES)
        memory[place], memory[place + 1], memory[place + 2] = t, x, y
        memory[at + PLACES] = places + 1.0
    memory[at + STARTED] = 1.0
    memory[at + T0], memory[at + X0], memory[at + Y0] = start
    memory[at + T], memory[at + X], memory[at + Y] = t, x, y


@law
def record(memory: FloatArray, at: int, share: float, moment: Moment) -> None:
    """Remember the first moment of a stage, as its last sample has it.

    Stages are taken in their order: none that was passed over, none that is behind.
    """
    stage = floor(share * stages.STAGES - 0.5 + EARLY)
    if stage < 0 or stage >= stages.STAGES:
        return
    place = at + MOMENTS + stage * stages.MOMENT
    again = memory[place + stages.PRESENT] == 1.0 and memory[place + stages.T] == moment.t
    for later in range(stage, stages.STAGES):
        if memory[at + MOMENTS + later * stages.MOMENT + stages.PRESENT] == 1.0 and not again:
            return
    stages.record(memory, place, moment)


@law
def fading(share: float, since: float) -> float:
    """1 up to a share of the time, then falling to 0 at the end."""
    return min((1.0 - share) / (1.0 - since), 1.0)


@law
def heading_of(memory: FloatArray, at: int, answer: TenFloats) -> Heading:
    """The law of an answer along and across the direction from the start to the cursor.

    Its widths are 0 where the answer claims too little to be adapted, or the cursor is where it started.
    """
    _, px, py, sxx, sxy, syy, left, _, tail, _ = answer
    away_x, away_y = memory[at + X] - memory[at + X0], memory[at + Y] - memory[at + Y0]
    reached = hypot(away_x, away_y)
    if not (reached > 0.0 and left > 0.0 and tail > 0.0 and sxx + syy > 0.0):
        return Heading(px, py, 0.0, 0.0, 0.0, 0.0, tail)
    ux, uy = away_x / reached, away_y / reached
    wide2 = sxx * ux * ux + 2.0 * sxy * ux * uy + syy * uy * uy
    broad2 = sxx * uy * uy - 2.0 * sxy * ux * uy + syy * ux * ux
    if not (wide2 > 0.0 and broad2 > 0.0):
        return Heading(px, py, 0.0, 0.0, 0.0, 0.0, tail)
    return Heading(px, py, ux, uy, sqrt(wide2), sqrt(broad2), tail)


@law
def ahead_of(memory: FloatArray, at: int, heading: Heading) -> tuple[float, float]:
    """The way from the cursor to the centre of a law, along and across its direction, px."""
    dx, dy = heading.x - memory[at + X], heading.y - memory[at + Y]
    return dx * heading.ux + dy * heading.uy, dy * heading.ux - dx * heading.uy


@law
def with_centre_ahead(memory: FloatArray, at: int, heading: Heading, along: float, wide: float) -> Heading:
    """A law whose centre lies ``along`` px ahead of the cursor, of the width ``wide`` px along."""
    _, across = ahead_of(memory, at, heading)
    x, y, ux, uy, _, broad, tail = heading
    x, y = memory[at + X] + along * ux - across * uy, memory[at + Y] + along * uy + across * ux
    return Heading(x, y, ux, uy, wide, broad, tail)


@law
def by_distances(
    memory: FloatArray, person: int, at: int, own: Heading, share: float
) -> tuple[Heading, float]:
    """The law of the endpoint by the last distances, and how likely ``own`` makes these."""
    reached = hypot(memory[at + X] - memory[at + X0], memory[at + Y] - memory[at + Y0])
    along, _ = ahead_of(memory, at, own)
    ahead = Ahead(along, own.wide, own.broad, own.tail)
    usual_along, usual_wide, usual = distances.combine(memory, person + DISTANCES, reached, ahead)
    weight = fading(share, FADE)
    along += weight * (usual_along - along)
    return with_centre_ahead(memory, at, own, along, own.wide * (usual_wide / own.wide) ** weight), usual


@law
def prepare(
    memory: FloatArray, person: int, going: int, parts: Parts, scene: Scene, start: tuple[float, float]
) -> None:
    """Lay out how likely each place is for a movement from ``start``, px from the scene's origin."""
    near = places.NEAR_SHARE * memory[person + DISTANCES + distances.DISTANCES]
    known = person + KNOWN, person + HABITS
    destination.prepare(memory, known, going, (scene.key, parts.sequence, near), start)


@law
def by_places(
    memory: FloatArray,
    person: int,
    at: int,
    parts: Parts,
    scene: Scene,
    laws: tuple[Heading, Heading],
    weights: tuple[float, float],
) -> Heading:
    """The law of the endpoint by the places where the person was before.

    ``laws``: without and with the last distances; ``weights``: how likely the first makes the last distances,
    and the weight of the places.
    """
    own, elsewhere = laws
    start = memory[at + X0] - scene.x, memory[at + Y0] - scene.y
    where, going = person + KNOWN, at + DESTINATION
    if memory[going + destination.READY] == 0.0:
        prepare(memory, person, going, parts, scene, start)
    if memory[going + destination.RETURNS] == 0.0:
        return elsewhere
    destination.weigh(memory, where, going, start, destination.shift_law(own, -scene.x, -scene.y), weights)
    combined = destination.combine(
        memory, where, going, start, destination.shift_law(elsewhere, -scene.x, -scene.y)
    )
    return destination.shift_law(combined, scene.x, scene.y)


@law
def adapted_end(
    memory: FloatArray, person: int, at: int, parts: Parts, scene: Scene, own: Heading, share: float
) -> tuple[Heading, Heading]:
    """The law of the endpoint by all parts that answer, and that of elsewhere, without the places.

    ``own``: `kinematic`'s, corrected for the person.
    """
    elsewhere, usual = own, 1.0
    if parts.distances == 1.0:
        elsewhere, usual = by_distances(memory, person, at, own, share)
    if parts.places == 0.0:
        return elsewhere, elsewhere
    weights = usual, fading(share, PLACES_FADE)
    return by_places(memory, person, at, parts, scene, (own, elsewhere), weights), elsewhere


@law
def write_mixture(memory: FloatArray, person: int, at: int, scene: Scene, to: int) -> None:
    """Write the mixture of places and elsewhere as it is claimed now."""
    known = person + REGIONS + region_widening.MIXED, person + KNOWN, at + DESTINATION
    start = memory[at + X0] - scene.x, memory[at + Y0] - scene.y
    mixed_region.write(memory, known, at + NOW, to, (scene.x, scene.y), start)


@law
def state(
    memory: FloatArray,
    person: int,
    at: int,
    scene: Scene,
    share: float,
    laws: tuple[SixFloats, SixFloats],
) -> None:
    """Remember what is stated at a share of the time: the single law, and that of elsewhere."""
    region, elsewhere = laws
    mixed_region.claim(memory, at + NOW, share, elsewhere)
    now, x, y = memory[at + T], memory[at + X], memory[at + Y]
    to = region_widening.record(memory, at + STATED, now, x, y, region)
    if to >= 0:
        write_mixture(memory, person, at, scene, to)


@law
def adapt(
    memory: FloatArray, person: int, at: int, parts: Parts, scene: Scene, answer: TenFloats, pace: Pace
) -> TenFloats:
    """The prediction as it is for this person; as it was where it claims too little or has no direction."""
    t, px, py, sxx, sxy, syy, predicted, phase, tail, _ = answer
    heading = heading_of(memory, at, answer)
    _, _, ux, uy, wide, broad, _ = heading
    memory[at + NOW + mixed_region.CLAIMED] = 0.0
    if wide == 0.0:
        return answer
    now, x, y = memory[at + T], memory[at + X], memory[at + Y]
    reached, since = hypot(x - memory[at + X0], y - memory[at + Y0]), now - memory[at + T0]
    along, across = ahead_of(memory, at, heading)
    share = since / (since + predicted)
    m = Moment(now, x, y, ux, uy, along, across, wide, broad, tail, predicted, reached)
    record(memory, at, share, m)
    if memory[person + DISTANCES + distances.COUNT] == 0.0:
        first = px, py, sxx, sxy, syy, tail
        state(memory, person, at, scene, share, (first, first))
        return answer
    shift, widen, broaden, slow = stages.correct(memory, person, share, hypot(reached + along, across), along)
    left = durations.mix(memory, person + DURATIONS, since, predicted * slow)
    share = since / (since + left)
    shape = (sxy * (ux * ux - uy * uy) + (syy - sxx) * ux * uy) / (wide * broad)
    own = with_centre_ahead(memory, at, heading, along + shift * fading(share, BIAS_FADE), wide * widen)
    own = Heading(own.x, own.y, ux, uy, own.wide, broad * broaden, tail)
    end, elsewhere = adapted_end(memory, person, at, parts, scene, own, share)
    factor, tail = region_widening.widen(memory, person + REGIONS, share, tail)
    region = destination.scaled(end, shape, factor, tail)
    state(memory, person, at, scene, share, (region, destination.scaled(elsewhere, shape, factor, tail)))
    px, py, sxx, sxy, syy, _ = region
    left, spread = time_left.stated(
        memory,
        (person + TIME_LEFT, person + INTERVALS, at + TIMED),
        (now, x, y),
        since,
        memory[person + DURATIONS + durations.MEDIAN],
        Estimates(left, predicted),
        Way(reached, hypot(px - x, py - y)),
        pace,
    )
    return t, px, py, sxx, sxy, syy, left, phase, tail, spread
