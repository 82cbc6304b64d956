"""``pointpred simulate`` and ``pointpred convert``: recordings from nothing, and from other formats."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from pointpred.cli.reading import recordings_in, to_read, with_reading
from pointpred.cli.screen import check_target
from pointpred.console import counted, remarks
from pointpred.errors import ParameterError, RecordingError

if TYPE_CHECKING:
    from pointpred.sources import Reading

Out = Annotated[Path, typer.Option(metavar="FILE", help="Samples file to write: .parquet or .csv.")]
Force = Annotated[bool, typer.Option("--force", help="Replace files that exist.")]


def simulate(
    out: Out = Path("simulated_samples.parquet"),
    people: Annotated[int, typer.Option(help="How many people, from novices to experts.")] = 10,
    seed: Annotated[int, typer.Option(help="Seed; the same seed gives the same file.")] = 0,
    trials: Annotated[int, typer.Option(help="Movements in each circle, at most 12.")] = 12,
    force: Force = False,
) -> None:
    """Write a recording of simulated people pointing at targets on a circle.

    Each person does 2 distances x 2 widths x 2 transfer functions, at 1 kHz with 2000 counts per inch. The
    recording is marked as simulated, and so is every score of it.

    Try:

      pointpred simulate

      pointpred simulate --people 20 --seed 7 --out simulated_20_samples.csv

      pointpred simulate --force && pointpred score simulated_samples.parquet
    """
    _check(out, force)
    from pointpred.simulation import people as persons
    from pointpred.simulation import simulate_circle
    from pointpred.sources import write

    name = out.stem.removesuffix("_samples")
    recording = simulate_circle(persons(people, seed), seed=seed, trials=trials, name=name)
    for file in write(recording, out):
        typer.echo(file)
    trials_done, events = counted(len(recording.trials), "trial"), counted(len(recording.events), "event")
    remarks().print(f"{trials_done}, {events}, simulated")


@with_reading
def convert(
    source: Annotated[
        Path, typer.Argument(callback=to_read, help="A file in any format pointpred reads, or a folder.")
    ],
    out: Out,
    force: Force = False,
    *,
    reading: Reading,
) -> None:
    """Convert a recording to pointpred's own format, and list what was skipped and why.

    Knows GoFitts, Balabit and SapiMouse, jsPsych, OpenSesame mousetrap, PsychoPy, evemu, evtest, libinput
    record, hid-recorder, the Pointing Dynamics Dataset, its own Parquet and CSV, and any table of samples.
    The format is recognised by the file's content.

    Try:

      pointpred convert block.sd3 --out block_samples.parquet

      pointpred convert mouse.evemu --cut bursts --cpi 1600 --out mouse_samples.parquet

      pointpred convert my.csv --columns t=time,x=px,y=py --time-unit ms --out my_samples.csv

      pointpred convert psychopy_data.csv --unit height --screen 1920x1080 --out psychopy_samples.csv
    """
    _check(out, force or source.is_dir())
    from pointpred.sources import write_recordings

    told = write_recordings(recordings_in(source, reading), out, replace=force)
    for file in told.files:
        typer.echo(file)
    screen_out = remarks()
    screen_out.print(
        f"kept {counted(told.trials, 'trial')} of {counted(told.users, 'user')}, {counted(told.rows, 'row')}"
    )
    for reason, count in told.skipped.items():
        screen_out.print(f"skipped {count}: {reason}", markup=False)
    for note in told.notes:
        screen_out.print(note, markup=False)
    if not told.trials:
        raise RecordingError(f"{source}: no trial could be read; see the reasons above")


def _check(out: Path, force: bool) -> None:
    """Raise ParameterError before any work where the result could not be written, or not without --force."""
    check_target(out)
    from pointpred.sources.own import recordings

    if out.suffix not in recordings.EXTENSIONS:
        raise ParameterError(
            f"--out {out}: cannot write {out.suffix or 'no extension'}, expected .parquet or .csv"
        )
    if not force:
        recordings.check_free(out)
