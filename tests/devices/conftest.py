"""An emulated machine and a screen for tests of devices."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.devices import screens, umockdev
from tests.devices.screens import Screen
from tests.devices.umockdev import Testbed


@pytest.fixture
def testbed() -> Iterator[Testbed]:
    """A machine without devices; the test is skipped where nothing can be emulated."""
    if why := umockdev.missing():
        pytest.skip(why)
    with Testbed() as bed:
        yield bed


@pytest.fixture
def screen() -> Iterator[Screen]:
    """A virtual screen; the test is skipped where there can be none."""
    if why := screens.missing():
        pytest.skip(why)
    with Screen() as made:
        yield made
