"""What a person who starts the service reads until it is ready."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, TextIO

import typer

from pointpred.console import plain

if TYPE_CHECKING:
    from pointpred_server.compiling.compiler import Compiler, Progress
    from pointpred_server.settings import Settings

CLEAR = "\r\x1b[2K"
"""Returns to the beginning of the line and clears it."""


class ServiceStart:
    """Prints the settings, the address, that the page can be used, and the progress of compiling.

    The address goes to stdout, all else to ``screen``. The progress is one line that is updated, in a
    terminal only; elsewhere it is in the log.
    """

    def __init__(self, settings: Settings, address: str, screen: TextIO | None = None) -> None:
        self.settings = settings
        self.address = address
        self._screen = screen or sys.stderr
        self._watched = self._screen.isatty()
        self._say(f"Settings: {changed_settings(settings)}")

    def watch(self, compiler: Compiler) -> None:
        """Print what a compiler does."""
        compiler.on_progress, compiler.on_ready = self.progress, self.ready

    def announce(self) -> None:
        """The page can be opened."""
        self._screen.write(CLEAR if self._watched else "")
        self._screen.flush()
        typer.echo(self.address + self.settings.address_query)

    def progress(self, progress: Progress) -> None:
        """What is being compiled."""
        if self._watched:
            far = f"{progress.done} of {progress.of}, {progress.next}"
            self._screen.write(CLEAR + (plain(f"Compiling, only this once: {far}") if progress.next else ""))
            self._screen.flush()

    def ready(self) -> None:
        """The recommended predictor is compiled; the address is printed again, without a token."""
        token = " with the token" if self.settings.token else ""
        self._say(f"Ready: open {self.address}{token} in a browser. Ctrl-C stops.")

    def _say(self, words: str) -> None:
        self._screen.write((CLEAR if self._watched else "") + plain(words) + "\n")
        self._screen.flush()


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
