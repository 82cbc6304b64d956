"""The words after ``python -m benchmarks.something``: known before any page is written over."""

from __future__ import annotations

import argparse
from collections.abc import Sequence


def words(
    doc: str | None, *, named: str | None = None, known: Sequence[str] = (), most: int | None = None
) -> list[str]:
    """The words given; ``--help`` prints the module's docstring, anything unexpected ends in an error.

    ``named``: what the words are, where a benchmark takes any; ``known``: those it knows, all unless given;
    ``most``: how many it takes.
    """
    parser = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
    if named is not None:
        parser.add_argument("words", nargs="*", metavar=named)
    found: list[str] = getattr(parser.parse_args(), "words", [])
    strange = [word for word in found if known and word not in known]
    if strange or len(found) > (len(found) if most is None else most):
        parser.error(f"takes {most or 'any'} of: {', '.join(known) or named}; received {' '.join(found)}")
    return found
