"""What a page loads, as stock bundlers make it, and how soon it predicts.

A page imports ``onIntent`` of an entry of the npm package, or registers with ForesightJS, and a bundler
with its defaults, minifying, makes files of it. Chromium opens the page; counted are the scripts that it
asks for until nothing more comes, compressed with gzip. For the first firing a mouse goes up and down over
links from the start, and each answer of the host waits. Needs npm, node and Chromium.
"""

from __future__ import annotations

import gzip
import json
import math
import os
import shutil
import statistics
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler
from pathlib import Path
from typing import Any, NamedTuple, Protocol

from evidence import ROOT
from evidence.arguments import parse
from evidence.data import Table, keep
from evidence.machine import machine
from tests.hosts import Silent, host
from tests.server import browser

LIB = ROOT / "server" / "pointpred_server" / "web" / "lib"
TOOLS = ROOT / "node_modules" / ".bin"
BUNDLERS = ("esbuild@0.25.12", "vite@7.3.8", "rollup@4.68.8")
FURTHER = ("@rollup/plugin-node-resolve@16.0.3", "@rollup/plugin-terser@0.4.4", "js.foresight@4.2.1")
"""The newest of each that run on Node 20."""
LATENCY_S = 0.15
"""Before each answer of the host."""
VISITS = 5
SCRIPTS = ("minimum-jerk.min.js", "pointpred.min.js")
LINKS = 20
STILL_S = 3.5
"""Nothing more is asked for afterwards: what waits for an idle page has come within two seconds."""
OURS = """import {{ onIntent }} from "{entry}";
for (const one of document.querySelectorAll("a"))
  onIntent(one, ({{ reason }}) => fired(reason));
"""
THEIRS = """import { ForesightManager } from "js.foresight";
for (const element of document.querySelectorAll("a"))
  ForesightManager.instance.register({ element, callback: () => fired("unknown") });
"""
TAG = """for (const one of document.querySelectorAll("a"))
  pointpred.onIntent(one, ({ reason }) => fired(reason));
"""
SUBJECTS = {
    "`pointpred/minimum-jerk`": OURS.format(entry="pointpred/minimum-jerk"),
    "`pointpred/kinematic-adaptive`": OURS.format(entry="pointpred/kinematic-adaptive"),
    "`pointpred/intent`": OURS.format(entry="pointpred/intent"),
    "`js.foresight`": THEIRS,
}
COMMANDS = {
    "esbuild": "esbuild main.js --bundle --splitting --minify --format=esm --outdir=dist/assets",
    "vite": "vite build --logLevel error",
    "rollup": "rollup main.js -d dist/assets -p node-resolve -p terser --silent",
}
HTML = """<!doctype html><title>links</title><style>a { display: block; height: 30px }</style>HEAD
<script>
  window.fired = (reason) => {
    window.first ??= performance.now();
    if (reason === "predicted") window.ahead ??= performance.now();
  };
  const began = performance.now();
  setInterval(() => {
    const clientY = 300 + 290 * Math.sin((performance.now() - began) / 200);
    const move = { clientX: 40, clientY, pointerType: "mouse", isPrimary: true, bubbles: true };
    document.body?.dispatchEvent(new PointerEvent("pointermove", move));
  }, 8);
</script>
<body style="margin: 0">LINKS
""".replace("LINKS", '<a href="#there">there</a>' * LINKS)
"""Links below each other, and a mouse that goes up and down over them; HEAD is what comes before."""


class NpmMissingError(Exception):
    """Neither npm nor what it should fetch can be had; says which."""


class Loaded(NamedTuple):
    """What a page asked for: how many scripts, their bytes compressed.

    When it first fired, and when it first did so before the entry, which ForesightJS does not tell, s.
    """

    requests: int
    size: int
    first_s: float
    ahead_s: float


class Load(Protocol):
    """Opens the page of a folder."""

    def __call__(self, folder: Path, latency_s: float = 0.0, still_s: float = STILL_S) -> Loaded:
        """Each answer waits so long, and the page stays open so long."""


def run(folder: Path, command: str) -> None:
    """Run a command that npm has installed; raises RuntimeError where it fails."""
    paths = (folder / "node_modules" / ".bin", TOOLS, os.environ["PATH"])
    path = os.pathsep.join(map(str, paths))
    done = subprocess.run(
        command.split(), cwd=folder, env=os.environ | {"PATH": path}, capture_output=True, text=True
    )
    if done.returncode:
        raise RuntimeError(f"{command}: {done.stderr[-500:]}")


def project(folder: Path) -> Path:
    """Install the packed package, the bundlers and ForesightJS into a folder. Raises NpmMissingError."""
    if shutil.which("npm") is None:
        raise NpmMissingError("no npm on this machine")
    if not (TOOLS / "esbuild").exists():
        raise NpmMissingError("the tools of package-lock.json are not installed: npm ci")
    copy = folder / "lib"
    shutil.copytree(LIB, copy)
    run(copy, "npm pack --silent --pack-destination ..")
    (tarball,) = folder.glob("pointpred-*.tgz")
    (folder / "package.json").write_text('{ "private": true, "type": "module" }')
    packages = (f"./{tarball.name}", *BUNDLERS, *FURTHER)
    try:
        run(folder, f"npm install --silent --no-audit --no-fund {' '.join(packages)}")
    except RuntimeError as failed:
        raise NpmMissingError(str(failed)) from failed
    return folder


def bundle(folder: Path, source: str, bundler: str) -> Path:
    """What a bundler makes of a page with a source, in a project; the folder to serve."""
    made = folder / "dist"
    shutil.rmtree(made, ignore_errors=True)
    (folder / "main.js").write_text(source)
    tag = '<script type="module" src="./main.js"></script>'
    (folder / "index.html").write_text(HTML.replace("HEAD", "") + tag)
    run(folder, COMMANDS[bundler])
    if bundler != "vite":
        (made / "index.html").write_text(
            (folder / "index.html").read_text().replace("./main.js", "./assets/main.js")
        )
    return made


def script_tag(folder: Path, script: str) -> Path:
    """A page with a file of the package for a script tag, in a project; the folder to serve."""
    made = folder / "tag"
    made.mkdir(exist_ok=True)
    shutil.copy(folder / "node_modules" / "pointpred" / script, made)
    (made / "index.html").write_text(
        HTML.replace("HEAD", f'<script src="{script}"></script>') + f"<script>{TAG}</script>"
    )
    return made


def plain(folder: Path, entry: str, preload: bool) -> Path:
    """A page with the modules of the package as they are; the folder to serve."""
    made = folder / "plain"
    if not made.exists():
        shutil.copytree(folder / "node_modules" / "pointpred", made / "pointpred")
    links = "".join(
        f'<link rel="modulepreload" href="{path}">' for path in (_reached(made, entry) if preload else ())
    )
    source = OURS.format(entry=f"./pointpred/{entry}")
    (made / "index.html").write_text(HTML.replace("HEAD", links) + f'<script type="module">{source}</script>')
    return made


def _reached(folder: Path, entry: str) -> list[str]:
    """The modules that an entry imports at once."""
    metafile = folder / "meta.json"
    run(
        folder,
        f"esbuild pointpred/{entry} --bundle --splitting --format=esm --outdir=out --metafile={metafile}"
        " --log-level=error",
    )
    inputs = json.loads(metafile.read_text())["inputs"]
    waiting, found = [f"pointpred/{entry}"], []
    while waiting:
        path = waiting.pop(0)
        if path not in found:
            found.append(path)
            waiting += [one["path"] for one in inputs[path]["imports"] if one["kind"] == "import-statement"]
    shutil.rmtree(folder / "out")
    return found


class Slow(Silent, SimpleHTTPRequestHandler):
    """The files of a folder, each some time after it was asked for; notes which."""

    protocol_version = "HTTP/1.1"

    def __init__(self, *given: Any, asked: list[str], latency_s: float, directory: str) -> None:
        self.asked, self.latency_s = asked, latency_s
        super().__init__(*given, directory=directory)

    def do_GET(self) -> None:
        """Answer a request."""
        self.asked.append(self.path)
        time.sleep(self.latency_s)
        super().do_GET()


@contextmanager
def chromium(profile: Path) -> Iterator[Load]:
    """A browser, as what opens the page of a folder."""
    with browser.running(profile) as running:

        def load(folder: Path, latency_s: float = 0.0, still_s: float = STILL_S) -> Loaded:
            asked: list[str] = []
            handler = partial(Slow, asked=asked, latency_s=latency_s, directory=str(folder))
            with host(handler) as origin, running.tab(f"{origin}/index.html") as page:
                page.wait_for_timeout(1000 * still_s)
                first, ahead = page.evaluate("[window.first ?? NaN, window.ahead ?? NaN]")
            scripts = [folder / path.lstrip("/") for path in asked if path.endswith(".js")]
            size = sum(len(gzip.compress(path.read_bytes(), 9)) for path in scripts)
            return Loaded(len(scripts), size, first / 1000.0, ahead / 1000.0)

        yield load


def sizes(folder: Path, load: Load) -> Table:
    """What each bundler makes of each entry, in a project."""
    rows = []
    for name, source in SUBJECTS.items():
        for bundler in COMMANDS:
            count, size, *_ = load(bundle(folder, source, bundler))
            rows.append((name, bundler, str(count), f"{size / 1000.0:.1f}"))
    for script in SCRIPTS:
        count, size, *_ = load(script_tag(folder, script))
        rows.append((f"`{script}`", "none: a script tag", str(count), f"{size / 1000.0:.1f}"))
    return Table.of(("imported", "bundler", "requests", "kB"), rows)


def first_predictions(folder: Path, load: Load) -> Table:
    """When a page first fires while each of its files comes late: medians of some visits."""
    makes: dict[str, Callable[[], Path]] = {
        f"`{name}`, a script tag": partial(script_tag, folder, name) for name in SCRIPTS
    }
    for name, source in SUBJECTS.items():
        makes[f"{name}, Vite"] = partial(bundle, folder, source, "vite")
    makes["modules as they are"] = partial(plain, folder, "intent/index.js", False)
    makes["modules as they are, with `modulepreload`"] = partial(plain, folder, "intent/index.js", True)
    rows = []
    for name, make in makes.items():
        made = make()
        visits = [load(made, LATENCY_S) for _ in range(VISITS)]
        first = statistics.median(visit.first_s for visit in visits)
        ahead = statistics.median(visit.ahead_s for visit in visits)
        rows.append((name, f"{first:.2f}", "-" if math.isnan(ahead) else f"{ahead:.2f}"))
    return Table.of(("page", "first firing, s", "first before the entry, s"), rows)


def main() -> None:
    """Measure, print and write."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as name:
        folder = project(Path(name))
        with chromium(folder / "profile") as load:
            load(script_tag(folder, SCRIPTS[0]))  # what a browser does only once
            tables = {"loaded": sizes(folder, load), "first": first_predictions(folder, load)}
    for table in tables.values():
        for row in table.rows:
            print("  ".join(map(str, row)))
    keep("costs", tables, part="page_size", machine=machine())


if __name__ == "__main__":
    parse(__doc__)
    main()
