"""Four journeys through a checkout, run once as plain Python: which functions and files of it each enters.

``measure.py`` runs this in a process of its own, with the checkout on the path and laws that are not
compiled. What a journey needs is a command or is found by its name, so that the same journeys run where files
have moved.
"""

from __future__ import annotations

import argparse
import contextlib
import importlib
import io
import json
import os
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path
from types import CodeType, FrameType, SimpleNamespace
from typing import Any
from urllib.error import URLError
from urllib.request import urlopen

from measure import module_of, room_of
from websockets.sync.client import connect
from websockets.typing import Subprotocol

MOUSE = bytes.fromhex(
    "05010902a1010901a100050919012903150025019503750181029501750581010501093009311581257f750895028106c0c0"
)
"""The report descriptor of a boot mouse: three buttons, then x and y of 8 bits."""
PARTS = ("<module>", "<lambda>", "<genexpr>", "<listcomp>", "<dictcomp>")
"""Code that is no function of its own."""
HELLO = json.dumps({"type": "hello", "version": 1, "predictor": "switched"})
TRIES = 10
WAIT_S = 300.0
"""How long a service may take to start and to answer on a busy machine."""


class Tree:
    """A checkout that is on the path: its names, and what of it runs."""

    def __init__(self, root: Path) -> None:
        self.root = root.resolve()
        self._own: dict[CodeType, str | None] = {}

    def named(self, name: str) -> Any:
        """The one class or function of the product that is defined under this name."""
        lines = subprocess.run(
            ["git", "grep", "-lE", rf"^(class|def) {name}\b", "--", "*.py"],
            cwd=self.root,
            capture_output=True,
            encoding="utf-8",
        ).stdout.splitlines()
        paths = [path for path in lines if (room := room_of(path)) and room.product]
        if len(paths) != 1:
            raise SystemExit(f"{name} is defined in {paths or 'no file'}, expected one file")
        return getattr(importlib.import_module(module_of(paths[0])), name)

    def path_of(self, code: CodeType) -> str | None:
        """Where code lies in the tree, links followed; ``None`` for code of others."""
        if code not in self._own:
            path = Path(code.co_filename).resolve()
            inside = path.is_relative_to(self.root) and path.suffix == ".py"
            relative = path.relative_to(self.root).as_posix() if inside else ""
            self._own[code] = relative if inside and room_of(relative) else None
        return self._own[code]


class Trace:
    """The functions of a tree that are called inside ``with`` on this thread, in order, while it is ``on``.

    With ``parts``, a comprehension or lambda counts as a function, as Python 3.11 calls it; with ``threads``,
    the threads that are started meanwhile count, too.
    """

    def __init__(self, tree: Tree, *, parts: bool = False, threads: bool = False, on: bool = True) -> None:
        self.calls: list[tuple[str, str]] = []
        self.on = on
        self._tree, self._parts, self._threads = tree, parts, threads

    def __enter__(self) -> Trace:
        if self._threads:
            threading.setprofile(self._note)
        sys.setprofile(self._note)
        return self

    def __exit__(self, *_: object) -> None:
        sys.setprofile(None)
        threading.setprofile(None)

    def _note(self, frame: FrameType, event: str, _: object) -> None:
        if event != "call" or not self.on:
            return
        code = frame.f_code
        if (path := self._tree.path_of(code)) and (self._parts or not code.co_qualname.endswith(PARTS)):
            self.calls.append((path, code.co_qualname))

    def counts(self) -> dict[str, Any]:
        """How many functions and files, and the functions in the order in which they are entered."""
        entered = dict.fromkeys(self.calls)
        return {
            "functions": len(entered),
            "files": len({path for path, _ in entered}),
            "entered": [f"{path} {name}" for path, name in entered],
        }


def events(t: float, x: float, y: float) -> str:
    """A message with one event."""
    return json.dumps({"type": "events", "events": [[t, x, y, None, None, 0]]})


def service(tree: Tree) -> dict[str, Any]:
    """An event in JSON from the socket of ``pointpred serve`` to its answer there.

    A service that shares its processor may take another way with a frame: the shortest of some counts.
    """
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]

    def talk() -> None:
        try:
            wait_until_ready(f"http://127.0.0.1:{port}/readyz")
            stream = f"ws://127.0.0.1:{port}/v1/stream"
            with connect(stream, subprotocols=[Subprotocol("pointpred.v1")], compression=None) as client:
                for message in (HELLO, *(events(i / 100, 5.0 * i, 3.0 * i) for i in range(10))):
                    client.send(message)
                    client.recv(WAIT_S)
                for i in range(TRIES):
                    trace.on = True
                    client.send(events(0.5 * (i + 1), 60.0, 31.0))
                    client.recv(WAIT_S)
                    time.sleep(0.05)  # what follows the answer
                    trace.on = False
                    tries.append(trace.calls.copy())
                    trace.calls.clear()
        finally:
            os.kill(os.getpid(), signal.SIGINT)

    tries: list[list[tuple[str, str]]] = []
    client = threading.Thread(target=talk)
    with Trace(tree, parts=True, on=False) as trace:
        client.start()
        command(["serve", "--port", str(port)])
    client.join()
    shortest = min(tries, key=lambda calls: len(set(calls)))
    first = next(
        i for i, (_, name) in enumerate(shortest) if name.endswith((".buffer_updated", ".data_received"))
    )
    trace.calls = shortest[first:]
    return {"an event in JSON to its answer": trace.counts()}


def wait_until_ready(url: str) -> None:
    """Wait until a service is ready."""
    until = time.monotonic() + WAIT_S
    while time.monotonic() < until:
        with contextlib.suppress(URLError), urlopen(url):  # nobody listens yet, or it is not ready
            return
        time.sleep(0.1)


def command(words: list[str]) -> None:
    """Run a command of the tree in this process, and keep what it prints."""
    main = importlib.import_module("pointpred.cli").main
    with contextlib.redirect_stdout(io.StringIO()), contextlib.suppress(SystemExit, KeyboardInterrupt):
        main(words)


def target(tree: Tree) -> dict[str, Any]:
    """An event in JSON to its answer where one target is known, in the session: without a socket."""
    at = tree.named("Instant")
    session = tree.named("PointingSession")("traced", tree.named("Limits")(), at(0.0))

    def send(message: str, t: float) -> None:
        session.receive(message, at(t))
        list(session.outbox.take())

    send(HELLO, 0.0)
    for i in range(20):
        send(events(i / 100, 5.0 * i, 3.0 * i), i / 100)
    send(events(0.21, 105.0, 63.0), 0.21)
    send(
        json.dumps(
            {"type": "targets", "targets": [{"id": "a", "x": 300, "y": 200, "width": 40, "height": 40}]}
        ),
        0.3,
    )
    with Trace(tree, parts=True) as trace:
        session.receive(events(0.32, 125.0, 73.0), at(0.32))
        list(session.outbox.take())
    return {"the same with one target, in the session": trace.counts()}


def reports(tree: Tree) -> dict[str, Any]:
    """A HID report as its reader gets it, to a prediction: a source whose device was never opened."""
    build = importlib.import_module("pointpred").build
    source = tree.named("HidSource")("/dev/none")
    source._reports = tree.named("parse_descriptor")(MOUSE)
    source.plugged, source._thread, source._device = True, object(), SimpleNamespace(described="a mouse")
    session = tree.named("LiveSession")(source, tree.named("MotorPath")(800.0), build("switched", cpi=800.0))
    for i in range(20):
        source._put(0.01 * i, bytes([0, 5, 2]))
        session.advance(0.0)
    with Trace(tree, parts=True) as trace:
        source._put(0.2, bytes([0, 5, 2]))
        pairs = session.advance(0.0)
    if not pairs:
        raise SystemExit("the report of a mouse led to no prediction")
    return {"a HID report to a prediction": trace.counts()}


def scores(tree: Tree) -> dict[str, Any]:
    """Three trials in a table of any columns, scored by the command; the second time, when all is loaded."""
    rows = ["time,px,py,sid,n"]
    for trial in range(3):
        for i in range(60):
            share = min(i / 50, 1.0)
            way = 10 * share**3 - 15 * share**4 + 6 * share**5
            rows.append(f"{i * 10},{400 * way:.0f},{100 * way:.0f},ann,{trial}")
    with tempfile.TemporaryDirectory() as folder:
        table = Path(folder, "my.csv")
        table.write_text("\n".join(rows) + "\n", encoding="utf-8")
        words = f"score {table} --columns t=time,x=px,y=py,user=sid,trial=n --time-unit ms --predictors hold"
        command([*words.split(), "--threads", "1"])
        with Trace(tree, threads=True) as trace:
            command([*words.split(), "--threads", "1"])
    return {"a CSV of three trials to scores": trace.counts()}


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("checkout", type=Path)
    checkout = Tree(parser.parse_args().checkout)
    print(json.dumps(service(checkout) | target(checkout) | reports(checkout) | scores(checkout)))
