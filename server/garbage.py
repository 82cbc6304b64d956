"""Python's garbage collector, told what a service is like."""

from __future__ import annotations

import gc

YOUNGEST, MIDDLE, OLDEST = 20_000, 50, 50
"""Objects made, younger and middle collections until the next collection of each generation."""


def spare() -> None:
    """What is loaded by now stays: collections neither look at it again nor come for every few messages.

    Sessions and messages make no cycles that matter: they are freed when they are let go. What a collection
    of everything that is loaded would cost, clients would feel as a delay.
    """
    gc.collect()
    gc.freeze()
    gc.set_threshold(YOUNGEST, MIDDLE, OLDEST)
