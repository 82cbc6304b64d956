"""Where ``pointpred live`` sends what a session makes: the screen, a file, the page."""

from __future__ import annotations

import threading
from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec
from msgspec.structs import replace

from pointpred.cli.live_following import Following, Viewing, attentive, until
from pointpred.cli.live_learning import Learning, learning_of
from pointpred.cli.live_log import ViewLog
from pointpred.cli.live_serving import Serving
from pointpred.cli.live_view import DASH, ending, show
from pointpred.cli.screen import counted, remarks, results
from pointpred.devices.cursor import CursorSource
from pointpred.devices.lsl_outlet import NAME, LslOutlet
from pointpred.devices.played import PlayedSource
from pointpred.errors import ParameterError, SourceError

if TYPE_CHECKING:
    from pointpred.devices.sessions import LiveSession, Pair
    from pointpred.protocol.live_messages import Curve
    from pointpred.server.live.feed import LiveFeed
    from pointpred.server.recorder.live_recording import LiveRecording
    from pointpred.transfer import GainCurve


PAGE_FIRST = "; begins when the page is opened"


class Wanted(msgspec.Struct, frozen=True):
    """What was asked for: the predictor, the resolutions, and where it all goes."""

    predictor: str
    cpi: float | None = None
    dpi: float = 96.0
    record: Path | None = None
    save_transfer: Path | None = None
    serve: bool = False
    host: str | None = None
    port: int | None = None
    seconds: float | None = None
    simulated: bool = False
    lsl: bool = False


class Outlets:
    """The outlets of one session; raises SourceError or ParameterError where one cannot be opened."""

    def __init__(self, session: LiveSession, wanted: Wanted) -> None:
        self.session = session
        self.wanted = wanted
        self.recording = _recording(session, wanted) if wanted.record else None
        self.feed = _feed(session, wanted) if wanted.serve else None
        if wanted.lsl:
            session.watchers.append(LslOutlet(wanted.predictor, session.source).take)
        self.serving = Serving(self.feed, wanted.host, wanted.port) if self.feed else None
        self.learning = learning_of(session.path, wanted.cpi, wanted.dpi)
        if isinstance(self.learning, Learning):
            session.watchers.append(self.learning.take)
        elif wanted.save_transfer is not None:
            raise ParameterError(f"nothing to save in {wanted.save_transfer}: {self.learning}")
        self._log = ViewLog() if results().is_terminal else None
        self._following = Following(session, self.feed.fail if self.feed else _to_nobody)

    @property
    def stopping(self) -> threading.Event:
        """Set it to end the session."""
        return self._following.stopping

    def follow(self) -> None:
        """Drive the session until something or somebody ends it; raises what ended it."""
        from pointpred.server.logs import set_up

        stopping, serving, screen = self._following.stopping, self.serving, results()
        heading = self._heading()
        self.session.source.take(0.0)  # what came while the outlets were opened belongs to nothing
        if self._log is not None:
            self._log.take_over()
        elif serving is not None:
            set_up(None)
        with attentive(stopping):
            view = None
            self._following.start(self.wanted.seconds)
            try:
                self._learn()
                if not screen.is_terminal:
                    for name, words in heading:
                        remarks().print(f"{name}: {words}", markup=False)
                view = Viewing(partial(show, self.session, heading, stopping, screen, self._viewed), stopping)
                if serving is None:
                    until(stopping)
                else:
                    serving.run(stopping, said=self._log is None)
            except KeyboardInterrupt:
                stopping.set()
            finally:
                stopping.set()
                if view is not None:
                    view.join()
                self._end(unheard=view is not None and view.error is not None)
            if view is not None and view.error is not None:
                raise view.error

    def _learn(self) -> None:
        """Keep the curve up to date, and show it to whoever looks at the page."""
        feed, learning = self.feed, self.learning
        if isinstance(learning, str):
            if feed is not None:
                feed.curve = curve_message(learning)
            return

        def told(curve: GainCurve) -> None:
            if feed is not None:
                feed.curve = curve_message(curve.words, curve)

        told(learning.curve)
        learning.start(self._following.stopping, told)

    def _end(self, *, unheard: bool) -> None:
        """Stop, see that everything is written, and say what it came to unless that is ``unheard``."""
        recording = self.recording
        try:
            self._following.stop()
        finally:
            written = recording.close() if recording else True
            screen = results()
            screen.quiet = unheard
            screen.print(ending(self.session), markup=False, soft_wrap=True)
            for entry in self._log.wrong if self._log else ():
                remarks().print(entry, markup=False)
            for name, words in self._more():
                screen.print(f"{name}: {words}", markup=False, soft_wrap=True)
        if self.wanted.save_transfer is not None and isinstance(self.learning, Learning):
            screen.print(self.learning.save(self.wanted.save_transfer), markup=False, soft_wrap=True)
        if recording is not None and not written:
            raise SourceError(f"{recording.file}: not everything could be recorded")

    def _heading(self) -> list[tuple[str, str]]:
        source, cpi = self.session.source, self.wanted.cpi
        fineness = "counts per inch unknown" if cpi is None else f"{cpi:.0f} counts per inch"
        if isinstance(source, CursorSource):
            fineness = "no counts"
        page = [("page", self.serving.address)] if self.serving else []
        played = source.told if isinstance(source, PlayedSource) else ""
        return [
            *page,
            *([("plays", played + (PAGE_FIRST if page else ""))] if played else []),
            ("device", f"{source.name}{'' if played else f' ({source.path})'}, {fineness}"),
            ("clock", source.clock),
            ("positions", self.session.words),
            ("predictor", self.wanted.predictor),
            *([("sent", f"as the stream {NAME!r} of Lab Streaming Layer")] if self.wanted.lsl else []),
        ]

    def _more(self) -> list[tuple[str, str]]:
        """What the outlets have come to so far."""
        told = []
        played = isinstance(self.session.source, PlayedSource)
        if isinstance(self.learning, Learning) and (not played or self.wanted.save_transfer is not None):
            told.append(("gain", self.learning.words()))
        if self.recording is not None:
            told.append(("recorded", self._recorded(self.recording)))
        return told

    def _recorded(self, recording: LiveRecording) -> str:
        """What has been recorded; there is no file before there is an event."""
        if recording.events:
            said = f"{counted(recording.events - recording.lost, 'event')} in {recording.file}"
        else:
            came = self.session.reports or self.session.source.unreadable
            said = "nothing recorded" if came else "nothing moved, nothing recorded"
        said += f", {recording.lost} lost" if recording.lost else ""
        return said + (", stopped by an error" if recording.failed else "")

    def _viewed(self) -> list[tuple[str, str]]:
        """The further rows of the view."""
        log = [("service", self._log.newest or "starting")] if self._log and self.serving else []
        source = self.session.source
        trial = [("trial", source.playing or DASH)] if isinstance(source, PlayedSource) else []
        return [*trial, *self._more(), *log]


def curve_message(words: str, curve: GainCurve | None = None) -> Curve:
    """What viewers hear of the transfer function."""
    from pointpred.protocol.live_messages import Curve

    return Curve(words, curve)


def _recording(session: LiveSession, wanted: Wanted) -> LiveRecording:
    from pointpred.protocol.client_messages import Device, Hello, Screen
    from pointpred.server.recorder.live_recording import LiveRecording

    assert wanted.record is not None
    hello = Hello(1, wanted.predictor, device=Device(cpi=wanted.cpi), screen=Screen(dpi=wanted.dpi))
    made = LiveRecording(
        wanted.record, hello, session.words, lambda: session.source.clock, simulated=wanted.simulated
    )
    session.watchers.append(made.take)
    return made


def _feed(session: LiveSession, wanted: Wanted) -> LiveFeed:
    from pointpred.protocol.live_messages import Attached
    from pointpred.server.live.feed import LiveFeed

    source = session.source
    about = Attached(
        source.name, source.clock, session.space, session.words, wanted.predictor, wanted.cpi, wanted.dpi
    )
    feed = LiveFeed(about, session.state)

    def renew(pairs: Sequence[Pair]) -> None:
        """Another device may be followed by now."""
        if (feed.attached.name, feed.attached.clock) != (source.name, source.clock):
            feed.attached = replace(feed.attached, name=source.name, clock=source.clock)

    session.watchers += [renew, feed.take]
    return feed


def _to_nobody(why: str) -> None:
    """The main thread hears of it."""
