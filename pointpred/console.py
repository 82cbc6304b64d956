"""Text on the terminal: results go to stdout, everything else to stderr."""

from __future__ import annotations

import sys
from collections.abc import Collection, Iterable, Sequence
from typing import Any

from rich.console import Console, JustifyMethod, OverflowMethod
from rich.table import Table
from rich.text import Text

WIDE = 160
"""Columns of a table that goes to a file or a pipe, which has no width of its own."""
NARROW = 120
"""In a terminal with fewer columns a table leaves some of its own out, so that no row wraps."""

CONTROLS = {code: f"\\x{code:02x}" for code in (*range(32), *range(127, 160)) if chr(code) not in "\n\t"}
"""Control characters, which names of files may hold, and what is shown in their place."""


def plain(text: str) -> str:
    r"""Text without control characters: it moves no cursor and rings no bell.

    >>> plain("a\x1b[2Jb")
    'a\\x1b[2Jb'
    """
    return text.translate(CONTROLS)


class PlainConsole(Console):
    """A console that shows text as it is: no markup, no names of emoji, control characters shown."""

    def __init__(self, **options: Any) -> None:
        super().__init__(markup=False, emoji=False, highlight=False, **options)

    def render_str(self, text: str, **options: Any) -> Text:
        """Render as rich does, with control characters shown."""
        return super().render_str(plain(text), **options)


def results() -> Console:
    """The console for results; plain and wide when it is not a terminal."""
    return PlainConsole(width=None if sys.stdout.isatty() else WIDE)


def remarks() -> Console:
    """The console for progress, remarks and errors."""
    return PlainConsole(stderr=True, soft_wrap=True)


def remark(text: str) -> None:
    """Print a remark as it is, without markup."""
    remarks().print(text)


def table(
    headings: Sequence[str],
    rows: Iterable[Sequence[str]],
    *,
    whole: Collection[str] = (),
    right: Collection[str] = (),
    overflow: OverflowMethod = "ellipsis",
) -> Table:
    """A table without lines; without headings none are shown.

    By their headings: ``whole`` columns are not broken into lines, ``right`` ones are aligned there.
    """
    made = Table(box=None, pad_edge=False, show_header=bool(headings))
    for heading in headings:
        justify: JustifyMethod = "right" if heading in right else "left"
        made.add_column(heading, justify=justify, no_wrap=heading in whole, overflow=overflow)
    for row in rows:
        made.add_row(*row)
    return made


def counted(number: int, noun: str) -> str:
    """A number with its noun.

    >>> counted(1, "trial"), counted(2, "trial")
    ('1 trial', '2 trials')
    """
    return f"{number} {noun}" + "s" * (number != 1)
