"""What tests of faults share: the library that injects them into a service."""

from __future__ import annotations

import os
import shutil
import struct
import subprocess
from pathlib import Path

import pytest

SHIM = Path(__file__).with_name("shim.c")
HANG, ERROR, WALL_CLOCK, HELD_UP = range(4)


class Faults:
    """Faults of a disk and of a clock, switched while a service runs."""

    def __init__(self, library: Path, folder: Path, faulty: Path) -> None:
        self._file = folder / "faults"
        self._file.write_bytes(bytes(32))
        self.faulty = faulty
        """The folder in which writing fails."""
        self.environment = {
            **os.environ,
            "LD_PRELOAD": str(library),
            "FAULTS_FILE": str(self._file),
            "FAULTS_FOLDER": str(faulty),
        }

    def set(self, which: int, value: int) -> None:
        """Switch a fault on, or off with 0."""
        with self._file.open("r+b") as file:
            file.seek(8 * which)
            file.write(struct.pack("<q", value))

    @property
    def held_up(self) -> int:
        """How many writes and syncs have been held up."""
        return int(struct.unpack_from("<q", self._file.read_bytes(), 8 * HELD_UP)[0])


@pytest.fixture(scope="session")
def library(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The library, compiled; without a C compiler the test is skipped."""
    compiler = shutil.which("cc")
    if compiler is None:
        pytest.skip("no C compiler (cc): faults are injected by a small library that is compiled here")
    made = tmp_path_factory.mktemp("shim") / "shim.so"
    subprocess.run([compiler, "-shared", "-fPIC", "-O1", "-Wall", "-o", made, SHIM, "-ldl"], check=True)
    return made


@pytest.fixture
def faults(library: Path, tmp_path: Path) -> Faults:
    """Faults for a service that records into ``kept``."""
    return Faults(library, tmp_path, tmp_path / "kept")


@pytest.fixture
def own_mounts() -> list[str]:
    """The command that gives a program mounts of its own; without the right to that the test is skipped."""
    command = ["unshare", "--mount", "--map-root-user"]
    trial = [*command, "mount", "-t", "tmpfs", "none", "/mnt"]
    if shutil.which("unshare") is None or subprocess.run(trial, capture_output=True, check=False).returncode:
        pytest.skip("this user may not mount a file system of its own (unshare --mount --map-root-user)")
    return command
