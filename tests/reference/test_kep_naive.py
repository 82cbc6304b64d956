"""KEP's recursive fit against numpy.polyfit on all samples, and its bracketed zero against numpy.roots."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from pointpred import EventColumns, Motion, build
from pointpred.differentiators import BackwardDifferentiator, HomogeneousDifferentiator
from pointpred.predictors import KinematicEndpointPredictor, kep
from pointpred.records import FloatArray
from pointpred.regression import least_squares
from tests.reference.naive_kep import NaiveKep


def curved_reach(seed: int, rate_hz: float, distance_px: float = 600.0) -> EventColumns:
    """A minimum-jerk reach on an arc in whole pixels with jittered stamps."""
    random = np.random.default_rng(seed)
    t = np.cumsum(random.uniform(0.6, 1.4, int(0.8 * rate_hz)) / rate_hz)
    s = np.clip(t / 0.7, 0.0, 1.0)
    way = 10 * s**3 - 15 * s**4 + 6 * s**5
    angle = random.uniform(0.0, 2 * np.pi) + 0.3 * way
    return EventColumns.of(
        t, np.round(distance_px * way * np.cos(angle)), np.round(distance_px * way * np.sin(angle))
    )


@pytest.mark.parametrize("degree", [2, 3, 4])
@pytest.mark.parametrize("differentiator", [HomogeneousDifferentiator, BackwardDifferentiator])
@pytest.mark.parametrize(("seed", "rate_hz"), [(1, 60.0), (2, 125.0), (3, 1000.0)])
def test_recursive_fit_agrees_with_polyfit_at_every_event(
    degree: int, differentiator: type[HomogeneousDifferentiator], seed: int, rate_hz: float
) -> None:
    motions = list(differentiator().run(curved_reach(seed, rate_hz)).motions())
    naive = NaiveKep(degree)
    predictor = KinematicEndpointPredictor(degree=degree)
    answered = 0
    for motion in motions:
        expected, found = naive.update(motion), predictor.update(motion)
        assert (expected is None) == (found is None)
        if expected is not None and found is not None:
            answered += 1
            assert (found.x, found.y) == pytest.approx(expected, rel=1e-6, abs=1e-6 * naive.travelled)
    assert answered > 0.2 * len(motions)


def test_the_registry_names_the_degrees() -> None:
    """build(name) answers as the naive fit of that degree does."""
    events = curved_reach(4, 125.0)
    for name, degree in (("kep-quadratic", 2), ("kep-quartic", 4)):
        naive, pipeline = NaiveKep(degree), build(name)
        differentiator = pipeline.differentiator.fresh()
        for event in events.events():
            expected, found = naive.update(differentiator.update(event)), pipeline.update(event)
            assert (expected is None) == (found is None)
            if expected is not None and found is not None:
                assert (found.x, found.y) == pytest.approx(expected, rel=1e-6, abs=1e-3)


def fitted(distances: FloatArray, speeds: FloatArray, degree: int) -> FloatArray:
    """Coefficients of the recursive fit, from the constant up, of the distance in px."""
    fit = kep.Fit(np.zeros(kep.Fit.length))
    for distance, speed in zip(distances, speeds, strict=True):
        kep.add(fit, degree, distance, speed)
    regression = least_squares.parts(fit.numbers, degree + 1)
    assert least_squares.solve(regression, kep.EXCITATION_LEAST, fit.coefficients)
    return fit.coefficients[: degree + 1]


@pytest.mark.parametrize("degree", [2, 3, 4])
@pytest.mark.parametrize("largest", [0.3, 1.0, 900.0, 1e7])
def test_coefficients_are_those_of_least_squares(degree: int, largest: float) -> None:
    random = np.random.default_rng(8)
    distances = np.sort(random.uniform(0.0, largest, 400))
    speeds = random.standard_normal(400)
    expected = np.polynomial.Polynomial.fit(distances, speeds, degree).convert().coef
    scale = largest ** np.arange(degree + 1)
    np.testing.assert_allclose(fitted(distances, speeds, degree) * scale, expected * scale, rtol=1e-9)


def test_growing_the_unit_rounds_nothing() -> None:
    """Distances scaled by a power of two give the same factor bit for bit once the units have grown alike."""
    random = np.random.default_rng(9)
    distances = 64.0 + np.cumsum(random.uniform(0.0, 20.0, 200))
    speeds = random.uniform(0.0, 1.0, 200)
    near, far = fitted(distances, speeds, 4), fitted(1024.0 * distances, speeds, 4)
    assert np.array_equal(near, far * 1024.0 ** np.arange(5))


COEFFICIENT = st.floats(-100.0, 100.0).filter(lambda c: c == 0.0 or abs(c) > 1e-6)


@given(
    c=st.tuples(st.floats(0.01, 100.0), COEFFICIENT, COEFFICIENT, COEFFICIENT, COEFFICIENT),
    far=st.floats(0.1, 50.0),
)
@settings(max_examples=300, deadline=None, derandomize=True)
def test_the_first_zero_is_that_of_numpy(c: tuple[float, ...], far: float) -> None:
    zero = kep.first_zero(kep.Quartic(*c), far)
    polynomial = np.polynomial.Polynomial(c)
    roots = np.roots(c[::-1])
    real = np.sort(roots.real[(np.abs(roots.imag) < 1e-7) & (roots.real > 0.0)])
    # A double root or one at the very bound may fall on either side of rounding.
    assume(all(abs(polynomial.deriv()(r)) * r > 1e-4 * np.sum(np.abs(c) * r ** np.arange(5)) for r in real))
    real = real[real <= far]
    if len(real) == 0:
        assert np.isnan(zero) or zero == pytest.approx(far, rel=1e-9)
    else:
        assert zero == pytest.approx(real[0], rel=1e-8)


@pytest.mark.parametrize(
    ("c", "far", "expected"),
    [
        ((-1.0, 1.0, 0.0, 0.0, 0.0), 10.0, None),  # comes up from below: the speed does not return to zero
        ((0.0, -1.0, 0.0, 0.0, 0.0), 10.0, None),  # is zero already
        ((1.0, 0.0, 0.0, 0.0, 0.0), 10.0, None),
        ((1.0, -0.5, 0.0, 0.0, 0.0), 10.0, 2.0),
        ((1.0, -0.5, 0.0, 0.0, 0.0), 1.9, None),
        ((4.0, -4.0, 1.0, 0.0, 0.0), 10.0, 2.0),  # touches zero
        ((6.0, -11.0, 6.0, -1.0, 0.0), 10.0, 1.0),  # zeros 1, 2, 3
        ((24.0, -50.0, 35.0, -10.0, 1.0), 10.0, 1.0),  # zeros 1, 2, 3, 4
        ((1.0, 0.0, 0.0, 0.0, -1e-12), 1e4, 1000.0),
    ],
)
def test_zeros_known_by_hand(c: tuple[float, ...], far: float, expected: float | None) -> None:
    zero = kep.first_zero(kep.Quartic(*c), far)
    assert np.isnan(zero) if expected is None else zero == pytest.approx(expected, rel=1e-12)


def test_the_naive_fit_sees_what_a_motion_is() -> None:
    """The oracle itself on a movement known by hand: speed = d (100 - d) / 1000."""
    naive = NaiveKep(2)
    ends = [
        naive.update(Motion(0.01 * i, 0.0, -d, 0.0, -d * (100.0 - d) / 1e3, 0.0, 0.0, True, start=i == 0))
        for i, d in enumerate([0.0, 10.0, 30.0, 60.0])
    ]
    assert ends[0] is None
    assert ends[3] == pytest.approx((0.0, -100.0))
