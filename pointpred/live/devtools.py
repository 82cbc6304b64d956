"""A tab of a running browser, controlled through its DevTools protocol, and its mouse moved along a path."""

from __future__ import annotations

import math
import time
from collections import Counter, deque
from contextlib import ExitStack
from typing import Any
from urllib.error import HTTPError, URLError
from urllib.parse import quote, urlsplit
from urllib.request import Request, urlopen

import msgspec

from pointpred.devices.source import BUTTON_NAMES, ClosedOnExit
from pointpred.errors import ParameterError, SourceError
from pointpred.extras import require
from pointpred.live.playback import Pacing
from pointpred.records import EventColumns

require("client", "a replay to a page")

from websockets.exceptions import ConnectionClosed, InvalidHandshake  # noqa: E402
from websockets.sync.client import connect as dial  # noqa: E402

START = "chromium --headless --remote-debugging-port=9222 --user-data-dir=$(mktemp -d)"
IN_FLIGHT = 512
"""Commands sent before one waits for a result: the browser merges them as those of a real mouse."""


class Page(ClosedOnExit):
    """One tab of a running browser; made by ``open_page``. Not safe for threads."""

    def __init__(self, socket: Any, timeout_s: float) -> None:
        self.timeout_s = timeout_s
        self.events: deque[dict[str, Any]] = deque(maxlen=10_000)
        """The newest events of the protocol."""
        self._socket = socket
        self._number = 0
        self._waiting: set[int] = set()

    def call(self, method: str, **parameters: Any) -> dict[str, Any]:
        """Send a command and wait for its result; raises SourceError where the browser refuses it."""
        number = self.send(method, **parameters)
        while True:
            answer = self._receive()
            if answer.get("id") == number:
                result: dict[str, Any] = answer.get("result", {})
                return result

    def send(self, method: str, **parameters: Any) -> int:
        """Send a command without waiting for its result; returns its number."""
        self._number += 1
        self._waiting.add(self._number)
        command = {"id": self._number, "method": method, "params": parameters}
        try:
            self._socket.send(msgspec.json.encode(command), text=True)
        except ConnectionClosed as closed:
            raise SourceError(f"the page has gone: {closed}") from closed
        while len(self._waiting) > IN_FLIGHT:
            self._receive()
        return self._number

    def wait_for_results(self) -> None:
        """Wait until the browser has carried out every command."""
        while self._waiting:
            self._receive()

    def evaluate(self, expression: str) -> Any:
        """The value of an expression in the page, awaited where it is a promise."""
        answer = self.call("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in answer:
            thrown = answer["exceptionDetails"]
            description = thrown.get("exception", {}).get("description") or thrown.get("text")
            raise SourceError(f"the page threw: {description}")
        return answer["result"].get("value")

    def go(self, url: str) -> None:
        """Open an address and wait until it has loaded."""
        self.call("Page.enable")
        self.call("Page.setLifecycleEventsEnabled", enabled=True)
        self.events.clear()
        answer = self.call("Page.navigate", url=url)
        if answer.get("errorText"):
            raise SourceError(f"the page cannot open {url}: {answer['errorText']}")
        while not self._loaded(answer.get("loaderId")):
            self._receive()

    def _loaded(self, loader: str | None) -> bool:
        """Whether this document has loaded, not the previous one, whose event may be late."""
        events = (event["params"] for event in self.events if event["method"] == "Page.lifecycleEvent")
        return loader is None or any((one["name"], one["loaderId"]) == ("load", loader) for one in events)

    def close(self) -> None:
        """Disconnect from the tab; it stays open."""
        self._socket.close()

    def _receive(self) -> dict[str, Any]:
        try:
            answer: dict[str, Any] = msgspec.json.decode(self._socket.recv(timeout=self.timeout_s))
        except TimeoutError:
            raise SourceError(f"the browser did not answer for {self.timeout_s:g} s") from None
        except ConnectionClosed as closed:
            raise SourceError(f"the page has gone: {closed}") from closed
        if "id" not in answer:
            self.events.append(answer)
            return answer
        self._waiting.discard(answer["id"])
        if "error" in answer:
            raise SourceError(f"the browser refused a command: {answer['error'].get('message')}")
        return answer


def open_page(devtools: str, url: str | None = None, *, timeout_s: float = 30.0) -> Page:
    """A tab of the browser whose DevTools answer at ``devtools``: a new one at ``url``, else the first.

    Raises SourceError, which says how to start a browser, where none answers.
    """
    if urlsplit(devtools).scheme != "http" or not urlsplit(devtools).netloc:
        raise ParameterError(f"DevTools are at http://HOST:PORT, received {devtools!r}")
    where = devtools.rstrip("/")
    try:
        if url is None:
            tabs = [tab for tab in _request(f"{where}/json/list") if tab["type"] == "page"]
            if not tabs:
                raise SourceError(f"the browser at {devtools} has no page open; name one with its address")
            tab = tabs[0]
        else:
            tab = _request(f"{where}/json/new?{quote('about:blank', safe='')}", "PUT")
        target = tab["webSocketDebuggerUrl"]
        opened = dial(target, max_size=None, max_queue=None, compression=None, proxy=None)
        socket = ExitStack().enter_context(opened)  # websockets 17 wants to be entered; `close` leaves
    except (HTTPError, URLError, OSError, InvalidHandshake) as error:
        if isinstance(error, SourceError):
            raise
        raise SourceError(f"no browser answers at {devtools} ({error}); start one with: {START}") from error
    page = Page(socket, timeout_s)
    if url is not None:
        page.go(url)
    return page


def _request(address: str, method: str = "GET") -> Any:
    with urlopen(Request(address, method=method), timeout=10) as answer:
        return msgspec.json.decode(answer.read())


class Driven(msgspec.Struct, frozen=True):
    """How often the mouse was moved, pressed and released."""

    moves: int
    presses: int
    releases: int
    seconds: float


def drive_mouse(
    page: Page,
    events: EventColumns,
    *,
    speed: float = 1.0,
    offset: tuple[float, float] = (0.0, 0.0),
    scale: float = 1.0,
) -> Driven:
    """Move a page's mouse along events, pressing and releasing its buttons where they say so.

    A point goes to ``scale * (x, y) + offset``, CSS px of the viewport. ``speed``: 1 as recorded, infinity
    as fast as the browser takes it (some 2,000 a second). No command waits for the last one's result, so
    that the browser merges moves within a frame as it does for a real mouse. A button still held at the end
    is released there. Raises SourceError where the browser refuses a command or goes away, ParameterError
    for a speed or a scale that is not positive.
    """
    if not scale > 0.0:
        raise ParameterError(f"scale must be positive, received {scale!r}")
    pacing = Pacing(events.t, speed)
    counts: Counter[str] = Counter()
    rows, held, x, y, began = events.table.tolist(), 0, 0.0, 0.0, time.perf_counter()
    while due := pacing.take():
        for row in rows[due.start : due.stop]:
            x, y = (scale * value + shift for value, shift in zip(row[1:3], offset, strict=True))
            buttons = 0 if math.isnan(row[5]) else int(row[5])
            for command in _commands(x, y, held, buttons):
                counts[command["type"]] += 1
                page.send("Input.dispatchMouseEvent", **command)
            held = buttons
    if held:
        for command in _commands(x, y, held, 0):
            counts[command["type"]] += 1
            page.send("Input.dispatchMouseEvent", **command)
    page.wait_for_results()
    moves, presses, releases = (counts[kind] for kind in ("mouseMoved", "mousePressed", "mouseReleased"))
    return Driven(moves, presses, releases, time.perf_counter() - began)


def _commands(x: float, y: float, held: int, buttons: int) -> list[dict[str, Any]]:
    """The commands for a move, or for a change of buttons."""
    place = {"x": x, "y": y, "pointerType": "mouse"}
    drag = next((name for bit, name in BUTTON_NAMES.items() if held & bit), "none")
    commands: list[dict[str, Any]] = []
    if buttons == held:
        return [{"type": "mouseMoved", "button": drag, "buttons": held, **place}]
    for bit, name in BUTTON_NAMES.items():
        if (held ^ buttons) & bit:
            kind = "mousePressed" if buttons & bit else "mouseReleased"
            held ^= bit
            commands.append({"type": kind, "button": name, "buttons": held, "clickCount": 1, **place})
    return commands
