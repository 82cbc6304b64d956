"""Which pipeline a client gets: hello and configure, parameters right and wrong."""

from __future__ import annotations

from typing import Any

import pytest

from pointpred import REGISTRY, PointerEvent, build
from pointpred.differentiators import DIFFERENTIATORS, HomogeneousDifferentiator
from pointpred.protocol.client_messages import Hello
from pointpred.protocol.errors import ProtocolError
from pointpred.registry import parameters
from pointpred_server.sessions import pipelines
from pointpred_server.sessions.pipelines import pipeline_of
from tests.unit.talking import Talk, events, hello

ROWS = [[0.01 * i, 1.0 * i * i, 0.5 * i * i, 4 * i, 2 * i, 0] for i in range(100)]


def configure(**fields: Any) -> dict[str, Any]:
    return {"type": "configure", **fields}


def last(talk: Talk) -> tuple[float, float]:
    answer = talk.feed(ROWS)[-1]
    return answer["x"], answer["y"]


def wanted(name: str, **settings: Any) -> tuple[float, float]:
    pipeline = build(name, **settings)
    for row in ROWS:
        prediction = pipeline.update(PointerEvent(*row))
    assert prediction is not None
    return prediction.x, prediction.y


def test_device_and_screen_reach_the_pipeline() -> None:
    greet = hello("kep-quadratic", device={"cpi": 400}, screen={"dpi": 120})
    assert last(Talk(greet=greet)) == wanted("kep-quadratic", cpi=400.0, dpi=120.0)
    assert wanted("kep-quadratic", cpi=400.0, dpi=120.0) != wanted("kep-quadratic")


@pytest.mark.parametrize("field", ["cpi", "dpi"])
def test_cpi_and_dpi_have_the_bounds_of_the_pipeline(field: str) -> None:
    place, known = {"cpi": ("device", "cpi"), "dpi": ("screen", "dpi")}[field]
    (bound,) = (p for p in HomogeneousDifferentiator.parameters if p.name == known)
    for value, good in ((bound.low, 1), (bound.high, 1), (bound.low * 0.99, 0), (bound.high * 1.01, 0)):
        talk = Talk(greet=False)
        (answer,) = talk.say(hello(**{place: {field: value}}))
        assert (answer["type"] == "welcome") == bool(good)
        if not good:
            assert (answer["code"], answer["path"]) == ("bad_field", f"$.{place}.{field}")


def test_parameters_reach_the_pipeline() -> None:
    settings: dict[str, Any] = {"horizon_s": 0.2, "differentiator": "kalman"}
    assert last(Talk(greet=hello("linear", parameters=settings))) == wanted("linear", **settings)


@pytest.mark.parametrize("order", [3, 3.0])
def test_a_whole_number_may_be_written_as_any_number(order: float) -> None:
    got = last(Talk(greet=hello("linear", parameters={"order": order})))
    assert got == wanted("linear", order=3)


def test_gains_are_a_list() -> None:
    gains = [100.0, 2000.0, 15000.0, 40000.0]
    assert last(Talk(greet=hello("linear", parameters={"gains": gains}))) == wanted("linear", gains=gains)


@pytest.mark.parametrize("name", REGISTRY)
def test_every_parameter_out_of_bounds_is_told_by_its_path(name: str) -> None:
    for parameter, _ in parameters(name).values():
        if parameter.name in ("cpi", "dpi"):
            continue
        settings = {"between": "line", parameter.name: parameter.high * 2.0 + 1.0}
        error = Talk(greet=False).error(hello(name, parameters=settings))
        assert (error["code"], error["path"]) == ("bad_field", f"$.parameters.{parameter.name}")
        assert f"{parameter.high:g}" in error["message"]


@pytest.mark.parametrize("differentiator", DIFFERENTIATORS)
def test_an_unknown_parameter_is_told_the_known_ones(differentiator: str) -> None:
    settings = {"differentiator": differentiator, "treshold": 1.0}
    error = Talk(greet=False).error(hello("switched", parameters=settings))
    assert (error["code"], error["path"]) == ("bad_field", "$.parameters.treshold")
    assert "threshold, bound, delay_s, gamma" in error["message"]


@pytest.mark.parametrize(
    ("name", "value", "word"),
    [
        ("threshold", True, "number"),
        ("threshold", "a", "number"),
        ("threshold", [1.0], "number"),
        ("threshold", None, "null"),
        ("threshold", {"a": 1}, "object"),
        ("threshold", [1.0, "a"], "str"),
        ("order", 2.5, "whole"),
        ("between", 3, "line"),
        ("gains", 3.0, "4 positive numbers"),
        ("gains", [1.0], "4"),
        ("gap_s", 0.5, "0.5"),
        ("differentiator", "x", "homogeneous"),
        ("cpi", 800, "device.cpi"),
        ("dpi", 96, "screen.dpi"),
        ("name", "hold", "predictor"),
        ("self", 1, "threshold"),
        ("", 1, "threshold"),
    ],
)
def test_a_wrong_parameter_is_told_by_its_path(name: str, value: Any, word: str) -> None:
    for frame in (hello("switched", parameters={name: value}), configure(parameters={name: value})):
        talk = Talk(greet=hello("switched") if frame["type"] == "configure" else False)
        error = talk.error(frame)
        assert (error["code"], error["path"], error["recoverable"]) == (
            "bad_field",
            f"$.parameters.{name}",
            True,
        )
        assert word in error["message"]


@pytest.mark.parametrize("value", ["x", 3.0])
def test_a_library_that_is_no_table_is_refused_by_its_name(value: Any) -> None:
    name = "library"
    error = Talk(greet=False).error(hello("ktm", parameters={name: value}))
    assert (error["code"], error["path"]) == ("bad_field", f"$.parameters.{name}")
    assert error["field"] == name


def test_a_fault_of_the_service_is_not_the_clients(monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(*_: Any, **__: Any) -> None:
        raise ValueError("a fault of the code")

    monkeypatch.setattr(pipelines, "build", fails)
    with pytest.raises(ValueError, match="a fault of the code") as error:
        pipeline_of(Hello(1, "hold"))
    assert not isinstance(error.value, ProtocolError)


@pytest.mark.parametrize("value", ["NaN", "1e999", "-Infinity"])
def test_a_parameter_that_is_not_finite_is_told_by_its_path(value: str) -> None:
    text = f'{{"type":"configure","parameters":{{"bound":1,"threshold":{value}}}}}'
    error = Talk(greet=hello("switched")).error(text)
    assert (error["code"], error["path"]) == ("bad_field", "$.parameters.threshold")


def test_another_predictor_begins_anew() -> None:
    talk = Talk(greet=hello("linear", parameters={"horizon_s": 0.2}))
    last(talk)
    (answer,) = talk.say(configure(predictor="switched"))
    assert (answer["type"], answer["predictor"]) == ("welcome", "switched")
    assert last(talk) == wanted("switched")


def test_a_parameter_changes_and_the_others_stay() -> None:
    talk = Talk(greet=hello("switched", parameters={"threshold": 0.3}))
    last(talk)
    talk.say(configure(parameters={"bound": 0.2}))
    assert last(talk) == wanted("switched", threshold=0.3, bound=0.2)


def test_the_reply_changes_without_forgetting() -> None:
    talk, other = (Talk(greet=hello("switched")) for _ in range(2))
    talk.say(events(*ROWS[:10]))
    assert talk.say(configure(reply="event"))[0]["type"] == "welcome"
    answers = talk.feed(ROWS[10:])
    assert len(answers) == 90
    assert answers[-1] == other.feed(ROWS)[-1]


@pytest.mark.parametrize(
    "wrong", [{"predictor": "x"}, {"parameters": {"x": 1}}, {"parameters": {"bound": -1}}]
)
def test_a_configure_that_is_refused_changes_nothing(wrong: dict[str, Any]) -> None:
    talk, other = (Talk(greet=hello("switched", reply="event")) for _ in range(2))
    for one in (talk, other):
        one.say(events(*ROWS[:10]))
    talk.error(configure(reply="frame", precision=0.5, **wrong))
    assert talk.feed(ROWS[10:]) == other.feed(ROWS[10:])
    assert talk.session.stream is not None
    assert talk.session.stream.precision is None


def test_a_configure_that_is_refused_leaves_assistance_as_it_was() -> None:
    rows = [[0.01 * i, 0.0, 0.0, 3 * i, i, 0] for i in range(20)]
    greet = hello("linear", device={"cpi": 800}, assist={"strength": 1.0})
    talk, other = Talk(greet=greet), Talk(greet=greet)
    talk.error(configure(assist={"strength": 0.0, "function": "constant", "gain": 9.0}, parameters={"x": 1}))
    assert talk.feed(rows) == other.feed(rows)


def test_the_precision_is_remembered() -> None:
    talk = Talk()
    for precision in (0.0, 0.9, 1.0):
        talk.say(configure(precision=precision))
        talk.say(configure(reply="frame"))
        assert talk.session.stream is not None
        assert talk.session.stream.precision == precision


def test_configure_counts_on() -> None:
    talk = Talk()
    talk.feed(ROWS)
    talk.say(configure(predictor="switched"))
    talk.feed(ROWS)
    assert talk.session.state == "streaming"
    assert talk.session.stream is not None
    assert talk.session.stream.events == 200
