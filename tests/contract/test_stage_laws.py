"""The laws that every pipeline of the registry obeys, without exemptions, and some of them given targets."""

from __future__ import annotations

import pickle

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointpred import REGISTRY, EventColumns, Pipeline, PointerEvent, build, run
from pointpred.errors import EventError, EventOrderError
from pointpred.targets import Target, around

GIVEN = " given targets"
NAMES = [
    *REGISTRY,
    *(f"{name}{GIVEN}" for name in ("hold", "minimum-jerk", "delphian", "kinematic-adaptive")),
]
EVERY = pytest.mark.parametrize("name", NAMES)
POSITIONS = ("x", "y")
LARGEST_PIPELINE_BYTES = 64 * 1024


def make(name: str, x: float = 0.0, y: float = 0.0) -> Pipeline:
    """Where the signals' reach ends, near there, where it comes from, aside: moved by (x, y)."""
    targets = [
        around("there", x + 380.0, y + 307.0, 40.0),
        Target("near", x + 300.0, y + 330.0, 60.0, 20.0, weight=2.0, kind="button"),
        around("here", x, y, 30.0),
        around("aside", x - 90.0, y + 200.0, 9.0, 200.0),
    ]
    return build(name.removesuffix(GIVEN), cpi=2000.0, targets=targets if name.endswith(GIVEN) else ())


def answers(pipeline: Pipeline, events: EventColumns) -> np.ndarray:
    return run(pipeline, events).table


def same(left: np.ndarray, right: np.ndarray) -> bool:
    return left.tobytes() == right.tobytes()


@EVERY
def test_update_is_run(name: str, events: EventColumns) -> None:
    pipeline = make(name)
    streamed = [pipeline.update(event) for event in events.events()]
    assert streamed == list(run(make(name), events).predictions())


@EVERY
@given(cut=st.floats(0.0, 1.0))
@settings(max_examples=10, deadline=None)
def test_chunks_equal_the_whole_and_the_future_changes_nothing(name: str, cut: float) -> None:
    events = _troubled()
    at = int(cut * len(events))
    whole = answers(make(name), events)
    chunked = make(name)
    head = answers(chunked, events.rows(0, at))
    tail = answers(chunked, events.rows(at, len(events)))
    assert same(np.concatenate([head, tail]), whole)


@EVERY
@pytest.mark.parametrize("origin", [1024.0, 1.7e9])
def test_the_clock_has_no_origin(name: str, origin: float, events: EventColumns) -> None:
    """Nor is any clock too late: 1.7e9 s have passed since 1970."""
    shifted = events.table.copy()
    shifted[:, 0] += origin  # exact for these stamps
    late = answers(make(name), EventColumns(shifted))
    assert same(late[:, 1:], answers(make(name), events)[:, 1:])


@EVERY
def test_the_screen_has_no_origin(name: str, events: EventColumns) -> None:
    shifted = events.table.copy()
    shifted[:, 1] += 4096.0
    shifted[:, 2] -= 1024.0
    moved = answers(make(name, 4096.0, -1024.0), EventColumns(shifted))
    moved[:, 1] -= 4096.0
    moved[:, 2] += 1024.0
    np.testing.assert_allclose(moved, answers(make(name), events), rtol=1e-5, atol=1e-5)


@EVERY
def test_zero_is_data(name: str) -> None:
    pipeline = make(name)
    pipeline.update(PointerEvent(0.0, 0.0, 0.0))
    with pytest.raises(EventOrderError, match=r"received -1\.0 s after 0\.0 s"):
        pipeline.update(PointerEvent(-1.0, 0.0, 0.0))


@EVERY
def test_events_at_one_time_are_one_event(name: str) -> None:
    """The first event too: the later position replaces, so it is where the movement starts."""
    rest = [PointerEvent(0.01 * i, 20.0 + 3.0 * i * i, -2.0 * i) for i in range(1, 30)]
    once, twice = make(name), make(name)
    left = [once.update(event) for event in [PointerEvent(0.0, 20.0, 0.0), *rest]]
    twice.update(PointerEvent(0.0, 5.0, 7.0))
    right = [twice.update(event) for event in [PointerEvent(0.0, 20.0, 0.0), *rest]]
    assert left[1:] == right[1:]


BAD = {
    "backwards": (PointerEvent(-1.0, 0.0, 0.0), EventOrderError, "t must not run backwards"),
    "NaN time": (PointerEvent(float("nan"), 0.0, 0.0), EventError, "t must lie"),
    "time in milliseconds": (PointerEvent(1.7e12, 0.0, 0.0), EventError, r"t must lie in .*1e\+11"),
    "NaN place": (PointerEvent(9.0, float("nan"), 0.0), EventError, "x must lie"),
    "infinite place": (PointerEvent(9.0, 0.0, float("inf")), EventError, "y must lie"),
    "half counts": (PointerEvent(9.0, 0.0, 0.0, 1.0), EventError, "dx and dy come together"),
    "infinite counts": (PointerEvent(9.0, 0.0, 0.0, float("inf"), 0.0), EventError, "dx must lie"),
    "too far": (PointerEvent(9.0, 1e300, 0.0), EventError, "x must lie"),
}


@EVERY
@pytest.mark.parametrize("kind", list(BAD))
def test_a_refused_event_changes_nothing(name: str, kind: str, troubled_events: EventColumns) -> None:
    event, error, message = BAD[kind]
    pipeline = make(name)
    answers(pipeline, troubled_events.rows(0, 60))
    before = pickle.dumps(pipeline)
    with pytest.raises(error, match=message):
        pipeline.update(event)
    assert pickle.dumps(pipeline) == before
    with pytest.raises(error, match=f"row 0: {message}"):
        run(pipeline, EventColumns.of_events([event]))
    assert pickle.dumps(pipeline) == before


@EVERY
def test_memory_is_bounded(name: str) -> None:
    random = np.random.default_rng(5)
    count = 100_000
    t = np.cumsum(random.uniform(1e-4, 2e-3, count))
    place = np.cumsum(random.integers(-3, 4, (count, 2)), axis=0).T
    pipeline = make(name)
    answers(pipeline, EventColumns.of(t[:1000], *place[:, :1000]))
    size = len(pickle.dumps(pipeline))
    answers(pipeline, EventColumns.of(t[1000:], *place[:, 1000:]))
    assert len(pickle.dumps(pipeline)) == size
    assert size < LARGEST_PIPELINE_BYTES


@EVERY
def test_two_pipelines_share_nothing(name: str, troubled_events: EventColumns) -> None:
    alone = [make(name).update(event) for event in troubled_events.rows(0, 1).events()]
    one, other = make(name), make(name)
    answers(other, troubled_events)
    assert [one.update(event) for event in troubled_events.rows(0, 1).events()] == alone
    twin = one.fresh()
    answers(twin, troubled_events)
    left = [one.update(event) for event in troubled_events.rows(1, 80).events()]
    solo = make(name)
    whole = [solo.update(event) for event in troubled_events.rows(0, 80).events()]
    assert left == whole[1:]


@EVERY
def test_the_input_is_not_modified(name: str, events: EventColumns) -> None:
    before = events.table.copy()
    answers(make(name), events)
    assert same(events.table, before)


@EVERY
def test_it_pickles_and_goes_on(name: str, troubled_events: EventColumns) -> None:
    pipeline = make(name)
    half = len(troubled_events) // 2
    answers(pipeline, troubled_events.rows(0, half))
    twin = pickle.loads(pickle.dumps(pipeline))
    rest = troubled_events.rows(half, len(troubled_events))
    assert same(answers(twin, rest), answers(pipeline, rest))


@EVERY
def test_answers_are_finite_and_phases_known(name: str, events: EventColumns) -> None:
    _assert_sound(answers(make(name), events))


WILD = st.lists(
    st.tuples(
        st.sampled_from([0.0, 1e-9, 1.25e-4, 0.001, 0.016, 0.09, 0.2, 5.0]),
        st.floats(-1e5, 1e5) | st.sampled_from([0.0, 1.0, -1.0, 1e9]),
        st.floats(-1e5, 1e5) | st.sampled_from([0.0, 1.0, -1.0, 1e9]),
        st.sampled_from([None, 0.0, 1.0, -3.0, 32767.0]),
        st.integers(0, 3),
    ),
    min_size=1,
    max_size=60,
)


@EVERY
@given(rows=WILD)
@settings(max_examples=60, deadline=None)
def test_never_nan(name: str, rows: list[tuple[float, float, float, float | None, int]]) -> None:
    t = 0.0
    events = []
    for dt, x, y, counts, buttons in rows:
        t += dt
        events.append(PointerEvent(t, x, y, counts, counts, buttons))
    _assert_sound(answers(make(name), EventColumns.of_events(events)))


def _assert_sound(table: np.ndarray) -> None:
    """Both coordinates or neither; a region whole or not at all, and a covariance; no infinity; a phase."""
    given_rows = ~np.isnan(table[:, 1])
    assert np.array_equal(given_rows, ~np.isnan(table[:, 2]))
    region = ~np.isnan(table[:, 3:6])
    assert np.array_equal(region.all(axis=1), region.any(axis=1))
    sxx, sxy, syy = table[region.all(axis=1), 3:6].T
    assert (sxx >= 0.0).all()
    assert (syy >= 0.0).all()
    assert (sxx * syy - sxy**2 >= -1e-6 * sxx * syy - 1e-9).all()
    assert not np.isinf(table).any()
    remaining = table[:, 6]
    assert (remaining[~np.isnan(remaining)] >= 0.0).all()
    assert np.isin(table[:, 7], (0.0, 1.0, 2.0)).all()


def _troubled() -> EventColumns:
    """The troubled signal without the fixture: hypothesis runs many examples inside one test."""
    random = np.random.default_rng(11)
    t = np.cumsum(random.choice([0.0, 0.001, 0.008, 0.017, 0.15, 0.4], 150))
    place = np.cumsum(random.integers(-12, 20, (150, 2)), axis=0)
    return EventColumns.of(t, *place.T, buttons=random.integers(0, 2, 150))
