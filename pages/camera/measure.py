"""Measure the camera's observer beside its peer: ``python -m pages.camera.measure``."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np

from pages import FIGURES
from pages.arguments import parse
from pages.camera.figures import draw
from pages.camera.tables import designs, residuals
from pages.data import Table, keep
from pointpred.cli.progress import following
from pointpred.records import FloatArray
from pointpred_observers.camera import (
    WAYS,
    DepthObserver,
    Noise,
    PointFilter,
    Trajectory,
    UnknownInputs,
    consistent,
    cramer_rao,
    printed,
    velocities,
)
from pointpred_observers.camera.samples import observed
from pointpred_observers.reproduction.camera import (
    FOCAL_PX,
    GUESSED_S,
    NAMES,
    RUNS,
    START_CHI,
    START_ETA,
    estimated,
    scenario_45,
)

PIXELS = (0.0, 2.0, 4.0, 8.0)
SMALLEST_PX = 0.05


def rms(errors: Any) -> Any:
    """Root mean square of each column where it is known."""
    return np.sqrt(np.nanmean(np.asarray(errors) ** 2, axis=0))


def filter_sigma(noise_px: float) -> float:
    """The standard deviation that the filter assumes for noise uniform in +-noise_px."""
    return max(noise_px / np.sqrt(3.0), SMALLEST_PX)


class Run(msgspec.Struct, frozen=True):
    """Errors of one run; those of several columns are of (chi, eta, v)."""

    ways: dict[str, FloatArray]
    """RMSE of the observer by way"""
    late: FloatArray
    """RMSE of the last way while the filter runs"""
    peer: FloatArray
    """RMSE of the filter"""
    ends: tuple[FloatArray, FloatArray]
    """Last errors of the observer and of the filter"""
    start: float
    depth: float
    """The filter's last error of the depth in m"""
    nees: float


def one_run(truth: Trajectory, noise: Noise, seed: int, accel: float | None = None) -> Run:
    """Simulate once and compare the observer, with every way, and the filter with the truth."""
    samples = observed(truth, focal_px=FOCAL_PX, noise=noise, seed=seed)
    observer = DepthObserver(focal_px=FOCAL_PX, start_chi=START_CHI, start_eta=START_ETA).run(samples)
    track = PointFilter(
        focal_px=FOCAL_PX,
        noise_px=filter_sigma(noise.noise_px),
        accel_noise=noise.accel_noise if accel is None else accel,
        gyro_noise=noise.gyro_noise,
    ).run(samples)
    wanted = np.column_stack([truth.chi, truth.eta, truth.v])
    ways = {}
    for way in WAYS:
        d = UnknownInputs(way, focal_px=FOCAL_PX, noise_px=filter_sigma(noise.noise_px)).run(
            samples, observer.eta
        )
        ways[way] = np.column_stack([observer.chi, observer.eta, velocities(d, observer)]) - wanted
    chi = 1.0 / track.state[:, 2]
    peer = np.column_stack([chi, track.state[:, 5] * chi, track.state[:, 3:]]) - wanted
    end = track.state[-1] - np.concatenate([truth.p[-1], truth.v[-1]])
    return Run(
        ways={way: rms(errors) for way, errors in ways.items()},
        late=rms(ways[WAYS[-1]][track.running]),
        peer=rms(peer[track.running]),
        ends=(ways[WAYS[-1]][-1], peer[-1]),
        start=float(track.t[track.running][0]),
        depth=float(end[2]),
        nees=float(end @ np.linalg.solve(track.covariance[-1], end)),
    )


def monte_carlo(truth: Trajectory) -> dict[float, list[Run]]:
    """All runs at all noises, with a bar where somebody can see it."""
    runs: dict[float, list[Run]] = {}
    with following() as bar:
        for noise_px in PIXELS:
            runs[noise_px] = []
            for seed in range(RUNS):
                runs[noise_px].append(one_run(truth, Noise(noise_px=noise_px), seed))
                if bar is not None:
                    bar(f"{noise_px:g} px", len(runs) * RUNS - RUNS + seed + 1, RUNS * len(PIXELS))
    return runs


def errors_table(runs: dict[float, list[Run]]) -> Table:
    """RMSE by noise: the observer with every way, and the peer."""
    rows = []
    for noise_px, some in runs.items():
        rows += [
            (f"{noise_px:g}", f"observer, {way}", *_short(rms([run.ways[way] for run in some])))
            for way in WAYS
        ]
        rows.append((f"{noise_px:g}", "**filter (peer)**", *_short(rms([run.peer for run in some]))))
    return Table.of(("noise px", "estimator", "chi 1/m", "eta 1/s", "v_x m/s", "v_y m/s", "v_z m/s"), rows)


def peer_table(runs: dict[float, list[Run]], truth: Trajectory) -> Table:
    """The peer beside the bound, its consistency, and the observer over the same time."""
    rows = []
    for noise_px, some in runs.items():
        bound = cramer_rao(truth, focal_px=FOCAL_PX, noise_px=filter_sigma(noise_px))
        least = float(np.sqrt(bound[-1, 2, 2]))
        depth_error = float(rms([run.depth for run in some]))
        average, (low, high) = consistent(np.array([run.nees for run in some]))
        late, peer = rms([run.late for run in some]), rms([run.peer for run in some])
        ends = rms([run.ends for run in some])
        rows.append(
            (
                f"{noise_px:g}",
                f"{np.mean([run.start for run in some]):.1f}",
                f"{1e3 * depth_error:.1f}",
                f"{1e3 * least:.1f}" if noise_px else "-",
                f"{depth_error / least:.2f}" if noise_px else "-",
                f"{average:.1f} ({low:.1f} to {high:.1f})" if noise_px else "-",
                f"{late[0] / peer[0]:.0f}, {late[4] / peer[4]:.0f}",
                f"{ends[0, 0] / ends[1, 0]:.0f}, {ends[0, 4] / ends[1, 4]:.0f}",
            )
        )
    header = (
        "noise px",
        "starts s",
        "depth error mm",
        "bound mm",
        "ratio",
        "NEES (95 %)",
        "since it started",
        "at 10 s",
    )
    return Table.of(header, rows)


def table_one(runs: dict[float, list[Run]], truth: Trajectory) -> Table:
    """TABLE I as printed, ours from the printed start, and ours from a start that is right in v_z."""
    rows = []
    guessed = estimated(scenario_45(GUESSED_S, cosine=True))
    for noise_px, values in printed.TABLE_I.items():
        rows.append((f"{noise_px}", "print", *_short(values)))
        rows.append(
            (f"{noise_px}", "ours", *_short(rms([run.ways["difference"] for run in runs[float(noise_px)]])))
        )
    right = estimated(truth, start_eta=-1.2)
    rows.append(("0", "ours, v_z right at the start: eta(0) = -1.2", *_short(right.rmse)))
    rows.append(("0", "ours, cos for sin in v_z, 63 s", *_short(guessed.rmse)))
    return Table.of(("noise px", "", *NAMES), rows)


def _short(values: Any) -> list[str]:
    return [f"{value:.4f}" for value in values]


def main() -> None:
    """Measure, print, draw, and fill the page."""
    truth = scenario_45()
    runs = monte_carlo(truth)
    parts = {
        "residuals": residuals(),
        "designs": designs(),
        "errors": errors_table(runs),
        "peer": peer_table(runs, truth),
        "table one": table_one(runs, truth),
        "sensors": sensors(truth),
    }
    keep("camera", parts)
    draw(FIGURES, FOCAL_PX)


def sensors(truth: Trajectory) -> Table:
    """What imperfect sensors do at 2 px: noise that the filter is told of, and biases that nobody is."""
    cases = {
        "perfect": (Noise(noise_px=2.0), None),
        "every fifth image missing": (Noise(noise_px=2.0, dropped=0.2), None),
        "white noise, told": (Noise(noise_px=2.0, gyro_noise=2e-4, accel_noise=2e-3), None),
        "bias 0.002 rad/s": (Noise(noise_px=2.0, gyro_bias=(0.002,) * 3), None),
        "bias 0.005 m/s^2": (Noise(noise_px=2.0, accel_bias=(0.005,) * 3), None),
        "the same, told 0.003 m/s^2/sqrt(Hz) of noise": (Noise(noise_px=2.0, accel_bias=(0.005,) * 3), 3e-3),
        "bias 0.02 m/s^2": (Noise(noise_px=2.0, accel_bias=(0.02,) * 3), None),
    }
    rows = []
    for name, (noise, accel) in cases.items():
        some = [one_run(truth, noise, seed, accel) for seed in range(RUNS)]
        late, peer = rms([run.late for run in some]), rms([run.peer for run in some])
        nees = np.mean([run.nees for run in some])
        rows.append((name, *_short(late[[0, 4]]), *_short(peer[[0, 4]]), f"{nees:.0f}"))
    return Table.of(("sensors", "observer chi", "v_z", "filter chi", "v_z", "filter's NEES"), rows)


if __name__ == "__main__":
    parse(__doc__)
    main()
