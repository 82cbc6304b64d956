"""A mouse at 8 kHz for two seconds: everything that reached the node is read, in order, once.

Nothing is timed here; ``python -m evidence costs devices`` does that, for a minute.
"""

from __future__ import annotations

import pytest

from tests.devices.live_mouse import measure
from tests.devices.umockdev import missing


@pytest.mark.skipif(missing() is not None, reason=missing() or "")
def test_two_seconds_at_8_khz() -> None:
    live = measure(8000.0, 2.0)
    assert (live.reports, live.lost, live.unreadable) == (16_000, 0, 0)
    assert live.read + live.dropped == live.reports, "what the emulated kernel's ring took was read"
    assert live.exact or live.dropped, "and every count of it"
