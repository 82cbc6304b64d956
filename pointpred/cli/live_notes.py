"""What a person should know of the device that ``pointpred live`` reads: that nothing moves, what to try."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from pointpred.devices.first_moving import SILENCE_S, FirstMoving
from pointpred.devices.lsl_inlet import LslInlet
from pointpred.devices.played import PlayedSource

if TYPE_CHECKING:
    from pointpred.devices.sessions import LiveSession
    from pointpred.devices.source import DeviceSource, Found

TRY = (
    "Move the mouse that is to be followed. If it is not named here, 'pointpred devices list' says why, such "
    "as a missing permission; --device NAME reads one device"
)


def notes_of(session: LiveSession) -> Callable[[], str | None]:
    """What ``LiveSession.note`` is to be."""
    source = session.source

    def note() -> str | None:
        if isinstance(source, PlayedSource):
            return None
        if not session.moved and session.silent_s >= SILENCE_S and source.plugged:
            return silence(source)
        return source.note or None if isinstance(source, FirstMoving) else None

    return note


def silence(source: DeviceSource) -> str:
    """Which devices are listened to while nothing moves, which cannot be, and what to try."""
    if isinstance(source, LslInlet):
        return f"nothing moves in the stream {source.name!r}. Is the program that sends it still running?"
    devices: tuple[DeviceSource, ...] = (source,)
    closed: tuple[Found, ...] = ()
    if isinstance(source, FirstMoving):
        devices, closed = source.devices, source.closed
    listened = ", ".join(f"{one.path} ({one.name})" for one in devices)
    shut = ", ".join(f"{one.path} ({one.name}): {one.why}" for one in closed)
    return f"nothing moves. Listening to {listened}. " + (f"Not opened: {shut}. " if shut else "") + TRY
