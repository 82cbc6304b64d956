"""Predictors of packages that are installed beside ours: found by entry points, checked as ours are."""

import json
import os
import subprocess
import sys
from typing import ClassVar

import numpy as np
import pytest

from pointpred import REGISTRY, EventColumns, Pipeline, Prediction, build, run
from pointpred.differentiators import HomogeneousDifferentiator
from pointpred.errors import EventOrderError
from pointpred.plugins import LAWS, PlainPredictor, check, troubled

MODULE = '''
from pointpred import build
from pointpred.predictors import HoldPredictor, LinearPredictor

class Theirs(LinearPredictor):
    """As linear, of another package."""

class Plain:
    """The cursor's own position, moved [/right]:on:"""
    def __init__(self, right=0.0):
        self.right = right
    def reset(self):
        pass
    def update(self, motion):
        return motion.x + self.right, motion.y

def piped(cpi=None, degree=2):
    return build(f"kep-{'quadratic' if degree == 2 else 'quartic'}", cpi=cpi)

def made():
    return None

def ends():
    raise SystemExit
'''
POINTS = """
[pointpred.predictors]
theirs = theirs:Theirs
plain = theirs:Plain
piped = theirs:piped
hold = theirs:Theirs
wrong = theirs:made
gone = theirs:Gone
ends = theirs:ends
"""
ASK = """
import json
import warnings
with warnings.catch_warnings(record=True) as seen:
    warnings.simplefilter("always")
    import theirs  # before the registry looks for it
    from pointpred import PointerEvent, build, errors
    def first(name, **more):
        return build(name, **more).update(PointerEvent(0.0, 3.0, 4.0))
    alike = first("theirs") == first("linear")
    moved = first("plain", right=2.0).x
    piped = build("piped", degree=4, cpi=800)
    refused = []
    for name, more in (("plain", {"left": 1}), ("piped", {"gain_xi": 2.0}), ("gone", {}), ("wrong", {})):
        try:
            build(name, **more)
        except errors.ParameterError as error:
            refused.append(str(error))
kind = type(build("hold").predictor).__name__
said = [str(one.message) for one in seen]
told = [piped.name, piped.predictor.degree, piped.differentiator.cpi]
answers = {"alike": alike, "moved": moved, "piped": told, "hold": kind}
print(json.dumps(answers | {"said": said, "refused": refused}))
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
    assert told["moved"] == 5.0
    assert told["piped"] == ["piped", 4, 800]
    assert told["hold"] == "HoldPredictor", "a name of ours cannot be taken"
    assert [("'hold'" in said, "theirs 2.0" in said) for said in told["said"]] == [(True, True)]
    left, gain, gone, wrong = told["refused"]
    assert "Known: right, cpi" in left
    assert "unknown parameter of piped" in gain
    assert "theirs 2.0 (theirs:Gone) cannot be used: AttributeError" in gone
    assert (
        "theirs 2.0 (theirs:made) cannot be used: it must make a Pipeline, a Predictor, or an object" in wrong
    )


def test_the_command_line_lists_checks_and_scores_a_predictor_of_another_package(beside):
    def command(*arguments):
        run = [sys.executable, "-m", "pointpred", *arguments]
        left = subprocess.run(run, env=beside, capture_output=True, text=True, check=False)
        return json.loads(left.stdout), left

    (listed,) = command("predictors", "theirs", "--json")[0]["predictors"]
    assert (listed["title"], listed["reference"]) == ("As linear, of another package", "theirs 2.0")
    assert listed["laws"] == dict.fromkeys(LAWS)
    every, left = command("predictors", "--json")
    assert {"theirs", "plain", "piped"} <= {one["name"] for one in every["predictors"]}
    assert (left.returncode, left.stderr.count("left out: ")) == (0, 3)
    shown = subprocess.run(
        [sys.executable, "-m", "pointpred", "predictors", "plain"],
        env=beside, capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert "moved [/right]:on:" in shown.stdout
    names = "theirs,linear,plain:right=0"
    (scored,) = command("score", "--predictors", names, "--json", "-")[0]["sets"]
    hold, theirs, linear, plain = (one["time_averaged"] for one in scored["predictors"])
    assert theirs == linear
    assert plain == hold


class Doubling:
    """Twice as far, remembering the movement in attributes."""

    def reset(self):
        self.first = None

    def update(self, motion):
        self.first = self.first or motion
        x, y = 2 * motion.x - self.first.x, 2 * motion.y - self.first.y
        return Prediction(motion.t, x, y, (9.0, 0.0, 4.0), "ballistic", 0.1)


def plain(of):
    return lambda: Pipeline("plain", HomogeneousDifferentiator(cpi=2000.0), PlainPredictor(of))


@pytest.mark.parametrize("name", REGISTRY)
def test_ours_keep_the_laws_that_others_are_checked_for(name):
    assert [one for one in check(name) if one.trouble] == []


def test_plain_python_keeps_them_too():
    assert [one for one in check(plain(Doubling)) if one.trouble] == []


class Remembers(Doubling):
    def reset(self):
        self.first = getattr(self, "first", None)


class Hoards(Doubling):
    def update(self, motion):
        self.all = [*getattr(self, "all", []), motion][-9000:]
        return super().update(motion)


class Late(Doubling):
    def update(self, motion):
        return motion.x + motion.t, motion.y


class Corner(Doubling):
    def update(self, motion):
        return 0.5 * motion.x, motion.y


class Open(Doubling):
    def update(self, motion):
        return motion.x, float("inf")


class Shared(Doubling):
    seen: ClassVar[list] = []

    def update(self, motion):
        self.seen.append(motion)
        return motion.x + len(self.seen), motion.y


class Wordy(Doubling):
    def update(self, motion):
        return "far"


class Locked(Doubling):
    def __init__(self):
        self.locked = lambda: None


BROKEN = {
    Remembers: "fresh and reset forget",
    Hoards: "memory is bounded",
    Late: "the clock has no origin",
    Corner: "the screen has no origin",
    Open: "answers are finite and whole",
    Shared: "two share nothing",
    Locked: "it pickles and goes on",
}


@pytest.mark.parametrize("of", BROKEN)
def test_a_law_that_is_broken_is_found(of):
    trouble = {one.law: one.trouble for one in check(plain(of))}
    assert trouble[BROKEN[of]]


def test_what_is_refused_is_never_seen_and_a_frame_is_answered_as_its_events():
    one, seen = plain(Doubling)(), troubled()
    answers = run(one, seen).table
    frame = plain(Doubling)()
    assert frame.push(seen.table, want="last")[:3] == tuple(answers[-1, :3])
    wrong = EventColumns(np.concatenate([seen.table[-1:], seen.table[:1]]))
    with pytest.raises(EventOrderError, match="row 1"):
        run(one, wrong)
    with pytest.raises(EventOrderError):
        one.push(wrong.table, want="last")
    twin = plain(Doubling)()
    run(twin, seen)
    later = EventColumns(seen.table + np.array([9, 0, 0, 0, 0, 0]))
    assert run(one, later).table.tobytes() == run(twin, later).table.tobytes()
    assert build("hold").predictor.joined


def test_an_answer_that_is_none_says_what_was_expected():
    assert "answered 'far', expected None, a pair" in check(plain(Wordy))[0].trouble
