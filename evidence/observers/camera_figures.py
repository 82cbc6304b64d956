"""The figures of observers/docs/camera.md and of docs/evidence/observers.md."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from evidence import ROOT
from evidence.observers.bounds import cramer_rao
from evidence.thinning import save, thin
from pointpred.drawing import GREY, PALETTE, canvas, picture
from pointpred_observers.camera import (
    SCENARIOS,
    CameraPipeline,
    DepthObserver,
    Noise,
    PointFilter,
    Scenario,
    trajectory,
)
from pointpred_observers.camera.samples import observed
from pointpred_observers.cli.camera_files import truth_table
from pointpred_observers.cli.camera_plot import plot


def draw(folder: Path, focal_px: float) -> None:
    """Write all four."""
    for name, depth, eta in (("paper", 0.25, -1.6), ("approaching", 4.0, -0.1)):
        truth = trajectory(SCENARIOS[name], np.arange(331) / 33.0)
        samples = observed(truth, focal_px=focal_px, noise=Noise(noise_px=2.0), seed=1)
        observer = DepthObserver(focal_px=focal_px, start_chi=1.0 / depth, start_eta=eta)
        noise_px = 2.0 / np.sqrt(3.0)
        stages = CameraPipeline(
            observer, PointFilter(focal_px=focal_px, noise_px=noise_px), noise_px=noise_px
        )
        title = f"Scenario {name}, 2 px, focal length {focal_px:g} px (simulated)"
        plot(stages.run(samples), truth_table(truth), folder / f"camera-{name}.svg", title)
        thin(folder / f"camera-{name}.svg")
    _fading(ROOT / "observers" / "docs" / "figures" / "camera-fading.svg", focal_px)
    _bound(folder / "camera-bound.svg", focal_px)


def _fading(target: Path, focal_px: float) -> None:
    """What fades of the observer's error, and what does not, over a minute of receding."""
    t = np.arange(60 * 33) / 33.0
    backwards = Scenario("backwards", lambda t: (0.0, 0.0, -0.2), lambda t: (0.0, 0.0, 0.0))
    truth = trajectory(backwards, t)
    observer = DepthObserver(focal_px=focal_px, start_chi=1.0 / 1.3, start_eta=-0.25 / 1.3)
    estimate = observer.run(observed(truth, focal_px=focal_px))
    lines = {
        "chi [1/m]": np.abs(estimate.chi - truth.chi),
        "eta [1/s]": np.abs(estimate.eta - truth.eta),
        "v_z [m/s]": np.abs(estimate.eta / estimate.chi - truth.v[:, 2]),
        "depth, relative": np.abs(1.0 / estimate.chi / truth.p[:, 2] - 1.0),
    }
    with canvas(width=7.5, height=4.2) as (figure, (ax,)):
        for (label, values), colour in zip(lines.items(), PALETTE, strict=False):
            ax.plot(t, values, color=colour, label=label)
        ax.set(yscale="log", xlabel="t [s]", ylabel="error of the observer", ylim=(1e-4, 2.0))
        ax.yaxis.set_major_formatter("{x:g}")
        ax.set_title("A camera that recedes at 0.2 m/s from 1 m, started with 1.3 m and 0.25 m/s")
        ax.legend(loc="lower left")
        words = "Errors of chi and eta fall; those of v_z and of the relative depth level off."
        save(picture(figure, words, words).svg, target)


def _bound(target: Path, focal_px: float) -> None:
    """The filter's depth error over time beside the bound and its own standard deviation."""
    truth = trajectory(SCENARIOS["paper"], np.arange(331) / 33.0)
    noise_px = 4.0 / np.sqrt(3.0)
    squares, believed = [], []
    for seed in range(40):
        samples = observed(truth, focal_px=focal_px, noise=Noise(noise_px=4.0), seed=seed)
        track = PointFilter(focal_px=focal_px, noise_px=noise_px).run(samples)
        squares.append((track.state[:, 2] - truth.p[:, 2]) ** 2)
        believed.append(track.covariance[:, 2, 2])
    started = np.isfinite(squares).all(axis=0)
    least = np.sqrt(cramer_rao(truth, focal_px=focal_px, noise_px=noise_px)[:, 2, 2])
    with canvas(width=7.5, height=4.2) as (figure, (ax,)):
        ax.plot(truth.t, least, color=GREY, linewidth=3.5, label="Cramer-Rao bound")
        error = np.sqrt(np.mean(squares, axis=0))
        ax.plot(truth.t[started], error[started], color=PALETTE[0], label="filter: RMS error of 40 runs")
        belief = np.sqrt(np.mean(believed, axis=0))
        ax.plot(
            truth.t[started],
            belief[started],
            color=PALETTE[1],
            linestyle=(0, (4, 2)),
            label="filter: believed",
        )
        ax.set(yscale="log", xlabel="t [s]", ylabel="depth [m]", ylim=(0.02, 2.0))
        ax.yaxis.set_major_formatter("{x:g}")
        ax.set_title("Depth by the filter, 4 px, once all runs have started")
        ax.legend(loc="upper right")
        words = "The filter's depth error lies near the Cramer-Rao bound."
        save(picture(figure, words, words).svg, target)
