"""An emulated machine for tests of devices."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.devices.umockdev import Testbed, missing


@pytest.fixture
def testbed() -> Iterator[Testbed]:
    """A machine without devices; the test is skipped where nothing can be emulated."""
    if why := missing():
        pytest.skip(why)
    with Testbed() as bed:
        yield bed
