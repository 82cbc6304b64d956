"""What a client's frame needs to be compiled."""

from __future__ import annotations

from pointpred.protocol.client_messages import Configure, Hello, Targets, TrialMark
from pointpred.protocol.decoding import decode_client_message
from pointpred.protocol.errors import ProtocolError
from pointpred.server.compiling.parts import ASSISTANCE, TARGETS, TRIALS, differentiator


def needs(frame: str | bytes) -> list[str]:
    """Names of parts; what events need came with the messages before them."""
    if isinstance(frame, bytes):
        return []
    try:
        message = decode_client_message(frame)
    except ProtocolError:
        return []  # the session says what is wrong
    if isinstance(message, Hello | Configure):
        names = [] if message.predictor is None else [message.predictor]
        if isinstance(chosen := message.parameters.get("differentiator"), str):
            names.append(differentiator(chosen))
        return [*names, ASSISTANCE] if message.assist is not None else names
    if isinstance(message, Targets):
        return [TARGETS] if message.targets else []
    return [TRIALS] if isinstance(message, TrialMark) and message.action == "end" else []
