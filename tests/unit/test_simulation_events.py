"""What the simulated mouse reports: counts, pixels, stamps, buttons; and the assisted transfer function."""

from __future__ import annotations

import os
import subprocess
import sys

import numpy as np
import pytest

from pointpred import build
from pointpred.records import EventColumns
from pointpred.simulation import Aim, Condition, Person, Setup, people, simulate_circle
from pointpred.simulation.circle import positions
from pointpred.simulation.movement import Movement, move, move_assisted
from pointpred.transfer import ConstantGain, PixelTransfer, SigmoidGain, TransferFunction

AIM = Aim(420.0, -310.0, 26.0)
PLAIN = """
import hashlib
from pointpred.simulation import Condition, people, simulate_circle
made = simulate_circle(people(2, 1), [Condition(75.0, 2.0, "sigmoid")], seed=1, trials=1)
print(hashlib.sha256(made.events.table.tobytes()).hexdigest())
"""


def person(skill: float = 0.5) -> Person:
    return Person.of_skill("p01", skill, np.random.default_rng(2))


def movement(function: TransferFunction, seed: int = 0) -> Movement:
    return move(person(), Setup(function), AIM, np.random.default_rng(seed))


@pytest.fixture(scope="module")
def events() -> EventColumns:
    return movement(SigmoidGain()).events((100.0, 700.0))


def test_counts_and_pixels_are_whole(events: EventColumns) -> None:
    for column in (events.x, events.y, events.dx, events.dy):
        np.testing.assert_array_equal(column, np.round(column))
    assert (events.x[0], events.y[0], events.t[0]) == (100.0, 700.0, 0.0)


@pytest.mark.parametrize("function", [SigmoidGain(), ConstantGain(4.0)])
def test_pixels_are_the_counts_through_the_transfer_function(function: TransferFunction) -> None:
    """The stage that any device uses moves the cursor alike when it is fed the simulated counts."""
    made = movement(function)
    stage = PixelTransfer(function, cpi=2000.0, dpi=96.0)
    polls = 0.001 * np.arange(1, len(made.table) + 1)
    moved = stage.run(polls, made.column("dx"), made.column("dy")).cumsum(axis=0)
    # The gap between two polls is 1 ms to the last bit or so, hence the odd pixel where a sum is whole.
    np.testing.assert_allclose(moved[:, 0], made.column("x"), atol=1.0)
    np.testing.assert_allclose(moved[:, 1], made.column("y"), atol=1.0)


def test_counts_add_up_to_the_hands_way() -> None:
    made = movement(ConstantGain(4.0))
    counts = np.column_stack([made.column("dx"), made.column("dy")]).cumsum(axis=0)
    hand = np.column_stack([made.column("u"), made.column("v")]) / (0.0254 / 2000.0)
    assert np.abs(counts - hand).max() <= 1.0
    assert np.hypot(*counts[-1]) * 4.0 * 96.0 / 2000.0 == pytest.approx(AIM.distance, rel=0.05)


def test_hands_velocity_is_the_derivative_of_its_way() -> None:
    made = movement(ConstantGain(4.0))
    way = np.diff(made.column("u"))
    np.testing.assert_allclose(way / 0.001, made.column("vx")[1:], atol=6e-3)


def test_stamps_run_forward_near_one_millisecond() -> None:
    made = movement(SigmoidGain()).events(idle_reports=True)
    gaps = np.diff(made.t)
    assert gaps.min() > 0.0
    assert np.abs(gaps[1:] - 0.001).max() < 0.0009
    assert 2e-5 < gaps[1:].std() < 2e-4
    assert gaps[1:].mean() == pytest.approx(0.001, rel=0.01)


def test_still_polls_are_left_out_unless_asked_for() -> None:
    made = movement(SigmoidGain())
    reported, every = made.events(), made.events(idle_reports=True)
    assert len(every) == len(made.table) + 1
    assert len(reported) < len(every)
    moving = (reported.dx != 0) | (reported.dy != 0)
    changed = np.diff(reported.buttons, prepend=0.0) != 0
    assert (moving | changed)[1:].all()
    for column in ("dx", "dy"):
        assert getattr(reported, column).sum() == getattr(every, column).sum()
    assert (reported.x[-1], reported.y[-1]) == (every.x[-1], every.y[-1])


def test_the_button_goes_down_once_and_comes_up_last(events: EventColumns) -> None:
    edges = np.diff(events.buttons)
    assert (edges == 1).sum() == (edges == -1).sum() == 1
    assert events.buttons[0] == events.buttons[-1] == 0.0
    pressed = events.t[np.argmax(events.buttons == 1)]
    assert 0.04 < events.t[-1] - pressed < 0.2
    assert not (events.buttons[events.t < pressed] == 1).any()


def test_targets_lie_on_a_circle_and_neighbours_at_the_distance() -> None:
    places = np.array(positions(567.0, (960.0, 540.0)))
    assert len({(round(x, 6), round(y, 6)) for x, y in places}) == 13
    around = np.concatenate([places, places[:1]])
    np.testing.assert_allclose(np.hypot(*np.diff(around, axis=0).T), 567.0)
    radii = np.hypot(*(places - (960.0, 540.0)).T)
    np.testing.assert_allclose(radii, radii[0])


def test_each_movement_starts_where_the_last_one_ended() -> None:
    made = simulate_circle(people(1), [Condition(75.0, 7.0, "constant")], trials=3)
    for trial in (1, 2):
        before, now = made.rows(trial - 1), made.rows(trial)
        assert (before.x[-1], before.y[-1]) == (now.x[0], now.y[0])


def test_plain_python_makes_the_same_bytes() -> None:
    digests = {
        subprocess.run(
            [sys.executable, "-W", "error", "-c", PLAIN],
            env={**os.environ, "POINTPRED_COMPILED": compiled},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for compiled in ("0", "1")
    }
    assert len(digests) == 1


def assisted(rho: float, off_px: float, strength: float = np.inf) -> list[Movement]:
    setup = Setup(ConstantGain(4.0), rho=rho, strength=strength)
    return [
        move(person(0.6), setup, AIM, np.random.default_rng(seed), (AIM.x + off_px, AIM.y))
        for seed in range(24)
    ]


def test_a_true_estimate_shortens_pointing_and_a_wrong_one_spoils_it() -> None:
    plain = float(np.mean([made.click_s for made in assisted(0.0, 0.0)]))
    helped = float(np.mean([made.click_s for made in assisted(2.0, 0.0)]))
    misled = assisted(2.0, 100.0)
    assert helped < 0.95 * plain
    assert float(np.mean([made.click_s for made in misled])) > 1.5 * plain
    ends = np.array([made.table[-1, 1:3] for made in misled]) - (AIM.x, AIM.y)
    assert (np.hypot(*ends.T) > AIM.width / 2).mean() > 0.5


def test_a_bounded_pull_lets_a_person_leave_a_wrong_estimate() -> None:
    plain = float(np.mean([made.click_s for made in assisted(0.0, 0.0)]))
    misled = assisted(2.0, 100.0, 0.5)
    ends = np.array([made.table[-1, 1:3] for made in misled]) - (AIM.x, AIM.y)
    assert (np.hypot(*ends.T) > AIM.width / 2).mean() < 0.1
    assert float(np.mean([made.click_s for made in misled])) < 1.5 * plain


def test_a_predictor_in_the_loop_changes_nothing_while_its_term_is_off() -> None:
    setup = Setup(ConstantGain(4.0), rho=0.0)
    alone = move(person(), setup, AIM, np.random.default_rng(9))
    beside = move_assisted(person(), setup, AIM, np.random.default_rng(9), build("hold", cpi=2000.0))
    np.testing.assert_array_equal(alone.table, beside.table)
