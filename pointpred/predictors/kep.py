"""Kinematic endpoint prediction (KEP): where a polynomial of speed over distance returns to zero."""

from __future__ import annotations

from math import hypot, nan, sqrt
from typing import Annotated, NamedTuple

from pointpred.compiled import law
from pointpred.layout import Layout, clear
from pointpred.parameter import parameter
from pointpred.predictors import movement
from pointpred.predictors.predictor import Predictor
from pointpred.records import FINE, FloatArray, MotionRow, TenFloats, endpoint
from pointpred.regression import least_squares

STEPS_MOST = 80
"""Bound on the cost of a zero: some six steps suffice, some forty where two zeros nearly meet."""


class Quartic(NamedTuple):
    """The polynomial c0 + c1 w + c2 w^2 + c3 w^3 + c4 w^4."""

    c0: float
    c1: float
    c2: float
    c3: float
    c4: float


@law
def value(p: Quartic, w: float) -> float:
    """The polynomial at w."""
    return p.c0 + w * (p.c1 + w * (p.c2 + w * (p.c3 + w * p.c4)))


@law
def derivative(p: Quartic) -> Quartic:
    """The polynomial's derivative."""
    return Quartic(p.c1, 2.0 * p.c2, 3.0 * p.c3, 4.0 * p.c4, 0.0)


@law
def bends(p: Quartic, far: float) -> tuple[float, float]:
    """The points in (0, far) where the second derivative 2 c2 + 6 c3 w + 12 c4 w^2 is zero, else ``far``."""
    a, b, c = 6.0 * p.c4, 3.0 * p.c3, p.c2
    discriminant = b * b - 4.0 * a * c
    if discriminant < 0.0:
        return far, far
    half = -0.5 * (b + (sqrt(discriminant) if b >= 0.0 else -sqrt(discriminant)))
    one = half / a if a != 0.0 else far
    other = c / half if half != 0.0 else far
    one = one if 0.0 < one < far else far
    other = other if 0.0 < other < far else far
    return min(one, other), max(one, other)


@law
def zero_between(p: Quartic, low: float, high: float) -> float:
    """The zero between low and high where the polynomial is monotone; ``high`` if there is none.

    Newton's steps as long as they stay within the bracket, which every step narrows; else it is halved.
    """
    at_low = value(p, low)
    if not at_low * value(p, high) < 0.0:
        return high
    w = 0.5 * (low + high)
    for _ in range(STEPS_MOST):
        here = value(p, w)
        if here == 0.0:
            return w
        if (here > 0.0) == (at_low > 0.0):
            low = w
        else:
            high = w
        slope = p.c1 + w * (2.0 * p.c2 + w * (3.0 * p.c3 + w * 4.0 * p.c4))
        new = w - here / slope if slope != 0.0 else low
        if not low < new < high:
            new = 0.5 * (low + high)
        if abs(new - w) <= 1e-13 * abs(w):
            return new
        w = new
    return w


@law
def first_zero(p: Quartic, far: float) -> float:
    """Smallest w in (0, far] where the polynomial comes down to zero from c0 > 0, else NaN."""
    if not p.c0 > 0.0:
        return nan
    bend_1, bend_2 = bends(p, far)
    bounds = bend_1, bend_2, far
    slope = derivative(p)
    left = 0.0
    for i in range(3):
        # Between two bends the slope is monotone: it is zero at most once, and splits the interval in two.
        turn = zero_between(slope, left, bounds[i])
        if value(p, turn) <= 0.0:
            return zero_between(p, left, turn)
        if value(p, bounds[i]) <= 0.0:
            return zero_between(p, turn, bounds[i])
        left = bounds[i]
    return nan


DEGREE_MOST = 4
TERMS = DEGREE_MOST + 1
EXCITATION_LEAST = 1e-5
"""A power of the distance whose own part is smaller than this share depends on the lower powers."""


class Settings(Layout):
    """The parameters; ``change_most`` 0: no check."""

    degree: float
    reach: float
    change_most: float


class Fit(Layout):
    """The regression of speed on powers of the distance, and its solution, from the constant up."""

    sums: least_squares.Sums
    numbers: Annotated[FloatArray, least_squares.numbers(TERMS)]
    coefficients: Annotated[FloatArray, TERMS]


class Check(Layout):
    """The length predicted after the sample before, in px; whether an endpoint was accepted, and which."""

    predicted: float
    accepted: float
    x: float
    y: float


class State(Layout):
    """What is remembered of the movement."""

    movement: movement.State
    fit: Fit
    check: Check


class Memory(Layout):
    """The settings, then the state."""

    settings: Settings
    state: State


@law
def add(fit: Fit, degree: int, distance: float, speed: float) -> None:
    """Take the row (1, d, d^2, ... | speed) into the fit."""
    regression = least_squares.parts(fit.numbers, degree + 1)
    power = 1.0
    for j in range(degree + 1):
        regression.w[j] = power
        power *= distance
    least_squares.advance(fit.sums, regression, 1.0, speed)


@law
def remaining(fit: Fit, degree: int, reach: float, travelled: float) -> float:
    """Distance in px from where the cursor is to where the fitted speed returns to zero, else NaN."""
    c, regression = fit.coefficients, least_squares.parts(fit.numbers, degree + 1)
    if not (travelled > 0.0 and least_squares.solve(regression, EXCITATION_LEAST, c)):
        return nan
    # The distance travelled is the unit of what follows.
    c0, c1, c2 = c[0], c[1] * travelled, c[2] * travelled**2
    c3 = c[3] * travelled**3 if degree > 2 else 0.0
    c4 = c[4] * travelled**4 if degree > 3 else 0.0
    # The same polynomial of the distance from here.
    here = Quartic(
        value(Quartic(c0, c1, c2, c3, c4), 1.0),
        c1 + 2.0 * c2 + 3.0 * c3 + 4.0 * c4,
        c2 + 3.0 * c3 + 6.0 * c4,
        c3 + 4.0 * c4,
        c4,
    )
    return float(first_zero(here, reach) * travelled)


@law
def judge(check: Check, change_most: float, length: float, x: float, y: float) -> None:
    """Accept an endpoint when the predicted length changed little since the sample before."""
    before = check.predicted
    if before > 0.0 and abs(length - before) < change_most * before:
        check.accepted, check.x, check.y = 1.0, x, y
    check.predicted = length if length > 0.0 else 0.0


@law
def step(memory: Memory, motion: TenFloats) -> TenFloats:
    """Add the motion to the fit and look for its zero ahead."""
    m = MotionRow(*motion)
    settings, s, fit, check = memory.settings, memory.state.movement, memory.state.fit, memory.state.check
    fault, new, dt = movement.follow(s, m)
    if fault != FINE:
        return movement.refuse(s, m, fault)
    if new:
        clear(fit)
        clear(check)
    degree, travelled = int(settings.degree), s.path
    if new or dt > 0.0:
        add(fit, degree, travelled, hypot(m.vx, m.vy))
    away_x, away_y = m.x - s.x0, m.y - s.y0
    away = hypot(away_x, away_y)
    end_x, end_y = nan, nan
    if away > 0.0:
        ahead = remaining(fit, degree, settings.reach, travelled)
        end_x, end_y = m.x + ahead * (away_x / away), m.y + ahead * (away_y / away)
        if dt > 0.0:
            judge(check, settings.change_most, travelled + ahead, end_x, end_y)
    if settings.change_most > 0.0:
        accepted = check.accepted == 1.0
        end_x, end_y = check.x if accepted else nan, check.y if accepted else nan
    return endpoint(m.t, end_x, end_y, movement.phase(s, m))


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
    states = State.length
