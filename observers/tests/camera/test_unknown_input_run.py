"""The general observer at run time: the camera through it, a system with a third output, and refusals."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from pointpred.errors import EventError, EventOrderError, ParameterError
from pointpred_observers import Box, ParameterVaryingSystem
from pointpred_observers.camera import SCENARIOS, DepthObserver, camera_box, camera_system, model, simulate
from pointpred_observers.unknown_input.observer import UnknownInputObserver
from pointpred_observers.unknown_input.stage import UnknownInputSample

BOUNDS = {"turn": (-0.02, 0.02), "a_z": (-0.1, 0.1), "w": (-0.07, 0.07), "dw": (-0.2, 0.2)}


@pytest.fixture(scope="module")
def camera() -> UnknownInputObserver:
    return UnknownInputObserver.design(camera_system(), camera_box((-2.0, -0.03), **BOUNDS), 0.005)


def test_the_camera_through_the_general_observer(camera: UnknownInputObserver) -> None:
    samples, truth = simulate(SCENARIOS["paper"], focal_px=800.0, duration_s=2.0, image_hz=100.0)
    slopes = np.gradient(truth.w, truth.t, axis=0, edge_order=2)
    stage = camera.stage([0.0, 0.0, 4.0, -1.6])
    found = []
    for k in range(len(truth.t)):
        x, y = truth.image[k]
        measured = dict(zip(("a_z", "w_x", "w_y"), (truth.a[k, 2], *truth.w[k, :2]), strict=True))
        measured |= {"dw_x": slopes[k, 0], "dw_y": slopes[k, 1]}

        def schedule(
            estimate: np.ndarray, x: float = x, y: float = y, m: dict = measured
        ) -> dict[str, float]:
            eta = float(estimate[3])
            return {"zero": y * m["w_x"] - x * m["w_y"] + eta, "eta": eta, **m}

        known = np.concatenate([model.interaction(x, y) @ truth.w[k], np.zeros(2)])
        estimate = stage.update(UnknownInputSample(truth.t[k], truth.image[k], known, schedule))
        found.append([estimate.x[2], estimate.x[3], estimate.certified])
        np.testing.assert_allclose(estimate.x[:2], truth.image[k], atol=1e-12)
    compiled = DepthObserver(focal_px=800.0, start_chi=4.0, start_eta=-1.6).run(samples)
    np.testing.assert_allclose(np.array(found)[:, 0], compiled.chi, rtol=1e-3)
    np.testing.assert_allclose(np.array(found)[:, 1], compiled.eta, atol=1e-3)
    assert np.array(found)[:, 2].all()


def third_output() -> tuple[UnknownInputObserver, ParameterVaryingSystem]:
    c = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    system = ParameterVaryingSystem(
        lambda p: np.array([[0.0, 1.0, 0.0], [0.0, 0.3, 0.0], [0.0, 1.0, p["k"]]]),
        lambda p: np.array([[1.0], [0.5], [0.0]]),
        c,
    )
    return UnknownInputObserver.design(system, Box({"k": (-2.0, -1.0)}), 0.25), system


def test_an_unknown_input_of_any_kind_leaves_the_error_alone() -> None:
    """The third output corrects the rest: the error of an unstable part goes, whatever the input does."""
    observer, system = third_output()

    def k(t: float) -> float:
        return -1.5 + 0.5 * np.sin(t)

    def rate(t: float, x: np.ndarray) -> np.ndarray:
        d = np.array([np.sign(np.sin(5.0 * t)) * 0.3])
        return system.a({"k": k(t)}) @ x + system.f({"k": k(t)}) @ d

    times = np.arange(0.0, 12.0, 0.02)
    truth = solve_ivp(rate, (0.0, 12.0), [0.1, 0.2, -0.3], t_eval=times, max_step=0.01).y.T
    stage = observer.stage([0.0, 2.0, 0.0])
    errors = []
    for t, x in zip(times, truth, strict=True):
        sample = UnknownInputSample(float(t), system.c @ x, np.zeros(3), lambda _, t=t: {"k": k(t)})
        errors.append(np.abs(stage.update(sample).x - x).max())
    assert errors[0] > 1.0
    assert errors[-1] < 0.02 * (1.0 + np.abs(truth[-1]).max())


def test_outside_the_box_it_goes_on_and_says_so() -> None:
    stage = third_output()[0].stage(np.zeros(3))
    for i, k in enumerate((-1.5, -0.5, -1.5)):
        sample = UnknownInputSample(0.02 * i, np.zeros(2), np.zeros(3), lambda _, k=k: {"k": k})
        assert stage.update(sample).certified == (k == -1.5)


def test_refusals_change_nothing() -> None:
    observer, _ = third_output()

    def sample(t: float, y: object = (0.0, 0.0), known: object = (0.0,) * 3) -> UnknownInputSample:
        return UnknownInputSample(t, np.array(y), np.array(known), lambda _: {"k": -1.5})

    with pytest.raises(ParameterError, match="start needs 3 finite numbers"):
        observer.stage(np.zeros(2))
    stage = observer.stage([1.0, 2.0, 3.0])
    first = stage.update(sample(0.0))
    with pytest.raises(EventOrderError, match="t must increase"):
        stage.update(sample(0.0))
    with pytest.raises(EventError, match="y needs 2 finite numbers"):
        stage.update(sample(0.1, y=(0.0, np.inf)))
    with pytest.raises(EventError, match="known needs 3 finite numbers"):
        stage.update(sample(0.1, known=(0.0,)))
    with pytest.raises(EventError, match="t must be finite"):
        stage.update(sample(np.inf))
    after = stage.update(sample(0.1)).x
    stage.reset()
    assert np.array_equal(stage.update(sample(0.0)).x, first.x)
    assert np.array_equal(stage.update(sample(0.1)).x, after)
