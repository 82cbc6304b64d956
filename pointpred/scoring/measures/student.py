"""Student's law of one dimension, compiled: what regions with a tail are judged by."""

from __future__ import annotations

from math import exp, inf, lgamma, log, sqrt

from pointpred.compiled import law

TERMS = 200
"""Of the continued fraction at most; it settles after some ten."""
SETTLED = 1e-14
SMALLEST = 1e-300


@law
def _fraction(a: float, b: float, x: float) -> float:
    """The continued fraction of the incomplete beta function, by Lentz's method."""
    c, d = 1.0, 1.0 - (a + b) * x / (a + 1.0)
    d = 1.0 / (d if abs(d) > SMALLEST else SMALLEST)
    total = d
    for m in range(1, TERMS):
        even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m))
        odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0))
        for k in range(2):
            term = even if k == 0 else odd
            d = 1.0 + term * d
            d = 1.0 / (d if abs(d) > SMALLEST else SMALLEST)
            c = 1.0 + term / c
            c = c if abs(c) > SMALLEST else SMALLEST
            total *= c * d
        if abs(c * d - 1.0) < SETTLED:
            break
    return total


@law
def log_beta(a: float, b: float) -> float:
    """Logarithm of the beta function."""
    return lgamma(a) + lgamma(b) - lgamma(a + b)


@law
def incomplete_beta(a: float, b: float, x: float) -> float:
    """The regularised incomplete beta function I_x(a, b).

    Reference: Olver and others, NIST Digital Library of Mathematical Functions, 8.17.22.
    """
    if x <= 0.0:
        return 0.0
    if x >= 1.0:
        return 1.0
    scale = exp(a * log(x) + b * log(1.0 - x) - log_beta(a, b))
    if x < (a + 1.0) / (a + b + 2.0):
        return scale * _fraction(a, b, x) / a
    return 1.0 - scale * _fraction(b, a, 1.0 - x) / b


@law
def distribution(z: float, tail: float) -> float:
    """Probability below ``z`` of a law with ``tail`` degrees of freedom, scale 1."""
    beyond = 0.5 * incomplete_beta(0.5 * tail, 0.5, tail / (tail + z * z))
    return 1.0 - beyond if z > 0.0 else beyond


@law
def ranked_score(error: float, scale: float, tail: float) -> float:
    """Continuous ranked probability score of a Student law whose centre is off by ``error``.

    With z = error / scale: scale (z (2 F(z) - 1) + 2 f(z) (tail + z^2) / (tail - 1)
    - 2 sqrt(tail) / (tail - 1) B(1/2, tail - 1/2) / B(1/2, tail/2)^2); without bound where tail <= 1, for the
    law then has no mean.

    Reference: Jordan, Krueger, Lerch 2019, "Evaluating probabilistic forecasts with scoringRules", app. A.

    >>> round(ranked_score(0.0, 1.0, 1e6), 4)  # the normal law: (sqrt(2) - 1) / sqrt(pi)
    0.2337
    """
    if tail <= 1.0:
        return inf
    if scale == 0.0:
        return abs(error)
    z = error / scale
    both = log_beta(0.5, 0.5 * tail)
    density = exp(-0.5 * (tail + 1.0) * log(1.0 + z * z / tail) - both) / sqrt(tail)
    spread = 2.0 * sqrt(tail) * exp(log_beta(0.5, tail - 0.5) - 2.0 * both)
    near = z * (2.0 * distribution(z, tail) - 1.0)
    return scale * (near + (2.0 * density * (tail + z * z) - spread) / (tail - 1.0))
