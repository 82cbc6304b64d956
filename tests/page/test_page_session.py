"""A session in the page answers as one of the service does."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from tests.page import node
from tests.page.movements import movements
from tests.unit.talking import Talk, events, hello

pytestmark = node.needed

SCREEN = {"width_px": 1600.0, "height_px": 1200.0}
OWN = {"session", "limits", "message", "value"}
"""Fields in which the page has words of its own."""
TARGETS = [
    {
        "id": f"{i},{j}",
        "x": 240.0 * i,
        "y": 240.0 * j,
        "width": 60.0,
        "height": 40.0 + i,
        "weight": 1.0 + abs(j),
    }
    for i in range(-3, 8)
    for j in range(-3, 8)
]


def rows(seed: int, **more: Any) -> list[list[float | None]]:
    return [[*row[:3], None, None, int(row[5])] for row in movements(seed, **more).tolist()]


def both(frames: list[dict[str, Any]]) -> tuple[list[Any], list[Any]]:
    """The answers of the page and of the service to each frame."""
    talk = Talk(greet=None)
    return node.run("converse.mjs", frames), [talk.say(frame) for frame in frames]


def assert_alike(found: Any, expected: Any, path: str = "$") -> None:
    """The same but for words of the page's own and the last digits of numbers.

    The page names the field of every number that is wrong, the service not where its decoder refuses it.
    """
    if isinstance(expected, dict):
        assert found.keys() - OWN - {"field"} == expected.keys() - OWN - {"field"}, path
        for name in expected.keys() - OWN:
            assert_alike(found[name], expected[name], f"{path}.{name}")
    elif isinstance(expected, list):
        assert len(found) == len(expected), f"{path}: {found} instead of {expected}"
        for i, (one, other) in enumerate(zip(found, expected, strict=True)):
            assert_alike(one, other, f"{path}[{i}]")
    elif isinstance(expected, float) and not isinstance(found, bool):
        assert found == pytest.approx(expected, rel=1e-7, abs=1e-7), path
    else:
        assert found == expected, path


def frames_of(table: list[Any], size: int) -> list[dict[str, Any]]:
    return [events(*table[i : i + size]) for i in range(0, len(table), size)]


def goal(row: list[Any], width: float = 40.0) -> dict[str, float]:
    return {"x": row[1], "y": row[2], "width": width}


@pytest.mark.parametrize("predictor", ["switched", "kinematic-adaptive", "ktm", "delphian"])
@pytest.mark.parametrize("reply", ["frame", "event"])
def test_a_session_with_targets_and_trials_is_answered_alike(predictor: str, reply: str) -> None:
    first, second = rows(11), rows(12, count=2)
    mark = {"type": "trial", "action": "start", "conditions": {"block": 1, "who": "p7"}}
    frames = [
        hello(predictor, version=2, reply=reply, screen=SCREEN),
        *frames_of(first[:60], 1),
        {"type": "targets", "targets": TARGETS},
        {"type": "configure", "precision": 0.1},
        *frames_of(first[60:200], 7),
        {"type": "targets", "targets": TARGETS[::2]},
        mark,
        *frames_of(first[200:], 5),
        {**mark, "action": "end", "target": goal(first[-1])},
        {"type": "configure", "precision": 1},
        {"type": "configure", "precision": 0},
        {"type": "reset"},
        {**mark, "conditions": {"size": 5}},
        mark,
        *frames_of([[t + 100.0, *rest] for t, *rest in second], 3),
        {**mark, "action": "end"},
        {"type": "targets", "targets": []},
        {"type": "configure", "predictor": "hold", "parameters": {"gap_s": 0.05}},
        events([200.0, 1.0, 2.0, None, None, 0]),
    ]
    found, expected = both(frames)
    answers = [one for heard in expected for one in heard]
    assert {one["reason"] for one in answers if one["type"] == "choice"} == {"predicted", "entered", None}
    assert [one["skill"] is not None for one in answers if one["type"] == "score"] == [True, True]
    assert_alike(found, expected)


def test_an_assisted_session_moves_the_cursor_alike() -> None:
    table = movements(13)
    counts = np.round(6.0 * np.diff(table[:, 1:3], axis=0, prepend=table[:1, 1:3]))
    moved = [
        [t, x, y, *map(float, dxy), int(b)] for (t, x, y, _, _, b), dxy in zip(table, counts, strict=True)
    ]
    for name, assist in (("switched", {"strength": 1.0, "rho": 1e4}), ("kinematic", {"function": "sigmoid"})):
        frames = [
            hello(name, assist=assist, device={"cpi": 1600.0}, screen=SCREEN),
            *frames_of(moved[:90], 1),
            {"type": "configure", "assist": {"strength": 0.2}},
            *frames_of(moved[90:300], 6),
            {"type": "configure", "assist": assist},
            *(
                frame
                for i in range(300, 400, 7)
                for frame in (*frames_of(moved[i : i + 7], 3), {"type": "reset"})
            ),
            events([1e3, 0.0, 0.0, 5, 5, 0], [1e3, 0.0, 0.0, None, None, 0]),
            events([1e3, 0.0, 0.0, 5, 5, 0], [999.0, 0.0, 0.0, 1, 1, 0]),
        ]
        assert_alike(*both(frames))


@pytest.mark.parametrize("late", [9.0, None])
def test_a_frame_with_an_event_that_is_refused_changes_nothing(late: float | None) -> None:
    """But where only its time is wrong: then the others of the frame are used."""
    first = rows(16, count=2)
    wrong = [late, 0.0, 0.0, None, None, 0] if late else [first[45][0], 2e9, 0.0, None, None, 0]
    frames = [
        hello("switched", reply="event"),
        *frames_of(first[:40], 8),
        events(*first[40:45], wrong, first[45]),
    ]
    found, expected = both([*frames, *frames_of(first[46:], 8)])
    assert expected[6][-1]["code"] == ("out_of_order" if late else "bad_field")
    assert_alike(found, expected)


REFUSED: list[list[Any]] = [
    [events([0.0, 0.0, 0.0, None, None, 0])],
    [hello(), hello()],
    [hello("nobody")],
    [{**hello(), "version": 3}],
    [{**hello(), "version": 2}, {"type": "trial", "action": "start", "conditions": {"user": "p"}}],
    [hello(), {"type": "trial", "action": "start", "conditions": {"a,b": 1}}],
    [hello(), {"type": "trial", "action": "start", "conditions": {"at": "a\n"}}],
    [hello(), {"type": "trial", "action": "start", "conditions": {"at": None}}],
    [hello(), {"type": "trial", "action": "start", "conditions": {str(i): i for i in range(33)}}],
    [{"type": "hello"}],
    [{**hello(), "reply": "both"}],
    [{**hello(), "more": 1}],
    [{**hello(), "screen": {"dpi": 0}}],
    [hello("switched", parameters={"threshold": 20.0})],
    [hello("switched", parameters={"cpi": 1000})],
    [hello("switched", parameters={"threshold": 0.1, "pause_s": 0.01})],
    [hello(person="1.xx")],
    [hello("kinematic-adaptive", person="1.xx")],
    [hello(assist={})],
    [hello(assist={"strength": 2})],
    [{"type": "what"}],
    [{"kind": "what"}],
    [hello(), {"type": "targets", "targets": [TARGETS[0], TARGETS[0]]}],
    [hello(), {"type": "targets", "targets": [{**TARGETS[0], "width": 0.0}]}],
    [hello(), {"type": "targets", "targets": [{**TARGETS[0], "id": ""}]}],
    [hello(), {"type": "targets", "targets": [{"id": "a", "x": 1.0}]}],
    [hello(), {"type": "trial", "action": "end"}],
    [hello(), {"type": "trial", "action": "stop"}],
    [hello(), {"type": "configure", "assist": {}}],
    [hello(), {"type": "configure", "precision": 2}],
    [hello(), {"type": "configure", "predictor": "lineaar"}],
    [hello(), {"type": "person", "person": "1.AAAA"}, {"type": "person"}],
    [hello(), events([1.0, 2.0, 3.0, None, None, 0], [0.5, 2.0, 3.0, None, None, 0])],
    [hello(), events([1.0, 2.0, 3.0, None, 1, 0])],
    [hello(), events([1.0, 2.0, 2e9, None, None, 0])],
    [
        hello(),
        events([0.0, 1.0, 1.0, None, None, 0]),
        {"type": "trial", "action": "start"},
        {"type": "trial", "action": "end"},
    ],
]


@pytest.mark.parametrize("frames", REFUSED, ids=range(len(REFUSED)))
def test_what_is_refused_has_the_same_code_and_place(frames: list[Any]) -> None:
    good = [*frames, events([1e6, 1.0, 2.0, None, None, 0])]
    assert_alike(*both(good))


def test_nothing_is_answered_after_goodbye() -> None:
    found = node.run(
        "converse.mjs", [hello(), {"type": "bye"}, {"type": "person"}, [[0.0, 0.0, 0.0, None, None, 0]]]
    )
    assert [len(answers) for answers in found] == [1, 0, 0, 0]


def test_the_person_of_a_session_can_be_asked_for_and_set() -> None:
    first = rows(14)
    frames = [hello("kinematic-adaptive"), *frames_of(first, 10), {"type": "reset"}, {"type": "person"}]
    found, expected = both(frames)
    known = expected[-1][0]["person"]
    assert len(known) > 1000
    later = [[t + 100.0, *rest] for t, *rest in rows(15, count=2)]
    again = [
        hello("kinematic-adaptive", person=known),
        *frames_of(later, 10),
        {"type": "configure", "parameters": {"gap_s": 0.09}},
        *frames_of([[t + 50.0, *rest] for t, *rest in later], 10),
        {"type": "person", "person": ""},
        {"type": "person", "person": found[-1][0]["person"]},
    ]
    pages, services = both(again)
    assert_alike(pages[:-1], services[:-1])
    assert pages[-1] == [{"type": "person", "person": found[-1][0]["person"]}]


def test_what_is_known_of_targets_goes_on_in_another_session_and_with_other_parameters() -> None:
    told = {
        "type": "targets",
        "targets": [{"id": "a", "x": -30.0, "y": -30.0, "width": 60.0, "height": 60.0}],
    }
    frames = [hello(), told, *frames_of(rows(14), 10), {"type": "reset"}, {"type": "person"}]
    known = both(frames)[1][-1][0]["person"]
    assert known.startswith("+")
    later = [[t + 100.0, *rest] for t, *rest in rows(15, count=2)]
    again = [
        hello(person=known),
        told,
        *frames_of(later, 10),
        {"type": "configure", "parameters": {"elsewhere": 0.5}},
        *frames_of([[t + 50.0, *rest] for t, *rest in later], 10),
        {"type": "configure", "predictor": "linear"},
        *frames_of([[t + 90.0, *rest] for t, *rest in later], 10),
        hello(person=f"{known}+"),
    ]
    assert_alike(*both(again))


@pytest.mark.parametrize("wrong", ["1.AAAA+", "+", "+1.AAAA"])
def test_half_a_person_is_refused_in_both(wrong: str) -> None:
    pages, services = both([hello("kinematic-adaptive", person=wrong)])
    assert (pages[0][0]["code"], pages[0][0]["path"]) == ("bad_field", "$.person")
    assert (services[0][0]["code"], services[0][0]["path"]) == ("bad_field", "$.person")
