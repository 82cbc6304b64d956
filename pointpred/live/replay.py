"""``pointpred live --replay``: a recording in the place of a mouse; nothing that reads devices is loaded."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from msgspec.structs import replace

from pointpred.devices.cursor_paths import PositionPath
from pointpred.errors import RecordingError
from pointpred.garbage import tune_collector
from pointpred.live.playback import PlayedPipeline, PlayedSource, PlayedTrial
from pointpred.live.run import LiveRun, OutputOptions
from pointpred.live.session import LiveSession
from pointpred.recording import Recording
from pointpred.records import Pair


def follow_replay(
    file: Path, recording: Recording, trials: Sequence[PlayedTrial], speed: float, outputs: OutputOptions
) -> None:
    """Play trials as the session of a device; ``outputs`` has the resolutions of the recording.

    Raises RecordingError where there is no trial.
    """
    if not trials:
        raise RecordingError(f"{file}: no trial can be played; see the reasons above")
    simulated = recording.provenance.simulated
    outputs = replace(outputs, simulated=simulated)
    name = f"replay of {file.name}" + (" (simulated people)" if simulated else "")
    path = PositionPath("the recorded cursor" + (", simulated" if simulated else ""), counts=True)
    pipeline = PlayedPipeline(outputs.pipeline())
    with PlayedSource(name, str(file), trials, speed=speed, words=recording.provenance.clock) as source:
        run = LiveRun(LiveSession(source, path, pipeline), outputs)
        _end_with(run, source)
        tune_collector()
        run.run()


def _end_with(run: LiveRun, source: PlayedSource) -> None:
    """End with the recording, after viewers were shown the last of it; with a page, begin once it is open."""
    page = run.page

    def end(pairs: Sequence[Pair]) -> None:
        if source.ended and not pairs:
            run.stopping.set()

    run.session.watchers.append(end)
    if page is not None:
        source.hold = lambda: not page.watched
