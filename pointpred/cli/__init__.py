"""The command line: the one place that joins sources, predictors, scoring and the server."""

from __future__ import annotations

import sys
from typing import NoReturn

INTERRUPTED = 130
"""The exit code after Ctrl-C."""


def main(arguments: list[str] | None = None) -> NoReturn:
    """Run the command line as ``pointpred.cli.app.main`` does, also where Ctrl-C comes while it loads."""
    try:
        from pointpred.cli.app import main as run

        run(arguments)
    except KeyboardInterrupt:
        sys.stderr.write("pointpred: interrupted\n")
        sys.exit(INTERRUPTED)


__all__ = ["main"]
