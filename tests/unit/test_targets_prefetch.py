"""The prefetch policy: once a movement, never withdrawn, at entry at the latest, each firing costs more."""

from __future__ import annotations

from collections.abc import Sequence
from runpy import run_path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pointpred import PointerEvent, Prediction
from pointpred.compiled import with_names
from pointpred.errors import ParameterError
from pointpred.targets import Prefetcher, Target, around, cursor, prefetch
from pointpred.targets.prefetch import ARMED, ENTERED, FIRED, PREDICTED, RESTING
from pointpred.targets.rectangles import table
from tests.aimed import Told

NEAR, BEHIND, ASIDE = (
    around("near", 200.0, 0.0, 40.0),
    around("behind", 400.0, 0.0, 40.0),
    around("aside", 0.0, 300.0, 40.0),
)
SETTINGS = np.array(prefetch.FITTED)


class Page:
    """A page's targets, and a cursor that is moved over it by hand."""

    def __init__(self, targets: Sequence[Target], threshold: float = prefetch.THRESHOLD) -> None:
        self.table, self.thresholds = table(targets), np.full(len(targets), threshold)
        self.state = prefetch.State(np.zeros(prefetch.State.length))
        self.visits, self.fired = np.zeros(len(targets)), np.zeros(len(targets))

    @property
    def targets(self) -> prefetch.Targets:
        return self.table, self.thresholds, self.visits, self.fired

    def move(
        self, t: float, x: float, y: float, shares: Sequence[float] | None = None, pressed: float = 0.0
    ) -> list[int]:
        """The places of the targets that fire at this event; all targets equally unlikely unless given."""
        cursor.follow(self.state.memory, t, x, y, pressed)
        each = np.full(len(self.table) + 1, 1e-9) if shares is None else np.array([*shares, 0.0])
        count = prefetch.step(self.state.memory, self.targets, each, SETTINGS)
        now = np.flatnonzero(self.fired >= PREDICTED).tolist()
        assert count == len(now)
        return now


def test_what_lies_on_the_way_to_the_likeliest_is_visited_and_what_lies_behind_is_not() -> None:
    targets, out = table([NEAR, BEHIND, ASIDE]), np.zeros(3)
    prefetch.visit(0.0, 0.0, targets, np.array([0.1, 0.7, 0.2, 0.0]), out)
    assert out.tolist() == pytest.approx([0.8, 0.7, 0.2])


@pytest.mark.parametrize(
    ("row", "steps"),
    [
        ((200.0, 0.0, 40.0, 40.0, 0.0), 1.8),
        ((200.0, 21.0, 40.0, 40.0, 0.0), np.inf),
        ((-200.0, 0.0, 40.0, 40.0, 0.0), np.inf),
        ((5.0, 0.0, 40.0, 40.0, 0.0), 0.0),
    ],
)
def test_contact_counts_steps_to_the_border(row: tuple[float, ...], steps: float) -> None:
    assert prefetch.contact(0.0, 0.0, 100.0, 0.0, np.array(row)) == pytest.approx(steps)


def test_a_sure_target_fires_early_and_once() -> None:
    page = Page([NEAR, ASIDE])
    assert page.move(0.0, 0.0, 0.0, (0.99, 0.0)) == []  # nobody can say yet that a movement has begun
    assert page.move(0.01, 10.0, 0.0, (0.99, 0.0)) == [0]
    assert page.fired.tolist() == [PREDICTED, ARMED]
    assert page.move(0.02, 20.0, 0.0, (0.99, 0.0)) == []
    assert page.fired.tolist() == [FIRED, ARMED]
    assert page.move(0.2, 200.0, 0.0, (0.99, 0.0)) == []  # nor again at entry


def test_a_target_fires_at_entry_at_the_latest_even_where_it_is_called_impossible() -> None:
    page = Page([NEAR])
    assert page.move(0.0, 0.0, 0.0) == []
    assert page.move(0.25, 200.0, 0.0) == [0]
    assert page.fired.tolist() == [ENTERED]


def test_a_target_of_weight_0_never_fires() -> None:
    page = Page([Target("never", 180.0, -20.0, 40.0, 40.0, weight=0.0), ASIDE])
    assert page.move(0.0, 0.0, 0.0) == page.move(0.1, 150.0, 0.0, (0.99, 0.0)) == []
    assert page.move(0.2, 200.0, 0.0) == []


def test_the_next_movement_arms_again_but_for_where_it_starts() -> None:
    page = Page([NEAR, ASIDE])
    assert page.move(0.0, 0.0, 0.0) == []
    assert page.move(0.1, 20.0, 0.0, (0.9, 0.9)) == [0, 1]
    assert page.move(0.2, 200.0, 0.0, pressed=1.0) == []
    assert page.move(0.3, 200.0, 0.0) == []  # the button comes up: a movement begins, in the first target
    assert page.fired.tolist() == [RESTING, ARMED]
    assert page.move(0.4, 202.0, 0.0, (0.99, 0.0)) == []
    assert page.move(0.5, 300.0, 0.0) == []
    assert page.fired[0] == ARMED
    assert page.move(0.6, 200.0, 0.0) == [0]


def test_a_higher_threshold_fires_later() -> None:
    def first(threshold: float) -> float:
        page = Page([NEAR, ASIDE, BEHIND], threshold)
        for i in range(100):
            p = i / 100
            if page.move(i / 100, 1.5 * i, 0.0, (p, 0.5 * (1.0 - p), 0.0)):
                return p
        return 1.0

    times = [first(threshold) for threshold in (0.0, 0.1, 0.5, 0.9, 1.0)]
    assert times == sorted(times)
    assert times[0] < times[-1]


positions = st.lists(st.tuples(st.integers(-100, 500), st.integers(-100, 400)), min_size=2, max_size=60)


@given(positions, st.integers(0, 2**32 - 1))
def test_nothing_fires_twice_and_whatever_is_entered_has_fired(way: list[tuple[int, int]], seed: int) -> None:
    generator, page = np.random.default_rng(seed), Page([NEAR, BEHIND, ASIDE])
    seen: list[int] = []
    for i, (x, y) in enumerate(way):
        shares = generator.dirichlet(np.full(4, 0.3))
        seen += page.move(i / 100, float(x), float(y), shares[:3].tolist())
        for k, row in enumerate(page.table):
            assert not prefetch.inside(float(x), float(y), row) or k in seen
    assert len(seen) == len(set(seen))
    assert np.isfinite(page.state.memory).all()
    assert np.isfinite(page.visits).all()


def test_more_targets_than_paths_and_none_at_all() -> None:
    many = Page([around(i, 60.0 * i + 60.0, 0.0, 40.0) for i in range(40)])
    assert many.move(0.0, 0.0, 0.0) == []
    assert many.move(0.05, 30.0, 0.0, [0.0] * 39 + [1.0])  # all lie on the way to the last
    assert Page([]).move(0.0, 0.0, 0.0, ()) == []


def test_plain_python_agrees_with_the_compiled_law(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("pointpred.compiled.law", with_names)
    plain = run_path(prefetch.__file__)["step"]
    generator = np.random.default_rng(3)
    one, other = Page([NEAR, BEHIND, ASIDE]), Page([NEAR, BEHIND, ASIDE])
    for i in range(200):
        t, x, y = i / 100, 2.0 * i, float(generator.normal(0.0, 30.0))
        shares = generator.dirichlet(np.full(4, 0.3))
        for page, step in ((one, prefetch.step), (other, plain)):
            cursor.follow(page.state.memory, t, x, y, 0.0)
            step(page.state, page.targets, shares, SETTINGS)
        assert one.fired.tolist() == other.fired.tolist()
        assert one.visits == pytest.approx(other.visits, rel=1e-12)


class Prefetched:
    """A prefetcher of targets, and a cursor that goes straight from x = 0 to 200 px in 40 events."""

    def __init__(self, *targets: Target, threshold: float = prefetch.THRESHOLD) -> None:
        self.pipeline = Told(targets)
        self.prefetcher = Prefetcher(self.pipeline, threshold=threshold)

    def straight(self, until: int, y: float = 0.0) -> list[object]:
        """What fires on the way, the endpoint known."""
        fired: list[object] = []
        for i in range(until):
            known = Prediction(i / 100, 200.0, 0.0, (25.0, 0.0, 25.0), "ballistic", None)
            fired += self.at(i / 100, 5.0 * i, y, known)
        return fired

    def at(self, t: float, x: float, y: float = 0.0, known: Prediction | None = None) -> tuple[object, ...]:
        self.pipeline.take(known, PointerEvent(t, x, y))
        return self.prefetcher.update()


def test_the_prefetcher_names_what_fires_once() -> None:
    page = Prefetched(NEAR, ASIDE)
    assert page.straight(41) == ["near"]
    assert page.prefetcher.visits[0] > page.prefetcher.visits[1]


def test_at_a_threshold_of_1_targets_fire_at_entry_only() -> None:
    page = Prefetched(NEAR, ASIDE, threshold=1.0)
    assert page.straight(36) == []
    assert page.at(0.36, 180.0) == ("near",)


def test_a_target_that_stays_on_the_page_does_not_fire_again_and_a_new_one_does() -> None:
    page = Prefetched(NEAR)
    assert page.straight(41) == ["near"]
    page.pipeline.aim.register([around("new", 200.0, 0.0, 30.0), NEAR])
    assert page.at(0.41, 201.0) == ("new",)


def test_after_a_reset_the_same_movement_fires_the_same() -> None:
    page = Prefetched(NEAR, ASIDE)
    first = page.straight(20)
    page.pipeline.aim.reset()
    page.prefetcher.reset()
    assert page.straight(20) == first == ["near"]


def test_a_threshold_out_of_bounds_is_refused() -> None:
    with pytest.raises(ParameterError, match="threshold"):
        Prefetcher(Told(), threshold=1.5)


@given(seed=st.integers(0, 10_000))
def test_no_target_that_reaches_its_threshold_is_passed_over(seed: int) -> None:
    """Targets that are looked at no further could not have fired, also with settings that were not fitted."""
    rng = np.random.default_rng(seed)
    count = 30
    rows = np.column_stack(
        [rng.uniform(0, 1000, (count, 2)), rng.uniform(5, 120, (count, 2)), np.zeros(count)]
    )
    page = Page([around(i, 0.0, 0.0, 10.0) for i in range(count)])
    page.table[:, :4] = rows[:, :4]
    page.thresholds[:] = rng.choice([0.05, 0.2, 0.5, 0.9], count)
    settings = SETTINGS * rng.choice([-1.0, 0.5, 1.0, 2.0], len(SETTINGS))
    start, end = rng.uniform(0, 1000, 2), rng.uniform(0, 1000, 2)
    for i in range(6):
        x, y = start + i / 8 * (end - start)
        shares = rng.dirichlet(np.full(count + 1, 0.3))
        cursor.follow(page.state.memory, i / 60, x, y, 0.0)
        prefetch.step(page.state.memory, page.targets, shares, settings)
        expected = prefetch.expect(x, y, page.table, page.visits, shares)
        moves = np.hypot(*(np.array([x, y]) - start)) >= prefetch.LEAST_WAY_PX
        for k in range(count):
            if page.fired[k] != ARMED or not moves:
                continue
            state = page.state.cursor.memory
            reached = prefetch.score(state, page.table[k], shares[k], page.visits[k], expected, settings)
            assert reached < prefetch.log_odds(page.thresholds[k])
