"""JSON schemas of what is said on the wire."""

from __future__ import annotations

from typing import Any

import msgspec

from pointpred.server.protocol.client_messages import ClientMessage
from pointpred.server.protocol.server_messages import ServerMessage


def schemas() -> tuple[dict[str, Any], dict[str, Any]]:
    """JSON schemas of the messages from the client and from the server, with their components."""
    (client, server), components = msgspec.json.schema_components(
        (ClientMessage, ServerMessage), ref_template="#/components/schemas/{name}"
    )
    return {"client": client, "server": server}, components
