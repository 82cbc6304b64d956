"""The correction of a prediction for one person, and its update by a finished movement.

Any prediction that claims a region and the time left can be adapted: the predictor only provides its answer
and the start of the movement.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import floor, hypot, sqrt
from typing import Annotated

from pointpred.compiled import law
from pointpred.layout import Layout, clear
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
from pointpred.predictors.adaptation.moments import (
    LEAST_S,
    NEAR_PX,
    NEAR_SHARE,
    SAMPLES_LEAST,
    SHORTEST_PX,
)
from pointpred.predictors.adaptation.time_left import Estimates, Pace, Way
from pointpred.predictors.adaptation.time_left_prior import PRIOR
from pointpred.records import FloatArray, SixFloats, TenFloats

TRACE_PLACES, APART_S = 96, 0.005
"""Places of the last way that are remembered, and how far apart in time at least; none while it stands."""

BIAS_FADE, FADE, PLACES_FADE = 0.2, 0.5, 0.7
"""From these shares of the time on the bias, the last distances and the places fade out."""
EARLY = 0.1
"""A stage begins at this share of its length before its middle."""


class Window(Layout):
    """What the cursor moves in: a ``Scene``."""

    key: float
    x: float
    y: float


class Settings(Layout):
    """Which parts of the adaptation answer, 1 or 0 each, the shortest movement that teaches, the window."""

    distances: float
    shortest_px: float
    places: float
    sequence: float
    scene: Window


class Person(Layout):
    """What is known of the person."""

    stages: stages.Stages
    distances: distances.Distances
    durations: durations.Durations
    regions: region_widening.Radii
    time_left: time_left.Sums
    intervals: arrival_intervals.Intervals
    places: places.Places
    habits: habits.Habits


class Sample(Layout):
    """Where the cursor was: s, px."""

    t: float
    x: float
    y: float


class Movement(Layout):
    """The movement, if one has ``started``: its start, its last sample, what was stated in it."""

    started: float
    t0: float
    x0: float
    y0: float
    t: float
    x: float
    y: float
    traced: float
    """How many places of the way there were."""
    samples: float
    """How many samples of different times there were."""
    trace: Annotated[Sequence[Sample], TRACE_PLACES]
    """The last places of the way."""
    stages: Annotated[Sequence[stages.Moment], stages.STAGES]
    regions: region_widening.Movement
    time_left: time_left.Movement
    destination: destination.Movement
    now: mixed_region.Movement


UNEQUAL = 21


@law
def fault(learned: Person) -> tuple[int, float]:
    """What is wrong with numbers that are each within their bounds, and the number that is wrong."""
    if learned.distances.count != learned.durations.count:
        return UNEQUAL, learned.distances.count
    wrong, value = distances.fault(learned.distances)
    if wrong != distances.FINE:
        return wrong, value
    wrong, value = durations.fault(learned.durations)
    if wrong != durations.FINE:
        return wrong, value
    wrong, value = time_left.fault(learned.time_left, PRIOR)
    if wrong != time_left.FINE:
        return wrong, value
    return places.fault(learned.places)


def doubt(learned: FloatArray) -> str:
    """``fault`` in words; empty for nothing."""
    known = Person(learned)
    held, other = known.distances.count, known.durations.count
    if held != other:
        return f"distances held must be as many as durations held, are {held:g} and {other:g}"
    return (
        distances.doubt(known.distances)
        or durations.doubt(known.durations)
        or time_left.doubt(known.time_left)
        or places.doubt(known.places)
    )


@law
def arrival(movement: Movement, near: float) -> float:
    """When the cursor came near its end for good; the oldest time remembered where that is longer ago."""
    traced = int(movement.traced)
    when = movement.t
    for back in range(min(traced, TRACE_PLACES)):
        place = movement.trace[(traced - 1 - back) % TRACE_PLACES]
        if hypot(place.x - movement.x, place.y - movement.y) > near:
            return float(when)
        when = place.t
    return float(when)


@law
def learn_place(settings: Settings, person: Person, movement: Movement) -> None:
    """Learn which place the movement went to; before its distance is taken in."""
    scene = settings.scene
    x0, y0 = movement.x0 - scene.x, movement.y0 - scene.y
    x, y = movement.x - scene.x, movement.y - scene.y
    distance, usual = hypot(x - x0, y - y0), 1.0
    if settings.distances == 1.0:
        usual = distances.likelihood(person.distances, distance)
    near = places.NEAR_SHARE * distance
    where = scene.key, settings.sequence, near
    habits.learn(person.habits, person.places, where, (x0, y0, x, y), usual)
    places.visit(person.places, scene.key, (x, y), near)


@law
def learn(person: Person, movement: Movement, distance: float, end: float) -> None:
    """Learn from a movement over ``distance`` px that arrived at ``end`` s where the cursor is."""
    x, y, start = movement.x, movement.y, movement.t0
    duration = end - start
    clock = person.durations
    not_first = clock.count > 0.0
    if not_first:
        durations.forget(clock)
    for number in range(stages.STAGES):
        m, stage = movement.stages[number], person.stages.stages[number]
        if m.present == 1.0:
            if not_first and m.t < end:
                left = m.left * stages.tempo_factor(stage)
                durations.judge(clock, m.t - start, left, end - m.t, duration)
            stages.learn(stage, m, x, y, end)
    if not_first:
        span = start, end
        time_left.learn(person.time_left, person.intervals, movement.time_left, span, clock.median, PRIOR)
    distances.remember(person.distances, distance)
    durations.remember(clock, duration)
    region_widening.learn(person.regions, movement.regions, (x, y), (start, end))


@law
def conclude(settings: Settings, person: Person, movement: Movement) -> None:
    """The movement has ended where the cursor is: learn from it, and forget it."""
    distance = hypot(movement.x - movement.x0, movement.y - movement.y0)
    end = arrival(movement, max(NEAR_PX, NEAR_SHARE * distance))
    whole = movement.started == 1.0 and movement.samples >= SAMPLES_LEAST
    shortest = max(settings.shortest_px, SHORTEST_PX)
    if whole and end - movement.t0 >= LEAST_S and distance >= shortest:
        if settings.places == 1.0:
            learn_place(settings, person, movement)
        learn(person, movement, distance, end)
    clear(movement)


@law
def follow(movement: Movement, now: tuple[float, float, float], start: tuple[float, float, float]) -> None:
    """Take in one sample (t, x, y) of the movement that started at ``start``."""
    t, x, y = now
    traced = int(movement.traced)
    last = movement.trace[(traced - 1) % TRACE_PLACES]
    if movement.started == 0.0 or t > movement.t:
        movement.samples += 1.0
    moved = x != last.x or y != last.y
    if traced > 0 and t == last.t:
        last.x, last.y = x, y
    elif traced == 0 or (moved and t - last.t >= APART_S):
        place = movement.trace[traced % TRACE_PLACES]
        place.t, place.x, place.y = t, x, y
        movement.traced = traced + 1.0
    movement.started = 1.0
    movement.t0, movement.x0, movement.y0 = start
    movement.t, movement.x, movement.y = t, x, y


@law
def stage_begun(movement: Movement, share: float) -> int:
    """The stage whose moment is at a share of the time, the first or of the same time again; -1 for none.

    Stages are taken in their order: none that was passed over, none that is behind.
    """
    stage = floor(share * stages.STAGES - 0.5 + EARLY)
    if stage < 0 or stage >= stages.STAGES:
        return -1
    again = movement.stages[stage].present == 1.0 and movement.stages[stage].t == movement.t
    for later in range(stage, stages.STAGES):
        if movement.stages[later].present == 1.0 and not again:
            return -1
    return stage


@law
def fading(share: float, since: float) -> float:
    """1 up to a share of the time, then falling to 0 at the end."""
    return min((1.0 - share) / (1.0 - since), 1.0)


@law
def heading_of(movement: Movement, answer: TenFloats) -> Heading:
    """The law of an answer along and across the direction from the start to the cursor.

    Its widths are 0 where the answer claims too little to be adapted, or the cursor is where it started.
    """
    _, px, py, sxx, sxy, syy, left, _, tail, _ = answer
    away_x, away_y = movement.x - movement.x0, movement.y - movement.y0
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
def ahead_of(movement: Movement, heading: Heading) -> tuple[float, float]:
    """The way from the cursor to the centre of a law, along and across its direction, px."""
    dx, dy = heading.x - movement.x, heading.y - movement.y
    return dx * heading.ux + dy * heading.uy, dy * heading.ux - dx * heading.uy


@law
def with_centre_ahead(movement: Movement, heading: Heading, along: float, wide: float) -> Heading:
    """A law whose centre lies ``along`` px ahead of the cursor, of the width ``wide`` px along."""
    _, across = ahead_of(movement, heading)
    x, y, ux, uy, _, broad, tail = heading
    x, y = movement.x + along * ux - across * uy, movement.y + along * uy + across * ux
    return Heading(x, y, ux, uy, wide, broad, tail)


@law
def by_distances(person: Person, movement: Movement, own: Heading, share: float) -> tuple[Heading, float]:
    """The law of the endpoint by the last distances, and how likely ``own`` makes these."""
    reached = hypot(movement.x - movement.x0, movement.y - movement.y0)
    along, _ = ahead_of(movement, own)
    ahead = Ahead(along, own.wide, own.broad, own.tail)
    usual_along, usual_wide, usual = distances.combine(person.distances, reached, ahead)
    weight = fading(share, FADE)
    along += weight * (usual_along - along)
    return with_centre_ahead(movement, own, along, own.wide * (usual_wide / own.wide) ** weight), usual


@law
def prepare(
    settings: Settings, person: Person, going: destination.Movement, start: tuple[float, float]
) -> None:
    """Lay out how likely each place is for a movement from ``start``, px from the window's origin."""
    near = places.NEAR_SHARE * person.distances.last[0]
    where = settings.scene.key, settings.sequence, near
    destination.prepare(going, person.places, person.habits, where, start)


@law
def by_places(
    settings: Settings,
    person: Person,
    movement: Movement,
    laws: tuple[Heading, Heading],
    weights: tuple[float, float],
) -> Heading:
    """The law of the endpoint by the places where the person was before.

    ``laws``: without and with the last distances; ``weights``: how likely the first makes the last distances,
    and the weight of the places.
    """
    own, elsewhere = laws
    scene, going, held = settings.scene, movement.destination, person.places
    start = movement.x0 - scene.x, movement.y0 - scene.y
    if going.ready == 0.0:
        prepare(settings, person, going, start)
    if going.returns == 0.0:
        return elsewhere
    destination.weigh(going, held, start, destination.shift_law(own, -scene.x, -scene.y), weights)
    combined = destination.combine(going, held, start, destination.shift_law(elsewhere, -scene.x, -scene.y))
    return destination.shift_law(combined, scene.x, scene.y)


@law
def adapted_end(
    settings: Settings, person: Person, movement: Movement, own: Heading, share: float
) -> tuple[Heading, Heading]:
    """The law of the endpoint by all parts that answer, and that of elsewhere, without the places.

    ``own``: `kinematic`'s, corrected for the person.
    """
    elsewhere, usual = own, 1.0
    if settings.distances == 1.0:
        elsewhere, usual = by_distances(person, movement, own, share)
    if settings.places == 0.0:
        return elsewhere, elsewhere
    weights = usual, fading(share, PLACES_FADE)
    return by_places(settings, person, movement, (own, elsewhere), weights), elsewhere


@law
def write_mixture(settings: Settings, person: Person, movement: Movement, to: mixed_region.Mixture) -> None:
    """Write the mixture of places and elsewhere as it is claimed now."""
    scene = settings.scene
    start = movement.x0 - scene.x, movement.y0 - scene.y
    mixed_region.write(
        person.regions.mixed,
        person.places,
        movement.destination,
        movement.now,
        to,
        (scene.x, scene.y),
        start,
    )


@law
def state(
    settings: Settings,
    person: Person,
    movement: Movement,
    share: float,
    laws: tuple[SixFloats, SixFloats],
) -> None:
    """Remember what is stated at a share of the time: the single law, and that of elsewhere."""
    region, elsewhere = laws
    mixed_region.claim(movement.now, share, elsewhere)
    cursor = movement.t, movement.x, movement.y
    number = region_widening.record(movement.regions, cursor, region)
    if number >= 0:
        write_mixture(settings, person, movement, movement.regions.moments[number].mixture)


@law
def adapt(settings: Settings, person: Person, movement: Movement, answer: TenFloats, pace: Pace) -> TenFloats:
    """The prediction as it is for this person; as it was where it claims too little or has no direction."""
    t, px, py, sxx, sxy, syy, predicted, phase, tail, _ = answer
    heading = heading_of(movement, answer)
    _, _, ux, uy, wide, broad, _ = heading
    movement.now.claimed = 0.0
    if wide == 0.0:
        return answer
    now, x, y = movement.t, movement.x, movement.y
    reached, since = hypot(x - movement.x0, y - movement.y0), now - movement.t0
    along, across = ahead_of(movement, heading)
    share = since / (since + predicted)
    stage = stage_begun(movement, share)
    if stage >= 0:
        m = movement.stages[stage]
        m.present, m.t, m.x, m.y, m.reached = 1.0, now, x, y, reached
        m.ux, m.uy, m.along, m.across = ux, uy, along, across
        m.wide, m.broad, m.tail, m.left = wide, broad, tail, predicted
    if person.distances.count == 0.0:
        first = px, py, sxx, sxy, syy, tail
        state(settings, person, movement, share, (first, first))
        return answer
    total = hypot(reached + along, across)
    shift, widen, broaden, slow = stages.correct(person.stages, share, total, along)
    left = durations.mix(person.durations, since, predicted * slow)
    share = since / (since + left)
    shape = (sxy * (ux * ux - uy * uy) + (syy - sxx) * ux * uy) / (wide * broad)
    own = with_centre_ahead(movement, heading, along + shift * fading(share, BIAS_FADE), wide * widen)
    own = Heading(own.x, own.y, ux, uy, own.wide, broad * broaden, tail)
    end, elsewhere = adapted_end(settings, person, movement, own, share)
    factor, tail = region_widening.widen(person.regions, share, tail)
    region = destination.scaled(end, shape, factor, tail)
    state(settings, person, movement, share, (region, destination.scaled(elsewhere, shape, factor, tail)))
    px, py, sxx, sxy, syy, _ = region
    left, spread = time_left.stated(
        person.time_left,
        person.intervals,
        movement.time_left,
        (now, x, y),
        since,
        person.durations.median,
        Estimates(left, predicted),
        Way(reached, hypot(px - x, py - y)),
        pace,
    )
    return t, px, py, sxx, sxy, syy, left, phase, tail, spread
