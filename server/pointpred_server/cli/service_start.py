"""What a person who starts the service reads until it is ready."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import TYPE_CHECKING

import typer

from pointpred.console import plain

if TYPE_CHECKING:
    from pointpred_server.settings import Settings


class ServiceStart:
    """Says the settings, the address, and that the page can be used.

    The address goes to stdout; all else is ``said``: on stderr, or as entries of a log that is JSON.
    """

    def __init__(self, settings: Settings, address: str, say: Callable[[str], None] | None = None) -> None:
        self.settings = settings
        self.address = address
        self._say = say or _on_stderr
        self._say(f"Settings: {changed_settings(settings)}")

    def announce(self) -> None:
        """The page can be opened; the address is printed twice, the second time without a token."""
        typer.echo(self.address + self.settings.address_query)
        token = " with the token" if self.settings.token else ""
        self._say(f"Ready: open {self.address}{token} in a browser. Ctrl-C stops.")

    def tell_metrics(self, port: int) -> None:
        """Where Prometheus finds the metrics."""
        self._say(f"Metrics: http://127.0.0.1:{port}/metrics")


def _on_stderr(words: str) -> None:
    sys.stderr.write(plain(words) + "\n")
    sys.stderr.flush()


def changed_settings(settings: Settings) -> str:
    """The settings that differ from their defaults; the token masked."""
    defaults = {name: field.default for name, field in type(settings).model_fields.items()}
    changed = [
        f"{name} {value}"
        for name, value in settings.printable().items()
        if value not in (defaults[name], [], None)
    ]
    words = ", ".join(changed)
    return f"{words}; everything else default" if words else "all default"
