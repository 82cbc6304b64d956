"""nginx and HAProxy with the configurations in deploy/, for tests."""

from __future__ import annotations

import os
import re
import shutil
import socket
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
FILES = {"nginx": ROOT / "deploy/nginx.conf", "haproxy": ROOT / "deploy/haproxy.cfg"}
PATHS = f"{os.environ.get('PATH', '')}:/usr/sbin:/usr/local/sbin"  # where Debian installs both
PROGRAMS = {name: shutil.which(name, path=PATHS) for name in ("nginx", "haproxy")}
OPENSSL = shutil.which("openssl")
PATIENCE_S = 60.0


def example() -> dict[str, Any]:
    """The names that the Python example of the guide defines and uses."""
    guide = (ROOT / "docs/guide/proxies.md").read_text("utf-8")
    (text,) = re.findall(r"^```python\n(.*?)^```$", guide, re.DOTALL | re.MULTILINE)
    names: dict[str, Any] = {}
    exec(text, names)
    return names


def replaced(text: str, *pairs: tuple[str, str]) -> str:
    """A text with parts replaced, each of which it has."""
    for before, after in pairs:
        assert before in text, before
        text = text.replace(before, after)
    return text


def certificate(folder: Path) -> tuple[Path, Path]:
    """A certificate for localhost that nobody else has signed, and its key."""
    assert OPENSSL is not None
    crt, key = folder / "lab.crt", folder / "lab.key"
    subprocess.run(
        [
            *(OPENSSL, "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes"),
            *("-keyout", str(key), "-out", str(crt), "-days", "2", "-subj", "/CN=localhost"),
            *("-addext", "subjectAltName=DNS:localhost,IP:127.0.0.1"),
        ],
        check=True,
        capture_output=True,
    )
    return crt, key


def configuration(name: str, folder: Path, port: int, services: list[int], *, tls: bool) -> str:
    """The file in deploy/ with the ports and paths of a test; without TLS as the guide says."""
    text = FILES[name].read_text("utf-8")
    for printed, served in zip((8765, 8766), services, strict=True):
        text = replaced(text, (f"127.0.0.1:{printed}", f"127.0.0.1:{served}"))
    if name == "nginx":
        text = replaced(
            text,
            ("/var/log/nginx/pointpred.log", str(folder / "access.log")),
            ("/var/log/nginx/pointpred-error.log", str(folder / "request-errors.log")),
        )
        if tls:
            crt, key = certificate(folder)
            listening = ("443 ssl", f"127.0.0.1:{port} ssl")
            return replaced(
                text,
                listening,
                ("/etc/ssl/lab.example.crt", str(crt)),
                ("/etc/ssl/lab.example.key", str(key)),
            )
        text = re.sub(r" +ssl_.*\n", "", text)
        return replaced(text, ("listen 443 ssl;", f"listen 127.0.0.1:{port};"))
    if tls:
        crt, key = certificate(folder)
        pem = folder / "lab.pem"
        pem.write_text(crt.read_text() + key.read_text())
        return replaced(
            text, ("bind :443", f"bind 127.0.0.1:{port}"), ("/etc/haproxy/lab.example.pem", str(pem))
        )
    return re.sub(r"bind :443 .*", f"bind 127.0.0.1:{port}", text)


@contextmanager
def proxy(name: str, folder: Path, services: list[int], *, tls: bool) -> Iterator[int]:
    """Run a proxy in front of two services until the block ends; yields its port."""
    program = PROGRAMS[name]
    assert program is not None
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port: int = free.getsockname()[1]
    file = folder / f"{name}.conf"
    file.write_text(configuration(name, folder, port, services, tls=tls))
    if name == "nginx":
        quiet = f"daemon off; pid {folder}/nginx.pid;"
        command = [program, "-p", str(folder), "-c", str(file), "-e", str(folder / "error.log"), "-g", quiet]
    else:
        command = [program, "-db", "-f", str(file)]
    with (folder / "output.log").open("w") as output:
        process = subprocess.Popen(command, stdout=output, stderr=output)
    try:
        _wait_until_open(process, port, folder)
        yield port
    finally:
        process.terminate()
        process.wait(PATIENCE_S)


def _wait_until_open(process: subprocess.Popen[bytes], port: int, folder: Path) -> None:
    until = time.monotonic() + PATIENCE_S
    while time.monotonic() < until:
        assert process.poll() is None, (folder / "output.log").read_text()
        try:
            socket.create_connection(("127.0.0.1", port)).close()
            return
        except OSError:
            time.sleep(0.02)
    raise AssertionError("the proxy does not listen")
