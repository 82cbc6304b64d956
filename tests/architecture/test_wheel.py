"""Wheels of one version: the library without web framework and solver, the service, the observers."""

from __future__ import annotations

import importlib.metadata
import os
import shutil
import subprocess
import sys
import sysconfig
import zipfile
from importlib.util import find_spec
from pathlib import Path

import pytest

from tests.architecture.tree import PACKAGES, ROOT, module_of, package_files

NEEDED = 77  # the first setuptools that reads a licence expression
INSTALLED = int(importlib.metadata.version("setuptools").split(".")[0])
LEFT = shutil.ignore_patterns(".*", "__pycache__", "*.egg-info", "build", "dist", "tests")
OPTIONAL = {
    *("fastapi", "prometheus_client", "pydantic_settings", "starlette", "uvicorn", "uvloop"),
    *("websockets", "hidraw", "Xlib", "pylsl"),
    *("clarabel", "cvxpy", "sympy"),
}
"""Libraries of the service, of the observers, of the extras ``client`` and ``live``: not of the library."""

CHECK = """
import pkgutil, importlib, pointpred, pointpred.datasets
from pointpred.errors import MissingExtraError
assert pointpred.__file__.startswith({folder!r}), pointpred.__file__
assert len(pointpred.datasets.sample().trials) == 240
for name in ("server", "datasets", "pointpred_server", "pointpred_observers"):
    assert importlib.util.find_spec(name) is None
for module in pkgutil.walk_packages(pointpred.__path__, "pointpred.", onerror=lambda name: None):
    if module.name == "pointpred.__main__":
        continue
    try:
        importlib.import_module(module.name)
    except MissingExtraError as missing:
        assert "[client]" in str(missing), module.name
from pointpred.reproduction.catalogue import entry_of
assert "</svg>" in entry_of("2.11").make(None).draw().svg
"""


@pytest.fixture(scope="module")
def wheels(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """The wheel of each package."""
    if INSTALLED < NEEDED:
        pytest.skip(f"building needs setuptools {NEEDED}, the environment has {INSTALLED}")
    folder = tmp_path_factory.mktemp("wheel")
    source = folder / "source"
    shutil.copytree(ROOT, source, ignore=LEFT)
    command = [sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps", "--no-build-isolation"]
    places = [str(source / place.relative_to(ROOT)) for place in PACKAGES.values()]
    quickly = {**os.environ, "CFLAGS": "-O0"}  # the laws of these wheels are not measured
    command += ["--disable-pip-version-check", "-w", str(folder)]
    subprocess.run([*command, *places], env=quickly, check=True)
    return {path.name.split("-")[0]: path for path in folder.glob("*.whl")}


@pytest.fixture(scope="module")
def library_alone(wheels: dict[str, Path], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the library and what is installed here, but for the service and what only it needs."""
    folder = tmp_path_factory.mktemp("library")
    zipfile.ZipFile(wheels["pointpred"]).extractall(folder)
    for path in Path(sysconfig.get_path("purelib")).iterdir():
        own = path.name.startswith(("pointpred", "__editable__"))
        if not own and path.stem not in OPTIONAL and not (folder / path.name).exists():
            (folder / path.name).symlink_to(path)
    return folder


def run(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    """Run Python with what a folder holds alone."""
    command = [sys.executable, "-S", *arguments]
    environment = {**os.environ, "PYTHONPATH": str(folder)}
    return subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)


@pytest.mark.parametrize("package", PACKAGES)
def test_a_wheel_holds_every_module_of_its_package(wheels: dict[str, Path], package: str) -> None:
    names = set(zipfile.ZipFile(wheels[package]).namelist())
    assert {name.split("/")[0].split("-")[0] for name in names} == {package}
    modules = {module_of(path) for path in package_files()}
    own = {name.replace(".", "/") for name in modules if name.split(".")[0] == package}
    assert own
    assert not {name for name in own if not {f"{name}.py", f"{name}/__init__.py"} & names}
    assert f"{package}/py.typed" in names


def test_wheels_hold_the_templates_the_sample_and_the_page(wheels: dict[str, Path]) -> None:
    library = set(zipfile.ZipFile(wheels["pointpred"]).namelist())
    assert {
        "pointpred/scoring/report/templates/report.html",
        "pointpred/datasets/simulated_circle_samples.parquet",
        "pointpred/datasets/set_left_out/kh2017.npz",
        "pointpred/devices/70-pointpred.rules",
    } <= library
    server = PACKAGES["pointpred_server"]
    page = (path for path in (server / "pointpred_server" / "web").rglob("*") if path.is_file())
    expected = {path.relative_to(server).as_posix() for path in page}
    assert expected <= set(zipfile.ZipFile(wheels["pointpred_server"]).namelist())


def test_a_wheel_of_laws_fits_every_python_from_3_11_and_holds_no_c(wheels: dict[str, Path]) -> None:
    for package, path in wheels.items():
        names = zipfile.ZipFile(path).namelist()
        assert not [name for name in names if name.endswith((".c", ".h"))]
        if list((PACKAGES[package] / package / "laws").glob("*.c")):
            assert "-cp311-abi3-" in path.name
            compiled = [
                name for name in names if name.startswith(f"{package}/_laws.") and not name.endswith("i")
            ]
            assert len(compiled) == int(shutil.which("cc") is not None or find_spec("ziglang") is not None)


def test_the_library_is_whole_without_the_service(library_alone: Path) -> None:
    done = run(library_alone, "-c", CHECK.format(folder=str(library_alone)))
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize(
    ("command", "said"),
    [
        ("serve --port 0", "'pointpred serve' is in pointpred-server, which is not installed"),
        ("demo --help", "'pointpred demo' is in pointpred-server, which is not installed"),
        ("observers example", "'pointpred observers' is in pointpred-observers, which is not installed"),
        ("live --serve", "the page of a device is in pointpred-server, which is not installed"),
        ("replay --to ws://127.0.0.1:1", "needs websockets"),
    ],
)
def test_the_library_says_what_to_install(library_alone: Path, command: str, said: str) -> None:
    done = run(library_alone, "-m", "pointpred", *command.split())
    assert done.returncode == 1
    sentence = done.stderr.splitlines()[-1]
    assert said in sentence
    assert "-m pip install " in sentence
    assert "Traceback" not in done.stderr


def test_doctor_looks_at_the_port_only_where_the_service_is(library_alone: Path) -> None:
    done = run(library_alone, "-m", "pointpred", "doctor")
    assert done.returncode == 0, done.stderr
    assert "prediction" in done.stdout
    assert "pointpred serve" not in done.stdout
