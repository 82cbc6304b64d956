"""``pointpred convert``: recordings of other formats in pointpred's own."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from pointpred.cli.output_files import Force, Out, check_recording
from pointpred.cli.reading_options import as_given, is_sample, recordings_in, to_read, with_reading
from pointpred.console import counted, remarks
from pointpred.errors import RecordingError
from pointpred.recordings.reading import People, Reading


@with_reading
def convert(
    sources: Annotated[
        list[Path],
        typer.Argument(
            callback=to_read, parser=as_given, help="Files in any format pointpred reads, or folders."
        ),
    ],
    out: Out,
    join: Annotated[
        People | None,
        typer.Option(
            metavar="file|folder|column",
            help="Make one set of all files, a person each: named by the file, its folder, or its users.",
        ),
    ] = None,
    force: Force = False,
    *,
    reading: Reading,
) -> None:
    """Convert recordings to pointpred's own format, and list what was skipped and why.

    Reads GoFitts, Balabit and SapiMouse, jsPsych, rrweb, OpenSesame mousetrap, PsychoPy, pynput, evemu,
    evtest, getevent, libinput record and debug-events, hid-recorder, the Pointing Dynamics Dataset, its own
    Parquet and CSV, and any table of samples.
    The format is recognised by the file's content.

    Try:

      pointpred convert block.sd3 --out block_samples.parquet

      pointpred convert mouse.evemu --cut bursts --cpi 1600 --out mouse_samples.parquet

      pointpred convert my.csv --columns t=time,x=px,y=py --time-unit ms --out my_samples.csv

      pointpred convert psychopy_data.csv --px-per-unit 1080 --out psychopy_samples.csv

      pointpred convert p*.csv --join file --out study_samples.parquet
    """
    check_recording(out, force or (join is None and (len(sources) > 1 or sources[0].is_dir())))
    from pointpred.datasets.embedded import FILE
    from pointpred.recordings import read_any, write_recordings

    if join is None:
        recordings = [one for source in sources for one in recordings_in(source, reading)]
    else:
        files = [FILE if is_sample(source) else source for source in sources]
        recordings = read_any(files, reading, people=join)
    summary = write_recordings(recordings, out, replace=force)
    for file in summary.files:
        typer.echo(file)
    screen_out = remarks()
    trials, users = counted(summary.trials, "trial"), counted(summary.users, "user")
    screen_out.print(f"kept {trials} of {users}, {counted(summary.rows, 'row')}")
    for reason, count in summary.skipped.items():
        screen_out.print(f"skipped {count}: {reason}")
    for note in summary.notes:
        screen_out.print(note)
    if any(reason.startswith("time goes backwards") for reason in summary.skipped):
        screen_out.print("--sort keeps such trials: it sorts their samples by time")
    if not summary.trials:
        names = ", ".join(map(str, sources))
        raise RecordingError(f"{names}: no trial could be read; see the reasons above")
