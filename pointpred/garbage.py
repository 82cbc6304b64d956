"""Settings of Python's garbage collector for a service."""

from __future__ import annotations

import gc

YOUNGEST, MIDDLE, OLDEST = 20_000, 50, 50
"""How many new objects, young and middle collections lead to a collection of each generation."""


def tune_collector() -> None:
    """Exclude everything loaded so far from collections, and collect rarely.

    Sessions and messages make no cycles that matter: they are freed with their last reference. A collection
    of everything that is loaded would delay the answers to clients.
    """
    gc.collect()
    gc.freeze()
    gc.set_threshold(YOUNGEST, MIDDLE, OLDEST)
