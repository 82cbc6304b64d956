"""Opens a page in a browser and returns what the page posts."""

from __future__ import annotations

import json
import shutil
import subprocess
import threading
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import pytest

from tests.server.browser import BROWSER, QUIET

FIREFOX = shutil.which("firefox-esr") or shutil.which("firefox")
PATIENCE_S = 120.0
ROOT = Path(__file__).parents[2]
FOLDERS = {"laws": ROOT / "server" / "pointpred_server" / "web" / "lib" / "laws"}
"""Addresses that begin with such a word lead to this folder, all others to that of the tests."""

COMMANDS = {
    "chromium": [BROWSER or "", *QUIET],
    "firefox": [FIREFOX or "", "--headless", "--no-remote", "--new-instance"],
}
KINDS = [
    pytest.param("chromium", marks=pytest.mark.skipif(BROWSER is None, reason="no chromium on this machine")),
    pytest.param("firefox", marks=pytest.mark.skipif(FIREFOX is None, reason="no firefox on this machine")),
]


def posted(kind: str, page: str, cases: bytes, profile: Path) -> Any:
    """What a page beside this file posts to ``/result`` in a browser of this kind.

    ``cases`` is what it gets from ``/cases.json``.
    """
    arrived = threading.Event()
    results: list[Any] = []

    class Handler(SimpleHTTPRequestHandler):
        def translate_path(self, path: str) -> str:
            first, _, rest = path.partition("?")[0].lstrip("/").partition("/")
            return str(FOLDERS[first] / rest if first in FOLDERS else Path(__file__).parent / first)

        def do_GET(self) -> None:
            if self.path != "/cases.json":
                super().do_GET()
                return
            self.send_response(200)
            self.send_header("Content-Type", "application/json")
            self.end_headers()
            self.wfile.write(cases)

        def do_POST(self) -> None:
            results.append(json.loads(self.rfile.read(int(self.headers["Content-Length"]))))
            self.send_response(204)
            self.end_headers()
            arrived.set()

        def log_message(self, format: str, *values: object) -> None:
            """Requests are not printed."""

    with ThreadingHTTPServer(("127.0.0.1", 0), Handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        address = f"http://127.0.0.1:{server.server_address[1]}/{page}"
        own = ["--profile", str(profile)] if kind == "firefox" else [f"--user-data-dir={profile}"]
        profile.mkdir(exist_ok=True)
        command = [*COMMANDS[kind], *own, address]
        with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
            came = arrived.wait(PATIENCE_S)
            process.terminate()
        server.shutdown()
    assert came, f"{kind} posted nothing"
    return results[0]
