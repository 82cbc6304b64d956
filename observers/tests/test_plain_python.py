"""Every compiled law beside plain Python of the same source, which another process runs."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

SCRIPT = """
import sys
import numpy as np
import pointpred.compiled
from pointpred_observers import GradientRegressor, NonlinearRegressor, invariant_observer
from pointpred_observers.camera import SCENARIOS, CameraColumns, DepthObserver, Gravity, PointFilter
from pointpred_observers.camera.velocity import UnknownInputFilter
from pointpred_observers.examples import UNMEASURED, two_masses
from pointpred_observers.thesis import PersidskiiStage

def stage(time):
    return PersidskiiStage(
        [[-1.0, 2.0], [-2.0, -1.0]], np.ones((2, 5)), np.arange(10.0).reshape(5, 2) / 10.0, [1.0, 0.0],
        ["sin", "tanh", "atan", "saturation", "identity"], R1=np.ones((2, 5)), start=[0.1, -0.2], time=time,
    )

def answers(images):
    random, begin = np.random.default_rng(3), np.arange(60) == 41
    t = np.cumsum(random.uniform(0.001, 0.03, 60))
    d, y = random.standard_normal((60, 2)), random.standard_normal(60)
    observer = invariant_observer(two_masses(), UNMEASURED, [[-1, 0], [0, 0.5]])
    both, weight = np.column_stack([t, d, y]), np.minimum(y**2, 1.0)
    samples = CameraColumns(np.load(images))
    depth = DepthObserver(focal_px=800.0, start_chi=4.0, start_eta=-1.6).run(samples)
    track = PointFilter(focal_px=800.0, noise_px=1.0, gyro_noise=1e-4, accel_noise=1e-3).run(samples)
    assert track.running.any()
    return {
        "gradient": GradientRegressor(2, gain=[[2.0, 0.5], [0.5, 1.0]]).walk(begin, both),
        "discrete": GradientRegressor(2, gain=0.1, time="discrete").walk(begin, both),
        "nonlinear": NonlinearRegressor(2, gain=9.0).walk(begin, np.column_stack([both, weight])),
        "observer": observer.stage().walk(begin, np.column_stack([t, d, d[::-1]])),
        "continuous": stage("continuous").walk(begin, np.column_stack([t, y])),
        "sampled": stage("discrete").walk(begin, np.column_stack([np.arange(60), y])),
        "depth": depth.table,
        "state": track.state,
        "covariance": track.covariance,
        "unknown input": UnknownInputFilter(focal_px=800.0).run(samples, depth.eta),
        "motion": Gravity(up=(0.1, -1.0, 0.0)).run(samples).table,
    }

if __name__ == "__main__":
    assert not pointpred.compiled.COMPILED
    np.savez(sys.argv[2], **answers(sys.argv[1]))
"""
LOOSER = {
    **dict.fromkeys(("gradient", "discrete", "nonlinear", "observer"), (1e-9, 1e-11)),
    "state": (1e-7, 1e-9),
    "covariance": (1e-6, 1e-12),
    "unknown input": (1e-10, 1e-12),
}


@pytest.mark.skipif(os.environ.get("POINTPRED_COMPILED") == "0", reason="nothing is compiled here")
def test_compiled_laws_agree_with_plain_python(tmp_path: Path) -> None:
    from pointpred_observers.camera import SCENARIOS, Noise, simulate

    noise = Noise(noise_px=1.5, dropped=0.2)
    samples, _ = simulate(SCENARIOS["paper"], focal_px=800.0, duration_s=3.0, noise=noise)
    images, out = tmp_path / "images.npy", tmp_path / "out.npz"
    turning = samples.table + 0.01 * np.eye(9)[5]  # a turn about the axis too
    np.save(images, turning)
    environment = {**os.environ, "POINTPRED_COMPILED": "0", "PYTHONWARNINGS": "error"}
    root = Path(__file__).parents[2]
    subprocess.run(
        [sys.executable, "-c", SCRIPT, str(images), str(out)], check=True, env=environment, cwd=root
    )
    here: dict[str, object] = {"__name__": "compiled"}
    exec(SCRIPT, here)
    compiled = here["answers"](images)  # type: ignore[operator]
    with np.load(out) as plain:
        assert set(plain) == set(compiled)
        for name, table in compiled.items():
            relative, absolute = LOOSER.get(name, (1e-12, 1e-12))
            np.testing.assert_allclose(table, plain[name], relative, absolute, err_msg=name)
