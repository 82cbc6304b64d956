"""``pointpred simulate``: a recording of simulated people."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from pointpred.cli.output_files import Force, Out, Seed, check_recording
from pointpred.console import counted, remarks


def simulate(
    out: Out = Path("simulated_samples.parquet"),
    people: Annotated[int, typer.Option(help="How many people, from novices to experts.")] = 10,
    seed: Seed = 0,
    trials: Annotated[int, typer.Option(help="Movements in each circle, at most 12.")] = 12,
    force: Force = False,
) -> None:
    """Write a recording of simulated people pointing at targets on a circle.

    Each person does 2 distances x 2 widths x 2 transfer functions, at 1 kHz with 2000 counts
    per inch. The recording is marked as simulated, and so is every score of it.

    Try:

      pointpred simulate

      pointpred simulate --people 20 --seed 7 --out simulated_20_samples.csv

      pointpred simulate --force && pointpred score simulated_samples.parquet
    """
    check_recording(out, force)
    from pointpred.recordings import write
    from pointpred.simulation import people as persons
    from pointpred.simulation import simulate_circle

    name, somebody = out.stem.removesuffix("_samples"), persons(people, seed)
    recording = simulate_circle(somebody, seed=seed, trials=trials, name=name)
    for file in write(recording, out):
        typer.echo(file)
    trials_done, events = counted(len(recording.trials), "trial"), counted(len(recording.events), "event")
    remarks().print(f"{trials_done}, {events}, simulated")
