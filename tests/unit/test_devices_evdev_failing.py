"""A reader thread that breaks: whoever takes reports hears of it, after what had come."""

from __future__ import annotations

import os

import pytest

from pointpred.devices import evdev
from pointpred.devices.evdev import EvdevSource
from pointpred.devices.source import Report
from pointpred.errors import SourceError

NODE = evdev.Node("/dev/input/event9", "a mouse", (), "", True, False)


def test_what_breaks_the_reader_is_told_by_take(monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(self: object, data: bytes) -> list[object]:
        raise RuntimeError("a mistake of ours")

    reading, writing = os.pipe()
    monkeypatch.setattr(evdev, "check_node", lambda path: NODE)
    monkeypatch.setattr(evdev, "open_node", lambda path: reading)
    monkeypatch.setattr(evdev.Clock, "ask", lambda self, file: None)
    monkeypatch.setattr(evdev.FrameDecoder, "feed", broken)
    with EvdevSource("/dev/input/event9") as source:
        source._queue.put(Report(1.0, 2, 3))
        os.write(writing, b"x" * 24)
        thread = source._thread
        assert thread is not None
        thread.join(10)
        assert source.take(5.0) == [Report(1.0, 2, 3)]
        with pytest.raises(SourceError, match="event9: reading ended: a mistake of ours"):
            source.take(5.0)
    source.close()
    os.close(writing)
    with pytest.raises(OSError, match="Bad file descriptor"):
        os.fstat(reading)
