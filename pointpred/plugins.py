"""Predictors of other packages, found by entry points: whether one keeps the laws that ours keep.

An entry point of the group ``pointpred.predictors`` names a callable that makes a predictor; see ``load`` and
``PlainPredictor``. ``check`` runs what our own predictors are tested with.
"""

from __future__ import annotations

import pickle
from collections.abc import Callable

import msgspec
import numpy as np

from pointpred.errors import EventError
from pointpred.pipeline import Pipeline, run
from pointpred.predictors.plain import PlainPredictor
from pointpred.records import EventColumns, FloatArray, PointerEvent
from pointpred.registry import build, find_others, load, others

__all__ = ["LAWS", "SIGNALS", "Kept", "PlainPredictor", "check", "find_others", "load", "others"]

TICK = 2.0**-13
"""Time stamps are multiples of this: adding a power of two to them is exact."""
NEAR = 1e-5
"""Numbers that differ by less, or by this share, are equal where an origin has moved."""
Make = Callable[[], Pipeline]


def minimum_jerk(duration: float, period: float, *, jitter: float = 0.0, seed: int = 1) -> EventColumns:
    """A straight reach of 500 px with a correction, in whole pixels, followed by a dwell."""
    random = np.random.default_rng(seed)
    t = np.arange(0.0, duration + 0.4, period)
    t = t + np.concatenate([[0.0], random.uniform(-jitter, jitter, len(t) - 1) * period])
    t = np.round(t / TICK) * TICK
    s = np.clip(t / duration, 0.0, 1.0)
    r = np.clip((t - duration) / 0.3, 0.0, 1.0)
    reach = 10 * s**3 - 15 * s**4 + 6 * s**5
    back = 10 * r**3 - 15 * r**4 + 6 * r**5
    return EventColumns.of(t, np.round(400 * reach - 20 * back), np.round(300 * reach + 7 * back))


def with_counts() -> EventColumns:
    """The same reach reported as counts beside pixels, four counts a pixel."""
    events = minimum_jerk(0.7, 0.001, jitter=0.3)
    table = events.table.copy()
    table[:, 3] = 4.0 * np.diff(table[:, 1], prepend=table[0, 1])
    table[:, 4] = 4.0 * np.diff(table[:, 2], prepend=table[0, 2])
    return EventColumns(table)


def troubled() -> EventColumns:
    """Equal stamps, gaps, pauses, a click, counts that come and go, a cursor that stands and turns back."""
    events = minimum_jerk(0.6, 0.008, jitter=0.4, seed=3)
    table = np.concatenate([events.table, events.table, events.table])
    length = len(events)
    table[length:, 0] += 2.0
    table[2 * length :, 0] += 2.0
    table[length : 2 * length, 1:3] *= -1.0
    table[5:60:7, 0] = table[4:59:7, 0]
    table[length + 20 : 2 * length, 0] += 0.1875
    table[length - 10 : length - 5, 5] = 1.0
    table[2 * length + 3 : 2 * length + 30, 3:5] = 3.0
    return EventColumns(table)


def wandering(rate: float = 125.0, count: int = 400, seed: int = 7) -> EventColumns:
    """A random walk: no law of movement holds."""
    random = np.random.default_rng(seed)
    t = np.round(np.cumsum(random.exponential(1.0 / rate, count)) / TICK) * TICK
    steps = np.round(random.standard_normal((count, 2)) * random.choice([0.0, 1.0, 30.0], (count, 1)))
    x, y = np.cumsum(steps, axis=0).T
    return EventColumns.of(t, x, y, buttons=random.integers(0, 4, count))


SIGNALS: dict[str, Callable[[], EventColumns]] = {
    "reach at 1 kHz": lambda: minimum_jerk(0.7, 0.001, jitter=0.3),
    "reach at 60 Hz": lambda: minimum_jerk(0.7, 1 / 60, jitter=0.2),
    "reach at 8 kHz": lambda: minimum_jerk(0.3, TICK),
    "reach with counts": with_counts,
    "troubled": troubled,
    "wandering": wandering,
    "still": lambda: EventColumns.of(np.arange(50) * 0.0078125, np.zeros(50), np.zeros(50)),
    "one event": lambda: EventColumns.of([0.0], [0.0], [0.0]),
    "1 Hz": lambda: EventColumns.of(np.arange(20.0), np.arange(20.0) ** 2, np.arange(20.0)),
}
"""What every predictor must survive."""


class Kept(msgspec.Struct, frozen=True):
    """One law, and how a predictor breaks it; "" where it keeps it."""

    law: str
    trouble: str


def check(predictor: str | Make) -> list[Kept]:
    """Whether a predictor keeps the LAWS, each tried on SIGNALS; some seconds in plain Python.

    ``predictor``: its name, or what makes a fresh pipeline.

    >>> [one.law for one in check("linear") if one.trouble]
    []
    """

    def make() -> Pipeline:
        return build(predictor, cpi=2000.0) if isinstance(predictor, str) else predictor()

    kept = []
    for name, law in LAWS.items():
        try:
            trouble = law(make)
        except Exception as error:  # a predictor may raise anything
            trouble = f"{type(error).__name__}: {error}"
        kept.append(Kept(name, trouble))
    return kept


def _aside() -> EventColumns:
    """A random walk that begins where no other signal does."""
    return EventColumns(wandering().table + np.array([0, 77, 55, 0, 0, 0]))


def _answers(pipeline: Pipeline, events: EventColumns) -> FloatArray:
    return run(pipeline, events).table


def _differ(left: FloatArray, right: FloatArray, near: float = 0.0) -> str:
    """The first row in which two tables of answers differ, in words."""
    same = np.isclose(left, right, rtol=near, atol=near, equal_nan=True).all(axis=1)
    rows = np.flatnonzero(~same)
    if not len(rows):
        return ""
    first, second = (", ".join(f"{value:g}" for value in one[rows[0]][:3]) for one in (left, right))
    return f"answer {rows[0]} is t, x, y = {first}, expected {second}"


def _update_is_run(make: Make) -> str:
    for name, signal in SIGNALS.items():
        events, one = signal(), make()
        streamed = [one.update(event) for event in events.events()]
        if streamed != list(run(make(), events).predictions()):
            return f"{name}: update, event by event, does not answer as run does"
    return ""


def _chunks(make: Make) -> str:
    events = troubled()
    whole = _answers(make(), events)
    for at in (1, 60, 61, 150, 200):
        one = make()
        parts = _answers(one, events.rows(0, at)), _answers(one, events.rows(at, len(events)))
        if words := _differ(np.concatenate(parts), whole):
            return f"events cut in two at {at}: {words}"
    return ""


def _origin_of_time(make: Make) -> str:
    for origin in (1024.0, 1.7e9):
        events = troubled()
        moved = events.table + np.array([origin, 0, 0, 0, 0, 0])
        answers = _answers(make(), EventColumns(moved))
        answers[:, 0] -= origin
        if words := _differ(answers, _answers(make(), events), NEAR):
            return f"times {origin:g} s later: {words}"
    return ""


def _origin_of_space(make: Make) -> str:
    for name in ("reach at 60 Hz", "troubled"):
        events = SIGNALS[name]()
        moved = _answers(make(), EventColumns(events.table + np.array([0, 4096, -1024, 0, 0, 0])))
        moved[:, 1:3] -= [4096.0, -1024.0]
        if words := _differ(moved, _answers(make(), events), NEAR):
            return f"4096 px to the right and 1024 px up: {words}"
    return ""


def _one_time(make: Make) -> str:
    rest = [PointerEvent(0.01 * i, 20.0 + 3.0 * i * i, -2.0 * i) for i in range(1, 30)]
    once, twice = make(), make()
    left = [once.update(event) for event in (PointerEvent(0.0, 20.0, 0.0), *rest)]
    twice.update(PointerEvent(0.0, 5.0, 7.0))
    right = [twice.update(event) for event in (PointerEvent(0.0, 20.0, 0.0), *rest)]
    return "" if left[1:] == right[1:] else "of two events at one time the first still counts"


def _refused(make: Make) -> str:
    events = troubled()
    one, twin = make(), make()
    for pipeline in (one, twin):
        _answers(pipeline, events.rows(0, 60))
    after = EventColumns(events.table[59:60] - [1.0, 0, 0, 0, 0, 0])
    for bad in (
        PointerEvent(-1.0, 0.0, 0.0),
        PointerEvent(9.0, float("nan"), 0.0),
        PointerEvent(9.0, 1e300, 0.0),
    ):
        for refusing in (lambda bad=bad: one.update(bad), lambda: run(one, after)):
            try:
                refusing()
            except EventError:
                continue
            return f"{bad} is not refused"
    words = _differ(_answers(one, events.rows(60, 160)), _answers(twin, events.rows(60, 160)))
    return f"after a refused event: {words}" if words else ""


def _begins(make: Make) -> str:
    before, events = _aside(), troubled()
    table = np.concatenate([before.table, events.table])
    begin = np.isin(np.arange(len(table)), (0, len(before)))
    apart = make()
    first = _answers(apart, before)
    if not apart.learns:
        apart = make()
    apart.reset()
    words = _differ(
        _answers(make(), EventColumns(table, begin)), np.concatenate([first, _answers(apart, events)])
    )
    return f"a row marked begin, where reset is expected: {words}" if words else ""


def _forgets(make: Make) -> str:
    events, used = troubled(), make()
    first = _answers(make(), events)
    _answers(used, _aside())
    if words := _differ(_answers(used.fresh(), events), first):
        return f"a fresh one remembers: {words}"
    used.reset()
    words = "" if used.learns else _differ(_answers(used, events), first)
    return f"after reset, where learns is not True: {words}" if words else ""


def _share(make: Make) -> str:
    events = troubled()
    whole, one, other = _answers(make(), events), make(), make()
    head = _answers(one, events.rows(0, 100))
    _answers(other, events)
    _answers(one.fresh(), events)
    words = _differ(np.concatenate([head, _answers(one, events.rows(100, len(events)))]), whole)
    return f"another one that was used meanwhile: {words}" if words else ""


def _input(make: Make) -> str:
    events = troubled()
    before = events.table.copy()
    _answers(make(), events)
    return "" if events.table.tobytes() == before.tobytes() else "the events were changed"


def _pickles(make: Make) -> str:
    events, one = troubled(), make()
    _answers(one, events.rows(0, 130))
    twin = pickle.loads(pickle.dumps(one))
    rest = events.rows(130, len(events))
    words = _differ(_answers(twin, rest), _answers(one, rest))
    return f"pickled and gone on: {words}" if words else ""


def _bounded(make: Make) -> str:
    one, count = make(), 4000
    t = np.arange(2 * count) / 500.0
    place = np.cumsum(np.random.default_rng(5).integers(-3, 4, (2 * count, 2)), axis=0).T
    events = EventColumns.of(t, *place)
    _answers(one, events.rows(0, count))
    before = len(pickle.dumps(one))
    _answers(one, events.rows(count, 2 * count))
    grown = len(pickle.dumps(one)) - before
    return "" if grown < 64 else f"{count} events of one movement more, and its pickle grows by {grown} bytes"


def _sound(make: Make) -> str:
    for name, signal in SIGNALS.items():
        table = _answers(make(), signal())
        x, y, region, left = table[:, 1], table[:, 2], table[:, 3:6], table[:, 6]
        there = np.isfinite(x)
        given = np.isfinite(region).all(axis=1)
        sxx, sxy, syy = region[given].T
        faults = {
            "infinite numbers": np.isinf(table).any(),
            "x without y": not np.array_equal(there, np.isfinite(y)),
            "a part of a region": not np.array_equal(given, ~np.isnan(region).all(axis=1)),
            "a region that is none": bool(
                np.any((sxx < 0.0) | (syy < 0.0) | (sxx * syy - sxy**2 < -1e-6 * sxx * syy - 1e-9))
            ),
            "negative time left": bool(np.any(left[np.isfinite(left)] < 0.0)),
            "a phase that is none": not np.isin(table[there, 7], (0.0, 1.0, 2.0)).all(),
            "another time than the event's": not np.array_equal(table[:, 0], signal().t),
        }
        if found := [words for words, wrong in faults.items() if wrong]:
            return f"{name}: {', '.join(found)}"
    return ""


LAWS: dict[str, Callable[[Make], str]] = {
    "update, event by event, answers as run": _update_is_run,
    "chunks equal the whole, and the future changes nothing": _chunks,
    "the clock has no origin": _origin_of_time,
    "the screen has no origin": _origin_of_space,
    "events at one time are one event": _one_time,
    "a refused event changes nothing": _refused,
    "a row marked begin is a reset": _begins,
    "fresh and reset forget": _forgets,
    "two share nothing": _share,
    "the input is not modified": _input,
    "it pickles and goes on": _pickles,
    "memory is bounded": _bounded,
    "answers are finite and whole": _sound,
}
"""What predictors have in common, by a sentence each: how one breaks it, in words, "" where it does not."""
