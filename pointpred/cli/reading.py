"""What the command line can be told about foreign recordings, where their files do not say it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

import typer

from pointpred.errors import ParameterError

if TYPE_CHECKING:
    from pointpred.sources import Reading

PANEL = "For recordings in other formats"

Cut = Annotated[
    str | None,
    typer.Option(help="How to cut a stream into trials: clicks, bursts or whole.", rich_help_panel=PANEL),
]
PauseS = Annotated[
    float | None, typer.Option(help="A pause longer than this ends a burst, s (0.3).", rich_help_panel=PANEL)
]
Unit = Annotated[
    str | None, typer.Option(help="Unit of positions: pix, height, norm, cm or m.", rich_help_panel=PANEL)
]
Screen = Annotated[
    str | None, typer.Option(help="Size of the screen in px, as 1920x1080.", rich_help_panel=PANEL)
]
Cpi = Annotated[float | None, typer.Option(help="Counts per inch of the device.", rich_help_panel=PANEL)]
Dpi = Annotated[float | None, typer.Option(help="Pixels per inch of the screen (96).", rich_help_panel=PANEL)]


def reading(
    cut: str | None,
    pause_s: float | None,
    unit: str | None,
    screen: str | None,
    cpi: float | None,
    dpi: float | None,
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
    }
    return Reading(**{name: value for name, value in options.items() if value is not None})


def _size(text: str) -> tuple[float, float]:
    width, _, height = text.lower().partition("x")
    try:
        return float(width), float(height)
    except ValueError:
        raise ParameterError(f"screen must be WIDTHxHEIGHT in px, received {text!r}") from None
