"""``pointpred camera``: depth and velocity from one tracked point and an inertial sensor."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import Annotated, Any

import typer

from pointpred.cli.output_files import Force, Numbers, Seed, check_free, check_target, check_targets
from pointpred.console import counted, remarks
from pointpred.errors import ParameterError
from pointpred_observers.cli import answer, existing, option, write_table

app = typer.Typer(no_args_is_help=True)
Focal = Annotated[float, option("PX", "Focal length in px; there is no default.")]
Seen = Annotated[float, option("PX", "Noise of the point: uniform in +- this many px.")]
SMALLEST_PX = 0.05
"""The least noise the filter assumes: with none it would rely on its first image alone."""


@app.command()
def simulate(
    focal_px: Focal,
    scenario: Annotated[
        str, typer.Argument(help="paper, approaching, axial, rotating or stationary.")
    ] = "paper",
    out: Annotated[Path, option("FILE", "CSV file to write.")] = Path("camera.csv"),
    seconds: Annotated[float, typer.Option(help="Length, s.")] = 10.0,
    noise: Seen = 2.0,
    seed: Seed = 0,
    force: Force = False,
) -> None:
    """Write simulated data of a moving camera, and the true values to a second file (_truth).

    Columns: t; x and y in px from the principal point, empty without an image; wx wy wz in rad/s; ax ay az in
    m/s^2 of the motion in the camera's frame, gravity removed.

    Try:

      pointpred camera simulate --focal-px 800

      pointpred camera simulate rotating --focal-px 800 --out rotating.csv

      pointpred camera run camera.csv camera_truth.csv --focal-px 800 --plot camera.svg
    """
    from pointpred_observers.camera import SCENARIOS, CameraColumns, Noise
    from pointpred_observers.camera import simulate as make
    from pointpred_observers.cli.camera_files import TRUTH, truth_table

    if scenario not in SCENARIOS:
        raise ParameterError(f"SCENARIO must be one of {', '.join(SCENARIOS)}, received {scenario!r}")
    check_target(out)  # first: a folder has no name to make another of
    targets = (out, out.with_name(f"{out.stem}_truth{out.suffix}"))
    check_target(targets[1])
    for target in targets:
        check_free(target, force)
    blur = Noise(noise_px=noise)
    samples, truth = make(SCENARIOS[scenario], focal_px=focal_px, duration_s=seconds, noise=blur, seed=seed)
    write_table(out, CameraColumns.names, samples.table)
    write_table(targets[1], TRUTH, truth_table(truth))
    for target in targets:
        typer.echo(target)
    remarks().print(f"{counted(len(samples), 'sample')}, simulated: {scenario}")


@app.command()
def run(
    samples: Annotated[Path, existing("CSV of camera samples.")],
    focal_px: Focal,
    truth: Annotated[Path | None, existing("CSV with the true values, to be compared with.")] = None,
    start: Annotated[
        str, option("M[,M/S]", "Depth and forward velocity that the observer starts with.")
    ] = "1,0",
    up: Annotated[str | None, option("X,Y,Z|rest", "Remove gravity: up at first, or at rest.")] = None,
    noise: Seen = 2.0,
    plot: Annotated[Path | None, option("FILE", "SVG file to draw.")] = None,
    json: Numbers = None,
    force: Force = False,
) -> None:
    """Estimate depth and velocity: the unknown input observer, and a Kalman filter that uses the image.

    The observer's errors decay only while the camera moves away from the point; the last column shows where
    they do not: use the filter there. The filter gives no estimate until the images determine the depth;
    until then the observer is not checked, and a wrong start is not detected.

    What an accelerometer measures has gravity in it: --up removes it, turned on by the gyroscope; columns ux,
    uy, uz give the direction opposite to it at each row.

    Try:

      pointpred camera run camera.csv --focal-px 800 --start 1,-0.3

      pointpred camera run readings.csv --focal-px 620 --up rest --plot depth.svg
    """
    check_targets({"--plot": plot, "--json": json}, [samples] if truth is None else [samples, truth], force)
    from pointpred_observers.cli import camera_files as files

    estimates = _pipeline(focal_px, start, noise).run(files.read_samples(samples, up))
    truths = None if truth is None else files.read_truth(truth)
    errors = None if truths is None else files.errors_of(estimates, truths)
    if plot is not None:
        files.plot(estimates, truths, plot, f"{samples.name}, focal length {focal_px:g} px")
        remarks().print(f"{plot}")
    answer(json, partial(files.summary, estimates, errors), partial(files.show, estimates, errors))


def _pipeline(focal_px: float, start: str, noise: float) -> Any:
    from pointpred_observers.camera import CameraPipeline, DepthObserver, PointFilter

    whole = start if "," in start else f"{start},0"
    try:
        depth, vz = (float(part) for part in whole.split(","))
    except ValueError as unusable:
        needs = "a depth in m, or DEPTH,VELOCITY in m and m/s"
        raise ParameterError(f"--start needs {needs}, received {whole!r}") from unusable
    if not depth > 0.0:
        raise ParameterError(f"--start: the depth must be positive, received {depth:g}")
    if not noise >= 0.0:
        raise ParameterError(f"--noise must not be negative, received {noise:g}")
    deviation = max(noise / 3.0**0.5, SMALLEST_PX)
    observer = DepthObserver(focal_px=focal_px, start_chi=1.0 / depth, start_eta=vz / depth)
    peer = PointFilter(focal_px=focal_px, noise_px=deviation)
    return CameraPipeline(observer, peer, noise_px=deviation)
