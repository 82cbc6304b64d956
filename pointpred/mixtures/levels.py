"""The regions of 50 and 80 % as they are corrected for a person, and those of all other levels.

Each of the two has an offset, the logarithm of what its squared radius, or that of a normal law, is
multiplied by; 0: what the law claims.
"""

from __future__ import annotations

from math import exp, log

from pointpred.compiled import law

LEVELS = (0.5, 0.8)
"""The levels of the regions that are corrected."""
LOWEST, HIGHEST = 1e-6, 40.0
"""Bounds on 2 / tail as a predictor states it: no exponential overflows."""
MOST = 1.0 - 1e-9
"""The largest probability of a region."""


@law
def squared_radius(level: float, heavy: float) -> float:
    """Squared radius of a level's region over the tail; ``heavy``: 2 / tail.

    The Student law of ``pointpred.regions.reach`` in the form that is compiled here.
    """
    return float(exp(-heavy * log(1.0 - level)) - 1.0)


@law
def corrected_radius(level: float, heavy: float, offset: float) -> float:
    """``squared_radius`` of a level with its offset.

    A region that held too few ends grows by the same factor, whatever the tail. One that held too many
    becomes the region of a lower level, whose squared radius under a normal law is smaller by that factor:
    with a heavy tail it shrinks much more. Otherwise the two radii would come nearer to each other than any
    Student law has them.
    """
    lower = exp(min(offset, 0.0))
    return float(exp(max(offset, 0.0)) * (exp(-heavy * log(1.0 - level) * lower) - 1.0))


@law
def heaviness(tail: float) -> float:
    """2 / tail within bounds."""
    return min(max(2.0 / tail, LOWEST), HIGHEST)


@law
def probability(level: float, tail: float, near: float, far: float) -> float:
    """The probability that the region of a level must have so that it holds that share of the ends.

    ``tail`` of elsewhere; ``near``, ``far``: the offsets of both  On a line between the levels over
    the logarithm of the squared radius of a normal law; never less than that of a lower level.
    """
    radius, half, most = log(-log(1.0 - level)), log(-log(1.0 - LEVELS[0])), log(-log(1.0 - LEVELS[1]))
    part = min(max((radius - half) / (most - half), 0.0), 1.0)
    heavy = heaviness(tail)
    own = corrected_radius(level, heavy, near + part * (far - near))
    if level > LEVELS[0]:
        own = max(own, corrected_radius(LEVELS[0], heavy, near))
    return min(1.0 - exp(-log(1.0 + own) / heavy), MOST)
