"""``pointpred demo``: the live page as files for any static host."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from pointpred.cli.output_files import Force
from pointpred.console import remarks
from pointpred.errors import ParameterError


def demo(
    out: Annotated[
        Path, typer.Option(metavar="FOLDER", help="Folder to write to; created if missing.")
    ] = Path("demo"),
    force: Force = False,
) -> None:
    """Write the live page as files that any static host can serve, under any path.

    The page predicts by itself: Live, Circle, Replay of a file, Assist. It needs no service and sends nothing
    anywhere. A browser does not load it from the disk: it must be served.

    Try:

      pointpred demo

      pointpred demo --out public/pointing --force

      pointpred demo && python -m http.server --directory demo
    """
    if out.is_dir() and any(out.iterdir()) and not force:
        raise ParameterError(f"{out} holds files already; add --force to replace those of the same names")
    if out.exists() and not out.is_dir():
        raise ParameterError(f"cannot write into {out}: it is not a folder; name another one")
    from pointpred_server.demo import write_demo

    out.mkdir(parents=True, exist_ok=True)
    write_demo(out)
    typer.echo(out / "index.html")
    remarks().print(f"to look at it: python -m http.server --directory {out}")
