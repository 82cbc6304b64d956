"""Predictors of packages that are installed beside ours are found by entry points."""

import json
import os
import subprocess
import sys

import pytest

MODULE = '''
from pointpred import build
from pointpred.predictors import HoldPredictor, LinearPredictor

class Theirs(LinearPredictor):
    """As linear, of another package."""

def made():
    return None
'''
POINTS = """
[pointpred.predictors]
theirs = theirs:Theirs
hold = theirs:Theirs
wrong = theirs:made
gone = theirs:Gone
"""
ASK = """
import json
import warnings
with warnings.catch_warnings(record=True) as seen:
    warnings.simplefilter("always")
    import theirs  # before the registry looks for it
    from pointpred import PointerEvent, build
    answers = [build(name).update(PointerEvent(0.0, 3.0, 4.0)) for name in ("theirs", "linear")]
kind = type(build("hold").predictor).__name__
said = [str(one.message) for one in seen]
print(json.dumps({"alike": answers[0] == answers[1], "hold": kind, "said": said}))
"""


@pytest.fixture
def beside(tmp_path):
    """The environment of a process that finds the other package."""
    (tmp_path / "theirs.py").write_text(MODULE)
    described = tmp_path / "theirs-2.0.dist-info"
    described.mkdir()
    (described / "METADATA").write_text("Metadata-Version: 2.1\nName: theirs\nVersion: 2.0\n")
    (described / "entry_points.txt").write_text(POINTS)
    return os.environ | {"PYTHONPATH": str(tmp_path), "PYTHONWARNINGS": "default"}


def test_a_predictor_of_another_package_is_built_by_its_name_and_what_cannot_be_is_told(beside):
    run = subprocess.run([sys.executable, "-c", ASK], env=beside, capture_output=True, text=True, check=True)
    told = json.loads(run.stdout)
    assert told["alike"]
    assert told["hold"] == "HoldPredictor", "a name of ours cannot be taken"
    assert [name in said for name, said in zip(("gone", "hold", "wrong"), sorted(told["said"]), strict=True)]


def test_the_command_line_lists_and_scores_a_predictor_of_another_package(beside):
    def command(*arguments):
        run = [sys.executable, "-m", "pointpred", *arguments]
        return json.loads(subprocess.run(run, env=beside, stdout=subprocess.PIPE, check=True).stdout)

    (listed,) = command("predictors", "theirs", "--json")["predictors"]
    assert (listed["title"], listed["reference"]) == ("As linear, of another package", "theirs 2.0")
    (scored,) = command("score", "--predictors", "theirs,linear", "--json", "-")["sets"]
    theirs, linear = (one["time_averaged"] for one in scored["predictors"] if one["name"] != "hold")
    assert theirs == linear
