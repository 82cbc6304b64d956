"""The counts per inch of a mouse: given, measured with a ruler, or asked for."""

from __future__ import annotations

import sys

import typer

from pointpred.console import remarks
from pointpred.devices.resolution import measure
from pointpred.devices.source import DeviceSource
from pointpred.errors import ParameterError
from pointpred.records import CPI

DISTANCE_CM = 10.0
QUESTION = "Counts per inch of the mouse (on its box; m: measure it; -: unknown)"


def counts_per_inch(source: DeviceSource, cpi: float | None, measured: bool) -> float | None:
    """Counts per inch: given, measured with the open source, or asked for where somebody can answer."""
    if cpi is not None and measured:
        raise ParameterError("give either --cpi or --measure-cpi", field="cpi")
    if cpi is None and not measured and sys.stdin.isatty() and sys.stdout.isatty():
        answer = typer.prompt(QUESTION, value_proc=_cpi)
        measured, cpi = answer == "m", answer if isinstance(answer, float) else None
    if measured:
        return _measured(source)
    if cpi is None:
        remarks().print("no --cpi: one count counts as one px, and speeds of the hand are guesses")
    return cpi


def _cpi(answer: str) -> float | str:
    """An answer to the question."""
    answer = answer.strip()
    if answer in ("m", "-"):
        return answer
    try:
        value = float(answer)
    except ValueError:
        raise typer.BadParameter(f"expected a number, m or -, received {answer!r}") from None
    if not CPI[0] <= value <= CPI[1]:
        raise typer.BadParameter(f"must lie in [{CPI[0]:g}, {CPI[1]:g}], received {value:g}")
    return value


def _measured(source: DeviceSource) -> float:
    remarks().print(
        f"Put the mouse against a ruler, move it {DISTANCE_CM:g} cm in a straight line, then hold it still "
        "for a second."
    )
    resolution = measure(source, DISTANCE_CM)
    remarks().print(
        f"{resolution.counts:.0f} counts over {DISTANCE_CM:g} cm: {resolution.cpi:.0f} CPI, within about 3 %"
    )
    if not resolution.straight:
        remarks().print(
            f"the path was {resolution.bent:.2f} times as long as a straight line: better measure again"
        )
    return resolution.cpi
