"""The observer at run time: against its full form, the exact law of its errors, and where it fails."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline

from pointpred.errors import ParameterError
from pointpred_observers import camera
from pointpred_observers.plants.boxes import Box
from pointpred_observers.plants.varying import ParameterVaryingSystem
from pointpred_observers.unknown_input.observer import UnknownInputObserver

FOCAL = 800.0
BOUNDS = {"turn": (-0.02, 0.02), "a_z": (-0.1, 0.1), "w": (-0.07, 0.07), "dw": (-0.2, 0.2)}


@pytest.fixture(scope="module")
def design() -> UnknownInputObserver:
    return UnknownInputObserver.design(
        camera.camera_system(), camera.camera_box((-2.0, -0.03), **BOUNDS), 0.005
    )


def observer(chi: float = 4.0, eta: float = -1.6, **more: object) -> camera.DepthObserver:
    return camera.DepthObserver(focal_px=FOCAL, start_chi=chi, start_eta=eta, **more)  # type: ignore[arg-type]


def test_the_reduced_form_is_the_full_form(design: UnknownInputObserver) -> None:
    """Four states with gains by Runge-Kutta of another library, on splines of exact signals."""
    samples, truth = camera.simulate(
        camera.SCENARIOS["paper"], focal_px=FOCAL, duration_s=6.0, image_hz=200.0
    )
    w, image = CubicSpline(truth.t, truth.w), CubicSpline(truth.t, truth.image)
    a_z, w_rate = CubicSpline(truth.t, truth.a[:, 2]), CubicSpline(truth.t, truth.w).derivative()

    def point(t: float, eta: float) -> dict[str, float]:
        (x, y), (wx, wy, _), (dwx, dwy, _) = image(t), w(t), w_rate(t)
        values = (y * wx - x * wy + eta, eta, float(a_z(t)), wx, wy, dwx, dwy)
        return dict(zip(camera.model.SCHEDULED, map(float, values), strict=True))

    def estimate(t: float, z: np.ndarray) -> np.ndarray:
        return z - design.system.e(point(t, 0.0)) @ image(t)

    def rate(t: float, z: np.ndarray) -> np.ndarray:
        found, y = estimate(t, z), image(t)
        here = point(t, found[3])
        k = design.box.mixed(design.gains, design.box.nearest(here))
        known = np.concatenate([camera.model.interaction(*y) @ w(t), np.zeros(2)])
        moved = design.system.gamma(here) @ found + design.system.t(here) @ known
        return moved + k @ (y - found[:2])

    began = design.system.t(point(0.0, -0.5)) @ [0.0, 0.0, 1.5, -0.5]
    full = solve_ivp(rate, (0.0, 6.0), began, rtol=1e-8, atol=1e-10, t_eval=truth.t[::40])
    estimates = np.array([estimate(t, z) for t, z in zip(full.t, full.y.T, strict=True)])
    reduced = observer(1.5, -0.5).run(samples)
    np.testing.assert_allclose(reduced.chi[::40], estimates[:, 2], rtol=2e-6)
    np.testing.assert_allclose(reduced.eta[::40], estimates[:, 3], atol=2e-6)
    np.testing.assert_allclose(estimates[:, :2], image(full.t), atol=1e-8)


def test_the_general_reduced_form_is_the_compiled_law(design: UnknownInputObserver) -> None:
    from pointpred_observers.camera import depth

    random = np.random.default_rng(4)
    for x, y, wx, wy, wz, eta, a_z, dwx, dwy, chi in random.uniform(0.03, 0.05, (20, 10)):
        values = (y * wx - x * wy - eta, -eta, a_z, wx, wy, dwx, dwy)
        point = dict(zip(camera.model.SCHEDULED, map(float, values), strict=True))
        state = np.array([x, y, chi, -eta])
        z = design.system.t(point) @ state
        known = np.concatenate([camera.model.interaction(x, y) @ [wx, wy, wz], [0, 0]])
        gamma, k, e, t = design.equations(point)
        rate = gamma @ (z - e @ [x, y]) + t @ known
        assert not k.any()
        np.testing.assert_allclose(
            depth.rate(chi, z[3], depth.Measured(x, y, wx, wy, wz, a_z), dwx, dwy), rate[2:], atol=1e-15
        )
        np.testing.assert_allclose(
            design.system.gamma(point) @ state + design.system.t(point) @ known, rate, atol=1e-14
        )


def test_with_the_right_start_the_truth_is_followed() -> None:
    samples, truth = camera.simulate(
        camera.SCENARIOS["paper"], focal_px=FOCAL, duration_s=10.0, image_hz=100.0
    )
    depth = observer(1.0, -0.3).run(samples)
    assert np.abs(depth.chi - truth.chi).max() < 1e-6
    assert np.abs(depth.eta - truth.eta).max() < 1e-6


def test_errors_follow_their_exact_law_and_the_image_never_corrects_them() -> None:
    """Without rotation (Z, v_z) is linear in its start: the error of v_z stays, that of Z grows by it."""
    samples, truth = camera.simulate(camera.SCENARIOS["axial"], focal_px=FOCAL, duration_s=20.0)
    depth = observer(1.0 / 1.3, -0.25 / 1.3).run(samples)
    forward = depth.eta / depth.chi - truth.v[:, 2]
    np.testing.assert_allclose(forward, -0.05, atol=1e-5)
    np.testing.assert_allclose(1.0 / depth.chi - truth.p[:, 2], 0.3 + 0.05 * truth.t, atol=1e-4)
    errors = np.abs(depth.chi - truth.chi)
    assert errors[-1] < 0.2 * errors[0]  # chi's error fades only because the point goes away


def test_v_z_of_the_paper_keeps_the_error_of_its_start() -> None:
    samples, truth = camera.simulate(camera.SCENARIOS["paper"], focal_px=FOCAL)
    depth = observer().run(samples)
    assert abs((depth.eta / depth.chi - truth.v[:, 2])[-1] + 0.1) < 0.01
    cosine, _ = observer(4.0, -1.2).run(samples), truth
    assert abs((cosine.eta / cosine.chi - truth.v[:, 2])[-1]) < 0.01


def test_the_proved_bound_covers_the_error(design: UnknownInputObserver) -> None:
    samples, truth = camera.simulate(camera.SCENARIOS["paper"], focal_px=FOCAL)
    depth = observer().run(samples)
    first = np.hypot(4.0 - truth.chi[0], -1.6 - truth.eta[0])
    state = np.column_stack([truth.chi, truth.eta])
    largest = (np.abs(depth.eta - truth.eta) * np.linalg.norm(state, axis=1)).max() * 2.0
    for k in range(0, len(truth.t), 10):
        error = np.hypot(depth.chi[k] - truth.chi[k], depth.eta[k] - truth.eta[k])
        assert error <= design.bound(truth.t[k], float(first), delta=float(largest))


def test_an_approaching_camera_is_flagged_from_the_first_sample(design: UnknownInputObserver) -> None:
    samples, truth = camera.simulate(camera.SCENARIOS["approaching"], focal_px=FOCAL)
    depth = observer(truth.chi[0] * 1.1, truth.eta[0], observer=design).run(samples)
    assert not depth.detectable.any()
    assert not depth.certified.any()
    error = np.abs(depth.chi - truth.chi)
    assert error[-1] > 1.5 * error[0]  # what the flag warns of


def test_flags_of_a_receding_camera(design: UnknownInputObserver) -> None:
    samples, _ = camera.simulate(camera.SCENARIOS["paper"], focal_px=FOCAL)
    depth = observer(1.0, -0.3, observer=design).run(samples)
    assert depth.detectable.all()
    assert depth.certified.all()
    # The box by its names, in whatever order they are.
    turned = UnknownInputObserver.design(
        camera.camera_system(), Box(dict(reversed(design.box.bounds.items()))), design.decay
    )
    assert observer(1.0, -0.3, observer=turned).settings() == observer(1.0, -0.3, observer=design).settings()
    assert not observer(1.0, -0.3).run(samples).certified.any()


def test_both_zeros_must_decay_to_call_a_turning_camera_detectable(design: UnknownInputObserver) -> None:
    """At x = 0, y = 0.5 the zero of chi is 0.5 w_x + eta: a turn moves it and leaves eta."""
    for wx, eta, detectable in ((-1.0, 0.25, False), (1.0, -0.25, False), (-1.0, -0.25, True)):
        for more in ({}, {"observer": design}):
            sample = camera.CameraSample(0.0, 0.0, 0.5 * FOCAL, wx, 0.0, 0.0, 0.0, 0.0, 0.0)
            depth = observer(1.0, eta, **more).update(sample)
            assert (depth.zero, depth.eta) == (0.5 * wx + eta, eta)
            assert (depth.detectable, depth.certified) == (detectable, False)


def test_missing_images_mean_prediction_only() -> None:
    clean, truth = camera.simulate(camera.SCENARIOS["paper"], focal_px=FOCAL, readings=3)
    gaps, _ = camera.simulate(
        camera.SCENARIOS["paper"], focal_px=FOCAL, readings=3, noise=camera.Noise(dropped=0.5), seed=2
    )
    full, some = observer(1.0, -0.3).run(clean), observer(1.0, -0.3).run(gaps)
    assert 0.1 < some.image.mean() < 0.2
    assert np.abs(some.chi - truth.chi).max() < 5e-3
    assert np.abs(some.chi - full.chi).max() > 0.0


def test_nothing_is_said_before_the_first_image() -> None:
    stage = observer()
    before = stage.update(camera.CameraSample(0.0, np.nan, np.nan, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    assert np.isnan([before.chi, before.eta]).all()
    assert not before.detectable
    first = stage.update(camera.CameraSample(0.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    assert (first.chi, first.eta, first.detectable) == (4.0, -1.6, True)


def test_a_camera_that_meets_the_point_is_lost_not_clipped() -> None:
    stage = observer(1.0, 2.0)
    for i in range(200):
        depth = stage.update(camera.CameraSample(i / 100, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    assert np.isnan([depth.chi, depth.eta, depth.zero]).all()
    assert not depth.detectable


def test_a_design_for_another_plant_is_refused(design: UnknownInputObserver) -> None:
    system = ParameterVaryingSystem(
        lambda p: np.array([[0.0, 1.0], [0.0, p["k"]]]), np.eye(2, 1), np.eye(1, 2)
    )
    other = UnknownInputObserver.design(system, Box({"k": (-3.0, -1.0)}), 0.5)
    wider = UnknownInputObserver.design(
        camera.camera_system(), Box({**design.box.bounds, "x": (-1.0, 1.0)}), design.decay
    )
    cases = (
        (other, "of 2 states in a box of k"),
        (wider, "dw_y, x$"),
        (3, "UnknownInputObserver, received 3"),
    )
    for wrong, words in cases:
        with pytest.raises(ParameterError, match=words) as refused:
            observer(observer=wrong)
        assert refused.value.field == "observer"
