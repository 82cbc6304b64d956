"""Why a frame is refused: what is wrong, where, and the value received."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from math import isfinite
from typing import Any

import msgspec

from pointpred.protocol.client_messages import CLIENT_TYPES, Setting
from pointpred.protocol.server_messages import Code, ErrorMessage

WORDS_MOST = 1000
"""What an error quotes of a client's frame is no longer than this."""
PATH_MOST = 200
VALUE_MOST = 60

_place = re.compile(r" - at `(?P<path>\$.*)`$", re.DOTALL)
_field = re.compile(r"(missing required|contains unknown) field `(?P<name>.*)`$", re.DOTALL)
_step = re.compile(r"\.(?P<key>[^.\[]+)|\[(?P<index>\d+)\]")


class ProtocolError(Exception):
    """What came cannot be used; ``answer`` says so, ``close`` is the close code where the session ends."""

    def __init__(
        self, code: Code, message: str, path: str | None = None, *, close: int | None = None
    ) -> None:
        super().__init__(message)
        self.answer = ErrorMessage(
            code, short(message), path and short(path, PATH_MOST), recoverable=close is None
        )
        self.close = close


def short(words: str, most: int = WORDS_MOST) -> str:
    """Words that a client may have chosen: of bounded length, and always good UTF-8."""
    words = words if len(words) <= most else f"{words[:most]}..."
    return words.encode(errors="replace").decode()


def not_fitting(text: str, words: str) -> ProtocolError:
    """JSON, but no message; ``words`` are the decoder's."""
    found = _place.search(words)
    path = found["path"] if found else "$"
    words = _place.sub("", words)
    if field := _field.search(words):
        path = f"{path}.{field['name']}"
    value = _loaded(text)
    if path == "$.type":
        code: Code = "bad_field" if words.startswith("Expected") else "unknown_type"
        return ProtocolError(code, f"{words}; known: {', '.join(CLIENT_TYPES)}", path)
    if path.startswith("$.parameters["):
        path = _wrong_parameter(value)
    if not field and " got " not in words:
        words = f"{words}, received {_at(value, path)}"
    return ProtocolError("bad_field", words, path)


def not_json(text: str, reason: str) -> ProtocolError:
    """Many encoders write NaN, which JSON does not know: then the place of the number helps more."""
    path = _not_finite(_loaded(text))
    if path is None:
        return ProtocolError("bad_json", f"expected JSON: {reason}")
    return ProtocolError("bad_field", "expected a finite number, received NaN or an infinity", f"${path}")


def _loaded(text: str) -> Any:
    """What a more lenient decoder reads; ``None`` where even that reads nothing."""
    try:
        return json.loads(text)
    except (ValueError, RecursionError):
        return None


def _wrong_parameter(value: Any) -> str:
    """The path of the first parameter whose value is none that a parameter may have."""
    try:
        parameters = dict(value["parameters"])
    except (TypeError, ValueError, KeyError):
        return "$.parameters"
    for name, setting in parameters.items():
        try:
            msgspec.convert(setting, Setting)
            if _not_finite(setting) is None:
                continue
        except msgspec.ValidationError:
            pass
        return f"$.parameters.{name}"
    return "$.parameters"


def _at(value: Any, path: str) -> str:
    """The value at a path in words; a list by its length."""
    for step in _step.finditer(path):
        try:
            value = value[step["key"] or int(step["index"])]
        except (TypeError, KeyError, IndexError):
            return "something else"
    if isinstance(value, dict):  # written out, it may be deeper than Python goes
        return "an object"
    return f"{len(value)}" if isinstance(value, list) else short(repr(value), VALUE_MOST)


def _not_finite(value: object) -> str | None:
    """The path of the first number that is not finite, from ``value`` on, however deep it lies."""
    levels: list[Iterator[tuple[object, object]]] = [iter([("", value)])]
    steps: list[object] = []  # the places on the way down, one fewer than levels
    while levels:
        for place, item in levels[-1]:
            if isinstance(item, float):
                if not isfinite(item):
                    return "".join(_step_to(step) for step in [*steps, place][1:])
            elif isinstance(item, dict | list):
                levels.append(iter(item.items()) if isinstance(item, dict) else enumerate(item))
                steps.append(place)
                break
        else:
            levels.pop()
            del steps[-1:]
    return None


def _step_to(place: object) -> str:
    return f"[{place}]" if isinstance(place, int) else f".{place}"
