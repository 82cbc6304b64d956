"""``pointpred study``: a study from its design to one recording of all participants."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from socket import socket
from typing import TYPE_CHECKING, Annotated

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
from pointpred.records import CPI
from pointpred_server.cli.serve import flags, open_port, settings_of
from pointpred_server.settings import Settings

if TYPE_CHECKING:
    from pointpred.studies.folder import Study

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
SERVED = ("host", "port", "allow_host", "trust_proxy")


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

    study = Study(design, folder)
    answer_study(study, settings, study.design.codes)


@app.command()
def run(
    design: Design,
    participant: Annotated[str, typer.Argument(metavar="PARTICIPANT", help="Who takes part: P01.")],
    folder: Folder = None,
    device: Annotated[
        str | None,
        typer.Option(
            metavar="NAME", help="Mouse to read, as for 'pointpred live'. Not given: the first that moves."
        ),
    ] = None,
    cpi: Annotated[
        float | None, typer.Option(min=CPI[0], max=CPI[1], help="Counts per inch of the mouse.")
    ] = None,
    port: Annotated[int | None, typer.Option(min=0, max=65535, help="Port; 0 takes any free one.")] = None,
) -> None:
    """Serve a study to one participant at this machine, and record their mouse as well.

    Beside the positions in the page, the counts that the mouse sends are kept at its own rate, marked by the
    same trials and conditions. 'pointpred study export' writes them as a recording of its own.

    Try:

      pointpred study run pointing.toml P01 --cpi 800
    """
    from pointpred.cli.counts_per_inch import counts_per_inch
    from pointpred.devices.selection import choose
    from pointpred.studies.folder import Study
    from pointpred.studies.mouse import MouseReader

    study = Study(design, folder)
    one = study.chosen(participant)
    settings = settings_of(host="127.0.0.1", port=port)
    with choose(device, remark) as source:
        one.mouse = mouse = MouseReader(source, counts_per_inch(source, cpi), remark)
        mouse.start()
        try:
            answer_study(study, settings, [one.code])
        finally:
            mouse.stop()
            remark(f"{counted(mouse.kept, 'event')} of the mouse kept, {source.clock}")


def answer_study(study: Study, settings: Settings, codes: Sequence[str]) -> None:
    """Serve a study until interrupted, and print the links of these participants."""
    from pointpred.recorder.recordings import prepare
    from pointpred_server.listening import serve as answer
    from pointpred_server.logs import set_up
    from pointpred_server.service import Service

    if prepare(study.folder):
        remark(f"others on this machine can look into {study.folder}: chmod 700 {study.folder}")
    settings = settings.guarded()
    set_up(settings.log_format)
    opened = open_port(settings)
    service = Service(settings)
    service.study = study
    address = public_address(settings, opened)

    def announce() -> None:
        links = study.links()
        for code in codes:
            typer.echo(f"{code} {address}study/{links[code]}")
        remark(f"Ready: give each participant a link. Data go into {study.folder}. Ctrl-C stops.")

    try:
        answer(opened, service, announce)
    except KeyboardInterrupt:
        remarks().print("stopped")


def public_address(settings: Settings, opened: socket) -> str:
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
    results().print(table(headings, cells, whole=("participant",), right=numbers))


@app.command()
def export(design: Design, out: Out, folder: Folder = None, force: Force = False) -> None:
    """Write all movements as one recording, a user each participant, and a table of the participants.

    'pointpred score' reads it without options; phase, block, distance, width, ... are conditions. The table
    beside it holds consent, device, screen and answers.

    Try:

      pointpred study export pointing.toml --out pointing_samples.parquet
    """
    from pointpred.studies.export import export as write_all
    from pointpred.studies.export import mice_beside, table_beside
    from pointpred.studies.folder import Study

    for file in (out, mice_beside(out)):
        check_recording(file, force)
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
