"""What takes a session long, done in slices, between which others have their turn."""

from __future__ import annotations

from collections.abc import Callable, Generator
from typing import TypeVar

Result = TypeVar("Result")
Slices = Generator[None, None, Result]
"""Computes a result, and stops after each slice: about ``SLICE_S`` of ``costs``."""
Completion = Callable[[], None]
"""Uses the result, in the thread of the session."""


class Work:
    """Slices of work for one session; any thread may do each of them, one at a time.

    ``divided``: whether no slice takes much longer than the others of the service.
    """

    def __init__(self, slices: Slices[Completion], *, divided: bool = True) -> None:
        self.divided = divided
        self._slices = slices

    def advance(self) -> Completion | None:
        """Do the next slice; returns what is then to be called, ``None`` where slices are left."""
        try:
            next(self._slices)
        except StopIteration as end:
            completion: Completion = end.value
            return completion
        return None

    def __call__(self) -> Completion:
        """Do all slices that are left."""
        return result_of(self._slices)


def result_of(slices: Slices[Result]) -> Result:
    """The result, all slices at once."""
    while True:
        try:
            next(slices)
        except StopIteration as end:
            result: Result = end.value
            return result
