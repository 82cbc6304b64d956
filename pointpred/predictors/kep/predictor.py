"""Kinematic endpoint prediction (KEP): where a polynomial of speed over distance returns to zero."""

from __future__ import annotations

from math import hypot, nan

from pointpred.compiled import law
from pointpred.parameter import parameter
from pointpred.predictors import movement
from pointpred.predictors.kep import quartic
from pointpred.predictors.kep.quartic import Quartic
from pointpred.predictors.predictor import Predictor
from pointpred.records import FINE, FloatArray, MotionRow, Row, TenFloats, endpoint
from pointpred.regression import least_squares
from pointpred.stage import offsets

DEGREE_MOST = 4
TERMS = DEGREE_MOST + 1
# The parameters; the movement, the fit and its solution; the stability check: the length predicted after the
# sample before, whether an endpoint was accepted, which.
DEGREE, REACH, CHANGE_MOST, AT, FIT, COEFFICIENTS, LENGTH, ACCEPTED, ACCEPTED_X, ACCEPTED_Y, END = offsets(
    1, 1, 1, movement.STATES, least_squares.states(TERMS), TERMS, 1, 1, 1, 1
)

EXCITATION_LEAST = 1e-5
"""A power of the distance whose own part is smaller than this share depends on the lower powers."""


@law
def add(memory: FloatArray, distance: float, speed: float) -> None:
    """Take the row (1, d, d^2, ... | speed) into the fit."""
    terms = int(memory[DEGREE]) + 1
    power = 1.0
    for j in range(terms):
        memory[FIT + least_squares.REGRESSOR + j] = power
        power *= distance
    least_squares.advance(memory, FIT, terms, 1.0, speed)


@law
def remaining(memory: FloatArray, travelled: float) -> float:
    """Distance in px from where the cursor is to where the fitted speed returns to zero, else NaN."""
    degree = int(memory[DEGREE])
    if not (travelled > 0.0 and least_squares.solve(memory, FIT, degree + 1, EXCITATION_LEAST, COEFFICIENTS)):
        return nan
    # The distance travelled is the unit of what follows.
    c0, c1 = memory[COEFFICIENTS], memory[COEFFICIENTS + 1] * travelled
    c2 = memory[COEFFICIENTS + 2] * travelled**2
    c3 = memory[COEFFICIENTS + 3] * travelled**3 if degree > 2 else 0.0
    c4 = memory[COEFFICIENTS + 4] * travelled**4 if degree > 3 else 0.0
    # The same polynomial of the distance from here.
    here = Quartic(
        quartic.value(Quartic(c0, c1, c2, c3, c4), 1.0),
        c1 + 2.0 * c2 + 3.0 * c3 + 4.0 * c4,
        c2 + 3.0 * c3 + 6.0 * c4,
        c3 + 4.0 * c4,
        c4,
    )
    return float(quartic.first_zero(here, memory[REACH]) * travelled)


@law
def judge(memory: FloatArray, length: float, x: float, y: float) -> None:
    """Accept an endpoint when the predicted length changed little since the sample before."""
    before = memory[LENGTH]
    if before > 0.0 and abs(length - before) < memory[CHANGE_MOST] * before:
        memory[ACCEPTED], memory[ACCEPTED_X], memory[ACCEPTED_Y] = 1.0, x, y
    memory[LENGTH] = length if length > 0.0 else 0.0


@law
def step(memory: FloatArray, motion: Row) -> TenFloats:
    """Add the motion to the fit and look for its zero ahead."""
    m = MotionRow(*motion)
    fault, new, dt = movement.follow(memory, AT, m)
    if fault != FINE:
        return movement.refuse(memory, AT, m, fault)
    travelled = memory[AT + movement.PATH]
    if new:
        memory[FIT:] = 0.0
    if new or dt > 0.0:
        add(memory, travelled, hypot(m.vx, m.vy))
    away_x, away_y = m.x - memory[AT + movement.X0], m.y - memory[AT + movement.Y0]
    away = hypot(away_x, away_y)
    end_x, end_y = nan, nan
    if away > 0.0:
        ahead = remaining(memory, travelled)
        end_x, end_y = m.x + ahead * (away_x / away), m.y + ahead * (away_y / away)
        if dt > 0.0:
            judge(memory, travelled + ahead, end_x, end_y)
    if memory[CHANGE_MOST] > 0.0:
        accepted = memory[ACCEPTED] == 1.0
        end_x, end_y = memory[ACCEPTED_X] if accepted else nan, memory[ACCEPTED_Y] if accepted else nan
    return endpoint(m.t, end_x, end_y, movement.phase(memory, AT, m))


class KinematicEndpointPredictor(Predictor):
    """Kinematic endpoint prediction (KEP): a polynomial of speed over distance, and where it returns to zero.

    Assumes one straight movement whose speed over distance is a polynomial, as that of a minimum-jerk
    movement nearly is. Far from the end the zero is an extrapolation that jumps from sample to sample: its
    authors trust it from 80 % of the way on. A stop, a second peak or a turn stays in the fit until the next
    movement. Their coefficients for each share of the way done (c_k) were not available: left out.

    min over c of sum (speed_i - c_0 - c_1 d_i - ... - c_n d_i^n)^2 over the whole movement so far, with d_i
    the distance travelled along the path (px); D is the smallest zero of the polynomial beyond d; endpoint =
    cursor + (D - d) in the direction start -> cursor. All samples weigh the same, those at rest too.

    ``None`` when the distances travelled do not determine the polynomial, when the fitted speed is not
    positive here, when it has no zero within ``reach`` times d ahead, or when the cursor is at its start. The
    bound on the reach is ours; with 1e6 it does not bind. A new fit begins where ``Motion.start`` is set. A
    second motion of the same time moves the cursor, but changes neither fit nor stability check. After a
    turn the path still grows, so the endpoint lies beyond the cursor as seen from the start. The speed is
    the hand's: where it is zero, so is the cursor's.

    With ``change_most`` (the gated variants, 0.02): a prediction is accepted when its length D differs from
    that of the sample before by less than this share of it; the answer is the endpoint accepted last,
    unchanged until the next is accepted, and ``None`` before the first of the movement. The check counts
    samples, so it is the laxer the higher the rate.

    Parameters: ``degree`` 2 (as in 2009) to 4 (as in 2007); ``reach``; ``change_most``, ``None`` for no
    check. Memory: 59 floats. Claims neither region nor time of arrival: along a polynomial that crosses zero
    the time to get there is infinite. Raises ParameterError, and EventError from ``update``.

    Reference: Lank, Cheng, Ruiz 2007; Ruiz, Lank 2009 (stability check); Khalin 2022, section 2.6.3.

    >>> from pointpred import Motion
    >>> predictor = KinematicEndpointPredictor(degree=2)
    >>> for i, d in enumerate([0.0, 20.0, 50.0, 90.0]):  # speed = d (200 - d) / 20000
    ...     motion = Motion(i / 100, d, 0.0, d * (200.0 - d) / 2e4, 0.0, 0.0, 0.0, True, start=i == 0)
    ...     prediction = predictor.update(motion)
    >>> round(prediction.x, 6)
    200.0
    """

    degree: int = parameter(
        "", 2, DEGREE_MOST, "degree of the polynomial of speed over distance", default=4, whole=True
    )
    reach: float = parameter(
        "", 1e-3, 1e6, "farthest zero ahead, as a multiple of the distance travelled", default=10.0
    )
    change_most: float | None = parameter(
        "", 1e-6, 1.0, "relative change between samples of an accepted prediction", default=None, absent=0.0
    )
    step = staticmethod(step)
    claims_time = False
    states = END - AT
