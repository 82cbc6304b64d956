"""The whole way from images to depth, on a rendered plane whose motion is known."""

from __future__ import annotations

import sys

import numpy as np
import pytest

from observers.tests.camera.rendering import render
from pointpred.errors import EventError, MissingExtraError, ParameterError
from pointpred_observers.camera import SCENARIOS, DepthObserver, PointFilter
from pointpred_observers.camera.scenario import Trajectory, observed, trajectory
from pointpred_observers.camera.tracker import PointTracker, tracked

pytest.importorskip("cv2", reason="OpenCV is not installed")
FOCAL = 300.0


@pytest.fixture(scope="module")
def truth() -> Trajectory:
    return trajectory(SCENARIOS["paper"], np.arange(231) / 33.0)


@pytest.fixture(scope="module")
def images(truth: Trajectory) -> list[np.ndarray]:
    return render(truth, FOCAL)


def test_the_point_is_followed_to_a_pixel(truth: Trajectory, images: list[np.ndarray]) -> None:
    samples = tracked(PointTracker(), images, observed(truth, focal_px=FOCAL))
    errors = samples.table[:, 1:3] - FOCAL * truth.image
    assert not np.isnan(errors).any()
    assert np.abs(FOCAL * truth.image).max() > 50.0  # it has really moved
    assert np.sqrt(np.mean(errors**2)) < 1.0


def test_images_lead_to_the_depth(truth: Trajectory, images: list[np.ndarray]) -> None:
    samples = tracked(PointTracker(), images, observed(truth, focal_px=FOCAL))
    track = PointFilter(focal_px=FOCAL, noise_px=0.5).run(samples)
    assert track.running[-1]
    assert abs(track.state[-1, 2] - truth.p[-1, 2]) < 0.05 * truth.p[-1, 2]
    assert np.abs(track.state[-1, 3:] - truth.v[-1]).max() < 0.02
    depth = DepthObserver(focal_px=FOCAL, start_chi=1.0, start_eta=-0.3).run(samples)
    assert abs(1.0 / depth.chi[-1] - truth.p[-1, 2]) < 0.01


def test_a_point_that_is_covered_is_reported_missing_and_found_again(
    truth: Trajectory, images: list[np.ndarray]
) -> None:
    covered = [image.copy() for image in images[:12]]
    for k in (5, 6):
        covered[k][:] = np.random.default_rng(k).integers(0, 255, covered[k].shape)
    samples = tracked(
        PointTracker(), covered, observed(trajectory(SCENARIOS["paper"], truth.t[:12]), focal_px=FOCAL)
    )
    assert np.isnan(samples.x[5:7]).all()
    assert abs(samples.x[11] - FOCAL * truth.image[11, 0]) < 0.5


def test_refusals(truth: Trajectory, images: list[np.ndarray]) -> None:
    tracker = PointTracker()
    with pytest.raises(EventError, match="must be grey"):
        tracker.update(np.zeros((100, 100, 3), np.uint8))  # type: ignore[arg-type]
    tracker.update(images[0])
    with pytest.raises(EventError, match=r"must have the shape \(240, 320\), received \(100, 100\)"):
        tracker.update(np.zeros((100, 100), np.uint8))
    with pytest.raises(ParameterError, match="the point must lie in the image"):
        PointTracker(x=1e4).update(images[0])
    with pytest.raises(ParameterError, match="231 images are needed, one every 1 of 231 rows, received 3"):
        tracked(PointTracker(), images[:3], observed(truth, focal_px=FOCAL))


def test_without_opencv_the_call_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "cv2", None)
    with pytest.raises(MissingExtraError, match=r"-m pip install .*\[camera\]"):
        PointTracker()
