"""The laws in C under the sanitizers of addresses and of undefined behaviour, by the tests that run them."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.architecture.tree import ROOT

GCC = shutil.which("gcc")
FLAGS = "-fsanitize=address,undefined,float-cast-overflow"
FOLDERS = {"pointpred": ROOT, "pointpred_observers": ROOT / "observers"}
TESTS = (
    *("contract/test_single_stages.py", "contract/test_stage_laws.py", "unit/test_predictors_mixture.py"),
    *("unit/test_predictors_places.py", "unit/test_regression_delay.py", "unit/test_regions.py"),
    *("unit/test_scoring_metrics.py", "unit/test_scoring_targets.py", "unit/test_simulation_people.py"),
    *("unit/test_targets_decision.py", "unit/test_targets_prefetch.py", "unit/test_targets_account.py"),
    *("unit/test_targets_aim.py", "unit/test_targets_endpoint.py", "unit/test_targets_past.py"),
    *("unit/test_targets_given.py", "unit/test_simulation_hand.py"),
    *(
        "unit/test_transfer_assisted_stage.py",
        "unit/test_transfer_identification.py",
        "unit/test_predictors_adaptation_law.py",
    ),
)
OBSERVERS = (
    "camera/test_point_filter.py",
    "camera/test_depth.py",
    "camera/test_gravity.py",
    "test_persidskii_stage.py",
    "test_regressors.py",
    "test_unknown_input_stage.py",
)
RUN = """
import sys
from importlib import import_module
for folder, name in (one.split("=") for one in sys.argv[1].split(":")):
    import_module(name).__path__.insert(0, folder)
    assert import_module(name + "._laws").__file__.startswith(folder)
import pytest
# What a sanitizer reports goes to the file of the process, which pytest would else take.
sys.exit(pytest.main(["-q", "--capture=sys", "-p", "no:cacheprovider", *sys.argv[2:]]))
"""


@pytest.mark.slow
@pytest.mark.skipif(GCC is None, reason="needs gcc and its sanitizers")
def test_no_law_reads_or_writes_outside_or_does_what_is_undefined(tmp_path: Path) -> None:
    flags = {"CC": "gcc", "CFLAGS": f"-O1 {FLAGS} -fno-sanitize-recover=all", "LDFLAGS": FLAGS}
    places = []
    for name, folder in FOLDERS.items():
        build = [
            "-q",
            "build_ext",
            "--build-lib",
            str(tmp_path / name),
            "--build-temp",
            str(tmp_path / "objects"),
        ]
        subprocess.run([sys.executable, "setup.py", *build], cwd=folder, env=os.environ | flags, check=True)
        places.append(f"{tmp_path / name / name}={name}")
    preload = subprocess.run(
        [str(GCC), "-print-file-name=libasan.so"], stdout=subprocess.PIPE, text=True, check=True
    )
    environment = os.environ | {"LD_PRELOAD": preload.stdout.strip(), "ASAN_OPTIONS": "detect_leaks=0"}
    files = [f"tests/{one}" for one in TESTS] + [f"observers/tests/{one}" for one in OBSERVERS]
    run = subprocess.run(
        [sys.executable, "-c", RUN, ":".join(places), *files],
        cwd=ROOT,
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stdout[-4000:]
