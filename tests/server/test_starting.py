"""What is read by a person at a terminal, and by a program, while the service starts."""

from __future__ import annotations

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

from pointpred_server.cli.service_start import changed_settings
from pointpred_server.settings import Settings
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
    shown, until = b"", time.monotonic() + 2 * PATIENCE_S
    try:
        while b"Ready" not in shown or not shown.endswith(b"\n"):
            assert time.monotonic() < until, shown
            shown += os.read(here, 4096)
        return stopped(process), shown.decode()
    finally:
        process.kill()
        process.wait()
        os.close(here)


def test_in_a_terminal_the_settings_come_first_and_the_address_last(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("POINTPRED_MAX_SESSIONS", "3")
    out, shown = seen()
    assert re.fullmatch(ADDRESS + r"\n", out)
    assert [line.strip() for line in shown.splitlines()] == [
        "Settings: port 0, max_sessions 3; everything else default",
        f"Ready: open {out.strip()} in a browser. Ctrl-C stops.",
    ]


def test_a_made_up_token_is_shown_once() -> None:
    out, shown = seen("--host", "0.0.0.0")
    token = out.strip().partition("?token=")[2]
    assert len(token) > 20
    assert token not in shown
    assert "with the token in a browser" in shown


def test_elsewhere_every_line_is_an_entry_in_json() -> None:
    process = subprocess.Popen(SERVE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert process.stdout is not None
    assert process.stderr is not None
    said: list[str] = []
    try:
        while not said or not said[-1].startswith("Ready"):
            said.append(json.loads(process.stderr.readline())["message"])
    finally:
        process.terminate()
        out, _ = process.communicate(timeout=PATIENCE_S)
    assert re.fullmatch(ADDRESS + r"\n", out)
    assert [one.partition(":")[0] for one in said] == ["Settings", "Ready"]


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
