"""The wall clock jumps: by an hour, a day, a year, forward and back."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.faults.conftest import WALL_CLOCK, Faults
from tests.faults.service import Client, service
from tests.server.listener import soon

DAY_S = 86_400


@pytest.mark.slow
def test_a_wall_clock_that_jumps_changes_no_session(faults: Faults, tmp_path: Path) -> None:
    with service(tmp_path, environment=faults.environment) as running:
        with Client(running.url) as client:
            client.exchange(50)
            names = set()
            for ahead_s in (DAY_S, -DAY_S, 400 * DAY_S, -3600):
                faults.set(WALL_CLOCK, ahead_s)
                client.exchange(50)
                soon(lambda: len(client.recorded(running)) == len(client.sent), "it is recorded")
                with Client(running.url, "switched") as other:
                    other.exchange(50)
                    other.leave()
                    soon(lambda other=other: len(other.recorded(running)) == 50, "and so is another")
                    names.add(running.samples(other.session).name[:8])
            client.leave()
            assert client.socket.close_code == 1000
        assert len(names) >= 3, "the clock of the service did jump"
        assert running.errors() == []
