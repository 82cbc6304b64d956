"""What the movement is for: the registered targets, how likely each is, and the prediction that follows."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from math import hypot, log2
from typing import Any, Self

import numpy as np
from msgspec import structs

from pointpred.compiled import law
from pointpred.errors import ParameterError
from pointpred.layout import clear, slots_of
from pointpred.parameter import parameter
from pointpred.predictors.adaptation import levels, moments, region_widening, time_left
from pointpred.predictors.mixture import (
    HEAVINESS_LEAST,
    LEVELS,
    Mixture,
    Part,
    PartRow,
    content,
    corrected_probability,
)
from pointpred.records import BoolArray, FloatArray, FloatTable, Row, SixFloats, TenFloats, event_at, row_at
from pointpred.stage import CompiledStage, copy_values
from pointpred.targets import arrival, cursor, endpoint, past, posterior
from pointpred.targets.arrival_prior import PRIOR
from pointpred.targets.heading import (
    ELSEWHERE,
    MOST,
    Memory,
    Movement,
    Person,
    Settings,
    Targets,
    begin,
    ended,
    follow,
    learn_target,
    weigh,
)
from pointpred.targets.posterior import Coefficients
from pointpred.targets.rectangles import (
    HEIGHT,
    LOG_WEIGHT,
    WIDTH,
    Target,
    key_of,
    table,
)

LIKELY = 0.01
"""A target that is less likely is no part of the mixture that is asked for: level sets of many take long."""
JUDGED_LEAST = 0.02
"""A target that is less likely counts as elsewhere when it is judged whether the end lay in a region."""
JUDGED_POINTS, POINTS_LEAST = 128, 8
"""About so many points of all parts, and at least so many of each, tell what is denser than the end."""
SIZE_PX = 20.0
"""The size of what a movement ends in that goes to none of the targets."""


@law
def row_of(values: FloatArray) -> TenFloats:
    """Ten numbers as a row."""
    return (
        values[0], values[1], values[2], values[3], values[4],
        values[5], values[6], values[7], values[8], values[9],
    )  # fmt: skip


@law
def learn_regions(
    s: region_widening.Radii,
    movement: Movement,
    end: tuple[float, float],
    span: tuple[float, float],
    targets: Targets,
    coefficients: Coefficients,
) -> None:
    """Judge the ellipses and level sets that were stated over ``span``, in s, by where the movement ended."""
    rows = targets[0]
    x, y = end
    s.movements = min(s.movements + 1.0, region_widening.MOVEMENTS_MOST)
    step = levels.step_after(s.movements)
    shares, parts = np.empty(len(rows) + 1), np.empty((len(rows) + 1, PartRow.length))
    k = 0
    for judged in range(1, region_widening.JUDGED + 1):
        share = judged / (region_widening.JUDGED + 1.0)
        while k + 1 < movement.series.count and moments.has_come(
            movement.series, movement.moments[k + 1].t, span, share
        ):
            k += 1
        m = movement.moments[k]
        answer = row_of(m.answer)
        posterior.scores(m.cursor, rows, answer, coefficients, movement.elsewhere, shares)
        posterior.normalise(shares)
        predicted = endpoint.elsewhere(m.cursor, answer)
        count = endpoint.mixture(rows, shares, predicted, JUDGED_LEAST, parts)
        within = content(parts, count, x, y, max(JUDGED_POINTS // count, POINTS_LEAST))
        ellipse = m.x, m.y, m.sxx, m.sxy, m.syy, m.tail
        nearer = region_widening.probability_within(ellipse, x, y)
        near, far = levels.offset(s.mixed, share, 0), levels.offset(s.mixed, share, 1)
        tail = predicted.tail if predicted.tail == predicted.tail else 2.0 / HEAVINESS_LEAST
        for which in range(len(LEVELS)):
            asked = corrected_probability(LEVELS[which], tail, near, far)
            levels.learn(s.mixed, share, which, within <= asked, step)
            levels.learn(s.single, share, which, nearer <= LEVELS[which], step)


@law
def learn_prediction(memory: Memory, targets: Targets, coefficients: Coefficients) -> None:
    """The movement has ended where the cursor is: learn how good its regions and times were."""
    s, movement, person = memory.cursor, memory.movement, memory.person
    end = ended(memory, targets[0])
    if end == end:
        span = s.t0, end
        learn_regions(person.regions, movement, (s.x, s.y), span, targets, coefficients)
        usual = arrival.mean(person.durations)
        time_left.learn(person.time_left, person.intervals, movement.time_left, span, usual, PRIOR)
        arrival.remember(person.durations, end - s.t0)


@law
def conclude(memory: Memory, targets: Targets, coefficients: Coefficients) -> None:
    """The movement has ended where the cursor is: learn from it, and forget it."""
    learn_prediction(memory, targets, coefficients)
    learn_target(memory, targets)


@law
def size_of(rows: FloatTable, shares: FloatArray) -> float:
    """The expected size of what the movement ends in, px."""
    size, total = SIZE_PX * shares[len(rows)], shares[len(rows)]
    for i in range(len(rows)):
        size += shares[i] * 0.5 * (rows[i, WIDTH] + rows[i, HEIGHT])
        total += shares[i]
    return float(max(size / total, 1.0))


@law
def record(movement: Movement, s: cursor.State, region: endpoint.Ellipse, answer: TenFloats) -> None:
    """Remember what is stated now, if the last moment is far enough back."""
    last = movement.moments[max(int(movement.series.count) - 1, 0)]
    number, full = moments.next_moment(movement.series, last.t, (s.t, s.x, s.y), MOST)
    if number < 0:
        return
    if full:
        for k in range(1, number):
            copy_values(movement.moments[2 * k].memory, movement.moments[k].memory)
    m = movement.moments[number]
    m.t = s.t
    m.x, m.y, m.sxx, m.sxy, m.syy, m.tail = region
    for i in range(len(answer)):
        m.answer[i] = answer[i]
    copy_values(s.memory, m.cursor.memory)


@law
def share_passed(since: float, left: float, usual: float) -> float:
    """The share of the time that has passed; without a time left, of ``usual``, the usual duration, s."""
    total = since + left if left == left else max(usual, since)
    return since / total if total > 0.0 else 0.0


@law
def step(
    memory: Memory, event: SixFloats, answer: TenFloats, targets: Targets, coefficients: Coefficients
) -> TenFloats:
    """Take in an event and the prediction made at it: the prediction given the targets.

    Writes how likely each target is. Where nothing is predicted, nothing is. The event is one that the
    predictor has taken.
    """
    t, x, y, _, _, buttons = event
    rows, _, _, shares = targets
    s, movement, person = memory.cursor, memory.movement, memory.person
    if cursor.begins(s, t, float(int(buttons) & 1)):
        learn_prediction(memory, targets, coefficients)
    follow(memory, event, targets)
    weigh(memory, answer, targets, coefficients)
    if answer[1] != answer[1] or len(rows) == 0:
        return answer
    predicted = endpoint.elsewhere(s, answer)
    movement.claimed = 1.0
    for i in range(len(predicted)):
        movement.elsewhere_law[i] = predicted[i]
    parts = np.empty((len(rows) + 1, PartRow.length))
    least = min(endpoint.NEGLIGIBLE, 0.5 / max(len(rows), 1))
    count = endpoint.mixture(rows, shares, predicted, least, parts)
    end = endpoint.geometric_median(parts, count)
    region = endpoint.ellipse(parts, count, end, (x - s.x0, y - s.y0))
    since, left, spread = t - s.t0, answer[6], answer[9]
    usual = arrival.mean(person.durations)
    if usual > 0.0 and left == left:
        way = hypot(end[0] - x, end[1] - y)
        known = arrival.terms(left, since, usual, way, size_of(rows, shares))
        left, spread = time_left.weighed(
            person.time_left,
            person.intervals,
            movement.time_left,
            (t, x, y),
            since,
            usual,
            left,
            known,
            PRIOR,
        )
    share = share_passed(since, left, usual)
    factor, tail = region_widening.widen(person.regions, share, region.tail)
    region = endpoint.Ellipse(
        region.x, region.y, factor * region.sxx, factor * region.sxy, factor * region.syy, tail
    )
    if memory.settings.learn == 1.0:
        record(movement, s, region, answer)
    movement.remaining_s = left
    _, _, _, _, _, _, _, phase, _, _ = answer
    return t, region.x, region.y, region.sxx, region.sxy, region.syy, left, phase, tail, spread


@law
def lay_parts(memory: Memory, targets: Targets, out: FloatTable) -> tuple[int, float, float]:
    """Write the parts of the law of the endpoint as it was stated last, elsewhere first, a row each.

    Returns how many, 0 where no endpoint was stated, and the offsets of ``Mixture``.
    """
    s, movement = memory.cursor, memory.movement
    if movement.claimed == 0.0:
        return 0, 0.0, 0.0
    law_of = movement.elsewhere_law
    predicted = posterior.Law(law_of[0], law_of[1], law_of[2], law_of[3], law_of[4], law_of[5])
    count = endpoint.mixture(targets[0], targets[3], predicted, LIKELY, out)
    person = memory.person
    share = share_passed(s.t - s.t0, movement.remaining_s, arrival.mean(person.durations))
    mixed = person.regions.mixed
    return count, levels.offset(mixed, share, 0), levels.offset(mixed, share, 1)


@law
def walk(
    memory: Memory,
    begins: BoolArray,
    events: FloatTable,
    answers: FloatTable,
    targets: Targets,
    coefficients: Coefficients,
) -> None:
    """``step`` over tables; the predictions take the place of ``answers``."""
    for i in range(len(events)):
        if begins[i]:
            conclude(memory, targets, coefficients)
            clear(memory.cursor)
        answer = step(memory, event_at(events, i), row_at(answers, i), targets, coefficients)
        for j in range(len(answer)):
            answers[i, j] = answer[j]


def keys_of(target: Target) -> tuple[float, float]:
    """The numbers for a target's id, and for its kind and size, to the nearest power of two of its sides."""
    width, height = round(log2(target.width)), round(log2(target.height))
    return key_of(str(target.id)), key_of(f"{target.kind} {width} {height}")


@law
def fault(learned: Person) -> tuple[int, float]:
    """What is wrong with what is known of a person, as ``time_left.fault`` says it; FINE for nothing."""
    return time_left.fault(learned.time_left, PRIOR)


class Aim(CompiledStage):
    """What can be pointed at, how likely each target is, and the prediction given these.

    The last stage of a pipeline: ``given`` takes an event and the prediction made at it, as rows. While
    ``learn`` is 1 finished movements teach it which targets the person takes, how often none of them, how
    large regions have to be, and how long movements take; a region and a time left are then this person's.
    Memory: some 1,600 floats, 9 a target.
    """

    elsewhere: float = parameter(
        "",
        1e-6,
        0.999999,
        "share of movements that go to none of the targets: at least, and at first",
        default=ELSEWHERE,
    )
    learn: int = parameter(
        "", 0, 1, "1: learn from finished movements what the person takes; 0: not", default=1, whole=True
    )
    learned = Person.length
    states = Memory.length - Settings.length - Person.length
    slots = slots_of(Memory)
    fault = staticmethod(fault)
    doubt = staticmethod(lambda known: time_left.doubt(Person(known).time_left, PRIOR))

    def __init__(self, *, coefficients: FloatArray = posterior.FITTED, **values: Any) -> None:
        """``coefficients``: of the evidence for a target. Raises ParameterError."""
        super().__init__(**values)
        if coefficients.shape != (Coefficients.length,) or not np.isfinite(coefficients).all():
            sentence = f"coefficients must be {Coefficients.length} finite numbers, received {coefficients!r}"
            raise ParameterError(sentence, field="coefficients")
        self._coefficients = coefficients.astype(np.float64)
        self.register(())

    def register(self, targets: Sequence[Target]) -> None:
        """Take these targets in place of those before; raises ParameterError, and then changes nothing."""
        rows = table(targets)
        keys = np.array([keys_of(target) for target in targets]).reshape(-1, past.KEYS)
        self.ids: tuple[Hashable, ...] = tuple(target.id for target in targets)
        self._targets: Targets = rows, rows[:, LOG_WEIGHT].copy(), keys, np.zeros(len(rows) + 1)
        begin(self._memory, self._targets)

    @property
    def keys(self) -> FloatTable:
        """The numbers of the targets, as ``past`` takes them. A view."""
        return self._targets[2]

    @property
    def memory(self) -> FloatArray:
        """What is known of the person, the cursor and the movement, as laws take it. A view."""
        return self._memory

    @property
    def shares(self) -> FloatArray:
        """How likely each target is, in their order; the last: none of them. A view."""
        return self._targets[-1]

    def likeliest(self, most: int = 5) -> list[tuple[Hashable, float]]:
        """The likeliest targets and their shares, best first."""
        order = np.argsort(-self.shares[:-1], kind="stable")[:most].tolist()
        return [(self.ids[i], float(self.shares[i])) for i in order]

    @property
    def table(self) -> FloatArray:
        """The targets as laws take them, with their weights before the movement. A view."""
        return self._targets[0]

    @property
    def cursor(self) -> cursor.State:
        """The cursor's way. A view."""
        return Memory(self._memory).cursor

    @property
    def released(self) -> bool:
        """Whether the last event released a button."""
        return Memory(self._memory).movement.released == 1.0

    @property
    def remaining_s(self) -> float:
        """The time left that was stated last, s; NaN where none was."""
        return float(Memory(self._memory).movement.remaining_s)

    def given(self, row: Row, answer: TenFloats) -> TenFloats:
        """One event, and the prediction made at it, through the law."""
        return step(self._memory, row, answer, self._targets, self._coefficients)

    def follow(self, begins: BoolArray, events: FloatArray, answers: FloatArray) -> None:
        """``given`` over tables; the predictions take the place of ``answers``."""
        walk(self._memory, begins, events, answers, self._targets, self._coefficients)

    def mixture(self, own: Mixture | None) -> Mixture | None:
        """The law of the endpoint by the targets; elsewhere it is the predictor's ``own``, if there is one.

        ``None`` where no endpoint was stated.
        """
        parts = np.empty((len(self.ids) + 1, PartRow.length))
        count, *offsets = lay_parts(self._memory, self._targets, parts)
        if count == 0:
            return None
        first, *aimed = (
            Part(share, x, y, (sxx, sxy, syy), tail or None)
            for share, x, y, sxx, sxy, syy, tail in parts[:count].tolist()
        )
        others = (first,) if own is None else own.parts
        scaled = [
            structs.replace(one, share=one.share * first.share / sum(p.share for p in others))
            for one in others
        ]
        near, far = map(float, offsets)
        return Mixture((*scaled, *aimed), (near, far))

    def reset(self) -> None:
        """Forget every event, after learning from the movement that ends; the targets stay."""
        conclude(self._memory, self._targets, self._coefficients)
        self._memory[self._first :] = 0.0
        begin(self._memory, self._targets)

    def fresh(self) -> Self:
        """The same targets, which remembers no event and knows nobody."""
        twin = super().fresh()
        begin(twin._memory, twin._targets)
        return twin

    def __copy__(self) -> Self:
        twin = super().__copy__()
        rows, own, keys, shares = self._targets
        twin._targets = rows.copy(), own, keys, shares.copy()
        return twin
