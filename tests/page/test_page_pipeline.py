"""Pipelines in the page: the answers of Python, what they refuse, and what they know of a person."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from pointpred import REGISTRY, build
from pointpred.errors import ParameterError
from pointpred.pipeline import Pipeline
from tests.page import node
from tests.page.movements import movements

pytestmark = node.needed

NEAR = 1e-9
"""Of the largest number of a kind in the answers."""


def answers(pipeline: Pipeline, steps: list[Any]) -> list[Any]:
    """What ``predict.mjs`` does, in Python."""
    found: list[Any] = []
    for step in steps:
        if step == "person":
            found.append(pipeline.person)
        elif step == "reset":
            found.append(pipeline.reset())
        elif step == "fresh":
            pipeline = pipeline.fresh()
            found.append(None)
        elif step == "forget":
            found.append(pipeline.forget())
        elif step == "places":
            found.append([place._asdict() for place in pipeline.places])
        elif isinstance(step, dict):
            found.append(pipeline.enter(*step["enter"]))
        else:
            found.append(pipeline.advance(tuple(step)))
    return found


def assert_equal(found: list[Any], expected: list[Any]) -> None:
    """Rows within NEAR of the largest number in their column, all else equal."""
    assert len(found) == len(expected)
    rows = [i for i, one in enumerate(expected) if isinstance(one, tuple)]
    assert [type(one) is list for one in found] == [type(one) is tuple for one in expected]
    one, other = (np.array([side[i] for i in rows], dtype=np.float64) for side in (found, expected))
    scale = np.nanmax(np.abs(other), axis=0, initial=1.0)
    assert np.allclose(one / scale, other / scale, rtol=0.0, atol=NEAR, equal_nan=True)
    assert [x for x in found if type(x) is not list] == [x for x in expected if type(x) is not tuple]


BACKWARDS = [1.0, 0.0, 0.0, np.nan, np.nan, 0.0]
REFUSED = [
    BACKWARDS,
    [1e12, 0.0, 0.0, np.nan, np.nan, 0.0],
    [2e5, 1e10, 0.0, np.nan, np.nan, 0.0],
    [2e5, 0.0, 0.0, 1.0, np.nan, 0.0],
    [2e5, 0.0, 0.0, np.nan, np.nan, 0.5],
    [np.nan, 0.0, 0.0, np.nan, np.nan, 0.0],
]


@pytest.mark.parametrize("name", REGISTRY)
def test_a_pipeline_answers_as_in_python(name: str) -> None:
    steps: list[Any] = movements(3).tolist()
    steps[40:40], steps[150:150] = REFUSED, ["reset"]
    steps += [
        "reset",
        *movements(4, rate_hz=1000.0, count=1).tolist(),
        "fresh",
        *movements(5, count=1).tolist(),
    ]
    assert_equal(
        node.run("predict.mjs", {"name": name, "options": {}, "steps": steps}), answers(build(name), steps)
    )


def test_counts_and_options_go_to_the_stages() -> None:
    table = movements(6, count=3)
    table[:, 3:5] = np.diff(4 * table[:, 1:3], axis=0, prepend=4 * table[:1, 1:3])
    options = {"cpi": 1600.0, "dpi": 110.0, "threshold": 0.1, "order": 3, "pause_s": 0.5}
    for more in ({}, {"differentiator": "kalman", "noise_m": 3e-5}):
        given = {key: value for key, value in (options | more).items() if key != "order" or not more}
        steps = table.tolist()
        found = node.run("predict.mjs", {"name": "switched", "options": given, "steps": steps})
        assert_equal(found, answers(build("switched", **given), steps))


@pytest.mark.parametrize("fails", [False, True])
def test_what_a_stage_refuses_leaves_both_as_they_were(fails: bool) -> None:
    """One row, or several at once, which the predictor or the differentiator refuses."""
    good, late, early = [0.0, 0.0], [0.0, 1.0], [0.0, 2.0]
    steps = [[good], [late], [good, good], [good, late], [good, good, early, good], [good]]
    assert node.run("refuse.mjs", {"steps": steps, "fails": fails}) == [
        [1, 1], [1, 1], [3, 3], [3, 3], [3, 3], [4, 4],
    ]  # fmt: skip


def test_what_a_stage_of_the_small_source_refuses_leaves_both_as_they_were() -> None:
    good, late, early = [0.0, 0.0], [0.0, 1.0], [0.0, 2.0]
    found = node.run("refuse_small.mjs", {"rows": [good, late, good, early, good]})
    assert found == [[1, 1], None, [2, 2], None, [3, 3]]


def test_a_person_goes_from_python_to_the_page_and_back() -> None:
    name, first, second = "kinematic-adaptive", movements(7).tolist(), movements(8).tolist()
    taught = build(name)
    answers(taught, [*first, "reset"])
    steps = [*second, "reset", "person"]
    found = node.run("predict.mjs", {"name": name, "options": {"person": taught.person}, "steps": steps})
    expected = answers(build(name, person=taught.person), steps)
    assert_equal(found[:-1], expected[:-1])
    again, direct = build(name, person=found[-1]), build(name, person=expected[-1])
    assert np.allclose(again.predictor.known, direct.predictor.known, rtol=1e-9, atol=1e-9)
    untouched = node.run(
        "predict.mjs", {"name": name, "options": {"person": taught.person}, "steps": ["person"]}
    )
    assert untouched == [taught.person]


def wrong(name: str, **options: Any) -> tuple[Any, Any]:
    """How Python and the page refuse options."""
    with pytest.raises(ParameterError) as refused:
        build(name, **options)
    return refused.value, node.run("predict.mjs", {"name": name, "options": options, "steps": []})


@pytest.mark.parametrize(
    ("name", "options"),
    [
        ("swiched", {}),
        ("hold", {"threshold": 1.0}),
        ("switched", {"thresold": 1.0}),
        ("switched", {"threshold": 11.0}),
        ("switched", {"threshold": "much"}),
        ("switched", {"order": 3.5}),
        ("switched", {"order": 9}),
        ("switched", {"pause_s": 0.05}),
        ("switched", {"alpha": -0.3}),
        ("switched", {"step_s": 0.05}),
        ("switched", {"gap_s": 600.0}),
        ("switched", {"cpi": 0.5}),
        ("switched", {"dpi": None}),
        ("switched", {"differentiator": "kalmann"}),
        ("switched-printed", {"alpha": -0.25, "step_s": 0.01}),
    ],
)
def test_what_cannot_be_built_is_refused_as_in_python(name: str, options: dict[str, Any]) -> None:
    error, found = wrong(name, **options)
    assert (found["error"], found["code"], found["field"]) == ("ParameterError", error.code, error.field)
    assert found["value"] == error.value
    assert found["message"].split(" received ")[0].split(" (gain_lambda)")[0][:20] == str(error)[:20]


def damaged(person: str) -> list[str]:
    return [
        person[:-1],
        person[:50] + "A" + person[51:],
        "2" + person[1:],
        person + "=",
        "1.",
        "1.!!",
        person * 9,
    ]


def test_a_person_that_cannot_be_used_is_refused() -> None:
    taught = build("kinematic-adaptive")
    answers(taught, [*movements(7).tolist(), "reset"])
    for person in damaged(taught.person):
        error, found = wrong("kinematic-adaptive", person=person)
        assert (found["code"], found["field"], found["message"].split(", received")[0]) == (
            error.code,
            error.field,
            str(error).split(", received")[0],
        )
    for name, options in (("hold", {}), ("kinematic-adaptive", {"adapt": 0})):
        error, found = wrong(name, person=taught.person, **options)
        assert found["message"] == str(error)


def test_a_person_with_impossible_numbers_is_refused() -> None:
    from pointpred.person import packed

    taught = build("kinematic-adaptive")
    answers(taught, [*movements(7).tolist(), "reset"])
    slots = taught.predictor.slots
    held = sum(slot.count for slot in slots[: [slot.name for slot in slots].index("distances held")])
    for place, value in ((0, -1.0), (len(taught.predictor.known) - 1, 1e9), (held, 3.5), (held, 0.0)):
        known = taught.predictor.known.copy()
        known[place] = value
        error, found = wrong("kinematic-adaptive", person=packed(slots, known))
        assert (found["code"], found["field"]) == (error.code, "person")
        assert found["message"].startswith("person contains an impossible value")
