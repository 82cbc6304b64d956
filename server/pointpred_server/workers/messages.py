"""What the supervisor and a worker send each other, as JSON lines."""

from __future__ import annotations

import asyncio
from typing import Any

import msgspec

from pointpred_server.workers.families import Family

LINE_BYTES = 2**24
"""Longest line that is read: the metrics of one worker have some 10 kB."""


class Begin(msgspec.Struct, tag="begin"):
    """To a worker, first of all: its number, how many workers there are, the settings."""

    number: int
    workers: int
    settings: dict[str, Any]


class Collect(msgspec.Struct, tag="collect"):
    """To a worker: send your metrics; also asked each second, to see whether it answers."""


class ServiceReady(msgspec.Struct, tag="service-ready"):
    """To a worker: every worker has started."""


class Text(msgspec.Struct, tag="text"):
    """To a worker: the metrics of all, in the exposition format."""

    text: str


class Stop(msgspec.Struct, tag="stop"):
    """To a worker: send ``bye`` to every session, and end."""


class Started(msgspec.Struct, tag="started"):
    """From a worker: it answers requests."""


class Collected(msgspec.Struct, tag="collected"):
    """From a worker: its metrics."""

    families: list[Family]


class AskText(msgspec.Struct, tag="ask-text"):
    """From a worker: send the metrics of all workers."""


ToWorker = Begin | Collect | ServiceReady | Text | Stop
FromWorker = Started | Collected | AskText

to_worker: msgspec.json.Decoder[ToWorker] = msgspec.json.Decoder(ToWorker)
from_worker: msgspec.json.Decoder[FromWorker] = msgspec.json.Decoder(FromWorker)


def send(writer: asyncio.StreamWriter, message: ToWorker | FromWorker) -> None:
    """Write one message; nothing where the other process has ended."""
    if not writer.is_closing():
        writer.write(msgspec.json.encode(message) + b"\n")
