"""Signals that every stage must survive, and the names of all stages."""

from __future__ import annotations

import pytest

from pointpred import EventColumns
from pointpred.plugins import SIGNALS, TICK, minimum_jerk, troubled, wandering, with_counts

__all__ = ["SIGNALS", "TICK", "minimum_jerk", "troubled", "wandering", "with_counts"]


@pytest.fixture(params=list(SIGNALS))
def events(request: pytest.FixtureRequest) -> EventColumns:
    """Each signal in turn."""
    return SIGNALS[request.param]()


@pytest.fixture
def troubled_events() -> EventColumns:
    """The signal in which the most goes wrong."""
    return troubled()
