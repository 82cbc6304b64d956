"""``pointpred recordings``: list and delete the sessions that the service has recorded."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import msgspec
import typer

from pointpred.cli.output_files import AsJson, print_json
from pointpred.console import counted, remark, remarks, results, table
from pointpred.errors import ParameterError

if TYPE_CHECKING:
    from pointpred.recorder.recordings import Recorded

app = typer.Typer(no_args_is_help=True)

Folder = Annotated[
    Path | None,
    typer.Option(
        metavar="FOLDER", envvar="POINTPRED_RECORD", file_okay=False, help="Folder of the recordings."
    ),
]


class RecordingRow(msgspec.Struct, frozen=True):
    """A recorded session in the JSON of ``list``."""

    name: str
    begun: str
    events: int
    trials: int
    skipped: int
    bytes: int
    files: list[str]
    notes: tuple[str, ...]
    problem: str | None


@app.command("list")
def list_recordings(
    folder: Folder = None,
    as_json: AsJson = False,
) -> None:
    """List the recorded sessions: when they began, events, trials, size on disk.

    Trials are those that 'pointpred score' would find; a session without marks is cut at clicks.

    Try:

      pointpred recordings list --folder kept

      pointpred recordings list --folder kept --json | jq '.recordings[].name'
    """
    from pointpred.recorder.recordings import listing

    recordings = listing(_chosen(folder))
    if as_json:
        rows = [
            RecordingRow(
                one.name,
                one.begun.isoformat(),
                one.events,
                one.trials,
                one.skipped,
                one.size,
                [str(path) for path in one.files],
                one.notes,
                one.problem,
            )
            for one in recordings
        ]
        print_json("recordings", rows)
    elif recordings:
        _show(recordings)
    else:
        remark(f"nothing is recorded in {_chosen(folder)}")


@app.command("delete")
def delete_recordings(
    names: Annotated[
        list[str] | None, typer.Argument(metavar="NAME...", help="Names from 'pointpred recordings list'.")
    ] = None,
    folder: Folder = None,
    everything: Annotated[bool, typer.Option("--all", help="Delete every recording in the folder.")] = False,
    force: Annotated[bool, typer.Option("--force", help="Do not ask for confirmation.")] = False,
) -> None:
    """Delete recorded sessions and all their files. This cannot be undone.

    Only files written by the recorder are deleted. A session in progress loses what was written so far and
    is no longer recorded.

    Try:

      pointpred recordings delete 20260102T030405Z-k3x9 --folder kept

      pointpred recordings delete --all --folder kept
    """
    from pointpred.recorder.recordings import delete, listing

    chosen = _chosen(folder)
    if everything == bool(names):
        raise ParameterError("name the recordings to delete, or give --all, not both")
    there = {one.name: one for one in listing(chosen, counted=False)}
    wanted = list(there) if everything else list(dict.fromkeys(names or ()))
    size = sum(there[name].size for name in wanted if name in there)
    if not wanted:
        remark(f"nothing is recorded in {chosen}")
        return
    present = all(name in there for name in wanted)
    many = counted(len(wanted), "recording")
    if present and not force and not _sure(f"Delete {many} ({_size(size)}) in {chosen}?"):
        remarks().print("nothing was deleted")
        raise typer.Exit(1)
    gone = delete(chosen, wanted)
    remark(f"deleted {counted(len(gone), 'recording')}, {_size(size)}")


def _chosen(folder: Path | None) -> Path:
    if folder is None:
        raise ParameterError("name the folder with --folder or in POINTPRED_RECORD")
    return folder


def _sure(question: str) -> bool:
    """Whether a user at the terminal confirms."""
    try:
        return typer.confirm(question, err=True)
    except typer.Abort:
        return False


def _show(recordings: list[Recorded]) -> None:
    numbers = ("events", "trials", "skipped", "size")
    rows = []
    for one in recordings:
        counts = (str(one.events), str(one.trials), str(one.skipped)) if one.problem is None else ("-",) * 3
        notes = one.problem or "; ".join(one.notes)
        rows.append((one.name, f"{one.begun:%Y-%m-%d %H:%M:%S}", *counts, _size(one.size), notes))
    headings = ("name", "begun (UTC)", *numbers, "remark")
    results().print(table(headings, rows, whole=("name",), right=numbers))


def _size(size: float) -> str:
    """Bytes as people read them."""
    for unit in ("B", "kB", "MB"):
        if size < 1000:
            return f"{size:.0f} {unit}" if unit == "B" else f"{size:.1f} {unit}"
        size /= 1000
    return f"{size:.1f} GB"
