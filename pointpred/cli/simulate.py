"""``pointpred simulate``: a recording of simulated people."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from pointpred.cli.output_files import Force, Out, check_recording
from pointpred.console import counted, remarks


def simulate(
    out: Out = Path("simulated_samples.parquet"),
    people: Annotated[int, typer.Option(help="How many people, from novices to experts.")] = 10,
    seed: Annotated[int, typer.Option(help="Seed; the same seed gives the same file.")] = 0,
    trials: Annotated[
        int | None,
        typer.Option(help="Movements in each circle, at most 12 (12); of each person on a desktop (120)."),
    ] = None,
    desktop: Annotated[
        str | None,
        typer.Option(help="Instead of circles, work on a desktop: steady, moved, habits, menus or windows."),
    ] = None,
    force: Force = False,
) -> None:
    """Write a recording of simulated people pointing at targets on a circle, or working on a desktop.

    On circles, each person does 2 distances x 2 widths x 2 transfer functions. On a desktop, each person
    returns to controls as habits say; after half of the movements the window moves (moved) or the habits
    change (habits). The trials file names window, control and change. Both are at 1 kHz with
    2000 counts per inch. The recording is marked as simulated, and so is every score of it.

    Try:

      pointpred simulate

      pointpred simulate --people 20 --seed 7 --out simulated_20_samples.csv

      pointpred simulate --desktop moved --out moved_samples.parquet

      pointpred simulate --force && pointpred score simulated_samples.parquet
    """
    check_recording(out, force)
    from pointpred.recordings import write
    from pointpred.simulation import people as persons
    from pointpred.simulation import simulate_circle, simulate_desktop

    name, somebody = out.stem.removesuffix("_samples"), persons(people, seed)
    if desktop is None:
        recording = simulate_circle(somebody, seed=seed, trials=12 if trials is None else trials, name=name)
    else:
        movements = 120 if trials is None else trials
        recording = simulate_desktop(somebody, desktop, seed=seed, movements=movements, name=name).recording
    for file in write(recording, out):
        typer.echo(file)
    trials_done, events = counted(len(recording.trials), "trial"), counted(len(recording.events), "event")
    remarks().print(f"{trials_done}, {events}, simulated")
