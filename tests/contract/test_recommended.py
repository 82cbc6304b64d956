"""One predictor wherever a live person is served and nobody has named another."""

from __future__ import annotations

import inspect
import pkgutil
import re
from collections.abc import Callable, Iterator
from importlib import import_module
from importlib.resources import files
from typing import Any

import msgspec
import pytest

from pointpred import RECOMMENDED, REGISTRY, EventColumns, build, run
from pointpred.client import connect, connect_async
from pointpred.client.session import hello_message
from tests.unit.talking import Talk, events

ROWS = [[i / 60, 3.0 * i * i, 0.5 * i * i, None, None, 0] for i in range(12)]
ROOMS = (
    *("pointpred.cli", "pointpred.client", "pointpred.devices", "pointpred.live", "pointpred.protocol"),
    "pointpred_server",
)
"""Where live people are served."""


def callables() -> Iterator[tuple[str, Callable[..., Any]]]:
    """Every function, method and class of those rooms, by the name it is defined under."""
    for room in ROOMS:
        package = import_module(room)
        found = pkgutil.walk_packages(package.__path__, f"{package.__name__}.")
        for module in map(import_module, [package.__name__, *(one.name for one in found)]):
            for name, value in vars(module).items():
                if getattr(value, "__module__", None) != module.__name__:
                    continue
                if inspect.isfunction(value):
                    yield f"{module.__name__}.{name}", value
                elif inspect.isclass(value):
                    for method in filter(inspect.isfunction, vars(value).values()):
                        yield f"{module.__name__}.{name}.{method.__name__}", method


def defaults() -> dict[str, str]:
    """The predictor of each that can do without being told one."""
    found = {}
    for name, call in callables():
        one = inspect.signature(call).parameters.get("predictor")
        if one is not None and isinstance(one.default, str):
            found[name] = one.default
    return found


def test_every_default_is_the_recommended_one() -> None:
    found = defaults()
    assert {name for name, default in found.items() if default != RECOMMENDED} == set()
    assert {
        "pointpred.cli.live.live",
        "pointpred.cli.replay.replay",
        "pointpred.client.session.hello_message",
        "pointpred.live.socket.replay_to",
    } <= set(found)


def test_it_is_a_name_of_the_registry() -> None:
    assert RECOMMENDED in REGISTRY


@pytest.mark.parametrize(
    ("script", "default"),
    [
        ("lib/laws/registry.js", r'^export const RECOMMENDED = "([^"]*)";'),
        ("lib/index.d.ts", r'/\*\* `"([^"]*)"` by default\. A service'),
    ],
)
def test_the_scripts_say_it(script: str, default: str) -> None:
    text = (files("pointpred_server") / "web" / script).read_text(encoding="utf-8")
    assert re.findall(default, text, re.MULTILINE) == [RECOMMENDED]


@pytest.mark.parametrize("script", ["lib/pointpred.js", "lib/intent/index.js", "page/service/listing.js"])
def test_the_scripts_take_it_from_the_registry(script: str) -> None:
    text = (files("pointpred_server") / "web" / script).read_text(encoding="utf-8")
    assert re.search(
        r'import \{[^}]*\bRECOMMENDED\b[^}]*\} from "(?:\.{1,2}/)+(?:lib/)?laws/registry\.js"', text
    )
    assert f'predictor: "{RECOMMENDED}"' not in text


@pytest.mark.parametrize("call", [connect, connect_async])
def test_the_python_client_says_it(call: Callable[..., Any]) -> None:
    assert "predictor" not in inspect.signature(call).parameters  # both pass it to hello_message
    assert msgspec.to_builtins(hello_message())["predictor"] == RECOMMENDED


@pytest.mark.parametrize("more", [{}, {"assist": {}, "device": {"cpi": 1000}}])
def test_a_hello_without_a_predictor_gets_it(more: dict[str, Any]) -> None:
    talk = Talk(greet=False)
    (welcome,) = talk.say({"type": "hello", "version": 1, **more})
    assert (welcome["type"], welcome["predictor"]) == ("welcome", RECOMMENDED)


def test_and_its_predictions() -> None:
    talk = Talk(greet={"type": "hello", "version": 1, "reply": "event"})
    table = EventColumns.of(*([row[i] for row in ROWS] for i in range(3)))
    expected = run(build(RECOMMENDED), table)
    answers = talk.say(events(*ROWS))
    assert [answer["x"] for answer in answers] == expected.x.tolist()
    assert expected.x.tolist() != table.x.tolist()
