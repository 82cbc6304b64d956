"""What the command line can be told about foreign recordings, where their files do not say it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from pointpred.errors import ParameterError

if TYPE_CHECKING:
    from pointpred.cli.progress import Advance
    from pointpred.recording import Recording
    from pointpred.sources import Reading

SAMPLE = "sample"
"""In the place of a file, unless there is one of that name: the embedded sample."""
PANEL = "For recordings in other formats"

Cut = Annotated[
    str | None,
    typer.Option(help="How to cut a stream into trials: clicks, bursts or whole.", rich_help_panel=PANEL),
]
PauseS = Annotated[
    float | None, typer.Option(help="A pause longer than this ends a burst, s (0.3).", rich_help_panel=PANEL)
]
Unit = Annotated[
    str | None,
    typer.Option(help="Unit of positions: pix, height, norm, cm, m or deg.", rich_help_panel=PANEL),
]
Screen = Annotated[
    str | None, typer.Option(help="Size of the screen in px, as 1920x1080.", rich_help_panel=PANEL)
]
Cpi = Annotated[float | None, typer.Option(help="Counts per inch of the device.", rich_help_panel=PANEL)]
Dpi = Annotated[float | None, typer.Option(help="Pixels per inch of the screen (96).", rich_help_panel=PANEL)]
Target = Annotated[
    str | None,
    typer.Option(
        help="Selector of the element that is the goal, as '#left' (jsPsych).", rich_help_panel=PANEL
    ),
]


def there(given: Any) -> Any:
    """A file or several as they were given; raises ParameterError for one that does not exist."""
    for file in given if isinstance(given, list) else [given]:
        if file is not None and not file.exists():
            raise ParameterError(f"no such file: {file}")
    return given


def to_read(given: Any) -> Any:
    """The same for recordings, among which ``sample`` is the embedded one."""
    there([file for file in (given if isinstance(given, list) else [given]) if not is_sample(file)])
    return given


def is_sample(file: Path | None) -> bool:
    """Whether the embedded sample is meant."""
    return file is not None and str(file) == SAMPLE and not file.exists()


def recordings_in(file: Path, options: Reading, progress: Advance | None = None) -> list[Recording]:
    """The recordings of a file or folder, or the embedded sample; raises RecordingError.

    ``progress`` is called before each file of a folder.
    """
    if is_sample(file):
        from pointpred.datasets import sample

        return [sample()]
    from pointpred.sources import read_any

    return list(read_any(file, options, progress))


def reading(
    cut: str | None,
    pause_s: float | None,
    unit: str | None,
    screen: str | None,
    cpi: float | None,
    dpi: float | None,
    target: str | None = None,
) -> Reading:
    """The options given, as the sources want them; raises ParameterError."""
    from pointpred.sources import Reading

    size = None if screen is None else _size(screen)
    options: dict[str, Any] = {
        "cut": cut,
        "pause_s": pause_s,
        "unit": unit,
        "screen": size,
        "cpi": cpi,
        "dpi": dpi,
        "target": target,
    }
    return Reading(**{name: value for name, value in options.items() if value is not None})


def _size(text: str) -> tuple[float, float]:
    width, _, height = text.lower().partition("x")
    try:
        return float(width), float(height)
    except ValueError:
        raise ParameterError(f"screen must be WIDTHxHEIGHT in px, received {text!r}") from None
