"""Notes about the device: that nothing moves and what to try, or which device is followed."""

from __future__ import annotations

from collections.abc import Callable

from pointpred.devices.first_moving import SILENCE_S, FirstMoving
from pointpred.devices.lsl import LslInlet
from pointpred.devices.source import DeviceInfo, DeviceSource
from pointpred.live.session import LiveSession

TRY = (
    "Move the mouse that is to be followed. If it is not named here, 'pointpred devices list' says why, such "
    "as a missing permission; --device NAME reads one device"
)


def device_note(session: LiveSession) -> Callable[[], str | None]:
    """The function for ``LiveSession.note`` of a session over a device."""
    source = session.source

    def note() -> str | None:
        if not session.moved and session.silent_s >= SILENCE_S and source.plugged:
            return silence(source)
        return source.note or None if isinstance(source, FirstMoving) else None

    return note


def silence(source: DeviceSource) -> str:
    """Which devices are read while nothing moves, which cannot be, and what to try."""
    if isinstance(source, LslInlet):
        return f"nothing moves in the stream {source.name!r}. Is the program that sends it still running?"
    devices: tuple[DeviceSource, ...] = (source,)
    closed: tuple[DeviceInfo, ...] = ()
    if isinstance(source, FirstMoving):
        devices, closed = source.devices, source.closed
    reading = ", ".join(f"{one.path} ({one.name})" for one in devices)
    not_opened = ", ".join(f"{one.path} ({one.name}): {one.why}" for one in closed)
    also = f"Not opened: {not_opened}. " if not_opened else ""
    return f"nothing moves. Listening to {reading}. {also}{TRY}"
