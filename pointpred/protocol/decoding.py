"""A frame from a client as a message or a table of events; what is wrong with it, and where."""

from __future__ import annotations

import re
from functools import reduce
from itertools import islice
from operator import or_
from typing import Annotated, Any

import msgspec
import numpy as np
from msgspec import Meta, Struct

from pointpred.protocol.client_messages import CLIENT_MESSAGES, ClientMessage, Events
from pointpred.protocol.errors import ProtocolError, invalid_json, invalid_message
from pointpred.protocol.frames import EVENT, NONE, unpack_events
from pointpred.protocol.server_messages import SERVER_MESSAGES, SERVER_TYPES
from pointpred.records import EVENT_FIELDS, FloatArray, Row


def _any_of(kinds: tuple[type[Struct], ...]) -> Any:
    """The union of the messages, as a decoder wants it."""
    return reduce(or_, kinds)


_from_client = msgspec.json.Decoder(_any_of(CLIENT_MESSAGES))
_from_server = msgspec.json.Decoder(_any_of(SERVER_MESSAGES))
# At the end of a number, an exponent of three digits, or a positive one of two.
_wide = re.compile(r"[eE](?<=[\d.][eE])([-+]?0*[1-9]\d\d|\+?0*[1-9]\d)\d*(?=[\s,\]}])", re.A)
EXTREME_MOST = 128
"""Numbers above 1e10 or below 1e-99 in one message: decoding one may take 8 us, and others take 20 ns."""
SHORT = 1024
"""Characters of a message that may hold any numbers."""
_most = tuple(field.high for field in EVENT_FIELDS[:3])


def decode_client_message(text: str) -> ClientMessage:
    """A message from a client's JSON text; raises ProtocolError with the path of what is wrong."""
    if len(text) > SHORT:
        _check_exponents(text)
    try:
        message: ClientMessage = _from_client.decode(text)
        return message
    except msgspec.ValidationError as error:
        raise invalid_message(text, str(error)) from None
    except (msgspec.DecodeError, UnicodeError, RecursionError) as error:
        raise invalid_json(text, str(error)) from None


def _check_exponents(text: str) -> None:
    """Raise ProtocolError for many numbers that take long to decode, and that nobody points at."""
    extreme = islice(_wide.finditer(text), EXTREME_MOST + 1)
    if len(list(extreme)) > EXTREME_MOST:
        sentence = f"a message holds at most {EXTREME_MOST} numbers written with so large exponents"
        raise ProtocolError("bad_field", sentence)


class _AnyMessage(Struct):
    """What every message has, those of newer services too."""

    type: Annotated[str, Meta(min_length=1)]


_any_from_server = msgspec.json.Decoder(_AnyMessage)


def decode_server_message(text: str) -> Struct | None:
    """A message from the server's JSON text; raises msgspec.DecodeError for what is none.

    ``None`` for a type of message that is not known here: a newer service may send such.
    """
    try:
        message: Struct = _from_server.decode(text)
    except msgspec.ValidationError:
        if _any_from_server.decode(text).type in SERVER_TYPES:
            raise
        return None
    return message


def rows_of_message(message: Events) -> list[Row]:
    """The rows of an ``events`` message, as ``EventColumns`` has them."""
    return [
        (t, x, y, NONE if dx is None else dx, NONE if dy is None else dy, buttons)
        for t, x, y, dx, dy, buttons in message.events
    ]


def rows_of_bytes(frame: bytes) -> list[Row]:
    """The rows of a frame of packed events; raises ProtocolError."""
    if len(frame) % EVENT.itemsize:
        sentence = f"a binary frame holds records of {EVENT.itemsize} bytes, received {len(frame)} bytes"
        raise ProtocolError("bad_field", sentence, "$")
    return unpack_events(frame)


def check_numbers(table: FloatArray) -> None:
    """Raise ProtocolError for the first number out of range, or a count without the other."""
    outside = ~(np.abs(table[:, :3]) <= _most)
    alone = np.isnan(table[:, 3:5])
    alone &= ~alone.all(axis=1, keepdims=True)
    wrong = np.argwhere(np.hstack([outside, alone]))
    if not len(wrong):
        return
    row, column = (int(i) for i in wrong[0])
    sentence, name, value = "dx and dy are both numbers or both null", EVENT_FIELDS[column].name, None
    if column < outside.shape[1]:
        value, most = float(table[row, column]), _most[column]
        sentence = f"{name} must lie in [{-most:g}, {most:g}], received {value!r}"
    raise ProtocolError("bad_field", sentence, f"$.events[{row}][{column}]", field=name, value=value)
