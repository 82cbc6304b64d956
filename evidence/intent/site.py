"""A static host with js.foresight of npm and pointpred's modules, for ``evidence.intent.browser``."""

from __future__ import annotations

import re
import shutil
import subprocess
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

from evidence import ROOT
from evidence.intent.fit import Fitted
from pointpred.predictors.kinematic import coefficient_file
from translation.coefficients import coefficients_text

PACKAGE = "js.foresight@4.2.1"
LIB, HERE = ROOT / "server" / "pointpred_server" / "web" / "lib", Path(__file__).parent
IMPORTS = """<script type="importmap">{"imports": {
  "js.foresight": "/npm/js.foresight/dist/index.mjs",
  "position-observer": "/npm/position-observer/dist/index.js",
  "tabbable": "/npm/tabbable/dist/index.esm.js"}}</script>"""
HTML = f"""<!doctype html><title>side by side</title>
<style>body {{ margin: 0; overflow: hidden }} .target {{ position: absolute; background: #ddd }}</style>
{IMPORTS}
<body><script type="module" src="/beside.js"></script>"""


class NpmMissingError(Exception):
    """Neither npm nor the package can be had; says which."""


def install(folder: Path) -> Path:
    """Fetch ForesightJS into a folder; returns where its modules are. Raises NpmMissingError."""
    if shutil.which("npm") is None:
        raise NpmMissingError("no npm on this machine, and js.foresight comes from there")
    command = ["npm", "install", "--silent", "--no-audit", "--no-fund", "--prefix", str(folder), PACKAGE]
    fetched = subprocess.run(command, capture_output=True, text=True, timeout=300)
    if fetched.returncode:
        raise NpmMissingError(f"npm cannot fetch {PACKAGE}: {fetched.stderr.strip()[-200:]}")
    return folder / "node_modules"


class Site(ThreadingHTTPServer):
    """Serves modules as they are, but for what was fitted to the people who are to come."""

    def __init__(self, modules: Path) -> None:
        super().__init__(("127.0.0.1", 0), partial(_Files, folders={"/npm/": modules, "/pointpred/": LIB}))
        self.changed: dict[str, bytes] = {}

    @property
    def address(self) -> str:
        """Where it is."""
        return f"http://127.0.0.1:{self.server_port}"

    def hold_out(self, coefficients: Path | None, fitted: Fitted) -> None:
        """Serve a file's coefficients (or the package's own), and what was fitted of the policy, instead."""
        laws = "/pointpred/laws/"
        flat = coefficient_file.read(coefficients or coefficient_file.OWN)
        self.changed = {
            f"{laws}kinematic.js": coefficients_text(flat).encode(),
            f"{laws}targets/posterior.js": _with("posterior", "FITTED_PAGES", fitted.evidence),
            f"{laws}targets/prefetch.js": _with("prefetch", "FITTED", fitted.settings),
        }


def _with(law: str, name: str, values: Sequence[float]) -> bytes:
    """A module of the laws with other numbers in a constant; raises ValueError where it has none."""
    text = (LIB / "laws" / "targets" / f"{law}.js").read_text(encoding="utf-8")
    numbers = ", ".join(f"{value:g}" if value else "0" for value in values)
    text, count = re.subn(rf"(export const {name} = [^\[]*\[)[^\]]*", rf"\g<1>{numbers}", text)
    if count != 1:
        raise ValueError(f"{law}.js must have one constant {name}, has {count}")
    return text.encode()


class _Files(SimpleHTTPRequestHandler):
    extensions_map = SimpleHTTPRequestHandler.extensions_map | {".mjs": "text/javascript"}
    server: Site

    def __init__(self, *given: Any, folders: dict[str, Path]) -> None:
        self.folders = folders
        super().__init__(*given)

    def do_GET(self) -> None:
        path = self.path.partition("?")[0]
        if path == "/":
            self.answer(HTML.encode(), "text/html")
        elif path in self.server.changed:
            self.answer(self.server.changed[path], self.guess_type(path))
        else:
            super().do_GET()

    def answer(self, body: bytes, kind: str) -> None:
        self.send_response(200)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def end_headers(self) -> None:
        self.send_header("Cache-Control", "no-store")
        super().end_headers()

    def translate_path(self, path: str) -> str:
        for start, folder in self.folders.items():
            if path.startswith(start):
                return str(folder / path.removeprefix(start).partition("?")[0])
        return str(HERE / "beside.js")

    def log_message(self, format: str, *args: object) -> None:
        pass


@contextmanager
def site(modules: Path) -> Iterator[Site]:
    """A host of its own at a free port."""
    with Site(modules) as server:
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        try:
            yield server
        finally:
            server.shutdown()
            thread.join()
