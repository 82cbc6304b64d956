"""One event: the cursor's way, the shares of all targets, and which of them is proposed."""

from __future__ import annotations

from pointpred.columns import FloatArray
from pointpred.compiled import law
from pointpred.targets import cursor, decision, posterior

KEEP = 0.4
"""A proposal stands while its share is at least this part of the precision asked for."""


@law
def step(
    memory: FloatArray,
    table: FloatArray,
    t: float,
    x: float,
    y: float,
    pressed: float,
    answer: FloatArray,
    coefficients: FloatArray,
    settings: FloatArray,
    standing: int,
    rows: FloatArray,
    shares: FloatArray,
) -> int:
    """Take one usable event in, with the prediction made at it, a row of ``PredictionColumns``.

    Writes ``shares`` and returns the target proposed from now on. When the button comes up the movement is
    over, and so is what it proposed.
    """
    if cursor.follow(memory, t, x, y, pressed):
        standing = decision.NOBODY
    elsewhere = settings[posterior.ELSEWHERE]
    posterior.scores(memory, table, answer, coefficients, elsewhere, rows, shares)
    posterior.normalise(shares)
    ask = settings[posterior.PRECISION]
    least_s = settings[posterior.LEAST_LEAD_S]
    return decision.decide(memory, table, shares, standing, answer[6], ask, KEEP * ask, least_s)
