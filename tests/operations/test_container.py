"""``make container``: the image is built, run as the guide runs it and behind a proxy by deploy/compose.yaml.

With docker or podman, whichever answers. ``BASE`` and ``PROXY`` name images to use instead of Python's and
HAProxy's from Docker Hub.
"""

from __future__ import annotations

import json
import os
import shutil
import socket
import ssl
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from urllib.error import URLError
from urllib.request import urlopen

import numpy as np
import pytest

from pointpred import build, run
from pointpred.client import connect
from pointpred.datasets import sample
from tests.server.reverse_proxies import OPENSSL, certificate

ROOT = Path(__file__).parents[2]
TOKEN = "open-sesame-9-open-sesame-9"
MOST_BYTES = 350e6
FIRST_ANSWER_S = 2.0
PATIENCE_S = 60.0
STARTS = 3
ON_THE_WIRE = 9
"""Columns of a prediction that are sent."""

pytestmark = [pytest.mark.slow, pytest.mark.timeout(1200)]


def done(*command: str | Path, **environment: str) -> str:
    """What a command prints; its errors are this test's."""
    ran = subprocess.run(command, capture_output=True, text=True, env={**os.environ, **environment})
    assert ran.returncode == 0, f"{command}\n{ran.stdout[-4000:]}\n{ran.stderr[-4000:]}"
    return ran.stdout.strip()


def free_port() -> int:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        return int(free.getsockname()[1])


@pytest.fixture(scope="module")
def engine() -> str:
    """The first of docker and podman that answers."""
    for name in ("docker", "podman"):
        if shutil.which(name) and subprocess.run([name, "info"], capture_output=True).returncode == 0:
            return name
    pytest.skip("neither docker nor podman is installed and runs containers")


@pytest.fixture(scope="module")
def image(engine: str) -> str:
    """The image, built from the Dockerfile."""
    base = ["--build-arg", f"BASE={os.environ['BASE']}"] if os.environ.get("BASE") else []
    # Podman's own format has no health check.
    form = ["--format", "docker"] if engine == "podman" else []
    done(engine, "build", "--quiet", "--tag", "pointpred", *form, *base, ROOT)
    return "pointpred"


@contextmanager
def started(engine: str, image: str, *options: str) -> Iterator[tuple[str, str, float]]:
    """A container until the block ends: its identity, its URL, and when its start was asked for."""
    port, begun = free_port(), time.monotonic()
    options = ("--cap-drop", "ALL", "--security-opt", "no-new-privileges", *options)
    published = ("-e", f"POINTPRED_TOKEN={TOKEN}", "-p", f"127.0.0.1:{port}:8765")
    container = done(engine, "run", "--detach", *options, *published, image).splitlines()[-1]
    try:
        yield container, f"http://127.0.0.1:{port}", begun
    finally:
        done(engine, "rm", "--force", container)


def wait_until_ready(url: str, trusted: ssl.SSLContext | None = None) -> None:
    until = time.monotonic() + PATIENCE_S
    while True:
        try:
            with urlopen(f"{url}/readyz", timeout=5, context=trusted):
                return
        except (URLError, OSError):
            assert time.monotonic() < until, f"{url} is not ready"
            time.sleep(0.01)


def assert_predicts(url: str) -> None:
    """A movement gets the predictions that it gets without a service, bit for bit."""
    events = sample().rows(0)
    expected = run(build("switched"), events)
    with connect(url, token=TOKEN, predictor="switched", reply="event") as session:
        session.send(events)
        predicted = session.columns()
    np.testing.assert_array_equal(predicted.table[:, :ON_THE_WIRE], expected.table[:, :ON_THE_WIRE])


def inspected(engine: str, container: str) -> dict[str, Any]:
    (found,) = json.loads(done(engine, "container", "inspect", container))
    return dict(found)


def waited_s(engine: str, container: str) -> float:
    """How long the service's main thread was ready to run and had no processor, where Linux tells."""
    file = Path(f"/proc/{inspected(engine, container)['State']['Pid']}/schedstat")
    return int(file.read_text().split()[1]) / 1e9 if file.exists() else 0.0


def test_the_image_is_small(engine: str, image: str) -> None:
    size = int(done(engine, "image", "inspect", "--format", "{{.Size}}", image))
    print(f"\nsize of the image: {size / 1e6:.0f} MB")
    assert size <= MOST_BYTES


def test_it_answers_soon_without_rights_or_anywhere_to_write(engine: str, image: str) -> None:
    nowhere = ["--read-only", *(["--read-only-tmpfs=false"] if engine == "podman" else [])]
    took, waited = [], []
    for _ in range(STARTS):
        with started(engine, image, *nowhere) as (container, url, begun):
            wait_until_ready(url)
            assert_predicts(url)
            took.append(time.monotonic() - begun)
            waited.append(waited_s(engine, container))
            health = inspected(engine, container)["Config"]["Healthcheck"]["Test"]
            assert health[0] == "CMD"
            done(engine, "exec", container, *health[1:])
            status = done(engine, "exec", container, "cat", "/proc/1/status")
            rows = dict(row.split(":\t", 1) for row in status.splitlines())
            assert set(rows["Uid"].split() + rows["Gid"].split()) == {"65532"}
            assert all(int(rows[name], 16) == 0 for name in ("CapPrm", "CapEff", "CapBnd"))
            assert rows["NoNewPrivs"] == "1"
            done(engine, "stop", container)
            assert inspected(engine, container)["State"]["ExitCode"] == 0
    times = "; ".join(f"{all_:.2f} s, of them {part:.2f} s" for all_, part in zip(took, waited, strict=True))
    print(f"\nfrom `{engine} run` to the first prediction, and waiting for a processor: {times}")
    # Other work on this machine only adds.
    assert min(np.subtract(took, waited)) <= FIRST_ANSWER_S


def test_it_writes_nothing_where_it_could(engine: str, image: str) -> None:
    with started(engine, image) as (container, url, _):
        wait_until_ready(url)
        assert_predicts(url)
        done(engine, "exec", container, "/opt/pointpred/bin/python", "-I", "/opt/pointpred/healthy.py")
        changed = done(engine, "diff", container).splitlines()
    # Docker and podman lay a few files of /etc and /run for every container.
    assert not [line for line in changed if line.split()[1].split("/")[1] not in ("etc", "run")]


def test_every_module_is_imported_there(engine: str, image: str) -> None:
    """What was left out of numpy and pyarrow is not missed."""
    python = ("--entrypoint", "/opt/pointpred/bin/python", image, "-W", "ignore", "-c")
    done(engine, "run", "--rm", *python, IMPORTS)
    assert "compiled" in done(engine, "run", "--rm", image, "doctor")


IMPORTS = """
import importlib, pkgutil, pointpred, pointpred_server
for package in pointpred, pointpred_server:
    for module in pkgutil.walk_packages(package.__path__, package.__name__ + "."):
        importlib.import_module(module.name)
"""


@pytest.fixture
def compose(engine: str) -> list[str]:
    if (
        engine == "docker"
        and not subprocess.run(["docker", "compose", "version"], capture_output=True).returncode
    ):
        return ["docker", "compose"]
    if engine == "podman" and (found := shutil.which("podman-compose")):
        return [found]
    pytest.skip("neither docker compose nor podman-compose is installed")


@pytest.mark.skipif(OPENSSL is None, reason="openssl is not installed")
def test_a_proxy_has_the_only_port(
    engine: str, image: str, compose: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    crt, key = certificate(tmp_path)
    pem, port = tmp_path / "lab.pem", free_port()
    pem.write_text(crt.read_text() + key.read_text())
    pem.chmod(0o444)  # the proxy is another user
    monkeypatch.setenv("SSL_CERT_FILE", str(crt))  # clients believe it
    settings = {"POINTPRED_TOKEN": TOKEN, "POINTPRED_ALLOW_HOST": "localhost"}
    settings |= {"PORT": str(port), "CERTIFICATE": str(pem)}
    command = [*compose, "-f", str(ROOT / "deploy/compose.yaml"), "-p", f"pointpred-{port}"]
    try:
        done(*command, "up", "--detach", **settings)
        url = f"https://localhost:{port}"
        wait_until_ready(url, ssl.create_default_context(cafile=crt))
        assert_predicts(url)
        running = done(
            engine, "ps", "--filter", f"name=pointpred-{port}", "--format", "{{.Names}} {{.Ports}}"
        )
        published = dict(line.split(" ", 1) for line in running.splitlines() if "->" in line)
        assert len(running.splitlines()) == 3
        (name,) = published
        assert "proxy" in name
        assert "->443/tcp" in published[name]
    finally:
        done(*command, "down", **settings)
