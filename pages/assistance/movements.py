"""Simulated people point with and without assistance, always the same movements; what that costs them."""

from __future__ import annotations

from collections.abc import Callable
from math import cos, radians, sin

import msgspec
import numpy as np

from pointpred.pipeline import Pipeline
from pointpred.records import FloatArray
from pointpred.simulation import Aim, Claim, Guard, Person, Setup, move_guarded, people
from pointpred.simulation.movement import Movement, move
from pointpred.transfer import ConstantGain

SEED = 0
SKILLS = {"novices": (0.0, 1 / 3), "middling": (1 / 3, 2 / 3), "experts": (2 / 3, 1.0)}
DISTANCE_PX, WIDTH_PX = 567.0, 26.0
GAIN, CPI = 4.0, 2000.0
SETUP = Setup(ConstantGain(GAIN), cpi=CPI)
LEARNT = 0.8
"""Of the strength: how much farther somebody used to the help expects the cursor to go."""

Play = Callable[[Person, Aim, np.random.Generator], Movement]


class Outcome(msgspec.Struct, frozen=True):
    """A row a movement: person, time to the click (s), px beyond the far rim, click off the target (0, 1)."""

    skills: FloatArray
    table: FloatArray

    def rows(self, group: str | None) -> FloatArray:
        """Those of one group of people, or all."""
        low, high = SKILLS[group] if group else (0.0, 1.0)
        skills = self.skills[self.table[:, 0].astype(int)]
        return self.table[(skills >= low) & (skills < high)]

    def seconds(self, group: str | None = None) -> float:
        """Mean time from the signal to the click."""
        return float(self.rows(group)[:, 1].mean())

    def overshot(self, group: str | None = None) -> float:
        """Share of movements that leave the target on its far side by more than a target's width."""
        return float((self.rows(group)[:, 2] > WIDTH_PX).mean())

    def missed(self, group: str | None = None) -> float:
        """Share of clicks outside the target."""
        return float(self.rows(group)[:, 3].mean())

    def change(self, plain: Outcome, group: str | None = None) -> tuple[float, float]:
        """Time over that of the same movements without help, less 1; half of a 95 % interval over people."""
        ours, theirs = self.rows(group), plain.rows(group)
        ratios = np.array(
            [
                ours[ours[:, 0] == p, 1].mean() / theirs[theirs[:, 0] == p, 1].mean() - 1.0
                for p in np.unique(ours[:, 0])
            ]
        )
        return float(ratios.mean()), float(1.96 * ratios.std(ddof=1) / np.sqrt(len(ratios)))


def aimed(number: int, person: int) -> Aim:
    """Movements go all round: no direction is special on a grid of pixels but those along it."""
    angle = radians(137.5 * number + 41.0 * person)
    return Aim(DISTANCE_PX * cos(angle), DISTANCE_PX * sin(angle), WIDTH_PX)


def outcome(play: Play, movements: int, count: int = 30) -> Outcome:
    """``count`` people of all skills, ``movements`` each; chance is the same for every way to play."""
    persons = people(count, SEED)
    rows = []
    for number, person in enumerate(persons):
        for k in range(movements):
            aim = aimed(k, number)
            movement = play(person, aim, np.random.default_rng([SEED, number, k]))
            way = movement.table[:, 1:3] @ (np.array([aim.x, aim.y]) / aim.distance)
            off = np.hypot(movement.table[-1, 1] - aim.x, movement.table[-1, 2] - aim.y)
            beyond = float(way.max()) - aim.distance - WIDTH_PX / 2
            rows.append((float(number), movement.click_s, beyond, float(off > WIDTH_PX / 2)))
    return Outcome(np.array([p.skill for p in persons]), np.array(rows))


def told(aim: Aim, angle_deg: float, factor: float, spread_px: float | None) -> Claim:
    """A prediction that errs by an angle and by a factor of the distance.

    Without a spread it claims an honest one: its own error, at least 10 px.
    """
    a = radians(angle_deg)
    x = factor * (aim.x * cos(a) - aim.y * sin(a))
    y = factor * (aim.x * sin(a) + aim.y * cos(a))
    own = max(10.0, float(np.hypot(x - aim.x, y - aim.y)))
    return Claim(x, y, own if spread_px is None else spread_px)


def scripted(
    strength: float,
    *,
    angle_deg: float = 0.0,
    factor: float = 1.0,
    spread_px: float | None = 10.0,
    learnt: bool = True,
) -> Play:
    """A prediction from the start of the movement on, with the guard."""
    guard, habit = Guard(strength=strength), LEARNT * strength * learnt

    def play(person: Person, aim: Aim, generator: np.random.Generator) -> Movement:
        side = 1.0 if generator.integers(2) else -1.0
        claim = told(aim, side * angle_deg, factor, spread_px)
        return move_guarded(person, SETUP, aim, generator, guard, claim, habit=habit)

    return play


def looped(pattern: Pipeline, strength: float, habit: float, practice: int = 0) -> Play:
    """A real predictor in the loop, a fresh one for each person.

    ``practice``: movements of each person, with help, that the predictor hears before those that count.
    """
    guard = Guard(strength=strength)
    pipelines: dict[Person, Pipeline] = {}

    def play(person: Person, aim: Aim, generator: np.random.Generator) -> Movement:
        if person not in pipelines:
            pipelines[person] = pattern.fresh()
            for k in range(practice):
                before = np.random.default_rng([SEED, len(pipelines), k, 1])
                move_guarded(person, SETUP, aimed(k, 1), before, guard, pipelines[person], habit=habit)
        generator.integers(2)  # so that chance is the same as for a script
        return move_guarded(person, SETUP, aim, generator, guard, pipelines[person], habit=habit)

    return play


def remark(rho: float, strength: float, *, angle_deg: float = 0.0, factor: float = 1.0) -> Play:
    """The remark's term without the guard, bounded or (infinite strength) as printed."""
    setup = Setup(ConstantGain(GAIN), cpi=CPI, rho=rho, strength=strength)

    def play(person: Person, aim: Aim, generator: np.random.Generator) -> Movement:
        side = 1.0 if generator.integers(2) else -1.0
        claim = told(aim, side * angle_deg, factor, 10.0)
        return move(person, setup, aim, generator, (claim.x, claim.y))

    return play


def faster(gain: float) -> Play:
    """No help but another gain, to which the person is used."""
    setup = Setup(ConstantGain(gain), cpi=CPI)

    def play(person: Person, aim: Aim, generator: np.random.Generator) -> Movement:
        generator.integers(2)
        return move(person, setup, aim, generator)

    return play
