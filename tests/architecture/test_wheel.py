"""A built wheel holds the whole package and nothing named plain ``server`` or ``datasets``."""

from __future__ import annotations

import importlib.metadata
import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from tests.architecture.tree import ROOT, module_of, package_files

NEEDED = 77  # the first setuptools that reads a licence expression
INSTALLED = int(importlib.metadata.version("setuptools").split(".")[0])
LEFT = shutil.ignore_patterns(".*", "__pycache__", "*.egg-info", "build", "dist", "tests")

CHECK = """
import importlib.util, pointpred_server.app, pointpred.datasets
assert pointpred.__file__.startswith({folder!r}), pointpred.__file__
assert importlib.util.find_spec("server") is None
assert importlib.util.find_spec("datasets") is None
assert (pointpred_server.app.WEB / "index.html").exists()
from pointpred.reproduction.catalogue import entry_of
assert "</svg>" in entry_of("3.4").make(None).draw().svg
"""


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    if INSTALLED < NEEDED:
        pytest.skip(f"building needs setuptools {NEEDED}, the environment has {INSTALLED}")
    folder = tmp_path_factory.mktemp("wheel")
    source = folder / "source"
    shutil.copytree(ROOT, source, symlinks=True, ignore=LEFT)
    command = [sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps", "--no-build-isolation"]
    subprocess.run([*command, "--disable-pip-version-check", "-w", str(folder), str(source)], check=True)
    return next(folder.glob("*.whl"))


def test_wheel_holds_every_module_under_pointpred(wheel: Path) -> None:
    names = set(zipfile.ZipFile(wheel).namelist())
    assert {name.split("/")[0].split("-")[0] for name in names} == {"pointpred"}
    modules = {module_of(path).replace(".", "/") for path in package_files()}
    missing = {name for name in modules if not {f"{name}.py", f"{name}/__init__.py"} & names}
    assert not missing
    assert {"pointpred/py.typed", "pointpred/scoring/report/templates/report.html"} <= names
    page = {path.relative_to(ROOT) for path in (ROOT / "server" / "web").rglob("*") if path.is_file()}
    assert {f"pointpred/{path.as_posix()}" for path in page} <= names


def test_installed_wheel_needs_nothing_of_the_checkout(wheel: Path, tmp_path: Path) -> None:
    zipfile.ZipFile(wheel).extractall(tmp_path)
    environment = {**os.environ, "PYTHONPATH": str(tmp_path)}
    check = CHECK.format(folder=str(tmp_path))
    subprocess.run([sys.executable, "-c", check], check=True, cwd=tmp_path, env=environment)
