"""A connection is read while neither the application nor we are against it."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from pointpred_server.http_reading import HeldReading


class FakeTransport:
    """Is strict where uvloop's is."""

    def __init__(self) -> None:
        self.reading = True

    def is_closing(self) -> bool:
        return False

    def pause_reading(self) -> None:
        assert self.reading
        self.reading = False

    def resume_reading(self) -> None:
        assert not self.reading
        self.reading = True


@given(st.lists(st.sampled_from(["hold", "release", "pause_reading", "resume_reading"])))
def test_it_is_read_while_nothing_holds_it(calls: list[str]) -> None:
    transport = FakeTransport()
    reading = HeldReading(transport)  # type: ignore[arg-type]
    held = paused = False
    for call in calls:
        getattr(reading, call)()
        held = call == "hold" or (held and call != "release")
        paused = call == "pause_reading" or (paused and call != "resume_reading")
        assert transport.reading == (not held and not paused)
        assert reading.read_paused == paused
