"""Studies: designs and their errors, orders of conditions, what is stored of a participant, the export."""

from __future__ import annotations

import csv
import itertools
import json
import math
from collections import Counter
from pathlib import Path

import pytest
from msgspec.structs import replace
from typer.testing import CliRunner

from pointpred.cli.app import app
from pointpred.errors import ParameterError, SourceError
from pointpred.recorder.files import SessionFiles
from pointpred.recordings import read
from pointpred.studies.design import TEMPLATE, design_of
from pointpred.studies.export import export, status
from pointpred.studies.folder import ConflictError
from pointpred.studies.messages import Agreed, Answered, Opened
from pointpred.studies.plan import latin_row, plan_of
from tests.studied import DESIGN, PAGE, movement, study_in, take_part


@pytest.mark.parametrize(
    ("wrong", "right", "words"),
    [
        ("blokcs = 2", "movements = 3", "there is no blokcs; did you mean blocks?"),
        ("movements = 'x'", "movements = 3", "movements: Expected `int`, got `str`"),
        ("movements = 4", "movements = 3", "a circle needs an odd number from 3"),
        ("widths_px = [200]", "widths_px = [20, 40]", "every width must be below every distance"),
        ("widths_px = [20, 20]", "widths_px = [20, 40]", "widths_px: 20.0 stands there twice"),
        (
            'tasks = ["cicle"]',
            'tasks = ["circle", "reciprocal"]',
            "tasks[0]: Invalid enum value 'cicle', expected one of circle, reciprocal",
        ),
        ('when = "during"', 'when = "before"', "expected one of before, after"),
        ("low = 101", "low = 0", "questions: 'effort' has low 101 and high 100"),
        ("", 'kind = "number"', "questions: 'effort' has low or high, and needs kind = \"number\""),
        ('choices = [" left"]', 'choices = ["left", "right"]', "' left' begins or ends with a space"),
        ('choices = ["1"]\nhigh = 3', 'choices = ["left", "right"]', "has choices, and is no number besides"),
        ('consent = " "', 'consent = "I agree."', "consent: expected words"),
        ('name = "a\\n"', 'name = "pointing"', "name: Expected `str` matching regex"),
        ('name = "../x"', 'name = "pointing"', "name: Expected `str` matching regex"),
        ("movements = 101\nblocks = 99", "movements = 3", "39996 movements of each participant"),
        ("title = ", 'title = "A study"', "at line"),
        ('high = "1"', "high = 100", "questions[1].high: Expected"),
        ('choices = ["left", "left"]', 'choices = ["left", "right"]', "'left' stands there twice"),
    ],
)
def test_a_wrong_design_is_refused_with_its_place(tmp_path: Path, wrong: str, right: str, words: str) -> None:
    with pytest.raises(ParameterError, match=r"pointing\.toml: ") as refused:
        study_in(tmp_path, DESIGN.replace(right, wrong))
    assert words in str(refused.value)


def test_a_design_to_start_from_is_a_design() -> None:
    design = design_of(TEMPLATE.format(file="a.toml", name="a"))
    assert len(plan_of(design, 0)) == design.blocks * 4
    assert design.codes[-1] == "P12"


@pytest.mark.parametrize("conditions", [1, 2, 4, 5, 6, 9])
def test_each_condition_follows_every_other_equally_often(conditions: int) -> None:
    rows = [latin_row(conditions, row) for row in range(conditions * (1 + conditions % 2))]
    assert all(sorted(row) == list(range(conditions)) for row in rows)
    for column in zip(*rows, strict=True):
        assert len(set(Counter(column).values())) == 1
    pairs = Counter(pair for row in rows for pair in itertools.pairwise(row))
    assert len(pairs) == conditions * (conditions - 1)
    assert len(set(pairs.values())) <= 1


def test_orders_are_the_participants_own_and_the_same_again() -> None:
    design = design_of(DESIGN)
    for order in ("latin-square", "random"):
        chosen = replace(design, order=order, blocks=2, practice_blocks=1)
        plans = [plan_of(chosen, i) for i in range(4)]
        assert plans == [plan_of(chosen, i) for i in range(4)]
        orders = [[(one.task, one.width) for one in plan] for plan in plans]
        assert len(set(map(str, orders))) > 2
        assert orders[0][:4] != orders[0][4:8] != orders[0][8:]
        assert [(one.phase, one.block) for one in plans[0][::4]] == [
            ("practice", 1),
            ("test", 1),
            ("test", 2),
        ]
        assert [one.rest for one in plans[0]] == [False] * 4 + [True, False, False, False] * 2
    circle, bars = (next(one for one in plans[0] if one.task == task) for task in ("circle", "reciprocal"))
    assert math.dist(circle.places[0], circle.places[1]) == pytest.approx(200.0)
    assert bars.places == [(-100.0, 0.0), (100.0, 0.0)]


def test_nothing_is_stored_before_the_participant_has_agreed(tmp_path: Path) -> None:
    study = study_in(tmp_path)
    one = study.find(study.links()["P01"])
    assert one is study.participants["P01"]
    for message in (movement(one), Opened(PAGE), Answered("before", {"hand": "left"})):
        with pytest.raises(ConflictError):
            one.take(message)
    assert [path.name for path in study.folder.iterdir()] == ["links.json"]
    one.take(Agreed(PAGE))
    assert json.loads((one.folder / "participant.json").read_bytes())["consent"] == "I agree."
    assert study.find("P01") is None


def test_answers_are_checked(tmp_path: Path) -> None:
    one = study_in(tmp_path).participants["P01"]
    one.take(Agreed(PAGE))
    for answers, words in (
        ({"hand": "both"}, "expected one of left, right"),
        ({}, "it needs an answer"),
        ({"hand": "left", "effort": "1"}, "no question 'effort' is asked before"),
    ):
        with pytest.raises(ParameterError, match=words):
            one.take(Answered("before", answers))
    with pytest.raises(ParameterError, match="expected a number from 0 to 100"):
        one.take(Answered("after", {"effort": "nan"}))
    assert one.waiting() == ["before", "after"]


def test_a_movement_that_is_sent_twice_is_stored_once(tmp_path: Path) -> None:
    one = study_in(tmp_path).participants["P01"]
    take_part(one, 2)
    again = movement(one, 1, t=3.0)
    one.take(again)
    assert len(one.done()) == 2
    with pytest.raises(ConflictError, match="goes on in another page"):
        one.take(replace(again, start=(99.0, *again.start[1:])))
    with pytest.raises(ConflictError):
        one.take(movement(one, 7, t=9.0))
    with pytest.raises(ParameterError, match="backwards"):
        one.take(replace(movement(one, t=9.0), rows=movement(one, t=8.0).rows))


@pytest.mark.parametrize(
    ("on_error", "places"),
    [("go-on", [(1, 1), (1, 2), (1, 3), (2, 1)]), ("repeat", [(1, 1), (1, 1), (1, 2), (1, 2)])],
)
def test_what_follows_a_miss(tmp_path: Path, on_error: str, places: list[tuple[int, int]]) -> None:
    study = study_in(tmp_path, DESIGN.replace("break_s", f'on_error = "{on_error}"\nbreak_s'))
    one = study.participants["P01"]
    one.take(Agreed(PAGE))
    for i in range(4):
        one.take(movement(one, hit=i % 2 == 1, t=1.0 + 2 * i))
    assert [(done.sequence, done.movement) for done in one.done()] == places
    assert [done.attempt for done in one.done()] == ([1, 2, 1, 2] if on_error == "repeat" else [1] * 4)
    following = [one.next([replace(one.done()[-1], hit=0, attempt=n)]) for n in (19, 20)]
    assert following == ([(1, 2), (1, 3)] if on_error == "repeat" else [(2, 2)] * 2)


def test_a_restart_goes_on_and_a_cut_movement_is_made_again(tmp_path: Path) -> None:
    study = study_in(tmp_path)
    take_part(study.participants["P01"], 4)
    trials = study.folder / "P01" / "P01-1_trials.csv"
    study.close()
    trials.write_bytes(trials.read_bytes()[:-7])  # killed while the fourth was written
    study = study_in(tmp_path)
    one = study.participants["P01"]
    assert one.state()["next"] == (2, 1)
    assert one.state()["stored"] == 3
    take_part(one)
    take_part(study.participants["P03"])
    study.close()
    [(recording, file)] = export(study, tmp_path / "all_samples.parquet")
    assert recording.skipped == ()
    again = read(file)
    assert Counter(trial.user for trial in again.trials) == {"P01": 12, "P03": 12}
    assert len({(trial.user, trial.trial) for trial in again.trials}) == 24
    conditions = [trial.condition for trial in again.trials if trial.user == "P01"]
    assert [(c["sequence"], c["movement"]) for c in conditions] == [
        (s, m) for s in (1, 2, 3, 4) for m in (1, 2, 3)
    ]
    for i, trial in enumerate(again.trials):
        x, y = again.rows(i).x[-1], again.rows(i).y[-1]
        assert (x, y) == pytest.approx((trial.target_x, trial.target_y))
        assert trial.target_w == trial.condition["width_px"]
    people = list(csv.DictReader((tmp_path / "all_participants.csv").read_text().splitlines()))
    assert [(row["user"], row["answer_hand"], row["answer_effort"]) for row in people] == [
        ("P01", "left", "40"),
        ("P03", "left", "40"),
    ]
    assert [one.state for one in status(study)] == ["done", "not begun", "done"]


def test_a_design_may_not_change_once_somebody_has_begun(tmp_path: Path) -> None:
    take_part(study_in(tmp_path).participants["P01"], 1)
    study_in(tmp_path, DESIGN.replace("participants = 3", "participants = 4"))
    with pytest.raises(ParameterError, match=r"widths_px has changed since the first participant began"):
        study_in(tmp_path, DESIGN.replace("[20, 40]", "[20, 41]"))


def test_participants_keep_their_codes_when_they_grow_to_a_hundred(tmp_path: Path) -> None:
    take_part(study_in(tmp_path).participants["P01"], 1)
    grown = study_in(tmp_path, DESIGN.replace("participants = 3", "participants = 100"))
    assert (grown.design.codes[0], grown.design.codes[-1]) == ("P01", "P100")
    assert len(grown.participants["P01"].done()) == 1
    take_part(grown.participants["P04"], 1)
    with pytest.raises(ParameterError, match="P04 has taken part"):
        study_in(tmp_path)


def test_two_services_of_one_study_keep_the_order_of_movements(tmp_path: Path) -> None:
    first, second = (study_in(tmp_path).participants["P01"] for _ in range(2))
    first.take(Agreed(PAGE))
    for i, one in enumerate((first, second, first, first)):
        one.take(movement(one, t=1.0 + 2 * i))
    assert [(done.sequence, done.movement) for done in first.done()] == [(1, 1), (1, 2), (1, 3), (2, 1)]
    assert len(list(first.folder.glob("*_trials.csv"))) == 3


def test_a_full_disk_leaves_no_files_behind(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    one = study_in(tmp_path).participants["P01"]
    take_part(one, 1)
    one.close()
    with monkeypatch.context() as full:
        full.setattr(SessionFiles.__init__, "__defaults__", (_full,))
        for _ in range(3):
            with pytest.raises(SourceError, match="No space left"):
                one.take(movement(one, t=9.0))
    one.take(movement(one, t=9.0))
    assert sorted(path.name for path in one.folder.glob("*_samples.csv")) == [
        "P01-1_samples.csv",
        "P01-2_samples.csv",
    ]


def _full(*_: object) -> int:
    raise OSError(28, "No space left on device")


@pytest.mark.parametrize("name", ["links.json", "P01/participant.json"])
def test_a_damaged_file_is_named(tmp_path: Path, name: str) -> None:
    study = study_in(tmp_path)
    study.links()
    take_part(study.participants["P01"], 1)
    (study.folder / name).write_text("{")
    with pytest.raises(SourceError, match=rf"{name}: damaged: "):
        status(study_in(tmp_path))


def test_deleting_leaves_nothing_and_the_link_no_longer_works(tmp_path: Path) -> None:
    study = study_in(tmp_path)
    take_part(study.participants["P02"], 2)
    link = study.links()["P02"]
    design = str(tmp_path / "pointing.toml")
    kept = CliRunner().invoke(app, ["study", "delete", design, "P02"], input="n\n")
    assert kept.exit_code == 1
    gone = CliRunner().invoke(app, ["study", "delete", design, "P02", "--force"])
    assert gone.exit_code == 0
    assert not (study.folder / "P02").exists()
    assert study.find(link) is None
    with pytest.raises(ConflictError):
        study.participants["P02"].take(Opened(PAGE))
