"""What docs/reference/settings.md shows: every setting of the service, from the code."""

from __future__ import annotations

from typing import Any

from pointpred_server.settings import Settings


def context() -> dict[str, Any]:
    """What the template needs."""
    return {
        "settings": [
            {
                "name": name,
                "default": "-" if field.default is None or field.default == () else f"`{field.default}`",
                "meaning": field.description or "",
            }
            for name, field in Settings.model_fields.items()
        ]
    }
