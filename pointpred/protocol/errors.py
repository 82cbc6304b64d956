"""Why a frame is refused: what is wrong, where, and the value received."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from itertools import islice
from math import isfinite
from typing import Any

import msgspec
from msgspec import UNSET, UnsetType

from pointpred.protocol.client_messages import CLIENT_TYPES, Condition, Setting
from pointpred.protocol.server_messages import Code, ErrorMessage, Scalar

SENTENCE_MOST = 1000
"""Characters of an error's sentence, which may quote the frame."""
PATH_MOST = 200
VALUE_MOST = 60
LOOKED_AT = 8192
"""Values of a message that are looked at for the one that is wrong: more would take milliseconds. That is all
of the longest frame of events."""
SETTINGS_LOOKED_AT = 256
ENTRIES = {"parameters": Setting, "conditions": Condition}
"""Fields whose entries a client names, for which the decoder has no path."""
QUOTED_MOST = 2**15
"""Characters of a message that is read once more, to quote what is wrong with it."""
LARGEST_EXACT = 2**53
"""Every JSON decoder reads whole numbers below this exactly."""

_decoder_place = re.compile(r" - at (?P<key>`key` in )?`(?P<path>\$.*)`$", re.DOTALL)
_decoder_field = re.compile(r"(missing required|contains unknown) field `(?P<name>.*)`$", re.DOTALL)
_step = re.compile(r"\.(?P<key>[^.\[]+)|\[(?P<index>\d+)\]")


class ProtocolError(Exception):
    """A frame is refused: ``answer`` is the message to send, ``close`` the code where the session ends."""

    def __init__(
        self,
        code: Code,
        message: str,
        path: str | None = None,
        *,
        field: str = "",
        value: object = UNSET,
        close: int | None = None,
    ) -> None:
        super().__init__(message)
        path = path and short(path, PATH_MOST)
        self.answer = ErrorMessage(code, short(message), path, recoverable=close is None)
        if field:
            self.answer.field = short(field, VALUE_MOST)
            self.answer.value = _scalar(value)
        self.close = close


def _scalar(value: object) -> Scalar | UnsetType:
    """A value as an error message holds it: a long text is cut; what JSON has no number for is left out."""
    if isinstance(value, str):
        return short(value, VALUE_MOST)
    if value is None or (isinstance(value, bool | int | float) and abs(value) < LARGEST_EXACT):
        return value
    return UNSET


def short(text: str, most: int = SENTENCE_MOST) -> str:
    """A text that a client may have chosen: of bounded length, and always good UTF-8."""
    text = text if len(text) <= most else f"{text[:most]}..."
    return text.encode(errors="replace").decode()


def invalid_message(text: str, reason: str) -> ProtocolError:
    """The error for JSON that is no message; the decoder has no more than a sentence for the ``reason``."""
    content = _content(text)
    place = _decoder_place.search(reason)
    path = place["path"] if place else "$"
    sentence = _decoder_place.sub("", reason)
    if place and place["key"]:
        return ProtocolError("bad_field", f"the name of an entry: {sentence}", path)
    missing_or_unknown = _decoder_field.search(sentence)
    if missing_or_unknown:
        path = f"{path}.{missing_or_unknown['name']}"
    if path == "$.type":
        code: Code = "bad_field" if sentence.startswith("Expected") else "unknown_type"
        received = content.get("type", UNSET) if isinstance(content, dict) else UNSET
        sentence = f"{sentence}; known: {', '.join(CLIENT_TYPES)}"
        return ProtocolError(code, sentence, path, field="type", value=received)
    for field in ENTRIES:
        if path.startswith(f"$.{field}["):
            path = _wrong_entry(content, field)
    if content is not None and not missing_or_unknown and " got " not in sentence:
        sentence = f"{sentence}, received {_value_at(content, path)}"
    return ProtocolError("bad_field", sentence, path)


def invalid_json(text: str, reason: str) -> ProtocolError:
    """The error for text that is not JSON; many encoders write NaN, and then its place helps more."""
    path = _path_of_nan(_lenient(text))
    if path is None:
        return ProtocolError("bad_json", f"expected JSON: {reason}")
    return ProtocolError("bad_field", "expected a finite number, received NaN or an infinity", f"${path}")


def _content(text: str) -> Any:
    """The content of JSON that is no message; ``None`` of a long one."""
    if len(text) > QUOTED_MOST:
        return None
    try:
        return msgspec.json.decode(text)  # several times as fast
    except (msgspec.DecodeError, UnicodeError, RecursionError):
        return _lenient(text)


def _lenient(text: str) -> Any:
    """The content as a decoder reads it that knows NaN; ``None`` where it cannot, and of a long text."""
    if len(text) > QUOTED_MOST:
        return None
    try:
        return json.loads(text)
    except (ValueError, RecursionError):
        return None


def _wrong_entry(value: Any, field: str) -> str:
    """The path of the first entry whose value is of a wrong kind, where it is among the first ones."""
    try:
        entries = dict(value[field])
    except (TypeError, ValueError, KeyError):
        return f"$.{field}"
    for name, entry in islice(entries.items(), SETTINGS_LOOKED_AT):
        try:
            msgspec.convert(entry, ENTRIES[field])
            if _path_of_nan(entry) is None:
                continue
        except msgspec.ValidationError:
            pass
        return f"$.{field}.{name}"
    return f"$.{field}"


def _value_at(value: Any, path: str) -> str:
    """The value at a path, as a sentence quotes it; a list by its length."""
    for step in _step.finditer(path):
        try:
            value = value[step["key"] or int(step["index"])]
        except (TypeError, KeyError, IndexError):
            return "something else"
    if isinstance(value, dict):  # written out, it may be deeper than Python goes
        return "an object"
    return f"{len(value)}" if isinstance(value, list) else short(repr(value), VALUE_MOST)


def _path_of_nan(value: object) -> str | None:
    """The path below ``value`` to the first number that is not finite, however deep it lies.

    ``None`` where there is none among the first values.
    """
    left = LOOKED_AT
    levels: list[Iterator[tuple[object, object]]] = [iter([("", value)])]
    steps: list[object] = []  # the places on the way down, one fewer than levels
    while levels:
        for place, item in levels[-1]:
            left -= 1
            if left < 0:
                return None
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
