"""The npm package: what it exports is there, at the version of the project, and nothing else goes with it."""

from __future__ import annotations

import json
import shutil
import subprocess
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
LIB = ROOT / "server" / "pointpred_server" / "web" / "lib"
PACKAGE = json.loads((LIB / "package.json").read_text())
NPM = shutil.which("npm")
NODE = shutil.which("node")


def test_the_version_and_the_licence_are_those_of_the_project() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    assert PACKAGE["version"] == project["version"]
    assert PACKAGE["license"] == project["license"]
    assert "dependencies" not in PACKAGE


def test_what_is_exported_is_there() -> None:
    for entry in PACKAGE["exports"].values():
        for path in entry.values():
            assert (LIB / path).is_file(), path


@pytest.mark.skipif(NPM is None, reason="no npm on this machine")
def test_what_belongs_goes_with_it() -> None:
    told = subprocess.run(
        ["npm", "pack", "--dry-run", "--json"], cwd=LIB, capture_output=True, text=True, check=True
    )
    files = {one["path"] for one in json.loads(told.stdout)[0]["files"]}
    assert {"index.js", "index.d.ts", "intent/index.js", "laws/kinematic.js", "prediction/build.js"} <= files
    rooms = {path.partition("/")[0] for path in files}
    assert rooms <= {*PACKAGE["files"], "package.json", "LICENSE", "NOTICE", "README.md"}


@pytest.mark.skipif(NODE is None, reason="no node on this machine")
def test_it_is_imported_by_its_names_without_a_page(tmp_path: Path) -> None:
    """A server that renders pages imports the same modules."""
    (tmp_path / "node_modules").mkdir()
    (tmp_path / "node_modules" / "pointpred").symlink_to(LIB)
    script = tmp_path / "use.mjs"
    script.write_text(
        'import { build, connect, onIntent, prefetchLink, regionOf } from "pointpred";\n'
        'import * as intent from "pointpred/intent";\n'
        'import { vIntent } from "pointpred/vue";\n'
        'const pipeline = await build("minimum-jerk");\n'
        "for (let i = 0; i < 30; i += 1) pipeline.update({ t: i / 100, x: i * i, y: 0 });\n"
        "const { x } = pipeline.update({ t: 0.3, x: 900, y: 0 });\n"
        "console.log(intent.onIntent === onIntent, x > 900, typeof vIntent.mounted, typeof prefetchLink);\n"
    )
    told = subprocess.run(["node", str(script)], capture_output=True, text=True, check=False)
    assert told.stdout.strip() == "true true function function", told.stderr


def test_the_licence_goes_with_it() -> None:
    for name in ("LICENSE", "NOTICE"):
        assert (LIB / name).read_text() == (ROOT / name).read_text()
