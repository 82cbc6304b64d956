"""When an HTTP connection is read: what holds it up besides the application, which uvicorn lets."""

from __future__ import annotations

from uvicorn.protocols.http.flow_control import FlowControl


class HeldReading(FlowControl):
    """uvicorn's pauses of a connection, and a hold of our own: it is read while there is neither.

    Without it the application, which asks for more of a body, would have more read than is parsed.
    """

    _held = False

    def hold(self) -> None:
        """Read nothing until the release."""
        if not self._held:
            self._held = True
            if not self.read_paused:
                self._transport.pause_reading()

    def release(self) -> None:
        """Read again, unless the application is behind."""
        if self._held:
            self._held = False
            if not self.read_paused and not self._transport.is_closing():
                self._transport.resume_reading()

    def pause_reading(self) -> None:
        """Read nothing until the application asks for more."""
        if self._held:
            self.read_paused = True
        else:
            super().pause_reading()

    def resume_reading(self) -> None:
        """The application asks for more."""
        if self._held:
            self.read_paused = False
        else:
            super().resume_reading()
