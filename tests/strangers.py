"""Installs a release as strangers do, from its files into empty environments, and uses it.

``python tests/strangers.py FOLDER`` needs the files of ``make release`` and an index for the packages of
others, nothing of the project: neither a clone nor its environment. It is for Linux, macOS and Windows; the
npm package is tried where npm is. It prints what each installation took, and ends with an error at the
first thing that does not work.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
import urllib.request
from pathlib import Path

SCRIPTS = "Scripts" if os.name == "nt" else "bin"
PAGE = """
import doctest, importlib.metadata
page = importlib.metadata.metadata({name!r}).get_payload()
examples = doctest.DocTestParser().get_doctest(page, {{}}, {name!r}, None, 0)
assert len(examples.examples) > 5, "the page of the distribution has no examples"
assert doctest.DocTestRunner().run(examples).failed == 0
"""
"""Runs the examples of the page that a distribution brings for an index: its README."""
CLIENT = """
from pointpred.client import connect
with connect({url!r}, predictor="linear") as connection:
    connection.send([(k / 100, 10.0 * k, 5.0) for k in range(20)])
    (prediction,) = connection.predictions()
assert prediction.x > 190.0, prediction
"""
VITE = {
    "package.json": '{ "private": true, "type": "module" }',
    "index.html": '<nav><a href="/next">Next</a></nav><script type="module" src="./main.js"></script>',
    "main.js": 'import { prefetchLink } from "pointpred/minimum-jerk";\nprefetchLink("nav a");\n',
}


class Environment:
    """An empty environment of this Python, into which files of the release are installed."""

    def __init__(self, folder: Path, release: Path) -> None:
        subprocess.run([sys.executable, "-m", "venv", folder], check=True)
        self.folder, self.release, self.empty = folder, release, size(folder)
        self.python = folder / SCRIPTS / "python"

    def install(self, *names: str) -> None:
        """Install distributions, such as ``pointpred[client]``, and print the time and the size."""
        (source,) = self.release.glob("pointpred-*.tar.gz")
        version = source.name.removeprefix("pointpred-").removesuffix(".tar.gz")
        wanted = [f"{name}=={version}" for name in names]
        pip: list[str | Path] = [self.python, "-m", "pip", "--quiet", "--disable-pip-version-check"]
        began = time.monotonic()
        subprocess.run([*pip, "install", "--find-links", self.release, *wanted], check=True)
        took_s = time.monotonic() - began
        subprocess.run([*pip, "check"], check=True, stdout=subprocess.DEVNULL)
        print(
            f"{' '.join(names)}: {took_s:.0f} s, {(size(self.folder) - self.empty) / 1e6:.0f} MB", flush=True
        )

    def run(self, code: str) -> None:
        """Run Python, away from every file but those that are installed."""
        subprocess.run([self.python, "-I", "-c", code], cwd=self.folder, check=True)

    def command(self, *arguments: str) -> str:
        """What ``pointpred ...`` prints."""
        command: list[str | Path] = [self.folder / SCRIPTS / "pointpred", *arguments]
        done = subprocess.run(command, cwd=self.folder, check=True, capture_output=True, encoding="utf-8")
        return done.stdout


def size(folder: Path) -> int:
    """The bytes of the files in a folder."""
    return sum(path.lstat().st_size for path in folder.rglob("*") if not path.is_dir())


def use_library(here: Environment) -> None:
    """The README's examples, by the compiled laws, and scores of the embedded people."""
    here.install("pointpred")
    here.run("import pointpred._laws")
    here.run(PAGE.format(name="pointpred"))
    scores = json.loads(here.command("score", "--predictors", "hold,minimum-jerk", "--json", "-"))
    assert [len(one["predictors"]) for one in scores["sets"]] == [2], scores


def use_service(here: Environment) -> None:
    """A service that is healthy, shows its page and predicts for a client."""
    here.install("pointpred-server")
    command: list[str | Path] = [here.folder / SCRIPTS / "pointpred", "serve", "--port", "0"]
    with subprocess.Popen(command, cwd=here.folder, stdout=subprocess.PIPE, text=True) as service:
        try:
            assert service.stdout is not None
            url = service.stdout.readline().strip()
            with urllib.request.urlopen(f"{url}healthz", timeout=60) as answer:
                assert json.load(answer)["status"] == "ok"
            with urllib.request.urlopen(url, timeout=60) as answer:
                assert b"<html" in answer.read()
            here.run(CLIENT.format(url=url))
        finally:
            service.terminate()


def use_observers(here: Environment) -> None:
    """An observer that is designed and runs, in Python and by the command."""
    here.install("pointpred-observers")
    here.run(PAGE.format(name="pointpred-observers"))
    here.command("observers", "example", "motor", "--out", "motor.json")
    assert "decay" in here.command("observers", "design", "motor.json", "--decay", "5")


def use_everything(here: Environment) -> None:
    """All extras together, and a report, which needs most of them."""
    extras = "client,cluster,live,remote,report,tables,train"
    here.install(f"pointpred[{extras}]", "pointpred-server", "pointpred-observers")
    here.command("doctor")
    here.command("score", "--predictors", "hold,minimum-jerk", "--report", "report.html")
    assert (here.folder / "report.html").stat().st_size > 10_000


def use_in_a_page(folder: Path, release: Path) -> None:
    """A project of Vite that has the tarball in its lock file, installed by ``npm ci`` and built."""
    npm = shutil.which("npm")
    if npm is None:
        print("npm: not here")
        return
    for name, text in VITE.items():
        (folder / name).write_text(text, encoding="utf-8")
    (tarball,) = release.glob("*.tgz")
    shutil.copy(tarball, folder)
    quiet = ["--no-audit", "--no-fund", "--loglevel=error"]
    subprocess.run([npm, "install", *quiet, f"./{tarball.name}", "vite@7.3.8"], cwd=folder, check=True)
    shutil.rmtree(folder / "node_modules")
    began = time.monotonic()
    subprocess.run([npm, "ci", *quiet], cwd=folder, check=True)
    took_s, modules = time.monotonic() - began, folder / "node_modules"
    whole, own = (size(path) / 1e6 for path in (modules, modules / "pointpred"))
    print(f"npm ci: {took_s:.0f} s, {whole:.0f} MB, {own:.1f} of them pointpred")
    subprocess.run([npm, "exec", "--", "vite", "build", "--logLevel", "warn"], cwd=folder, check=True)
    assert any("pointer" in path.read_text("utf-8") for path in (folder / "dist").rglob("*.js"))


def main(release: Path) -> None:
    """Be every kind of stranger, one after another."""
    with tempfile.TemporaryDirectory() as temporary:
        for use in (use_library, use_service, use_observers, use_everything):
            use(Environment(Path(temporary, use.__name__), release))
            shutil.rmtree(Path(temporary, use.__name__))
        Path(temporary, "page").mkdir()
        use_in_a_page(Path(temporary, "page"), release)
    print("a stranger can use all of it")


if __name__ == "__main__":
    if len(sys.argv) != 2 or not list(Path(sys.argv[1]).glob("*.whl")):
        sys.exit("usage: python tests/strangers.py FOLDER, with the files of `make release`")
    main(Path(sys.argv[1]).resolve())
