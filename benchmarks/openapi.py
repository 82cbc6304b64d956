"""Write the OpenAPI document of the HTTP part from the routes: part of ``make docs``."""

from __future__ import annotations

import json
from typing import Any

from fastapi.routing import APIRoute

from pointpred.server.app import create_app


def document() -> dict[str, Any]:
    """The routes as they are; ``HEAD`` answers like ``GET`` and is not described apart."""
    app = create_app()
    for route in app.routes:
        if isinstance(route, APIRoute):
            route.methods.discard("HEAD")
    return app.openapi()


def render() -> str:
    """The document as JSON."""
    return json.dumps(document(), indent=2, sort_keys=True, ensure_ascii=False) + "\n"
