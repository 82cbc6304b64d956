"""Tables in Markdown, and generated parts of a page.

A generated part stands between two comments, ``<!-- generated: NAME -->`` and ``<!-- end -->``; the rest of
a page is written by people.
"""

from __future__ import annotations

import re

PART = r"<!-- generated: {name} -->\n.*?<!-- end -->"


def table(header: tuple[str, ...], rows: list[tuple[str, ...]]) -> str:
    """A Markdown table."""
    lines = [header, tuple("---" for _ in header), *rows]
    return "\n".join("| " + " | ".join(cell.replace("|", "\\|") for cell in line) + " |" for line in lines)


def filled(page: str, name: str, text: str) -> str:
    """The page with one part replaced; raises ValueError where the page has no such part."""
    part = f"<!-- generated: {name} -->\n\n{text}\n\n<!-- end -->"
    result, count = re.subn(PART.format(name=re.escape(name)), lambda _: part, page, flags=re.DOTALL)
    if count != 1:
        raise ValueError(f"expected one part {name!r}, found {count}")
    return result
