"""What the command line can be told about foreign recordings, where their files do not say it."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Sequence
from functools import wraps
from inspect import Parameter, Signature, signature
from pathlib import Path
from shutil import copyfileobj
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Annotated, Any, Literal, get_type_hints, overload

import typer

from pointpred.errors import ParameterError, PointpredError

if TYPE_CHECKING:
    from pointpred.cli.progress import Advance
    from pointpred.recording import Recording
    from pointpred.sources import Reading, StoredRecording

SAMPLE = "sample"
"""In the place of a file, unless there is one of that name: the embedded sample."""
PATTERN = re.compile(r"[*?\[]")
STDIN, SPOOLED = "-", "stdin"
PANEL = "For recordings in other formats"
TABLES = "For a table of your own"

Cut = Annotated[
    str | None,
    typer.Option(help="How to cut a stream into trials: clicks, bursts (at pauses of 0.3 s) or whole.", rich_help_panel=PANEL),
]
Cpi = Annotated[float | None, typer.Option(help="Counts per inch of the device.", rich_help_panel=PANEL)]
Dpi = Annotated[float | None, typer.Option(help="Pixels per inch of the screen (96).", rich_help_panel=PANEL)]
Target = Annotated[
    str | None,
    typer.Option(
        help="Selector of the element that is the goal, as '#left' (jsPsych).", rich_help_panel=PANEL
    ),
]
Columns = Annotated[
    str | None,
    typer.Option(
        metavar="t=NAME,x=NAME,y=NAME",
        help="Which column is which, by name or by place from 0; also user, trial, buttons, target_x, "
        "target_y, target_w, dx, dy. Not given: guessed from the usual names.",
        rich_help_panel=TABLES,
    ),
]
TimeUnit = Annotated[
    str | None,
    typer.Option(help="Unit of the column t: s, ms, us, ns, or iso (date and time).", rich_help_panel=TABLES),
]
YUp = Annotated[bool, typer.Option("--y-up", help="y grows upwards.", rich_help_panel=TABLES)]
PxPerUnit = Annotated[
    str | None,
    typer.Option(
        metavar="NUMBER",
        help="Pixels in one unit of x, y and the target (1); X,Y where they differ across and down.",
        rich_help_panel=TABLES,
    ),
]
Records = Annotated[
    str | None,
    typer.Option(help="Path to the rows in nested JSON, such as data.trials.", rich_help_panel=TABLES),
]


def check_exists(value: Any) -> Any:
    """A file or several as they were given; raises ParameterError for one that does not exist."""
    for file in value if isinstance(value, list) else [value]:
        if file is not None and not file.exists():
            raise ParameterError(f"no such file: {file}")
    return value


def as_given(text: str) -> Path | str:
    """One of the recordings given: a path, or an address as it was typed, which a path would change."""
    from pointpred.sources.files.addresses import address_in

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
        from pointpred.sources.files.addresses import local_copy

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
    from pointpred.sources.files.addresses import address_of

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
    from pointpred.sources import open_any, read_any

    try:
        return (open_any if stored else read_any)(file, options, progress)
    except PointpredError as error:
        error.args = (str(error).replace(str(file), shown(file)),)
        raise


def reading(
    cut: Cut = None,
    cpi: Cpi = None,
    dpi: Dpi = None,
    columns: Columns = None,
    time_unit: TimeUnit = None,
    y_up: YUp = False,
    px_per_unit: PxPerUnit = None,
    records: Records = None,
    target: Target = None,
) -> Reading:
    """The options as a ``Reading``; raises ParameterError."""
    from pointpred.sources import Reading
    from pointpred.sources.reading import columns_of, px_per_unit_of

    options: dict[str, Any] = {
        "cut": cut,
        "cpi": cpi,
        "dpi": dpi,
        "columns": None if columns is None else columns_of(columns),
        "time_unit": time_unit,
        "y_up": y_up,
        "px_per_unit": None if px_per_unit is None else px_per_unit_of(px_per_unit),
        "records": records,
        "target": target,
    }
    return Reading(**{name: value for name, value in options.items() if value is not None})


def options_in(reading: Reading) -> list[tuple[str, object]]:
    """The options that differ from their defaults, by the name of their parameter."""
    from pointpred.sources.reading import AS_IS

    values = [(name, getattr(reading, name)) for name in reading.__struct_fields__]
    return [(name, value) for name, value in values if value != getattr(AS_IS, name)]


def with_reading(command: Callable[..., None]) -> Callable[..., None]:
    """Give a command the options of ``reading``, and what they say as its parameter ``reading``.

    An option that the command declares itself, such as ``cpi``, is passed to both.
    """
    own = {name: one for name, one in _parameters(command).items() if name != "reading"}
    options = _parameters(reading)

    @wraps(command)
    def run(**arguments: Any) -> None:
        values = reading(**{name: arguments[name] for name in options})
        command(**{name: arguments[name] for name in own}, reading=values)

    # The interface of the command line is made from the signature and the annotations.
    shown = own | {name: one for name, one in options.items() if name not in own}
    run.__dict__["__signature__"] = Signature(list(shown.values()))
    run.__annotations__ = {name: one.annotation for name, one in shown.items()}
    return run


def _parameters(function: Callable[..., Any]) -> dict[str, Parameter]:
    """The parameters with their types, of which ``Reading`` is not looked up: its room is slow to load."""
    types = get_type_hints(function, localns={"Reading": object}, include_extras=True)
    return {name: one.replace(annotation=types[name]) for name, one in signature(function).parameters.items()}
