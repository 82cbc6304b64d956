"""The learned predictor for one person: what their movements taught, laid over what it says of anybody."""

from __future__ import annotations

from collections.abc import Mapping
from math import hypot
from typing import Any, ClassVar, Self

import numpy as np

from pointpred.compiled import law
from pointpred.layout import Layout, clear, slots_of
from pointpred.parameter import parameter
from pointpred.predictors.adaptation import correction, destination, mixed_region, places
from pointpred.predictors.adaptation.places import Places
from pointpred.predictors.adaptation.time_left import Pace
from pointpred.predictors.kinematic import features, network
from pointpred.predictors.kinematic import predictor as kinematic
from pointpred.predictors.kinematic.predictor import KinematicPredictor
from pointpred.predictors.mixture import Mixture, Part, PartRow
from pointpred.records import FloatArray, FloatTable, MotionRow, Place, TenFloats
from pointpred.scene import SCREEN, Scene

# A row of known places: position in px, shares now and before the movement, visits, the number of the place,
# the standard deviation of its visits in px.
X, Y, P, BEFORE, VISITS, NUMBER, SPREAD, FIELDS = range(8)
ADAPT_OF = 0
"""Which parameter says whether anything is learned."""


class Settings(Layout):
    """The parameters with the scene of this movement, then the scene of the next."""

    adapt: float
    adaptation: correction.Settings
    next: correction.Window


class Memory(Layout):
    """The settings, what is known of the person, the movement as `kinematic` and the adaptation have it."""

    settings: Settings
    person: correction.Person
    observation: features.State
    movement: correction.Movement


@law
def sizes(values: FloatArray) -> tuple[int, int, int]:
    """How many settings, learned floats and states there are: without adaptation nothing is learned."""
    learned = correction.Person.length if values[ADAPT_OF] == 1.0 else 0
    return Settings.length, learned, Memory.length - Settings.length - learned


@law
def conclude(memory: Memory) -> None:
    """The movement has ended: learn from it. The next one is in the window that was entered last."""
    settings = memory.settings
    if settings.adapt == 1.0:
        correction.conclude(settings.adaptation, memory.person, memory.movement)
        scene, after = settings.adaptation.scene, settings.next
        scene.key, scene.x, scene.y = after.key, after.x, after.y


@law
def pace_of(own: features.State, m: MotionRow) -> Pace:
    """The hand's speed over its peak and how long it has been slow; ``own``: memory of `kinematic`."""
    of_peak = hypot(m.vx, m.vy) / own.track.peak if own.track.peak > 0.0 else 0.0
    return Pace(of_peak, m.t - own.movement.t0 - own.track.fast_t)


@law
def step(memory: Memory, motion: TenFloats, coefficients: network.Coefficients) -> TenFloats:
    """The learned predictor's step, then what is known of the person."""
    m = MotionRow(*motion)
    own = memory.observation
    answer = kinematic.step(own, motion, coefficients)
    if memory.settings.adapt == 0.0 or answer[0] != answer[0]:
        return answer
    if m.start == 1.0:
        conclude(memory)
    start = own.movement.t0, own.movement.x0, own.movement.y0
    correction.follow(memory.movement, (m.t, m.x, m.y), start)
    settings, pace = memory.settings.adaptation, pace_of(own, m)
    return correction.adapt(settings, memory.person, memory.movement, answer, pace)


@law
def enter_scene(memory: Memory, scene: Scene) -> None:
    """The next movement is in this window or page; at once where none goes on."""
    now, after = memory.settings.adaptation.scene, memory.settings.next
    after.key, after.x, after.y = scene
    if memory.settings.adapt == 0.0 or memory.movement.started == 0.0:
        now.key, now.x, now.y = scene


@law
def last_end(held: Places, key: float) -> tuple[float, float]:
    """Where the last movement to a place of this key ended, px from the origin; the origin if none did."""
    for age in range(places.MOVEMENTS):
        number = places.visited(held, age)
        place = held.places[max(number, 0)]
        if number >= 0 and place.key == key:
            return float(place.x), float(place.y)
    return 0.0, 0.0


@law
def list_places(memory: Memory, out: FloatTable) -> int:
    """Fill a row for each place of the window that the cursor is in, by their numbers; returns how many.

    ``out``: ``places.CAPACITY`` rows of FIELDS. Before a movement has begun the shares are those of a
    movement from where the last one in this window ended.
    """
    settings, person, going = memory.settings.adaptation, memory.person, memory.movement.destination
    if memory.settings.adapt == 0.0 or settings.places == 0.0:
        return 0
    scene, held = settings.scene, person.places
    waits = going.ready == 0.0
    start = memory.movement.x0 - scene.x, memory.movement.y0 - scene.y
    if waits:
        if memory.movement.started == 0.0:
            start = last_end(held, scene.key)
        correction.prepare(settings, person, going, start)
    count = 0
    for i in range(int(held.count)):
        place = held.places[i]
        if place.key == scene.key:
            before = going.returns * going.before[i]
            out[count, X], out[count, Y] = place.x + scene.x, place.y + scene.y
            out[count, P] = before if waits else going.now[i]
            out[count, BEFORE], out[count, VISITS] = before, place.visits
            out[count, NUMBER] = i
            out[count, SPREAD] = destination.spread_of(going, start, place.x, place.y)
            count += 1
    if waits:  # the movement lays them out for where it starts
        clear(going)
    return count


@law
def write_mixture(memory: Memory) -> bool:
    """Write the mixture of places and elsewhere into the memory; whether one is claimed now."""
    settings, now = memory.settings, memory.movement.now
    if settings.adapt == 0.0 or settings.adaptation.places == 0.0 or now.claimed == 0.0:
        return False
    correction.write_mixture(settings.adaptation, memory.person, memory.movement, now.asked)
    return True


@law
def list_parts(memory: Memory, out: FloatTable) -> tuple[int, float, float]:
    """Write the parts of the mixture into ``out``; returns how many, 0 for no mixture, and its offsets."""
    if not write_mixture(memory):
        return 0, 0.0, 0.0
    asked = memory.movement.now.asked
    for k in range(int(asked.count)):
        for i in range(PartRow.length):
            out[k, i] = asked.rows[k].memory[i]
    return int(asked.count), asked.offsets[0], asked.offsets[1]


class AdaptiveKinematicPredictor(KinematicPredictor):
    """``kinematic`` that gets to know its person while they move.

    Assumes one person, who moves as they did lately. Where movements are free and of every length it gains
    little; a new task costs a few movements of trust in the old distances. It knows a movement's end only
    when the next one starts (by ``reset``, a row marked ``begin`` or ``Motion.start``): the truth is the
    last position. Movements shorter than ``shortest_px``, 80 ms or 6 samples teach nothing. What was
    learned stays in this object's memory and nowhere else: ``reset`` keeps it, ``fresh`` knows nobody.

    ``kinematic`` says a px ahead along the direction start -> cursor, of D px in all, with widths s along
    and across and tail nu. At five stages of the time, and on lines between them:

    bias: a <- a + b (p D + q a), with p and q by least squares with forgetting 0.97, weights
    (nu + 1) / (nu + r^2) of the residual r in widths, ridge 20; b in 0 .. 1 is the share of that shift that
    has paid so far. Widths: s <- s sqrt((S + 2) / (n + 2)), S the sum of the weighted squared residuals.
    Tempo: log(time left) shifts by its mean residual, shrunk and believed in the same way.
    Clock: it is then mixed with what the median M of the last 12 durations leaves, in the one of five shares
    (0 to 1) that erred least so far.

    Time left: M times a weighted sum of seven terms: this mixture and `kinematic`'s own time left, over M and
    at most 4; 1; the share r of the way that is left to the predicted end; the speed over its peak times the
    second term; the time since the speed was a fifth of its peak over the time passed and M / 10; and
    1 / (1 + (r / 0.04)^2). The weights are those of the least absolute error in 12 moments of each movement,
    forgetting 0.98, with everybody's as a prior worth two movements.
    Intervals: the spread is 0.6 exp(d) at three stages. After the n-th movement, at 12 shares of its true
    time, d grows where the arrival lay outside the interval stated there and falls where inside, by
    max(12 / (n + 5), 0.15) / 12 times 2/3 p (p = 0.5) or 4/3 p (p = 0.8), and 1 - p in place of p.

    Distances: the Student law along, times a density of the last 12 distances, kernels of 2, 8 and 35 %,
    weights exp(-age / 1.5) and exp(-age / 12). Each of the six, and "nothing is known" (0.98 at first), is
    believed by how likely it had made the distances that came; 5 % flows back. The median of the product
    answers. Bias and distances, with the width they ask for, fade out from 0.2 and 0.5 of the time on, as
    the mixture has it.

    Places: up to 64 ends, merged within 3 % of the distance, visits forgotten by 0.97. Before a movement a
    place has the share w: by how often it was visited and how lately, how many movements ago people return
    to a place, and where they went from here; each rule weighs by the ends that it made likely; and by
    r^-1.25 of its distance r from the start. With q, the
    learned share of returns (0.05 at first), a place at distance r becomes q w f 2 pi r^2 L, where f is the
    Student law at the place, widened by the learned scatter of its visits, and L = 3; elsewhere is 1 - q
    times the same of the last distances. The answer is the geometric median of the places and elsewhere, the
    widths are mean distances from it. Places fade out from 0.7 of the time on.

    Levels: at five stages the squared radii of the regions of 50 and 80 % are multiplied by exp(d) where
    d > 0; otherwise they become those of the level 1 - (1 - p)^exp(d). After the n-th movement, for each
    share 0.1 ... 0.9 of its true time, d grows by e p where its end lay outside the region stated there, and
    falls by e (1 - p) where inside: e = max(6 / (n + 5), 0.2), p the level. The Student law that has both
    radii (tail from 1/2 to 100) is stated. The regions of the mixture of elsewhere and the four likeliest
    places (``mixture``), the smallest that hold a share of it, are corrected in the same way.

    Parameters: ``adapt`` 0 or 1 (0: bit for bit `kinematic`), ``distances``, ``places`` and ``sequence``
    (where people go from a place) 0 or 1, ``shortest_px``; ``coefficients`` as for `kinematic`.
    Memory: 3949 floats. Costs 1 to 6 us an event more than ``kinematic``. Raises ParameterError,
    and EventError from ``update``.

    Reference: none; docs/guide/adaptation.md. Prior knowledge of repeated distances: Pasqual, Wobbrock 2014.

    >>> from pointpred import PointerEvent, build
    >>> pipeline, ends = build("kinematic-adaptive"), []
    >>> for _ in range(5):  # five times the same 400 px, asked after 0.3 of 0.7 s
    ...     pipeline.reset()
    ...     for i in range(100):
    ...         s = min(i / 70, 1.0)
    ...         event = PointerEvent(i / 100, 400 * (10 * s**3 - 15 * s**4 + 6 * s**5), 0.0)
    ...         prediction = pipeline.update(event)
    ...         if i == 30:
    ...             ends.append(abs(prediction.x - 400.0))
    >>> ends[4] < 0.1 * ends[0]
    True
    """

    adapt: int = parameter(
        "", 0, 1, "1: learn from each finished movement; 0: exactly `kinematic`", default=1, whole=True
    )
    distances: int = parameter(
        "",
        0,
        1,
        "1: ask the last distances; 0: only bias, widths, tempo and the clock",
        default=1,
        whole=True,
    )
    shortest_px: float = parameter(
        "px", 0.0, 1e6, "straight distance of the shortest movement that teaches", default=10.0
    )
    places: int = parameter(
        "", 0, 1, "1: remember where movements ended; 0: only how far they went", default=1, whole=True
    )
    sequence: int = parameter(
        "",
        0,
        1,
        "1: learn which place follows which; 0: only how often each is visited",
        default=1,
        whole=True,
    )
    without_memory: ClassVar[Mapping[str, Any]] = {"places": 0, "distances": 0}
    step = staticmethod(step)
    follow = None  # what is stated at each motion is compared with the movement's end
    conclude = staticmethod(conclude)
    slots = slots_of(correction.Person)
    fault = staticmethod(correction.fault)
    doubt = staticmethod(correction.doubt)
    sizes = staticmethod(sizes)
    enter_scene = staticmethod(enter_scene)
    list_places = staticmethod(list_places)
    list_parts = staticmethod(list_parts)

    def settings(self) -> FloatArray:
        """The numbers of the parameters, and the scene: no key, the origin at 0."""
        return self.filled(Settings.length)

    def declare(self, **values: Any) -> None:
        """Check the values; without adaptation nothing of the person is remembered."""
        super().declare(**values)
        _, self.learned, self.states = sizes(self.values())

    def fresh(self) -> Self:
        """Return a predictor with the same parameters, which knows neither a person nor a window."""
        twin = super().fresh()
        twin.enter(SCREEN)
        return twin

    def enter(self, scene: Scene) -> None:
        """The next movement is in this window or page; at once where none goes on."""
        enter_scene(self._memory, scene)

    @property
    def known_places(self) -> tuple[Place, ...]:
        """The places of the window that the cursor is in, the likeliest destination first."""
        rows = np.empty((places.CAPACITY, FIELDS))
        count = list_places(self._memory, rows)
        listed = (
            Place(x, y, p, before, visits, int(number), spread)
            for x, y, p, before, visits, number, spread in rows[:count].tolist()
        )
        return tuple(sorted(listed, key=lambda place: -place.p))

    @property
    def mixture(self) -> Mixture | None:
        """The law of the endpoint as places and elsewhere have it; ``None`` where no law is claimed."""
        rows = np.empty((mixed_region.MOST_PLACES + 1, PartRow.length))
        count, near, far = list_parts(self._memory.copy(), rows)
        if count == 0:
            return None
        parts = tuple(
            Part(share, x, y, (sxx, sxy, syy), tail or None)
            for share, x, y, sxx, sxy, syy, tail in rows[:count].tolist()
        )
        return Mixture(parts, (float(near), float(far)))
