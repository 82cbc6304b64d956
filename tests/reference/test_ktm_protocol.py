"""The protocol of template matching against a second, slow implementation, and what it draws."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred import EventColumns, build
from pointpred.recording import Recording, Trial
from pointpred.scoring import Prepared, prepare
from pointpred.scoring.ktm_protocol import (
    FRACTIONS,
    LIBRARY,
    ProtocolErrors,
    never_nearer,
    select,
    summarise_protocol,
    with_library,
    without_library,
)
from tests.reference import naive_ktm


def reaches(users: list[str], seed: int = 2) -> Prepared:
    """Reaches of many distances and directions; every third passes its end and comes back."""
    random = np.random.default_rng(seed)
    parts = []
    for k in range(len(users)):
        seconds = random.uniform(0.4, 0.9)
        t = np.arange(0.0, seconds, 1 / 60) + random.uniform(0.0, 1e-3)
        s = np.linspace(0.0, 1.0, len(t))
        way = 10 * s**3 - 15 * s**4 + 6 * s**5
        if k % 3 == 2:
            way += 0.25 * np.sin(np.pi * np.clip((s - 0.6) / 0.4, 0.0, 1.0))
        end = random.uniform(-600.0, 600.0, 2)
        parts.append(EventColumns.of(t, *np.outer(end, way)))
    return prepare(Recording.of("reaches", parts, [Trial(user, str(k)) for k, user in enumerate(users)]))


def moves(prepared: Prepared, trials: list[int]) -> list[tuple[np.ndarray, ...]]:
    return [tuple(prepared.rows(k).table[:, :3].T) for k in trials]


def test_errors_are_those_of_the_slow_implementation_with_the_trial_left_out() -> None:
    prepared = reaches(["ann", "bob"] * 12)
    selection = select(prepared, only_monotone=False, share=0.5, least=5)
    assert len(selection.tested) == 12
    result = with_library(selection)
    for row, k in zip(result.errors, selection.tested, strict=True):
        user = prepared.trials[k].trial.user
        others = [j for j in range(24) if prepared.trials[j].trial.user == user and j != k]
        ((t, x, y),) = moves(prepared, [k])
        predicted = naive_ktm.predictions(t, x, y, moves(prepared, others))
        away = np.hypot(x - x[0], y - y[0])
        for share, error in zip(FRACTIONS, row, strict=True):
            at = np.flatnonzero(away >= share * away[-1])[0]
            expected = np.hypot(predicted[at, 0] - x[-1], predicted[at, 1] - y[-1])
            assert error == pytest.approx(expected, rel=1e-9, abs=1e-6)


def test_a_movement_repeated_is_found_and_a_single_one_is_not() -> None:
    """With the tested trial itself in the library every error would be nearly 0."""
    one = reaches(["ann"] * 20)
    twice = prepare(
        Recording.of(
            "twice",
            [one.rows(k) for k in range(20) for _ in range(2)],
            [Trial("ann", str(k)) for k in range(40)],
        )
    )
    alone = with_library(select(one, only_monotone=True, share=1.0))
    again = with_library(select(twice, only_monotone=True, share=1.0))
    assert again.errors.max() < 1e-6
    assert np.median(alone.errors) > 20.0


def test_trials_that_come_back_are_drawn_only_when_asked_for_and_always_are_templates() -> None:
    prepared = reaches(["ann"] * 30)
    turning = [k for k in range(30) if k % 3 == 2]
    assert [k for k in range(30) if not never_nearer(prepared.rows(k))] == turning
    selection = select(prepared, share=1.0)
    assert set(selection.tested) == set(range(30)) - set(turning)
    assert selection.libraries == {"ann": tuple(range(30))}
    assert select(prepared, share=1.0, only_monotone=False).tested == tuple(range(30))


def test_a_tenth_is_drawn_once_each_and_the_seed_decides_which() -> None:
    prepared = reaches(["ann"] * 60)
    draws = [select(prepared, seed=seed, only_monotone=False).tested for seed in (0, 0, 1)]
    assert [len(set(tested)) for tested in draws] == [6, 6, 6]
    assert draws[0] == draws[1] != draws[2]


def test_who_and_what_takes_no_part_is_told() -> None:
    users = ["ann"] * 16 + ["bob"] * 15
    prepared = reaches(users)
    flick = EventColumns.of([0.0, 0.01, 0.02, 0.04], [0.0, 9.0, 50.0, 90.0], [0.0, 0.0, 0.0, 0.0])
    parts = [*(prepared.rows(k) for k in range(31)), flick]
    trials = [*(Trial(user, str(k)) for k, user in enumerate(users)), Trial("ann", "flick")]
    selection = select(prepare(Recording.of("all", parts, trials)), share=1.0, only_monotone=False)
    assert selection.tested == tuple(range(16))
    assert [(skip.user, skip.trial, skip.reason) for skip in selection.left_out] == [
        ("ann", "flick", "makes no template"),
        ("bob", "*", "15 movements of this person, a library needs 16"),
    ]


def test_a_thousand_templates_are_the_most() -> None:
    short = EventColumns.of(np.arange(6) / 60, 20.0 * np.arange(6) ** 2, np.zeros(6))
    many = prepare(Recording.of("many", [short] * 1100, [Trial("ann", str(k)) for k in range(1100)]))
    selection = select(many, share=0.01)
    assert len(set(selection.libraries["ann"])) == 1000
    assert len(selection.tested) == 10
    assert set(selection.tested) <= set(selection.libraries["ann"])
    assert with_library(selection).errors.shape == (10, 3)


def test_without_a_library_a_pipeline_answers_as_alone_and_one_that_learns_has_seen_what_came_before() -> (
    None
):
    prepared = reaches(["ann", "bob"] * 16)
    selection = select(prepared, share=0.3, only_monotone=False)
    held = without_library(selection, build("hold"))
    for row, k in zip(held.errors, selection.tested, strict=True):
        rows = prepared.rows(k)
        away = np.hypot(rows.x - rows.x[0], rows.y - rows.y[0])
        at = [np.flatnonzero(away >= share * away[-1])[0] for share in FRACTIONS]
        left = np.hypot(rows.x[-1] - rows.x[at], rows.y[-1] - rows.y[at])
        np.testing.assert_allclose(row, left)
    learned = without_library(selection, build("ktm"))
    first = without_library(select(prepared, share=1.0, only_monotone=False), build("ktm"))
    order = sorted(range(32), key=lambda k: prepared.trials[k].trial.user)
    np.testing.assert_array_equal(learned.errors, first.errors[[order.index(k) for k in selection.tested]])
    held_first = without_library(select(prepared, share=1.0, only_monotone=False), build("hold"))
    np.testing.assert_array_equal(first.errors[[0, 16]], held_first.errors[[0, 16]])  # knows nothing yet
    assert (first.errors[[1, 17]] != held_first.errors[[1, 17]]).all()


def test_the_summary_of_errors() -> None:
    floor = ProtocolErrors(
        "hold", np.array([[100.0, 50.0, 20.0], [300.0, 150.0, 60.0]]), np.array([200.0, 600.0])
    )
    one = ProtocolErrors(LIBRARY, np.array([[16.0, 16.1, 0.0], [184.0, 33.9, 80.0]]), floor.distances)
    assert one.mean_px().tolist() == [100.0, 25.0, 40.0]
    assert one.share().tolist() == [0.25, 0.0625, 0.1]
    assert one.skill(floor).tolist() == [0.5, 0.75, 0.0]
    assert one.hits().tolist() == [0.5, 0.0, 0.5]


def test_the_summary_holds_the_numbers_of_what_was_read() -> None:
    selection = select(reaches(["ann", "bob"] * 12), only_monotone=False, share=0.5, least=5)
    reads = [without_library(selection, build("hold")), with_library(selection)]
    one = summarise_protocol(selection, reads, monotone=False)
    assert (one.tested, one.users, one.templates) == (12, 2, (11, 11))
    hold, matched = one.predictors
    assert list(hold.px.values()) == reads[0].mean_px().tolist()
    assert set(hold.skill.values()) == {0.0}
    assert set(matched.of_library.values()) == {1.0}
    low, high = hold.interval[0.5] or (0.0, 0.0)
    assert low <= hold.of_library[0.5] <= high
    nobody = select(reaches(["ann"] * 3))
    assert summarise_protocol(nobody, [], monotone=True).predictors == ()
