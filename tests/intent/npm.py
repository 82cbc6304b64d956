"""This package as `npm pack` makes it, and packages of npm, in folders of their own."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
LIB = ROOT / "server" / "pointpred_server" / "web" / "lib"
TOOLS = ROOT / "node_modules" / ".bin"
TRIED = (
    *("react@19.2.0", "react-dom@19.2.0", "vue@3.5.22", "svelte@5", "esbuild@0.25.12"),
    *("typescript@5.9", "vue-tsc@3", "@types/react@19", "@types/node@20"),
    *("playwright-core@1.56", "puppeteer-core@24"),
)
"""What the quick tests of frameworks, types and drivers need. Puppeteer 25 needs a newer Node than 20."""
OLDER = (
    "react@18.3.1",
    "react-dom@18.3.1",
    "svelte@4.2.20",
    "@types/react@18",
    "typescript@5.9",
    "esbuild@0.25.12",
)
"""The oldest versions that the package is made for."""
QUIET = ("--loglevel=error", "--no-audit", "--no-fund")


def pack(folder: Path) -> Path:
    """Pack a copy of this package into a folder; skips the test where npm or a tool of it is missing."""
    if shutil.which("npm") is None:
        pytest.skip("no npm on this machine")
    if not (TOOLS / "esbuild").exists() and attempt(["npm", "ci", *QUIET], ROOT).returncode:
        pytest.skip("npm cannot fetch the tools of package-lock.json")
    shutil.copytree(LIB, folder / "lib")
    packed = run(["npm", "pack", "--silent", "--pack-destination", str(folder)], folder / "lib")
    return folder / packed.stdout.split()[-1]


def install(folder: Path, *packages: str) -> None:
    """Install this package, packed, and others into a folder; skips the test where npm cannot fetch them."""
    tarball = pack(folder)
    write(folder, {"package.json": '{ "private": true, "type": "module" }'})
    fetched = attempt(["npm", "install", *QUIET, *packages], folder)
    if fetched.returncode:
        pytest.skip(f"npm cannot fetch {', '.join(packages)}: {fetched.stderr.strip()[-500:]}")
    run(["npm", "install", *QUIET, f"./{tarball.name}"], folder)


def run(command: list[str], folder: Path) -> subprocess.CompletedProcess[str]:
    """Run a command in a folder; fails the test where it fails."""
    done = attempt(command, folder)
    assert done.returncode == 0, f"{' '.join(command)}\n{done.stdout[-3000:]}\n{done.stderr[-3000:]}"
    return done


def attempt(command: list[str], folder: Path) -> subprocess.CompletedProcess[str]:
    """Run a command in a folder; it finds the tools of the repository."""
    paths = os.environ | {"PATH": f"{TOOLS}{os.pathsep}{os.environ['PATH']}"}
    return subprocess.run(command, cwd=folder, env=paths, capture_output=True, text=True, timeout=500)


def write(folder: Path, files: dict[str, str]) -> None:
    """Write files by their paths in a folder."""
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, "utf-8")
