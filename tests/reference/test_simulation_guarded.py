"""The guarded transfer function in the pointing loop: the pixels of the stage, and what help does there."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred import build
from pointpred.errors import ParameterError
from pointpred.simulation import Aim, Claim, Guard, Person, Setup, guarded, move_guarded, movement, slots
from pointpred.simulation.movement import Movement, move
from pointpred.transfer import ConstantGain, GuardedTransfer, PixelTransfer
from pointpred.transfer.assistance import UNGUIDED

CPI, H = 2000.0, 2.0**-10
FUNCTION = ConstantGain(3.91372)  # no sum of pixels falls on a whole one, where rounding decides
SETUP = Setup(FUNCTION, cpi=CPI, period_s=H)
AIM = Aim(480.0, -300.0, 26.0)
RIGHT = Claim(AIM.x, AIM.y, 10.0)


def person(skill: float = 0.6) -> Person:
    return Person.of_skill("p", skill, np.random.default_rng(2))


def moved(guard: Guard, predictor: Claim | None, seed: int = 5, habit: float = 0.0) -> Movement:
    return move_guarded(person(), SETUP, AIM, np.random.default_rng(seed), guard, predictor, habit=habit)


def times(guard: Guard, predictor: Claim | None, habit: float = 0.0) -> float:
    return float(np.mean([moved(guard, predictor, seed, habit).click_s for seed in range(24)]))


def test_without_strength_or_prediction_it_is_the_plain_loop_bit_for_bit() -> None:
    plain = move(person(), SETUP, AIM, np.random.default_rng(5)).table
    for guard, predictor in (
        (Guard(strength=0.0), RIGHT),
        (Guard(), None),
        (Guard(), Claim(900.0, 0.0, 1e6)),
    ):
        np.testing.assert_array_equal(moved(guard, predictor).table, plain)
    assert not np.array_equal(
        moved(Guard(), RIGHT).table[:, 1:3], plain[: len(moved(Guard(), RIGHT).table), 1:3]
    )


@pytest.mark.parametrize("claim", [RIGHT, Claim(700.0, 100.0, 40.0), Claim(200.0, -90.0)])
def test_the_pixels_of_the_loop_are_those_of_the_stage(claim: Claim) -> None:
    """The counts that the loop reported, once more through the stage with the same prediction."""
    guard = Guard(strength=0.7, rho=6.0)
    made = moved(guard, claim)
    phase = made.column("phase")
    begun = int(np.argmax(phase > 0.0))
    stage = GuardedTransfer(FUNCTION, cpi=CPI, strength=0.7, rho=6.0, period_s=H)
    variance = np.nan if claim.spread_px is None else claim.spread_px**2
    x = y = 0.0
    for i, (dx, dy) in enumerate(zip(made.column("dx"), made.column("dy"), strict=True)):
        way = (claim.x - x, claim.y - y, variance, 0.0, variance) if i >= begun else UNGUIDED
        _, moved_x, moved_y, _, _ = stage.advance((i * H, float(dx), float(dy), *way))
        x, y = x + moved_x, y + moved_y
        assert (x, y) == (made.table[i, 1], made.table[i, 2]), i


def test_the_eyes_are_given_the_helped_cursor() -> None:
    memory, chance = movement.prepare(person(), SETUP, AIM, np.random.default_rng(5))
    guard = Guard().memory()
    for tick, (noise_x, noise_y, late_s, _, _) in enumerate(chance[:800].tolist(), start=1):
        made = guarded.step(memory, (noise_x, noise_y, late_s, AIM.x, AIM.y, 4.0, 0.0, 4.0), guard)
        row = slots.RING + slots.RING_SLOTS * (tick % slots.RING_ROWS)
        assert (memory[row], memory[row + 1]) == made[1:3]
    assert np.hypot(made[1], made[2]) > 100.0


def test_the_cursor_never_moves_against_the_hand_in_the_loop() -> None:
    for claim in (RIGHT, Claim(-200.0, -300.0, 5.0), Claim(480.0, 300.0, 5.0)):
        made = moved(Guard(strength=1.0, sideways=1.0, rho=100.0), claim)
        steps = np.diff(made.table[:, 1:3], axis=0, prepend=0.0)
        counts = made.table[:, 3:5]
        plain = PixelTransfer(FUNCTION, cpi=CPI, period_s=H)
        own = plain.run(np.arange(len(counts)) * H, counts[:, 0], counts[:, 1])
        added = steps - own
        assert np.abs(added).sum() > 20.0
        assert ((added * counts).sum(axis=1) >= 0.0).all()


def test_a_right_prediction_helps_and_a_wrong_one_costs_little() -> None:
    plain = times(Guard(strength=0.0), None)
    assert times(Guard(), RIGHT) < 0.97 * plain
    assert times(Guard(), RIGHT, habit=0.4) < 0.97 * plain
    wrong = Claim(-AIM.y, AIM.x, 5.0)  # at a right angle, and sure of it
    assert times(Guard(), wrong) < 1.05 * plain
    assert times(Guard(), wrong, habit=0.4) > 1.05 * plain  # who relies on help misses it


def test_a_pipeline_in_the_loop_is_heard() -> None:
    plain = move(person(), SETUP, AIM, np.random.default_rng(5)).table
    held = move_guarded(person(), SETUP, AIM, np.random.default_rng(5), Guard(), build("hold", cpi=CPI))
    np.testing.assert_array_equal(held.table, plain)  # the endpoint is the cursor: no way, no help
    led = move_guarded(
        person(), SETUP, AIM, np.random.default_rng(5), Guard(), build("minimum-jerk", cpi=CPI)
    )
    ahead = led.table[: len(plain), 1:3] @ (AIM.x, AIM.y) / AIM.distance
    assert ahead.max() > 5.0 + (plain[:, 1:3] @ (AIM.x, AIM.y) / AIM.distance).max()


def test_what_cannot_be_is_refused() -> None:
    with pytest.raises(ParameterError, match="strength"):
        moved(Guard(strength=1.1), None)
    with pytest.raises(ParameterError, match="habit"):
        moved(Guard(), None, habit=-0.1)
