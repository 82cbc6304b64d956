"""What is read by a person at a terminal, and by a program, while the service starts."""

from __future__ import annotations

import io
import json
import os
import pty
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from pointpred.registry import RECOMMENDED, REGISTRY
from pointpred_server.cli.service_start import ServiceStart, changed_settings
from pointpred_server.settings import Settings
from tests.server.compiler import FakeProcesses
from tests.server.running import PATIENCE_S

MAKEFILE = Path(__file__).parents[2] / "Makefile"
SERVE = [sys.executable, "-m", "pointpred", "serve", "--port", "0"]
ADDRESS = r"http://127\.0\.0\.1:\d+/"


def stopped(process: subprocess.Popen[str]) -> str:
    process.send_signal(signal.SIGTERM)
    out, _ = process.communicate(timeout=PATIENCE_S)
    return out


def seen(*more: str) -> tuple[str, str]:
    """What goes to stdout, and to a terminal as stderr, until all is ready."""
    here, there = pty.openpty()
    process = subprocess.Popen([*SERVE, *more], stdout=subprocess.PIPE, stderr=there, text=True)
    os.close(there)
    shown, until = b"", time.monotonic() + 2 * PATIENCE_S  # all code may have to be compiled
    try:
        while b"Ready" not in shown or not shown.endswith(b"\n"):
            assert time.monotonic() < until, shown
            shown += os.read(here, 4096)
        return stopped(process), shown.decode()
    finally:
        process.kill()
        process.wait()
        os.close(here)


def test_in_a_terminal_the_progress_is_one_line_and_the_address_comes_last() -> None:
    out, shown = seen("--max-sessions", "3")
    assert re.fullmatch(ADDRESS + r"\n", out)
    lines = [line.rpartition("\x1b[2K")[2].strip() for line in shown.split("\n")[:-1]]
    left = [line for line in lines if line]
    assert left[0] == "Settings: port 0, max_sessions 3; everything else default"
    assert left[-1] == f"Ready: open {out.strip()} in a browser. Ctrl-C stops."
    assert len(left) == 2, "a line that stays on the screen between"
    assert "{" not in shown


def test_a_made_up_token_is_shown_once() -> None:
    out, shown = seen("--host", "0.0.0.0")
    token = out.strip().partition("?token=")[2]
    assert len(token) > 20
    assert token not in shown
    assert "with the token in a browser" in shown


def test_elsewhere_entries_are_json_and_the_settings_can_say_otherwise() -> None:
    process = subprocess.Popen(SERVE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert process.stdout is not None
    assert process.stderr is not None
    lines: list[str] = []
    try:
        while not lines or not lines[-1].startswith("Ready"):
            lines.append(process.stderr.readline())
            assert lines[-1], lines
    finally:
        process.terminate()
        out, _ = process.communicate(timeout=PATIENCE_S)
    assert re.fullmatch(ADDRESS + r"\n", out)
    entries = [json.loads(line) for line in lines if not line.startswith(("Settings", "Ready"))]
    assert {entry["message"].split(":")[0] for entry in entries} <= {"Compiling once"}, "loading is no news"
    assert "\x1b" not in "".join(lines)


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        (Settings(), "all default"),
        (Settings(token="open-sesame-9", idle_s=5), "token ***, idle_s 5.0; everything else default"),
        (Settings(allow_host=["lab.example"]), "allow_host ['lab.example']; everything else default"),
    ],
)
def test_only_settings_of_ones_own_are_told(settings: Settings, words: str) -> None:
    assert changed_settings(settings) == words


def test_setting_up_says_that_it_takes_a_while() -> None:
    runs, _, ready = MAKEFILE.read_text(encoding="utf-8").partition("$(RUNS): ")[2].partition("$(READY): ")
    assert runs.index("about half a minute") < runs.index("-m venv") < runs.index("'.[live,client]'")
    assert ready.index("about a minute") < ready.index("$(INSTALL) '.[dev]'")


class Terminal(io.StringIO):
    """A screen that somebody looks at."""

    def isatty(self) -> bool:
        return True


def test_what_is_compiled_is_one_line_that_goes_when_all_is_done() -> None:
    compiler, screen = FakeProcesses(), Terminal()
    compiling = compiler.compiling([RECOMMENDED, "ktm"])
    ServiceStart(Settings(), "http://127.0.0.1:1/", screen).watch(compiling)
    compiler.allow()
    compiling.start()
    compiling.join()
    shown = screen.getvalue()
    assert shown.count("\n") == 2, "the settings, and that it is ready"
    far = [line for line in re.split(r"[\n\r]", shown) if "only this once" in line]
    count = len(REGISTRY)
    assert {f"0 of {count}, {RECOMMENDED}", f"1 of {count}, ktm"} <= {
        line.rpartition(": ")[2] for line in far
    }
    assert shown.endswith("\x1b[2K")
