"""Simulated people: their speed, accuracy and scatter, drawn once from a seed."""

from __future__ import annotations

import msgspec
import numpy as np

from pointpred.parameter import Parameter, check


class Person(msgspec.Struct, frozen=True):
    """One simulated person; ``skill`` 0 is a novice, 1 an expert with the setup.

    Assumes that a movement is one to four ballistic pieces and a corrective phase, each planned from the
    visible cursor; these people do not tire, learn or change strategy for a harder target.

    Fields: ``base_s`` and ``per_bit_s`` the time of a first piece, base + per_bit log2(A/W + 1);
    ``one_piece`` probability of a movement in one piece; ``reach`` and ``reach_sd`` share of the way a last
    piece covers; ``turn_sd`` and ``curvature`` (rad) direction error and bend of a piece; ``skew`` of its
    speed; ``reaction_s``, ``pause_s`` between pieces, ``verify_s`` before the click, ``press_s`` of the
    button; ``friction`` b1 (1/s) and ``rate`` sqrt(b2 c) (1/s) of the corrective phase; ``delay_s`` of the
    eyes, ``muscle_s`` lag of the muscles; ``noise`` of the motion as a share of the speed, ``tremor_m_s``;
    ``aim_sd`` scatter of the aim as a share of the target's width.
    """

    name: str
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

    @classmethod
    def of_skill(cls, name: str, skill: float, generator: np.random.Generator) -> Person:
        """A person of a given skill in [0, 1], the rest drawn around it; raises ParameterError.

        >>> expert = Person.of_skill("p01", 1.0, np.random.default_rng(1))
        >>> novice = Person.of_skill("p02", 0.0, np.random.default_rng(1))
        >>> expert.one_piece > novice.one_piece, expert.base_s < novice.base_s
        (True, True)
        """
        check((Parameter("skill", "", 0.0, 1.0, "0 novice, 1 expert"),), {"skill": skill})

        def between(novice: float, expert: float, spread: float) -> float:
            middle = novice + skill * (expert - novice)
            return float(middle * np.exp(spread * np.clip(generator.standard_normal(), -2.0, 2.0)))

        rate = between(7.5, 10.5, 0.08)
        return cls(
            name=name,
            skill=skill,
            base_s=between(0.34, 0.24, 0.10),
            per_bit_s=between(0.085, 0.060, 0.08),
            one_piece=float(np.clip(0.08 + 0.84 * skill, 0.0, 1.0)),
            reach=between(0.96, 0.98, 0.03),
            reach_sd=between(0.12, 0.05, 0.10),
            turn_sd=between(0.12, 0.05, 0.15),
            curvature=float(generator.normal(0.0, 0.08 + 0.08 * (1.0 - skill))),
            skew=float(np.clip(0.10 + 0.08 * generator.standard_normal(), -0.1, 0.4)),
            reaction_s=between(0.26, 0.20, 0.12),
            pause_s=between(0.07, 0.03, 0.20),
            verify_s=between(0.17, 0.10, 0.15),
            press_s=between(0.095, 0.080, 0.15),
            friction=2.0 * between(1.05, 1.05, 0.06) * rate,
            rate=rate,
            delay_s=between(0.120, 0.095, 0.08),
            muscle_s=between(0.024, 0.018, 0.10),
            noise=between(0.035, 0.025, 0.15),
            tremor_m_s=between(0.0007, 0.0004, 0.20),
            aim_sd=between(0.16, 0.12, 0.10),
        )


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
