"""The npm package as its users install it: the tarball of ``npm pack``, in a project of its own."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
LIB = ROOT / "server" / "pointpred_server" / "web" / "lib"
TOOLS = ROOT / "node_modules" / ".bin"
QUIET = ("--silent", "--no-audit", "--no-fund")
PATIENCE_S = 300.0


def run(folder: Path, *command: str) -> subprocess.CompletedProcess[str]:
    """A command in a folder, which finds the tools of the repository."""
    path = f"{TOOLS}{os.pathsep}{os.environ['PATH']}"
    return subprocess.run(
        command,
        cwd=folder,
        env=os.environ | {"PATH": path},
        capture_output=True,
        text=True,
        timeout=PATIENCE_S,
        check=False,
    )


def pack(folder: Path) -> Path:
    """Pack a copy of the package into a folder; skips the test where npm or a tool of it is missing."""
    if shutil.which("npm") is None:
        pytest.skip("no npm on this machine")
    if not (TOOLS / "esbuild").exists() and run(ROOT, "npm", "ci", *QUIET).returncode:
        pytest.skip("npm cannot fetch the tools of package-lock.json")
    shutil.copytree(LIB, folder / "lib")
    packed = run(folder / "lib", "npm", "pack", "--silent", "--pack-destination", str(folder))
    assert packed.returncode == 0, packed.stderr
    return folder / packed.stdout.split()[-1]


def install(folder: Path, *packages: str | Path) -> None:
    """Install packages into a project; skips the test where npm cannot fetch them."""
    if not (folder / "package.json").exists():
        (folder / "package.json").write_text('{ "private": true, "type": "module" }')
    done = run(folder, "npm", "install", *QUIET, *map(str, packages))
    if done.returncode:
        pytest.skip(f"npm cannot fetch {packages}: {done.stderr.strip()[-200:]}")


def files(tarball: Path) -> Sequence[str]:
    """The paths in a tarball."""
    listed = subprocess.run(["tar", "tzf", str(tarball)], capture_output=True, text=True, check=True)
    return [path.removeprefix("package/") for path in listed.stdout.split()]
