"""Measure the camera's observer beside its peer: ``python -m evidence observers camera_measure``."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from evidence import FIGURES, ROOT
from evidence.arguments import parse
from evidence.data import Table, keep
from evidence.observers import printed
from evidence.thinning import save, thin
from pointpred.cli.progress import following
from pointpred.differentiators import DIFFERENTIATORS
from pointpred.drawing import GREY, PALETTE, canvas, picture
from pointpred.errors import InfeasibleError, ParameterError
from pointpred.records import METRES_PER_INCH, BoolArray, FloatArray, PointerEvent
from pointpred_observers.camera import (
    SCENARIOS,
    CameraColumns,
    CameraPipeline,
    DepthObserver,
    Noise,
    PointFilter,
    camera_box,
    camera_system,
    kinematics,
)
from pointpred_observers.camera.point_filter import PointTrack
from pointpred_observers.camera.scenario import Scenario, Trajectory, observed, trajectory
from pointpred_observers.camera.velocity import UnknownInputFilter, flow, velocities
from pointpred_observers.cli.camera_files import plot, truth_table
from pointpred_observers.plants.boxes import Box
from pointpred_observers.reproduction.camera import (
    FOCAL_PX,
    GUESSED_S,
    NAMES,
    RUNS,
    START_CHI,
    START_ETA,
    TABLE_I,
    estimated,
    scenario_45,
)
from pointpred_observers.unknown_input.observer import UnknownInputObserver

IDENTITY = np.eye(6)
FED_FORWARD = "kalman-two-state"
DPI = 96.0
"""Image pixels are treated as pixels of a screen of this resolution, in which differentiators are tuned."""
GAPS = {"dpi": DPI, "gap_s": 2.0, "pause_s": 5.0}
"""Settings of all differentiators; the gaps (s) are long, so that missing images are bridged."""
CALM: dict[str, dict[str, Any]] = {
    "homogeneous": {"order": 3, "gain_lambda": 2.0, "gain_xi": 1.5, "alpha": -0.1, "step_s": 0.004},
    "kalman": {"jerk_density": 1e-3, "noise_m": 1e-3},
}
"""Settings for a camera at 33 images a second, the best of a small grid with 4 px of noise."""
WAYS = (*DIFFERENTIATORS, *(f"{name}, calm" for name in CALM), FED_FORWARD)
"""Methods for d: each differentiator, those tuned for a camera, the product's filter."""


def unknown_inputs(
    way: str, samples: CameraColumns, eta: FloatArray, focal_px: float, noise_px: float = 1.0
) -> FloatArray:
    """D = chi (v_x, v_y) at each row by (40), with any differentiator or by the product's filter.

    Without an image the last derivative is held; NaN before the first estimate.
    """
    if way == FED_FORWARD:
        return UnknownInputFilter(focal_px=focal_px, noise_px=noise_px).run(samples, eta)
    name, _, calm = way.partition(", ")
    kind: Any = DIFFERENTIATORS[name]
    stage = kind(**GAPS, **(CALM[name] if calm else {}))
    found, d = np.empty((len(samples), 2)), (np.nan, np.nan)
    for row, (one, value) in enumerate(zip(samples, eta.tolist(), strict=True)):
        if one.x == one.x and value == value:
            motion = stage.update(PointerEvent(one.t, one.x, one.y))
            scale = DPI / METRES_PER_INCH / focal_px if motion.settled else np.nan
            x, y = flow(one.x / focal_px, one.y / focal_px, value, one.wx, one.wy, one.wz)
            d = x - motion.vx * scale, y - motion.vy * scale
        found[row] = d
    return found


def transition(truth: Trajectory, row: int) -> FloatArray:
    """Phi from a row to the next one: (p, v) is linear, so it is exact except for the change of w."""
    h = float(truth.t[row + 1] - truth.t[row])
    rx, ry, rz = (0.5 * h * (truth.w[row] + truth.w[row + 1])).tolist()
    columns = IDENTITY.copy()
    for column in columns:
        kinematics.carry(column, h, (rx, ry, rz))
    return columns.T.copy()


def information(truth: Trajectory, row: int, variance: float) -> FloatArray:
    """The information of one image about (p, v): H' H / r at the truth."""
    x, y, z = truth.p[row]
    h = np.array([[1.0, 0.0, -x / z], [0.0, 1.0, -y / z]]) / z
    whole = np.zeros((6, 6))
    whole[:3, :3] = h.T @ h / variance
    return whole


def cramer_rao(
    truth: Trajectory,
    *,
    focal_px: float,
    noise_px: float,
    images: BoolArray | None = None,
    gyro_noise: float = 0.0,
    accel_noise: float = 0.0,
) -> FloatArray:
    """The least covariance of an unbiased estimate of (p, v) at each time, NaN while it is not determined.

    Assumes normal pixel noise of standard deviation ``noise_px``, no prior knowledge, and perfect inertial
    sensors unless their noise is passed. With noise that is not normal an estimator can be better.

    J <- (Phi J^-1 Phi' + Q)^-1 + H' H / r, with Phi J^-1 Phi' written as Phi^-T J Phi^-1 while Q is 0.

    Parameters: ``images``, the rows that have one, all by default. Returns (rows, 6, 6).
    Raises ParameterError for a noise that is not positive.

    Reference: Tichavsky, Muravchik, Nehorai 1998, equation (21); for Q = 0 Taylor 1979.
    """
    if not (noise_px > 0.0 and focal_px > 0.0):
        raise ParameterError(
            f"noise_px and focal_px must be positive, received {noise_px!r} and {focal_px!r}",
            field="focal_px" if noise_px > 0.0 else "noise_px",
            value=focal_px if noise_px > 0.0 else noise_px,
        )
    variance = (noise_px / focal_px) ** 2
    taken = np.ones(len(truth.t), np.bool_) if images is None else images
    j = np.zeros((6, 6))
    covariances = np.full((len(truth.t), 6, 6), np.nan)
    for row in range(len(truth.t)):
        if row:
            inverse = np.linalg.inv(transition(truth, row - 1))
            j = _less(inverse.T @ j @ inverse, truth, row, gyro_noise, accel_noise)
        if taken[row]:
            j = j + information(truth, row, variance)
        if np.linalg.cond(j) < 1e13:
            covariances[row] = np.linalg.inv(j)
    return covariances


def _less(j: FloatArray, truth: Trajectory, row: int, gyro_noise: float, accel_noise: float) -> FloatArray:
    """Information after the sensors' noise of one step: (J^-1 + Q)^-1 = J - J (J + Q^-1)^-1 J."""
    if gyro_noise == 0.0 and accel_noise == 0.0:
        return j
    h = float(truth.t[row] - truth.t[row - 1])
    flat, state = np.zeros(36), np.concatenate([truth.p[row], truth.v[row]])
    kinematics.add_noise(flat, state, gyro_noise**2 * h, accel_noise**2 * h)
    noise = flat.reshape(6, 6)
    lost = noise @ np.linalg.inv(IDENTITY + j @ noise) @ j
    less: FloatArray = j @ (IDENTITY - lost)
    return 0.5 * (less + less.T)


def normalised_errors(track: PointTrack, truth: Trajectory) -> FloatArray:
    """The normalised estimation error squared (NEES) of each row, NaN before the filter started.

    For a consistent filter it is chi-squared distributed with 6 degrees of freedom and has mean 6.

    Reference: Bar-Shalom, Li, Kirubarajan 2001, section 5.4.2.
    """
    errors = track.state - np.hstack([truth.p, truth.v])
    squares = np.full(len(errors), np.nan)
    for row in np.flatnonzero(track.running):
        squares[row] = errors[row] @ np.linalg.solve(track.covariance[row], errors[row])
    return squares


def consistent(track_errors: FloatArray, share: float = 0.95) -> tuple[float, tuple[float, float]]:
    """The mean of independent NEES values and the interval it should lie in with probability ``share``.

    ``track_errors``: one value per run, at the same time.
    """
    from scipy.stats import chi2

    runs = len(track_errors)
    low, high = (float(chi2.ppf(end, 6 * runs)) / runs for end in (0.5 - 0.5 * share, 0.5 + 0.5 * share))
    return float(np.mean(track_errors)), (low, high)


FOCAL, RATE_HZ = 800.0, 33.0


def residuals() -> Table:
    """How far printed equations are from the derivative of the trajectory, beside the corrected ones."""
    truth = trajectory(SCENARIOS["paper"], np.arange(331) / RATE_HZ)
    expected = printed.derivatives(truth)
    (x, y), (wx, wy, _), (vx, vy, _) = truth.image.T, truth.w.T, truth.v.T
    chi, eta = truth.chi, truth.eta
    corrected = truth.a[:, 2] * chi + wy * vx * chi - wx * vy * chi + eta**2 + truth.turn * eta
    system, point = camera_system(), {"w_x": 0.05, "w_y": -0.06}
    _, t = printed.decoupling_matrices(0.05, -0.06)
    least = float(np.linalg.eigvalsh(printed.P)[0])
    rows = [
        ("chi' in (12)", "right", _tiny(chi * (eta + y * wx - x * wy) - expected[:, 2])),
        ("chi' in (14)", _share(printed.chi_rate_14(truth) - expected[:, 2], expected[:, 2]), "as (12)"),
        (
            "eta' in (12), (14)",
            _share(printed.eta_rate_12(truth) - expected[:, 3], expected[:, 3]),
            _tiny(corrected - expected[:, 3]),
        ),
        ("T F, below (23)", _tiny(t @ system.f(point)), _tiny(system.t(point) @ system.f(point))),
        ("least eigenvalue of P, demanded >= 1e-12", f"{least:.2g}", "P >= I by scale"),
    ]
    return Table.of(("what", "largest error as printed", "corrected"), rows)


def asked() -> list[tuple[tuple[str, str], Box, float]]:
    """What is designed: ranges of eta at two thirds of the largest decay, or at 0.005 1/s.

    The bounds of eta and the decay in 1/s as the tables name them, the box, and the decay.
    """
    bounds = {"turn": (-0.02, 0.02), "a_z": (-0.1, 0.1), "w": (-0.06, 0.06), "dw": (-0.1, 0.1)}
    listed = []
    for eta in ((-2.0, -0.2), (-2.0, -0.05), (-2.0, -0.03), (-2.0, -0.015), (-0.4, 0.1)):
        decay = max(2.0 / 3.0 * -(eta[1] + 0.02), 0.005)
        listed.append(((f"[{eta[0]:g}, {eta[1]:g}]", f"{decay:.3g}"), camera_box(eta, **bounds), decay))
    return listed


def designs() -> Table:
    """What can be designed: certificates, and refusals."""
    rows = []
    for names, box, decay in asked():
        try:
            one = UnknownInputObserver.design(camera_system(), box, decay).certificate
            cells = (f"{one.largest_decay:.3g}", f"{one.phi1:.3g}", f"{one.phi2:.3g}", f"{one.margin:.1e}")
        except InfeasibleError as none:
            cells = ("none" if "no decay" in str(none) else "?", "refused", "-", "-")
        rows.append((*names, *cells))
    return Table.of(("eta 1/s", "decay 1/s", "largest", "phi1", "phi2 s", "margin"), rows)


def _share(error: Any, of: Any) -> str:
    """An error, and how large it is beside the largest value of what it is an error of."""
    return f"{_tiny(error)}, {np.abs(error).max() / np.abs(of).max():.0%} of the largest"


def _tiny(values: Any) -> str:
    return f"{np.abs(values).max():.2g}"


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
        d = unknown_inputs(way, samples, observer.eta, FOCAL_PX, filter_sigma(noise.noise_px))
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
    for noise_px, values in TABLE_I.items():
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
    keep("observers", parts, part="camera")
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
