"""What the Dockerfile says, and what the image relies on; `make container` builds and runs it."""

from __future__ import annotations

import json
import os
import re
import shutil
import socket
import subprocess
import sys
import threading
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
LINES = (ROOT / "Dockerfile").read_text(encoding="utf-8").replace("\\\n", " ").splitlines()
INSTRUCTIONS = [tuple(line.split(maxsplit=1)) for line in LINES if line and not line.startswith("#")]
STAGES = [place for place, (name, _) in enumerate(INSTRUCTIONS) if name == "FROM"]
FINAL = INSTRUCTIONS[STAGES[-1] :]


def arguments(name: str, instructions: list[tuple[str, ...]] = FINAL) -> list[str]:
    return [rest for found, rest in instructions if found == name]


def test_the_last_stage_carries_no_build_and_needs_no_shell() -> None:
    assert len(STAGES) == 2
    assert not arguments("RUN")
    assert arguments("COPY") == ["--from=build /opt/pointpred /opt/pointpred"]
    for name in ("ENTRYPOINT", "CMD"):
        (command,) = arguments(name)
        assert isinstance(json.loads(command), list)
    (check,) = arguments("HEALTHCHECK")
    assert isinstance(json.loads(check.partition("CMD ")[2]), list)


def test_it_runs_as_nobody_in_particular() -> None:
    (user,) = arguments("USER")
    assert all(int(number) >= 1000 for number in user.split(":"))


def test_the_base_has_a_version() -> None:
    (base,) = arguments("ARG", INSTRUCTIONS)
    assert re.fullmatch(r"BASE=[\w./-]+:\d[\w.-]*", base)
    assert {image.split()[0] for image in arguments("FROM", INSTRUCTIONS)} == {"${BASE}"}


def test_only_what_the_wheel_is_made_of_goes_to_the_build() -> None:
    lines = (ROOT / ".dockerignore").read_text(encoding="utf-8").splitlines()
    rules = [line for line in lines if line and not line.startswith("#")]
    assert rules[0] == "*"
    admitted = {rule[1:] for rule in rules if rule.startswith("!")}
    assert all((ROOT / path).exists() for path in admitted)
    assert not admitted & {".git", ".venv", "tests", "docs"}
    assert {"constraints.txt", "container", "pointpred", "server"} <= admitted  # the Dockerfile names them


class Answer(BaseHTTPRequestHandler):
    """Answers with the status that the server holds."""

    def do_GET(self) -> None:
        status = 404 if self.path != "/readyz" else self.server.status  # type: ignore[attr-defined]
        self.send_response(status)
        self.end_headers()

    def log_message(self, *arguments: object) -> None:
        pass


@pytest.mark.parametrize(("status", "healthy"), [(200, True), (503, False), (401, False)])
def test_the_health_check_asks_whether_it_is_ready(status: int, healthy: bool) -> None:
    with HTTPServer(("127.0.0.1", 0), Answer) as server:
        server.status = status  # type: ignore[attr-defined]
        thread = threading.Thread(target=server.handle_request)
        thread.start()
        left = check(server.server_port)
        thread.join()
    assert (left == 0) == healthy


def test_without_a_service_the_health_check_fails() -> None:
    with socket.socket() as held:  # bound, so that nobody else gets the port, and not listening
        held.bind(("127.0.0.1", 0))
        assert check(held.getsockname()[1]) == 1


def check(port: int) -> int:
    command = [sys.executable, "-I", str(ROOT / "container/healthy.py")]
    environment = {**os.environ, "POINTPRED_PORT": str(port), "http_proxy": "http://127.0.0.1:1"}
    return subprocess.run(command, env=environment, capture_output=True).returncode


def test_hadolint_finds_nothing() -> None:
    linter = shutil.which("hadolint")
    if linter is None:
        pytest.skip("hadolint is not installed")
    run = subprocess.run([linter, ROOT / "Dockerfile"], capture_output=True, text=True)
    assert run.returncode == 0, run.stdout
