"""Folders with packages of npm and this package as `npm pack` makes it, where npm can fetch them."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from tests.intent.conftest import LIB

INSTALL = ("npm", "install", "--silent", "--no-audit", "--no-fund")


def install(folder: Path, *packages: str) -> None:
    """Install packages and this one into a folder; skips the test where that is not possible."""
    if shutil.which("npm") is None:
        pytest.skip("no npm on this machine")
    (folder / "package.json").write_text('{ "private": true, "type": "module" }')
    packed = run(["npm", "pack", "--silent", str(LIB)], folder).stdout.split()[-1]
    command = [*INSTALL, *packages]
    fetched = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=500)
    if fetched.returncode:
        pytest.skip(f"npm cannot fetch {', '.join(packages)}: {fetched.stderr.strip()[-200:]}")
    run([*INSTALL, f"./{packed}"], folder)


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
