"""The words after ``python -m benchmarks.something``: known before any page is written over."""

from __future__ import annotations

import argparse


def words(doc: str | None, *, named: str | None = None) -> list[str]:
    """The words given; ``--help`` prints the module's docstring, anything unexpected ends in an error.

    ``named``: what the words are, where a benchmark takes any.
    """
    parser = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
    if named is not None:
        parser.add_argument("words", nargs="*", metavar=named)
    found: list[str] = getattr(parser.parse_args(), "words", [])
    return found
