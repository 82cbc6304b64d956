"""``pointpred study``: a study from its design to one recording of all participants."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from pointpred.cli.options import with_options
from pointpred.cli.output_files import (
    AsJson,
    Force,
    Out,
    check_free,
    check_recording,
    check_target,
    print_json,
)
from pointpred.console import counted, remark, remarks, results, table
from pointpred.errors import ParameterError, RecordingError
from pointpred_server.cli.serve import flags, open_port, settings_of
from pointpred_server.settings import Settings

app = typer.Typer(no_args_is_help=True)

Design = Annotated[Path, typer.Argument(metavar="FILE", help="The design, from 'pointpred study new'.")]
Folder = Annotated[
    Path | None,
    typer.Option(
        metavar="FOLDER",
        file_okay=False,
        help="Folder of the data. Not given: beside the design, with its name.",
    ),
]
SERVED = ("host", "port", "allow_host", "allow_origin", "trust_proxy")


@app.command()
def new(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="TOML file to write.")],
    force: Force = False,
) -> None:
    """Write a design to start from, which explains every field.

    Try:

      pointpred study new pointing.toml
    """
    from pointpred.files import write_whole
    from pointpred.studies.design import TEMPLATE, design_of

    check_target(file)
    if file.suffix != ".toml":
        raise ParameterError(f"{file}: a design is a TOML file; name it {file.stem}.toml", field="file")
    check_free(file, force, "FILE")
    name = "".join(c if c.isascii() and (c.isalnum() or c in "-_") else "-" for c in file.stem)[:40]
    text = TEMPLATE.format(file=file, name=name if name[:1].isalpha() else "study")
    design_of(text)
    write_whole(file, text.encode())
    typer.echo(file)


@app.command()
@with_options("settings", flags(SERVED), settings_of)
def serve(design: Design, folder: Folder = None, *, settings: Settings) -> None:
    """Serve a study; prints a link for each participant.

    A link is a secret: whoever has it takes part as this participant. Everything is saved as it goes. A
    participant who opens the link again goes on where they were, also after a crash of this command.

    Try:

      pointpred study serve pointing.toml

      pointpred study serve pointing.toml --port 9000 --host 0.0.0.0 --allow-host lab.example
    """
    from pointpred.studies.folder import Study
    from pointpred_server.listening import serve as answer
    from pointpred_server.logs import set_up
    from pointpred_server.service import Service

    study = Study(design, folder)
    settings = settings.guarded()
    set_up(settings.log_format)
    opened = open_port(settings)
    service = Service(settings)
    service.study = study
    address = public_address(settings, opened)

    def announce() -> None:
        for code, link in study.links().items():
            typer.echo(f"{code} {address}study/{link}")
        remark(f"Ready: give each participant a link. Data go into {study.folder}. Ctrl-C stops.")

    try:
        answer(opened, service, announce)
    except KeyboardInterrupt:
        remarks().print("stopped")


def public_address(settings: Settings, opened: Any) -> str:
    """The address that participants open: the first further host name, where there is one."""
    from pointpred_server.listening import address

    own = address(settings.host, opened)
    if not settings.allow_host:
        return own
    if settings.trust_proxy:
        return f"https://{settings.allow_host[0]}/"
    return f"http://{settings.allow_host[0]}:{opened.getsockname()[1]}/"


@app.command()
def status(design: Design, folder: Folder = None, as_json: AsJson = False) -> None:
    """How far each participant is; with --json also their links.

    Try:

      pointpred study status pointing.toml

      pointpred study status pointing.toml --json | jq '.participants[] | select(.state == "done")'
    """
    from pointpred.studies.export import status as progress
    from pointpred.studies.folder import Study

    rows = progress(Study(design, folder))
    if as_json:
        print_json("participants", rows)
        return
    cells = [
        (
            one.participant,
            one.state,
            f"{one.movements} of {one.planned}",
            str(one.missed),
            one.agreed_at or "-",
        )
        for one in rows
    ]
    numbers = ("movements", "missed")
    headings = ("participant", "state", "movements", "missed", "agreed (UTC)")
    results().print(table(headings, cells, whole=("participant",), right=numbers), markup=False)


@app.command()
def export(design: Design, out: Out, folder: Folder = None, force: Force = False) -> None:
    """Write all movements as one recording, a user each participant, and a table of the participants.

    'pointpred score' reads it without options; phase, block, distance, width, ... are conditions. The table
    beside it holds consent, device, screen and answers.

    Try:

      pointpred study export pointing.toml --out pointing_samples.parquet
    """
    from pointpred.studies.export import export as write_all
    from pointpred.studies.export import table_beside
    from pointpred.studies.folder import Study

    check_recording(out, force)
    check_free(table_beside(out), force)
    study = Study(design, folder)
    if not any(one.about for one in study.participants.values()):
        raise RecordingError(f"{study.folder}: nobody has taken part yet, nothing to export")
    written = write_all(study, out)
    for recording, file in written:
        typer.echo(file)
        people = len({trial.user for trial in recording.trials})
        remark(f"kept {counted(len(recording.trials), 'movement')} of {counted(people, 'participant')}")
        for skip in recording.skipped:
            remark(f"skipped: {skip.place}: {skip.reason}")
    typer.echo(table_beside(out))


@app.command()
def delete(
    design: Design,
    participants: Annotated[list[str], typer.Argument(metavar="PARTICIPANT...", help="Such as P03.")],
    folder: Folder = None,
    force: Annotated[bool, typer.Option("--force", help="Do not ask for confirmation.")] = False,
) -> None:
    """Delete all that is kept of a participant. This cannot be undone.

    The link stops to work, and the participant has a new one. Exported files are not touched.

    Try:

      pointpred study delete pointing.toml P03
    """
    from pointpred.studies.folder import Study

    study = Study(design, folder)
    chosen = [study.chosen(code).code for code in participants]
    if not force and not typer.confirm(f"Delete all of {', '.join(chosen)} in {study.folder}?", err=True):
        remark("nothing was deleted")
        raise typer.Exit(1)
    for code in chosen:
        remark(f"deleted {counted(study.delete(code), 'file')} of {code}; a new link is ready for {code}")
