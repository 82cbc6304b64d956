"""Running a session: it is shown in the terminal, recorded, served and sent until something ends it.

One thread drives the session, one draws the view, the main one waits.
"""

from __future__ import annotations

import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from importlib.metadata import entry_points
from pathlib import Path
from types import FrameType
from typing import Any, Protocol

import msgspec

from pointpred.console import counted, remark, results
from pointpred.devices.cursor_paths import SurfacePath
from pointpred.devices.lsl import OUTLET, LslOutlet
from pointpred.devices.screen_cursor import CursorSource
from pointpred.errors import ParameterError, SourceError
from pointpred.extras import missing_distribution
from pointpred.live.outputs import CurveLearner, LiveRecording, curve_learner
from pointpred.live.playback import PlayedPipeline, PlayedSource
from pointpred.live.session import LiveSession
from pointpred.live.targets import likeliest
from pointpred.live.terminal import DASH, TerminalLog, show, summary
from pointpred.pipeline import Pipeline
from pointpred.protocol.client_messages import VERSION, Device, Hello, Rectangle, Screen
from pointpred.protocol.server_messages import Curve
from pointpred.records import Pair
from pointpred.registry import build
from pointpred.transfer import GainCurve

PAGE_FIRST = "; begins when the page is opened"
SWITCH_S = 0.0005
"""How long a thread may keep the interpreter while a report waits: drawing a view takes milliseconds."""
LOOK_S = 0.1
"""How often the main thread looks whether the end has come."""


class LivePage(Protocol):
    """A page that shows a session."""

    @property
    def address(self) -> str:
        """Where it is opened, with the token where that is shown."""

    @property
    def watched(self) -> bool:
        """Whether there are viewers."""

    def show_curve(self, curve: Curve) -> None:
        """Show the newest transfer function; from any thread."""

    def fail(self, reason: str) -> None:
        """The device has failed: tell the viewers why; from any thread."""

    def run(self, stopping: threading.Event, *, announce: bool) -> None:
        """Serve until interrupted or until ``stopping`` is set, which it is afterwards.

        ``announce``: print the address once the page can be opened.
        """


OpenPage = Callable[[LiveSession, str, float | None, float], LivePage]
"""Opens the page of a session, from its predictor, counts per inch and dpi."""


def page_opener(host: str | None, port: int | None) -> OpenPage:
    """What opens the page, on an address or port that may be given.

    It is the entry point ``page`` of the group ``pointpred.live``. Raises MissingExtraError where no
    distribution has one, ParameterError for settings that are wrong.
    """
    for entry in entry_points(group="pointpred.live", name="page"):
        opener: OpenPage = entry.load()(host, port)
        return opener
    raise missing_distribution("pointpred-server", "the page of a device")


class OutputOptions(msgspec.Struct, frozen=True):
    """The predictor with its parameters, the resolutions, and where the predictions go.

    ``page`` opens the page that shows the session; ``simulated``: the events of a recording of
    simulated people; ``lsl``: send the predictions as a stream of Lab Streaming Layer; ``targets``: what can
    be pointed at.
    """

    predictor: str
    cpi: float | None = None
    dpi: float = 96.0
    record: Path | None = None
    save_transfer: Path | None = None
    page: OpenPage | None = None
    seconds: float | None = None
    simulated: bool = False
    lsl: bool = False
    parameters: dict[str, Any] = {}
    targets: tuple[Rectangle, ...] = ()

    def pipeline(self, person: str = "") -> Pipeline:
        """The predictor with ``person`` loaded; raises ParameterError."""
        return build(
            self.predictor,
            cpi=self.cpi,
            dpi=self.dpi,
            person=person,
            targets=self.targets,
            **self.parameters,
        )


class LiveRun:
    """One session and its outputs; raises SourceError or ParameterError where one cannot be opened."""

    def __init__(self, session: LiveSession, options: OutputOptions) -> None:
        self.session = session
        self.options = options
        self.recording = self._record(options.record) if options.record else None
        self.page = (
            options.page(session, options.predictor, options.cpi, options.dpi) if options.page else None
        )
        pipeline = session.pipeline
        if options.targets and isinstance(pipeline, Pipeline | PlayedPipeline):
            session.target = DASH
            session.watchers.append(partial(name_target, session, pipeline))
        if options.lsl:
            session.watchers.append(LslOutlet(options.predictor, session.source).take)
        self.learner = curve_learner(session.path, options.cpi, options.dpi)
        if isinstance(self.learner, CurveLearner):
            session.watchers.append(self.learner.take)
        elif options.save_transfer is not None:
            raise ParameterError(f"nothing to save in {options.save_transfer}: {self.learner}")
        self._log = TerminalLog() if results().is_terminal else None
        self._thread = SessionThread(session, self.page.fail if self.page else lambda why: None)
        self.stopping = self._thread.stopping
        """Set this event to end the session."""

    def run(self) -> None:
        """Drive the session until it ends; raises the error that ended it."""
        stopping, console = self.stopping, results()
        heading = self._heading()
        self.session.source.take(0.0)  # reports that came while the outputs were opened are left out
        if self._log is not None:
            self._log.install()
        with end_on_signal(stopping):
            view = None
            self._thread.start(self.options.seconds)
            try:
                self._start_learning()
                if not console.is_terminal:
                    for name, words in heading:
                        remark(f"{name}: {words}")
                view = ViewThread(
                    partial(show, self.session, heading, stopping, console, self._view_rows), stopping
                )
                if self.page is None:
                    wait(stopping)
                else:
                    self.page.run(stopping, announce=self._log is None)
            except KeyboardInterrupt:
                stopping.set()
            finally:
                stopping.set()
                if view is not None:
                    view.join()
                self._end(quiet=view is not None and view.error is not None)
            if view is not None and view.error is not None:
                raise view.error

    def _record(self, file: Path) -> LiveRecording:
        options, session = self.options, self.session
        hello = Hello(
            VERSION, options.predictor, device=Device(cpi=options.cpi), screen=Screen(dpi=options.dpi)
        )
        recording = LiveRecording(
            file,
            hello,
            lambda: session.words,
            lambda: session.source.clock,
            simulated=options.simulated,
        )
        session.watchers.append(recording.take)
        return recording

    def _start_learning(self) -> None:
        """Keep the curve up to date, and send it to the viewers of the page."""
        learner = self.learner
        if isinstance(learner, str):
            if self.page is not None:
                self.page.show_curve(Curve(learner))
            return
        self._show_curve(learner.curve)
        learner.start(self.stopping, self._show_curve)

    def _show_curve(self, curve: GainCurve) -> None:
        if self.page is not None:
            self.page.show_curve(Curve(curve.words, curve))

    def _end(self, *, quiet: bool) -> None:
        """Stop, finish the recording, and print a summary unless ``quiet``."""
        recording = self.recording
        try:
            self._thread.stop()
        finally:
            written = recording.close() if recording else True
            console = results()
            console.quiet = quiet
            console.print(summary(self.session), soft_wrap=True)
            for entry in self._log.problems if self._log else ():
                remark(entry)
            for name, words in self._output_rows():
                console.print(f"{name}: {words}", soft_wrap=True)
        if self.options.save_transfer is not None and isinstance(self.learner, CurveLearner):
            console.print(self.learner.save(self.options.save_transfer), soft_wrap=True)
        if recording is not None and not written:
            raise SourceError(f"{recording.file}: not everything could be recorded")

    def _heading(self) -> list[tuple[str, str]]:
        source, cpi = self.session.source, self.options.cpi
        resolution = "counts per inch unknown" if cpi is None else f"{cpi:.0f} counts per inch"
        path = self.session.path
        if isinstance(source, CursorSource) or (isinstance(path, SurfacePath) and path.counts is None):
            resolution = "no counts"
        page = [("page", self.page.address)] if self.page else []
        plays = source.pace if isinstance(source, PlayedSource) else ""
        return [
            *page,
            *([("plays", plays + (PAGE_FIRST if page else ""))] if plays else []),
            ("device", f"{source.name}{'' if plays else f' ({source.path})'}, {resolution}"),
            ("clock", source.clock),
            ("positions", self.session.words),
            ("predictor", self.options.predictor),
            *([("targets", str(len(self.options.targets)))] if self.options.targets else []),
            *([("sent", f"as the stream {OUTLET!r} of Lab Streaming Layer")] if self.options.lsl else []),
        ]

    def _output_rows(self) -> list[tuple[str, str]]:
        """The learned gain, and how much is recorded."""
        rows = []
        played = isinstance(self.session.source, PlayedSource)
        if isinstance(self.learner, CurveLearner) and (not played or self.options.save_transfer is not None):
            rows.append(("gain", self.learner.words()))
        if self.recording is not None:
            rows.append(("recorded", self._recorded(self.recording)))
        return rows

    def _recorded(self, recording: LiveRecording) -> str:
        """How much is recorded; there is no file before there is an event."""
        if recording.events:
            words = f"{counted(recording.events - recording.lost, 'event')} in {recording.file}"
        else:
            moved = self.session.reports or self.session.source.unreadable
            words = "nothing recorded" if moved else "nothing moved, nothing recorded"
        words += f", {recording.lost} lost" if recording.lost else ""
        return words + (", stopped by an error" if recording.failed else "")

    def _view_rows(self) -> list[tuple[str, str]]:
        """The rows of the view below those of the session."""
        log = [("service", self._log.newest or "starting")] if self._log and self.page else []
        source = self.session.source
        trial = [("trial", source.playing or DASH)] if isinstance(source, PlayedSource) else []
        return [*trial, *self._output_rows(), *log]


def name_target(session: LiveSession, pipeline: Pipeline | PlayedPipeline, pairs: Sequence[Pair]) -> None:
    """Say which target a movement is for, once something has moved."""
    if pairs:
        session.target = likeliest(pipeline.shares)


class SessionThread:
    """Drives a session until it is stopped or fails; ``stop`` then raises the error."""

    def __init__(self, session: LiveSession, failed: Callable[[str], None] = lambda why: None) -> None:
        self.session = session
        self.stopping = threading.Event()
        self._failed = failed
        self._error: Exception | None = None
        self._thread = threading.Thread(target=self._run, name="device", daemon=True)
        self._timer: threading.Timer | None = None

    def start(self, seconds: float | None) -> None:
        """Begin; end by itself after ``seconds``, unless they are ``None`` or more than a clock can count."""
        self._thread.start()
        if seconds is not None and seconds < threading.TIMEOUT_MAX:
            self._timer = threading.Timer(seconds, self.stopping.set)
            self._timer.daemon = True
            self._timer.start()

    def stop(self) -> None:
        """End, and raise the error that ended it before."""
        self.stopping.set()
        if self._timer is not None:
            self._timer.cancel()
        self._thread.join()
        if self._error is not None:
            raise self._error

    def _run(self) -> None:
        try:
            self.session.run(self.stopping)
        except Exception as error:  # raised by stop(), on the main thread
            self._error = error
            self._failed("the session of the attached device ended with an error")
        finally:
            self.stopping.set()


class ViewThread:
    """Draws the view; an error ends the session and is kept in ``error``."""

    def __init__(self, show: Callable[[], None], stopping: threading.Event) -> None:
        self.error: BaseException | None = None
        self._show, self._stopping = show, stopping
        self._thread = threading.Thread(target=self._run, name="view")
        self._thread.start()

    def join(self) -> None:
        """Wait for its end."""
        self._thread.join()

    def _run(self) -> None:
        try:
            self._show()
        except BaseException as error:  # SystemExit too: rich raises it where a pipe was closed
            self.error = error
        finally:
            self._stopping.set()


def wait(stopping: threading.Event) -> None:
    """Wait for the end on the main thread, where Python runs the handlers of signals.

    It does not wait for the event itself: a handler may run while the event's lock is held, and it sets the
    event.
    """
    while not stopping.is_set():
        time.sleep(LOOK_S)


@contextmanager
def end_on_signal(stopping: threading.Event) -> Iterator[None]:
    """End in order at SIGTERM; threads take turns quickly meanwhile."""
    interval = sys.getswitchinterval()
    sys.setswitchinterval(SWITCH_S)

    def end(number: int, frame: FrameType | None) -> None:
        stopping.set()

    main = threading.current_thread() is threading.main_thread()
    before = signal.signal(signal.SIGTERM, end) if main else None
    try:
        yield
    finally:
        sys.setswitchinterval(interval)
        if main:
            signal.signal(signal.SIGTERM, before or signal.SIG_DFL)
