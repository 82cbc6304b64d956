"""Arguments of what measures, read before anything is done."""

from __future__ import annotations

import argparse
from collections.abc import Sequence


def parse(
    doc: str | None, *, metavar: str | None = None, choices: Sequence[str] = (), most: int | None = None
) -> list[str]:
    """The arguments; ``--help`` prints the module's docstring, anything unexpected is an error.

    ``metavar``: what the arguments are, ``None`` where there are none; ``choices``: those that are possible,
    all unless given; ``most``: how many there may be.
    """
    parser = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
    if metavar is not None:
        parser.add_argument("arguments", nargs="*", metavar=metavar)
    arguments: list[str] = getattr(parser.parse_args(), "arguments", [])
    wrong = [one for one in arguments if choices and one not in choices]
    if wrong or (most is not None and len(arguments) > most):
        expected = ", ".join(choices) or metavar
        parser.error(f"takes {most or 'any'} of: {expected}; received {' '.join(arguments)}")
    return arguments
