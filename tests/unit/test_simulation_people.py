"""Simulated people: seeded, plausible, told apart by skill."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred.errors import ParameterError
from pointpred.recording import Recording
from pointpred.simulation import Condition, Person, people, simulate_circle, thesis_setup
from tests.simulated_shapes import Shape, shapes

CONDITION = Condition(75.0, 7.0, "constant")


@pytest.fixture(scope="module")
def thesis() -> Recording:
    return thesis_setup(3)


@pytest.fixture(scope="module")
def forms(thesis: Recording) -> list[Shape]:
    found = shapes(thesis)
    assert all(form is not None for form in found)
    return [form for form in found if form is not None]


def skill(recording: Recording) -> np.ndarray:
    return np.array([float(trial.condition["skill"]) for trial in recording.trials])


def test_same_seed_same_people_other_seed_others() -> None:
    assert people(4, 7) == people(4, 7)
    assert people(4, 7) != people(4, 8)


def test_skills_cover_the_range_evenly() -> None:
    skills = sorted(person.traits.skill for person in people(10, 0))
    assert all(i / 10 <= s <= (i + 1) / 10 for i, s in enumerate(skills))


def test_the_thesis_setup_is_a_full_factorial_of_960_trials(thesis: Recording) -> None:
    assert len(thesis.trials) == 960
    keys = ("distance_mm", "width_mm", "transfer")
    cells = {(trial.user, *(trial.condition[key] for key in keys)) for trial in thesis.trials}
    assert len(cells) == 10 * 2 * 2 * 2
    assert len({(trial.user, trial.trial) for trial in thesis.trials}) == 960
    assert thesis.provenance.simulated
    assert "simulated" in thesis.name


def test_movement_times_are_those_of_people(forms: list[Shape]) -> None:
    times = np.array([form.movement_s for form in forms])
    assert 0.5 < np.median(times) < 1.2
    assert np.quantile(times, 0.05) > 0.25
    assert np.quantile(times, 0.95) < 2.2


def test_harder_targets_take_longer(thesis: Recording, forms: list[Shape]) -> None:
    def median(distance: float, width: float) -> float:
        return float(
            np.median(
                [
                    form.movement_s
                    for form, trial in zip(forms, thesis.trials, strict=True)
                    if (trial.condition["distance_mm"], trial.condition["width_mm"]) == (distance, width)
                ]
            )
        )

    assert median(150.0, 2.0) > median(150.0, 7.0) > median(75.0, 7.0)
    assert median(150.0, 2.0) > median(75.0, 2.0) > median(75.0, 7.0)


def test_skilled_people_move_in_one_piece_and_novices_do_not(thesis: Recording, forms: list[Shape]) -> None:
    one = np.array([form.one_piece for form in forms])
    expert, novice = skill(thesis) > 0.8, skill(thesis) < 0.2
    assert one[expert].mean() > 0.5
    assert one[novice].mean() < 0.25
    times = np.array([form.movement_s for form in forms])
    assert np.median(times[expert]) < 0.7 * np.median(times[novice])


def test_speed_of_one_piece_peaks_before_the_middle_and_has_a_bell(
    thesis: Recording, forms: list[Shape]
) -> None:
    """A half cosine has 1.57, minimum jerk 1.88; a slow approach makes the whole movement more peaked."""
    chosen = [form for form, s in zip(forms, skill(thesis), strict=True) if form.one_piece and s > 0.6]
    assert 0.3 < np.median([form.peak_share for form in chosen]) < 0.5
    assert 1.4 < np.median([form.sharpness for form in chosen]) < 3.0


def test_clicks_are_scattered_within_the_target(thesis: Recording, forms: list[Shape]) -> None:
    off = np.array(
        [
            np.hypot(form.end_x - trial.target_x, form.end_y - trial.target_y) / trial.target_w
            for form, trial in zip(forms, thesis.trials, strict=True)
        ]
    )
    assert (off > 0.5).mean() < 0.05
    assert 0.15 < np.sqrt((off**2).mean()) < 0.4


def test_a_persons_trials_do_not_depend_on_who_else_takes_part() -> None:
    first, second = people(2, 5)
    alone = simulate_circle([second], [CONDITION], seed=5, trials=2)
    together = simulate_circle([first, second], [CONDITION], seed=5, trials=2)
    np.testing.assert_array_equal(alone.rows(1).table, together.rows(3).table)


def test_conditions_keep_their_trials_apart_by_chance_only() -> None:
    """Two circles of the same condition have the same targets' distance but other noise."""
    made = simulate_circle(people(1), [CONDITION, CONDITION], trials=1)
    assert len(made.rows(0)) != len(made.rows(1)) or not np.array_equal(
        made.rows(0).table, made.rows(1).table
    )


@pytest.mark.parametrize(
    ("wrong", "says"),
    [
        (lambda: people(0), "count must lie in"),
        (lambda: people(2.5), "whole number"),  # type: ignore[arg-type]
        (lambda: people(2, -1), "seed must lie in"),
        (lambda: Person.of_skill("p", 1.2, np.random.default_rng(0)), "skill must lie in"),
        (lambda: simulate_circle(people(1), trials=13), "trials must lie in"),
        (lambda: simulate_circle(people(1), [Condition(75.0, 7.0, "cubic")]), "received 'cubic'"),
        (lambda: simulate_circle(people(1), [Condition(0.0, 7.0, "constant")]), "distance_mm must lie in"),
        (lambda: simulate_circle(people(1), [Condition(75.0, -1.0, "constant")]), "width_mm must lie in"),
    ],
)
def test_wrong_settings_are_told(wrong: object, says: str) -> None:
    with pytest.raises(ParameterError, match=says):
        wrong()  # type: ignore[operator]
