"""Write the OpenAPI document of the HTTP part from the routes: part of ``make docs``."""

from __future__ import annotations

import json

from pointpred_server.app import create_app


def render() -> str:
    """The document that the service serves at ``/openapi.json``, as JSON."""
    return json.dumps(create_app().openapi(), indent=2, sort_keys=True, ensure_ascii=False) + "\n"
