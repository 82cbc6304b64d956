"""Folders with packages of npm and this package as `npm pack` makes it, where npm can fetch them."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from tests.intent.packed import pack

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
INSTALL = ("npm", "install", "--loglevel=error", "--no-audit", "--no-fund")


def install(folder: Path, *packages: str) -> None:
    """Install packages and this one into a folder; skips the test where npm cannot fetch them."""
    if shutil.which("npm") is None:
        pytest.skip("no npm on this machine")
    write(folder, {"package.json": '{ "private": true, "type": "module" }'})
    fetched = subprocess.run([*INSTALL, *packages], cwd=folder, capture_output=True, text=True, timeout=500)
    if fetched.returncode:
        pytest.skip(f"npm cannot fetch {', '.join(packages)}: {fetched.stderr.strip()[-500:]}")
    run([*INSTALL, str(pack(folder))], folder)


def run(command: list[str], folder: Path) -> subprocess.CompletedProcess[str]:
    """Run a command in a folder; fails the test where it fails."""
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=500)
    assert done.returncode == 0, f"{' '.join(command)}\n{done.stdout[-3000:]}\n{done.stderr[-3000:]}"
    return done


def write(folder: Path, files: dict[str, str]) -> None:
    """Write files by their paths in a folder."""
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, "utf-8")
