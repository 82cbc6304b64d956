"""Any text as a plant or a design: refused, or a thing that is written again as the same text."""

from __future__ import annotations

from functools import cache

from observers.tests import kept_designs as kept
from pointpred.errors import PointpredError
from pointpred_observers.files import decoded, encoded
from tests.fuzz.refusals import refused

NAME = "input.json"
DESIGNS = ("reduced order, linear", "full order", "driven", "regulator", "unknown input", "interlaced")


def check(data: bytes) -> str:
    """An input is the text of a file."""
    try:
        thing = decoded(data, name=NAME)
    except PointpredError as error:
        return refused(error, NAME)
    text = encoded(thing)
    assert encoded(decoded(text)) == text
    return "read"


@cache
def seeds() -> list[bytes]:
    """A plant, a generator and a design of every kind."""
    things = [kept.PENDULUM, kept.TANKS, kept.CONSTANT, kept.WING, kept.SYMBOLIC, kept.CIRCLE]
    return [encoded(one) for one in (*things, *map(kept.design, DESIGNS))]
