"""A WebSocket without a network: what is sent is kept, and what is received comes from the test."""

from __future__ import annotations

from collections.abc import Callable

from pointpred.protocol.frames import Frame
from pointpred_server.connection import Receiver


class FakeSocket:
    """A ``FrameSocket`` on which everything can be sent at once, unless ``can_write`` is set to False."""

    def __init__(self, on_write: Callable[[Frame], None] = lambda frame: None) -> None:
        self.receiver: Receiver | None = None
        self.written: list[Frame] = []
        self.can_write = True
        self.paused = False
        self.on_attach: Callable[[], None] = lambda: None
        self._on_write = on_write

    def attach(self, receiver: Receiver) -> None:
        self.receiver = receiver
        self.on_attach()

    def detach(self) -> None:
        self.receiver = None

    def write(self, frame: Frame) -> None:
        self.written.append(frame)
        self._on_write(frame)

    def pause_frames(self) -> None:
        self.paused = True

    def resume_frames(self) -> None:
        self.paused = False

    @property
    def there(self) -> Receiver:
        """The connection, which has attached itself."""
        assert self.receiver is not None
        return self.receiver
