"""What assistance may add to the hand's own motion: the safety rule of the guarded transfer function."""

from __future__ import annotations

from math import expm1, hypot, inf, sqrt

from pointpred.columns import FloatArray
from pointpred.compiled import law
from pointpred.transfer import pixels

# Parameters, relative to `at`; the fractions of a pixel that are owed stand where the caller says.
RHO, STRENGTH, SIDEWAYS, UNCERTAIN, UNCLAIMED = 0, 1, 2, 3, 4
SETTINGS = 5


@law
def spread(way_px: float, sxx: float, sxy: float, syy: float, unclaimed: float) -> float:
    """The endpoint's standard deviation along the longest axis of its region, as a share of the way to it.

    ``unclaimed`` where no region is claimed (sxx is NaN).
    """
    if sxx != sxx:
        return unclaimed
    if not (abs(sxx) < inf and abs(sxy) < inf and abs(syy) < inf):
        return inf
    return sqrt(max(0.5 * (sxx + syy) + hypot(0.5 * (sxx - syy), sxy), 0.0)) / way_px


@law
def guide(
    memory: FloatArray,
    at: int,
    dt: float,
    own_x: float,
    own_y: float,
    off_x: float,
    off_y: float,
    sxx: float,
    sxy: float,
    syy: float,
) -> tuple[float, float]:
    """The px that are added to the hand's own (own_x, own_y) in ``dt`` s.

    ``off`` leads from the cursor before the report to the endpoint, NaN while none is predicted. Nothing is
    added to a hand at rest, nor to one that leaves the endpoint. Along the hand's direction the pull is never
    negative, never longer than ``strength`` of the hand's own way and never leads past the endpoint; across
    it is at most ``strength * sideways`` of that way, less the farther the hand points elsewhere.
    """
    own, way = hypot(own_x, own_y), hypot(off_x, off_y)
    if not (0.0 < own < inf and 0.0 < way < inf):
        return 0.0, 0.0
    trust = 1.0 - spread(way, sxx, sxy, syy, memory[at + UNCLAIMED]) / memory[at + UNCERTAIN]
    to_x, to_y = own_x / own, own_y / own
    ahead, beside = off_x * to_x + off_y * to_y, off_y * to_x - off_x * to_y
    if not (trust > 0.0 and ahead > 0.0):
        return 0.0, 0.0
    share = -expm1(-memory[at + RHO] * dt)
    longest = memory[at + STRENGTH] * own
    widest = memory[at + SIDEWAYS] * longest
    along = trust * min(share * ahead, longest, max(ahead - own, 0.0))
    across = trust * min(max(share * beside * (ahead / way), -widest), widest)
    return along * to_x - across * to_y, along * to_y + across * to_x


@law
def add(
    memory: FloatArray,
    at: int,
    owed: int,
    dt: float,
    own_x: float,
    own_y: float,
    off_x: float,
    off_y: float,
    sxx: float,
    sxy: float,
    syy: float,
) -> tuple[float, float]:
    """``guide`` in whole pixels, the fractions carried in ``memory[owed]`` and the place after it.

    Rounding may release a pixel of one axis before its companion; what would go against the hand is dropped.
    """
    x, y = guide(memory, at, dt, own_x, own_y, off_x, off_y, sxx, sxy, syy)
    whole_x, whole_y = pixels.carry(memory, owed, x), pixels.carry(memory, owed + 1, y)
    if whole_x * own_x + whole_y * own_y < 0.0:
        memory[owed] = memory[owed + 1] = 0.0
        return 0.0, 0.0
    return whole_x, whole_y
