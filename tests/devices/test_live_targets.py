"""``pointpred live --targets``: rectangles of a file, and which of them the movement is for."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from pointpred import build, run
from pointpred.devices.cursor_paths import PositionPath
from pointpred.errors import ParameterError
from pointpred.live import terminal
from pointpred.live.playback import PlayedPipeline, PlayedSource, PlayedTrial
from pointpred.live.run import LiveRun, OutputOptions
from pointpred.live.session import LiveSession
from pointpred.live.targets import read_targets
from pointpred.protocol.client_messages import Rectangle
from pointpred.recording import Trial
from tests.building import reach, text_file
from tests.devices.live_fakes import FakeMouse

JSON = """[{"id": "left", "x": -420, "y": -20, "width": 40, "height": 40},
 {"id": "right", "x": 380, "y": -20, "width": 40, "height": 40.0, "weight": 2, "kind": "button"}]"""
CSV = "id, x,y,width,height,weight,kind\nleft,-420,-20,40,40,,\nright,380,-20,4e1,40,2,button\n"
BOTH = (
    Rectangle("left", -420.0, -20.0, 40.0, 40.0),
    Rectangle("right", 380.0, -20.0, 40.0, 40.0, 2.0, "button"),
)


SEPARATED = (CSV.replace(",", ";"), CSV.replace(",", "\t"))


@pytest.mark.parametrize("text", [JSON, CSV, "\ufeff" + CSV, CSV.replace("\n", "\r\n"), *SEPARATED])
def test_json_and_csv_hold_the_same_rectangles(tmp_path: Path, text: str) -> None:
    assert read_targets(text_file(tmp_path / "targets", text)) == BOTH


def test_ids_may_be_whole_numbers(tmp_path: Path) -> None:
    text = '[{"id": 7, "x": 0, "y": 0, "width": 9, "height": 9}]'
    assert [one.id for one in read_targets(text_file(tmp_path / "targets", text))] == ["7"]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "holds no targets"),
        ("[]", "holds no targets"),
        ('[{"id": "a"', "truncated"),
        ('{"id": "a"}', "`$`|array"),
        ('[{"id": "a", "x": 0, "y": 0, "width": 9}]', r"`height` - at `\$\[0\]`"),
        ('[{"id": "a", "x": 0, "y": 0, "width": 9, "height": 0}]', r">= 0.001 - at `\$\[0\].height`"),
        ('[{"id": "a", "x": 0, "y": 0, "width": 9, "height": 9, "hight": 1}]', "unknown field `hight`"),
        (CSV.replace("left", "right"), "once, received 'right' twice"),
        (CSV.replace("4e1", "wide"), r"line 3: .*`\$.width`"),
        (CSV.replace("4e1", "nan"), r"line 3: .*`\$.width`"),
        (CSV.replace("4e1,", ""), "line 3 has not as many cells"),
        (CSV.replace("width", "w"), "line 2: .*`width`|line 2: .*`w`"),
        ("\udcff", "can't decode"),
    ],
)
def test_a_wrong_file_is_named_with_the_place_and_what_was_expected(
    tmp_path: Path, text: str, said: str
) -> None:
    file = tmp_path / "targets"
    file.write_bytes(text.encode(errors="surrogateescape"))
    with pytest.raises(
        ParameterError, match=f"(?s)--targets .*targets: .*({said}).*; expected a JSON list"
    ) as e:
        read_targets(file)
    assert e.value.field == "targets"


def test_a_file_that_is_not_there_is_wrong_use(command: Callable[..., Any], tmp_path: Path) -> None:
    left = command("live", "--targets", tmp_path / "none.json", "--replay", "sample")
    assert (left.code, left.out) == (2, "")
    assert "none.json: No such file" in left.err


def test_predictions_are_those_given_the_targets_and_the_likeliest_is_shown() -> None:
    options = OutputOptions("minimum-jerk", targets=BOTH)
    events = reach((0.0, 0.0), (400.0, 0.0), rest_s=0.0)
    trials = [PlayedTrial(Trial("ann", "1"), events.rows(0, 40))]
    with PlayedSource("replay", "reach", trials, speed=float("inf")) as source:
        session = LiveSession(
            source, PositionPath("recorded", counts=True), PlayedPipeline(options.pipeline())
        )
        LiveRun(session, options)
        assert session.state().target == "-"
        assert "target" in dict(terminal.prediction_rows(None, 0.0, "-"))
        answers = []
        while not source.ended:
            answers += [answer for _, answer in session.advance()]
    given = build("minimum-jerk", targets=BOTH)
    expected = run(given, events.rows(0, 40))
    assert [one.x for one in answers if one is not None][-1] == expected.x[-1]
    assert abs(expected.x[-1] - 400.0) < 1.0
    share = given.shares["right"]
    assert share > 0.9
    state = session.state()
    assert state.target == f"right, {100 * share:.0f} %"
    assert f"left; target right, {100 * share:.0f} %; 0 lost" in terminal.line(state, session.newest)
    assert dict(terminal.prediction_rows(session.newest, 9.0, state.target))["target"] == "-"


def test_without_targets_nothing_is_said_of_them() -> None:
    session = LiveSession(FakeMouse(), None, build("hold"))
    assert session.state().target is None
    assert "target" not in terminal.line(session.state(), session.newest)
