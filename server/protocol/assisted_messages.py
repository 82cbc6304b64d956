"""The messages of assistance: what a client asks for, and where the service then puts the cursor."""

from __future__ import annotations

from typing import Annotated, Literal

from msgspec import Meta, Struct

from pointpred.server.protocol.fields import Share

Rho = Annotated[float, Meta(ge=0.0, le=1e4)]
Gain = Annotated[float, Meta(ge=0.0, le=1e3)]


class Assist(Struct, forbid_unknown_fields=True):
    """The service moves the cursor: counts through ``function``, helped towards the predicted endpoint.

    ``strength``: longest help as a share of the hand's own motion, 0 is the function alone; ``rho`` 1/s;
    ``gain`` of the constant function, the sigmoid one has its own.
    """

    strength: Share = 0.5
    rho: Rho = 8.0
    function: Literal["constant", "sigmoid"] = "constant"
    gain: Gain = 4.0


class Cursor(Struct, tag="cursor"):
    """Where the cursor is after the events up to ``t``, px, in a session that asked for assistance.

    ``added_px``: the length of all that help has added since the session began.
    """

    t: float
    x: float
    y: float
    added_px: float
