"""The recordings that a command is given: what it is told about them, and each read under its own name."""

from __future__ import annotations

import math
import re
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from inspect import Parameter
from pathlib import Path
from shutil import copyfileobj
from tempfile import TemporaryDirectory
from typing import (
    TYPE_CHECKING,
    Annotated,
    Any,
    Literal,
    TypeVar,
    get_args,
    get_origin,
    get_type_hints,
    overload,
)

import msgspec
import typer

from pointpred.cli.options import option, with_options
from pointpred.console import remark, remarks
from pointpred.errors import ParameterError, PointpredError, RecordingError
from pointpred.recording import Recording, kinds_of
from pointpred.recordings.reading import Reading, columns_of, px_per_unit_of

if TYPE_CHECKING:
    from pointpred.cli.progress import Advance
    from pointpred.recordings import StoredRecording

SAMPLE = "sample"
"""In the place of a file, unless there is one of that name: the embedded sample."""
PATTERN = re.compile(r"[*?\[]")
STDIN, SPOOLED = "-", "stdin"
PANEL = "For recordings in other formats"
TABLES = "For a table of your own"

PARSED: dict[str, Callable[[str], Any]] = {"columns": columns_of, "px_per_unit": px_per_unit_of}
"""What reads the text of an option that is neither a word nor a number."""

Reasons = dict[str, str]
"""Files that could not be read and recordings that could not be scored, and why."""
Source = TypeVar("Source", "Recording", "Recording | StoredRecording")

SPEED = "1 as recorded, 2 twice as fast, max without waiting."
TRIAL = "USER-TRIAL, or its number counted from 1; repeatable. Not given: all."


def check_exists(value: Any) -> Any:
    """A file or several as they were given; raises ParameterError for one that does not exist."""
    for file in value if isinstance(value, list) else [value]:
        if file is not None and not file.exists():
            raise ParameterError(f"no such file: {file}")
    return value


def as_given(text: str) -> Path | str:
    """One of the recordings given: a path, or an address as it was typed, which a path would change."""
    from pointpred.recordings.addresses import address_in

    return address_in(text) or Path(text)


def to_read(context: typer.Context, value: Any) -> Any:
    """The recordings given: ``sample`` is the embedded one, ``-`` stdin, a pattern all files that fit it.

    What lies at an address is copied to this machine first.
    """
    if value is None:
        return None
    names = value if isinstance(value, list) else [value]
    files = [file for one in names for file in _matches(context, one)]
    check_exists([file for file in files if not is_sample(file)])
    if isinstance(value, list):
        return files
    if len(files) != 1:
        raise ParameterError(f"{value} names {len(files)} files, expected one")
    return files[0]


def _matches(context: typer.Context, value: Path | str) -> list[Path]:
    """The files that are meant by one argument; raises ParameterError where no file matches a pattern."""
    if str(value) == STDIN:
        return [_save_stdin(context)]
    if isinstance(value, str):
        from pointpred.recordings.addresses import local_copy

        return [local_copy(value)]
    if value.exists() or not PATTERN.search(str(value)):
        return [value]
    files = sorted(Path(value.anchor).glob(str(value.relative_to(value.anchor))))
    if not files:
        raise ParameterError(f"no file matches {value}")
    return files


def _save_stdin(context: typer.Context) -> Path:
    """What comes by stdin as a file, which is deleted when the command ends."""
    folder = context.with_resource(TemporaryDirectory(prefix="pointpred-"))
    path = Path(folder, SPOOLED)
    with path.open("wb") as file:
        copyfileobj(sys.stdin.buffer, file)
    return path


def shown(file: Path) -> str:
    """How messages name a file: what came by stdin is ``-``."""
    from pointpred.recordings.addresses import address_of

    if address := address_of(file):
        return address
    spooled = file.name == SPOOLED and file.parent.name.startswith("pointpred-")
    return STDIN if spooled else str(file)


def is_sample(file: Path | None) -> bool:
    """Whether the embedded sample is meant."""
    return file is not None and str(file) == SAMPLE and not file.exists()


@overload
def recordings_in(
    file: Path, options: Reading, progress: Advance | None = None, *, stored: Literal[False] = False
) -> list[Recording]: ...


@overload
def recordings_in(
    file: Path, options: Reading, progress: Advance | None = None, *, stored: Literal[True]
) -> list[Recording | StoredRecording]: ...


def recordings_in(
    file: Path, options: Reading, progress: Advance | None = None, *, stored: bool = False
) -> Sequence[Recording | StoredRecording]:
    """The recordings of a file or folder, or the embedded sample; raises RecordingError.

    ``progress`` is called before each file of a folder. ``stored``: long files are not read into memory.
    """
    if is_sample(file):
        from pointpred.datasets import sample

        return [sample()]
    from pointpred.recordings import open_any, read_any

    try:
        return (open_any if stored else read_any)(file, options, progress)
    except PointpredError as error:
        error.args = (str(error).replace(str(file), shown(file)),)
        raise


def reading(**options: Any) -> Reading:
    """The options that are given as a ``Reading``; raises ParameterError."""
    given = {name: value for name, value in options.items() if value is not None}
    return Reading(
        **{name: PARSED[name](value) if name in PARSED else value for name, value in given.items()}
    )


def _options() -> Iterator[Parameter]:
    """The fields of a ``Reading`` that a command can be told."""
    for name, annotated in get_type_hints(Reading, include_extras=True).items():
        if get_origin(annotated) is not Annotated:
            continue
        kind, about = get_args(annotated)
        flag = kind is bool
        value: Any = float if float in (kind, *get_args(kind)) and name not in PARSED else str
        yield option(
            name,
            bool if flag else value | None,
            False if flag else None,
            help=about.description,
            metavar=about.extra["metavar"],
            rich_help_panel=TABLES if about.extra["table"] else PANEL,
        )


with_reading = with_options("reading", _options(), reading)
"""Gives a command the options of a ``Reading``, and what they say as its parameter ``reading``."""


def in_memory(files: list[Path], reading: Reading, reasons: Reasons) -> Iterator[Recording]:
    """The recordings of files, so that only one is in memory; complains where a file cannot be read."""
    return _named(files, lambda file: recordings_in(file, reading), reasons)


def in_memory_or_stored(
    files: list[Path], reading: Reading, reasons: Reasons
) -> Iterator[Recording | StoredRecording]:
    """The same, but long files of pointpred's own stay where they are."""
    return _named(files, lambda file: recordings_in(file, reading, stored=True), reasons)


def _named(
    files: list[Path], open_one: Callable[[Path], Sequence[Source]], reasons: Reasons
) -> Iterator[Source]:
    names: dict[str, Path] = {}
    for file in files:
        try:
            for recording in open_one(file):
                name = _free_name(recording.name, file, names)
                if name != recording.name:
                    first = shown(names[recording.name])
                    note = f"{shown(file)} is called {name!r} here: {recording.name!r} is {first}"
                    remark(note)
                names[name] = file
                yield _called(recording, name)
        except (PointpredError, OSError) as error:
            leave_out(reasons, shown(file), error)


def _called(recording: Source, name: str) -> Source:
    if isinstance(recording, Recording):
        return msgspec.structs.replace(recording, name=name)
    about = msgspec.structs.replace(recording.about, name=name)
    return msgspec.structs.replace(recording, about=about)


def _free_name(name: str, file: Path, names: Mapping[str, Path]) -> str:
    """A name that no other recording has: with its folder before it where it is taken, then with a number."""
    free, count = name, 1
    while free in names:
        folder = file.absolute() if file.is_dir() else file.absolute().parent
        free = f"{folder.name}/{name}" + f"_{count}" * (count > 1)
        count += 1
    return free


def leave_out(reasons: Reasons, name: str, error: Exception) -> None:
    """Complain about a file that cannot be read or a recording that cannot be scored, and remember it."""
    expected = isinstance(error, PointpredError | OSError)
    reason = str(error) if expected else f"{type(error).__name__}: {error}"
    reasons[name] = reason
    message = reason if name in reason else f"{name}: {reason}"
    remarks().print(f"left out: {message}", style="red")


def one_recording(file: Path | None, reading: Any) -> Recording:
    """The recording to play; the embedded sample where no file is named."""
    if file is None:
        from pointpred.datasets import sample

        remarks().print("No recording given: playing the embedded sample of simulated people.")
        return sample()
    from pointpred.cli.progress import following

    with following() as progress:
        recordings = recordings_in(file, reading, progress)
    if len(recordings) != 1:
        raise RecordingError(f"{file} holds {len(recordings)} recordings; name a file with one")
    return recordings[0]


def speed_of(text: str) -> float:
    """A number above 0, or infinity for ``max``; raises ParameterError."""
    try:
        value = math.inf if text == "max" else float(text)
    except ValueError:
        value = math.nan
    if not value > 0.0:
        raise ParameterError(f"speed must be a positive number or 'max', received {text!r}")
    return value


def print_skipped(skips: tuple[Any, ...]) -> None:
    """Say which trials are left out, and why; those of one kind in one line."""
    for kind, some in kinds_of(skips):
        first = f"{some[0].user}-{some[0].trial}"
        words = (
            f"left out: {first} {kind}"
            if len(some) == 1
            else f"left out {len(some)}: {kind} (first: {first})"
        )
        remarks().print(words, style="red")
