"""A recording in the place of a mouse: ``pointpred live --replay FILE``."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec

from pointpred.cli.playing import complain, one_recording, speed_of
from pointpred.errors import RecordingError

if TYPE_CHECKING:
    from pointpred.cli.live_outlets import Outlets
    from pointpred.devices.played import PlayedPath, PlayedSource
    from pointpred.devices.sessions import Pair
    from pointpred.sources import Reading


class Asked(msgspec.Struct, frozen=True):
    """What to play, and what the recording does not say of itself."""

    file: Path
    trials: tuple[str, ...]
    speed: str | None
    reading: Reading
    cpi: float | None = None
    dpi: float | None = None


class Replay(msgspec.Struct, frozen=True):
    """A recording ready to be played, with its resolutions."""

    source: PlayedSource
    path: PlayedPath
    cpi: float | None
    dpi: float
    simulated: bool


def replay_of(asked: Asked) -> Replay:
    """Open the recording; raises ParameterError and RecordingError before anything is played."""
    from pointpred.devices.played import Played, PlayedPath, PlayedSource
    from pointpred.replaying.choosing import chosen, named, unplayable

    speed = speed_of(asked.speed or "1")
    recording = one_recording(asked.file, asked.reading)
    places = chosen(recording, asked.trials)
    skips = {k: skip for k in places if (skip := unplayable(recording, k)) is not None}
    complain((*(() if asked.trials else recording.skipped), *skips.values()))
    kept = [k for k in places if k not in skips]
    trials = [Played(recording.trials[k].user, named(recording, k), recording.rows(k)) for k in kept]
    if not trials:
        raise RecordingError(f"{asked.file}: no trial can be played; see the reasons above")
    about = recording.provenance
    name = f"replay of {asked.file.name}" + (" (simulated people)" if about.simulated else "")
    return Replay(
        PlayedSource(name, str(asked.file), trials, speed=speed, words=about.clock),
        PlayedPath("the recorded cursor" + (", simulated" if about.simulated else "")),
        about.cpi if asked.cpi is None else asked.cpi,
        about.dpi if asked.dpi is None else asked.dpi,
        about.simulated,
    )


def end_with(outlets: Outlets, source: PlayedSource) -> None:
    """End with the recording, after viewers were shown the last of it; with a page, begin once it is open."""
    session, feed = outlets.session, outlets.feed

    def end(pairs: Sequence[Pair]) -> None:
        if source.ended and not pairs:
            outlets.stopping.set()

    session.watchers.append(end)
    if feed is not None:
        source.hold = lambda: not feed.watched
