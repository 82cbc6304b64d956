"""Simulated people: their speed, accuracy and scatter, drawn once from a seed."""

from __future__ import annotations

from math import exp

import msgspec
import numpy as np

from pointpred.compiled import law
from pointpred.layout import Layout
from pointpred.parameter import Parameter, check
from pointpred.records import FloatArray

NORMALS = 18
"""So many standard normal numbers make a person."""


class Traits(Layout):
    """What a person is.

    ``skill`` 0 is a novice, 1 an expert with the setup; ``base_s`` and ``per_bit_s`` the time of a
    first piece, base + per_bit log2(A/W + 1); ``one_piece`` probability of a movement in one piece;
    ``reach`` and ``reach_sd`` share of the way a last piece covers; ``turn_sd`` and ``curvature`` (rad)
    direction error and bend of a piece; ``skew`` of its speed; ``reaction_s``, ``pause_s`` between
    pieces, ``verify_s`` before the click, ``press_s`` of the button; ``friction`` b1 (1/s) and ``rate``
    sqrt(b2 c) (1/s) of the corrective phase; ``delay_s`` of the eyes, ``muscle_s`` lag of the muscles;
    ``noise`` of the motion as a share of the speed, ``tremor_m_s``; ``aim_sd`` scatter of the aim as a
    share of the target's width.
    """

    skill: float
    base_s: float
    per_bit_s: float
    one_piece: float
    reach: float
    reach_sd: float
    turn_sd: float
    curvature: float
    skew: float
    reaction_s: float
    pause_s: float
    verify_s: float
    press_s: float
    friction: float
    rate: float
    delay_s: float
    muscle_s: float
    noise: float
    tremor_m_s: float
    aim_sd: float


@law
def between(skill: float, novice: float, expert: float, scatter: float) -> float:
    """A trait between a novice's and an expert's, scattered by a factor e^scatter."""
    return (novice + skill * (expert - novice)) * exp(scatter)


@law
def grow(traits: Traits, skill: float, normals: FloatArray) -> None:
    """The traits of a person of a skill in [0, 1], from ``NORMALS`` standard normal numbers."""
    n = np.empty(NORMALS)
    for i in range(NORMALS):
        n[i] = min(max(normals[i], -2.0), 2.0)
    traits.skill = skill
    traits.rate = between(skill, 7.5, 10.5, 0.08 * n[0])
    traits.base_s = between(skill, 0.34, 0.24, 0.10 * n[1])
    traits.per_bit_s = between(skill, 0.085, 0.060, 0.08 * n[2])
    traits.one_piece = min(max(0.08 + 0.84 * skill, 0.0), 1.0)
    traits.reach = between(skill, 0.96, 0.98, 0.03 * n[3])
    traits.reach_sd = between(skill, 0.12, 0.05, 0.10 * n[4])
    traits.turn_sd = between(skill, 0.12, 0.05, 0.15 * n[5])
    traits.curvature = (0.08 + 0.08 * (1.0 - skill)) * normals[6]
    traits.skew = min(max(0.10 + 0.08 * normals[7], -0.1), 0.4)
    traits.reaction_s = between(skill, 0.26, 0.20, 0.12 * n[8])
    traits.pause_s = between(skill, 0.07, 0.03, 0.20 * n[9])
    traits.verify_s = between(skill, 0.17, 0.10, 0.15 * n[10])
    traits.press_s = between(skill, 0.095, 0.080, 0.15 * n[11])
    traits.friction = 2.0 * between(skill, 1.05, 1.05, 0.06 * n[12]) * traits.rate
    traits.delay_s = between(skill, 0.120, 0.095, 0.08 * n[13])
    traits.muscle_s = between(skill, 0.024, 0.018, 0.10 * n[14])
    traits.noise = between(skill, 0.035, 0.025, 0.15 * n[15])
    traits.tremor_m_s = between(skill, 0.0007, 0.0004, 0.20 * n[16])
    traits.aim_sd = between(skill, 0.16, 0.12, 0.10 * n[17])


class Person(msgspec.Struct, frozen=True):
    """One simulated person.

    Assumes that a movement is one to four ballistic pieces and a corrective phase, each planned from the
    visible cursor; these people do not tire, learn or change strategy for a harder target.
    """

    name: str
    numbers: tuple[float, ...]
    """The traits, in their order."""

    @property
    def traits(self) -> Traits:
        """The traits by their names, a copy."""
        return Traits(np.array(self.numbers))

    @classmethod
    def of_skill(cls, name: str, skill: float, generator: np.random.Generator) -> Person:
        """A person of a given skill in [0, 1], the rest drawn around it; raises ParameterError.

        >>> expert = Person.of_skill("p01", 1.0, np.random.default_rng(1))
        >>> novice = Person.of_skill("p02", 0.0, np.random.default_rng(1))
        >>> bool(expert.traits.one_piece > novice.traits.one_piece)
        True
        """
        check((Parameter("skill", "", 0.0, 1.0, "0 novice, 1 expert"),), {"skill": skill})

        traits = Traits(np.zeros(Traits.length))
        grow(traits, skill, generator.standard_normal(NORMALS))
        return cls(name, tuple(traits.memory.tolist()))


def people(count: int = 10, seed: int = 0) -> tuple[Person, ...]:
    """``count`` people from novice to expert, in random order of skill.

    Parameters: ``count`` in [1, 10000]; ``seed`` a whole number >= 0. The same seed gives the same people.
    Raises ParameterError.

    >>> [p.name for p in people(3)]
    ['p01', 'p02', 'p03']
    """
    check(
        (
            Parameter("count", "people", 1, 10_000, "how many people", whole=True),
            Parameter("seed", "", 0, 2**32 - 1, "of the generator", whole=True),
        ),
        {"count": count, "seed": seed},
    )
    generator = np.random.default_rng([seed, 0])
    skills = (generator.permutation(count) + generator.uniform(0.2, 0.8, count)) / count
    return tuple(
        Person.of_skill(f"p{i + 1:02d}", float(skills[i]), np.random.default_rng([seed, 1, i]))
        for i in range(count)
    )
